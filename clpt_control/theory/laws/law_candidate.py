"""V of a law on the paper's loop: it falls, is bounded, or is refuted.

If the residual of V' is never positive, V falls and e goes to zero as in Theorem 3.2; where it
pulls back but for a constant, V is bounded (`ultimate_bounds`).
"""

from dataclasses import replace
from functools import cached_property, partial

import sympy
from sympy.core.function import AppliedUndef

from ...base.units import at_least, at_most
from ..algebra.exact import normal_form
from ..algebra.facts import CLIP, has_time
from ..algebra.slopes import along
from ..algebra.sums_of_squares import rising_in
from ..algebra.texts import short
from ..proofs.certificates import Ways
from ..proofs.conclusions import Condition
from ..proofs.judge import Fall, Refutation
from ..proofs.steps import Step, checked, exact
from ..proofs.ultimate_bounds import Bounding, bounded
from .law_certificates import of_law
from .law_equations import LawEquations
from .law_for_every_n import holds_for_every_N

HIDDEN = {"flow_x": "the true flow", "V": "V, which is made of the truth"}


class LawCandidate(LawEquations):
    """A law with its V, and what is asked of them."""

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
