// Zoom of the figures: double click or + and -, drag when zoomed, Ctrl and wheel; Escape resets.
for (const svg of document.querySelectorAll("figure svg[viewBox]")) {
  const box = svg.viewBox.baseVal, full = { x: box.x, y: box.y, w: box.width, h: box.height };
  let view = { ...full }, grip = null;
  const clamp = (v, low, high) => Math.min(Math.max(v, low), high);
  const zoomed = () => view.w < 0.99 * full.w;
  const reset = document.createElement("button");
  reset.textContent = "whole figure";
  reset.className = "reset";
  reset.addEventListener("click", () => show({ ...full }));
  svg.after(reset);
  function show(wanted) {
    const w = clamp(wanted.w, full.w / 50, full.w), h = (w * full.h) / full.w;
    view = { w, h, x: clamp(wanted.x, full.x, full.x + full.w - w), y: clamp(wanted.y, full.y, full.y + full.h - h) };
    svg.setAttribute("viewBox", `${view.x} ${view.y} ${view.w} ${view.h}`);
    svg.style.cursor = zoomed() ? "grab" : "zoom-in";
    svg.style.touchAction = zoomed() ? "none" : "auto";
    reset.hidden = !zoomed();
  }
  function pointOf(event) {
    const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    return [point.x, point.y];
  }
  function zoom(factor, x, y) {
    show({ x: x - (x - view.x) / factor, y: y - (y - view.y) / factor, w: view.w / factor });
  }
  const middle = () => [view.x + view.w / 2, view.y + view.h / 2];
  svg.tabIndex = 0;
  svg.addEventListener("dblclick", (event) => { event.preventDefault(); zoom(2, ...pointOf(event)); });
  svg.addEventListener("wheel", (event) => {
    if (!event.ctrlKey) return;
    event.preventDefault();
    zoom(Math.exp(-event.deltaY / 400), ...pointOf(event));
  }, { passive: false });
  svg.addEventListener("keydown", (event) => {
    if (event.key === "+") zoom(2, ...middle());
    else if (event.key === "-") zoom(0.5, ...middle());
    else if (event.key === "Escape") show({ ...full });
  });
  svg.addEventListener("pointerdown", (event) => { grip = zoomed() ? pointOf(event) : null; });
  svg.addEventListener("pointermove", (event) => {
    if (grip === null) return;
    const [x, y] = pointOf(event);
    show({ x: view.x + grip[0] - x, y: view.y + grip[1] - y, w: view.w });
  });
  for (const name of ["pointerup", "pointercancel", "pointerleave"])
    svg.addEventListener(name, () => { grip = null; });
  show({ ...full });
}
