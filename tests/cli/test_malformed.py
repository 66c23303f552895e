"""Bad input: one line that names the key or file, status 2, nothing half-written."""

import math
import os
from pathlib import Path

import pytest
from written import RUN, write

from clpt_control.blocks.disturbance import disturbance
from clpt_control.diagrams import interconnection
from clpt_control.equations.declaration import multiples
from clpt_control.errors import BlockError
from clpt_control.scenario.file import load_scenario, paper_scenario, paper_text, save_scenario

FIELD = {"parameters": None, "field": "field.nc"}

NOISE = {"kind": "noise", "amplitude": [0.1, 0.1], "period": 1e-300}

ONE_KEY = [  # key, value, words that the line must hold beside the key
    ("learning.gian", 1.0, "did you mean gain"),
    ("basis.widths", None, "missing"),
    ("vehicle", None, "missing"),
    ("flow.parameters", [[1.0, 2.0], [1.0, 2.0]], "2 rows of 3"),
    ("flow.parameters", [[1.0, 2.0, 3.0]] * 3, "at most 2 items"),
    ("basis.widths", [5.0, 5.0], "3 entries"),
    ("vehicle.position", [float("nan"), 0.0], "[0]", "finite"),
    ("basis.widths", [5.0, -5.0, 5.0], "[1]", "greater than 0"),
    ("basis.periods", [0.0, 1.0, 1.0], "[0]", "positive"),
    ("vehicle.feedback", [1.0, 0.0], "[1]", "greater than 0"),
    ("learning.gain", -0.8, "-0.8", "greater than or equal to 0"),
    ("learning.gain", "0.8", "'0.8'", "number"),
    ("learning.gain", True, "number"),
    ("learning.gain", 10**400, "number"),
    ("basis.kernel", "gauss", "'gaussian-sigma'"),
    ("reference.count", 2.5, "2.5", "integer"),
    ("reference.count", 2**63, "equal to 1000000"),
    ("reference.dwell", 1e-300, "1e-300", "at least"),
    ("reference.kind", "square", "waypoints"),
    ("run.output_step", 1e-9, "1e8"),
    ("flow.outside", "clip", "only with flow.field"),
    ("localization", {"noise": -0.1, "noise_period": 1.0}, "-0.1", "greater than or equal to 0"),
    ("localization", {"noise": 0.1, "noise_period": 1e-300}, ".noise_period", "at least"),
    ("localization", {"noise": 0.1}, ".noise_period"),
    ("localization", {"noise": 0.1, "noise_period": 1.0, "seed": 2**63}, ".seed", "less than"),
    ("flow.disturbance", {**NOISE, "kind": "square"}, ".period", "1e-300", "at least"),
    ("flow.disturbance", {**NOISE, "seed": 1}, ".period", "1e-300", "at least"),
    ("flow.disturbance", {**NOISE, "seed": 2**63}, ".seed", "less than"),
    ("flow.disturbance", {**NOISE, "kind": "sine", "period": 1.0, "seed": 1}, ".seed", "noise"),
    ("flow.disturbance", {"kind": "square", "amplitude": [1.0, 0.0]}, ".period", "required"),
    ("reference", {"kind": "waypoints", "dwell": 1.0, "points": []}, ".points = []: must have at"),
]
SEVERAL = {  # name -> (changes, words that the line must hold)
    "unknown constituent": (
        {"basis.periods": None, "basis.constituents": ["M2", "K1", "X9"]},
        ["X9", "steady"],
    ),
    "periods and constituents": (
        {"basis.constituents": ["M2", "K1", "O1"]},
        ["basis.periods", "one of the two"],
    ),
    "key of 5000": ({"learning." + "g" * 5000: 1.0}, ["unknown key learning.ggg", "feedback"]),
    "field of 5000": ({"flow.parameters": None, "flow.field": "f" * 5000}, ["no such file"]),
    "known flow without estimate": (
        {"learning.law": "known-flow", "learning.parameters": None},
        ["learning.theta_estimate", "required"],
    ),
    "one number for two": (
        {"vehicle.position": 3.0},
        ["vehicle.position = 3.0: must be a list, in brackets"],
    ),
    "theta and field": ({"flow.field": "field.nc"}, ["flow.parameters", "one of the two"]),
    "missing field": ({f"flow.{k}": v for k, v in FIELD.items()}, ["flow.field", "no such file"]),
    "fixes longer apart than the run": (
        {"learning": {"law": "fix-regression"}, "localization": {"interval": 5000.0}},
        ["localization.interval: nothing is learned before t = 5000.0", "at most"],
    ),
    "fixes that arrive after the run": (
        {
            "learning": {"law": "fix-regression"},
            "localization": {"interval": 1900.0, "latency": 200.0},
        },
        ["localization.interval: nothing is learned before t = 2100.0"],
    ),
}
CASES = [
    *(pytest.param({key: value}, [key, *words], id=key) for key, value, *words in ONE_KEY),
    *(pytest.param(*case, id=name) for name, case in SEVERAL.items()),
]


@pytest.mark.parametrize(("changes", "words"), CASES)
def test_scenario_is_refused(refused_for, changes, words):
    write(changes)
    refused_for(["s.toml", *words], *RUN)


