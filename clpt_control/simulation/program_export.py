"""Export of a diagram as a program (C99, FMU), of data as a map (KML, GeoJSON, NetCDF).

The ending of the file's name chooses the kind.  Features of a track are the track of the vehicle,
its prediction, the waypoints, start and end.  If the run has a date (`time_origin`), start and end
have their time.  Those of an estimate are the fixes, each with its time, the line through them, and
the regions of their forecasts.
"""

import re
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, overload

import control
import numpy as np

from ..base.arguments import public
from ..base.errors import ClptError, DataError
from ..base.files import check_writable, write_file
from ..base.map_files import BLUE, GREEN, ORANGE, PURPLE, Feature, geojson, kml, ring
from ..base.units import SECONDS, iso, seconds_since_1970
from ..engine.diagram.wiring import Params
from ..paper.scenario.experiment import Scenario
from ..paper.scenario.recorded_run import (
    fixes_of,
    kind_of,
    read_estimate,
    scenario_with,
    waypoints_of,
)
from .c_export import c_file
from .flow_map import flow_map
from .fmu_export import fmu
from .on_board import learner_file

if TYPE_CHECKING:
    import xarray

SUFFIXES = (".kml", ".geojson")  # of tracks
READ = """latitude longitude start_latitude start_longitude end_time forecast_radius
predicted_latitude predicted_longitude position_error leg has_origin"""
NUMBER = re.compile(r"(?<![\w.])(\d+\.\d+(e[-+]?\d+)?|\d+e[-+]?\d+)(?![\w.])")


@overload
def export(
    system: "Scenario | control.InputOutputSystem",
    path: None = None,
    initial_state: Any = None,
    params: Params = None,
    part: str | None = None,
    *,
    single: bool = False,
    watch: Sequence[Any] = (),
) -> str: ...
@overload
def export(
    system: "Scenario | control.InputOutputSystem | xarray.Dataset",
    path: str | Path,
    initial_state: Any = None,
    params: Params = None,
    part: str | None = None,
    *,
    single: bool = False,
    watch: Sequence[Any] = (),
) -> str | None: ...
@public
def export(
    system: "Scenario | control.InputOutputSystem | xarray.Dataset",
    path: str | Path | None = None,
    initial_state: Any = None,
    params: Params = None,
    part: str | None = None,
    *,
    single: bool = False,
    watch: Sequence[control.InputOutputSystem] = (),
) -> str | None:
    """Write a diagram as C99 or an FMU, or a run's track as a map.

    Parameters
    ----------
    system : Scenario, InputOutputSystem or xarray.Dataset
        A scenario stands for its closed loop. A dataset is a run of a scenario with an origin.
    path : str or Path, optional
        ``.c`` or ``.h``: one self-contained file of C99; ``.fmu``: FMI 3.0, model exchange. Of a
        run: its track, ``.kml`` or ``.geojson``, or its `flow_map`, ``.nc``.
    initial_state : array_like, optional
        Start of the program; 0 by default, of a scenario its own.
    params : mapping, optional
        Parameters by name, as in `simulate`.
    part : str, optional
        ``"learner"``: the law, model and controller of a scenario or closed loop alone, for a
        computer on board. The names of its functions begin with the name of the file.
    single : bool, optional
        Write C with ``float`` in place of ``double``.
    watch : sequence of Block, optional
        Blocks that a learner carries beside the law, such as `watch` of `gramian`: bounds of its
        errors, from the transition matrix, with the numbers of the scenario, not of `params`.

    Returns
    -------
    str or None
        The program in C, also without a path; None of an FMU or a map.

    Raises
    ------
    DiagramError
        If a function cannot be traced, or the file's kind does not have the diagram's time.
    DataError
        If the run has no latitude and longitude.
    ClptError
        If the name has another ending, or the file cannot be written.

    Examples
    --------
    >>> import tempfile, clpt_control as clpt
    >>> lag = control.tf(1, [1, 1], name="lag")
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     text = clpt.export(lag, f"{folder}/lag.c")
    >>> "void lag_step(" in text
    True
    """
    if part not in (None, "learner"):
        raise ClptError(f"part = '{part}': must be 'learner', or left out")
    if watch and not part:
        raise ClptError("watch: is of part='learner'. Give that too, or leave it out")
    if not isinstance(system, Scenario | control.InputOutputSystem):
        if path is None:
            raise ClptError(
                "path: is required for a run. Give a .kml, .geojson or .nc file"
            )
        path = Path(path)
        check_writable(path, "a map", (*SUFFIXES, ".nc"))
        is_flow = path.suffix == ".nc"
        write_file(
            path, flow_map(system) if is_flow else track_text(system, path.suffix)
        )
        return None
    if path is not None:
        path = Path(path)
        is_plain = part is None and not single
        kind = "a program" + " of a part or in single precision" * (not is_plain)
        check_writable(path, kind, (".c", ".h", *(".fmu",) * is_plain))
    if part is None:
        file = c_file(system, initial_state, params)
    else:
        name = "learner" if path is None else path.stem
        file = learner_file(system, name, initial_state, params, watch)
    if path is not None and path.suffix == ".fmu":
        write_file(path, fmu(file))
        return None
    text = in_single_precision(file.text) if single else file.text
    if path is not None:
        write_file(path, text)
    return text


