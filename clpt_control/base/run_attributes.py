"""Attributes of a run: their names, and notes: arguments of `simulate`, labels of its diagram.

With its scenario, the arguments repeat a scenario's run.  The run of another diagram is repeated
by the script that made it.  Notes are in the `encoding` of a run, which xarray passes on, and are
attributes of its file, as JSON.  The diagram itself is in the `encoding` of a run in memory.
"""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib.metadata import version
from typing import TYPE_CHECKING, Any

import numpy as np

from .errors import DataError

if TYPE_CHECKING:
    import xarray


@cache
def versions(*packages: str) -> str:
    """Return the names and versions of packages in one line."""
    return ", ".join(f"{name} {version(name)}" for name in packages)


MOST_BYTES = 4 * 10**9  # memory of a run
CHANGED = "parameters_changed"  # attribute of a run: parameters given at call time
# attribute of a team's run, in place of its scenario: the team as TOML text
TEAM = "team"
OWN_LAW = "own_law"  # attribute of a run: the name of a law given in Python
# attribute of a run: other blocks of its diagram that were given in Python
OWN_PARTS = "own_parts"
REFERENCE = "reference"  # name of the block of the waypoints
FORM = "run_format"  # attribute of a run's file: the number of its format; default 1
IN_PYTHON = "the rest to closed_loop(replace=..., insert=...)"
BEYOND = {  # attribute of a run -> change that its scenario does not have, remedy in Python
    CHANGED: (
        "parameters given at call time",
        "the parameters to simulate(params=...)",
    ),
    OWN_LAW: ("a law given in Python", IN_PYTHON),
    OWN_PARTS: ("parts given in Python", IN_PYTHON),
}


def beyond_scenario(attributes: Mapping[Any, Any]) -> list[str]:
    """Return what a run had that its scenario does not hold, by attributes of the run."""
    return [
        f"{change}, {attributes[name]}"
        for name, (change, _) in BEYOND.items()
        if name in attributes
    ]


# --- notes ----------------------------------------------------------------------------------------

ARGUMENTS = "arguments"
LABELS = "labels"
DIAGRAM = "diagram"  # of a run in memory; no file has it
KEYS = {  # note -> its keys
    ARGUMENTS: {
        "timepts",
        "params",
        "engine",
        "method",
        "rtol",
        "atol",
        "max_step",
        "first_step",
    },
    LABELS: {"name", "inputs", "outputs", "states"},
}


@dataclass(eq=False)
class RunDiagram:
    """The diagram of a run in memory and its arguments, which copies share and pickles lose."""

    diagram: Any = None
    params: Mapping[str, Any] | None = None
    request: Any = None  # times, inputs, start and options as they were read
    numbers: Any = ()  # parameters of each block

    def __deepcopy__(self, memo: Any) -> "RunDiagram":
        return self

    def __reduce__(self) -> Any:
        return RunDiagram, ()


def note_texts(run: "xarray.Dataset") -> dict[str, str]:
    """Return the notes on a run as attributes of its file."""
    return {
        name: json.dumps(run.encoding[name], default=lambda x: np.asarray(x).tolist())
        for name in KEYS
        if name in run.encoding
    }


def read_note(attributes: Mapping[Any, Any], name: str) -> dict[str, Any]:
    """Return a note from the attributes of a file."""
    try:
        note = json.loads(str(attributes.get(name, "{}")))
        unknown = note.keys() - KEYS[name]
        if name == LABELS:
            labels = [label for labels in note.values() for label in labels]
            unknown |= {label for label in labels if not isinstance(label, str)}
    except (ValueError, AttributeError, TypeError):
        unknown = {"text"}
    if unknown:
        raise DataError(f"its {name} are damaged: {min(map(str, unknown))}")
    return note
