"""Points at which V of a user fails on a diagram, by the blocks that run."""

import sympy

from ...engine.diagram.symbol_names import TIME
from ..algebra.exact import normal_form
from .judge import Refutation
from .point_search import Failure
from .steps import Step, exact
from .system_equations import SystemEquations


class RefutableSystem(SystemEquations):
    """A diagram with its V, and the search for points at which V is no Lyapunov function."""

    def refuted(self, steps: list[Step]) -> Refutation | None:
        """Return a point at which V' > 0, or above what is claimed, or V is no least value."""
        _, definite, falls, *_ = steps
        below = "V is below its value at rest" if self.rest else "V falls without end"
        over = "V' > 0" if self.claim is None else "V' is above the claim"
        for fails, find, holds in (
            (over, self._rises, falls.holds),
            (below, self._no_least, definite.holds),
        ):
            if holds:
                continue
            failure = find()
            claim = f"{fails} at a point"
            step = Step(claim, failure is not None, "counterexample", "", False)
            if failure is not None:
                claim = f"V' = {self.shown_rate}; {fails}: {failure[1]:.3g} at `point`"
                return Refutation(claim, step, *failure)
            steps.append(step)
        return None

    def refuted_by_inputs(self) -> Refutation | None:
        """Return a point at which inputs raise V, however far from the rest."""
        failure = self.search.rises_far_off(self.rate, set())
        if failure is None:
            return None
        inputs = " = ".join(self.depends_on(self.rate))
        step = Step(f"{inputs} raises V however large it is", True, "counterexample")
        claim = f"V' > 0: {failure[1]:.3g} at `point`, and 10 and 100 times as far off"
        return Refutation(f"{claim}; where {inputs} = 0 V' <= 0", step, *failure)

    def refuted_at_jump(self, rise: sympy.Expr) -> Refutation | None:
        """Return a point at which V rises at a jump, if jumps do not depend on time."""
        if rise.has(TIME, *self.intervals):  # at few of which it jumps
            return None
        failure = self.search.sign_at(rise, 1)
        if failure is None:
            return None
        claim = f"V rises by {failure[1]:.3g} at a jump"
        return Refutation(claim, exact(claim, False), *failure)

    def _rises(self) -> Failure | None:
        """Return a point at which V' is above 0, or above the claim."""
        rate, zero = normal_form(self.rate), sympy.S.Zero
        if self.claim is not None:
            return self.search.rate_above(rate, self.claim, still=False)
        still = self.search.rate_above(rate, zero, still=True)
        if still is not None:
            return still
        if self.depends_on(rate):
            return self.search.rises_far_off(self.rate, set())
        return self.search.rate_above(rate, zero, still=False)

    def _no_least(self) -> Failure | None:
        """Return a point at which V is below its value at the rest, and by how much.

        If no rest is given it is one whose multiples have a V that falls without end: there the
        part of V of highest degree is negative.
        """
        V, states = self.V, self.states
        if self.rest is not None:
            return self.search.sign_at(V - V.xreplace(self.rest), -1)
        if not (V.is_polynomial(*states) and V.has(*states)):
            return None
        scale = sympy.Dummy()
        scaled = sympy.Poly(V.xreplace({s: scale * s for s in states}), scale)
        return self.search.sign_at(scaled.LC(), -1)
