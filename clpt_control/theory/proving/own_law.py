"""Prove an adaptive law of your own, or see where it fails.

    V' = -e^T KD e + residual        along the closed loop with your law in it

The law is a block that takes any of the diagram's signals and makes alpha, K, Gamma.  If
the residual is never positive, V falls and e goes to zero as in Theorem 3.2.  Where what
is left pulls back but for a constant, V' is bounded.  Else points are looked for at which
the running blocks themselves give V' > 0.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy
from sympy.core.function import AppliedUndef

from ...blocks import Block
from ...diagrams.interconnection import Diagram, connect
from ...errors import ClptError, DiagramError
from .lyapunov import claimed, decay, every_n_residual, short
from .paper_symbols import port_symbols
from .proof import Step, checked
from .quadratic_forms import nonpositive, positive_definite, pulled, tidied
from .refutation import refuting_point
from .running_rate import Draw, Point, compared, symbol_values
from .symbolic_loop import TIME, SymbolicLoop, symbolic_loop
from .theorem_loop import theorem_candidate, theorem_loop


@dataclass(frozen=True)
class Verdict:
    """What is known of V' under a law.

    Attributes
    ----------
    status : str
        ``"proved"``: V' <= -e^T KD e; ``"bounded"``: V' <= -e^T KD e + a bounded term;
        ``"refuted"``: the running blocks give V' > 0 at `point`, however far from the
        truth; ``"open"``: none of these is known.
    for_every_N : bool
        Whether it is proved for every number of basis functions.
    residual : sympy.Expr
        V' + e^T KD e, multiplied out.
    point : Point or None
        Where V' > 0: ``diagram.dynamics(*point)`` and ``diagram.output(*point)``.
    rate : float or None
        V' there, length squared per time.
    reached : str
        For ``"bounded"``: the set that V comes to, or the mean square of e.
    steps : tuple of Step
        What was tried.
    diagram : Diagram
        The closed loop that was judged, V its last output.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> from clpt_control.blocks.adaptation import LearnedFlowParameters, adaptation
    >>> wrong = adaptation(LearnedFlowParameters(N=1, gain=-0.5))
    >>> verdict = clpt.theory.prove(wrong, points=200)
    >>> verdict.status, verdict.rate > 0
    ('refuted', True)
    """

    status: str
    for_every_N: bool
    residual: sympy.Expr
    point: Point | None
    rate: float | None
    reached: str
    steps: tuple[Step, ...]
    diagram: Diagram


def prove(law_block: Block, V: Block | None = None, points: int = 10_000, seed: int = 0) -> Verdict:
    """Judge an adaptive law by V' along the closed loop.

    Parameters
    ----------
    law_block : Block
        With outputs alpha[2N], K[2], Gamma[2] and inputs among the diagram's ports, such
        as e[2], phi_x[N], z[2], zc[2].
    V : Block, optional
        A candidate with the output V[1]; by default Eq. (24), each error weighed by the
        gain with which the law adapts it.
    points : int, optional
        Random points at which the running blocks are called.
    seed : int, optional
        Of the random points.

    Returns
    -------
    Verdict
        A proof, a bound, a point where V' > 0, or what is left over.

    Raises
    ------
    DiagramError
        If the law does not make alpha[2N], K[2] and Gamma[2].
    BlockError
        If its equations cannot be read.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> from clpt_control.blocks.adaptation import LearnedFlowParameters, adaptation
    >>> clpt.theory.prove(adaptation(LearnedFlowParameters(N=2, gain=0.5)), points=200).status
    'proved'
    """
    for block in (law_block, *(() if V is None else (V,))):
        if not isinstance(block, Block):
            raise DiagramError(f"{block!r} is a {type(block).__name__}: give a Block")
    if V is not None and V.output_ports != {"V": 1}:
        raise DiagramError(f"{V.name}: a candidate makes V[1] and nothing else")
    N = _functions(law_block)
    diagram = theorem_loop(N, "learned-flow", law_block=law_block, candidate=V)
    try:
        return _judged(diagram, law_block, V, N, points, seed)
    except ClptError:
        raise
    except Exception as error:  # whatever SymPy says of these equations
        kind = type(error).__name__
        raise DiagramError(f"{law_block.name}: V' cannot be worked out: {kind}: {error}") from None


def _judged(
    diagram: Diagram, law: Block, V: Block | None, N: int, points: int, seed: int
) -> Verdict:
    candidate, fitted = V, False  # one V that does not fall refutes no law
    gains: list[sympy.Expr] = []
    if candidate is None:
        alone = symbolic_loop(_alone(law))
        own = _values(alone, [law])
        gains, fitted = weights(law, N)
        numbers = [float(gain.subs(own)) for gain in gains]
        parts = (np.reshape(numbers[: 2 * N], (2, N)), *np.split(np.array(numbers[2 * N :]), 2))
        candidate = theorem_candidate(N, "learned-flow", 1.0, parts)
        diagram = theorem_loop(N, "learned-flow", law_block=law, candidate=candidate)
    loop = symbolic_loop(diagram)
    if gains:  # in the names of the whole diagram
        here, there = (_flat(one.parameters[law.name]) for one in (alone, loop))
        gains = [gain.subs(dict(zip(here, there, strict=True))) for gain in gains]
    return _Case(diagram, loop, candidate, law, gains, points, seed).verdict(fitted)


def _flat(parameters: Any) -> list[Any]:
    return [symbol for field in parameters for symbol in np.ravel(np.asarray(field, dtype=object))]


def _functions(law: Block) -> int:
    sizes = law.output_ports
    N = sizes.get("alpha", 0) // 2
    if N < 1 or sizes.get("alpha") != 2 * N or sizes.get("K") != 2 or sizes.get("Gamma") != 2:
        raise DiagramError(
            f"{law.name}: a law makes alpha[2N], K[2] and Gamma[2]; it makes "
            + (", ".join(f"{port}[{size}]" for port, size in sizes.items()) or "nothing")
        )
    if law.input_ports.get("phi_x", N) != N:
        raise DiagramError(f"{law.name}: phi_x has {law.input_ports['phi_x']} signals, N is {N}")
    return N


def _alone(law: Block) -> Diagram:
    return connect([law], external=list(law.input_ports))


def _values(loop: SymbolicLoop, blocks: list[Block]) -> dict[Any, sympy.Rational]:
    """Return each parameter's own number."""
    draw = Draw(blocks, 0)
    own = draw.parameters(kept=tuple(block.name for block in blocks))
    return {
        symbol: sympy.nsimplify(float(value), rational=True)
        for symbol, value in symbol_values(loop, draw, own).items()
    }


