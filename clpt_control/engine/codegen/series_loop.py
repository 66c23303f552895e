"""A run by Taylor series as one function of machine code.

    void series(X, P, T, W, times, edges, values, out, numbers, indices, integers)

Coefficients (`series`) are scaled by the last step, so that they neither overflow nor underflow.
The last two give the step, at most `GROWTH` times the last one; what a function is sensitive to may
not change by more than the function allows.  Each step is checked: at three times within it the
rates are compared with the slopes of the polynomials, and where they differ by more than the
tolerance the step is taken again, half as long.  Runs lie side by side, one or `LANES`; each has
time and steps of its own, and waits at the end of a segment of time.
"""

from math import log2
from typing import Any

from llvmlite import ir

from ..record.graph import deep
from .llvm_text import LLVMPrinter
from .plan import Program
from .series import Coefficients
from .vectors import (
    BIT,
    DOUBLE,
    WORD,
    constant,
    elements,
    gathered,
    splat,
    vector,
    word,
)

SAFETY = 0.9
GROWTH = 8.0
INSIDE = 0.2877, 0.5381, 0.8179, 0.9423  # of a step: where it is checked
NEGLIGIBLE = 40.0  # size of an argument where exp and tanh change by less than 1e-17
LARGEST = 2.0**930  # of scaled coefficients in tolerances
SHRINK = 2.0**-40  # of the scale where they are larger
LEAST_STEP = 4e-15  # relative to time
RUNNING, ARRIVED, FAILED = range(3)  # status of a lane
# of the numbers: tolerances and the longest step, then time and scale of each lane
RTOL, ATOL, LONGEST, TIME, SCALE = 0, 1, 2, 8, 16
# of the integers: counts of samples, segments and indices, and of steps of a call; the segment
# reached; then next sample, status and steps of each lane
SAMPLES, SEGMENTS, COUNT, MOST, SEGMENT, NEXT, STATUS, STEPS = 0, 1, 2, 3, 4, 8, 16, 24
ARRAYS = (*"XPTW", "times", "edges", "values", "out", "numbers", "indices", "integers")
WORDS = ("indices", "integers")
BLOCKS = (
    "segment",
    "step",
    "body",
    "inside",
    "accept",
    "samples",
    "sample",
    "after",
    "end",
    "done",
)


def print_series(program: Program, lanes: int, order: int) -> ir.Module:
    """Return a module of LLVM with the function `series`, for 1 or `LANES` runs."""
    module = ir.Module()
    with deep():
        LLVMPrinter(module, "prepare", lanes, program, set()).print_function()
        SeriesPrinter(module, program, lanes, order).print_run()
    return module


