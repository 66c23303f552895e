"""V of an adaptive law: by default from its gains, else as the user gives it.

The default is Eq. (24), each error weighed by the inverse of the gain with which the law adapts it,
so that the terms with e cancel.  Gains are read off the law's equations,

    alpha' = -gain e phi + rest,    K' = -gain z e + rest,    Gamma' = gain zc e + rest

Where the products e phi, e z and e zc drive each other's rates, by a matrix that is symmetric and
positive definite, V weighs the errors by its inverse.
"""

from collections.abc import Callable, Mapping
from functools import partial
from inspect import signature
from typing import Any, NamedTuple

import control
import numpy as np
import sympy
from sympy.core.function import AppliedUndef

from ...base.errors import DiagramError
from ...engine.diagram.interconnection import connect
from ...engine.diagram.wiring import read_anew
from ...engine.model.block import Block
from ...paper.blocks.lyapunov import lyapunov_candidate, weighted
from ...paper.laws.law import LEARNED, Truth
from ...simulation.user_parts import functions_of
from ..promises import truth_of
from .exact import tidied
from .symbolic_loop import TIME, SymbolicLoop, flat, refuse_no_value, symbolic_loop
from .theorem_loop import mixed_candidate, theorem_loop, theorem_scenario

MakeV = Callable[[Truth], Block]


class LawV(NamedTuple):
    """V of a law: a function that makes it of the truth, and what is known of it."""

    make: MakeV
    # weights of V in the law's parameters; None for a V of the user
    gains: Callable[[list], list] | None = None
    # whether V' > 0 refutes the law: V was fitted to it
    fitted: bool = False


# --- the default ----------------------------------------------------------------------------


def default_V(law: Block, N: int) -> LawV:
    """Return V fitted to a law.

    V refutes the law if each learned parameter that is not held has a gain, and if a V of squares
    can take the other terms of the rates; otherwise V is a guess, and refutes nothing.
    """
    diagram = connect([law], external=list(law.input_ports), name=law.name)
    loop = symbolic_loop(diagram, jumps=True)
    refuse_no_value(loop, law.name)
    parameters = {*loop.values}
    e, states, rates, products = _learned(loop, N)
    gains, rests = list[sympy.Expr](), dict[sympy.Expr, sympy.Expr]()
    has_gains = True
    for state, rate, product in zip(states, rates, products, strict=True):
        gain = -_factor(rate, product, parameters)
        number = gain.xreplace(loop.values)
        has_gains &= number != 0 or rate == 0
        size = gain if number.is_positive else -gain if number else sympy.S.One
        gains.append(size)
        rests[state] = sympy.expand(rate + gain * product) / size
    inverse = _inverse_of_gains(loop, e, rates, products, rests)
    still = {s: sympy.Dummy(real=True) for s in _inputs_without_e(loop)}
    own_states = {s: r.xreplace(still) for s, r in rests.items() if s.is_Symbol}
    fitted = has_gains and len(own_states) == len(states) and inverse is None
    known = {*loop.values, *still.values()}
    fitted = fitted and _weighed_by_squares(own_states, known)
    symbols = flat(loop.parameters[law.name])
    weights = gains if inverse is None else [*inverse]

    def weights_of(values: list) -> list[sympy.Expr]:
        pairs = zip(symbols, values, strict=True)
        names = {s: value for s, value in pairs if isinstance(s, sympy.Symbol)}
        return [weight.xreplace(names) for weight in weights]

    if inverse is not None:
        matrix = np.array(inverse, dtype=float)
        return LawV(partial(mixed_candidate, matrix), weights_of, fitted)
    numbers = [float(gain.subs(loop.values)) for gain in gains]
    K, Gamma = np.reshape(numbers[-4:], (2, 2))
    each = {"gain": np.reshape(numbers[:-4], (2, N)), "gain_K": K, "gain_Gamma": Gamma}

    def make(truth: Truth) -> Block:
        parameters = weighted([1.0] * 3, *truth)._replace(**each)
        return lyapunov_candidate("learned-flow", parameters)

    return LawV(make, weights_of, fitted)


def _learned(loop: SymbolicLoop, N: int) -> tuple:
    """Return e, what is learned, its rates, and the product of e that drives each."""
    nothing = np.zeros(2 * N, dtype=object)
    e = np.array([sympy.Function(f"e_{i}", real=True)(TIME) for i in (1, 2)])
    differences = {}
    if {"x", "z"} <= set(loop.inputs):  # e may be written x - z
        differences = dict(zip(loop.inputs["x"], e + loop.inputs["z"], strict=True))
    phi, z, zc = (loop.inputs.get(port, nothing) for port in ("phi_x", "z", "zc"))
    products = [*np.ravel(np.outer(e, phi[:N])), *(e * z[:2]), *(-e * zc[:2])]
    states = [s for port in LEARNED for s in np.ravel(loop.signals.get(port, nothing))]
    rates = [
        tidied(loop.derivative(sympy.sympify(s)).xreplace(differences)) for s in states
    ]
    return e, states, rates, products


