"""A verdict on a specification of runs: proved by boxes, refuted by a run, or open.

    proved    the boxes of the margin, at times and over the intervals between, have one sign
    refuted   a run has the other sign at a time, and so has the box around that run

The margin is an output of the diagram: boxes, machine code and runs read one equation.  Pieces of
the set are halved only where the margin is undecided.  A run that violates is searched for at
corners of the set, at random members, and by descent of the least margin.
"""

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

import control
import numpy as np

from ...base.arguments import Count, Seed, brief, numbers, public
from ...base.errors import ArgumentError
from ...base.figures import RED, legend_above_data, literal
from ...engine.enclosure.sets import Enclosure
from ...simulation.enclosures import boxes, is_pair, tube_plot, varied_by
from ...simulation.integrate import simulate
from ...simulation.prepared_runs import prepare
from ...simulation.requests import as_diagram
from ..algebra.texts import cut
from .conclusions import Judged
from .specification import Specification, named, specification_of
from .statements import Statement, said
from .steps import Step
from .violating_run import Members, Search, margins_along

if TYPE_CHECKING:
    import xarray

    from ...paper.scenario.experiment import Scenario

MOST_STEPS = 3_000  # of boxes
TIMES = 100  # intervals of a run that gives fewer times
SHOWN_BEYOND = 3.0  # of the range of a run, that its figure shows beyond it
HOLDS = "holds on every run"


class RunCondition(NamedTuple):
    """A condition of a verdict on runs, and its sentence."""

    name: str
    of: str

    def __str__(self) -> str:
        return self.of


@dataclass(frozen=True)
class RunVerdict(Judged):
    """Verdict on a specification of runs.

    Attributes
    ----------
    status : str
        ``"proved"``: of every run; ``"refuted"``: `run` violates it, so does the box around this
        run; ``"open"``: neither is known.
    conclusion, conditions, sentence, steps
        As of the verdicts of `lyapunov`.
    run : xarray.Dataset or None
        The run that violates the specification, or the closest one found.
    time, margin : float or None
        Where boxes show that the run violates it, else where its margin is least; and the least
        margin of the run, above 0 where the specification holds.
    tube : xarray.Dataset
        Boxes of the set, as `enclose` returns them.
    member : dict
        ``inputs``, ``initial_state`` and ``params`` of `run`.
    margins : dict
        Margins of `run` by the names that they have in `tube`.
    sure, possible : float or None
        Of `by`: from when on all runs are in the target, and from when on one may be.
    """

    run: "xarray.Dataset | None" = field(default=None, compare=False)
    time: float | None = None
    margin: float | None = None
    tube: Any = field(default=None, compare=False)
    member: Mapping[str, Any] = field(default_factory=dict, compare=False)
    sure: float | None = None
    possible: float | None = None
    margins: Mapping[str, np.ndarray] = field(default_factory=dict, compare=False)

    def plot(self, *, ax: Any = None) -> Any:
        """Draw boxes of the margins, their bound 0, and the margins of `run`.

        A specification holds where its margin is above 0.
        """
        axes = tube_plot(self.tube.sel(name=[*self.margins]), ax=ax)
        panels = np.ravel(axes)
        for panel, (name, margin) in zip(panels, self.margins.items(), strict=True):
            panel.set_title(literal(cut(name, 80)), loc="left", fontsize="medium")
            panel.set_ylabel("margin")
            panel.axhline(0.0, color=RED, linestyle="--", label="bound")
            if np.any(np.isfinite(margin)):
                style = {"color": "black", "linewidth": 0.8, "label": "run"}
                panel.plot(self.tube.time, margin, **style)
        legend_above_data(panels[0])
        # boxes that explode leave the run and the bound to be seen
        for panel, margin in zip(panels, self.margins.values(), strict=True):
            low, high = np.nanmin([*margin, 0.0]), np.nanmax([*margin, 0.0])
            beyond = SHOWN_BEYOND * (high - low) or np.inf
            panel.set_ylim(*np.clip(panel.get_ylim(), low - beyond, high + beyond))
        return axes

    def _shown(self, most: int) -> str:
        return cut(self.claim, most)

    @property
    def statement(self) -> Statement:
        """The sentence as a statement."""
        return said("{}", self.sentence)

    def __repr__(self) -> str:
        return f"<RunVerdict {self.status}: {self.sentence}>"


def _rows(spec: Specification, times: np.ndarray) -> slice:
    return slice(int(times.searchsorted(spec.begin)), None)


