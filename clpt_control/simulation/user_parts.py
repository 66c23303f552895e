"""The user's own parts in the paper's loop: parts that replace others or are inserted.

A part that replaces another takes over the ports of that part which other parts use.  An inserted
part reads a signal; the blocks that read the signal before read the output of the inserted part.
"""

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import control

from ..base.errors import DiagramError
from ..engine.diagram.wiring import (
    Part,
    as_part,
    input_ports,
    is_discrete,
    output_ports,
    read_anew,
)
from ..engine.model.block import Block
from ..engine.model.declaration import ports_line
from ..engine.model.ports import counts_of, labels, renamed
from ..engine.model.system import block_of_ports, is_linear, on_each_axis

LAW = "adaptation"  # the part that is the adaptive law


class Changes(NamedTuple):
    """The user's own parts: {name: part} and {signal, or (signal, block that reads it): part}."""

    replace: dict[str, Part]
    insert: dict[Any, Part]

    @property
    def law(self) -> Part | None:
        """The user's law, or None."""
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
    def description(self) -> str:
        """Replaced parts, except the law, and inserted parts as one line of text."""
        replaced_parts = {
            name: part for name, part in self.replace.items() if name != LAW
        }
        inserted_parts = {
            signal if isinstance(signal, str) else " to ".join(signal): part
            for signal, part in self.insert.items()
        }
        items = [*replaced_parts.items(), *inserted_parts.items()]
        return ", ".join(f"{location}: {part.name}" for location, part in items)

    def of_blocks(self, user: str) -> "Changes":
        """Refuse parts that are no blocks, for a user that runs machine code only.

        A law that is a `control.nlsys` becomes a block.
        """
        if self.law is not None:
            law = law_block(self.law)
            return self._replace(replace={**self.replace, LAW: law})._of_blocks(user)
        return self._of_blocks(user)

    def _of_blocks(self, user: str) -> "Changes":
        for part in self.parts:
            if not isinstance(part, Block):
                raise DiagramError(
                    f"{part.name}: is a {type(part).__name__}; {user} takes blocks, control.ss and "
                    "control.tf"
                )
        return self


UNCHANGED = Changes({}, {})


def changes_of(law: Any, replace: Any = None, insert: Any = None) -> Changes:
    """Return the user's changes; `law` is short for replacing the part called adaptation."""
    replacing = _checked_mapping("replace", replace, "{'vehicle': block}")
    inserting = _checked_mapping("insert", insert, "{('v_x', 'vehicle'): lag}")
    if law is not None:
        if LAW in replacing:
            raise DiagramError(
                f"law and replace = {LAW!r}: are one and the same; give one of them"
            )
        replacing[LAW] = law
    changes = Changes(
        {name: as_part(part) for name, part in replacing.items()},
        {signal: as_part(part) for signal, part in inserting.items()},
    )
    for part in changes.parts:
        read_anew(part)
    return changes


def _checked_mapping(argument: str, value: Any, example: str) -> dict[Any, Any]:
    if value is not None and not isinstance(value, Mapping):
        raise DiagramError(
            f"{argument}: is a {type(value).__name__}; must be a dict, such as {example}"
        )
    return dict(value or {})


def law_block(law: Part) -> Part:
    """Return a law that is a `control.nlsys` as a block with alpha of shape (2, N)."""
    is_function = type(law) is control.NonlinearIOSystem and not is_discrete(law)
    if not is_function:
        return law
    return block_of_ports(law, {"alpha": (2, functions_of(law))})


def functions_of(law: Part) -> int:
    """Return the N of a law; refuse a part without the outputs alpha[2N], K[2] and Gamma[2]."""
    outputs = counts_of(law.output_labels)
    N = outputs.get("alpha", 0) // 2
    if N < 1 or {"alpha": 2 * N, "K": 2, "Gamma": 2}.items() - outputs.items():
        raise DiagramError(
            f"{law.name}: a law makes alpha[2N], K[2] and Gamma[2]; it makes "
            f"{ports_line(outputs)}; clpt.theory.lyapunov judges a V on any diagram"
        )
    count = counts_of(law.input_labels).get("phi_x", N)
    if count != N:
        raise DiagramError(f"{law.name}: phi_x has {count} signals, N is {N}")
    return N


