"""A Lyapunov function of the user on any diagram: `lyapunov(system, V)`.

V and V' are exact, on the equations that run; `judge` asks the five questions of them.  What is not
shown is open; what is refuted is refuted by a point.  If no V is given, one is searched for
(`searching`) and judged as any other is.  In a region (`region`) V' < 0 is enough.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

import control
import sympy
from sympy import Expr, S

from ...base.arguments import Count, Seed, public
from ...base.errors import ClptError, DiagramError
from ...base.units import at_least
from .answers import Fall
from .between import margins_of
from .conclusions import Condition, concluded, signs_of, strength
from .judge import Answers, Verdict, asked, refuted, with_refutation
from .rate_as_sum import in_region
from .region import Region
from .searching import candidates, growing_eigenvalue
from .signal_functions import function_of_signals
from .statements import joined, said
from .steps import How, Step, first_failure, worked_out
from .system_candidate import SystemCandidate

NOT_HELD = ("outside V", "existence")  # conditions on states that V does not contain
Reader = Callable[..., SystemCandidate]
OF_PARAMETERS = "values", "signs", "between"  # names of conditions
MOST_MARGINS = 3  # conditions between parameters
MOST_TRIES = 16  # judgements without signs, or values, of parameters


def _of_fewest_values(case: SystemCandidate, proof: Answers, read: Reader) -> Reader:
    """Return the reader by which a proof for the parameters' values is of the fewest of them.

    `case` has symbols for all parameters.  They may be so under conditions between them; else
    those that do not need their values are tried one by one.
    """
    margins, of_margins, verdict = list[Expr](), case, proof.verdict
    while len(margins) < MOST_MARGINS and (more := next(margins_of(of_margins), None)):
        margins.append(more)
        reader = partial(read, margins=margins)
        if _holds(verdict, reader):
            return reader
        of_margins = reader(points=1)
    free = frozenset[str]()
    for s in [*case.eq.values][:MOST_TRIES]:
        tried = free | {f"{s}"}
        if len(tried) < len(case.eq.values):
            reader = partial(read, numbers=True, symbols=tried)
            free = tried if _holds(verdict, reader) else free
    return partial(read, numbers=True, symbols=free)


def _holds(verdict: Verdict, read: Reader) -> bool:
    """Return whether a verdict holds as it is read now, under no more conditions."""
    try:
        weaker = asked(read(points=1)).verdict
    except ClptError:
        return False
    given = {*verdict.conditions}
    more = {c for c in weaker.conditions if c.name not in OF_PARAMETERS}
    # symbols may give the forms that go to zero another order
    counts = (judged.of.count(",") for judged in (weaker, verdict))
    is_same = strength(weaker) == strength(verdict) and len({*counts}) == 1
    return is_same and more <= given


def _with_signs(verdict: Verdict, case: Any, read: Reader) -> Verdict:
    """Return a proof with the signs of parameters that its steps need as a condition.

    A sign is not needed if the same steps hold for the parameter as any real number.  After
    `MOST_TRIES` the signs that are left are conditions, needed or not.
    """
    needed = {str(s): s for s in case.eq.values if s.is_positive or s.is_negative}
    shown = sympy.Tuple(case.V, *case.motion.values()).free_symbols
    hidden = {name for name, s in needed.items() if s not in shown}
    groups = [hidden, *({name} for name in needed if name not in hidden)]
    dropped = set[str]()
    for group in [*filter(None, groups)][:MOST_TRIES]:
        try:
            weaker = asked(read(points=1, unsigned=dropped | group)).verdict
        except ClptError:
            continue
        if _texts(weaker) == _texts(verdict):
            dropped |= group
            verdict = replace(verdict, ways=weaker.ways)
    signs = signs_of(s for name, s in needed.items() if name not in dropped)
    conditions = [Condition("signs", signs)] * bool(signs)
    return replace(verdict, conditions=(*conditions, *verdict.conditions))


def _texts(verdict: Verdict) -> tuple:
    """Return a verdict as text, without how it was compared with the running blocks."""
    steps = [(s.claim, s.holds, s.shows) for s in verdict.steps]
    return verdict.sentence, f"{verdict.V}", f"{verdict.rate}", steps


def _names(verdict: Verdict) -> set[str]:
    """Return the names of conditions."""
    return {condition.name for condition in verdict.conditions}


def _zeroed(answers: Answers) -> bool:
    """Return whether it is proved for inputs of 0 alone."""
    return "zero inputs" in _names(answers.verdict)


def _in_region(candidate: SystemCandidate, within: Any) -> Verdict:
    """Return in which part of a box V' < 0, with inputs of 0 or between their bounds."""
    region, where_ends = Region(candidate, within), candidate.where.ends
    inputs = [str(f.func) for f in candidate.inputs if f not in where_ends]
    how: How = "enclosed"
    level, where = region.level(), "V' < 0"
    if not level and (rests := candidate.ends_at(region.low, region.high)):
        level, how, where = region.level(rests), "exact", "V' <= 0, and V falls on,"
    less = said(" - {}", region.V_at_rest) if region.V_at_rest else ""
    below = "near the rest"
    if level:
        below = said("where V{} < {} in the box", less, at_least(level, 6))
    claim = said("{} {}, but at the rest", where, below)

    def in_box(points: tuple) -> tuple:
        t, x, u = points
        x = candidate.search.random.uniform(region.low, region.high, x.T.shape).T
        return t, *candidate.search.both_inside(x, 0.0 * u)

    steps = (
        candidate.has_values(),
        Step(claim, level > 0.0, how, "", False, "region"),
        Step("runs that begin there stay in it", level > 0.0, how, "", False, "exists"),
        candidate.same_as_running(in_box),
    )
    if failed := first_failure(steps):
        return candidate.verdict("open", failed, Fall([]), steps=steps)
    zeroed = {f: S.Zero for f in candidate.inputs if str(f.func) in inputs}
    verdict = candidate.verdict(
        "proved",
        claim,
        Fall([], zeroed=zeroed),
        conclusions=concluded(steps),
        conditions=tuple(candidate.conditions(inputs)),
        steps=steps,
    )
    ways = partial(in_region, region, candidate, level)
    return replace(verdict, inputs=tuple(inputs), level=level, ways=ways)