@public
def verify(
    system: "Scenario | control.InputOutputSystem",
    timepts: Any = None,
    inputs: Any = None,
    initial_state: Any = None,
    params: Mapping[str, Any] | None = None,
    *,
    always: str | Callable[[Any], Any] | None = None,
    never: str | Callable[[Any], Any] | None = None,
    by: tuple[float, str | Callable[[Any], Any]] | None = None,
    within: float | None = None,
    pieces: Count = 16,
    seed: Seed = 0,
) -> RunVerdict:
    """Judge a specification of all runs from a set.

    Proved by boxes of all runs, refuted by one run and the box around it, or open.

    Parameters
    ----------
    system, timepts, inputs, initial_state, params
        As of `enclose`: a pair ``(lower, upper)`` in place of a number is an interval. A run from
        one time to another is seen at 100 times between, unless inputs have samples.
    always : str or callable, optional
        What holds at all times: ``"level < 0.9"``, ``"x > 0 and hypot(x, y) < 2"``, of the names
        of outputs and states, and t; or a function of these signals that is above 0 where it
        holds, ``lambda s: 0.9 - s.level``, in operators and functions of NumPy.
    never : str or callable, optional
        What holds at no time.
    by : tuple, optional
        A time, and what holds from then on to the end: ``(60, "hypot(x - 10, y - 5) < 2")``.
    within : float, optional
        Part of each parameter's number by which it may differ, 0.1 for 10 %. Parameters in
        `params` are as given there; the matrices of linear systems are no parameters.
    pieces : int, optional
        Into how many pieces the set is divided at most, where it is undecided.
    seed : int, optional
        Of the members that are tried at random.

    Returns
    -------
    RunVerdict
        `status`, `conclusion`, `conditions`, `sentence` and `steps` as of `lyapunov`; `run`, the
        run that violates it or comes closest, ``verdict.run.clpt.plot()``; `tube`, the boxes.

    Raises
    ------
    ArgumentError
        If a specification is no comparison of signals, jumps, or asks for a time that is none.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> tank = clpt.Block("tank", update=lambda t, x, u, p: {"level": p.q - p.k * x.level},
    ...     states={"level": 1}, parameters={"q": 0.8, "k": 1.0})
    >>> clpt.verify(tank, [0, 5], params={"tank.k": (0.9, 1.1)}, always="level < 0.9").status
    'proved'
    >>> verdict = clpt.verify(tank, [0, 5], within=0.1, always="level < 0.9")
    >>> verdict.status, float(verdict.run["level"][-1]) > 0.9
    ('refuted', True)
    """
    times, specs = _read(system, timepts, inputs, always, never, by)
    if within is not None:
        given_params = dict(params or {})
        params, still = varied_by(system, within, given_params)
        if still:
            raise ArgumentError(
                f"within = {within}: {', '.join(still)}: can have no interval, as their numbers "
                "are read. Give these in `params`"
            )
        if not params:
            raise ArgumentError(
                f"within = {within}: there is no parameter. Leave it out"
            )
    given = {"inputs": inputs, "initial_state": initial_state, "params": params}

    labels = list[list[str]]()  # of outputs and of states

    def columns(spec: Specification) -> Callable[..., Any]:
        def margin(t: Any, *groups: Any) -> Any:
            signals: dict[str, Any] = {}
            labels[:] = [of for of, _ in groups]
            for of, values in groups:
                named(of, values, signals)
            if hidden := signals.keys() & {"t", "pi"}:
                raise ArgumentError(
                    f"verify: a signal has the name {min(hidden)}, which has a meaning of its own "
                    "in specifications. Rename it"
                )
            return spec.of(signals | {"t": t})

        return margin

    margins = {f"margin of {spec.claim}": columns(spec) for spec in specs}

    def undecided(piece: Enclosure) -> bool:
        for k, spec in enumerate(specs):
            rows = _rows(spec, piece.times)
            (low, over), (high, _) = piece.bounds[:, :, rows, k - len(specs)]
            if np.any(spec.fails(high)):
                return False  # of a part that is refuted by any of its runs
            if not (np.all(spec.holds(low)) and np.all(spec.holds(over[1:]))):
                return True
        return False

    # 1. boxes of the whole set: bad arguments are named here
    boxes_of = partial(boxes, system, times, margins=margins)
    tube = boxes_of(**given, most_steps=MOST_STEPS)
    specs = _at_times(specs, tube.time.values)
    proved = _are_proved(specs, tube)
    # 2. a run that violates
    search, refuted = None, None
    if not all(proved):
        members = Members(given, times)
        run: Any = partial(simulate, system, times)
        if not (diagram := as_diagram(system)[0]).dt:
            at = tube.time.values if times is None else times
            run = prepare(diagram, at, **members.member(np.zeros(0)))
        search = Search(run, specs, members, tube.time.values, labels)
        search(np.random.default_rng(seed))
        refuted = _confirmed(search, partial(boxes_of, most_steps=MOST_STEPS), specs)
    # 3. pieces
    if not all(proved) and refuted is None and pieces > 1:
        tube = boxes_of(**given, pieces=pieces, undecided=undecided)
        proved = _are_proved(specs, tube)
    unknown = np.full(tube.sizes["time"], np.nan)
    found: dict[str, Any] = {"tube": tube, "margins": dict.fromkeys(margins, unknown)}
    if search is not None and np.isfinite(search.best[0]):
        least, shares, at = search.best
        member = search.members.member(shares)
        found |= {"time": at, "margin": least, "member": member}
        found["run"] = simulate(system, times, **member)
        closest = search.run(**member)
        found["margins"] = {
            name: margins_along(spec, closest, *search.of)
            for name, spec in zip(margins, specs, strict=True)
        }
    return _verdict(specs, [*margins], proved, tube, search, refuted, found)


