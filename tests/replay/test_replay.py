"""Replay of a glider: SG542's figures, causality, mistakes, the dataset."""

import math
from dataclasses import replace

import numpy as np
import pytest
from synthetic_vehicle import vehicle

from clpt_control.errors import ArgumentError, DataError, ScenarioError
from clpt_control.estimation.estimators import ESTIMATORS
from clpt_control.gliders.dive_files import sample_dives
from clpt_control.gliders.usable_dives import usable
from clpt_control.replay.facts import replay_dataset
from clpt_control.replay.outcome import clpe_rms, summary
from clpt_control.replay.replay import Replay, replay_dives


@pytest.fixture(scope="module")
def sg542():
    return replay_dives(usable(sample_dives())[0])


def test_sg542_without_learning(sg542):
    # the 13 after the first, which has no dive before it; all 14, the first with no flow
    found = summary(sg542)
    assert found["clpe_rms"]["no_flow"] == pytest.approx(1853, abs=1)
    assert found["clpe_rms"]["previous_dive"] == pytest.approx(1213, abs=1)
    assert found["clpe_rms_all"]["no_flow"] == pytest.approx(1950, abs=1)
    assert found["clpe_rms_all"]["previous_dive"] == pytest.approx(1407, abs=1)
    one = summary(replay_dives([sg542.steps[0].dive]))
    assert set(one["clpe_rms"].values()) == {None}
    assert one["clpe_rms_all"]["previous_dive"] == pytest.approx(2931, abs=1)
    assert summary(sg542)["dac_identity_median"] < 1e-3


def test_sg542_adaptive(sg542):
    rms = clpe_rms(sg542, 3)
    assert rms["previous_dive"] == pytest.approx(1167, rel=0.01)
    assert rms["adaptive"] <= 0.88 * rms["previous_dive"]
    assert 0.75 <= summary(sg542)["inside_90"] <= 1
    assert summary(sg542)["anomalies"] == []


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


def test_mistakes_are_sentences():
    dives, replay = vehicle(1, 2), Replay()
    replay.step(dives[1])
    with pytest.raises(DataError, match="ends before dive 1"):
        replay.step(dives[0])
    with pytest.raises(DataError, match="must be finite"):
        replay.step(replace(dives[1], t_gpse=2e9, gps_east=math.nan))


def test_the_dataset_is_a_cf_trajectory(sg542, tmp_path):
    import xarray

    from clpt_control.files import write_file

    write_file(tmp_path / "replay.nc", replay_dataset(sg542))
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


def test_the_next_surfacing_is_that_of_the_next_dive():
    """Planned as it was flown, the next dive's forecast is the one the replay gives it."""
    from clpt_control.geodesy import place_from
    from clpt_control.replay.replay import next_dive

    *earlier, last = usable(sample_dives())[0]
    before = replay_dives(earlier)
    found = next_dive(before, last.duration, (last.dr_east, last.dr_north))
    start = before.start()
    assert start[0] == earlier[-1].t_gpse + found.as_dict()["surface_time"]
    step = before.step(last)
    # but for the drift at the surface: it starts at the fix where the glider came up
    assert found.forecast == pytest.approx(step.forecast, abs=15)
    # and for what a dive scatters by that is flown as planned
    assert np.linalg.eigvalsh(found.covariance - step.covariance).min() > 0
    way = found.forecast + np.array([last.dr_east, last.dr_north])
    assert (found.latitude, found.longitude) == place_from(*start[1:], *way)
    for plan in ((0.0, (0.0, 0.0)), (3600.0, (math.inf, 0.0))):
        with pytest.raises(ScenarioError, match="through the water"):
            next_dive(before, *plan)


def test_what_was_repaired_is_said():
    noted = replace(vehicle(1, 3)[1], notes=("filled 2 samples",))
    found = summary(replay_dives([vehicle(1, 3)[0], noted]))
    assert found["notes"] == [{"dive": 1, "note": "filled 2 samples"}]


def test_a_path_is_no_dive():
    with pytest.raises(ArgumentError, match=r"'p5420304.nc'.*must be Iterable.Dive.*read_dives"):
        replay_dives(["p5420304.nc"])
