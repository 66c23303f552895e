"""States and inputs of a diagram by name: ``{"angle": 0.5}``, of labels or ports."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ...base.arguments import nearest, numbers
from ...base.errors import ArgumentError
from ..model.ports import indices_by_name, ports_of


def columns_of(diagram: Any, kind: str, labels: Sequence[str], name: Any) -> list[int]:
    """Return the columns of a label or port; refuse an unknown name."""
    names = indices_by_name(labels)
    for known in (name, str(name).replace(".", "_")):  # plant.angle is plant_angle
        if known in names:
            return names[known]
    close = nearest(str(name), names)
    advice = (
        f"Did you mean '{close}'?" if close else f"It has {', '.join(ports_of(labels))}"
    )
    raise ArgumentError(
        f"{diagram.name}: has no {kind} '{name}'. {advice if names else 'It has none'}"
    )


def check_rows(argument: str, name: str, values: np.ndarray, count: int) -> None:
    """Refuse values of other signals than `count`."""
    if len(values) != count:
        raise ArgumentError(
            f"{argument}['{name}']: has {len(values)} rows. Give {count}, one per signal"
        )


def vector_by_name(
    argument: str, diagram: Any, kind: str, given: Any, default: Any = None
) -> Any:
    """Return states or inputs given by name as a vector; others have the default, or are 0."""
    if not isinstance(given, Mapping):
        return given
    labels = getattr(diagram, f"{kind}_labels")
    if len(labels) != getattr(diagram, f"n{kind}s"):
        raise ArgumentError(
            f"{argument}: {diagram.name} has {kind}s of one name. Give an array"
        )
    vector = np.zeros(len(labels))
    if default is not None:
        vector[:] = default
    for name, value in given.items():
        columns = columns_of(diagram, kind, labels, name)
        values = numbers(f"{argument}['{name}']", value).ravel()
        if len(values) == 1:
            values = np.repeat(values, len(columns))
        check_rows(argument, name, values, len(columns))
        vector[columns] = values
    return vector
