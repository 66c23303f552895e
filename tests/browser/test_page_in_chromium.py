"""The page of a replay in headless Chromium: whole, quiet, and no wider than a telephone.

Run by `make test-browser`; skipped, with the reason, where no Chromium is installed.
"""

import json
import re
import shutil

import pytest
from processes import CLPT, ran
from synthetic_vehicle import fixes_of

from clpt_control.gliders.dive_table import write_dive_table

NAMES = ("chromium", "chromium-browser", "google-chrome")
CHROMIUM = next(filter(None, map(shutil.which, NAMES)), "")
QUIET = [
    *("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run"),
    *("--disable-sync", "--disable-background-networking", "--disable-component-update"),
    "--enable-logging=stderr",
]
PROBE = """
<script>
function used() {
  const before = map.viewBox.baseVal.width, k = +getComputedStyle(map).getPropertyValue("--k");
  document.querySelector(".buttons button").click();
  document.querySelector("tr[id]").click();
  return { zoom: before / map.viewBox.baseVal.width,
    smaller: k / +getComputedStyle(map).getPropertyValue("--k"),
    named: document.querySelectorAll("#map .degrees").length,
    said: document.getElementById("said").textContent };
}
addEventListener("load", () => parent.postMessage(JSON.stringify({
  inner: innerWidth, wide: document.documentElement.scrollWidth,
  beyond: [...document.querySelectorAll(".table")].map((one) => one.scrollWidth - one.clientWidth),
  buttons: document.querySelectorAll(".buttons button").length,
  fetched: performance.getEntriesByType("resource").map((one) => one.name),
  k: getComputedStyle(map).getPropertyValue("--k"), ...used(),
}), "*"));
</script>
"""
WORDS = """
<script>
addEventListener("load", () => {
  const broken = [];
  for (const cell of document.querySelectorAll("td:not(:first-child)")) {
    const text = cell.firstChild?.nodeValue ?? "";
    for (const { 0: word, index } of text.matchAll(/\\S+/g)) {
      const range = document.createRange();
      range.setStart(cell.firstChild, index);
      range.setEnd(cell.firstChild, index + word.length);
      if (range.getClientRects().length > 1) broken.push(word);
    }
  }
  const table = document.querySelector(".table"), words = document.querySelectorAll("td").length;
  parent.postMessage(JSON.stringify({ words, broken, wide: document.documentElement.scrollWidth,
    beyond: table.scrollWidth - table.clientWidth }), "*");
});
</script>
"""
FRAME = """
<!DOCTYPE html><body><iframe src="{page}" style="border:0;width:{width}px;height:900px"></iframe>
<script>addEventListener("message", (event) => {{ document.body.textContent = event.data; }});
</script>
"""
pytestmark = IN_CHROMIUM = [
    pytest.mark.browser,
    pytest.mark.skipif(not CHROMIUM, reason="no Chromium is installed: chromium is not on PATH"),
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
    words = f"--user-data-dir={profile}", *words, "--dump-dom", path.as_uri()
    done = ran(CHROMIUM, *QUIET, *words)
    return done.stdout, re.findall(r"CONSOLE.*", done.stderr)


def test_the_page_obeys_its_own_policy(page, tmp_path):
    """Its script runs under the policy, and nothing is refused, missed or complained of."""
    tree, console = shown(page, tmp_path / "profile")
    assert console == []
    assert tree.count("<button") == 3
    assert re.search(r'<svg id="map"[^>]*style="[^"]*--k', tree)


def asked(page, probe, tmp_path, width, *words):
    """What a probe finds in a page on a screen so wide."""
    text = re.sub(r"<meta http-equiv[^>]*>", "", page.read_text("utf-8"))
    probed = tmp_path / "probed.html"
    probed.write_text(text.replace("<head>", "<head>" + probe, 1), "utf-8")
    frame = tmp_path / "frame.html"
    frame.write_text(FRAME.format(page=probed.as_uri(), width=width), "utf-8")
    words = (f"--window-size={max(width, 500)},900", "--virtual-time-budget=5000", *words)
    tree, _ = shown(frame, tmp_path / "profile", *words)
    return json.loads(re.search(r"<body>(.*?)</body>", tree, re.S)[1])


def test_the_words_of_a_fleet_are_whole_on_a_telephone(tmp_path):
    for name in ("north", "a_long_name_of_a_vehicle_2026"):
        (tmp_path / "fleet" / name).mkdir(parents=True)
        write_dive_table(fixes_of(15), tmp_path / "fleet" / name / "dives.csv")
    ran(*CLPT, "replay", "--fleet", "fleet", "--out", "out", cwd=tmp_path)
    found = asked(tmp_path / "out" / "fleet.html", WORDS, tmp_path, 390)
    assert found["words"] > 10
    assert found["broken"] == []
    assert found["wide"] <= 390
    assert found["beyond"] == 0


@pytest.mark.parametrize("width", [390, 1280])
def test_the_page_fits_its_screen(page, tmp_path, width):
    found = asked(page, PROBE, tmp_path, width)
    assert found["inner"] == width
    assert found["wide"] <= width
    assert found["beyond"] == [0]  # the table of dives
    assert (found["fetched"], found["buttons"]) == ([], 3)
    assert float(found["k"]) > 0
    assert found["zoom"] == pytest.approx(2)
    assert found["smaller"] == pytest.approx(2)  # marks and numbers keep their size
    assert found["named"] > 3
    assert found["said"].startswith("dive 60: surfaced ")


def test_the_page_reads_without_a_script(page, tmp_path):
    text = re.sub(r"<script>.*?</script>", "", page.read_text("utf-8"), flags=re.S)
    still = tmp_path / "still.html"
    still.write_text(text, "utf-8")
    tree, console = shown(still, tmp_path / "profile")
    assert console == []
    assert tree.count('href="#map-dive') == 60
    assert len(re.findall(r">\d+°(\d+')?[NESW]<", tree)) > 5
    assert "Next surfacing" in tree
