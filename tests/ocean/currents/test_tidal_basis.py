"""theta of tides that UTide fitted, against the wave that they were made of."""

import numpy as np
import pytest
import utide

import clpt_control as clpt

SPEED = {"M2": 28.9841042, "S2": 30.0, "K1": 15.0410686}  # degrees per hour
TIME = np.datetime64("2019-01-01") + np.arange(24 * 60) * np.timedelta64(1, "h")


def test_the_basis_gives_the_current_that_was_fitted():
    rng, hours = np.random.default_rng(3), np.arange(len(TIME))
    flow = np.full((2, len(TIME)), [[0.1], [-0.05]])
    for speed in SPEED.values():
        c, s = rng.normal(size=(2, 2, 1))
        angle = np.radians(speed * hours)
        flow += c * np.cos(angle) + s * np.sin(angle)
    tides = utide.solve(
        TIME, *flow, lat=41.0, constit=[*SPEED], trend=False, verbose=False
    )
    basis = clpt.currents.tidal_basis(tides, TIME[700], "km h-1")
    assert basis.constituents[0] == "steady"
    later = hours[700:724] - 700
    found = basis.theta[:, [0]] + sum(
        basis.theta[:, [k]]
        * np.cos(np.radians(SPEED[basis.constituents[k]] * later) + basis.phases[k])
        for k in range(1, 7)
    )
    assert np.abs(found / 3.6 - flow[:, 700:724]).max() < 0.05  # nodal factors change by 2 %


def test_a_tide_that_no_scenario_has_is_refused():
    tides = utide.solve(TIME, np.sin(np.arange(1440.0)), lat=41.0, constit=["MSF"], verbose=False)
    with pytest.raises(clpt.DataError, match="MSF: a scenario has only"):
        clpt.currents.tidal_basis(tides, TIME[0])
