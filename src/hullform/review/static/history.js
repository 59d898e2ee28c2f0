// The states of the review: every change is one step that can be undone.

export class History {
  constructor(document) {
    this.states = [{ document, what: "opened" }];
    this.at = 0;
    this.saved = JSON.stringify(document);
  }

  get document() {
    return this.states[this.at].document;
  }

  get changed() {
    return JSON.stringify(this.document) !== this.saved;
  }

  get canUndo() {
    return this.at > 0;
  }

  get canRedo() {
    return this.at < this.states.length - 1;
  }

  // What the next undo takes back, and the next redo brings back.
  get undoes() {
    return this.canUndo ? this.states[this.at].what : "";
  }

  get redoes() {
    return this.canRedo ? this.states[this.at + 1].what : "";
  }

  push(document, what) {
    this.states.length = this.at + 1;
    this.states.push({ document, what });
    this.at += 1;
  }

  undo() {
    if (this.canUndo) this.at -= 1;
  }

  redo() {
    if (this.canRedo) this.at += 1;
  }

  markSaved(document) {
    this.saved = JSON.stringify(document);
  }
}
