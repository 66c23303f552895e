"""One of each thing that is drawn, shown or asked."""

import control
import pytest

import clpt_control as clpt


@pytest.fixture(scope="session")
def scenario():
    return clpt.paper_scenario().with_values({"run.duration": 40.0})


@pytest.fixture(scope="session")
def made(scenario):
    dives = clpt.gliders.sample_dives()
    team = clpt.Team(members={"a": scenario, "b": scenario}, coupling=0.5)
    run = clpt.simulate(scenario)
    few = scenario.with_values({"reference.count": 2})
    return {
        "run": run,
        "fixes": clpt.currents.flow_estimate(run, every=5.0),
        "diagram": clpt.simulate(
            control.ss(-1, 1, [[1], [2]], 0, name="lag"), [0, 1, 2], [0, 1, 2]
        ),
        "team": clpt.simulate(team),
        "ensemble": clpt.run_ensemble(scenario, "learning.gain=0.2:2.0", 3),
        "replay": clpt.replay.replay_dives(dives[:5]),
        "design": clpt.theory.design_track(few, goal="kappa", window=20),
    }
