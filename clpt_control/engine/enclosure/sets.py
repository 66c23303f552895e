"""Guaranteed runs: Taylor series on sets, which are zonotopes.

    z = (x, parameters)  in  m + G r,      |r_i| at most 1 times given radii

A step of length h has three evaluations of the record on balls:

1. coefficients F_i and their Jacobian J_i on the box of the set, i = 0 ... p + 1;
2. a box B that holds all runs during the step: where
   sum [0, h]^i F_i + [0, h]^(p + 1) F_(p + 1)(B) lies inside B, no run leaves B (Corliss and Rihm
   1996); the remainder is h^(p + 1) F_(p + 1)(B);
3. coefficients at the middle, for the mean value form.

J maps G; sets too wide for first derivatives take second ones (`curvature`).
The errors of a step are new columns, and when these are many the shortest become a box
(Kuehn 1998).  Where there is no series, at a switch, a kink or the root of 0, lines stand in the
place of these, and what they leave is a noise (`sides`).  Discrete time and jumps at known times,
such as those of sampled blocks, map the set by the mean value form.
"""

from contextlib import suppress
from functools import partial
from typing import Any

import numpy as np

from . import balls
from .balls import (
    Ball,
    Switching,
    Undecided,
    around,
    around_both,
    between,
    exact,
    matrix,
    within,
)
from .curvature import bend, second_derivatives, with_tangents
from .noise import REACH, InputNoise, moved_apart, sources, walls
from .set_program import DECIDED, SetProgram
from .set_series import SetSeries
from .sides import Line
from .step_length import moved, powers, step_length

ORDER = 26  # at most 60, for the radii of `ball_series`
TERMS = 100  # of a set, for each state
LEAST = 2.0**-30  # of a run: the shortest step
SHORTEST = 2.0**-38  # of a run: the shortest step beside a switch
LONGEST = 2.0**-8  # of a run: the longest of these
LARGER = 1.1  # the longest step after another one
QUICKER = 1.5  # of short steps with lines in the place of decisions
MOST_STEPS = 20_000
SHORTER = 2.0**-5  # least step by series after one without
FLAT = 2.0**-20  # error of a step by first derivatives, beside the radius of a box
LOOSE = 2.0**-7  # error from which a step has walls
NOISY = 2.0**-3  # wished growth of noise in a step, and share of a box's radius
SMALL = 2.0**-8  # share of noise that may grow
NOISY_STEPS = 2.0**-8  # of a run: steps with noise that may grow more
EMPTY = np.array([np.inf, -np.inf])[:, None, None, None]  # bounds of no number


