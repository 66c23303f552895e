"""Files of real vehicles, drawn in `tests/data`, against plain netCDF4 and WGS84 arithmetic."""

import csv
import json
import shutil

import netCDF4
import numpy as np
import pytest
from pyproj import Geod

from clpt_control.errors import DataError
from clpt_control.gliders import read_dives, usable

WGS84 = Geod(ellps="WGS84")
AXES = ("east", "north")


def between(lat1, lon1, lat2, lon2):
    """East and north of the geodesic at its start, m."""
    bearing, _, length = WGS84.inv(lon1, lat1, lon2, lat2)
    return length * np.sin(np.radians(bearing)), length * np.cos(np.radians(bearing))


def test_basestation3_files_say_what_they_hold(facts):
    dives, skipped = read_dives(facts / "glider" / "sg171")
    assert skipped == []
    assert [dive.number for dive in dives] == [100, 101, 102]
    for dive in dives:
        assert dive.notes == ()
        with netCDF4.Dataset(facts / "glider" / "sg171" / f"p1710{dive.number}.nc") as data:
            lat, lon, time = (data[f"log_gps_{name}"][:] for name in ("lat", "lon", "time"))
            dr = [float(np.sum(data[f"{axis}_displacement"][:])) for axis in ("east", "north")]
            own = [float(data[f"depth_avg_curr_{axis}"][...]) for axis in ("east", "north")]
            flight = float(data["total_flight_time_s"][...])
            deepest = float(data["depth"][:].max())
            variation = float(data["magnetic_variation"][...])
        assert (dive.gps_east, dive.gps_north) == pytest.approx(
            between(lat[1], lon[1], lat[2], lon[2]), abs=1e-6
        )
        assert (dive.dr_east, dive.dr_north) == pytest.approx(dr, abs=1e-9)
        assert dive.duration == time[2] - time[1]
        assert (dive.dac_east, dive.dac_north) == pytest.approx(own)
        assert (dive.depth_max, dive.magvar) == pytest.approx((deepest, variation))
        # its maker divides by the time of flight, not by the time between the fixes
        current = dive.miss_east / flight, dive.miss_north / flight
        assert current == pytest.approx(own, abs=2e-3)
    assert len(usable(dives, 1000.0)[0]) == 3


def test_the_adcp_of_the_vehicle_says_how_far_it_swam(facts):
    """An independent instrument: 1.56 times the dead reckoning (the data's description)."""
    with (facts / "glider" / "sg171_adcp.csv").open() as file:
        rows = {int(row["dive"]): row for row in csv.DictReader(file.readlines()[1:])}
    reckoned, swum = [], []
    for dive in read_dives(facts / "glider" / "sg171")[0]:
        east, north = (float(rows[dive.number][name]) for name in ("u_east", "v_north"))
        reckoned += [dive.dr_east, dive.dr_north]
        swum += [
            dive.gps_east - east * dive.duration,
            dive.gps_north - north * dive.duration,
        ]
    assert np.dot(swum, reckoned) / np.dot(reckoned, reckoned) == pytest.approx(1.56, abs=0.03)


def test_every_row_of_a_seaexplorer_is_read(facts):
    path = facts / "glider" / "sea035m10_dives.csv"
    with path.open() as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    long = [row for row in rows if float(row["t_gpse"]) - float(row["t_gps2"]) > 4000]
    dives, unread = read_dives(path)
    used, unused = usable(dives)
    assert unread == []
    assert len(dives) == len(rows)
    assert [dive.number for dive in used] == [int(row["dive"]) for row in long]
    assert all("must last longer than 4000 s" in one.why for one in unused)
    for dive, row in zip(used, long, strict=True):
        fixes = [float(row[name]) for name in ("lat_gps2", "lon_gps2", "lat_gpse", "lon_gpse")]
        assert (dive.gps_east, dive.gps_north) == pytest.approx(between(*fixes), abs=1e-6)
    everyone, none = usable(dives, 0.0)
    assert (len(everyone), none) == (len(rows), [])


