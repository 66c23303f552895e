"""A measured current that ships with the package, to try things on."""

from importlib import resources
from pathlib import Path

NAME = "maracoos_hfr_2019-01-01.nc"


def sample_currents() -> Path:
    """Return the file of a measured current in the package.

    Returns
    -------
    Path
        NetCDF: the surface current of Nantucket Shoals on 1 January 2019 by HF radar, hourly, on
        cells of 6 km; u and v in cm/s, with gaps (MARACOOS; MIT licence).

    Examples
    --------
    >>> import clpt_control as clpt
    >>> clpt.currents.read_currents(sample_currents()).u.shape
    (24, 14, 18)
    """
    return Path(str(resources.files("clpt_control.data") / NAME))
