"""Files of other vehicles, old and new, against the displacement that is known."""

from dataclasses import replace

import glider_dialects as made
import numpy as np
import pytest
from glider_dialects import basestation, basestation3, dives_in, og1, og1_rows

from clpt_control.gliders.dive_files import read_dives
from clpt_control.gliders.dive_table import write_dive_table
from clpt_control.gliders.samples import variation, with_variation
from clpt_control.gliders.usable_dives import usable

DATE_LINE = 180.0 - made.DRIFT / 2


def swam(dive):
    """Check a dive against the vehicle's displacement, its fixes, its current and its depth."""
    assert (dive.dr_east, dive.dr_north) == pytest.approx(tuple(made.SWUM), rel=1e-9)
    assert (dive.gps_east, dive.gps_north) == pytest.approx((made.GPS_EAST, 0.0), abs=1e-5)
    assert dive.duration == made.DURATION
    mean = dive.miss_east / made.DURATION, dive.miss_north / made.DURATION
    assert mean == pytest.approx(tuple(made.current()), abs=1e-9)
    assert dive.depth_max == pytest.approx(made.DEPTH, rel=0.01)
    return True


def half_way(dive):
    """Check the track where half of the dive has passed."""
    time, east, north = dive.track
    assert (time[0], time[-1]) == (0.0, made.DURATION)
    here = np.interp(made.DURATION / 2, time, east), np.interp(made.DURATION / 2, time, north)
    assert here == pytest.approx(tuple(made.VELOCITY * (made.DURATION / 2 - 60.0)), abs=1.0)


@pytest.mark.parametrize("make", [basestation, basestation3])
@pytest.mark.parametrize("lon", [8.0, DATE_LINE])
def test_basestation_files_of_both_kinds(make, lon, tmp_path):
    dive = dives_in(make(tmp_path / "p1230007.nc", lon=lon))[0]
    assert swam(dive)
    half_way(dive)
    assert (dive.number, dive.kind, dive.magvar) == (7, "Seaglider", made.VARIATION)
    assert dive.notes == ()
    assert (dive.dac_east, dive.dac_north) == pytest.approx(tuple(made.current()))
    assert usable([dive])[0] == [dive]


def test_the_track_has_the_times_of_its_displacement(tmp_path):
    dive = dives_in(basestation(tmp_path / "a.nc"))[0]  # ctd_time is half a second later
    assert dive.track[0][1] == pytest.approx(60.5, abs=1e-6)
    dive = dives_in(basestation(tmp_path / "c.nc", drop=("ctd_time",)))[0]
    assert dive.track[0][1] == pytest.approx(60.0, abs=1e-6)


def test_a_part_of_the_dive_that_is_missing_is_no_time_at_the_surface(tmp_path):
    point = ("ctd_data_point",)
    since = np.linspace(60.0, made.DURATION - 1200.0, 1800)  # up 1200 s before the fix
    risen = {"ctd_time": (point, made.T0 + 60000.0 + since, made.EPOCH)}
    dive = dives_in(basestation3(tmp_path / "risen.nc", **risen))[0]
    assert dive.dr_east == pytest.approx(made.SWUM[0])
    down = {"ctd_depth": (point, np.linspace(0.0, 300.0, 1800), made.M)}  # still deep then
    dive = dives_in(basestation3(tmp_path / "cut.nc", **risen, **down))[0]
    assert usable([dive])[0] == []
    assert "no samples for 1200 s of 9000 s, from 300 m depth on" in dive.notes


def in_nanoseconds(columns):
    """Times since the first."""
    whole = np.round(columns["TIME"] - made.T0 + 300, 3)
    columns["TIME"] = (whole * 1e9).astype(np.int64)
    return {
        "units": {"TIME": {"units": "nanoseconds since 2017-07-14 02:35:00"}}
    }  # made.T0 - 300 s


def on_their_own(columns):
    """Fixes on a dimension of their own."""
    fix = np.isfinite(columns["LATITUDE_GPS"])
    own = {
        name: (("N_GPS",), columns[of][fix], made.EPOCH if name == "TIME_GPS" else {})
        for name, of in (("TIME_GPS", "TIME"), ("LATITUDE_GPS",) * 2, ("LONGITUDE_GPS",) * 2)
    }
    for name in [*columns]:
        columns[name] = columns[name][~fix]
    del columns["LATITUDE_GPS"], columns["LONGITUDE_GPS"]
    return {"sizes": {"N_GPS": int(fix.sum())}, **own}


@pytest.mark.parametrize("lon", [8.0, DATE_LINE])
@pytest.mark.parametrize("change", [lambda columns: {}, in_nanoseconds, on_their_own])
def test_og1_fixes_and_times_as_files_have_them(change, lon, tmp_path):
    columns = og1_rows(lon=lon)
    dives = dives_in(og1(tmp_path / "og1.nc", **change(columns), columns=columns))
    assert [dive.number for dive in dives] == [1, 2, 3]
    assert [dive.t_gps2 for dive in dives] == [made.T0, made.T0 + 10000, made.T0 + 20000]
    for dive in dives:
        assert swam(dive)
        half_way(dive)
        assert dive.t_gps1 == dive.t_gps2 - (300 if dive.number == 1 else 1000)
        assert dive.kind is None  # any vehicle's
        assert dive.notes == ()


