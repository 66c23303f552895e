// The map's zoom and the dive under the pointer. The page reads well without.
const map = document.getElementById("map"), said = document.getElementById("said");
const full = { x: 0, y: 0, w: map.viewBox.baseVal.width, h: map.viewBox.baseVal.height };
// place of the chart in the map, its edges in degrees, metres of a unit
const [left, top_, wide, high, south, north, west, east, metres] = map.dataset.chart.split(" ").map(Number);
const DEEPEST = 200, STEPS = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 1800];
let view = { ...full };

const clamp = (v, low, high) => Math.min(Math.max(v, low), high);
const zoomed = () => view.w < 0.99 * full.w;
function part(name, attributes, parent, text) {
  const made = document.createElementNS(map.namespaceURI, name);
  for (const key in attributes) made.setAttribute(key, attributes[key]);
  if (text !== undefined) made.textContent = text;
  parent.append(made);
  return made;
}
const yOf = (lat) => top_ + ((north - lat) / (north - south)) * high;
const xOf = (lon) => left + ((lon - west) / (east - west)) * wide;
function named(angle, names, step) {
  if (names === "EW") angle = ((angle + 540) % 360 + 360) % 360 - 180;
  const digits = step >= 1 ? 0 : step >= 0.1 ? 1 : 2;
  const hundredths = Math.round(Math.abs(angle) * 60 * 100) / 100;
  const whole = Math.floor(hundredths / 60), rest = hundredths - 60 * whole;
  const minutes = rest.toFixed(digits).padStart(digits ? digits + 3 : 2, "0");
  return whole + "°" + (step >= 60 ? "" : minutes + "'") + names[angle < 0 ? 1 : 0];
}
// What is drawn anew at each zoom.
const over = part("g", { class: "over" }, map);
function label(x, y, text, kind) {
  part("text", { class: kind, x: x, y: y, "font-size": 11 * pixel(), "stroke-width": 3 * pixel() }, over, text);
}
function grid() {
  const minutes = ((east - west) * 60 * view.w) / wide, tall = ((north - south) * 60 * view.h) / high;
  const [up, along] = [tall, minutes].map((span) => STEPS.find((s) => s >= span / 5) || 1800);
  for (let k = Math.ceil((south * 60) / up); k * up <= north * 60; k++) {
    const y = yOf((k * up) / 60);
    if (y < view.y || y > view.y + view.h - 24 * pixel()) continue;
    part("path", { class: "grid", d: `M${view.x} ${y}h${view.w}` }, over);
    label(view.x + 4 * pixel(), y - 4 * pixel(), named((k * up) / 60, "NS", up), "degrees");
  }
  for (let k = Math.ceil((west * 60) / along); k * along <= east * 60; k++) {
    const x = xOf((k * along) / 60);
    if (x < view.x || x > view.x + view.w) continue;
    part("path", { class: "grid", d: `M${x} ${view.y}v${view.h}` }, over);
    label(x + 4 * pixel(), view.y + view.h - 5 * pixel(), named((k * along) / 60, "EW", along), "degrees");
  }
}
function scaleBar() {
  const most = 0.25 * view.w * metres, power = 10 ** Math.floor(Math.log10(most));
  const length = [5, 2, 1].find((m) => m * power <= most) * power, long = length / metres;
  const x = view.x + 0.97 * view.w - long, y = view.y + view.h - 24 * pixel();
  part("path", { class: "scale", d: `M${x} ${y - 6 * pixel()}V${y}h${long}v${-6 * pixel()}` }, over);
  label(x + 6 * pixel(), y - 8 * pixel(), length >= 1000 ? length / 1000 + " km" : length + " m", "");
}
for (const mark of map.querySelectorAll("use"))
  mark.style.transformOrigin = `${mark.getAttribute("x")}px ${mark.getAttribute("y")}px`;
const fixes = [...map.querySelectorAll("a")].map((link) => {
  const box = link.getBBox(), row = document.querySelector(link.getAttribute("href"));
  return { x: box.x + box.width / 2, y: box.y + box.height / 2, row: row };
});
function numbers() {
  const here = fixes.filter(({ x, y }) => Math.abs(x - view.x - view.w / 2) < view.w / 2 && Math.abs(y - view.y - view.h / 2) < view.h / 2);
  const taken = [];
  for (const { x, y, row } of here.reverse()) {
    if (taken.some((one) => Math.abs(one.x - x) < 34 * pixel() && Math.abs(one.y - y) < 15 * pixel())) continue;
    taken.push({ x, y });
    label(x + 7 * pixel(), y - 5 * pixel(), row.cells[0].textContent, "number");
  }
}
function pixel() {
  const box = map.getBoundingClientRect();
  return 1 / (Math.min(box.width / view.w, box.height / view.h) || 1);
}
function draw() {
  map.setAttribute("viewBox", `${view.x} ${view.y} ${view.w} ${view.h}`);
  map.style.setProperty("--k", view.w / full.w);
  map.style.touchAction = zoomed() ? "none" : "pan-y";
  map.classList.toggle("zoomed", zoomed());
  over.replaceChildren();
  if (!zoomed()) return;
  grid();
  scaleBar();
  numbers();
}
function zoomBy(factor, x, y) {
  const w = clamp(view.w / factor, full.w / DEEPEST, full.w), shrink = w / view.w;
  view = { x: x - (x - view.x) * shrink, y: y - (y - view.y) * shrink, w: w, h: (w * full.h) / full.w };
  move(0, 0);
}
function move(dx, dy) {
  view.x = clamp(view.x + dx, 0, full.w - view.w);
  view.y = clamp(view.y + dy, 0, full.h - view.h);
  draw();
}
function unitsAt(event) {
  const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(map.getScreenCTM().inverse());
  return [point.x, point.y];
}
function choose(row) {
  for (const old of document.querySelectorAll(".on")) old.classList.remove("on");
  if (row === null) return;
  row.classList.add("on");
  map.querySelector(`a[href="#${row.id}"]`).classList.add("on");
  said.textContent = row.title;
}
function nearest(event) {
  const [x, y] = unitsAt(event);
  let best = null, least = 30 * pixel();
  for (const fix of fixes) {
    const far = Math.hypot(fix.x - x, fix.y - y);
    if (far < least) [best, least] = [fix.row, far];
  }
  return best;
}
const down = new Map();
// A fix is a link for who has no script.
map.addEventListener("click", (event) => event.preventDefault());
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
// The first zoom goes to the chart's middle, not to that of its legend.
const middle = () => zoomed() ? [view.x + view.w / 2, view.y + view.h / 2] : [left + wide / 2, top_ + high / 2];
const buttons = document.querySelector(".buttons");
for (const [name, hint, act] of [
  ["+", "zoom in", () => zoomBy(2, ...middle())],
  ["−", "zoom out", () => zoomBy(0.5, ...middle())],
  ["⤢", "whole map", () => { view = { ...full }; draw(); }],
]) {
  const button = document.createElement("button");
  button.textContent = name;
  button.title = hint;
  button.addEventListener("click", act);
  buttons.append(button);
}
for (const row of document.querySelectorAll("tr[id]"))
  for (const name of ["pointerenter", "click"])
    row.addEventListener(name, () => choose(row));
addEventListener("resize", draw);
draw();
