"""Many runs: `clpt ensemble`, with values that vary; `clpt tune`, which chooses law and gains."""

from pathlib import Path
from typing import Any

import clpt_control as clpt

from ..html import Result
from ..progress import progress_bar
from .help_pages import flag, names_of_laws, opt
from .printing import (
    Json,
    ScenarioFile,
    check_figure,
    check_scenario,
    draw_figure,
    finish,
    shown,
)

MOST_CYCLES = 4  # rows of an ensemble's table
MOST_SHOWN = 15  # candidates in the table; --json has all


def ensemble(
    scenario: ScenarioFile,
    members: int = opt("COUNT", "How many runs.", default=...),
    vary: list[str] = opt(
        "KEY=LOW:HIGH",
        "A range, KEY~normal:DEVIATION, KEY~gamma(2) or another of scipy.stats, KEY=[VALUE, ...]; "
        "repeat it.",
        default=...,
    ),
    out: Path = opt("FOLDER", "Zarr folder; if it holds a part, go on from there.", default=...),
    design: str = opt(
        "NAME",
        "lhs (Latin hypercube), grid or random.",
        default="lhs",
        words=("lhs", "grid", "random"),
    ),
    seed: int = opt("NUMBER", "Seed of the draws.", default=0),
    threads: int | None = opt("COUNT", "Default: all processors."),
    trajectories: bool = flag("Keep the states too.", "--trajectories"),
    figure: Path | None = opt("FILE", ".png, .pdf or .svg: percentiles of CLPE and errors."),
    dask: str | None = opt("ADDRESS", "Run on a cluster: tcp://HOST:PORT, or local."),
    chunk: int | None = opt("COUNT", "Members written at once."),
    samples: int | None = opt("COUNT", "Samples a cycle for CLPE rms."),
    as_json: Json = False,
) -> None:
    r"""Run a scenario many times with values that vary.

    Example:
        clpt ensemble mine.toml --members 1000 --vary learning.gain=0.2:2.0 \
            --vary vehicle.position~normal:0.5 --out e.zarr --figure e.png
    """
    from ..pages.ensemble_page import ensemble_result

    experiment = clpt.load_scenario(scenario)
    check_figure(figure)
    with progress_bar(f"running {scenario.name}", members, "members") as report:
        data = clpt.run_ensemble(
            experiment,
            vary,
            members,
            design,
            seed,
            out,
            threads=threads,
            trajectories=trajectories,
            chunk=chunk,
            samples=samples,
            progress=report,
            dask=dask,
        )
    summary = clpt.ensemble.ensemble_summary(data)
    draw_figure(figure, clpt.ensemble.ensemble_plot, data)
    found = ensemble_result(data, summary, experiment.title or str(scenario), MOST_CYCLES)
    finish([found], summary, as_json, out)


def tune(
    scenario: ScenarioFile,
    out: Path | None = opt("FILE", "Scenario file to write, with the choice in it."),
    members: int = opt("COUNT", "How many flows are drawn.", default=24),
    prior: float | None = opt("SPEED", "Standard deviation of flow parameters; default: 0.3 k R."),
    unmodelled: float | None = opt(
        "SPEED", "Rms of flow beside the basis; default: the scenario's."
    ),
    law: list[str] | None = opt(
        "NAME", "A law to compare; repeat it; default: all.", autocompletion=names_of_laws
    ),
    seed: int = opt("NUMBER", "Seed of the draws.", default=0),
    as_json: Json = False,
) -> None:
    """Choose law, gains and filter for a flow that is not known.

    Example:
        clpt tune mine.toml --law learned-flow --law sigma --out tuned.toml
    """
    experiment = clpt.load_scenario(scenario)
    check_scenario(out)
    with progress_bar(f"tuning {scenario.name}", 1.0) as report:
        tuned = clpt.ensemble.tune_law(
            experiment,
            members=members,
            prior=prior,
            unmodelled=unmodelled,
            laws=law or (),
            seed=seed,
            progress=report,
        )
    if out is not None:
        clpt.save_scenario(tuned.scenario, out)
    finish([_result(tuned.report)], tuned.report, as_json, out)


def _result(report: dict[str, Any]) -> Result:
    length, time = report["units"]["length"], report["units"]["time"]
    rows = [_row(one) for one in report["candidates"][:MOST_SHOWN]]
    if report["own"] is not None:
        rows.append(_row(report["own"]))
    more = len(report["candidates"]) - MOST_SHOWN
    title = (
        f"{report['members']} flows drawn with a prior of {report['prior']:.3g} {length}/{time}, "
        f"the scenario's own flow unseen{f'; {more} more candidates' if more > 0 else ''}"
    )
    errors = [f"error at the end ({length}/{time})", "95 %", f"to a tenth ({time})"]
    columns = ["law", "gain", "K, Gamma", "filter", *errors, f"CLPE rms ({length})"]
    skipped = [f"skipped {name}: {why}" for name, why in report["skipped"].items()]
    return Result(title, columns, rows, [*skipped, report["because"]])


def _row(one: dict[str, Any]) -> list[str]:
    if one["failed"]:
        return [one["law"], *_choice(one), f"{one['failed']} runs failed", "", "", ""]
    found = [one[key] for key in ("error", "error_95", "learning_time", "clpe_rms")]
    return [one["law"], *_choice(one), *("never" if v is None else shown(v) for v in found)]


def _choice(one: dict[str, Any]) -> list[str]:
    gain, pole = ("-" if one[key] is None else shown(one[key]) for key in ("gain", "filter"))
    return [gain, "held" if one["held"] else "adapted", pole]
