"""Pages of a replay and to send, and what a notebook shows, in headless Chromium.

They are whole, quiet, no wider than a telephone, and read in light and dark.

Run by `make test-browser`; skipped, with the reason, where no Chromium is installed.
"""

import json
import re
import shutil
import threading
import time
from dataclasses import replace
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer

import pytest
from paths import ROOT
from subprocesses import CLPT, ran
from synthetic_vehicle import fixes_of

import clpt_control as clpt
from clpt_control.gliders import write_dive_table

NAMES = ("chromium", "chromium-browser", "google-chrome", "chromium-headless-shell")
CHROMIUM = next(filter(None, map(shutil.which, NAMES)), "")
QUIET = [
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
]
QUIET += [
    "--disable-sync",
    "--disable-background-networking",
    "--disable-component-update",
]
PROBE = """
<script>
FOUND
addEventListener("load", () => parent.postMessage(JSON.stringify({
  inner: innerWidth, wide: document.documentElement.scrollWidth, ...found(),
  fetched: performance.getEntriesByType("resource").map((one) => one.name),
}), "*"));
</script>
"""
REPLAY = """
function found() {
  const k = () => +getComputedStyle(map).getPropertyValue("--k"), first = k();
  const before = map.viewBox.baseVal.width, tables = [...document.querySelectorAll(".table")];
  const beyond = tables.map((one) => one.scrollWidth - one.clientWidth);
  document.querySelector(".buttons button").click();
  document.querySelector("tr[id]").click();
  return { k: first, zoom: before / map.viewBox.baseVal.width, smaller: first / k(), beyond,
    buttons: document.querySelectorAll(".buttons button").length,
    named: document.querySelectorAll("#map .degrees").length,
    said: document.getElementById("said").textContent };
}
"""
WORDS = """
function found() {
  const broken = [], table = document.querySelector(".table");
  for (const cell of document.querySelectorAll("td:not(:first-child)")) {
    const text = cell.firstChild?.nodeValue ?? "";
    for (const { 0: word, index } of text.matchAll(/\\S+/g)) {
      const range = document.createRange();
      range.setStart(cell.firstChild, index);
      range.setEnd(cell.firstChild, index + word.length);
      if (range.getClientRects().length > 1) broken.push(word);
    }
  }
  return { broken, words: document.querySelectorAll("td").length,
    beyond: table.scrollWidth - table.clientWidth };
}
"""
FRAME = """
<!DOCTYPE html><body><iframe src="{page}" style="border:0;width:{width}px;height:900px"></iframe>
<script>addEventListener("message", (event) => {{ document.body.textContent = event.data; }});
</script>
"""
pytestmark = [
    pytest.mark.browser,
    pytest.mark.skipif(
        not CHROMIUM, reason="no Chromium is installed: chromium is not on PATH"
    ),
]


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    """The page of sixty dives, aimed at a waypoint."""
    folder = tmp_path_factory.mktemp("page")
    write_dive_table(fixes_of(60), folder / "dives.csv")
    ran(*CLPT, "replay", "dives.csv", "--aim", 40.5, 9.0, "--out", "out", cwd=folder)
    return folder / "out" / "replay.html"


def shown(path, profile, *words):
    """What Chromium makes of a file: its tree, and what its console says."""
    words = f"--user-data-dir={profile}", "--enable-logging=stderr", *words
    done = ran(CHROMIUM, *QUIET, *words, "--dump-dom", path.as_uri())
    return done.stdout, re.findall(r"CONSOLE.*", done.stderr)


def test_the_page_obeys_its_own_policy(page, tmp_path):
    """Its script runs under the policy, and nothing is refused, missed or complained of."""
    tree, console = shown(page, tmp_path / "profile")
    assert (console, tree.count("<button")) == ([], 3)
    assert re.search(r'<svg id="map"[^>]*style="[^"]*--k', tree)


