"""Do the units that are declared for a block fit together?  Its equations are tried in others.

With a metre half as long every length is twice as large a number, every speed too, and an
acceleration per second squared stays.  Equations whose units fit give, of numbers so changed,
results so changed: for an output y of unit m^a s^b, in a unit of length 1/c times as long,

    y(c^.. u, c^.. p) = c^a y(u, p)

A number with a unit that stands inside the equations, two units added, or a unit declared
wrongly breaks it.  m and km are two units here: nobody but a reader knows what 1000 stands for.
"""

import re
from collections.abc import Callable, Iterator, Mapping

import numpy as np

from ..equations.block import Block
from ..errors import BlockError
from .equations import Sample, python_values, roles

FACTOR = 1.7  # by which a unit is made smaller
TOLERANCE = 1e-9  # of the largest value; rounding is far below
UNIT = re.compile(r"([A-Za-z_]+)(?:\^|\*\*)?(-?\d+)?")


def powers(unit: str) -> dict[str, int]:
    """Return the powers of a unit, in which rad and 1 are none.

    >>> powers("m/s"), powers("1/s^2"), powers("m s-1"), powers("1")
    ({'m': 1, 's': -1}, {'s': -2}, {'m': 1, 's': -1}, {})
    """
    found: dict[str, int] = {}
    for k, part in enumerate(unit.replace("**", "^").split("/")):
        for word in re.split(r"[\s.*()]+", part.strip(" ()")):
            read = UNIT.fullmatch(word)
            if read is None and word not in ("", "1"):
                raise BlockError(f"units: {unit!r} is no unit; write such as 'm', 'm/s' or '1/s^2'")
            if read is not None and read[1] not in ("rad", "radians"):
                power = int(read[2] or 1) * (-1 if k else 1)
                found[read[1]] = found.get(read[1], 0) + power
    return {symbol: power for symbol, power in found.items() if power}


def keeps_units(units: Mapping[str, str]) -> Callable[[Block, list[Sample]], Iterator[str]]:
    """Return the check of a block whose ports, parameters and time t have these units."""

    def check(block: Block, drawn: list[Sample]) -> Iterator[str]:
        """Equations hold in other units alike."""
        yield from _failures(block, drawn, {"t": "s", **units})

    return check


def _failures(block: Block, drawn: list[Sample], units: Mapping[str, str]) -> Iterator[str]:
    ports = {**block.input_ports, **block.state_ports, **block.output_ports}
    numbers = block.parameters._asdict()
    scaled = [n for n in numbers if n != "interval" and not isinstance(numbers[n], int)]
    unknown = set(units) - {"t", *ports, *scaled}
    missing = {*ports, *scaled} - set(units)
    if unknown:
        yield f"{block.name}: units: no port or parameter is called '{min(unknown)}'"
    if missing:
        yield (
            f"{block.name}: units: '{min(missing)}' has none; give one to each port and each "
            "parameter that is no whole number, '1' where there is none"
        )
    if unknown or missing:
        return
    each = {name: powers(unit) for name, unit in units.items()}
    for symbol in sorted({symbol for one in each.values() for symbol in one}):
        by = {name: FACTOR ** one.get(symbol, 0) for name, one in each.items()}
        for role in roles(block):
            made = block.output_ports if role == "output" else block.state_ports
            rate = by["t"] if role == "update" else 1.0
            names = [port for port, count in made.items() for _ in range(count)]
            for sample in drawn:
                other = Sample(
                    sample.t * by["t"],
                    sample.x * _along(block.state_ports, by),
                    sample.u * _along(block.input_ports, by),
                    sample.p._replace(**{n: getattr(sample.p, n) * by[n] for n in scaled}),
                )
                wanted = python_values(block, role, sample) * _along(made, by) / rate
                got = python_values(block, role, other)
                off = np.abs(got - wanted) > TOLERANCE * np.max(np.abs(wanted), initial=0.0)
                if off.any():
                    port = names[int(np.argmax(off))]
                    yield (
                        f"{block.name}.{role}: {port} is not of the unit '{units[port]}' that is "
                        f"declared: in a smaller {symbol} it becomes {got[off][0]:.6g}, not "
                        f"{wanted[off][0]:.6g}; "
                        "a number in the equations has a unit, or one is declared wrongly"
                    )
                    break


def _along(ports: Mapping[str, int], by: Mapping[str, float]) -> np.ndarray:
    """Return the factor of each signal."""
    return np.array([by[port] for port, count in ports.items() for _ in range(count)])