def _inputs_without_e(loop: SymbolicLoop) -> list[Any]:
    """Return the symbols of the law's inputs, except e."""
    ports = {port: symbols for port, symbols in loop.inputs.items() if port != "e"}
    return [s for symbols in ports.values() for s in symbols.flat]


def _inverse_of_gains(
    loop: SymbolicLoop, e: np.ndarray, rates: list, products: list, rests: dict
) -> sympy.Matrix | None:
    """Return the inverse of a matrix of gains between all that is learned, if there is one."""
    if not any(rest.has(*e) for rest in rests.values()):
        return None
    parameters = {*loop.values}
    M = [
        [-_factor(rate, product, parameters) for product in products] for rate in rates
    ]
    M = sympy.Matrix(M).xreplace(loop.values)
    is_mixed = M.is_symmetric() and not M.is_diagonal()
    return M.inv() if is_mixed and M.is_positive_definite else None


def _weighed_by_squares(rests: dict, known: set) -> bool:
    """Return whether a V of squares can take the terms of a law besides its gains.

    It cannot if they contain e or time, as gains that change do, or other states of the law, which
    need not take every value, or if they weigh the errors in another way.
    """
    if any(rest.free_symbols - set(rests) - known for rest in rests.values()):
        return False
    slopes = {(a, b): sympy.diff(rest, b) for a, rest in rests.items() for b in rests}
    return all(
        sympy.expand(slope - slopes[b, a]) == 0 for (a, b), slope in slopes.items()
    )


def _factor(rate: sympy.Expr, product: sympy.Expr, parameters: set) -> sympy.Expr:
    """Return the factor of a product in a rate, made of parameters alone."""
    if product == 0:  # the law does not read a signal of it
        return sympy.S.Zero
    quotients = [term / product for term in sympy.Add.make_args(rate)]
    factors = [
        q
        for q in quotients
        if not q.atoms(AppliedUndef) and q.free_symbols <= parameters
    ]
    return sympy.Add(*factors)


# --- a V of the user ------------------------------------------------------------------------


def user_V(V: Callable[..., Any], law: Block) -> LawV:
    """Return V of the user: a function of signals, or one that makes a block of the truth."""
    if isinstance(V, control.InputOutputSystem):
        raise DiagramError(
            f"{V.name}: is made, and would know one truth; give V(truth) or V(truth, parameters), "
            "a function that makes a Block with the output V[1]"
        )

    def make(truth: Truth) -> Block:
        block = V(*(truth, law.parameters)[: len(signature(V).parameters)])
        if not isinstance(block, Block) or block.output_ports != {"V": 1}:
            raise DiagramError(f"{block}: a candidate makes V[1] and nothing else")
        read_anew(block)
        return block.copy("candidate")

    try:
        make(truth_of(theorem_scenario(functions_of(law), "learned-flow")))
    except AttributeError:  # the truth alone has no signals
        return LawV(partial(_block_of_signals, V, law))
    return LawV(make)


class LawSignals:
    """The signals, parameters and true values that a V of a law may ask for: s.e, s.theta."""

    def __init__(self, ports: Mapping[str, Any], signals: Any, parameters: Any):
        self._ports, self._signals, self._parameters = ports, signals, parameters

    def __getattr__(self, name: str) -> Any:
        if name in self._ports:
            return getattr(self._signals, name)
        if hasattr(self._parameters, name):
            return getattr(self._parameters, name)
        names = ", ".join([*self._ports, *self._parameters._fields])
        raise DiagramError(f"V asks for s.{name}; s has {names}")


def _block_of_signals(V: Callable[[Any], Any], law: Block, truth: Truth) -> Block:
    """Return V as a block, of a function of the loop's signals."""
    loop = theorem_loop(functions_of(law), "learned-flow", law_block=law)
    parts = [part for part in loop.syslist if part.output_ports != {"V": 1}]
    shapes = {port: s for part in parts for port, s in part.declared["outputs"].items()}
    shapes |= {"phi_x": ("N",), "phi_z": ("N",), "zc": (2,)}
    parameters = {**law.parameters._asdict(), **truth._asdict()}

    def block(ports: Mapping[str, Any], fields: Mapping[str, Any]) -> Block:
        return Block(
            "candidate",
            output=lambda t, x, u, p: {"V": V(LawSignals(ports, u, p))},
            inputs=ports,
            outputs={"V": 1},
            parameters=fields,
            shapes={"theta": (2, "N")} if "theta" in fields else {},
            sizes={"N": functions_of(law)},
        )

    record = block(shapes, parameters).array_record("output")
    ports, fields = (
        {name: every[name] for name in every if name in {*record.leaves(group)}}
        for group, every in (("u", shapes), ("p", parameters))
    )
    return block(ports, fields)