def _searched(
    system: control.NonlinearIOSystem,
    rest_state: Any,
    judged: Callable[[Expr], Verdict],
    in_box: bool,
) -> Verdict:
    """Return the verdict on the best of the functions that are searched for."""
    best = None
    candidate = SystemCandidate(system, sympy.S.Zero, None, rest_state)
    for V in candidates(candidate):
        verdict = judged(V)
        missed = [c.of for c in verdict.conditions if c.name in NOT_HELD]
        if verdict.status == "proved" and not missed:
            return verdict
        if best is None and verdict.status == "proved":
            parts = (getattr(of, "parts", (of,)) for of in missed)
            names = joined(", ", (of[0] for of in parts))
            claim = said("V found, but it does not contain {}", names)
            best = replace(
                verdict, status="open", claim=claim, conclusions=(), conditions=()
            )
    inputs = ", ".join(str(f.func) for f in candidate.inputs)
    still = f", with {inputs} = 0," if inputs else ""
    if (growing := growing_eigenvalue(candidate)) is not None:
        number = growing if growing.imag else growing.real
        cause = f"the linear part{still} has the eigenvalue {number:.3g}"
        return Verdict("open", f"the rest is unstable: {cause}")
    if best is not None:
        return best
    message = f"no V was found{still} that is proved: give one, or a rest (at=) to search about"
    return Verdict("open", message + ", or a smaller box (within=)" * in_box)


