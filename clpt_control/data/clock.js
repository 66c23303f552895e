"use strict";
// Ages and overdue vehicles, counted on by the reader's clock. The page reads well without.
const HOUR = 3600000;
const hoursSince = (time) => (Date.now() - Date.parse(time)) / HOUR;
const age = (hours) => hours < 48 ? `${hours.toFixed(1)} h` : `${(hours / 24).toFixed(0)} d`;
const ageOf = (time) => age(Math.max(hoursSince(time), 0));
const fromNow = (hours) => hours < -0.05 ? `${age(-hours)} ago` : `in ${Math.abs(hours).toFixed(1)} h`;
const isOverdue = ({ overdue, until }) => hoursSince(overdue) > 0 && hoursSince(until) <= 0;
function countCard(card) {
  const late = isOverdue(card.dataset), words = fromNow(-hoursSince(card.dataset.time));
  card.classList.toggle("alarm", late);
  card.querySelector("h2").textContent = late ? "Overdue: next surfacing" : "Next surfacing";
  card.querySelector("small").textContent = late ? `expected ${words}` : words;
}
function countRow(row) {
  const titles = [...row.closest("table").tHead.rows[0].cells].map((one) => one.textContent);
  const pilot = row.cells[titles.indexOf("pilot")];
  row.cells[titles.indexOf("age")].textContent = ageOf(row.dataset.end);
  if (!isOverdue(row.dataset) || pilot.textContent.startsWith("overdue")) return;
  pilot.textContent = [row.dataset.words, pilot.textContent].filter(Boolean).join("; ");
  pilot.className = "alarm";
}
function countOn() {
  for (const mark of document.querySelectorAll("[data-since]"))
    mark.textContent = `${ageOf(mark.dataset.since)} ago`;
  for (const card of document.querySelectorAll("section[data-overdue]")) countCard(card);
  for (const card of document.querySelectorAll("section[data-end]"))
    card.querySelector("b").textContent = `${ageOf(card.dataset.end)} ago`;
  for (const row of document.querySelectorAll("tr[data-end]")) countRow(row);
}
countOn();
// A zoomed map is being read, and stays.
const again = document.body.dataset.again;
if (again) setInterval(() => { if (!document.querySelector(".zoomed")) location.reload(); }, 1000 * again);
setInterval(countOn, 60000);
