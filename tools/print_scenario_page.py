"""Pages of the keys of a scenario and of the blocks of its loop, from their declarations.

- data/paper.toml, which `clpt init` writes, and docs/scenario.md: from the fields of the tables in
  `paper/scenario`.  The comment `#:` above a field is its line in data/paper.toml, or the header of
  its table: name, value of the paper or, commented out, of an example, and a sentence.
- The table of docs/blocks.md: from the blocks of all laws and of each example.  The equation is the
  docstring of a block's function.

`tests/test_scenario_page.py` checks that all are current; print them anew by

    python tools/print_scenario_page.py
"""

import inspect
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import clpt_control as clpt
from clpt_control.engine.diagram.wiring import output_ports
from clpt_control.engine.methods import BY_NAME
from clpt_control.paper.blocks.disturbance import KINDS
from clpt_control.paper.blocks.flow import KERNELS
from clpt_control.paper.blocks.ports import SHAPES
from clpt_control.paper.scenario.experiment import Scenario
from clpt_control.paper.scenario.tables import Table, tables_in
from clpt_control.paper.scenario.tidal_periods import SPEEDS

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs" / "scenario.md"
BLOCKS = ROOT / "docs" / "blocks.md"
EXAMPLE = ROOT / "clpt_control" / "data" / "paper.toml"
TITLE = """\
# The experiment of Cho, Zhang and Edwards (2016), section IV.
# Run it: clpt run THIS_FILE --out run.nc
"""
COLUMN = 46  # of the sentences in data/paper.toml
LINKS = {  # words of sentences: pages
    "`clpt laws`": "laws.md",
    "of known-flow": "laws.md#source-of-a-given-flow",
    "sampled law": "laws.md#sampled-laws",
    "hedging": "theory.md#limited-speed",
}


def lines_of(table: type[Table]) -> dict[str, str]:
    """Return the comments `#:` above the fields that a table's class declares, by name."""
    found, line = {}, ""
    for text in inspect.getsource(table).splitlines():
        if comment := re.match(r" +#: (.*)", text):
            line = f"{line} {comment[1]}".strip()
        elif field := re.match(r" +(\w+): ", text):
            found[field[1]] = line
            line = ""
    return {name: line for name, line in found.items() if line}


def fields_of(table: type[Table], before: str = "") -> Iterator[tuple[str, Any]]:
    """Yield each key of a scenario, dotted, and its field."""
    for name, field in table.model_fields.items():
        yield f"{before}{name}", field
        for inner in tables_in(field.annotation):
            yield from fields_of(inner, f"{before}{name}.")


NAMES = {  # key: names from tables, after its sentence
    "basis.kernel": "; ".join(
        f"{name}: {row.formula}" for name, row in KERNELS.items()
    ),
    "basis.constituents": " ".join(SPEEDS),
    "flow.disturbance.kind": ", ".join(KINDS),
    "run.method": ", ".join(f"{name} ({row.text})" for name, row in BY_NAME.items()),
}


def rows_of(table: type[Table], before: str = "") -> Iterator[tuple[str, str]]:
    """Yield each key and table of the file, dotted, and its line; keys before inner tables."""
    lines = lines_of(table)
    for name in sorted(lines, key=lambda name: lines[name].lstrip("# ")[0] == "["):
        key = f"{before}{name}"
        yield key, ": ".join(filter(None, [lines[name], NAMES.get(key)]))
        if lines[name].lstrip("# ").startswith(f"[{key}]"):
            for inner in tables_in(table.model_fields[name].annotation):
                yield from rows_of(inner, f"{key}.")
        elif not lines[name].removeprefix("# ").startswith(f"{name} = "):
            raise ValueError(f"{key}: the comment above it is '{lines[name]}'")


def example() -> str:
    """Return the file that `clpt init` writes."""
    text = TITLE
    for _, line in rows_of(Scenario):
        commented = "# " if line.startswith("# ") else ""
        left, _, sentence = line.removeprefix("# ").partition(" # ")
        left = commented + left
        text += "\n" * left.removeprefix("# ").startswith("[")
        gap = " " * max(COLUMN - len(left), 2) + "# "
        text += left + (gap + sentence) * bool(sentence) + "\n"
    return text