def asked(page, probe, tmp_path, width, *words):
    """What a probe finds in a page on a screen so wide, which it fits, and fetches nothing."""
    text = re.sub(r"<meta http-equiv[^>]*>", "", page.read_text("utf-8"))
    probed = tmp_path / "probed.html"
    head = "<head>" + PROBE.replace("FOUND", probe)
    probed.write_text(text.replace("<head>", head, 1), "utf-8")
    frame = tmp_path / "frame.html"
    frame.write_text(FRAME.format(page=probed.as_uri(), width=width), "utf-8")
    words = (
        f"--window-size={max(width, 500)},900",
        "--virtual-time-budget=5000",
        *words,
    )
    tree, console = shown(frame, tmp_path / "profile", *words)
    found = json.loads(re.search(r"<body>(.*?)</body>", tree, re.S)[1])
    assert (console, found["fetched"], found["inner"]) == ([], [], width)
    assert found["wide"] <= width
    return found


def test_the_words_of_a_fleet_are_whole_on_a_telephone(tmp_path):
    for name in ("north", "a_long_name_of_a_vehicle_2026"):
        (tmp_path / "fleet" / name).mkdir(parents=True)
        write_dive_table(fixes_of(15), tmp_path / "fleet" / name / "dives.csv")
    ran(*CLPT, "watch", "fleet", "--fleet", "--out", "out", cwd=tmp_path)
    found = asked(tmp_path / "out" / "fleet.html", WORDS, tmp_path, 390)
    assert found["words"] > 10
    assert (found["broken"], found["beyond"]) == ([], 0)


LATER = """
const now = Date.now, later = HOURS * 3600000;
Date.now = () => now() + later;
function found() {
  const text = (name) => document.querySelector(name)?.textContent ?? "";
  const card = document.querySelector("section[data-overdue]");
  const row = document.querySelector("tr[data-end]");
  return { since: text("[data-since]"), alarm: card?.classList.contains("alarm"),
    title: text("section[data-overdue] h2"), below: text("section[data-overdue] small"),
    last: text("section[data-end] b"), age: row?.cells[1].textContent,
    pilot: row?.cells[3].textContent, loud: row?.cells[3].className };
}
"""


@pytest.fixture(scope="module")
def watched(tmp_path_factory):
    """The pages of a vehicle that surfaced an hour ago, and of its fleet."""
    folder = tmp_path_factory.mktemp("watched")
    dives = fixes_of(15)
    late = time.time() - 3600 - dives[-1].t_gpse
    dives = [
        replace(dive, t_gps2=dive.t_gps2 + late, t_gpse=dive.t_gpse + late)
        for dive in dives
    ]
    (folder / "fleet" / "north").mkdir(parents=True)
    write_dive_table(dives, folder / "fleet" / "north" / "dives.csv")
    ran(*CLPT, "watch", "fleet", "--fleet", "--out", "out", cwd=folder)
    return folder / "out"


@pytest.mark.parametrize(
    ("hours", "title", "last"),
    [
        (0, "Next surfacing", "1.0 h ago"),
        (10, "Overdue: next surfacing", "11.0 h ago"),
        (31 * 24, "Next surfacing", "31 d ago"),
    ],
)
def test_a_page_that_is_read_later_counts_on(watched, tmp_path, hours, title, last):
    probe = LATER.replace("HOURS", str(hours))
    page = watched / "north" / "replay.html"
    found = asked(page, probe, tmp_path, 390)
    overdue = hours == 10
    assert (found["title"], found["alarm"]) == (title, overdue)
    assert found["last"] == last
    assert found["since"] == ("31 d ago" if hours > 48 else f"{hours:.1f} h ago")
    assert found["below"].startswith(
        "expected" if overdue else "in" if hours == 0 else "3"
    )
    fleet = asked(watched / "fleet.html", probe, tmp_path, 390)
    assert fleet["age"] == last.removesuffix(" ago")
    said = "overdue after dive 15: should have surfaced at"
    assert fleet["pilot"].startswith(said) == overdue
    assert fleet["loud"] == ("alarm" if overdue else "")