class Enclosure:
    """Boxes of all runs of a program from a `whole` box of states and P.

    Inputs with a `noise` may change at any time by as much from their middles.  `bounds` has lower
    and upper numbers of states and signals, at samples and over the intervals before them.
    """

    def __init__(
        self,
        whole: Ball,
        programs: list[SetProgram],
        noise: InputNoise,
        times: np.ndarray,
        jumps: list[int] | None,
        most_steps: int = MOST_STEPS,
    ):
        self.most_steps = most_steps
        rates, signals, leaps, second = programs
        # 1. the set, with columns for what has a radius
        self.whole, self.n = whole, len(rates.x)
        n, P = self.n, Ball(whole.c[self.n :].copy(), whole.r[self.n :])
        varied = np.flatnonzero(P.r).tolist()
        self.m, radii = (np.append(a[:n], a[n:][varied]) for a in whole)
        given = np.flatnonzero(radii)
        self.given, self.N = len(given), len(radii)
        self.G, self.r = np.eye(self.N)[:, given], radii[given]
        # by how much each column bends; at first its share
        self.bent = 1e-9 * self.r / (np.abs(self.m[given]) + self.r)
        # columns of products of two, if there are second derivatives
        is_second = self.given > 0 and len(second.x) == n * (1 + self.N)
        if is_second:
            i, j = np.triu_indices(self.given)
            self.r = np.append(self.r, self.r[i] * self.r[j] * balls.GROWTH)
            self.G = np.hstack([self.G, np.zeros((self.N, len(i)))])
        self.kept = len(self.r)
        # 2. series
        along = [("X", k) for k in range(n)]
        along += [("P", k) for k in varied]
        self.wide = SetSeries(rates, ORDER + 1, along)
        self.narrow = SetSeries(rates, ORDER + 1)
        self.second = SetSeries(second, ORDER + 1, along) if is_second else None
        self.rates = SetSeries(rates, 0, along, noise=True)
        self.of_rates = self.wide, self.narrow, self.rates
        self.has_lines = any(s.rest >= 0 or s.kind in DECIDED for s in self.rates.steps)
        self.leaps = SetSeries(leaps, 0, along, noise=True)
        self.jumps = jumps  # places of their requests in P; None in discrete time
        self.signals = SetSeries(signals, 0, along, noise=True)
        self.signals.apart = True
        self.P, self.noise, self.is_noisy = P, noise, bool(rates.sources)
        self.walls: Ball | None = None  # a box beside the set, of runs with noise
        self.of_inputs = {
            program: SetSeries(program.of_inputs(), 0)
            for program in programs
            if program.sources
        }
        if signals in self.of_inputs:
            self.of_inputs[signals].apart = True
        # 3. results
        self.times, self.t, self.why = times, float(times[0]), ""
        self.span = float(times[-1] - times[0])
        self.place = times.searchsorted
        self.h, self.short = np.inf, SHORTEST * self.span
        self.steps = self.beside = 0  # all steps, and those beside a switch or a root
        shape = 2, 2, len(times), n + len(signals.results)
        self.bounds = np.full(shape, EMPTY)
        self.lost: dict[int, str] = {}  # signals without bounds, and why

    # --- runs ---------------------------------------------------------------------------------

    @np.errstate(all="ignore")
    def run(self, schedule: Any) -> None:
        """Fill the boxes up to the last sample, or to where they end."""
        most = self.most_steps
        try:
            for edge, values in zip(schedule.edges, schedule.values, strict=True):
                self.P.c[schedule.indices] = values
                end = min(float(edge), float(self.times[-1]))
                self._disturb(end)
                self._begin()
                while self.t < end:
                    self._advance(end)
                    if self.steps >= most:
                        raise Undecided(f"the run takes more than {most} steps")
        except Undecided as error:
            self.why = str(error)
        del self.wide, self.narrow, self.second, self.of_rates  # large
        # an interval has the boxes at its ends, and is covered whole or not at all
        for (at, over), widest in zip(
            self.bounds, (np.minimum, np.maximum), strict=True
        ):
            over[1:] = widest(over[1:], widest(at[1:], at[:-1]))
        self.bounds[:, 1, self.place(self.t, "right") :] = np.nan
        self.bounds[np.isinf(self.bounds)] = np.nan

    def _disturb(self, end: float) -> None:
        """Compute the intervals of the sources of noise up to a time."""
        radii = self.noise.largest(self.t, self.t if self.jumps is None else end)
        for program, of_inputs in self.of_inputs.items():
            found = sources(of_inputs, self.t, self.P, self.noise.places, radii)
            for series in (*self.of_rates, self.leaps, self.signals):
                if series.program is program:
                    series.of_sources = found

    def _begin(self) -> None:
        """Begin a segment with its jumps; a sample there is after them."""
        now = slice(self.place(self.t), self.place(self.t, "right"))
        self.bounds[:, 0, now] = EMPTY[:, 0]
        if self.jumps and np.any(self.P.c[self.jumps]):
            try:
                self._leap()
            except Undecided:
                self.bounds[:, 1, now] = np.nan
                raise
        # the next interval begins with this box, too
        for which, stop in enumerate((now.stop, now.stop + 1)):
            self._write(
                which, slice(now.start, stop), exact(self.t), *self._set, self.walls
            )

    def _image(
        self, series: SetSeries, t: Ball, x: Ball, G: Ball, hull: Ball | None
    ) -> tuple[Ball, Ball]:
        """Return centre and generators of a function of the set, or its box where it has none."""
        box = around_both(within(self._box(x, G), hull), x)
        try:
            with suppress(Switching):
                J = self._noisy(series, t, box)[:, 1:]
            if series.why:  # lines in the place of decisions
                self._plain(series, t, box)
                series.held = series.lines
                J = self._noisy(series, t, box)[:, 1:]
            y = series.evaluate(t, x, exact(self.P.c))[:, 0, 0]
        except Undecided:  # a line may leave where a function has a value
            y = self._plain(series, t, box)
            return y, exact(np.zeros((len(y.c), len(self.r))))
        finally:
            series.held = {}
        y = balls.add(y, J[:, -1])
        rest = self.G[self.n :]
        G = Ball(np.vstack([G.c, rest]), np.vstack([G.r, 0 * rest]))
        return y, matrix(J[:, : self.N], G)

    def _leap(self) -> None:
        """Map the set by a jump, or from one time of discrete time to the next."""
        t = exact(self.t)
        plain = self._plain(self.leaps, t, self._hull)
        self._put(*self._image(self.leaps, t, *self._set, self.walls), plain)

    def _noisy(self, series: SetSeries, t: Ball, box: Ball) -> Ball:
        """Return values on a box with noise, their derivatives, and what noise adds."""
        return series.evaluate(t, box, self.P, noisy=True)[:, 0]

    def _plain(self, series: SetSeries, t: Ball, box: Ball) -> Ball:
        """Return values on a box, of both sides of switches, with noise."""
        return series.evaluate(t, box, self.P, loose=True, noisy=True)[:, 0, 0]

    def _write(
        self, which: int, rows: slice, t: Ball, x: Ball, G: Ball, hull: Ball | None
    ) -> None:
        """Widen boxes by that of states, and by those of signals: plain, and by their slopes."""
        box = within(self._box(x, G), hull)
        low, high = box.lower, box.upper
        if len(self.signals.results):
            y = self._box(*self._image(self.signals, t, x, G, hull))
            plain = self._plain(self.signals, t, box)
            low = np.append(low, np.fmax(plain.lower, y.lower))
            high = np.append(high, np.fmin(plain.upper, y.upper))
            for k in {*np.flatnonzero(np.isnan(low[self.n :]))}.difference(self.lost):
                self.lost[k] = self.signals.reason(self.signals.results[k])
        lower, upper = self.bounds[:, which, rows]
        np.minimum(lower, low, out=lower)
        np.maximum(upper, high, out=upper)

    def _advance(self, end: float) -> None:
        """Take a step, with lines or by rates alone if there is no series."""
        if self.jumps is None:
            self._leap()
            self.t, self.steps = end, self.steps + 1
            return
        try:
            self._step(end)
            if self.h > self.short:  # no longer beside a switch
                self.short = SHORTEST * self.span
        except Undecided as error:
            if not self.has_lines:
                raise
            larger = QUICKER
            if not self._step_beside(end):
                larger = LARGER
                try:
                    self._step_by_rates(end)
                except Undecided:
                    raise error from None
            self.short = min(larger * self.short, LONGEST * self.span)

    # --- a step -------------------------------------------------------------------------------

    def _hold(self, lines: dict[int, Line]) -> None:
        """Put lines in the place of the decisions of rates."""
        for series in self.of_rates:
            series.held = lines

    def _step_beside(self, end: float, least: float = 0.0) -> bool:
        """Take a step with lines in the place of decisions; return whether there is one."""
        try:
            self._step(*self._held(end, least))
        except Undecided:
            return False
        finally:
            self._hold({})
        self.beside += 1
        return True

    def _step_by_rates(self, end: float) -> None:
        """Take a short step x + h f(B), where coefficients are too large beside a root."""
        new, (x, G) = min(self.t + self.short, end), self._set
        h = float(moved(self.t, new).upper)
        time = between(self.t, np.nextafter(self.t + h, np.inf))
        B = self._picard(time, h, 1e-6 * h * h)
        rates = self._plain(self.rates, time, B)
        hull = self._walls(time, B, h)
        self._accept(
            new, hull, lambda h: (balls.add(x, balls.mul(rates, h)), G), has_walls=True
        )
        self.beside += 1

    def _held(self, end: float, least: float) -> tuple[float, Any]:
        """Return the end of a step with little noise, or a short one, and its `_noise_box`."""
        t, box = self.t, self._hull
        self._plain(self.rates, exact(t), box)
        self._hold(self.rates.lines)
        d = self._noisy(self.rates, exact(t), box)[:, -1].size
        new = min(t + min(2.0 * self.h, LONGEST * self.span), end)
        while (h := float(moved(t, new).upper)) > least:
            try:
                time = between(t, np.nextafter(t + h, np.inf))
                held = self._noise_box(time, h, has_lines=True)
                share = np.max(h * held[1] / (box.r + REACH))
                grows = np.any(held[1] > (1.0 + NOISY) * d)
                if share <= (SMALL if grows else NOISY) or h <= self.short:
                    return new, held
            except Undecided:
                if h <= self.short:
                    raise
            new = t + 0.5 * (new - t)
        raise Undecided("noise is large")

    def _noise_box(
        self, time: Ball, h: float, has_lines: bool = False
    ) -> tuple[Ball, np.ndarray, Any]:
        """Return a box that no run leaves in a step, its noise, and how far that moves a run."""
        n = self.n
        reach = 1e-6 * h * h if has_lines else REACH  # a root grows from 0
        B = self._picard(time, h, reach, has_lines)
        found = self._noisy(self.rates, time, B)
        slopes, d = found[:, 1:], found[:, -1].size
        J = slopes[:, :n].size
        J[np.diag_indices(n)] = np.diag(slopes[:, :n].upper)
        sizes = B.size + self.span * found[:, 0].size + REACH
        return B, d, partial(moved_apart, d, J, sizes)

    def _step(self, end: float, beside: Any = None) -> None:
        """Take a step by series."""
        p, n, N, t = ORDER, self.n, self.N, self.t
        least = LEAST * self.span
        # after a short step beside a switch, while these may still grow
        is_beside = SHORTEST * self.span < self.short < LONGEST * self.span
        shortest = SHORTER * self.short * is_beside
        # 1. coefficients on the box
        box = self._hull
        wide = self.wide.evaluate(exact(t), box, self.P)
        F = wide[:, :, 0]
        d = None
        if beside:
            d, shortest = beside[1], 0.0
        elif self.is_noisy:  # an error if the box itself straddles a switch
            d = self._noisy(self.rates, exact(t), box)[:, -1].size
        longest = end - t if beside else max(LARGER * self.h, least)
        h, allowed = step_length(F, box, min(longest, end - t), least)
        # 2. a box that holds all runs
        speeds = (box.r[box.r > 0.0] / (F.size[box.r > 0.0, 1] + REACH)).tolist()
        passing = 0.0 if beside else SHORTER * min(speeds, default=0.0)  # of a switch
        while True:
            if h < shortest:
                raise Undecided("steps by series are too short")
            new = end if end - t - h < 1e-3 * h else t + h
            step = moved(t, new)
            try:
                remainder, hull, apart = self._remainder(step, F, d, beside)
                error = remainder.size * float(step.upper) ** (p + 1)
                worst = float(np.max(error / allowed))
                if worst <= 1.0 or h < 4.0 * least:
                    break
                h *= max(0.5, 0.9 * worst ** (-1.0 / (p + 1)))
            except Undecided as error:
                h *= 0.6
                if isinstance(error, Switching) and h < passing:
                    passing = 0.0
                    if self._step_beside(end, h):
                        return
                if h < least or t + h <= t:
                    raise
        # 3. mean value form
        middle = exact(t), self._set[0], exact(self.P.c)
        terms = self.narrow.evaluate(*middle)[:, :, 0]
        terms.c[:, p + 1], terms.r[:, p + 1] = remainder
        J = wide[:, : p + 1, 1 : N + 1]
        flow = self._flow(terms, J, apart)
        first = flow(step)
        if (H := self._bends(box, first[1])) is not None:
            J = self.wide.evaluate(*middle)[:, : p + 1, 1 : N + 1]
            bent = self._flow(terms, J, apart, H)
            radii = (self._box(*one).r + REACH for one in (bent(step), first))
            flow = bent if np.sum(np.divide(*radii)) < n else flow
        is_loose = bool(np.any(flow(step)[1].r @ self.r > LOOSE * box.r))
        if is_loose and d is None:
            time = between(t, np.nextafter(t + float(step.upper), np.inf))
            hull = self._walls(time, hull(step), float(step.upper))
        # errors of the Jacobian grow as h, more is of dependent terms
        while len(self.r) and 0.5 * (new - t) > least:
            half = t + 0.5 * (new - t)
            errors = [flow(moved(t, one))[1].r @ self.r for one in (new, half)]
            if np.all(errors[0] <= 2.3 * errors[1] + allowed):
                break
            new = half
        self._accept(new, hull, flow, is_loose or d is not None)

    def _flow(self, terms: Ball, J: Ball, apart: Any, H: Ball | None = None) -> Any:
        """Return a function of time since the step began, with middle and generators."""
        n, N, orders = self.n, self.N, ORDER + 1

        def flow(h: Ball) -> tuple[Ball, Ball]:
            scales = powers(h, orders + 1)
            centre = balls.total(balls.mul(terms, scales))
            centre = balls.add(centre, around(apart(float(h.upper))))
            G = matrix(matrix(scales[None, :orders], J)[:, 0], exact(self.G))
            if H is None:
                return centre, G
            of_step = matrix(scales[None, :orders], H)[:, 0]
            of_step = Ball(*(a.reshape(n, N, N) for a in of_step))
            left = bend(G, of_step, self.G, self.r, self.given)
            return balls.add(centre, around(left)), G

        return flow

    def _walls(self, time: Ball, B: Ball, h: float) -> Any:
        """Return walls of the set in a step, by times since it began."""
        return walls(partial(self._plain, self.rates, time), self._inner, B, h)

    def _bends(self, box: Ball, G: Ball) -> Ball | None:
        """Return second derivatives of coefficients, where first ones on the box are too wide."""
        n, orders = self.n, ORDER + 1
        if self.second is None or np.all(G.r @ self.r <= FLAT * box.r):
            return None
        with suppress(Undecided):
            x = with_tangents(box, self.N)
            found = self.second.evaluate(exact(self.t), x, self.P)
            return second_derivatives(found[:, :orders, 1:], n, self.N)
        return None

    @property
    def _set(self) -> tuple[Ball, Ball]:
        """The middle of the states and their generators."""
        return exact(self.m[: self.n]), exact(self.G[: self.n])

    @property
    def _inner(self) -> Ball:
        """The box of the states within the walls."""
        return within(self._box(*self._set), self.walls)

    @property
    def _hull(self) -> Ball:
        """The box of the states within the walls, and their middle."""
        return around_both(self._inner, self._set[0])

    def _box(self, x: Ball, G: Ball) -> Ball:
        """Return the box of values with a middle and generators."""
        return balls.add(x, matrix(G, around(self.r)))

    def _accept(self, new: float, hull: Any, flow: Any, has_walls: bool) -> None:
        """Go to a new time, and write the boxes up to it.

        `flow` returns centre and generators of x after a time in a ball, `hull` a box of them.
        """
        t, before = self.t, self._inner
        # 1. boxes over intervals, as far as these are in the step, and at samples
        for k in range(self.place(t, "right"), self.place(new) + 1):
            begin, end = max(t, self.times[k - 1]), min(new, self.times[k])
            rows, inside = slice(k, k + 1), between(begin, end)
            h = between(moved(t, begin).lower, moved(t, end).upper)
            x, G = flow(h)
            box = within(self._box(x, G), hull(h))
            length = float(moved(begin, end).upper)
            box = self._reached(box, before, inside, between(0.0, length))
            if end == self.times[k]:
                x_end, G_end = flow(moved(t, end))
                before = within(self._box(x_end, G_end), hull(moved(t, end)))
                self._write(0, rows, exact(end), x_end, G_end, before)
                box = self._reached(box, before, inside, between(-length, 0.0))
            self._write(1, rows, inside, x, G, box)
        # 2. the set
        end = moved(t, new)
        x, G = flow(end)
        self._put(x, G, hull(end) if has_walls else None)
        self.h, self.t = new - t, new
        self.steps += 1

    def _reached(self, box: Ball, known: Ball, time: Ball, ago: Ball) -> Ball:
        """Return a box over an interval, no farther from that at an end than at its rates."""
        with suppress(Undecided):
            for _ in range(2):  # rates of the box that the first ones leave
                far = self._plain(self.rates, time, box)
                box = within(box, balls.add(known, balls.mul(ago, far)))
        return box

    def _put(self, centre: Ball, G: Ball, walls: Ball | None) -> None:
        """Replace the set; its errors are new columns, the shortest of which become a box.

        A state far beyond its walls is an interval between them.
        """
        n, N = self.n, self.N
        if walls is not None:
            is_far = walls.r < 0.5 * self._box(centre, G).r
            ends = zip(walls, centre, strict=True)
            centre = Ball(*(np.where(is_far, wall, of) for wall, of in ends))
            G.c[is_far] = G.r[is_far] = 0.0
        errors = balls.add(matrix(around(G.r), exact(self.r)), exact(centre.r)).size
        # what bends runs: the radii of columns, and their shares in noise
        R = self._box(*self._set).r + REACH
        share = np.abs(G.c[:, : self.given]) * (centre.r / R)[:, None]
        bent = (G.r[:, : self.given] + share) * self.r[: self.given]
        self.bent += np.sum(bent.T / R, axis=1)
        self.m[:n], self.walls = centre.c, walls
        self.G = np.hstack([np.vstack([G.c, self.G[n:]]), np.eye(N, n)])
        self.r = np.concatenate([self.r, errors])
        if (count := len(self.r) - self.kept) > TERMS * n:
            lengths = np.max(np.abs(self.G), axis=0) * self.r
            shortest = np.argsort(lengths[self.kept :])[: count - TERMS // 2 * n]
            shortest += self.kept
            rest = matrix(exact(np.abs(self.G[:n, shortest])), exact(self.r[shortest]))
            self.G = np.hstack([np.delete(self.G, shortest, axis=1), np.eye(N, n)])
            self.r = np.concatenate([np.delete(self.r, shortest), rest.size])

    # --- boxes that hold runs -----------------------------------------------------------------

    def _remainder(
        self, step: Ball, F: Ball, d: np.ndarray | None, beside: Any
    ) -> tuple[Ball, Any, Any]:
        """Return coefficient p + 1 on a box that holds all runs, the box, and what noise adds.

        Both are functions of the time since the step began; d is the noise of the rates then.
        """
        p, h = ORDER, float(step.upper)
        time = between(self.t, np.nextafter(self.t + h, np.inf))
        if d is not None:
            B, during, apart = beside or self._noise_box(time, h)
            grows = np.any((d > 0.0) & (during > (1.0 + NOISY) * d))
            if grows and not beside and h > NOISY_STEPS * self.span:
                raise Undecided("a step is too long for its noise")
            apart(h)  # an error if the step is too long
            found = self.narrow.evaluate(time, B, self.P)[:, p + 1, 0]
            return found, self._walls(time, B, h), apart
        scales = powers(between(0.0, h), ORDER + 2)
        base = matrix(F[:, : p + 1], scales[: p + 1])
        last = float(scales.upper[p + 1])
        reach = 2.0 * last * F[:, p + 1].size + balls.UNIT * base.size + REACH
        for _ in range(3):
            B = Ball(base.c, (base.r + reach) * balls.GROWTH)
            found = self.narrow.evaluate(time, B, self.P)[:, p + 1, 0]
            needed = last * found.size * balls.GROWTH
            if np.all(needed < reach):
                break
            reach = np.maximum(reach, 4.0 * needed)
        else:
            raise Undecided("no box holds the runs of a step")
        B = Ball(base.c, (base.r + needed) * balls.GROWTH)
        return found, (lambda h: B), (lambda h: 0.0 * needed)

    def _picard(
        self, time: Ball, h: float, reach: float, has_lines: bool = False
    ) -> Ball:
        """Return a box that no run leaves during a step.

        With lines in the place of decisions, no run of these leaves it either.
        """
        box, during = self._hull, between(0.0, h)
        B = box
        for _ in range(8 + self.n):  # each may wait for another to grow
            found = self._plain(self.rates, time, B)
            if has_lines:
                self._hold(self.rates.lines)
                held = self._noisy(self.rates, time, B)[:, 0]
                found = around_both(found, held)
            needed = balls.add(box, balls.mul(during, found))
            if np.all((needed.lower > B.lower) & (needed.upper < B.upper)):
                return B
            low = np.minimum(needed.lower, box.lower)
            B = between(low, np.maximum(needed.upper, box.upper))
            B = Ball(B.c, 1.2 * B.r + balls.UNIT * np.abs(B.c) + reach)
        raise Undecided("no box holds the runs of a step")
