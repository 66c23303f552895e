"""A fit on disk: SCENARIO.toml and its field beside it, both or none.

The scenario refers to the field by its name alone, so that the two files can
be moved together.
"""

import json
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING

from ..arguments import public
from ..errors import DataError
from ..files import check_writable, write_together
from ..scenario.experiment import Scenario
from ..scenario.file import load_scenario, scenario_to_text
from .field_file import field_dataset

if TYPE_CHECKING:
    from .fit import Fit


@public
def save_fit(fit: "Fit", out: str | Path) -> Scenario:
    """Write a fit as a scenario with its field beside it.

    Parameters
    ----------
    fit : Fit
        From `fit_scenario`.
    out : str or Path
        ``SCENARIO.toml``; the field becomes ``SCENARIO_field.nc``.

    Returns
    -------
    Scenario
        As read back from the file, ready to run.

    Raises
    ------
    DataError
        If the name is not a TOML file's or the folder cannot be written to.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> fit = clpt.currents.fit_scenario("currents.nc")  # doctest: +SKIP
    >>> clpt.simulate(save_fit(fit, "mine.toml"))  # doctest: +SKIP
    """
    out = Path(out)
    if out.suffix != ".toml":
        raise DataError(f"{out}: must end in .toml; the field is written beside it")
    field = out.with_name(f"{out.stem}_field.nc")
    for path in (out, field):
        check_writable(path)
    report, scenario = fit.report, fit.scenario
    attributes = {
        "title": scenario.title,
        "source": f"{report['source']}, by clpt-control {version('clpt-control')}",
        "time_origin": report["start"],
        "origin_latitude_longitude": report["origin"],
        "comment": _gaps(report),
        "fit_report": json.dumps(report),
    }
    text = _header(report) + _named(scenario, field.name)
    write_together({out: text, field: field_dataset(fit.field, scenario.units, attributes)})
    return load_scenario(out)


def _named(scenario: Scenario, field: str) -> str:
    """Return the TOML text with the field's name put in."""
    flow = scenario.flow.model_copy(update={"field": field})
    return scenario_to_text(scenario.model_copy(update={"flow": flow}))


def _gaps(report: dict) -> str:
    return (
        f"{report['missing_fraction']:.1%} of the values were missing and are filled, harmonically "
        f"in space and time; {report['cells_never_measured']} of {report['cells']} cells were "
        "never measured"
    )


def _header(report: dict) -> str:
    """Return the comment lines that say where the scenario came from."""
    box = " ".join(f"{value:g}" for value in report["box"])
    rows, columns = report["places"]
    lines = [
        f"Made by clpt-control {version('clpt-control')} from {report['source']}, "
        f"box {box} (degrees).",
        f"Origin ({report['origin'][0]:.6g} N, {report['origin'][1]:.6g} E), x1 east, x2 north, "
        f"t = 0 at {report['start']}.",
        f"True flow: the measured current; {_gaps(report)}.",
        f"Basis: {rows} x {columns} places, width {report['width']:g} km, "
        f"{', '.join(report['constituents'])}: {report['functions']} functions.",
        f"They explain {report['explained_variance']:.1%} of the measured variance "
        f"({report['samples']} samples); the rest, Delta of Eq. (32), has rms "
        f"{report['residual_rms']:.3g}, at most {report['residual_max']:.3g} km/h; "
        f"condition number {report['condition_number']:.3g}.",
        "The fitted theta is in the field file's attribute fit_report; the learner does not "
        "know it",
        "unless learning.parameters = -theta.",
    ]
    return "".join(f"# {line}\n" for line in lines) + "\n"
