// The chain on the start page: beads in linear wells that push and never pull, the first of which is struck again and
// again. A sketch that moves, drawn from a run of its own; the numbers of the book come from the programs.
(() => {
  "use strict";
  const canvas = document.getElementById("chain"), button = document.getElementById("chain-button");
  if (!canvas) return;
  const count = Math.max(20, Math.min(64, Math.floor(canvas.clientWidth / 14))), step = 0.04, velocity = 1.2, ending = 4.5 * count;
  let y, v, t;
  const strike = () => { y = new Float64Array(count); v = new Float64Array(count); v[0] = velocity; t = 0; };
  const accelerations = () => {
    const out = y.map((x) => -x);
    for (let n = 0; n + 1 < count; ++n) {
      const r = Math.max(0, y[n] - y[n + 1]), push = r * Math.sqrt(r);
      out[n] -= push;
      out[n + 1] += push;
    }
    return out;
  };
  const advance = (steps) => {
    let a = accelerations();
    for (let k = 0; k < steps; ++k, t += step) {
      v.forEach((_, n) => { v[n] += 0.5 * step * a[n]; y[n] += step * v[n]; });
      a = accelerations();
      v.forEach((_, n) => { v[n] += 0.5 * step * a[n]; });
    }
  };
  const draw = () => {
    const scale = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
    if (canvas.width !== Math.round(width * scale)) { canvas.width = Math.round(width * scale); canvas.height = Math.round(height * scale); }
    const pen = canvas.getContext("2d"), pitch = width / (count + 1), ink = getComputedStyle(canvas).color;
    pen.setTransform(scale, 0, 0, scale, 0, 0);
    pen.clearRect(0, 0, width, height);
    pen.strokeStyle = ink; pen.lineWidth = 1; pen.globalAlpha = 0.35;
    pen.beginPath(); pen.moveTo(0, 3.5); pen.lineTo(width, 3.5); pen.stroke();
    for (let n = 0; n < count; ++n) {
      const x = pitch * (n + 1), at = x + pitch * y[n] * 1.3, low = height - 12;
      pen.globalAlpha = 0.35; pen.strokeStyle = ink;
      pen.beginPath(); pen.moveTo(x, 3.5); pen.lineTo(at, low); pen.stroke();
      const energy = Math.min(1, (v[n] * v[n] + y[n] * y[n]) / 0.25);
      pen.globalAlpha = 1; pen.fillStyle = `rgb(${Math.round(86 + 127 * energy)}, ${Math.round(180 - 86 * energy)}, ${Math.round(233 * (1 - energy))})`;
      pen.beginPath(); pen.arc(at, low, Math.max(2, 0.42 * pitch), 0, 7); pen.fill();
    }
  };
  let running = !matchMedia("(prefers-reduced-motion: reduce)").matches, last = 0;
  const frame = (now) => {
    if (!running) return;
    const wanted = Math.min(0.05, (now - last) / 1000) * 8;
    last = now;
    advance(Math.round(wanted / step));
    if (t > ending) strike();
    draw();
    requestAnimationFrame(frame);
  };
  const say = () => { button.textContent = running ? "Pause" : "Play"; };
  button.addEventListener("click", () => { running = !running; say(); if (running) requestAnimationFrame(frame); });
  button.hidden = false;
  strike();
  // At rest there is nothing to see: a reader who wants no motion gets the chain some time after the blow.
  if (!running) advance(1500);
  draw();
  say();
  if (running) requestAnimationFrame(frame);
  new MutationObserver(draw).observe(document.body, { attributeFilter: ["data-theme"] });
  new ResizeObserver(draw).observe(canvas);
})();
