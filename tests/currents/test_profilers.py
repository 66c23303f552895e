"""Records of a profiler, and tides that steps are too long for."""

import numpy as np
import pytest
import xarray
from made_fields import gridded_current

from clpt_control.currents.current_record import read_record
from clpt_control.currents.fit import fit_scenario
from clpt_control.currents.telling_apart import nyquist
from clpt_control.currents.tidal_fit import fit_tides
from clpt_control.errors import DataError

MS = {"units": "m/s"}


def profiler(system="earth", **attrs):
    """A made file as of dolfyn: three ranges, the last mostly empty; 0.4 to the east, 0.2 north."""
    hours = np.arange(0.0, 360.0, 0.5)
    vel = np.zeros((4, 3, hours.size))
    vel[0] = [[0.3], [0.5], [9.0]]
    vel[1] = 0.2
    vel[:, 2, 10:] = np.nan
    wave = np.cos(np.radians(28.9841042) * hours)
    vel[0, :2] += 0.1 * wave
    return xarray.Dataset(
        {"vel": (("dir", "range", "time"), vel, MS)},
        {
            "dir": [*("ENU" if system == "earth" else "XYZ"), "err"],
            "range": [1.0, 2.0, 3.0],
            "time": ("time", 1.55e9 + 3600 * hours, {"units": "seconds since 1970-01-01"}),
        },
        {"coord_sys": system, "latitude": 41.0, **attrs},
    )


def test_a_profilers_file_is_a_record(tmp_path):
    profiler(declination=-14.0).to_netcdf(tmp_path / "adcp.nc")
    record = read_record(tmp_path / "adcp.nc")
    assert record.u.mean() == pytest.approx(0.4, abs=0.01)
    assert record.v == pytest.approx(0.2)
    assert record.latitude == 41.0
    profiler().to_netcdf(tmp_path / "magnetic.nc")
    with pytest.raises(DataError, match="set_declination"):
        read_record(tmp_path / "magnetic.nc")
    profiler("inst", declination=0.0).to_netcdf(tmp_path / "inst.nc")
    with pytest.raises(DataError, match=r"of 'inst'; dolfyn.rotate2 turns it to earth"):
        read_record(tmp_path / "inst.nc")


def test_speed_and_direction_are_read_as_east_and_north(tmp_path):
    path = tmp_path / "adcp.txt"
    rows = "".join(f"2019-01-01T0{k}:00:00Z,{100 + k},{90 * k}\n" for k in range(4))
    path.write_text("# latitude: 41.2\ntime,speed (cm/s),direction (deg)\n" + rows)
    record = read_record(path)
    assert record.u == pytest.approx([0.0, 1.01, 0.0, -1.03])
    assert record.v == pytest.approx([1.0, 0.0, -1.02, 0.0], abs=1e-12)
    path.write_text("# latitude: 41.2\ntime,speed,direction\n" + rows)
    with pytest.raises(DataError, match="speed has no units"):
        read_record(path)
    assert read_record(path, units="cm/s").u[1] == pytest.approx(1.01)
    path.write_text("# latitude: 41.2\ntime,speed (cm/s)\n2019-01-01,3\n")
    with pytest.raises(DataError, match="no column direction"):
        read_record(path)


@pytest.mark.parametrize(("step", "auto"), [(1.0, True), (3.0, True), (8.0, False)])
def test_no_tide_above_the_nyquist_frequency(step, auto):
    utide = pytest.importorskip("utide")
    hours = np.arange(0.0, 1440.0, step)
    time = np.datetime64("2019-01-01") + (3600 * hours).astype("timedelta64[s]")
    wave = np.cos(np.radians(15.0410686) * hours)
    found = fit_tides(time, wave, 0.5 * wave, 41.0, "auto").constituents
    fastest = max(utide.cycles_per_hour[tide.name] for tide in found)
    assert fastest < 0.5 / step
    for name, refused in (("M2", 2 * step > 12.42), ("M4", 2 * step > 6.21)):
        if refused:
            with pytest.raises(DataError, match=f"see no tide of {2 * step:g} h or faster.*{name}"):
                fit_tides(time, wave, 0.5 * wave, 41.0, ["K1", name])
        else:
            fit_tides(time, wave, 0.5 * wave, 41.0, ["K1", name])
    rng = np.random.default_rng(1)
    assert nyquist(np.sort(rng.uniform(0, 100, 50))) == np.inf
    kept = np.sort(rng.choice(hours.size, hours.size * 3 // 4, replace=False))
    assert nyquist(hours[kept]) == pytest.approx(0.5 / step)


def test_a_fit_of_a_grid_refuses_a_tide_that_its_steps_miss(tmp_path):
    hours, place = np.arange(0.0, 240.0, 8.0), np.linspace(41.0, 41.3, 4)
    wave = 0.3 * np.cos(2 * np.pi * hours / 12.42)[:, None, None] * np.ones((4, 4))
    gridded_current(wave, wave, place, place, hours).to_netcdf(tmp_path / "slow.nc")
    with pytest.raises(DataError, match="steps of 8 h see no tide of 16 h or faster"):
        fit_scenario(tmp_path / "slow.nc", rows=1, columns=1, radius_km=1.0)
