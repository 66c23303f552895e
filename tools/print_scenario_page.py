"""Table of the keys of a scenario: docs/scenario.md, from the file that `clpt init` writes.

A key's sentence is the comment of its line in the file; its default is that of its field.
`tests/test_scenario_page.py` checks that the page is current; print it anew by

    python tools/print_scenario_page.py
"""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any, get_args

from clpt_control.paper.scenario.experiment import Scenario
from clpt_control.paper.scenario.file import paper_text
from clpt_control.paper.scenario.tables import Table

PAGE = Path(__file__).parents[1] / "docs" / "scenario.md"
LINE = re.compile(
    r"(?:# )?(?:\[(?P<table>[\w.]+)\]|(?P<key>\w+) = [^#]*?) *(?:# (?P<sentence>.*))?"
)
LINKS = {  # words of sentences: pages
    "`clpt laws`": "laws.md",
    "of known-flow": "laws.md#source-of-a-given-flow",
    "sampled law": "laws.md#sampled-laws",
    "hedging": "theory.md#limited-speed",
}


def tables_in(annotation: Any) -> Iterator[type[Table]]:
    """Yield the tables among the types of a field."""
    if isinstance(annotation, type) and issubclass(annotation, Table):
        yield annotation
    for part in get_args(annotation):
        yield from tables_in(part)


def fields_of(table: type[Table], before: str = "") -> Iterator[tuple[str, Any]]:
    """Yield each key of a scenario, dotted, and its field."""
    for name, field in table.model_fields.items():
        tables = [*tables_in(field.annotation)]
        yield f"{before}{name}", field
        for inner in tables:
            yield from fields_of(inner, f"{before}{name}.")


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


def sentences() -> Iterator[tuple[str, str]]:
    """Yield each key of the file, dotted, and each table that may be left out; and its sentence."""
    table = ""
    for line in paper_text().splitlines():
        found = LINE.fullmatch(line)
        if found is None:
            continue
        if found["table"]:
            table = f"{found['table']}."
            if line.startswith("#"):
                yield found["table"], found["sentence"]
        elif found["key"]:
            yield table + found["key"], found["sentence"] or ""


def rows() -> str:
    """Return the table of keys."""
    fields = dict(fields_of(Scenario))
    lines = ["key | meaning | default", "---|---|---"]
    for key, sentence in sentences():
        cells = [f"`{key}`", linked(sentence), default_of(fields[key])]
        lines.append(" | ".join(filter(None, cells)))
    return "\n".join(lines) + "\n"


def page() -> str:
    """Return the page with its table of keys printed anew."""
    before, _, rest = PAGE.read_text("utf-8").partition("key | meaning | default\n")
    return before + rows() + rest[rest.index("\n\n") + 1 :]


if __name__ == "__main__":
    PAGE.write_text(page(), "utf-8")
