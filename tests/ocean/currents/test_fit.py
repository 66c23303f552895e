"""A scenario from a measured current: known theta, files, and the field of Nantucket Shoals."""

import json
import os

import netCDF4
import numpy as np
import pytest
from gridded_currents import gridded_current
from pyproj import Proj
from refusals import refuses

import clpt_control as clpt
from clpt_control import ArgumentError, ClptError, DataError, ScenarioError
from clpt_control.currents import (
    explained_variance,
    fit_current,
    flow_velocity,
    read_currents,
    sample_currents,
)

MARACOOS = sample_currents()
BOX = (40.9, 41.55, -69.9, -69.0)
SPEED = 28.9841042  # M2, degrees per hour
LAT, LON, TIME = (
    np.linspace(40.9, 41.55, 13),
    np.linspace(-69.9, -69.0, 14),
    np.arange(25.0),
)


PLANE = Proj(proj="aeqd", ellps="WGS84", lat_0=41.225, lon_0=-69.45)
OMEGA = np.radians(SPEED)


def known_flow(places, width, theta):
    """East and north flow, m/s, of known theta; the formulas written out here."""
    lat, lon = np.meshgrid(LAT, LON, indexing="ij")
    x1, x2 = (w / 1000 for w in PLANE(lon, lat))
    east = np.array(PLANE(lon + 1e-5, lat)) - np.array(PLANE(lon - 1e-5, lat))
    east /= np.hypot(*east)
    kernels = [
        np.exp(-((x1 - x) ** 2 + (x2 - y) ** 2) / (2 * width**2)) for x, y in places
    ]
    tides = [np.ones(25), np.cos(OMEGA * TIME), np.sin(OMEGA * TIME)]
    phi = np.array(
        [tide[:, None, None] * kernel for tide in tides for kernel in kernels]
    )
    f1, f2 = np.tensordot(theta, phi, axes=1) / 3.6
    return east[0] * f1 + east[1] * f2, -east[1] * f1 + east[0] * f2


def write(path, u, v, time=TIME):
    data = gridded_current(u, v, LAT, LON, time, since="2020-06-01", units="m s-1")
    data.to_netcdf(path)
    return path


@pytest.fixture(scope="module")
def known(tmp_path_factory):
    """A file of known theta on 2 x 2 places with gaps: file, theta, gaps."""
    x1 = np.array([PLANE(lon, 41.225)[0] / 1000 for lon in (-69.9, -69.0)])
    x2 = np.array([PLANE(-69.45, lat)[1] / 1000 for lat in (40.9, 41.55)])
    # one and three quarters of the way across, to the metre
    columns, rows = (
        np.round(w[0] + np.ptp(w) * np.array([0.25, 0.75]), 3) for w in (x1, x2)
    )
    places = [(x, y) for y in rows for x in columns]
    rng = np.random.default_rng(12)
    theta = rng.normal(size=(2, 12))
    u, v = known_flow(places, 20.0, theta)
    gap = rng.random(u.shape) < 0.3
    u[gap] = np.nan
    return write(tmp_path_factory.mktemp("known") / "c.nc", u, v), theta, gap


@pytest.fixture(scope="module")
def fit(known):
    return fit_current(known[0], BOX, rows=2, columns=2, width_km=20.0)


def test_known_theta_is_recovered(known, fit):
    _, theta, gap = known
    np.testing.assert_allclose(fit.report["theta"], theta, atol=1e-6)
    assert fit.report["explained_variance"] == pytest.approx(1, abs=1e-10)
    assert fit.report["missing_fraction"] == pytest.approx(gap.mean())
    assert fit.report["samples"] == (~gap).sum()


def test_width_and_radius_follow_the_box(known, tmp_path):
    """The kernels are as wide as their places are apart, times 0.6; the track follows the field."""
    small = fit_current(known[0], BOX)
    assert (small.report["width"], small.report["track_radius"]) == (15.0, 12.0)
    assert small.report["functions_felt_on_the_track"] == 27
    half = fit_current(known[0], (41.05, 41.4, -69.7, -69.2))
    assert half.report["width"] == pytest.approx(
        15 * np.sqrt(0.35 * 0.5 / (0.65 * 0.9)), rel=0.03
    )
    assert half.report["track_radius"] < 0.6 * small.report["track_radius"]
    narrow = fit_current(known[0], BOX, width_km=6.0, radius_km=1.0)
    assert narrow.report["functions_felt_on_the_track"] == 3
    narrow.save(tmp_path / "fit.toml")
    assert (
        "# functions wide enough to reach the track: 3\n"
        in (tmp_path / "fit.toml").read_text()
    )


