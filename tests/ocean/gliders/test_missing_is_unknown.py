"""Rows, columns and files of a SeaExplorer that are missing: unknown, never no motion.

The vehicle dives near the equator in a current of CURRENT m/s, 0.3 m/s through the water, a row
each 20 s.  A file ends in the climb, so that a dive lies in two files.
"""

import gzip
from datetime import datetime

import netCDF4
import numpy as np
import pytest
from geodesics import place_from
from refusals import refuses

from clpt_control.gliders import read_dives

CURRENT, SPEED, EAST, DIVES = np.array([0.12, -0.06]), 0.3, -4.0, 5
STEP, ROWS, UP = 20.0, 60, 24  # s, rows down or up, rows at the surface
SINK = SPEED * np.tan(np.radians(20.0)) * STEP  # m a row
T0, START = 1563750000.0, (1.0, 20.0)
HEAD = (
    "Timestamp;NavState;Heading;Declination;Pitch;Depth;Lat;Lon;DeadReckoning;DesiredH;"
)
MOTION = ("Heading", "Pitch", "Depth")


def ddmm(degrees):
    return f"{int(degrees) * 100 + (degrees % 1) * 60:.4f}"


def rows_of(boundary=10.0):
    """Rows of a mission, each with its file and its dive from 1; the dive before a surfacing."""
    rows, time, place = [], T0, START
    fix, number = START, 1

    def row(dive, state, course, pitch, depth):
        cells = [state, f"{course - EAST:.2f}", EAST, pitch, f"{depth:.2f}"]
        cells += [*map(ddmm, fix), int(state != 116), ""]
        names = HEAD.split(";")[1:]
        rows.append(
            {"file": number, "dive": dive, "time": time}
            | dict(zip(names, cells, strict=False))
        )

    for dive in range(DIVES + 1):
        course = 20.0 + 35.0 * dive
        way = SPEED * np.array([np.sin(np.radians(course)), np.cos(np.radians(course))])
        depths = SINK * np.arange(ROWS)
        if dive:
            for pitch, flown in ((-20, depths), (20, depths[::-1])):
                for depth in flown:
                    if pitch > 0 and depth < boundary and number == dive:
                        number += 1
                    row(dive, 100 if pitch < 0 else 117, course, pitch, depth)
                    place = place_from(*place, *((way + CURRENT) * STEP))
                    time += STEP
        for k in range(UP):
            fix = place if k % 3 == 0 and k else fix
            row(dive, 116, course, -10, 0.5)
            place = place_from(*place, *(CURRENT * STEP))
            time += STEP
    return rows


def write(folder, rows, name="sea035.12.gli.sub.{}"):
    texts = {}
    for row in rows:
        date = (
            np.datetime64(round(row["time"]), "s").item().strftime("%d/%m/%Y %H:%M:%S")
        )
        cells = [date, *(row[column] for column in HEAD.split(";")[1:-1])]
        texts.setdefault(row["file"], [HEAD]).append(";".join(map(str, cells)) + ";")
    for number, lines in texts.items():
        (folder / name.format(number)).write_text("\n".join(lines) + "\n")


def currents(dives):
    return np.array([dive.miss / dive.duration for dive in dives])


@pytest.fixture(scope="module")
def whole():
    return rows_of()


@pytest.mark.parametrize("boundary", [10.0, 4.0])
@pytest.mark.parametrize("lost", [None, 2, 3, 4])
def test_a_lost_file_costs_two_dives_and_says_so(tmp_path, boundary, lost):
    write(tmp_path, [row for row in rows_of(boundary) if row["file"] != lost])
    dives, skipped = read_dives(tmp_path)
    assert np.allclose(currents(dives), CURRENT, atol=0.02)
    assert len(dives) == DIVES - 2 * bool(lost)
    if lost:
        files = rf"no file between sea035.12.gli.sub.{lost - 1} and sea035.12.gli.sub.{lost + 1}"
        assert files in skipped[0].why
        # without the numbers, the hole itself tells
        for k in range(lost + 1, DIVES + 2):
            path = tmp_path / f"sea035.12.gli.sub.{k}"
            path.rename(path.with_suffix(f".{k - 1}"))
        dives, skipped = read_dives(tmp_path)
        assert np.allclose(currents(dives), CURRENT, atol=0.02)
        assert "no samples for 2900 s of 5400 s" in skipped[0].why