def weights(law: Block, N: int) -> tuple[list[sympy.Expr], bool]:
    """Return the gains with which a law adapts alpha, K and Gamma."""
    loop = symbolic_loop(_alone(law))
    values = _values(loop, [law])
    _refuse_no_value(loop, law.name)
    nothing = np.zeros(2 * N, dtype=object)
    e, apart = port_symbols("e", 2, None, (TIME,)), {}
    if {"x", "z"} <= set(loop.inputs):  # e may be written x - z
        apart = dict(zip(loop.inputs["x"], e + loop.inputs["z"], strict=True))
    gains: list[sympy.Expr] = []
    rests: dict[sympy.Expr, sympy.Expr] = {}
    fitted = True
    for port, signal, size in (("alpha", "phi_x", N), ("K", "z", 1), ("Gamma", "zc", 1)):
        with_ = loop.inputs.get(signal, nothing)
        states = loop.states.get(port, nothing[: 2 * size])
        for j, state in enumerate(states):
            i, k = (divmod(j, N)) if port == "alpha" else (j, j)
            product, rate = e[i] * with_[k], sympy.Integer(0)
            if state != 0:
                rate = tidied(loop.rates[port][j].subs(apart))
            factor = _factor(rate, product, set(values)) if product != 0 else product
            number = sympy.sympify(factor).subs(values)
            positive, negative = number.is_positive, number.is_negative
            fitted &= bool(positive or negative or rate == 0)
            gains.append(factor if positive else -factor if negative else sympy.Integer(1))
            rests[state] = sympy.expand(rate - factor * product) / gains[-1]
    rests.pop(sympy.Integer(0), None)
    given = [s for port, symbols in loop.inputs.items() if port != "e" for s in symbols]
    held = {s: sympy.Dummy(real=True) for s in given}
    rests = {s: rest.xreplace(held) for s, rest in rests.items()}
    return gains, fitted and _judged_by_squares(rests, {*values, *held.values()})


def _refuse_no_value(loop: SymbolicLoop, name: str) -> None:
    """Refuse equations that have no value whatever the states are."""
    none = (sympy.zoo, sympy.nan, sympy.oo, -sympy.oo, sympy.I)
    if any(
        one.has(*none)
        for ports in (loop.rates, loop.signals)
        for port in ports.values()
        for one in port
    ):
        raise DiagramError(
            f"{name}: with the parameters as they are its equations have no value"
            + (f" ({loop.gaps[0]})" if loop.gaps else "")
        )


