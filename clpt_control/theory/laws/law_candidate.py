"""V of an adaptive law on the paper's loop: a diagram with V in x and e = x - z.

    V' = -e^T KD e + residual

The law's numbers and those of V stand in V' exactly; the truth that V contains, theta, KD and
GammaD, is the loop's own symbols.  If the residual is never positive, V falls and e goes to zero as
in Theorem 3.2; where V' pulls V back but for a constant and a disturbance, V is bounded
(`ultimate_bounds`).  With V of another shape in e the decay is -sum KD_i e_i dV/de_i.  For every
number N of functions V', V and the rates of what V does not contain are base + sum_k term(k); each
is judged by its base and its term.
"""

from collections.abc import Mapping
from copy import copy
from dataclasses import replace
from functools import cached_property, partial
from typing import Any

import numpy as np
import sympy
from sympy import Add, Expr, S, Symbol, expand, sympify

from ...base.units import at_least, at_most
from ...engine.model.block import Block
from ...engine.record.scalar_graph import Index
from ...simulation.user_components import functions_of
from ..algebra.every_n import base_and_term, reindexed
from ..algebra.exact import normal_form
from ..algebra.facts import CLIP, has_time
from ..algebra.slopes import degree, slope_in
from ..algebra.sums_of_squares import rising_in, split_dead_zone, squares
from ..proofs.answers import Definite, Fall, Refutation
from ..proofs.conclusions import Condition, Status
from ..proofs.judge import LyapunovCandidate, Verdict
from ..proofs.losses import excess_over
from ..proofs.outside import CLOCK
from ..proofs.point_search import Failure, PointSearch
from ..proofs.rate_as_sum import Ways, of_system
from ..proofs.relations import Relations
from ..proofs.same_as_running import running_step, search_of
from ..proofs.statements import CLPE_GOES, said
from ..proofs.steps import Step, checked, exact
from ..proofs.symbolic_loop import (
    TIME,
    ArrayLoop,
    SymbolicLoop,
    flat,
    refuse_no_value,
    symbolic_loop,
)
from ..proofs.system_candidate import SystemCandidate
from ..proofs.ultimate_bounds import bound_of_V, bounded
from ..proofs.where import NOTHING
from .default_candidate import WEIGHTS, LawV
from .promises import truth_of
from .theorem_loop import (
    ErrorCoordinates,
    decay,
    rate_of_V,
    symbols_of_V,
    theorem_loop,
    theorem_scenario,
    truth_in,
)

HIDDEN = {"flow_x": "the true flow", "V": "V, which is made of the truth"}


class LoopCandidate(LyapunovCandidate):
    """V on the closed loop of a law with N functions: its verdicts have the loop's diagram."""

    known: Mapping[Any, Any] = NOTHING  # symbols of the law -> its numbers

    def __init__(self, loop: SymbolicLoop, N: int, points: int, seed: int):
        self.eq = self.loop = loop
        self.system, self.fixed = loop.diagram, {*loop.values}
        self.N, self.points, self.seed = N, points, seed
        self.sizes = f"N = {N}"  # for which V' is as shown

    def same_as_running(self, *_: Any) -> Step:
        """Return the step that the running blocks have the same V and rates."""
        return running_step(lambda: self.loop, self.points, seed=self.seed)

    def verdict(
        self,
        status: Status,
        claim: str,
        fall: Fall,
        for_every_N: bool = False,
        **fields: Any,
    ) -> Verdict:
        """Return a verdict on the law."""
        if status == "proved":
            of_N = Condition("N", "every N" if for_every_N else self.sizes)
            fields["conditions"] = (*fields["conditions"], of_N)
        rates = {
            port: np.array([sympify(e).xreplace(self.known) for e in values.flat])
            for port, values in self.loop.rates.items()
        }
        return Verdict(
            status,
            claim,
            V=self.at_z(self.V),
            rate=self.at_z(self.rate),
            residual=self.at_z(fall.residual),
            diagram=self.loop.diagram,
            for_every_N=for_every_N,
            equations=replace(self.loop, rates=rates, signals={}),
            **fields,
        )


