"""Bad input: one line that names the key or file, status 2, nothing half-written."""

import os
import re
import shutil
import sys
from pathlib import Path

import numpy as np
import pytest
from command_outputs import COMMANDS, RUN, write
from damaged_commands import OPTIONS, USES
from error_sentences import says
from gridded_currents import uniform_field
from paths import DATA
from subprocesses import ran

import clpt_control
from clpt_control import paper_scenario


def many(N):
    """Return changes of the paper's scenario to so many basis functions."""
    changes = {
        "basis.centers": [[1.0, 1.0]] * N,
        "flow.parameters": [[0.1] * N] * 2,
        **{f"basis.{key}": [1.0] * N for key in ("widths", "periods")},
    }
    unset = ("basis.phases", "model.parameters", "learning.parameters")
    return changes | dict.fromkeys(unset)


NOISE = {"kind": "noise", "amplitude": [0.1, 0.1], "period": 1e-300}

KNOWN = {"learning.law": "known-flow", "learning.parameters": None}
AT_FIXES = {"learning": {"law": "fix-regression"}}
LEARNS = "localization.interval: nothing is learned before t ="
WRONG = [  # changed keys, words that the line must hold, the first the key
    ({"learning.gian": 1.0}, "learning.gian", "did you mean learning.gain"),
    ({"learning." + "g" * 5000: 1.0}, "unknown key learning.ggg", "feedback"),
    ({"basis.widths": None}, "basis.widths", "missing"),
    ({"flow.parameters": [[1.0, 2.0], [1.0, 2.0]]}, "flow.parameters", "2 rows of 3"),
    ({"basis.widths": [5.0, 5.0]}, "basis.widths", "must have 3"),
    ({"vehicle.position": [float("nan"), 0.0]}, "vehicle.position[0]", "finite"),
    ({"vehicle.position": 3.0}, "vehicle.position = 3.0: must be a list, in brackets"),
    ({"basis.periods": [0.0, 1.0, 1.0]}, "basis.periods[0]", "positive"),
    ({"vehicle.feedback": [1.0, 0.0]}, "vehicle.feedback[1]", "greater than 0"),
    ({"learning.gain": -0.8}, "learning.gain", "-0.8", "greater than or equal to 0"),
    ({"learning.gain": True}, "learning.gain", "number"),
    ({"learning.gain": 10**400}, "learning.gain", "number"),
    ({"basis.kernel": "gauss"}, "basis.kernel", "'gaussian-sigma'"),
    ({"reference.count": 2.5}, "reference.count", "2.5", "integer"),
    ({"reference.count": 2**63}, "reference.count", "equal to 1000000"),
    ({"reference.dwell": 1e-300}, "reference.dwell", "1e-300", "at least"),
    ({"reference.kind": "square"}, "reference.kind", "waypoints"),
    ({"run.output_step": 1e-9}, "run.output_step", "1e8"),
    ({"flow.outside": "clip"}, "flow.outside", "only with flow.field"),
    ({"flow.field": "field.nc"}, "flow.parameters", "give one of"),
    ({"flow.parameters": None, "flow.field": "f" * 5000}, "flow.field", "no such file"),
    ({"localization": {"noise": 0.1}}, "localization.noise_period"),
    (
        {"localization": {"noise": 0.1, "noise_period": 1.0, "seed": 2**63}},
        ".seed",
        "less than",
    ),
    (
        {"flow.disturbance": {**NOISE, "kind": "square"}},
        "flow.disturbance.period",
        "at least",
    ),
    (
        {"flow.disturbance": {**NOISE, "kind": "sine", "seed": 1}},
        ".seed",
        "has no seed. Leave it out",
    ),
    (
        {"flow.disturbance": {"kind": "square", "amplitude": [1.0, 0.0]}},
        ".period",
        "required",
    ),
    (
        {"reference": {"kind": "waypoints", "dwell": 1.0, "points": []}},
        ".points = []: must have",
    ),
    ({"basis.periods": None, "basis.constituents": ["M2", "K1", "X9"]}, "X9", "steady"),
    ({"basis.constituents": ["M2", "K1", "O1"]}, "basis.periods", "one of the two"),
    (KNOWN, "learning.theta_estimate", "required"),
    ({**AT_FIXES, "localization": {"interval": 5000.0}}, f"{LEARNS} 5000.0"),
    (
        {**AT_FIXES, "localization": {"interval": 1900.0, "latency": 200.0}},
        f"{LEARNS} 2100.0",
    ),
    (
        many(20_000) | {"run.output_step": 0.1},
        "2e+04 samples of 20000 basis functions",
        "84.5 GB of me",
    ),
    ({"run.output_step": 1e-4}, "2e+07 samples of 3 basis functions", "GB"),
]


