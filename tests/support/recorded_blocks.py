"""What the record of a block computes, beside what its functions do."""

import numpy as np

from clpt_control import Block


def recorded(block, role, t, x, u):
    """Return what the record of a role computes."""
    return block.on_arrays(
        role, t, np.asarray(x, dtype=float), np.asarray(u, dtype=float)
    )


@np.errstate(all="ignore")
def run(block, role, t, x, u):
    """Return what the function of a role gives."""
    size = block.noutputs if role == "output" else block.nstates
    p = block.parameters_at(t, block.parameters)
    return block.values(role, size, t, np.array(x, float), np.array(u, float), p)


def as_it_runs(block, role, t, x, u, tolerance=1e-14):
    """Compare the two, and the scalars' record with them; return the numbers."""
    wanted, found = run(block, role, t, x, u), recorded(block, role, t, x, u)
    np.testing.assert_allclose(found, wanted, rtol=tolerance, atol=tolerance)
    return wanted


def static(function, inputs=3, outputs=1, **more):
    """Make a block of one function of inputs."""
    ports = inputs if isinstance(inputs, dict) else {"u": inputs}
    out = outputs if isinstance(outputs, dict) else {"y": outputs}
    return Block("mine", output=function, inputs=ports, outputs=out, **more)
