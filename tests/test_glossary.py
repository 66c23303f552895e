"""Words, names and units: each has one meaning, and every variable has its unit."""

import inspect
import re
from pathlib import Path

import pytest
from error_sentences import says

import clpt_control as clpt
from clpt_control.base import errors
from clpt_control.base.units import (
    length_in_metres,
    seconds_since_1970,
    speed_in_metres_per_second,
    time_in_seconds,
)

PAGE = Path(__file__).parent.parent / "docs" / "glossary.md"
KINDS = [
    *(
        {"localization": {"noise": 0.02, "noise_period": 1.0}},
        {"vehicle.max_speed": 1.5},
    ),
    *(
        {"learning.law": "drem"},
        {"flow.disturbance": {"kind": "constant", "amplitude": [0.1, 0]}},
    ),
]


def rows():
    """The rows of the joined table: column -> what stands in backticks there."""
    table = PAGE.read_text("utf-8").split("| symbol |")[1].split("\n\n")[0]
    names = ["word", "port", "key", "variable"]
    for line in table.splitlines()[2:]:
        cells = re.split(r"(?<!\\)\|", line)[2:]
        yield {
            n: re.findall(r"`([^`]+)`", cell)
            for n, cell in zip(names, cells, strict=False)
        }


@pytest.fixture(scope="module")
def scenarios():
    paper = clpt.paper_scenario().with_values(
        {"run.duration": 2.0, "run.output_step": 1.0}
    )
    return [paper, *(paper.with_values(values) for values in KINDS)]


@pytest.fixture(scope="module")
def team(scenarios):
    return clpt.Team(members={"west": scenarios[0], "east": scenarios[0]}, coupling=0.5)


def test_every_port_is_one_of_a_diagram(scenarios, team):
    loops = [clpt.closed_loop(one) for one in scenarios]
    loops += [clpt.closed_loop(scenarios[0], errors=True), clpt.closed_loop(team)]
    ports = {
        re.sub(r".*/|\[.*", "", label) for loop in loops for label in loop.output_labels
    }
    named = {
        port.split("[")[0] for row in rows() for port in row["port"] if "[" in port
    }
    assert len(named) > 15
    assert named - ports == {"V"}  # of a proof's diagram


def test_every_key_is_one_of_a_scenario(scenarios):
    known = {"team.coupling"}
    for one in scenarios:
        for table, values in one.model_dump().items():
            known |= {table} | {
                f"{table}.{key}" for key in values or () if table != "title"
            }
    named = set()
    for first, *more in (row["key"] for row in rows() if row["key"]):
        table = first.split(".")[0]
        named |= {
            first,
            *(key if key.startswith(table) else f"{table}.{key}" for key in more),
        }
    assert len(named) > 15
    assert named <= known


def test_every_variable_is_one_of_a_run(scenarios):
    runs = [clpt.simulate(one) for one in scenarios]
    named = {name for row in rows() for name in row["variable"]}
    assert len(named) > 10
    assert named <= {str(name) for run in runs for name in run.variables}


PACKAGE = Path(clpt.__file__).parent
ROOMS = [name for name in clpt.__all__ if inspect.ismodule(getattr(clpt, name))]


def test_every_error_is_a_name_of_the_package():
    every = inspect.getmembers(errors, inspect.isclass)
    public = {name for name, one in every if one.__module__ == "clpt_control"}
    assert len(public) > 5
    assert public <= set(clpt.__all__)


@pytest.mark.parametrize("room", ["", *ROOMS])
def test_every_name_of_a_room_is_there_and_no_file_too(room):
    """Importing a file puts it on its room, in place of a function of the same name."""
    module = getattr(clpt, room) if room else clpt
    folder = PACKAGE / room  # a public module such as clpt.native has none
    files = {path.stem for path in folder.iterdir()} if folder.is_dir() else set()
    assert module.__doc__
    for name in module.__all__:
        assert getattr(module, name) is not None
        assert name in dir(module)
        assert name not in files or inspect.ismodule(getattr(module, name))
    with pytest.raises(AttributeError):
        _ = module.no_such_name


SPEEDS = {  # m/s
    "m/s, m s-1, m.s-1, m s^-1, m s**-1, metres per sec": 1.0,
    "cm/s, cm s-1, cm/sec,  cm / second ": 0.01,
    "km/h, km h-1, km/hr, kilometers per hour": 1 / 3.6,
    "knot, Knots, kt, kts, kn": 1852 / 3600,
    "mm/s, millimeters per second, mm s-1": 1e-3,
    "m/day": 1 / 86400,
}
TIMES = {  # s
    "s, sec, secs, second, Seconds": 1.0,
    "min, mins, minute, minutes": 60.0,
    "h, hr, hrs, hour, hours since 2019-01-01": 3600.0,
    "d, day, days": 86400.0,
    "milliseconds": 1e-3,
    "nanoseconds since 2010-07-29 13:31:04": 1e-9,
}


LENGTHS = {"km": 1e3, "m, Metres": 1.0, "cm": 0.01}


@pytest.mark.parametrize(
    ("read", "table"),
    [
        (speed_in_metres_per_second, SPEEDS),
        (time_in_seconds, TIMES),
        (length_in_metres, LENGTHS),
    ],
)
def test_speeds_times_and_lengths(read, table):
    for units, size in table.items():
        for unit in units.split(", "):
            assert read(unit, "u") == pytest.approx(size, rel=1e-15), unit


def test_dates():
    days = [
        seconds_since_1970(text) for text in ("1970-01-02", "1970-01-02T00:00:00+02:00")
    ]
    assert days == [86400.0, 86400.0 - 7200]


NO_UNITS = [
    "",
    "kelvin",
    "m",
    "s",
    "m s",
    "m-1 s",
    "s-1 m",
    "ms-1",
    "m/fortnight",
    "m/s/s",
    "1",
]


@pytest.mark.parametrize("unit", NO_UNITS)
def test_what_is_no_unit_is_refused(unit):
    for read, own, said in (
        (
            speed_in_metres_per_second,
            "m/s",
            "u: units = .* is not a speed. Use a unit such as 'm/s'",
        ),
        (length_in_metres, "m", "u has units .*; use a unit such as 'm', 'km' or"),
        (time_in_seconds, "s", "u has units .*; use a unit such as 's', 'min', 'h'"),
    ):
        if unit != own:
            says(clpt.DataError, said, read, unit, "u")
