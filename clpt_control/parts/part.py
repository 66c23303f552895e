"""What every part is made with: numbers as parameters, ports by other names, two kinds of time."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from ..arguments import brief, nearest, numbers
from ..equations.block import Block
from ..equations.declaration import renamed
from ..errors import BlockError


def part(
    name: str, ports: Mapping[str, str], parameters: Mapping[str, Any], **declared: Any
) -> Block:
    """Make a part; `ports` calls some of its ports otherwise, {"u": "v_c"}."""
    own = {key: numbers(f"{name}: {key}", value)[()] for key, value in parameters.items()}
    made = Block(name, parameters=own, **declared)
    known = {*made.input_ports, *made.output_ports}
    for port, called in ports.items():
        if port not in known:
            close = nearest(port, [*known, *own, "dt", "signals", "name"])
            raise BlockError(
                f"{name}: has no port '{port}'; it has {', '.join(sorted(known))}"
                + (f"; did you mean {close}?" if close else "")
            )
        if not isinstance(called, str):
            raise BlockError(f"{name}: {port} = {called!r}: must be a name, a text")
    return renamed(made, name, ports, ports) if ports else made


def each(name: str, signals: int, **given: Any) -> dict[str, Any]:
    """Return numbers, of which there may be one for each signal."""
    for key, value in given.items():
        if numbers(f"{name}: {key}", value).shape not in ((), (signals,)):
            raise BlockError(f"{name}: {key} = {brief(value)}: must be one number, or {signals}")
    return given


def positive(name: str, **given: Any) -> None:
    """Refuse what is no positive number."""
    for key, value in given.items():
        if not np.all(numbers(f"{name}: {key}", value) > 0):
            raise BlockError(f"{name}: {key} = {brief(value)}: must be positive")


def rising(name: str, **given: Any) -> None:
    """Refuse two limits of which the first is not below."""
    (below, low), (above, high) = given.items()
    if not np.all(np.asarray(low) < np.asarray(high)):
        raise BlockError(f"{name}: {below} = {brief(low)}: must be below {above} = {brief(high)}")


def time_of(name: str, lag: float | None, dt: float | None) -> dict[str, float]:
    """Return the one time that was given: a lag, in continuous time, or that of sampling."""
    given = {key: value for key, value in (("lag", lag), ("dt", dt)) if value is not None}
    if len(given) != 1:
        raise BlockError(
            f"{name}: give lag, for continuous time, or dt, for a sampled part; one of the two"
        )
    positive(name, **given)
    return given


def remembering(
    name: str,
    rate: Any,
    step: Any,
    signals: int,
    ports: dict[str, str],
    lag: float | None,
    dt: float | None,
    **parameters: Any,
) -> Block:
    """Make a part that remembers its output: a state, or what a sampled one gave last."""
    given = {**parameters, **time_of(name, lag, dt)}
    own: dict[str, Any] = {"inputs": {"u": signals}}
    if dt is None:
        return part(name, ports, given, update=rate, states={"y": signals}, **own)
    own |= {"outputs": {"y": signals}, "states": {"last": signals}, "dt": dt}
    return part(name, ports, given, update=step, output=step, **own)
