"""`clpt replay` as a command: figures, table, JSON, aims, flow models, mistakes; following."""

import json
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import time
from dataclasses import replace
from signal import SIGTERM as TERM

import numpy as np
import pytest
import xarray
from gridded_currents import gridded_current
from paths import ROOT
from subprocesses import ran, without_progress
from synthetic_vehicle import one_file_each

from clpt_control.gliders import sample_dives, write_dive_table

TABLES = ("replay.nc", "replay.html", "next.geojson", "track.kml")
RESULTS = (*TABLES, "replay.png")


def rows_of(text):
    """Cells of the first table that was printed."""
    lines = text.splitlines()
    head = next(k for k, line in enumerate(lines) if line.startswith("┃"))
    end = next(k for k, line in enumerate(lines) if line.startswith("└"))
    lines = [
        line.replace("┃", "│").strip("│") for line in lines[head:end] if line[0] in "┃│"
    ]
    titles, *rows = [[cell.strip() for cell in line.split("│")] for line in lines]
    return titles, rows


def percent(found):
    """The level of forecasts in words."""
    return f"{100 * found['level']:g} %"


def test_the_command(sample, command):
    found = sample.found
    assert (found["dives"], found["used"], found["skipped"]) == (14, 14, [])
    assert set(found["clpe_rms"]) == {"no_flow", "previous_dive", "adaptive"}
    assert 0.7 < found["speed_factor"]["value"] < 1
    assert {p.name for p in sample.folder.iterdir()} == set(RESULTS)
    titles, rows = rows_of(sample.text)
    ahead = found["next_dive"]
    assert (len(rows), rows[-1][:2]) == (
        15,
        ["next", ahead["time"][5:16].replace("T", " ")],
    )
    assert " x " in rows[-1][titles.index(f"{percent(found)} half axes m, deg")]
    assert rows[-1][titles.index("adaptive")] == ""
    table = command("--sample", "--no-learn-speed", "--flow", "steady")
    assert table.exit_code == 0
    assert "after the third dive" in table.stdout
    gaussians = command("--sample", "--flow", "steady,gaussians")
    assert "gaussians (odds " in gaussians.stdout


@pytest.mark.parametrize("width", [20, 80, 200])
def test_the_table_keeps_what_matters(width, sample, command, monkeypatch):
    monkeypatch.setenv("COLUMNS", str(width))
    found, said = sample.found, command("--sample").stdout
    assert "…" not in said
    titles, (*rows, ahead) = rows_of(said)
    assert ahead[0] == "next"
    assert {"dive", "previous", "adaptive", percent(found)} <= set(titles)
    assert all(titles)
    for row, dive in zip(rows, found["each_dive"], strict=True):
        assert row[titles.index("dive")] == str(dive["dive"])
        assert row[titles.index("adaptive")] == f"{dive['clpe']['adaptive']:.0f}"
        assert row[titles.index(percent(found))] in ("in", "OUT", "-")
    if width >= 60:
        table = [line for line in said.splitlines() if line[:1] in "┏┃┡│└"]
        assert max(map(len, table)) <= width
    assert (len(titles) > 12) == (width == 200)