@pytest.mark.parametrize("column", MOTION)
@pytest.mark.parametrize("part", ["dive", "climb"])
def test_a_column_that_is_empty_is_unknown(tmp_path, whole, column, part):
    write(
        tmp_path,
        [
            row | {column: ""}
            if row["dive"] == 3 and (part == "dive" or row["NavState"] == 117)
            else row
            for row in whole
        ],
    )
    dives, skipped = read_dives(tmp_path)
    assert np.allclose(currents(dives), CURRENT, atol=0.02)
    assert len(dives) == DIVES - 1
    assert "no samples" in skipped[0].why


@pytest.mark.parametrize("late", [-1200, -600, -200, 300, 900])
@pytest.mark.parametrize("end", [0.6, 1.0])
def test_rows_that_go_back_in_time_are_told(tmp_path, whole, late, end):
    wet = [row for row in whole if row["dive"] == 3 and row["NavState"] != 116]
    wrong = {id(row) for row in wet[int(0.3 * len(wet)) : int(end * len(wet))]}
    write(
        tmp_path,
        [row | {"time": row["time"] + late * (id(row) in wrong)} for row in whole],
    )
    dives, skipped = read_dives(tmp_path)
    assert np.allclose(currents(dives), CURRENT, atol=0.03)
    assert any("rows go back in time by" in skip.why for skip in skipped)


@pytest.mark.parametrize("again", [lambda rows: rows[::-1], lambda rows: rows * 2])
def test_rows_in_another_order_or_twice_are_sorted(tmp_path, whole, again):
    write(tmp_path, again(whole))
    dives, skipped = read_dives(tmp_path)
    assert (len(dives), skipped) == (DIVES, [])
    assert np.allclose(currents(dives), CURRENT, atol=0.02)


def test_a_fix_without_its_dive_is_skipped(tmp_path, whole):
    write(tmp_path, [row for row in whole if row["file"] > 1])
    dives, skipped = read_dives(tmp_path)
    assert len(dives) == DIVES - 1
    assert "no fix before the dive that ends 2019-07-21T23:49:00Z" in skipped[0].why
    refuses("no fix before the dive", read_dives, tmp_path / "sea035.12.gli.sub.2")


def test_a_gzip_of_several_members(tmp_path, whole):
    write(tmp_path, whole)
    texts = [path.read_bytes() for path in sorted(tmp_path.iterdir())]
    for path in list(tmp_path.iterdir()):
        path.unlink()
    path = tmp_path / "sea035.12.gli.sub.1.gz"
    members = b"".join(map(gzip.compress, texts))
    path.write_bytes(members + bytes(512))  # padded, as on tapes
    assert len(read_dives(tmp_path)[0]) == DIVES
    path.write_bytes(members + b"not gzip")
    refuses("its gzip is damaged", read_dives, tmp_path)


@pytest.mark.long
@pytest.mark.parametrize("declination", ["0", ""])
def test_a_declination_that_is_none_is_that_of_igrf(
    tmp_path, whole, declination, printed
):
    ppigrf = pytest.importorskip("ppigrf")
    east, north, _ = ppigrf.igrf(20.0, 1.0, 0.0, datetime(2019, 7, 22))
    igrf = np.degrees(np.arctan2(east, north)).item()
    write(tmp_path, [row | {"Declination": declination} for row in whole])
    dives, _ = read_dives(tmp_path)
    for dive in dives:
        assert dive.turned == pytest.approx(igrf, abs=0.05)
        assert any("Declination is" in note for note in dive.notes)
    command = ("replay", tmp_path, "--no-learn-speed", "--variation", EAST)
    last = printed(*command)["each_dive"][-1]
    found = last["current_east"], last["current_north"]
    assert found == pytest.approx(CURRENT, abs=0.02)


