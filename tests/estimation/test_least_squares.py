"""Least squares, wandering currents and parts of a flow, against closed forms and made vehicles."""

from dataclasses import replace

import numpy as np
import pytest
from refusals import refuses
from scipy.stats import multivariate_normal, multivariate_t
from synthetic_vehicle import vehicle

from clpt_control.equations import evaluate
from clpt_control.estimation import FixModel, Priors
from clpt_control.ocean.estimation.dive import mid_time, miss
from clpt_control.ocean.estimation.estimators import KalmanBank, with_hidden
from clpt_control.ocean.estimation.least_squares import explained_share, least_squares
from clpt_control.ocean.estimation.priors import DAY, Sea
from clpt_control.paper.blocks.flow import flow_basis
from clpt_control.replay import replay_dives

M2 = 2 * np.pi / 12.4206
NAMES = [f"f{k}" for k in range(9)]


def functions(*centers):
    """A constant, cosine and sine of M2 at each place."""
    rows = [
        (place, *of)
        for of in ((0, 0.0), (M2, 0.0), (M2, -np.pi / 2))
        for place in centers
    ]
    places, frequencies, phases = zip(*rows, strict=True)
    widths = np.full(len(rows), 10.0)
    return flow_basis("basis_x", "x", "gaussian", places, widths, frequencies, phases)


def samples():
    rng = np.random.default_rng(11)
    return rng.uniform(0, 24.0, 400), rng.uniform(-20, 20, (400, 2))


def test_residuals_are_orthogonal_and_their_figures_are_lengths():
    block, (t, x) = functions((-8.0, 0.0), (8.0, 5.0)), samples()
    phi, flow = evaluate(block, t, x), np.random.default_rng(4).normal(size=(400, 2))
    fit = least_squares(phi, flow, NAMES)
    np.testing.assert_allclose(phi.T @ fit.residuals, 0, atol=1e-10)
    lengths = np.hypot(*fit.residuals.T)
    assert fit.residual_max == pytest.approx(lengths.max())
    assert fit.residual_rms == pytest.approx(np.sqrt((lengths**2).mean()))
    share = 1 - (lengths**2).sum() / ((flow - flow.mean(axis=0)) ** 2).sum()
    assert fit.explained_variance == pytest.approx(share)
    values = np.linalg.svd(phi, compute_uv=False)
    assert fit.condition_number == pytest.approx(values[0] / values[-1])


def test_functions_that_cannot_be_separated_are_named():
    block, (t, x), one = (
        functions((0.0, 0.0), (0.0, 0.0), (9.0, 0.0)),
        samples(),
        np.ones(400),
    )
    for phi, said in (
        (
            evaluate(block, t, x),
            "cannot separate the basis functions .*condition number",
        ),
        (
            np.column_stack([t, one, 2 * t]),
            "functions f0, f2: condition number .*longer record",
        ),
        (
            np.column_stack([one, 0 * one]),
            "basis functions f1: .* inf, .* another width",
        ),
    ):
        refuses(said, least_squares, phi, np.ones((len(phi), 2)), NAMES)


def test_share_is_zero_for_the_mean_and_negative_for_worse():
    flow = np.array([3.0, -5.0]) + np.random.default_rng(8).normal(size=(30, 2))
    mean = np.broadcast_to(flow.mean(axis=0), flow.shape)
    shares = [explained_share(flow, other) for other in (mean, flow, 2 * mean - flow)]
    assert shares == [0, 1, pytest.approx(-3.0)]
    more = (mean[0] ** 2).sum() / flow.var(axis=0).sum()
    assert explained_share(flow, 0 * flow) == pytest.approx(-more)
    assert explained_share(flow @ [1, 1j], 0 * flow @ [1, 1j]) == pytest.approx(-more)


def test_a_steady_flow_has_no_share():
    wave = np.column_stack([np.sin(np.arange(30.0)), np.cos(np.arange(30.0))])
    for flow in (0 * wave, 0 * wave + 0.1, 1 + 0.013 * wave):
        assert np.isnan(explained_share(flow, flow))
        assert np.isnan(explained_share(flow, 0 * flow))
    assert explained_share(1 + 0.015 * wave, 1 + 0.015 * wave) == 1


def taught(model, dives):
    """A bank that has learned dives."""
    bank = KalmanBank(model)
    for dive in dives:
        bank.update(dive)
    return bank


def slow(kind, t):
    """The covariance of a slow current over a time, by the closed forms of Matern's."""
    g = np.sqrt(3) * abs(t) / kind.memory
    shape = (1 + g) * np.exp(-g) if kind.smooth else np.exp(-abs(t) / kind.memory)
    return kind.size**2 * shape


