"""Fixes one by one, saved and loaded between them: the numbers of all at once."""

import json
import pickle
import random
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from geodesics import displacement
from refusals import refuses
from subprocesses import GUARD, await_line, kill_while_it_writes, ran, started
from test_recorded_fixes import LAWS, SCENARIO, place, straight_mission

import clpt_control as clpt

EXAMPLE = Path(__file__).parents[3] / "examples" / "nmea_fixes.py"
SCENARIO_TEXT = """
origin = [36.7, -122.1]
[units]
length = "km"
time = "h"
[basis]
kernel = "gaussian"
centers = [[0, 0], [12, 0], [6, 10]]
widths = [8.0, 8.0, 8.0]
constituents = ["steady", "steady", "steady"]
[learning]
law = "fix-regression"
"""
BEGIN = 1777636800.0  # 2026-05-01 12:00 UTC
PLACE = 36.7, -122.1


def calls(fixes, seed=4):
    """Calls of a vehicle with two courses between fixes, at 1 m/s in a current of (0.2, -0.1)."""
    numbers = np.random.default_rng(seed)
    at, t = np.array([4000.0, 3000.0]), 1.7e9  # m from the origin
    made = [("fix", t, *place(at))]
    for _ in range(fixes):
        for _ in range(2):
            ahead = numbers.uniform(0, 12e3, 2) - at
            way = 900.0 * ahead / np.hypot(*ahead)
            at, t = at + way + (180.0, -90.0), t + 900.0
            made.append(("move", t, *way.tolist()))
        made.append(("fix", t, *place(at)))
    return made


def numbers_of(learner, learned):
    """All numbers of a learner and of its last fix, as text: NaN is NaN."""
    when = learner.time, *PLACE
    ahead = learner.forecast([(learner.time + 3600, 3000.0, -900.0)])
    arrays = learned.flow_parameters, learned.standard_error, learner.covariance
    return (
        *(array.tolist() for array in arrays),
        repr((learned.forecast, learned.error_east, learned.note, learned.turn)),
        repr((ahead, learner.flow(*when), learner.guaranteed(*when))),
        (learner.legs, learner.warnings, learner.guarantee),
    )


def fed(learner, made):
    """Call a learner; return what its last fix taught."""
    learned = None
    for name, *arguments in made:
        learned = getattr(learner, name)(*arguments) or learned
    return learned


def test_a_time_in_milliseconds_is_refused():
    learner = clpt.currents.FlowEstimator(clpt.Scenario(**SCENARIO))
    refuses("Divide milliseconds by 1000", learner.fix, 1000.0 * BEGIN, *PLACE)
    assert learner.fix(BEGIN, *PLACE).time == BEGIN


def test_legs_one_by_one_are_legs_at_once(tmp_path):
    """The table's numbers, to the last bit, from calls of the same legs."""
    rows = straight_mission(legs=10)
    learner = clpt.currents.FlowEstimator(clpt.Scenario(**SCENARIO))
    live = []
    for _, start, lat0, lon0, end, lat1, lon1, east, north in rows:
        learner.fix(start, lat0, lon0)
        learner.move(end, east, north)
        live.append(learner.fix(end, lat1, lon1).flow_parameters.tolist())
    head = "dive,t_gps2,lat_gps2,lon_gps2,t_gpse,lat_gpse,lon_gpse,dr_east_m,dr_north_m"
    table = tmp_path / "legs.csv"
    table.write_text("\n".join([head, *(",".join(map(repr, row)) for row in rows)]))
    legs, _ = clpt.gliders.read_dives(table)
    data = clpt.currents.flow_estimate(legs, clpt.Scenario(**SCENARIO))
    assert live == data.flow_parameters_estimate.values.tolist()


def scenario_of(law, count):
    """A scenario with so many functions, at odd places."""
    centers = np.random.default_rng(count).uniform(-15, 15, (count, 2)).tolist()
    basis = {
        "kernel": "gaussian",
        "centers": centers,
        "widths": [8.1] * count,
        "constituents": ["steady"] * count,
    }
    return clpt.Scenario(**{**SCENARIO, "basis": basis, "learning": {"law": law}})


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("count", [1, 13])
def test_a_loaded_learner_has_the_same_numbers(tmp_path, law, count):
    """Saved and loaded between any two calls, a wild fix among them: equal to the last bit."""
    made, path = calls(20), tmp_path / "learned.state"
    made[30] = (*made[30][:2], 36.9, -122.4)
    made[45:47] = []  # a displacement that is not known
    limits = {"shear": 2e-5, "unmodelled": 0.03}
    whole = clpt.currents.FlowEstimator(scenario_of(law, count), **limits)
    expected = fed(whole, made)
    learner = clpt.currents.FlowEstimator(scenario_of(law, count), **limits)
    learned = None
    for call in made:
        learned = fed(learner, [call]) or learned
        learner.save(path)
        learner = clpt.currents.FlowEstimator.load(path)
    assert numbers_of(learner, learned) == numbers_of(whole, expected)