def _judged_by_squares(rests: dict, known: set) -> bool:
    """Return whether a V of squares can judge what a law has beside its gains.

    It cannot where that holds e or time, as gains that change do, or states of the law's
    own, which need not come to every value, or where it weighs the errors in another way.
    """
    if any(rest.free_symbols - set(rests) - known for rest in rests.values()):
        return False
    slopes = {(a, b): sympy.diff(rest, b) for a, rest in rests.items() for b in rests}
    return all(sympy.expand(slope - slopes[b, a]) == 0 for (a, b), slope in slopes.items())


def _factor(rate: sympy.Expr, product: sympy.Expr, parameters: set) -> sympy.Expr:
    terms = (term / product for term in sympy.Add.make_args(rate))
    return sympy.Add(
        *(q for q in terms if not q.atoms(AppliedUndef) and q.free_symbols <= parameters)
    )


def _renamed(expression: sympy.Expr, last: str, new: str) -> sympy.Expr:
    """Return an expression with another last index in the names of its symbols."""
    names = {
        s: sympy.Symbol(s.name.removesuffix(last) + new, **s.assumptions0)
        for s in expression.free_symbols
        if s.name.endswith(last)
    }
    return expression.subs(names)


class _Case:
    """A law with its V, on symbols and running."""

    def __init__(
        self,
        diagram: Diagram,
        loop: SymbolicLoop,
        V: Block,
        law: Block,
        gains: list[sympy.Expr],
        points: int,
        seed: int,
    ):
        self.diagram, self.loop, self.V, self.law = diagram, loop, V, law
        _refuse_no_value(loop, V.name)
        self.points, self.seed = points, seed
        self.blocks = [node for node in diagram.syslist if isinstance(node, Block)]
        names = Draw(self.blocks, 0).names
        self.weights: dict[sympy.Expr, sympy.Expr] = {}
        self.given: dict[str, list[sympy.Expr]] = {}  # V's gains, where they are apart
        at = 0
        for field in ("gain", "gain_K", "gain_Gamma") if gains else ():
            own = list(np.ravel(getattr(loop.parameters[V.name], field)))
            theirs = gains[at : at + len(own)]
            at += len(own)
            self.weights.update(zip(own, theirs, strict=True))
            if own != theirs:
                self.given[names[V.name, field]] = theirs
        hidden = {
            s
            for b in self.blocks
            if b.name not in (law.name, V.name)
            for s in _flat(loop.parameters[b.name])
        }
        self.values = {s: v for s, v in _values(loop, self.blocks).items() if s not in hidden}
        self.moving = {TIME, *(s for port in loop.states.values() for s in port)}
        self.kept: tuple[str, ...] = ()
        self.Vs = loop.signals["V"][0].subs(self.weights)
        self.rate = tidied(loop.derivative(loop.signals["V"][0]).subs(self.weights))
        self.rest = tidied(self.rate - claimed(loop, decay))

    def truth(self) -> dict[Any, sympy.Expr]:
        """Return where each error is zero."""
        p, states = self.loop.parameters, self.loop.states
        true = dict(zip(states["x"], states["z"], strict=True))
        known = (
            ("alpha", -p["true_flow"].theta.ravel()),
            ("K", p["vehicle_controller"].KD),
            ("Gamma", p["vehicle_controller"].GammaD),
        )
        for port, where in known:
            if port in states:
                true |= dict(zip(states[port], where, strict=True))
        return true

    def verdict(self, fitted: bool) -> Verdict:
        """Judge the law; a V that does not fit it refutes nothing."""
        truth = self.truth()
        definite = checked(
            "V is positive definite in e and the parameter errors, at the blocks' own values",
            "exact",
            lambda: positive_definite(self.Vs, list(truth), truth, self.values),
            False,
        )
        total = Step(
            "the equations have a value everywhere",
            not self.loop.gaps,
            "exact",
            self.loop.gaps[0] if self.loop.gaps else "",
            False,
        )
        if self.rest != 0 and tidied(self.rest.subs(self.values)) == 0:
            self.rest, self.given = sympy.Integer(0), {}  # for the values that they have
            self.kept = (self.law.name, self.V.name)
        falls = self.falls(self.rest)
        at = " and the parameters as they are" if self.kept else ""
        claim = f"V' {'=' if self.rest == 0 else '<='} -e^T KD e, N = {self.loop.N}{at}"
        left = "" if self.rest == 0 else f"left over: {short(self.rest)}"
        steps = [definite, total, Step(claim, falls, "exact", left, False)]
        pull = None
        if definite.holds and not falls and self.keeps_decay():
            pull = pulled(self.rate, self.Vs, truth, self.values, self.moving)
        if definite.holds and total.holds and (falls or pull is not None):
            running = self.running()
            steps.append(running)
            if running.holds and falls:
                every = self.every()
                return self.found("proved", [*steps, every], every.holds)
            if running.holds and pull is not None:
                return self.found("bounded", steps, reached=self.reached(pull))
        if definite.holds and fitted:
            kept = (self.law.name, self.V.name)
            point, rate = refuting_point(self.diagram, self.loop, self.rate, kept, self.seed)
            claim = "the running blocks give V' > 0, ten and a hundred times as far off as well"
            detail = "no such point was found" if point is None else f"V' = {rate:.3g}"
            steps.append(Step(claim, point is not None, "counterexample", detail, False))
            if point is not None:
                return self.found("refuted", steps, point=point, rate=rate)
        return self.found("open", steps)

    def keeps_decay(self) -> bool:
        """Return whether V' has -e^T KD e, or more of it."""
        return all(
            sympy.diff(self.rest.subs(self.values), s, 2).is_nonpositive
            for s in self.loop.states["x"]
        )

    def falls(self, rest: sympy.Expr) -> bool:
        """Return whether what V' has beyond -e^T KD e is known not to be positive."""
        apart = self.moving - {TIME} | rest.free_symbols - set(self.values) - {TIME}
        return bool(rest == 0 or nonpositive(rest, apart, self.values))

    def found(
        self,
        status: str,
        steps: list[Step],
        every: bool = False,
        point: Point | None = None,
        rate: float | None = None,
        reached: str = "",
    ) -> Verdict:
        """Put a verdict together."""
        return Verdict(status, every, self.rest, point, rate, reached, tuple(steps), self.diagram)

    def running(self) -> Step:
        """Compare V' with the running blocks."""

        def same() -> tuple[bool, str]:
            wanted = claimed(self.loop, decay) + self.rest
            found = compared(
                self.diagram, self.loop, wanted, self.points, self.seed, self.given, self.kept
            )
            if found.where is not None:
                return False, f"differs by {found.worst:.1e} of V at {found.where}"
            return True, f"{found.points} points, largest difference {found.worst:.0e} of V"

        return checked("the running blocks give the same V'", "sampled", same, False)

    def every(self) -> Step:
        """Read the loop for every N."""

        def holds() -> tuple[bool, str]:
            loop, rest = every_n_residual(self.diagram, decay)
            at = self.values if self.kept else {}
            weights = {**self.weights, **self.every_n_weights()}
            base, term = (tidied(part.subs(weights).subs(at)) for part in rest)
            if loop.gaps:
                return False, loop.gaps[0]
            if self.falls(base) and self.falls(term):
                return True, ""
            return False, f"left over: {short(base)}; summand {short(term)}"

        return checked("the same for every N", "exact", holds)

    def every_n_weights(self) -> dict[sympy.Expr, sympy.Expr]:
        """Return V's gains of the element k, where they are alike for every function."""
        found: dict[sympy.Expr, sympy.Expr] = {}
        if not self.weights:
            return found
        own = np.reshape(self.loop.parameters[self.V.name].gain, (2, -1))
        for row in own if own.shape[1] == self.loop.N else ():
            if row[0] not in self.weights:
                continue
            theirs = [self.weights[symbol] for symbol in row]
            one = len(set(theirs)) == 1
            whole = theirs[0] if one else _renamed(theirs[0], "[1]", "[k]")
            if one or all(_renamed(whole, "[k]", f"[{k + 1}]") == g for k, g in enumerate(theirs)):
                found[_renamed(row[0], "[1]", "[k]")] = whole
        return found

    def reached(self, pull: Any) -> str:
        """Say where a bounded law comes to."""
        push, rate = pull.push.n(4), pull.rate.n(4)
        if rate == 0:
            return f"V' <= -e^T KD e/2 + {push}: in the mean e^T KD e is at most {2 * push}"
        return f"V' <= -{rate} V + {push}: V comes down to {push / rate}"
