"""What can be a part of a diagram: a block, and python-control's systems beside it; parts replaced.

A `control.ss`, `tf` or summing junction becomes a block of A, B, C, D; diagrams and systems by
functions stay as they are.  The labels of a system form its ports: `v_c[0], v_c[1]` is v_c.
Parts of one discrete time stay as they are; beside others each samples what it takes.

A part that replaces another makes the ports that others take of it.  A part that is inserted
takes a signal, and what it makes goes to those who took the signal; the signal keeps its name.
"""

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple, TypeAlias

import control

from ..equations.block import Block
from ..equations.declaration import labels, ports_of, renamed
from ..equations.sampled import Sampled
from ..equations.system import System, is_linear, linear, on_each_axis
from ..errors import DiagramError
from .wiring import read_anew


def as_part(system: Any, discrete: bool = False) -> control.NonlinearIOSystem:
    """Return what can be wired; refuse in a sentence what cannot.

    What is of discrete time samples, but in a diagram that is `discrete` throughout.
    """
    part = _wired(system)
    return part if discrete or not is_discrete(part) else sampled(part, part.dt)


def is_discrete(*systems: Any) -> bool:
    """Return whether systems are of one discrete time, as python-control wires them."""
    times = {getattr(system, "dt", 0) for system in systems} - {None}
    return bool(times) and 0 not in times and len(times - {True}) < 2


def sampled(
    part: control.NonlinearIOSystem, period: float, params: Mapping[str, Any] | None = None
) -> control.NonlinearIOSystem:
    """Return a part of discrete time as one of continuous time, a diagram block by block.

    `params` are those that a diagram hands down.
    """
    if period is True:
        raise DiagramError(
            f"{part.name}: dt = True does not say how often it samples; give dt a number"
        )
    if isinstance(part, Block):
        return Sampled(part, period)
    own = {**part.params, **(params or {})}
    if not isinstance(part, control.InterconnectedSystem):
        linear_alone = isinstance(part, control.StateSpace)
        return Sampled(linear(part) if linear_alone else System(part, own), period)
    made = control.InterconnectedSystem(
        [sampled(one, period, own) for one in part.syslist],
        inputs=part.input_labels,
        outputs=part.output_labels,
        name=part.name,
    )
    made.set_connect_map(part.connect_map)
    made.set_input_map(part.input_map)
    made.set_output_map(part.output_map)
    return made


def _wired(system: Any) -> control.NonlinearIOSystem:
    if isinstance(system, Block):
        return system
    by_equations = isinstance(system, control.NonlinearIOSystem | control.TransferFunction)
    if not by_equations:
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
    linear_alone = isinstance(system, control.StateSpace | control.TransferFunction)
    if linear_alone and not isinstance(system, control.InterconnectedSystem):
        return linear(system)
    return system


def input_ports(part: control.NonlinearIOSystem) -> dict[str, list[int]]:
    """Return the ports that a part takes, each with the places of its signals."""
    return ports_of(part.input_labels)


def output_ports(part: control.NonlinearIOSystem) -> dict[str, list[int]]:
    """Return the ports that a part makes, each with the places of its signals."""
    return ports_of(part.output_labels)


def sizes(ports: Mapping[str, list[int]]) -> str:
    """Return ports in words, as `alpha[6], K[2]`."""
    return ", ".join(f"{port}[{len(at)}]" for port, at in ports.items()) or "nothing"


def functions_of(law: control.NonlinearIOSystem) -> int:
    """Return the N of a law; refuse a part that does not make alpha[2N], K[2] and Gamma[2]."""
    if not isinstance(law, control.NonlinearIOSystem):
        what = f"a {type(law).__name__}" if hasattr(law, "name") else f"{law!r:.60}"
        raise DiagramError(f"{what} is no law: give a Block")
    made = {port: len(places) for port, places in output_ports(law).items()}
    N = made.get("alpha", 0) // 2
    if N < 1 or {"alpha": 2 * N, "K": 2, "Gamma": 2}.items() - made.items():
        raise DiagramError(
            f"{law.name}: a law makes alpha[2N], K[2] and Gamma[2]; it makes "
            f"{sizes(output_ports(law))}; clpt.theory.lyapunov judges a V on any diagram"
        )
    taken = len(input_ports(law).get("phi_x", range(N)))
    if taken != N:
        raise DiagramError(f"{law.name}: phi_x has {taken} signals, N is {N}")
    return N


