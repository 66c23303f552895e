"""What a track can teach: eigenvalues of the Gramian of Definition 3.1, and what they mean."""

from typing import TYPE_CHECKING, Any

from ..errors import ClptError
from ..figures import figure_of
from ..html.text import folded, paragraphs, table
from ..scenario.experiment import Scenario
from .page import Drawn, Section

if TYPE_CHECKING:
    import xarray

HEADING = "What the track can teach"
LONG = 400  # letters on what cannot be learned
SLOW = 100  # runs as long as this one
MOST = 3  # parameters named of the least excited direction


def excitation_section(run: "xarray.Dataset", scenario: Scenario) -> Section:
    """Return the excitation over one round of a recorded run, or why it cannot be measured."""
    from ..theory.excitation.plot import excitation_plot
    from ..theory.excitation.report import excitation_report

    try:
        found = excitation_report(run)
        figure = figure_of(excitation_plot, run, found["window"], found["start"])
    except ClptError as error:
        return Section("excitation", HEADING, [paragraphs([f"Not measured: {error}."])])
    caption = (
        "Above, eigenvalues of the Gramian in a window that slides over the run: the smallest says "
        "how fast the slowest combination is learned. Below, that combination in one window."
    )
    drawn = Drawn("excitation", figure, caption, wide=True)
    end = float(run.time[-1])
    said = [paragraphs(_sentences(found, end)), *_not_learnable(found), _table(found)]
    parts: list[str | Drawn] = [*said, drawn]
    return Section("excitation", HEADING, parts)


def _sentences(found: dict[str, Any], run_end: float) -> list[str]:
    end, unit = found["start"] + found["window"], found["time_unit"]
    said = [
        f"Measured from t = {found['start']:g} to {end:g} {unit}, {found['trajectory']}; "
        f"eigenvalues are certain to {100 * found['accuracy']:.2g} %."
    ]
    if not found["not_learnable"]:
        said.append("Every flow parameter and gain can be told apart on this track.")
    if found["contraction"] is None:
        said.append(f"No rate is certified: {found['not_certified']}.")
    else:
        time = found["time_to_tenth"]
        slow = time is not None and time > SLOW * run_end
        said.append(
            "By the theory errors need not fall in such windows."
            if time is None
            else f"Errors fall to a tenth within {time:.3g} {unit} of such windows, at worst"
            + (": of some combination as good as nothing is learned." if slow else ".")
        )
    return said


def _not_learnable(found: dict[str, Any]) -> list[str]:
    """Return what cannot be learned on the track; long lists are folded."""
    said = paragraphs([f"{sentence}." for sentence in found["not_learnable"]])
    if len(said) <= LONG:
        return [said]
    counts = ", ".join(
        f"{found['dimension'][axis]} of {len(values)} along {axis}"
        for axis, values in found["eigenvalues"].items()
    )
    return [
        paragraphs([f"Not all can be learned: {counts}, in some combination."]),
        folded("Which cannot be learned one by one", said),
    ]


def _table(found: dict[str, Any]) -> str:
    rows = []
    for axis, values in found["eigenvalues"].items():
        parts = sorted(found["least_excited"][axis].items(), key=lambda part: -abs(part[1]))[:MOST]
        rows.append(
            [
                axis,
                f"{values[0]:.3g}",
                f"{values[-1]:.3g}",
                f"{found['dimension'][axis]} of {len(values)}",
                ", ".join(f"{name} {share:+.2f}" for name, share in parts),
            ]
        )
    columns = ["axis", "smallest eigenvalue", "largest", "can be learned", "least excited"]
    return table("Eigenvalues over one round of the waypoints", columns, rows)
