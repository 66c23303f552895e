"""`clpt tune`: law, gains and filter, chosen by an ensemble, with the reason."""

from pathlib import Path
from typing import Annotated, Any

from ..html.text import Result
from .help_pages import names_of_laws, opt
from .printing import Json, ScenarioFile, check_scenario, finish, shown

MOST_SHOWN = 15  # candidates in the table; --json has all


def tune(
    scenario: ScenarioFile,
    out: Annotated[
        Path | None, opt("FILE", "Scenario file to write, with the choice in it.")
    ] = None,
    members: Annotated[int, opt("COUNT", "How many flows are drawn.")] = 24,
    prior: Annotated[
        float | None, opt("SPEED", "Standard deviation of flow parameters; default: 0.3 k R.")
    ] = None,
    unmodelled: Annotated[
        float | None, opt("SPEED", "Rms of flow beside the basis; default: the scenario's.")
    ] = None,
    law: Annotated[
        list[str] | None,
        opt("NAME", "A law to compare; repeat it; default: all.", autocompletion=names_of_laws),
    ] = None,
    seed: Annotated[int, opt("NUMBER", "Seed of the draws.")] = 0,
    as_json: Json = False,
) -> None:
    """Choose law, gains and filter for a flow that is not known.

    Example:
        clpt tune mine.toml --law learned-flow --law sigma --out tuned.toml
    """
    from ..ensemble.tune import tune_law
    from ..files import write_text
    from ..progress import progress_bar
    from ..scenario.file import load_scenario, scenario_to_text

    experiment = load_scenario(scenario)
    check_scenario(out)
    with progress_bar(f"tuning {scenario.name}", 1.0) as report:
        tuned = tune_law(
            experiment,
            members=members,
            prior=prior,
            unmodelled=unmodelled,
            laws=law or (),
            seed=seed,
            progress=report,
        )
    if out is not None:
        write_text(out, scenario_to_text(tuned.scenario, out.parent))
    finish(_result(tuned.report), tuned.report, as_json, out)


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