class LawCandidate(LoopCandidate, SystemCandidate):
    """A law with a V in x and e = x - z: V' is judged as that of a diagram, beyond -e^T KD e."""

    place = "the truth"
    errors = NOTHING, NOTHING  # it is written in e
    sums = NOTHING  # signals are not written in place of their sums

    def __init__(self, law: Block, law_V: LawV, points: int, seed: int):
        N = functions_of(law)
        self.law, self.fitted = law, law_V.fitted
        truth = truth_of(theorem_scenario(N, "learned-flow"))
        self.block = V = law_V.make(truth)
        diagram = theorem_loop(N, "learned-flow", law_block=law, candidate=V)
        loop = symbolic_loop(diagram, jumps=True)
        LoopCandidate.__init__(self, loop, N, points, seed)
        refuse_no_value(loop, V.name)
        self._tie(symbols_of_V(loop, V, law_V.make, (truth, truth_in(loop))), law_V)
        self.numbers = {*self.values}
        self.coordinates = ErrorCoordinates(loop)
        self.e = self.coordinates.e
        self.KD = dict(zip(self.e, truth_in(loop).KD, strict=True))
        self.motion = self.coordinates.motion(self.of_e)
        self.relations = Relations(loop, self.motion)
        self.inputs = [s for port in loop.inputs.values() for s in port.flat]
        of_V = f"{V.name}."  # a V that leaves the range of numbers is a V
        self.undefined = [
            s
            for s in loop.undefined
            if not (s.startswith(of_V) and s.endswith("large"))
        ]
        self.V = self.of_e(loop.signals["V"][0])
        self.claim, self.level_values = None, {}
        self.rate = normal_form(self._rate_of_V())
        self._read_decay()

    def _tie(self, tied: dict[Expr, Expr], law_V: LawV) -> None:
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

    def of_e(self, expression: Expr) -> Expr:
        """Return an expression in x and e, with the numbers of the law and of V."""
        e = sympify(expression).xreplace(self.known)
        return e.xreplace(self.coordinates.in_e)

    def at_z(self, expression: Expr) -> Expr:
        """Return an expression in the states of the loop."""
        return expression.xreplace(self.coordinates.in_x)

    def with_rate(self, claim: str) -> str:
        """Return a claim: V' of a law is long."""
        return claim

    # --- V' -------------------------------------------------------------------------------------

    def _read_decay(self) -> None:
        """Set the decay of V by e alone, -sum KD_i e_i dV/de_i, and the zones where V is flat.

        It is not positive where V rises with each |e_i| beyond its zone.
        """
        self.zones, V_of_e = [], self.V
        for e in self.e:
            zone, V_of_e = split_dead_zone(V_of_e, e)
            self.zones.append(zone)
        slopes = [slope_in(V_of_e, e) for e in self.e]
        self.rises = all(
            rising_in(normal_form(e * slope), e)
            for e, slope in zip(self.e, slopes, strict=True)
        )
        gains = [*zip(self.KD.values(), self.e, self.zones, strict=True)]
        lost = (k * e * slope_in(self.V, e) for k, e, _ in gains)
        self.decay = -normal_form(Add(*lost))
        squares = (
            k * e * (e - CLIP(e, -zone, zone) if zone else e) for k, e, zone in gains
        )
        self.decay_text = "D^T KD e" if any(self.zones) else "e^T KD e"
        if normal_form(self.decay + Add(*squares)) != 0:
            self.decay_text = "sum KD_i e_i dV/de_i"

    def falls(self, definite: Definite) -> Fall:
        """Return what is shown of V': it falls, or e comes to a set."""
        residual, holds, text = self._below_decay()
        below = said(f"V' {'=' if residual == 0 else '<='} `-{text}`")
        detail = said("left over: {}", self.at_z(residual)) if residual != 0 else ""
        detail = detail if self.rises else "V is not known to rise with |e|"
        claim = said("{}, {} and the parameters as they are", below, self.sizes)
        step = exact(claim, holds, "" if holds else detail, "falls loses")
        fall = Fall([step], below, self.e, said(f"`{text}`"), CLPE_GOES)
        if holds and any(self.zones):
            fall = self._comes_to_zones(text)
        fall.residual = residual
        fall.conditions += self.conditions([])
        return fall

    def bounds(self, definite: Definite, fall: Fall) -> Fall:
        """Return the set that V comes to under a disturbance; `fall` if none is known."""
        if definite.least is None or any(self.zones):
            return fall
        bound = bound_of_V(self.disturbed(), definite)
        if bound is None:
            return fall
        bound.residual = fall.residual
        bound.conditions += self.conditions([])
        return bound

    def every_N(self, definite: Definite, fall: Fall) -> Step | None:
        """Return the step that V' falls so for every number of functions."""
        if not fall.losses or any(self.zones):
            return None
        check = partial(holds_for_every_N, self, definite, fall)
        return replace(checked("the same for every N", check), needed=False)

    def conditions(self, zeroed: list[str]) -> list[Condition]:
        """Return where V' is as shown."""
        conditions = [Condition("t >= 0")] * has_time(self.V, self.rate)
        read = [why for port, why in HIDDEN.items() if port in self.law.input_ports]
        conditions += [Condition("reads the truth", why) for why in read]
        return conditions + [Condition("rounding")] * self.is_rounded

    def _below_decay(self) -> tuple[Expr, bool, str]:
        """Return what V' has beyond its decay, or half of it, if that falls, and the decay."""
        residual = excess_over(self.rate, self.decay)
        for share, ending in ((S.Zero, ""), (S.Half, "/2")):
            above = residual + share * self.decay
            if self.rises and self.never_positive(above):
                return above, True, self.decay_text + ending
        return residual, False, self.decay_text

    def _comes_to_zones(self, decay: str) -> Fall:
        """Return the zones that e comes to, outside of which V falls.

        As e_i dV/de_i > 0 there, (Delta_i - KD_i e_i) dV/de_i <= 0 where |Delta_i| <= zone KD_i.
        """
        half = "/2" * decay.endswith("/2")
        zones = [*enumerate(map(float, self.zones), 1)]
        below = " and ".join(
            f"`|Delta_{i}| <= {at_least(zone)} KD_{i}{half}`" for i, zone in zones
        )
        ends = " and ".join(f"`|e_{i}|` comes to {at_most(zone)}" for i, zone in zones)
        where = [] if self.reads_flow else [Condition("truth", said(below))]
        most = f"-D^T KD D{half}" if decay.startswith("D^T") else "0"
        claim = said(f"V' <= `{most if where else f'-{decay}'}`")
        fields = {"losses": self.e, "of": said(ends), "conditions": where}
        return bounded(claim, "zone falls", **fields)

    @property
    def reads_flow(self) -> bool:
        """True if the law or V reads the flow: a disturbance adds more than e^T Delta to V'."""
        return "flow_x" in {*self.law.input_ports, *self.block.input_ports}

    def disturbed(self) -> "LawCandidate":
        """Return the law with a disturbance in x' and e', unless law or V would read it."""
        if self.reads_flow:
            return self
        other, x = copy(self), self.coordinates.x
        other.disturbances = [
            f(TIME) for f in sympy.symbols("Delta_1:3", cls=sympy.Function)
        ]
        pushed = dict(zip([*x, *self.e], 2 * other.disturbances, strict=True))
        other.motion = {s: r + pushed.get(s, 0) for s, r in self.motion.items()}
        other.rate = normal_form(other._rate_of_V())
        return other

    def ways(self, definite: Definite, fall: Fall) -> Ways:
        """Return the ways to write V' as a sum; where V is pulled back a disturbance pushes e."""
        candidate = self if fall.level is None else self.disturbed()
        return of_system(candidate, definite, fall)

    # --- what refutes ---------------------------------------------------------------------------

    @cached_property
    def search(self) -> PointSearch:
        """Random points about the truth, x that of z."""
        x, z = self.coordinates.x, self.coordinates.z
        rest = dict(zip(x, z, strict=True)) | self._true_states()
        return search_of(self.loop, rest, self.seed)

    def _true_states(self) -> dict[Any, Expr]:
        """Return states -> their values for true alpha, K and Gamma, where those are known."""
        truth, states = truth_in(self.loop), {*self.loop.motion}
        true = {"alpha": -truth.theta.ravel(), "K": truth.KD, "Gamma": truth.GammaD}
        values = dict.fromkeys(self.e, S.Zero)
        for port, numbers in true.items():
            outputs = self.loop.signals[port].flat
            for output, number in zip(outputs, numbers, strict=True):
                error = expand(self.of_e(output).xreplace(values) - number)
                moving = [*error.free_symbols & states]
                slope = sympy.diff(error, moving[0]) if len(moving) == 1 else error
                if slope.is_nonzero and not slope.has(*states):
                    values[moving[0]] = expand(moving[0] - error / slope)
        return {s: value for s, value in values.items() if s not in self.e}

    def _rises(self) -> Failure | None:
        """Return a point at which V' > 0 however far off, if V is of the law."""
        fixed = {s for s in self.search.states if s not in self.search.rest}
        rate = self.at_z(self.rate)
        return self.search.rises_far_off(rate, fixed) if self.fitted else None

    def _no_least(self) -> Failure | None:
        """Return a point at which V is below V at the truth."""
        V = self.at_z(self.V)
        return self.search.sign_at(V - V.xreplace(self.search.rest), -1)

    def refuted_at_jump(self, rise: Expr) -> Refutation | None:
        """Return a point at which V of the running blocks rises at a jump, however far off."""
        jump = self.search.rising_jump() if self.fitted else None
        if jump is None:
            return None
        before, after, size = jump
        claim = f"V rises at a jump by {size:.3g}, ten and a hundred times as far off"
        return Refutation(claim, exact(claim, False), before, None, after)

    def rises_at_jumps(self) -> list[Expr]:
        """Return by how much V rises at each set of jumps."""
        V = self.at_z(self.V)
        if V.has(*self.inputs):  # they may jump as well
            return [Symbol("jump_of_V", real=True)]
        after = self.loop.jumps_at_once()
        return [normal_form(self.of_e(V.xreplace(jump) - V)) for jump in after]


