"""Two vehicles in a strait: none sees the whole flow, together they learn it.

    python examples/team.py [FIGURE]

Runs the team of `clpt init --example team`, and each of its vehicles alone; FIGURE (default:
team.png) shows where they swim and what they learn.
"""

import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import clpt_control as clpt

COLOURS, GREY = {"west": "C0", "east": "C1"}, "#666666"
STYLES = {"west": "--", "east": "-."}


def largest_error(run):
    """Return the largest error of a flow parameter along a run."""
    return abs(run.flow_parameters_estimate - run.flow_parameters).max(
        ("axis", "basis")
    )


@plt.style.context("clpt_control.data.house")
def main(path="team.png"):
    """Run, compare, draw."""
    team = clpt.load_scenario(Path(clpt.__file__).parent / "data" / "team.toml")
    end, units = team.run.duration, team.first.units
    speed = f"{units.length}/{units.time}"
    run = clpt.simulate(team)
    alone = {name: clpt.simulate(scenario) for name, scenario in team.members.items()}
    found = clpt.gramian(team, end, 0.0)
    for name, own in alone.items():
        smallest = found.vehicles[name].smallest
        print(
            f"{name} alone: smallest eigenvalue {smallest:.1e}, largest error of a flow "
            f"parameter {float(largest_error(own)[-1]):.2g} {speed}"
        )
    together = float(largest_error(run)[:, -1].max())
    least = f"smallest eigenvalue {found.smallest:.3g}"
    print(f"the team: {least}, largest error {together:.1e} {speed}")
    drawn = figure(team, run, alone)
    drawn.savefig(Path(path))
    plt.close(drawn)
    print(f"Wrote {path}")


def figure(team, run, alone):
    """Draw where the vehicles swim, and their largest errors alone and together."""
    drawn, (chart, errors) = plt.subplots(2, figsize=(6.4, 5.6))
    basis, units, turn = (
        team.first.basis,
        team.first.units,
        np.linspace(0, 2 * np.pi, 100),
    )
    for center, width in sorted(set(zip(basis.centers, basis.widths, strict=True))):
        ring = np.array(center)[:, None] + 2 * width * np.array(
            [np.cos(turn), np.sin(turn)]
        )
        chart.fill(*ring, color=GREY, alpha=0.12)
    for name, own in alone.items():
        at = {"color": COLOURS[name], "linestyle": STYLES[name], "linewidth": 1.2}
        path = run.position.sel(vehicle=name).values
        chart.plot(*path.T, color=COLOURS[name], linewidth=0.6)
        chart.plot(
            *team.members[name].waypoints.T, "o", color=COLOURS[name], markersize=4
        )
        chart.annotate(
            name, path.mean(0), ha="center", va="center", color=COLOURS[name]
        )
        errors.semilogy(own.time, largest_error(own), label=f"{name} alone", **at)
    whole = largest_error(run).max("vehicle")
    errors.semilogy(
        run.time, whole, color="black", linewidth=1.4, label="both, as a team"
    )
    errors.axhline(1e-3, color=GREY, linewidth=0.8, linestyle=":")
    chart.set(
        xlabel=f"east ({units.length})",
        ylabel=f"north ({units.length})",
        aspect="equal",
    )
    chart.set_title(
        "Tracks, and where each flow function is seen (grey)", loc="left", fontsize=10
    )
    speed = f"{units.length}/{units.time}"
    errors.set(
        xlabel=f"time ({units.time})", ylabel=f"largest error of theta ({speed})"
    )
    errors.set_xlim(0, team.run.duration)
    errors.legend(frameon=False, fontsize=8, loc="lower left")
    return drawn


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except clpt.ClptError as problem:
        sys.exit(str(problem))