MISTAKES = [
    ("", "Give files"),
    ("--sample a.csv", "Give files"),
    ("--sample --flow M2", "must begin with steady"),
    ("--sample --flow steady,M2,S2", "cannot be distinguished: M2 and S2"),
    ("--sample --flow steady,model", "needs --flow-model"),
    ("--sample --flow-model state.toml", "state.toml"),
    ("--sample --flow-model model.txt", "no such file"),
    ("--sample --units m/s", "--units m/s: is for --flow-model FILE"),
    ("--sample --least-duration 1e9", "must last longer"),
    ("--sample --variation 3", "no dive has dead reckoning from a magnetic"),
    ("--sample --variation nan", "must be -180 to 180"),
    ("--sample --next 0 0 0", "a dive of 0 hours"),
    ("--sample --next nan 0 0", "a dive of nan hours"),
    ("--sample --next 5 1e300 0", "at most 5 m/s"),
    ("--sample --next 14400 0 3000", "to 720 hours"),
    ("--sample --aim 4304.27 8.0", "decimal degrees"),
    ("--sample --aim nan 8", "must be a latitude"),
    ("--sample --speed 0.2", "Give a waypoint"),
    ("--sample --aim 40 8 --speed -1", "at -1 m/s"),
    ("--sample --aim 40 8 --speed 0", "reaches no waypoint. Give --speed"),
    ("--sample --aim 40 8 --hours 1e9", "to 720 hours"),
    (
        "watch . --fleet",
        "no subfolder has dive files. Give a folder with one subfolder per vehicle",
    ),
    ("watch no --fleet", "folder not found"),
    ("watch . --fleet --aim 1 2", "are for one vehicle"),
    ("watch . --fleet --alert no-such-command-here", "command not found"),
    ('watch . --fleet --alert "echo \'a"', "command not found"),
    ("watch none", "folder not found"),
    ("watch . --every inf", "--every inf s: must be above 0 s and at most 86400 s"),
    ("watch . --every nan", "at most 86400 s"),
    ("watch . --every 0", "above 0 s"),
    ("watch . --patience nan", "--patience nan s: must be 0 s or more"),
    ("watch . --out .", "would be in the watched folder"),
    ("watch . --out ''", "'--out': is empty"),
    ("watch ''", "'FOLDER': is empty"),
]


