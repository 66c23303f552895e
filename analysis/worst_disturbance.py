"""The worst disturbance, where the regressor w(t) is given: a peak gain.

    max |e_i(t)| = Dmax int_0^t |c Phi(t, s) b| ds                Eqs. (28), (32)

over all |Delta_i| <= Dmax, started true; b and c pick e_i in (e_i, eta_i), Phi is the transition
matrix of Eq. (28), and Delta_i(s) = Dmax sign(c Phi(t, s) b) attains it.  It is exact for this w;
the w of a disturbed run differs somewhat, since it holds z.  Eq. (33) would have it below Dmax/k;
the corrected bound of Theorem 3.4 is far above it.

    python -m analysis.worst_disturbance [--out FOLDER]

asks it of the paper's scenario.
"""

from pathlib import Path
from typing import Annotated, NamedTuple

import numpy as np
import typer
from scipy.linalg import expm

import clpt_control as clpt
from clpt_control.theory.excitation.regressor import regressors

from .study import GREY, leave, new_figure

END = 400.0  # s


class WorstDisturbance(NamedTuple):
    """Largest |e_i| that any disturbance of size 1 can make."""

    times: np.ndarray  # (nt,), units.time
    gains: np.ndarray  # (2, nt): max |e_i(t)| / Dmax for a disturbance of axis i, time

    @property
    def peaks(self) -> tuple[float, float]:
        """The largest gain of each axis."""
        return float(self.gains[0].max()), float(self.gains[1].max())


def influences(A: np.ndarray, step: float, targets: np.ndarray) -> np.ndarray:
    """Return c Phi(t, s) b, what Delta at s does to e at t, shape (steps + 1, nt).

    A (steps, n, n) is held over each step, e first; the targets (nt,) are t in steps.  Rows are
    s = 0, step, 2 step, ...; entries with s > t are zero.
    """
    moves = expm(A * step)
    targets = np.asarray(targets, dtype=int)
    rows = np.zeros((len(targets), A.shape[-1]))
    found = np.zeros((len(A) + 1, len(targets)))
    for j in range(targets.max(), -1, -1):
        if j < targets.max():
            rows = np.einsum("ti,ij->tj", rows, moves[j])
        rows[targets == j, 0] = 1.0
        found[j] = rows[:, 0]
    return found


def peak_gains(A: np.ndarray, step: float, targets: np.ndarray) -> np.ndarray:
    """Integrate |c Phi(t, s) b| over s from 0 to each target, shape (nt,)."""
    size = np.abs(influences(A, step, targets))
    ends = (size[0] + size[targets, np.arange(len(targets))]) / 2
    return step * (size.sum(axis=0) - ends)


def error_matrices(
    phi: np.ndarray, z: np.ndarray, zc: np.ndarray, KD: np.ndarray, gain: float
) -> np.ndarray:
    """Return A(t) of Eq. (28), axis by axis.

    >>> phi, z, zc = np.array([0.5]), np.array([2, 2]), np.array([3, 3])
    >>> error_matrices(phi, z, zc, [1, 1], 2.0)[0]
    array([[-1. ,  0.5,  2. ,  3. ],
           [-1. ,  0. ,  0. ,  0. ],
           [-4. ,  0. ,  0. ,  0. ],
           [-6. ,  0. ,  0. ,  0. ]])
    """
    N, shape = phi.shape[-1], phi.shape[:-1]
    w = regressors(phi, z, zc)
    A = np.zeros((*w.shape[:-1], N + 3, N + 3))
    A[..., 0, 0] = -np.reshape(KD, (2, *[1] * len(shape)))
    A[..., 0, 1:] = w
    A[..., 1:, 0] = -gain * w
    return A + 0.0  # without -0


def regressor_matrices(scenario: clpt.Scenario, end: float, step: float) -> np.ndarray:
    """Return A of Eq. (28) along the undisturbed run, started true, in the middle of each step.

    Axis first, shape (2, steps, N + 3, N + 3).
    """
    calm = scenario.started_true().with_values({"flow.disturbance": None})
    loop = clpt.closed_loop(calm)
    times = np.concatenate([[0.0], step * (np.arange(round(end / step)) + 0.5)])
    run = clpt.simulate(loop, times, initial_state=clpt.initial_state(calm))
    names = ("phi_x", "predicted_position", "reference")
    phi, z, zc = (run[name].values[1:] for name in names)
    KD = np.array(calm.vehicle.feedback)
    return error_matrices(phi, z, zc, KD, calm.learning.used_gains.parameters)


def worst_disturbance(
    scenario: clpt.Scenario,
    start: float,
    end: float,
    step: float = 0.04,
    every: float = 1.0,
) -> WorstDisturbance:
    """Return the gains from start to end, each `every`; Delta acts from 0.

    The scenario has theta and the learned-flow law; it is run started true, without Delta, and
    its regressor is held over each step.
    """
    A = regressor_matrices(scenario, end, step)
    targets = np.unique(np.round(np.arange(start, end, every) / step).astype(int))
    return WorstDisturbance(
        targets * step, np.stack([peak_gains(A[i], step, targets) for i in range(2)])
    )


def main(
    out: Annotated[Path, typer.Option(help="Folder.")] = Path("out/worst_disturbance"),
    end: Annotated[float, typer.Option(help="Until then, s.")] = END,
) -> None:
    """Leave worst_disturbance.md and worst_disturbance.png."""
    paper = clpt.paper_scenario()
    found = worst_disturbance(paper, 0.0, end)
    claimed = 1 / np.array(paper.vehicle.feedback)  # s, Eq. (33)
    lines = [
        "| axis | worst abs(e)/Dmax (s) | claimed, Eq. (33) (s) |",
        "|---|---|---|",
    ]
    rows = zip(found.peaks, claimed, strict=True)
    lines += [
        f"| x{k} | {peak:.3f} | {one:g} |" for k, (peak, one) in enumerate(rows, 1)
    ]
    figure, ax = new_figure()
    for k, gains in enumerate(found.gains, 1):
        ax.plot(found.times, gains, label=f"x{k}")
    ax.axhline(claimed.max(), color=GREY, linestyle="--", label="claimed, Eq. (33)")
    ax.set(xlabel="time (s)", ylabel="worst |e|/Dmax (s)")
    ax.legend(frameon=False)
    leave(out, "worst_disturbance", "\n".join(lines) + "\n", figure)
    typer.echo("\n".join(lines))


if __name__ == "__main__":
    typer.run(main)
