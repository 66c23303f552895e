"""Report of an excitation: numbers for JSON, the table of `clpt excitation`, and a figure.

The report has Definition 3.1 over one window, the exact contraction of V of Eq. (24) and its
drop, for one trajectory.  The figure has a column for each axis: above the eigenvalues
of the Gramian in a window that slides over the run, below the least excited direction of one window
and the excited share of each parameter.
"""

from collections.abc import Iterator
from itertools import chain
from textwrap import shorten
from typing import TYPE_CHECKING, Any

import numpy as np

from ...base.figures import BLUE, GREY, RED, TITLE, axes_for
from ...base.html import Result
from ...base.units import at_most, finite_or_none
from .regressor import scale_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MEASURED = (
    "window",
    "start",
    "time_unit",
    "trajectory",
    "ceilings",
    "least_excited",
    "dimension",
    "not_learnable",
    "run_length",
)
CERTIFIED = (
    "contraction",
    "drop",
    "disturbed",
    "time_to_tenth",
    "learned",
    "half_life",
    "overshoot",
)
INVOLVED = 0.05  # smallest length of a parameter's unit vector in a subspace
OFF = 0.1  # share of the largest flow parameter
LOWEST = (
    1e-16  # share of the largest eigenvalue; smaller ones are rounding, and drawn there
)
SHARED = "the flow parameters, which all share, and each one's gains where they adapt"


def report_of(excitation: Any) -> dict[str, Any]:
    """Return a `gramian.Excitation` as JSON values.

    Its entries are ``window``, ``start``, ``time_unit``, ``trajectory``, ``not_learnable``
    (sentences), and by axis ``eigenvalues`` (ascending), ``ceilings`` (of the smallest
    eigenvalue), ``least_excited`` and ``dimension`` (of the excited subspace).

    ``contraction`` (exact V(t+T)/V(t) at worst), ``drop``
    (1 - contraction, with all its digits), ``time_to_tenth`` (time in which the root of V
    falls to a tenth in windows like this one, or None for never) and ``learned`` (by axis,
    number of directions in which errors do so within ``run_length``) exclude the effect of a
    disturbance if ``disturbed``.  The root of V is at most ``overshoot``
    2^(-t/``half_life``) of the first if the window repeats; ``half_life`` is None if it is not
    excited.  All are None if the window cannot be certified; ``not_certified`` is the reason.
    ``along_run`` has lists: by ``time`` and ``axis`` ``factor``, ``|Phi|``, of which the root of V
    is at most so much of its first in the run, but for what a disturbance adds, and
    ``window_factor``, ``|Phi|`` of the window that ends there, None for a shorter one.  It is
    empty if Phi is not known.

    A recorded run has an ``accuracy``: the largest relative change of an eigenvalue if every
    second sample is left out; None if the change is large.  It does not show what changes between
    the samples.
    A team has ``measured`` (description of the parameters), ``smallest`` (eigenvalues by name),
    and ``vehicles`` by name and ``team`` with ``eigenvalues``, ``dimension``, ``not_learnable``.
    """
    if excitation.vehicles:
        by_name = {**excitation.vehicles, "team": excitation}
        measured = {name: _measured(single) for name, single in by_name.items()}
        team = measured.pop("team")
        smallest = {name: single.smallest for name, single in by_name.items()}
        shared = {"measured": SHARED, "smallest": smallest}
        return team | shared | {"vehicles": measured, "team": team}
    certificate, reason = excitation.certified
    report = _measured(excitation)
    report |= {name: getattr(certificate, name, None) for name in CERTIFIED}
    report |= {"not_certified": reason} if reason else {}
    along, _ = excitation.along_run
    columns = along.variables.items() if along else ()
    report["along_run"] = {name: finite_or_none(x.values) for name, x in columns}
    recorded = hasattr(excitation.source, "data_vars")
    return report | ({"accuracy": excitation.accuracy} if recorded else {})


def _measured(excitation: Any) -> dict[str, Any]:
    """Return the entries of a single Gramian."""
    values = {axis: array.tolist() for axis, array in excitation.eigenvalues.items()}
    return {name: getattr(excitation, name) for name in MEASURED} | {
        "eigenvalues": values
    }


