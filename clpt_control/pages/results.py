"""What a run achieved, and what its track can teach, as a terminal and a page show it.

A run carries its figures, or they are those of its samples: nothing is run again.  `clpt run` and
`clpt paper` leave mean squares over many samples a cycle in the run.
"""

from typing import Annotated, Any

from pydantic import AfterValidator, BaseModel, Field, ValidationError
from xarray import Dataset

from ..html import Result, shortened
from ..scenario.experiment import Scenario
from ..scenario.file import TEAM
from ..scenario.team import Team
from ..simulation.summary import SUMMARY, ending_of, figures_of
from ..theory.excitation.excitation_report import excitation_report
from ..theory.excitation.pooled import team_excitation_report
from ..units import percent

MOST_VEHICLES = 8  # in the table; the summary has all
MOST_CYCLES = 10
MOST_EIGENVALUES = 20  # in the table; the report has all


Numbers = dict[str, Any]  # figures of a run by name, as `run_and_report` has them
Number = Annotated[float, Field(allow_inf_nan=False)]
Time = Annotated[str, AfterValidator(lambda time: f"{float(time):g}")]


class Shares(BaseModel):
    """The shares of a current's variance that are learned, as `explained_variance` has them."""

    track: Number | None
    box: Number | None


class Speeds(BaseModel):
    """How long a vehicle was at its limit, as `speed_figures` has it."""

    share_at_limit: Number
    faster_flow: dict[str, Number] | None


class Figures(BaseModel):
    """The figures of one vehicle that a run carries, of which pages speak."""

    end: Number
    clpe_rms_per_cycle: list[Number]
    clpe_rms: Number
    clpe_rms_last_quarter: Number
    max_flow_parameter_error: dict[Time, Number] = {}
    max_gain_error: dict[Time, Number] = {}
    explained_variance: Shares | None = None
    speed: Speeds | None = None


def numbers_of(run: Dataset, system: Scenario | Team) -> Numbers:
    """Return a run's figures by the names of `run_and_report`; `of_samples` if they are less."""
    ending = ending_of(system, run)
    try:
        own = Figures.model_validate_json(str(run.attrs.get(SUMMARY, "")), strict=True)
        if own.end == ending["end"]:
            return {**ending, "of_samples": False, **own.model_dump(exclude_unset=True)}
    except ValidationError:  # none, or damaged
        pass
    return {**ending, "of_samples": True, **figures_of(system, run)}


def asked(system: Scenario | Team, law: str, waypoints: int) -> str:
    """Return in a sentence what a run is of, by its scenario or its team."""
    first = system.first if isinstance(system, Team) else system
    run, unit, N = first.run, first.units, first.basis.N
    water = "a measured current" if first.flow.field is not None else f"a flow of {N} functions"
    span = f"for {run.duration:g} {unit.time} in {water}"
    if isinstance(system, Team):
        names = shortened(", ".join(system.members), 80)
        pull = f"{system.coupling:g} 1/{unit.time}"
        return (
            f"{len(system.members)} vehicles ({names}) visit their waypoints {span}; each learns "
            "it from the error of its own predictions (CLPE) and, with a coupling of "
            f"{pull}, from its neighbours."
        )
    way = "follows a desired position given in Python"
    if waypoints:
        way = f"visits {waypoints} waypoints, {first.reference.dwell:g} {unit.time} at each,"
    return (
        f"A vehicle {way} {span}; the law {law} adapts by the error of the vehicle's predictions "
        "(CLPE)."
    )


def run_result(summary: Numbers, title: str, most: int = MOST_VEHICLES) -> Result:
    """Return what a vehicle achieved in its run, or each of a team's, up to the most."""
    length, time = summary["units"]["length"], summary["units"]["time"]
    rows = [["status", summary["message"]]]
    if "vehicles" not in summary:
        rows += _achieved(summary, length, time)
        return Result(title, ["", ""], rows)
    graph = f"{summary['coupling']:g}, {summary['connectivity']:.3g}"
    rows.append([f"coupling kappa (1/{time}), connectivity lambda_2", graph])
    end, apart = list(summary["max_disagreement"].items())[-1]
    rows.append([f"largest disagreement ({length}/{time})", f"{apart:.3g} at t = {end} {time}"])
    by_vehicle = {key: of for key, of in summary.items() if isinstance(of, dict)}
    for name in summary["vehicles"][:most]:
        numbers = {key: of[name] for key, of in by_vehicle.items() if name in of}
        rows += [[f"{name}: {what}", value] for what, value in _achieved(numbers, length, time)]
    if left := summary["vehicles"][most:]:
        rows.append(["...", f"{len(left)} more vehicles in --json"])
    return Result(title, ["", ""], rows)


