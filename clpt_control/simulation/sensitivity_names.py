"""Names of parameters and initial states by which a run is differentiated.

A name is that of a call-time parameter, ``adaptation.gain``, of one of its elements,
``plant.A[0,1]``, of a state, ``x0.NAME``, or ``x0`` for all states.
"""

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from ..base.arguments import known
from ..base.errors import SimulationError
from ..engine.codegen.directional_derivatives import (
    Place,
    place_of,
    places_of,
    read_as_number,
    value_at,
)
from ..engine.diagram.wiring import Wiring

START = "x0"  # name of all initial states


def varied_numbers(
    names: str | Iterable[str], wiring: Wiring, states: Sequence[str]
) -> dict[str, Place]:
    """Return the locations of the numbers that have these names, one by one."""
    parameters = wiring.parameters()
    places = places_of(wiring, parameters, states)
    places |= {
        f"{START}.{name}": candidates[-1:]
        for name, candidates in places.items()
        if candidates[-1].states
    }
    places[START] = [Place(states=tuple(range(len(states))))]
    varied = {}
    for name in [names] if isinstance(names, str) else names:
        location = place_of(name, places, parameters)
        if location is None:  # unknown, or the name of a parameter and of a state
            raise SimulationError(
                f"parameter '{name}': is no number of the system, nor an element, counted from 0. "
                f"{known(name, sorted(places))}"
            )
        for k in location.states:
            varied[f"{START}.{states[k]}"] = Place(states=(k,))
        if location.fields:
            varied |= _elements(name, location, parameters)
    if not varied:
        raise SimulationError(
            "to, or parameters= of a fit: no parameters. Name a parameter, or a state of the start"
        )
    _check_differentiable(varied, wiring)
    return varied


def _elements(
    name: str, location: Place, parameters: Sequence[Any]
) -> dict[str, Place]:
    """Return the elements of a parameter by name, or the single element that is named."""
    shape = np.shape(value_at(location, list(parameters), np.zeros(0)))
    field = name.partition("[")[0]
    is_whole = location.element is ...
    elements = {}
    for index in np.ndindex(shape) if is_whole else [location.element]:
        label = f"{field}[{','.join(map(str, index))}]" if index else name
        elements[label] = location._replace(element=index)
    return elements


def _check_differentiable(varied: dict[str, Place], wiring: Wiring) -> None:
    """Raise `SimulationError` for a parameter whose value a function needs as a number."""
    for name, location in varied.items():
        for k, field in location.fields:
            node = wiring.nodes[k]
            if role := read_as_number(node.system, field):
                raise SimulationError(
                    f"{name}: {node.name}.{role} asks for its value (a count, an "
                    "index, an `if`, or a library that is no NumPy), so its derivative is not known"
                )
