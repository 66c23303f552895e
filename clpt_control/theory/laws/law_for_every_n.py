"""V' of a law for every number N of basis functions, as it is for one N.

V', V and the rates of what V does not contain are base + sum_k term(k); each is judged by its base
and its term, and holds for every N.
"""

from collections.abc import Mapping
from functools import partial
from typing import Any

import numpy as np
import sympy

from ...engine.record.scalar_graph import Index
from ..algebra.every_n import base_and_term, reindexed
from ..algebra.exact import normal_form
from ..algebra.slopes import degree
from ..algebra.sums_of_squares import squares
from ..algebra.texts import short
from ..proofs.limits import CLOCK
from ..proofs.symbolic_loop import TIME, ArrayLoop
from .theorem_loop import decay, rate_of_V


def holds_for_every_N(law: Any) -> tuple[bool, str]:
    """Return whether V' of a `LawCandidate` is as shown for every N, and what is left over."""
    loop = ArrayLoop(law.loop.diagram, substitute=partial(_of_every_N, law))
    residual = normal_form(loop.elements.of(rate_of_V(loop) - decay(loop)))
    if loop.undefined:
        return False, loop.undefined[0]
    V = loop.elements.of(loop.signals["V"][0])
    if not all(squares(summand, law.fixed) for summand in base_and_term(V)):
        return False, "V is not known to be definite"
    # what no equation reads exists as long as what drives it
    ports = [port for port in _outside_V(law) if port in loop.states]
    rates = {port: loop.elements.of(loop.rates[port]) for port in ports}
    states = {port: loop.elements.of(loop.states[port]) for port in ports}
    if faster := faster_than(1, rates, states):
        return False, f"{faster} may grow faster than linearly"
    of_e = {"e'": loop.elements.of(loop.derivative(loop.signals["e"]))}
    states["t"] = [TIME]
    if faster := faster_than(0, of_e, states):
        return False, f"{faster} is not known to be bounded"
    base, term = summands = [
        normal_form(summand) for summand in base_and_term(residual)
    ]
    # for all gains, or for those that it has
    every_gain: dict[Any, Any] = {}
    for values in (every_gain, law.values):
        if all(law.never_positive(summand.xreplace(values)) for summand in summands):
            return True, ""
    return False, f"left over: {short(base)}; summand {short(term)}"


def _outside_V(law: Any) -> list[str]:
    """Return the ports of states that V need not contain."""
    in_V = set().union(*(form.free_symbols for form in law.forms))
    in_V |= {*law.loop.states["z"], *law.loop.states["x"]}
    states = law.loop.states
    return [port for port in states if {*states[port].flat} - in_V]


def _of_every_N(law: Any, symbol: sympy.Expr, index: Index) -> sympy.Expr:
    """Return a parameter's element for every N: V's are numbers, the law's or the truth's."""
    generic = [name for name in index if isinstance(name, str)]
    weight = law.of_V.get(symbol, symbol)
    if weight != symbol or len(generic) != 1:
        return weight
    names = [{generic[0]: str(k + 1)} for k in range(law.N)]
    members = [reindexed(symbol, name) for name in names]
    members = [law.of_V.get(s, s) for s in members]
    # one for all, or one each
    for gain in (members[0], reindexed(members[0], {"1": generic[0]})):
        if [reindexed(gain, name) for name in names] == members:
            return gain
    return symbol


def faster_than(power: int, rates: Mapping[str, Any], states: Mapping[str, Any]) -> str:
    """Return which rate may grow with a higher power of the states, and its value; or ""."""
    elements = [s for symbols in states.values() for s in np.ravel(symbols)]
    names = {str(s).split("[")[0] for s in elements}

    def is_state(symbol: sympy.Symbol) -> bool:
        return str(symbol).split("[")[0] in names  # m[k] is one of m[j]

    for port, values in rates.items():
        for rate in np.ravel(values):
            if degree(sympy.sympify(rate).xreplace({TIME: CLOCK}), is_state) > power:
                return f"{port} = {short(rate)}"
    return ""
