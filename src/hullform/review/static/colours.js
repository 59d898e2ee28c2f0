// One place for the colours of confidence: the style sheet's custom properties.

const known = new Map();

export function curveColour(standing) {
  if (!known.has(standing)) {
    const style = getComputedStyle(document.documentElement);
    known.set(standing, style.getPropertyValue(`--${standing}`).trim() || "#000");
  }
  return known.get(standing);
}