def test_the_share_explained_is_about_the_mean(known, tmp_path):
    """A steady flow of 5 m/s more changes nothing that varies; about zero the share goes to 1."""
    with netCDF4.Dataset(known[0]) as file:
        u, v = file["u"][:].filled(np.nan), file["v"][:].filled(np.nan)
    shares = []
    for more in (0.0, 5.0):
        path = write(tmp_path / "more.nc", u + more, v)
        found = fit_current(path, BOX, rows=1, columns=1, width_km=3000.0)
        shares.append(found.report["explained_variance"])
    assert shares[0] == pytest.approx(shares[1], abs=0.02)
    assert shares[0] < 0.6


@pytest.mark.long
def test_a_fit_worse_than_the_mean_current_says_so(clpt, tmp_path):
    """A current that is strong beside its tide, by narrow functions, then by wide ones."""
    tide = 0.1 * np.cos(OMEGA * TIME)[:, None, None] * np.ones((LAT.size, LON.size))
    path = write(tmp_path / "strong.nc", 1.0 + tide, 0.5 + tide)
    for width, told in ((15, True), (60, False)):
        _, out, _ = clpt("fit", path, "--out", tmp_path / "s.toml", "--width-km", width)
        assert ("worse than the mean current" in out) is told


@pytest.mark.long
@pytest.mark.usefixtures("undrawn")
def test_a_uniform_current_has_no_share_and_says_so(clpt, printed, known, tmp_path):
    """On the plane it turns by 0.2 %: no variance that anybody asks about."""
    u, scenario, run = (
        np.full(known[2].shape, 0.5),
        tmp_path / "s.toml",
        tmp_path / "run.nc",
    )
    uniform = write(tmp_path / "c.nc", u, 0.4 * u)
    assert printed("fit", uniform, "--out", scenario)["explained_variance"] is None
    assert "# explained variance: None" in scenario.read_text()
    _, out, _ = clpt("run", scenario, "--out", run)
    assert out.count("none: the current hardly changes") == 2
    shares = printed("run", scenario, "--out", run)["explained_variance"]
    assert shares["track"] is shares["box"] is None
    clpt("report", run, "-o", tmp_path / "run.html")
    page = (tmp_path / "run.html").read_text()
    assert page.count("the current hardly changes") == 2


def test_steps_without_any_measurement_do_not_lengthen_a_record(tmp_path):
    u, v = np.random.default_rng(3).normal(size=(2, 25, 13, 14))
    u[12:] = np.nan
    path, said = (
        write(tmp_path / "c.nc", u, v),
        r"in 11 h, these .*cannot be distinguished: steady and M2 \(12.43 h",
    )
    refuses(said, fit_current, path, BOX, rows=1, columns=1, width_km=30.0)


def test_steps_that_are_missing_are_gaps_and_nothing_overshoots(tmp_path):
    """A tide of 0.5 m/s, with a hole of ten hours, by steps of nothing and without them."""
    rows = np.array([*range(20), *range(30, 61)])
    tide = 0.5 * np.cos(OMEGA * np.arange(61.0))[:, None, None] + np.zeros((13, 14))
    hole = tide.copy()
    hole[20:30] = np.nan

    def fitted(u, hours):
        path = write(tmp_path / "c.nc", u, u, hours.astype(float))
        return fit_current(path, rows=2, columns=2)

    whole, without = fitted(hole, np.arange(61)), fitted(tide[rows], rows)
    for name in ("time", "u", "v"):
        np.testing.assert_array_equal(
            getattr(without.field, name), getattr(whole.field, name)
        )
    assert without.report == whole.report
    assert np.hypot(without.field.u, without.field.v).max() <= 3.6 * np.hypot(
        0.5, 0.5
    ) * (1 + 1e-6)
    assert without.report["missing_fraction"] == pytest.approx(10 / 61)
    refuses(
        "99 steps are missing, most behind 19 h",
        fitted,
        tide[rows],
        rows + 89 * (rows > 25),
    )


