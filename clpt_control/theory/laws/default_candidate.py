"""V of an adaptive law: by default from its gains, otherwise from the user's function.

The default is Eq. (24), each error weighted by the inverse of the gain with which the law adapts
it, so that the terms with e cancel.  Gains are coefficients in the law's equations,

    alpha' = -gain e phi + terms,    K' = -gain z e + terms,    Gamma' = gain zc e + terms

If the products e phi, e z and e zc drive each other's rates, by a symmetric positive definite
matrix, V weights the errors by its inverse.
"""

from collections.abc import Callable, Mapping
from functools import partial
from inspect import signature
from typing import Any, NamedTuple

import control
import numpy as np
import sympy
from sympy import Add, Expr, Matrix, S, expand
from sympy.core.function import AppliedUndef

from ...base.errors import DiagramError
from ...engine.diagram.interconnection import connect
from ...engine.diagram.wiring import read_anew
from ...engine.model.block import Block
from ...paper.blocks.lyapunov import lyapunov_candidate, weighted
from ...paper.laws.law import LEARNED, Truth
from ...simulation.user_components import functions_of
from ..algebra.exact import normal_form
from ..proofs.steps import of_user
from ..proofs.symbolic_loop import (
    TIME,
    SymbolicLoop,
    flat,
    refuse_no_value,
    symbolic_loop,
)
from .promises import truth_of
from .theorem_loop import mixed_candidate, theorem_loop, theorem_scenario

MakeV = Callable[[Truth], Block]
WEIGHTS = ("inverse", "gain", "gain_K", "gain_Gamma")  # parameters of the default V


class LawV(NamedTuple):
    """V of a law as a function of the truth, and its relation to the law."""

    make: MakeV
    # the law's parameters -> weights of V; None for a V of the user
    gains: Callable[[list], list] | None = None
    # whether V was fitted to the law: then V' > 0 refutes the law
    fitted: bool = False


class LearnedParameters(NamedTuple):
    """Learned parameters of a law, one by one."""

    e: np.ndarray
    states: list[Any]
    rates: list[Expr]
    products: list[Expr]  # the product with e that drives each rate


# --- the default ----------------------------------------------------------------------------


def default_V(law: Block, N: int) -> LawV:
    """Return V fitted to a law.

    V refutes the law if each learned parameter that is not fixed has a gain, and if a V of squares
    accounts for the other terms of the rates; otherwise V is a guess, and refutes nothing.
    """
    diagram = connect([law], external=list(law.input_ports), name=law.name)
    loop = symbolic_loop(diagram, jumps=True)
    refuse_no_value(loop, law.name)
    learned = _learned(loop, N)
    # gains, and the other terms of the rates
    parameters = {*loop.values}
    weights = []
    terms = {}
    has_gains = True
    for state, rate, product in zip(*learned[1:], strict=True):
        gain = -_coefficient(rate, product, parameters)
        number = gain.xreplace(loop.values)
        has_gains &= number != 0 or rate == 0
        weight = gain if number.is_positive else -gain if number else S.One
        weights.append(weight)
        terms[state] = expand(rate + gain * product) / weight
    symbols = flat(loop.parameters[law.name])

    def weights_of(values: list) -> list[Expr]:
        pairs = zip(symbols, values, strict=True)
        value_of = {s: value for s, value in pairs if isinstance(s, sympy.Symbol)}
        return [weight.xreplace(value_of) for weight in weights]

    inverse = _inverse_of_gains(loop, learned, terms)
    if inverse is not None:
        weights = [*inverse]
        matrix = np.array(inverse, dtype=float)
        return LawV(partial(mixed_candidate, matrix), weights_of)
    # is V fitted to the law?
    ports = {port: inputs for port, inputs in loop.inputs.items() if port != "e"}
    constant = {s: sympy.Dummy(real=True) for port in ports.values() for s in port.flat}
    of_states = {s: e.xreplace(constant) for s, e in terms.items() if s.is_Symbol}
    is_fitted = (
        has_gains
        and len(of_states) == len(learned.states)
        and _is_gradient(of_states, {*loop.values, *constant.values()})
    )
    numbers = [float(weight.subs(loop.values)) for weight in weights]
    return LawV(partial(_candidate_of_gains, numbers), weights_of, is_fitted)


def _candidate_of_gains(gains: list[float], truth: Truth) -> Block:
    """Return V of Eq. (24) with a gain for each element of alpha, K and Gamma."""
    alpha, K, Gamma = gains[:-4], gains[-4:-2], gains[-2:]
    parameters = weighted([1.0] * 3, *truth)._replace(
        gain=np.reshape(alpha, (2, -1)), gain_K=np.array(K), gain_Gamma=np.array(Gamma)
    )
    return lyapunov_candidate("learned-flow", parameters)


