"use strict";
// The map's zoom, its grid, the dive under the pointer, hours from now. The page reads well without.
const map = document.getElementById("map"), said = document.getElementById("said");
const full = map.viewBox.baseVal, W = full.width, H = full.height, facts = map.dataset;
const heights = facts.heights.split(" ").map(Number);
const [west, east, south, north] = ["west", "east", "south", "north"].map((k) => +facts[k]);
const DEEPEST = 200, STEPS = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 1800];
let view = { x: 0, y: 0, w: W, h: H };

const clamp = (v, low, high) => Math.min(Math.max(v, low), high);
function part(name, attributes, parent, text) {
  const made = document.createElementNS(map.namespaceURI, name);
  for (const key in attributes) made.setAttribute(key, attributes[key]);
  if (text !== undefined) made.textContent = text;
  parent.append(made);
  return made;
}
function yOf(lat) {
  const at = ((lat - south) / (north - south)) * (heights.length - 1);
  const k = clamp(Math.floor(at), 0, heights.length - 2);
  return heights[k] + (at - k) * (heights[k + 1] - heights[k]);
}
const xOf = (lon) => ((lon - west) / (east - west)) * W;
function named(angle, names, step) {
  if (names === "EW") angle = ((angle + 540) % 360 + 360) % 360 - 180;
  const digits = step >= 1 ? 0 : step >= 0.1 ? 1 : 2;
  const hundredths = Math.round(Math.abs(angle) * 60 * 100) / 100;
  const whole = Math.floor(hundredths / 60), rest = hundredths - 60 * whole;
  const minutes = rest.toFixed(digits).padStart(digits ? digits + 3 : 2, "0");
  return whole + "°" + (step >= 60 ? "" : minutes + "'") + names[angle < 0 ? 1 : 0];
}
function label(x, y, dx, dy, text, parent) {
  const group = part("g", { class: "m", transform: `translate(${x} ${y})` }, parent);
  part("text", { class: "degrees", x: dx, y: dy }, group, text);
}
function grid() {
  const group = document.getElementById("grid"), minutes = ((east - west) * 60 * view.w) / W;
  const tall = ((north - south) * 60 * view.h) / H;
  const [up, along] = [tall, minutes].map((span) => STEPS.find((s) => s >= span / 5) || 1800);
  group.replaceChildren();
  for (let k = Math.ceil((south * 60) / up); k * up <= north * 60; k++) {
    const y = yOf((k * up) / 60);
    if (y < view.y || y > view.y + view.h) continue;
    part("path", { class: "grid", d: `M${view.x} ${y}h${view.w}` }, group);
    if (y < view.y + view.h - 24 * pixel()) label(view.x, y, 4, -4, named((k * up) / 60, "NS", up), group);
  }
  for (let k = Math.ceil((west * 60) / along); k * along <= east * 60; k++) {
    const x = xOf((k * along) / 60);
    if (x < view.x || x > view.x + view.w) continue;
    part("path", { class: "grid", d: `M${x} ${view.y}v${view.h}` }, group);
    label(x, view.y + view.h, 4, -5, named((k * along) / 60, "EW", along), group);
  }
}
function scaleBar() {
  const group = document.getElementById("scale"), most = 0.25 * view.w * facts.metres;
  const power = 10 ** Math.floor(Math.log10(most));
  const length = [5, 2, 1].find((m) => m * power <= most) * power, long = length / facts.metres;
  const x = view.x + 0.97 * view.w - long, y = view.y + view.h - 24 * pixel();
  group.replaceChildren();
  part("path", { class: "scale", d: `M${x} ${y - 6 * pixel()}V${y}h${long}v${-6 * pixel()}` }, group);
  label(x, y, 6, -8, length >= 1000 ? length / 1000 + " km" : length + " m", group);
}
function pixel() {
  const box = map.getBoundingClientRect();
  return 1 / (Math.min(box.width / view.w, box.height / view.h) || 1);
}
function draw() {
  map.setAttribute("viewBox", `${view.x} ${view.y} ${view.w} ${view.h}`);
  map.style.setProperty("--k", pixel());
  const level = Math.floor(Math.log2(1 / pixel() / 0.36) + 0.01);
  for (const text of document.querySelectorAll("#numbers text"))
    text.style.display = +text.getAttribute("class").slice(1) <= level ? "inline" : "none";
  map.style.touchAction = view.w < 0.99 * W ? "none" : "pan-y";
  grid();
  scaleBar();
}
function zoomBy(factor, x, y) {
  const w = clamp(view.w / factor, W / DEEPEST, W), shrink = w / view.w;
  view = { x: x - (x - view.x) * shrink, y: y - (y - view.y) * shrink, w: w, h: (w * H) / W };
  move(0, 0);
}
function move(dx, dy) {
  view.x = clamp(view.x + dx, 0, W - view.w);
  view.y = clamp(view.y + dy, 0, H - view.h);
  draw();
}
function unitsAt(event) {
  const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(map.getScreenCTM().inverse());
  return [point.x, point.y];
}
function choose(number) {
  for (const old of document.querySelectorAll(".on")) old.classList.remove("on");
  if (number === null) return;
  for (const found of document.querySelectorAll("[data-dive]"))
    if (found.dataset.dive === number) {
      found.classList.add("on");
      const title = found.querySelector("title");
      if (title) said.textContent = title.textContent;
    }
}
function nearest(event) {
  let best = null, least = 30;
  for (const dive of document.querySelectorAll("#dives .dive")) {
    const box = dive.querySelector("circle").getBoundingClientRect();
    const far = Math.hypot(box.x + box.width / 2 - event.clientX, box.y + box.height / 2 - event.clientY);
    if (far < least) [best, least] = [dive.dataset.dive, far];
  }
  return best;
}
const down = new Map();
map.addEventListener("wheel", (event) => {
  event.preventDefault();
  zoomBy(Math.exp(-event.deltaY / 400), ...unitsAt(event));
}, { passive: false });
map.addEventListener("pointerdown", (event) => {
  down.set(event.pointerId, unitsAt(event));
  choose(nearest(event));
});
map.addEventListener("pointermove", (event) => {
  if (!down.has(event.pointerId)) {
    const found = nearest(event);
    if (found !== null) choose(found);
    return;
  }
  const [x, y] = unitsAt(event), [x0, y0] = down.get(event.pointerId);
  if (down.size === 1) move(x0 - x, y0 - y);
  else {
    const other = [...down].find(([id]) => id !== event.pointerId)[1];
    const before = Math.hypot(x0 - other[0], y0 - other[1]), now = Math.hypot(x - other[0], y - other[1]);
    if (before > 0) zoomBy(clamp(now / before, 0.5, 2), ...other);
    down.set(event.pointerId, unitsAt(event));
  }
});
for (const name of ["pointerup", "pointercancel", "pointerleave"])
  map.addEventListener(name, (event) => down.delete(event.pointerId));
