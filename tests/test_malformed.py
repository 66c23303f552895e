"""Bad input: one line that names the key or file, status 2, nothing half-written."""

import tomllib

import numpy as np
import pytest
import tomlkit
import xarray

from clpt_control.paper import paper_text

FIELD = {"parameters": None, "field": "field.nc"}

SCENARIOS = {  # name -> (changes, words that the line must hold)
    "unknown key": ({"learning.gian": 1.0}, ["learning.gian", "did you mean gain"]),
    "unknown table": ({"lerning.gain": 1.0}, ["lerning", "learning"]),
    "missing key": ({"basis.widths": None}, ["basis.widths", "missing"]),
    "missing table": ({"vehicle": None}, ["vehicle", "missing"]),
    "wrong shape of theta": ({"flow.parameters": [[1.0, 2.0], [1.0, 2.0]]},
                             ["flow.parameters", "2 rows of 3"]),
    "three rows": ({"flow.parameters": [[1.0, 2.0, 3.0]] * 3}, ["flow.parameters"]),
    "too few widths": ({"basis.widths": [5.0, 5.0]}, ["basis.widths", "3 entries"]),
    "NaN": ({"vehicle.position": [float("nan"), 0.0]}, ["vehicle.position[0]", "finite"]),
    "infinite": ({"learning.feedback": [float("inf"), 0.0]}, ["learning.feedback[0]", "finite"]),
    "negative width": ({"basis.widths": [5.0, -5.0, 5.0]}, ["basis.widths[1]", "greater than 0"]),
    "zero period": ({"basis.periods": [0.0, 1.0, 1.0]}, ["basis.periods[0]", "positive"]),
    "feedback not positive": ({"vehicle.feedback": [1.0, 0.0]},
                              ["vehicle.feedback[1]", "greater than 0"]),
    "negative gain": ({"learning.gain": -0.8}, ["learning.gain", "-0.8", "greater than 0"]),
    "text for a number": ({"learning.gain": "0.8"}, ["learning.gain", "'0.8'", "number"]),
    "true for a number": ({"learning.gain": True}, ["learning.gain", "number"]),
    "unknown kernel": ({"basis.kernel": "gauss"}, ["basis.kernel", "'gaussian-sigma'"]),
    "unknown law": ({"learning.law": "known"}, ["learning.law", "'known-flow'"]),
    "unknown unit": ({"units.time": "hours"}, ["units.time", "'h'"]),
    "unknown constituent": ({"basis.periods": None, "basis.constituents": ["M2", "K1", "X9"]},
                            ["X9", "steady"]),
    "periods and constituents": ({"basis.constituents": ["M2", "K1", "O1"]},
                                 ["basis.periods", "one of the two"]),
    "count not whole": ({"reference.count": 2.5}, ["reference.count", "2.5", "integer"]),
    "count zero": ({"reference.count": 0}, ["reference.count", "greater than or equal to 1"]),
    "unknown reference": ({"reference.kind": "square"}, ["reference.kind", "waypoints"]),
    "zero dwell": ({"reference.dwell": 0.0}, ["reference.dwell", "greater than 0"]),
    "zero duration": ({"run.duration": 0.0}, ["run.duration", "greater than 0"]),
    "endless output": ({"run.output_step": 1e-9}, ["run.output_step", "1e8"]),
    "known flow without estimate": ({"learning.law": "known-flow", "learning.parameters": None},
                                    ["learning.theta_estimate", "required"]),
    "known flow with alpha": ({"learning.law": "known-flow"}, ["learning."]),
    "theta and field": ({"flow.field": "field.nc"}, ["flow.parameters", "one of the two"]),
    "missing field": ({f"flow.{k}": v for k, v in FIELD.items()}, ["flow.field", "no such file"]),
    "outside without field": ({"flow.outside": "clip"}, ["flow.outside", "only with flow.field"]),
    "seed of a sine": ({"flow.disturbance": {"kind": "sine", "amplitude": [1.0, 0.0],
                                             "period": 1.0, "seed": 1}},
                       ["flow.disturbance.seed", "noise"]),
    "square without period": ({"flow.disturbance": {"kind": "square", "amplitude": [1.0, 0.0]}},
                              ["flow.disturbance.period", "required"]),
}  # fmt: skip


def write(path, changes):
    tables = tomllib.loads(paper_text())
    for key, value in changes.items():
        *place, last = key.split(".")
        table = tables
        for name in place:
            table = table.setdefault(name, {})
        if value is None:
            del table[last]
        else:
            table[last] = value
    path.write_text(tomlkit.dumps(tables))


def assert_refused(outcome, folder, before, words):
    assert outcome.status == 2, outcome
    assert outcome.out == ""
    assert outcome.err.startswith("clpt: ")
    assert outcome.err.count("\n") == 1, outcome.err
    assert "Traceback" not in outcome.err
    for word in words:
        assert word in outcome.err, outcome.err
    assert sorted(path.name for path in folder.rglob("*")) == before


