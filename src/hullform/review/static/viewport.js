// Where the picture lies on the screen. Pixel centres lie at integers, so pixel u covers u - 1/2 .. u + 1/2.

const LARGEST_SCALE = 32;
const FIT_MARGIN = 24;

export class Viewport {
  constructor(stage, moved) {
    this.stage = stage;
    this.moved = moved;
    this.scale = 1;
    this.left = 0;
    this.top = 0;
    this.size = [1, 1];
  }

  get window() {
    return [this.stage.clientWidth, this.stage.clientHeight];
  }

  toScreen([u, v]) {
    return [this.left + this.scale * (u + 0.5), this.top + this.scale * (v + 0.5)];
  }

  toPicture([x, y]) {
    return [(x - this.left) / this.scale - 0.5, (y - this.top) / this.scale - 0.5];
  }

  // The place in the picture of a mouse or pointer event.
  ofEvent(event) {
    const box = this.stage.getBoundingClientRect();
    return this.toPicture([event.clientX - box.left, event.clientY - box.top]);
  }

  get smallestScale() {
    const [width, height] = this.window;
    return 0.5 * Math.min(width / this.size[0], height / this.size[1]);
  }

  zoomAt(factor, [x, y] = this.window.map((length) => length / 2)) {
    const scale = Math.min(LARGEST_SCALE, Math.max(this.smallestScale, this.scale * factor));
    this.left = x - ((x - this.left) * scale) / this.scale;
    this.top = y - ((y - this.top) * scale) / this.scale;
    this.scale = scale;
    this.#keepInSight();
  }

  panBy(dx, dy) {
    this.left += dx;
    this.top += dy;
    this.#keepInSight();
  }

  fit() {
    this.show([
      [-0.5, -0.5],
      [this.size[0] - 0.5, this.size[1] - 0.5],
    ]);
  }

  // Brings points of the picture into the middle, as large as they fit but no larger than the given scale.
  show(points, largest = Infinity) {
    const [us, vs] = [points.map((p) => p[0]), points.map((p) => p[1])];
    const [u0, u1, v0, v1] = [Math.min(...us), Math.max(...us), Math.min(...vs), Math.max(...vs)];
    const [width, height] = this.window;
    const fitting = Math.min((width - 2 * FIT_MARGIN) / (u1 - u0 || 1), (height - 2 * FIT_MARGIN) / (v1 - v0 || 1));
    this.scale = Math.min(Math.max(fitting, this.smallestScale), largest, LARGEST_SCALE);
    this.left = width / 2 - this.scale * ((u0 + u1) / 2 + 0.5);
    this.top = height / 2 - this.scale * ((v0 + v1) / 2 + 0.5);
    this.#keepInSight();
  }

  inSight(point) {
    const [x, y] = this.toScreen(point);
    return x > 0 && y > 0 && x < this.window[0] && y < this.window[1];
  }

  // Some of the picture always stays to be seen.
  #keepInSight() {
    const [width, height] = this.window;
    const least = 60;
    this.left = Math.min(width - least, Math.max(least - this.scale * this.size[0], this.left));
    this.top = Math.min(height - least, Math.max(least - this.scale * this.size[1], this.top));
    this.moved();
  }
}