CUT = """
function found() {
  const map = document.getElementById("map"), edge = map.getBoundingClientRect();
  const names = [...map.querySelectorAll("text")].filter((one) => /[NSEW]$/.test(one.textContent));
  const cut = names.filter((one) => {
    const box = one.getBoundingClientRect();
    return box.left < edge.left || box.right > edge.right || box.bottom > edge.bottom;
  });
  const broken = [...document.querySelectorAll(".whole")].filter(
    (one) => one.getClientRects().length > 1 || one.getBoundingClientRect().right > innerWidth);
  return { names: names.length, cut: cut.map((one) => one.textContent),
    broken: broken.map((one) => one.textContent) };
}
"""


@pytest.mark.parametrize("width", [390, 1280])
@pytest.mark.parametrize(("lat", "lon"), [(40.0, 8.0), (-42.1, -128.3)])
def test_no_degree_is_cut(tmp_path, lat, lon, width):
    write_dive_table(fixes_of(3, lat, lon), tmp_path / "dives.csv")
    ran(*CLPT, "replay", "dives.csv", "--out", "out", cwd=tmp_path)
    found = asked(tmp_path / "out" / "replay.html", CUT, tmp_path, width)
    assert found["names"] > 4
    assert (found["cut"], found["broken"]) == ([], [])


@pytest.mark.parametrize("width", [390, 1280])
def test_the_page_fits_its_screen(page, tmp_path, width):
    found = asked(page, REPLAY, tmp_path, width)
    assert (found["beyond"], found["buttons"]) == ([0], 3)  # of the table of dives
    assert found["k"] > 0
    assert found["named"] > 3
    # marks and numbers keep their size
    assert (found["zoom"], found["smaller"]) == (pytest.approx(2), pytest.approx(2))
    assert found["said"].startswith("dive 60: surfaced ")


def test_the_page_reads_without_a_script(page, tmp_path):
    text = re.sub(r"<script>.*?</script>", "", page.read_text("utf-8"), flags=re.S)
    (tmp_path / "still.html").write_text(text, "utf-8")
    tree, console = shown(tmp_path / "still.html", tmp_path / "profile")
    assert (console, tree.count('href="#map-dive')) == ([], 60)
    assert len(re.findall(r">\d+°(\d+')?[NESW]<", tree)) > 5
    assert "Next surfacing" in tree


# --- pages to send --------------------------------------------------------------------------------

DARK = "--blink-settings=preferredColorScheme=0"
READ = """
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
function found() {
  const texts = [...document.body.querySelectorAll("*")].filter((one) => one.tagName !== "SCRIPT"
    && [...one.childNodes].some((node) => node.nodeType === 3 && node.data.trim()));
  return { texts: texts.length, dark: matchMedia("(prefers-color-scheme: dark)").matches,
    sections: [...document.querySelectorAll("section h2")].map((one) => one.id),
    faint: texts.filter((one) => contrast(one) < 4.5).map((one) => one.outerHTML.slice(0, 90)),
    flat: [...document.querySelectorAll("figure svg")].filter(
      (one) => one.getBoundingClientRect().height < 100).length };
}
"""
SECTIONS = {
    "run": [
        "achieved",
        "loop",
        "track",
        "clpe",
        "learning",
        "excitation",
        "scenario",
        "versions",
    ],
    "team": ["achieved", "loop", "track", "excitation", "scenario", "versions"],
    "ensemble": ["spread", "varied", "scenario", "versions"],
}


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    """Pages of a run, a team's run and an ensemble."""
    folder = tmp_path_factory.mktemp("pages")

    run = clpt.paper_scenario().with_values({"run.duration": 400})
    team = clpt.Team(members={"a": run, "b": run}, coupling=0.5)
    many = clpt.run_ensemble(run, "learning.gain=0.2:2.0", 8)
    made = {"run": clpt.simulate(run), "team": clpt.simulate(team), "ensemble": many}
    for name, one in made.items():
        clpt.report(one, folder / f"{name}.html")
    return folder


