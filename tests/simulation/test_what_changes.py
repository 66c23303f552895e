"""What a function names may change after its block was made: the next run counts."""

import numpy as np
import pytest

import clpt_control as clpt

SHORT = clpt.paper_scenario().with_values({"run.duration": 20})
GAIN = 0.8


def adaptation(t, x, u, p):
    alpha = -GAIN * np.outer(u.e, u.phi_x)
    return {"alpha": alpha, "K": -GAIN * u.z * u.e, "Gamma": GAIN * u.zc * u.e}


@pytest.fixture
def law():
    return clpt.Block(
        "adaptation",
        update=adaptation,
        inputs={"e": 2, "phi_x": "N", "z": 2, "zc": 2},
        states={"alpha": (2, "N"), "K": 2, "Gamma": 2},
        sizes={"N": 3},
    )


@pytest.mark.parametrize("engine", ["native", "python"])
def test_a_global_that_changes_counts_at_the_next_run(law, monkeypatch, engine):
    def run():
        return clpt.simulate(clpt.closed_loop(SHORT, law=law), engine=engine)

    for gain in (0.8, 1.6):
        monkeypatch.setitem(globals(), "GAIN", gain)
        expected = clpt.simulate(SHORT.with_values({"learning.gain": gain}))
        np.testing.assert_allclose(run().alpha, expected.alpha, rtol=1e-6, atol=1e-8)


def test_a_global_that_changes_counts_in_an_ensemble_and_a_proof(law, monkeypatch):
    before = clpt.run_ensemble(clpt.closed_loop(SHORT, law=law), "flow.parameters~normal:0.1", 2)
    assert clpt.theory.prove(law, points=200).status == "proved"
    monkeypatch.setitem(globals(), "GAIN", -0.8)
    after = clpt.run_ensemble(clpt.closed_loop(SHORT, law=law), "flow.parameters~normal:0.1", 2)
    assert not np.allclose(before.flow_parameter_error, after.flow_parameter_error)
    assert clpt.theory.prove(law, points=200).status != "proved"
