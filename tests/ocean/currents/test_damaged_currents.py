"""Damaged files of currents: each is refused by a sentence, or read as the undamaged file is.

The current is an M2 tide, the same everywhere, so that amplitude and Greenwich phase of a read
file have one right value.  A damage that changes them without an error is a silent one.
"""

import numpy as np
import pytest
from gridded_currents import gridded_current

from clpt_control import ClptError
from clpt_control.currents import fit_tides, read_currents, read_record

HOURS = np.arange(72.0)
LAT, LON = np.linspace(41.0, 41.6, 4), np.linspace(-70.0, -69.4, 4)
ANGLE = 2 * np.pi * HOURS / 12.4206012
EAST, NORTH = 0.1 + 0.4 * np.cos(ANGLE - 1.0), 0.2 * np.cos(ANGLE - 2.0) - 0.05
GAP = np.arange(4, 72, 9)
WHOLE_HOURS = [
    f"2019-03-{1 + int(h // 24):02d}T{int(h % 24):02d}:00:00Z" for h in HOURS
]


def tide(record):
    """Return amplitude and phase of M2 to the east."""
    fit = fit_tides(record.time, record.u, record.v, 41.3, ["M2"])
    return fit.constituents[0].east, fit.constituents[0].east_phase


def current(east=EAST, north=NORTH, hours=HOURS):
    """Return the tide on a grid."""
    u, v = (w[:, None, None] * np.ones((4, 4)) for w in (east, north))
    return gridded_current(u, v, LAT, LON, hours, since="2019-03-01")


def table(east=EAST, north=NORTH, header="time,u (m/s),v (m/s)", times=WHOLE_HOURS):
    """Return the lines of the tide as a table."""
    rows = zip(times, east, north, strict=True)
    return ["# latitude: 41.3", header, *(f"{t},{u:.5f},{v:.5f}" for t, u, v in rows)]


def read(path):
    """Return M2 of a file, or None where it is refused."""
    try:
        return tide(
            read_record(path, at=None if path.suffix == ".csv" else (41.3, -69.7))
        )
    except ClptError:
        return None


@pytest.fixture(scope="module")
def right(tmp_path_factory):
    path = tmp_path_factory.mktemp("right") / "c.nc"
    current().to_netcdf(path)
    return read(path)


def is_right(found, right):
    """Return whether a file was refused or read as the undamaged one, gaps aside."""
    return found is None or (
        found[0] == pytest.approx(right[0], rel=0.02) and abs(found[1] - right[1]) < 1.0
    )


def with_gaps(value, size=1.0):
    east = EAST.copy()
    east[GAP] = value * size
    return east


FILLS = [-999.9, -99.99, 9.0, -9.0, 9.899, 9.969e36, 1e20, -1e34, 32.767, -32.768]
FILLS += [5.0, -5.0, 7.5, 3.2767, -3.2768, -2.0, 99.99, np.inf]


@pytest.mark.parametrize("value", FILLS)
@pytest.mark.parametrize("kind", ["float64", "float32", "packed", "table", "cm/s"])
def test_undeclared_fill_values_are_refused_or_gaps(tmp_path, right, value, kind):
    path = tmp_path / ("c.csv" if kind in ("table", "cm/s") else "c.nc")
    if kind == "table":
        path.write_text("\n".join(table(with_gaps(value))))
    elif kind == "cm/s":
        lines = table(
            100 * with_gaps(value, 0.01), 100 * NORTH, "time,u (cm/s),v (cm/s)"
        )
        path.write_text("\n".join(lines))
        if (
            abs(value) <= 50.0
        ):  # within the range of the tide, 50 cm/s: not to be recognized
            return
    else:
        encoding = {"dtype": "float32" if kind == "float32" else "float64"}
        if kind == "packed":
            if not abs(value) < 32.0:
                return
            encoding = {"dtype": "int16", "scale_factor": 0.001, "_FillValue": -32768}
        current(with_gaps(value)).to_netcdf(
            path, encoding={"u": encoding, "v": encoding}
        )
    assert is_right(read(path), right)


