"""`clpt replay` as a command: figures, table, JSON, mistakes, following."""

import json
import re
import shlex
from pathlib import Path

import numpy as np
import pytest
import xarray
from made_fields import gridded_current
from synthetic_vehicle import one_file_each
from test_follow_command import RESULTS

from clpt_control.gliders.dive_files import sample_dives

PAGE = Path(__file__).parents[2] / "docs" / "gliders.md"


@pytest.mark.skipif(not PAGE.exists(), reason="installed without docs")
def test_the_screen_that_is_read_aloud_is_what_the_command_says(command, monkeypatch):
    def plain(text):
        return {" ".join(re.sub("[│┃|]", " ", line).split()) for line in text.splitlines()}

    monkeypatch.setenv("COLUMNS", "80")
    read = PAGE.read_text("utf-8").partition("## One screen")[2].partition("## What to do")[0]
    shown = "\n".join(re.findall(r"```\w+\n(.*?)```", read, re.DOTALL))
    words = shlex.split(re.search(r"clpt replay (.*)", shown)[1])
    lines = plain(shown) - {"", "...", "$ COLUMNS=80 clpt replay " + " ".join(words)}
    assert len(lines) > 15
    assert lines <= plain(command(*words).stdout)


def test_the_command(command, tmp_path):
    done = command("--sample", "--out", tmp_path / "out", "--json")
    found = json.loads(done.stdout)
    assert (found["dives"], found["used"], found["skipped"]) == (14, 14, [])
    assert set(found["clpe_rms"]) == {"no_flow", "previous_dive", "adaptive"}
    assert found["clpe_rms_after_3"]["adaptive"] < 0.88 * found["clpe_rms_after_3"]["previous_dive"]
    assert 0.7 < found["speed_factor"]["value"] < 1
    assert {p.name for p in (tmp_path / "out").iterdir()} == set(RESULTS)
    table = command("--sample", "--no-learn-speed", "--flow", "steady", "--estimator", "gradient")
    assert table.exit_code == 0
    assert "after the third dive" in table.stdout
    for words, says in (
        ((), "give files"),
        (("--sample", "--follow", tmp_path), "give files"),
        (("--follow", tmp_path / "none"), "no such folder"),
        (("--sample", "--flow", "M2"), "must begin with steady"),
        (("--sample", "--least-duration", "1e9"), "must last longer"),
    ):
        assert says in str(command(*words).exception)


@pytest.mark.usefixtures("undrawn")
def test_the_command_follows(command, follow, tmp_path):
    (tmp_path / "in").mkdir()
    words = (tmp_path / "in", "--out", tmp_path / "out", "--json")
    empty = json.loads(follow(*words).stdout)
    assert empty["used"] == 0
    assert empty["clpe_rms"]["adaptive"] is None
    for part in (sample_dives()[:5], sample_dives()[5:]):
        one_file_each(tmp_path / "in", part)
        followed = json.loads(follow(*words).stdout)
    for key, none in (("vehicle", "glider"), ("kind", None)):
        assert followed.pop(key) == none  # the table of dives names none
    sample = json.loads(command("--sample", "--json").stdout)
    assert (sample.pop("vehicle"), sample.pop("kind")) == ("SG542", "Seaglider")
    assert followed == sample
    assert (tmp_path / "out" / "replay.nc").exists()


@pytest.fixture
def forecast(tmp_path):
    """A forecast over SG542's area and first two days: u grows eastward, v with time."""
    u = np.broadcast_to(np.array([0.05, 0.15]), (2, 2, 2))
    v = np.broadcast_to(np.array([0.02, 0.08])[:, None, None], (2, 2, 2))
    axes = [-44.0, -42.0], [7.5, 9.5], [0.0, 48.0]
    gridded_current(u, v, *axes, since="2016-01-31").to_netcdf(tmp_path / "forecast.nc")
    return tmp_path / "forecast.nc"


