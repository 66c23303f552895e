"""`clpt prove`: the paper's theorems, a limited speed and every law, on the equations that run."""

from dataclasses import asdict
from typing import Annotated, Any

import typer

from ..errors import SimulationError
from .help_pages import one_of
from .printing import Json, print_json, print_table

OF_THEOREM = "status for_every_N printed assumptions steps conclusion corrected cited not_proved"
OF_LAW = "law status claim for_every_N steps"
FIELDS = {  # of each room's proofs, in JSON
    "theorems": OF_THEOREM.split(),
    "limited_speed": OF_THEOREM.split(),
    "laws": OF_LAW.split(),
    "team": [*OF_LAW.split()[1:], "cited"],
}


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
    from ..theory.proving.two_processes import judge, nothing_kept, own_digest, second_process

    with second_process() as pool:
        if pool is not None and theorem is None and (again or nothing_kept()):
            pool.submit(own_digest)  # what it needs takes a while to be imported
        from ..progress import progress_bar
        from ..theory.proving.judgement import Kept, parts

        wanted, kept = parts(theorem), Kept()
        new = [part for part in wanted if again or part not in kept.verdicts]
        if new:
            with progress_bar("proving", len(new)) as report:
                kept.keep(judge(new, kept.digest, report, pool))
    judged: dict[Any, Any] = {part: kept.verdicts[part] for part in wanted}
    rooms = {room: {p.name: v for p, v in judged.items() if p.room == room} for room in FIELDS}
    listed = judged[wanted[-1]]
    judged_at = max(kept.times[part] for part in wanted)
    if as_json:
        said: dict[str, Any] = {
            room: {name: _said(found, room, name) for name, found in proofs.items()}
            for room, proofs in rooms.items()
        }
        said |= {"team": said["team"].get(""), "misprints": listed}
        print_json({**said, "judged": {"time": judged_at, "before": not new}})
    else:
        for name, found in rooms["theorems"].items():
            _print_proof(f"Theorem {name}", found)
        for name, found in rooms["limited_speed"].items():
            _print_proof(f"Limited speed, {name}", found)
        if rooms["laws"]:
            rows = [
                [law, found.status + (", every N" if found.for_every_N else ""), found.claim]
                for law, found in rooms["laws"].items()
            ]
            print_table("Laws", ["law", "status", "V' along the closed loop"], rows)
            typer.echo("")
        for found in rooms["team"].values():
            _print_proof("A team that learns one flow", found)
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
    wrong = [
        f"{'limited speed, ' * (room == 'limited_speed')}{name} at step '{step.claim}'"
        for room in ("theorems", "limited_speed")
        for name, found in rooms[room].items()
        for step in found.failed
    ]
    wrong += [
        f"law {law}: {found.claim}" for law, found in rooms["laws"].items() if not found.holds
    ]
    wrong += [f"team: {found.claim}" for found in rooms["team"].values() if not found.holds]
    wrong += [
        f"the misprint of {m['equation']} is not confirmed" for m in listed if not m["confirmed"]
    ]
    if wrong:
        more = f" (and {len(wrong) - 1} more)" if len(wrong) > 1 else ""
        raise SimulationError(f"the proof fails: {wrong[0]}{more}")


def _said(found: Any, room: str, name: str) -> dict[str, Any]:
    """Return what is said of one thing in JSON."""
    known = {**asdict(found), "law": name, "conclusion": found.claim}
    return {field: known[field] for field in FIELDS[room]}


def _print_proof(name: str, found: Any) -> None:
    """Print the steps of a proof, and what is printed, holds, is cited or not shown."""
    rows = [["yes" if s.holds else "NO", s.how, s.claim, s.detail] for s in found.steps]
    every = ", for every N" if found.for_every_N else ""
    print_table(f"{name}: {found.status}{every}", ["holds", "how", "claim", ""], rows)
    sentences = [("printed", found.printed), ("holds", found.corrected), ("cited", found.cited)]
    for what, sentence in [*sentences, *(("not shown", rest) for rest in found.not_proved)]:
        if sentence:
            typer.echo(f"{what + ':':8} {sentence}")
    typer.echo("")
