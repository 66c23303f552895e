"""Replay of a glider: SG542's figures, causality, synthetic vehicles, anomalies."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import trapezoid

from clpt_control.errors import DataError, ScenarioError
from clpt_control.estimation.between_fixes import ESTIMATORS, make_estimator
from clpt_control.estimation.fix_model import FixModel, inertial_frequency, mid_time
from clpt_control.ocean.anomaly import SpeedWatch
from clpt_control.ocean.dive_table import sample_dives
from clpt_control.ocean.dives import Dive, usable
from clpt_control.ocean.replay import Replay, replay_dives
from clpt_control.ocean.replay_file import replay_dataset
from clpt_control.tides import period

STEADY = (0.1, -0.05)


def vehicle(seed, count=30, flow="steady", factor=1.0, fault=None, lost=0.15, walk=0.0, noise=0.0,
            hours=4.0, heading="any", fix=20.0, latitude=40.0):  # fmt: skip
    """A vehicle at 0.25 m/s; `fix` is the noise of a displacement, m per component."""
    rng = np.random.default_rng(seed)
    time, dives, current = 1.6e9, [], np.array(STEADY)
    phase = rng.uniform(0, 2 * math.pi)
    w = inertial_frequency(latitude) if flow == "inertial" else 2 * math.pi / period("M2", "s")
    for k in range(count):
        T = 3600 * hours * rng.uniform(0.8, 1.2)
        t = np.linspace(time + 600, time + 600 + T, 101)
        u = np.tile(current, (101, 1))
        if flow != "steady":
            turn = (-1 if flow == "inertial" else 0.5) * np.sin(w * t + phase)
            u = u + 0.15 * np.stack([np.cos(w * t + phase), turn], 1)
        angle = rng.uniform(0, 2 * math.pi) if heading == "any" else 0.6 + 0.1 * rng.normal()
        dr = 0.25 * T * np.array([math.cos(angle), math.sin(angle)])
        f = factor * (1 - lost if fault is not None and k >= fault else 1)
        way = f * dr + trapezoid(u, t, axis=0) + fix * rng.normal(size=2)
        way = way + noise * T * rng.normal(size=2)
        current = current + walk * math.sqrt((T + 600) / 21600) * rng.normal(size=2)
        dives.append(Dive(k, t[0], latitude, 8.0, t[-1], latitude, 8.0, *way, *dr))
        time = t[-1]
    return dives


def ratio(dives, estimator="kalman", model=None):
    rms = replay_dives(dives, estimator, model).rms(3)
    return rms["adaptive"] / rms["previous_dive"]


@pytest.fixture(scope="module")
def sg542():
    return replay_dives(usable(sample_dives())[0])


def test_sg542_without_learning(sg542):
    # over all 14 dives, the first forecast without flow, and over the 13 after it
    assert sg542.rms(0)["no_flow"] == pytest.approx(1950, rel=0.005)
    assert sg542.rms(0)["previous_dive"] == pytest.approx(1407, rel=0.005)
    assert sg542.rms(1)["no_flow"] == pytest.approx(1853, rel=0.02)
    assert sg542.rms(1)["previous_dive"] == pytest.approx(1213, rel=0.03)
    assert sg542.summary()["dac_identity_median"] < 1e-3


def test_sg542_adaptive(sg542):
    rms = sg542.rms(3)
    assert rms["previous_dive"] == pytest.approx(1167, rel=0.01)
    assert rms["adaptive"] <= 0.88 * rms["previous_dive"]
    assert 0.75 <= sg542.summary()["inside_90"] <= 1
    assert sg542.summary()["anomalies"] == []


@pytest.mark.parametrize("estimator", ESTIMATORS)
def test_later_dives_change_nothing_earlier(estimator):
    dives = vehicle(3, 14)
    whole = replay_dives(dives, estimator)
    rng = np.random.default_rng(0)
    later = [replace(d, gps_east=d.gps_east + 1e4 * rng.normal()) for d in dives[7:]]
    changed = replay_dives([*dives[:7], *later], estimator)
    times = [(d.t_gps2, d.t_gpse) for d in dives[7:]]
    shuffled = [
        replace(d, t_gps2=t[0], t_gpse=t[1])
        for d, t in zip(rng.permutation(np.array(dives[7:], object)), times, strict=True)
    ]
    permuted = replay_dives([*dives[:7], *shuffled], estimator)
    for k in range(7):
        for other in (changed, permuted):
            assert np.array_equal(whole.steps[k].forecast, other.steps[k].forecast)
            assert np.array_equal(whole.steps[k].covariance, other.steps[k].covariance)


@pytest.mark.parametrize("estimator", ESTIMATORS)
def test_a_forecast_does_not_read_the_dives_end(estimator):
    *earlier, last = vehicle(4, 9)
    learner = make_estimator(estimator, FixModel())
    for dive in earlier:
        learner.update(dive)
    blind = replace(last, gps_east=math.nan, gps_north=math.nan, lat_gpse=math.nan)
    for seen, unseen in zip(learner.predict(last), learner.predict(blind), strict=True):
        assert np.array_equal(seen, unseen)


@pytest.mark.parametrize("estimator", ESTIMATORS)
def test_one_by_one_is_all_at_once(estimator):
    dives = vehicle(5, 12)
    single = Replay(estimator)
    for dive in dives:
        single.step(dive)
        single.forecast(dives[-1])
        single.summary()
    at_once = replay_dataset(replay_dives(dives, estimator))
    assert replay_dataset(single).identical(at_once)


def test_estimates_lie_within_three_standard_errors():
    """Current and speed factor, 200 vehicles: within three errors in 95 %."""
    inside = 0
    for seed in range(200):
        factor = 1 + 0.1 * np.random.default_rng(1000 + seed).normal()
        step = replay_dives(vehicle(seed, 16, factor=factor), model=FixModel(("steady",))).steps[-1]
        inside += bool(
            abs(step.speed - factor) < 3 * step.speed_error
            and np.all(np.abs(step.current - STEADY) < 3 * step.current_error)
        )
    assert inside >= 190


def test_learns_what_there_is():
    for flow in ("M2", "inertial"):
        assert ratio(vehicle(1, flow=flow)) < 0.3
    step = replay_dives(vehicle(2, 40, factor=0.9)).steps[-1]
    assert step.speed == pytest.approx(0.9, abs=0.01)
    assert "speed" in step.learned


@pytest.mark.parametrize(
    ("case", "most"),
    [
        ({"walk": 0.03}, 1.06),  # the previous dive's current is the best forecast there
        ({"walk": 0.1}, 1.06),
        ({"walk": 0.03, "heading": "one"}, 1.06),
        ({"noise": 0.05}, 0.85),
        ({"walk": 0.03, "noise": 0.05}, 0.95),
        ({"walk": 0.03, "factor": 0.85}, 0.9),
    ],
)
def test_against_the_previous_dives_current(case, most):
    ratios = [ratio(vehicle(seed, **case)) for seed in range(6)]
    assert np.sqrt(np.mean(np.square(ratios))) < most


@pytest.mark.parametrize("case", [{"walk": 0.03}, {"noise": 0.05}, {"flow": "M2"}])
def test_ellipses_hold_what_they_promise(case):
    inside = [replay_dives(vehicle(seed, **case)).summary()["inside_90"] for seed in range(6)]
    assert 0.83 < np.mean(inside) <= 1


def test_what_is_not_excited_is_held():
    dives = [replace(d, dr_east=600.0, dr_north=300.0) for d in vehicle(1, 6, fix=400.0)]
    last = replay_dives(dives).steps[-1]
    assert {"speed", "compass"} <= set(last.held)
    assert last.speed == pytest.approx(1, abs=0.02)
    assert "current_east" in last.learned


@pytest.mark.parametrize("case", [{}, {"noise": 0.01}, {"walk": 0.01}, {"flow": "M2"}])
def test_lost_speed_is_flagged(case):
    for seed in range(5):
        watch = SpeedWatch(FixModel())
        found = [a for a in map(watch.step, vehicle(seed, 24, fault=20, **case)) if a]
        assert found[0].dive in (20, 21, 22)
        assert found[0].change == pytest.approx(-0.15, abs=0.08)
        assert "evidence" in str(found[0])


@pytest.mark.parametrize("case", [{}, {"noise": 0.02}, {"walk": 0.03}, {"flow": "inertial"}])
def test_healthy_vehicles_are_left_alone(case):
    flags = 0
    for seed in range(4):
        watch = SpeedWatch(FixModel())
        flags += sum(watch.step(dive) is not None for dive in vehicle(50 + seed, 100, **case))
    assert flags <= 2  # in 400 dives


def test_the_coriolis_turn_is_right():
    model, dive = FixModel(("steady", "inertial"), False), vehicle(1, 1)[0]
    dt, w = 7200.0, inertial_frequency(dive.lat_gps2)
    east, north = model.turning(dt, dive.lat_gps2)[2:, 2:] @ [1.0, 0.0]
    assert (east, north) == pytest.approx((math.cos(w * dt), -math.sin(w * dt)))  # clockwise
    t = np.linspace(-dive.duration / 2, dive.duration / 2, 10001)
    whole = trapezoid(np.cos(w * t), t)
    assert model.regressor(dive)[0, 2] == pytest.approx(whole, rel=1e-6)


def test_the_tides_integral_is_right():
    model, dive = FixModel(("steady", "M2"), False), vehicle(1, 1)[0]
    w = 2 * math.pi / period("M2", "s")
    t = np.linspace(dive.t_gps2, dive.t_gpse, 10001)
    H = model.regressor(dive)
    assert H[0, 2] == pytest.approx(trapezoid(np.cos(w * t), t), rel=1e-5)
    assert H[1, 5] == pytest.approx(trapezoid(np.sin(w * t), t), rel=1e-5)
    assert mid_time(dive) == pytest.approx(t.mean())


def test_mistakes_are_sentences():
    with pytest.raises(ScenarioError, match="must begin with steady"):
        FixModel(("M2",))
    with pytest.raises(ScenarioError, match="unknown constituent"):
        FixModel(("steady", "X9"))
    with pytest.raises(ScenarioError, match="must be one of gradient, rls, kalman"):
        make_estimator("best", FixModel())
    dives, replay = vehicle(1, 2), Replay()
    replay.step(dives[1])
    with pytest.raises(DataError, match="ends before dive 1"):
        replay.step(dives[0])
    with pytest.raises(DataError, match="must be finite"):
        replay.step(replace(dives[1], t_gpse=2e9, gps_east=math.nan))


def test_the_dataset_is_a_cf_trajectory(sg542, tmp_path):
    import xarray

    from clpt_control.files import write_netcdf

    write_netcdf(replay_dataset(sg542, "SG542"), tmp_path / "replay.nc")
    with xarray.open_dataset(tmp_path / "replay.nc") as data:
        assert data.attrs["featureType"] == "trajectory"
        assert data.trajectory.attrs["cf_role"] == "trajectory_id"
        assert data.sizes["dive"] == 14
        assert str(data.time.values[0])[:10] == "2016-02-01"
        # a forecast's place is as far from the fix as its CLPE
        from pyproj import Geod

        far = Geod(ellps="WGS84").inv(
            data.forecast_longitude, data.forecast_latitude, data.longitude, data.latitude
        )[2]
        assert far == pytest.approx(data.clpe_adaptive.values, rel=2e-2, abs=5)


def one_file_each(folder, dives):
    from clpt_control.ocean.dive_table import write_dive_table

    for dive in dives:
        write_dive_table([dive], folder / f"dive{dive.number}.csv")


def test_following_a_folder_equals_reading_it(tmp_path):
    from clpt_control.ocean.follow import Follower

    dives = sample_dives()
    for k, dive in enumerate(dives):
        one_file_each(tmp_path, [dive])
        (tmp_path / "half.nc").write_bytes(b"CDF\x01" + bytes(k))
        follower = Follower(tmp_path, tmp_path / "state.json")  # begins anew, each time
        assert set(follower.look()) == {f"dive{dive.number}.csv", "half.nc"}
        assert follower.look() == []
        used = usable(follower.dives()[0])[0]
        assert [d.number for d in used] == [d.number for d in dives[: k + 1]]
    (tmp_path / "dive304.csv").unlink()
    again = Follower(tmp_path, tmp_path / "state.json")
    assert again.look() == []
    known, skipped = again.dives()
    assert len(skipped) == 1
    assert "half.nc" in skipped[0].why
    assert replay_dataset(replay_dives(usable(known)[0])).identical(
        replay_dataset(replay_dives(usable(dives)[0]))
    )


def test_a_killed_follower_loses_nothing(tmp_path):
    """Kill -9 at random moments; what a last run gives is what reading gives."""
    import subprocess
    import sys
    import time

    from clpt_control.ocean.follow import Follower

    inbox, state = tmp_path / "inbox", tmp_path / "state.json"
    inbox.mkdir()
    code = (
        "import sys, time\nfrom clpt_control.ocean.follow import Follower\n"
        "f = Follower(sys.argv[1], sys.argv[2])\nprint('up', flush=True)\n"
        "while True:\n    f.look()\n"
    )
    rng = np.random.default_rng(0)
    dives = sample_dives()
    for part in (dives[:3], dives[3:6], dives[6:10], dives[10:]):
        process = subprocess.Popen(
            [sys.executable, "-c", code, str(inbox), str(state)], stdout=subprocess.PIPE
        )
        process.stdout.readline()
        one_file_each(inbox, part)
        time.sleep(0.03 * rng.uniform())
        process.kill()
        process.wait()
        process.stdout.close()
    follower = Follower(inbox, state)
    follower.look()
    assert [d.number for d in usable(follower.dives()[0])[0]] == [d.number for d in dives]
    assert follower.dives()[1] == []


def test_a_strange_state_is_refused(tmp_path):
    from clpt_control.ocean.follow import Follower

    (tmp_path / "state.json").write_text("[1]")
    with pytest.raises(DataError, match="is no state"):
        Follower(tmp_path, tmp_path / "state.json")
    with pytest.raises(DataError, match="no such folder"):
        Follower(tmp_path / "none", tmp_path / "other.json")


def test_asking_for_a_forecast_changes_nothing():
    dives = vehicle(6, 5)
    replay = replay_dives(dives[:4])
    before = replay.forecast(dives[4])
    assert all(map(np.array_equal, before, replay.forecast(dives[4])))


@pytest.fixture
def command():
    """Run `clpt replay` without the rest of the command line."""
    import typer
    from typer.testing import CliRunner

    from clpt_control.commands.replay import replay

    app = typer.Typer()
    app.command()(replay)
    return lambda *words: CliRunner().invoke(app, list(map(str, words)))


def test_the_command(command, tmp_path):
    import json

    done = command("--sample", "--out", tmp_path / "out", "--json")
    found = json.loads(done.stdout)
    assert (found["dives"], found["used"], found["skipped"]) == (14, 14, [])
    assert set(found["clpe_rms"]) == {"no_flow", "previous_dive", "adaptive"}
    assert found["clpe_rms_after_3"]["adaptive"] < 0.88 * found["clpe_rms_after_3"]["previous_dive"]
    assert 0.7 < found["speed_factor"]["value"] < 1
    assert {p.name for p in (tmp_path / "out").iterdir()} == {
        "replay.nc", "map.png", "clpe.png", "current.png"
    }  # fmt: skip
    table = command("--sample", "--no-learn-speed", "--flow", "steady", "--estimator", "rls")
    assert table.exit_code == 0
    assert "after the third dive" in table.stdout
    for words, says in (
        ((), "give files"),
        (("--sample", "--follow", tmp_path), "give files"),
        (("--follow", tmp_path), "needs --out"),
        (("--sample", "--flow", "M2"), "must begin with steady"),
        (("--sample", "--least-duration", "1e9"), "must last longer"),
    ):
        assert says in str(command(*words).exception)


def test_the_command_follows(command, tmp_path):
    import json

    (tmp_path / "in").mkdir()
    words = ("--follow", tmp_path / "in", "--out", tmp_path / "out", "--every", "0.01",
             "--patience", "0.01", "--json")  # fmt: skip
    empty = json.loads(command(*words).stdout)
    assert empty["used"] == 0
    assert empty["clpe_rms"]["adaptive"] is None
    for part in (sample_dives()[:5], sample_dives()[5:]):
        one_file_each(tmp_path / "in", part)
        followed = json.loads(command(*words).stdout)
    assert followed == json.loads(command("--sample", "--json").stdout)
    assert (tmp_path / "out" / "replay.nc").exists()