def test_an_og1_fix_at_depth_is_refused_with_its_row(facts):
    path = facts / "glider" / "og1" / "sg015_20040929T140907_delayed.nc"
    with netCDF4.Dataset(path) as data:
        is_fix = np.isfinite(np.ma.filled(data["LATITUDE_GPS"][:], np.nan))
        (row,) = np.flatnonzero(is_fix & (data["DEPTH"][:] > 20))
        depth = float(data["DEPTH"][row])
    assert depth == pytest.approx(251, abs=1)
    said = f"have a new fix {depth:.0f} m under water in row {row} .* set both to NaN there"
    with pytest.raises(DataError, match=said):
        read_dives(path)


def test_the_other_fixes_of_that_mission_are_in_nanoseconds(facts, tmp_path):
    """Without that row and with units the dives are those between fixes over 600 s apart."""
    path = tmp_path / "sg015.nc"
    shutil.copyfile(facts / "glider" / "og1" / "sg015_20040929T140907_delayed.nc", path)
    with netCDF4.Dataset(path, "a") as data:
        deep = data["DEPTH"][:] > 20
        for name in ("LATITUDE_GPS", "LONGITUDE_GPS"):
            data[name][:] = np.where(deep, np.nan, data[name][:])
        times = data["TIME_GPS"][:][np.isfinite(data["LATITUDE_GPS"][:])] / 1e9
    dives = read_dives(path)[0]
    assert all("it looks like nanoseconds" in one.why for one in usable(dives)[1])
    with netCDF4.Dataset(path, "a") as data:
        data["TIME_GPS"].units = "nanoseconds since 1970-01-01"
        data.renameVariable("HORZ_GLIDER_SPEED", "HORZ_SPEED")
        time, heading, speed = (data[name][:] for name in ("TIME", "HEADING", "HORZ_SPEED"))
    dives = read_dives(path)[0]
    gaps = np.flatnonzero(np.diff(times) > 600)
    assert [dive.duration for dive in dives] == pytest.approx(np.diff(times)[gaps])
    for dive in dives:
        assert "magnetic and the variation not in the file" in "; ".join(dive.notes)
    whole = [dive for dive in dives if np.isfinite(dive.dr_east)]
    assert 0 < len(whole) < len(dives)  # a climb is missing
    for dive in whole:
        inside = (time > dive.t_gps2) & (time <= dive.t_gpse) & np.isfinite(heading)
        since = np.diff(time[inside], prepend=time[inside][0])
        cm, angle = speed[inside] * since, np.radians(heading[inside])
        swum = [float(np.nansum(cm * part(angle))) / 100 for part in (np.sin, np.cos)]
        assert (dive.dr_east, dive.dr_north) == pytest.approx(swum)


def test_an_og1_mission_without_fixes_is_refused(facts):
    path = facts / "glider" / "og1" / "sp028_20230202T1637_R.nc"
    with netCDF4.Dataset(path) as data:
        assert np.ma.count(data["latitude_gps"][:]) == 0
        assert np.ma.count(data["latitude_gps_end"][:]) > 0  # not a name of OG1 1.0
    with pytest.raises(DataError, match="no two fixes more than 600 s apart"):
        read_dives(path)


def test_a_replay_of_files_is_that_of_the_table(clpt, facts, tmp_path):
    """Miss and current of SG542's first six dives, by the columns of its table."""
    files = ("replay", facts / "glider" / "basestation", "--json", "--out", tmp_path)
    status, out, _ = clpt(*files)
    found = json.loads(out)
    with (facts / "glider" / "sg542_2016_dives.csv").open() as file:
        rows = list(csv.DictReader(file))[:6]
    miss, current, duration = [], [], []
    for row in rows:
        miss.append([float(row[f"gps_{axis}_m"]) - float(row[f"dr_{axis}_m"]) for axis in AXES])
        current.append([float(row[f"dac_{axis}"]) for axis in AXES])
        duration.append([float(row["t_gpse"]) - float(row["t_gps2"])])
    rms = np.sqrt(np.mean(np.sum(np.square(miss), axis=1)))
    off = np.hypot(*(np.divide(miss, duration) - current).T)
    assert (status, found["used"], found["skipped"]) == (0, 6, [])
    assert found["clpe_rms_all"]["no_flow"] == pytest.approx(rms, abs=1e-3)
    assert found["dac_identity_median"] == pytest.approx(np.median(off), abs=1e-6)
