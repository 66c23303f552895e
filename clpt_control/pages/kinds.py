"""What a file or folder is: a run, a team's run, an ensemble or a replay."""

import json
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import ClptError, DataError
from ..files import open_netcdf
from ..files.reading import read_text
from ..scenario.file import TEAM

if TYPE_CHECKING:
    import xarray

KNOWN = "give run.nc, the folder of an ensemble, or a replay's replay.nc or JSON"
NETCDF = (b"CDF", b"\x89HDF")
NEEDED = {  # variable of a run -> its dimensions, after those of a team
    "position": ("time", "axis"),
    "predicted_position": ("time", "axis"),
    "clpe": ("time", "axis"),
    "feedback_gain": ("time", "axis"),
    "feedforward_gain": ("time", "axis"),
    "flow_parameters_estimate": ("time", "axis", "basis"),
}


def read(path: Path) -> Any:
    """Return what lies there: a run or an ensemble as a Dataset, a replay as its JSON."""
    if os.path.isdir(path):  # noqa: PTH112 - never raises
        return _folder(path)
    if not os.path.exists(path):  # noqa: PTH110 - never raises
        raise DataError(f"{str(path)[:200]}: no such file; {KNOWN}")
    if path.is_file():
        with path.open("rb") as file:
            start = file.read(4)
        if start.startswith(NETCDF):
            return _netcdf(path)
    text = read_text(path, f"is nothing that clpt writes; {KNOWN}")
    if not text.lstrip().startswith("{"):
        hint = (
            "is a scenario, or text; `clpt run` runs a scenario; " if path.suffix == ".toml" else ""
        )
        raise DataError(f"{path}: {hint or 'is nothing that clpt report reads; '}{KNOWN}")
    try:
        found = json.loads(text, parse_constant=_no_number)
    except (ValueError, RecursionError) as error:
        raise DataError(f"{path}: is no whole JSON: {str(error)[:80]}; {KNOWN}") from None
    return checked_replay(found, str(path))


def _no_number(name: str) -> None:
    raise ValueError(f"{name} is no number of JSON")


def _folder(path: Path) -> "xarray.Dataset":
    from ..ensemble.store import open_store

    if (path / "zarr.json").is_file():
        store = open_store(path, mode="r")
        try:
            data = store.dataset()
            for array in data.variables.values():
                if "time" not in array.dims:  # a page shows no trajectory
                    array.load()
        except Exception:  # a damaged file can raise anything
            raise DataError(
                f"{path}: is damaged: a part of it cannot be read; run the ensemble again"
            ) from None
        return data
    inside = [path / name for name in ("run.nc", "replay.nc") if (path / name).is_file()]
    raise DataError(
        f"{path}: is a folder without an ensemble; " + (f"give {inside[0]}" if inside else KNOWN)
    )


def _netcdf(path: Path) -> Any:
    from ..simulation.run_file import load_run

    with open_netcdf(path) as data:
        if "dive" in data.dims:
            return checked_replay(data, str(path))
        if "clpe" not in data.variables:
            raise DataError(f"{path}: is NetCDF, but no run and no replay; {KNOWN}")
    return load_run(path)


def checked_replay(found: Any, name: str) -> dict[str, Any]:
    """Return the JSON of a replay or of its dataset; refuse other JSON, and one without a dive."""
    from ..replay.dataset import carried
    from ..replay.outcome import summary
    from ..replay.surfacing import next_dive

    if "dive" in getattr(found, "dims", ()):
        found = carried(found, name)
    elif hasattr(found, "steps"):
        ahead = next_dive(found).as_dict() if found.steps else None
        found = {**summary(found), "next_dive": ahead}
    if not (isinstance(found, dict) and "each_dive" in found and "next_dive" in found):
        raise DataError(f"{name}: is JSON, but not what `clpt replay --json` prints; {KNOWN}")
    if not found["each_dive"] or found["next_dive"] is None:
        raise DataError(f"{name}: is a replay without a dive; there is nothing to show yet")
    return {"vehicle": "glider", "aim": [], **found}


def checked_run(run: "xarray.Dataset") -> None:
    """Refuse a dataset that is no whole run, or whose numbers are not finite."""
    for name, dims in {"time": ("time",), **NEEDED}.items():
        if name not in run.variables or run[name].dims[-len(dims) :] != dims:
            raise DataError(
                f"the run has no {name} over {', '.join(dims)}; clpt.simulate(scenario) makes runs"
            )
        values = run[name].values
        if not values.size:
            raise DataError("the run has no sample; there is nothing to show")
        if values.dtype.kind not in "iuf" or not np.all(np.isfinite(values)):
            raise DataError(f"the run's {name} holds what is no finite number; run it again")
    if "scenario" not in run.attrs and TEAM not in run.attrs:
        raise DataError(
            "the run carries no scenario, so that nobody could say what was asked; `clpt run` and "
            "clpt.simulate(scenario) make runs that do"
        )


def is_ensemble(data: "xarray.Dataset") -> bool:
    """Return whether a dataset is an ensemble; refuse one that has lost what it varied."""
    if "member" not in data.dims:
        return False
    missing = {"clpe_rms_whole", "status"} - set(data.variables)
    missing |= {"scenario", "ensemble"} - set(data.attrs)
    if missing:
        raise ClptError(f"the ensemble has no {min(missing)}; `clpt ensemble` writes whole ones")
    return True
