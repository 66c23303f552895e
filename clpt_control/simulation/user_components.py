"""The user's own components in the paper's loop, which replace its blocks or are inserted.

A component that replaces a block takes over the ports that other blocks use.  An inserted component
reads a signal; the blocks that read the signal before read the output of the component.
"""

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import control

from ..base.arguments import check_known
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
from ..engine.model.ports import counts_of, renamed, whole_labels
from ..engine.model.system import System, is_linear, on_each_axis

LAW = "adaptation"  # the block of the adaptive law


class Changes(NamedTuple):
    """The user's components that replace blocks, by name, and that are inserted.

    The keys of inserted components are a signal, or (signal, block that reads the signal).
    """

    replace: dict[str, Part]
    insert: dict[Any, Part]

    @property
    def law(self) -> Part | None:
        """The user's law, or None."""
        return self.replace.get(LAW)

    @property
    def components(self) -> list[Part]:
        """The user's components."""
        return [*self.replace.values(), *self.insert.values()]

    @property
    def names(self) -> list[str]:
        """The names of the user's components."""
        return [component.name for component in self.components]

    @property
    def description(self) -> str:
        """The components except a law as one line of text, `location: name`."""
        texts = [
            f"{name}: {component.name}"
            for name, component in self.replace.items()
            if name != LAW
        ]
        for key, component in self.insert.items():
            location = key if isinstance(key, str) else " to ".join(key)
            texts.append(f"{location}: {component.name}")
        return ", ".join(texts)

    def of_blocks(self) -> "Changes":
        """Return the changes for machine code; raise `DiagramError` for a component in Python.

        A law that is a `control.nlsys` becomes a block.
        """
        changes = self
        if self.law is not None:
            replace = {**self.replace, LAW: law_block(self.law)}
            changes = self._replace(replace=replace)
        for component in changes.components:
            if not isinstance(component, Block):
                raise DiagramError(
                    f"{component.name}: is a {type(component).__name__}; an ensemble takes "
                    "blocks, control.ss and control.tf"
                )
        return changes


UNCHANGED = Changes({}, {})


def changes_of(law: Any, replace: Any = None, insert: Any = None) -> Changes:
    """Return the user's changes; `law` is short for the replacement of the block adaptation."""
    replacements = dict(replace or {})
    if law is not None:
        if LAW in replacements:
            raise DiagramError(
                f"law and replace = {LAW!r}: both replace the law. Give one of them"
            )
        replacements[LAW] = law
    changes = Changes(
        {name: as_part(component) for name, component in replacements.items()},
        {signal: as_part(component) for signal, component in (insert or {}).items()},
    )
    for component in changes.components:
        read_anew(component)
    return changes


def law_block(law: Part) -> Part:
    """Return a law that is a `control.nlsys` as a block with alpha of shape (2, N)."""
    is_function = type(law) is control.NonlinearIOSystem and not is_discrete(law)
    if not is_function:
        return law
    return System(law, shapes={"alpha": (2, functions_of(law))})


def functions_of(law: Part) -> int:
    """Return the N of a law, a component with the outputs alpha[2N], K[2] and Gamma[2]."""
    outputs = counts_of(law.output_labels)
    N = outputs.get("alpha", 0) // 2
    if N < 1 or {"alpha": 2 * N, "K": 2, "Gamma": 2}.items() - outputs.items():
        raise DiagramError(
            f"{law.name}: a law makes alpha[2N], K[2] and Gamma[2]; it makes "
            f"{ports_line(outputs)}; clpt.lyapunov judges a V on any diagram"
        )
    count = counts_of(law.input_labels).get("phi_x", N)
    if count != N:
        raise DiagramError(f"{law.name}: phi_x has {count} signals, N is {N}")
    return N


def replaced(components: Sequence[Part], replace: Mapping[str, Part]) -> list[Part]:
    """Return components of which some are replaced: {name: its replacement}."""
    components = list(components)
    made = _output_sizes(components)
    for name, component in replace.items():
        names = [old.name for old in components]
        argument = f"replace = {name!r}"
        check_known("replace", [name], names)
        index = names.index(name)
        sizes = _output_sizes(components)
        components[index] = _in_place(component, components[index], sizes, argument)
    read = {port for component in components for port in input_ports(component)}
    for port in sorted(made.keys() & read - _output_sizes(components).keys()):
        raise DiagramError(
            f"replace = {', '.join(replace)}: no block makes '{port}' now. Rename an output of the "
            f"new block to '{port}'"
        )
    return components


