"""The mean-square bound, which holds where Eqs. (16) and (33) do not.

    int |e|^2 dt <= 2 V(0)/k + int |Delta|^2 dt / k^2,    k = lambda_min(KD)

It follows from V' = -e^T KD e + e^T Delta, Eqs. (34)-(35), by completing the square,
e^T Delta <= k |e|^2/2 + |Delta|^2/(2 k), and needs no excitation.  So rms(e) <= rms(Delta)/k in
the long run.  With the known-flow law the residual (theta - theta_hat) phi(x, t) of Eq. (16)
is part of Delta.

    python -m analysis.mean_square [--out FOLDER]

asks how near the two sides come on the paper's scenario under square waves.
"""

from pathlib import Path
from typing import Annotated, NamedTuple

import numpy as np
import typer
import xarray
from scipy.integrate import cumulative_trapezoid

import clpt_control as clpt
from clpt_control.theory.theorems.counterexamples import printed_bound

from .study import leave, new_figure

AMPLITUDE, PERIODS = 0.1, (2.0, 20.0, 200.0)  # m/s; s


class MeanSquare(NamedTuple):
    """Both sides of the bound from 0 to each time, length squared times time, (nt, ...)."""

    left: np.ndarray
    right: np.ndarray

    @property
    def tightness(self) -> float:
        """The largest left side divided by its right side."""
        right = np.where(self.right > 0, self.right, 1.0)
        return float(np.max(self.left / right))

    @property
    def holds(self) -> bool:
        """Whether left <= right at every time, but for rounding."""
        return bool(np.all(self.left <= self.right * (1 + 1e-9)))


def mean_square_sides(
    times: np.ndarray,
    e: np.ndarray,
    delta: np.ndarray,
    V0: float | np.ndarray,
    k: float,
) -> MeanSquare:
    """Integrate e and Delta (nt, ..., n) by the trapezoid rule over the times (nt,)."""
    left, power = (
        cumulative_trapezoid(np.sum(values**2, axis=-1), times, axis=0, initial=0.0)
        for values in (e, delta)
    )
    return MeanSquare(left, 2 * V0 / k + power / k**2)


def mean_square_bound(run: xarray.Dataset, scenario: clpt.Scenario) -> MeanSquare:
    """Return both sides along a finely sampled run from t = 0."""
    found = printed_bound(scenario, run, 0.0)
    e, delta = found.size[:, None], found.drive[:, None]
    return mean_square_sides(found.times, e, delta, float(run.lyapunov[0]), found.k)


def main(
    out: Annotated[Path, typer.Option(help="Folder.")] = Path("out/mean_square"),
) -> None:
    """Leave mean_square.md and mean_square.png."""
    figure, ax = new_figure()
    lines = [
        "| period (s) | rms(e) k / rms(Delta) | sides, at most | holds |",
        "|---|---|---|---|",
    ]
    for period in PERIODS:
        wave = {"kind": "square", "amplitude": [AMPLITUDE, 0.0], "period": period}
        values = {
            "flow.disturbance": wave,
            "run.duration": 400,
            "run.output_step": 0.02,
        }
        scenario = clpt.paper_scenario().started_true().with_values(values)
        run = clpt.simulate(scenario)
        found = mean_square_bound(run, scenario)
        share = float(np.sqrt(found.left[-1] / found.right[-1]))
        lines.append(
            f"| {period:g} | {share:.3f} | {found.tightness:.3f} | {found.holds} |"
        )
        ax.plot(run.time, found.left, label=f"left side, period {period:g} s")
    ax.plot(run.time, found.right, "k--", label="right side")
    ax.set(
        xlabel="time (s)",
        ylabel="from 0 to then (m² s)",
        yscale="log",
        ylim=(1e-4, None),
    )
    ax.legend(frameon=False, fontsize=8)
    leave(out, "mean_square", "\n".join(lines) + "\n", figure)
    typer.echo("\n".join(lines))


if __name__ == "__main__":
    typer.run(main)