def test_a_field_is_written_beside_its_scenario_or_neither(fit, tmp_path):
    (tmp_path / "taken_field.nc").mkdir()
    refuses("taken_field.nc: is a folder", fit.save, tmp_path / "taken.toml")
    assert [one.name for one in tmp_path.iterdir()] == ["taken_field.nc"]


@pytest.mark.long
def test_saved_scenario_and_field_belong_together(fit, tmp_path):
    scenario = fit.save(tmp_path / "north.toml")
    assert sorted(p.name for p in tmp_path.iterdir()) == [
        "north.toml",
        "north_field.nc",
    ]
    assert (scenario.flow.field, scenario.learning.parameters) == (
        "north_field.nc",
        None,
    )
    assert scenario.learning.gain == 5.0
    assert scenario.vehicle.position == scenario.learning.position == (12.0, 0.0)
    assert scenario.run.duration == 24.0
    moved = tmp_path / "elsewhere"
    moved.mkdir()
    for name in ("north.toml", "north_field.nc"):
        (tmp_path / name).rename(moved / name)
    assert (
        clpt.load_scenario(moved / "north.toml").model_dump() == scenario.model_dump()
    )
    text = (moved / "north.toml").read_text()
    assert "# missing fraction: 0.30" in text
    assert 'law = "composite-least-squares"\n# law = "learned-flow"' in text
    assert str(tmp_path) not in text
    with netCDF4.Dataset(moved / "north_field.nc") as file:
        assert json.loads(file.fit_report) == fit.report
        assert file.time_origin == "2020-06-01T00:00:00"
    short = clpt.load_scenario(moved / "north.toml").with_values({"run.duration": 0.2})
    np.testing.assert_allclose(clpt.simulate(short).clpe[0], 0)


@pytest.mark.skipif(os.name != "posix", reason="names of files hold any bytes there")
@pytest.mark.parametrize("name", ["a\nb\x1b[2J.nc", "\udcff\u202eb.nc"])
def test_a_scenario_of_a_file_with_any_name_is_read_back(known, tmp_path, name):
    (tmp_path / name).write_bytes(known[0].read_bytes())
    fit = fit_current(tmp_path / name, BOX, rows=2, columns=2, width_km=20.0)
    shown = ascii(name)[1:-1]
    scenario = fit.save(tmp_path / "north.toml")
    assert scenario.title == f"Measured current of {shown} from 2020-06-01T00:00:00"
    assert shown in (tmp_path / "north.toml").read_text()


def test_each_mistake_is_one_sentence(known):
    for options, error, sentence in (
        ({"rows": 0}, ArgumentError, "rows = 0: must be a whole number, 1 or more"),
        (
            {"width_km": -1.0},
            ArgumentError,
            "width_km = -1.0: must be a number, positive",
        ),
        (
            {"width_km": 1e4},
            DataError,
            "cannot separate the basis functions .* another width",
        ),
        ({"constituents": ()}, DataError, "must be names, each once"),
        ({"constituents": ("M9",)}, ScenarioError, "unknown constituent 'M9'"),
        ({"rows": 50, "columns": 40}, DataError, "samples for 6000 functions"),
        ({"radius_km": 60.0}, DataError, "circle of 60 km leaves the field"),
    ):
        refuses(sentence, fit_current, known[0], BOX, error=error, **options)


@pytest.mark.long
def test_fit_and_run_say_what_the_track_does_not_teach(clpt, printed, known, tmp_path):
    """Of what `clpt excitation` names, in one sentence; nothing where all can be learned."""
    scenario = tmp_path / "s.toml"
    words = (known[0], "--out", scenario, "--width-km", "6")
    said = printed("fit", *words)["not_learnable"]
    assert said.startswith("parameters that this run cannot tell apart")
    _, out, _ = clpt("fit", *words)
    assert "along x2): theta_1[1]" in out
    of_run = printed("run", scenario, "--out", tmp_path / "run.nc")["not_learnable"]
    learned = printed("excitation", tmp_path / "run.nc")["dimension"]
    assert all(f"{n} of 29 along {axis}" in of_run for axis, n in learned.items())
    assert min(learned.values()) < 29
    assert printed("fit", *words[:3], "--constituents", "steady")["not_learnable"] == ""


