"""`clpt laws`: their table; `clpt prove`: theorems, laws, and searches for counterexamples."""

from dataclasses import asdict
from pathlib import Path
from typing import Any

from ...base.errors import ClptError, SimulationError
from ...base.html import Result
from ...base.progress import progress_bar
from .printing import Json, Report, arg, cell_text, check_out, finish, flag, opt

OF_THEOREM = (
    "status for_every_N printed assumptions steps conclusion corrected cited not_proved"
)
OF_LAW = "status claim for_every_N steps"
ROOMS = {  # of proofs -> what one is called, its fields in JSON
    "theorems": ("Theorem {}", OF_THEOREM),
    "limited_speed": ("Limited speed, {}", OF_THEOREM),
    "laws": ("Law {}", f"law {OF_LAW}"),
    "team": ("A team that learns one flow", f"{OF_LAW} cited"),
}


def laws(
    name: str | None = arg("LAW", "Its page; default: the table.", default=None),
    as_json: Json = False,
) -> None:
    """List the adaptive laws; of one, print its page.

    Example:
        clpt laws concurrent
    """
    from ...paper.laws.table import LAWS
    from ...theory.promises import promises_in_words, what_it_promises

    if name is not None and name not in LAWS:
        raise ClptError(f"{name}: is not a law. List the laws with: clpt laws")
    laws_listed = list(LAWS.values()) if name is None else [LAWS[name]]
    listed: Report = {}
    rows, keys = [], []
    for law in laws_listed:
        settings = {}
        for key, setting in law.settings.items():
            settings[key] = {
                name: getattr(setting, name)
                for name in ("default", "allowed", "meaning")
            }
            default = (
                "of the scenario" if setting.default is None else f"{setting.default:g}"
            )
            keys.append(
                [
                    f"learning.{law.table}.{key}",
                    setting.allowed,
                    default,
                    setting.meaning,
                ]
            )
        rows.append([law.name, what_it_promises(law), law.needs])
        listed[law.name] = {
            "promises": list(promises_in_words(law).values()),
            "needs": law.needs,
            "default_gain": law.gain,
            "table": f"learning.{law.table}" if settings else None,
            "settings": settings,
        }
    sentences = [""]
    if name is not None:
        page = listed[name]["page"] = laws_listed[0].page
        promises = [f"- {words}" for words in listed[name]["promises"]]
        sentences = [page, "Asked along runs:", *promises, ""]
    results = [
        Result(
            "Laws (learning.law)",
            ["law", "promise, on conditions", "needs"],
            rows,
            sentences,
        )
    ]
    if keys:
        results.append(
            Result("Settings", ["key", "allowed", "default", "what it is"], keys)
        )
    finish(results, {"laws": listed}, as_json)


