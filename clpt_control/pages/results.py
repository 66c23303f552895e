"""What was asked, and what was found, in sentences and rows with numbers and units.

Of a run, and of what its track can teach: the Gramian of Definition 3.1, and what it means.  A run
carries its figures, or they are those of its samples: nothing is run again.  `clpt run` and
`clpt paper` leave mean squares over many samples a cycle in the run.
"""

from collections.abc import Iterator
from typing import Annotated, Any

from pydantic import AfterValidator, BaseModel, Field, ValidationError
from xarray import Dataset

from ..html import Result
from ..scenario.experiment import Scenario
from ..scenario.file import TEAM
from ..scenario.team import Team
from ..simulation.pieces import clpe_of_samples
from ..simulation.summary import SUMMARY, errors, team_summary
from ..units import percent

LEAST_SHARE = 0.01  # percent, that is said
MOST_VEHICLES = 8  # in the table; the summary has all
MOST_CYCLES = 10
MOST_NAMED = 4  # vehicles in a sentence
SHARES = {"track": "along the track", "box": "over all of the current's box"}
WORSE = "worse than the mean current"
MOST_EIGENVALUES = 20  # in the table; the report has all


Numbers = dict[str, Any]  # figures of a run by name, as `run_and_report` has them
Number = Annotated[float, Field(allow_inf_nan=False)]
Time = Annotated[str, AfterValidator(lambda time: f"{float(time):g}")]


class Shares(BaseModel):
    """The shares of a current's variance that are learned, as `explained_variance` has them."""

    track: Number | None
    box: Number | None
    window: list[Number]


class Figures(BaseModel):
    """The figures of one vehicle that a run carries, of which pages speak."""

    end: Number
    clpe_rms_per_cycle: list[Number]
    clpe_rms: Number
    clpe_rms_last_quarter: Number
    max_flow_parameter_error: dict[Time, Number] = {}
    max_gain_error: dict[Time, Number] = {}
    explained_variance: Shares | None = None


def number(value: float) -> str:
    """Return a number as a sentence has it.

    >>> number(0.000123456), number(1234.5), number(0.0)
    ('0.000123', '1230', '0')
    """
    text = f"{value:.3g}"
    return f"{float(text):.0f}" if "e+" in text and abs(value) < 1e6 else text


def numbers_of(run: Dataset, system: Scenario | Team) -> Numbers:
    """Return a run's figures by the names of `run_and_report`; `of_samples` if they are less."""
    if isinstance(system, Team):
        return {"of_samples": True, **team_summary(system, run, run)}
    try:
        summary = Figures.model_validate_json(str(run.attrs.get(SUMMARY, "")), strict=True)
    except ValidationError:  # none, or damaged
        summary = None
    end = float(run.time[-1])
    if summary is not None and summary.end == end:
        numbers = {"of_samples": False, **summary.model_dump(exclude_unset=True)}
    else:
        numbers = {"of_samples": True, "end": end, **clpe_of_samples(system, run)}
    if f"{end:g}" not in numbers.get("max_gain_error", {}):
        for key, late in errors(system, run, {f"{end:g}": run.isel(time=-1)}).items():
            numbers[key] = {**numbers.get(key, {}), **late}
    return numbers


def of_the_worst(numbers: Numbers) -> Numbers:
    """Return the figures of a team as those of one vehicle, each of the vehicle that is worst."""
    worst = {**numbers, "clpe_rms_per_cycle": []}
    for key in ("clpe_rms", "clpe_rms_last_quarter"):
        worst[key] = max(numbers[key].values())
    for key in ("max_flow_parameter_error", "max_gain_error"):
        if key in numbers:
            each = list(numbers[key].values())
            worst[key] = {time: max(one[time] for one in each) for time in each[0]}
    if "explained_variance" in numbers:
        each = list(numbers["explained_variance"].values())
        worst["explained_variance"] = {
            place: min((one[place] for one in each if one[place] is not None), default=None)
            for place in SHARES
        }
    return worst


def at_end(by_time: dict[str, float]) -> float:
    """Return the last of values by time."""
    return list(by_time.values())[-1]


def asked(scenario: Scenario, law: str, count: int, begin: str) -> str:
    """Return what was asked of a scenario's run with so many waypoints."""
    run, unit = scenario.run, scenario.units
    rounds = run.duration / scenario.cycle
    way = (
        f"visits {count} waypoint{'s'[: count != 1]} in turn, {scenario.reference.dwell:g} "
        f"{unit.time} at each, for {run.duration:g} {unit.time} "
        f"({rounds:.3g} round{'s'[: rounds != 1]})"
    )
    if not count:
        way = "follows a desired position given in Python"
    return (
        f"{begin}: a vehicle {way} in {_water(scenario)}; it predicts where it "
        f"will be, and from the error of that prediction (CLPE) the law {law} "
        + ("is to adapt its gains." if scenario.learning.row.given_estimate else "is to learn it.")
    )


def asked_of_team(team: Team) -> str:
    """Return what was asked of a team's run."""
    unit, names = team.first.units, list(team.members)
    water = "a measured current" if team.first.flow.field is not None else "one flow"
    named = f"{', '.join(names[:-1])} and {names[-1]}"
    if len(names) > MOST_NAMED:
        named = f"{names[0]} to {names[-1]}"
    return (
        f"Asked: {len(names)} vehicles, {named}, each visit their own waypoints for "
        f"{team.run.duration:g} {unit.time} in {water} that none of them knows; each learns it "
        "from its own prediction error (CLPE) and, with a coupling of "
        f"{team.coupling:g} 1/{unit.time}, from its neighbours."
    )


