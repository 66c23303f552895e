"""Cache of prepared runs: a repeated call of `simulate` does not wire and compile again.

The key of a run has the numbers of the diagram and a fingerprint of its functions.  A diagram in
which something could change unnoticed has no key; such a diagram is prepared at each call.
"""

import os
from collections.abc import Callable
from typing import Any

import control
import numpy as np

from ..engine.codegen.machine import ENGINE
from ..engine.diagram.wiring import Params
from ..engine.model.block import Block
from ..engine.model.sampled import Sampled
from ..engine.model.system import System, given_units
from ..engine.record.unread import Unread
from ..engine.trace.fingerprint import Fingerprint, reachable

MAX_RUNS = 16  # cached runs
PLAIN = (int, bool, str, type(None))
_CACHE: dict[Any, Any] = {}
MOST_FINGERPRINTS = 64
_LAST: dict[tuple[int, ...], tuple[tuple, Fingerprint]] = {}  # by identities

Key = tuple[Any, Any]  # the key, and the objects whose identities are in the key


def cached_run(key: Key | None, make: Callable[[], Any]) -> Any:
    """Return the cached run of a key, or a new one; no other caller has it until `keep_run`."""
    cached = key and _CACHE.pop((key[0], os.environ.get(ENGINE)), None)
    return cached[1] if cached else make()


def keep_run(key: Key | None, run: Any) -> None:
    """Cache a run for the next caller.

    Runs in Python are not cached, so that their warning is repeated.
    """
    if key and run.runner.engine == "native":
        # the objects stay alive as long as their identities are in the cache
        _CACHE[key[0], os.environ.get(ENGINE)] = key, run
        if len(_CACHE) > MAX_RUNS:
            _CACHE.pop(next(iter(_CACHE)), None)


def diagram_key(diagram: Any, params: Params, *options: Any) -> Key | None:
    """Return the key of a diagram's run; None if the diagram could change unnoticed."""
    numbers = [tuple((params or {}).items()), options]
    functions: list[Any] = []
    try:
        names = _identity(diagram, numbers, functions)
        code = _fingerprint(tuple(functions))
        values = _plain_key(tuple(numbers))
        referenced = ()
        if values is None:
            fingerprint = reachable(*numbers)
            values = fingerprint.key
            referenced = fingerprint.referenced
    except Unread:
        return None
    # equal objects which can change are told apart
    mutables = tuple([id(content.value) for content in code.mutables])
    key = names, (code.key, mutables), values
    return key, (diagram, code.referenced, referenced)


def _fingerprint(functions: tuple) -> Fingerprint:
    """Return the fingerprint of functions: the last one, if nothing that they read has changed."""
    identities = tuple(map(id, functions))
    _, last = _LAST.get(identities, (None, None))
    if last is not None and last.reads is not None and last.reads.unchanged():
        return last
    fingerprint = reachable(*functions)
    if fingerprint.reads is not None:
        if len(_LAST) >= MOST_FINGERPRINTS:
            _LAST.clear()
        _LAST[identities] = functions, fingerprint
    return fingerprint


def _plain_key(values: tuple) -> tuple | None:
    """Return the key of names and numbers in tuples; None if there are other values."""
    key = []
    for value in values:
        kind = type(value)
        if kind is tuple:
            inner = _plain_key(value)
            if inner is None:
                return None
            key.append(inner)
        elif kind is float:
            key.append(value.hex())  # 0.0 is not -0.0
        elif kind in PLAIN:
            key.append((kind, value))
        else:
            return None
    return tuple(key)


def _identity(system: Any, numbers: list[Any], functions: list[Any]) -> tuple:
    """Return names and identities of a system; append its numbers and functions to the lists."""
    if not isinstance(system, control.NonlinearIOSystem):
        raise Unread("cannot be wired")
    labels = (*system.input_index, *system.output_index, *(system.state_index or ()))
    units = tuple(given_units(system).items())
    identity: tuple = id(system), system.name, system.dt, labels, units
    if isinstance(system, Sampled):
        inner = system.inner
        numbers += inner.params.values() if isinstance(inner, System) else ()
        inner_identity = _identity(inner, numbers, functions)
        return *identity, id(system.parameters), system.period, *inner_identity
    if isinstance(system, Block):
        if not system.of_package:  # functions of the package do not change
            functions += [function for function, _ in system._roles.values()]
        numbers.append(system.parameters)
        return *identity, id(system.parameters)
    identity = (*identity, system.nstates, system.ninputs, system.noutputs)
    numbers.append(tuple(system.params.items()))
    if isinstance(system, control.InterconnectedSystem):
        matrices = system.connect_map, system.input_map, system.output_map
        inner_identities = (_identity(s, numbers, functions) for s in system.syslist)
        return *identity, *map(_content, matrices), *inner_identities
    if isinstance(system, control.StateSpace):
        return *identity, *map(_content, (system.A, system.B, system.C, system.D))
    base = control.NonlinearIOSystem
    if type(system)._rhs is not base._rhs or type(system)._out is not base._out:
        raise Unread("its class has its own equations")
    functions += [system.updfcn, system.outfcn]
    return identity


def _content(matrix: np.ndarray) -> tuple:
    """Return the numbers of a matrix, to be compared."""
    return matrix.dtype.str, matrix.shape, matrix.tobytes()
