"""Sets of the ARCH-COMP category of nonlinear systems: widths, properties and CPU.

    python -m benchmarks.guaranteed_runs

LALO is the Laub-Loomis model of 7 states, CVDP two coupled van der Pol oscillators (mu = 1, b = 1);
sets and properties are those of JuliaReach/ARCH2020_NLN_RE.
"""

import time

import numpy as np

import clpt_control as clpt

LALO = [1.2, 1.05, 1.5, 2.4, 1.0, 0.1, 0.45]


def laub_loomis(t, x, u, p):
    """Return the rates of the seven states."""
    a, b, c, d, e, f, g = x.x
    return [
        1.4 * c - 0.9 * a,
        2.5 * e - 1.5 * b,
        0.6 * g - 0.8 * b * c,
        2 - 1.3 * c * d,
        0.7 * a - d * e,
        0.3 * a - 3.1 * f,
        1.8 * f - 1.5 * b * g,
    ]


def coupled(t, x, u, p):
    """Return the rates of two oscillators."""
    a, b, c, d = x.x
    return [b, (1 - a * a) * b - 2 * a + c, d, (1 - c * c) * d - 2 * c + a]


def judged(name, rates, start, times, always, pieces=1):
    """Print the verdict on a property, the largest width at the end, and the CPU."""
    model = clpt.Block("model", update=rates, states={"x": len(start)})
    begin = time.process_time()
    verdict = clpt.verify(model, times, None, start, always=always, pieces=pieces)
    cpu = time.process_time() - begin
    width = (verdict.tube.upper - verdict.tube.lower).values[-1, : len(start)]
    print(f"{name}: {verdict.status}, width {np.max(width):.3g}, {cpu:.1f} s of CPU")


def main():
    """Judge each set."""
    for w, most in ((0.01, 4.5), (0.05, 4.5), (0.1, 5.0)):
        start = [(x - w, x + w) for x in LALO]
        always = f"x[3] < {most}"
        judged(f"LALO {w}", laub_loomis, start, np.linspace(0, 20, 201), always)
    start = [(1.25, 1.55), (2.35, 2.45)] * 2
    always = "x[1] < 2.75 and x[3] < 2.75"
    judged("CVDP", coupled, start, np.linspace(0, 7, 71), always, 16)


if __name__ == "__main__":
    main()
