"""Members of ensembles against single runs of `simulate`: equal to the last bit."""

import control
import numpy as np
import pytest
import slope_limiter

import clpt_control as clpt


def network(seed):
    """A random network of 3 to 12 states; some have inputs, a sum of bumps, a guard or jumps."""
    draw = np.random.default_rng(seed)
    n = int(draw.integers(3, 13))
    A = draw.normal(size=(n, n)) - 3.0 * np.eye(n)
    terms = draw.normal(size=(3, n))
    centers = np.linspace(-2.0, 2.0, 7 + seed)

    def rates(t, x, u, p):
        total = A @ x.x + terms[0] * np.sin(p.k * x.x) + terms[1] * u.u
        if seed % 3:
            bumps = np.exp(-((x.x[0] - centers) ** 2))
            total = total + terms[2] * np.sum(bumps * centers)
        return total

    given = {}
    if seed % 4 == 1:
        given["guard"] = clpt.Guard(lambda t, x, u, p: 2.5 - np.sum(x.x**2), "stop")
    if seed % 4 == 2:
        given["jump"] = lambda t, x, u, p: -0.5 * x.x
        given["breakpoints"] = lambda p, t0, t1: np.array([0.7, 1.9])
    if seed % 4 == 3:
        given["guard"] = clpt.Guard(lambda t, x, u, p: x.x[0] + 0.3, "jump")
        given["jump"] = lambda t, x, u, p: np.abs(x.x)
    parameters = {"k": 1.0} | ({"interval": -1.0} if seed % 4 == 2 else {})
    return clpt.Block(
        "network",
        update=rates,
        output=lambda t, x, u, p: x.x,
        inputs={"u": 1},
        outputs={"y": n},
        states={"x": n},
        parameters=parameters,
        **given,
    ), 0.3 * draw.normal(size=n)


@pytest.mark.parametrize("seed", range(12))
def test_members_have_the_bits_of_simulate(seed):
    """Eight members run side by side: their sums have the order of one run."""
    block, start = network(seed)
    times = np.linspace(0.0, 3.0, 13)
    given = {"timepts": times, "inputs": np.sin(times), "initial_state": start}
    rates = np.linspace(0.3, 3.0, 11)
    data = clpt.run_ensemble(block, {"network.k": rates}, trajectories=True, **given)
    for m, k in enumerate(rates):
        alone = clpt.simulate(block, params={"network.k": k}, **given)
        member = data.isel(member=m)
        last = alone.y[-1].values
        assert member.y_final.values.tobytes() == last.tobytes()
        samples = times[np.isin(times, alone.time)]
        wanted = alone.y.sel(time=samples).values
        found = member.y.sel(time=samples).values
        assert found.tobytes() == wanted.tobytes()


def climber():
    """A height that rises by 1 m/s up to an edge."""
    return clpt.Block(
        "climber",
        update=lambda t, x, u, p: p.speed,
        output=lambda t, x, u, p: x.h,
        outputs={"height": 1},
        states={"h": 1},
        parameters={"speed": 1.0, "edge": 1.0},
        guard=clpt.Guard(lambda t, x, u, p: p.edge - x.h, "stop"),
    )


@pytest.mark.parametrize("beside", [0.0, -1e-13, 1e-13, "below", "above"])
def test_a_stop_at_a_sample_is_the_sample_of_simulate(beside):
    """The height is t.  A stop at a sample, or an ulp beside it, is the last sample."""
    times = np.linspace(0.0, 2.0, 21)
    edges = times[1:-1]
    if isinstance(beside, str):
        edges = np.nextafter(edges, np.inf if beside == "above" else -np.inf)
    else:
        edges = edges + beside
    vary = {"climber.edge": edges}
    data = clpt.run_ensemble(climber(), vary, timepts=times, trajectories=True)
    assert (data.status == 10).all()
    np.testing.assert_allclose(data.height_final, edges, rtol=0.0, atol=1e-12)
    for m, edge in enumerate(edges):
        member = data.isel(member=m)
        alone = clpt.simulate(climber(), times, params={"climber.edge": edge})
        assert member.end == alone.time[-1]
        assert member.height_final == alone.height[-1]
        in_run = np.isin(times, alone.time)
        wanted = alone.height.sel(time=times[in_run]).values
        assert member.height.values[in_run].tobytes() == wanted.tobytes()
        assert np.isnan(member.height.values[~in_run]).all()


def limited(t, x, u, p):
    """Rates of Burgers' equation with a slope limiter, on 20 cells: 100 kinks."""
    return p["k"] * slope_limiter.limited(x)


def root_at_k(t, x, u, p):
    """Return the rates of a clock, and of a sum that has no Taylor series at the time k."""
    return [1.0 + 0.0 * u[0], u[0] + ((x[0] - p["k"]) ** 2) ** 0.75]


