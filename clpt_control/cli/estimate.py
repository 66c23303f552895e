"""`clpt estimate`: theta from a run's fixes, for the known-flow law."""

from pathlib import Path
from typing import Annotated

from ..html.text import Result
from .help_pages import arg, one_of, opt
from .printing import Json, finish, shown


def estimate(
    run: Annotated[Path, arg("RUN", "A run's NetCDF, as clpt run writes it.")],
    method: Annotated[
        str,
        opt(
            "NAME",
            "least-squares, kalman or tomography.",
            autocompletion=one_of("least-squares", "kalman", "tomography"),
        ),
    ] = "least-squares",
    every: Annotated[
        float | None, opt("TIME", "Time between fixes; a tenth of reference.dwell.")
    ] = None,
    prior: Annotated[
        float | None, opt("SPEED", "Standard deviation of each theta before any fix.")
    ] = None,
    noise: Annotated[
        float | None, opt("LENGTH", "Standard deviation of a miss between fixes.")
    ] = None,
    until: Annotated[float | None, opt("TIME", "Use the run up to this time.")] = None,
    out: Annotated[
        Path | None, opt("FILE", "Scenario file to write: the run's, with the estimate given.")
    ] = None,
    as_json: Json = False,
) -> None:
    """Estimate the flow from fix to fix, for the known-flow law.

    Example:
        clpt estimate run.nc --method kalman --out known.toml
    """
    import numpy as np

    from ..errors import DataError, ScenarioError
    from ..estimation.segments import run_scenario
    from ..estimation.theta_from_fixes import METHODS, flow_estimate, known_flow_scenario
    from ..scenario.file import save_scenario
    from ..simulation.run_file import load_run

    if method not in METHODS:
        raise ScenarioError(f"--method {method}: must be one of {', '.join(METHODS)}")
    if run.suffix != ".nc":
        raise DataError(f"{run}: is no run; `clpt run {run} --out run.nc` makes one of a scenario")
    data = load_run(run)
    scenario = run_scenario(data)
    if until is not None:
        if not data.time.values[1] < until <= data.time.values[-1]:
            raise ScenarioError(f"--until {until:g}: must lie within the run")
        data = data.sel(time=slice(None, until * (1 + 1e-12)))
    found = flow_estimate(data, method, every=every, prior=prior, noise=noise)
    if out is not None:
        save_scenario(known_flow_scenario(scenario, found.theta), out)
    sd, speed = found.standard_deviation, f"{scenario.units.length}/{scenario.units.time}"
    condition = found.condition_number
    report = {
        "method": method,
        "fixes": len(found.misses) + 1,
        "theta": found.theta.tolist(),
        "standard_deviation": sd.tolist(),
        "condition_number": condition if np.isfinite(condition) else None,
        "rms_of_misses_left": float(np.sqrt(np.mean(np.sum(found.misses**2, axis=1)))),
        "steps": len(found.steps),
    }
    if scenario.flow.parameters is not None:
        error = np.abs(found.theta - np.array(scenario.flow.parameters))
        report["largest_error"] = float(error.max())
    rows = [
        [str(k + 1), *(f"{found.theta[i, k]:.4f}" for i in range(2)), f"{sd[k]:.1e}"]
        for k in range(len(sd))
    ]
    columns = ["function", f"theta_1 ({speed})", f"theta_2 ({speed})", "standard deviation"]
    keys = ("condition_number", "rms_of_misses_left", "largest_error")
    known = [key for key in keys if report.get(key) is not None]
    said = [f"{key.replace('_', ' ')}: {shown(report[key])}" for key in known]
    if out is not None:
        said.append(f"{out}: written, with law = known-flow and this estimate")
    title = f"{run}: {method}, {report['fixes']} fixes"
    finish(Result(title, columns, rows, said), report, as_json)
