"""A profiler's NetCDF as dolfyn writes it: `vel` on dir, range and time.

`dir` names the components, E, N and up where `coord_sys` is earth; they lie from true
north once a `declination` is set.  The current is the mean over the ranges that hold a
number at half of the times or more.
"""

from pathlib import Path
from typing import TYPE_CHECKING

from ...errors import DataError

if TYPE_CHECKING:
    import xarray

SHARE = 0.5  # of times at which a range must hold a number


def of_profiler(data: "xarray.Dataset", path: Path) -> "xarray.Dataset":
    """Return u and v of a profiler's file; another file as it is."""
    if "vel" not in data.variables or "dir" not in data.variables or "dir" not in data["vel"].dims:
        return data
    system = str(data.attrs.get("coord_sys", "unknown"))
    names = [str(name) for name in data["dir"].values]
    if system != "earth" or not {"E", "N"} <= set(names):
        raise DataError(
            f"{path}: vel has the coordinates '{system}' ({', '.join(names)}); must be earth: "
            "dolfyn.rotate2(data, 'earth'), and save it again"
        )
    if "declination" not in data.attrs:
        raise DataError(
            f"{path}: does not say its declination, so north is that of the compass; "
            "dolfyn.set_declination(data, DEGREES EAST), and save it again"
        )
    parts = {}
    for name, direction in (("u", "E"), ("v", "N")):
        part = data["vel"].isel(dir=names.index(direction), drop=True)
        others = [str(dim) for dim in part.dims if dim != "time"]
        if "time" not in part.dims or len(others) > 1:
            raise DataError(f"{path}: vel is on {', '.join(map(str, data['vel'].dims))}")
        if others:
            held = part.notnull().mean("time") >= SHARE
            part = part.where(held).mean(others[0], skipna=True)
        said = {key: value for key, value in data["vel"].attrs.items() if key == "units"}
        parts[name] = part.assign_attrs(said)
    kept = data.drop_vars([n for n in data.variables if n != "time" and data[n].ndim])
    return kept.assign(parts)
