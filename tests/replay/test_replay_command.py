"""`clpt replay` as a command: figures, table, JSON, where to aim, a flow model, mistakes."""

import json
import re
import shlex
from pathlib import Path

import numpy as np
import pytest
import xarray
from made_fields import gridded_current
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


def rows_of(text):
    """Cells of the first table that was printed."""
    lines = text.splitlines()
    head = next(k for k, line in enumerate(lines) if line.startswith("┃"))
    end = next(k for k, line in enumerate(lines) if line.startswith("└"))
    table = [
        [cell.strip() for cell in line.replace("┃", "│").strip("│").split("│")]
        for line in lines[head:end]
        if line[0] in "┃│"
    ]
    return table[0], table[1:]


def test_the_command(sample, command):
    found = sample.found
    assert (found["dives"], found["used"], found["skipped"]) == (14, 14, [])
    assert set(found["clpe_rms"]) == {"no_flow", "previous_dive", "adaptive"}
    assert found["clpe_rms_after_3"]["adaptive"] < 0.88 * found["clpe_rms_after_3"]["previous_dive"]
    assert 0.7 < found["speed_factor"]["value"] < 1
    assert {p.name for p in sample.folder.iterdir()} == set(RESULTS)
    titles, rows = rows_of(sample.text)
    ahead = found["next_dive"]
    assert (len(rows), rows[-1][:2]) == (15, ["next", ahead["time"][5:16].replace("T", " ")])
    assert " x " in rows[-1][titles.index("90 % ellipse (m, deg)")]
    assert rows[-1][titles.index("adaptive")] == ""
    table = command("--sample", "--no-learn-speed", "--flow", "steady", "--estimator", "gradient")
    assert table.exit_code == 0
    assert "after the third dive" in table.stdout
    gaussians = command("--sample", "--flow", "steady,gaussians")
    assert "gaussians (odds " in gaussians.stdout


@pytest.mark.parametrize("width", [20, 80, 200])
def test_the_table_keeps_what_matters(width, sample, capsys, monkeypatch):
    from clpt_control.cli.printing import finish
    from clpt_control.cli.replay_report import results

    monkeypatch.setenv("COLUMNS", str(width))
    found = json.loads(json.dumps(sample.found)) | {"next_dive": None, "aim": []}
    found["each_dive"][4]["anomaly"] = {"certain": False}
    tables = [one._replace(sentences=[]) for one in results(found)]
    finish(tables, found, False)
    said = capsys.readouterr().out
    assert "…" not in said
    titles, rows = rows_of(said)
    assert {"dive", "previous", "adaptive", "90 %", "mark"} <= set(titles)
    assert all(titles)
    marks = [row[titles.index("mark")] for row in rows]
    assert marks == ["SPEED?" if k == 4 else "" for k in range(14)]
    for row, dive in zip(rows, found["each_dive"], strict=True):
        assert row[titles.index("dive")] == str(dive["dive"])
        assert row[titles.index("adaptive")] == f"{dive['clpe']['adaptive']:.0f}"
        assert row[titles.index("90 %")] in ("in", "OUT")
    if width >= 60:
        assert max(map(len, said.splitlines())) <= width
    assert (len(titles) > 12) == (width == 200)


