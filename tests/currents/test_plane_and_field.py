"""Local plane, gaps that are filled, and the field block."""

import numpy as np
import pytest
from pyproj import Geod
from scipy.interpolate import make_interp_spline
from test_currents import LAT, LON

from clpt_control.blocks.field import gridded_flow
from clpt_control.currents.plane import (
    GriddedField,
    LocalPlane,
    field_dataset,
    fill_gaps,
    read_field,
    regular_grid,
)
from clpt_control.equations import evaluate
from clpt_control.errors import DataError
from clpt_control.files import write_file
from clpt_control.scenario.tables import Units


def test_plane_both_ways_and_true_distances():
    plane = LocalPlane(41.225, -69.45)
    rng = np.random.default_rng(1)
    lat, lon = 41.225 + rng.uniform(-0.5, 0.5, 50), -69.45 + rng.uniform(-0.5, 0.5, 50)
    x1, x2 = plane.to_plane(lat, lon)
    back = plane.to_earth(x1, x2)
    np.testing.assert_allclose(back[0], lat, atol=1e-9)
    np.testing.assert_allclose(back[1], lon, atol=1e-9)
    _, _, metres = Geod(ellps="WGS84").inv(np.full(50, -69.45), np.full(50, 41.225), lon, lat)
    np.testing.assert_allclose(np.hypot(x1, x2), metres / 1000, rtol=1e-9)
    with pytest.raises(DataError, match="choose a smaller box"):
        plane.to_plane(60.0, -69.0)
    with pytest.raises(DataError, match="km from the origin"):
        plane.to_plane(np.nan, -69.0)
    with pytest.raises(DataError, match="latitude"):
        LocalPlane(91.0, 0.0)


def test_velocities_turn_as_displacements_do():
    plane, geod = LocalPlane(41.225, -69.45), Geod(ellps="WGS84")
    for lat, lon in ((41.5, -69.0), (40.9, -69.9), (41.2, -68.0)):
        for bearing in (0.0, 35.0, 90.0, 200.0):
            lon1, lat1, _ = geod.fwd(lon, lat, bearing, 1.0)  # one metre further
            here, there = plane.to_plane(lat, lon), plane.to_plane(lat1, lon1)
            moved = 1000 * (np.array(there) - np.array(here))
            u, v = np.sin(np.radians(bearing)), np.cos(np.radians(bearing))
            np.testing.assert_allclose(plane.rotate(lat, lon, u, v), moved, atol=2e-4)
    leaning = plane.rotate(41.5, -69.0, 0.0, 1.0)[0]
    assert 0.004 < abs(leaning) < 0.007  # 0.3 degrees: what is forgotten without turning


def test_filling_keeps_measured_values_and_their_range():
    rng = np.random.default_rng(3)
    u, v = rng.normal(size=(2, 8, 6, 7))
    gap = rng.random(u.shape) < 0.4
    gap[:, :2, :2] = True  # a corner that was never seen
    u[gap] = np.nan
    *full, filled = fill_gaps(np.arange(8.0), np.arange(6.0) * 6, np.arange(7.0) * 5, u, v)
    np.testing.assert_array_equal(full[0][~gap], u[~gap])
    np.testing.assert_array_equal(full[1][~gap], v[~gap])
    assert np.all(np.isfinite(full))
    assert np.nanmin(u) <= full[0].min()
    assert full[0].max() <= np.nanmax(u)
    np.testing.assert_array_equal(filled, gap)


def interior(shape):
    gap = np.zeros(shape, bool)
    gap[1:-1, 1:-1, 1:-1] = True
    return gap


def test_filling_solves_the_laplace_equation():
    """Quadratics that are harmonic in (10 km/h t, x2, x1) come back from their edges alone."""
    axes = 0.3 * np.arange(6.0), 4 * np.arange(5.0), 6 * np.arange(7.0)
    t, y, x = np.meshgrid(*axes, indexing="ij")
    u, v = 2 * (10 * t) ** 2 - x**2 - y**2, x * y + x**2 - y**2
    with_gap = [np.where(interior(u.shape), np.nan, w) for w in (u, v)]
    *full, _ = fill_gaps(*axes, *with_gap)
    np.testing.assert_allclose(full, [u, v], atol=1e-9)


