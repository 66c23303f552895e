"""Flow models that carry a glider: closed forms, fitted bases, refusals, the replay."""

import math
from dataclasses import replace

import netCDF4
import numpy as np
import pytest
from made_fields import saying
from synthetic_forecast import (
    HOURS,
    LAT,
    LON,
    Made,
    W,
    dive_at,
    ended,
    model_way,
    turned,
    turning,
    write,
)

from clpt_control.currents.fit import fit_scenario, save_fit
from clpt_control.errors import DataError
from clpt_control.replay.carried_dives import carried
from clpt_control.replay.flow_models import read_flow_model


def test_solid_rotation():
    """Z' = v + omega J z: z(T) = (v_x sin + v_y (cos - 1), v_x (1 - cos) + v_y sin) / omega."""
    dive, w = dive_at(), 1e-4
    v = np.array([dive.dr_east, dive.dr_north]) / dive.duration
    s, c = math.sin(w * dive.duration), math.cos(w * dive.duration)
    end = np.array([v[0] * s + v[1] * (c - 1), v[0] * (1 - c) + v[1] * s]) / w
    way = model_way(dive, Made(lambda t, x, y: (-w * y, w * x)))
    assert way == pytest.approx(end - (dive.dr_east, dive.dr_north), abs=0.01)


def test_linear_shear_and_tide():
    dive, k = dive_at(), 2e-5
    T = dive.duration
    # x' = v_x + k y, y = v_y t: the flow adds k v_y T^2 / 2
    assert model_way(dive, Made(lambda t, x, y: (k * y, 0.0))) == pytest.approx(
        (k * dive.dr_north * T / 2, 0.0), abs=1e-6
    )
    tide = Made(lambda t, x, y: (0.5 * math.cos(W * t), 0.5 * math.sin(W * t)))
    assert model_way(dive, tide) == pytest.approx(
        0.5 / W * np.array([math.sin(W * T), 1 - math.cos(W * T)]), abs=0.01
    )


def test_the_track_is_followed():
    """All the way east in the first half, at rest in the second; the flow grows eastward."""
    T, way, k = 21600.0, 5000.0, 1e-5
    track = (np.array([0, T / 2, T]), np.array([0, way, way]), np.zeros(3))
    dive = dive_at(way=(way, 0.0), track=track)
    # x' = v + k x, then x' = k x: x(T) = (v / k) (e^(kT/2) - 1) e^(kT/2)
    grown = math.exp(k * T / 2)
    end = 2 * way / T / k * (grown - 1) * grown
    model = Made(lambda t, x, y: (k * x, 0.0))
    assert model_way(dive, model)[0] == pytest.approx(end - way, abs=0.05)
    straight = model_way(replace(dive, track=None), model)[0]
    assert straight == pytest.approx(way / T / k * (math.exp(k * T) - 1) - way, abs=0.01)


def test_the_end_fix_is_not_read(tmp_path):
    model = read_flow_model(write(tmp_path / "t.nc", *turning(HOURS, (len(LAT), len(LON)))))
    blind = dive_at()
    seen = model_way(ended(blind, 900.0, -700.0), model)
    assert np.array_equal(model_way(blind, model), seen)


def known_fit(folder):
    """The fit of a steady current and an M2 tide that are known, 0.2 east and 0.3 turning."""
    u, v = turning(HOURS[::4], (len(LAT), len(LON)))
    path = write(folder / "known.nc", u + 0.2, v, hours=HOURS[::4])
    fit = fit_scenario(path, rows=4, columns=4, width_km=60.0, radius_km=5.0)
    save_fit(fit, folder / "fit.toml")
    return fit


def test_a_fitted_basis(tmp_path):
    """As far from the known flow as the fit's own residual, and turned to east and north."""
    fit = known_fit(tmp_path)
    model = read_flow_model(tmp_path / "fit.toml")
    assert model.about.startswith("fitted basis of 48 functions")
    assert repr(model) == f"<Fitted fit.toml: {model.about}>"
    for hour, place in ((3.0, (41.0, -69.3)), (20.0, (41.2, -68.9))):
        dive = dive_at(hour, lat=place[0], lon=place[1])
        expected = turned(dive) + np.array([0.2 * dive.duration, 0.0])
        most = fit.report["residual_max"] / 3.6 * dive.duration
        assert most < 500  # m, of some 5 km
        assert np.hypot(*(model_way(dive, model) - expected)) < most
    assert "outside the fit's area" in carried(dive_at(lat=39.0), model).uncovered


def test_files_that_are_no_flow_model(tmp_path):
    known_fit(tmp_path)
    full = tuple(turning(HOURS, (len(LAT), len(LON))))
    text = (tmp_path / "fit.toml").read_text()
    (tmp_path / "bare.toml").write_text(text)
    with netCDF4.Dataset(tmp_path / "fit_field.nc", "a") as file:
        report = file.fit_report
        file.fit_report = "{}"
    (tmp_path / "model.csv").write_text("u,v\n")
    write(tmp_path / "days.nc", *full, change=saying("time", calendar="360_day"))
    deep = np.zeros((2, 3, len(LAT), len(LON)))
    write(tmp_path / "deep.nc", deep, deep, hours=HOURS[:2], depth=[0.0, 1.0, 1.0])
    levels = {"depth": [0.0, 0.5, 1.0], "change": saying("depth", units="1")}
    write(tmp_path / "sigma.nc", deep, deep, hours=HOURS[:2], **levels)
    write(tmp_path / "fast.nc", full[0] + 40, full[1])
    for name, says in (
        ("model.csv", "is no flow model"),
        ("none.nc", "no such file"),
        ("fit_field.nc", "give the .toml file"),
        ("bare.toml", "is no fit with its field"),
        ("days.nc", "calendar '360_day'"),
        ("deep.nc", "each once"),
        ("sigma.nc", "depth has units '1'"),
        ("fast.nc", "check its units"),
    ):
        with pytest.raises(DataError, match=says):
            read_flow_model(tmp_path / name)
    with netCDF4.Dataset(tmp_path / "fit_field.nc", "a") as file:
        file.fit_report = report.replace('"theta": [[', '"theta": [[0.0, ', 1)
    with pytest.raises(DataError, match="write both anew"):
        read_flow_model(tmp_path / "fit.toml")
