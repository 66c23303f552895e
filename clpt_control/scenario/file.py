"""Scenarios in TOML files: read, checked, written.

Every mistake is one sentence that names the file, the key, the value and what
is allowed.  The scenario of section IV ships as a commented file, the one that
`clpt init` writes.
"""

import errno
import os
import pickle
import re
import tomllib
from functools import lru_cache
from importlib import resources
from pathlib import Path
from typing import Any

from ..errors import DataError, ScenarioError
from ..files import open_netcdf, write_text
from ..files.reading import read_bytes
from .experiment import Scenario, checked_scenario, scenario_tables

CHANGED = "parameters_changed"  # attribute of a run: parameters that no key holds
OWN_LAW = "own_law"  # attribute of a run: the name of a law given in Python


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
        text = read_bytes(path).decode("utf-8")
    except UnicodeDecodeError:
        raise ScenarioError(f"{path}: is not text; a scenario is a TOML file in UTF-8") from None
    except DataError as error:
        if str(error).endswith(os.strerror(errno.ENOENT)):
            raise ScenarioError(
                f"{path}: no such file; `clpt init` writes a scenario to start from"
            ) from None
        raise ScenarioError(str(error)) from None
    return scenario_from_text(text, str(path), path.parent)


def scenario_from_text(text: str, name: str, folder: Path) -> Scenario:
    """Read a scenario of TOML text; `name` begins each error, `folder` holds its files."""
    try:
        tables = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise ScenarioError(f"{name}: is not valid TOML: {error}") from None
    except RecursionError:
        raise ScenarioError(f"{name}: brackets are nested too deep; at most 3 levels") from None
    except ValueError:  # a whole number of thousands of digits
        raise ScenarioError(f"{name}: a number has too many digits; write it as 1e300") from None
    return checked_scenario(tables, name, folder)


def scenario_to_text(scenario: Scenario, folder: Path | None = None) -> str:
    """Return a scenario as TOML text to lie in `folder`, to which a relative field is turned."""
    tables = scenario_tables(scenario)
    if folder is not None and scenario.field_path is not None:
        relative = os.path.relpath(scenario.field_path.resolve(), Path(folder).resolve())
        tables["flow"]["field"] = Path(relative).as_posix()
    return _dumped(pickle.dumps(tables))


@lru_cache(maxsize=64)
def _dumped(tables: bytes) -> str:
    """Return tables as TOML; kept, as the same scenario is run again and again."""
    import tomlkit

    return tomlkit.dumps(_with_long_rows(pickle.loads(tables)))


def _with_long_rows(tables: dict[str, Any]) -> dict[str, Any]:
    """Replace rows of numbers by text: tomlkit's time for a row grows with its square."""
    from tomlkit.items import Float, Trivia

    def item(value: Any) -> Any:
        if isinstance(value, dict):
            return {key: item(inner) for key, inner in value.items()}
        if isinstance(value, list | tuple) and value and not isinstance(value[0], str):
            return Float(0.0, Trivia(), re.sub(r",?\)", "]", repr(value).replace("(", "[")))
        return value

    return item(tables)


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
    """Return the scenario that a run's file carries, as TOML text."""
    with open_netcdf(Path(path)) as data:
        if "scenario" not in data.attrs:
            raise DataError(f"{path}: carries no scenario; `clpt run` writes runs that do")
        if CHANGED in data.attrs:
            raise DataError(
                f"{path}: was run with parameters that no key of a scenario holds, "
                f"{data.attrs[CHANGED]}, so it cannot be repeated; give the scenario itself, and "
                "the parameters to simulate(params=...)"
            )
        if OWN_LAW in data.attrs:
            raise DataError(
                f"{path}: was run with a law given in Python, {data.attrs[OWN_LAW]}, which no file "
                "holds, so it cannot be repeated; give the scenario itself, and the law to "
                "simulate(law=...)"
            )
        return str(data.attrs["scenario"])


def paper_text() -> str:
    """Return the paper's scenario as commented TOML text."""
    return resources.files("clpt_control.data").joinpath("paper.toml").read_text("utf-8")


def paper_scenario() -> Scenario:
    """Return the scenario of section IV.

    Returns
    -------
    Scenario
        Three exponential basis functions, ten waypoints, t = 0 to 2000.

    Examples
    --------
    >>> paper_scenario().cycle
    200.0
    """
    return scenario_from_text(paper_text(), "paper.toml", Path())