@public
def lyapunov(
    system: control.NonlinearIOSystem,
    V: str | Callable | Expr | None = None,
    claim: str | Callable | Expr | float | None = None,
    at: Mapping[str, float] | None = None,
    points: Count = 200,
    seed: Seed = 0,
    within: Mapping[str, Sequence[float]] | None = None,
    where: Mapping[str, Sequence[float | None]] | None = None,
    keeps: Callable | None = None,
) -> Verdict:
    """Judge a Lyapunov function of your own on any diagram.

    Parameters
    ----------
    system : control.NonlinearIOSystem
        A diagram, a block or a system of python-control.
    V : str, callable or sympy.Expr, optional
        The name of an output; a function of signals, ``lambda s: s.e**2 / 2``, in NumPy, which may
        ask for parameters and the time ``s.t`` too; or an expression in the symbols of
        `clpt.equations`.  By default V is searched for, of squares, products of two states, and
        integrals of functions of one state: `status` is then ``"open"`` where none that is found
        is proved.
    claim : str, callable, sympy.Expr or float, optional
        An upper bound of V', ``lambda s: -s.am * s.e**2``: the status speaks of V' <= claim, and
        the conclusion of what follows from it. By default V' <= 0 is judged.
    at : mapping, optional
        The rest state, ``{"theta": np.pi}``, other states 0: where V is to be least. By default V
        may be least anywhere, and is searched for about 0.
    points : int, optional
        Random points at which the running blocks are asked.
    seed : int, optional
        Of the random points.
    within : mapping, optional
        The ends of each state, ``{"theta": (-1, 1), "omega": (-2, 2)}``: where V' < 0 in this box,
        and from where every run comes to rest, inputs 0 or as `where` has them. For few states,
        some four.
    where : mapping, optional
        The ends of a set that the system keeps, ``{"q": (0, None)}`` for q >= 0, or q > 0 if V
        divides by q: V' is judged there. Its rate, or next value, is asked for at each end: it
        must not lead outside. Inputs, at most six, have bounds, ``{"d": (-1, 3)}``, one bound,
        ``(0, None)``, or one value, ``(1, 1)``: if V' is convex in each, or in its square, V comes
        down to a `level`, an upper estimate, for each d(t) within them. A `claim` is for any
        inputs.
    keeps : callable, optional
        Relations of states that hold where a run begins: a function of signals that returns what
        is then 0, ``lambda s: [s.y - s.theta * s.w]``, each linear in one state. Rates and jumps
        must keep them, and a small distance and its factors must not grow. V' is judged there.

    Returns
    -------
    Verdict
        `status`: ``"proved"``, ``"refuted"`` at a `point`, or ``"open"``; the `conclusion` with its
        `conditions`; `rate`, V' in your own signals, exact: in discrete time V(x+) - V(x).

    Raises
    ------
    DiagramError
        If the diagram cannot be read, V is no number of it, or is to be
        searched for about what is no rest, of more than 16 states, or with a claim.

    Examples
    --------
    >>> import numpy as np
    >>> import clpt_control as clpt
    >>> def swing(t, x, u, p):
    ...     return {"theta": x.omega, "omega": -p.g * np.sin(x.theta) - p.b * x.omega}
    >>> pendulum = clpt.Block("rod", update=swing, states={"theta": 1, "omega": 1},
    ...                       parameters={"g": 9.8, "b": 0.1})
    >>> energy = lambda s: s.omega**2 / 2 + s.g * (1 - np.cos(s.theta))
    >>> clpt.lyapunov(pendulum, energy).rate
    -b*omega**2
    >>> clpt.lyapunov(pendulum).V
    omega**2/2 - 49*cos(theta)/5 + 49/5
    """

    def judged(V: Any, where: Mapping[str, Sequence] | None = where) -> Verdict:
        read: Reader = partial(
            SystemCandidate,
            system,
            V,
            claim,
            at,
            points=points,
            seed=seed,
            where=where or {},
            keeps=keeps,
        )
        candidate = read(numbers=bool(within))
        sets = {name: tuple(ends) for name, ends in (where or {}).items()}
        above = {name for name, ends in sets.items() if ends[:1] == (0,)}
        if candidate.undefined and above:  # they may be any numbers but 0
            read = partial(read, above=above)
            candidate = read()
        if within and candidate.where.kept:
            raise DiagramError(
                f"{system.name}: give bounds of inputs alone in `where`: the box `within` has "
                "those of states"
            )
        if within:
            return _in_region(candidate, within)
        answers = asked(candidate)
        # numbers are tried where LaSalle's rest is not shown
        has_cases = answers.ends and answers.ends.cases
        is_final = answers.verdict.implies(
            "asymptotically stable" if has_cases else "goes to zero"
        )
        if candidate.eq.values and (_zeroed(answers) or not is_final):
            of_numbers = asked(read(numbers=True))
            is_stronger = strength(of_numbers.verdict) < strength(answers.verdict)
            if is_stronger or (_zeroed(answers) and not _zeroed(of_numbers)):
                read = _of_fewest_values(candidate, of_numbers, read)
                answers = asked(read())
        if is_given and _zeroed(answers):
            failure = candidate.refuted_by_inputs()
            if claim is not None:  # it holds with the inputs
                pushed = partial(read, is_pushed=True)
                with_inputs = asked(pushed())
                if failure is not None or with_inputs.verdict.implies(
                    "bounded in the mean"
                ):
                    read, answers = pushed, with_inputs
            elif failure is not None:
                return refuted(candidate, failure, answers.fall, answers.steps)
        verdict = answers.verdict
        kept = candidate.kept_signs() if verdict.status == "open" and not where else {}
        if kept and (of_signs := judged(V, kept)).status == "proved":
            return of_signs
        if verdict.status == "proved":
            return _with_signs(verdict, answers.candidate, read)
        return with_refutation(candidate, answers)

    for name, given in ("keeps", keeps), ("claim", claim):
        if given is not None and (V is None or within):
            raise DiagramError(
                f"{system.name}: leave `{name}` out, or give a V and no box"
            )
    with worked_out(system.name):
        is_given = V is not None
        V = function_of_signals(system, V)
        claim = function_of_signals(system, claim)
        if not is_given:
            return _searched(system, at, judged, bool(within))
        verdict = judged(V)
        for name in where or {}:
            fewer = {key: ends for key, ends in (where or {}).items() if key != name}
            weaker = judged(V, fewer) if "start" in _names(verdict) else verdict
            if weaker.conclusion == verdict.conclusion and _names(weaker) < _names(
                verdict
            ):
                verdict, where = weaker, fewer
        return verdict
