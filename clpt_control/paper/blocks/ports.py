"""Ports of the paper's diagram: shapes and units.  A law declares its states' shapes.

    paper_block("vehicle_controller", "x zc phi_x -> v_x", parameters, output=controller)

Quantities of two axes are positions (x, z, zc, e: length), velocities (flow_x, v_x, psi, delta:
length per time) and gains of each axis (K, Gamma: per time).  N is the number of basis functions
(phi_x, phi_z: no unit); rows of parameters, one for each axis, are (2, N) (alpha, theta: length per
time).
"""

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from ...engine.model.block import Block


def _by_name(groups: Mapping[Any, str]) -> dict[str, Any]:
    """Return the fact of each name of groups of names."""
    return {name: fact for fact, names in groups.items() for name in names.split()}


POWERS = _by_name(  # of the units of length and of 1/time
    {
        (1, 0): "x x_true z zc e fix",
        (0, 1): "K Gamma",
        (1, 1): "flow_x flow_z v_x v_z v_c unflown psi delta alpha",
    }
)
SHAPES = dict.fromkeys([*POWERS, "eta_3", "eta_4"], 2) | _by_name(
    {
        "N": "phi_x phi_x_true phi_z widths frequencies phases information",
        (2, "N"): "alpha alpha_0 alpha_M theta theta_hat eta",
        ("N", 2): "centers",
        1: "taken V",
    }
)


def shapes_of(names: Iterable[str]) -> dict[str, Any]:
    """Return the shapes of the quantities that have one."""
    return {name: SHAPES[name] for name in names if name in SHAPES}


def paper_block(
    name: str,
    ports: str,
    parameters: Mapping[str, Any] = {},
    N: int | None = None,
    **options: Any,
) -> Block:
    """Make a block; `ports` are its inputs, "->" and its outputs, or its states without `output`.

    N is the number of basis functions if no parameter has that size.  A block with `breakpoints`
    has the parameter `interval`, which the integrator sets.
    """
    inputs, outputs = (
        {port: SHAPES[port] for port in s.split()} for s in ports.split("->")
    )
    options["outputs" if "output" in options else "states"] = outputs
    numbers = dict(parameters)
    if "breakpoints" in options:
        numbers["interval"] = -1.0
    return Block(
        name,
        inputs=inputs,
        parameters={
            key: np.asarray(value, dtype=float)[()] for key, value in numbers.items()
        },
        shapes=shapes_of(parameters) | options.pop("shapes", {}),
        sizes={} if N is None else {"N": N},
        **options,
    )