@pytest.mark.parametrize(
    ("attributes", "packed"),
    [
        ({"valid_range": [-3.0, 3.0]}, False),
        ({"valid_min": -3.0, "valid_max": 3.0}, False),
        ({"valid_max": 3.0}, False),
        ({"valid_range": np.array([-3000, 3000], "int16")}, True),
        ({"valid_min": np.int16(-3000), "valid_max": np.int16(3000)}, True),
        ({"valid_range": np.array([-3.0, 3.0], "float32")}, True),
        ({"valid_range": "-3 3"}, False),
        ({"valid_range": [-3.0]}, False),
        ({"valid_range": [0.45, 3.0]}, False),
    ],
)
def test_values_outside_the_valid_range_are_gaps(tmp_path, right, attributes, packed):
    east = EAST.copy()
    east[GAP] = 5.0 + 0.1 * np.arange(GAP.size)  # no value twice
    data = current(east)
    data.u.attrs.update(attributes)
    scaled = {"dtype": "int16", "scale_factor": 0.001, "_FillValue": -32768}
    data.to_netcdf(tmp_path / "c.nc", encoding={"u": scaled} if packed else {})
    assert is_right(read(tmp_path / "c.nc"), right)


def bounds(start, end, methods="time: mean", **changes):
    """Return the tide averaged over intervals, stamped at their start."""

    def change(data, step):
        lower, upper = HOURS * step + start * step, HOURS * step + end * step
        data["time_bnds"] = (("time", "nv"), np.stack([lower, upper], 1))
        data.time.attrs |= {"bounds": "time_bnds"}
        for name in "uv":
            data[name].attrs |= {"cell_methods": methods} if methods else {}
        for key, value in changes.items():
            data.time_bnds.values[key] = value
        return data

    return change


INTERVALS = [
    (bounds(0, 1), 0.5),
    (bounds(0, 1, "area: mean time: mean (interval: 1 minute)"), 0.5),
    (bounds(0, 1, "time: area: mean"), 0.5),
    (bounds(0, 1, ""), 0.5),
    (bounds(-1, 0), -0.5),
    (bounds(-0.5, 0.5), 0.0),
    (bounds(0, 1, "time: point"), 0.0),
]


@pytest.mark.parametrize("step", [0.5, 1.0, 3.0])
@pytest.mark.parametrize(("change", "middle"), INTERVALS)
def test_means_are_dated_at_the_middle_of_their_bounds(
    tmp_path, right, change, middle, step
):
    angle = ANGLE * step + 2 * np.pi * middle * step / 12.4206012
    data = current(
        0.1 + 0.4 * np.cos(angle - 1.0), 0.2 * np.cos(angle - 2.0), HOURS * step
    )
    change(data, step).to_netcdf(tmp_path / "c.nc")
    found = read(tmp_path / "c.nc")
    assert found is not None
    assert is_right(found, right)


def attributes_of(name, **attributes):
    def change(data):
        data[name].attrs |= attributes
        return data

    return change


def bad_bounds(values, units=None):
    def change(data):
        data["time_bnds"] = (("time", "nv"), values)
        if units:
            data.time_bnds.attrs["units"] = units
        return attributes_of("time", bounds="time_bnds")(data)

    return change


def renamed_time(data):
    """Return u and v on `time1`, beside the times of something else."""
    data = data.rename(time="time1")
    return data.assign_coords(
        time=("time", HOURS[:5] + 100, {"units": "hours since 1999-1-1"})
    )


def one_time(value, index=30):
    def change(data):
        time = data.time.values.copy()
        time[index] = value
        return data.assign_coords(time=("time", time, data.time.attrs))

    return change


LOWER, UPPER = HOURS, HOURS + 1.0
TIMES = [
    bad_bounds(np.stack([LOWER + 5, UPPER + 5], 1)),
    bad_bounds(np.stack([LOWER, UPPER * np.nan], 1)),
    bad_bounds(np.stack([LOWER, UPPER], 1), units="hours since 2018-03-01"),
    bad_bounds(np.stack([LOWER, LOWER, UPPER], 1)),
    attributes_of("u", cell_methods="time: maximum"),
    attributes_of("u", cell_methods="time: standard_deviation"),
    attributes_of("time", climatology="climatology_bounds"),
    attributes_of("time", calendar="365_day"),
    attributes_of("time", calendar="360_day"),
    attributes_of("time", calendar="julian"),
    attributes_of("time", units="hours since 0001-01-01"),
    attributes_of("time", units="months since 2019-03-01"),
    attributes_of("time", units="hours since 01/03/2019"),
    attributes_of("time", units="hours"),
    renamed_time,
    one_time(np.nan),
    one_time(HOURS[29]),
    one_time(np.inf),
    one_time(9.97e36),
    lambda data: data.assign_coords(time=("time", HOURS - 1e9, data.time.attrs)),
    lambda data: data.isel(time=data.time.notnull().values[::-1]),
]