@pytest.mark.parametrize(
    ("words", "says"),
    [
        ("", "give files"),
        ("--sample --follow .", "give files"),
        ("--sample --flow M2", "must begin with steady"),
        ("--sample --flow steady,M2,S2", "cannot be told apart: M2 and S2"),
        ("--sample --flow steady,model", "needs --flow-model"),
        ("--sample --flow-model state.toml", "state.toml"),
        ("--sample --flow-model model.txt", "no such file"),
        ("--sample --units m/s", "--units m/s: is for --flow-model FILE"),
        ("--sample --least-duration 1e9", "must last longer"),
        ("--sample --variation 3", "no dive here has its dead reckoning from a magnetic"),
        ("--sample --variation nan", "must be -180 to 180"),
        ("--sample --next 0 0 0", "a dive of 0 hours"),
        ("--sample --next nan 0 0", "a dive of nan hours"),
        ("--sample --next 5 1e300 0", "at most 5 m/s"),
        ("--sample --next 14400 0 3000", "to 720 hours"),
        ("--sample --aim 4304.27 8.0", "decimal degrees"),
        ("--sample --aim nan 8", "must be a latitude"),
        ("--sample --speed 0.2", "give a waypoint"),
        ("--sample --aim 40 8 --speed -1", "at -1 m/s"),
        ("--sample --aim 40 8 --speed 0", "leads nowhere; give --speed"),
        ("--sample --aim 40 8 --hours 1e9", "to 720 hours"),
        ("--fleet .", "no folder below it has files of dives"),
        ("--fleet no", "no such folder"),
        ("--fleet . --aim 1 2", "are of one vehicle"),
        ("--sample --alert true", "is for --follow FOLDER or --fleet FOLDER"),
        ("--fleet . --alert no-such-command-here", "no such command"),
        ('--fleet . --alert "echo \'a"', "no such command"),
        ("--follow none", "no such folder"),
        ("--follow . --every inf", "--every inf s: must be above 0 s and at most 86400 s"),
        ("--follow . --every nan", "at most 86400 s"),
        ("--follow . --every 0", "above 0 s"),
        ("--follow . --patience nan", "--patience nan s: must be 0 s or more"),
        ("--follow . --out .", "would lie in the followed folder"),
        ("--follow . --out ''", "'--out': is empty"),
        ("--follow ''", "'--follow': is empty"),
    ],
)
def test_each_mistake_is_one_sentence(words, says, refused_for, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    refused_for([says], "replay", *shlex.split(words))


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
    out, why = tmp_path / "out", "outside the forecast's steps, or in a gap of them"
    words = ("--sample", "--flow-model", forecast)
    found = json.loads(command(*words, "--out", out, "--json").stdout)
    given = found["flow_model"]
    assert given["source"] == "forecast.nc"
    assert 0 < given["covered"] < 14
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
    assert found["clpe_rms"]["flow_model"] == given["clpe_rms"]["flow_model"] == pytest.approx(rms)
    assert given["clpe_rms"]["no_flow"] == pytest.approx(bare)
    assert found["next_dive"]["why_uncovered"] == why
    table = command(*words).stdout
    for said in (
        "covered, after the first dive",
        f"covers {given['covered']} of 14 dives",
        f"; the flow model does not cover it: {why}",
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


@pytest.mark.usefixtures("few_draws")
def test_aiming_by_the_command(command, sample, tmp_path):
    (tmp_path / "way.txt").write_text("-42.5 8.0\n-43 -7\n")
    words = ("--sample", "--route", tmp_path / "way.txt")
    found = json.loads(command(*words, "--json").stdout)
    assert [(leg["latitude"], leg["longitude"]) for leg in found["aim"]] == [(-42.5, 8), (-43, -7)]
    assert found["each_dive"] == sample.found["each_dive"]
    assert sample.found["aim"] == []
    first, words = found["aim"][0], ("--sample", "--aim", "-42.5", "8.0")
    said = command(*words).stdout
    assert f"heading {first['heading']:03.0f} (magnetic {first['heading_magnetic']:03.0f})" in said
    assert "aim at 42 30.00 S 8 00.00 E (42.5000 S 8.0000 E)" in said
    assert "m made good of" in said
    slow = command(*words, "--speed", "0.01", "--hours", "6", "--json")
    (leg,) = json.loads(slow.stdout)["aim"]
    assert (leg["state"], leg["duration"]) == ("cannot be made", 21600)
    assert "cannot be made against the current" in command(*words, "--speed", "0.01").stdout
    upstream = ("--sample", "--aim", "-42.93", "8.42", "--speed", "0.01")
    assert "m are lost, then " in command(*upstream).stdout


def test_the_headline_is_the_dive_that_is_aimed(command):
    found = json.loads(command("--sample", "--aim", "-43.4", "8.4", "--json").stdout)
    ahead, leg = found["next_dive"], found["aim"][0]
    assert ahead["basis"] == "given"
    end = leg["end"], leg["end_latitude"], leg["end_longitude"]
    assert (ahead["time"], ahead["latitude"], ahead["longitude"]) == end
    assert ahead["ellipse_90_long"] == leg["ellipse_90_long"]
    assert np.hypot(ahead["dr_east"], ahead["dr_north"]) == pytest.approx(leg["through_water"])
