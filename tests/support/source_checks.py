"""What pins down the sources of a diagram: bounds, symmetries, values at special points.

phi of Eq. (5), the waypoints of section IV, Delta of Eq. (32), a gridded F_R.  None of
the formulas stands here; each check raises AssertionError where a property fails.
"""

import math
from types import FunctionType

import numpy as np
import sympy

from clpt_control.base import random_numbers
from clpt_control.engine.model.declaration import Parameters
from clpt_control.paper.blocks import disturbance, field, flow, localization, reference
from clpt_control.paper.currents.plane import GriddedField

POINTS = np.array([[3.0, 1.0], [-2.0, 5.0], [7.0, -4.0]])
KERNELS = list(flow.KERNELS)


def phi(kernel, position, t=0.7, omega=1.3, phase=0.4, width=2.0):
    """One function around (1, -2)."""
    block = flow.flow_basis(
        "basis_x", "x", kernel, [[1.0, -2.0]], [width], [omega], [phase]
    )
    return float(block.output(t, [], np.array([1.0, -2.0]) + position)[0])


def functions_are_even_isotropic_and_never_rise():
    for kernel in KERNELS:
        for a, b in ((0.3, 0.4), (-1.2, 2.0), (0.0, 0.7)):
            places = [(a, b), (-a, -b), (b, -a), (-b, a)]
            values = [phi(kernel, place) for place in places]
            assert np.allclose(values, values[0], rtol=1e-14, atol=0.0)
        falling = [abs(phi(kernel, (d, 0.0))) for d in (0.0, 0.5, 1.0, 2.0, 4.0)]
        assert np.all(np.diff(falling) <= 0)
        assert 0.0 <= falling[-1] < falling[0] <= 1.0


def functions_oscillate_with_their_tide():
    for kernel in KERNELS:
        for t in (0.0, 0.7, 3.0, 11.0):
            assert math.isclose(
                phi(kernel, (0.0, 0.0), t), math.cos(1.3 * t + 0.4), abs_tol=1e-14
            )
            shape = phi(kernel, (0.6, -0.9), t) / math.cos(1.3 * t + 0.4)
            still = phi(kernel, (0.6, -0.9), 0.0, omega=0.0, phase=0.0)
            assert math.isclose(shape, still, rel_tol=1e-13)


def functions_scale_with_their_width():
    for kernel in KERNELS:
        power = 0.5 if kernel == "gaussian-sigma" else 1.0
        wide = phi(kernel, (0.6 * 4**power, -0.9 * 4**power), width=8.0)
        assert math.isclose(wide, phi(kernel, (0.6, -0.9)), rel_tol=1e-13)


def waypoints_are_taken_in_turn_and_jump_at_multiples_of_the_dwell():
    block = reference.reference(POINTS, 20.0)
    zc = [block.output(20.0 * j + 7.0, [], []) for j in range(7)]
    assert np.array_equal(zc, POINTS[[0, 1, 2, 0, 1, 2, 0]])
    block = reference.reference(POINTS, 0.1)
    for j in (0, 3, 40):
        piece = block.breakpoints(0.1 * j, 0.1 * j + 1.0)
        assert np.array_equal(piece, 0.1 * np.arange(j + 1, j + len(piece) + 1))
        assert len(piece) >= 9


def circles_turn_left_from_the_east():
    w = reference.circle(2.0, 8)
    turned = np.column_stack([-w[:, 1], w[:, 0]])
    assert np.allclose(np.hypot(*w.T), 2.0, atol=1e-14)
    assert np.allclose(np.roll(w, -2, axis=0), turned, atol=1e-14)
    assert np.allclose(w[0], [2.0, 0.0], atol=1e-14)


def disturbances_start_as_they_say():
    def at(kind, t):
        return disturbance.disturbance(kind, [0.3, -0.2], period=2.0).output(t, [], [])

    a = np.array([0.3, -0.2])
    for kind, factors in (
        ("constant", {1.7: 1.0}),
        ("sine", {0.0: 0.0, 0.5: 1.0, 1.0: 0.0, 1.5: -1.0, 2.0: 0.0}),
        ("square", {0.0: 1.0, 0.9: 1.0, 1.1: -1.0, 1.9: -1.0, 2.1: 1.0}),
    ):
        found = [at(kind, t) for t in factors]
        assert np.allclose(found, np.outer([*factors.values()], a), atol=1e-15)
    for t in np.linspace(0.0, 4.0, 9):
        assert np.allclose(at("sine", t) ** 2 + at("sine", t + 0.5) ** 2, a**2)
    block = disturbance.disturbance("square", [1.0, 1.0], period=2.0)
    assert np.array_equal(block.breakpoints(0.0, 3.5), [1.0, 2.0, 3.0])


