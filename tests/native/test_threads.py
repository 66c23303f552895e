"""Threads that compile at the same moment share the code; those that call a block share no call."""

import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import control
import numpy as np

from clpt_control import Block

ASKED_AT_ONCE = """
from concurrent.futures import ThreadPoolExecutor
from threading import Barrier
import numpy as np
import clpt_control as clpt

scenario = clpt.paper_scenario().with_values({"run.duration": 40})
loop, state, count = clpt.closed_loop(scenario), clpt.initial_state(scenario), 6
together = Barrier(count)

def run(k):
    native = clpt.native.compile(loop)
    together.wait()
    found = [native.run_many(np.tile(state, (m, 1)), [0.0, 40.0]) for m in (1, 8)]
    return native.code, found[0][0], found[1][0]

with ThreadPoolExecutor(count) as pool:
    found = list(pool.map(run, range(count)))
assert len({id(code) for code, _, _ in found}) == 1
for _, *states in found:
    for one in states:
        np.testing.assert_allclose(one, found[0][1], rtol=1e-12, atol=1e-12)
"""


def test_threads_that_compile_at_once():
    done = subprocess.run([sys.executable, "-c", ASKED_AT_ONCE], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def test_each_thread_runs_a_shared_block_with_its_own_params():
    block = Block(
        "plant", update=lambda t, x, u, p: -p.rate * x, states={"x": 1}, parameters={"rate": 1.0}
    )
    rates, times = 1.0 + 0.3 * (np.arange(48) % 8), np.linspace(0.0, 1.0, 20)

    def run(rate):
        asked = {"params": {"plant.rate": rate}, "solve_ivp_kwargs": {"rtol": 1e-8}}
        return control.input_output_response(block, times, 0, [1.0], **asked).states[0]

    with ThreadPoolExecutor(8) as pool:
        found = np.array(list(pool.map(run, rates)))
    np.testing.assert_allclose(found, np.exp(-np.outer(rates, times)), atol=1e-5)
