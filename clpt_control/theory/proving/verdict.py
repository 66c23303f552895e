"""The verdict on an adaptive law: V' along the closed loop with the law in it, judged.

    V' = -e^T KD e + residual

If the residual is never positive, V falls and e goes to zero as in Theorem 3.2.  Where what is
left pulls back but for a constant, V' is bounded.  Else points are looked for at which the
running blocks themselves have V' > 0.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import sympy
from sympy.core.function import AppliedUndef

from ...blocks import Block
from ...diagrams.interconnection import Diagram
from .dead_zones import DeadZones
from .law_gains import own_values, refuse_no_value
from .leaks import Bound, Leaking, delta_bounds, leaks_of, pull_bound
from .lyapunov import claimed, decay, every_n_residual, short
from .proof import Step, checked
from .quadratic_forms import nonpositive, positive_definite, pulled, tidied
from .random_points import Draw, Point
from .refutation import refuting_point
from .running_rate import compared
from .symbolic_loop import TIME, SymbolicLoop, symbolic_loop
from .theorem_loop import theorem_loop


@dataclass(frozen=True)
class Verdict:
    """What is known of V' under a law.

    Attributes
    ----------
    status : str
        ``"proved"``: V' <= -e^T KD e; ``"bounded"``: V' <= -e^T KD e + a bounded term;
        ``"refuted"``: the running blocks give V' > 0 at `point`, however far from the
        truth; ``"open"``: none of these is known. ``"proved between jumps"`` and ``"bounded
        between jumps"`` where states jump, and V is not known not to rise there.
    residual : sympy.Expr
        V' + e^T KD e, multiplied out.
    steps : tuple of Step
        What was tried.
    diagram : Diagram
        The closed loop that was judged, V its last output.
    for_every_N : bool
        Whether it is proved for every number of basis functions.
    point : Point or None
        Where V' > 0: ``diagram.dynamics(*point)`` and ``diagram.output(*point)``.
    rate : float or None
        V' there, length squared per time.
    reached : str
        For ``"bounded"``: the set that V comes to, or the mean square of e.
    level : sympy.Expr or None
        V of that set, where there is one, in theta, KD, GammaD and Delta_1, Delta_2, the largest
        disturbance of each axis.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> from clpt_control.blocks.laws.learned_flow import LearnedFlowParameters, learned_flow_law
    >>> wrong = learned_flow_law(LearnedFlowParameters(N=1, gain=-0.5))
    >>> verdict = clpt.theory.prove(wrong, points=200)
    >>> verdict.status, verdict.rate > 0
    ('refuted', True)
    """

    status: str
    residual: sympy.Expr
    steps: tuple[Step, ...]
    diagram: Diagram
    for_every_N: bool = False
    point: Point | None = None
    rate: float | None = None
    reached: str = ""
    level: sympy.Expr | None = None


class Case:
    """A law with its V, on symbols and running; V's gains are those of the law, if any."""

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
        refuse_no_value(loop, V.name)
        self.points, self.seed = points, seed
        self.blocks = [node for node in diagram.syslist if isinstance(node, Block)]
        names = Draw(self.blocks, 0).names
        self.weights: dict[sympy.Expr, sympy.Expr] = {}
        self.tied: dict[str, list[sympy.Expr]] = {}  # V's gains, where they are apart
        at = 0
        for field in ("gain", "gain_K", "gain_Gamma") if gains else ():
            own = list(np.ravel(getattr(loop.parameters[V.name], field)))
            theirs = gains[at : at + len(own)]
            at += len(own)
            self.weights.update(zip(own, theirs, strict=True))
            if own != theirs:
                self.tied[names[V.name, field]] = theirs
        hidden = {
            s
            for b in self.blocks
            if b.name not in (law.name, V.name)
            for s in flat(loop.parameters[b.name])
        }
        self.values = {s: v for s, v in own_values(loop, self.blocks).items() if s not in hidden}
        self.moving = {TIME, *(s for port in loop.states.values() for s in port)}
        self.kept: tuple[str, ...] = ()
        self.Vs = loop.signals["V"][0].subs(self.weights)
        self.zones = DeadZones(loop, self.Vs, self.values)
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
        zone = self.zones.zone
        if zone is not None:
            return self.beyond_a_zone(truth, f"{float(zone):.4g}")
        definite = checked(
            "V is positive definite in e and the parameter errors, at the blocks' own values",
            "exact",
            lambda: positive_definite(self.Vs, list(truth), truth, self.values),
            False,
        )
        total = self.valued()
        if self.rest != 0 and tidied(self.rest.subs(self.values)) == 0:
            self.rest, self.tied = sympy.Integer(0), {}  # for the values that they have
            self.kept = (self.law.name, self.V.name)
        falls = self.falls(self.rest)
        at = " and the parameters as they are" if self.kept else ""
        claim = f"V' {'=' if self.rest == 0 else '<='} -e^T KD e, N = {self.loop.N}{at}"
        left = "" if self.rest == 0 else f"left over: {short(self.rest)}"
        steps = [definite, total, Step(claim, falls, "exact", left, False)]
        bound = None
        if definite.holds and not falls:
            bound = self.bound(truth)
        if definite.holds and total.holds and (falls or bound is not None):
            running = self.running()
            steps.append(running)
            if running.holds and falls:
                every = self.every()
                return self.found("proved", [*steps, every], for_every_N=every.holds)
            if running.holds and bound is not None:
                steps.append(Step(bound.says, True, "exact", "", False))
                return self.found("bounded", steps, reached=bound.says, level=bound.level)
        if definite.holds and fitted:
            kept = (self.law.name, self.V.name)
            point, rate = refuting_point(self.diagram, self.loop, self.rate, kept, self.seed)
            claim = "the running blocks give V' > 0, ten and a hundred times as far off as well"
            detail = "no such point was found" if point is None else f"V' = {rate:.3g}"
            steps.append(Step(claim, point is not None, "counterexample", detail, False))
            if point is not None:
                return self.found("refuted", steps, point=point, rate=rate)
        return self.found("open", steps)

    def beyond_a_zone(self, truth: dict, zone: str) -> Verdict:
        """Judge a law with a V that has a dead zone."""
        zones = self.zones
        KD = list(self.loop.parameters["vehicle_controller"].KD)
        delta = [self.disturbed.inputs["delta"][i] for i in range(2)]
        self.rest = zones.beyond(self.loop, KD)
        pushed = zones.beyond(self.disturbed, KD)
        kept = (self.law.name, self.V.name)
        steps = [
            Step(
                "V = |D|^2/2 + a positive definite form of the parameter errors, D = e - clip(e)",
                zones.definite(truth),
                "exact",
                "",
                False,
            ),
            self.valued(),
            Step(
                "V' = -D^T KD e + D^T Delta",
                self.rest == 0 and sympy.expand(pushed - sum(map(sympy.Mul, zones.D, delta))) == 0,
                "exact",
                "" if self.rest == 0 else f"left over: {short(self.rest)}",
                False,
            ),
        ]
        if not all(step.holds for step in steps):
            return self.found("open", steps)
        steps.append(
            checked(
                "the running blocks give the same rates and V",
                "sampled",
                lambda: zones.same(self.diagram, self.points, self.seed, kept),
                False,
            )
        )
        if not steps[-1].holds:
            return self.found("open", steps)
        said = (
            f"V' <= -D^T KD D where |Delta_i| <= {zone} KD_i: V never rises, |e_i| comes to {zone}"
        )
        return self.found("bounded", steps, reached=said)

    @cached_property
    def disturbed(self) -> SymbolicLoop:
        """The loop with the disturbance of Eq. (32) as an input."""
        law, V = self.law, self.V
        return symbolic_loop(
            theorem_loop(self.loop.N or 1, "learned-flow", True, law_block=law, candidate=V),
            jumps=True,
        )

    def valued(self) -> Step:
        """Return the step that the equations have a value everywhere."""
        return Step(
            "the equations have a value everywhere",
            not self.loop.undefined,
            "exact",
            self.loop.undefined[0] if self.loop.undefined else "",
            False,
        )

    def bound(self, truth: dict) -> Bound | None:
        """Return what V comes to where V' pulls back, or where leaks do."""
        at, p = self.values, self.loop.parameters
        KD, disturbed = list(p["vehicle_controller"].KD), self.takes_delta()
        pull = None
        if self.keeps_decay():
            pull = pulled(self.rate, self.Vs, truth, at, self.moving)
        if pull is not None:
            return pull_bound(pull, KD, delta_bounds(disturbed))
        rate, rest, V = (one.subs(at) for one in (self.rate, self.rest, self.Vs))
        leaks = leaks_of(rest, truth, self.moving)
        pairs = [
            (s, sympy.sympify(value).subs(at))
            for port, symbols in self.loop.states.items()
            for s, value in zip(symbols, self.loop.rates[port], strict=True)
        ]
        leaking = Leaking(rate, leaks, V, truth, self.moving, dict(pairs), KD, disturbed)
        return leaking.bound() if leaks else None

    def takes_delta(self) -> bool:
        """Return whether a disturbance adds e^T Delta to V' and nothing else."""
        loop = self.disturbed
        rate = loop.derivative(loop.signals["V"][0]).subs(self.weights)
        delta = zip(loop.signals["e"], loop.inputs["delta"], strict=True)
        return tidied(rate - self.rate - sum(e * d for e, d in delta)) == 0

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

    def found(self, status: str, steps: list[Step], **known: Any) -> Verdict:
        """Return a verdict with its residual and diagram; it says what is known of jumps."""
        if self.loop.jumps:
            steps = [*steps, self.across_jumps()]
            if status in ("proved", "bounded") and not steps[-1].holds:
                status = f"{status} between jumps"
        return Verdict(status, self.rest, tuple(steps), self.diagram, **known)

    def across_jumps(self) -> Step:
        """Return the step that V does not rise where states jump, whichever jump at once."""

        def no_rise() -> tuple[bool, str]:
            V = self.Vs
            own = (self.loop.parameters[block.name] for block in self.blocks)
            steps = {p.interval for p in own if "interval" in p._fields}
            if V.free_symbols & steps or V.atoms(AppliedUndef):
                return False, "V itself depends on time"
            for after in self.loop.jumps_at_once():
                rise = tidied(V.subs(after, simultaneous=True) - V).subs(self.values)
                if not self.falls(rise):
                    return False, f"V changes by {short(rise)}"
            return True, ""

        claim = f"V does not rise where states of {' and '.join(self.loop.jumps)} jump"
        return checked(claim, "exact", no_rise, False)

    def running(self) -> Step:
        """Return the step that the running blocks have the same V'."""

        def same() -> tuple[bool, str]:
            square = sum(e**2 for e in self.loop.signals["e"])  # multiplied out it loses digits
            rest = self.rest.xreplace({sympy.expand(square): square})
            wanted = claimed(self.loop, decay) + rest
            found = compared(
                self.diagram, self.loop, wanted, self.points, self.seed, self.tied, self.kept
            )
            if found.where is not None:
                return False, f"differs by {found.worst:.1e} of V at {found.where}"
            return True, f"{found.points} points, largest difference {found.worst:.0e} of V"

        return checked("the running blocks give the same V'", "sampled", same, False)

    def every(self) -> Step:
        """Return the step that the same holds for every N."""

        def holds() -> tuple[bool, str]:
            loop, rest = every_n_residual(self.diagram, decay)
            at = self.values if self.kept else {}
            weights = {**self.weights, **self.every_n_weights()}
            base, term = (tidied(part.subs(weights).subs(at)) for part in rest)
            if loop.undefined:
                return False, loop.undefined[0]
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
            gain = theirs[0] if one else _renamed(theirs[0], "[1]", "[k]")
            if one or all(_renamed(gain, "[k]", f"[{k + 1}]") == g for k, g in enumerate(theirs)):
                found[_renamed(row[0], "[1]", "[k]")] = gain
        return found


def flat(parameters: Any) -> list[Any]:
    """Return the symbols of a block's parameters, one after the other."""
    return [symbol for field in parameters for symbol in np.ravel(np.asarray(field, dtype=object))]


def _renamed(expression: sympy.Expr, last: str, new: str) -> sympy.Expr:
    """Return an expression with another last index in the names of its symbols."""
    names = {
        s: sympy.Symbol(s.name.removesuffix(last) + new, **s.assumptions0)
        for s in expression.free_symbols
        if s.name.endswith(last)
    }
    return expression.subs(names)
