"""How late may a law hear of CLPE before its loop loses stability?

e reaches the law of a scenario through a lag 1/(tau s + 1), a delay (Pade of order 3) or a
sampler (the law by Euler's step, its inputs held).  The learner begins true, but for z, 1 mm off;
the loop has lost stability where CLPE comes above 1 cm and ten times that of the loop as it is,
within a cycle.  It may come back: a burst moves K until the loop is stable again.  The margin is
found by bisection, to 3 %.

Theory, where w of Eq. (31) is held, g = gamma |w|^2 and all KD = k: e' = -k e + u, u' = -g e, so

    lag         tau < k/(g - k^2)                     (Routh), any where g <= k^2
    delay       T < atan(k/s)/s,  s^2 = ((k^4 + 4 g^2)^(1/2) - k^2)/2     (phase margin)
    sampler     h < k/g                               (Jury; e is sampled, u held)

On a track w turns, so these are rules of thumb there.  (C. E. Rohrs, L. Valavani, M. Athans, G.
Stein, "Robustness of continuous-time adaptive control algorithms in the presence of unmodeled
dynamics", IEEE Trans. Automatic Control 30, 881-889, 1985.)

    python -m analysis.margins [--out FOLDER]
"""

from pathlib import Path
from typing import Annotated

import control
import numpy as np
import typer

import clpt_control as clpt

from .study import COLOURS, GREY, leave, new_figure, progress_bar

KINDS = ("lag", "delay", "sampler")
LEAST, MOST = 2.0**-7, 8.0  # looked at
FINE = 1.03  # ratio at which the bisection ends
OFF, LOST, TIMES = 1e-3, 1e-2, 10.0


def largest_clpe(scenario: clpt.Scenario, kind: str, size: float) -> float:
    """Return the largest CLPE of a run; inf where it fails."""
    if kind == "sampler" and size > 0:
        scenario = scenario.with_values({"learning.sample": size})
    insert = {}
    if size > 0 and kind != "sampler":
        of = ([1.0], [size, 1.0]) if kind == "lag" else control.pade(size, 3)
        insert = {("e", "adaptation"): control.tf(*of, name=kind)}
    try:
        run = clpt.simulate(clpt.closed_loop(scenario, insert=insert))
    except clpt.SimulationError:
        return np.inf
    e = run.position.values - run.predicted_position.values
    return float(np.hypot(*e.T).max()) if run.attrs["status"] == "finished" else np.inf


def margin(scenario: clpt.Scenario, kind: str) -> float:
    """Return the largest lag, delay or sampling interval that is borne; inf: all up to `MOST`."""
    start = np.add(scenario.vehicle.position, [OFF, -OFF])
    scenario = scenario.started_true().with_values({"learning.position": start})
    limit = max(LOST, TIMES * largest_clpe(scenario, kind, 0.0))
    lost = LEAST
    while lost <= MOST and largest_clpe(scenario, kind, lost) <= limit:
        lost *= 2
    if lost > MOST:
        return np.inf
    borne = lost / 2
    while lost / borne > FINE:
        middle = np.sqrt(lost * borne)
        if largest_clpe(scenario, kind, middle) <= limit:
            borne = middle
        else:
            lost = middle
    return float(np.sqrt(lost * borne))


def closed_form(kind: str, k: float, g: float) -> float:
    """Return the margin where w is held."""
    if kind == "lag":
        return k / (g - k**2) if g > k**2 else np.inf
    s = np.sqrt((np.sqrt(k**4 + 4 * g**2) - k**2) / 2)
    return float(np.arctan2(k, s) / s) if kind == "delay" else k / g


def main(
    out: Annotated[Path, typer.Option(help="Folder.")] = Path("out/margins"),
) -> None:
    """Leave margins.md and margins.png."""
    paper = clpt.paper_scenario().with_values(
        {"run.duration": 200, "run.output_step": 0.25}
    )
    laws = [
        law
        for law in clpt.laws().values()
        if not (law.at_fixes or law.alpha_is_constant)
    ]
    found: dict[str, list[float]] = {}
    with progress_bar("margins", len(laws) * len(KINDS)) as report:
        for law in laws:
            scenario = paper.with_values({"learning.law": law.name})
            found[law.name] = []
            for kind in KINDS:
                try:
                    found[law.name].append(margin(scenario, kind))
                except clpt.DiagramError:
                    # a law with jumps of its own cannot be sampled
                    found[law.name].append(np.nan)
                report(sum(map(len, found.values())))
    words = {"inf": "-", "nan": "not sampled"}
    cells = [
        f"| `{name}` | "
        + " | ".join(words.get(m, m) for m in map("{:.3f}".format, row))
        + " |"
        for name, row in found.items()
    ]
    head = [
        "| law | lag (s) | delay (s) | sampling interval (s) |",
        "|---|---|---|---|",
    ]
    figure, axes = new_figure(7, 4)
    for k, column in enumerate(np.transpose(list(found.values()))):
        at = np.arange(len(found)) + (k - 1) / 5
        mark = "os^"[k]
        axes.semilogy(
            at, np.minimum(column, MOST), mark, color=COLOURS[k], label=KINDS[k]
        )
    axes.axhline(MOST, color=GREY, linewidth=0.8)
    axes.text(0, 1.1 * MOST, "all looked at is borne", va="bottom", color=GREY)
    axes.set_xticks(range(len(found)), found, rotation=60, ha="right")
    axes.set(ylabel="largest borne (s)", ylim=(LEAST, 2 * MOST))
    axes.legend(loc="upper left", bbox_to_anchor=(1, 1))
    leave(out, "margins", "\n".join([*head, *cells]) + "\n", figure)


if __name__ == "__main__":
    typer.run(main)
