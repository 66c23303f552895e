"""Promises of the laws in words: each claim, and the conditions under which a law makes it."""

import numpy as np

from ...paper.laws.law import Law, Truth
from ...paper.scenario.experiment import Scenario

CLAIMS = {
    "falls": "V never rises",
    "settles": "CLPE goes to zero, its weighed square integral at most V(0)",
    "mean square": "in the mean CLPE is at most the flow that the law does not know, over KD",
    "zone": "CLPE comes to the zone",
    "exponential": "V falls exponentially, at the rate that the memories have reached, for good",
    "level": "V never rises above a level",
    "balls": "what is learned stays within the limits",
    "shrinks": "each parameter's error only shrinks",
    "estimate": "the error of the estimate, over its covariance, never rises",
    "readout": "the readout is theta",
}
CONDITIONS = {
    "spanned": "the functions span the flow",
    "exact": "positions are exact (at fixes z(0) too)",
    "true": "K and Gamma adapt, or are held at the vehicle's own",
    "within": "the truth lies within the limits",
    "small": "the disturbance is at most KD times the zone",
    "bounded": "the disturbance is bounded",
    "uniform": "phi at the prediction is phi at the vehicle",
}


def what_it_promises(row: Law) -> str:
    """Return the promises of a law without conditions."""
    return "; ".join(CLAIMS[promise.claim] for promise in row.promises)


def promises_in_words(row: Law) -> dict[str, str]:
    """Return each promise of a law as text, with its conditions."""
    texts = {}
    for promise in row.promises:
        conditions = "; ".join(CONDITIONS[name] for name in promise.conditions)
        words = CLAIMS[promise.claim]
        texts[promise.claim] = f"{words}, where: {conditions}" if conditions else words
    return texts


def largest_disturbance(scenario: Scenario) -> float:
    """Return the largest |Delta| of a scenario, length per time."""
    delta = scenario.flow.disturbance
    return 0.0 if delta is None else float(np.hypot(*delta.amplitude))


def truth_of(scenario: Scenario) -> Truth:
    """Return theta, KD and GammaD of a scenario."""
    vehicle = scenario.vehicle
    values = scenario.flow.parameters, vehicle.feedback, vehicle.feedforward
    return Truth(*map(np.array, values))
