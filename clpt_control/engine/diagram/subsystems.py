"""The parts of a diagram: blocks and python-control's systems; parts replaced and inserted.

A `control.ss`, `tf` or summing junction becomes a block of A, B, C, D; diagrams and systems by
functions stay as they are.  The labels of a system form its ports: `v_c[0], v_c[1]` is v_c.
Parts of one discrete time stay as they are; beside others each samples its inputs.

A part that replaces another makes the ports of that part which others take.  An inserted part takes
a signal, and its output goes to the blocks that took the signal, whose name stays.
"""

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import control

from ...errors import DiagramError
from ..model.block import Block
from ..model.declaration import ports_line
from ..model.ports import counts_of, labels, ports_of, renamed
from ..model.sampled import Sampled
from ..model.system import System, is_linear, linear, on_each_axis
from .wiring import Params, Part, read_anew


def as_part(system: Any, discrete: bool = False) -> Part:
    """Return a system as a part that can be wired; refuse any other object in a sentence.

    A system of discrete time samples its inputs, unless the whole diagram is `discrete`.
    """
    part = _wired(system)
    return part if discrete or not is_discrete(part) else sampled(part, part.dt)


def is_discrete(*systems: Any) -> bool:
    """Return whether systems are of one discrete time, as python-control wires them."""
    times = [dt for dt in (getattr(system, "dt", 0) for system in systems) if dt is not None]
    return bool(times) and 0 not in times and len({dt for dt in times if dt is not True}) < 2


def sampled(part: Part, period: float, params: Params = None) -> Part:
    """Return a part of discrete time as one of continuous time, a diagram block by block.

    `params` come from the diagram around it.
    """
    if period is True:
        raise DiagramError(
            f"{part.name}: dt = True does not say how often it samples; give dt a number"
        )
    if isinstance(part, Block):
        return Sampled(part, period)
    params = {**part.params, **(params or {})}
    if not isinstance(part, control.InterconnectedSystem):
        plain = isinstance(part, control.StateSpace)
        return Sampled(linear(part) if plain else System(part, params), period)
    diagram = control.InterconnectedSystem(
        [sampled(one, period, params) for one in part.syslist],
        inputs=part.input_labels,
        outputs=part.output_labels,
        name=part.name,
    )
    diagram.set_connect_map(part.connect_map)
    diagram.set_input_map(part.input_map)
    diagram.set_output_map(part.output_map)
    return diagram


def _wired(system: Any) -> Part:
    if isinstance(system, Block):
        return system
    if not isinstance(system, control.NonlinearIOSystem | control.TransferFunction):
        what = f"a {type(system).__name__}" if hasattr(system, "name") else f"{system!r:.60}"
        raise DiagramError(
            f"{what} is no block: give a clpt.Block, a diagram, or control.ss, tf or nlsys"
        )
    if system.name is None or system._generic_name_check():
        raise DiagramError(
            f"a {type(system).__name__} without a name: parts and their parameters are called by "
            "name; give it one, such as control.ss(A, B, C, D, name='lag')"
        )
    if None in (system.ninputs, system.noutputs):
        raise DiagramError(
            f"{system.name}: how many inputs and outputs it has is not said; give inputs= and "
            "outputs= to control.nlsys"
        )
    is_linear_system = isinstance(system, control.StateSpace | control.TransferFunction)
    if is_linear_system and not isinstance(system, control.InterconnectedSystem):
        return linear(system)
    return system


def input_ports(part: Part) -> dict[str, list[int]]:
    """Return the ports that a part takes, each with the places of its signals."""
    return ports_of(part.input_labels)


def output_ports(part: Part) -> dict[str, list[int]]:
    """Return the ports that a part makes, each with the places of its signals."""
    return ports_of(part.output_labels)


def functions_of(law: Part) -> int:
    """Return the N of a law; refuse a part that does not make alpha[2N], K[2] and Gamma[2]."""
    outputs = widths([law])
    N = outputs.get("alpha", 0) // 2
    if N < 1 or {"alpha": 2 * N, "K": 2, "Gamma": 2}.items() - outputs.items():
        raise DiagramError(
            f"{law.name}: a law makes alpha[2N], K[2] and Gamma[2]; it makes "
            f"{ports_line(outputs)}; clpt.theory.lyapunov judges a V on any diagram"
        )
    taken = len(input_ports(law).get("phi_x", range(N)))
    if taken != N:
        raise DiagramError(f"{law.name}: phi_x has {taken} signals, N is {N}")
    return N


def with_ports(part: Part, inputs: Mapping[str, str], outputs: Mapping[str, str]) -> Part:
    """Return a part whose inputs and outputs have other names: {old: new}."""
    if isinstance(part, Block):
        return renamed(part, part.name, inputs, outputs)
    renamed_part = part.copy(name=part.name)
    for new, ports, set_labels in (
        (inputs, input_ports(part), renamed_part.set_inputs),
        (outputs, output_ports(part), renamed_part.set_outputs),
    ):
        names: dict[int, str] = {}
        for port, places in ports.items():
            names |= zip(places, labels({new.get(port, port): len(places)}), strict=True)
        set_labels([names[place] for place in range(len(names))])
    return renamed_part


# --- parts replaced and inserted, by name ---------------------------------------------------------


LAW = "adaptation"  # the part that is the adaptive law


