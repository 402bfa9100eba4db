// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace fairway::vda5050 {

/// The live page: one file of HTML that asks for /map once and for /robots five times a second.
inline constexpr std::string_view kLivePage = R"page(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>Fairway: VDA 5050</title>
<style>
body { margin: 0; font: 14px system-ui, sans-serif; color: #222; display: flex; flex-wrap: wrap; }
canvas { flex: 3 1 500px; min-width: 300px; height: 100vh; background: #f4f4f2; }
aside { flex: 1 1 260px; padding: 12px; box-sizing: border-box; overflow: auto; max-height: 100vh; }
h1 { font-size: 16px; margin: 0 0 8px; } h2 { font-size: 14px; margin: 12px 0 2px; }
.error { color: #a00000; } .quiet { color: #666; } p { margin: 2px 0; }
@media (prefers-color-scheme: dark) { body { background: #1d1f21; color: #ddd; }
canvas { background: #26282b; } .quiet { color: #aaa; } .error { color: #ff8a80; } }
</style></head><body>
<canvas id="view" role="img" aria-label="Map with robots, corridors and zones"></canvas>
<aside><h1>VDA 5050</h1><div id="robots" aria-live="polite"></div>
<p class="quiet">Blue: the strip of each edge, pale in the horizon. Green: planned path. Red: blocked
zone. Yellow: other zones.</p></aside>
<script>
"use strict";
const view = document.getElementById("view"), list = document.getElementById("robots");
let map = null, tiles = null;
function draw(robots) {
  const ratio = window.devicePixelRatio || 1;
  view.width = view.clientWidth * ratio; view.height = view.clientHeight * ratio;
  const pen = view.getContext("2d"), w = map.width * map.resolution, h = map.height * map.resolution;
  const scale = 0.96 * Math.min(view.width / w, view.height / h);
  pen.setTransform(scale, 0, 0, -scale, 0.5 * (view.width - scale * w), 0.5 * (view.height + scale * h));
  pen.save(); pen.scale(map.resolution, map.resolution);
  pen.imageSmoothingEnabled = false; pen.drawImage(tiles, 0, 0); pen.restore();
  pen.rotate(-map.origin[2]); pen.translate(-map.origin[0], -map.origin[1]);
  const trace = (points, close) => { pen.beginPath();
    points.forEach((p, i) => i ? pen.lineTo(p[0], p[1]) : pen.moveTo(p[0], p[1])); if (close) pen.closePath(); };
  for (const zone of robots.length ? robots[0].zones : []) {
    trace(zone.vertices, true); pen.fillStyle = zone.type === "BLOCKED" ? "#d0404066" : "#d0a02055"; pen.fill();
  }
  for (const robot of robots) {
    for (const leg of robot.legs) {
      if (leg.strip) { trace(leg.strip, true); pen.fillStyle = leg.released ? "#3070c033" : "#3070c014"; pen.fill(); }
      trace(leg.line); pen.lineWidth = 0.04; pen.strokeStyle = leg.released ? "#3070c0" : "#3070c066"; pen.stroke();
    }
    for (const node of robot.nodes) {
      pen.beginPath(); pen.arc(node.x, node.y, 0.09, 0, 7);
      pen.fillStyle = node.released ? "#3070c0" : "#3070c066"; pen.fill();
    }
    trace([[robot.x, robot.y], ...robot.planned]); pen.lineWidth = 0.05; pen.strokeStyle = "#2a9050"; pen.stroke();
    pen.beginPath(); pen.arc(robot.x, robot.y, robot.radius, 0, 7);
    pen.fillStyle = robot.errors.length ? "#c03030" : "#e08020"; pen.fill();
    trace([[robot.x, robot.y], [robot.x + robot.radius * Math.cos(robot.theta), robot.y + robot.radius * Math.sin(robot.theta)]]);
    pen.lineWidth = 0.06; pen.strokeStyle = "#fff"; pen.stroke();
  }
}
function line(kind, text) { const p = document.createElement("p"); p.className = kind; p.textContent = text; return p; }
function describe(robots) {
  list.replaceChildren(...robots.flatMap(robot => {
    const title = document.createElement("h2"); title.textContent = robot.serial;
    const state = robot.paused ? "paused" : robot.driving ? "driving, " + robot.speed.toFixed(2) + " m/s" : "at standstill";
    return [title, line("", robot.order ? "order " + robot.order + ", last node " + robot.last_node : "no order"),
      line("", state), ...(robot.limit ? [line("quiet", robot.limit)] : []),
      ...robot.errors.map(error => line("error", error))];
  }));
}
async function start() {
  map = await (await fetch("/map")).json();
  tiles = document.createElement("canvas"); tiles.width = map.width; tiles.height = map.height;
  const pen = tiles.getContext("2d"); pen.fillStyle = "#707478";
  map.rows.forEach((row, y) => { for (let x = 0; x < map.width; ++x)
    if (parseInt(row[x >> 2], 16) >> (x & 3) & 1) pen.fillRect(x, y, 1, 1); });
  for (;;) {
    try {
      const robots = (await (await fetch("/robots")).json()).robots || [];
      draw(robots); describe(robots);
    } catch (error) { list.replaceChildren(line("error", "the program does not answer")); }
    await new Promise(done => setTimeout(done, 200));
  }
}
start();
</script></body></html>
)page";

}  // namespace fairway::vda5050
