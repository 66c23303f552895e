"""What was asked of a run, and what was found, in sentences with numbers and units."""

from typing import Any

from ..html.text import Result
from ..scenario.experiment import Scenario
from .run_numbers import at_end

LEAST_SHARE = 0.01  # percent, that is said
MOST_VEHICLES = 8  # in the table; the summary has all
MOST_CYCLES = 10


def number(value: float) -> str:
    """Return a number as a sentence has it.

    >>> number(0.000123456), number(1234.5), number(0.0)
    ('0.000123', '1230', '0')
    """
    shown = f"{value:.3g}"
    return f"{float(shown):.0f}" if "e+" in shown and abs(value) < 1e6 else shown


def asked(scenario: Scenario, law: str, begin: str = "Asked") -> str:
    """Return what was asked of a scenario's run."""
    run, unit = scenario.run, scenario.units
    count = len(scenario.waypoints)
    rounds = run.duration / scenario.cycle
    return (
        f"{begin}: a vehicle visits {count} waypoint{'s'[: count != 1]} in turn, "
        f"{scenario.reference.dwell:g} {unit.time} at each, for {run.duration:g} {unit.time} "
        f"({rounds:.3g} round{'s'[: rounds != 1]}) in {_water(scenario)}; it predicts where it "
        f"will be, and from the error of that prediction (CLPE) the law {law} "
        + ("is to adapt its gains." if scenario.learning.row.given_estimate else "is to learn it.")
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


def found_of_clpe(numbers: dict[str, Any], length: str) -> str:
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
        f"Found: the CLPE, root mean square, was {number(numbers['clpe_rms'])} {length} over the "
        f"run and {number(numbers['clpe_rms_last_quarter'])} {length} over its last quarter."
    )


def found_of_flow(numbers: dict[str, Any], scenario: Scenario) -> str:
    """Return what was learned of the flow by the end."""
    unit = scenario.units
    said = f"At the end, t = {numbers['end']:g} {unit.time}, "
    parts = []
    if errors := numbers.get("max_flow_parameter_error"):
        largest = max(abs(value) for row in scenario.flow.parameters or () for value in row)
        percent = 100 * at_end(errors) / largest if largest else 0.0
        part = f" ({number(percent)} % of the largest)" if percent >= LEAST_SHARE else ""
        parts.append(
            f"the largest error of a flow parameter is {number(at_end(errors))} "
            f"{unit.length}/{unit.time}{part}"
        )
    shares = numbers.get("explained_variance") or {}
    for place, where in (("track", "along the track"), ("box", "over all of the current's box")):
        share = shares.get(place)
        if isinstance(share, float):
            worse = ", worse than no flow" if share < 0 else ""
            parts.append(
                f"the learned flow explains {100 * share:.0f} % of the current's variance {where}"
                + worse
            )
    if errors := numbers.get("max_gain_error"):
        parts.append(f"the largest error of a gain is {number(at_end(errors))} 1/{unit.time}")
    return said + "; ".join(parts) + "."


def run_result(summary: dict[str, Any], title: str) -> Result:
    """Return what a vehicle achieved in its run, or each of a team's."""
    length, time = summary["units"]["length"], summary["units"]["time"]
    rows = [["status", summary["message"]]]
    if "vehicles" not in summary:
        rows += _achieved(summary, length, time)
        return Result(title, ["", ""], rows)
    graph = f"{summary['coupling']:g}, {summary['connectivity']:.3g}"
    apart = f"{at_end(summary['max_disagreement']):.3g} at t = {summary['end']:g} {time}"
    rows += [["coupling kappa, connectivity lambda_2", graph], ["largest disagreement", apart]]
    for name in summary["vehicles"][:MOST_VEHICLES]:
        own = {key: of[name] for key, of in summary.items() if isinstance(of, dict) and name in of}
        rows += [[f"{name}: {what}", value] for what, value in _achieved(own, length, time)]
    if left := summary["vehicles"][MOST_VEHICLES:]:
        rows.append(["...", f"{len(left)} more vehicles in --json"])
    return Result(title, ["", ""], rows)


def _achieved(numbers: dict[str, Any], length: str, time: str) -> list[list[str]]:
    """Return rows of what one vehicle achieved."""
    rows = []
    if rms := numbers.get("clpe_rms_per_cycle"):
        shown = [
            *(f"{value:.3g}" for value in rms[:MOST_CYCLES]),
            *["..."][: len(rms) > MOST_CYCLES],
        ]
        rows.append([f"CLPE rms per cycle ({length})", ", ".join(shown)])
    rows.append([f"CLPE rms, whole run ({length})", f"{numbers['clpe_rms']:.3g}"])
    late = f"{numbers['clpe_rms_last_quarter']:.3g}"
    rows.append([f"CLPE rms, last quarter ({length})", late])
    if "speed" in numbers:
        share = f"{numbers['speed']['share_at_limit']:.3g}"
        rows.append(["share of time at the speed limit", share])
        if numbers["speed"]["faster_flow"] is None:
            rows.append(["flow faster than the vehicle", "never"])
    for what in ("flow parameter", "gain"):
        if errors := numbers.get(f"max_{what.replace(' ', '_')}_error"):
            end, error = list(errors.items())[-1]
            rows.append([f"largest {what} error", f"{error:.3g} at t = {end} {time}"])
    for place, share in numbers.get("explained_variance", {}).items():
        if isinstance(share, float):
            worse = "; negative: worse than no flow" if share < 0 else ""
            rows.append([f"share of the flow's variance learned, {place}", f"{share:.3f}{worse}"])
    return rows
