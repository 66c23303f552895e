"""V of an adaptive law on the paper's loop, at the parameters that the law has.

    V' = -e^T KD e + residual

The law's numbers and those of V stand in V' exactly; the truth that V contains, theta, KD and
GammaD, is the loop's own symbols.  With V of another shape in e the fall is -sum KD_i e_i dV/de_i.
If the residual is never positive, V falls and e goes to zero as in Theorem 3.2; where it pulls back
but for a constant, V is bounded (`ultimate_bounds`).
"""

from collections.abc import Mapping
from functools import cached_property
from typing import Any

import numpy as np
import sympy
from sympy.core.function import AppliedUndef

from ...engine.model.block import Block
from ...engine.record.scalar_graph import Index
from .decide import never_positive
from .every_n import base_and_term, reindexed
from .exact import normal_form, vanishes
from .facts import CLIP, SIGN, along, degree, interval
from .judge import Candidate, Fall, Refutation, Verdict
from .same_as_running import running_step, search_of
from .steps import Step, checked, exact, short
from .sums_of_squares import dead_zone, rising_in, zero_of
from .symbolic_loop import TIME, ArrayLoop, SymbolicLoop, flat, refuse_no_value
from .theorem_loop import decay, rate_of_V, truth_in
from .ultimate_bounds import Bound, Bounding

HIDDEN = {"flow_x": "the true flow", "V": "made of the truth"}


