"""V of an adaptive law on the paper's loop: it falls, is bounded, or is refuted.

    V' = -e^T KD e + residual

If the residual of V' is never positive, V falls and e goes to zero as in Theorem 3.2; where it
pulls back but for a constant, V is bounded (`ultimate_bounds`).  The law's numbers and those of V
stand in V' exactly; the truth that V contains, theta, KD and GammaD, is the loop's own symbols.
With V of another shape in e the fall is -sum KD_i e_i dV/de_i.  States are x and e, z = x - e.
"""

from dataclasses import replace
from functools import cached_property, partial
from typing import Any

import numpy as np
import sympy
from sympy.core.function import AppliedUndef

from ...base.units import at_least, at_most
from ...engine.model.block import Block
from ...simulation.user_components import functions_of
from ..algebra.exact import as_factors, normal_form, vanishes
from ..algebra.facts import CLIP, SIGN, has_time
from ..algebra.slopes import along
from ..algebra.sums_of_squares import dead_zone, rising_in
from ..algebra.texts import short
from ..proofs.certificates import Ways
from ..proofs.conclusions import Condition, Status
from ..proofs.judge import Candidate, Fall, Refutation, Verdict
from ..proofs.point_search import PointSearch
from ..proofs.same_as_running import running_step, search_of
from ..proofs.steps import Step, checked, exact
from ..proofs.symbolic_loop import (
    TIME,
    SymbolicLoop,
    flat,
    refuse_no_value,
    symbolic_loop,
)
from ..proofs.ultimate_bounds import Bounding, bounded
from .default_candidate import WEIGHTS, LawV
from .law_certificates import of_law
from .law_for_every_n import holds_for_every_N
from .promises import truth_of
from .theorem_loop import (
    ErrorCoordinates,
    rate_of_V,
    symbols_of_V,
    theorem_loop,
    theorem_scenario,
    truth_in,
)

HIDDEN = {"flow_x": "the true flow", "V": "V, which is made of the truth"}


class LoopCandidate(Candidate):
    """V on the loop of a law."""

    loop: SymbolicLoop
    points: int
    seed: int
    residual: sympy.Expr  # V' less its fall
    sizes: str  # numbers of functions for which V' is as shown: N = 2
    for_every_N = False

    def same_as_running(self) -> Step:
        """Return the step that the running blocks have the same V and rates."""
        return running_step(lambda: self.loop, self.points, seed=self.seed)

    def at_z(self, expression: sympy.Expr) -> sympy.Expr:
        """Return an expression in the states of the loop."""
        return expression

    def verdict(self, status: Status, claim: str, **fields: Any) -> Verdict:
        """Return a verdict on the law."""
        if status == "proved":
            of_N = Condition("N", "every N" if self.for_every_N else self.sizes)
            fields["conditions"] = (*fields["conditions"], of_N)
        return Verdict(
            status,
            claim,
            V=self.at_z(self.V),
            rate=self.at_z(self.rate),
            residual=self.at_z(self.residual),
            diagram=self.loop.diagram,
            for_every_N=self.for_every_N and status == "proved",
            **fields,
        )


