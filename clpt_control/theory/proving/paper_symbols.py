"""The paper's symbols for a diagram's states, ports and parameters.

A port `x[2]` becomes x_1, x_2; a port of 2N signals, such as `alpha`, becomes
alpha_1[1] ... alpha_2[N], axis then basis function, both from 1.  A state that is no
port of the diagram carries its block's name, and so does every parameter; fields that
are one number in the paper (`ONE`) are one symbol where they hold the same values.
A parameter has the sign of its value, and one that is zero is zero.
"""

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
import sympy

from ...equations.block import Block
from ...equations.namespaces import named, split
from ...scenario.keys import CALL_TIME_NAMES

# fields that stand for one thing, and its name in the paper
ONE = {
    "alpha_M": CALL_TIME_NAMES["model.parameters"],
    "theta": ("true_flow.theta", "lyapunov.theta"),
    "theta_hat": ("injection.theta_hat",),
    "KD": ("vehicle_controller.KD", "lyapunov.KD", "error_system.KD"),
    "GammaD": ("vehicle_controller.GammaD", "lyapunov.GammaD"),
    "gamma": (
        "adaptation.gain",
        "adaptation.gain_K",
        "adaptation.gain_Gamma",
        "parameter_system.gain",
        "lyapunov.gain",
        "lyapunov.gain_K",
        "lyapunov.gain_Gamma",
    ),
    "kappa": ("consensus.coupling",),
}
SHARED = ("theta", "gamma", "kappa")  # by all vehicles of a team
SCALARS = ("gamma",)  # one number in the paper, whatever shape a block keeps it in
_NAMES = {field: name for name, fields in ONE.items() for field in fields}


def port_names(port: str, size: int, N: int | None = None) -> list[str]:
    """Return the names of one port's signals, flattened row by row."""
    own = split(port)[1]
    if N is not None and own.startswith("phi") and size == N:
        return [f"{port}[{k + 1}]" for k in range(size)]
    if N is not None and own in ("alpha", "eta", "pull") and size >= 2 * N:
        names = [f"{port}_{k // N + 1}[{k % N + 1}]" for k in range(2 * N)]
        return names + [f"{port}_{k + 1}" for k in range(2 * N, size)]
    return [f"{port}_{k + 1}" for k in range(size)]


def port_symbols(port: str, size: int, N: int | None = None, function_of: tuple = ()) -> np.ndarray:
    """Return the symbols of one port, flattened row by row, or functions of arguments."""
    names = port_names(port, size, N)
    if function_of:
        return np.array([sympy.Function(name, real=True)(*function_of) for name in names], object)
    return np.array([sympy.Symbol(name, real=True) for name in names], dtype=object)


def state_names(blocks: Iterable[Block]) -> dict[tuple[str, str], str]:
    """Return what each state is called: its port, or block:port."""
    made = {port: block.name for block in blocks for port in block.output_ports}
    return {
        (block.name, port): port if made.get(port) == block.name else f"{block.name}:{port}"
        for block in blocks
        for port in block.state_ports
    }


def paper_name(block: str, field: str) -> str | None:
    """Return what the paper calls a field, with the vehicle's name where it is its own."""
    space, own = split(block)
    name = _NAMES.get(f"{own}.{field}")
    return name if name is None or not space or name in SHARED else named(space, name)


def parameter_names(blocks: Sequence[Block]) -> dict[tuple[str, str], str]:
    """Return (block, field) -> the paper's name where all fields of it agree, else block.field."""
    held: dict[str, list[Any]] = {}
    for block in blocks:
        for field, value in zip(block.parameters._fields, block.parameters, strict=True):
            name = paper_name(block.name, field)
            if name is not None:
                held.setdefault(name, []).append(value)
    ports = {port for b in blocks for port in (*b.input_ports, *b.output_ports)}
    one = {name for name, values in held.items() if name not in ports and _same(name, values)}
    found = {}
    for block in blocks:
        for field in block.parameters._fields:
            name = paper_name(block.name, field)
            found[block.name, field] = name if name in one else f"{block.name}.{field}"
    return found


def parameter_symbols(blocks: Sequence[Block]) -> dict[str, Any]:
    """Return block -> NamedTuple of symbols; whole numbers stay numbers, zeros are zero."""
    names = parameter_names(blocks)
    return {
        block.name: type(block.parameters)(
            *(
                value if isinstance(value, int) else symbols_of(names[block.name, field], value)
                for field, value in zip(block.parameters._fields, block.parameters, strict=True)
            )
        )
        for block in blocks
    }


def signed(name: str, value: Any) -> sympy.Expr:
    """Return a symbol with the sign that all values have, or zero."""
    value = np.asarray(value, dtype=float)
    if name.endswith(".interval"):  # its own value, -1, says only that it is counted
        return sympy.Symbol(name, real=True)
    if value.size and not np.any(value):
        return sympy.Integer(0)
    if value.size and np.all(value > 0):
        return sympy.Symbol(name, positive=True)
    if value.size and np.all(value < 0):
        return sympy.Symbol(name, negative=True)
    return sympy.Symbol(name, real=True)


def symbols_of(name: str, value: Any) -> Any:
    """Return the symbols of a parameter, in its shape."""
    shape = np.shape(value)
    if not shape:
        return signed(name, value)
    array = np.empty(shape, dtype=object)
    for index in np.ndindex(shape):
        axis = split(name)[1] in ONE and shape[0] == 2
        place = f"_{index[0] + 1}" if axis else f"[{index[0] + 1}]"
        place += "".join(f"[{k + 1}]" for k in index[1:])
        array[index] = signed(name if name in SCALARS else name + place, value)
    return array


def _same(name: str, values: list) -> bool:
    if name in SCALARS:
        return all(np.all(np.asarray(value) == np.ravel(values[0])[0]) for value in values)
    return all(np.array_equal(value, values[0]) for value in values)
