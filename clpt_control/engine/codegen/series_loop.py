"""A run by Taylor series as one function of machine code.

    void series(X, P, T, W, times, edges, values, out, numbers, indices, integers)

Coefficients (`series`) are scaled by the last step, so that they neither overflow nor underflow.
The last two give the step, at most `GROWTH` times the last one.  Each step is checked: the rate at
its end, the next first coefficient, against the slope of its polynomial.  Where they differ by more
than the tolerance the step is taken again, half as long.  Runs lie side by side, one or `LANES`;
each has its own time and steps, and waits at the end of a segment of time.
"""

from math import log2
from typing import Any

from llvmlite import ir

from ..record.graph import deep
from .llvm_text import LLVMPrinter
from .plan import Program
from .series import Coefficients
from .vectors import BIT, DOUBLE, WORD, constant, elements, gathered, splat, vector

SAFETY = 0.9
GROWTH = 8.0
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
        builder = self.builder
        n, width = len(self.rates), self.lanes
        names = ("segment", "step", "body", "samples", "sample", "after", "end", "done")
        blocks = {name: builder.append_basic_block(name) for name in names}
        zero, words = self.number(0.0, False), constant(0, width, WORD)

        def lanes(name: str, offset: int, kind: ir.Type) -> Any:
            """Return the address of a number of each lane."""
            address = builder.gep(self.arrays[name], [ir.Constant(WORD, offset)])
            return builder.bitcast(address, vector(width, kind).as_pointer())

        def entry(name: str, index: Any) -> Any:
            """Return an entry of an array of which lanes share each."""
            index = ir.Constant(WORD, index) if type(index) is int else index
            return builder.load(builder.gep(self.arrays[name], [index]))

        def shared(index: int) -> Any:
            return self.broadcast_to_lanes(entry("numbers", index))

        def select(condition: Any, a: Any, b: Any) -> Any:
            return builder.select(condition, self.as_value(a), self.as_value(b))

        def any_of(condition: Any) -> Any:
            if width == 1:
                return condition
            bits = builder.bitcast(condition, ir.IntType(width))
            return builder.icmp_unsigned("!=", bits, ir.Constant(ir.IntType(width), 0))

        def phi(kind: ir.Type, value: Any, block: Any) -> Any:
            node = builder.phi(kind)
            node.add_incoming(value, block)
            return node

        # 1. what is kept between calls
        double, word = vector(width), vector(width, WORD)
        rtol, atol, longest = map(shared, (RTOL, ATOL, LONGEST))
        kept: dict[Any, Any] = {
            "time": lanes("numbers", TIME, DOUBLE),
            "scale": lanes("numbers", SCALE, DOUBLE),
            "next": lanes("integers", NEXT, WORD),
            "status": lanes("integers", STATUS, WORD),
            "steps": lanes("integers", STEPS, WORD),
            **{k: lanes("X", k * width, DOUBLE) for k in range(n)},
        }
        begun = {name: builder.load(address, align=8) for name, address in kept.items()}
        count, segments, m, most, first = (
            entry("integers", k) for k in (SAMPLES, SEGMENTS, COUNT, MOST, SEGMENT)
        )
        before = builder.block
        builder.branch(blocks["segment"])

        # 2. a segment: its numbers in P, and what is prepared
        builder.position_at_end(blocks["segment"])
        segment = phi(WORD, first, before)
        at_segment = {
            name: phi(value.type, value, before) for name, value in begun.items()
        }
        at_segment["tries"] = phi(WORD, ir.Constant(WORD, 0), before)
        self.set_parameters(segment, m)
        prepare = builder.module.globals["prepare"]
        time_of_lanes = builder.gep(self.arrays["numbers"], [ir.Constant(WORD, TIME)])
        P, W = self.arrays["P"], self.arrays["W"]
        builder.call(
            prepare, [time_of_lanes, self.arrays["X"], P, self.arrays["T"], W, W]
        )
        end = self.broadcast_to_lanes(entry("edges", segment))
        ahead = builder.icmp_signed(
            "!=", at_segment["status"], constant(FAILED, width, WORD)
        )
        status = select(ahead, words, at_segment["status"])
        before = builder.block
        builder.branch(blocks["step"])

        # 3. the beginning of a step: check of the step before
        builder.position_at_end(blocks["step"])
        start = {**at_segment, "status": status}
        now = {name: phi(value.type, value, before) for name, value in start.items()}
        last = {
            name: phi(start[name].type, start[name], before)
            for name in ("time", "next", *range(n))
        }
        size = phi(double, zero, before)  # of the step before
        cap = phi(double, longest, before)
        slopes = [phi(double, zero, before) for _ in range(n)]
        self.time, self.scale = now["time"], now["scale"]
        self.states = [now[k] for k in range(n)]
        self.begins[0] = builder.block
        self.scopes = [{}]
        rates = [self.at(rate, 0) for rate in self.rates]
        weights = []
        defect: Any = 0.0
        for k in range(n):
            tolerance = self.call("fmuladd", rtol, self.call("fabs", now[k]), atol)
            weights.append(self.call("div", 1.0, tolerance))
            error = self.call("fabs", self.operate("fsub", rates[k], slopes[k]))
            defect = self.sum_of_products([(error, weights[k])], defect)
        defect = builder.fmul(self.as_value(defect), size)
        is_fine = builder.fcmp_ordered(
            "<=", defect, self.number(self.order + 1.0, False)
        )
        is_running = builder.icmp_signed("==", now["status"], words)
        at_end = builder.fcmp_unordered(">=", now["time"], end)
        false = constant(0, width, BIT)
        fine = select(is_running, is_fine, false)
        retries = select(is_running, builder.not_(is_fine), false)
        arrives = select(fine, at_end, false)
        least = builder.fmul(
            self.call("fabs", last["time"]), self.number(LEAST_STEP, False)
        )
        half = builder.fmul(size, self.number(0.5, False))
        no_room = select(retries, builder.fcmp_ordered("<=", half, least), false)
        status = select(arrives, constant(ARRIVED, width, WORD), now["status"])
        status = select(no_room, constant(FAILED, width, WORD), status)
        goes = builder.icmp_signed("==", status, words)
        going = select(goes, fine, false)
        in_time = builder.icmp_signed("<", now["tries"], most)
        builder.cbranch(
            builder.and_(any_of(goes), in_time), blocks["body"], blocks["end"]
        )

        # 4. coefficients, step, new state and the slope there
        builder.position_at_end(blocks["body"])
        series = [
            [
                self.as_value(self.state_coefficient(k, j))
                for j in range(1, self.order + 1)
            ]
            for k in range(n)
        ]
        sizes = []
        sound = going
        for j in (self.order - 1, self.order):
            total: Any = 0.0
            for k in range(n):
                total = self.sum_of_products(
                    [(self.call("fabs", series[k][j - 1]), weights[k])], total
                )
            is_sound = builder.fcmp_ordered(
                "<", self.as_value(total), self.number(LARGEST, False)
            )
            sound = select(sound, is_sound, false)
            sizes.append((j, select(is_sound, total, 1.0)))
        share = self.share_of_scale(sizes)
        wished = self.call("minnum", builder.fmul(share, self.scale), cap)
        left = builder.fsub(end, now["time"])
        is_last = builder.fcmp_unordered(">=", wished, left)
        step = select(is_last, left, wished)
        new_time = select(is_last, end, builder.fadd(now["time"], step))
        moves = builder.fcmp_ordered(">", new_time, now["time"])
        steps = select(sound, moves, false)
        inverse = self.call("div", 1.0, self.scale)
        at = builder.fmul(step, inverse)
        new = [self.polynomial([now[k], *series[k]], at) for k in range(n)]
        slope = [
            builder.fmul(
                self.polynomial(
                    [
                        self.operate("fmul", float(j), c)
                        for j, c in enumerate(series[k], 1)
                    ],
                    at,
                ),
                inverse,
            )
            for k in range(n)
        ]
        before = builder.block
        builder.branch(blocks["samples"])

        # 5. samples within the step
        builder.position_at_end(blocks["samples"])
        number = phi(word, now["next"], before)
        limit = self.broadcast_to_lanes(count)
        is_due = select(steps, builder.icmp_signed("<", number, limit), false)
        index = select(is_due, number, words)
        sample_time = gathered(
            builder, [entry("times", i) for i in elements(builder, index)]
        )
        is_due = select(
            is_due, builder.fcmp_ordered("<=", sample_time, new_time), false
        )
        builder.cbranch(any_of(is_due), blocks["sample"], blocks["after"])
        builder.position_at_end(blocks["sample"])
        since = builder.fmul(builder.fsub(sample_time, now["time"]), inverse)
        values = [self.polynomial([now[k], *series[k]], since) for k in range(n)]
        self.write_samples(values, index, is_due, count)
        following = builder.add(number, builder.zext(is_due, word))
        number.add_incoming(following, builder.block)
        builder.branch(blocks["samples"])

        # 6. the next step, or the last one again
        builder.position_at_end(blocks["after"])
        smaller = builder.fmul(self.scale, self.number(SHRINK, False))
        unsound = select(going, builder.not_(sound), false)
        is_tiny = builder.fcmp_unordered("<=", smaller, least)
        fails = select(unsound, is_tiny, select(sound, builder.not_(moves), false))
        following = {
            "time": select(steps, new_time, select(retries, last["time"], now["time"])),
            "scale": select(steps, wished, select(unsound, smaller, self.scale)),
            "next": select(steps, number, select(retries, last["next"], now["next"])),
            "status": select(fails, constant(FAILED, width, WORD), status),
            "steps": builder.add(now["steps"], builder.zext(steps, word)),
            "tries": builder.add(now["tries"], ir.Constant(WORD, 1)),
            **{
                k: select(steps, new[k], select(retries, last[k], now[k]))
                for k in range(n)
            },
        }
        for name, node in now.items():
            node.add_incoming(following[name], builder.block)
        for name, node in last.items():
            node.add_incoming(select(going, now[name], last[name]), builder.block)
        size.add_incoming(select(steps, step, 0.0), builder.block)
        cap.add_incoming(
            select(retries, half, select(unsound, cap, longest)), builder.block
        )
        for node, value in zip(slopes, slope, strict=True):
            node.add_incoming(select(steps, value, 0.0), builder.block)
        builder.branch(blocks["step"])

        # 7. the end of a segment
        builder.position_at_end(blocks["end"])
        ended = {
            name: select(retries, last[name], now[name]) if name in last else now[name]
            for name in now
        }
        ended["status"] = status
        for name, address in kept.items():
            builder.store(ended[name], address, align=8)
        number = builder.add(segment, ir.Constant(WORD, 1))
        has_failed = builder.icmp_signed("==", status, constant(FAILED, width, WORD))
        on = builder.and_(in_time, any_of(builder.not_(has_failed)))
        on = builder.and_(on, builder.icmp_signed("<", number, segments))
        segment.add_incoming(number, builder.block)
        for name, node in at_segment.items():
            node.add_incoming(ended[name], builder.block)
        builder.cbranch(on, blocks["segment"], blocks["done"])
        builder.position_at_end(blocks["done"])
        builder.store(
            segment, builder.gep(self.arrays["integers"], [ir.Constant(WORD, SEGMENT)])
        )
        builder.ret_void()

    # --- parts of the run ---------------------------------------------------------------------

    def broadcast_to_lanes(self, value: Any) -> Any:
        """Return one number in every lane."""
        return splat(self.builder, value, self.lanes)

    def set_parameters(self, segment: Any, count: Any) -> None:
        """Write the numbers of a segment into P."""
        builder = self.builder
        before = builder.block
        look, write, after = (builder.append_basic_block() for _ in range(3))
        builder.branch(look)
        builder.position_at_end(look)
        k = builder.phi(WORD)
        k.add_incoming(ir.Constant(WORD, 0), before)
        builder.cbranch(builder.icmp_signed("<", k, count), write, after)
        builder.position_at_end(write)
        index = builder.load(builder.gep(self.arrays["indices"], [k]))
        position = builder.add(builder.mul(segment, count), k)
        value = builder.load(builder.gep(self.arrays["values"], [position]))
        index = builder.mul(index, ir.Constant(WORD, self.lanes))
        address = builder.gep(self.arrays["P"], [index])
        address = builder.bitcast(address, vector(self.lanes).as_pointer())
        builder.store(self.broadcast_to_lanes(value), address, align=8)
        k.add_incoming(builder.add(k, ir.Constant(WORD, 1)), builder.block)
        builder.branch(look)
        builder.position_at_end(after)

    def share_of_scale(self, sizes: list[tuple[int, Any]]) -> Any:
        """Return the step, in units of the scale, at which coefficients are as large as tolerances.

        Logarithms are taken of exponent and leading bits: a step may be some percent shorter.
        """
        builder = self.builder
        bits = vector(self.lanes, WORD)
        lowered = 1023.0 - 0.045
        largest: Any = None
        for order, size in sizes:
            size = self.call("maxnum", size, 1e-300)
            number = builder.sitofp(builder.bitcast(size, bits), vector(self.lanes))
            logarithm = self.operate(
                "fsub", self.operate("fmul", 2.0**-52, number), lowered
            )
            logarithm = self.operate("fmul", 1.0 / order, logarithm)
            largest = (
                logarithm
                if largest is None
                else self.call("maxnum", largest, logarithm)
            )
        exponent = self.operate("fsub", log2(SAFETY), largest)
        exponent = self.call("minnum", exponent, log2(GROWTH))
        shifted = self.operate("fmul", 2.0**52, self.operate("fadd", exponent, lowered))
        return builder.bitcast(builder.fptosi(shifted, bits), vector(self.lanes))

    def polynomial(self, coefficients: list[Any], at: Any) -> Any:
        """Return the value of a polynomial, the lowest coefficient first."""
        *others, value = map(self.as_value, coefficients)
        for coefficient in reversed(others):
            value = self.call("fmuladd", value, at, coefficient)
        return value

    def write_samples(
        self, values: list[Any], index: Any, is_due: Any, count: Any
    ) -> None:
        """Write states into the row of a sample; lanes without a sample write behind all rows."""
        builder = self.builder
        n = len(values)
        behind = builder.mul(count, ir.Constant(WORD, self.lanes))
        rows = zip(elements(builder, index), elements(builder, is_due), strict=True)
        by_lane = [elements(builder, value) for value in values]
        for lane, (number, due) in enumerate(rows):
            row = builder.add(builder.mul(count, ir.Constant(WORD, lane)), number)
            row = builder.select(due, row, behind)
            first = builder.mul(row, ir.Constant(WORD, n))
            for k in range(n):
                place = builder.add(first, ir.Constant(WORD, k))
                builder.store(
                    by_lane[k][lane], builder.gep(self.arrays["out"], [place])
                )
