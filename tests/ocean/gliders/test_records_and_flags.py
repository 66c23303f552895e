"""Several records or vehicles in one input, and fixes and samples that their file flags as bad.

A vehicle swims 0.3 m/s for 9000 s, each dive on another heading, in a current of 0.10 m/s to the
east and 0.08 m/s to the north, and drifts for 600 s between dives.
"""

import glider_files as made
import numpy as np
import pytest
from geodesics import place_from
from glider_files import basestation3, og1, og1_rows
from refusals import refuses

import clpt_control as clpt
from clpt_control.gliders import make_dive, read_dives, write_dive_table

CURRENT, DURATION, STAY = np.array([0.10, 0.08]), 9000.0, 600.0
HOUR, DAY, KM = 3600.0, 86400.0, 1000.0
ROWS = ("N_MEASUREMENTS",)


def flown(count=10, place=(30.0, -70.0), since=1.7e9, current=CURRENT):
    dives = []
    for k in range(count):
        heading = np.radians(90 + 70 * np.sin(1.3 * k))
        swum = 0.3 * DURATION * np.array([np.sin(heading), np.cos(heading)])
        end = place_from(*place, *(swum + current * DURATION))
        fixes = (since, *place), (since + DURATION, *end)
        dives.append(make_dive(k + 1, *fixes, tuple(swum)))
        place, since = place_from(*end, *(current * STAY)), since + DURATION + STAY
    return dives


def after(dives, wait, north, **more):
    """Fly as long after the last dive (s), so far north of its end (m)."""
    last = dives[-1]
    place = place_from(last.lat_gpse, last.lon_gpse, 0.0, north)
    return flown(place=place, since=last.t_gpse + wait, **more)


def learned(dives):
    """Return the current that a replay knows after its last dive, m/s."""
    row = clpt.replay.replay_dives(dives).summary()["each_dive"][-1]
    return row["current_east"], row["current_north"]


BREAKS = [(3 * DAY, 0.0), (5 * DAY, 330 * KM), (HOUR, 20 * KM), (25 * HOUR, 1 * KM)]


@pytest.mark.parametrize(("wait", "north"), BREAKS)
def test_a_break_begins_a_new_record(tmp_path, wait, north):
    first = flown(current=-2 * CURRENT)
    second = after(first, wait, north)
    write_dive_table([*first, *second], tmp_path / "dives.csv")
    dives, skipped = read_dives(tmp_path / "dives.csv")
    assert [dive.t_gps2 for dive in dives] == [dive.t_gps2 for dive in second]
    begins = f"{north / KM:.1f} km and {wait / HOUR:.1f} h from the end of dive 10"
    assert dives[0].notes == (f"begins a new record, {begins}",)
    why = f"of an earlier record: dive 1 begins a new one, {begins}; replay each on its own"
    assert [(one.dive, one.why) for one in skipped] == [(k, why) for k in range(1, 11)]
    assert learned(dives) == learned(second)
    assert learned(dives) == pytest.approx(CURRENT, abs=0.02)


@pytest.mark.parametrize(
    ("wait", "north"), [(20 * HOUR, 0.0), (HOUR, 8 * KM), (0.0, 0.0)]
)
def test_what_a_current_can_do_continues_the_record(tmp_path, wait, north):
    first = flown()
    dives = [*first, *after(first, wait, north)]
    write_dive_table(dives, tmp_path / "dives.csv")
    used, skipped = read_dives(tmp_path / "dives.csv")
    assert (len(used), skipped) == (20, [])


def test_a_vehicle_far_away_begins_its_record_with_its_second_dive(tmp_path):
    """Its first one could be a wrong place; two in a row are another vehicle."""
    first = flown()
    second = after(first, HOUR, 330 * KM)
    write_dive_table([*first, *second], tmp_path / "dives.csv")
    dives, skipped = read_dives(tmp_path / "dives.csv")
    assert [dive.number for dive in dives] == list(range(2, 11))
    assert "another vehicle? replay each on its own" in skipped[0].why
    assert len(skipped) == 11
    assert learned(dives) == pytest.approx(CURRENT, abs=0.02)


@pytest.mark.parametrize("fix", ["gps2", "gpse"])
def test_a_wild_fix_begins_no_record(tmp_path, fix):
    """By dead reckoning past the wrong fix, 18 km off, the vehicle is near."""
    dives = flown()
    start, end = (
        (dives[5].t_gps2, dives[5].lat_gps2, dives[5].lon_gps2),
        (dives[5].t_gpse, dives[5].lat_gpse, dives[5].lon_gpse),
    )
    if fix == "gps2":
        start = start[0], *place_from(*start[1:], 0.0, 18 * KM)
    else:
        end = end[0], *place_from(*end[1:], 0.0, 18 * KM)
    dives[5] = make_dive(6, start, end, (dives[5].dr_east, dives[5].dr_north))
    write_dive_table(dives, tmp_path / "dives.csv")
    used, skipped = read_dives(tmp_path / "dives.csv")
    assert (len(used), skipped) == (10, [])


@pytest.mark.long
@pytest.mark.parametrize("latitudes", [(30.0, 30.0, 30.0), (30.0, 31.0, 32.0)])
def test_tables_of_several_vehicles_are_named_by_their_files(tmp_path, latitudes, clpt):
    for k, (name, latitude) in enumerate(
        zip(("alpha", "beta", "gamma"), latitudes, strict=True)
    ):
        dives = flown(5, (latitude, -70.0), current=CURRENT * (k + 1))
        write_dive_table(dives, tmp_path / f"{name}.csv")
    said = "alpha, beta, gamma: are 3 vehicles in one replay"
    refuses(said, read_dives, tmp_path)
    fleet = clpt("watch", tmp_path, "--fleet", "--out", tmp_path / "out")
    assert fleet.status == 0
    for name in ("alpha", "beta", "gamma"):
        assert (tmp_path / "out" / name / "replay.html").exists()
    assert "3 vehicles" in fleet.out