@pytest.mark.parametrize(("words", "says"), MISTAKES)
def test_each_mistake_is_one_sentence(words, says, refused_for, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    command = [] if words.startswith("watch ") else ["replay"]
    refused_for([says], *command, *shlex.split(words))


@pytest.fixture
def forecast(tmp_path):
    """A forecast over SG542's area and first two days: u grows eastward, v with time."""
    u = np.broadcast_to(np.array([0.05, 0.15]), (2, 2, 2))
    v = np.broadcast_to(np.array([0.02, 0.08])[:, None, None], (2, 2, 2))
    axes = [-44.0, -42.0], [7.5, 9.5], [0.0, 48.0]
    gridded_current(u, v, *axes, since="2016-01-31").to_netcdf(tmp_path / "forecast.nc")
    return tmp_path / "forecast.nc"


@pytest.mark.long
@pytest.mark.usefixtures("undrawn")
def test_the_command_with_a_flow_model(command, forecast, tmp_path):
    out, why = tmp_path / "out", "outside the forecast's steps, or in a gap of them"
    words = ("--sample", "--flow-model", forecast)
    found = json.loads(command(*words, "--out", out, "--json").stdout)
    given = found["flow_model"]
    assert (given["source"], 0 < given["covered"] < 14) == ("forecast.nc", True)
    assert {entry["why"] for entry in given["uncovered"]} == {why}
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
    assert (
        found["clpe_rms"]["flow_model"]
        == given["clpe_rms"]["flow_model"]
        == pytest.approx(rms)
    )
    assert given["clpe_rms"]["no_flow"] == pytest.approx(bare)
    assert found["next_dive"]["why_uncovered"] == why
    table = command(*words).stdout
    for said in (
        "covered, after the first dive",
        f"covers {given['covered']} of 14 dives",
        f"; the flow model does not cover the next dive: {why}",
    ):
        assert said in table


def test_a_plan_of_the_next_dive(command):
    words = ("--sample", "--next", "4", "0", "3000")
    ahead = json.loads(command(*words, "--json").stdout)["next_dive"]
    assert (ahead["duration"], ahead["dr_north"]) == (14400.0, 3000.0)
    assert ahead["latitude"] > sample_dives()[-1].lat_gpse
    assert ahead["why_uncovered"] is None
    said = command(*words).stdout
    assert "next surfacing 2016-02-03 13:56 UTC +- " in said
    assert "min, in 4.1 h from the end of the last dive" in said


def test_a_replay_has_no_map_of_the_flow(sample, refused_for):
    file = sample.folder / "replay.nc"
    refused_for(["is a replay of dives", "track.kml"], "export", file, "-o", "map.nc")


@pytest.mark.parametrize("field", ["dr_east", "t_gps2", "lat_gpse"])
def test_a_last_dive_without_use_still_ends_at_a_fix(command, tmp_path, field):
    *dives, last = sample_dives()
    lost = replace(last, **{field: float("nan")})
    write_dive_table([*dives, lost], tmp_path / "lost.csv")
    words = (tmp_path / "lost.csv", "--next", "4.5", "0", "3000", "--json")
    found = json.loads(command(*words).stdout)
    ahead, fixed = found["next_dive"], dives[-1] if field == "lat_gpse" else last
    assert [skip["dive"] for skip in found["skipped"]] == [last.number]
    assert (ahead["from_latitude"], ahead["from_longitude"]) == fixed.end
    begins = fixed.t_gpse + ahead["surface_time"]
    assert np.datetime64(ahead["time"][:19], "s").astype(float) == pytest.approx(
        begins + 4.5 * 3600, abs=1.0
    )


@pytest.mark.long
def test_aiming_by_the_command(command, sample):
    words = ("--sample", "--aim", "-42.92", "-351.57")
    found = json.loads(command(*words, "--json").stdout)
    assert [(leg["latitude"], leg["longitude"]) for leg in found["aim"]] == [
        (-42.92, -351.57)
    ]
    assert (found["each_dive"], sample.found["aim"]) == (sample.found["each_dive"], [])
    first = found["aim"][0]
    assert (
        f"heading {first['heading']:03.0f} (magnetic {first['heading_magnetic']:03.0f})"
        in command("--sample", "--aim", "-42.92", "8.43").stdout
    )
    words = ("--sample", "--aim", "-42.5", "8.0")
    said = command(*words).stdout
    assert "aim at 42 30.00 S 8 00.00 E (42.5000 S 8.0000 E)" in said
    assert "m made good of" in said
    slow = command(*words, "--speed", "0.01", "--hours", "6", "--json")
    (leg,) = json.loads(slow.stdout)["aim"]
    assert (leg["state"], leg["duration"]) == ("cannot be made", 21600)
    assert (
        "cannot be made against the current"
        in command(*words, "--speed", "0.01").stdout
    )
    upstream = ("--sample", "--aim", "-42.93", "8.42", "--speed", "0.01")
    assert "m are lost, then " in command(*upstream).stdout


def test_the_headline_is_the_dive_that_is_aimed(command):
    found = json.loads(command("--sample", "--aim", "-43.4", "8.4", "--json").stdout)
    ahead, leg = found["next_dive"], found["aim"][0]
    assert ahead["basis"] == "given"
    end = leg["end"], leg["end_latitude"], leg["end_longitude"]
    assert (ahead["time"], ahead["latitude"], ahead["longitude"]) == end
    assert ahead["ellipse_long"] == leg["ellipse_long"]
    assert np.hypot(ahead["dr_east"], ahead["dr_north"]) == pytest.approx(
        leg["through_water"]
    )


# --- following a folder, and the hook of basestation3 that does ---


@pytest.mark.long
@pytest.mark.usefixtures("undrawn")
def test_the_command_follows(follow, sample, tmp_path):
    (tmp_path / "in").mkdir()
    words = (tmp_path / "in", "--out", tmp_path / "out", "--json")
    empty = json.loads(follow(*words).stdout)
    assert (empty["used"], empty["clpe_rms"]["adaptive"]) == (0, None)
    for part in (sample_dives()[:5], sample_dives()[5:]):
        one_file_each(tmp_path / "in", part)
        followed = json.loads(follow(*words).stdout)
    # the table of dives names no vehicle: the folder does
    assert followed == sample.found
    assert (tmp_path / "out" / "replay.nc").exists()


@pytest.mark.long
@pytest.mark.usefixtures("undrawn")
def test_what_the_dives_so_far_do_not_allow_is_told_and_work_goes_on(
    command, follow, tmp_path
):
    """Two tides on one dive, and aiming by a vehicle that does not swim."""
    still = {"dr_east": 0.0, "dr_north": 0.0, "dac_east": None, "dac_north": None}
    one_file_each(tmp_path, [replace(sample_dives()[0], **still)])
    words = ("--flow", "steady,M2,S2", "--aim", "-42.5", "8.0", "--json")
    for _ in range(2):
        # its own results, which lie in the folder by default, are no dives
        done = follow(tmp_path, *words)
        found = json.loads(done.stdout)
        assert (found["used"], found["aim"]) == (1, [])
    assert (tmp_path / "replay" / "replay.nc").exists()
    assert "so far, flow steady,M2,S2" in done.stderr
    assert (
        "so far, --aim: 0 m/s, given or of the last dives, reaches no waypoint"
        in done.stderr
    )
    assert set(found["clpe_rms"].values()) == {None}
    assert found["clpe_rms_all"]["no_flow"] > 0
    two = command("--sample", "--flow", "steady,M2,K1")
    assert two.exit_code == 0


@pytest.mark.usefixtures("undrawn")
def test_the_line_of_following(follow, tmp_path):
    dives = sample_dives()[:3]
    one_file_each(tmp_path, dives)
    done = follow(tmp_path, "--aim", "-43.05", "8.4", "--json")
    line = next(line for line in done.stderr.splitlines() if "dives used" in line)
    said = r"3 new files, 3 dives used; dive 306: position error \d+ m; next surfacing 2016-02-01"
    assert re.search(said, line)
    assert "h from the end of the last dive, near 43 " in line
    assert "; aim at 43 03.00 S 8 24.00 E" in line
    assert len(json.loads(done.stdout)["aim"]) == 1


@pytest.mark.usefixtures("undrawn")
def test_sigterm_ends_following_with_its_results(clpt, tmp_path, monkeypatch):
    one_file_each(tmp_path, sample_dives()[:1])
    before = signal.getsignal(TERM)
    monkeypatch.setattr(time, "sleep", lambda _: signal.raise_signal(TERM))
    outcome = clpt("watch", tmp_path, "--out", tmp_path / "out", "--json")
    assert outcome.err.startswith("1 new file, 1 dive used; dive 304")
    assert (outcome.status, json.loads(outcome.out)["used"]) == (0, 1)
    assert signal.getsignal(TERM) is before


LIMITED = """
import resource, sys
from pathlib import Path
size = int(sys.argv.pop(1))
import matplotlib.font_manager  # what it keeps for itself is written before
resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
from clpt_control.app.cli import main
main()
"""


PROCESSES = [
    pytest.param(n, marks=pytest.mark.processes) for n in RESULTS if n != "replay.png"
]


@pytest.mark.long
@pytest.mark.parametrize("name", ["replay.png", *PROCESSES])
def test_a_full_disk_leaves_the_results_as_they_were(tmp_path, sample, name):
    """A limit on files stands in for the disk; a file is one half too large."""
    for other in RESULTS:
        (tmp_path / other).write_text("old")
    size = (sample.folder / name).stat().st_size // 2
    words = ("replay", "--sample", "--json", "--out", tmp_path)
    said = without_progress(
        ran(sys.executable, "-c", LIMITED, size, *words, status=2).stderr
    )
    assert "cannot be written" in said
    assert said.count("\n") == 1
    left = {path.name: path.read_text() for path in tmp_path.iterdir()}
    assert left == dict.fromkeys(RESULTS, "old")


@pytest.mark.long
@pytest.mark.usefixtures("undrawn")
def test_a_folder_in_the_place_of_a_result_leaves_all_others_as_they_were(
    refused, tmp_path
):
    inbox, out = tmp_path / "in", tmp_path / "out"
    inbox.mkdir()
    one_file_each(inbox, sample_dives()[:2])
    (out / "replay.html").mkdir(parents=True)
    others = [name for name in RESULTS if name != "replay.html"]
    for name in others:
        (out / name).write_text("old")
    for words in (("watch", inbox, "--patience", "0"), ("replay", inbox)):
        assert "replay.html: is a folder" in refused(*words, "--out", out)
        assert [(out / name).read_text() for name in others] == ["old"] * len(others)
        assert not list(out.glob(".*.part"))


def test_following_without_dives_says_so(clpt, tmp_path):
    (tmp_path / "half.nc").write_bytes(b"CDF\x01")
    outcome = clpt("watch", tmp_path, "--patience", "0")
    assert outcome.status == 0
    reason, line = outcome.err.splitlines()
    said = f"so far, {tmp_path / 'half.nc'}: damaged or cut short"
    assert reason.startswith(said)  # the reason beside the name, at once
    assert line == "1 new file, 0 dives used"
    assert outcome.out == "no dives yet\n"


@pytest.mark.parametrize(("every", "seen"), [(1000, ["3"]), (10, ["1", "2"])])
def test_patience_is_time(clpt, tmp_path, monkeypatch, every, seen):
    """The clock moves by waits alone; files arrive at 1 s, 11 s and 15 s."""
    now, arrive = [0.0], iter([1.0, 11.0, 15.0, np.inf])
    following = [next(arrive)]

    def sleep(seconds):
        now[0] += seconds
        if now[0] >= following[0]:
            (tmp_path / f"{following[0]}.nc").write_bytes(b"CDF\x01")
            following[0] = next(arrive)

    monkeypatch.setattr(time, "monotonic", lambda: now[0])
    monkeypatch.setattr(time, "sleep", sleep)
    ended = clpt("watch", tmp_path, "--every", every, "--patience", 25)
    assert ended.status == 0
    assert re.findall(r"^(\d) new file", ended.err, re.MULTILINE) == ["0", *seen]
    # after the last file that was seen
    assert now[0] == pytest.approx(50.0 if every > 25 else 45.0)


@pytest.fixture
def mission(tmp_path, facts):
    """A mission directory with dives and what else lies there; `NewMission` links the hook."""
    home = tmp_path / "sg542"
    shutil.copytree(facts / "glider" / "basestation", home / "mission")
    shutil.copy(ROOT / "examples" / "basestation3_post_dive.sh", home / ".post_dive")
    (home / "mission" / ".post_dive").symlink_to(home / ".post_dive")
    (home / "mission" / "comm.log").write_text("no dive\n")
    (home / "mission" / "sg542_profile.nc").write_bytes(b"no NetCDF")
    return home / "mission"


def logged(line, folder):
    """Run a line as `Utils.run_cmd_shell` does, where `clpt` tells its words; return the log."""
    clpt = folder / "clpt"
    clpt.write_text('#!/bin/sh\necho a table; echo "$@" >&2\n')
    clpt.chmod(0o755)
    path = f"{folder}:{os.environ['PATH']}"
    options = {
        "shell": True,
        "text": True,
        "check": True,
        "env": {**os.environ, "PATH": path},
    }
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT}
    return subprocess.run(line, cwd="/", **options, **pipes).stdout


@pytest.mark.long
@pytest.mark.usefixtures("undrawn")
def test_the_page_is_written_after_each_dive(mission, clpt, tmp_path):
    words = logged(f"{mission}/.post_dive ", tmp_path)  # as older versions do
    assert (
        logged(f"{mission}/.post_dive {tmp_path}/basestation {mission} ", tmp_path)
        == words
    )
    asked = f"watch {mission} --patience 0 --out {mission}/clpt\n"
    assert words == asked  # and nothing of standard output
    outcome = clpt(*words.split())
    assert outcome.status == 0
    assert "7 new files, 6 dives used; dive 309: position error " in outcome.err
    assert outcome.err.count("\n") == 1  # a line of the log
    assert "dive 309" in (mission / "clpt" / "replay.html").read_text("utf-8")