def replaced(parts: Sequence[Part], replace: Mapping[str, Part]) -> list[Part]:
    """Return parts of which some are replaced: {name of a part: its replacement}."""
    parts = list(parts)
    for name, part in replace.items():
        names = [old.name for old in parts]
        argument = f"replace = {name!r}"
        if name not in names:
            raise DiagramError(f"{argument}: must be among {', '.join(names)}")
        index = names.index(name)
        parts[index] = _in_place(part, parts[index], _output_sizes(parts), argument)
    return parts


def inserted(parts: Sequence[Part], insert: Mapping[Any, Part]) -> list[Part]:
    """Return parts with inserted ones: {signal, or (signal, block that reads it): part}."""
    parts = list(parts)
    for key, part in insert.items():
        signal, *users = (key or ("",)) if isinstance(key, tuple) else (key,)
        argument, sizes = f"insert = {key!r}", _output_sizes(parts)
        if signal not in sizes:
            raise DiagramError(
                f"{argument}: must begin with one of {', '.join(sorted(sizes))}"
            )
        readers = [reader.name for reader in parts if signal in input_ports(reader)]
        wrong = [user for user in users if user not in readers]
        if wrong or not readers:
            remedy = (
                f", not to {wrong[0]!r}" if wrong else "; give a signal that is taken"
            )
            raise DiagramError(
                f"{argument}: '{signal}' goes to {', '.join(readers) or 'nobody'}{remedy}"
            )
        outputs = [*output_ports(part)]
        has_name = len(outputs) == 1 and outputs[0] not in {"y", *sizes}
        name = outputs[0] if has_name else f"{signal}_{part.name}"
        size = sizes[signal]
        part = _between(part, (signal, size), (name, size), argument)
        for index, reader in enumerate(parts):
            if reader.name in (users or readers):
                parts[index] = with_ports(reader, {signal: name}, {})
        parts.append(part)
    return parts


def with_ports(
    part: Part, inputs: Mapping[str, str], outputs: Mapping[str, str]
) -> Part:
    """Return a part with renamed inputs and outputs: {old: new}."""
    if isinstance(part, Block):
        return renamed(part, part.name, inputs, outputs)
    copy = part.copy(name=part.name)
    for new_names, ports, set_labels in (
        (inputs, input_ports(part), copy.set_inputs),
        (outputs, output_ports(part), copy.set_outputs),
    ):
        names: dict[int, str] = {}
        for port, indices in ports.items():
            new_labels = labels({new_names.get(port, port): len(indices)})
            names |= zip(indices, new_labels, strict=True)
        set_labels([names[index] for index in range(len(names))])
    return copy


def _output_sizes(parts: Sequence[Part]) -> dict[str, int]:
    """Return the output ports of parts, each with its number of signals."""
    return {
        port: size
        for part in parts
        for port, size in counts_of(part.output_labels).items()
    }


def _in_place(part: Part, old: Part, sizes: Mapping[str, int], argument: str) -> Part:
    """Return a part with the ports of an old one, if both have one input and one output port."""
    old_inputs, old_outputs = [*input_ports(old)], [*output_ports(old)]
    inputs, outputs = [*input_ports(part)], [*output_ports(part)]
    if any(len(ports) != 1 for ports in (old_inputs, old_outputs, inputs, outputs)):
        return part
    # a part whose input is a signal of the loop reads this signal
    source = inputs[0] if inputs[0] in sizes else old_inputs[0]
    size = sizes.get(source, len(input_ports(old).get(source, ())))
    result = old_outputs[0]
    return _between(part, (source, size), (result, sizes[result]), argument)


def _between(
    part: Part, source: tuple[str, int], result: tuple[str, int], argument: str
) -> Part:
    """Return a part that reads one port and writes another, each (name, number of signals)."""
    inputs, outputs = input_ports(part), output_ports(part)
    own_input = next(iter(inputs)) if len(inputs) == 1 else source[0]
    candidates = outputs if len(outputs) == 1 else [result[0], source[0]]
    own_output = next((port for port in candidates if port in outputs), result[0])
    for verb, port, ports in (
        ("takes", own_input, inputs),
        ("makes", own_output, outputs),
    ):
        if port not in ports:
            raise DiagramError(
                f"{argument}: {part.name} {verb} {', '.join(ports)}; call the one that is meant "
                f"'{port}', or give a part with one input port and one output port"
            )
    is_scalar = part.ninputs == part.noutputs == 1
    if is_linear(part) and is_scalar and source[1] == result[1] != 1:
        part, own_input, own_output = on_each_axis(part, source[1]), "u", "y"
    return with_ports(part, {own_input: source[0]}, {own_output: result[0]})
