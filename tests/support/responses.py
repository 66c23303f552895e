"""A diagram's run as python-control has responses: arrays of shape (signals, times)."""

from types import SimpleNamespace

import numpy as np

import clpt_control as clpt
from clpt_control.simulation.dataset import VARIABLES

NAMES = {port: name for name, (port, *_) in VARIABLES.items()}


def response(system, *args, **kwargs):
    """Run a diagram; return its time, outputs, states and inputs in the order of its labels."""
    run = clpt.simulate(system, *args, **kwargs)

    def signals(labels):
        found = []
        for label in labels:
            port, _, number = label.partition("[")
            values = run[NAMES[port] if NAMES.get(port) in run else port].values
            found.append(
                values.reshape(len(values), -1)[:, int(number.rstrip("]") or 0)]
            )
        return np.array(found)

    shown = {"message": run.attrs["message"], "output_labels": system.output_labels}
    shown |= {
        "inputs": signals(system.input_labels),
        "outputs": signals(system.output_labels),
    }
    return SimpleNamespace(time=run.time.values, states=run.states.values.T, **shown)


def states_of(run):
    """States over time in the order of tests/reference; alpha is recorded under either law."""
    order = (
        "position",
        "predicted_position",
        "alpha",
        "feedback_gain",
        "feedforward_gain",
    )
    return np.hstack(
        [run[name].values.reshape(run.sizes["time"], -1) for name in order]
    )
