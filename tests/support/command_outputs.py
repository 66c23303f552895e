"""Files that commands are given: the paper's scenario with changed keys, and one of each kind."""

import json
import shutil
import tomllib
from pathlib import Path

import pytest
from synthetic_vehicle import one_file_each
from team_scenarios import FILE

import clpt_control as clpt

RUN = ("run", "s.toml", "--out", "run.nc")
ENSEMBLE = (
    "ensemble",
    "s.toml",
    "--vary",
    "learning.gain=1:2",
    "--out",
    "e.zarr",
    "--members",
)
FOLLOW = ("watch", "in", "--out", "out", "--patience", "0", "--json")
COMMANDS = {  # of files as `write_each` writes -> what is made: all of it, or nothing; None: a part
    ("--help",): (),
    ("init", "mine.toml"): ("mine.toml",),
    (*RUN, "--figures", "out"): ("run.nc", "figure?.png"),
    ("run", "team.toml", "--out", "run.nc"): ("run.nc",),
    ("export", "s.toml", "--drawing", "-o", "d.svg"): ("d.svg",),
    (*ENSEMBLE, "64", "--chunk", "8", "--trajectories"): None,
    ("laws", "concurrent", "--json"): (),
    ("report", "r.nc", "-o", "r.html"): ("r.html",),
    ("replay", "in", "--out", "out", "--aim", "-43.1", "8.5"): (
        "replay.*",
        "*.png",
        "*.kml",
    ),
    (*ENSEMBLE, "64", "--chunk", "8", "--dask", "local", "--threads", "1"): None,
    ("paper", "--out", "out"): ("run.nc", "figure?.png"),
    ("tune", "s.toml", "--members", "3", "--law", "learned-flow", "--out", "t.toml"): (
        "t.toml",
    ),
    ("prove", "--theorem", "3.2"): (),
    ("verify", "s.toml", "--always", "e[0] < 3", "--until", "1"): (),
    ("excitation", "s.toml", "--figure", "x.png"): ("x.png",),
    ("excitation", "s.toml", "--bounds", "--json"): (),
    ("tune", "s.toml", "--waypoints", "--out", "b.toml", "--figure", "b.png"): (
        "b.toml",
        "b.png",
    ),
    ("fit", "c.nc", "--out", "f.toml", "--json"): ("f.toml", "f_field.nc"),
    ("estimate", "r.nc", "--out", "known.toml"): ("known.toml",),
    FOLLOW: None,
    ("report", "r.nc", "--film", "-o", "r.gif", "--seconds", "1"): ("r.gif",),
}


def seldom(cases, often=1):
    """Leave all but the first cases to `make test-processes`."""
    rare = [pytest.mark.processes]
    return [pytest.param(one, marks=rare * (k >= often)) for k, one in enumerate(cases)]


def toml(tables, outer=""):
    """Return nested dicts as TOML, whose strings, numbers and lists are those of JSON."""
    inner = {key: one for key, one in tables.items() if isinstance(one, dict)}
    values = [(key, one) for key, one in tables.items() if key not in inner]
    lines = [f"[{outer[:-1]}]"] if outer else []
    lines += [f"{key} = {json.dumps(one).replace('NaN', 'nan')}" for key, one in values]
    return "\n".join([*lines, *(toml(inner[key], f"{outer}{key}.") for key in inner)])


def write(changes, path="s.toml"):
    clpt.save_scenario(clpt.paper_scenario(), path)
    tables = tomllib.loads(Path(path).read_text())
    for key, value in changes.items():
        *place, last = key.split(".")
        table = tables
        for name in place:
            table = table.setdefault(name, {})
        table[last] = value
        if value is None:
            del table[last]
    Path(path).write_text(toml(tables))


def write_each(folder, duration):
    """Write a scenario, its run, a team, a current and dives."""
    scenario = clpt.paper_scenario().with_values({"run.duration": duration})
    clpt.save_scenario(scenario, folder / "s.toml")
    clpt.save_run(clpt.simulate(scenario), folder / "r.nc")
    for name, file in (("team.toml", FILE), ("c.nc", clpt.currents.sample_currents())):
        shutil.copyfile(file, folder / name)
    (folder / "in").mkdir()
    one_file_each(folder / "in", clpt.gliders.sample_dives()[:4])
