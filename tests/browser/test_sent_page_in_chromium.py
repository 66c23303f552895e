"""Pages to send, and what a notebook shows, in headless Chromium, in light and dark."""

import json
import re

import pytest
from processes import CLPT, ran
from test_page_in_chromium import CHROMIUM, IN_CHROMIUM, QUIET, asked, shown

import clpt_control as clpt

DARK = "--blink-settings=preferredColorScheme=0"
PROBE = """
<script>
const channels = (colour) => colour.match(/[\\d.]+/g).map(Number);
function light(colour) {
  const [r, g, b] = channels(colour).map((v) => (v /= 255) <= 0.04045 ? v / 12.92
    : ((v + 0.055) / 1.055) ** 2.4);
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}
function behind(element) {
  for (; element; element = element.parentElement) {
    const colour = getComputedStyle(element).backgroundColor;
    if (channels(colour)[3] !== 0) return colour;
  }
}
function contrast(element) {
  const style = getComputedStyle(element), drawn = element.closest("svg");
  const both = [light(drawn ? style.fill : style.color), light(behind(element))];
  return (Math.max(...both) + 0.05) / (Math.min(...both) + 0.05);
}
addEventListener("load", () => {
  const texts = [...document.body.querySelectorAll("*")].filter((one) => one.tagName !== "SCRIPT"
    && [...one.childNodes].some((node) => node.nodeType === 3 && node.data.trim()));
  parent.postMessage(JSON.stringify({
    inner: innerWidth, wide: document.documentElement.scrollWidth,
    fetched: performance.getEntriesByType("resource").map((one) => one.name),
    sections: [...document.querySelectorAll("section h2")].map((one) => one.id),
    texts: texts.length, dark: matchMedia("(prefers-color-scheme: dark)").matches,
    faint: texts.filter((one) => contrast(one) < 4.5).map((one) => one.outerHTML.slice(0, 90)),
    flat: [...document.querySelectorAll("figure svg")].filter(
      (one) => one.getBoundingClientRect().height < 100).length,
  }), "*");
});
</script>
"""
SECTIONS = {
    "run": ["achieved", "loop", "track", "clpe", "learning", "excitation", "scenario", "versions"],
    "team": ["achieved", "loop", "track", "excitation", "scenario", "versions"],
    "ensemble": ["spread", "varied", "scenario", "versions"],
}
pytestmark = IN_CHROMIUM


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    """Pages of a run, a team's run and an ensemble."""
    folder = tmp_path_factory.mktemp("pages")

    def clpt(*words):
        ran(*CLPT, *words, cwd=folder)

    clpt("init", "run.toml")
    text = (folder / "run.toml").read_text("utf-8").replace("duration = 2000", "duration = 400")
    (folder / "run.toml").write_text(text, "utf-8")
    member = "[team]\ncoupling = 0.5\n[team.members]\na = {}\nb = {}\n"
    (folder / "team.toml").write_text(f"{text}\n{member}", "utf-8")
    for name in ("run", "team"):
        clpt("run", f"{name}.toml", "--out", f"{name}.nc")
        clpt("report", f"{name}.nc", "-o", f"{name}.html")
    vary = ("--members", "8", "--vary", "learning.gain=0.2:2.0")
    clpt("ensemble", "run.toml", *vary, "--out", "ensemble.zarr")
    clpt("report", "ensemble.zarr", "-o", "ensemble.html")
    return folder


@pytest.mark.parametrize("name", SECTIONS)
def test_the_page_is_quiet(pages, tmp_path, name):
    tree, console = shown(pages / f"{name}.html", tmp_path / "profile")
    assert console == []
    assert "</footer>" in tree


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("width", [390, 1280])
@pytest.mark.parametrize("name", SECTIONS)
def test_the_page_is_read_on_its_screen(pages, tmp_path, name, width, theme):
    words = [DARK] if theme == "dark" else []
    found = asked(pages / f"{name}.html", PROBE, tmp_path, width, *words)
    assert found["inner"] == width
    assert found["wide"] <= width
    assert (found["fetched"], found["dark"]) == ([], theme == "dark")
    assert found["sections"] == SECTIONS[name]
    assert found["texts"] > 60
    assert (found["faint"], found["flat"]) == ([], 0)


def test_the_page_prints(pages, tmp_path):
    """As pages of paper, with the scenario unfolded."""
    made = tmp_path / "run.pdf"
    profile = f"--user-data-dir={tmp_path / 'profile'}"
    ran(CHROMIUM, *QUIET, profile, f"--print-to-pdf={made}", (pages / "run.html").as_uri())
    content = made.read_bytes()
    assert content.startswith(b"%PDF-")
    assert 2 <= len(re.findall(rb"/Type\s*/Page\b", content)) <= 8


# --- what a notebook shows takes the colours of its page -----------------------------------------

PAGE = """
<!DOCTYPE html><meta charset="utf-8"><body style="color:{ink};background:{paper}">{body}<script>
addEventListener("load", () => {{
  const of = (name, key) => [...document.querySelectorAll(name)].map((one) =>
    getComputedStyle(one)[key]);
  const found = {{
    text: [...new Set(of(".clpt td, .clpt strong, .clpt pre", "color"))],
    lines: [...new Set(of(".clpt svg path", "stroke"))].filter((one) => one !== "none"),
    letters: [...new Set(of(".clpt svg text", "fill"))],
    behind: [...new Set(of(".clpt, .clpt table, .clpt td, .clpt svg", "backgroundColor"))],
    fetched: performance.getEntriesByType("resource").map((one) => one.name),
    wide: document.documentElement.scrollWidth - innerWidth,
  }};
  document.body.textContent = JSON.stringify(found);
}});
</script>
"""


@pytest.mark.parametrize(
    ("ink", "paper"), [("rgb(1, 2, 3)", "white"), ("rgb(230, 231, 232)", "#111")]
)
def test_they_take_the_colours_of_the_page(ink, paper, tmp_path):
    scenario = clpt.paper_scenario().with_values({"run.duration": 40})
    loop = clpt.closed_loop(scenario)
    body = "".join(thing._repr_html_() for thing in (scenario, loop, clpt.draw(loop)))
    page = tmp_path / "page.html"
    page.write_text(PAGE.format(ink=ink, paper=paper, body=body), "utf-8")
    tree, console = shown(page, tmp_path / "profile", "--window-size=600,900")
    assert console == []
    found = json.loads(re.search(r"<body[^>]*>(.*?)</body>", tree, re.S)[1])
    assert found["text"] == found["letters"] == [ink]
    assert ink in found["lines"]
    assert found["behind"] == ["rgba(0, 0, 0, 0)"]
    assert found["fetched"] == []
    assert found["wide"] <= 0
