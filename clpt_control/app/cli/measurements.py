"""Commands on measurements: `clpt fit` and `clpt estimate`."""

from pathlib import Path

import clpt_control as clpt

from ...base.errors import DataError, ScenarioError
from ...base.html import Result
from ...base.units import finite_or_none, percent
from .printing import Json, Report, arg, cell_text, check_out, finish, flag, opt

MOSTLY = 0.5  # least share of the variance that functions should explain


def fit(
    currents: Path = arg(
        "FILE",
        "NetCDF file of a gridded current, Zarr, or a folder of files; with --tides a record.",
    ),
    out: Path | None = opt(
        "SCENARIO", "Scenario file to write; the field lies beside it."
    ),
    box: tuple[float, float, float, float] | None = opt(
        "LAT0 LAT1 LON0 LON1", "Degrees; default: the whole grid."
    ),
    rows: int = opt("COUNT", "Centers of functions, south to north.", default=3),
    columns: int = opt("COUNT", "Centers of functions, west to east.", default=3),
    width_km: float | None = opt(
        "KM",
        "Width of the Gaussians, km; default: 0.6 of the distance between centers.",
    ),
    constituents: str | None = opt(
        "NAMES",
        "steady and named tides; default: steady,M2. With --tides such as M2,S2,K1, or auto: all "
        "that are distinguishable.",
    ),
    units: str | None = opt(
        "UNIT", "Units of u and v, such as m/s, if the file has none."
    ),
    u: str | None = opt("NAME", "Variable of the eastward velocity; needs --v."),
    v: str | None = opt("NAME", "Variable of the northward velocity; needs --u."),
    tides: bool = flag(
        "Fit tidal constituents to a record at one place instead.", "--tides"
    ),
    latitude: float | None = opt(
        "DEGREES", "With --tides: degrees north; default: the file's own."
    ),
    at: tuple[float, float] | None = opt(
        "LAT LON", "With --tides: degrees, the nearest cell of a grid."
    ),
    as_json: Json = False,
) -> None:
    """Make a scenario in a measured current, or fit tides to a record.

    Example:
        clpt fit currents.nc --box 40.9 41.55 -69.9 -69.0 --out mine.toml
        clpt fit record.nc --tides --constituents M2,S2,K1
    """
    if (u is None) != (v is None):
        raise ScenarioError("--u and --v: one is missing. Give both names")
    if tides:
        if u is not None:
            raise ScenarioError("--u, --v: not with --tides. Name the columns u and v")
        if constituents is None:
            raise ScenarioError("--tides: needs --constituents, such as M2,S2, or auto")
        _fit_tides(currents, constituents, latitude, at, units, as_json)
        return
    if out is None:
        raise ScenarioError("--out: is missing. Give the scenario file to write")
    names = tuple(name.strip() for name in (constituents or "steady,M2").split(","))
    from ...theory.excitation.gramian import not_learned

    fitted = clpt.currents.fit_current(
        currents,
        box,
        rows=rows,
        columns=columns,
        width_km=width_km,
        constituents=names,
        units=units,
        names=None if u is None or v is None else {"u": u, "v": v},
    )
    scenario = fitted.save(out)
    length, speed = fitted.report["width_units"], fitted.report["speed_units"]
    unit_of = dict.fromkeys(("track_radius", "width"), f" {length}")
    unit_of |= dict.fromkeys(("residual_rms", "residual_max"), f" {speed}")
    lines = [
        [key.replace("_", " "), cell_text(value) + unit_of.get(key, "")]
        for key, value in fitted.report.items()
        if key not in ("theta", "width_units", "speed_units")
    ]
    missing = not_learned(scenario)
    sentences = [
        sentence
        for sentence in (_explained_too_little(fitted.report), missing)
        if sentence
    ]
    result = Result(
        f"Wrote {out}, with the field next to it", ["", ""], lines, sentences
    )
    finish([result], fitted.report | {"not_learnable": missing}, as_json)


def _explained_too_little(fit: Report) -> str:
    """Return a warning if the functions fit the current badly, with the remedy."""
    explained = fit["explained_variance"] or 0
    if explained < 0:
        return "the fit is worse than the mean current alone; --width-km wider than that may do"
    if explained < MOSTLY:
        return (
            f"the functions explain {percent(explained)} of the current's variance: no law learns "
            "more of the box; more --constituents, --rows and --columns, or a smaller --box, may do"
        )
    return ""


def _fit_tides(
    record: Path,
    constituents: str,
    latitude: float | None,
    at: tuple[float, float] | None,
    units: str | None,
    as_json: bool,
) -> None:
    """Print the tidal constants of a record."""
    from ...ocean.currents.tidal_constants import tides_report

    measured = clpt.currents.read_record(record, latitude, at, units)
    names = [name.strip() for name in constituents.split(",")]
    current = measured.time, measured.u, measured.v, measured.latitude
    fit = clpt.currents.fit_tides(*current, names, where=str(record))
    report = {"source": measured.source, **tides_report(fit)}
    finish([tides_result(report)], report, as_json)


