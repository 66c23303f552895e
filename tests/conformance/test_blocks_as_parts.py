"""Each block of the package as a part: copied, alone in a diagram, with call-time parameters."""

import control
import numpy as np
import pytest
from package_blocks import BLOCKS, EACH

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


@pytest.mark.parametrize("case", EACH)
def test_a_copy_shares_nothing(case):
    block = BLOCKS[case]
    before = [np.array(value) for value in block.parameters]
    twin = block.copy(name=f"{block.name}_copy")
    assert twin.name == f"{block.name}_copy"
    assert list(twin.params) == [twin.name]
    for sample in random_samples(block, 0, 3):
        for role in roles(block):
            ours, theirs = (python_values(one, role, sample) for one in (block, twin))
            np.testing.assert_array_equal(ours, theirs)
    for value in twin.parameters:
        if isinstance(value, np.ndarray):
            value.flags.writeable = True
            value += 1.0
    for old, new in zip(before, block.parameters, strict=True):
        np.testing.assert_array_equal(old, new)


@pytest.mark.parametrize("case", EACH)
def test_alone_in_a_diagram_it_gives_the_same(case):
    block = BLOCKS[case]
    diagram = alone(block)
    for sample in random_samples(block, 0, 5):
        calls = {"update": diagram.dynamics, "output": diagram.output}
        for role in calls.keys() & roles(block):
            given = calls[role](sample.t, sample.x, sample.u)
            assert not differ(python_values(block, role, sample), given), role


@pytest.mark.parametrize("case", EACH)
def test_parameters_reach_it_by_name(case):
    block = BLOCKS[case]
    diagram, sample = alone(block), random_samples(block, 0, 1)[0]
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
