"""The pages of scenario keys and blocks, and the example of `clpt init`, against declarations."""

import re
import runpy

from paths import ROOT

import clpt_control as clpt
from clpt_control.engine.methods.table import BY_NAME, METHODS
from clpt_control.paper.scenario.file import paper_text

PRINTED = runpy.run_path(str(ROOT / "tools" / "print_scenario_page.py"))
PAGE = (ROOT / "docs" / "scenario.md").read_text("utf-8")


def test_the_pages_are_current():
    assert PRINTED["page"]() == PAGE
    assert PRINTED["example"]() == PRINTED["EXAMPLE"].read_text("utf-8")
    assert PRINTED["block_rows"]() in PRINTED["BLOCKS"].read_text("utf-8")


def test_the_example_has_a_sentence_for_each_key():
    """Laws' own tables are listed by `clpt laws`; flow.basis has the keys of basis."""
    sentences = PRINTED["sentences"]()
    assert [key for key, sentence in sentences.items() if not sentence] == []
    fields = dict(PRINTED["fields_of"](PRINTED["Scenario"]))
    tables = {key.rpartition(".")[0] for key in fields}
    own = re.compile(r"learning\.\w+\.|flow\.basis\.")
    keys = {key for key in fields.keys() - tables if not own.match(key)}
    assert keys <= sentences.keys() <= fields.keys()


def test_no_braces_of_a_template_are_left():
    braces = re.compile(r"\{\w*\}")
    assert braces.findall(paper_text()) == []
    assert braces.findall(PRINTED["rows"]()) == []


def test_methods_are_named_with_their_order():
    sentence = PRINTED["sentences"]()["run.method"]
    for name, row in BY_NAME.items():
        kind = "implicit" if row.implicit else "explicit"
        assert re.search(rf"\b{name} \({kind}.*?, order {row.order}\)", sentence)
    assert METHODS.keys() - BY_NAME.keys() <= {*re.findall(r"\w+", sentence)}
    assert "``run.method`` in the file of `clpt init`" in clpt.simulate.__doc__
