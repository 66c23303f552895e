"""docs/each_law.md has a section for each law, as its page and its row have it."""

import re
import runpy
from pathlib import Path

import pytest

from clpt_control.blocks.laws.table import LAWS
from clpt_control.theory.promises import promises_in_words

ROOT = Path(__file__).parents[1]
TOOL = ROOT / "tools" / "print_laws.py"
PAGE = ROOT / "docs" / "each_law.md"

pytestmark = pytest.mark.skipif(not TOOL.exists(), reason="installed without tools")


def test_the_sections_are_those_of_the_laws():
    tool = runpy.run_path(str(TOOL))
    text = PAGE.read_text("utf-8")
    assert tool["whole_page"]() == text, "run python tools/print_laws.py"
    for law in LAWS.values():
        assert re.search(rf"^## .*`{law.name}`", text, re.M)


@pytest.mark.parametrize("name", LAWS)
def test_the_command_prints_a_laws_page(clpt, printed, name):
    outcome = clpt("laws", name)
    assert outcome.status == 0
    listed = printed("laws", name)["laws"]
    assert (list(listed), listed[name]["page"]) == ([name], LAWS[name].page)
    assert list(listed[name]["settings"]) == list(LAWS[name].settings)
    assert listed[name]["promises"] == list(promises_in_words(LAWS[name]).values())
    for line in (LAWS[name].page.splitlines()[0], *listed[name]["promises"]):
        assert line in outcome.out


def test_the_command_lists_all(clpt, printed):
    assert list(printed("laws")["laws"]) == list(LAWS)
    assert all(name in clpt("laws").out for name in LAWS)


def test_an_unknown_law_is_refused(clpt):
    outcome = clpt("laws", "no-law")
    assert (outcome.status, outcome.out) == (2, "")
    assert outcome.err == "clpt: no-law: is no law; `clpt laws` lists them\n"
