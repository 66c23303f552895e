"""A law with its V on symbols and running, and what can be asked of them.

`verdict` puts the answers together.
"""

from functools import cached_property
from typing import Any

import numpy as np
import sympy
from sympy.core.function import AppliedUndef

from ...diagrams.interconnection import Diagram
from ...equations.block import Block
from ...equations.elements import Index
from ...equations.every_n import base_and_term, renamed
from ...errors import DiagramError
from .array_loop import TIME, array_loop
from .leaks import Bound, DeadZones, Leaking, delta_bounds, leaks_of, pull_bound
from .proof import Step, checked, exact, short
from .running_rate import running_step
from .signs import faster_than_linear, nonpositive, pulled, tidied
from .symbolic_loop import SymbolicLoop, numeric, own_values, refuse_no_value, symbolic_loop
from .theorem_loop import decay, rate_of_V, theorem_loop

TRIED = 100  # points at which a sign is looked at before it is proved
SMALL = 1e-6  # of the largest value there; less may be rounding


class Case:
    """A law with its V, on symbols and running; V's gains are those of the law, if any."""

    def __init__(
        self,
        diagram: Diagram,
        loop: SymbolicLoop,
        V: Block,
        law: Block,
        gains: list[sympy.Expr],
        fitted: bool,
        points: int,
        seed: int,
    ):
        self.diagram, self.loop, self.V, self.law = diagram, loop, V, law
        refuse_no_value(loop, V.name)
        self.fitted, self.points, self.seed = fitted, points, seed
        self.blocks = [node for node in diagram.syslist if isinstance(node, Block)]
        self.weights: dict[sympy.Expr, sympy.Expr] = {}
        if gains:
            p = loop.parameters[V.name]
            own = [s for field in (p.gain, p.gain_K, p.gain_Gamma) for s in np.ravel(field)]
            self.weights = dict(zip(own, gains, strict=True))
        self.tied = {s: gain for s, gain in self.weights.items() if s != gain}
        hidden = {
            s
            for b in self.blocks
            if b.name not in (law.name, V.name)
            for s in flat(loop.parameters[b.name])
        }
        self.values = {s: v for s, v in own_values(loop, self.blocks).items() if s not in hidden}
        self.moving = {TIME, *loop.motion}
        self.kept: tuple[str, ...] = ()
        self.Vs = loop.signals["V"][0].xreplace(self.weights)
        self.zones = DeadZones(loop, self.Vs, self.values)
        self.rate = tidied(loop.derivative(loop.signals["V"][0]).xreplace(self.weights))
        self.rest = tidied(self.rate - decay(loop))

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
                true |= dict(zip(states[port].flat, where, strict=True))
        return true

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
        said = "".join(self.loop.undefined[:1])
        return exact("the equations have a value everywhere", not said, said)

    def bound(self, truth: dict) -> Bound | None:
        """Return what V comes to where V' pulls back, or where leaks do."""
        at, p = self.values, self.loop.parameters
        KD, disturbed = list(p["vehicle_controller"].KD), self.takes_delta()
        pull = None
        if self.keeps_decay():
            pull = pulled(self.rate, self.Vs, truth, at, self.moving)
        if pull is not None:
            return pull_bound(pull, KD, delta_bounds(disturbed))
        rate, rest, V = (one.xreplace(at) for one in (self.rate, self.rest, self.Vs))
        leaks = leaks_of(rest, truth, self.moving)
        rates = {s: own.xreplace(at) for s, own in self.loop.motion.items()}
        leaking = Leaking(rate, leaks, V, truth, self.moving, rates, KD, disturbed)
        return leaking.bound() if leaks else None

    def takes_delta(self) -> bool:
        """Return whether a disturbance adds e^T Delta to V' and nothing else."""
        loop = self.disturbed
        rate = loop.derivative(loop.signals["V"][0]).xreplace(self.weights)
        delta = zip(loop.signals["e"], loop.inputs["delta"], strict=True)
        return tidied(rate - self.rate - sum(e * d for e, d in delta)) == 0

    def keeps_decay(self) -> bool:
        """Return whether V' has -e^T KD e, or more of it."""
        rest = self.rest.xreplace(self.values)
        x = self.loop.states["x"]
        if any(word.has(*x) for word in rest.atoms(AppliedUndef)):  # how it bends is not known
            return False
        return all(sympy.diff(rest, s, 2).is_nonpositive for s in x)

    def falls(self, rest: sympy.Expr) -> bool:
        """Return whether what V' has beyond -e^T KD e is known not to be positive."""
        apart = self.moving - {TIME} | rest.free_symbols - set(self.values) - {TIME}
        if rest == 0:
            return True
        return not self.positive_somewhere(rest) and nonpositive(rest, apart, self.values)

    def positive_somewhere(self, rest: sympy.Expr) -> bool:
        """Return whether an expression is positive at a point: then no proof is tried."""
        try:
            function, symbols = numeric(rest.xreplace(self.values))
        except DiagramError:
            return False
        random = np.random.default_rng(self.seed)
        drawn = random.standard_normal((len(symbols), TRIED)) * 10 ** random.uniform(-1, 1, TRIED)
        for k, symbol in enumerate(symbols):
            sign = 1 if symbol.is_positive else -1 if symbol.is_negative else 0
            drawn[k] = sign * np.abs(drawn[k]) if sign else drawn[k]
        with np.errstate(all="ignore"):
            found = np.broadcast_to(function(*drawn), TRIED)
        found = found[np.isfinite(found)]
        return bool(found.size and found.max() > SMALL * np.abs(found).max())

    def across_jumps(self) -> Step:
        """Return the step that V does not rise where states jump, whichever jump at once."""

        def no_rise() -> tuple[bool, str]:
            V = self.Vs
            own = (self.loop.parameters[block.name] for block in self.blocks)
            steps = {p.interval for p in own if "interval" in p._fields}
            if V.free_symbols & steps or V.atoms(AppliedUndef):
                return False, "V itself depends on time"
            for after in self.loop.jumps_at_once():
                rise = tidied(V.xreplace(after) - V).xreplace(self.values)
                if not self.falls(rise):
                    return False, f"V changes by {short(rise)}"
            return True, ""

        claim = f"V does not rise where states of {' and '.join(self.loop.jumps)} jump"
        return checked(claim, "exact", no_rise, False)

    @property
    def others(self) -> list[str]:
        """The states that V need not hold: all but e's and what is learned."""
        return [port for port in self.loop.states if port not in ("x", "z", "alpha", "K", "Gamma")]

    def existing(self) -> Step:
        """Return the step that the other states exist for all times."""
        loop = self.loop
        moves = {f"{port}'": loop.rates[port] for port in self.others}
        moves |= {
            f"{s} after a jump": new
            for own in loop.jumps.values()
            for s, new in own.items()
            if any(s in loop.states[port] for port in self.others)
        }
        at = {what: [m.xreplace(self.values) for m in np.ravel(own)] for what, own in moves.items()}
        detail = faster_than_linear(at, {port: loop.states[port] for port in self.others})
        claim = f"{', '.join(self.others)}: not in V, may grow, and exist for all t"
        return exact(claim, not detail, detail)

    def running(self) -> Step:
        """Return the step that the running blocks have the same V'."""

        def read() -> tuple:
            square = sum(e**2 for e in self.loop.signals["e"])  # multiplied out it loses digits
            rest = self.rest.xreplace({sympy.expand(square): square})
            return self.diagram, self.loop, decay(self.loop) + rest

        return running_step(read, self.points, seed=self.seed, tied=self.tied, kept=self.kept)

    def every(self) -> Step:
        """Return the step that the same holds for every N."""

        def holds() -> tuple[bool, str]:
            loop = array_loop(self.diagram, known=self.of_every_N)
            rest = tidied(loop.elements.of(rate_of_V(loop) - decay(loop)))
            if loop.undefined:
                return False, loop.undefined[0]
            read = loop.elements.of
            moves, states = (
                {port: read(own[port]) for port in self.others} for own in (loop.rates, loop.states)
            )
            if faster := faster_than_linear(moves, states):
                return False, faster
            base, term = map(tidied, base_and_term(rest))
            if self.falls(base) and self.falls(term):
                return True, ""
            return False, f"left over: {short(base)}; summand {short(term)}"

        return checked("the same for every N", "exact", holds)

    def of_every_N(self, symbol: sympy.Expr, index: Index) -> sympy.Expr:
        """Return a parameter's element for every N: V's gains are the law's, as for this N."""
        generic = [one for one in index if isinstance(one, str)]
        found = self.weights.get(symbol, symbol)
        if found == symbol and len(generic) == 1:
            names = [{generic[0]: str(k + 1)} for k in range(self.loop.N or 0)]
            theirs = [self.weights.get(renamed(symbol, name), symbol) for name in names]
            each = [_of_function(gain, generic[0]) for gain in theirs[:1]]
            for gain in (*each, *theirs[:1]):  # a gain each, or one for all
                if all(renamed(gain, name) == own for name, own in zip(names, theirs, strict=True)):
                    found = gain
        return found.xreplace(self.values) if self.kept else found


def flat(parameters: Any) -> list[Any]:
    """Return the symbols of a block's parameters, one after the other."""
    return [symbol for field in parameters for symbol in np.ravel(np.asarray(field, dtype=object))]


def _of_function(expression: sympy.Expr, index: str) -> sympy.Expr:
    """Return what an expression of the first function is for another one."""
    names = {
        s: sympy.Symbol(f"{s.name.removesuffix('[1]')}[{index}]", **s.assumptions0)
        for s in expression.free_symbols
        if s.name.endswith("[1]")
    }
    return expression.xreplace(names)