def test_the_limits_of_the_guarantee_are_in_the_file(tmp_path):
    """Larger limits guarantee a larger error; a loaded learner has its own."""
    guaranteed = []
    for unmodelled in (0.02, 0.04):
        limits = {"shear": 5e-5, "unmodelled": unmodelled}
        learner = clpt.currents.FlowEstimator(clpt.Scenario(**SCENARIO), **limits)
        learner.save(tmp_path / "new")
        made = calls(12)
        first = fed(learner, made).guaranteed
        loaded = clpt.currents.FlowEstimator.load(tmp_path / "new")
        assert fed(loaded, made).guaranteed == first < np.inf
        guaranteed.append(first)
    assert guaranteed[0] < guaranteed[1]


def test_a_learner_without_a_fix_is_saved(tmp_path):
    learner = clpt.currents.FlowEstimator(clpt.Scenario(**SCENARIO))
    learner.save(tmp_path / "new")
    loaded = clpt.currents.FlowEstimator.load(str(tmp_path / "new"))
    made = calls(3)
    first, second = fed(learner, made), fed(loaded, made)
    assert numbers_of(learner, first) == numbers_of(loaded, second)


PROGRAM = """
import json, sys
from pathlib import Path
import clpt_control as clpt
made, path = json.loads(Path(sys.argv[1]).read_text()), Path(sys.argv[2])
if path.exists():
    learner = clpt.currents.FlowEstimator.load(path)
else:
    learner = clpt.currents.FlowEstimator(clpt.load_scenario(sys.argv[3]), shear=2e-5)
last = learner.time
for name, time, *way in made:
    if time < last + 1.0:
        continue
    learned = getattr(learner, name)(time, *way)
    if name == "fix":
        learner.save(path)
        print("saved", flush=True)
print(learner.flow_parameters.tolist(), learner.covariance.tolist(), learned.guaranteed)
"""


@pytest.mark.processes
def test_a_killed_learner_has_the_same_numbers(tmp_path):
    """1,000 fixes; killed within saves and between them, and begun again: the last bit."""
    (tmp_path / "mine.toml").write_text(SCENARIO_TEXT)
    (tmp_path / "calls").write_text(json.dumps(calls(1000)))
    words = [sys.executable, "-c", PROGRAM, tmp_path / "calls"]
    scenario = tmp_path / "mine.toml"
    expected = ran(*words, tmp_path / "whole", scenario).stdout.splitlines()[-1]
    folder, chance = tmp_path / "broken", random.Random(5)
    folder.mkdir()
    again = [*words, folder / "learned.state", scenario]
    for number in range(10):
        with started(again, stderr=subprocess.DEVNULL) as process:
            for _ in range(chance.randint(40, 90)):
                await_line(process, process.stdout, "saved")
            if number % 2:
                kill_while_it_writes(process, folder, ".learned.state.*.part")
            process.kill()
            process.wait(GUARD)
    done = ran(*again)
    assert done.stdout.splitlines()[-1] == expected
    assert [file.name for file in folder.iterdir()] == ["learned.state"]


@pytest.fixture
def saved(tmp_path):
    """A saved learner: its path and its bytes."""
    learner = clpt.currents.FlowEstimator(clpt.Scenario(**SCENARIO))
    fed(learner, calls(4))
    learner.save(tmp_path / "learned.state")
    return tmp_path / "learned.state", (tmp_path / "learned.state").read_bytes()


def is_refused(path, raw):
    """Refuse a file of these bytes by one sentence, and leave it as it is."""
    path.write_bytes(raw)
    said = refuses("learned.state: .+", clpt.currents.FlowEstimator.load, path)
    assert path.read_bytes() == raw
    return said


def test_a_file_that_is_no_saved_learner_is_refused(saved):
    """Cut short at any place, a changed byte anywhere, another kind of file."""
    path, whole = saved
    chance = random.Random(1)
    for end in [*range(40), *chance.sample(range(len(whole)), 60), len(whole) - 1]:
        is_refused(path, whole[:end])
    for byte in [*range(40), *chance.sample(range(len(whole)), 200)]:
        changed = bytearray(whole)
        changed[byte] ^= 1 << chance.randrange(8)
        is_refused(path, bytes(changed))
    others = b"{}", b"[" * 10**5, SCENARIO_TEXT.encode(), b"CDF\x01", b"\xff" * 100
    for raw in (*others, pickle.dumps(SCENARIO), whole + b" ", whole + whole):
        assert "no file of FlowEstimator.save" in is_refused(path, raw)