def result_of(excitation: Any) -> Result:
    """Return a `gramian.Excitation` as a table: each vehicle of a team alone, and all together."""
    team = "team" if excitation.vehicles else ""
    columns = ["", "smallest eigenvalue", "largest", "excited"]
    columns += (
        [] if team else ["upper bound of the smallest", "least excited direction"]
    )
    rows, sentences = [], [f"measured: {SHARED}"] if team else []
    for name, member in {**excitation.vehicles, team: excitation}.items():
        for axis, values in member.eigenvalues.items():
            row = [f"{name} {axis}".strip(), f"{values[0]:.4g}", f"{values[-1]:.4g}"]
            row.append(f"{member.dimension[axis]} of {len(values)}")
            rows.append(row + ([] if team else _direction(member, axis)))
        subject = {"": "", "team": "the team: "}.get(name, f"{name} alone: ")
        sentences += [subject + sentence for sentence in member.not_learnable]
    title = f"Excitation {excitation.span}, {excitation.trajectory}"
    sentences += [] if team else _how_fast(excitation)
    if excitation.without_noise is not excitation:
        sentences.append("excited directions are those of the track without noise")
    return Result(title, columns, rows, sentences)


def learned_text(excitation: Any) -> str:
    """Return the numbers of directions that the law learns within the run, and the time of all."""
    found, unit = excitation.certified[0], f" {excitation.time_unit}".rstrip()
    counts = excitation.counted(found.learned)
    time = found.time_to_tenth
    is_never = time is None or bool(excitation.not_learnable)
    when = "infinite" if is_never else f"at most {at_most(time, 6)}{unit}"
    return (
        f"can be learned within the run, {excitation.run_length:g}{unit}: {counts}; time "
        f"in which the root of V falls to a tenth: {when}"
    )


def repeated_text(excitation: Any) -> str:
    """Return the half-life of the errors, if they are excited."""
    found = excitation.certified[0]
    if found.half_life is None:
        return "not excited, or not enough: errors have no half-life"
    half_life = f"{at_most(found.half_life)} {excitation.time_unit}".rstrip()
    factor = at_most(found.overshoot)
    form = excitation.form
    scale = form.right if form else scale_of(excitation.gains)
    of_errors = at_most(found.overshoot * np.linalg.cond(scale))
    but = ", but for what the disturbance adds" * found.disturbed
    return (
        f"the root of V halves at least every {half_life}, but for a factor {factor}, if the "
        f"window repeats (errors of parameters, from e = 0: a factor {of_errors}){but}"
    )


def _direction(excitation: Any, axis: str) -> list[str]:
    """Return the upper bound of the smallest eigenvalue, and the least excited direction."""
    ceiling = excitation.ceilings.get(axis)
    loads = excitation.least_excited[axis].items()
    visible = [load for load in loads if abs(load[1]) >= 0.005]  # 0.00 is left out
    largest = sorted(visible, key=lambda load: -abs(load[1]))[:4]
    listed = ", ".join(f"{name} {share:+z.2f}" for name, share in largest)
    return ["-" if ceiling is None else at_most(ceiling), listed]


def _how_fast(excitation: Any) -> Iterator[str]:
    """Yield sentences on the decay of errors, and on the accuracy."""
    certificate, reason = excitation.certified
    if certificate is None:
        yield f"contraction of V: {reason}"
    else:
        yield f"contraction of V at worst {at_most(certificate.contraction, 6)}"
        yield f"{learned_text(excitation)}, in windows like this one"
        yield repeated_text(excitation)
        yield from _along_run(excitation)
        if certificate.disturbed:
            yield "V and errors fall so but for what the disturbance adds to them"
    if hasattr(excitation.source, "data_vars"):
        change = excitation.accuracy
        yield "accuracy of the eigenvalues: " + (
            "not known: the samples are too far apart. Use a smaller run.output_step"
            if change is None
            else f"{change:.2g} relative"
        )
    if excitation.ceilings:
        yield (
            "the upper bound, for this motion of the vehicle, is int (x' + KD e)^2 dt / "
            "(|theta - alpha_M|^2 + KD^2 + GammaD^2): a vehicle that does not move learns nothing"
        )


