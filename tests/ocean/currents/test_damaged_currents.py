"""Damaged files of currents: each is refused by a sentence, or read as the undamaged file is.

The current is an M2 tide, the same everywhere, so that amplitude and phase of a read file have one
right value.  A damage that changes them without an error is a silent one.
"""

import numpy as np
import pytest
from gridded_currents import gridded_current

from clpt_control import ClptError
from clpt_control.currents import read_currents

HOURS = np.arange(72.0)
LAT, LON = np.linspace(41.0, 41.6, 4), np.linspace(-70.0, -69.4, 4)
ANGLE = 2 * np.pi * HOURS / 12.4206012
EAST, NORTH = 0.1 + 0.4 * np.cos(ANGLE - 1.0), 0.2 * np.cos(ANGLE - 2.0) - 0.05
GAP = np.arange(4, 72, 9)
START = np.datetime64("2019-03-01")
RIGHT = 0.4, np.degrees(1.0)  # amplitude, m/s, and phase to the east


def current(east=EAST, north=NORTH, hours=HOURS):
    """Return the tide on a grid."""
    u, v = (w[:, None, None] * np.ones((4, 4)) for w in (east, north))
    return gridded_current(u, v, LAT, LON, hours, since="2019-03-01")


def read(path):
    """Return amplitude and phase of M2 to the east in a file, or None where it is refused."""
    try:
        found = read_currents(path)
    except ClptError:
        return None
    since_start = (np.datetime64(found.start) - START) / np.timedelta64(1, "h")
    angle = 2 * np.pi * (found.time + since_start) / 12.4206012
    functions = np.stack([np.ones(angle.size), np.cos(angle), np.sin(angle)], axis=1)
    east = found.u[:, 2, 2]
    measured = np.isfinite(east)
    _, c, s = np.linalg.lstsq(functions[measured], east[measured])[0]
    return np.hypot(c, s), np.degrees(np.arctan2(s, c))


def is_right(found):
    """Return whether a file was refused or read as the undamaged one, gaps aside."""
    return found is None or (
        found[0] == pytest.approx(RIGHT[0], rel=0.02) and abs(found[1] - RIGHT[1]) < 1.0
    )


def test_the_undamaged_file_is_right(tmp_path):
    current().to_netcdf(tmp_path / "c.nc")
    assert read(tmp_path / "c.nc") == pytest.approx(RIGHT)


def with_gaps(value):
    east = EAST.copy()
    east[GAP] = value
    return east


FILLS = [-999.9, -99.99, 9.0, -9.0, 9.899, 9.969e36, 1e20, -1e34, 32.767, -32.768]
FILLS += [5.0, -5.0, 7.5, 3.2767, -3.2768, -2.0, 99.99, np.inf]


@pytest.mark.parametrize("value", FILLS)
@pytest.mark.parametrize("kind", ["float64", "float32", "packed"])
def test_undeclared_fill_values_are_refused_or_gaps(tmp_path, value, kind):
    encoding = {"dtype": "float32" if kind == "float32" else "float64"}
    if kind == "packed":
        if not abs(value) < 32.0:
            return
        encoding = {"dtype": "int16", "scale_factor": 0.001, "_FillValue": -32768}
    path = tmp_path / "c.nc"
    current(with_gaps(value)).to_netcdf(path, encoding={"u": encoding, "v": encoding})
    assert is_right(read(path))


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
def test_values_outside_the_valid_range_are_gaps(tmp_path, attributes, packed):
    east = EAST.copy()
    east[GAP] = 5.0 + 0.1 * np.arange(GAP.size)  # no value twice
    data = current(east)
    data.u.attrs.update(attributes)
    scaled = {"dtype": "int16", "scale_factor": 0.001, "_FillValue": -32768}
    data.to_netcdf(tmp_path / "c.nc", encoding={"u": scaled} if packed else {})
    assert is_right(read(tmp_path / "c.nc"))


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
def test_means_are_dated_at_the_middle_of_their_bounds(tmp_path, change, middle, step):
    angle = ANGLE * step + 2 * np.pi * middle * step / 12.4206012
    data = current(
        0.1 + 0.4 * np.cos(angle - 1.0), 0.2 * np.cos(angle - 2.0), HOURS * step
    )
    change(data, step).to_netcdf(tmp_path / "c.nc")
    found = read(tmp_path / "c.nc")
    assert found is not None
    assert is_right(found)


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
def test_damaged_times_are_refused_or_right(tmp_path, change):
    change(current()).to_netcdf(tmp_path / "c.nc")
    found = read(tmp_path / "c.nc")
    assert is_right(found)


def test_a_velocity_on_a_time_of_its_own_is_read(tmp_path):
    renamed_time(current()).to_netcdf(tmp_path / "c.nc")
    assert read(tmp_path / "c.nc") == pytest.approx(RIGHT)


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