FILES = {
    "absent.toml": (None, ["no such file", "clpt init"]),
    "text.toml": (b"gain 0.8", ["TOML", "line 1"]),
    "binary.toml": (b"\xff\xfe\x00\x01", ["not text"]),
    "absent.nc": (None, ["no such file"]),
    "fake.nc": (b"not NetCDF", ["NetCDF"]),
    "cut.nc": (b"\x89HDF\r\n\x1a\n" + bytes(40), ["NetCDF"]),
}


@pytest.mark.parametrize("name", FILES)
def test_files_that_are_no_scenario(refused_for, name):
    content, words = FILES[name]
    if content is not None:
        Path(name).write_bytes(content)
    refused_for([name, *words], "run", name, "--out", "run.nc")


@pytest.mark.parametrize(
    ("value", "words"),
    [
        ("[" * 1000 + "]" * 1000, "brackets are nested too deep"),
        ("{a=" * 1000 + "1" + "}" * 1000, "brackets are nested too deep"),
        ("1" * 5000, "too many digits"),
    ],
)
def test_text_that_toml_cannot_hold(refused_for, value, words):
    Path("s.toml").write_text(paper_text().replace("gain = 0.8", f"gain = {value}"))
    refused_for(["s.toml", words], *RUN)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="pipes with names are not of this system")
@pytest.mark.parametrize("name", ["s.toml", os.devnull])
def test_what_is_no_file_is_not_waited_for(refused_for, name):
    os.mkfifo("s.toml")
    for arguments in (("run", name, "--out", "run.nc"), ("diagram", name), ("excitation", name)):
        refused_for(["is no regular file; give one"], *arguments)


@pytest.mark.parametrize("name", ["x" * 5000, "x" * 255, "x/" * 2000, "\udcff"])
def test_names_that_no_file_can_have(refused_for, name):
    write({})
    words = ["bytes that are no text" if name == "\udcff" else "name is too long"]
    for arguments in (
        ("run", "s.toml", "--out", f"{name}.nc"),
        (*RUN, "--figures", name),
        ("ensemble", "s.toml", "--members", 2, "--vary", "learning.gain=1:2", "--out", name),
        ("init", f"{name}.toml"),
        ("diagram", "s.toml", "--out", f"{name}.svg"),
    ):
        refused_for(words, *arguments)
    for arguments in (
        ("run", f"{name}.toml", "--out", "run.nc"),
        ("excitation", name),
        ("run", f"{name}.nc", "--out", "run.nc"),
        ("replay", name),
        ("tides", name, "--constituents", "M2"),
    ):
        assert len(refused_for(["no such file" * (name == "\udcff")], *arguments)) < 1500


@pytest.mark.parametrize(
    ("changes", "window", "words"),
    [
        ({}, "1e-300", ["window 1e-300 from", "must be positive", "at least 2e-06 long"]),
        ({"basis.periods": [1e-300, 1, 1]}, "60", ["window 60: takes 1e+302 pieces", "at most"]),
        ({"vehicle.feedback": [1e300, 1.0]}, "60", ["window 60: takes", "/vehicle.feedback"]),
    ],
)
def test_windows_that_cannot_be_summed(refused_for, changes, window, words):
    write(changes)
    refused_for(words, "excitation", "s.toml", "--window", window)


def test_a_scenario_with_many_waypoints_is_read_and_written():
    points = [[0.5 * (k % 7), -0.25 * k] for k in range(20_000)]
    way = {"kind": "waypoints", "dwell": 20.0, "points": points}
    scenario = paper_scenario().with_values({"reference": way})
    save_scenario(scenario, "s.toml")
    assert load_scenario("s.toml") == scenario


def test_a_diagram_that_python_control_cannot_hold_is_refused(refused_for, monkeypatch):
    write({})
    monkeypatch.setattr(interconnection, "MOST_BYTES", 1000)
    refused_for(["closed_loop: has 3", "fewer basis functions"], "diagram", "s.toml")


def test_jumps_are_not_listed_without_end():
    for period in (1e-300, 5e-324):
        with pytest.raises(BlockError, match="multiples from 0 to 2000; at most 2e"):
            multiples(period, 0.0, 2000.0)
    for period in (0.0, -0.5, math.nan):
        with pytest.raises(BlockError, match=f"a period of {period:g}: must be above 0"):
            multiples(period, 0.0, 2000.0)
    with pytest.raises(BlockError, match="at most 2e"):
        disturbance("square", [1.0, 0.0], 1e-300).breakpoints(0.0, 2000.0)


@pytest.mark.parametrize(
    "changes",
    [
        {"learning.gain": 2.0**63},
        {"reference.radius": 1e154},
        {"basis.periods": [1e-300, 1.0, 1.0]},
        {"flow.disturbance": {"kind": "sine", "amplitude": [0.1, 0.1], "period": 1e-300}},
        {"flow.parameters": [[1e300, 1.0, 1.0], [1.0, 1.0, 1.0]]},
    ],
)
def test_a_run_that_cannot_be_ends_with_a_sentence(clpt, changes):
    write(changes)
    outcome = clpt(*RUN)
    assert outcome.status == 1
    said = outcome.err.splitlines()[-1]
    assert said.startswith("clpt: ")
    assert "fault" not in said
    assert "too many steps" in said or "the integration stopped at t = " in said
    assert [*Path().iterdir()] == [Path("s.toml")]