def prove(
    law: str | None = arg(
        "LAW", "Law of --search; default: theorems and laws are proved.", default=None
    ),
    theorem: str | None = opt(
        "NUMBER", "3.1 to 3.4; default: all, limits and every law."
    ),
    again: bool = flag("Ignore cached verdicts and prove everything again.", "--again"),
    search: float | None = opt(
        "SECONDS", "Search so long for a run that breaks a promise of LAW instead."
    ),
    seed: int = opt("NUMBER", "Seed of --search.", default=0),
    out: Path | None = opt(
        "FILE", "With --search: scenario that breaks the promise, to write."
    ),
    as_json: Json = False,
) -> None:
    """Check the paper's theorems, and every law, by symbols.

    The equations are those that run, traced from the same blocks. A search that finds no run is
    no proof.

    Example:
        clpt prove --theorem 3.2
        clpt prove concurrent --search 20 --out broken.toml
    """
    if (law is None) != (search is None):
        raise ClptError("--search SECONDS: needs LAW, and LAW needs --search SECONDS")
    if law is not None and search is not None:
        _search_counterexample(law, search, seed, out, as_json)
        return
    from ...theory.proofs.cached_verdicts import (
        CachedOutcomes,
        make_ready,
        prove_all,
        second_process,
    )

    with second_process() as pool:
        cached = CachedOutcomes()
        if pool is not None and theorem is None and (again or not cached.outcomes):
            pool.submit(make_ready)
        from ...theory.proofs.all_proofs import statements

        requested = statements(theorem)
        new = [
            statement
            for statement in requested
            if again or statement not in cached.outcomes
        ]
        if new:
            with progress_bar("proving", len(new)) as report:
                cached.store(prove_all(new, report, pool))
    outcomes: dict[Any, Any] = {
        statement: cached.outcomes[statement] for statement in requested
    }
    summary: Report = {}
    results, wrong = [], []
    for room, (title, fields) in ROOMS.items():
        proofs = {s.name: outcomes[s] for s in requested if s.room == room}
        summary[room] = {
            name: _fields(proof, fields, name) for name, proof in proofs.items()
        }
        if room == "laws":
            rows = [
                [
                    law,
                    proof.status + (", every N" if proof.for_every_N else ""),
                    proof.claim,
                ]
                for law, proof in proofs.items()
            ]
            columns = ["law", "status", "V' along the closed loop"]
            results += [Result("Laws", columns, rows, [""])] if rows else []
        else:
            results += [
                _result(title.format(name), proof) for name, proof in proofs.items()
            ]
        wrong += [
            f"{title.format(k)}{_failure(p)}"
            for k, p in proofs.items()
            if not p.as_expected
        ]
    misprints = outcomes[requested[-1]]
    proved_at = max(cached.times[statement] for statement in requested)
    summary |= {"team": summary["team"].get(""), "misprints": misprints}
    summary["judged"] = {"time": proved_at, "before": not new}
    columns = ["equation", "printed", "should be", "confirmed"]
    rows = [
        [m["equation"], m["printed"], m["corrected"], "yes" if m["confirmed"] else "NO"]
        for m in misprints
    ]
    if theorem is None:
        results.append(Result("Misprints", columns, rows, []))
    if not new:
        before = f"judged on {proved_at} of the same equations; --again judges anew"
        last = results[-1]
        results[-1] = last._replace(sentences=[*last.sentences, before])
    finish(results, summary, as_json)
    wrong += [
        f"the misprint of {m['equation']} is not confirmed"
        for m in misprints
        if not m["confirmed"]
    ]
    if wrong:
        more = f" (and {len(wrong) - 1} more)" if len(wrong) > 1 else ""
        raise SimulationError(f"the proof fails: {wrong[0]}{more}")


def _search_counterexample(
    law: str, budget: float, seed: int, out: Path | None, as_json: bool
) -> None:
    """Search for a run that breaks what a law promises, and print how near it came."""
    from ...base.files import write_file
    from ...paper.laws.table import LAWS
    from ...paper.scenario.file import scenario_to_text
    from ...theory.promises import promises_in_words
    from ...theory.refuting import refute as search

    check_out(out, "a scenario")
    with progress_bar(f"searching {law}", 1.0) as report:
        outcome = search(law, budget=budget, seed=seed, progress=report)
    text = None if outcome.scenario is None else scenario_to_text(outcome.scenario)
    if out is not None and text is not None:
        write_file(out, text)
    rows = [
        [
            words,
            "never asked"
            if claim not in outcome.closest
            else cell_text(outcome.closest[claim]),
        ]
        for claim, words in promises_in_words(LAWS[law]).items()
    ]
    title = f"{law}: {outcome.status} by {outcome.runs} runs in {outcome.seconds:.0f} s"
    result = Result(title, ["promise", "came to, above 1 is broken"], rows)
    finish(
        [result], {**vars(outcome), "scenario": text}, as_json, out if text else None
    )
    if outcome.broken:
        raise SimulationError(f"{law} breaks its promise: {outcome.broken}")


def _fields(proof: Any, fields: str, name: str) -> Report:
    """Return the fields of a proof in JSON."""
    values = {**asdict(proof), "law": name, "conclusion": proof.claim}
    return {field: values[field] for field in fields.split()}


def _failure(proof: Any) -> str:
    """Return the step at which a proof fails, or what is claimed."""
    return f" at step '{proof.failed[0].claim}'" if proof.failed else f": {proof.claim}"


def _result(name: str, proof: Any) -> Result:
    """Return the steps of a proof, and what is printed, holds, is cited or not proved."""
    rows = [["yes" if s.holds else "NO", s.how, s.claim, s.detail] for s in proof.steps]
    every = ", for every N" if proof.for_every_N else ""
    sentences = [
        ("printed", proof.printed),
        ("holds", proof.corrected),
        ("cited", proof.cited),
    ]
    sentences += [("not shown", condition) for condition in proof.not_proved]
    lines = [f"{label + ':':8} {sentence}" for label, sentence in sentences if sentence]
    return Result(
        f"{name}: {proof.status}{every}",
        ["holds", "how", "claim", ""],
        rows,
        [*lines, ""],
    )
