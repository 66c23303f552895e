"""Whether a diagram would be wired and read as before: a key of all that it is made of."""

from collections.abc import Mapping
from typing import Any

import control

from ..equations.block import Block
from ..equations.sampled import Sampled
from ..equations.system import System
from ..equations.unchanged import Keys, Unkeyed


def key_of(diagram: Any, params: Mapping[str, Any] | None, *more: Any) -> tuple[Any, Any] | None:
    """Return the key of a diagram with such params and more, and what must live as long.

    None where something in it could change unseen.
    """
    keys = Keys()
    try:
        found = _system(keys, diagram), keys.named(params or {}), keys.of(more)
    except Unkeyed:
        return None
    return found, keys.held


def _system(keys: Keys, system: Any) -> Any:
    if not isinstance(system, control.NonlinearIOSystem):
        raise Unkeyed  # and it cannot be wired
    labels = *system.input_index, *system.output_index, *(system.state_index or ())
    own = keys.place(system), system.name, system.dt, labels
    if isinstance(system, Sampled):
        inner = system.inner
        given = keys.named(inner.given) if isinstance(inner, System) else ()
        return *own, keys.place(system.parameters), system.period, *given, *_system(keys, inner)
    if isinstance(system, Block):  # what is the package's own is not read anew
        functions = [] if system.of_package else [f for f, _ in system._roles.values()]
        return *own, keys.place(system.parameters), *map(keys.of, functions)
    own = *own, system.nstates, system.ninputs, system.noutputs, *keys.named(system.params)
    if isinstance(system, control.InterconnectedSystem):
        matrices = system.connect_map, system.input_map, system.output_map
        parts = [_system(keys, part) for part in system.syslist]
        return *own, *map(keys.of, matrices), *parts
    if isinstance(system, control.StateSpace):
        return *own, *map(keys.of, (system.A, system.B, system.C, system.D))
    kind, plain = type(system), control.NonlinearIOSystem
    if kind._rhs is not plain._rhs or kind._out is not plain._out:  # they are an object's
        raise Unkeyed
    return *own, *map(keys.of, (system.updfcn, system.outfcn))
