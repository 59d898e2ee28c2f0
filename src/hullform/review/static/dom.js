// Small helpers to make elements, and to redraw a panel without losing the focus in it.

const SVG = "http://www.w3.org/2000/svg";

export const byId = (id) => document.getElementById(id);

function filled(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
}

export const make = (name, attributes = {}, ...children) => filled(document.createElement(name), attributes, children);

export const shape = (name, attributes = {}, ...children) =>
  filled(document.createElementNS(SVG, name), attributes, children);

export const pathOf = (points, closed = false) =>
  points.map(([u, v], index) => `${index ? "L" : "M"}${u} ${v}`).join("") + (closed ? "Z" : "");

const drawnBefore = new WeakMap();

// Elements that take the focus carry data-key, by which the focus finds its place again; what is being typed stays.
export function redraw(container, children) {
  const wanted = children.filter(Boolean);
  // what is the same stays, so that a press on it that is under way is not lost; so handlers look up what they need
  const html = wanted.map((child) => child.outerHTML).join("");
  const values = [...container.querySelectorAll("input, textarea")].some((input) => input.value !== input.defaultValue);
  if (drawnBefore.get(container) === html && !values) return;
  drawnBefore.set(container, html);
  const active = document.activeElement;
  const key = container.contains(active) ? active.dataset.key : undefined;
  const typed = key !== undefined && "value" in active && active.dataset.dirty !== undefined ? active.value : null;
  const scrolled = [...container.querySelectorAll("[data-scroll]")].map((one) => [one.dataset.scroll, one.scrollTop]);
  container.replaceChildren(...wanted);
  for (const [name, top] of scrolled) {
    const again = container.querySelector(`[data-scroll="${name}"]`);
    if (again) again.scrollTop = top;
  }
  if (key === undefined) return;
  const again = container.querySelector(`[data-key="${CSS.escape(key)}"]`);
  if (!again) return;
  if (typed !== null) {
    again.value = typed;
    again.dataset.dirty = "";
  }
  again.focus({ preventScroll: true });
}

// An input of one number; it reports a new value when it is left or Enter is pressed.
export function numberInput(key, label, value, step, report) {
  return make("input", {
    type: "number",
    step,
    value,
    "aria-label": label,
    "data-key": key,
    oninput: (event) => (event.target.dataset.dirty = ""),
    onchange: (event) => {
      delete event.target.dataset.dirty;
      const number = event.target.valueAsNumber;
      if (Number.isFinite(number)) report(number);
    },
  });
}
