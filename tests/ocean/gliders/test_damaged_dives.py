"""Damaged tables of dives: refused, noted, or read with the current of the undamaged table.

A made vehicle dives in a steady current of 0.12 m/s to the east and -0.05 m/s to the north.
"""

from datetime import UTC, datetime

import numpy as np
import pytest
from pyproj import Geod

from clpt_control import ClptError
from clpt_control.gliders import read_dives

EARTH = Geod(ellps="WGS84")
CURRENT = np.array([0.12, -0.05])
START, DURATION, SURFACE = 1.6e9, 10800.0, 900.0
WEEKS = 1024 * 7 * 86400.0
COUNT = 8


def moved(lat, lon, displacement):
    east, north = displacement
    angle, distance = np.degrees(np.arctan2(east, north)), np.hypot(east, north)
    lon, lat, _ = EARTH.fwd(lon, lat, angle, distance)
    return lat, lon


def made_rows(count=COUNT):
    """Return rows of dives with the currents of a vehicle in CURRENT."""
    rows, lat, lon = [], 40.0, -60.0
    for number in range(1, count + 1):
        heading = np.radians(40.0 + 25.0 * np.sin(number))
        reckoned = 0.25 * DURATION * np.array([np.sin(heading), np.cos(heading)])
        end = moved(lat, lon, reckoned + CURRENT * DURATION)
        time = START + (number - 1) * (DURATION + SURFACE)
        rows.append(
            {
                "dive": number,
                "t_gps2": time,
                "lat_gps2": lat,
                "lon_gps2": lon,
                "t_gpse": time + DURATION,
                "lat_gpse": end[0],
                "lon_gpse": end[1],
                "dr_east_m": reckoned[0],
                "dr_north_m": reckoned[1],
                "dac_east": CURRENT[0],
                "dac_north": CURRENT[1],
                "magvar": -14.0,
                "vehicle": "sg500",
            }
        )
        lat, lon = moved(*end, CURRENT * SURFACE)
    return rows


def written(folder, rows, header=None):
    columns = header or list(rows[0])
    lines = [",".join(columns)]
    lines += [",".join(str(cell) for cell in row.values()) for row in rows]
    (folder / "dives.csv").write_text("\n".join(lines) + "\n")
    return folder / "dives.csv"


def is_silent(path, right=COUNT):
    """Return whether a damaged table gives wrong currents, or fewer dives, without a word."""
    try:
        dives, skipped = read_dives(path)
    except ClptError:
        return False
    current = [np.array([d.miss_east, d.miss_north]) / d.duration for d in dives]
    wrong = [
        dive
        for dive, found in zip(dives, current, strict=True)
        if np.hypot(*(found - CURRENT)) > 2e-3
    ]
    said = [*skipped, *(note for dive in dives for note in dive.notes)]
    return any(not dive.notes for dive in wrong) or (len(dives) < right and not said)


def test_the_undamaged_table_has_the_current_of_its_sea(tmp_path):
    path = written(tmp_path, made_rows())
    dives, skipped = read_dives(path)
    assert len(dives) == COUNT
    assert not skipped
    assert not any(dive.notes for dive in dives)
    assert not is_silent(path)


def every(**changes):
    """Return a change of cells in each row."""

    def change(rows):
        for row in rows:
            for name, function in changes.items():
                row[name] = function(row)
        return rows

    return change


def some(index, **changes):
    """Return a change of cells in one row."""

    def change(rows):
        for name, function in changes.items():
            rows[index][name] = function(rows[index])
        return rows

    return change


def cell(name, factor=1.0, added=0.0):
    return lambda row: row[name] * factor + added


def value(constant):
    return lambda row: constant


def repeated_end(rows):
    for row in rows[3:4]:
        row["lat_gpse"], row["lon_gpse"] = row["lat_gps2"], row["lon_gps2"]
    return rows


def short(index, column):
    def change(rows):
        rows[index] = {k: v for k, v in rows[index].items() if k != column}
        return rows

    return change


def early(first):
    def change(rows):
        for row in rows[first:]:
            row["t_gps2"] -= WEEKS
            row["t_gpse"] -= WEEKS
        return rows

    return change


def second_vehicle(rows):
    rows[4]["vehicle"] = "sg501"
    return rows