def friction(t, x, u, p):
    return [x[1], 0.2 - x[0] - p["k"] * np.sign(x[1])]


def van_der_pol(t, x, u, p):
    return [x[1], p["k"] * (1.0 - x[0] ** 2) * x[1] - x[0]]


def hysteresis(t, x, u, p):
    """Return the rates of Bouc and Wen: |z|^0.5 has no value where the sign of z is held."""
    q, v, z = x
    slip = 0.6 * np.abs(v) * np.abs(z) ** 0.5 * z + 0.3 * v * np.abs(z) ** 1.5
    return [v, np.sin(t) - 0.2 * v - p["k"] * q - 0.5 * z, v - slip]


WAVE = 1.2 + np.sin(2.0 * np.pi * (np.arange(20) + 0.5) / 20.0)
SECONDS = np.linspace(0.0, 4.0, 21)
LEGS = {  # rates, times, k, initial state, and the words of a run's method
    "series": (root_at_k, SECONDS, (0.9, 3.0), [0.0, 0.0], ", from t = 3 DOP853"),
    "kinks": (limited, SECONDS, (0.5, 1.5), WAVE, "DOP853"),
    "slides": (friction, 5.0 * SECONDS, (0.1, 1.1), [2.0, 0.0], "sliding"),
    "stiff": (van_der_pol, 500.0 * SECONDS, (1.0, 501.0), [2.0, 0.0], "Rodas5P"),
    "stuck": (hysteresis, SECONDS, (0.5, 1.5), [0.01, 0.0, 0.0], "not located"),
}


@pytest.mark.parametrize("threads", [1, 2])
@pytest.mark.parametrize("name", LEGS)
def test_members_go_on_as_simulate_does(name, threads):
    rates, times, bounds, start, words = LEGS[name]
    n, is_series = len(start), name == "series"
    states = [f"s{k}" for k in range(n)]
    system = control.nlsys(
        rates,
        inputs=int(is_series),
        states=states,
        outputs=states,
        params={"k": 1.0},
        name=name,
    )
    given = {"timepts": times, "initial_state": start}
    if is_series:
        given |= {"inputs": np.abs(times - 2.0), "method": "taylor"}
    values = np.linspace(*bounds, 11)
    data = clpt.run_ensemble(
        system, {"k": values}, trajectories=True, threads=threads, **given
    )
    for m, k in enumerate(values):
        alone = clpt.simulate(system, params={"k": k}, **given)
        for state in states:
            found = data[state][m].values
            assert found.tobytes() == alone[state].values.tobytes()
    assert words in alone.attrs["method"]


@pytest.mark.parametrize("outputs", [["y"], ["y", "z"]])
def test_zeros_of_members_have_the_sign_of_simulate(outputs):
    """The output -k x of k = 0 is -0.0, as it is in `simulate` and in NumPy."""
    system = control.nlsys(
        lambda t, x, u, p: [-x[0]],
        lambda t, x, u, p: [-p["k"] * x[0], x[0]][: len(outputs)],
        inputs=0,
        outputs=outputs,
        states=1,
        params={"k": 1.0},
        name="decay",
    )
    given = {"timepts": [0.0, 1.0], "initial_state": [1.0]}
    data = clpt.run_ensemble(system, {"k": [0.0, 1.0]}, trajectories=True, **given)
    alone = clpt.simulate(system, params={"k": 0.0}, **given)
    for run in (alone.y, data.y[0], data.y_final[0]):
        assert (run == 0.0).all()
        assert np.signbit(run).all()


@pytest.mark.parametrize("count", [2, 9])
def test_a_member_that_begins_outside_its_jumps_fails_alone(count):
    """A height 1 falls to 1 - g t^2 / 2; no ball begins below the floor."""
    ball = clpt.Block(
        "ball",
        update=lambda t, x, u, p: [x.v, -9.81],
        output=lambda t, x, u, p: x.h,
        outputs={"height": 1},
        states={"h": 1, "v": 1},
        guard=clpt.Guard(lambda t, x, u, p: x.h, "jump"),
        jump=lambda t, x, u, p: [0.0, -0.8 * x.v],
    )
    heights = np.array([1.0] * count)
    heights[1] = -1e-12
    with pytest.warns(UserWarning, match="member 1: .* outside of the guard of ball"):
        data = clpt.run_ensemble(ball, {"h[0]": heights}, timepts=[0.0, 0.1])
    assert (data.status == 1).values.tolist() == (heights == 1.0).tolist()
    np.testing.assert_allclose(data.height_final[heights == 1.0], 1.0 - 0.04905)
    assert np.isnan(data.height_final[1])