@pytest.mark.parametrize(
    "drop", [("divenum",), ("divenum", "DEPTH"), ("divenum", "DEPTH", "PHASE")]
)
def test_og1_dives_without_numbers_depth_or_phase(drop, tmp_path):
    columns = og1_rows()
    again = columns["TIME"] == columns["TIME"][2:402].max() + made.LAST  # GPSE of the first dive
    drifted = {name: np.repeat(a, 1 + 2 * again) for name, a in columns.items()}
    place = np.flatnonzero(again)[0]
    drifted["TIME"][place + 1 : place + 3] += [310.0, 690.0]  # two more fixes at the surface
    dives = dives_in(og1(tmp_path / "og1.nc", drop=drop, columns=drifted))
    assert [dive.number for dive in dives] == [1, 2, 3]
    for dive in dives:
        assert (dive.dr_east, dive.dr_north) == pytest.approx(tuple(made.SWUM))
        assert (dive.depth_max is None) == ("DEPTH" in drop)


STEPS = ("EAST_DISPLACEMENT", "NORTH_DISPLACEMENT")
OWN = ("DAVG_CURR_EAST", "DAVG_CURR_NORTH")


def test_og1_dead_reckoning_of_speed_and_heading(tmp_path):
    turned = {"MAGNETIC_VARIATION": ((), made.VARIATION, {})}
    for dive in dives_in(og1(tmp_path / "a.nc", drop=(*STEPS, *OWN), **turned)):
        assert swam(dive)
        assert "magnetic, variation -15 degrees (of the file" in dive.notes[0]
    for dive in dives_in(og1(tmp_path / "b.nc", drop=STEPS)):  # the file's current before a guess
        assert swam(dive)
        assert dive.notes == ("dead reckoning computed from the file's depth-averaged current",)
    for dive in dives_in(og1(tmp_path / "c.nc", drop=(*STEPS, *OWN))):
        middle = 0.5 * (dive.t_gps2 + dive.t_gpse)
        igrf = variation(middle, dive.lat_gps2, dive.lon_gps2)
        bearing = np.radians(made.BEARING - made.VARIATION + igrf)
        there = made.SPEED * (made.DURATION - 200.0) * np.array([np.sin(bearing), np.cos(bearing)])
        assert (dive.dr_east, dive.dr_north) == pytest.approx(tuple(there))
        assert (dive.turned, dive.magvar) == (igrf, igrf)
        assert f"magnetic, variation {igrf:.0f} degrees (by IGRF" in dive.notes[0]
        back = with_variation(dive, made.VARIATION)
        assert swam(back)
        assert np.hypot(*(end[-1] for end in back.track[1:])) == pytest.approx(np.hypot(*there))
        assert "--variation: turned by -15 degrees instead" in back.notes
    true = {"HEADING": {"units": "degrees", "comment": "relative to true north"}}
    columns = og1_rows()
    columns["HEADING"] = columns["HEADING"] + made.VARIATION
    path = og1(tmp_path / "d.nc", drop=(*STEPS, *OWN), columns=columns, units=true)
    assert all(swam(dive) and with_variation(dive, 90.0) is dive for dive in dives_in(path))
    unnamed = {"HEADING": {"units": "degrees"}}
    path = og1(tmp_path / "e.nc", drop=(*STEPS, *OWN), units=unnamed)
    for dive in dives_in(path):
        assert (
            "a north that the file does not name, variation 0 degrees (not known; --"
            in dive.notes[0]
        )
        assert swam(with_variation(dive, made.VARIATION))


def test_places_that_are_no_dead_reckoning_are_the_fixes(tmp_path):
    """OG1's DEAD_RECKONING is 0 where the receiver gave the place, 1 where it was computed."""
    columns = og1_rows()
    fix = np.isfinite(columns["LATITUDE_GPS"])
    rows = np.arange(fix.size)
    places = {
        name: np.interp(rows, rows[fix], columns.pop(f"{name}_GPS")[fix])
        for name in ("LATITUDE", "LONGITUDE")
    }
    columns |= places | {"DEAD_RECKONING": np.where(fix, 0.0, 1.0)}
    expected = dives_in(og1(tmp_path / "gps.nc"))
    for k, more in enumerate(({}, {"LATITUDE_GPS": np.full(fix.size, np.nan)})):
        found = dives_in(og1(tmp_path / f"{k}.nc", columns=columns | more))
        assert found == expected
        assert all(swam(dive) for dive in found)


def test_a_stall_of_the_flight_model_is_no_way(tmp_path):
    columns = og1_rows()
    stall = np.arange(100, 111)
    for name in ("GLIDER_HORZ_VELO_MODEL", *STEPS):
        columns[name][stall] = 0.0 if name in STEPS else np.nan
    turned = {"MAGNETIC_VARIATION": ((), made.VARIATION, {})}
    ways = [
        dives_in(og1(tmp_path / f"{len(drop)}.nc", drop=drop, columns=columns, **turned))[0]
        for drop in ((), (*STEPS, *OWN))
    ]
    assert (ways[0].dr_east, ways[0].dr_north) == pytest.approx((ways[1].dr_east, ways[1].dr_north))


def test_missions_over_the_date_line_go_round(tmp_path):
    dives = dives_in(og1(tmp_path / "og1.nc", columns=og1_rows(lon=DATE_LINE - made.DRIFT)))
    assert {np.sign(dive.lon_gps2) for dive in dives} == {1.0, -1.0}
    write_dive_table(dives, tmp_path / "back.csv")
    back = dives_in(tmp_path / "back.csv")
    assert [swam(replace(dive, track=None)) for dive in back] == [True] * 3
    east = [replace(dive, lon_gpse=dive.lon_gpse % 360.0, gps_east=0.0) for dive in dives]
    write_dive_table(east, tmp_path / "east.csv")  # longitudes to 360 east
    rows = read_dives([tmp_path / "east.csv"])[0]
    assert [dive.gps_east for dive in rows] == pytest.approx([made.GPS_EAST] * 3)
