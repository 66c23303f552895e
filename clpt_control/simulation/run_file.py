"""Run files: NetCDF with CF attributes.

The file of a scenario's run has the scenario as TOML, which repeats the run.  The file of a
diagram's run has names, versions and arguments; the script that made the run repeats it.
"""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.arguments import public
from ..base.errors import DataError, naming
from ..base.files import check_writable, write_file
from ..base.files.reading import open_netcdf
from ..base.run_attributes import (
    ARGUMENTS,
    FORM,
    KEYS,
    MOST_BYTES,
    TEAM,
    note_texts,
    read_note,
)
from ..paper.scenario import file
from ..paper.scenario.recorded_run import (
    check_response,
    check_run,
    is_response,
    kind_of,
)
from ..paper.scenario.team import Team, system_of_run, team_to_text

if TYPE_CHECKING:
    import xarray

NO_RUN = "is not a run: it has no variable 'clpe', nor the signals of a diagram"
KINDS_IN_WORDS = {"ensemble": "an ensemble", "tube": "a tube", "fixes": "an estimate"}
NOT_RUNS = {  # kind of a dataset: what is done with its file
    "fixes": "is an estimate from fixes. Open it with xarray.open_dataset",
    "replay": "is a replay of dives. Open it with xarray.open_dataset; its track is track.kml "
    "beside it, and clpt report makes its page",
}


@public
def save_run(run: "xarray.Dataset", path: str | Path) -> None:
    """Write a run to NetCDF.

    The file of a scenario's run contains the scenario, which repeats the run. The file of a
    diagram's run contains no equations, but labels, versions and arguments of `simulate`: the
    script that made the run repeats it.

    Parameters
    ----------
    run : xarray.Dataset
        As `simulate` gives it.
    path : str or Path
        The file.

    Raises
    ------
    DataError
        If the file cannot be written, or the dataset is no run.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> import tempfile, pathlib
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 5})
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "run.nc"
    >>> clpt.save_run(clpt.simulate(scenario), file)
    >>> clpt.load_scenario(file) == scenario
    True
    """
    check_writable(path, "a run", (".nc",))
    if "clpe" not in run.variables and not is_response(run):
        kind = KINDS_IN_WORDS.get(kind_of(run), "another dataset")
        raise DataError(
            f"{path}: holds a run, and this is {kind}. Write it by to_netcdf, a grid of members by "
            "unstack().to_netcdf"
        )
    if not set(run.data_vars) - {"states"}:
        raise DataError(f"{path}: the run has no signal. Give its system outputs")
    write_file(path, as_written(run, Path(path)))


def as_written(run: "xarray.Dataset", path: Path) -> "xarray.Dataset":
    """Return a run with the attributes of its file; paths of the scenario are relative to it."""
    attributes = {}
    if {"scenario", TEAM} & run.attrs.keys():
        system = system_of_run(run)
        vehicles = [*np.ravel(run.get("vehicle", []))]
        if isinstance(system, Team) and vehicles == [*system.members]:
            attributes[TEAM] = team_to_text(system, path.parent)
        elif TEAM in run.attrs or isinstance(system, Team):
            raise DataError(
                f"{path}: holds a team's whole run, which its file repeats. Select vehicles "
                "after clpt.load_run"
            )
        else:
            attributes["scenario"] = file.scenario_to_text(system, path.parent)
    return run.assign_attrs({**attributes, **note_texts(run), FORM: file.LATEST})


@public
def load_run(path: str | Path) -> "xarray.Dataset":
    """Read a run that `save_run` or `clpt run` wrote.

    Parameters
    ----------
    path : str or Path
        A NetCDF file.

    Returns
    -------
    xarray.Dataset
        In memory, as `simulate` gave it.

    Raises
    ------
    DataError
        If the file is missing, is not NetCDF, is no run, one with gaps, or of a later form.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> import tempfile, pathlib
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 5})
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "run.nc"
    >>> clpt.save_run(clpt.simulate(scenario), file)
    >>> clpt.load_run(file).sizes["time"]
    6
    """
    with open_netcdf(Path(path), MOST_BYTES) as data:
        file.check_form(data.attrs, path)
        if "clpe" not in data.variables and not is_response(data):
            why = NOT_RUNS.get(kind_of(data), f"{NO_RUN}. Make a run with: clpt run")
            raise DataError(f"{path}: {why}")
        run = data.load()
    with naming(path):
        if is_response(run):
            check_response(run)
        else:
            system = system_of_run(run, files=False)
            check_run(run, system, "time", "position", "predicted_position", "clpe")
        for name in KEYS & run.attrs.keys():
            run.encoding[name] = read_note(run.attrs, name)
            del run.attrs[name]
    run.attrs.pop(FORM, None)  # of the file, not of the run
    run.encoding["folder"] = str(Path(path).parent)
    return run


def recorded_arguments(path: Path) -> dict[str, Any]:
    """Return the arguments of `simulate` that repeat a scenario's run, beside its scenario."""
    if path.suffix != ".nc":
        return {}
    with open_netcdf(path) as data:
        attributes = data.attrs
    with naming(path):
        return read_note(attributes, ARGUMENTS)
