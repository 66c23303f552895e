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
    law, out = LAWS[name], clpt("laws", name).out
    [(listed, told)] = printed("laws", name)["laws"].items()
    assert (listed, told["page"], [*told["settings"]]) == (name, law.page, [*law.settings])
    assert told["promises"] == list(promises_in_words(law).values())
    for line in (law.page.splitlines()[0], *told["promises"]):
        assert line in out


def test_the_command_lists_all_and_refuses_others(clpt, printed, refused):
    assert list(printed("laws")["laws"]) == list(LAWS)
    assert all(name in clpt("laws").out for name in LAWS)
    assert refused("laws", "no-law") == "clpt: no-law: is no law; `clpt laws` lists them\n"
