"""Results of runs and tracks as tables, for the terminal and for pages.

A run carries its figures, or they are those of its samples: nothing is run again.  `clpt run` and
`clpt paper` leave mean squares over many samples a cycle in the run.
"""

import json
from contextlib import suppress
from typing import Any

from xarray import Dataset

from ...base.html import Result, shortened
from ...base.units import percent
from ...paper.scenario.experiment import Scenario
from ...paper.scenario.recorded_run import kind_of
from ...paper.scenario.team import Team
from ...simulation.summary import SUMMARY, ending_of, figures_of

MOST_CYCLES = 10
AT_FLOOR = 0.9  # explained variance: the rest of CLPE is flow that no function has
REMEDY = "Try another law (`clpt tune`), held gains, or less lag in the vehicle: see docs/laws.md"


OF_A_RUN = (  # figures that a run carries, of which pages speak
    "clpe_rms_per_cycle",
    "clpe_rms",
    "clpe_rms_last_quarter",
    "max_flow_parameter_error",
    "flow_error",
    "max_gain_error",
    "explained_variance",
    "speed",
)
Summary = dict[str, Any]  # figures of a run by name, as `run_and_report` has them


def numbers_of(run: Dataset, system: Scenario | Team) -> Summary:
    """Return a run's figures by the names of `run_and_report`; `of_samples` if they are less.

    Those that the run carries count if they are of its own end and can be shown.
    """
    ending = ending_of(system, run)
    with suppress(
        LookupError,
        ArithmeticError,
        TypeError,
        ValueError,
        AttributeError,
        RecursionError,
    ):
        # NaN is no number
        figures = json.loads(str(run.attrs.get(SUMMARY)), parse_constant=int)
        numbers = {
            **ending,
            "of_samples": False,
            **{k: figures[k] for k in OF_A_RUN if k in figures},
        }
        run_result(numbers, "")
        if figures["end"] == ending["end"]:
            return numbers
    return {**ending, "of_samples": True, **figures_of(system, run, run, run)}


def asked(system: Scenario | Team, waypoints: int) -> str:
    """Return in a sentence what a run is of, by its scenario or its team."""
    if isinstance(system, Team):
        scenario = system.first
        names = shortened(", ".join(system.members), 80)
        subject = f"{len(system.members)} vehicles, {names},"
    else:
        scenario = system
        subject = "A vehicle"
        if waypoints:
            dwell = f"{scenario.reference.dwell:g} {scenario.units.time}"
            subject += f" at {waypoints} waypoints, {dwell} at each,"
    measured = scenario.flow.field is not None
    functions = (scenario.flow.basis or scenario.basis).N
    count = "1 function" if functions == 1 else f"{functions} functions"
    water = "a measured current" if measured else f"a flow of {count}"
    span = f"{scenario.run.duration:g} {scenario.units.time}"
    return f"{subject} for {span} in {water}; law {scenario.learning.law}"


def run_result(summary: Summary, title: str) -> Result:
    """Return what a vehicle achieved in its run, or each of a team's."""
    length = summary["units"]["length"]
    time = summary["units"]["time"]
    rows = [["status", summary["message"]]]
    if "vehicles" not in summary:
        rows += _achieved(summary, length, time)
        return Result(title, ["", ""], rows, learning_advice({"": summary}))
    graph = f"{summary['coupling']:g}, {summary['connectivity']:.3g}"
    rows.append([f"coupling kappa (1/{time}), connectivity lambda_2", graph])
    *_, (end, disagreement) = summary["max_disagreement"].items()
    rows.append(
        [
            f"largest disagreement ({length}/{time})",
            f"{disagreement:.3g} at t = {end} {time}",
        ]
    )
    by_key = {key: of for key, of in summary.items() if isinstance(of, dict)}
    by_vehicle = {}
    for name in summary["vehicles"]:
        numbers = {key: of[name] for key, of in by_key.items() if name in of}
        by_vehicle[f"{name}: "] = numbers
        rows += [
            [f"{name}: {quantity}", value]
            for quantity, value in _achieved(numbers, length, time)
        ]
    return Result(title, ["", ""], rows, learning_advice(by_vehicle))


def learning_advice(by_vehicle: dict[str, Summary]) -> list[str]:
    """Return a sentence for each vehicle that did not learn, with the remedy."""
    sentences = []
    for vehicle, numbers in by_vehicle.items():
        faults = []
        rms = numbers.get("clpe_rms_per_cycle") or []
        shares = numbers.get("explained_variance") or {}
        at_floor = (shares.get("track") or 0) > AT_FLOOR
        if len(rms) > 1 and rms[-1] > rms[0] and not at_floor:
            faults.append("CLPE does not fall: its last cycle is above the first")
        if any((shares.get(where) or 0) < 0 for where in ("track", "box")):
            faults.append("the flow learned is worse than the mean current")
        if faults:
            sentences.append(f"{vehicle}{'; '.join(faults)}. {REMEDY}")
    return sentences


def _achieved(numbers: Summary, length: str, time: str) -> list[list[str]]:
    """Return rows of what one vehicle achieved."""
    rows = []
    if rms := numbers.get("clpe_rms_per_cycle"):
        values = [f"{value:.3g}" for value in rms[:MOST_CYCLES]]
        values += ["..."] if len(rms) > MOST_CYCLES else []
        rows.append([f"CLPE rms per cycle ({length})", ", ".join(values)])
    rows.append([f"CLPE rms, whole run ({length})", f"{numbers['clpe_rms']:.3g}"])
    late = f"{numbers['clpe_rms_last_quarter']:.3g}"
    rows.append([f"CLPE rms, last quarter ({length})", late])
    if "speed" in numbers:
        at_limit = f"{numbers['speed']['share_at_limit']:.3g}"
        rows.append(["share of time at the speed limit", at_limit])
        if numbers["speed"]["faster_flow"] is None:
            rows.append(["flow faster than the vehicle", "never"])
    for region, error in (numbers.get("flow_error") or {}).items():
        name = f"rms error of the learned flow, {region} ({length}/{time})"
        rows.append([name, f"{error:.3g}"])
    for quantity, unit in (
        ("flow parameter", f"{length}/{time}"),
        ("gain", f"1/{time}"),
    ):
        if by_time := numbers.get(f"max_{quantity.replace(' ', '_')}_error"):
            *_, (end, error) = by_time.items()
            rows.append(
                [
                    f"largest {quantity} error ({unit})",
                    f"{error:.3g} at t = {end} {time}",
                ]
            )
    shares = numbers.get("explained_variance") or {}
    for region in ("track", "box") if shares else ():
        share = shares[region]
        text = "none: the current hardly changes" if share is None else percent(share)
        text += "; negative: worse than the mean current" if (share or 0) < 0 else ""
        rows.append([f"share of the flow's variance learned, {region}", text])
    return rows


def claims_result(claims: list[dict[str, str]]) -> Result:
    """Return the claims of section IV, judged."""
    rows = [list(claim.values()) for claim in claims]
    return Result(
        "Claims of section IV", ["claim", "criterion", "measured", "verdict"], rows
    )


def is_team(source: Any) -> bool:
    """Return whether a scenario or a run is of several vehicles."""
    return isinstance(source, Team) or (
        hasattr(source, "attrs") and kind_of(source) == "team"
    )
