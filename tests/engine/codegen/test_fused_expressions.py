"""Machine code of records of arrays: every operation, in every form, against NumPy's."""

from itertools import product

import control
import numpy as np
import pytest
import scipy.linalg
from engine_runs import (
    NativeDiagram,
    compare_backends,
    print_program,
    readings,
    wiring_of,
)

import clpt_control as clpt
from clpt_control import Block, lookup

SIZES = {"N": 11, "M": 3}
STATES = {"x": "N", "y": "M", "A": ("N", "N"), "B": (2, "N"), "c": 2, "d": 20, "s": 1}


def turned(t, x, u, p):
    """Views: transposed, backwards, shifted, a diagonal."""
    return {
        "x": x.A.T @ x.x + np.trace(x.A),
        "y": x.y * 2.0 - x.y,
        "A": x.A.T - x.A,
        "B": np.stack([x.x, x.x * x.x]) - x.B,
        "c": x.c[::-1],
        "d": np.concatenate([x.d[1:], x.d[:1]]) - x.d[::-1],
        "s": np.diagonal(x.A).sum(),
    }


def products(t, x, u, p):
    """Matrices, outer products, and a factor that leaves its sum."""
    return {
        "x": x.A @ (p.m @ x.x),
        "y": x.y * (x.x @ p.m @ x.x),
        "A": x.A @ np.outer(x.x, x.x) @ x.A,
        "B": np.outer(x.c, x.x) @ x.A,
        "c": x.B @ x.x,
        "d": np.outer(x.d, x.d) @ x.d,
        "s": x.x @ x.x,
    }


def choices(t, x, u, p):
    """Questions of elements, truth values as numbers, NaN, lookups."""
    positive = x.x > 0
    return {
        "x": np.where(positive & ~(x.x > 1), np.sqrt(x.x), np.minimum(x.x, -0.5)),
        "y": lookup(x.x, np.floor(3 * x.y)),
        "A": np.where(x.A > x.A.T, x.A, p.m),
        "B": np.sign(x.B) * np.floor(x.B) + positive,
        "c": np.array([np.sum(positive), lookup(x.d, 5.0 * x.c[0])]),
        "d": np.clip(x.d, -0.5, 0.5) % 0.3,
        "s": lookup(np.array([np.sin(k * x.c[0]) for k in range(30)]), 7.0 + x.c[0]),
    }


def functions(t, x, u, p):
    """Powers, divisions by parameters and by signals, functions of a library."""
    return {
        "x": np.exp(-x.x / p.w) * np.cos(t * p.w + x.x) / (1.0 + x.x**2),
        "y": np.arctan2(x.y, -0.0 * x.y) + np.hypot(x.y, 2.0),
        "A": np.tanh(x.A) ** 3,
        "B": np.abs(x.B) ** 0.5 + x.B**4,
        "c": np.abs(x.c) ** 1.3,
        "d": np.array([np.sin(k * x.c[0]) * x.d[k] for k in range(20)]),
        "s": np.exp(np.sum(p.m @ p.w)) + np.linalg.norm(x.x),
    }


PROGRAMS = (turned, products, choices, functions)


def block_of(update):
    """Return a block with states of every kind."""
    random = np.random.default_rng(5)
    parameters = {"m": random.normal(size=(11, 11)) / 11, "w": random.uniform(1, 2, 11)}
    own = {"states": STATES, "shapes": {"m": ("N", "N"), "w": "N"}, "sizes": SIZES}
    return Block("block", update=update, parameters=parameters, **own)


def as_python(diagram, points):
    """Each form of machine code gives what Python does."""
    ask = readings(diagram)
    for x, name in product(points, ("native", "scalar", "looped", "lanes")):
        found, wanted = (ask[one](0.7, x, [])[0] for one in (name, "python"))
        np.testing.assert_allclose(found, wanted, rtol=1e-12, atol=1e-13, err_msg=name)


@pytest.mark.parametrize("update", PROGRAMS)
def test_every_form_is_numpys(update):
    block = block_of(update)
    as_python(block, np.random.default_rng(1).normal(size=(3, block.nstates)))


def meeting(one):
    """Return a diagram in which alpha phi of one block meets - alpha phi of another, or its own."""
    basis = lambda t, x, u, p: {"phi": np.exp(-np.arange(1.0, 6.0) * u.z[0] ** 2)}  # noqa: E731
    opposed = lambda t, x, u, p: {  # noqa: E731
        "z": u.plus + u.minus - x.z,
        "alpha": np.outer(u.plus, np.ones(5)),
    }
    own = {"states": {"z": 2, "alpha": (2, 5)}, "inputs": {"plus": 2, "minus": 2}}
    size = {"inputs": {"alpha": (2, "N"), "phi": "N"}, "sizes": {"N": 5}}
    made = [
        Block(
            "basis", output=basis, inputs={"z": 2}, outputs={"phi": "M"}, sizes={"M": 5}
        ),
        Block("model", update=opposed, **own),
    ]
    if one:
        own = lambda t, x, u, p: {"plus": u.alpha @ u.phi, "minus": -u.alpha @ u.phi}  # noqa: E731
        return clpt.connect(
            [*made, Block("both", output=own, outputs={"plus": 2, "minus": 2}, **size)]
        )
    up = Block(
        "up", output=lambda t, x, u, p: u.alpha @ u.phi, outputs={"plus": 2}, **size
    )
    down = Block(
        "down", output=lambda t, x, u, p: -u.alpha @ u.phi, outputs={"minus": 2}, **size
    )
    return clpt.connect([*made, up, down])