def _along_run(excitation: Any) -> Iterator[str]:
    """Yield sentences on |Phi| along the run, and on what it promises ahead."""
    along, reason = excitation.along_run
    if reason:
        yield f"|Phi| along the run: {reason}"
        return
    unit, axes = f" {excitation.time_unit}".rstrip(), ", ".join(excitation.names)
    told = [
        f"{', '.join(map(at_most, row.values))} at {float(row.time):.10g}{unit}"
        for row in along.factor[:: -along.time.size // 4]  # four or fewer
    ]
    most = ", ".join(map(at_most, along.window_factor.max("time").values))
    yield (
        "along this run, and for it alone, the root of V is at most |Phi| times the first "
        f"({axes}): {'; '.join(told)}"
    )
    yield (
        f"ahead by windows only: |Phi| in each window of {excitation.window:g}{unit} of this run "
        f"is at most {most} ({axes}); errors go on to fall so while later windows keep it"
    )


def least_excited_of(excitation: Any) -> dict[str, dict[str, float]]:
    """Unit eigenvector of the smallest eigenvalue, by parameter name."""
    components = {}
    for axis, vectors in excitation.directions.items():
        vector = vectors[:, 0]
        vector = vector * np.sign(vector[np.argmax(np.abs(vector))])
        components[axis] = dict(
            zip(excitation.names[axis], vector.tolist(), strict=True)
        )
    return components


def not_learnable_of(excitation: Any) -> list[str]:
    """Sentences that name the parameters that cannot be learned on this track.

    A parameter whose own direction is not excited has its own sentence; parameters that are
    excited in combinations only share one.
    """
    from ..proofs.statements import listed

    sentences = []
    for single, mixed in _not_learnable_names(excitation):
        sentences += [f"{name} is not learnable on this track" for name in single]
        if mixed:
            sentences.append(
                f"{listed(mixed)!s} are not learnable one by one on this track"
            )
    return sentences


def in_one_sentence_of(excitation: Any) -> str:
    """Summary of `not_learnable`; "" if every parameter is learnable."""
    names = [*chain(*chain(*_not_learnable_names(excitation)))]
    if not names:
        return ""
    text = (
        "parameters that this run cannot tell apart (it excites so many combinations of "
        f"them: {excitation.counted()}): {', '.join(names)}"
    )
    text = shorten(text, 250, placeholder=" ... (`clpt excitation` names all)")
    return f"{text}. Use fewer functions, a longer run, or other waypoints"


def slow_direction_of(excitation: Any, run: Any) -> str:
    """Return a sentence on the direction that a run learns too slowly, or "".

    Its flow parameters end further from the true ones than `OFF` of the largest.
    """
    if "flow_parameters" not in getattr(run, "data_vars", {}):
        return ""
    certificate, _ = excitation.certified
    theta = run.flow_parameters.values
    off = np.abs(run.flow_parameters_estimate.values[-1] - theta).max()
    time = getattr(certificate, "time_to_tenth", None)
    if off <= OFF * np.abs(theta).max() or not time or time <= excitation.run_length:
        return ""
    axis = min(excitation.eigenvalues, key=lambda a: excitation.eigenvalues[a][0])
    unit = excitation.time_unit
    return (
        f"flow parameters end up to {off:.2g} {run.flow_parameters.attrs['units']} off. The track "
        f"hardly shows the direction {_direction(excitation, axis)[1]}: the root of V "
        f"falls to a tenth within {at_most(time, 6)} {unit}, the run has "
        f"{excitation.run_length:g} {unit}. Use a longer run, other waypoints or another kernel"
    )


def _not_learnable_names(excitation: Any) -> Iterator[tuple[list[str], list[str]]]:
    """Yield the parameters of each axis that are not excited, alone and in combinations."""
    for axis, idle in excitation.idle.items():
        length = np.linalg.norm(excitation.directions[axis][:, :idle], axis=1)
        single = length > np.sqrt(1 - INVOLVED**2)
        names = np.array(excitation.names[axis])
        mixed = names[(length > INVOLVED) & ~single]
        yield names[single].tolist(), mixed.tolist()


def draw_excitation(
    excitation: Any, starts: np.ndarray, values: dict[str, np.ndarray], ax: Any
) -> np.ndarray:
    """Draw a `gramian.Excitation` and the eigenvalues (starts, n) of each axis; (2, axes) Axes."""
    columns = len(excitation.names)
    axes = axes_for(ax, 7.6, 6.0, nrows=2, ncols=columns, sharey="row", squeeze=False)
    for (top, bottom), axis in zip(axes.T, excitation.names, strict=True):
        _draw_eigenvalues(top, starts, values[axis], excitation, axis)
        _draw_direction(bottom, excitation, axis)
        bottom.set(ylim=(-1.6, 1.15), yticks=[-1, -0.5, 0, 0.5, 1], axisbelow=True)
    axes[0, 0].set_ylabel(r"eigenvalue of $\int w w^T dt$")
    axes[1, 0].set_ylabel("component")
    legend: dict[str, Any] = {"fontsize": 8, "frameon": False, "loc": "lower left"}
    axes[0, 0].legend(ncols=3, bbox_to_anchor=(0, 1.1), **legend)
    axes[1, -1].legend(**legend)
    return axes


def _draw_eigenvalues(
    ax: "Axes", starts: np.ndarray, values: np.ndarray, excitation: Any, axis: str
) -> None:
    """Draw the eigenvalues of one axis in the sliding window."""
    from matplotlib.ticker import ScalarFormatter

    values = np.maximum(values, LOWEST * values.max())
    rows = ((-1, RED, r"$\kappa_2$, largest"), (0, BLUE, r"$\kappa_1$, smallest"))
    for k, color, label in rows:
        ax.semilogy(starts, values[:, k], ".-", color=color, markersize=3, label=label)
    for line in ax.semilogy(starts, values[:, 1:-1], color=GREY, linewidth=0.7)[:1]:
        line.set_label("others")
    if values.max() < 10.0 * values.min():  # less than a decade: plain numbers
        ax.yaxis.set_major_formatter(ScalarFormatter())
        ax.yaxis.set_minor_formatter(ScalarFormatter())
    style: dict[str, Any] = {"color": "black", "linestyle": ":", "linewidth": 1.0}
    ax.axvline(excitation.start, label="window below", **style)
    if values.max() < 1.01 * values.min():  # rounding is no change
        ax.set_ylim(0.5 * values.min(), 2.0 * values.max())
    unit = excitation.time_unit
    ax.set_xlabel("start of the window" + (f" ({unit})" if unit else ""))
    ax.set_title(f"{axis}: window of {excitation.window:g} {unit}", **TITLE)


def _draw_direction(ax: "Axes", excitation: Any, axis: str) -> None:
    """Draw the least excited direction and the excited shares of one axis."""
    components = excitation.least_excited[axis]
    names = [*components]
    label = "least excited direction"
    ax.bar(names, [*components.values()], width=0.55, color=BLUE, label=label)
    shares = np.linalg.norm(excitation.excited[axis], axis=1)
    ax.plot(names, shares, "D", color=RED, markersize=5, label="excited share")
    ax.axhline(0, color="black", linewidth=0.7)
    ax.tick_params(axis="x", labelsize=8, rotation=90)
    values = excitation.eigenvalues[axis]
    kappa = values[0]
    number = f"{kappa:.3g}" if kappa > LOWEST * values[-1] else "0 to rounding"
    title = rf"{axis}: $\kappa_1$ = {number}, {excitation.span}"
    ax.set_title(title, **TITLE)


def draw_tube(excitation: Any, run: Any, ax: Any) -> "Axes":
    """Draw the root of V along a run, and what an excitation certifies of it from its window on."""
    form, times, start = excitation.form, run.time.values, excitation.start
    V = form.V_along(run) if form else run.lyapunov.values
    ax = axes_for(ax, 7.6, 4.0)
    ax.set_prop_cycle(color=("black", BLUE), linestyle=("-", "--"))
    ax.semilogy(times, V**0.5, label="of the run")
    after = times[times >= start]
    first, found = np.interp(start, times, V**0.5), excitation.certificate()
    tube = (
        first * found.overshoot * 2 ** ((start - after) / (found.half_life or np.inf))
    )
    ax.semilogy(after, tube, label="at most, contraction")
    unit = "" if form else excitation.scenario.units.length
    ax.set_xlabel(f"time ({excitation.time_unit})".removesuffix(" ()"))
    ax.set_ylabel(f"root of V ({unit})".removesuffix(" ()"))
    ax.set_title(f"Errors, if the window {excitation.span} repeats", **TITLE)
    ax.legend(fontsize=8, frameon=False)
    return ax
