"""What a track, or those of a team, can teach: the Gramian of Definition 3.1, and what it means."""

from typing import TYPE_CHECKING, Any

from ..errors import ClptError
from ..figures import figure_of
from ..html import Result, folded, paragraphs, table
from ..scenario.file import TEAM
from ..scenario.team import Team
from ..theory.excitation.plot import excitation_plot
from ..theory.excitation.pooled import team_excitation_report
from ..theory.excitation.report import excitation_report
from .page import Drawn, Section

if TYPE_CHECKING:
    import xarray

LONG = 400  # letters on what cannot be learned
MOST = 20  # eigenvalues in the table; the report has all


def is_team(source: Any) -> bool:
    """Return whether a scenario or a run is of several vehicles."""
    return isinstance(source, Team) or TEAM in getattr(source, "attrs", {})


def excitation_of(source: Any, window: float | None = None, start: float | None = None) -> Any:
    """Return what a scenario, a team or a run of one can teach over one window, for JSON."""
    return (team_excitation_report if is_team(source) else excitation_report)(source, window, start)


def excitation_section(run: "xarray.Dataset") -> Section:
    """Return the excitation over one round of a recorded run, or why it cannot be measured."""
    team = is_team(run)
    heading = f"What the track{'s' if team else ''} can teach"
    try:
        report = excitation_of(run)
        drawn = [] if team else [_drawn(run, report)]
    except ClptError as error:
        return Section("excitation", heading, [paragraphs([f"Not measured: {error}."])])
    found = excitation_result(report)
    said = paragraphs([f"{sentence}." for sentence in found.sentences])
    if len(said) > LONG:
        said = folded("What cannot be learned one by one", said)
    return Section("excitation", heading, [table(*found[:3]), said, *drawn])


def _drawn(run: "xarray.Dataset", report: dict[str, Any]) -> Drawn:
    figure = figure_of(excitation_plot, run, report["window"], report["start"])
    caption = (
        "Above, eigenvalues of the Gramian in a window that slides over the run: the smallest says "
        "how fast the slowest combination is learned. Below, that combination in one window."
    )
    return Drawn("excitation", figure, caption, wide=True)


def excitation_result(report: dict[str, Any]) -> Result:
    """Return what a track can teach, or the tracks of a team, each alone and together."""
    end, unit = report["start"] + report["window"], report["time_unit"]
    title = f"Excitation from {report['start']:g} to {end:g} {unit}, {report['trajectory']}"
    if "vehicles" in report:
        columns = ["", "axis", "smallest eigenvalue", "largest", "can be learned"]
        return Result(title, columns, *_of_a_team(report))
    rows = []
    for axis, values in report["eigenvalues"].items():
        shown = [f"{value:.4g}" for value in values]
        if len(shown) > MOST:
            shown = [*shown[:6], "...", *shown[-3:], f"({len(values)} in all)"]
        rows.append([f"{axis}: eigenvalues", ", ".join(shown)])
        if axis in report["ceilings"]:
            rows.append([f"{axis}: ceiling of the smallest", f"{report['ceilings'][axis]:.4g}"])
        parts = sorted(report["least_excited"][axis].items(), key=lambda part: -abs(part[1]))[:8]
        listed = ", ".join(f"{name} {share:+.2f}" for name, share in parts)
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
        rows.append(["accuracy of the eigenvalues", f"{report['accuracy']:.2g} relative"])
    said = list(report["not_learnable"])
    if report["ceilings"]:
        said.append(
            "the ceiling of an axis is int (x' + KD e)^2 dt / (|theta - alpha_M|^2 + KD^2 + "
            "GammaD^2): a vehicle that waits teaches nothing"
        )
    return Result(title, ["", ""], rows, said)


def _of_a_team(report: dict[str, Any]) -> tuple[list[list[str]], list[str]]:
    """Return a row for each axis of each vehicle and of the team, and sentences."""
    rows, said = [], [f"measured: {report['measured']}"]
    for name, one in [*report["vehicles"].items(), ("team", report["team"])]:
        for axis, values in one["eigenvalues"].items():
            learned = f"{one['dimension'][axis]} of {len(values)}"
            rows.append([name, axis, f"{values[0]:.4g}", f"{values[-1]:.4g}", learned])
        who = "the team" if one is report["team"] else f"{name} alone"
        said += [f"{who}: {sentence}" for sentence in one["not_learnable"]]
    return rows, said
