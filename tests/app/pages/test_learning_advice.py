"""Advice to a run that did not learn: a sentence for each fault, with the remedy."""

import pytest

from clpt_control.app.pages.results import REMEDY, learning_advice

WORSE = "the flow learned is worse than the mean current"
RISES = "CLPE does not fall: its last cycle is above the first"


@pytest.mark.parametrize(
    ("rms", "track", "box", "said"),
    [
        ([0.2, 0.1], 0.9, 0.4, []),
        ([0.2, 0.2], 0.0, None, []),
        ([0.2], 0.9, 0.4, []),
        ([], None, None, []),
        ([0.2, 0.1], -0.1, 0.4, [WORSE]),
        ([0.2, 0.1], 0.9, -0.4, [WORSE]),
        ([0.1, 0.05, 0.2], 0.9, 0.4, [RISES]),
        ([0.1, 0.2], -0.1, 0.4, [RISES, WORSE]),
    ],
)
def test_faults_of_learning(rms, track, box, said):
    shares = {"track": track, "box": box, "window": [10.0, 20.0]}
    numbers = {"clpe_rms_per_cycle": rms, "explained_variance": shares}
    expected = [f"{'; '.join(said)}. {REMEDY}"] if said else []
    assert learning_advice({"": numbers}) == expected


def test_each_vehicle_of_a_team_has_its_sentence():
    falls, rises = {"clpe_rms_per_cycle": [2, 1]}, {"clpe_rms_per_cycle": [1, 2]}
    advice = learning_advice({"north: ": falls, "south: ": rises})
    assert advice == [f"south: {RISES}. {REMEDY}"]
