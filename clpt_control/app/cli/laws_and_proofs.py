"""`clpt laws`: their table; `clpt prove`: theorems and laws; `clpt verify`: all runs of a loop."""

import os
from dataclasses import asdict
from pathlib import Path
from typing import Any

from ...base.errors import ClptError, SimulationError
from ...base.html import Result
from ...base.progress import interrupt, progress_bar
from .printing import Json, Report, ScenarioFile, arg, finish, law_names, opt

JUDGED = "status conclusion conclusions sentence claim conditions level bound for_every_N steps"
OF_THEOREM = f"{JUDGED} printed assumptions corrected cited not_proved"
ROOMS = {  # of proofs -> what one is called, its fields in JSON
    "theorems": ("Theorem {}", OF_THEOREM),
    "limited_speed": ("Limited speed, {}", OF_THEOREM),
    "laws": ("Law {}", f"law {JUDGED}"),
    "team": ("A team that learns one flow", f"{JUDGED} cited"),
}


def laws(
    name: str | None = arg(
        "LAW", "Its page; default: the table.", default=None, autocompletion=law_names
    ),
    as_json: Json = False,
) -> None:
    """List the adaptive laws; of one, print its page.

    Example:
        clpt laws concurrent
    """
    from ...base.arguments import check_known
    from ...paper.laws.table import LAWS
    from ...theory.laws.promises import promises_in_words, what_it_promises

    check_known("laws", filter(None, [name]), LAWS)
    laws_listed = list(LAWS.values()) if name is None else [LAWS[name]]
    listed: Report = {}
    rows = []
    keys = []
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
        sentences = [page, "Promises:", *promises, ""]
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
        "LAW",
        "Prove this law alone; default: theorems and laws.",
        default=None,
        autocompletion=law_names,
    ),
    theorem: str | None = opt(
        "NUMBER", "3.1 to 3.4; default: all, limits and every law."
    ),
    coq: Path | None = opt(
        "DIR",
        "Write the theorems as Coq files instead; coqc, if installed, checks them.",
    ),
    as_json: Json = False,
) -> None:
    """Check the paper's theorems, and every law, by symbols.

    The equations are those that run, traced from the same blocks.

    Example:
        clpt prove sigma
        clpt prove --theorem 3.2
        clpt prove --coq coq
    """
    from ...base.arguments import check_known
    from ...paper.laws.table import LAWS

    check_known("LAW", filter(None, [law]), LAWS)
    if coq is not None:
        if theorem is not None:
            raise ClptError("--coq DIR: writes all theorems. Leave --theorem out")
        _prove_by_coq(coq, law, as_json)
        return
    if law is not None and theorem is not None:
        raise ClptError("--theorem NUMBER: is not of LAW. Give one of the two")
    os.environ.setdefault("SYMPY_CACHE_SIZE", "100000")  # read at the import
    from ...theory.theorems.all_proofs import statements

    outcomes = {}
    requested = statements(theorem, law)
    with progress_bar("proving", len(requested)) as report:
        for statement in requested:
            interrupt.check()
            outcomes[statement] = statement.prove()
            report(len(outcomes))
    _print_outcomes(outcomes, as_json)


def verify(
    scenario: ScenarioFile,
    always: str | None = opt("FORMULA", "Holds at all times: 'hypot(e[0], e[1]) < 3'."),
    never: str | None = opt("FORMULA", "Holds at no time."),
    by: str | None = opt(
        "TIME:FORMULA", "Holds from a time to the end: '20: hypot(e[0], e[1]) < 0.05'."
    ),
    flow: float = opt(
        "SHARE", "Part by which each flow parameter may differ.", default=0.0
    ),
    until: float | None = opt("TIME", "End of the runs. Default: the scenario's."),
    pieces: int = opt("COUNT", "Pieces of the set, at most.", default=1),
    as_json: Json = False,
) -> None:
    """Judge a specification of every run: proved (exit status 0), refuted, open.

    Example:
        clpt verify mine.toml --always "e[0] < 3" --flow 0.01 --until 5
    """
    import clpt_control as clpt

    from ...paper.scenario.file import load_vehicle_scenario
    from ...simulation.enclosures import varied_by

    loaded = load_vehicle_scenario(scenario)
    loop = clpt.closed_loop(loaded)
    target: tuple[float, str] | None = None
    if by is not None:
        time, _, text = by.partition(":")
        try:
            target = float(time), text
        except ValueError:
            raise ClptError(f"--by {by}: has no time. Give TIME:FORMULA") from None
    params = {}
    if flow:
        varied, _ = varied_by(loop, flow, {})
        params = {name: ends for name, ends in varied.items() if ".theta" in name}
        if not params:
            raise ClptError(f"--flow {flow}: the scenario has no flow parameters")
    end = loaded.run.duration if until is None else until
    verdict = clpt.verify(
        loop,
        [0.0, end],
        params=params,
        always=always,
        never=never,
        by=target,
        pieces=pieces,
    )
    rows = [["yes" if s.holds else "NO", s.how, s.claim] for s in verdict.steps]
    line = f"{verdict.status}: {verdict.sentence}"
    fields = "status", "conclusion", "sentence", "claim", "time", "margin"
    report = {field: getattr(verdict, field) for field in fields}
    report["conditions"] = [f"{condition}" for condition in verdict.conditions]
    result = Result("Specification", ["holds", "how", "claim"], rows, [line])
    finish([result], report, as_json)
    if verdict.status != "proved":
        raise SimulationError(f"the specification is {verdict.status}")