def _achieved(numbers: Numbers, length: str, time: str) -> list[list[str]]:
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
    for what, unit in (("flow parameter", f"{length}/{time}"), ("gain", f"1/{time}")):
        if by_time := numbers.get(f"max_{what.replace(' ', '_')}_error"):
            end, error = list(by_time.items())[-1]
            rows.append([f"largest {what} error ({unit})", f"{error:.3g} at t = {end} {time}"])
    shares = numbers.get("explained_variance") or {}
    for place in ("track", "box") if shares else ():
        share = shares[place]
        said = "none: the current hardly changes" if share is None else percent(share)
        said += "; negative: worse than the mean current" if (share or 0) < 0 else ""
        rows.append([f"share of the flow's variance learned, {place}", said])
    return rows


def claims_result(found: list[dict[str, str]]) -> Result:
    """Return the claims of section IV, judged."""
    rows = [list(one.values()) for one in found]
    return Result("Claims of section IV", ["claim", "criterion", "measured", "verdict"], rows)


def is_team(source: Any) -> bool:
    """Return whether a scenario or a run is of several vehicles."""
    return isinstance(source, Team) or TEAM in getattr(source, "attrs", {})


def excitation_of(source: Any, window: float | None = None, start: float | None = None) -> Any:
    """Return what a scenario, a team or a run of one can teach over one window, for JSON."""
    return (team_excitation_report if is_team(source) else excitation_report)(source, window, start)


def excitation_result(report: Numbers) -> Result:
    """Return the excitation of a track, or of the tracks of a team, each alone and together."""
    end, unit = report["start"] + report["window"], report["time_unit"]
    title = f"Excitation from {report['start']:g} to {end:g} {unit}, {report['trajectory']}"
    if "vehicles" in report:
        columns = ["", "axis", "smallest eigenvalue", "largest", "can be learned"]
        return Result(title, columns, *_of_a_team(report))
    rows = []
    for axis, values in report["eigenvalues"].items():
        cells = [f"{value:.4g}" for value in values]
        if len(cells) > MOST_EIGENVALUES:
            cells = [*cells[:6], "...", *cells[-3:], f"({len(values)} in all)"]
        rows.append([f"{axis}: eigenvalues", ", ".join(cells)])
        if axis in report["ceilings"]:
            rows.append([f"{axis}: ceiling of the smallest", f"{report['ceilings'][axis]:.4g}"])
        parts = sorted(report["least_excited"][axis].items(), key=lambda part: -abs(part[1]))[:8]
        listed = ", ".join(f"{name} {share:+z.2f}" for name, share in parts)
        rows.append([f"{axis}: least excited direction", listed])
    if report["contraction"] is None:
        rows.append(["contraction of V", report["not_certified"]])
    else:
        time = report["time_to_tenth"]
        within = "never" if time is None else f"{time:.6g} {unit}, in windows like this one"
        rows += [
            ["contraction of V, exact, at worst", f"{report['contraction']:.6g}"],
            ["guaranteed drop of V, rho", f"{report['rho']:.3g}"],
            ["errors fall to a tenth within", within],
        ]
    if "accuracy" in report:
        change = report["accuracy"]
        said = "not known: the samples are too far apart; a smaller run.output_step says more"
        said = said if change is None else f"{change:.2g} relative"
        rows.append(["accuracy of the eigenvalues", said])
    sentences = list(report["not_learnable"])
    if report["disturbed"]:
        sentences.append("V and errors fall so but for what the disturbance adds to them")
    if report["ceilings"]:
        sentences.append(
            "the ceiling of an axis is int (x' + KD e)^2 dt / (|theta - alpha_M|^2 + KD^2 + "
            "GammaD^2): a vehicle that waits teaches nothing"
        )
    return Result(title, ["", ""], rows, sentences)


def _of_a_team(report: Numbers) -> tuple[list[list[str]], list[str]]:
    """Return a row for each axis of each vehicle and of the team, and sentences."""
    rows, sentences = [], [f"measured: {report['measured']}"]
    for name, one in [*report["vehicles"].items(), ("team", report["team"])]:
        for axis, values in one["eigenvalues"].items():
            count = f"{one['dimension'][axis]} of {len(values)}"
            rows.append([name, axis, f"{values[0]:.4g}", f"{values[-1]:.4g}", count])
        who = "the team" if one is report["team"] else f"{name} alone"
        sentences += [f"{who}: {sentence}" for sentence in one["not_learnable"]]
    return rows, sentences
