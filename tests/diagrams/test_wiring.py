"""A wiring made from ports is the one that python-control's matrices are read as."""

import numpy as np
import pytest

import clpt_control as clpt
from clpt_control.diagrams import wiring
from clpt_control.diagrams.interconnection import connect, wiring_of_blocks
from clpt_control.diagrams.wiring import wiring_of
from clpt_control.equations import Block

PAPER = clpt.paper_scenario()
SQUARE = {"kind": "square", "amplitude": [0.05, 0.02], "period": 1.8}


def same(one, other):
    assert one.ninputs == other.ninputs
    assert one.order == other.order
    assert one.output_map.shape == other.output_map.shape
    maps = [wiring.output_map @ np.eye(wiring.output_map.shape[1]) for wiring in (one, other)]
    np.testing.assert_array_equal(*maps)
    for mine, theirs in zip(one.nodes, other.nodes, strict=True):
        assert mine.name == theirs.name
        for part in ("states", "inputs", "outputs"):
            assert getattr(mine, part) == getattr(theirs, part)
        assert sorted(mine.wires) == sorted(theirs.wires)


@pytest.mark.parametrize(
    "changes",
    [
        {},
        {"flow.disturbance": SQUARE},
        {
            "learning.law": "known-flow",
            "learning.parameters": None,
            "learning.theta_estimate": [[1.0, 0.5, 0.8], [0.9, 0.4, 0.7]],
        },
    ],
)
@pytest.mark.parametrize("external", [(), ("zc",), ("x",), ("x", "zc")])
def test_the_paper(changes, external):
    loop = clpt.closed_loop(PAPER.with_values(changes), external)
    same(wiring_of_blocks(loop.syslist, external), wiring_of(loop))


def passed_on(t, x, u, p):
    return u


def test_ports_in_another_order_than_their_makers():
    def block(name, inputs, outputs):
        return Block(name, output=passed_on, inputs=inputs, outputs=outputs)

    blocks = [
        block("last", {"d": 1, "c": 2, "w": 1}, {"e": 4}),
        block("middle", {"b": 2, "a": 2}, {"c": 2, "d": 1, "f": 1}),
        block("first", {"w": 1, "v": 3}, {"a": 2, "b": 2}),
    ]
    for external in (["v", "w"], ["w", "v"]):
        same(wiring_of_blocks(blocks, external), wiring_of(connect(blocks, external)))


def test_a_run_reads_its_wiring_once(monkeypatch):
    made = []

    class Counted(wiring.Wiring):
        def __init__(self, *parts):
            made.append(1)
            super().__init__(*parts)

    monkeypatch.setattr(wiring, "Wiring", Counted)
    scenario = PAPER.with_values({"run.duration": 2})
    clpt.simulate(scenario)
    assert len(made) == 1
    loop, start = clpt.closed_loop(scenario), clpt.initial_state(scenario)
    made.clear()
    clpt.simulate(loop, [0.0, 2.0], initial_state=start)
    assert len(made) == 1
