// A table that is wider than its page has small letters; where that does not do its code breaks
// anywhere, and on a telephone it stands row by row, each cell after the name of its column.
const tables = () => document.querySelectorAll(".bd-article .pst-scrollable-table-container > table");

function name() {
  for (const table of tables()) {
    const names = [...table.querySelectorAll("thead th")].map((one) => one.textContent);
    for (const row of table.tBodies[0].rows)
      [...row.cells].forEach((cell, k) => { cell.dataset.column = names[k] || ""; });
  }
}

function fit() {
  for (const table of tables()) {
    const place = table.parentElement, wide = () => place.scrollWidth > place.clientWidth;
    table.classList.remove("small", "broken", "row-by-row");
    table.classList.toggle("small", wide());
    table.classList.toggle(innerWidth <= 600 ? "row-by-row" : "broken", wide());
  }
}

document.addEventListener("DOMContentLoaded", () => { name(); fit(); });
addEventListener("load", fit);
addEventListener("resize", fit);
