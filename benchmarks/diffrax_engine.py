"""diffrax: Dopri8 on the traced diagram, started again at each waypoint."""

import diffrax
import jax
import jax.numpy as jnp
import numpy as np

import clpt_control as clpt
from clpt_control import initial_state

from .cases import Case
from .engines import timed
from .traced import boxed, rates

jax.config.update("jax_enable_x64", True)
FUNCTIONS = {"exp": jnp.exp, "cos": jnp.cos, "sin": jnp.sin, "sqrt": jnp.sqrt}


def _stretch(scenario):
    """Return a function from one waypoint's start to its end."""
    diagram, N, run = clpt.closed_loop(scenario), scenario.basis.N, scenario.run

    def derivative(t, y, arguments):
        zc, theta, gain = arguments
        own = {
            ("true_flow", "theta"): boxed(theta).reshape(2, N),
            ("adaptation", "gain"): gain,
        }
        found = rates(diagram, t, y, FUNCTIONS, {"reference": zc}, own)
        return jnp.stack([jnp.asarray(f) for f in found])

    def stretch(y, start, end, zc, theta, gain):
        return diffrax.diffeqsolve(
            diffrax.ODETerm(derivative),
            diffrax.Dopri8(),
            start,
            end,
            None,
            y,
            (zc, theta, gain),
            saveat=diffrax.SaveAt(t1=True),
            stepsize_controller=diffrax.PIDController(rtol=run.rtol, atol=run.atol),
            max_steps=None,
        ).ys[0]

    return stretch


def _whole(scenario, times):
    """Return a function that runs one member through every waypoint."""
    stretch, points = _stretch(scenario), scenario.waypoints
    zc = jnp.asarray(points[np.arange(len(times) - 1) % len(points)])
    starts, ends = jnp.asarray(times[:-1]), jnp.asarray(times[1:])

    def whole(y0, theta, gain):
        def body(y, interval):
            new = stretch(y, *interval, theta, gain)
            return new, new

        return jax.lax.scan(body, y0, (starts, ends, zc))[1]

    return whole


def prepare(case: Case):
    """Prepare one run, compiled before it is timed."""
    scenario = case.scenario
    x0 = initial_state(scenario)
    theta, gain = (
        jnp.ravel(jnp.asarray(scenario.flow.parameters)),
        scenario.learning.gain,
    )
    whole = jax.jit(_whole(scenario, case.times))

    def run():
        states, seconds = timed(lambda: np.asarray(whole(jnp.asarray(x0), theta, gain)))
        return np.vstack([x0, states]), seconds

    run()
    return run


def members(scenario):
    """Prepare an ensemble with vmap; each new size is compiled before it is timed."""
    N, dwell = scenario.basis.N, scenario.reference.dwell
    times = dwell * np.arange(round(scenario.run.duration / dwell) + 1)
    one = _whole(scenario, times)
    every = jax.jit(jax.vmap(lambda y, theta, gain: one(y, theta, gain)[-1]))
    sizes: set[int] = set()

    def run(parameters, states):
        parts = (states, parameters[:, 5 * N : 7 * N], parameters[:, -1])
        arguments = [jnp.asarray(part) for part in parts]
        if len(states) not in sizes:
            sizes.add(len(states))
            np.asarray(every(*arguments))
        return timed(lambda: np.asarray(every(*arguments)))

    return run
