"""theta by least squares: exact recovery, shares, and what is refused."""

import numpy as np
import pytest

from clpt_control.blocks.basis import flow_basis
from clpt_control.equations import evaluate
from clpt_control.errors import DataError
from clpt_control.estimation.least_squares import explained_share, least_squares

M2 = 2 * np.pi / 12.4206


def functions(frequencies, centers=((-8.0, 0.0), (8.0, 5.0)), width=10.0):
    """Cosine and sine of each frequency at each place."""
    rows = [
        (place, f, phase)
        for f in frequencies
        for phase in ((0.0,) if f == 0 else (0.0, -np.pi / 2))
        for place in centers
    ]
    places, frequencies, phases = zip(*rows, strict=True)
    p = places, np.full(len(rows), width), frequencies, phases
    return flow_basis("basis_x", "x", "gaussian", *p)


def samples(n=400, hours=24.0):
    rng = np.random.default_rng(11)
    return rng.uniform(0, hours, n), rng.uniform(-20, 20, (n, 2))


def test_theta_is_recovered_exactly():
    block, (t, x) = functions([0.0, M2]), samples()
    theta = np.random.default_rng(2).normal(size=(2, 6))
    fit = least_squares(evaluate(block, t, x), evaluate(block, t, x) @ theta.T)
    np.testing.assert_allclose(fit.theta, theta, atol=1e-12)
    assert fit.explained_variance == pytest.approx(1.0, abs=1e-12)
    assert fit.residual_max < 1e-12


def test_residuals_are_orthogonal_and_their_figures_are_lengths():
    block, (t, x) = functions([0.0, M2]), samples()
    phi, flow = evaluate(block, t, x), np.random.default_rng(4).normal(size=(400, 2))
    fit = least_squares(phi, flow)
    np.testing.assert_allclose(phi.T @ fit.residuals, 0, atol=1e-10)
    lengths = np.hypot(*fit.residuals.T)
    assert fit.residual_max == pytest.approx(lengths.max())
    assert fit.residual_rms == pytest.approx(np.sqrt((lengths**2).mean()))
    share = 1 - (lengths**2).sum() / (flow**2).sum()
    assert fit.explained_variance == pytest.approx(share)
    values = np.linalg.svd(phi, compute_uv=False)
    assert fit.condition_number == pytest.approx(values[0] / values[-1])


def test_cosine_alone_cannot_hold_a_rotary_tide():
    t, x = samples()
    envelope = np.exp(-np.sum((x - [-8, 0]) ** 2, axis=1) / 200)
    rotary = envelope[:, None] * np.column_stack([np.cos(M2 * t), np.sin(M2 * t)])
    phi = evaluate(functions([M2]), t, x)
    assert least_squares(phi, rotary).explained_variance > 1 - 1e-12
    assert least_squares(phi[:, :2], rotary).explained_variance < 0.7


def test_functions_that_cannot_be_separated_are_named():
    block, (t, x) = functions([0.0, M2], centers=((0.0, 0.0), (0.0, 0.0), (9.0, 0.0))), samples()
    names = [f"f{k}" for k in range(9)]
    with pytest.raises(DataError, match=r"cannot separate the basis functions .*condition number"):
        least_squares(evaluate(block, t, x), np.ones((400, 2)), names)
    phi = np.column_stack([t, np.ones(400), 2 * t])
    with pytest.raises(DataError, match=r"functions f0, f2: condition number .*longer record"):
        least_squares(phi, np.ones((400, 2)), names[:3])


def test_dead_function_is_refused():
    phi = np.column_stack([np.ones(9), np.zeros(9)])
    with pytest.raises(
        DataError, match=r"too far from the places of function 2 .* inf, .* larger width"
    ):
        least_squares(phi, np.ones((9, 2)))


@pytest.mark.parametrize(
    ("phi", "flow", "sentence"),
    [
        (np.ones((2, 3)), np.ones((2, 2)), "2 samples cannot determine 3"),
        (np.full((4, 1), np.nan), np.ones((4, 2)), "not finite"),
        (np.ones((4, 1)), np.full((4, 2), np.nan), "not finite"),
        (np.ones((4, 1)), np.ones((3, 2)), r"shapes \(n, N\) and \(n, 2\)"),
        (np.ones((4, 1)), np.zeros((4, 2)), "zero throughout"),
    ],
)
def test_what_cannot_be_fitted_is_refused(phi, flow, sentence):
    with pytest.raises(DataError, match=sentence):
        least_squares(phi, flow)


def test_share_is_zero_for_no_flow_and_negative_for_worse():
    flow = np.random.default_rng(8).normal(size=(30, 2))
    assert explained_share(flow, 0 * flow) == 0
    assert explained_share(flow, flow) == 1
    assert explained_share(flow, -flow) == pytest.approx(-3.0)
    with pytest.raises(DataError, match="not finite"):
        explained_share(flow, flow * np.nan)