def noise_is_normal():
    draws = np.array(
        [[random_numbers.normal(7.0, float(k), i) for k in range(4000)] for i in (0, 1)]
    )
    assert np.abs(draws.mean(1)).max() < 0.06
    assert np.abs(draws.std(1) - 1).max() < 0.06
    assert abs(np.corrcoef(draws)[0, 1]) < 0.06
    M = random_numbers.MODULUS
    small = [
        random_numbers.remainder(a) for a in (0.0, 5.0, M, 2.0 * M + 7.0, 3.0 * M - 1.0)
    ]
    assert small == [0, 5, 0, 7, M - 1]


def noise_is_hashed_on_whole_numbers_below_two_to_53():
    """Interval arithmetic over all seeds, intervals, axes and streams."""
    M, arguments = int(random_numbers.MODULUS), []

    def remainder(a):
        arguments.append(a)
        return sympy.AccumBounds(0, M - 1)

    space = {**random_numbers.hash_fraction.__globals__, "remainder": remainder}
    hashed = FunctionType(random_numbers.hash_fraction.__code__, space)
    any_whole = sympy.AccumBounds(0, M - 1)
    for axis, stream in np.ndindex(2, 2):
        share = hashed(any_whole, any_whole, axis, stream)
        assert 0 < share.min <= share.max < 1
    ends = [
        (a.min, a.max) if isinstance(a, sympy.AccumBounds) else (a, a)
        for a in arguments
    ]
    assert all(low >= 0 and high < 2**53 for low, high in ends)


def positions_are_read_with_numbers_of_their_own():
    """x_m - x = s n(j, axis), with the axes 2 and 3 of the hash; the disturbance has 0 and 1."""
    x, s, seed = np.array([3.0, -1.0]), 0.25, 7.0
    for j in (1, 2, 5):
        noise = [s * random_numbers.normal(seed, float(j), axis) for axis in (2, 3)]
        read = localization.measurement(s, 0.5, seed).output(0.5 * j + 0.1, [], x)
        fixed = localization.fixes(s, 0.5, 0.0, seed).output(0.5 * j + 0.1, [], x)
        assert np.allclose(read - x, noise, rtol=0.0, atol=1e-14)
        assert np.allclose(fixed, [*(x + noise), 1.0], rtol=0.0, atol=1e-14)


SIDES = (3, 4, 5), (1.0, -2.0, 3.0), (2.0, 1.0, 3.0)


def gridded_flows_reproduce_linear_ones():
    """A spline whose coefficients are linear is that line; beyond the edges it is held."""
    axes = [s + d * np.arange(n) for n, s, d in zip(*SIDES, strict=True)]
    wider = [s + d * np.arange(-1, n + 1) for n, s, d in zip(*SIDES, strict=True)]
    grid = GriddedField(*axes, np.zeros(SIDES[0]), np.zeros(SIDES[0]))

    def line(t, x2, x1):
        return np.array([7 - 2 * t + x2 + 5 * x1, t + 10 * x2 - 3 * x1])

    u, v = line(*np.meshgrid(*wider, indexing="ij"))
    params = {"true_flow.u": u.ravel(), "true_flow.v": v.ravel()}
    first, last = np.array([(a[0], a[-1]) for a in axes]).T
    rng = np.random.default_rng(3)
    for delta in ([], [0.25, -0.5]):
        block = field.gridded_flow(grid, disturbed=bool(delta), outside="clip")
        for share in [
            *rng.random((40, 3)),
            np.zeros(3),
            np.ones(3),
            2 * np.ones(3),
            -np.ones(3),
        ]:
            place = first + share * (last - first)
            flow = block.output(place[0], [], [place[2], place[1], *delta], params)
            wanted = line(*np.clip(place, first, last)) + (delta or 0.0)
            assert np.allclose(flow, wanted, rtol=1e-12, atol=1e-11)


def guards_know_the_edge():
    sides = dict(zip(("shape", "start", "step"), SIDES, strict=True))
    p = Parameters(**{name: np.array(a, dtype=float) for name, a in sides.items()})
    places = ((2.0, 6.0, 0.0), (2.0, 0.0, 0.0), (6.0, 6.0, 0.0))
    near = [field.inside(t, np.zeros(0), np.array([x1, x2]), p) for t, x1, x2 in places]
    assert np.allclose(near, [0.5, -1.0, -0.5], atol=1e-14)


CHECKS = [
    *(functions_are_even_isotropic_and_never_rise, functions_oscillate_with_their_tide),
    *(functions_scale_with_their_width, circles_turn_left_from_the_east),
    waypoints_are_taken_in_turn_and_jump_at_multiples_of_the_dwell,
    *(disturbances_start_as_they_say, noise_is_normal, guards_know_the_edge),
    noise_is_hashed_on_whole_numbers_below_two_to_53,
    *(
        positions_are_read_with_numbers_of_their_own,
        gridded_flows_reproduce_linear_ones,
    ),
]
