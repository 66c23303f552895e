"""A run, read between its samples.

Between two switches of the waypoint a spline of degree 5 joins the samples of a position: it is
continuous at a switch, with a kink there.  zc and the tides are the scenario's own, so that
jumps are exact.  On the paper's scenario, started true, eigenvalues of the Gramian over a cycle
are then within 0.2 % at samples each 1 s and 1e-6 at each 0.2 s; in the first cycle of a run
started at zero, where the learner oscillates, within 16 % and 2e-5.  For any run, `thinned`
shows what changes when every second sample is left out.
"""

from typing import TYPE_CHECKING, Union

import numpy as np

from ...errors import DataError
from ...scenario.experiment import Scenario

if TYPE_CHECKING:
    import xarray

DEGREE = 5
Source = Union[Scenario, "xarray.Dataset"]


def scenario_of(source: Source) -> Scenario:
    """Return a scenario, or that which a run carries in its attributes."""
    from ...scenario.file import TEAM, scenario_of_run

    if isinstance(source, Scenario):
        return source
    if TEAM in source.attrs:
        raise DataError("the run is a team's; clpt.theory.team_gramian measures a team")
    return scenario_of_run(source)


def span_of(source: Source) -> tuple[float, float]:
    """Return the first and last time of a run; a scenario's starts at 0."""
    if isinstance(source, Scenario):
        return 0.0, float(source.run.duration)
    if source.sizes.get("time", 0) < 2:
        raise DataError("the dataset is no run: it needs two times or more")
    return float(source.time[0]), float(source.time[-1])


def thinned(run: "xarray.Dataset") -> "xarray.Dataset":
    """Return a run without every second sample; the first and last stay."""
    last = run.sizes["time"] - 1
    thin = run.isel(time=np.unique([*range(0, last + 1, 2), last]))
    thin.encoding.update(run.encoding)
    return thin


def positions_between(
    run: "xarray.Dataset", name: str, scenario: Scenario, times: np.ndarray
) -> np.ndarray:
    """Return a position of a run between its samples, (pieces, nodes, 2).

    Each row of the times lies within one dwell, whose samples a spline joins.
    """
    from scipy.interpolate import make_interp_spline

    if name not in run:
        raise DataError(f"the dataset is no run: it needs '{name}'")
    if scenario.localization is not None and scenario.localization.interval > 0:
        raise DataError(
            "localization.interval: z of a recorded run jumps at fixes, and is not known between "
            "samples; give the scenario in place of the run"
        )
    t, values = run.time.values, run[name].values
    dwell = scenario.reference.dwell
    number = np.floor(times.mean(1) / dwell).astype(int)
    found = np.empty((*times.shape, 2))
    for j in np.unique(number):
        near = 1e-9 * dwell
        inside = np.flatnonzero((t >= j * dwell - near) & (t <= (j + 1) * dwell + near))
        if len(inside) < 2:  # fewer samples than switches: what can be done with them
            middle = int(np.searchsorted(t, (j + 0.5) * dwell))
            inside = np.arange(max(0, middle - 1), min(len(t), middle + 1))
            inside = inside if len(inside) == 2 else np.arange(len(t) - 2, len(t))
        k = min(DEGREE, len(inside) - 1)
        spline = make_interp_spline(t[inside], values[inside], k - (k + 1) % 2)
        found[number == j] = spline(times[number == j])
    return found
