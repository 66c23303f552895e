"""The pages of scenario keys and blocks, and the example of `clpt init`, against declarations."""

import re
import runpy
import tomllib

from paths import ROOT

import clpt_control as clpt
from clpt_control.engine.methods import BY_NAME, METHODS
from clpt_control.paper.blocks.ports import POWERS
from clpt_control.paper.laws.law import Fixes, Gains, LawContext
from clpt_control.paper.scenario.file import paper_text

PRINTED = runpy.run_path(str(ROOT / "tools" / "print_scenario_page.py"))
QUANTITIES = PRINTED["Scenario"].quantities()
OTHER_DIAGRAMS = {"lyapunov", "parameter_system", "error_system"}  # not of a scenario
UNITS = {"length/time": (1, 1), "1/time": (0, 1), "length": (1, 0), "time": "time"}
PAGE = (ROOT / "docs" / "scenario.md").read_text("utf-8")


def test_the_pages_are_current():
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


def test_a_key_names_parameters_and_states_of_blocks():
    """A name that no block has would be a key without effect."""
    parameters, states = set(), set()
    for name, made in PRINTED["blocks_of_loops"]().items():
        for _, block in made:
            parameters |= {f"{name}.{field}" for field in block.parameters._fields}
            states |= {*block.state_ports}
    for key, quantity in QUANTITIES.items():
        names = {*quantity.parameters.split()}
        of_loops = {n for n in names if n.partition(".")[0] not in OTHER_DIAGRAMS}
        assert of_loops <= parameters, key
        assert quantity.state in states | {""}, key


def test_a_parameter_has_the_value_of_one_key():
    """But of an own gain, which stands in place of the common one, and of a basis."""
    keys = {}
    for key, quantity in QUANTITIES.items():
        for name in quantity.parameters.split():
            keys.setdefault(name, []).append(key)
    several = [tuple(names) for names in keys.values() if len(names) > 1]
    assert {*several} <= {
        ("basis.centers", "flow.basis.centers"),
        ("basis.widths", "flow.basis.widths"),
        ("basis.phases", "flow.basis.phases"),
        ("learning.gain", "learning.gains.parameters"),
        ("learning.gain", "learning.gains.feedback"),
        ("learning.gain", "learning.gains.feedforward"),
    }


def test_a_key_has_the_symbol_of_the_glossary():
    """`flow.parameters`, theta there, is in a row that begins with it."""
    rows = (ROOT / "docs" / "glossary.md").read_text("utf-8").splitlines()
    plain = re.compile(r"\\hat(\\\w+)|[\\_]")
    symbols = {}
    for row in rows:
        _, symbol, *cells = re.split(r"(?<!\\)\|", row) if "|" in row else ("", "")
        keys = re.findall(r"`(\w+\.\w+)`(?:, `(\w+)`)?", "|".join(cells[2:3]))
        names = re.findall(r"\$(.*?)\$", symbol)
        for key, second in keys:
            both = [key, f"{key.partition('.')[0]}.{second}"]
            symbols |= dict(zip(both, names, strict=False))
    declared = {key: q.symbol for key, q in QUANTITIES.items() if q.symbol}
    assert len(declared) > 5
    for key, symbol in declared.items():
        letters = plain.sub(lambda m: (m[1] or "") and f"{m[1]}hat", symbols[key])
        assert plain.sub("", letters) == symbol.replace("_", ""), key


def test_a_key_has_the_default_of_its_comment():
    """A line of the example that is no comment has the default, if there is one."""
    fields = dict(PRINTED["fields_of"](PRINTED["Scenario"]))
    compared = set()
    for key, line in PRINTED["rows_of"](PRINTED["Scenario"]):
        default = None if key not in fields else fields[key].get_default()
        if line.startswith(("#", "[")) or fields[key].is_required() or not default:
            continue
        (value,) = tomllib.loads(line).values()
        value = tuple(value) if isinstance(value, list) else value
        assert value == default, key
        compared.add(key)
    assert {"run.rtol", "run.atol", "run.output_step", "units.time"} <= compared


LEFT_OUT = {  # key -> the value that its sentence gives in place of it, other keys
    "model.parameters": (((0.0,) * 3,) * 2, {}),
    "learning.parameters": (((0.0,) * 3,) * 2, {}),
    "learning.hedging": (True, {"vehicle.max_speed": 0.8}),
}


def test_a_key_that_is_left_out_has_the_value_of_its_sentence():
    said = {
        key: found[1] or found[2]
        for key, sentence in PRINTED["sentences"]().items()
        if (
            found := re.search(
                r"left out: (true|false|[\d.]+)|(\S+) where left", sentence
            )
        )
    }
    assert said == {**dict.fromkeys(LEFT_OUT, "0"), "learning.hedging": "true"}
    for key, (value, others) in LEFT_OUT.items():
        short = clpt.paper_scenario().with_values({"run.duration": 30, **others})
        runs = [clpt.simulate(short.with_values({key: one})) for one in (None, value)]
        assert runs[0].predicted_position.equals(runs[1].predicted_position), key


def test_a_key_names_what_laws_read():
    read = {*LawContext.__annotations__}
    for name, kind in (("gains", Gains), ("fixes", Fixes)):
        read |= {f"{name}.{field}" for field in kind.__annotations__}
    for key, quantity in QUANTITIES.items():
        assert {*quantity.context.split()} <= read, key


def test_a_key_has_the_unit_of_its_sentence():
    for key, sentence in PRINTED["sentences"]().items():
        if key not in QUANTITIES or key.endswith("_lat_lon"):
            continue
        found = re.search(r"length/time|1/time|\blength\b|\btime\b", sentence)
        port = QUANTITIES[key].unit or QUANTITIES[key].state
        unit = port if port == "time" else POWERS.get(port)
        assert unit == (found and UNITS[found[0]]), key
