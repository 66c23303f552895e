"""A fleet: one row each, what asks for a pilot first, a command for it, on a folder tree."""

import json
import os
import shlex
import shutil
import signal
import subprocess
import sys
import time
from dataclasses import replace
from datetime import datetime
from functools import partial
from urllib.parse import unquote

import pytest
from geodesics import place_from
from html_parser import Reader
from subprocesses import CLPT, kill_while_it_writes, ran, started
from synthetic_vehicle import fixes_of, one_file_each

from clpt_control.gliders import make_dive, read_dives, write_dive_table

HOUR = 3600.0
TELL = "import sys; open(sys.argv[1], 'a').write(sys.stdin.read())"


def recent(count, hours, name=None, seed=1):
    """Dives of which the last one ended some hours ago."""
    dives = fixes_of(count, seed=seed)
    late = time.time() - hours * HOUR - dives[-1].t_gpse
    return [
        replace(
            dive, t_gps2=dive.t_gps2 + late, t_gpse=dive.t_gpse + late, vehicle=name
        )
        for dive in dives
    ]


def strayed(dives, last=2):
    """Dives of which the last ones came up 20 km to the north of where they did, as the sea may."""
    found = list(dives[:-last])
    for dive in dives[-last:]:
        start = found[-1].lat_gpse, found[-1].lon_gpse
        way = place_from(
            *start, dive.gps_east, dive.gps_north + (-1) ** len(found) * 20000
        )
        fixes = (dive.t_gps2, *start), (dive.t_gpse, *way)
        found.append(make_dive(dive.number, *fixes, (dive.dr_east, dive.dr_north)))
    return found


@pytest.fixture
def look(command, tmp_path, monkeypatch, undrawn):
    """Look once at the folder `glider` with these files of dives; return its row, and errors."""
    top, clock = tmp_path / "top", time.time

    def run(dives=(), *words, now=None, name="glider"):
        (top / name).mkdir(parents=True, exist_ok=True)
        one_file_each(top / name, dives)
        monkeypatch.setattr(time, "time", clock if now is None else lambda: now)
        done = command("watch", top, "--fleet", "--json", *words)
        assert done.exit_code == 0, done.output
        rows = {row["vehicle"]: row for row in json.loads(done.stdout)["vehicles"]}
        return rows[name], done.stderr

    return run


@pytest.mark.long
def test_what_asks_for_a_pilot(look):
    dives = recent(12, 1.0)
    end = dives[-1].t_gpse
    calm, _ = look(dives, now=end)
    assert calm["asks"] == []
    ahead = calm["next_dive"]
    due = datetime.fromisoformat(ahead["time"]).timestamp() + ahead["time_half_width"]
    assert look(now=due - 60)[0]["asks"] == []
    late, _ = look(now=due + 60)
    assert late["asks"] == ["overdue"]
    assert late["said"][0].startswith("overdue after dive 12: ")
    assert look(now=end + 40 * 24 * HOUR)[0]["asks"] == []  # an old record
    for last, asks in ((1, []), (2, ["OUT"])):
        name = f"strayed {last}"
        wild, _ = look(strayed(dives, last), now=end, name=name)
        assert (wild["asks"], wild["out_running"]) == (asks, last)
    # the first of those that run: one event
    (said,) = wild["said"]
    assert said.startswith("OUT: 2 dives running, since dive 11, ")


@pytest.fixture
def tree(tmp_path, facts, sample):
    """A vehicle that is well, with a replay's results, one overdue, one OUT, two in one folder."""
    top = tmp_path / "top"
    for name, dives in (
        ("well", recent(6, 1.0)),
        ("late", recent(6, 30.0, seed=2)),
        ("a <b> & '#1%3f'", strayed(recent(6, 0.5))),
        ("station/from-glider", recent(4, 1.0)),
        ("two", []),
        ("hurt", []),
        ("none", []),
    ):
        (top / name).mkdir(parents=True)
        one_file_each(top / name, dives)
    shutil.copytree(sample.folder, top / "well" / "results")
    for file in ("sg171/p1710100.nc", "basestation/p5420304.nc"):
        shutil.copy(facts / "glider" / file, top / "two")
    (top / "hurt" / "p1.nc").write_bytes(b"CDF\x01 and no more")
    return top