def with_ports(
    part: control.NonlinearIOSystem, inputs: Mapping[str, str], outputs: Mapping[str, str]
) -> control.NonlinearIOSystem:
    """Return a part that takes and makes signals of other names: {old: new}."""
    if isinstance(part, Block):
        return renamed(part, part.name, inputs, outputs)
    found = part.copy(name=part.name)
    for old, ports, put in (
        (inputs, input_ports(part), found.set_inputs),
        (outputs, output_ports(part), found.set_outputs),
    ):
        names: dict[int, str] = {}
        for port, places in ports.items():
            own = labels({old.get(port, port): len(places)})
            names |= dict(zip(places, own, strict=True))
        put([names[place] for place in range(len(names))])
    return found


# --- parts replaced and inserted, by name ---------------------------------------------------------


Part: TypeAlias = control.NonlinearIOSystem
LAW = "adaptation"  # the part that is the adaptive law


class Changes(NamedTuple):
    """Parts of the user's own: {name: part} and {signal, or (signal, who takes it): part}."""

    replace: dict[str, Any]
    insert: dict[Any, Any]

    @property
    def law(self) -> Part | None:
        """The part in place of the law, if there is one."""
        return as_part(self.replace[LAW]) if LAW in self.replace else None

    @property
    def names(self) -> list[str]:
        """The names of the user's parts."""
        return [as_part(part).name for part in (*self.replace.values(), *self.insert.values())]

    @property
    def in_words(self) -> str:
        """What is replaced, other than the law, and inserted."""
        places = [where for where in self.replace if where != LAW]
        places += [where if isinstance(where, str) else " to ".join(where) for where in self.insert]
        names = [name for name in self.names if self.law is None or name != self.law.name]
        return ", ".join(f"{place}: {name}" for place, name in zip(places, names, strict=True))

    def of_blocks(self, what: str) -> "Changes":
        """Return the parts as blocks, for what runs as machine code alone."""
        found = Changes(*({at: as_part(part) for at, part in parts.items()} for parts in self))
        for part in (*found.replace.values(), *found.insert.values()):
            if not isinstance(part, Block):
                raise DiagramError(
                    f"{part.name}: is a {type(part).__name__}; {what} takes blocks, control.ss and "
                    "control.tf"
                )
        return found


UNCHANGED = Changes({}, {})


def changes_of(law: Any = None, replace: Any = None, insert: Any = None) -> Changes:
    """Return what is to be changed; `law` is another word for the part called adaptation."""
    found = dict(pairs("replace", replace, "{'vehicle': block}"))
    if law is not None and LAW in found:
        raise DiagramError(f"law and replace = {LAW!r}: are one and the same; give one of them")
    if law is not None:
        found[LAW] = law
    changes = Changes(found, dict(pairs("insert", insert, "{('v_x', 'vehicle'): lag}")))
    for part in (*changes.replace.values(), *changes.insert.values()):
        read_anew(part)
    return changes


def replaced(parts: Sequence[Part], replace: Mapping[str, Any]) -> list[Part]:
    """Return parts of which some are replaced: {name of a part: another}."""
    found = list(parts)
    for name, system in replace.items():
        names = [part.name for part in found]
        if name not in names:
            raise DiagramError(f"replace = {name!r}: must be among {', '.join(names)}")
        said, old = f"replace = {name!r}", found[names.index(name)]
        part = _in_place(as_part(system), old, widths(found), said)
        made = output_ports(part)
        for port, places in output_ports(old).items():
            users = [other.name for other in found if port in input_ports(other)]
            if users and len(made.get(port, ())) != len(places):
                raise DiagramError(
                    f"{said}: {part.name} must make {port}[{len(places)}], which goes to "
                    f"{', '.join(users)}; it makes {sizes(made)}; give its outputs these names"
                )
        found[names.index(name)] = part
    return found


