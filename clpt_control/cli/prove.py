"""`clpt prove`: the paper's theorems, a limited speed and every law, on the equations that run."""

from dataclasses import asdict
from typing import Annotated, Any

import typer

from ..errors import SimulationError
from .help_pages import one_of
from .printing import Json, print_json, print_table


def prove(
    theorem: Annotated[
        str | None,
        typer.Option(
            metavar="NUMBER",
            autocompletion=one_of("3.1", "3.2", "3.3", "3.4"),
            help="3.1 to 3.4; default: all, limits and every law.",
        ),
    ] = None,
    again: Annotated[bool, typer.Option("--again", help="Judge what was judged before.")] = False,
    as_json: Json = False,
) -> None:
    """Check the paper's theorems, and every law, by symbols.

    The equations are those that run, read from the same blocks.

    Example:
        clpt prove --theorem 3.2
    """
    from ..theory.proving.two_processes import SecondProcess, judge, nothing_kept

    with SecondProcess() as second:
        if theorem is None and (again or nothing_kept()):
            second.start()
        from ..progress import progress_bar
        from ..theory.proving.judgement import parts
        from ..theory.proving.kept_verdicts import Kept

        wanted = parts(theorem)
        kept = Kept()
        new = [part for part in wanted if again or part not in kept.verdicts]
        if new:
            with progress_bar("proving", len(new)) as report:
                kept.keep(judge(new, kept.digest, report, second))
    rooms: dict[str, dict[str, Any]] = {}
    for part in wanted:
        rooms.setdefault(part.room, {})[part.name] = kept.verdicts[part]
    proofs, listed = rooms["theorems"], rooms["misprints"][""]
    laws, limits = rooms.get("laws", {}), rooms.get("limited_speed", {})
    team = rooms.get("team", {}).get("")
    judged_at = max(kept.times[part] for part in wanted)
    if as_json:
        said = _as_json(proofs, limits, listed, laws, team)
        print_json({**said, "judged": {"time": judged_at, "before": not new}})
    else:
        named = {f"Theorem {number}": proof for number, proof in proofs.items()}
        named |= {f"Limited speed, {name}": proof for name, proof in limits.items()}
        for name, proof in named.items():
            rows = [["yes" if s.holds else "NO", s.how, s.claim, s.detail] for s in proof.steps]
            every = ", for every N" if proof.for_every_N else ""
            print_table(f"{name}: {proof.status}{every}", ["holds", "how", "claim", ""], rows)
            typer.echo(f"printed: {proof.printed}")
            if proof.corrected:
                typer.echo(f"holds:   {proof.corrected}")
            if proof.cited:
                typer.echo(f"cited:   {proof.cited}")
            for rest in proof.not_proved:
                typer.echo(f"not shown: {rest}")
            typer.echo("")
        if laws:
            rows = [
                [law, found.status + (", every N" if found.for_every_N else ""), found.claim]
                for law, found in laws.items()
            ]
            print_table("Laws", ["law", "status", "V' along the closed loop"], rows)
            typer.echo("")
        if team is not None:
            rows = [["yes" if s.holds else "NO", s.how, s.claim, s.detail] for s in team.steps]
            every = ", for every N" if team.for_every_N else ""
            columns = ["holds", "how", "claim", ""]
            print_table(f"A team that learns one flow: {team.status}{every}", columns, rows)
            typer.echo(f"cited:   {team.cited}")
            typer.echo("")
        print_table(
            "Misprints",
            ["equation", "printed", "should be", "confirmed"],
            [
                [m["equation"], m["printed"], m["corrected"], "yes" if m["confirmed"] else "NO"]
                for m in listed
            ],
        )
        if not new:
            typer.echo(f"judged on {judged_at} of the same equations; --again judges anew")
    judged = {**proofs, **{f"limited speed, {name}": proof for name, proof in limits.items()}}
    wrong = [f"{n} at step '{s.claim}'" for n, p in judged.items() for s in p.failed]
    wrong += [f"law {law}: {found.claim}" for law, found in laws.items() if not found.holds]
    wrong += [f"team: {team.claim}"] if team is not None and not team.holds else []
    wrong += [
        f"the misprint of {m['equation']} is not confirmed" for m in listed if not m["confirmed"]
    ]
    if wrong:
        more = f" (and {len(wrong) - 1} more)" if len(wrong) > 1 else ""
        raise SimulationError(f"the proof fails: {wrong[0]}{more}")


def _as_json(proofs: dict, limits: dict, listed: list, laws: dict, team: Any) -> dict[str, Any]:
    """Return the statuses, steps and statements, laws, team and misprints."""

    def plain(judged: dict) -> dict[str, Any]:
        found = {}
        for name, proof in judged.items():
            said = asdict(proof)
            del said["theorem"], said["printed_holds"]
            found[name] = {"status": proof.status, "for_every_N": proof.for_every_N, **said}
        return found

    return {
        "theorems": plain(proofs),
        "limited_speed": plain(limits),
        "laws": {law: _judged(found) for law, found in laws.items()},
        "team": None if team is None else _judged(team),
        "misprints": listed,
    }


def _judged(found: Any) -> dict[str, Any]:
    """Return what is known of a law, with its steps."""
    return {**found._asdict(), "steps": [asdict(step) for step in found.steps]}