def default_of(field: Any) -> str:
    """Return a field's default as a cell, "" if it is None."""
    if field.is_required():
        return "required"
    value = field.default
    if value is None or value == "":
        return ""
    if value == (0.0, 0.0):
        return "0"
    text = f"{value:g}" if isinstance(value, float) else str(value).lower()
    return text.replace("e-0", "e-")


def linked(sentence: str) -> str:
    """Return a sentence with links to pages."""
    sentence = sentence.replace("^2", "²").replace("|", "\\|")
    for words, address in LINKS.items():
        sentence = sentence.replace(words, f"[{words}]({address})")
    return sentence


def sentences() -> dict[str, str]:
    """Return the sentence of each key and of each table that may be left out."""
    found = {}
    for key, line in rows_of(Scenario):
        if not line.startswith("["):
            found[key] = line.removeprefix("# ").partition(" # ")[2]
    return found


def rows() -> str:
    """Return the table of keys."""
    fields = dict(fields_of(Scenario))
    lines = ["key | meaning | default", "---|---|---"]
    for key, sentence in sentences().items():
        cells = [f"`{key}`", linked(sentence), default_of(fields[key])]
        lines.append(" | ".join(filter(None, cells)))
    return "\n".join(lines) + "\n"


def with_table(path: Path, table: str) -> str:
    """Return a page with the table of the same first line printed anew."""
    head = table[: table.index("\n") + 1]
    before, _, rest = path.read_text("utf-8").partition(head)
    return before + table + rest[rest.index("\n\n") + 1 :]


def page() -> str:
    """Return the page of a scenario with its table of keys printed anew."""
    return with_table(PAGE, rows())


def blocks_of_loops() -> dict[str, list[tuple[Scenario, Any]]]:
    """Return the scenarios and blocks of each name, those of the paper first."""
    sys.path += [str(ROOT / "tests" / "support"), str(ROOT / "tests")]
    from loop_scenarios import scenarios

    found: dict[str, list[tuple[Scenario, Any]]] = {}
    for scenario in (clpt.paper_scenario(), *scenarios()):
        for block in clpt.paper_blocks(scenario):
            found.setdefault(block.name, []).append((scenario, block))
    return found


def condition_of(scenarios: list[Scenario]) -> str:
    """Return the key that the scenarios set and the paper does not, or ""."""
    keys = [{key for key, _, is_set in one.every_key() if is_set} for one in scenarios]
    paper = {key for key, _, is_set in clpt.paper_scenario().every_key() if is_set}
    keys_of_all = sorted(set.intersection(*keys) - paper)
    return f" with `{keys_of_all[0]}`" if keys_of_all else ""


def ports_text(ports: list[str]) -> str:
    """Return the ports with their sizes."""
    sizes = (str(SHAPES[port]).strip("()").replace(", ", "") for port in ports)
    texts = (
        f"`{port}[{size}]`".replace("'", "")
        for port, size in zip(ports, sizes, strict=True)
    )
    return ", ".join(texts)


def block_rows() -> str:
    """Return the table of blocks, one row for each equation; the law is that of the paper."""
    names: dict[str, list[str]] = {}
    blocks_of: dict[str, list[Any]] = {}
    for name, made in blocks_of_loops().items():
        scenarios, blocks = zip(*made, strict=True)
        if name == "adaptation":
            blocks = blocks[:1]
        function = blocks[0].update_function or blocks[0].output_function
        equation = inspect.getdoc(function).partition("\n")[0].rstrip(".")
        names.setdefault(equation, []).append(f"`{name}`{condition_of(scenarios)}")
        blocks_of.setdefault(equation, []).extend(blocks)
    lines = ["block | equation | inputs | outputs | states", "---|---|---|---|---"]
    for equation, blocks in blocks_of.items():
        inputs = [port for block in blocks for port in block.input_ports]
        states = [port for block in blocks for port in block.state_ports]
        outputs = [port for block in blocks for port in output_ports(block)]
        ports = (ports_text([*dict.fromkeys(p)]) for p in (inputs, outputs, states))
        cells = [", ".join(names[equation]), equation.replace("|", "\\|"), *ports]
        lines.append(" | ".join(cells).rstrip(" |"))
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    EXAMPLE.write_text(example(), "utf-8")
    PAGE.write_text(page(), "utf-8")
    BLOCKS.write_text(with_table(BLOCKS, block_rows()), "utf-8")