@pytest.mark.parametrize("name", SECTIONS)
def test_the_page_is_quiet(pages, tmp_path, name):
    tree, console = shown(pages / f"{name}.html", tmp_path / "profile")
    assert (console, "</footer>" in tree) == ([], True)


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("width", [390, 1280])
@pytest.mark.parametrize("name", SECTIONS)
def test_the_page_is_read_on_its_screen(pages, tmp_path, name, width, theme):
    words = [DARK] if theme == "dark" else []
    found = asked(pages / f"{name}.html", READ, tmp_path, width, *words)
    wanted = {
        "dark": theme == "dark",
        "faint": [],
        "flat": 0,
        "sections": SECTIONS[name],
    }
    assert {key: found[key] for key in wanted} == wanted
    assert found["texts"] > 60


ZOOM = """
function found() {
  const svg = document.querySelector("figure svg"), full = svg.viewBox.baseVal.width;
  const box = svg.getBoundingClientRect(), reset = document.querySelector("button.reset");
  const at = { clientX: box.x + box.width / 2, clientY: box.y + box.height / 2, bubbles: true };
  const widths = [], note = () => widths.push(full / svg.viewBox.baseVal.width, reset.hidden);
  note();
  svg.dispatchEvent(new MouseEvent("dblclick", at));
  note();
  svg.dispatchEvent(new KeyboardEvent("keydown", { key: "+" }));
  note();
  const x = svg.viewBox.baseVal.x;
  svg.dispatchEvent(new PointerEvent("pointerdown", at));
  svg.dispatchEvent(new PointerEvent("pointermove", { ...at, clientX: at.clientX - 10 }));
  svg.dispatchEvent(new PointerEvent("pointerup", at));
  const moved = svg.viewBox.baseVal.x - x;
  reset.click();
  note();
  return { widths, moved: moved > 0, buttons: document.querySelectorAll("button.reset").length,
    figures: document.querySelectorAll("figure svg").length };
}
"""


def test_figures_of_a_report_are_zoomed_and_dragged(pages, tmp_path):
    found = asked(pages / "run.html", ZOOM, tmp_path, 1280)
    assert found["widths"] == pytest.approx([1, True, 2, False, 4, False, 1, True])
    assert found["moved"]
    assert found["buttons"] == found["figures"] > 5


def test_the_page_prints(pages, tmp_path):
    """As pages of paper, with the scenario unfolded."""
    made = tmp_path / "run.pdf"
    profile = f"--user-data-dir={tmp_path / 'profile'}"
    ran(
        CHROMIUM,
        *QUIET,
        profile,
        f"--print-to-pdf={made}",
        (pages / "run.html").as_uri(),
    )
    assert (content := made.read_bytes()).startswith(b"%PDF-")
    assert 2 <= len(re.findall(rb"/Type\s*/Page\b", content)) <= 8


# --- what a notebook shows takes the colours of its page -----------------------------------------

COLOURS = """
function found() {
  const of = (name, key) => [...new Set([...document.querySelectorAll(name)].map((one) =>
    getComputedStyle(one)[key]))];
  return { text: of(".clpt td, .clpt strong, .clpt pre", "color"),
    lines: of(".clpt svg path", "stroke"), letters: of(".clpt svg text", "fill"),
    behind: of(".clpt, .clpt table, .clpt td, .clpt svg", "backgroundColor") };
}
"""


INKS = {"white": "rgb(1, 2, 3)", "#111": "rgb(230, 231, 232)"}


@pytest.mark.parametrize("paper", INKS)
def test_they_take_the_colours_of_the_page(paper, tmp_path):
    scenario = clpt.paper_scenario().with_values({"run.duration": 40})
    loop = clpt.closed_loop(scenario)
    body = "".join(thing._repr_html_() for thing in (scenario, loop, clpt.draw(loop)))
    ink, head = INKS[paper], '<!DOCTYPE html><head><meta charset="utf-8">'
    head += f'<body style="color:{INKS[paper]};background:{paper}">'
    (tmp_path / "page.html").write_text(head + body, "utf-8")
    found = asked(tmp_path / "page.html", COLOURS, tmp_path, 600)
    assert found["text"] == found["letters"] == [ink]
    assert ink in found["lines"]
    assert found["behind"] == ["rgba(0, 0, 0, 0)"]


# --- the site ------------------------------------------------------------------------------------