class SeriesPrinter(Coefficients):
    """Printer of the function `series`."""

    def _declare(self, module: ir.Module, name: str, constants: Any) -> None:
        super()._declare(module, "series", constants)

    def signature(self) -> dict[str, ir.Type]:
        """Return names and types of the arguments."""
        types = {name: WORD if name in WORDS else DOUBLE for name in ARRAYS}
        return {name: kind.as_pointer() for name, kind in types.items()}

    # --- the run ------------------------------------------------------------------------------

    def print_run(self) -> None:
        """Print the loop over segments of time, with the loop over steps in it."""
        builder, where = self.builder, self.builder.select
        n, width = len(self.rates), self.lanes
        blocks = {name: builder.append_basic_block(name) for name in BLOCKS}
        running, arrived, failed = (constant(k, width, WORD) for k in range(3))
        false, true = (constant(k, width, BIT) for k in range(2))
        zero = self.as_value(0.0)

        # 1. what is kept between calls
        self.rtol, self.atol, longest = (
            self.broadcast_to_lanes(self.entry("numbers", k))
            for k in (RTOL, ATOL, LONGEST)
        )
        kept: dict[Any, Any] = {
            "time": self.of_lanes("numbers", TIME, DOUBLE),
            "scale": self.of_lanes("numbers", SCALE, DOUBLE),
            "next": self.of_lanes("integers", NEXT, WORD),
            "status": self.of_lanes("integers", STATUS, WORD),
            "steps": self.of_lanes("integers", STEPS, WORD),
            **{k: self.of_lanes("X", k * width, DOUBLE) for k in range(n)},
        }
        begun = {name: builder.load(address, align=8) for name, address in kept.items()}
        count, segments, m, most, first = (
            self.entry("integers", k) for k in (SAMPLES, SEGMENTS, COUNT, MOST, SEGMENT)
        )
        before = builder.block
        builder.branch(blocks["segment"])

        # 2. a segment: its numbers in P, and what is prepared
        builder.position_at_end(blocks["segment"])
        segment = self.phi(first, before)
        at_segment = {name: self.phi(value, before) for name, value in begun.items()}
        at_segment["tries"] = self.phi(word(0), before)
        self.set_parameters(segment, m)
        time_of_lanes = builder.gep(self.arrays["numbers"], [word(TIME)])
        X, P, T, W = (self.arrays[name] for name in "XPTW")
        prepare = builder.module.globals["prepare"]
        builder.call(prepare, [time_of_lanes, X, P, T, W, W])
        end = self.broadcast_to_lanes(self.entry("edges", segment))
        has_failed = builder.icmp_signed("==", at_segment["status"], failed)
        start = {**at_segment, "status": where(has_failed, failed, running)}
        before = builder.block
        builder.branch(blocks["step"])

        # 3. the beginning of a step: the rates check the end of the step before
        builder.position_at_end(blocks["step"])
        now = {name: self.phi(value, before) for name, value in start.items()}
        last = {
            name: self.phi(start[name], before) for name in ("time", "next", *range(n))
        }
        cap = self.phi(longest, before)
        size = self.phi(zero, before)  # of the step before
        slopes = [self.phi(zero, before) for _ in range(n)]  # at its end
        self.time, self.scale = now["time"], now["scale"]
        self.states = [now[k] for k in range(n)]
        self.begins[0] = builder.block
        self.outside = {}
        weights = self.weights()
        is_running = builder.icmp_signed("==", now["status"], running)
        is_right = self.are_slopes(slopes, weights, size)
        again = where(is_running, builder.not_(is_right), false)
        right = where(is_running, is_right, false)
        at_end = builder.fcmp_unordered(">=", now["time"], end)
        status = where(where(right, at_end, false), arrived, now["status"])
        half = self.call("mul", size, 0.5)
        no_room = self.no_room(half, last["time"])
        status = where(where(again, no_room, false), failed, status)
        goes_on = builder.icmp_signed("==", status, running)
        going = where(goes_on, right, false)
        in_time = builder.icmp_signed("<", now["tries"], most)
        is_going = self.any_of(goes_on)
        goes_on = builder.and_(is_going, in_time)
        builder.cbranch(goes_on, blocks["body"], blocks["end"])

        # 4. coefficients and the step
        builder.position_at_end(blocks["body"])
        series = self.series_of_states()
        share, is_sound = self.share_of_scale(series, weights)
        sound = where(going, is_sound, false)
        wished = self.call("minnum", builder.fmul(share, self.scale), cap)
        inverse = self.call("div", 1.0, self.scale)
        excess = self.excess(builder.fmul(wished, inverse))
        wished = self.call("div", wished, excess)
        left = builder.fsub(end, now["time"])
        is_last = builder.fcmp_unordered(">=", wished, left)
        new_time = where(is_last, end, builder.fadd(now["time"], wished))
        # where time is large, the step is that of the rounded times
        step = builder.fsub(new_time, now["time"])
        moves = builder.fcmp_ordered(">", step, zero)
        at = builder.fmul(step, inverse)
        new = [self.polynomial(coefficients, at) for coefficients in series]
        new_slopes = self.slopes(at)
        moved = where(sound, moves, false)
        before = builder.block
        unsure = self.unsure(share)
        any_unsure = self.any_of(where(moved, unsure, false))
        builder.cbranch(any_unsure, blocks["inside"], blocks["accept"])

        # 5. a check within a step whose coefficients do not show enough
        builder.position_at_end(blocks["inside"])
        right = self.is_right(series, weights, step, at)
        right = where(unsure, right, true)
        inside = builder.block
        builder.branch(blocks["accept"])
        builder.position_at_end(blocks["accept"])
        fine = self.phi(true, before)
        fine.add_incoming(right, inside)
        steps = where(moved, fine, false)
        builder.branch(blocks["samples"])

        # 6. samples within the step
        builder.position_at_end(blocks["samples"])
        number = self.phi(now["next"], blocks["accept"])
        limit = self.broadcast_to_lanes(count)
        is_due = where(steps, builder.icmp_signed("<", number, limit), false)
        index = where(is_due, number, running)
        sample_time = gathered(
            builder, [self.entry("times", i) for i in elements(builder, index)]
        )
        in_step = builder.fcmp_ordered("<=", sample_time, new_time)
        is_due = where(is_due, in_step, false)
        builder.cbranch(self.any_of(is_due), blocks["sample"], blocks["after"])
        builder.position_at_end(blocks["sample"])
        since = builder.fmul(builder.fsub(sample_time, now["time"]), inverse)
        values = [self.polynomial(coefficients, since) for coefficients in series]
        self.write_samples(values, index, is_due, count)
        following = builder.add(number, builder.zext(is_due, number.type))
        number.add_incoming(following, builder.block)
        builder.branch(blocks["samples"])

        # 7. the next step, or a step again: half as long, or with a smaller scale
        builder.position_at_end(blocks["after"])
        half_now = self.call("mul", step, 0.5)
        smaller = self.call("mul", self.scale, SHRINK)
        unsound = where(going, builder.not_(is_sound), false)
        no_room = self.no_room(where(unsound, smaller, half_now), now["time"])
        fails = where(going, where(steps, false, no_room), false)
        reached: dict[Any, Any] = {"time": new_time, "next": number}
        reached |= dict(enumerate(new))
        following = {
            "scale": where(steps, wished, where(unsound, smaller, self.scale)),
            "status": where(fails, failed, status),
            "steps": builder.add(now["steps"], builder.zext(steps, number.type)),
            "tries": builder.add(now["tries"], word(1)),
        }
        for name, node in last.items():
            back = where(again, node, now[name])
            following[name] = where(steps, reached[name], back)
            node.add_incoming(where(going, now[name], node), builder.block)
        for name, node in now.items():
            node.add_incoming(following[name], builder.block)
        shorter = where(again, half, where(moved, half_now, cap))
        cap.add_incoming(where(steps, longest, shorter), builder.block)
        size.add_incoming(where(steps, step, zero), builder.block)
        for node, slope in zip(slopes, new_slopes, strict=True):
            node.add_incoming(where(steps, slope, zero), builder.block)
        builder.branch(blocks["step"])

        # 8. the end of a segment
        builder.position_at_end(blocks["end"])
        back = {name: where(again, node, now[name]) for name, node in last.items()}
        ended = {**now, **back, "status": status}
        for name, address in kept.items():
            builder.store(ended[name], address, align=8)
        number = builder.add(segment, word(1))
        not_failed = builder.icmp_signed("!=", status, failed)
        on = builder.and_(builder.not_(is_going), self.any_of(not_failed))
        on = builder.and_(on, builder.icmp_signed("<", number, segments))
        segment.add_incoming(number, builder.block)
        for name, node in at_segment.items():
            node.add_incoming(ended[name], builder.block)
        builder.cbranch(on, blocks["segment"], blocks["done"])
        builder.position_at_end(blocks["done"])
        reached = builder.gep(self.arrays["integers"], [word(SEGMENT)])
        builder.store(segment, reached)
        builder.ret_void()

    # --- numbers of lanes ---------------------------------------------------------------------

    def of_lanes(self, name: str, offset: int, kind: ir.Type) -> Any:
        """Return the address of a number of each lane."""
        address = self.builder.gep(self.arrays[name], [word(offset)])
        return self.builder.bitcast(address, vector(self.lanes, kind).as_pointer())

    def entry(self, name: str, index: Any) -> Any:
        """Return an entry of an array that lanes share."""
        index = word(index) if type(index) is int else index
        return self.builder.load(self.builder.gep(self.arrays[name], [index]))

    def broadcast_to_lanes(self, value: Any) -> Any:
        """Return one number in every lane."""
        return splat(self.builder, value, self.lanes)

    def any_of(self, condition: Any) -> Any:
        """Return whether a condition holds in a lane."""
        if self.lanes == 1:
            return condition
        kind = ir.IntType(self.lanes)
        bits = self.builder.bitcast(condition, kind)
        return self.builder.icmp_unsigned("!=", bits, ir.Constant(kind, 0))

    def set_parameters(self, segment: Any, count: Any) -> None:
        """Write the numbers of a segment into P."""
        builder = self.builder
        before = builder.block
        look, write, after = (builder.append_basic_block() for _ in range(3))
        builder.branch(look)
        builder.position_at_end(look)
        k = self.phi(word(0), before)
        builder.cbranch(builder.icmp_signed("<", k, count), write, after)
        builder.position_at_end(write)
        position = builder.add(builder.mul(segment, count), k)
        value = self.entry("values", position)
        index = builder.mul(self.entry("indices", k), word(self.lanes))
        address = builder.gep(self.arrays["P"], [index])
        address = builder.bitcast(address, vector(self.lanes).as_pointer())
        builder.store(self.broadcast_to_lanes(value), address, align=8)
        k.add_incoming(builder.add(k, word(1)), builder.block)
        builder.branch(look)
        builder.position_at_end(after)

    # --- a step -------------------------------------------------------------------------------

    def series_of_states(self) -> list[list[Any]]:
        """Return the coefficients of each state."""
        orders = range(1, self.order + 1)
        return [
            [state, *(self.as_value(self.state_coefficient(k, j)) for j in orders)]
            for k, state in enumerate(self.states)
        ]

    def weights(self) -> list[Any]:
        """Return 1 / (atol + rtol |x|) of each state."""
        sizes = (self.call("fabs", state) for state in self.states)
        tolerances = (
            self.call("fmuladd", self.rtol, size, self.atol) for size in sizes
        )
        return [self.call("div", 1.0, tolerance) for tolerance in tolerances]

    def weighed(self, values: list[Any], weights: list[Any]) -> Any:
        """Return the sum of sizes in tolerances."""
        sizes = [self.call("fabs", value) for value in values]
        return self.as_value(self.sum_of_products(zip(sizes, weights, strict=True)))

    def share_of_scale(self, series: list[list[Any]], weights: list[Any]) -> Any:
        """Return the step, in units of the scale, at which coefficients are as large as tolerances.

        Logarithms are taken of exponent and leading bits: a step may be some percent shorter.  The
        second value is whether the coefficients are sound: neither too large nor NaN.
        """
        builder = self.builder
        bits = vector(self.lanes, WORD)
        lowered = 1023.0 - 0.045
        most = -1e300
        is_sound = constant(1, self.lanes, BIT)
        for order in (self.order - 1, self.order):
            size = self.weighed([row[order] for row in series], weights)
            fits = builder.fcmp_ordered("<", size, self.as_value(LARGEST))
            is_sound = builder.and_(is_sound, fits)
            size = self.call(
                "maxnum", self.builder.select(fits, size, self.as_value(1.0)), 1e-300
            )
            number = builder.sitofp(builder.bitcast(size, bits), vector(self.lanes))
            logarithm = self.operate(
                "sub", self.operate("mul", 2.0**-52, number), lowered
            )
            most = self.call(
                "maxnum", most, self.operate("mul", 1.0 / order, logarithm)
            )
        exponent = self.operate("sub", log2(SAFETY), most)
        exponent = self.call("minnum", exponent, log2(GROWTH))
        shifted = self.operate("mul", 2.0**52, self.operate("add", exponent, lowered))
        share = builder.bitcast(builder.fptosi(shifted, bits), vector(self.lanes))
        return share, is_sound

    def excess(self, at: Any) -> Any:
        """Return how many times more than allowed an argument may change in a step, at least 1.

        The sum of sizes of coefficients is convex: so many times shorter, the step is allowed.
        """
        largest = self.as_value(1.0)
        for (argument, is_relative), most in self.limits.items():
            coefficients = [self.at(argument, k) for k in range(1, self.order)]
            sizes = [self.call("fabs", coefficient) for coefficient in coefficients]
            change = self.polynomial([0.0, *sizes], at)
            size = self.call("fabs", self.at(argument, 0))
            if is_relative:
                allowed = self.operate("mul", most, size)
            else:
                allowed = self.call(
                    "maxnum", self.operate("sub", size, NEGLIGIBLE), most
                )
            part = self.call("div", 1.0, allowed)
            largest = self.call("maxnum", largest, self.operate("mul", change, part))
        return largest

    def no_room(self, step: Any, time: Any) -> Any:
        """Return whether a step is lost in the rounding of time."""
        size = self.call("fabs", time)
        least = self.call("mul", size, LEAST_STEP)
        return self.builder.fcmp_unordered("<=", step, least)

    def slopes(self, at: Any) -> list[Any]:
        """Return the slopes of the polynomials of the states."""
        return [
            self.polynomial([self.at(rate, k) for k in range(self.order)], at)
            for rate in self.rates
        ]

    def are_slopes(self, slopes: list[Any], weights: list[Any], step: Any) -> Any:
        """Return whether rates at the current state are slopes, within the tolerance of a step."""
        errors = [
            self.operate("sub", self.at(rate, 0), slope)
            for rate, slope in zip(self.rates, slopes, strict=True)
        ]
        error = self.builder.fmul(self.weighed(errors, weights), step)
        most = self.as_value(self.order + 1.0)
        return self.builder.fcmp_ordered("<=", error, most)

    def unsure(self, share: Any) -> Any:
        """Return whether coefficients do not show how long the step may be.

        The last two are zero, or the degree of a function is so high that the first may be.
        """
        if 2 * self.highest > self.order:
            return constant(1, self.lanes, BIT)
        most = self.as_value(0.9 * GROWTH)
        return self.builder.fcmp_ordered(">", share, most)

    def is_right(
        self, series: list[list[Any]], weights: list[Any], step: Any, at: Any
    ) -> Any:
        """Return whether rates within a step are the slopes of the polynomials."""
        kept = self.time, self.states, self.outside, self.begins[0]
        right = constant(1, self.lanes, BIT)
        self.begins[0] = self.builder.block
        for point in INSIDE:
            there = self.operate("mul", point, at)
            slopes = self.slopes(there)
            time = self.call("fmuladd", step, point, kept[0])
            states = [self.polynomial(row, there) for row in series]
            self.time, self.states, self.outside = time, states, {}
            right = self.builder.and_(right, self.are_slopes(slopes, weights, step))
            self.time, self.states, self.outside = kept[:3]
        self.begins[0] = kept[3]
        return right

    def polynomial(self, coefficients: list[Any], at: Any) -> Any:
        """Return the value of a polynomial, the lowest coefficient first.

        Even and odd powers are added side by side, which takes half the time.
        """
        square = self.operate("mul", at, at)
        factors = []
        for first in (0, 1):
            *others, value = map(self.as_value, coefficients[first::2])
            for coefficient in reversed(others):
                value = self.call("fmuladd", value, square, coefficient)
            factors.append(value)
        return self.call("fmuladd", factors[1], at, factors[0])

    def write_samples(
        self, values: list[Any], index: Any, is_due: Any, count: Any
    ) -> None:
        """Write states into the row of a sample; lanes without a sample write behind all rows."""
        builder = self.builder
        n = len(values)
        behind = builder.mul(count, word(self.lanes))
        rows = zip(elements(builder, index), elements(builder, is_due), strict=True)
        by_lane = [elements(builder, value) for value in values]
        for lane, (number, due) in enumerate(rows):
            row = builder.add(builder.mul(count, word(lane)), number)
            row = builder.select(due, row, behind)
            first = builder.mul(row, word(n))
            for k in range(n):
                index = builder.add(first, word(k))
                address = builder.gep(self.arrays["out"], [index])
                builder.store(by_lane[k][lane], address)