@pytest.mark.parametrize("case", WRONG, ids=lambda case: case[1])
def test_scenario_is_refused(refused_for, case):
    changes, *words = case
    write(changes)
    refused_for(["s.toml", *words], *RUN)


def test_files_that_are_no_scenario(refused_for):
    for name, content, *words in (
        ("absent.toml", None, "no such file", "clpt init"),
        ("text.toml", b"gain 0.8", "TOML", "line 1"),
        ("binary.toml", b"\xff\xfe\x00\x01", "not text"),
        ("absent.nc", None, "no such file"),
        ("fake.nc", b"not NetCDF", "NetCDF"),
        ("cut.nc", b"\x89HDF\r\n\x1a\n" + bytes(40), "NetCDF"),
    ):
        if content is not None:
            Path(name).write_bytes(content)
        refused_for([name, *words], "run", name, "--out", "run.nc")


def test_text_that_toml_cannot_hold(refused_for):
    write({}, "paper.toml")
    text = Path("paper.toml").read_text()
    assert "gain = 0.8" in text
    for value, words in (
        ("[" * 1000 + "]" * 1000, "brackets are nested too deep"),
        ("{a=" * 1000 + "1" + "}" * 1000, "brackets are nested too deep"),
        ("1" * 5000, "too many digits"),
    ):
        Path("s.toml").write_text(text.replace("gain = 0.8", f"gain = {value}"))
        refused_for(["s.toml", words], *RUN)


@pytest.mark.skipif(
    not hasattr(os, "mkfifo"), reason="pipes with names are not of this system"
)
@pytest.mark.parametrize("name", ["s.toml", os.devnull])
def test_what_is_no_file_is_not_waited_for(refused_for, name):
    os.mkfifo("s.toml")
    for arguments in (
        ("run", name, "--out", "run.nc"),
        ("export", name, "--drawing"),
        ("excitation", name),
    ):
        refused_for(["is not a regular file. Give a file"], *arguments)


def test_a_link_to_itself_is_one_sentence(refused_for):
    Path("dive.nc").symlink_to("dive.nc")
    refused_for(["Too many levels of symbolic links"], "replay", "dive.nc", "--json")


@pytest.mark.parametrize("name", ["x" * 5000, "x" * 255, "x/" * 2000, "\udcff"])
def test_names_that_no_file_can_have(refused_for, name):
    write({})
    words = ["not valid text" if name == "\udcff" else "name is too long"]
    for arguments in (
        *(("run", "s.toml", "--out", f"{name}.nc"), (*RUN, "--figures", name)),
        (
            "ensemble",
            "s.toml",
            "--members",
            2,
            "--vary",
            "learning.gain=1:2",
            "--out",
            name,
        ),
        ("init", f"{name}.toml"),
    ):
        refused_for(words, *arguments)
    for arguments in (("run", f"{name}.nc", "--out", "run.nc"), ("excitation", name)):
        assert (
            len(refused_for(["no such file" * (name == "\udcff")], *arguments)) < 1500
        )


