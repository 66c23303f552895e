"""Random models that run in Python, next to python-control at the same tolerances.

Each model has two to four states, a linear part with random eigenvalues, and terms that are smooth,
bend, jump, or make the model stiff.  The reference is SciPy's DOP853 at 1e-10 with short steps, or
Radau for a stiff model.

    python benchmarks/python_models.py [COUNT]
"""

import ctypes
import sys
import time
import warnings

import control
import numpy as np
from scipy.integrate import solve_ivp

import clpt_control as clpt

SEED = 71
SINE = ctypes.PyDLL(None).sin  # C, which cannot be traced
SINE.restype, SINE.argtypes = ctypes.c_double, [ctypes.c_double]
TIMES = np.linspace(0.0, 5.0, 26)
TOLERANCES = {"rtol": 1e-8, "atol": 1e-10}
TERMS = {
    "smooth": lambda v: SINE(v),
    "kink": lambda v: abs(v - 0.3),
    "clip": lambda v: max(-0.4, min(0.4, v)),
    "jump": lambda v: 1.0 if v > 0.2 else -0.5,
    "stairs": lambda v: float(np.floor(3.0 * v)),
    "stiff": lambda v: SINE(v),
}


def model(seed):
    """Return the kind, the rates and the initial state of a random model."""
    random = np.random.default_rng([SEED, seed])
    kind = [*TERMS][seed % len(TERMS)]
    n = int(random.integers(2, 5))
    A = 0.7 * random.standard_normal((n, n)) - 1.5 * np.eye(n)
    b, w = random.standard_normal(n), random.uniform(0.5, 3.0)
    if kind == "stiff":
        A[-1] *= 300.0
        A[-1, -1] = -1000.0
    term = TERMS[kind]

    def rates(t, x, u, params):
        # rates of a jump depend on time alone there, so a run never slides
        at = SINE(w * t) if kind in ("jump", "stairs") else x[0]
        return A @ x + b * term(at) + SINE(w * t)

    return kind, rates, random.standard_normal(n)


def measured(seed):
    """Return kind, errors, evaluations and seconds, ours before python-control's."""
    kind, rates, start = model(seed)
    count = [0]

    def counted(t, x, u, params):
        count[0] += 1
        return rates(t, x, u, params)

    n = len(start)
    system = control.nlsys(counted, None, inputs=0, outputs=n, states=n, name="m")
    exact = solve_ivp(
        lambda t, x: rates(t, x, None, None),
        (0.0, TIMES[-1]),
        start,
        "Radau" if kind == "stiff" else "DOP853",
        TIMES,
        rtol=1e-10,
        atol=1e-12,
        max_step=np.inf if kind == "stiff" else 0.01,
    ).y
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        clpt.simulate(system, TIMES[:2], None, start)  # traced once
        count[0], begin = 0, time.process_time()
        run = clpt.simulate(system, TIMES, None, start, **TOLERANCES)
        ours = count[0], time.process_time() - begin
    assert run.attrs["engine"].startswith("python")
    count[0], begin = 0, time.process_time()
    other = control.input_output_response(
        system, TIMES, 0, start, solve_ivp_kwargs=TOLERANCES
    )
    theirs = count[0], time.process_time() - begin
    errors = (
        np.abs(run.states.values.T - exact).max(),
        np.abs(other.states - exact).max(),
    )
    return kind, errors, *zip(ours, theirs, strict=True)


def main(count):
    """Print errors, and ratios to python-control, by kind of model."""
    rows = [measured(seed) for seed in range(count)]
    print("kind     models  error  python-control  evaluations  time (ratios of sums)")
    for kind in TERMS:
        errors, evaluations, seconds = (
            np.array(columns)
            for columns in list(
                zip(*(row for row in rows if row[0] == kind), strict=True)
            )[1:]
        )
        ratio = [a / b for a, b in (evaluations.sum(0), seconds.sum(0))]
        worst = errors.max(axis=0)
        print(
            f"{kind:8} {len(errors):6}  {worst[0]:.1e}  {worst[1]:.1e}  "
            f"{ratio[0]:.2f}  {ratio[1]:.2f}"
        )


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 300)