@pytest.mark.parametrize("declination", [30.0, -20.0])
def test_a_declination_of_another_place_is_told(tmp_path, whole, declination):
    write(tmp_path, [row | {"Declination": declination} for row in whole])
    dives, _ = read_dives(tmp_path)
    assert all(any("by IGRF" in note for note in dive.notes) for dive in dives)


@pytest.mark.parametrize("state", [100, 117])
@pytest.mark.parametrize("rows_lost", [8, 11, 15])
def test_rows_beside_the_surface_that_are_lost_are_told(
    tmp_path, whole, state, rows_lost
):
    """A twentieth of a dive of 2,520 s, too little for a hole, or a tenth."""
    lost = SINK * rows_lost
    write(
        tmp_path,
        [
            row
            for row in whole
            if (row["dive"], row["NavState"]) != (3, state)
            or float(row["Depth"]) > lost
        ],
    )
    dives, skipped = read_dives(tmp_path)
    found = {dive.number: str(dive.notes) for dive in dives}
    found |= {skip.dive: skip.why for skip in skipped}
    told = {number for number, text in found.items() if "no samples for" in text}
    assert told == ({4} if lost > 20.0 else set())  # its climb is in file 4


def test_one_dive_of_no_motion_is_told(tmp_path, whole):
    write(
        tmp_path, [row | {"Pitch": 0.0} if row["dive"] == 3 else row for row in whole]
    )
    dives, _ = read_dives(tmp_path)
    told = [any("exactly 0. Unless" in note for note in d.notes) for d in dives]
    assert told == [False, False, True, False, False]


def test_a_pitch_in_radians_is_no_motion_in_each_dive(tmp_path, whole):
    write(tmp_path, [row | {"Pitch": np.radians(row["Pitch"])} for row in whole])
    dives, _ = read_dives(tmp_path)
    assert all(any("exactly 0. Unless" in note for note in d.notes) for d in dives)


@pytest.mark.parametrize("column", ["HEADING", "GLIDER_HORZ_VELO_MODEL", None])
def test_an_og1_mission_with_a_hole(tmp_path, whole, column):
    """Heading or speed empty below the surface in a dive, or the dive and its surfacing lost."""
    rows = [row for row in whole if column or row["file"] != 4]
    wet = np.array([row["NavState"] != 116 for row in rows])
    new = [k > 0 and row["Lat"] != rows[k - 1]["Lat"] for k, row in enumerate(rows)]
    fixed = ~wet & np.array(new)
    places = np.array([[float(row["Lat"]), float(row["Lon"])] for row in rows])
    places = places // 100 + places % 100 / 60
    columns = {
        "TIME": np.array([row["time"] for row in rows]),
        "DEPTH": np.array([float(row["Depth"]) for row in rows]),
        "HEADING": np.array([float(row["Heading"]) + EAST for row in rows]),
        "GLIDER_HORZ_VELO_MODEL": np.where(wet, SPEED, 0.0),
        "LATITUDE_GPS": np.where(fixed, places[:, 0], np.nan),
        "LONGITUDE_GPS": np.where(fixed, places[:, 1], np.nan),
    }
    if column:
        blank = wet & [row["dive"] == 3 and float(row["Depth"]) > 1 for row in rows]
        columns[column] = np.where(blank, np.nan, columns[column])
    with netCDF4.Dataset(tmp_path / "og1.nc", "w") as data:
        data.createDimension("N_MEASUREMENTS", len(rows))
        for name, numbers in columns.items():
            data.createVariable(name, "f8", ("N_MEASUREMENTS",))[:] = numbers
        data["TIME"].units = "seconds since 1970-01-01 00:00:00"
        data["HEADING"].setncatts({"units": "degrees", "comment": "true heading"})
    dives, skipped = read_dives(tmp_path)
    assert np.allclose(currents(dives), CURRENT, atol=0.03)
    assert len(dives) == DIVES - 1 - (column is None)
    assert "no samples for" in skipped[0].why