def test_windows_that_cannot_be_summed(refused_for):
    for changes, window, *words in (
        ({}, "1e-300", "window 1e-300 from", "must be positive", "at least 2e-06 long"),
        (
            {"basis.periods": [1e-300, 1, 1]},
            "60",
            "window 60: takes 1e+302 pieces",
            "at most",
        ),
        (
            {"vehicle.feedback": [1e300, 1.0]},
            "60",
            "window 60: takes",
            "/vehicle.feedback",
        ),
    ):
        write(changes)
        refused_for(words, "excitation", "s.toml", "--window", window)


def test_a_scenario_with_many_waypoints_is_read_and_written():
    points = [[0.5 * (k % 7), -0.25 * k] for k in range(20_000)]
    way = {"kind": "waypoints", "dwell": 20.0, "points": points}
    scenario = paper_scenario().with_values({"reference": way})
    clpt_control.save_scenario(scenario, "s.toml")
    assert clpt_control.load_scenario("s.toml") == scenario


def test_a_diagram_that_python_control_cannot_hold_is_refused(refused_for):
    write(many(2000))
    said = ["closed_loop: has ", "fewer basis functions"]
    refused_for(said, "export", "s.toml", "--drawing")


def test_jumps_are_not_listed_without_end():
    block = clpt_control.Sampled(clpt_control.parts.lag(1.0), 1e-300)
    said = "multiples from 0 to 2000; at most 2e"
    says(clpt_control.BlockError, said, clpt_control.simulate, block, [0, 2000])


NO_RUNS = [
    *(("learning.gain", 2.0**63), ("reference.radius", 1e154)),
    ("basis.periods", [1e-300, 1.0, 1.0]),
    ("flow.parameters", [[1e300, 1.0, 1.0], [1.0, 1.0, 1.0]]),
]


@pytest.mark.parametrize(("key", "value"), NO_RUNS)
def test_a_run_that_cannot_be_ends_with_a_sentence(clpt, key, value):
    write({key: value})
    outcome = clpt(*RUN)
    said = outcome.err.splitlines()[-1]
    assert re.match("clpt: .*(too many steps|the integration stopped at t = )", said)
    assert "fault" not in said
    assert (outcome.status, [*Path().iterdir()]) == (1, [Path("s.toml")])


# --- runs, currents and places -------------------------------------------------------------------

RUN_DAMAGES = {
    "no time": (lambda run: run.drop_vars("time"), "has no time over time"),
    "a number": (
        lambda run: run.assign(predicted_position=0.0),
        "has no predicted_position over",
    ),
    "other functions": (lambda run: run.isel(basis=[0, 1]), "axis 2, basis 3"),
    "turned": (
        lambda run: run.transpose("axis", ...),
        "has no position over time, axis",
    ),
    "far times": (
        lambda run: run.assign_coords(time=run.time + 1e15),
        "must lie in 0 to",
    ),
    "a huge place": (
        lambda run: run.assign(position=run.position + 1e308),
        "not finite",
    ),
    "a team": (lambda run: run.assign_attrs(team="[team]"), "a scenario and a team"),
    "no scenario": (lambda run: run.drop_attrs(), "contains no scenario"),
    "turned round": (
        lambda run: run.isel(time=slice(None, None, -1)),
        "its times do not increase",
    ),
    "twice at one time": (
        lambda run: run.isel(time=[0, 0, 1, 2]),
        "its times do not increase",
    ),
    "no waypoints": (
        lambda run: run.drop_vars("reference"),
        "has no reference over time, axis",
    ),
    "a gap": (
        lambda run: run.assign(reference=run.reference.where(run.time > 30)),
        "not finite",
    ),
    "one sample": (lambda run: run.isel(time=[0]), "has fewer than two samples"),
    "words": (lambda run: run.assign(clpe=run.clpe.astype(str)), "not finite"),
}
NEEDED_BY_ESTIMATE = ("no waypoints", "a gap", "one sample")


@pytest.fixture(scope="module")
def run():
    short = {"run.duration": 400, "run.output_step": 20}
    return clpt_control.simulate(paper_scenario().with_values(short))


