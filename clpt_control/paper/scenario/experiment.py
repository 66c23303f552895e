"""The typed scenario of one experiment.

A scenario describes the flow, the vehicle, the learner and the run, as a TOML file does, in the
file's units of length and time.  `simulation.closed_loop` makes the blocks of a scenario.
"""

import os
from collections.abc import Iterator, Mapping
from functools import cache
from operator import attrgetter
from pathlib import Path
from typing import Annotated, Any

import numpy as np
from pydantic import Field, PrivateAttr, ValidationInfo, model_validator

from ...base.arguments import public
from ...base.errors import DataError, ScenarioError
from ...base.geodesy import LocalPlane, angle_near, is_place
from ...base.html import facts, fragment, shortened
from ...base.run_attributes import MOST_BYTES
from ...engine.model.block import Block
from ...engine.model.sampled import Sampled
from ..blocks.flow import flow_basis
from ..laws.law import LawContext
from ..laws.table import LAWS
from . import tables
from .learning import Learning

Nested = dict[str, Any]  # tables of a scenario, as TOML has them
MOST_JUMPS = 10**7  # of one block in a run
STARTING = "vehicle", "learning"  # tables that have a position
LENGTHS = ("reference.points", "basis.centers", "vehicle.position", "learning.position")
DEGREES = 3.0  # lengths this near to the origin's latitude and longitude are degrees
FINE = 2000  # samples of a run in addition to those of its output
SPANS = (  # keys of times from one jump to the next
    "reference.dwell",
    "flow.disturbance.period",
    "learning.sample",
    "localization.interval",
    "localization.noise_period",
)
# floats of memory for each sample, and for each sample and function: measured, times two
NUMBERS = (110, 24)
AT_FIXES = " or ".join(law.name for law in LAWS.values() if law.at_fixes)


