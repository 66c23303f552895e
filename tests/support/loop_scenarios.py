"""Scenarios that have every block of the paper's loop together, and their blocks.

They are those of each law, and the example with each line that is commented out.
"""

import re
import tomllib

from paths import ROOT
from small_scenarios import paper_of

import clpt_control as clpt

EXAMPLE = (ROOT / "clpt_control/data/paper.toml").read_text("utf-8")
HEADER = re.compile(r"(# )?\[([\w.]+)\]")
COMMENTED = re.compile(r"# (\w+ = .*)")


def values_of_comments():
    """Yield values of each line or table of the example that is commented out."""
    name, in_comment, table = "", False, {}
    for line in EXAMPLE.splitlines():
        if header := HEADER.match(line):
            in_comment, name, table = bool(header[1]), header[2], {}
        elif commented := COMMENTED.match(line):
            ((key, value),) = tomllib.loads(commented[1]).items()
            table[key] = value
            yield (
                {name: dict(table)}
                if in_comment
                else {f"{name}.{key}".strip("."): value}
            )


def scenarios():
    """Return scenarios that have every block together."""
    found = [paper_of(2, law) for law in clpt.laws()]
    for values in values_of_comments():
        try:
            found.append(clpt.paper_scenario().with_values(values))
        except clpt.ScenarioError:
            continue  # needs another key
    return found


LOOPS = [(one, clpt.paper_blocks(one)) for one in scenarios()]