def test_tables_of_parts_and_copies_are_of_one_vehicle(tmp_path):
    dives = flown()
    for dive in dives:
        write_dive_table([dive], tmp_path / f"dive_{dive.number}.csv")
    assert read_dives(tmp_path)[0] == dives
    write_dive_table(dives, tmp_path / "copy.csv")
    used, skipped = read_dives(tmp_path)
    assert [dive.number for dive in used] == list(range(1, 11))
    assert {one.why[:9] for one in skipped} == {"duplicate"}


@pytest.mark.long
def test_a_damaged_file_is_named_with_its_reason_as_it_arrives(tmp_path, clpt):
    write_dive_table(flown(), tmp_path / "good.csv")
    (tmp_path / "bad.csv").write_text("dive,depth\n1,2\n")
    (line,) = clpt("watch", tmp_path, "--patience", "0").err.splitlines()
    assert line.startswith("2 new files, 10 dives used; ")
    assert f"; skipped {tmp_path / 'bad.csv'}: no column t_gps2" in line


def flagged_fix(columns, good, bad, attributes):
    """Move the fix after the second of three dives, and flag it."""
    fixes = np.flatnonzero(np.isfinite(columns["LATITUDE_GPS"]))
    end = fixes[5]
    columns["LATITUDE_GPS"][end] += 0.02  # 2.2 km
    flags = np.full(columns["TIME"].size, good)
    flags[end] = bad
    return {
        f"{name}_GPS_QC": (ROWS, flags, attributes)
        for name in ("LATITUDE", "LONGITUDE")
    }


WORDS = "good suspect interpolated"
FLAGS = [(1, 4, {}), (0, 3, {}), (1, 8, {}), (b"1", b"9", {})] + [
    (0, value, {"flag_values": np.arange(3), "flag_meanings": WORDS})
    for value in (1, 2)
]


@pytest.mark.parametrize(("good", "bad", "attributes"), FLAGS)
def test_a_flagged_fix_of_og1_is_not_used(tmp_path, good, bad, attributes):
    """The first fix before the next dive takes its place: dives are as long as without it."""
    columns = og1_rows()
    flags = flagged_fix(columns, good, bad, attributes)
    dives, _ = read_dives(og1(tmp_path / "a.nc", columns=columns, **flags))
    assert all(abs(dive.gps_north) < 1.0 for dive in dives)
    assert [dive.number for dive in dives] == [1, 2, 3]
    for name in ("LATITUDE", "LONGITUDE"):
        note = f"1 of {columns['TIME'].size} values of {name}_GPS are flagged bad: left out"
        assert note in dives[0].notes
    (tmp_path / "b.nc").unlink(missing_ok=True)
    used = read_dives(og1(tmp_path / "b.nc", columns=columns))[0]
    assert used[1].gps_north == pytest.approx(2200.0, rel=0.02)  # without flags


WORDS = {"flag_values": [0, 5, 6], "flag_meanings": "good bad unknown"}


@pytest.mark.parametrize(
    ("name", "flags"),
    [
        ("log_gps_qc", (made.INFO, [1.0, 1.0, 4.0], {})),
        ("log_gps_qc", (made.INFO, [0.0, 0.0, 5.0], WORDS)),
        ("GPSE_qc", ((), "3", {})),
        ("GPSE_qc", ((), 5, WORDS)),
    ],
)
def test_a_flagged_fix_of_a_seaglider_is_not_used(tmp_path, name, flags):
    basestation3(tmp_path / "p1230006.nc", number=6)
    basestation3(tmp_path / "p1230007.nc", number=7, **{name: flags})
    dives, (skipped,) = read_dives(tmp_path)
    assert [dive.number for dive in dives] == [6]
    assert "bad: left out" in skipped.why


def test_a_code_that_its_words_call_good_is_used(tmp_path):
    words = {"flag_values": [4, 5], "flag_meanings": "good bad"}
    basestation3(tmp_path / "p1230007.nc", number=7, GPSE_qc=((), 4, words))
    dives, skipped = read_dives(tmp_path)
    assert len(dives) == 1
    assert not skipped


def test_flagged_samples_of_a_seaglider_are_filled_from_their_neighbours(tmp_path):
    steps = made.swim(1800)[2]
    flags = np.where(np.arange(1800) % 50 == 7, 4, 1)
    wild = steps[:, 0] + np.where(flags == 4, 30.0, 0.0)
    changed = {
        "east_displacement": (made.CTD, wild, made.M),
        "east_displacement_qc": (made.CTD, flags, {}),
    }
    (dive,), _ = read_dives(basestation3(tmp_path / "p1230007.nc", **changed))
    assert dive.dr_east == pytest.approx(made.SWUM[0], rel=1e-6)
    assert (
        "36 of 1800 values of east_displacement are flagged bad: left out" in dive.notes
    )


def test_times_of_a_glider_in_a_named_zone_are_refused(tmp_path):
    """Hours of EST were read as UTC, so that tides and days were 5 h off."""
    units = {"TIME": {"units": "seconds since 1970-01-01 00:00:00 EST"}}
    path = og1(tmp_path / "a.nc", units=units)
    refuses("time zone EST, .* Write UTC, or an offset", read_dives, path)
    units = {"TIME": {"units": "seconds since 1970-01-01 00:00:00 UTC"}}
    dives, _ = read_dives(og1(tmp_path / "b.nc", units=units))
    assert dives[0].t_gps2 == made.T0
