"""Choice of a law: every law of the table where the assumptions of the paper hold, and where not.

On the paper's scenario each condition is an ensemble over the flow (normal, 0.2), the start and
the seed of the noise.  K and Gamma are held at the vehicle's own, but with --adapted and in the
first row, the paper's law as it is printed.  Told are medians of the largest error of a flow
parameter at t = 200 and of the CLPE rms of the second cycle.  With CURRENTS, the gridded currents
of `examples/measured_current.py`: one lap, CLPE rms over 18 to 23 h and the shares of variance
that the learned flow explains along the track and over the box.

    python -m analysis.laws [CURRENTS] [--members 100] [--adapted] [--out FOLDER]
"""

from pathlib import Path
from typing import Annotated, Any, NamedTuple

import numpy as np
import typer

import clpt_control as clpt
from clpt_control.currents import explained_variance, fit_current

from .study import BLUE, GREY, ORANGE, leave, make_folder, new_figure, progress_bar

# Nantucket Shoals: 27 functions span 0.80 of its variance
BOX = (40.9, 41.55, -69.9, -69.0)
LATE = (18.0, 23.0)  # h
FIXES = {"localization": {"interval": 5.0}}
PAPER: dict[str, dict[str, Any]] = {  # condition -> keys of the paper's scenario
    "as assumed": {},
    "noise 0.02": {"localization": {"noise": 0.02, "noise_period": 1.0}},
    "disturbance 0.05": {
        "flow.disturbance": {
            "kind": "square",
            "amplitude": [0.05, 0.05],
            "period": 1.7951958,
        }
    },
    "unmodelled flow 0.1": {
        "flow.disturbance": {"kind": "sine", "amplitude": [0.1, -0.1], "period": 37.0}
    },
    "speed limit 1.5": {"vehicle.max_speed": 1.5},
    "fixes every 5": FIXES,
}
SEA: dict[str, dict[str, Any]] = {  # the same of the measured current, km and h
    "as measured": {},
    "noise 0.05 km": {"localization": {"noise": 0.05, "noise_period": 0.1}},
    "speed limit 5 km/h": {"vehicle.max_speed": 5.0},
    "fixes every 0.5 h": {"localization": {"interval": 0.5}},
}
LEAST = 1e-7  # m/s, the least error that the figure shows
PRINTED = "learned-flow, K and Gamma adapted"  # the paper's law


class Told(NamedTuple):
    """What is told of a law under a condition: medians, with the tenths on both sides."""

    error: np.ndarray  # shape (3,), of a flow parameter, m/s
    clpe: np.ndarray  # shape (3,), m


def candidates(
    scenario: clpt.Scenario, adapted: bool = False
) -> dict[str, dict[str, Any]]:
    """Return keys of the paper's law as printed, then of each that learns, gains held or not."""
    car, keys = scenario.vehicle, {PRINTED: dict[str, Any]()}
    held = {
        "learning.adapt_gains": False,
        "learning.feedback": car.feedback,
        "learning.feedforward": car.feedforward,
    }
    for law in clpt.laws().values():
        if law.given_estimate:
            continue  # is told the flow
        needed = law.gain is None and law.alpha_by_gain
        keys[law.name] = {
            "learning.law": law.name,
            "learning.gain": scenario.learning.gain if needed else None,
            "learning.parameters": None,
            # at fixes they always are
            **(dict.fromkeys(held) if law.at_fixes else {} if adapted else held),
        }
    return keys


def on_papers_scenario(
    scenario: clpt.Scenario, keys: dict[str, Any], members: int
) -> Told:
    """Run an ensemble of two cycles under a condition."""
    scenario = scenario.with_values({**keys, "run.duration": 400})
    vary = ["flow.parameters~normal:0.2", "vehicle.position~normal:1.0"]
    if "noise" in keys.get("localization", {}):
        vary.append(f"localization.seed={list(range(members))}")
    found = clpt.run_ensemble(scenario, vary, members, design="random", times=[200.0])
    error = found.flow_parameter_error.values[:, 0]
    return Told(
        *(
            np.nanpercentile(v, [50, 10, 90])
            for v in (error, found.clpe_rms.values[:, 1])
        )
    )


def on_measured_current(
    scenario: clpt.Scenario, keys: dict[str, Any]
) -> tuple[float, float, float]:
    """Return CLPE rms (km) and the shares along the track and over the box, of one lap."""
    scenario = scenario.with_values({**keys, "run.output_step": 0.1})
    run = clpt.simulate(scenario)
    late = run.clpe.sel(time=slice(*LATE))
    shares = explained_variance(scenario, run)
    return float(np.sqrt((late**2).sum("axis").mean())), shares["track"], shares["box"]