class Changes(NamedTuple):
    """The user's own parts: {name: part} and {signal, or (signal, block that takes it): part}."""

    replace: dict[str, Part]
    insert: dict[Any, Part]

    @property
    def law(self) -> Part | None:
        """The part in place of the law, if there is one."""
        return self.replace.get(LAW)

    @property
    def parts(self) -> list[Part]:
        """The user's parts."""
        return [*self.replace.values(), *self.insert.values()]

    @property
    def names(self) -> list[str]:
        """The names of the user's parts."""
        return [part.name for part in self.parts]

    @property
    def in_words(self) -> str:
        """The parts replaced, other than the law, and inserted, in words."""
        places = [where for where in self.replace if where != LAW]
        places += [where if isinstance(where, str) else " to ".join(where) for where in self.insert]
        names = [name for name in self.names if self.law is None or name != self.law.name]
        return ", ".join(f"{place}: {name}" for place, name in zip(places, names, strict=True))

    def of_blocks(self, what: str) -> "Changes":
        """Refuse parts that are no blocks, for uses that run as machine code alone."""
        for part in self.parts:
            if not isinstance(part, Block):
                raise DiagramError(
                    f"{part.name}: is a {type(part).__name__}; {what} takes blocks, control.ss and "
                    "control.tf"
                )
        return self


UNCHANGED = Changes({}, {})


def changes_of(law: Any, replace: Any = None, insert: Any = None) -> Changes:
    """Return the user's changes; `law` is short for replacing the part called adaptation."""
    replacing = dict(pairs("replace", replace, "{'vehicle': block}"))
    if law is not None and LAW in replacing:
        raise DiagramError(f"law and replace = {LAW!r}: are one and the same; give one of them")
    if law is not None:
        replacing[LAW] = law
    inserting = dict(pairs("insert", insert, "{('v_x', 'vehicle'): lag}"))
    own = ({at: as_part(part) for at, part in given.items()} for given in (replacing, inserting))
    changes = Changes(*own)
    for part in changes.parts:
        read_anew(part)
    return changes


def replaced(parts: Sequence[Part], replace: Mapping[str, Any]) -> list[Part]:
    """Return parts of which some are replaced: {name of a part: another}."""
    new_parts = list(parts)
    for name, mine in replace.items():
        names = [part.name for part in new_parts]
        if name not in names:
            raise DiagramError(f"replace = {name!r}: must be among {', '.join(names)}")
        old = new_parts[names.index(name)]
        part = _in_place(mine, old, widths(new_parts), f"replace = {name!r}")
        new_parts[names.index(name)] = part
    return new_parts


def inserted(parts: Sequence[Part], insert: Mapping[Any, Any]) -> list[Part]:
    """Return parts with inserted ones: {signal, or (signal, block that takes it): part}."""
    new_parts = list(parts)
    for where, part in insert.items():
        signal, *users = [*where, ""][: len(where) or 1] if isinstance(where, tuple) else [where]
        argument, made = f"insert = {where!r}", widths(new_parts)
        if signal not in made:
            raise DiagramError(f"{argument}: must begin with one of {', '.join(sorted(made))}")
        takers = [one.name for one in new_parts if signal in input_ports(one)]
        wrong = [user for user in users if user not in takers]
        if wrong or not takers:
            raise DiagramError(
                f"{argument}: '{signal}' goes to {', '.join(takers) or 'nobody'}"
                + (f", not to {wrong[0]!r}" if wrong else "; give a signal that is taken")
            )
        own = [*output_ports(part)]
        name = own[0] if len(own) == 1 and own[0] not in {"y", *made} else f"{signal}_{part.name}"
        part = _between(part, (signal, made[signal]), (name, made[signal]), argument)
        for k, one in enumerate(new_parts):
            if one.name in (users or takers):
                new_parts[k] = with_ports(one, {signal: name}, {})
        new_parts.append(part)
    return new_parts


def widths(parts: Sequence[Part]) -> dict[str, int]:
    """Return the ports that parts make, each with its number of signals."""
    return {port: n for part in parts for port, n in counts_of(part.output_labels).items()}


def pairs(argument: str, given: Any, example: str) -> list[tuple[Any, Any]]:
    """Return the items of a mapping; refuse another object."""
    if given is not None and not isinstance(given, Mapping):
        raise DiagramError(
            f"{argument}: is a {type(given).__name__}; must be a dict, such as {example}"
        )
    return [*(given or {}).items()]


def _in_place(part: Part, old: Part, made: Mapping[str, int], argument: str) -> Part:
    """Return a part with the ports of another, if both have one input and one output port."""
    ports = [[*of(one)] for one in (old, part) for of in (input_ports, output_ports)]
    if any(len(own) != 1 for own in ports):
        return part
    (taken,), (wanted,), (takes,), _ = ports
    if takes in made:  # it is wired by name
        taken = takes
    count = made.get(taken, len(input_ports(old).get(taken, ())))
    return _between(part, (taken, count), (wanted, made[wanted]), argument)


def _between(part: Part, taken: tuple[str, int], made: tuple[str, int], argument: str) -> Part:
    """Return a part that takes one port and makes another, each with its number of signals."""
    takes, makes = input_ports(part), output_ports(part)
    to = taken[0] if len(takes) != 1 else next(iter(takes))
    meant = [*makes] if len(makes) == 1 else [port for port in (made[0], taken[0]) if port in makes]
    out = next(iter(meant), made[0])
    for which, port, ports in (("takes", to, takes), ("makes", out, makes)):
        if port not in ports:
            raise DiagramError(
                f"{argument}: {part.name} {which} {', '.join(ports)}; call the one that is meant "
                f"'{port}', or give a part with one input port and one output port"
            )
    if is_linear(part) and part.ninputs == part.noutputs == 1 and taken[1] == made[1] != 1:
        part, to, out = on_each_axis(part, taken[1]), "u", "y"
    return with_ports(part, {to: taken[0]}, {out: made[0]})