def tides_result(report: Report) -> Result:
    """Return tidal constants: a row per constituent, then the whole."""
    rows = []
    for name, constituent in report["constituents"].items():
        row = [name]
        for key, error in constituent["standard_errors"].items():
            digits = 4 if key in ("east", "north", "major", "minor") else 1
            words = "any" if error is None else f"{error:.{digits}f}"
            row.append(f"{constituent[key]:z.{digits}f} ({words})")
        rows.append(row)
    title = (
        f"Tides of {report['source']}: amplitudes and axes in m/s, Greenwich phases and "
        "inclination in degrees (standard error)"
    )
    east, north = report["mean"]
    sentences = [
        f"{report['samples']} measurements over {report['hours']:.6g} h from "
        f"{report['start'][:16]} UTC, latitude {report['latitude']:g}",
        f"mean current: {east:+z.4f} east, {north:+z.4f} north (m/s)",
        f"explained: {percent(report['explained_variance'])} of the variance; residual rms "
        f"{report['residual_rms']:.4f} m/s",
    ]
    columns = [
        "",
        "east",
        "phase",
        "north",
        "phase",
        "major",
        "minor",
        "incl.",
        "phase",
    ]
    return Result(title, columns, rows, sentences)


def estimate(
    run: Path = arg("RUN", "A run's NetCDF, as clpt run writes it."),
    method: str = opt("NAME", "least-squares or kalman.", default="least-squares"),
    every: float | None = opt(
        "TIME", "Time between fixes; a tenth of reference.dwell."
    ),
    prior: float | None = opt(
        "SPEED", "Standard deviation of each theta before any fix."
    ),
    noise: float | None = opt("LENGTH", "Standard deviation of a miss between fixes."),
    until: float | None = opt("TIME", "Use the run up to this time."),
    out: Path | None = opt(
        "FILE", "Scenario file to write: the run's, with the estimate given."
    ),
    as_json: Json = False,
) -> None:
    """Estimate the flow from fixes of a run, for the known-flow law.

    Example:
        clpt estimate run.nc --method kalman --out known.toml
    """
    import numpy as np

    from ...ocean.estimation.run_segments import run_scenario

    if run.suffix != ".nc":
        raise DataError(
            f"{run}: is not a run. Make a run with: clpt run {run} --out run.nc"
        )
    check_out(out, "a scenario")
    data = clpt.load_run(run)
    scenario = run_scenario(data)
    if until is not None:
        if not data.time.values[1] < until <= data.time.values[-1]:
            raise ScenarioError(f"--until {until:g}: must lie within the run")
        data = data.sel(time=slice(None, until * (1 + 1e-12)))
    fitted_flow = clpt.currents.flow_estimate(
        data, method, every=every, prior=prior, noise=noise
    )
    if out is not None:
        fed = clpt.currents.known_flow_scenario(scenario, fitted_flow.theta)
        clpt.save_scenario(fed, out)
    sd, length = fitted_flow.standard_deviation, scenario.units.length
    speed = f"{length}/{scenario.units.time}"
    report = {
        "method": method,
        "units": {"length": length, "time": scenario.units.time},
        "fixes": len(fitted_flow.misses) + 1,
        "theta": fitted_flow.theta.tolist(),
        "standard_deviation": sd.tolist(),
        "condition_number": finite_or_none(fitted_flow.condition_number),
        "rms_of_misses_left": float(
            np.sqrt(np.mean(np.sum(fitted_flow.misses**2, axis=1)))
        ),
        "steps": len(fitted_flow.steps),
    }
    if scenario.flow.parameters is not None:
        error = np.abs(fitted_flow.theta - np.array(scenario.flow.parameters))
        report["largest_error"] = float(error.max())
    rows = [
        [
            str(k + 1),
            *(f"{fitted_flow.theta[i, k]:#.4g}" for i in range(2)),
            f"{sd[k]:.1e}",
        ]
        for k in range(len(sd))
    ]
    names = "theta_1", "theta_2", "standard deviation"
    columns = ["function", *(f"{name} ({speed})" for name in names)]
    units = {
        "condition_number": "",
        "rms_of_misses_left": length,
        "largest_error": speed,
    }
    sentences = [
        f"{key.replace('_', ' ')}: {cell_text(report[key])} {unit}".rstrip()
        for key, unit in units.items()
        if report.get(key) is not None
    ]
    if out is not None:
        sentences.append(f"Wrote {out}, with law = known-flow and this estimate")
    title = f"{run}: {method}, {report['fixes']} fixes"
    finish([Result(title, columns, rows, sentences)], report, as_json)