class Scenario(tables.Table):
    """One experiment: flow, vehicle, waypoints, law and run.

    Made by `load_scenario`, or from keywords of the same names as the tables
    of the TOML file. All numbers are in ``units.length`` and ``units.time``.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario()
    >>> scenario.basis.N, scenario.learning.gain
    (3, 0.8)
    """

    #: title = "Cho, Zhang, Edwards 2016, section IV" # text
    title: str = ""
    #: # origin = [41.2, -69.5] # latitude and longitude of (0, 0); runs and maps then have degrees
    origin: tables.Pair | None = None
    #: [units] # every number below is in these
    units: tables.Units = tables.Units()
    #: [basis] # flow basis functions, Eq. (5); one entry per function
    basis: tables.Basis
    #: [flow] # the true flow, Eq. (3): parameters, field or basis
    flow: tables.Flow = tables.left_out("flow")
    #: [model] # the modelled flow, Eq. (4)
    model: tables.Model = tables.Model()
    #: [vehicle] # vehicle and controller, Eqs. (1) and (7)
    vehicle: tables.Vehicle = tables.left_out("vehicle")
    #: [reference] # waypoints zc(t)
    reference: Annotated[
        tables.Circle | tables.Waypoints, Field(discriminator="kind")
    ] = tables.left_out("reference")
    #: [learning] # the adaptive law
    learning: Learning
    #: # [localization] # noise on the position that the vehicle reads, or fixes
    localization: tables.Localization | None = None
    #: [run]
    run: tables.Run = tables.left_out("run")
    _folder: Path = PrivateAttr(default_factory=Path)

    def _mistakes(self) -> Iterator[str]:
        if self.left_out and self.learning.row.between_fixes is None:
            yield f"missing key {self.left_out[0]}"
        yield from self._place_mistakes()
        yield from self._shape_mistakes()
        if not self.left_out:
            yield from self._law_mistakes()
            yield from self._size_mistakes()

    @property
    def left_out(self) -> list[str]:
        """Tables that a scenario for recorded fixes leaves out."""
        return [name for name, table in self if isinstance(table, tables.LeftOut)]

    def _place_mistakes(self) -> Iterator[str]:
        """Yield mistakes of latitudes and longitudes, also of those given as lengths."""
        values = {key: v for key, v, _ in self.every_key() if v is not None}
        degrees = [key for key in values if key.endswith(("origin", "_lat_lon"))]
        for key in degrees:
            for lat, lon in np.reshape(values[key], (-1, 2)):
                if not is_place(lat, lon):
                    yield f"{key}: [{lat}, {lon}] must be latitude and longitude in degrees"
                    return
        if self.origin is None:
            for key in degrees[:1]:
                yield (
                    f"origin: is required with {key}. Give the latitude and "
                    "longitude of the plane's origin above all tables: origin = [41.2, -69.5]"
                )
            return
        for key in filter(values.get, LENGTHS):
            pairs = np.reshape(values[key], (-1, 2)).tolist()
            if all(self._is_near_origin_in_degrees(*pair) for pair in pairs):
                yield (
                    f"{key} = {pairs[0]}: looks like degrees, but is in "
                    f"{self.units.length} from the origin {list(self.origin)}. Give degrees as "
                    "reference.points_lat_lon or as position_lat_lon"
                )
        yield from self._place_starts()
        if "reference" in self.left_out:
            return
        try:
            self.waypoints  # noqa: B018 - too far from the origin
        except DataError as error:
            yield f"reference.points_lat_lon: {error}"

    def _place_starts(self) -> Iterator[str]:
        """Set positions that are given in degrees, in lengths; yield those too far away."""
        for name in STARTING:
            table = getattr(self, name)
            if name in self.left_out or table.position_lat_lon is None:
                continue
            try:
                x1, x2 = self.plane.to_plane(*table.position_lat_lon)
            except DataError as error:
                yield f"{name}.position_lat_lon: {error}"
                return
            # a copy, as the table may be that of another scenario; the key is not set in it
            table = table.model_copy()
            table.__dict__["position"] = float(x1), float(x2)
            self.__dict__[name] = table

    def _is_near_origin_in_degrees(self, first: float, second: float) -> bool:
        """Return True if two lengths are the latitude and longitude of a place at the origin."""
        lat, lon = self.origin or (0.0, 0.0)
        far_from_zero = max(abs(lat), abs(lon)) > DEGREES
        return far_from_zero and any(
            abs(a - lat) < DEGREES and abs(angle_near(b, lon) - lon) < DEGREES
            for a, b in ((first, second), (second, first))
        )

    def _shape_mistakes(self) -> Iterator[str]:
        for key, quantity in self.quantities().items():
            is_given = key.partition(".")[0] not in self.left_out
            has_rows = is_given and quantity.axes == "axis basis"
            rows = attrgetter(key)(self) if has_rows else None
            if rows is not None and any(len(row) != self.basis.N for row in rows):
                yield (
                    f"{key}: must be 2 rows of {self.basis.N} numbers, one per basis "
                    f"function; the rows have {len(rows[0])} and {len(rows[1])}"
                )

    def _law_mistakes(self) -> Iterator[str]:
        """Yield what the law needs of other tables."""
        if self.learning.hedging is not None and self.vehicle.max_speed is None:
            yield (
                f"learning.hedging = {str(self.learning.hedging).lower()}: is allowed only with "
                "vehicle.max_speed, which it tells the learner of. Remove the key or give the limit"
            )
        row, fixes, sample = self.learning.row, self.localization, self.learning.sample
        if row.at_fixes != (fixes is not None and fixes.interval > 0):
            yield (
                f'learning.law = "{row.name}": {AT_FIXES} learns at fixes, and needs '
                "localization.interval above 0, the time from one to the next; other laws read the "
                "position at all times, with the interval 0 or left out"
            )
        begins = {"learning.sample": sample}
        if fixes is not None:
            begins["localization.interval"] = fixes.interval + fixes.latency
        for key in ("localization.interval", "learning.sample"):
            time = begins.get(key)
            if time is not None and time > self.run.duration:
                yield (
                    f"{key}: nothing is learned before t = {time}, and run.duration is "
                    f"{self.run.duration}; must be at most that"
                )

    def _size_mistakes(self) -> Iterator[str]:
        """Yield a sentence if a run would need too much memory or have too many jumps."""
        N = self.basis.N
        samples = self.run.duration / self.run.output_step
        size = 8 * (NUMBERS[0] + NUMBERS[1] * N) * (samples + FINE)
        if size > MOST_BYTES:
            yield (
                f"run.output_step = {self.run.output_step}: {samples:.3g} samples of {N} basis "
                f"functions would take {size / 1e9:.3g} GB of memory; at most "
                f"{MOST_BYTES / 1e9:g} are allowed: take a longer step, a shorter run or fewer "
                "functions"
            )
        least = self.run.duration / MOST_JUMPS
        for key, span, _ in self.every_key():
            if key in SPANS and span and span < least:
                yield (
                    f"{key} = {span}: more than {MOST_JUMPS:.0e} times in run.duration; must be at "
                    f"least {least:.3g}"
                )

    @model_validator(mode="after")
    def _field_is_there(self, info: ValidationInfo) -> "Scenario":
        folder = (info.context or {}).get("folder")
        if folder is None:
            return self
        self._folder = Path(folder)
        if "flow" in self.left_out:
            return self
        path = Path(folder) / (self.flow.field or "")
        if self.flow.field is not None and not os.path.isfile(path):  # noqa: PTH113 - never raises
            raise ValueError(
                f'flow.field = "{self.flow.field}": no such file; must be a NetCDF file, relative '
                "to the scenario"
            )
        return self

    def __eq__(self, value: object) -> bool:
        return isinstance(value, Scenario) and self.__dict__ == value.__dict__

    def __repr__(self) -> str:
        use = "for recorded fixes"
        if not self.left_out:
            points = len(self.waypoints)
            visited = f"{points} waypoint{'s' * (points > 1)}"
            use = f"{visited}, {self.run.duration:g} {self.units.time}"
        return (
            f"<Scenario {shortened(self.title, 60)!r}: {self.learning.law}, {self.basis.N} flow "
            f"functions, {use}>"
        )

    __str__ = __repr__

    def _repr_html_(self) -> str:
        keys = ((key, value) for key, value, is_set in self.every_key() if is_set)
        return fragment("Scenario", self.title, facts(keys))

    @property
    def periods(self) -> np.ndarray:
        """Periods of the basis functions, units.time; inf is steady."""
        return self.basis.periods_in(self.units.time)

    @property
    def frequencies(self) -> np.ndarray:
        """Angular frequencies omega_i of Eq. (5), rad per units.time."""
        return 2 * np.pi / self.periods

    @property
    def phases(self) -> tuple[float, ...]:
        """Phases of the basis functions, rad."""
        return self.basis.phases or (0.0,) * self.basis.N

    @property
    def model_parameters(self) -> tables.TwoRows:
        """alpha_M of Eq. (4), zero if the scenario leaves it out."""
        return self.model.parameters or ((0.0,) * self.basis.N,) * 2

    @property
    def learning_parameters(self) -> tables.TwoRows:
        """alpha(0); alpha_M with a law that does not adapt alpha."""
        if self.learning.row.alpha_is_constant:
            return self.model_parameters
        return self.learning.parameters or ((0.0,) * self.basis.N,) * 2

    @property
    def hedged(self) -> bool:
        """True if the learning model subtracts the unflown velocity."""
        knows = self.learning.hedging is not False and not self.learning.row.at_fixes
        return self.vehicle.max_speed is not None and knows

    @property
    def known_to_law(self) -> LawContext:
        """Facts of the experiment that the law may use."""
        return LawContext(
            self.basis.N,
            self.learning.used_gains,
            np.array(self.model_parameters),
            np.array(self.vehicle.feedback),
            self.waypoints,
            self.reference.dwell,
            np.array(self.vehicle.position),
            np.array(self.learning_parameters),
            np.array(self.learning.theta_estimate or self.model_parameters),
            self.learning.settings,
            np.array(self.vehicle.feedforward),
            None if self.localization is None else self.localization.fixes,
            self.vehicle.max_speed is not None,
        )

    @public
    def basis_block(self, position: str = "x") -> Block:
        """Return the block phi(x, t) of Eq. (5).

        Parameters
        ----------
        position : str, optional
            The port of the position.

        Returns
        -------
        Block
            A static block with the output ``phi_x``, or of another position.

        Examples
        --------
        >>> import clpt_control as clpt
        >>> clpt.paper_scenario().basis_block("z").output_ports
        {'phi_z': 3}
        """
        basis = self.basis
        functions = basis.centers, basis.widths, self.frequencies, self.phases
        return flow_basis(f"basis_{position}", position, basis.kernel, *functions)

    @property
    def law_block(self) -> Block:
        """The law as a block; sampled if ``learning.sample`` is set."""
        law = self.learning.row.block(self.known_to_law)
        sample = self.learning.sample
        return law if sample is None else Sampled(law, sample)

    @property
    def waypoints(self) -> np.ndarray:
        """Waypoints, shape (n, 2), units.length."""
        from ..blocks.reference import circle

        reference = self.reference
        if isinstance(reference, tables.Circle):
            return circle(reference.radius, reference.count)
        if reference.points_lat_lon is not None:
            lat, lon = np.transpose(reference.points_lat_lon)
            return np.column_stack(self.plane.to_plane(lat, lon))
        return np.array(reference.points)

    @property
    def plane(self) -> LocalPlane:
        """Local plane around the origin, in units.length."""
        if self.origin is None:
            raise DataError("origin: the scenario has no latitude and longitude")
        return _plane(*self.origin, self.units.length)

    @property
    def cycle(self) -> float:
        """Time to visit every waypoint once, units.time."""
        return len(self.waypoints) * self.reference.dwell

    @property
    def field_path(self) -> Path | None:
        """The file of the gridded field; None with parameters theta."""
        if "flow" in self.left_out or self.flow.field is None:
            return None
        return self._folder / self.flow.field

    @public
    def with_values(self, values: Mapping[str, Any]) -> "Scenario":
        """Return a scenario with some values changed and checked again.

        Parameters
        ----------
        values : mapping
            ``{"learning.gain": 2.0}``: dotted keys as in the TOML file; another
            ``reference.kind`` leaves out the keys of the old one, but for its dwell.

        Returns
        -------
        Scenario
            A new scenario.

        Raises
        ------
        ScenarioError
            If a key or value is not allowed.

        Examples
        --------
        >>> import clpt_control as clpt
        >>> clpt.paper_scenario().with_values({"learning.gain": 2.0}).learning.gain
        2.0
        """
        nested = scenario_tables(self)
        reference = nested.get("reference", {})
        kind = values.get("reference.kind")
        if kind is not None and kind != reference.get("kind", kind):
            # the two kinds have only the dwell in common
            nested["reference"] = {"dwell": self.reference.dwell}
        for key, value in values.items():
            *path, leaf_key = str(key).split(".")
            table = nested
            for name in path:
                table = table.setdefault(name, {})
                if not isinstance(table, dict):
                    raise ScenarioError(
                        f"scenario: unknown key {key}: {name} is not a table of keys"
                    )
            if value is None:
                table.pop(leaf_key, None)
            else:
                by_numpy = isinstance(value, np.ndarray | np.generic)
                table[leaf_key] = value.tolist() if by_numpy else value
        return checked_scenario(nested, "scenario", self._folder)

    @public
    def started_true(self) -> "Scenario":
        """Return the scenario with the learner started at the truth.

        That is alpha(0) = -theta, K(0) = KD, Gamma(0) = GammaD and z(0) = x(0).

        Raises
        ------
        ScenarioError
            If the true flow is a gridded field, which has no theta.

        Examples
        --------
        >>> import clpt_control as clpt
        >>> clpt.paper_scenario().started_true().learning.parameters[0]
        (-1.0, -0.4, -0.8)
        """
        if self.flow.parameters is None:
            raise ScenarioError(
                "flow: a gridded field or flow.basis has no true parameters to start from"
            )
        start = {
            "parameters": -np.array(self.flow.parameters),
            "feedback": self.vehicle.feedback,
            "feedforward": self.vehicle.feedforward,
            "position": self.vehicle.position,
            "position_lat_lon": None,
        }
        return self.with_values({f"learning.{key}": start[key] for key in start})


tables.Table.scenario = Scenario


_plane = cache(LocalPlane)


def checked_scenario(nested: Nested, name: str, folder: Path | None) -> Scenario:
    """Return a scenario of nested dicts; `name` begins each error.

    Files of the scenario are relative to `folder`; if it is None, they need not exist.
    """
    return Scenario.model_validate(nested, context={"name": name, "folder": folder})


def scenario_tables(scenario: Scenario) -> Nested:
    """Return a scenario as nested dicts of the keys that were set."""
    return scenario.model_dump(mode="python", exclude_none=True, exclude_unset=True)