@pytest.mark.parametrize("name", SCENARIOS)
def test_scenario_is_refused(clpt, tmp_path, name):
    changes, words = SCENARIOS[name]
    write(tmp_path / "bad.toml", changes)
    outcome = clpt("run", tmp_path / "bad.toml", "--out", tmp_path / "run.nc")
    assert_refused(outcome, tmp_path, ["bad.toml"], ["bad.toml", *words])


def test_files_that_are_no_scenario(clpt, tmp_path):
    (tmp_path / "text.toml").write_text("gain 0.8")
    (tmp_path / "binary.toml").write_bytes(b"\xff\xfe\x00\x01")
    (tmp_path / "fake.nc").write_text("not NetCDF")
    (tmp_path / "cut.nc").write_bytes(b"\x89HDF\r\n\x1a\n" + bytes(40))
    xarray.Dataset({"a": ("n", np.zeros(3))}).to_netcdf(tmp_path / "other.nc")
    before = sorted(path.name for path in tmp_path.iterdir())
    for name, words in {
        "absent.toml": ["no such file", "clpt init"],
        "text.toml": ["TOML", "line 1"],
        "binary.toml": ["not text"],
        "absent.nc": ["no such file"],
        "fake.nc": ["NetCDF"],
        "cut.nc": ["NetCDF"],
        "other.nc": ["carries no scenario"],
    }.items():
        outcome = clpt("run", tmp_path / name, "--out", tmp_path / "run.nc")
        assert_refused(outcome, tmp_path, before, [name, *words])


def test_places_that_cannot_be_written(clpt, tmp_path):
    (tmp_path / "p.toml").write_text(paper_text())
    (tmp_path / "file").write_text("")
    before = sorted(path.name for path in tmp_path.iterdir())
    for arguments, words in [
        (("run", tmp_path / "p.toml", "--out", tmp_path / "no" / "run.nc"), ["no", "folder"]),
        (("run", tmp_path / "p.toml", "--out", tmp_path), ["is a folder"]),
        (("paper", "--out", tmp_path / "file"), ["is a file"]),
        (("init", tmp_path / "no" / "p.toml"), ["cannot be written"]),
    ]:
        assert_refused(clpt(*arguments), tmp_path, before, words)


def test_words_that_are_no_command(clpt, tmp_path):
    for arguments, words in [
        (("runn",), ["runn"]),
        (("run",), ["scenario"]),
        (("run", "a.toml"), ["--out"]),
        (("run", "a.toml", "--out", "b.nc", "--jsn"), ["--jsn"]),
    ]:
        assert_refused(clpt(*arguments), tmp_path, [], [])
        assert all(word in clpt(*arguments).err.lower() for word in words)


def test_field_files_that_cannot_be_used(clpt, tmp_path):
    axis = np.arange(4.0)
    good = xarray.Dataset(
        {name: (("time", "y", "x"), np.zeros((4, 4, 4)), {"units": "m s-1"}) for name in "uv"},
        {"time": ("time", 1e4 * axis, {"units": "s"}), "y": ("y", 10 * axis - 15, {"units": "m"}),
         "x": ("x", 10 * axis - 15, {"units": "m"})},
    )  # fmt: skip
    gap = good.copy(deep=True)
    gap.u[1, 1, 1] = np.nan
    unit = good.copy(deep=True)
    unit.u.attrs["units"] = "furlong"
    uneven = good.assign_coords(x=("x", [-15.0, -5.0, 4.0, 15.0], {"units": "m"}))
    for data, words in [
        (good.drop_vars("v"), ["'v'"]),
        (gap, ["u has gaps"]),
        (unit, ["furlong", "speed"]),
        (uneven, ["x must be evenly spaced"]),
        (good.assign_coords(y=("y", axis)), ["y has units"]),
    ]:
        data.to_netcdf(tmp_path / "field.nc")
        write(tmp_path / "s.toml", {f"flow.{key}": value for key, value in FIELD.items()})
        outcome = clpt("run", tmp_path / "s.toml", "--out", tmp_path / "run.nc")
        assert_refused(outcome, tmp_path, ["field.nc", "s.toml"], ["field.nc", *words])


def test_a_run_that_fails_has_status_one(clpt, tmp_path):
    axis = np.arange(4.0)
    xarray.Dataset(
        {name: (("time", "y", "x"), np.ones((4, 4, 4)), {"units": "m s-1"}) for name in "uv"},
        {"time": ("time", 1e4 * axis, {"units": "s"}), "y": ("y", axis - 1, {"units": "m"}),
         "x": ("x", axis - 1, {"units": "m"})},
    ).to_netcdf(tmp_path / "field.nc")  # fmt: skip
    write(tmp_path / "s.toml", {f"flow.{key}": value for key, value in FIELD.items()})
    outcome = clpt("run", tmp_path / "s.toml", "--out", tmp_path / "run.nc")
    assert outcome.status == 1
    assert "left the field at position" in outcome.err
    assert not (tmp_path / "run.nc").exists()
