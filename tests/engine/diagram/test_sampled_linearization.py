"""The discrete system of a loop with sampled parts, against expm by hand and runs."""

import control
import numpy as np
import pytest
from error_sentences import says
from scipy.linalg import expm

import clpt_control as clpt
from clpt_control import Block, Sampled

A = np.array([[0.0, 1.0], [-2.0, -0.3]])
B, C = np.array([[0.0], [1.5]]), np.array([[1.0, 0.0]])


def error():
    return control.summing_junction(["r", "-y"], "e", name="error")


def plant(**more):
    names = {"inputs": "v", "outputs": "y", "name": "plant"} | more
    return control.ss(A, B, C, 0, **names)


def law(period, **more):
    names = {"inputs": "e", "outputs": "v", "name": "law"} | more
    return control.ss([[0.2]], [[1.0]], [[0.5]], [[0.8]], period, **names)


def held(T):
    """Return x(t + T) of the plant with a held input, by one expm."""
    both = expm(T * np.block([[A, B], [np.zeros((1, 3))]]))
    return both[:2, :2], both[:2, 2:]


@pytest.mark.parametrize("T", [0.05, 0.5])
def test_one_rate_is_the_loop_by_hand(T):
    loop = clpt.connect([error(), law(T), plant()], external="r")
    linear = clpt.linearize(loop)
    Ad, Bd = held(T)
    # the law's state z and the plant's x; e = r - y, v = 0.5 z + 0.8 e
    by_hand = np.block([[np.array([[0.2]]), -C], [0.5 * Bd, Ad - 0.8 * Bd @ C]])
    np.testing.assert_allclose(linear.A, by_hand, atol=1e-12)
    np.testing.assert_allclose(linear.B, np.vstack([[[1.0]], 0.8 * Bd]), atol=1e-12)
    assert linear.dt == T
    assert linear.state_labels == ["law_x[0]", "plant_x[0]", "plant_x[1]"]
    assert linear.input_labels == ["r"]
    assert linear["y", "r"].noutputs == 1
    closed = control.feedback(law(T) * control.c2d(plant(), T), 1)
    poles = [np.sort_complex(one.poles()) for one in (linear, closed)]
    np.testing.assert_allclose(*poles, atol=1e-9)


@pytest.mark.parametrize("periods", [(0.2, 0.3), (0.1, 0.25), (0.5, 0.5)])
def test_several_rates_are_at_the_common_multiple(periods):
    """A linear loop: the system is that of the run from one common sample to the next."""
    one = law(periods[0], outputs="v1", name="one")
    two = law(periods[1], outputs="v2", name="two")
    total = control.summing_junction(["v1", "v2"], "v", name="total")
    loop = clpt.connect([error(), one, two, total, plant()], external="r")
    linear = clpt.linearize(loop)
    T = {(0.2, 0.3): 0.6, (0.1, 0.25): 0.5, (0.5, 0.5): 0.5}[periods]
    assert linear.dt == pytest.approx(T)
    kept = [loop.state_labels.index(name) for name in linear.state_labels]
    for k, place in enumerate(kept):
        start = np.zeros(loop.nstates)
        start[place] = 1.0
        run = clpt.simulate(loop, [0.0, T], 0.0, start, rtol=1e-11, atol=1e-13)
        np.testing.assert_allclose(run.states[-1, kept], linear.A[:, k], atol=1e-9)
    run = clpt.simulate(loop, [0.0, T], 1.0, rtol=1e-11, atol=1e-13)
    np.testing.assert_allclose(run.states[-1, kept], linear.B[:, 0], atol=1e-9)


def test_a_nonlinear_loop_is_linearized_at_its_point():
    swing = Block(
        "swing",
        update=lambda t, x, u, p: [x[1], -9.81 * np.sin(x[0]) + u[0]],
        output=lambda t, x, u, p: x.q,
        inputs={"v": 1},
        outputs={"y": 2},
        states={"q": 2},
    )
    gain = Block(
        "gain",
        output=lambda t, x, u, p: [-4.0 * np.tanh(u[0]) - u[1]],
        inputs={"y": 2},
        outputs={"v": 1},
    )
    loop = clpt.connect([swing, Sampled(gain, 0.1)])
    linear = clpt.linearize(loop, [0.4, 0.0, 0.4, 0.0])
    slope = np.array([[0.0, 1.0], [-9.81 * np.cos(0.4), 0.0]])
    both = expm(0.1 * np.block([[slope, np.array([[0.0], [1.0]])], [np.zeros((1, 3))]]))
    feed = -np.array([[4.0 / np.cosh(0.4) ** 2, 1.0]])
    np.testing.assert_allclose(linear.A, both[:2, :2] + both[:2, 2:] @ feed, atol=1e-12)


def test_python_control_is_refused_where_it_would_be_wrong():
    loop = clpt.connect([error(), law(0.5), plant()], external="r")
    said = "law samples its inputs, which control.linearize does not see. Call clpt.linearize"
    says(clpt.DiagramError, said, control.linearize, loop, np.zeros(4), [0.0])
    smooth = clpt.connect([error(), plant(inputs="e")], external="r")
    np.testing.assert_allclose(
        control.linearize(smooth, [0, 0], [0]).A, A - B @ C, atol=1e-6
    )


def test_periods_without_a_small_multiple_are_refused():
    two = law(0.5 * np.sqrt(2), outputs="w", name="two")
    loop = clpt.connect([error(), law(0.5), two, plant()], external="r")
    says(clpt.DiagramError, "law 0.5, two 0.707107", clpt.linearize, loop)


def test_equations_print_rates_and_updates():
    loop = clpt.connect([error(), law(0.5), plant()], external="r")
    text = repr(clpt.equations(loop))
    assert "law.x+ (each 0.5) = held_u + law.x/5" in text
    assert "held_u+ (each 0.5) = -plant.x[0] + r(t)" in text
    assert "plant.x[0]' = plant.x[1]" in text
