"""What every part is made with: numbers as parameters, ports by other names, checks."""

from collections.abc import Mapping
from functools import partial, update_wrapper
from typing import Any

import numpy as np

from ..arguments import brief, numbers
from ..equations.block import Block
from ..equations.ports import renamed
from ..errors import BlockError

Ports = Mapping[str, str]  # name of a port -> the user's own


def part(name: str, ports: Ports, parameters: Mapping[str, Any], **declared: Any) -> Block:
    """Make a part; `ports` calls some of its ports otherwise, {"u": "v_c"}."""
    values = {key: numbers(f"{name}: {key}", value)[()] for key, value in parameters.items()}
    block = Block(name, parameters=values, **declared)
    known = {*block.input_ports, *block.output_ports}
    for port, new_name in ports.items():
        if port not in known:
            named = ", ".join(sorted({*known, *values}))
            raise BlockError(f"{name}: has no port or parameter '{port}', but {named}")
        if not isinstance(new_name, str):
            raise BlockError(f"{name}: {port} = {new_name!r}: must be a name, a text")
    return renamed(block, name, ports, ports) if ports else block


def signal_part(
    name: str, ports: Ports, parameters: Mapping[str, Any], signals: int, **declared: Any
) -> Block:
    """Make a part that takes u and makes y, each of some signals."""
    both = {"inputs": {"u": signals}, "outputs": {"y": signals}}
    return part(name, ports, parameters, **both, **declared)


def each(name: str, signals: int, **values: Any) -> dict[str, Any]:
    """Return numbers, of which there may be one for each signal."""
    for key, value in values.items():
        if numbers(f"{name}: {key}", value).shape not in ((), (signals,)):
            raise BlockError(f"{name}: {key} = {brief(value)}: must be one number, or {signals}")
    return values


def positive(name: str, **values: Any) -> None:
    """Refuse what is no positive number."""
    for key, value in values.items():
        if not np.all(numbers(f"{name}: {key}", value) > 0):
            raise BlockError(f"{name}: {key} = {brief(value)}: must be positive")


def rising(name: str, **limits: Any) -> None:
    """Refuse two limits of which the first is not below."""
    (below, low), (above, high) = limits.items()
    if not np.all(np.asarray(low) < np.asarray(high)):
        raise BlockError(f"{name}: {below} = {brief(low)}: must be below {above} = {brief(high)}")


def sampled(function: Any, dt: float) -> Any:
    """Return equations that know when they are sampled next, which no parameter changes."""
    return update_wrapper(partial(function, dt=dt), function)