class LawCandidate(LoopCandidate):
    """A law with its V, on symbols and running, and what is asked of them."""

    def __init__(self, law: Block, law_V: LawV, points: int, seed: int):
        self.N = N = functions_of(law)
        truth = truth_of(theorem_scenario(N, "learned-flow"))
        V = law_V.make(truth)
        diagram = theorem_loop(N, "learned-flow", law_block=law, candidate=V)
        self.eq = self.loop = loop = symbolic_loop(diagram, jumps=True)
        self.block, self.law, self.fitted = V, law, law_V.fitted
        self.points, self.seed = points, seed
        refuse_no_value(loop, V.name)
        self.sizes = f"N = {N}"
        self._tie(symbols_of_V(loop, V, law_V.make, (truth, truth_in(loop))), law_V)
        self.fixed, self.numbers = {*loop.values}, {*self.values}
        self.coordinates = ErrorCoordinates(loop)
        self.e = self.coordinates.e
        self.motion = self.coordinates.motion(self.of_e)
        self.moving_symbols = {TIME, *self.motion}
        of_V = f"{V.name}."  # a V that leaves the range of numbers is a V
        self.undefined = [
            s
            for s in loop.undefined
            if not (s.startswith(of_V) and s.endswith("large"))
        ]
        self.V = self.of_e(loop.signals["V"][0])
        self.zones, self.V_of_e = [], self.V
        for e in self.e:
            zone, self.V_of_e = dead_zone(self.V_of_e, e)
            self.zones.append(zone)
        self.rate = normal_form(self.of_e(rate_of_V(loop)))
        self.residual = self._residual()

    def _tie(self, tied: dict[Any, Any], law_V: LawV) -> None:
        """Set what symbols are: numbers of the law and of V, but not of the truth."""
        p = self.loop.parameters[self.block.name]
        if law_V.gains is not None:
            weights = law_V.gains(flat(self.loop.parameters[self.law.name]))
            fields = [getattr(p, field) for field in WEIGHTS if field in p._fields]
            tied |= zip(flat(fields), weights, strict=True)
        tied = {s: e for s, e in tied.items() if s != e}
        self.values = self.loop.numbers_of(self.law.name, self.block.name)
        self.known = self.values | {s: e.xreplace(self.values) for s, e in tied.items()}
        self.of_V = {s: v for s, v in self.values.items() if s in {*flat(p)}} | tied

    def of_e(self, expression: sympy.Expr) -> sympy.Expr:
        """Return an expression in x and e, with the numbers of the law and of V."""
        return (
            sympy.sympify(expression)
            .xreplace(self.known)
            .xreplace(self.coordinates.in_e)
        )

    def _residual(self) -> sympy.Expr:
        """Return V' less its fall."""
        remainder = normal_form(self.rate - self.fall_of_e)
        sizes = {a: a.args[0] * SIGN(*a.args) for a in remainder.atoms(sympy.Abs)}
        has_powers = remainder.atoms(sympy.Pow)
        divisors = [p.base for p in has_powers if p.exp.is_negative]
        if sympy.Tuple(*divisors).has(TIME):  # gains of time, which may cancel
            remainder = as_factors(remainder)
        return (
            sympy.S.Zero
            if has_powers and vanishes(remainder.xreplace(sizes))
            else remainder
        )

    # --- the truth ------------------------------------------------------------------------------

    @property
    def KD(self) -> np.ndarray:
        """The gains of the vehicle, as symbols."""
        return self.loop.parameters["vehicle_controller"].KD

    @cached_property
    def fall_of_e(self) -> sympy.Expr:
        """-sum KD_i e_i dV/de_i, which is -e^T KD e where V contains |e|^2/2."""
        pairs = zip(self.KD, self.e, strict=True)
        terms = [k * e * along(self.V, {e: sympy.S.One}) for k, e in pairs]
        return -normal_form(sympy.Add(*terms))

    @cached_property
    def truth(self) -> dict[Any, sympy.Expr]:
        """Values of states at which CLPE and each parameter's error is zero, where one is known."""
        truth, states = truth_in(self.loop), {*self.loop.motion}
        true = {"alpha": -truth.theta.ravel(), "K": truth.KD, "Gamma": truth.GammaD}
        values = dict.fromkeys(self.e, sympy.S.Zero)
        for port, numbers in true.items():
            for output, number in zip(
                self.loop.signals[port].flat, numbers, strict=True
            ):
                error = sympy.expand(self.of_e(output).xreplace(values) - number)
                moving = [*error.free_symbols & states]
                slope = sympy.diff(error, moving[0]) if len(moving) == 1 else error
                if slope.is_nonzero and not slope.has(*states):
                    values[moving[0]] = sympy.expand(moving[0] - error / slope)
        return values

    def takes_delta(self) -> bool:
        """Return whether a disturbance adds (dV/de)^T Delta to V' and nothing else."""
        return "flow_x" not in {*self.law.input_ports, *self.block.input_ports}

    def has_decay(self) -> bool:
        """Return whether V' has -e^T KD e, or more of it."""
        residual = self.residual
        if any(call.has(*self.e) for call in residual.atoms(AppliedUndef)):
            # how it bends is not known
            return False
        return all(sympy.diff(residual, e, 2).is_nonpositive for e in self.e)

    @cached_property
    def search(self) -> PointSearch:
        """Random points about the truth."""
        return search_of(self.loop, self.rest_of_states, self.seed)

    @property
    def rest_of_states(self) -> dict[Any, sympy.Expr]:
        """The truth of the states of the loop, x that of z."""
        x, z = self.loop.states["x"], self.loop.states["z"]
        learned = {s: v for s, v in self.truth.items() if s not in self.e}
        return dict(zip(x, z, strict=True)) | learned

    def at_z(self, expression: sympy.Expr) -> sympy.Expr:
        """Return an expression in the states of the loop."""
        return expression.xreplace(self.coordinates.in_x)

    # --- the questions --------------------------------------------------------------------------

    def fall(self) -> Fall:
        """Return what is shown of V': it falls, or V or e comes to a set."""
        falls, text = self._falls()
        below = f"V' {'=' if self.residual == 0 else '<='} {text}"
        detail = f"left over: {short(self.at_z(self.residual))}" * (self.residual != 0)
        detail = detail if self.rises else "V is not known to rise with |e|"
        sizes = f"{self.sizes} and the parameters as they are"
        shows = "falls loses" * (not any(self.zones))
        step = exact(f"{below}, {sizes}", falls, "" if falls else detail, shows)
        fall = None
        if falls and any(self.zones):
            fall = self._comes_to_zones(text)
        elif self.least is not None and not (falls or any(self.zones)):
            fall = Bounding(self).bound()
        if fall is None:
            fall = Fall([step], below, self.e, text.lstrip("-"), "CLPE goes")
            if falls:
                every_N = checked(
                    "the same for every N", partial(holds_for_every_N, self)
                )
                self.for_every_N = every_N.holds
                fall.remarks = [replace(every_N, needed=False)]
        read = [why for port, why in HIDDEN.items() if port in self.law.input_ports]
        if has_time(self.V, self.rate):
            fall.conditions.append(Condition("t >= 0"))
        fall.conditions += [Condition("reads the truth", why) for why in read]
        return fall

    def ways(self, fall: Fall) -> Ways:
        """Return the ways to write V' as a sum, for a certificate."""
        return of_law(self)

    def rises_at_jumps(self) -> list[sympy.Expr]:
        """Return by how much V rises at each set of jumps."""
        V = self.at_z(self.V)
        if V.atoms(AppliedUndef):  # it may depend on inputs, which may jump as well
            return [sympy.Symbol("jump_of_V", real=True)]
        return [
            normal_form(self.of_e(V.xreplace(after) - V))
            for after in self.loop.jumps_at_once()
        ]

    # --- V' -------------------------------------------------------------------------------------

    @cached_property
    def rises(self) -> bool:
        """True if V rises with each |e_i|, beyond its zone, so that its fall is one."""
        slopes = {e: along(self.V_of_e, {e: sympy.S.One}) for e in self.e}
        return all(rising_in(normal_form(e * slope), e) for e, slope in slopes.items())

    def _falls(self) -> tuple[bool, str]:
        """Return whether V' less its fall, or half of it, is never positive, and the fall."""
        beyond = [
            e * (e - CLIP(e, -zone, zone) if zone else e)
            for e, zone in zip(self.e, self.zones, strict=True)
        ]
        pairs = zip(self.KD, beyond, strict=True)
        squares = sympy.Add(*(k * square for k, square in pairs))
        fall = "-D^T KD e" if any(self.zones) else "-e^T KD e"
        if normal_form(self.fall_of_e + squares) != 0:
            fall = "-sum KD_i e_i dV/de_i"
        if not self.rises:
            return False, fall
        for text, share in (("", sympy.S.Zero), ("/2", sympy.S.Half)):
            residual = self.residual + share * self.fall_of_e
            if self.never_positive(residual):
                self.residual = residual
                return True, fall + text
        return False, fall

    def _comes_to_zones(self, fall: str) -> Fall:
        """Return the zones that e comes to, outside of which V falls.

        As e_i dV/de_i > 0 there, (Delta_i - KD_i e_i) dV/de_i <= 0 where |Delta_i| <= zone KD_i.
        """
        zones = [at_least(float(zone)) for zone in self.zones]
        most_of = [at_most(float(zone)) for zone in self.zones]
        suffix = "/2" * fall.endswith("/2")
        below = " and ".join(
            f"|Delta_{i}| <= {d} KD_{i}{suffix}" for i, d in enumerate(zones, 1)
        )
        most = f"-D^T KD D{suffix}" if fall.startswith("-D^T") else "0"
        ends = " and ".join(f"|e_{i}| comes to {d}" for i, d in enumerate(most_of, 1))
        where = [Condition("truth", below)] if self.takes_delta() else []
        claim = f"V' <= {most if where else fall}"
        fields = {"losses": self.e, "of": ends, "conditions": where}
        return bounded(claim, "zone falls", **fields)

    # --- what refutes, and what is said ---------------------------------------------------------

    def refuted(self, steps: list[Step]) -> Refutation | None:
        """Return a point at which V' > 0 however far off, or V is below V at the truth."""
        V, rest_state = self.at_z(self.V), self.rest_of_states
        if not steps[1].holds:
            below = self.search.below_rest(V - V.xreplace(rest_state))
            if below is None:
                return None
            claim = f"V is {-below[1]:.3g} below its value at the truth at `point`"
            step = Step(claim, True, "counterexample", every_N=False)
            return Refutation(claim, step, *below)
        if not self.fitted:
            return None
        fixed = {s for s in self.search.states if s not in self.search.rest}
        rise = self.search.rises_far_off(self.at_z(self.rate), fixed)
        claim = (
            "the running blocks give V' > 0, ten and a hundred times as far off as well"
        )
        if rise is None:
            steps.append(
                Step(claim, False, "counterexample", "no such point was found", False)
            )
            return None
        detail = f"V' = {rise[1]:.3g}"
        step = Step(claim, True, "counterexample", detail, False)
        return Refutation(f"{detail} at `point`", step, *rise)

    def refuted_at_jump(self, rise: sympy.Expr) -> Refutation | None:
        """Return a point at which V of the running blocks rises at a jump, however far off."""
        jump = self.search.rising_jump() if self.fitted else None
        if jump is None:
            return None
        before, after, size = jump
        claim = (
            "the running blocks' V rises at a jump, ten and a hundred times as far off"
        )
        step = Step(claim, True, "counterexample", f"by {size:.3g}", False)
        return Refutation(claim, step, before, None, after)
