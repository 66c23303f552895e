"""Flow models from their files: a gridded forecast, or a fitted basis."""

from pathlib import Path

from ..arguments import public
from ..errors import DataError
from .fitted_flow import read_fitted
from .flow_models import FlowModel
from .forecast import read_forecast

NETCDF = (".nc", ".nc4", ".cdf", ".netcdf")


@public
def read_flow_model(path: str | Path, units: str | None = None) -> FlowModel:
    """Read a flow model: a gridded forecast, or a fitted basis.

    Parameters
    ----------
    path : str or Path
        NetCDF of a current on time, latitude, longitude and perhaps depth; or
        the TOML file that `clpt fit` wrote, its field beside it.
    units : str, optional
        Of u and v of a NetCDF file, such as ``"m/s"``, where it has none.

    Returns
    -------
    FlowModel
        To be given to `carried` with each dive.

    Raises
    ------
    DataError
        If the file is missing or neither, or lacks what a flow model needs.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> model = clpt.replay.read_flow_model("forecast.nc")  # doctest: +SKIP
    >>> dives, skipped = clpt.gliders.usable(clpt.gliders.sample_dives())
    >>> replay = clpt.replay.replay_dives(dives, flow_model=model)  # doctest: +SKIP
    """
    path = Path(path)
    kind = path.suffix.lower()
    if kind not in (".toml", *NETCDF):
        raise DataError(
            f"{path}: is no flow model; must be a NetCDF file (.nc) of a current on time, latitude "
            "and longitude, or the .toml file of a `clpt fit`"
        )
    if not path.exists():
        raise DataError(
            f"{path}: no such file; a flow model is a NetCDF file (.nc) of a current, or the .toml "
            "file that `clpt fit` writes"
        )
    if kind == ".toml" and units is not None:
        raise DataError(f"{path}: a fit has its units in the file; leave out units ({units})")
    return read_fitted(path) if kind == ".toml" else read_forecast(path, units)