def test_filling_on_uneven_axes_keeps_linear_flow():
    axes = np.array([0, 1, 3, 4, 7.0]), np.array([0, 5, 6, 9.0]), np.array([-3, 0, 1, 8, 9.0])
    t, y, x = np.meshgrid(*axes, indexing="ij")
    u, v = 1 + 2 * x - y + 0.3 * t, 5 - t
    with_gap = [np.where(interior(u.shape), np.nan, w) for w in (u, v)]
    *full, _ = fill_gaps(*axes, *with_gap)
    np.testing.assert_allclose(full, [u, v], atol=1e-10)


def test_field_of_a_plane_flow_is_that_flow():
    """A flow linear in plane and time comes out the same on the regular grid."""
    plane = LocalPlane(41.25, -69.5)
    x1, x2 = plane.to_plane(LAT[:, None], LON[None, :])
    uneven = np.array([0.0, 1.0, 2.5, 3.0, 4.5, 6.0])
    t = uneven[:, None, None]
    u, v = 1 + 0.02 * x1 - 0.03 * x2 + 0.1 * t, 0.01 * x2 + 0.001 * x1 * x2 - 0.2 * t
    field = regular_grid(uneven, LAT, LON, u, v, plane)
    np.testing.assert_allclose(field.time, np.linspace(0, 6, 6))
    T, Y, X = np.meshgrid(field.time, field.x2, field.x1, indexing="ij")
    np.testing.assert_allclose(field.u, 1 + 0.02 * X - 0.03 * Y + 0.1 * T, atol=1e-6)
    np.testing.assert_allclose(field.v, 0.01 * Y + 0.001 * X * Y - 0.2 * T, atol=1e-6)


def random_field():
    rng = np.random.default_rng(5)
    axes = np.linspace(0, 6, 7), np.linspace(-20, 20, 6), np.linspace(-30, 30, 8)
    return GriddedField(*axes, *rng.normal(size=(2, 7, 6, 8)))


@pytest.mark.parametrize("units", [Units(length="km", time="h"), Units(length="m", time="s")])
def test_field_file_read_back_equals_the_data_at_nodes(tmp_path, units):
    field = random_field()
    data = field_dataset(field, Units(length="km", time="h"), {"title": "test"})
    write_file(tmp_path / "f.nc", data)
    read = read_field(tmp_path / "f.nc", units)
    T, Y, X = np.meshgrid(read.time, read.x2, read.x1, indexing="ij")
    values = evaluate(gridded_flow(read), T.ravel(), np.column_stack([X.ravel(), Y.ravel()]))
    size = 1.0 if units.length == "km" else 1000.0 / 3600.0
    np.testing.assert_allclose(values[:, 0], size * field.u.ravel(), atol=1e-12)
    np.testing.assert_allclose(values[:, 1], size * field.v.ravel(), atol=1e-12)
    assert read.x1[-1] == pytest.approx(30.0 if units.length == "km" else 30000.0)


def test_field_block_equals_scipys_interpolating_spline():
    """Independent: B-splines by collocation, not-a-knot, axis after axis."""
    field = random_field()
    rng = np.random.default_rng(6)
    t, x2, x1 = rng.uniform(0, 6, 40), rng.uniform(-20, 20, 40), rng.uniform(-30, 30, 40)
    mine = evaluate(gridded_flow(field), t, np.column_stack([x1, x2]))
    for k in range(40):
        for component, values in enumerate((field.u, field.v)):
            for axis, at in ((field.time, t[k]), (field.x2, x2[k]), (field.x1, x1[k])):
                values = make_interp_spline(axis, values, k=3)(at)
            assert mine[k, component] == pytest.approx(float(values), abs=1e-10)