def _read(
    system: Any, timepts: Any, inputs: Any, always: Any, never: Any, by: Any
) -> tuple[Any, list[Specification]]:
    """Return times, with some between, and specifications."""
    begin = -np.inf
    given = [("always", always, begin, 1.0), ("never", never, begin, -1.0)]
    if by is not None:
        if not is_pair(by) or isinstance(by[0], str) or np.ndim(by[0]):
            raise ArgumentError(
                f"by = {brief(by)}: is no pair of a time and what holds then"
            )
        given.append(("by", by[1], float(by[0]), 1.0))
    specs = [
        specification_of(n, v, t, sign) for n, v, t, sign in given if v is not None
    ]
    if not specs:
        raise ArgumentError("verify: has no specification. Give always, never or by")
    times = timepts if timepts is None else numbers("timepts", timepts)
    is_row = times is not None and times.ndim == 1 and times.size > 0
    if times is not None and is_row and _are_held(inputs, len(times), system):
        dt = as_diagram(system)[0].dt
        span, count = float(times[-1] - times[0]), max(TIMES, len(times))
        extra = times[0] + span * np.linspace(0.0, 1.0, count + 1)
        if dt:
            extra = times[0] + dt * np.arange(round(span / dt) + 1)
        elif by is not None and times[0] <= by[0] <= times[-1]:
            times = np.append(times, by[0])
        far = np.min(np.abs(extra[:, None] - times), axis=1) > 1e-9 * span
        times = np.unique(np.append(times, extra[far]))
    return times, specs


def _at_times(specs: list[Specification], times: np.ndarray) -> list[Specification]:
    """Return specifications that begin at a time of the run; times are rounded."""
    begun = []
    for spec in specs:
        if np.isfinite(spec.begin):
            nearest = float(times[np.argmin(np.abs(times - spec.begin))])
            if abs(nearest - spec.begin) > 1e-12 * (np.ptp(times) + abs(nearest)):
                raise ArgumentError(
                    f"by: {spec.begin:.9g} is no time of the run. Give a time of `timepts`"
                )
            spec = replace(spec, begin=nearest)
        begun.append(spec)
    return begun


def _are_held(inputs: Any, count: int, system: Any) -> bool:
    """Return whether no input has a sample for each of some times; others are refused later."""
    entries = inputs.values() if isinstance(inputs, Mapping) else inputs
    with suppress(TypeError, ValueError):
        is_plain = not isinstance(inputs, Mapping | list | tuple)
        if inputs is None or (is_plain and np.ndim(inputs) == 0):
            return True
        ends = [one[0] if is_pair(one) else one for one in entries]
        # numbers of a list are one for each input, or else one for each time
        are_inputs = len(ends) == as_diagram(system)[0].ninputs
        are_rows = not isinstance(inputs, Mapping) and len(ends) == count
        return (are_inputs or not are_rows) and all(np.ndim(end) == 0 for end in ends)
    return False


