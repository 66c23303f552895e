"""What a notebook shows, in headless Chromium on a light and a dark page: it takes its colours.

Run by `make test-browser`; skipped, with the reason, where no Chromium is installed.
"""

import json
import re

import pytest
from test_page_in_chromium import IN_CHROMIUM, shown

import clpt_control as clpt

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
pytestmark = IN_CHROMIUM


@pytest.mark.parametrize(
    ("ink", "paper"), [("rgb(1, 2, 3)", "white"), ("rgb(230, 231, 232)", "#111")]
)
def test_they_take_the_colours_of_the_page(ink, paper, tmp_path):
    scenario = clpt.paper_scenario().with_values({"run.duration": 40})
    loop = clpt.closed_loop(scenario)
    things = scenario, loop, clpt.draw(loop)
    body = "".join(thing._repr_html_() for thing in things)
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