@pytest.mark.long
@pytest.mark.usefixtures("undrawn")
def test_a_row_each_what_asks_for_a_pilot_first_and_is_told_once(
    tree, command, monkeypatch
):
    monkeypatch.setenv("COLUMNS", "80")
    heard = tree.parent / "told"
    done = command("watch", tree, "--fleet", "--alert", teller(heard))
    assert done.exit_code == 0, done.output
    table = [line for line in done.stdout.splitlines() if line.startswith("│")]
    names = [line.split("│")[1].strip() for line in table]
    asking = ["late", "a <b> & '#1%3f'", "hurt"]
    assert [*names[:3], *sorted(names[3:5])] == [*asking, "station", "well"]
    assert names[5:] == ["SG542", "SG171"]  # old records
    assert max(map(len, table)) <= 80
    assert "OUT x2" in table[1]
    for said in ("7 vehicles, 3 need a pilot", "hurt: cannot be read: "):
        assert said in done.stdout
    again = command("watch", tree, "--fleet", "--alert", teller(heard), "--json")
    assert sorted(told_in(heard)) == [
        ("a <b> & '#1%3f'", "OUT", 5),
        ("late", "overdue", 6),
    ]
    rows = {row["vehicle"]: row for row in json.loads(again.stdout)["vehicles"]}
    assert ([*rows][:3], rows["late"]["asks"]) == (asking, ["overdue"])
    assert rows["late"]["age_hours"] == pytest.approx(30.0, abs=0.5)
    assert "p1.nc" in rows["hurt"]["said"][0]
    page = Reader((tree / "replay" / "fleet.html").read_text("utf-8"))
    assert next(filter(str.strip, page.texts)).startswith("Fleet, ")  # its title
    links = [names["href"] for tag, names in page.tags if tag == "a"]
    assert len(links) == 6
    assert all((tree / "replay" / unquote(link)).is_file() for link in links)
    assert "a <b> & '#1%3f'" in page.texts  # as a text, no markup
    assert rows["late"]["time"][:16].replace("T", " ") in page.texts  # with its year


def teller(path):
    return shlex.join([sys.executable, "-c", TELL, str(path)])


def told_in(path):
    """What the command was told: sentences, each with its object."""
    lines = path.read_text("utf-8").splitlines() if path.exists() else []
    told = [
        (one, json.loads(two)) for one, two in zip(lines[::2], lines[1::2], strict=True)
    ]
    assert all(said == data["sentence"] for said, data in told)
    names = ("vehicle", "event", "fix")
    assert all(
        data["id"] == "{} {} {}".format(*map(data.get, names)) for _, data in told
    )
    return [(data["vehicle"], data["event"], data["dive"]) for _, data in told]


TWICE_OUT = strayed(recent(6, 1.0))  # the last two of six


LEFT = """import subprocess as s, sys
one = s.Popen([sys.executable, '-c', 'import time; time.sleep(600)'])
open(sys.argv[1], 'w').write(str(one.pid))
open(sys.argv[2], 'w').write(sys.argv[3])
"""


def python(code, *words):
    """Return the option that runs a program of Python."""
    return "--alert", shlex.join([sys.executable, "-c", code, *map(str, words)])


@pytest.mark.long
def test_a_command_has_the_sentence_and_what_it_leaves_behind_is_not_waited_for(
    tmp_path, look
):
    number, said = tmp_path / "number", tmp_path / "said"
    alert = python(LEFT, number, said, "{}")
    look(TWICE_OUT, *alert)
    os.kill(int(number.read_text()), signal.SIGKILL)  # it still waits
    assert said.read_text().startswith("glider: OUT: 2 dives running, since dive 5")
    said.unlink()
    look((), *alert)
    assert not said.exists()  # it was told


FAILING = [
    ("raise SystemExit(3)", 60.0, "ended with status 3; is run again"),
    ("import time; time.sleep(60)", 0.3, "takes longer than "),
]


@pytest.mark.long
@pytest.mark.parametrize(("code", "longest", "says"), FAILING)
def test_a_command_that_fails_is_one_sentence_and_is_run_again(
    code, longest, says, tmp_path, monkeypatch, look
):
    ran_for_long = subprocess.run
    with monkeypatch.context() as patch:  # the time that it waits for a process
        hurried = partial(ran_for_long, timeout=longest)
        patch.setattr(subprocess, "run", lambda *a, timeout, **k: hurried(*a, **k))
        _, said = look(strayed(recent(6, 30.0)), *python(code))
    assert (said.count(says), said.count("\n")) == (1, 1)  # of both events
    heard = tmp_path / "told"
    look((), "--alert", teller(heard))
    assert told_in(heard) == [("glider", "overdue", 6), ("glider", "OUT", 5)]


@pytest.mark.processes
def test_a_fleet_killed_twice_is_as_an_unbroken_one(tmp_path):
    top = tmp_path / "top"
    for k in range(3):
        (top / f"v{k}").mkdir(parents=True)
        one_file_each(top / f"v{k}", strayed(fixes_of(8, seed=k)) if k else fixes_of(8))
    told = {name: tmp_path / f"told {name}" for name in ("broken", "whole")}
    words = ("watch", top, "--fleet", "--json")
    commands = {
        name: [*CLPT, *words, "--out", name, "--alert", teller(path)]
        for name, path in told.items()
    }
    # a file that is being written may be there too short a time to be seen: then it is whole
    for part in ("*replay.html*", "v1/*track.kml*"):
        with started(
            commands["broken"], stdout=subprocess.DEVNULL, cwd=tmp_path
        ) as process:
            kill_while_it_writes(process, tmp_path / "broken", part)
    found = {}
    for name, own in commands.items():
        found[name] = json.loads(ran(*own, cwd=tmp_path).stdout)
        for row in found[name]["vehicles"]:
            row.pop("age_hours")
        found[name].pop("now")
    assert found["broken"] == found["whole"]
    for path in (tmp_path / "whole").rglob("*"):
        same = tmp_path / "broken" / path.relative_to(tmp_path / "whole")
        assert same.exists()
        if path.name in ("replay.html", "next.geojson", "track.kml"):
            assert same.read_bytes() == path.read_bytes()
    assert set(told_in(told["broken"])) == set(told_in(told["whole"]))
    assert {event for _, event, _ in told_in(told["whole"])} == {"OUT"}
    assert not list((tmp_path / "broken").rglob("*.part"))