@pytest.mark.parametrize("kind", Priors().kinds)
def test_a_filter_is_the_gaussian_process_of_all_dives(kind):
    """The same problem, solved at once with the covariance of each pair of dives."""
    priors = Priors(kinds=(kind,), speed_fading=3e6)
    model = FixModel(("steady", "M2"), priors=priors)
    dives, kept = (
        vehicle(3, 8, walk=0.02),
        (priors.tide_fading, 3e6, priors.compass_fading),
    )
    left = dict(zip(("tides", "speed", "compass"), kept, strict=True))
    H, t = (
        [model.regressor(dive) for dive in dives],
        np.array([mid_time(d) for d in dives]),
    )
    fading, y = (
        [left.get(p, np.inf) for p in model.parts],
        np.concatenate([miss(d) for d in dives]),
    )

    def among(one, other):
        k, j = H[one], H[other]
        away = abs(t[one] - t[other])
        own = k @ np.diag(model.prior_sd**2 * np.exp(-away / np.array(fading))) @ j.T
        return own + slow(kind, away) * k[:, :2] @ j[:, :2].T

    K = np.block([[among(i, j) for j in range(8)] for i in range(8)])
    noise = np.repeat([model.noise(dive, kind.scatter) for dive in dives], 2)
    known = np.linalg.inv(K[:14, :14] + np.diag(noise[:14]))
    mean, covariance = (
        K[14:, :14] @ known @ y[:14],
        K[14:, 14:] - K[14:, :14] @ known @ K[:14, 14:],
    )
    bank = taught(model, dives[:-1])
    with_it = np.flatnonzero(bank.present[:, 0])[0]
    _, _, found, P = bank.ahead(dives[-1])
    row = with_hidden(H[-1])
    assert found[with_it] @ row.T == pytest.approx(mean, rel=1e-6, abs=1e-6)
    assert row @ P[with_it] @ row.T == pytest.approx(covariance, rel=1e-6)


def test_covariances_stay_whole_over_a_thousand_dives():
    bank = taught(FixModel(), vehicle(1, 1000, walk=0.03, noise=0.01))
    size = np.sqrt(np.diagonal(bank.covariance, axis1=1, axis2=2)) + 1e-12
    correlation = bank.covariance / size[:, :, None] / size[:, None, :]
    assert np.abs(correlation - correlation.transpose(0, 2, 1)).max() < 1e-8
    assert np.linalg.eigvalsh(correlation).min() > -1e-7
    assert np.isfinite(bank.mean).all()


def test_weights_are_those_of_the_density_before_the_fix():
    """A fix 60 km away: the density is that of the forecast, not of the ellipse it widens."""
    dives = vehicle(2, 12, noise=0.01)
    bank = taught(FixModel(), dives[:11])
    last = replace(dives[11], gps_east=dives[11].gps_east + 60e3)
    nu, before = bank.priors.degrees_of_freedom, bank.weights
    model, _, mean, P = bank.ahead(last)
    H = with_hidden(model.regressor(last))
    S = H @ P @ H.T + bank.noise(last)
    density = [
        multivariate_t.pdf(miss(last), H @ m, (nu - 2) / nu * s, nu)
        for m, s in zip(mean, S, strict=True)
    ]
    bank.priors = bank.priors._replace(weight_memory=1e15)
    bank.update(last)
    expected = before * density / (before @ density)
    assert bank.weights == pytest.approx(expected, rel=1e-6, abs=1e-12)


@pytest.mark.parametrize("factor", [1.0, 1.06])
def test_the_probability_of_a_speed_factor_is_that_of_its_evidence(factor):
    """All dives at once, with a factor and without: the ratio of two normal densities."""
    still = Sea(0.0, DAY, scatter=0.01)
    priors = Priors(kinds=(still,), speed_fading=np.inf, compass_fading=np.inf)
    model = FixModel(("steady",), priors=priors)
    dives = vehicle(4, 10, factor=factor, noise=0.01, fix=30.0)
    bank = taught(model, dives)
    H = np.vstack([model.regressor(dive) for dive in dives])
    noise = np.diag(np.repeat([model.noise(dive, 0.01) for dive in dives], 2))
    y = np.concatenate([miss(dive) for dive in dives])
    with_it, without = (
        multivariate_normal.logpdf(y, cov=H @ np.diag(sd**2) @ H.T + noise)
        for sd in (model.prior_sd, model.prior_sd * (np.array(model.parts) != "speed"))
    )
    expected = 1 / (1 + np.exp(without - with_it))
    assert bank.parts()["speed"] == pytest.approx(expected, rel=1e-6)
    assert (bank.parts()["speed"] > 0.5) == (factor != 1.0)


@pytest.mark.parametrize(
    ("flow", "there", "absent"),
    [("M2", "tides", "inertial"), ("inertial", "inertial", "tides")],
)
def test_parts_that_are_there_are_found(flow, there, absent):
    wrong = []
    for seed in range(3):
        parts = replay_dives(vehicle(seed, 40, flow=flow, noise=0.01)).steps[-1].parts
        assert set(parts) == {
            "tides",
            "inertial",
            "trend",
            "eddies",
            "speed",
            "compass",
        }
        assert all(0 <= p <= 1 for p in parts.values())
        assert parts[there] > 0.9
        wrong.append(parts[absent])
    assert np.mean(wrong) < 0.3
