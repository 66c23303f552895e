"""What `clpt replay` prints: tables at any width, what was learned, when, where to aim."""

import json
import math
import re
from dataclasses import replace

import numpy as np
import pytest
from synthetic_vehicle import one_file_each, vehicle

from clpt_control.estimation.fix_model import FixModel
from clpt_control.gliders.dive_files import sample_dives
from clpt_control.replay.outcome import learned_words, odds, speed_words, summary
from clpt_control.replay.replay import replay_dives


@pytest.fixture(scope="module")
def sg542():
    return summary(replay_dives(sample_dives()))


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


@pytest.mark.parametrize("width", [20, 60, 80, 100, 140, 200])
def test_the_table_keeps_what_matters(width, sg542, capsys, monkeypatch):
    from clpt_control.cli.printing import finish
    from clpt_control.cli.replay_report import results

    monkeypatch.setenv("COLUMNS", str(width))
    found = json.loads(json.dumps(sg542))
    found["each_dive"][4]["anomaly"] = {"certain": False}
    found |= {"next_dive": None, "aim": []}
    tables = [one._replace(sentences=[]) for one in results(found)]
    finish(tables, found, False)
    said = capsys.readouterr().out
    assert "…" not in said
    titles, rows = rows_of(said)
    assert {"dive", "previous", "adaptive", "90 %", "mark"} <= set(titles)
    assert all(titles)
    assert len(rows) == 14
    marks = [row[titles.index("mark")] for row in rows]
    assert marks == ["SPEED?" if k == 4 else "" for k in range(14)]
    for row, dive in zip(rows, found["each_dive"], strict=True):
        assert row[titles.index("dive")] == str(dive["dive"])
        assert row[titles.index("adaptive")] == f"{dive['clpe']['adaptive']:.0f}"
        assert row[titles.index("90 %")] in ("in", "OUT")
    if width >= 60:
        assert max(map(len, said.splitlines())) <= width
    assert (len(titles) > 12) == (width == 200)


def test_the_next_dive_has_a_row(command):
    titles, rows = rows_of(command("--sample").stdout)
    ahead = json.loads(command("--sample", "--json").stdout)["next_dive"]
    assert rows[-1][:2] == ["next", ahead["time"][5:16].replace("T", " ")]
    assert len(rows) == 15
    assert " x " in rows[-1][titles.index("90 % ellipse (m, deg)")]
    assert rows[-1][titles.index("adaptive")] == ""


@pytest.mark.usefixtures("undrawn")
def test_following_goes_on_where_it_cannot_aim(command, follow, tmp_path):
    still = [replace(dive, dr_east=0.0, dr_north=0.0) for dive in sample_dives()[:2]]
    one_file_each(tmp_path, still)
    aim = ("--aim", "-42.5", "8.0", "--json")
    done = follow(tmp_path, *aim)
    assert "so far, --aim: 0 m/s, given or of the last dives, leads nowhere" in done.stderr
    assert json.loads(done.stdout)["aim"] == []
    assert "give --speed" in str(command(*tmp_path.glob("*.csv"), *aim).exception)


def test_what_is_learned_is_said_as_it_is():
    steady = replay_dives(vehicle(1, 2))
    said = learned_words(steady)
    assert "M2 0.0" in said
    assert "(odds 1:" in said or "(odds below 1:99)" in said
    tidal = replay_dives(vehicle(3, 40, flow="M2", fix=5.0))
    # the made tide turns by 0.15 m/s one way and 0.075 the other
    size = re.search(r"M2 (\S+) m/s \(odds above 99:1\)", learned_words(tidal))[1]
    assert float(size) == pytest.approx(0.15, abs=0.02)
    assert learned_words(replay_dives([])) == "nothing"
    bare = learned_words(replay_dives(vehicle(1, 3), "gradient", FixModel(("steady",), False)))
    assert bare.endswith("over the last dive")
    places = replay_dives(vehicle(1, 3), model=FixModel(("steady", "gaussians")))
    assert "gaussians (odds " in learned_words(places)