def _are_proved(specs: list[Specification], tube: "xarray.Dataset") -> list[bool]:
    """Return of each specification whether all boxes of its margin have its sign."""
    proved = []
    for k, spec in enumerate(specs, -len(specs)):
        rows = _rows(spec, tube.time.values)
        low, over = tube.lower.values[rows, k], tube.over_lower.values[rows, k][1:]
        shown = len(low) and np.all(spec.holds(low)) and np.all(spec.holds(over))
        proved.append(bool(shown))
    return proved


def _confirmed(
    search: Search, box: Callable[..., Any], specs: list[Specification]
) -> tuple[Specification, float] | None:
    """Return the specification that boxes around the best run violate, and the first time."""
    if search.best[0] > 0.0:
        return None
    tube = box(**search.members.member(search.best[1]))
    for k, spec in enumerate(specs):
        rows = _rows(spec, tube.time.values)
        fails = spec.fails(tube.upper.values[rows, k - len(specs)])
        if np.any(fails):
            return spec, float(tube.time.values[rows][np.argmax(fails)])
    return None


def _verdict(
    specs: list[Specification],
    names: list[str],
    proved: list[bool],
    tube: "xarray.Dataset",
    search: Search | None,
    refuted: tuple[Specification, float] | None,
    more: dict[str, Any],
) -> RunVerdict:
    """Return the verdict with its sentence."""
    texts = " and ".join(spec.claim for spec in specs)
    times = tube.time.values
    steps = [
        Step(f"boxes show {spec.claim}", is_shown, "enclosed")
        for spec, is_shown in zip(specs, proved, strict=True)
    ]
    if search is not None:
        if "margin" in more:
            least, at = more["margin"], more["time"]
            runs = f"{search.runs} run{'s' * (search.runs > 1)}"
            text = f"the least margin of {runs} is {least:.6g}, at t = {at:.9g}"
            holds = least > 0.0 and not search.without
            steps.append(Step(text, holds, "sampled", needed=False))
        steps += [Step(text, False, "sampled") for text in search.without]
    of_model = RunCondition("recorded", "of the recorded equations in exact arithmetic")
    until = RunCondition("times", f"for t from {times[0]:.9g} to {times[-1]:.9g}")
    conditions: tuple[Any, ...] = (until, of_model)
    if "Filippov" in tube.message:
        conditions += (RunCondition("jumps", "runs of Filippov where rates jump"),)
    if refuted is not None:
        spec, more["time"] = refuted
        at = more["time"]
        steps.append(
            Step(
                f"the box around that run is outside of {spec.claim}",
                True,
                "counterexample",
            )
        )
        claim = f"{spec.claim} fails at t = {at:.9g} of `run`, which is `member`"
        return RunVerdict(
            "refuted", claim, conditions=conditions, steps=tuple(steps), **more
        )
    event = specs[-1] if np.isfinite(specs[-1].begin) else None
    if event is not None:
        more |= _event(event, tube.sel(name=names[-1]))
    if all(proved):
        return RunVerdict(
            "proved",
            f"{texts} {HOLDS}",
            conclusions=(HOLDS,),
            conditions=conditions,
            steps=tuple(steps),
            **more,
        )
    spec = specs[proved.index(False)]
    of = tube.sel(name=names[proved.index(False)])
    rows = _rows(spec, times)
    unknown = ~(spec.holds(of.lower.values) & spec.holds(of.over_lower.values))[rows]
    # the interval before the first time that is undecided
    k = max(int(np.argmax(unknown)) - 1, 0) if unknown.any() else -1
    at = times[rows][k]
    claim = f"{spec.claim} is not decided from t = {at:.9g} on"
    if "the boxes end there" in tube.message:
        claim += (
            ", as"
            + tube.message.partition("the boxes end there, as")[2].partition(";")[0]
        )
    return RunVerdict("open", claim, steps=tuple(steps), **more)


def _event(spec: Specification, of: "xarray.Dataset") -> dict[str, Any]:
    """Return from when on all runs are in a target for good, and from when on one may be."""
    times, low = of.time.values, of.lower.values
    over = np.append(spec.holds(of.over_lower.values[1:]), True)
    later = np.logical_and.accumulate((over & spec.holds(low))[::-1])[::-1]
    is_possible = ~spec.fails(of.over_upper.values[1:])
    return {
        "sure": float(times[np.argmax(later)]) if later.any() else None,
        "possible": float(times[np.argmax(is_possible)]) if is_possible.any() else None,
    }