def _learned(loop: SymbolicLoop, N: int) -> LearnedParameters:
    """Return the learned parameters of a law."""
    zeros = np.zeros(2 * N, dtype=object)
    e = np.array([sympy.Function(f"e_{i}", real=True)(TIME) for i in (1, 2)])
    differences = {}
    if {"x", "z"} <= {*loop.inputs}:  # e may be written x - z
        differences = dict(zip(loop.inputs["x"], e + loop.inputs["z"], strict=True))
    phi, z, zc = (loop.inputs.get(port, zeros) for port in ("phi_x", "z", "zc"))
    products = [*np.ravel(np.outer(e, phi[:N])), *(e * z[:2]), *(-e * zc[:2])]
    ports = [loop.signals.get(port, zeros) for port in LEARNED]
    states = [state for port in ports for state in np.ravel(port)]
    rates = []
    for state in states:
        rate = loop.derivative(sympy.sympify(state))
        rates.append(normal_form(rate.xreplace(differences)))
    return LearnedParameters(e, states, rates, products)


def _inverse_of_gains(
    loop: SymbolicLoop, learned: LearnedParameters, terms: dict
) -> Matrix | None:
    """Return the inverse of the matrix of gains if gains couple learned parameters."""
    if not any(term.has(*learned.e) for term in terms.values()):
        return None
    parameters = {*loop.values}
    rows = [
        [-_coefficient(rate, product, parameters) for product in learned.products]
        for rate in learned.rates
    ]
    gains = Matrix(rows).xreplace(loop.values)
    is_mixed = not gains.is_diagonal() and gains.is_positive_definite
    return gains.inv() if gains.is_symmetric() and is_mixed else None


def _is_gradient(terms: dict, constants: set) -> bool:
    """Return whether a V of squares accounts for the terms of a law without gains.

    It does not if they contain e or time, as gains that change do, or other states of the law,
    which need not take every value, or if they weight the errors in another way.
    """
    if any(term.free_symbols - {*terms} - constants for term in terms.values()):
        return False
    slopes = {(a, b): sympy.diff(term, b) for a, term in terms.items() for b in terms}
    return all(expand(slope - slopes[b, a]) == 0 for (a, b), slope in slopes.items())


def _coefficient(rate: Expr, product: Expr, parameters: set) -> Expr:
    """Return the coefficient of a product in a rate, made of parameters alone."""
    if product == 0:  # the law does not read a signal of the product
        return S.Zero
    quotients = (term / product for term in Add.make_args(rate))
    return Add(
        *(
            q
            for q in quotients
            if q.free_symbols <= parameters and not q.has(AppliedUndef)
        )
    )


# --- a V of the user ------------------------------------------------------------------------


def user_V(V: Callable, law: Block) -> LawV:
    """Return V of the user: a function of signals, or of the truth that returns a block."""
    if isinstance(V, control.InputOutputSystem):
        raise DiagramError(
            f"{V.name}: is a Block for one truth. Give V(truth) or V(truth, parameters), "
            "a function that makes a Block with the output V[1]"
        )

    def make(truth: Truth) -> Block:
        count = len(signature(V).parameters)
        block = of_user(f"{law.name}: V", V)(*(truth, law.parameters)[:count])
        if not isinstance(block, Block) or block.output_ports != {"V": 1}:
            raise DiagramError(f"{block}: a candidate makes V[1] and nothing else")
        read_anew(block)
        return block.copy("candidate")

    scenario = theorem_scenario(functions_of(law), "learned-flow")
    try:
        make(truth_of(scenario))
    except DiagramError as error:  # the truth alone has no signals
        if not isinstance(error.__cause__, AttributeError):
            raise
        return LawV(partial(_block_of_signals, V, law))
    return LawV(make)


class LawSignals:
    """Signals, parameters, true values and time that a V of a law may read: s.e, s.theta, s.t."""

    def __init__(
        self, ports: Mapping[str, tuple], signals: tuple, parameters: Any, t: float
    ):
        self._ports, self._signals, self._parameters = ports, signals, parameters
        self.t = t

    def __getattr__(self, name: str) -> Any:
        if name in self._ports:
            return getattr(self._signals, name)
        if hasattr(self._parameters, name):
            return getattr(self._parameters, name)
        names = ", ".join(["t", *self._ports, *self._parameters._fields])
        raise DiagramError(f"V needs s.{name}; s has {names}")


def _block_of_signals(
    V: Callable[[LawSignals], Expr], law: Block, truth: Truth
) -> Block:
    """Return V as a block, of a function of the loop's signals."""
    loop = theorem_loop(functions_of(law), "learned-flow", law_block=law)
    shapes: dict[str, Any] = {}
    for block in loop.syslist[:-1]:  # the last one is V
        shapes |= block.declared["outputs"]
    shapes |= {"phi_x": ("N",), "phi_z": ("N",), "zc": (2,)}
    parameters = law.parameters._asdict() | truth._asdict()

    def candidate(ports: Mapping[str, tuple], fields: Mapping[str, Any]) -> Block:
        return Block(
            "candidate",
            output=lambda t, x, u, p: {"V": V(LawSignals(ports, u, p, t))},
            inputs=ports,
            outputs={"V": 1},
            parameters=fields,
            shapes={"theta": (2, "N")} if "theta" in fields else {},
            sizes={"N": functions_of(law)},
        )

    # only with the ports and parameters that V reads
    leaves = candidate(shapes, parameters).array_record("output").leaves
    ports = {port: shapes[port] for port in shapes if port in leaves("u")}
    fields = {name: parameters[name] for name in parameters if name in leaves("p")}
    return candidate(ports, fields)