def test_a_file_of_a_newer_version_is_refused(saved):
    path, whole = saved
    kind, version, rest = whole.split(b" ", 2)
    newer = b" ".join([kind, str(int(version) + 1).encode(), rest])
    assert "by another version of clpt-control" in is_refused(path, newer)


def test_a_file_that_is_missing_or_a_folder_is_refused(tmp_path):
    load = clpt.currents.FlowEstimator.load
    refuses("none: no such file", load, tmp_path / "none")
    refuses("is a folder", load, tmp_path)
    learner = clpt.currents.FlowEstimator(clpt.Scenario(**SCENARIO))
    refuses("the folder .* does not exist", learner.save, tmp_path / "none" / "state")


def test_a_plan_is_forecast():
    """The next fix: the plan's displacement, drifted by the learned flow."""
    learner = clpt.currents.FlowEstimator(clpt.Scenario(**SCENARIO))
    last = fed(learner, calls(40))
    end = last.time + 3600
    ahead = learner.forecast([(end, 3600.0, 0.0)])
    assert ahead.time == pytest.approx(end, abs=1e-3)
    way = (ahead.longitude - last.longitude) * 89.3e3
    assert way == pytest.approx(3600 * 1.2, rel=0.03)  # 1 m/s and the current
    assert 0 < ahead.radius < 3000


def test_a_gap_begins_a_leg():
    """A time of unknown displacement teaches nothing, and is told."""
    learner = clpt.currents.FlowEstimator(clpt.Scenario(**SCENARIO))
    learner.fix(0.0, 36.7, -122.1)
    learned = learner.fix(7200.0, 36.75, -122.0)
    assert learner.legs == 0
    assert "7200 s before it is not known" in learned.note


def test_the_old_word_of_the_command_names_what_serves(clpt):
    done = clpt("estimate", "-")
    assert done.status == 2
    assert "call clpt.currents.FlowEstimator in Python" in done.err


# --- NMEA -----------------------------------------------------------------------------------------


def checked(body):
    """Return a sentence with its checksum."""
    total = 0
    for letter in body.encode():
        total ^= letter
    return f"${body}*{total:02x}"


def rmc(hour, minutes_east, status="A"):
    """A fix on 36 42 N, some minutes to the east of 122 06 W."""
    minutes = 6.0 - minutes_east
    place = f"3642.000,N,122{minutes:06.3f},W"
    return checked(f"GPRMC,{hour:02d}0000,{status},{place},0.0,0.0,010526,,")


def vhw(course, knots=2.0):
    return checked(f"IIVHW,{course:.1f},T,80.0,M,{knots},N,3.7,K")


@pytest.fixture
def nmea(tmp_path):
    """Learn from sentences by the example; return its answers and what it tells."""
    (tmp_path / "mine.toml").write_text(SCENARIO_TEXT)

    def run(sentences, state="learned.state"):
        words = EXAMPLE, tmp_path / "mine.toml", tmp_path / state
        done = ran(sys.executable, *words, input="\n".join(sentences))
        return [json.loads(line) for line in done.stdout.splitlines()], done.stderr

    return run


@pytest.mark.long
def test_nmea_sentences_are_learned(nmea):
    """RMC is a fix, VHW course and speed; a wrong checksum is left out."""
    wrong = "$IIVHW,45.0,T,80.0,M,2.0,N,3.7,K*00"
    # 2 knots to the east for 2 h are 7408 m; the fixes are 7.5 minutes apart
    answers, _ = nmea([rmc(12, 0), vhw(90), rmc(13, 0, "V"), wrong, rmc(14, 7.5)])
    first, second = answers
    assert (first["time"], second["time"]) == (BEGIN, BEGIN + 7200)
    assert first["latitude"] == pytest.approx(36.7)
    assert first["longitude"] == pytest.approx(-122.1)
    assert first["error_m"] is None
    # the forecast before any leg is dead reckoning
    east, _ = displacement(36.7, -122.1, 36.7, -122.1 + 7.5 / 60)
    assert second["error_m"] == pytest.approx(east - 7408, abs=5)
    assert second["note"] == ""


@pytest.mark.long
def test_a_log_in_which_nothing_was_read_says_so(nmea):
    """A time before each sentence, as some loggers write; and a receiver without a fix."""
    for log in ([f"12:00:00 {rmc(12, 0)}", vhw(90)], [rmc(12, 0, "V")]):
        answers, told = nmea(log)
        assert answers == []
        assert "no RMC with a fix was read" in told