@pytest.mark.usefixtures("undrawn")
def test_the_command_with_a_flow_model(command, forecast, tmp_path):
    out = tmp_path / "out"
    found = json.loads(command("--sample", "--flow-model", forecast, "--out", out, "--json").stdout)
    given = found["flow_model"]
    assert given["source"] == "forecast.nc"
    assert 0 < given["covered"] < 14
    assert {entry["why"] for entry in given["uncovered"]} == {
        "outside the forecast's steps, or in a gap of them"
    }
    with xarray.open_dataset(out / "replay.nc") as data:
        covered = np.isfinite(data.clpe_flow_model.values)
        assert covered.sum() == given["covered"]
        # a flow of 0.05 to 0.15 and 0.02 to 0.08 m/s carries a dive so far
        hours = (data.time - data.start_time).values[covered] / np.timedelta64(1, "s")
        for axis, low, high in (("east", 0.05, 0.15), ("north", 0.02, 0.08)):
            speed = data[f"flow_model_{axis}"].values[covered] / hours
            assert np.all((low - 1e-3 < speed) & (speed < high + 1e-3))
        rms = np.sqrt(np.mean(data.clpe_flow_model.values[covered][1:] ** 2))
        bare = np.sqrt(np.mean(data.clpe_no_flow.values[covered][1:] ** 2))
    assert found["clpe_rms"]["flow_model"] == given["clpe_rms"]["flow_model"] == pytest.approx(rms)
    assert given["clpe_rms"]["no_flow"] == pytest.approx(bare)
    table = command("--sample", "--flow-model", forecast)
    assert "model" in table.stdout
    assert "covered, after the first dive" in table.stdout
    assert f"covers {given['covered']} of 14 dives" in table.stdout
    for name, says in (("state.toml", "state.toml"), ("model.txt", "no such file")):
        assert says in str(command("--sample", "--flow-model", tmp_path / name).exception)


@pytest.mark.usefixtures("undrawn")
def test_tides_need_a_record(command, follow, tmp_path):
    words = ("--flow", "steady,M2,S2")
    failed = str(command("--sample", *words).exception)
    assert "cannot be told apart: M2 and S2" in failed
    assert command("--sample", "--flow", "steady,M2,K1", "--estimator", "gradient").exit_code == 0
    (tmp_path / "in").mkdir()
    one_file_each(tmp_path / "in", sample_dives()[:1])
    words += ("--out", tmp_path / "out", "--estimator", "gradient", "--json")
    done = follow(tmp_path / "in", *words)
    assert "so far, flow steady,M2,S2" in done.stderr
    found = json.loads(done.stdout)
    assert found["used"] == 1
    assert set(found["clpe_rms"].values()) == {None}
    assert found["clpe_rms_all"]["no_flow"] > 0


@pytest.mark.usefixtures("undrawn")
def test_results_of_following_lie_in_the_folder_by_default(follow, tmp_path):
    one_file_each(tmp_path, sample_dives()[:2])
    for _ in range(2):  # its own results are no dives
        assert json.loads(follow(tmp_path, "--json").stdout)["used"] == 2
    assert (tmp_path / "replay" / "replay.nc").exists()


def test_a_plan_of_the_next_dive(command):
    found = json.loads(command("--sample", "--next", "4", "0", "3000", "--json").stdout)
    ahead = found["next_dive"]
    assert (ahead["duration"], ahead["dr_north"]) == (14400.0, 3000.0)
    assert ahead["latitude"] > sample_dives()[-1].lat_gpse
    said = command("--sample", "--next", "4", "0", "3000").stdout
    assert "next surfacing 2016-02-03 13:56 UTC +- " in said
    assert "min, in 4.1 h from the end of the last dive" in said
    for words, says in (
        (("0", "0", "0"), "a dive of 0 hours"),
        (("nan", "0", "0"), "a dive of nan hours"),
        (("5", "1e300", "0"), "at most 5 m/s"),
        (("5", "1e8", "0"), "a dive of 5 hours at 5556 m/s"),
        (("14400", "0", "3000"), "to 720 hours"),
        (("1e306", "0", "0"), "to 720 hours"),
    ):
        assert says in str(command("--sample", "--next", *words).exception)
    assert ahead["why_uncovered"] is None


def test_whether_the_flow_model_covers_the_plan_is_said(command, forecast):
    words = ("--sample", "--flow-model", forecast, "--least-duration", "15000")
    ahead = json.loads(command(*words, "--json").stdout)["next_dive"]
    assert "outside the forecast's steps" in ahead["why_uncovered"]
    said = f"; the flow model does not cover it: {ahead['why_uncovered']}"
    assert said in command(*words).stdout


def test_gaussians_from_the_command(command):
    words = ("--sample", "--flow", "steady,gaussians")
    assert "gaussians (odds " in command(*words).stdout
    assert "needs --flow-model" in str(command("--sample", "--flow", "steady,model").exception)