def inserted(components: Sequence[Part], insert: Mapping[Any, Part]) -> list[Part]:
    """Return components with inserted ones, whose keys are as in `Changes`."""
    components = list(components)
    for key, component in insert.items():
        signal, *users = (key or ("",)) if isinstance(key, tuple) else (key,)
        argument = f"insert = {key!r}"
        sizes = _output_sizes(components)
        if signal not in sizes:
            raise DiagramError(
                f"{argument}: must begin with one of {', '.join(sorted(sizes))}"
            )
        readers = [
            reader.name for reader in components if signal in input_ports(reader)
        ]
        strangers = [user for user in users if user not in readers]
        if strangers or not readers:
            remedy = ". Give a signal that is taken"
            if strangers:
                remedy = f", not to {strangers[0]!r}"
            raise DiagramError(
                f"{argument}: '{signal}' goes to {', '.join(readers) or 'nobody'}{remedy}"
            )
        outputs = [*output_ports(component)]
        has_name = len(outputs) == 1 and outputs[0] not in {"y", *sizes}
        name = outputs[0] if has_name else f"{signal}_{component.name}"
        size = sizes[signal]
        component = _between(component, (signal, size), (name, size), argument)
        for index, reader in enumerate(components):
            if reader.name in (users or readers):
                components[index] = with_ports(reader, {signal: name}, {})
        components.append(component)
    return components


def with_ports(
    component: Part, inputs: Mapping[str, str], outputs: Mapping[str, str]
) -> Part:
    """Return a component with renamed inputs and outputs: {old: new}."""
    if isinstance(component, Block):
        return renamed(component, component.name, inputs, outputs)
    copy = component.copy(name=component.name)
    copy.set_inputs(whole_labels(component.input_labels, inputs))
    copy.set_outputs(whole_labels(component.output_labels, outputs))
    return copy


def _output_sizes(components: Sequence[Part]) -> dict[str, int]:
    """Return the number of signals of each output port."""
    return {
        port: count
        for component in components
        for port, count in counts_of(component.output_labels).items()
    }


def _in_place(
    component: Part, old: Part, sizes: Mapping[str, int], argument: str
) -> Part:
    """Return a component with the ports of an old one, if both have one input and one output."""
    old_inputs = [*input_ports(old)]
    old_outputs = [*output_ports(old)]
    inputs = [*input_ports(component)]
    outputs = output_ports(component)
    if any(len(ports) != 1 for ports in (old_inputs, old_outputs, inputs, outputs)):
        return component
    # an input that is a signal of the loop keeps its name
    source = inputs[0] if inputs[0] in sizes else old_inputs[0]
    source_size = sizes.get(source, len(input_ports(old).get(source, ())))
    result = old_outputs[0]
    return _between(component, (source, source_size), (result, sizes[result]), argument)


def _between(
    component: Part, source: tuple[str, int], result: tuple[str, int], argument: str
) -> Part:
    """Return a component between two ports, each (name, number of signals)."""
    inputs = input_ports(component)
    outputs = output_ports(component)
    input_name = next(iter(inputs)) if len(inputs) == 1 else source[0]
    candidates = outputs if len(outputs) == 1 else [result[0], source[0]]
    output_name = next((port for port in candidates if port in outputs), result[0])
    for verb, port, ports in (
        ("takes", input_name, inputs),
        ("makes", output_name, outputs),
    ):
        if port not in ports:
            raise DiagramError(
                f"{argument}: {component.name} {verb} {', '.join(ports)}. Rename the intended "
                f"port to '{port}', or give a part with one input port and one output port"
            )
    is_scalar = component.ninputs == component.noutputs == 1
    if is_linear(component) and is_scalar and source[1] == result[1] != 1:
        component = on_each_axis(component, source[1])
        input_name = "u"
        output_name = "y"
    return with_ports(component, {input_name: source[0]}, {output_name: result[0]})
