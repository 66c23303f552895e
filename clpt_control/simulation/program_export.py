"""Export of a diagram as a program: C99 or an FMU, by the ending of the file's name."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import control

from ..base.arguments import public
from ..base.files import check_writable
from ..paper.scenario.experiment import Scenario
from .c_export import export_c
from .fmu_export import export_fmu


@public
def export(
    system: Scenario | control.InputOutputSystem,
    path: str | Path | None = None,
    initial_state: Any = None,
    params: Mapping[str, Any] | None = None,
) -> str | None:
    """Write a diagram as C99 or as an FMU.

    Parameters
    ----------
    system : Scenario or InputOutputSystem
        A scenario stands for its closed loop.
    path : str or Path, optional
        ``.c`` or ``.h``: one self-contained file of C99; ``.fmu``: FMI 3.0, model exchange.
    initial_state : array_like, optional
        Start of the program; 0 by default, of a scenario its own.
    params : mapping, optional
        Parameters by name, as in `simulate`.

    Returns
    -------
    str or None
        The program in C, also without a path; None of an FMU.

    Raises
    ------
    DiagramError
        If a function cannot be traced, or the file's kind does not have the diagram's time.
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
    if path is None:
        return export_c(system, None, initial_state, params)
    path = Path(path)
    check_writable(path, "a program", (".c", ".h", ".fmu"))
    if path.suffix == ".fmu":
        export_fmu(system, path, initial_state, params)
        return None
    return export_c(system, path, initial_state, params)
