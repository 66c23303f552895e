"""One sentence for what is wrong with a scenario: key, value, what is allowed."""

import difflib
from collections.abc import Sequence
from typing import Any

from .tables import (
    Basis,
    Circle,
    Disturbance,
    Flow,
    Learning,
    Model,
    Part,
    Run,
    Units,
    Vehicle,
    Waypoints,
)

TABLES: dict[tuple[str, ...], type[Part]] = {
    ("units",): Units,
    ("basis",): Basis,
    ("flow",): Flow,
    ("flow", "disturbance"): Disturbance,
    ("model",): Model,
    ("vehicle",): Vehicle,
    ("reference", "circle"): Circle,
    ("reference", "waypoints"): Waypoints,
    ("learning",): Learning,
    ("run",): Run,
}


def sentence(problem: Any, tables: Sequence[str]) -> str:
    """Say what is wrong with one key.

    Parameters
    ----------
    problem : dict
        An entry of pydantic's errors.
    tables : sequence of str
        Names allowed at the top.

    Returns
    -------
    str
        Key, value and what is allowed.
    """
    where = [part for part in problem["loc"] if not _is_tag(part, problem["loc"])]
    key = ""
    for part in where:
        key += f"[{part}]" if isinstance(part, int) else f".{part}" if key else str(part)
    message = problem["msg"].replace("Input should be", "must be").replace("Value error, ", "")
    kind = problem["type"]
    if kind == "missing":
        return f"missing key {key}"
    if kind == "extra_forbidden":
        table = tuple(str(part) for part in problem["loc"][:-1])
        allowed = list(tables) if not table else list(TABLES[table].model_fields)
        close = difflib.get_close_matches(str(where[-1]), allowed, n=1)
        hint = f"; did you mean {close[0]}?" if close else ""
        return f"unknown key {key}{hint} allowed here: {', '.join(allowed)}".replace("? a", "? A")
    if kind == "union_tag_not_found":
        return f'{key}.kind: is required; must be "circle" or "waypoints"'
    if kind == "union_tag_invalid":
        return f'{key}.kind = {problem["ctx"]["tag"]!r}: must be "circle" or "waypoints"'
    if kind == "value_error" and len(where) <= 1:
        return message
    if kind in ("too_long", "too_short", "tuple_type", "missing_argument"):
        message = message.replace("Tuple should", "must").replace("after validation", "")
    if kind in ("model_type", "model_attributes_type"):
        message = "must be a table of keys"
    shown = repr(problem["input"])
    shown = shown if len(shown) <= 60 else shown[:57] + "..."
    return f"{key} = {shown}: {message}"


def _is_tag(part: Any, location: tuple[Any, ...]) -> bool:
    return location[:1] == ("reference",) and part in ("circle", "waypoints")
