"""Sets of the ARCH-COMP category of nonlinear systems: widths, properties and CPU.

    python -m benchmarks.guaranteed_runs

LALO is the Laub-Loomis model of 7 states, CVDP two coupled van der Pol oscillators (mu = 1, b = 1),
PRDE the production and destruction of a substance, QUAD a quadrotor of 12 states, ROBE the reaction
of Robertson, LOVO the equations of Lotka and Volterra with a counter of the time in a disc; sets
and properties are those of JuliaReach/ARCH2020_NLN_RE.
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


def production(t, x, u, p):
    """Return the rates of nutrient, plankton and what has died."""
    a, b, _ = x.x
    eaten = a * b / (1 + a)
    return [-eaten, eaten - p.a * b, p.a * b]


def quadrotor(t, x, u, p):
    """Return the rates of position, speed, attitude and turning at height 1."""
    g, m, J, Jz = 9.81, 1.4, 0.054, 0.104
    _, _, height, v1, v2, v3, phi, theta, psi, w1, w2, w3 = x.x
    s1, s2, s3 = np.sin(phi), np.sin(theta), np.sin(psi)
    c1, c2, c3 = np.cos(phi), np.cos(theta), np.cos(psi)
    turning = s1 * w2 + c1 * w3
    return [
        c2 * c3 * v1 + (s1 * s2 * c3 - c1 * s3) * v2 + (c1 * s2 * c3 + s1 * s3) * v3,
        c2 * s3 * v1 + (s1 * s2 * s3 + c1 * c3) * v2 + (c1 * s2 * s3 - s1 * c3) * v3,
        s2 * v1 - s1 * c2 * v2 - c1 * c2 * v3,
        w3 * v2 - w2 * v3 - g * s2,
        w1 * v3 - w3 * v1 + g * c2 * s1,
        w2 * v1 - w1 * v2 + g * c2 * c1 - (m * g - 10 * (height - 1) + 3 * v3) / m,
        w1 + s2 / c2 * turning,
        c1 * w2 - s1 * w3,
        turning / c2,
        (J - Jz) / J * w2 * w3 - (phi + w1) / J,
        (Jz - J) / J * w1 * w3 - (theta + w2) / J,
        0.0 * w3,
    ]


def robertson(b, g):
    """Return the function of rates with two constants."""

    def rates(t, x, u, p):
        r, s = 0.4 * x.x[0] - b * x.x[1] * x.x[2], g * x.x[1] ** 2
        return [-r, r - s, s]

    return rates


def counted(t, x, u, p):
    """Return the rates of prey, predators and the counter."""
    a, b, _ = x.x
    is_inside = (a - 1) ** 2 + (b - 1) ** 2 <= 0.161**2
    return [3 * a - 3 * a * b, a * b - b, np.where(is_inside, 1.0, 0.0)]


def judged(name, rates, start, times, pieces=1, params=None, **specification):
    """Print the verdict on a property, the largest width at the end, and the CPU."""
    model = clpt.Block(
        "model", update=rates, states={"x": len(start)}, parameters={"a": 0.3}
    )
    begin = time.process_time()
    verdict = clpt.verify(
        model, times, None, start, params, pieces=pieces, **specification
    )
    cpu = time.process_time() - begin
    width = (verdict.tube.upper - verdict.tube.lower).values[-1, : len(start)]
    print(f"{name}: {verdict.status}, width {np.max(width):.3g}, {cpu:.1f} s of CPU")


def main():
    """Judge each set."""
    for w, most in ((0.01, 4.5), (0.05, 4.5), (0.1, 5.0)):
        start = [(x - w, x + w) for x in LALO]
        times = np.linspace(0, 20, 201)
        judged(f"LALO {w}", laub_loomis, start, times, always=f"x[3] < {most}")
    start = [(1.25, 1.55), (2.35, 2.45)] * 2
    times, always = np.linspace(0, 7, 71), "x[1] < 2.75 and x[3] < 2.75"
    judged("CVDP", coupled, start, times, 16, always=always)
    times, by = np.linspace(0, 100, 101), (100, "x[0] >= 0 and x[1] >= 0 and x[2] >= 0")
    for name, prey, ends in (
        ("I", (9.5, 10.0), (0.3, 0.3)),
        ("P", 9.98, (0.296, 0.304)),
        ("I and P", (9.7, 10.0), (0.298, 0.302)),
    ):
        start, params = [prey, 0.01, 0.01], {"model.a": ends}
        judged(f"PRDE {name}", production, start, times, params=params, by=by)
    for w in (0.1, 0.4, 0.8):
        start, times = [(-w, w)] * 6 + [0.0] * 6, np.linspace(0, 5, 51)
        judged(f"QUAD {w}", quadrotor, start, times, always="x[2] < 1.4")
    for b, g in ((1e2, 1e3), (1e3, 1e5)):
        model = clpt.Block(
            "model",
            update=robertson(b, g),
            output=lambda t, x, u, p: x.x[0] + x.x[1] + x.x[2],
            states={"x": 3},
            outputs={"sum": 1},
        )
        begin = time.process_time()
        tube = clpt.enclose(model, [0, 40], None, [1.0, 0.0, 0.0])
        cpu = time.process_time() - begin
        width = float((tube.upper - tube.lower)[-1, -1])
        print(f"ROBE {b:g} {g:g}: {tube.status}, sum {width:.2g}, {cpu:.1f} s of CPU")
    for w in (0.008, 0.012):
        start, times = [(1.3 - w, 1.3 + w), 1.0, 0.0], np.linspace(0, 3.64, 201)
        always = "(x[0] - 1)**2 + (x[1] - 1)**2 < 0.25 and x[2] < 0.6"
        judged(f"LOVO {w}", counted, start, times, always=always)


if __name__ == "__main__":
    main()
