"""What the record of a block computes, beside what its functions do."""

import math

import numpy as np

from clpt_control.equations import Block


def recorded(block, role, t, x, u):
    """Return what the record of a role computes."""
    given = {("t", "t"): np.float64(t)}
    for group, values, shapes in (("x", x, block.state_shapes), ("u", u, block.input_shapes)):
        at, values = 0, np.asarray(values, dtype=float)
        for port, shape in shapes.items():
            size = math.prod(shape)
            given[group, port] = values[at : at + size].reshape(shape)
            at += size
    given |= {("p", name): value for name, value in block.parameters._asdict().items()}
    found = block.array_record(role).values(lambda group, name: given[group, name], block.sizes)
    return np.concatenate([np.ravel(value) for value in found])


def run(block, role, t, x, u):
    """Return what the function of a role gives."""
    size = block.noutputs if role == "output" else block.nstates
    return block.values(role, size, t, np.array(x, float), np.array(u, float), block.parameters)


def as_it_runs(block, role, t, x, u, tolerance=1e-14):
    """Compare the two, and the scalars' record with them; return the numbers."""
    wanted = run(block, role, t, x, u)
    np.testing.assert_allclose(
        recorded(block, role, t, x, u), wanted, rtol=tolerance, atol=tolerance
    )
    return wanted


def static(function, inputs=3, outputs=1, **more):
    """Make a block of one function of inputs."""
    ports = inputs if isinstance(inputs, dict) else {"u": inputs}
    out = outputs if isinstance(outputs, dict) else {"y": outputs}
    return Block("mine", output=function, inputs=ports, outputs=out, **more)