@pytest.mark.long
@pytest.mark.usefixtures("undrawn")
def test_linked_folders_are_followed_once_and_never_in_a_circle(tmp_path, command):
    top, elsewhere = tmp_path / "top", tmp_path / "elsewhere"
    for folder in (top / "here", elsewhere / "there"):
        folder.mkdir(parents=True)
        one_file_each(folder, recent(4, 1.0))
    (top / "linked").symlink_to(elsewhere)
    (top / "again").symlink_to(elsewhere / "there")
    (top / "a").symlink_to(top / "here")
    (top / "here" / "up").symlink_to(tmp_path)
    (elsewhere / "there" / "circle").symlink_to(elsewhere)
    found = json.loads(command("watch", top, "--fleet", "--json").stdout)
    assert sorted(row["vehicle"] for row in found["vehicles"]) == ["here", "there"]
    places = sorted(path.name for path in (top / "replay").iterdir())
    assert places == ["again", "fleet.html", "here"]


@pytest.mark.usefixtures("undrawn")
def test_a_vehicle_that_cannot_be_read_hides_no_other_of_its_folder(tmp_path, command):
    for file in ("an empty file.csv", "replay.nc"):
        (tmp_path / file).write_text("")
    for name, lost in (("a", {"lat_gpse": 92.0}), ("z", {})):
        dive = replace(recent(1, 1.0)[0], vehicle=name, **lost)
        write_dive_table([dive], tmp_path / f"{name}.csv")
    lost, well = json.loads(command("watch", tmp_path, "--fleet", "--json").stdout)[
        "vehicles"
    ]
    assert (lost["vehicle"], well["vehicle"], well["asks"]) == ("a", "z", [])
    assert lost["said"][0].startswith(
        "cannot be read: no usable dive: dive 1: the fix after"
    )


@pytest.mark.long
def test_the_same_dive_number_of_another_mission_is_another_event(tmp_path, look):
    heard = tmp_path / "told"
    second = recent(6, 24.0)
    for mission in (recent(6, 20 * 24.0), second, second):
        look(mission, "--alert", teller(heard))
    assert told_in(heard) == [("glider", "overdue", 6)] * 2


@pytest.mark.long
def test_a_vehicles_name_is_no_option_of_the_command(tmp_path, look):
    heard = tmp_path / "heard"
    save = "import sys; print(*sys.argv[2:], file=open(sys.argv[1], 'a'))"
    names = ["-oProxyCommand=touch x", "--help", "@file", ">x"]
    for name in names:
        named = replace(fixes_of(1)[0], vehicle=name)
        write_dive_table([named], tmp_path / "dives.csv")
        (read,), _ = read_dives(tmp_path / "dives.csv")
        assert read.vehicle is None
        (tmp_path / "top" / name).mkdir(parents=True)
        one_file_each(tmp_path / "top" / name, TWICE_OUT)
    look((), *python(save, heard, "{}"), name=names[0])
    said = [line.partition(": OUT")[0] for line in heard.read_text().splitlines()]
    assert sorted(said) == sorted(f"vehicle {name}" for name in names)


@pytest.mark.long
def test_two_spells_of_dives_with_one_number_are_two_events(tmp_path, look):
    heard, since = tmp_path / "told", TWICE_OUT[-1].t_gpse - TWICE_OUT[0].t_gps2
    again = [
        replace(one, t_gps2=one.t_gps2 - since - 600, t_gpse=one.t_gpse - since - 600)
        for one in TWICE_OUT
    ]
    for spells in (again, [*again, *TWICE_OUT]):
        files = tmp_path / "top" / "glider"
        files.mkdir(parents=True, exist_ok=True)
        for k, one in enumerate(spells):
            write_dive_table([replace(one, number=42)], files / f"{k}.csv")
        look((), "--alert", teller(heard), now=spells[-1].t_gpse)
    assert told_in(heard) == [("glider", "OUT", 42)] * 2


@pytest.mark.long
def test_what_was_told_and_cannot_be_read_is_told_again(tmp_path, look):
    heard, results = tmp_path / "told", tmp_path / "top" / "replay"
    for dives in (TWICE_OUT, ()):
        look(dives, "--alert", teller(heard))
    assert len(told_in(heard)) == 1
    (place,) = results.rglob("*told*")
    for damage in ("5", '{"a": 1}', "[", os.mkfifo):
        before = len(told_in(heard))
        place.unlink()
        damage(place) if callable(damage) else place.write_text(damage)
        look((), "--alert", teller(heard))
        assert told_in(heard)[before:] == [("glider", "OUT", 5)]
