"""Every page of the built site in headless Chromium: whole, quiet, as wide as its screen.

Run by `make test-browser` after `make docs`; skipped, with the reason, where the site is not built
or no Chromium is installed.  A page of ours opens them one after the other in a frame.
"""

import json
import re
import threading
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest
from processes import ran
from test_page_in_chromium import CHROMIUM, IN_CHROMIUM, QUIET

SITE = Path(__file__).parents[2] / "build" / "docs"
LARGEST = 3_000_000  # bytes of a page
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
pytestmark = [
    *IN_CHROMIUM,
    pytest.mark.skipif(not SITE.is_dir(), reason="no site in build/docs: `make docs` builds it"),
]


class Quiet(SimpleHTTPRequestHandler):
    """Files of the site and the visiting page; what is asked for and missing is kept."""

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

    def send_error(self, code, *arguments, **words):
        self.missing.append(self.path)
        super().send_error(code, *arguments, **words)

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


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("width", [390, 1280])
def test_every_page_fits_its_screen(served, tmp_path, width, theme):
    address, missing, visits = served
    pages = json.dumps([*names(), SEARCH])
    text = VISIT.replace("PAGES", pages).replace("SEARCH", SEARCH)
    visits["/visit.html"] = text.replace("WIDTH", str(width)).replace("THEME", theme)
    words = "--window-size=1400,900", "--virtual-time-budget=600000"
    profile = f"--user-data-dir={tmp_path / 'profile'}", "--enable-logging=stderr"
    done = ran(CHROMIUM, *QUIET, *profile, *words, "--dump-dom", f"{address}/visit.html")
    found = json.loads(re.search(r"<body>(.*?)</body>", done.stdout, re.S)[1])
    assert list(found) == json.loads(pages)
    assert {name: one["wide"] for name, one in found.items() if one["wide"] > one["inner"]} == {}
    assert {name: one["scrolls"] for name, one in found.items() if one["scrolls"]} == {}
    assert {one["inner"] for one in found.values()} <= {width, width - 15}  # less its scroll bar
    assert {one["theme"] for one in found.values()} == {theme}
    assert {name for one in found.values() for name in one["broken"] + one["foreign"]} == set()
    assert found[SEARCH]["hits"] > 2
    said = re.findall(r"CONSOLE.*", done.stderr)
    assert [line for line in said if "[PST]: " not in line] == []  # words of the theme
    assert [path for path in missing if "favicon" not in path] == []


def test_no_page_is_heavy():
    sizes = {name: (SITE / name).stat().st_size for name in names()}
    assert {name: size for name, size in sizes.items() if size >= LARGEST} == {}
