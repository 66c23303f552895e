"""Least squares against closed forms."""

import numpy as np
import pytest
from refusals import refuses

from clpt_control.engine.model.block import evaluate
from clpt_control.paper.blocks.flow import flow_basis
from clpt_control.paper.currents.least_squares import explained_share, least_squares

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
