#pragma once

#include <string_view>

namespace parmesan {

/// The page that plays an evolution; the list of frames (see evolution.cpp) comes between head and tail.
inline constexpr std::string_view evolution_page_head = R"html(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>Evolution of a mesh</title>
<style>
body { margin: 0; font: 14px Helvetica, Arial, sans-serif; color: #111827; background: #f3f4f6; }
#bar { display: flex; flex-wrap: wrap; gap: 8px 14px; align-items: center; padding: 8px 12px; }
#bar input[type=range] { vertical-align: middle; }
#frame { flex: 1 1 200px; }
canvas { display: block; width: 100vw; height: calc(100vh - 90px); background: #fff; cursor: grab; }
button { min-width: 3.5em; }
#text { padding: 0 12px 6px; font-variant-numeric: tabular-nums; }
</style></head><body>
<div id="bar">
<button id="back" title="one frame back (left arrow)">&#9664;|</button>
<button id="play" title="play or pause (space)">Play</button>
<button id="step" title="one frame on (right arrow)">|&#9654;</button>
<input id="frame" type="range" min="0" value="0" aria-label="frame">
<label>speed <input id="speed" type="range" min="1" max="60" value="10"></label>
<button id="in">+</button><button id="out">&minus;</button><button id="fit">Fit</button>
</div><div id="text"></div><canvas id="view"></canvas>
<script>
"use strict";
const frames = [
)html";

inline constexpr std::string_view evolution_page_tail = R"html(
];
const at = id => document.getElementById(id);
const canvas = at("view"), pen = canvas.getContext("2d");
let now = 0, playing = false, last = 0, zoom = 1, panX = 0, panY = 0;
at("frame").max = frames.length - 1;

function draw() {
  const ratio = window.devicePixelRatio || 1, f = frames[now];
  canvas.width = canvas.clientWidth * ratio;
  canvas.height = canvas.clientHeight * ratio;
  const margin = 16 * ratio;
  const fit = Math.min((canvas.width - 2 * margin) / f.w, (canvas.height - 2 * margin) / f.h);
  const s = fit * zoom, x0 = (canvas.width - f.w * s) / 2 + panX * ratio, y0 = (canvas.height + f.h * s) / 2 + panY * ratio;
  const X = v => x0 + f.p[2 * v] * s, Y = v => y0 - f.p[2 * v + 1] * s;
  pen.lineWidth = ratio * Math.min(1, Math.max(0.25, zoom * 12 / Math.sqrt(f.t.length / 3)));
  pen.strokeStyle = "#334155";
  pen.beginPath();
  for (let i = 0; i < f.t.length; i += 3) {
    pen.moveTo(X(f.t[i]), Y(f.t[i]));
    pen.lineTo(X(f.t[i + 1]), Y(f.t[i + 1]));
    pen.lineTo(X(f.t[i + 2]), Y(f.t[i + 2]));
    pen.closePath();
  }
  pen.stroke();
  pen.lineWidth = 1.8 * ratio;
  pen.strokeStyle = "#0f172a";
  pen.beginPath();
  for (let i = 0; i < f.e.length; i += 2) {
    pen.moveTo(X(f.e[i]), Y(f.e[i]));
    pen.lineTo(X(f.e[i + 1]), Y(f.e[i + 1]));
  }
  pen.stroke();
  at("frame").value = now;
  at("text").textContent = "frame " + (now + 1) + " of " + frames.length + ", step " + f.s + ", " +
    f.p.length / 2 + " vertices, " + f.t.length / 3 + " triangles";
}
function show(i) { now = Math.max(0, Math.min(frames.length - 1, i)); draw(); }
function pause() { playing = false; at("play").textContent = "Play"; }
function toggle() {
  if (playing) return pause();
  if (now === frames.length - 1) now = 0;
  playing = true;
  at("play").textContent = "Pause";
  requestAnimationFrame(tick);
}
function tick(time) {
  if (!playing) return;
  if (time - last >= 1000 / at("speed").value) {
    last = time;
    if (now === frames.length - 1) return pause();
    show(now + 1);
  }
  requestAnimationFrame(tick);
}
function scale(factor) { zoom *= factor; panX *= factor; panY *= factor; draw(); }
at("play").onclick = toggle;
at("back").onclick = () => { pause(); show(now - 1); };
at("step").onclick = () => { pause(); show(now + 1); };
at("frame").oninput = e => { pause(); show(+e.target.value); };
at("in").onclick = () => scale(1.4);
at("out").onclick = () => scale(1 / 1.4);
at("fit").onclick = () => { zoom = 1; panX = panY = 0; draw(); };
canvas.onwheel = e => {
  e.preventDefault();
  const factor = Math.exp(-e.deltaY / 500), box = canvas.getBoundingClientRect();
  const dx = e.clientX - box.left - box.width / 2, dy = e.clientY - box.top - box.height / 2;
  panX = dx + (panX - dx) * factor;
  panY = dy + (panY - dy) * factor;
  zoom *= factor;
  draw();
};
canvas.onpointerdown = e => canvas.setPointerCapture(e.pointerId);
canvas.onpointermove = e => { if (e.buttons & 1) { panX += e.movementX; panY += e.movementY; draw(); } };
document.onkeydown = e => {
  if (e.key === " ") { e.preventDefault(); toggle(); }
  if (e.key === "ArrowLeft") { pause(); show(now - 1); }
  if (e.key === "ArrowRight") { pause(); show(now + 1); }
};
window.onresize = draw;
show(0);
</script></body></html>
)html";

}  // namespace parmesan