def inserted(parts: Sequence[Part], insert: Mapping[Any, Any]) -> list[Part]:
    """Return parts with others between them: {signal, or (signal, who takes it): part}."""
    found = list(parts)
    for where, system in insert.items():
        signal, *users = [*where, ""][: len(where) or 1] if isinstance(where, tuple) else [where]
        said, made = f"insert = {where!r}", widths(found)
        if signal not in made:
            raise DiagramError(f"{said}: must begin with one of {', '.join(sorted(made))}")
        takers = [one.name for one in found if signal in input_ports(one)]
        wrong = [user for user in users if user not in takers]
        if wrong or not takers:
            raise DiagramError(
                f"{said}: '{signal}' goes to {', '.join(takers) or 'nobody'}"
                + (f", not to {wrong[0]!r}" if wrong else "; give a signal that is taken")
            )
        part = as_part(system)
        own = [*output_ports(part)]
        name = own[0] if len(own) == 1 and own[0] not in {"y", *made} else f"{signal}_{part.name}"
        part = _between(part, (signal, made[signal]), (name, made[signal]), said)
        for k, one in enumerate(found):
            if one.name in (users or takers):
                found[k] = with_ports(one, {signal: name}, {})
        found.append(part)
    return found


def widths(parts: Sequence[Part]) -> dict[str, int]:
    """Return what parts make, and of how many signals each is."""
    return {port: len(places) for part in parts for port, places in output_ports(part).items()}


def pairs(argument: str, given: Any, example: str) -> list[tuple[Any, Any]]:
    """Return what a mapping holds; refuse what is none."""
    if given is not None and not isinstance(given, Mapping):
        raise DiagramError(
            f"{argument}: is a {type(given).__name__}; must be a dict, such as {example}"
        )
    return [*(given or {}).items()]


def _in_place(part: Part, old: Part, made: Mapping[str, int], said: str) -> Part:
    """Return a part under the ports of another, where each has one in and one out."""
    ports = [[*of(one)] for one in (old, part) for of in (input_ports, output_ports)]
    if any(len(own) != 1 for own in ports):
        return part
    (taken,), (wanted,), (takes,), _ = ports
    if takes in made:  # it is wired by name
        taken = takes
    count = made.get(taken, len(input_ports(old).get(taken, ())))
    return _between(part, (taken, count), (wanted, made[wanted]), said)


def _between(part: Part, taken: tuple[str, int], made: tuple[str, int], said: str) -> Part:
    """Return a part that takes one port and makes another, each with its number of signals."""
    takes, makes = input_ports(part), output_ports(part)
    to = taken[0] if len(takes) != 1 else next(iter(takes))
    out = (
        next(iter(makes))
        if len(makes) == 1
        else next((port for port in (made[0], taken[0]) if port in makes), made[0])
    )
    for which, port, ports in (("takes", to, takes), ("makes", out, makes)):
        if port not in ports:
            raise DiagramError(
                f"{said}: {part.name} {which} {sizes(ports)}; call the one that is meant '{port}', "
                "or give a part with one input port and one output port"
            )
    own = len(takes[to]), len(makes[out])
    if is_linear(part) and part.ninputs == part.noutputs == 1 and taken[1] == made[1] != 1:
        part, to, out = on_each_axis(part, taken[1]), "u", "y"
    elif own != (taken[1], made[1]):
        raise DiagramError(
            f"{said}: {part.name} takes {own[0]} and makes {own[1]} signals, must take "
            f"{taken[0]}[{taken[1]}] and make {made[1]}; control.append joins parts of one signal"
        )
    return with_ports(part, {to: taken[0]}, {out: made[0]})
