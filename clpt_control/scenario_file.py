"""Scenarios in TOML files: read, checked, written.

Every mistake is one sentence that names the file, the key, the value and what
is allowed.
"""

import os
import pickle
import tomllib
from functools import lru_cache
from pathlib import Path

from .errors import DataError, ScenarioError
from .files import open_netcdf, write_text
from .scenario import Scenario, checked_scenario, scenario_tables

CHANGED = "parameters_changed"  # attribute of a run: parameters that its scenario does not hold


def load_scenario(path: str | Path) -> Scenario:
    """Read a scenario from a TOML file or from a run's NetCDF file.

    Parameters
    ----------
    path : str or Path
        A ``.toml`` file, or a ``.nc`` file that `clpt run` wrote.

    Returns
    -------
    Scenario
        Checked; a relative ``flow.field`` is relative to the file.

    Raises
    ------
    ScenarioError
        If the file is missing, is not TOML, or a key or value is not allowed.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> import tempfile, pathlib
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "paper.toml"
    >>> clpt.save_scenario(clpt.paper_scenario(), file)
    >>> clpt.load_scenario(file) == clpt.paper_scenario()
    True
    """
    path = Path(path)
    if path.suffix == ".nc":
        return scenario_from_text(scenario_text(path), str(path), path.parent)
    try:
        text = path.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise ScenarioError(
            f"{path}: no such file; `clpt init` writes a scenario to start from"
        ) from None
    except IsADirectoryError:
        raise ScenarioError(f"{path}: is a folder; give a scenario's TOML file") from None
    except UnicodeDecodeError:
        raise ScenarioError(f"{path}: is not text; a scenario is a TOML file in UTF-8") from None
    except OSError as error:
        raise ScenarioError(f"{path}: cannot be read: {error.strerror}") from None
    return scenario_from_text(text, str(path), path.parent)


def scenario_from_text(text: str, name: str, folder: Path) -> Scenario:
    """Check a scenario's TOML text.

    Parameters
    ----------
    text : str
        TOML.
    name : str
        How to call it in messages, usually the path.
    folder : Path
        What a relative ``flow.field`` is relative to.

    Returns
    -------
    Scenario
        Checked.

    Raises
    ------
    ScenarioError
        If it is not TOML, or a key or value is not allowed.
    """
    try:
        tables = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise ScenarioError(f"{name}: is not valid TOML: {error}") from None
    return checked_scenario(tables, name, folder)


def scenario_to_text(scenario: Scenario, folder: Path | None = None) -> str:
    """Write a scenario as TOML text.

    Parameters
    ----------
    scenario : Scenario
        The experiment.
    folder : Path, optional
        Where the text will lie; a relative ``flow.field`` is turned to it.

    Returns
    -------
    str
        TOML that reads back to the same scenario.
    """
    tables = scenario_tables(scenario)
    if folder is not None and scenario.field_path is not None:
        relative = os.path.relpath(scenario.field_path.resolve(), Path(folder).resolve())
        tables["flow"]["field"] = Path(relative).as_posix()
    return _dumped(pickle.dumps(tables))


@lru_cache(maxsize=64)
def _dumped(tables: bytes) -> str:
    """Write tables as TOML; the same scenario is run again and again."""
    import tomlkit

    return tomlkit.dumps(pickle.loads(tables))


def save_scenario(scenario: Scenario, path: str | Path) -> None:
    """Write a scenario to a TOML file.

    Parameters
    ----------
    scenario : Scenario
        The experiment.
    path : str or Path
        The file; written beside and renamed, so never half there.

    Raises
    ------
    ScenarioError
        If the file cannot be written.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> import tempfile, pathlib
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "paper.toml"
    >>> clpt.save_scenario(clpt.paper_scenario(), file)
    """
    path = Path(path)
    write_text(path, scenario_to_text(scenario, path.parent))


def scenario_text(path: str | Path) -> str:
    """Give the scenario that a run's file carries, as TOML text.

    Raises
    ------
    DataError
        If the file is missing, is not NetCDF, or carries no scenario.
    """
    with open_netcdf(Path(path)) as data:
        if "scenario" not in data.attrs:
            raise DataError(f"{path}: carries no scenario; `clpt run` writes runs that do")
        if CHANGED in data.attrs:
            raise DataError(
                f"{path}: was run with parameters that no key of a scenario holds, "
                f"{data.attrs[CHANGED]}, so it cannot be repeated; give the scenario itself, and "
                "the parameters to simulate(params=...)"
            )
        return str(data.attrs["scenario"])