@pytest.mark.parametrize("change", TIMES)
def test_damaged_times_are_refused_or_right(tmp_path, right, change):
    change(current()).to_netcdf(tmp_path / "c.nc")
    found = read(tmp_path / "c.nc")
    assert is_right(found, right)


def test_a_velocity_on_a_time_of_its_own_is_read(tmp_path, right):
    renamed_time(current()).to_netcdf(tmp_path / "c.nc")
    assert read(tmp_path / "c.nc") == pytest.approx(right)


@pytest.mark.parametrize("last", ["", ",", ",,", ",x", ",0.1,0.2,0.3"])
@pytest.mark.parametrize("row", [2, 30, 73])
def test_a_row_with_another_number_of_cells_is_refused(tmp_path, right, last, row):
    lines = table()
    lines[row] = lines[row].split(",")[0] + last
    (tmp_path / "c.csv").write_text("\n".join(lines))
    found = read(tmp_path / "c.csv")
    assert is_right(found, right)
    assert found is None or last == ",,"


def test_the_units_of_erddaps_second_row_are_read(tmp_path, right):
    lines = table(header="time,u,v\nUTC,m s-1,m s-1")
    (tmp_path / "c.csv").write_text("\n".join(lines))
    assert is_right(read(tmp_path / "c.csv"), right)
    assert read(tmp_path / "c.csv") is not None
    lines = table(100 * EAST, 100 * NORTH, "time,u,v\nUTC,cm s-1,cm s-1")
    (tmp_path / "c.csv").write_text("\n".join(lines))
    assert read(tmp_path / "c.csv")[0] == pytest.approx(right[0], rel=1e-3)


POLAR = "time,speed (m/s),direction (degrees)"
SPEED, TOWARDS = np.hypot(EAST, NORTH), np.degrees(np.arctan2(EAST, NORTH)) % 360


@pytest.mark.parametrize("value", [-999.0, -9.99, -1.0, -99.99, 9.9, np.nan])
@pytest.mark.parametrize("column", [0, 1])
def test_gaps_of_speed_and_direction_are_refused(tmp_path, right, value, column):
    columns = [SPEED.copy(), TOWARDS.copy()]
    columns[column][GAP] = value
    if column == 1 and -180 <= value <= 360:
        return  # an angle
    (tmp_path / "c.csv").write_text("\n".join(table(*columns, POLAR)))
    assert is_right(read(tmp_path / "c.csv"), right)


@pytest.mark.parametrize("count", [2, 3, 5])
@pytest.mark.parametrize("shared", ["all", "first two", "last two"])
def test_a_file_of_a_folder_that_is_not_used_is_refused(tmp_path, count, shared):
    """Files of a day each, some with the same times as another: the last one would count."""
    days = {"all": [0] * count, "first two": [0, *range(count - 1)]}
    days["last two"] = [*range(count - 1), count - 2]
    for k, day in enumerate(days[shared]):
        part = current().isel(time=range(24)).copy()
        part["time"] = (
            "time",
            HOURS[:24] + 24 * day,
            {"units": "hours since 2019-03-01"},
        )
        part.to_netcdf(tmp_path / f"day{k}.nc")
    with pytest.raises(
        ClptError, match=r"each step of day\d.nc is in a later file too"
    ):
        read_currents(tmp_path)


MASKED = np.ma.masked_less(with_gaps(-999.0), -900)


@pytest.mark.parametrize(
    ("u", "v"),
    [
        (MASKED, NORTH),
        (MASKED, np.ma.array(NORTH, mask=MASKED.mask)),
        (np.ma.array(EAST, mask=HOURS < 9), NORTH),
        (np.ma.array(EAST, mask=False), NORTH),
        (MASKED.astype("float32"), NORTH),
        (list(MASKED.filled(np.nan)), NORTH),
    ],
)
def test_masks_are_gaps(right, u, v):
    time = np.datetime64("2019-03-01") + (HOURS * 3600).astype("m8[s]")
    fit = fit_tides(time, u, v, 41.3, ["M2"])
    assert is_right((fit.constituents[0].east, fit.constituents[0].east_phase), right)


def test_masked_times_are_refused():
    time = np.ma.array(
        np.datetime64("2019-03-01") + (HOURS * 3600).astype("m8[s]"), mask=HOURS == 3
    )
    with pytest.raises(ClptError, match="time = NaT"):
        fit_tides(time, EAST, NORTH, 41.3, ["M2"])
