"""Ultimate levels of V of laws that leak, in closed form, for tests of proofs and runs."""

from functools import cache

import numpy as np

import clpt_control as clpt
from clpt_control.paper.laws.robust import NORM_LIMITS
from clpt_control.theory.laws.promises import truth_of
from clpt_control.theory.laws.theorem_loop import law_and_V, theorem_scenario


def adapted_gain_and_size(p, truth):
    """Return the least gain of the adapted parameters, and their sum of |a*|^2."""
    gains = [gain for gain in (p.gain, p.gain_K, p.gain_Gamma) if gain > 0]
    adapts = (truth.theta, truth.KD * (p.gain_K > 0), truth.GammaD * (p.gain_Gamma > 0))
    return min(gains), float(sum(np.sum(a * a) for a in adapts))


def level_of_sigma(p, truth, delta):
    """Return the bound on V: V' <= -min(k, gamma s) V + Delta^2/(2 k) + s sum |a*|^2/2."""
    gain, size = adapted_gain_and_size(p, truth)
    k = truth.KD.min()
    return float((delta**2 / (2 * k) + p.leak * size / 2) / min(k, gain * p.leak))


def level_of_switching(p, truth, delta):
    """Return the level of sigma plus the missing leak below 2 M: (s - s_j) d^T a <= s |d| |a|."""
    gain, _ = adapted_gain_and_size(p, truth)
    k = truth.KD.min()
    limits = (getattr(p, key) for key in NORM_LIMITS)
    missing = sum(
        2 * M * (2 * M + np.linalg.norm(a)) for M, a in zip(limits, truth, strict=True)
    )
    sigma_level = level_of_sigma(p, truth, delta)
    return sigma_level + float(p.leak * missing / min(k, gain * p.leak))


def level_of_e_modification(p, truth, delta):
    """Return the largest V for which k |e| + s sum |d|^2/2 <= c = Delta + s sum |a*|^2/2."""
    gain, size = adapted_gain_and_size(p, truth)
    k = truth.KD.min()
    c = delta + p.leak * size / 2
    return float(max(c**2 / (2 * k**2), c / (p.leak * gain)))


LEVELS = {  # law -> level of V, of its parameters, the truth and the largest disturbance
    "sigma": level_of_sigma,
    "switching-sigma": level_of_switching,
    "e-modification": level_of_e_modification,
}


@cache
def proved_level(name):
    """Return the level that the proof of a law of the table has."""
    return clpt.prove(name, points=50).level


def proved_and_closed_form(name, delta):
    """Return both levels for a disturbance of each axis, at the numbers of the theorems."""
    p, truth = (
        law_and_V(clpt.laws()[name], 2)[0].parameters,
        truth_of(theorem_scenario(2, name)),
    )
    values = {f"theta_{i + 1}[{k + 1}]": v for (i, k), v in np.ndenumerate(truth.theta)}
    for i in (0, 1):
        values |= {f"KD_{i + 1}": truth.KD[i], f"GammaD_{i + 1}": truth.GammaD[i]}
        values[f"Delta_{i + 1}"] = delta[i]
    level = proved_level(name)
    proved = float(level.subs({s: values[s.name] for s in level.free_symbols}))
    return proved, LEVELS[name](p, truth, float(np.hypot(*delta)))