def iso(seconds):
    return datetime.fromtimestamp(seconds, UTC).strftime("%Y-%m-%dT%H:%M:%SZ")


DAMAGES = {
    "currents swapped": every(dac_east=cell("dac_north"), dac_north=value(CURRENT[0])),
    "currents in cm/s": every(
        dac_east=cell("dac_east", 100), dac_north=cell("dac_north", 100)
    ),
    "currents in mm/s": every(
        dac_east=cell("dac_east", 1000), dac_north=cell("dac_north", 1000)
    ),
    "currents in knots": every(
        dac_east=cell("dac_east", 1.944), dac_north=cell("dac_north", 1.944)
    ),
    "currents of the opposite sign": every(
        dac_east=cell("dac_east", -1), dac_north=cell("dac_north", -1)
    ),
    "dead reckoning swapped": every(
        dr_east_m=cell("dr_north_m"), dr_north_m=cell("dr_east_m")
    ),
    "dead reckoning of the opposite sign": every(
        dr_east_m=cell("dr_east_m", -1), dr_north_m=cell("dr_north_m", -1)
    ),
    "dead reckoning in km": every(
        dr_east_m=cell("dr_east_m", 1e-3), dr_north_m=cell("dr_north_m", 1e-3)
    ),
    "dead reckoning in feet": every(
        dr_east_m=cell("dr_east_m", 3.28), dr_north_m=cell("dr_north_m", 3.28)
    ),
    "one dead reckoning that is not a number": some(3, dr_east_m=value("nan")),
    "one dead reckoning of -999": some(3, dr_east_m=value(-999.0)),
    "one fill of the library": some(3, dr_east_m=value(9.969e36)),
    "one latitude of 99": some(3, lat_gpse=value(99.0)),
    "one place at 0 N 0 E": some(3, lat_gpse=value(0.0), lon_gpse=value(0.0)),
    "an end fix that repeats the start fix": repeated_end,
    "a magnetic variation of -999": every(magvar=value(-999.0)),
    "a magnetic variation of 9.97e36": some(2, magvar=value(9.97e36)),
    "dates 1024 weeks early": early(4),
    "the last dive 1024 weeks early": early(7),
    "times in days": every(
        t_gps2=cell("t_gps2", 1 / 86400), t_gpse=cell("t_gpse", 1 / 86400)
    ),
    "times in ms": every(t_gps2=cell("t_gps2", 1e3), t_gpse=cell("t_gpse", 1e3)),
    "an end before the start": some(2, t_gpse=cell("t_gps2", 1.0, -60.0)),
    "a row without a latitude": short(3, "lat_gps2"),
    "a row without dead reckoning": short(3, "dr_east_m"),
    "a row without its number": short(3, "dive"),
    "the last row without its vehicle": short(7, "vehicle"),
    "the first row without a time": short(0, "t_gpse"),
    "a second vehicle": second_vehicle,
    "a cell of letters": some(3, lat_gpse=value("40 N")),
    "a date of another form": some(3, t_gpse=value("13/09/2020 12:00")),
    "a row twice": lambda rows: [*rows, dict(rows[2])],
    "longitudes of 0 to 360": every(
        lon_gps2=cell("lon_gps2", 1.0, 360.0), lon_gpse=cell("lon_gpse", 1.0, 360.0)
    ),
    "rows in reverse": lambda rows: rows[::-1],
    "dates as texts": every(
        t_gps2=lambda row: iso(row["t_gps2"]), t_gpse=lambda row: iso(row["t_gpse"])
    ),
}


@pytest.mark.parametrize("name", DAMAGES)
def test_no_damage_of_a_table_is_silent(tmp_path, name):
    path = written(tmp_path, DAMAGES[name](made_rows()), list(made_rows()[0]))
    assert not is_silent(path)


@pytest.mark.parametrize("name", [name for name in DAMAGES if "dead" not in name])
def test_no_damage_of_a_table_without_dead_reckoning_is_silent(tmp_path, name):
    """The current alone has nothing to be compared with: its own damages are left out."""
    if "currents" in name:
        return
    rows = DAMAGES[name](made_rows())
    rows = [{k: v for k, v in row.items() if not k.startswith("dr_")} for row in rows]
    header = [k for k in made_rows()[0] if not k.startswith("dr_")]
    assert not is_silent(written(tmp_path, rows, header))
