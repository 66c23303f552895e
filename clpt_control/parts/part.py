"""What every part is made with: numbers as parameters, ports by other names, two kinds of time."""

from collections.abc import Mapping
from functools import partial, update_wrapper
from typing import Any

import numpy as np

from ..arguments import brief, numbers
from ..engine.model.block import Block
from ..engine.model.ports import renamed
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


def time_of(name: str, lag: float | None, dt: float | None) -> dict[str, float]:
    """Return the lag, in continuous time; a part that samples, each `dt`, has none."""
    times = {key: value for key, value in (("lag", lag), ("dt", dt)) if value is not None}
    if len(times) != 1:
        raise BlockError(f"{name}: give lag, in continuous time, or dt, sampled; one of the two")
    positive(name, **times)
    return {} if lag is None else {"lag": lag}


def sampled(function: Any, dt: float) -> Any:
    """Return equations that know when they are sampled next, which no parameter changes."""
    return update_wrapper(partial(function, dt=dt), function)


def remembering(
    name: str, ports: Ports, values: dict, signals: int, rate: Any, step: Any, dt: float | None
) -> Block:
    """Make a part that remembers its output: a state, or what a sampled one gave last."""
    if dt is None:
        return part(name, ports, values, update=rate, inputs={"u": signals}, states={"y": signals})
    last = {"last": signals}
    return signal_part(name, ports, values, signals, update=step, output=step, states=last, dt=dt)