class LawCandidate(Candidate):
    """A law with its V, on symbols and running.

    `tied` are V's symbols -> what they are of the truth or of the law; V' > 0 refutes the law only
    where V is `fitted` to it.
    """

    def __init__(
        self,
        loop: SymbolicLoop,
        V: Block,
        law: Block,
        tied: Mapping[Any, sympy.Expr],
        fitted: bool,
        points: int,
        seed: int,
    ):
        self.eq = self.loop = loop
        self.block, self.law, self.fitted = V, law, fitted
        self.points, self.seed = points, seed
        refuse_no_value(loop, V.name)
        self.N = len(loop.inputs["phi_x"])
        self._replace_symbols({s: e for s, e in tied.items() if s != e})
        self.moving = {TIME, *loop.motion}
        self.V = loop.signals["V"][0].xreplace(self.known)
        # e as symbols of their own, x = e + z; a state of the law may be called e_1 as well
        self.e = sympy.symbols("e_1:3", real=True, cls=sympy.Dummy)
        x, z = loop.states["x"], loop.states["z"]
        self.in_e = {a: e + b for a, e, b in zip(x, self.e, z, strict=True)}
        self.in_x = {e: a - b for a, e, b in zip(x, self.e, z, strict=True)}
        self.zones, self.V_of_e = [], self.V.xreplace(self.in_e)
        for e in self.e:
            zone, self.V_of_e = dead_zone(self.V_of_e, e)
            self.zones.append(zone)
        self.rate = normal_form(rate_of_V(loop).xreplace(self.known))
        self.residual = self._residual()
        self.for_every_N = False

    def _replace_symbols(self, tied: dict) -> None:
        """Set what symbols are: numbers of the law and of V, but not of the truth."""
        parameters = self.loop.parameters
        judged = self.law.name, self.block.name
        hidden = {
            s
            for name in parameters
            if name not in judged
            for s in flat(parameters[name])
        }
        self.values = {s: v for s, v in self.loop.values.items() if s not in hidden}
        self.known = self.values | {s: e.xreplace(self.values) for s, e in tied.items()}
        of_V = {*flat(parameters[self.block.name])} & self.values.keys()
        self.of_V = {s: self.values[s] for s in of_V} | tied

    def _residual(self) -> sympy.Expr:
        """Return V' less its fall."""
        remainder = normal_form(self.rate - self.fall_of_e)
        sizes = {a: a.args[0] * SIGN(*a.args) for a in remainder.atoms(sympy.Abs)}
        has_powers = remainder.atoms(sympy.Pow)
        return (
            sympy.S.Zero
            if has_powers and vanishes(remainder.xreplace(sizes))
            else remainder
        )

    # --- the truth ------------------------------------------------------------------------------

    @cached_property
    def fall_of_e(self) -> sympy.Expr:
        """-sum KD_i e_i dV/de_i, which is -e^T KD e where V contains |e|^2/2."""
        KD = self.loop.parameters["vehicle_controller"].KD
        V = self.V.xreplace(self.in_e)
        terms = [
            k * e * along(V, {e: sympy.S.One}) for k, e in zip(KD, self.e, strict=True)
        ]
        return -normal_form(sympy.Add(*terms)).xreplace(self.in_x)

    @cached_property
    def errors(self) -> list[tuple[list[Any], sympy.Expr]]:
        """The states of each learned parameter, and its error, where e = 0."""
        truth, states = truth_in(self.loop), set(self.loop.motion)
        x, z = self.loop.states["x"], self.loop.states["z"]
        true = {"alpha": -truth.theta.ravel(), "K": truth.KD, "Gamma": truth.GammaD}
        substitutions = self.values | dict(zip(x, z, strict=True))
        errors = [
            sympy.expand(output.xreplace(substitutions) - true[port][k])
            for port in true
            for k, output in enumerate(self.loop.signals[port].flat)
        ]
        return [(sorted(e.free_symbols & states, key=str), e) for e in errors]

    @cached_property
    def truth(self) -> dict[Any, sympy.Expr]:
        """Values of states at which each parameter error is zero."""
        truth = dict(zip(self.loop.states["x"], self.loop.states["z"], strict=True))
        for states, error in self.errors:
            if len(states) != 1:
                continue
            slope = sympy.diff(error, *states)
            if slope.is_nonzero and not error.diff(states[0], 2):
                truth[states[0]] = sympy.expand(states[0] - error / slope)
        return truth

    @property
    def learned(self) -> list[Any]:
        """The states of learned parameters, which V has to contain."""
        return list(dict.fromkeys(s for states, _ in self.errors for s in states))

    @property
    def others_in_V(self) -> list[Any]:
        """States of V that are neither the vehicle's, the learner's nor learned."""
        excluded = {*self.learned, *self.loop.states["x"], *self.loop.states["z"]}
        return [s for s in self.loop.motion if s not in excluded and self.V.has(s)]

    # --- the five questions ---------------------------------------------------------------------

    def has_values(self) -> Step:
        """Return the step that the equations have a value everywhere."""
        of_V = f"{self.block.name}."  # a V that leaves the range of numbers is a V
        undefined = [
            s
            for s in self.loop.undefined
            if not (s.startswith(of_V) and s.endswith("large"))
        ]
        claim = "the equations have a value everywhere"
        return exact(claim, not undefined, "".join(undefined[:1]))

    def is_definite(self) -> Step:
        """Return the step that V is positive definite, or so beyond dead zones."""
        measure = "e" if not any(self.zones) else "D = e - clip(e, -d, d)"
        claim = f"V is positive definite in {measure} and the parameter errors"
        claim = f"{claim}, at the blocks' own values"
        step = checked(claim, self._definite, every_N=False)
        self.definite = step.holds
        return step

    def _definite(self) -> bool:
        V = self.V_of_e
        if any(s.name.endswith(".interval") for s in V.free_symbols):
            return False  # V itself may jump
        shifted = {s: s + true for s, true in self.truth.items() if s in self.learned}
        V = normal_form(V.xreplace(shifted))
        states = [*self.e, *self.learned, *self.others_in_V]
        for learned, error in self.errors:
            # alpha = s + s^3: V is least where its error is zero
            if len(learned) != 1 or learned[0] in self.truth:
                continue
            (s,) = learned
            remainder, level = V.as_independent(s, as_Add=True)
            share = sympy.cancel(sympy.diff(level, s) / error)
            rises = interval(sympy.diff(error, s))[0]
            if not (share.is_number and share.is_positive and rises.is_positive):
                return False
            V, states = remainder, [state for state in states if state != s]
        least = zero_of(V, states)
        if least is None:
            return False
        self.truth |= {s: least[s] for s in self.others_in_V}
        return not any(least[s] for s in states if s not in self.others_in_V)

    def fall(self) -> Fall:
        """Return what is shown of V': it falls, or V or e comes to a set."""
        falls, fall = self._falls()
        below = f"V' {'=' if self.residual == 0 else '<='} {fall}"
        detail = "" if self.residual == 0 else f"left over: {short(self.residual)}"
        detail = detail if self.rises else "V is not known to rise with |e|"
        sizes = f"N = {self.N} and the parameters as they are"
        step = exact(f"{below}, {sizes}", falls, "" if falls else detail)
        bound = None
        if falls and any(self.zones):
            bound = self._comes_to_zones(fall)
        elif self.definite and not (falls or any(self.zones)):
            bound = Bounding(self).bound()
        if bound is not None:
            steps = [exact(bound.sentence, True)]
            return Fall(steps, "bounded", bound.sentence, bound.level, self._hidden())
        claim = f"{below}, so CLPE goes to zero"
        return Fall(
            [step],
            claim=claim,
            remarks=[self._every_N(), *self._hidden()] if falls else [],
        )

    def same_as_running(self) -> Step:
        """Return the step that the running blocks have the same V and rates."""
        return running_step(lambda: self.loop, self.points, seed=self.seed)

    def held(self) -> tuple[list[sympy.Expr], dict]:
        """Return the states that V, or e with z, bounds."""
        x, z = self.loop.states["x"], self.loop.states["z"]
        return [*x, *z, *self.learned, *self.others_in_V], self.values

    def rises_at_jumps(self) -> list[sympy.Expr]:
        """Return by how much V rises at each set of jumps."""
        if self.V.atoms(
            AppliedUndef
        ):  # it may depend on inputs, which may jump as well
            return [sympy.Symbol("jump_of_V", real=True)]
        return [
            normal_form((self.V.xreplace(after) - self.V).xreplace(self.values))
            for after in self.loop.jumps_at_once()
        ]

    # --- V' -------------------------------------------------------------------------------------

    def takes_delta(self) -> bool:
        """Return whether a disturbance adds (dV/de)^T Delta to V' and nothing else."""
        return "flow_x" not in {*self.law.input_ports, *self.block.input_ports}

    def has_decay(self) -> bool:
        """Return whether V' has -e^T KD e, or more of it."""
        residual, x = self.residual, self.loop.states["x"]
        if any(call.has(*x) for call in residual.atoms(AppliedUndef)):
            # how it bends is not known
            return False
        return all(sympy.diff(residual, s, 2).is_nonpositive for s in x)

    @cached_property
    def rises(self) -> bool:
        """True if V rises with each |e_i|, beyond its zone, so that its fall is one."""
        slopes = {e: along(self.V_of_e, {e: sympy.S.One}) for e in self.e}
        return all(rising_in(normal_form(e * slope), e) for e, slope in slopes.items())

    def never_positive(self, expression: sympy.Expr) -> bool:
        """Return whether an expression is known never to be positive."""
        expression, e = expression.xreplace(self.in_e), {*self.e}
        z = {*self.loop.states["z"]}
        free_symbols = expression.free_symbols - {TIME, *self.values} - z - e
        return never_positive(expression, {*self.values}, (free_symbols, e, None))

    def _falls(self) -> tuple[bool, str]:
        """Return whether V' less its fall, or half of it, is never positive, and the fall."""
        KD = self.loop.parameters["vehicle_controller"].KD
        beyond = [
            e * (e - CLIP(e, -zone, zone) if zone else e)
            for e, zone in zip(self.e, self.zones, strict=True)
        ]
        squares = sympy.Add(*(k * square for k, square in zip(KD, beyond, strict=True)))
        fall = "-D^T KD e" if any(self.zones) else "-e^T KD e"
        if normal_form(self.fall_of_e.xreplace(self.in_e) + squares) != 0:
            fall = "-sum KD_i e_i dV/de_i"
        if not self.rises:
            return False, fall
        for text, share in (("", sympy.S.Zero), ("/2", sympy.S.Half)):
            residual = self.residual + share * self.fall_of_e
            if self.never_positive(residual):
                self.residual = residual
                return True, fall + text
        return False, fall

    def _comes_to_zones(self, fall: str) -> Bound:
        """Return the zones that e comes to, outside of which V falls.

        As e_i dV/de_i > 0 there, (Delta_i - KD_i e_i) dV/de_i <= 0 where |Delta_i| <= zone KD_i.
        """
        zones = [f"{float(zone):.4g}" for zone in self.zones]
        suffix = "/2" * fall.endswith("/2")
        below = " and ".join(
            f"|Delta_{i}| <= {d} KD_{i}{suffix}" for i, d in enumerate(zones, 1)
        )
        most = f"-D^T KD D{suffix}" if fall.startswith("-D^T") else "0"
        where = f"V' <= {most} where {below}" if self.takes_delta() else f"V' <= {fall}"
        ends = " and ".join(f"|e_{i}| comes to {d}" for i, d in enumerate(zones, 1))
        return Bound(f"{where}: V never rises, {ends}")

    # --- every N --------------------------------------------------------------------------------

    def _every_N(self) -> Step:
        """Return the step that the same holds for every N."""
        step = checked("the same for every N", self._holds_for_every_N)
        self.for_every_N = step.holds
        return step

    def _holds_for_every_N(self) -> tuple[bool, str]:
        loop = ArrayLoop(self.loop.diagram, substitute=self._of_every_N)
        residual = normal_form(loop.elements.of(rate_of_V(loop) - decay(loop)))
        if loop.undefined:
            return False, loop.undefined[0]
        # what no equation reads exists as long as what drives it
        ports = [port for port in self._outside_V() if port in loop.states]
        rates = {port: loop.elements.of(loop.rates[port]) for port in ports}
        states = {port: loop.elements.of(loop.states[port]) for port in ports}
        if faster := faster_than_linear(rates, states):
            return False, faster
        base, term = summands = [
            normal_form(summand) for summand in base_and_term(residual)
        ]
        # for all gains, or for those that it has
        for values in ({}, self.values):
            if all(
                self.never_positive(summand.xreplace(values)) for summand in summands
            ):
                return True, ""
        return False, f"left over: {short(base)}; summand {short(term)}"

    def _outside_V(self) -> list[str]:
        """Return the ports of states that V need not contain."""
        contained = {*self.learned, *self.loop.states["z"]}
        states = self.loop.states
        return [p for p in states if p != "x" and {*states[p].flat} - contained]

    def _of_every_N(self, symbol: sympy.Expr, index: Index) -> sympy.Expr:
        """Return a parameter's element for every N: V's are numbers, the law's or the truth's."""
        generic = [name for name in index if isinstance(name, str)]
        weight = self.of_V.get(symbol, symbol)
        if weight != symbol or len(generic) != 1:
            return weight
        names = [{generic[0]: str(k + 1)} for k in range(self.N)]
        members = [reindexed(symbol, name) for name in names]
        members = [self.of_V.get(s, s) for s in members]
        # one for all, or one each
        for gain in (members[0], reindexed(members[0], {"1": generic[0]})):
            if [reindexed(gain, name) for name in names] == members:
                return gain
        return symbol

    # --- what refutes, and what is said ---------------------------------------------------------

    def _hidden(self) -> list[Step]:
        """Return remarks on signals that no vehicle measures by itself."""
        return [
            exact(
                f"the law reads {port}, {reason}, which no vehicle measures by itself",
                True,
            )
            for port, reason in HIDDEN.items()
            if port in self.law.input_ports
        ]

    def refuted(self, steps: list[Step]) -> Refutation | None:
        """Return a point at which V' > 0 however far off, or V is below V at the truth."""
        self.search = search_of(self.loop, self.truth, self.seed)
        if not steps[1].holds:
            below = self.search.below_rest(self.V - self.V.xreplace(self.truth))
            if below is None:
                return None
            claim = f"V is {-below[1]:.3g} below its value at the truth at `point`"
            step = Step(claim, True, "counterexample", "", False)
            return Refutation(claim, step, *below)
        if not self.fitted:
            return None
        fixed = {s for s in self.search.states if s not in self.search.rest}
        rise = self.search.rises_far_off(self.rate, fixed)
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
        self.search = search_of(self.loop, self.truth, self.seed)
        jump = self.search.rising_jump() if self.fitted else None
        if jump is None:
            return None
        before, after, size = jump
        claim = (
            "the running blocks' V rises at a jump, ten and a hundred times as far off"
        )
        step = Step(claim, True, "counterexample", f"by {size:.3g}", False)
        return Refutation(claim, step, before, None, "refuted at a jump", after)

    def verdict(self, status: str, claim: str, **fields: Any) -> Verdict:
        """Return a verdict on the law."""
        return Verdict(
            status,
            claim,
            self.V,
            self.rate,
            residual=self.residual,
            diagram=self.loop.diagram,
            for_every_N=self.for_every_N and status.startswith("proved"),
            **fields | {"steps": tuple(fields["steps"])},
        )


def faster_than_linear(rates: Mapping[str, Any], states: Mapping[str, Any]) -> str:
    """Return which state may grow faster than linearly in the states, and its rate; or ""."""
    elements = [s for symbols in states.values() for s in np.ravel(symbols)]
    names = {str(s).split("[")[0] for s in elements}

    def is_state(symbol: sympy.Symbol) -> bool:
        return str(symbol).split("[")[0] in names  # m[k] is one of m[j]

    for port, values in rates.items():
        for rate in np.ravel(values):
            if degree(sympy.sympify(rate), is_state) > 1:
                return f"{port} = {short(rate)} may grow faster than linearly"
    return ""