def judged(
    told: dict[str, dict[str, Any]], conditions: dict[str, Any], one: Any
) -> list[list[str]]:
    """Return rows of a table: a law, then what `one` says of each condition, or a dash."""
    return [
        [
            law,
            *(
                one(found[name]) if found.get(name) is not None else "-"
                for name in conditions
            ),
        ]
        for law, found in told.items()
    ]


def table(title: str, conditions: dict[str, Any], rows: list[list[str]]) -> str:
    """Return a table as Markdown."""
    heads = ["law", *conditions]
    lines = [
        f"| {' | '.join(cells)} |" for cells in (heads, ["---"] * len(heads), *rows)
    ]
    return "\n".join([title, "", *lines, ""])


def figure(told: dict[str, dict[str, Told | None]]) -> Any:
    """Draw for each condition the error of every law, the paper's law as a line.

    An arrow to the left stands for less than 1e-7 m/s.
    """
    height = 0.62 * len(told) + 2.4  # two panels beside each other: for a telephone
    fig, axes = new_figure(4.8, height, nrows=3, ncols=2, sharex=True, sharey=True)
    names = list(told)
    for ax, condition in zip(axes.flat, PAPER, strict=True):
        printed = told[PRINTED][condition]
        if printed is not None:
            ax.axvline(printed.error[0], color=GREY, linewidth=1, linestyle="--")
        for row, name in enumerate(names):
            found = told[name][condition]
            if found is not None:
                colour = ORANGE if name == PRINTED else BLUE
                ax.plot(
                    found.error[1:], [row, row], color=colour, linewidth=2, alpha=0.5
                )
                shown, mark = (
                    max(found.error[0], LEAST),
                    "o" if found.error[0] > LEAST else "<",
                )
                ax.plot(shown, row, mark, color=colour, markersize=5)
        ax.set(xscale="log", xlim=(LEAST / 3, 3))
        ax.tick_params(labelsize=8)
        ax.set_title(condition, fontsize=9)
        ax.grid(axis="x", alpha=0.3)
    for ax in axes[-1]:
        ax.set_xlabel("error (m/s)")
    short = [name.replace(", ", ",\n") for name in names]
    axes[0, 0].set_yticks(range(len(names)), short)
    axes[0, 0].invert_yaxis()
    return fig


def main(
    currents: Annotated[
        Path | None, typer.Argument(help="Gridded currents, NetCDF.")
    ] = None,
    members: Annotated[
        int, typer.Option(help="Members of each ensemble.", min=2)
    ] = 100,
    adapted: Annotated[
        bool, typer.Option("--adapted", help="Adapt K and Gamma too.")
    ] = False,
    out: Annotated[Path, typer.Option(help="Folder.")] = Path("out/laws"),
) -> None:
    """Leave laws.md and laws.png."""
    folder = make_folder(out)
    why: dict[str, list[str]] = {}  # a refusal, and where it was met
    pages = []

    def asked(
        study: Any, scenario: clpt.Scenario, conditions: dict[str, Any], *more: Any
    ) -> Any:
        told: dict[str, dict[str, Any]] = {}
        laws = candidates(scenario, adapted)
        with progress_bar("laws", len(laws) * len(conditions)) as report:
            for name, law in laws.items():
                told[name] = {}
                for condition, keys in conditions.items():
                    try:
                        told[name][condition] = study(scenario, {**law, **keys}, *more)
                    except clpt.ClptError as error:
                        told[name][condition] = None
                        said = str(error).replace(
                            f'"{law.get("learning.law")}"', "NAME"
                        )
                        why.setdefault(f"{condition}: {said}", []).append(name)
                    report(sum(map(len, told.values())))
        return told

    told = asked(on_papers_scenario, clpt.paper_scenario(), PAPER, members)
    rows = judged(told, PAPER, lambda t: f"{t.error[0]:.1e}, {t.clpe[0]:.1e}")
    title = "Error of a flow parameter (m/s) at t = 200, CLPE rms (m) of the second cycle: medians"
    pages.append(table(title, PAPER, rows))
    drawn = figure(told)
    if currents is not None:
        fit = fit_current(
            currents,
            BOX,
            rows=3,
            columns=3,
            width_km=15.0,
            constituents=("steady", "M2"),
        )
        lap = asked(on_measured_current, fit.save(folder / "measured.toml"), SEA)
        rows = judged(lap, SEA, lambda t: f"{t[0]:.3f}, {t[1]:.3f}, {t[2]:.2f}")
        title = "CLPE rms (km), share of variance along the track, over the box"
        pages.append(table(title, SEA, rows))
    pages += [f"- {line} ({', '.join(names)})" for line, names in why.items()]
    text = "\n".join(pages) + "\n"
    leave(folder, "laws", text, drawn)
    typer.echo(text)


if __name__ == "__main__":
    typer.run(main)
