"""Members of ensembles against single runs of `simulate`: equal to the last bit."""

import numpy as np
import pytest

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
