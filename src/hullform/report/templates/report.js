"use strict";
// The still picture stays where the browser has no WebGL; elsewhere the hull loads once it comes near the window.
(function () {
  const box = document.getElementById("hull-view");
  const still = box.querySelector("img");
  const hint = document.getElementById("hull-hint");
  function hasWebGL() {
    try {
      const context = document.createElement("canvas").getContext("webgl");
      if (!context) return false;
      const lose = context.getExtension("WEBGL_lose_context");
      if (lose) lose.loseContext();
      return true;
    } catch (error) {
      return false;
    }
  }
  function show() {
    if (!hasWebGL()) {
      hint.textContent = "A still picture: this browser has no WebGL.";
      return;
    }
    const frame = document.createElement("iframe");
    frame.title = "The hull in three dimensions";
    frame.srcdoc = JSON.parse(document.getElementById("hull-page").textContent);
    still.hidden = true;
    box.appendChild(frame);
    hint.textContent = "Drag to turn. Click once, then the wheel zooms.";
  }
  new IntersectionObserver(function (entries, observer) {
    if (entries.some(function (entry) { return entry.isIntersecting; })) {
      observer.disconnect();
      show();
    }
  }, { rootMargin: "200px" }).observe(box);
})();
