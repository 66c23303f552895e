"""Reading and writing of scenarios: TOML files and the attributes of runs.

A mistake raises a ScenarioError with one sentence: the file, the key, the value and what is
allowed.  The scenario of section IV is the commented file that `clpt init` writes.
"""

import json
import os
import re
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ...base.arguments import public
from ...base.errors import DataError, ScenarioError
from ...base.files import check_writable, write_file
from ...base.files.reading import AnyPath, open_netcdf, read_bytes
from ...base.html import asset
from ...base.run_attributes import BEYOND, FORM, OWN_PARTS, TEAM
from .experiment import Nested, Scenario, checked_scenario, scenario_tables

LARGEST = 2 * 10**7  # bytes of a scenario; parsing them takes some seconds
LATEST = 1  # format that is written; all formats up to it are read


def load_vehicle_scenario(path: AnyPath) -> Scenario:
    """Read a scenario of one vehicle, not a team, from a TOML file or a run's file."""
    path = Path(path)
    return scenario_from_text(read_text(path), str(path), path.parent)


def read_text(path: Path) -> str:
    """Return the TOML text of a scenario or team from its file or from a run's file."""
    if path.suffix == ".nc":
        return run_text(path)
    try:
        raw = read_bytes(
            path, hint="`clpt init` writes a scenario to start from", most=LARGEST
        )
        return raw.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise ScenarioError(
            f"{path}: is not text; a scenario is a TOML file in UTF-8"
        ) from None
    except DataError as error:
        raise ScenarioError(str(error)) from None


def scenario_from_text(text: str, name: str, folder: Path | None) -> Scenario:
    """Read a scenario from TOML text; `name` begins each error, `folder` has its files."""
    tables = tables_of(text, name)
    if "team" in tables:
        raise ScenarioError(
            f"{name}: has a table [team], so it is a team's; `clpt run`, `clpt excitation` "
            "and clpt.load_scenario read it"
        )
    return checked_scenario(tables, name, folder)


def tables_of(text: str, name: str) -> Nested:
    """Return TOML text as nested dicts; `name` begins each error."""
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        advice = ". A text has quotes" if "Invalid value" in str(error) else ""
        if name.endswith(".csv"):
            advice = ". `clpt estimate` and read_dives read tables of fixes"
        raise ScenarioError(f"{name}: is not valid TOML: {error}{advice}") from None
    except RecursionError:
        raise ScenarioError(
            f"{name}: brackets are nested too deep; at most 3 levels"
        ) from None
    except ValueError:  # a whole number of thousands of digits
        raise ScenarioError(
            f"{name}: a number has too many digits. Write it as 1e300"
        ) from None


def folder_of(run: Any) -> Path:
    """Return the folder to which a field in a run's attributes is relative."""
    source = str(run.encoding.get("source", ""))
    return Path(run.encoding.get("folder") or Path(source).parent)


def attached_scenario(run: Any, files: bool = True) -> Scenario:
    """Return the scenario in the attributes of a run or an ensemble.

    With `files` the file of its field must exist.
    """
    if not hasattr(run, "attrs"):
        raise DataError(
            f"{run!r:.60}: must be a run, as clpt.simulate gives it; clpt.load_run reads one"
        )
    if not isinstance(text := run.attrs.get("scenario"), str):
        raise DataError(
            "the run contains no scenario, as that of a diagram does not; "
            "clpt.simulate(scenario) writes one"
        )
    return scenario_from_text(text, "the run", folder_of(run) if files else None)


def scenario_to_text(scenario: Scenario, folder: Path | None = None) -> str:
    """Return a scenario as TOML text; its field's path is relative to `folder`, if given."""
    return toml(placed_tables(scenario, folder))


def placed_tables(scenario: Scenario, folder: Path | None) -> Nested:
    """Return a scenario as nested dicts; its field's path is relative to `folder`, if given."""
    tables = scenario_tables(scenario)
    if folder is not None and scenario.field_path is not None:
        relative = os.path.relpath(
            scenario.field_path.resolve(), Path(folder).resolve()
        )
        tables["flow"]["field"] = Path(relative).as_posix()
    return tables


def toml(tables: Nested, name: str = "") -> str:
    """Return nested dicts as TOML text; `name` is "" or the outer table's name and a dot."""
    values, inner = "", []
    for key, value in tables.items():
        if isinstance(value, dict):
            inner.append(toml(value, f"{name}{_key(key)}."))
        else:
            values += f"{_key(key)} = {_value(value)}\n"
    head = f"[{name[:-1]}]\n" if name and (values or not inner) else ""
    return "\n".join(filter(None, [head + values, *inner]))


def _key(key: str) -> str:
    return key if re.fullmatch(r"[\w-]+", key, re.ASCII) else _value(key)


def _value(value: Any) -> str:
    if isinstance(value, list | tuple):
        return f"[{', '.join(map(_value, value))}]"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, bool):
        return str(value).lower()
    return repr(float(value)) if isinstance(value, float) else str(value)


@public
def save_scenario(scenario: Scenario, path: AnyPath) -> None:
    """Write a scenario to a TOML file.

    Parameters
    ----------
    scenario : Scenario
        The experiment.
    path : str or Path
        The file. It is written to a temporary file and renamed, so it is never incomplete.

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
    check_writable(path, "a scenario", (".toml",))
    write_file(path, scenario_to_text(scenario, path.parent))


def run_text(path: AnyPath) -> str:
    """Return the TOML text that a run's file carries, of a scenario or a team."""
    with open_netcdf(Path(path)) as data:
        check_form(data.attrs, path)
        text = data.attrs.get(TEAM, data.attrs.get("scenario"))
        if text is None:
            raise DataError(
                f"{path}: contains no scenario. Give a scenario or its run; repeat the run of a "
                "diagram with the script that made it"
            )
        for name, (change, cure) in BEYOND.items():
            if name in data.attrs:
                raise DataError(
                    f"{path}: was run with {change}, {data.attrs[name]}, so its scenario alone "
                    f"does not repeat it. Give the scenario itself, and {cure}"
                )
        return str(text)


def check_form(attributes: Mapping[str, Any], path: AnyPath) -> None:
    """Refuse a run's file of a later format."""
    form = str(attributes.get(FORM, LATEST))
    if form not in map(str, range(1, LATEST + 1)):
        writer = attributes.get("source", "what is not said")
        raise DataError(
            f"{path}: {FORM} = {form:.20}, written by {writer}; "
            f"this version reads 1 to {LATEST}: update clpt-control"
        )


def own_parts(attributes: Mapping[str, Any]) -> set[str]:
    """Return the names of the blocks that were given in Python, from a run's attributes."""
    entries = str(attributes.get(OWN_PARTS, "")).split(", ")
    return {entry.partition(":")[0] for entry in entries}


def paper_text() -> str:
    """Return the paper's scenario as commented TOML text."""
    return asset("paper.toml")


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
