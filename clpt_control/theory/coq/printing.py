"""Equations of a law's record as text of Coq: variables, rates, V and domains, by `coq_text`."""

import re
from collections.abc import Iterable
from typing import Any

from ..proofs.coq_text import CoqPrinter, name_in_coq
from .running import Equations


def text_of(equations: Equations) -> str:
    """Return variables, rates, jumps, V and domains of a closed loop as text of a section of Coq.

    Rates of states that jump are those between jumps; rates of 0 are left out.
    """
    rates, inputs, V, conditions, jumps = equations
    printer = CoqPrinter([*rates, *inputs])

    def defined(name: str, value: Any) -> str:
        base, indices = name_in_coq(name)
        value = printer.doprint(value)
        return f"Definition {base[2:]}{_nats(indices)} (t : R) := {value}."

    lines = ["Variable N : nat.", *_variables(equations, printer.signals)]
    for state, rate in rates.items():
        name, indices = name_in_coq(state.name)
        if jumps:
            lines += [defined(f"run_{state.name}", rate)] * (rate != 0)
            continue
        applied = " ".join(["", *indices])
        bounds = "".join(f"forall {k}, ({k} < N)%nat -> " for k in indices)
        run = name.replace("r_", "run_", 1)
        lines += [
            defined(f"run_{state.name}", rate),
            f"Hypothesis H{name[1:]} : {bounds}follows ({name}{applied}) ({run}{applied}).",
        ]
    for state, after in jumps.items():
        is_changed = after not in (0, state)
        lines += [defined(f"run_after_{state.name}", after)] * is_changed
    lines.append(defined("run_V", V))
    for number, (expression, relation) in enumerate(conditions, 1):
        indices = sorted({*re.findall(r"\[([a-z]\w*)\]", str(expression))})
        if jumps:  # a lemma of the file: P has no sign of its own
            lines.append(defined(f"divisor_{number}", expression))
            continue
        claim = f"{printer.doprint(expression)} {relation}"
        lines += [
            f"Lemma domain_{number}{_nats(indices)} (t : R) : {claim}.",
            "Proof. domain. Qed.",
        ]
    return "\n".join(lines)


def _nats(indices: Iterable[str]) -> str:
    """Return indices as arguments of Coq."""
    return "".join(f" ({index} : nat)" for index in indices)


def _variables(equations: Equations, signals: set[str]) -> list[str]:
    """Return the variables of a record with their signs; Coq refuses a name of two kinds."""
    rates, inputs, V, _, jumps = equations
    expressions = [*rates, *inputs, *rates.values(), *jumps.values(), V]
    symbols = {s for e in expressions for s in e.free_symbols if s.is_real}
    lines = {}
    for symbol in sorted(symbols, key=str):
        if symbol.is_integer or symbol.name == "t":
            continue
        name, indices = name_in_coq(symbol.name)
        kind = "nat -> " * len(indices) + "R" + " -> R" * (name in signals)
        line = f"Variable {name} : {kind}."
        if symbol.is_positive:
            element = " ".join([name, *indices])
            every = f"forall{_nats(indices)}, " * bool(indices)
            line += f" Hypothesis P{name[1:]} : {every}0 < {element}."
        lines[name, len(indices)] = line
    return [*lines.values()]