def _print_outcomes(outcomes: dict[Any, Any], as_json: bool) -> None:
    """Print proofs and misprints; raise an error if one of them fails."""
    summary: Report = {}
    results = []
    wrong = []
    for room, (title, fields) in ROOMS.items():
        proofs = {s.name: outcomes[s] for s in outcomes if s.room == room}
        summary[room] = {
            name: _fields(proof, fields, name) for name, proof in proofs.items()
        }
        if room == "laws" and len(outcomes) > 1:
            rows = [[law, p.status, p.sentence] for law, p in proofs.items()]
            columns = ["law", "status", "what is shown"]
            results += [Result("Laws", columns, rows, [""])] if rows else []
        else:
            results += [_result(title.format(k), p) for k, p in proofs.items()]
        wrong += [
            f"{title.format(k)}{_failure(p)}"
            for k, p in proofs.items()
            if not p.as_expected
        ]
    misprints: list[Report] = next(
        (outcomes[s] for s in outcomes if s.room == "misprints"), []
    )
    summary |= {"team": summary["team"].get(""), "misprints": misprints}
    if len(outcomes) > 2:  # not of one theorem
        columns = ["equation", "printed", "should be", "confirmed"]
        keys = "equation", "printed", "corrected"
        rows = [
            [*(m[key] for key in keys), "yes" if m["confirmed"] else "NO"]
            for m in misprints
        ]
        results.append(Result("Misprints", columns, rows, []))
    finish(results, summary, as_json)
    wrong += [
        f"the misprint of {m['equation']} is not confirmed"
        for m in misprints
        if not m["confirmed"]
    ]
    if wrong:
        further = f" (and {len(wrong) - 1} more)" if len(wrong) > 1 else ""
        raise SimulationError(f"the proof fails: {wrong[0]}{further}")


def _prove_by_coq(folder: Path, law: str | None, as_json: bool) -> None:
    """Write the theorems, or those of one law, as files of Coq; print what Coq checked."""
    from ...theory.coq.files import PACKAGES, write_proofs

    with progress_bar("coqc", 1.0) as report:
        proofs = write_proofs(folder, report, law)
    sentences = [""]
    if proofs.theorems is None:
        sentences = [
            f"{folder}: written, not checked. coqc is not installed. "
            f"Install it on Debian with: apt-get install {PACKAGES}"
        ]
    sentences += [f"No file for {reason}" for reason in proofs.not_written.values()]
    theorems = proofs.theorems or []
    rows = [
        [t.name, t.file, f"{t.seconds:.1f}", f"{len(t.axioms)} of the real numbers"]
        for t in theorems
    ]
    axioms = sorted({axiom for theorem in theorems for axiom in theorem.axioms})
    sentences += ["Axioms: " + ", ".join(axioms)] * bool(axioms)
    columns = ["theorem", "file", "seconds of the file", "axioms"] if rows else []
    report_of_coq = {
        **proofs._asdict(),
        "folder": str(folder),
        "checked": proofs.theorems is not None,
        "theorems": [t._asdict() for t in theorems],
    }
    result = Result("Theorems checked by Coq", columns, rows, sentences)
    finish([result], {"coq": report_of_coq}, as_json, folder)


def _fields(proof: Any, fields: str, name: str) -> Report:
    """Return the fields of a proof in JSON."""
    conditions = [
        {**asdict(condition), "sentence": f"{condition}"}
        for condition in proof.conditions
    ]
    values = {**asdict(proof), "law": name, "conditions": conditions}
    values |= {"sentence": proof.sentence, "conclusion": proof.conclusion}
    return {field: values[field] for field in fields.split()}


def _failure(proof: Any) -> str:
    """Return the step at which a proof fails, or what is claimed."""
    return f" at step '{proof.failed[0].claim}'" if proof.failed else f": {proof.claim}"


def _result(name: str, proof: Any) -> Result:
    """Return the steps of a proof, and what is printed, holds, is cited or not proved."""
    rows = [["yes" if s.holds else "NO", s.how, s.claim, s.detail] for s in proof.steps]
    every = ", for every N" if proof.for_every_N else ""
    status = f"{proof.status} as printed" if proof.corrected else proof.status
    sentences = [
        ("shown", proof.sentence if proof.conclusion else ""),
        ("printed", proof.printed),
        ("holds", proof.corrected),
        ("cited", proof.cited),
    ]
    sentences += [("not shown", condition) for condition in proof.not_proved]
    lines = [f"{label + ':':8} {sentence}" for label, sentence in sentences if sentence]
    return Result(
        f"{name}: {status}{every}", ["holds", "how", "claim", ""], rows, [*lines, ""]
    )