SITE = ROOT / "build" / "docs"
SEARCH = "search.html?q=waypoint"
VISIT = """
<!DOCTYPE html><meta charset="utf-8"><body><script>
const found = {}, pages = PAGES;
localStorage.setItem("mode", "THEME");
localStorage.setItem("theme", "THEME");
function look(frame) {
  const page = frame.contentDocument.documentElement;
  return {
    theme: page.dataset.theme, wide: page.scrollWidth, inner: frame.contentWindow.innerWidth,
    broken: [...page.querySelectorAll("img")].filter((one) => !one.naturalWidth)
      .map((one) => one.src),
    foreign: frame.contentWindow.performance.getEntriesByType("resource")
      .map((one) => one.name).filter((name) => !name.startsWith(location.origin)),
    scrolls: [...page.querySelectorAll(".pst-scrollable-table-container")]
      .filter((one) => one.scrollWidth > one.clientWidth).map((one) => one.textContent),
    hits: page.querySelectorAll("#search-results li").length,
  };
}
function visit() {
  const name = pages.shift();
  if (!name) { document.body.textContent = JSON.stringify(found); return; }
  const frame = document.createElement("iframe");
  frame.style = "border:0;width:WIDTHpx;height:900px";
  frame.onload = () => setTimeout(() => {
    found[name] = look(frame); frame.remove(); visit();
  }, name === "SEARCH" ? 3000 : 50);
  frame.src = name;
  document.body.append(frame);
}
visit();
</script>
"""
BUILT = pytest.mark.skipif(
    not (SITE / "searchindex.js").is_file(),
    reason="no site in build/docs: `make docs` builds it",
)


class Quiet(SimpleHTTPRequestHandler):
    """Files of the site and the visiting page; what was requested and missing is kept."""

    def __init__(self, *arguments, missing, visits, **words):
        self.missing, self.visits = missing, visits
        super().__init__(*arguments, **words)

    def do_GET(self):
        if (text := self.visits.get(self.path)) is None:
            super().do_GET()
            return
        self.send_response(200)
        self.send_header("Content-Type", "text/html; charset=utf-8")
        self.end_headers()
        self.wfile.write(text.encode())

    def log_error(self, *arguments):
        self.missing.append(self.path)

    def log_message(self, *arguments):
        """Say nothing."""


@pytest.fixture
def served():
    """The site under an address of this machine, and what was asked for in vain."""
    missing, visits = [], {}
    handler = partial(Quiet, missing=missing, visits=visits, directory=SITE)
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}", missing, visits
        server.shutdown()


def names():
    found = (str(path.relative_to(SITE)) for path in SITE.rglob("*.html"))
    return sorted(name for name in found if not name.startswith("_"))


@BUILT
@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("width", [390, 1280])
def test_every_page_fits_its_screen(served, tmp_path, width, theme):
    address, missing, visits = served
    pages = json.dumps([*names(), SEARCH])
    text = VISIT.replace("PAGES", pages).replace("SEARCH", SEARCH)
    visits["/visit.html"] = text.replace("WIDTH", str(width)).replace("THEME", theme)
    words = "--window-size=1400,900", "--virtual-time-budget=600000"
    profile = f"--user-data-dir={tmp_path / 'profile'}", "--enable-logging=stderr"
    done = ran(
        CHROMIUM, *QUIET, *profile, *words, "--dump-dom", f"{address}/visit.html"
    )
    found = json.loads(re.search(r"<body>(.*?)</body>", done.stdout, re.S)[1])
    assert list(found) == json.loads(pages)
    for name, one in found.items():
        assert (one["theme"], one["scrolls"], one["broken"], one["foreign"]) == (
            theme,
            [],
            [],
            [],
        )
        # less its scroll bar
        assert one["wide"] <= one["inner"] in (width, width - 15), name
    assert found[SEARCH]["hits"] > 2
    said = re.findall(r"CONSOLE.*", done.stderr)
    assert [line for line in said if "[PST]: " not in line] == []  # words of the theme
    assert [path for path in missing if "favicon" not in path] == []


@BUILT
def test_no_page_is_heavy():
    assert [name for name in names() if (SITE / name).stat().st_size >= 3_000_000] == []