# --- for every N ------------------------------------------------------------------------------


def holds_for_every_N(
    law: LawCandidate, definite: Definite, fall: Fall
) -> tuple[bool, str]:
    """Return whether V' of a `LawCandidate` is as shown for every N, and what is left over."""
    loop = ArrayLoop(law.loop.diagram, substitute=partial(_of_every_N, law))
    residual = normal_form(loop.elements.of(rate_of_V(loop) - decay(loop)))
    if loop.undefined:
        return False, loop.undefined[0]
    V = loop.elements.of(loop.signals["V"][0])
    if not all(squares(summand, law.fixed) for summand in base_and_term(V)):
        return False, "V is not known to be definite"
    # what no equation reads exists as long as what drives it
    ports = [port for port in _outside_V(law, definite) if port in loop.states]
    rates = {port: loop.elements.of(loop.rates[port]) for port in ports}
    states = {port: loop.elements.of(loop.states[port]) for port in ports}
    if faster := faster_than(1, rates, states):
        return False, said("{} may grow faster than linearly", faster)
    of_e = {"e'": loop.elements.of(loop.derivative(loop.signals["e"]))}
    states["t"] = np.array([TIME])
    if faster := faster_than(0, of_e, states):
        return False, said("{} is not known to be bounded", faster)
    base, term = summands = [
        normal_form(summand) for summand in base_and_term(residual)
    ]
    # for all gains, or for those that it has
    every_gain: dict[Any, Any] = {}
    for values in (every_gain, law.values):
        if all(law.never_positive(summand.xreplace(values)) for summand in summands):
            return True, ""
    return False, said("left over: {}; summand {}", base, term)


def _outside_V(law: LawCandidate, definite: Definite) -> list[str]:
    """Return the ports of states that V need not contain."""
    in_V = set().union(*(form.free_symbols for form in definite.forms))
    in_V |= {*law.loop.states["z"], *law.loop.states["x"]}
    states = law.loop.states
    return [port for port in states if {*states[port].flat} - in_V]


def _of_every_N(law: LawCandidate, symbol: Expr, index: Index) -> Expr:
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


def faster_than(
    power: int, rates: Mapping[str, np.ndarray], states: Mapping[str, np.ndarray]
) -> str:
    """Return which rate may grow with a higher power of the states, and its value; or ""."""
    elements = [s for symbols in states.values() for s in np.ravel(symbols)]
    names = {str(s).split("[")[0] for s in elements}

    def is_state(symbol: Symbol) -> bool:
        return str(symbol).split("[")[0] in names  # m[k] is one of m[j]

    for port, values in rates.items():
        for rate in np.ravel(values):
            if degree(sympify(rate).xreplace({TIME: CLOCK}), is_state) > power:
                return said("{} = {}", port, sympify(rate))
    return ""
