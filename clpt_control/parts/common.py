"""Functions to make the blocks of the component library.

Parameters are numbers, ports may have other names, and time is continuous or discrete.
"""

import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial, update_wrapper
from typing import Any

import numpy as np

from ..base.arguments import brief, finite, known, numbers
from ..base.errors import BlockError
from ..engine.model.block import Block
from ..engine.model.ports import check_count, renamed

Ports = Mapping[str, str]  # name of a port -> the user's name
Rule = Callable[[str, Mapping[str, Any]], None]  # refuses values of a named block
UNBOUNDED = {"low", "high", "rise", "fall", "tracking"}  # what may be infinite


def make_block(
    name: str,
    ports: Ports,
    parameters: Mapping[str, Any],
    rules: Sequence[Rule] = (),
    **declared: Any,
) -> Block:
    """Make a block; `ports` has other names of some ports, {"u": "v_c"}.

    Rules hold where the block is made and for values of a call.
    """
    rules = check_finite, *rules
    for rule in rules:
        rule(name, parameters)
    values = {
        key: numbers(f"{name}: {key}", value)[()] for key, value in parameters.items()
    }
    block = Block(name, parameters=values, **declared)
    block.rules = rules
    names = {*block.input_ports, *block.output_ports}
    for port, new_name in ports.items():
        if port not in names:
            raise BlockError(
                f"{name}: has no port or argument '{port}'. {known(port, sorted(names))}"
            )
        if not isinstance(new_name, str):
            raise BlockError(f"{name}: {port} = {new_name!r}: must be a name, a text")
    return renamed(block, name, ports, ports) if ports else block


def signal_block(
    name: str,
    ports: Ports,
    parameters: Mapping[str, Any],
    signals: int,
    **declared: Any,
) -> Block:
    """Make a block with the input u and the output y, each of some signals."""
    declared |= {"inputs": {"u": signals}, "outputs": {"y": signals}}
    return make_block(name, ports, parameters, **declared)


def following_block(
    name: str,
    ports: Ports,
    values: dict,
    signals: int,
    rules: Sequence[Rule],
    rate: Any,
    step: Any = None,
    dt: float | None = None,
) -> Block:
    """Make a block with its output as state, or, sampled, with its last output as state."""
    if dt is None:
        u, y = {"u": signals}, {"y": signals}
        return make_block(name, ports, values, rules, update=rate, inputs=u, states=y)
    last = {"last": signals}
    return signal_block(
        name,
        ports,
        values,
        signals,
        rules=rules,
        update=step,
        output=step,
        states=last,
        dt=dt,
    )


def with_constants(function: Any, **constants: Any) -> Any:
    """Return equations with constants, such as their period dt, which are no parameters."""
    return update_wrapper(partial(function, **constants), function)


# --- values ------------------------------------------------------------------------------------


def checked_sizes(name: str, signals: int, **values: Any) -> dict[str, Any]:
    """Return values; each is one number, or a number for each signal."""
    check_count(f"{name}: signals = {signals}", signals)
    for key, value in values.items():
        if numbers(f"{name}: {key}", value).shape not in ((), (signals,)):
            others = f", or {signals}" if signals > 1 else ""
            raise BlockError(
                f"{name}: {key} = {brief(value)}: must be one number{others}"
            )
    return values


def check_finite(name: str, values: Mapping[str, Any]) -> None:
    """Refuse values that are not finite, but for limits."""
    for key, value in values.items():
        (numbers if key in UNBOUNDED else finite)(f"{name}: {key}", value)


def check_positive(name: str, *, or_zero: bool = False, **values: Any) -> None:
    """Refuse values that are not positive numbers."""
    check_finite(name, values)
    for key, value in values.items():
        array = np.asarray(value)
        if not np.all(array >= 0 if or_zero else array > 0):
            raise BlockError(
                f"{name}: {key} = {brief(value)}: must be positive{' or 0' * or_zero}"
            )


def positive(*keys: str, or_zero: bool = False) -> Rule:
    """Return a rule that refuses parameters that are not positive."""
    return Positive(keys, or_zero)


@dataclass(frozen=True)
class Positive:
    """Rule that refuses parameters that are not positive."""

    keys: Sequence[str]
    or_zero: bool

    def __call__(self, name: str, values: Mapping[str, Any]) -> None:
        """Check the values of a named block."""
        given = {key: values[key] for key in self.keys if key in values}
        check_positive(name, or_zero=self.or_zero, **given)

    @property
    def least(self) -> dict[str, float]:
        """The least value that each parameter may have."""
        return dict.fromkeys(self.keys, 0.0 if self.or_zero else sys.float_info.min)


def ordered(below: str, above: str, is_below: Any = np.less) -> Rule:
    """Return a rule that refuses a parameter that is not below another."""
    return partial(_ordered, below, above, is_below)


def _ordered(
    below: str, above: str, is_below: Any, name: str, values: Mapping[str, Any]
) -> None:
    low, high = values[below], values[above]
    if not np.all(is_below(low, high)):
        raise BlockError(
            f"{name}: {below} = {brief(low)}: must be below {above} = {brief(high)}"
        )


def lag_parameter(name: str, lag: float | None, dt: float | None) -> dict[str, float]:
    """Return the parameter `lag` of a continuous block; a sampled block has none."""
    if (lag is None) == (dt is None):
        raise BlockError(
            f"{name}: give lag, in continuous time, or dt, sampled; one of the two"
        )
    if lag is None:
        check_positive(name, dt=dt)
        return {}
    return {"lag": lag}
