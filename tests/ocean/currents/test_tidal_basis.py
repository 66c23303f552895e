"""theta of tides that UTide fitted, against closed forms and UTide's own reconstruction."""

import numpy as np
import pytest
import utide
from refusals import refuses

from clpt_control import ScenarioError
from clpt_control.currents import tidal_basis
from clpt_control.paper.currents.tidal_basis import NAMES
from clpt_control.paper.scenario.tidal_periods import SPEEDS, period, speed

LATITUDE = 41.2
HOUR = np.timedelta64(1, "h")
# name: east amplitude (m/s) and phase (degrees), north amplitude and phase
KNOWN = {
    "M2": (0.50, 40.0, 0.30, 110.0),
    "S2": (0.15, 350.0, 0.10, 20.0),
    "K1": (0.08, 200.0, 0.06, 300.0),
    "O1": (0.05, 10.0, 0.07, 95.0),
}
MEAN = np.array([0.1, -0.05])
FIXED = {"nodal": False, "phase": "linear_time"}  # f = 1, n = 0, and V grows evenly


def times(days, start="2019-01-01"):
    return np.datetime64(start, "ms") + np.arange(24 * days + 1) * HOUR


def waves(time, known=KNOWN):
    """Return east and north, from the cosines of each tide about the first time."""
    hours = (time - time[0]) / HOUR
    flow = MEAN[:, None] * np.ones(hours.size)
    for name, (*row,) in known.items():
        amplitude, phase = np.array(row).reshape(2, 2).T[:, :, None]
        flow += amplitude * np.cos(np.radians(SPEEDS[name] * hours - phase))
    return flow


def solved(time, flow, names=tuple(KNOWN), **options):
    chosen = {"trend": False, "verbose": False} | options
    return utide.solve(time, *flow, lat=LATITUDE, constit=list(names), **chosen)


def flow_of(basis, hours):
    """Return theta phi of a basis at hours since its epoch; phi is Eq. (5) without places."""
    rates = np.array([2 * np.pi / period(name) for name in basis.constituents])
    phi = np.cos(rates[:, None] * hours + np.array(basis.phases)[:, None])
    return basis.theta @ phi


def test_speeds_are_those_of_utide():
    of_utide = {
        NAMES.get(name, name): 360 * cycles
        for name, cycles in utide.cycles_per_hour.items()
    }
    # UTide's SA and S1 follow the sun's perigee, Schureman's the mean year
    for name in SPEEDS:
        off = 2.1e-6 if name in ("SA", "S1") else 4e-7
        assert of_utide[name] == pytest.approx(SPEEDS[name], abs=off)
    assert (speed("steady"), period("steady")) == (0, np.inf)
    refuses("unknown constituent 'M9'", speed, "M9", error=ScenarioError)


def test_theta_of_a_made_tide_is_its_cosine_and_sine():
    """A cos(w t - g) is c cos(w (t - t0)) + s sin(w (t - t0)), c + i s = A exp(i (g - w t0))."""
    time = times(30)
    basis = tidal_basis(solved(time, waves(time), **FIXED), time[100], "km h-1")
    assert basis.constituents[0] == "steady"
    np.testing.assert_allclose(basis.theta[:, 0], 3.6 * MEAN, atol=1e-5)
    assert sorted(basis.constituents[1::2]) == sorted(KNOWN)
    assert basis.constituents[1::2] == basis.constituents[2::2]
    assert basis.phases == (0.0, *([0.0, -np.pi / 2] * 4))
    for k, name in enumerate(basis.constituents[1::2]):
        amplitude, phase = np.array(KNOWN[name]).reshape(2, 2).T
        both = 3.6 * amplitude * np.exp(1j * np.radians(phase - 100 * SPEEDS[name]))
        found = basis.theta[:, 1 + 2 * k] + 1j * basis.theta[:, 2 + 2 * k]
        np.testing.assert_allclose(found, both, atol=1e-5)
    hours = (time - time[100]) / HOUR
    np.testing.assert_allclose(flow_of(basis, hours), 3.6 * waves(time), atol=1e-4)


@pytest.mark.parametrize(
    "options",
    [
        {},
        {"nodal": False},
        {"nodal": "linear_time", "phase": "linear_time"},
        {"nodal": False, "phase": "raw"},
        {"method": "robust"},
    ],
)
@pytest.mark.parametrize("epoch", ["2019-01-15", "2031-07-09T05:30:15", "1987-02-28"])
def test_the_flow_at_the_epoch_is_that_of_utide(options, epoch):
    time = times(30)
    tides = solved(time, waves(time), **options)
    when = np.array([epoch], "datetime64[s]")
    there = utide.reconstruct(when, tides, min_SNR=0, verbose=False)
    for given in (epoch, when[0], when.astype("datetime64[ns]")[0], f"{epoch}"):
        found = flow_of(tidal_basis(tides, given), np.zeros(1))
        assert np.abs(found - [there.u, there.v]).max() < 1e-9


def m2(time):
    """Return east and north by the classical series in the node and the longitudes of moon and sun.

    J. Meeus, Astronomical Algorithms; D. Pugh, Tides, Surges and Mean Sea-Level.
    """
    T = (time - np.datetime64("2000-01-01T12")) / np.timedelta64(1, "D") / 36525
    s, h = 218.3164477 + 481267.88123 * T, 280.46646 + 36000.76983 * T
    N = np.radians(125.04452 - 1934.136261 * T)
    f, u = 1.0004 - 0.0373 * np.cos(N) + 0.0002 * np.cos(2 * N), -2.14 * np.sin(N)
    day = (time - time.astype("datetime64[D]")) / HOUR
    angle = np.radians(30 * day + 2 * (h - s) + u)
    return np.array([0.5 * f * np.cos(angle - 1), 0.3 * f * np.cos(angle - 2)])


def test_a_fit_of_one_month_holds_in_another_year():
    """Both months made from the classical f, u and Meeus's V, ten years apart."""
    here, there = times(30, "2016-03-01"), times(30, "2026-03-01")
    tides = solved(here, m2(here), ["M2"])
    middle = there[360]
    later = flow_of(tidal_basis(tides, middle), (there - middle) / HOUR)
    assert np.abs(later - m2(there)).max() < 0.006
    without = solved(here, m2(here), ["M2"], nodal=False)
    lost = flow_of(tidal_basis(without, middle), (there - middle) / HOUR) - m2(there)
    assert np.abs(lost).max() > 0.015


def test_the_name_of_a_tide_is_that_of_a_scenario():
    time = times(60)
    flow = waves(time, {"M1": KNOWN["M2"]})
    assert tidal_basis(solved(time, flow, ["NO1"]), time[0]).constituents[1] == "M1"


def test_tides_that_no_scenario_can_have_are_refused():
    time = times(30)
    flow = waves(time)
    right = solved(time, flow)
    with_trend = solved(time, flow, trend=True)
    refuses(r"have a trend.*trend=False", tidal_basis, with_trend, time[0])
    foreign = solved(time, flow, ["M2", "MSF"])
    refuses("tides: have MSF; must be of M2, S2", tidal_basis, foreign, time[0])
    heights = utide.solve(time, flow[0], lat=LATITUDE, trend=False, verbose=False)
    for wrong in (heights, {}):
        refuses("tides: must be of two components", tidal_basis, wrong, time[0])
    for epoch in ("today", "NaT", np.datetime64("NaT"), 5, None, "2019-02-30"):
        refuses("epoch = .*: must be such as 2019-01-01T", tidal_basis, right, epoch)
    refuses("theta: units = 'km' is not a speed", tidal_basis, right, time[0], "km")
