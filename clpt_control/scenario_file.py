"""Scenarios in TOML files: read, checked, written.

Every mistake is one sentence that names the file, the key, the value and what
is allowed.
"""

import difflib
import os
import tomllib
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from .errors import ScenarioError
from .files import write_text
from .scenario import Scenario
from .scenario_tables import (
    Basis,
    Circle,
    Disturbance,
    Flow,
    Learning,
    Model,
    Part,
    Run,
    Units,
    Vehicle,
    Waypoints,
)

TABLES: dict[tuple[str, ...], type[Part]] = {
    (): Scenario,
    ("units",): Units,
    ("basis",): Basis,
    ("flow",): Flow,
    ("flow", "disturbance"): Disturbance,
    ("model",): Model,
    ("vehicle",): Vehicle,
    ("reference", "circle"): Circle,
    ("reference", "waypoints"): Waypoints,
    ("learning",): Learning,
    ("run",): Run,
}


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
        from .runs import scenario_text

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


def checked_scenario(tables: dict[str, Any], name: str, folder: Path = Path()) -> Scenario:
    """Make a scenario of nested dicts, or say what is wrong.

    Parameters
    ----------
    tables : dict
        As TOML gives it.
    name : str
        How to call it in messages.
    folder : Path, optional
        What a relative ``flow.field`` is relative to.

    Returns
    -------
    Scenario
        Checked.

    Raises
    ------
    ScenarioError
        Naming the key, the value and what is allowed.
    """
    try:
        scenario = Scenario.model_validate(tables)
    except ValidationError as error:
        problems = error.errors()
        first = min(problems, key=lambda p: p["type"] != "extra_forbidden")
        more = f" (and {len(problems) - 1} more)" if len(problems) > 1 else ""
        raise ScenarioError(f"{name}: {_sentence(first)}{more}") from None
    scenario._folder = Path(folder)
    path = scenario.field_path
    if path is not None and not path.is_file():
        raise ScenarioError(
            f'{name}: flow.field = "{scenario.flow.field}": no such file; '
            "must be a NetCDF file, relative to the scenario"
        )
    return scenario


def _sentence(problem: Any) -> str:
    where = [part for part in problem["loc"] if not _is_tag(part, problem["loc"])]
    key = ""
    for part in where:
        key += f"[{part}]" if isinstance(part, int) else f".{part}" if key else str(part)
    message = problem["msg"].replace("Input should be", "must be").replace("Value error, ", "")
    kind = problem["type"]
    if kind == "missing":
        return f"missing key {key}"
    if kind == "extra_forbidden":
        table = tuple(str(part) for part in problem["loc"][:-1])
        allowed = list(TABLES[table].model_fields) if table in TABLES else []
        close = difflib.get_close_matches(str(where[-1]), allowed, n=1)
        hint = f"; did you mean {close[0]}?" if close else ""
        return f"unknown key {key}{hint} allowed here: {', '.join(allowed)}".replace("? a", "? A")
    if kind == "union_tag_not_found":
        return f'{key}.kind: is required; must be "circle" or "waypoints"'
    if kind == "union_tag_invalid":
        return f'{key}.kind = {problem["ctx"]["tag"]!r}: must be "circle" or "waypoints"'
    if kind == "value_error" and len(where) <= 1:
        return message
    if kind in ("too_long", "too_short", "tuple_type", "missing_argument"):
        message = message.replace("Tuple should", "must").replace("after validation", "")
    if kind in ("model_type", "model_attributes_type"):
        message = "must be a table of keys"
    shown = repr(problem["input"])
    shown = shown if len(shown) <= 60 else shown[:57] + "..."
    return f"{key} = {shown}: {message}"


def _is_tag(part: Any, location: tuple[Any, ...]) -> bool:
    return location[:1] == ("reference",) and part in ("circle", "waypoints")


def scenario_tables(scenario: Scenario) -> dict[str, Any]:
    """Give a scenario as nested dicts, with the keys it was given.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario_tables(clpt.paper_scenario())["learning"]["gain"]
    0.8
    """
    return scenario.model_dump(mode="python", exclude_none=True, exclude_unset=True)


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
    import tomlkit

    tables = scenario_tables(scenario)
    if folder is not None and scenario.field_path is not None:
        relative = os.path.relpath(scenario.field_path.resolve(), Path(folder).resolve())
        tables["flow"]["field"] = Path(relative).as_posix()
    return tomlkit.dumps(tables)


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