def found_of_clpes(numbers: Numbers, length: str) -> str:
    """Return what became of the prediction errors of a team."""
    late = numbers["clpe_rms_last_quarter"]
    worst = max(late, key=late.__getitem__)
    return (
        f"Found: over the last quarter the CLPE, root mean square, is at most "
        f"{number(late[worst])} {length}, that of {worst}; over the whole run it was at most "
        f"{number(max(numbers['clpe_rms'].values()))} {length}."
    )


def _water(scenario: Scenario) -> str:
    count = scenario.basis.N
    if scenario.flow.field is not None:
        water = "a measured current that it does not know"
    elif scenario.learning.row.given_estimate:
        water = "a flow of which it has an estimate"
    else:
        water = f"a flow that it does not know, of {count} function{'s'[: count != 1]}"
    return water + (" and a disturbance" if scenario.flow.disturbance is not None else "")


def found_of_clpe(numbers: Numbers, length: str) -> str:
    """Return what became of the prediction error."""
    rms = numbers["clpe_rms_per_cycle"]
    if len(rms) > 1 and rms[0] > 0:
        percent = 100 * rms[-1] / rms[0]
        share = f", {number(percent)} % of it" if percent >= LEAST_SHARE else ""
        return (
            f"Found: the CLPE, root mean square, was {number(rms[0])} {length} in the first round "
            f"of the waypoints and {number(rms[-1])} {length} in the last of {len(rms)}{share}."
        )
    return (
        f"Found: the CLPE, root mean square, was {number(numbers['clpe_rms'])} {length} over "
        f"{span_of_means(numbers)} and {number(numbers['clpe_rms_last_quarter'])} {length} over "
        "its last quarter."
    )


def span_of_means(numbers: Numbers) -> str:
    """Return over what mean squares are that are of no round."""
    return "what is shown" if numbers["of_samples"] else "the run"


def shares_of(numbers: Numbers) -> list[tuple[str, float | None, str]]:
    """Return where the learned flow explains which share of the variance; words if less than 0."""
    shares = numbers.get("explained_variance") or {}
    each = [(place, shares[place]) for place in SHARES if place in shares]
    return [(place, share, WORSE if (share or 0) < 0 else "") for place, share in each]


def errors_by_time(
    numbers: Numbers, length: str, time: str
) -> Iterator[tuple[str, str, dict[str, float]]]:
    """Yield what has an error, its unit, and the largest error by time."""
    for what, unit in (("flow parameter", f"{length}/{time}"), ("gain", f"1/{time}")):
        if errors := numbers.get(f"max_{what.replace(' ', '_')}_error"):
            yield what, unit, errors


def found_of_flow(numbers: Numbers, scenario: Scenario) -> str:
    """Return what was learned of the flow by the end."""
    unit = scenario.units
    begin = f"At the end, t = {numbers['end']:g} {unit.time}, "
    parts = []
    if errors := numbers.get("max_flow_parameter_error"):
        largest = max(abs(value) for row in scenario.flow.parameters or () for value in row)
        relative = 100 * at_end(errors) / largest if largest else 0.0
        part = f" ({number(relative)} % of the largest)" if relative >= LEAST_SHARE else ""
        parts.append(
            f"the largest error of a flow parameter is {number(at_end(errors))} "
            f"{unit.length}/{unit.time}{part}"
        )
    for place, share, worse in shares_of(numbers):
        where = SHARES[place]
        parts.append(
            f"the current hardly changes {where}, so there is no variance to explain"
            if share is None
            else f"the learned flow explains {percent(share)} of the current's variance {where}"
            f"{worse and ', '}{worse}"
        )
    if errors := numbers.get("max_gain_error"):
        parts.append(f"the largest error of a gain is {number(at_end(errors))} 1/{unit.time}")
    if apart := numbers.get("max_disagreement"):
        per = f"{unit.length}/{unit.time}"
        parts.append(f"two vehicles differ by at most {number(at_end(apart))} {per}")
    return begin + "; ".join(parts) + "."


def run_result(summary: Numbers, title: str, most: int = MOST_VEHICLES) -> Result:
    """Return what a vehicle achieved in its run, or each of a team's, up to the most."""
    length, time = summary["units"]["length"], summary["units"]["time"]
    rows = [["status", summary["message"]]]
    if "vehicles" not in summary:
        rows += _achieved(summary, length, time)
        return Result(title, ["", ""], rows)
    graph = f"{summary['coupling']:g}, {summary['connectivity']:.3g}"
    apart = f"{at_end(summary['max_disagreement']):.3g} at t = {summary['end']:g} {time}"
    rows.append([f"coupling kappa (1/{time}), connectivity lambda_2", graph])
    rows.append([f"largest disagreement ({length}/{time})", apart])
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
    for what, unit, by_time in errors_by_time(numbers, length, time):
        end, error = list(by_time.items())[-1]
        rows.append([f"largest {what} error ({unit})", f"{error:.3g} at t = {end} {time}"])
    for place, share, worse in shares_of(numbers):
        said = "none: the current hardly changes" if share is None else percent(share)
        said += f"; negative: {worse}" if worse else ""
        rows.append([f"share of the flow's variance learned, {place}", said])
    return rows


def claims_result(found: list[dict[str, str]]) -> Result:
    """Return the claims of section IV, judged."""
    rows = [list(one.values()) for one in found]
    return Result("Claims of section IV", ["claim", "criterion", "measured", "verdict"], rows)


def is_team(source: Any) -> bool:
    """Return whether a scenario or a run is of several vehicles."""
    return isinstance(source, Team) or TEAM in getattr(source, "attrs", {})


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