const buttons = document.querySelector(".buttons");
for (const [name, hint, act] of [
  ["+", "zoom in", () => zoomBy(2, view.x + view.w / 2, view.y + view.h / 2)],
  ["−", "zoom out", () => zoomBy(0.5, view.x + view.w / 2, view.y + view.h / 2)],
  ["⤢", "whole map", () => { view = { x: 0, y: 0, w: W, h: H }; draw(); }],
]) {
  const button = document.createElement("button");
  button.textContent = name;
  button.title = hint;
  button.addEventListener("click", act);
  buttons.append(button);
}
for (const row of document.querySelectorAll("tr[data-dive]"))
  for (const name of ["pointerenter", "click"])
    row.addEventListener(name, () => choose(row.dataset.dive));
function hours() {
  for (const mark of document.querySelectorAll("[data-time]")) {
    const left = (Date.parse(mark.dataset.time) - Date.now()) / 3600000;
    mark.textContent = left < -0.05 ? `${(-left).toFixed(1)} h ago` : `in ${Math.abs(left).toFixed(1)} h`;
  }
}
hours();
setInterval(hours, 60000);
const again = document.querySelector("[data-again]");
// A zoomed map is being read, and stays.
if (again) setInterval(() => { if (view.w === W) location.reload(); }, 1000 * again.dataset.again);
addEventListener("resize", draw);
draw();
