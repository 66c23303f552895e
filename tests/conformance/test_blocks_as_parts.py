"""Each block of the package alone in a diagram of python-control, with call-time parameters."""

import control
import numpy as np
import pytest
from package_blocks import EACH

from clpt_control.conformance.checks import differ, python_values, random_samples, roles
from clpt_control.errors import BlockError


def alone(block):
    names = [f"{block.name}.{label}" for label in block.input_labels]
    return control.interconnect(
        [block],
        connections=False,
        inplist=names,
        outlist=[f"{block.name}.{label}" for label in block.output_labels],
        inputs=block.input_labels,
        outputs=block.output_labels,
        name="alone",
        check_unused=False,
    )


@pytest.mark.parametrize("block", EACH)
def test_alone_in_a_diagram_it_gives_the_same_and_parameters_reach_it(block):
    diagram = alone(block)
    for sample in random_samples(block, 0, 3):
        calls = {"update": diagram.dynamics, "output": diagram.output}
        for role in calls.keys() & roles(block):
            given = calls[role](sample.t, sample.x, sample.u)
            assert not differ(python_values(block, role, sample), given), role
    arguments = (sample.t, sample.x, sample.u)
    for field, value in block.parameters._asdict().items():
        if isinstance(value, int):
            continue
        other = np.where(np.asarray(value) == 0, 0.125, 1.25 * np.asarray(value))
        changed = {f"{block.name}.{field}": 3.0 if field == "interval" else other[()]}
        arrived = block.with_params(changed)
        np.testing.assert_array_equal(getattr(arrived, field), changed[f"{block.name}.{field}"])
        p = block.parameters_at(sample.t, arrived)
        try:
            calls = [system.output(*arguments, params=changed) for system in (block, diagram)]
        except RuntimeError:  # python-control takes NaN, as of a table too short, for a loop
            continue
        finally:
            block._update_params(None)
        ours = python_values(block, "output", sample._replace(p=p))
        assert not any(differ(ours, given) for given in calls), field
    for unknown in (f"{block.name}.no_such_field", "no_such_block.gain", "no_such_name"):
        with pytest.raises(BlockError, match="unknown parameter"):
            block.output(*arguments, params={unknown: 1.0})
    ours = block.output(*arguments)
    assert not differ(ours, diagram.output(*arguments, params={"another_block.gain": 1.0}))