@pytest.mark.parametrize(("one", "left"), [(True, 4), (False, 2)])
def test_terms_of_different_blocks_cancel_and_those_of_one_do_not(one, left):
    """The rates of the model take so many sums, two of them for alpha'."""
    nests = NativeDiagram(meeting(one)).code.program.functions["derivative"]
    assert sum(item.summed for nest in nests for item in nest.items) == left
    as_python(meeting(one), np.random.default_rng(2).normal(size=(1, 12)))


def test_sums_of_one_block_stay_as_they_are_written():
    """a phi + b phi takes two sums, not one of (a + b) phi."""
    twice = lambda t, x, u, p: u.a @ np.exp(u.c) + u.b @ np.exp(u.c)  # noqa: E731
    inputs = dict.fromkeys("abc", "N")
    block = Block(
        "twice", update=twice, states={"s": 1}, inputs=inputs, sizes={"N": 11}
    )
    nests = NativeDiagram(block).code.program.functions["derivative"]
    assert sum(item.summed for nest in nests for item in nest.items) == 2


def test_a_large_matrix_is_a_loop():
    random = np.random.default_rng(0)
    system = control.ss(
        random.normal(size=(60, 60)), np.ones((60, 1)), np.ones((1, 60)), 0
    )
    assert len(NativeDiagram(wiring_of(system)).code.program.components) < 200
    x, asks = random.normal(size=60), readings(system)
    found = [asks[name](0.0, x, [0.5])[0] for name in ("native", "lanes")]
    np.testing.assert_allclose(found, [system.A @ x + 0.5] * 2, rtol=1e-12, atol=1e-12)


@pytest.mark.long
def test_products_of_small_matrices_are_loops_where_they_are_many():
    """exp(S), its series: as straight code it would take more than 60,000 operations."""
    n = 16

    def turn(t, x, u, p):
        series = np.eye(n)
        for k in range(18, 0, -1):
            series = np.eye(n) + (x.S - x.S.T) @ series / k
        return series

    block = Block("turn", update=turn, states={"S": (n, n)})
    assert len(NativeDiagram(block).code.program.components) < 200
    S = np.random.default_rng(3).normal(size=(n, n)) / n
    found = readings(block)["native"](0.0, S.ravel(), [])[0]
    np.testing.assert_allclose(
        found, scipy.linalg.expm(S - S.T).ravel(), rtol=0, atol=1e-12
    )


def test_many_inputs_that_nothing_feeds_are_a_whole_array():
    """They are 0, which stood as one number where an array was joined, and reshaped."""
    sizes = {"inputs": 20, "outputs": 20, "states": 20}
    joined = lambda t, x, u, p: np.sin(np.r_[u, u.reshape(4, 5)[:, 2]])[4:] - x  # noqa: E731
    lags = control.nlsys(joined, None, name="lags", **sizes)
    source = control.nlsys(lambda t, x, u, p: u - x, None, name="source", **sizes)
    outer = [f"source.u[{k}]" for k in range(20)]
    loop = control.interconnect(
        [lags, source], False, outer, ["lags.y[0]", "lags.y[7]"]
    )
    run = clpt.simulate(loop, [0.0, 1.0], initial_state=np.ones(40))
    assert run.attrs["engine"] == "native"
    np.testing.assert_allclose(run.states[-1], np.exp(-1.0), rtol=1e-6)


@pytest.mark.parametrize("count", [40, 80])
def test_a_function_that_is_called_often_is_written_once(count):
    """LLVM took minutes where thousands of sines stood one behind the other."""

    def rate(t, x, u, p):
        total = 0.0
        for k in range(count):
            total = np.sin(x[0] + k * total)
        return total

    program = NativeDiagram(Block("b", update=rate, states={"x": 1})).code.program
    text = str(print_program(program, ("derivative",), 1))
    assert ("noinline" in text, "alwaysinline" in text) == (count > 64, count < 64)


def test_a_state_that_is_looked_up_by_its_place_moves_within_a_step():
    """y' = z[k], where z = (1 + t, 2 - 3 t) and k rests at 1."""
    rates = lambda t, x, u, p: {"z": [1.0, -3.0], "k": 0.0, "y": x.z[int(x.k[0])]}  # noqa: E731
    native = NativeDiagram(
        wiring_of(Block("b", update=rates, states={"z": 2, "k": 1, "y": 1}))
    )
    times = np.array([0.0, 0.7, 3.0])
    y = native.run([1.0, 2.0, 1.0, 0.0], times).x[:, 3]
    np.testing.assert_allclose(y, 2.0 * times - 1.5 * times**2, rtol=0, atol=1e-12)


HALVES = [k / 2 for k in range(-18, 19) if k]
WHOLE = [exponent for exponent in HALVES if exponent % 1 == 0]


@pytest.mark.long
@pytest.mark.parametrize(
    ("base", "exponents"),
    [(0.3, HALVES), (7.0, HALVES), (0.0, HALVES), (-0.0, HALVES), (-0.7, WHOLE)],
)
def test_whole_and_half_powers_are_those_of_numpy(base, exponents):
    """The angle of a power is finite also where the power is infinite."""

    def angles(t, x, u, p):
        return [np.arctan(x[0] ** exponent) for exponent in exponents]

    size = {"inputs": 0, "states": 1, "outputs": len(exponents)}
    rest = control.nlsys(lambda t, x, u, p: [0.0], angles, **size, name="rest")
    found = clpt.simulate(rest, [0.0, 1.0], initial_state=[base])
    assert found.attrs["engine"] == "native"
    with np.errstate(divide="ignore"):
        powers = np.float64(base) ** np.array(exponents)
    np.testing.assert_allclose(found.y.values[0], np.arctan(powers), rtol=3e-15)
    compare_backends(rest)
