"""Export of a diagram as a program (C99, FMU) and of a run's track as a map (KML, GeoJSON).

The ending of the file's name chooses the kind.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import control

from ..base.arguments import public
from ..base.errors import ClptError
from ..base.files import check_writable
from ..paper.scenario.experiment import Scenario
from .c_export import export_c
from .fmu_export import export_fmu
from .map_export import SUFFIXES, export_track

if TYPE_CHECKING:
    import xarray


@public
def export(
    system: "Scenario | control.InputOutputSystem | xarray.Dataset",
    path: str | Path | None = None,
    initial_state: Any = None,
    params: Mapping[str, Any] | None = None,
) -> str | None:
    """Write a diagram as C99 or an FMU, or a run's track as a map.

    Parameters
    ----------
    system : Scenario, InputOutputSystem or xarray.Dataset
        A scenario stands for its closed loop. A dataset is a run of a scenario with an origin.
    path : str or Path, optional
        ``.c`` or ``.h``: one self-contained file of C99; ``.fmu``: FMI 3.0, model exchange. Of a
        run: ``.kml`` or ``.geojson``.
    initial_state : array_like, optional
        Start of the program; 0 by default, of a scenario its own.
    params : mapping, optional
        Parameters by name, as in `simulate`.

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
    if not isinstance(system, Scenario | control.InputOutputSystem):
        if path is None:
            raise ClptError("path: is required for a run. Give a .kml or .geojson file")
        path = Path(path)
        check_writable(path, "a map", SUFFIXES)
        export_track(system, path)
        return None
    if path is None:
        return export_c(system, None, initial_state, params)
    path = Path(path)
    check_writable(path, "a program", (".c", ".h", ".fmu"))
    if path.suffix == ".fmu":
        export_fmu(system, path, initial_state, params)
        return None
    return export_c(system, path, initial_state, params)
