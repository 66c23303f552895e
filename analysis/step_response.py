"""How does the vehicle, and CLPE, answer a step of the desired position?

`closed_loop(scenario, external=("zc",))` is linearised by `control.linearize`
at a frozen time, with the learner at the true parameters.  Theory, Eqs. (9) and
(27): zc -> x is GammaD/(s + KD - dF/dx), where dF/dx = (theta - alpha_M)
dphi/dx is what Eq. (9) leaves of the flow's gradient; zc -> e is exactly zero
where the learner knows all, and GammaD - Gamma drives it where it does not.

    python -m analysis.step_response [--out FOLDER]
"""

from pathlib import Path
from typing import Annotated

import control
import numpy as np
import typer

import clpt_control as clpt

from .study import BLUE, RED, leave, new_figure

TIME = 100.0  # frozen time, s
WRONG_BY = 0.1  # 1/s: how far the second learner's feedforward gain is off


def operating_point(scenario: clpt.Scenario) -> np.ndarray:
    """Return the state of a run at the frozen time."""
    return clpt.simulate(scenario, [0.0, TIME]).clpt.state(TIME)


def linear_model(scenario: clpt.Scenario, state: np.ndarray) -> control.StateSpace:
    """Linearise zc -> everything at the frozen time."""
    loop = clpt.closed_loop(scenario, external=("zc",))
    zc = clpt.closed_loop(scenario).output(TIME, state, [])[:2]
    return control.linearize(loop, state, zc, t=TIME, copy_names=True)


def flow_gradient(
    scenario: clpt.Scenario, state: np.ndarray, step: float = 1e-6
) -> np.ndarray:
    """Return (theta - alpha_M) dphi/dx at the vehicle by central differences."""
    left = np.array(scenario.flow.parameters) - np.array(scenario.model_parameters)
    places = state[:2] + step * np.vstack([np.eye(2), -np.eye(2)])
    flow = clpt.currents.flow_velocity(scenario, places, TIME, left)
    return (flow[:2] - flow[2:]).T / (2 * step)


def main(
    out: Annotated[Path, typer.Option(help="Folder.")] = Path("out/step_response"),
) -> None:
    """Leave step_response.md and step_response.png."""
    scenario = clpt.paper_scenario().started_true()
    state = operating_point(scenario)
    model = linear_model(scenario, state)
    wrong = state.copy()
    wrong[-2:] -= WRONG_BY
    mistaken = linear_model(scenario, wrong)
    names = model.output_labels
    x1, e1 = names.index("x[0]"), names.index("e[0]")
    t = np.linspace(0.0, 10.0, 501)

    KD, GammaD = (
        np.diag(g) for g in (scenario.vehicle.feedback, scenario.vehicle.feedforward)
    )
    A = flow_gradient(scenario, state) - KD
    theory = control.ss(A, GammaD, np.eye(2), 0)
    frozen = control.ss(-KD, GammaD, np.eye(2), 0)

    answers = {
        "x": control.step_response(model[x1, 0], t).outputs,
        "x theory": control.step_response(theory[0, 0], t).outputs,
        "x without flow": control.step_response(frozen[0, 0], t).outputs,
        "e": control.step_response(model[e1, 0], t).outputs,
        "e mistaken": control.step_response(mistaken[e1, 0], t).outputs,
    }
    away = float(np.abs(answers["x"] - answers["x theory"]).max())
    rows = {
        "settled gain of zc -> x, linearised": answers["x"][-1],
        "the same in theory, Eq. (9)": answers["x theory"][-1],
        "largest difference of the two responses": away,
        "largest |zc -> e|, learner true": np.abs(answers["e"]).max(),
        f"largest |zc -> e|, Gamma {WRONG_BY} too small": np.abs(
            answers["e mistaken"]
        ).max(),
        "initial slope of it (theory: GammaD - Gamma)": answers["e mistaken"][1] / t[1],
    }
    text = "| quantity | value |\n|---|---|\n" + "".join(
        f"| {name} | {value:.6g} |\n" for name, value in rows.items()
    )
    picture, (top, bottom) = new_figure(6.4, 5.4, nrows=2, sharex=True)
    top.plot(t, answers["x"], color=BLUE, linewidth=2, label="linearised diagram")
    top.plot(
        t, answers["x theory"], color="black", linestyle=":", label="theory, Eq. (9)"
    )
    top.plot(
        t,
        answers["x without flow"],
        color=RED,
        linestyle="--",
        linewidth=0.9,
        label="theory without flow",
    )
    top.set_ylabel("$x_1$ after a step of $z_{c,1}$ (m/m)")
    top.set_title(
        f"Step responses of the linearised closed loop, frozen at t = {TIME:g} s",
        loc="left",
        fontsize=10,
    )
    top.legend(frameon=False, fontsize=8)
    bottom.plot(
        t, answers["e"], color=BLUE, linewidth=2, label="learner at the true parameters"
    )
    bottom.plot(
        t,
        answers["e mistaken"],
        color=RED,
        linestyle="--",
        label=f"$\\Gamma$ {WRONG_BY} /s too small",
    )
    bottom.set(xlabel="time after the step (s)", ylabel="$e_1$ (m/m)", xlim=(0, 10))
    bottom.legend(frameon=False, fontsize=8)
    leave(out, "step_response", text, picture)
    typer.echo(text)


if __name__ == "__main__":
    typer.run(main)
