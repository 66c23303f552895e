"""A law with its V on symbols and running, and the steps of its proof.

A law is judged with the parameters that it has: its numbers and those of V, exact, stand in V'.
What V holds of the truth is the truth's symbols.  `verdict` puts the steps together.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import sympy
from sympy.core.function import AppliedUndef

from ...engine.model.block import Block
from ...engine.record.scalar_graph import Index
from ..squares import least_place, never_positive, states_beside
from .every_n import base_and_term, reindexed
from .facts import CLIP, SIGN, along, degree, interval
from .leaks import Bound
from .proof import Step, checked, exact, short
from .signs import dead_zone, rising_in, tidied, vanishes
from .symbolic_loop import TIME, ArrayLoop, SymbolicLoop, flat, refuse_no_value
from .theorem_loop import decay, rate_of_V, truth_in


@dataclass
class Case:
    """A law with its V, on symbols and running."""

    loop: SymbolicLoop
    V: Block
    law: Block
    # V's symbols -> what they are of the truth's, or of the law's
    tied: dict[Any, sympy.Expr]
    refutes: bool  # whether V' > 0 refutes the law: V was fitted to it
    points: int
    seed: int

    def __post_init__(self) -> None:
        """Read V and V'."""
        loop = self.loop
        refuse_no_value(loop, self.V.name)
        self.N = len(loop.inputs["phi_x"])
        self.tied = {s: truth for s, truth in self.tied.items() if s != truth}
        own = self.law.name, self.V.name
        hidden = {
            s for name, p in loop.parameters.items() if name not in own for s in flat(p)
        }
        self.values = {s: v for s, v in loop.values.items() if s not in hidden}
        self.known = self.values | {
            s: e.xreplace(self.values) for s, e in self.tied.items()
        }
        of_V = self.values.keys() & {*flat(loop.parameters[self.V.name])}
        self.of_V = {s: self.values[s] for s in of_V} | self.tied
        self.moving = {TIME, *loop.motion}
        self.Vs = loop.signals["V"][0].xreplace(self.known)
        # a state of the law may be called e_1 as well
        self.e = sympy.symbols("e_1:3", real=True, cls=sympy.Dummy)
        x, z = loop.states["x"], loop.states["z"]
        # x = e + z
        self.apart = {a: e + b for a, e, b in zip(x, self.e, z, strict=True)}
        self.together = {e: a - b for a, e, b in zip(x, self.e, z, strict=True)}
        self.zones, self.V_of_D = [], self.Vs.xreplace(self.apart)
        for e in self.e:
            zone, self.V_of_D = dead_zone(self.V_of_D, e)
            self.zones.append(zone)
        self.rate = tidied(rate_of_V(loop).xreplace(self.known))
        sums = tidied(self.rate - self.fall)
        signed = sums.xreplace(
            {a: a.args[0] * SIGN(*a.args) for a in sums.atoms(sympy.Abs)}
        )
        self.residual = (
            sympy.S.Zero if sums.atoms(sympy.Pow) and vanishes(signed) else sums
        )

    @cached_property
    def fall(self) -> sympy.Expr:
        """-sum KD_i e_i dV/de_i, which is -e^T KD e where V holds |e|^2/2."""
        KD, V = (
            self.loop.parameters["vehicle_controller"].KD,
            self.Vs.xreplace(self.apart),
        )
        falls = (
            k * e * along(V, {e: sympy.S.One}) for k, e in zip(KD, self.e, strict=True)
        )
        return -tidied(sympy.Add(*falls)).xreplace(self.together)

    @cached_property
    def errors(self) -> list[tuple[list[Any], sympy.Expr]]:
        """The states that make each learned parameter, and its error, where e = 0."""
        ports, states, truth = (
            self.loop.signals,
            set(self.loop.motion),
            truth_in(self.loop),
        )
        x, z = self.loop.states["x"], self.loop.states["z"]
        true = {"alpha": -truth.theta.ravel(), "K": truth.KD, "Gamma": truth.GammaD}
        known = self.values | dict(zip(x, z, strict=True))
        errors = [
            sympy.expand(output.xreplace(known) - true[port][k])
            for port in true
            for k, output in enumerate(ports[port].flat)
        ]
        return [
            (sorted(error.free_symbols & states, key=str), error) for error in errors
        ]

    @cached_property
    def truth(self) -> dict[Any, sympy.Expr]:
        """Where each error is zero, of states that make a learned parameter linearly."""
        true = dict(zip(self.loop.states["x"], self.loop.states["z"], strict=True))
        for of, error in self.errors:
            if (
                len(of) == 1
                and sympy.diff(error, *of).is_nonzero
                and not error.diff(of[0], 2)
            ):
                true[of[0]] = sympy.expand(of[0] - error / sympy.diff(error, *of))
        return true

    @property
    def learned(self) -> list[Any]:
        """The states that make learned parameters, which V has to hold."""
        return list(dict.fromkeys(s for of, _ in self.errors for s in of))

    def definite(self) -> Step:
        """Return the step that V is positive definite, or so beyond dead zones."""
        mapped = {
            of[0]: error
            for of, error in self.errors
            if len(of) == 1 and of[0] not in self.truth
        }
        named = "e" if not any(self.zones) else "D = e - clip(e, -d, d)"

        def holds() -> bool:
            V, states = self.V_of_D, [*self.e, *self.learned, *self.others_in_V]
            if any(s.name.endswith(".interval") for s in V.free_symbols):
                return False  # V itself may jump
            V = tidied(
                V.xreplace({s: s + true for s, true in list(self.truth.items())[2:]})
            )
            for (
                s,
                error,
            ) in mapped.items():  # alpha = s + s^3: V is least where its error is zero
                rest, own = V.as_independent(s, as_Add=True)
                share = sympy.cancel(sympy.diff(own, s) / error)
                rises = interval(sympy.diff(error, s))[0]
                if not (share.is_number and share.is_positive and rises.is_positive):
                    return False
                V, states = rest, [one for one in states if one != s]
            least = least_place(V, states)
            if least is None:
                return False
            self.truth |= {s: least[s] for s in self.others_in_V}
            return not any(least[s] for s in states if s not in self.others_in_V)

        claim = f"V is positive definite in {named} and the parameter errors"
        return checked(f"{claim}, at the blocks' own values", holds, every_N=False)

    @property
    def others_in_V(self) -> list[Any]:
        """States of V that are neither the vehicle's, the learner's nor learned."""
        known = {*self.learned, *self.loop.states["x"], *self.loop.states["z"]}
        return [s for s in self.loop.motion if s not in known and self.Vs.has(s)]

    def valued(self) -> Step:
        """Return the step that the equations have a value everywhere."""
        mine = f"{self.V.name}."  # a V that leaves the range of numbers is a V
        none = (
            s
            for s in self.loop.undefined
            if not (s.startswith(mine) and s.endswith("large"))
        )
        undefined = next(none, "")
        return exact("the equations have a value everywhere", not undefined, undefined)

    def comes_to_zones(self, fall: str) -> Bound:
        """Return the zones that e comes to, outside of which V falls.

        As e_i dV/de_i > 0 there, (Delta_i - KD_i e_i) dV/de_i <= 0 where |Delta_i| <= zone KD_i.
        """
        zones = [f"{float(zone):.4g}" for zone in self.zones]
        half = "/2" * fall.endswith("/2")
        below = " and ".join(
            f"|Delta_{i}| <= {d} KD_{i}{half}" for i, d in enumerate(zones, 1)
        )
        most = f"-D^T KD D{half}" if fall.startswith("-D^T") else "0"
        where = f"V' <= {most} where {below}" if self.takes_delta() else f"V' <= {fall}"
        ends = " and ".join(f"|e_{i}| comes to {d}" for i, d in enumerate(zones, 1))
        return Bound(f"{where}: V never rises, {ends}")

    def takes_delta(self) -> bool:
        """Return whether a disturbance adds (dV/de)^T Delta to V' and nothing else."""
        return "flow_x" not in {*self.law.input_ports, *self.V.input_ports}

    def has_decay(self) -> bool:
        """Return whether V' has -e^T KD e, or more of it."""
        residual, x = self.residual, self.loop.states["x"]
        if any(word.has(*x) for word in residual.atoms(AppliedUndef)):
            # how it bends is not known
            return False
        return all(sympy.diff(residual, s, 2).is_nonpositive for s in x)

    @cached_property
    def rises(self) -> bool:
        """Whether V rises with each |e_i|, beyond its zone, so that its fall is one."""
        V = self.V_of_D
        return all(rising_in(tidied(e * along(V, {e: sympy.S.One})), e) for e in self.e)

    def falls(self, residual: sympy.Expr) -> bool:
        """Return whether what V' has beyond its fall is known not to be positive."""
        residual, e = residual.xreplace(self.apart), {*self.e}
        others = (
            residual.free_symbols - {TIME, *self.values, *self.loop.states["z"]} - e
        )
        return never_positive(residual, {*self.values}, (others, e, None))

    def across_jumps(self) -> Step:
        """Return the step that V does not rise where states jump, whichever jump at once."""

        def no_rise() -> tuple[bool, str]:
            V = self.Vs
            if V.atoms(AppliedUndef) or any(
                s.name.endswith(".interval") for s in V.free_symbols
            ):
                return False, "V itself depends on time"
            for after in self.loop.jumps_at_once():
                rise = tidied((V.xreplace(after) - V).xreplace(self.values))
                if not self.falls(rise):
                    return False, f"V changes by {short(rise)}"
            return True, ""

        claim = f"V does not rise where states of {' and '.join(self.loop.jumps)} jump"
        return checked(claim, no_rise, every_N=False)

    @property
    def others(self) -> list[str]:
        """The states that V need not hold: all but e's and those that make learned parameters."""
        in_V, states = {*self.learned, *self.loop.states["z"]}, self.loop.states
        return [port for port in states if port != "x" and {*states[port].flat} - in_V]

    def existing(self) -> tuple[str, Step]:
        """Return what a verdict adds of the other states, and the step that they exist."""
        x, z = self.loop.states["x"], self.loop.states["z"]
        held = [*x, *z, *self.learned, *self.others_in_V]
        return states_beside(held, self.loop, self.values)

    def settled(self) -> tuple[bool, str]:
        """Settle how V falls; return whether the rest of V' is not positive, and the fall in words.

        Half of the fall may do.
        """
        KD, D = (
            self.loop.parameters["vehicle_controller"].KD,
            zip(self.e, self.zones, strict=True),
        )
        beyond = [e * (e - CLIP(e, -zone, zone) if zone else e) for e, zone in D]
        squares = sympy.Add(*(k * one for k, one in zip(KD, beyond, strict=True)))
        fall = "-D^T KD e" if any(self.zones) else "-e^T KD e"
        if tidied(self.fall.xreplace(self.apart) + squares) != 0:
            fall = "-sum KD_i e_i dV/de_i"
        if not self.rises:
            return False, fall
        for share, part in (("", sympy.S.Zero), ("/2", sympy.S.Half)):
            if self.falls(self.residual + part * self.fall):
                self.residual += part * self.fall
                self.fall -= part * self.fall
                return True, fall + share
        return False, fall

    def every(self) -> Step:
        """Return the step that the same holds for every N."""

        def holds() -> tuple[bool, str]:
            loop = ArrayLoop(self.loop.diagram, known=self.of_every_N)
            residual = tidied(loop.elements.of(rate_of_V(loop) - decay(loop)))
            if loop.undefined:
                return False, loop.undefined[0]
            read, asked = (
                loop.elements.of,
                [one for one in self.others if one in loop.states],
            )
            moves, states = (  # what no equation reads exists as long as what drives it
                {port: read(one[port]) for port in asked}
                for one in (loop.rates, loop.states)
            )
            if faster := faster_than_linear(moves, states):
                return False, faster
            base, term = parts = [tidied(part) for part in base_and_term(residual)]
            for at in ({}, self.values):  # for all gains, or those that it has
                if all(self.falls(part.xreplace(at)) for part in parts):
                    return True, ""
            return False, f"left over: {short(base)}; summand {short(term)}"

        return checked("the same for every N", holds)

    def of_every_N(self, symbol: sympy.Expr, index: Index) -> sympy.Expr:
        """Return a parameter's element for every N: V's are numbers, the law's or the truth's."""
        generic = [one for one in index if isinstance(one, str)]
        weight = self.of_V.get(symbol, symbol)
        if weight != symbol or len(generic) != 1:
            return weight
        names = [{generic[0]: str(k + 1)} for k in range(self.N)]
        theirs = [
            self.of_V.get(s, s) for s in (reindexed(symbol, name) for name in names)
        ]
        # one for all, or one each
        ways = (theirs[0], reindexed(theirs[0], {"1": generic[0]}))
        fit = (
            gain for gain in ways if [reindexed(gain, name) for name in names] == theirs
        )
        return next(fit, symbol)


def faster_than_linear(moves: Mapping[str, Any], states: Mapping[str, Any]) -> str:
    """Return which state may grow faster than linearly in the states, and its rate; or ""."""
    names = {
        str(s).split("[")[0] for symbols in states.values() for s in np.ravel(symbols)
    }

    def is_state(symbol: sympy.Symbol) -> bool:
        return str(symbol).split("[")[0] in names  # m[k] is one of m[j]

    for what, move in moves.items():
        for one in np.ravel(move):
            if degree(sympy.sympify(one), is_state) > 1:
                return f"{what} = {short(one)} may grow faster than linearly"
    return ""