@pytest.mark.parametrize("name", RUN_DAMAGES)
def test_a_damaged_run_is_refused_by_all_that_open_runs(refused_for, run, name):
    damage, said = RUN_DAMAGES[name]
    damage(run).to_netcdf("run.nc")
    commands = ["estimate"]
    if name not in NEEDED_BY_ESTIMATE:
        commands += ["report -o out.html", "report --film -o out.gif", "excitation"]
    for command, *out in map(
        str.split, commands + ["run --out a.nc"] * (name == "no scenario")
    ):
        refused_for([said], command, "run.nc", *out)


WARNING = """
import warnings; from clpt_control.app import cli
warn = lambda **options: warnings.warn('a word of a library', RuntimeWarning)
cli.application = lambda: warn
cli.main()
"""


def test_warnings_of_libraries_are_no_words_of_a_command():
    ended = ran(sys.executable, "-c", WARNING)
    assert (ended.stdout, ended.stderr) == ("", "")


def test_places_that_cannot_be_written(refused_for):
    write({})
    Path("file").write_text("")
    refused_for(["no", "folder"], "run", "s.toml", "--out", "no/run.nc")
    refused_for(["is a folder"], "run", "s.toml", "--out", ".")
    refused_for(["is a file"], "paper", "--out", "file")
    refused_for(["cannot be written"], "init", "no/p.toml")


def test_field_files_that_cannot_be_used(refused_for):
    good = uniform_field("field.nc", 0.0, 0.0, half=20.0, end=4e4)
    uneven = ("x", [-20.0, -10.0, 0.0, 9.0, 20.0], {"units": "m"})
    write({"flow.parameters": None, "flow.field": "field.nc"})
    for data, *words in (
        (good.drop_vars("v"), "'v'"),
        (good.assign(u=good.u.where((good.x != 0) | (good.y != 0))), "u has gaps"),
        (good.assign(u=good.u.assign_attrs(units="furlong")), "furlong", "speed"),
        (good.assign_coords(x=uneven), "x must have two points or more, evenly"),
        (good.assign_coords(y=("y", np.arange(5.0))), "y has units"),
    ):
        data.to_netcdf("field.nc")
        refused_for(["field.nc", *words], *RUN)


def test_sizes_that_no_machine_holds_are_refused_before_work(refused_for):
    shutil.copy(clpt_control.currents.sample_currents(), "g.nc")
    for rows in ("99999999999999999999", "9" * 400):
        refused_for(
            [" samples for 8999999"], "fit", "g.nc", "--rows", rows, "--out", "f.toml"
        )
    said = ["a dive of 1e-300 hours at 1 m/s through the water: give 1 s to 720 hours"]
    refused_for(said, "replay", "--sample", "--aim", "-43", "8", "--hours=1e-300")


def test_long_headers_and_comments_are_read(refused_for):
    spaces, long = " " * 4000, " " * 10**5
    for text, said in (
        (f"time,latitude,longitude,u{spaces}(m/s\n1,2,3,4\n", "no dives"),
        (f"{spaces}x{spaces}(\n1\n", "no column dive"),
        (f"# a{long}b\n# {'a' * 10**5}\n# x: {long}y\ntime\n", "no column latitude"),
    ):
        Path("r.csv").write_text(text)
        refused_for([said], "replay", "r.csv")


def test_files_of_each_command_and_each_glider_are_damaged(clpt):
    """`make test-slow` damages what `USES` and `OPTIONS` list."""
    names = {words[0] for words in COMMANDS} - {"--help", "init"}  # which writes
    helped = {name: clpt(name, "--help").out for name in names}
    of_files = re.compile(
        r"Arguments:\n(?:  .*\n)*?  .*(?:[Ff]ile|[Ff]older|NetCDF|\.nc)"
    )
    reads = {name for name in names if of_files.search(helped[name])}
    lines = [*USES, *(words for words, _ in OPTIONS)]
    assert {line.split()[0] for line in lines} == reads
    for folder in (DATA / "glider").iterdir():
        if folder.is_dir() and any(folder.iterdir()):
            assert any(f" {folder.name}/" in use for use in USES), folder.name
            assert folder.name in (DATA / "README.md").read_text("utf-8"), "README"
