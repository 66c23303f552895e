"""Decide with the SMT solver Z3 that an expression is never positive.

    e > 0 and facts have no common solution   =>   e <= 0

Z3 decides polynomials over the real numbers (`z3_translation`, `z3_facts`).  Its limit is a count
of operations, not a time, so that a result is the same on every machine.

Source: de Moura, L., Bjorner, N. (2008), Z3: An efficient SMT solver, TACAS, LNCS 4963, 337-340.
"""

from functools import lru_cache
from typing import Any

import sympy

from .z3_facts import facts_of_pairs
from .z3_translation import NotTranslatedError, Translation

# of Z3's resource counter; an operation on many real numbers takes longer
LIMIT, LIMIT_OF_MANY, MANY = 150_000, 15_000, 4
MOST_OPERATIONS = 400  # larger expressions are not translated


def z3_never_positive(e: sympy.Expr, fixed: set) -> bool:
    """Return whether Z3 shows that an expression is never positive, t >= 0.

    The result holds for all values of the symbols, also of the parameters `fixed`.  It is False if
    Z3 is not installed, cannot decide, or the expression has a function without a translation.
    """
    try:
        import z3
    except ImportError:
        return False
    return _is_decided(e, z3)


@lru_cache(maxsize=1000)
def _is_decided(e: sympy.Expr, z3: Any) -> bool:
    if e.count_ops() > MOST_OPERATIONS:
        return False
    translation = Translation(z3)
    try:
        value = translation.real(e)
        translation.exclude(e, ())
    except NotTranslatedError:
        return False
    facts = [*translation.facts, *facts_of_pairs(z3, translation.calls)]
    limit = LIMIT if translation.count < MANY else LIMIT_OF_MANY

    def result(*constraints: Any) -> Any:
        solver = z3.SolverFor("QF_NRA", ctx=translation.context)
        # with ctrl_c, Z3 would take an interrupt from Python
        solver.set(rlimit=limit, ctrl_c=False)
        solver.add(*constraints)
        return solver.check()

    # contradictory facts would prove anything
    return bool(result(*facts, value > 0) == z3.unsat and result(*facts) == z3.sat)