def test_shares_are_what_their_definition_says(fit, tmp_path):
    """Written out here: theta_hat of each time on the track, of the end over the box."""
    scenario = fit.save(tmp_path / "a.toml")
    scenario = scenario.with_values({"run.duration": 4.0, "run.output_step": 0.25})
    run = clpt.simulate(scenario)
    centers = np.array(scenario.basis.centers[:4])

    def phi(t, x1, x2):
        d2 = (x1[..., None] - centers[:, 0]) ** 2 + (x2[..., None] - centers[:, 1]) ** 2
        kernel = np.exp(-d2 / 800.0)
        cos, sin = (f(OMEGA * np.asarray(t))[..., None] for f in (np.cos, np.sin))
        return np.concatenate([kernel, kernel * cos, kernel * sin], axis=-1)

    def share(truth, learned):
        mean = truth.reshape(-1, 2).mean(axis=0)
        return 1 - np.sum((truth - learned) ** 2) / np.sum((truth - mean) ** 2)

    theta = -run.alpha.values
    late = run.time.values >= 3.0
    x = run.position.values[late]
    learned = np.einsum("tan,tn->ta", theta[late], phi(run.time.values[late], *x.T))
    shares = explained_variance(scenario, run)
    assert shares["window"] == [3.0, 4.0]
    refuses("has no sample", explained_variance, scenario, run, window=(7.0, 8.0))
    refuses(
        "basis functions", explained_variance, scenario, run.isel(basis=slice(0, 3))
    )
    refuses(
        "shares of variance are for scenarios with flow.field",
        explained_variance,
        clpt.paper_scenario(),
        run,
    )
    track = share(run.true_flow.values[late], learned)
    assert shares["track"] == pytest.approx(track, rel=1e-9)
    with netCDF4.Dataset(scenario.field_path) as file:
        t, x2, x1, u, v = (
            np.asarray(file[name][:]) for name in ("time", "y", "x", "u", "v")
        )
    t, x2, x1 = np.meshgrid(t, x2, x1, indexing="ij")
    box = share(np.stack([u, v], axis=-1), phi(t, x1, x2) @ theta[-1].T)
    assert shares["box"] == pytest.approx(box, rel=1e-9)


@pytest.fixture(scope="module")
def nantucket(tmp_path_factory):
    fit = fit_current(MARACOOS, BOX)
    return fit, fit.save(tmp_path_factory.mktemp("nantucket") / "s.toml")


def test_nantucket_fit(nantucket):
    fit, scenario = nantucket
    report = fit.report
    assert report["functions"] == scenario.basis.N == 27
    assert 0.75 <= report["explained_variance"] <= 0.85
    assert report["missing_fraction"] == pytest.approx(0.28, abs=0.005)
    assert report["origin"] == [41.225, -69.45]
    assert report["condition_number"] < 20
    assert report["residual_rms"] < report["residual_max"] < 3.0
    assert json.loads(json.dumps(report)) == report
    far = scenario.with_values({"reference.radius": 60.0})
    refuses("left the field", clpt.simulate, far, error=ClptError)


def test_nantucket_field_is_close_to_what_was_measured(nantucket):
    """The spline field at the measured cells: half a cell of resampling costs little."""
    currents = read_currents(MARACOOS, BOX)
    lon, lat = np.meshgrid(currents.lon, currents.lat)
    x1, x2 = np.divide(PLANE(lon, lat), 1000)
    turned = np.subtract(PLANE(lon, lat + 1e-5), PLANE(lon, lat))  # north, in the plane
    east, north = turned / np.hypot(*turned)
    u = currents.u * north + currents.v * east
    v = currents.v * north - currents.u * east
    g, scenario = nantucket[0].field, nantucket[1]
    inside = (x1 >= g.x1[0]) & (x1 <= g.x1[-1]) & (x2 >= g.x2[0]) & (x2 <= g.x2[-1])
    kept = currents.measured & inside
    t, y1, y2 = (
        np.broadcast_to(w, u.shape)[kept]
        for w in (currents.time[:, None, None], x1, x2)
    )
    field = flow_velocity(scenario, np.column_stack([y1, y2]), t) / 3.6
    error = np.hypot(field[:, 0] - u[kept], field[:, 1] - v[kept])
    assert np.sqrt(np.mean(error**2)) < 0.02  # m/s, of 0.51