def test_odds_are_of_whole_numbers():
    for p in np.linspace(0.02, 0.98, 49):
        a, b = map(int, odds(p).split(":"))
        assert min(a, b) == 1
        assert math.log(a / b) == pytest.approx(math.log(p / (1 - p)), abs=0.41)


def test_a_speed_far_from_one_is_a_sentence():
    fast = replay_dives(vehicle(4, 30, factor=1.5)).steps[-1]
    assert speed_words(fast).endswith(": your flight model is too slow")
    slow = replay_dives(vehicle(4, 30, factor=0.6)).steps[-1]
    assert speed_words(slow).endswith(": your flight model is too fast")
    edge = replace(slow, speed=1 - 2.99 * slow.speed_error)
    assert "flight model" not in speed_words(edge)


def test_aiming_by_the_command(command, sg542, tmp_path):
    (tmp_path / "way.txt").write_text("-42.5 8.0\n-43 -7\n")
    words = ("--sample", "--route", tmp_path / "way.txt")
    found = json.loads(command(*words, "--json").stdout)
    assert [(leg["latitude"], leg["longitude"]) for leg in found["aim"]] == [(-42.5, 8), (-43, -7)]
    first = found["aim"][0]
    said = command(*words).stdout
    assert f"heading {first['heading']:03.0f} (magnetic {first['heading_magnetic']:03.0f})" in said
    assert "aim at 42 30.00 S 8 00.00 E (42.5000 S 8.0000 E)" in said
    assert "m made good of" in said
    slow = json.loads(command(*words, "--speed", "0.01", "--hours", "6", "--json").stdout)["aim"]
    assert [leg["state"] for leg in slow] == ["cannot be made"]
    assert slow[0]["duration"] == 21600
    assert "cannot be made against the current" in command(*words, "--speed", "0.01").stdout
    upstream = ("--sample", "--aim", "-42.93", "8.42", "--speed", "0.01")
    assert "m are lost, then " in command(*upstream).stdout
    one = command("--sample", "--aim", "-42.5", "8.0", "--json")
    assert json.loads(one.stdout)["aim"][0]["heading"] == first["heading"]
    assert json.loads(command("--sample", "--json").stdout)["aim"] == []
    assert found["each_dive"] == sg542["each_dive"]


def test_mistakes_in_aiming(command):
    for words, says in (
        (("--aim", "4304.27", "8.0"), "decimal degrees"),
        (("--aim", "nan", "8"), "must be a latitude"),
        (("--speed", "0.2"), "give a waypoint"),
        (("--aim", "40", "8", "--speed", "-1"), "at -1 m/s"),
        (("--aim", "40", "8", "--hours", "1e9"), "to 720 hours"),
    ):
        done = command("--sample", *words)
        assert done.exit_code != 0
        assert says in " ".join(f"{done.output} {done.exception}".replace("│", " ").split())


@pytest.mark.usefixtures("undrawn")
def test_the_line_of_following(follow, tmp_path):
    dives = sample_dives()[:3]
    one_file_each(tmp_path, dives)
    near = dives[2].lat_gpse + 0.001, dives[2].lon_gpse  # come close to: the next one is aimed at
    way = tmp_path / "way.txt"
    way.write_text(f"{near[0]} {near[1]}\n-42.5 8.0\n")
    done = follow(tmp_path, "--route", way, "--json")
    line = next(line for line in done.stderr.splitlines() if "dives used" in line)
    said = r"3 new files, 3 dives used; dive 306: miss \d+ m; next surfacing 2016-02-01"
    assert re.search(said, line)
    assert "h from the end of the last dive, near 43 " in line
    assert "; aim at 42 30.00 S 8 00.00 E" in line
    assert len(json.loads(done.stdout)["aim"]) == 1