@pytest.mark.parametrize("clock", [True, False])
@pytest.mark.long
def test_several_vhw_between_two_rmc_are_their_mean(nmea, clock):
    """Turns of 90 degrees between RMC: half an hour to the north, half an hour to the east.

    In still water 0.5 knots make 463 m in each half an hour; a clock may stand under water.
    """
    log = [rmc(12, 0), *[vhw(0, 0.5)] * 30, *[vhw(90, 0.5)] * 30]
    if clock:
        log += [rmc(13, 0, "V"), *[vhw(0, 0.5)] * 30, *[vhw(90, 0.5)] * 30]
    hours = 2 if clock else 1
    # 1.5 m to the east: a position that is repeated to its last digit is no fix
    answers, _ = nmea([*log, rmc(12 + hours, 0.001)])
    way = 463.0 * hours  # to the north, and to the east
    assert answers[1]["error_m"] == pytest.approx(np.hypot(way, way - 1.5), rel=1e-3)


def test_a_vehicle_that_shuttles_between_two_piers_is_learned():
    """A position of the fix before the last one is a new fix: 0.2 m/s to the east, exactly."""
    basis = {
        "kernel": "gaussian",
        "centers": [[0, 0]],
        "widths": [1e8],
        "constituents": ["steady"],
    }
    scenario = clpt.Scenario(basis=basis, learning={"law": "fix-regression"})
    estimator = clpt.currents.FlowEstimator(scenario)
    piers = (60.5, 5.25), (60.5, 5.315)
    east, _ = displacement(*piers[0], *piers[1])
    estimator.fix(0.0, *piers[0])
    for k in range(1, 6):
        estimator.move(3600.0 * k, (east if k % 2 else -east) - 720.0, 0.0)
        learned = estimator.fix(3600.0 * k, *piers[k % 2])
        assert learned.note == ""
    assert estimator.legs == 5
    assert learned.flow == pytest.approx((0.2, 0.0), abs=2e-3)


@pytest.mark.long
def test_the_example_goes_on_after_a_restart(nmea):
    """With all sentences again: the same numbers. With lost sentences: a leg begins."""
    log = []
    for k in range(6):
        log += [rmc(2 * k, 1.5 * (k % 2)), vhw(90 if k % 2 == 0 else 270, 0.4)]
    whole, _ = nmea(log, "whole")
    nmea(log[:7])
    answers, _ = nmea(log)
    assert answers == whole[-2:]
    nmea(log[:6], "lost")
    answers, _ = nmea(log[7:], "lost")  # the sentences between them never arrived
    assert "begins a leg" in answers[0]["note"]
    assert "begins a leg" not in answers[1]["note"]


@pytest.mark.long
def test_a_speed_that_cannot_be_makes_the_motion_unknown(nmea):
    log = [rmc(1, 0), vhw(90), rmc(2, 1, "V"), vhw(90, 120), rmc(3, 2, "V"), vhw(90)]
    answers, _ = nmea([*log, rmc(4, 3), rmc(5, 5)])
    assert "begins a leg" in answers[1]["note"]
    assert "begins a leg" not in answers[2]["note"]


@pytest.mark.long
@pytest.mark.parametrize(
    ("body", "count"),
    [
        ("GPRMC,120000.00,A,3642.0000,N,12206.0000,W,0.1,0.0,010526,,,A", 1),
        ("GPRMC,120000.00,A,3642.0000,N,12206.0000,W,0.1,0.0,010526,,,E", 0),
        ("GPRMC,120000.00,A,3642.0000,N,12206.0000,W,0.1,0.0,010526,,,N", 0),
        ("GPRMC,120000.00,A,3642.0000,N,12206.0000,W,0.1,0.0,010526,,,S", 0),
        ("GPRMC,120000.00,A,,,,,0.1,0.0,010526,,,A", 0),
        ("GPRMC,120000,A,3642,N,12206,W,0,0,010526,,", 1),
        ("GPRMC,120000,A", 0),
        ("IIVHW,,T,80.0,M,2.0,N,3.7,K", 0),
    ],
)
def test_sentences_that_are_no_fix_end_nothing(nmea, body, count):
    answers, _ = nmea([checked(body), rmc(13, 0)])
    assert len(answers) == count + 1


@pytest.mark.long
def test_a_magnetic_heading_alone_is_told(nmea):
    _, told = nmea([rmc(13, 0), checked("IIVHW,,T,80.0,M,2.0,N,3.7,K")])
    assert "magnetic heading alone" in told
