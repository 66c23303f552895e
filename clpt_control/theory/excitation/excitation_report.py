"""Report of an excitation: numbers for JSON, and the table of `clpt excitation`.

The report has Definition 3.1 over one window, the exact contraction of V of Eq. (24) and its
guaranteed drop, for one trajectory.
"""

from collections.abc import Iterator
from itertools import chain
from textwrap import shorten
from typing import Any

import numpy as np

from ...base.html import Result
from ...base.units import at_least, at_most

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
CERTIFIED = ("rho", "contraction", "drop", "disturbed", "time_to_tenth", "learned")
INVOLVED = 0.05  # smallest length of a parameter's unit vector in a subspace
SHARED = "the flow parameters, which all share, and each one's gains where they adapt"


def report_of(excitation: Any) -> dict[str, Any]:
    """Return a `gramian.Excitation` as JSON values.

    Its entries are ``window``, ``start``, ``time_unit``, ``trajectory``, ``not_learnable``
    (sentences), and by axis ``eigenvalues`` (ascending), ``ceilings`` (of the smallest
    eigenvalue), ``least_excited`` and ``dimension`` (of the excited subspace).

    ``rho`` (guaranteed drop of V), ``contraction`` (exact V(t+T)/V(t) at worst), ``drop``
    (1 - contraction, with all its digits), ``time_to_tenth`` (time in which all errors fall to
    a tenth in windows like this one, or None for never) and ``learned`` (by axis, number of
    directions in which errors do so within ``run_length``) exclude the effect of a disturbance
    if ``disturbed``.  All are None if the window cannot be certified; ``not_certified`` is the
    reason.

    A recorded run has an ``accuracy``: the largest relative change of an eigenvalue if every
    second sample is left out, which is above the error; None if the change is large.
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
    for name, one in {**excitation.vehicles, team: excitation}.items():
        for axis, values in one.eigenvalues.items():
            row = [f"{name} {axis}".strip(), f"{values[0]:.4g}", f"{values[-1]:.4g}"]
            row.append(f"{one.dimension[axis]} of {len(values)}")
            rows.append(row + ([] if team else _direction(one, axis)))
        who = {"": "", "team": "the team: "}.get(name, f"{name} alone: ")
        sentences += [who + said for said in one.not_learnable]
    title = f"Excitation {excitation.span}, {excitation.trajectory}"
    sentences += [] if team else _how_fast(excitation)
    return Result(title, columns, rows, sentences)


def learned_text(excitation: Any) -> str:
    """Return the numbers of directions that the law learns within the run, and the time of all."""
    found, unit = excitation.certified[0], excitation.time_unit
    counts = excitation.counted(found.learned)
    time = found.time_to_tenth
    when = "infinite" if time is None else f"at most {at_most(time, 6)} {unit}"
    return (
        f"can be learned within the run, {excitation.run_length:g} {unit}: {counts}; time "
        f"in which all errors of adapted parameters fall to a tenth: {when}"
    )


def _direction(excitation: Any, axis: str) -> list[str]:
    """Return the upper bound of the smallest eigenvalue, and the least excited direction."""
    ceiling = excitation.ceilings.get(axis)
    parts = excitation.least_excited[axis].items()
    largest = sorted(parts, key=lambda part: -abs(part[1]))[:4]
    listed = ", ".join(f"{what} {share:+z.2f}" for what, share in largest)
    return ["-" if ceiling is None else at_most(ceiling), listed]


def _how_fast(excitation: Any) -> Iterator[str]:
    """Yield sentences on the decay of errors, and on the accuracy."""
    certificate, reason = excitation.certified
    if certificate is None:
        yield f"contraction of V: {reason}"
    else:
        yield (
            f"contraction of V, exact, at worst {at_most(certificate.contraction, 6)}; guaranteed "
            f"drop rho {at_least(certificate.rho, 3)}"
        )
        yield f"{learned_text(excitation)}, in windows like this one"
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
    sentences = []
    for single, mixed in _not_learnable_names(excitation):
        sentences += [f"{name} is not learnable on this track" for name in single]
        if mixed:
            joined = ", ".join(mixed[:-1])
            joined = f"{joined} and {mixed[-1]}" if joined else mixed[0]
            sentences.append(f"{joined} are not learnable one by one on this track")
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


def _not_learnable_names(excitation: Any) -> Iterator[tuple[list[str], list[str]]]:
    """Yield the parameters of each axis that are not excited, alone and in combinations."""
    for axis, idle in excitation.idle.items():
        length = np.linalg.norm(excitation.directions[axis][:, :idle], axis=1)
        single = length > np.sqrt(1 - INVOLVED**2)
        names = np.array(excitation.names[axis])
        mixed = names[(length > INVOLVED) & ~single]
        yield names[single].tolist(), mixed.tolist()
