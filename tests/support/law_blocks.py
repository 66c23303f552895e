"""Laws of the user's own for tests, what a module of theirs would hold, and runs of laws.

u = e[2], phi_x[N], z[2], zc[2]; states alpha[2N], K[2], Gamma[2], section III.
"""

import numpy as np

import clpt_control as clpt

EACH = {"parameters": 0.8, "feedback": 0.3, "feedforward": 0.5}  # a gain for each part
TRUE_GAINS = {"learning.feedback": [1, 1], "learning.feedforward": [1, 1]}
HELD = {"learning.adapt_gains": False, **TRUE_GAINS}


LEARNED = {"alpha": (2, "N"), "K": 2, "Gamma": 2}


def remembering(t, x, u, p):
    """alpha' = -gamma e phi^T, K and Gamma held, and a count m' = p.start, section III."""
    return {
        "alpha": -p.gain * np.outer(u.e, u.phi_x),
        "K": 0.0,
        "Gamma": 0.0,
        "m": p.start,
    }


def remembering_law(N=3, gain=0.8, start=0.5):
    ports = {
        "inputs": {"e": 2, "phi_x": "N"},
        "states": {**LEARNED, "m": 1},
        "sizes": {"N": N},
    }
    own = {"gain": gain, "start": start}
    return clpt.Block("mine", update=remembering, parameters=own, **ports)


def filled(u, gain, e):
    """Eqs. (21)-(23) with this gain and this error."""
    return {
        "alpha": -gain * np.outer(e, u.phi_x),
        "K": -gain * u.z * e,
        "Gamma": gain * u.zc * e,
    }


def papers(t, x, u, p):
    """Eqs. (21)-(23), one gain for all."""
    return filled(u, p.gain, u.e)


def papers_law(N=3, gain=0.8, name="mine"):
    """The paper's own, as a block that no table knows."""
    inputs = {"e": 2, "phi_x": "N", "z": 2, "zc": 2}
    ports = {"inputs": inputs, "states": LEARNED, "sizes": {"N": N}}
    return clpt.Block(name, update=papers, parameters={"gain": gain}, **ports)


def still(row, N=1, **own):
    """Make a law of the table whose K and Gamma stand, beside a model of calm water."""
    return row.of(
        N, **{"alpha_M": np.zeros((2, N)), "gain_K": 0.0, "gain_Gamma": 0.0, **own}
    )


def of_law(law, values, held=False):
    """The paper's scenario with a law at its defaults; K and Gamma are adapted, or held true."""
    own = HELD if held else {"learning.gain": None}
    return clpt.paper_scenario().with_values({"learning.law": law, **own, **values})


def everything(scenario, **values):
    """Run a scenario to a thousandth of its tolerance, and keep every signal by its port."""
    tight = {"run.rtol": 1e-11, "run.atol": 1e-13}
    return clpt.simulate(clpt.closed_loop(scenario.with_values({**tight, **values})))


def square(run, port, n=3):
    """Return the matrices of a port, shape (time, n, n)."""
    return run[port].values.reshape(-1, n, n)


def off(run):
    """Return the largest error of the flow parameters along a run."""
    return np.abs(run.flow_parameters_estimate - run.flow_parameters).max(
        ("axis", "basis")
    )


def places(labels):
    """Return where each port is among labels, as K[0] and K[1] are of K."""
    ports = [label.partition("[")[0] for label in labels]
    return {port: [k for k, one in enumerate(ports) if one == port] for port in ports}


def alone(law, t, phi, theta, **start):
    """Run a law of one without CLPE: its signals by port, where theta phi carries a vehicle from 0.

    phi (N, times), theta (2, N); v = 0, and states begin at 0 but for those in `start`.
    """
    inputs, columns = places(law.input_labels), places(law.state_labels)
    u, flow = np.zeros((law.ninputs, len(t))), theta @ phi
    u[inputs["phi_x"]] = phi
    steps = np.diff(t) * (flow[:, 1:] + flow[:, :-1]) / 2  # inputs are straight lines
    u[inputs["x"], 1:] = np.cumsum(steps, axis=1)
    state = np.zeros(law.nstates)
    for port, value in start.items():
        state[columns[port]] = np.ravel(value)
    loop = clpt.connect([law], external=list(law.input_ports))
    run = clpt.simulate(loop, t, u, state, rtol=1e-11, atol=1e-13)
    return {port: run.states.values.T[column] for port, column in columns.items()}, run
