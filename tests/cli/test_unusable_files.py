"""Runs, currents and sizes that no command can use: one line, nothing half-written."""

import shutil
import sys
from pathlib import Path

import numpy as np
import pytest
from made_fields import uniform_field
from processes import ran
from written import RUN, write

import clpt_control
from clpt_control.scenario.file import paper_scenario
from clpt_control.simulation.integrate import simulate

FIELD = {"parameters": None, "field": "field.nc"}

RUN_DAMAGES = {
    "no time": (lambda run: run.drop_vars("time"), "has no time over time"),
    "a number": (lambda run: run.assign(predicted_position=0.0), "has no predicted_position over"),
    "other functions": (lambda run: run.isel(basis=[0, 1]), "axis 2, basis 3"),
    "turned": (lambda run: run.transpose("axis", ...), "has no position over time, axis"),
    "far times": (lambda run: run.assign_coords(time=run.time + 1e15), "must lie in 0 to"),
    "a huge place": (lambda run: run.assign(position=run.position + 1e308), "no finite number"),
    "a team": (lambda run: run.assign_attrs(team="[team]"), "a scenario and a team"),
    "no scenario": (lambda run: run.drop_attrs(), "carries no scenario"),
    "turned round": (lambda run: run.isel(time=slice(None, None, -1)), "its times do not increase"),
    "twice at one time": (lambda run: run.isel(time=[0, 0, 1, 2]), "its times do not increase"),
    "no waypoints": (lambda run: run.drop_vars("reference"), "has no reference over time, axis"),
    "a gap": (lambda run: run.assign(reference=run.reference.where(run.time > 30)), "no finite"),
    "one sample": (lambda run: run.isel(time=[0]), "has fewer than two samples"),
    "words": (lambda run: run.assign(clpe=run.clpe.astype(str)), "no finite number"),
}
NEEDED_BY_ESTIMATE = ("no waypoints", "a gap", "one sample")


@pytest.fixture(scope="module")
def run():
    return simulate(paper_scenario().with_values({"run.duration": 400, "run.output_step": 20}))


@pytest.mark.parametrize("name", RUN_DAMAGES)
def test_a_damaged_run_is_refused_by_all_that_open_runs(refused_for, run, name):
    damage, said = RUN_DAMAGES[name]
    damage(run).to_netcdf("run.nc")
    others = (("report", "-o", "out.html"), ("animate", "-o", "out.gif"), ("excitation",))
    for command, *out in (("estimate",), *(() if name in NEEDED_BY_ESTIMATE else others)):
        refused_for([said], command, "run.nc", *out)
    if name == "no scenario":
        refused_for([said], "run", "run.nc", "--out", "again.nc")


def test_warnings_of_libraries_are_no_words_of_a_command():
    code = (
        "import warnings; from clpt_control import cli\n"
        "warn = lambda **options: warnings.warn('a word of a library', RuntimeWarning)\n"
        "cli.application = lambda: warn\n"
        "cli.main()"
    )
    ended = ran(sys.executable, "-c", code)
    assert (ended.stdout, ended.stderr) == ("", "")


def test_places_that_cannot_be_written(refused_for):
    write({})
    Path("file").write_text("")
    for arguments, words in [
        (("run", "s.toml", "--out", "no/run.nc"), ["no", "folder"]),
        (("run", "s.toml", "--out", "."), ["is a folder"]),
        (("paper", "--out", "file"), ["is a file"]),
        (("init", "no/p.toml"), ["cannot be written"]),
    ]:
        refused_for(words, *arguments)


def test_field_files_that_cannot_be_used(refused_for):
    good = uniform_field("field.nc", 0.0, 0.0, half=20.0, end=4e4)
    gap = good.copy(deep=True)
    gap.u[1, 1, 1] = np.nan
    unit = good.copy(deep=True)
    unit.u.attrs["units"] = "furlong"
    uneven = good.assign_coords(x=("x", [-20.0, -10.0, 0.0, 9.0, 20.0], {"units": "m"}))
    write({f"flow.{key}": value for key, value in FIELD.items()})
    for data, words in [
        (good.drop_vars("v"), ["'v'"]),
        (gap, ["u has gaps"]),
        (unit, ["furlong", "speed"]),
        (uneven, ["x must have two points or more, evenly"]),
        (good.assign_coords(y=("y", np.arange(5.0))), ["y has units"]),
    ]:
        data.to_netcdf("field.nc")
        refused_for(["field.nc", *words], *RUN)


def test_sizes_that_no_machine_holds_are_refused_before_work(refused_for):
    many = 20_000
    basis = {"centers": [[1.0, 1.0]] * many, "widths": [1.0] * many, "periods": [1.0] * many}
    changes = {f"basis.{key}": values for key, values in basis.items()} | {"basis.phases": None}
    changes |= {"run.output_step": 0.1, "flow.parameters": [[0.1] * many] * 2}
    write(changes | dict.fromkeys(("model.parameters", "learning.parameters")))
    words = "2e+04 samples of 20000 basis functions would take 84.5 GB of memory; at most 4 are"
    refused_for([words], *RUN)
    write({"run.output_step": 1e-4})
    refused_for(["2e+07 samples of 3 basis functions", "GB"], *RUN)
    shutil.copy(clpt_control.currents.sample_currents(), "g.nc")
    for rows in ("99999999999999999999", "9" * 400):
        refused_for([" samples for 8999999"], "fit", "g.nc", "--rows", rows, "--out", "f.toml")
    aim = ("replay", "--sample", "--aim", "-43", "8")
    refused_for(
        ["a dive of 1e-300 hours at 1 m/s through the water: give 1 s to 720 hours"],
        *aim,
        "--hours=1e-300",
    )


def test_long_headers_and_comments_are_read(refused_for):
    spaces = " " * 4000
    for text, said in (
        (f"time,u{spaces}(m/s,v (m/s)\n1,2,3\n", "no column u"),
        (f"{spaces}x{spaces}(\n1\n", "no column time"),
        (f"# a{' ' * 10**5}b\n# {'a' * 10**5}\n# x: {' ' * 10**5}y\ntime\n", "no column u"),
    ):
        Path("r.csv").write_text(text)
        refused_for([said], "tides", "r.csv", "--constituents", "M2")