def in_single_precision(text: str) -> str:
    """Return a C file with float for double; functions become those of float by tgmath.h."""
    text = re.sub(r"\bdouble\b", "float", text).replace("math.h", "tgmath.h")
    head, include, code = text.partition("#include")
    return head + include + NUMBER.sub(r"\g<0>f", code)


# --- track of a run ------------------------------------------------------------------------------


def track_text(data: "xarray.Dataset", suffix: str) -> str:
    """Return the track of a run or an estimate as KML or GeoJSON, by the ending of a name."""
    is_estimate = kind_of(data) == "fixes"
    features = fixes_on_map(data) if is_estimate else run_on_map(data)
    title = str(data.attrs.get("title", "")) or ("fixes" if is_estimate else "run")
    return kml(features, title) if suffix == ".kml" else geojson(features)


def fixes_on_map(data: "xarray.Dataset") -> list[Feature]:
    """Return the fixes of an estimate, the line through them and the regions of forecasts."""
    estimate, _ = read_estimate(data, READ)
    if not estimate.attrs["has_origin"]:
        raise DataError("the estimate has no latitude and longitude: its run has none")
    fixes = np.column_stack([estimate.latitude, estimate.longitude])
    track = fixes_of(estimate)[0].T
    features = [Feature("track", "LineString", track, BLUE)]
    for k, fix in enumerate(fixes):
        leg = estimate.isel(leg=k)
        predicted = float(leg.predicted_latitude), float(leg.predicted_longitude)
        radius = float(leg.forecast_radius)
        off = float(np.hypot(*leg.position_error.values))
        time = iso(seconds_since_1970(str(leg.end_time.values)[:23]))
        name = f"leg {int(leg.leg)}"
        words = (
            f"{off:.0f} m from its forecast, whose region has the radius {radius:.0f} m"
        )
        properties = {"time": time, "error_m": off, "radius_m": radius}
        outline = ring(predicted, (0.0, 0.0), radius, radius, 0.0)
        features += [
            Feature(f"fix of {name}", "Point", [fix], BLUE, time, words, properties),
            Feature(f"region of {name}", "Polygon", outline, PURPLE, time),
        ]
    return features


def run_on_map(run: "xarray.Dataset") -> list[Feature]:
    """Return the track of a scenario's run, its prediction, waypoints, start and end."""
    scenario = scenario_with(run, "position")
    if scenario.origin is None:
        raise DataError(
            "the run has no latitude and longitude. Give its scenario an origin: "
            "origin = [41.2, -69.5]"
        )

    def on_earth(points: np.ndarray) -> np.ndarray:
        return np.column_stack(scenario.plane.to_earth(*points.T))

    track = on_earth(run.position.values)
    features = [Feature("track", "LineString", track, BLUE)]
    if "predicted_position" in run:
        predicted = on_earth(run.predicted_position.values)
        features.append(Feature("prediction", "LineString", predicted, GREEN))
    for number, waypoint in enumerate(on_earth(waypoints_of(run, scenario)), 1):
        features.append(Feature(f"waypoint {number}", "Point", [waypoint], ORANGE))
    origin = run.attrs.get("time_origin")
    for name, sample in (("start", 0), ("end", -1)):
        elapsed = round(float(run.time[sample]) * SECONDS[scenario.units.time])
        time = iso(seconds_since_1970(origin) + elapsed) if origin else ""
        properties = {"time": time} if time else {}
        features.append(
            Feature(name, "Point", [track[sample]], BLUE, time, "", properties)
        )
    return features
