"""Branches are merged where they end: execution paths add up and do not multiply."""

import math

import control
import numpy as np
import pytest
from engine_runs import Unread, readings
from recorded_blocks import as_it_runs, static

import clpt_control as clpt

N = 8
U = np.array([0.3, -1.7, 2.0, -0.4, 1.0, -1.0, 0.0, 1.2])
LIMITS = np.array([0.5, 1.0, 1.5, 0.5, 1.0, 1.5, 0.5, 1.0])


class Thrusters:
    """Eight of three cases each: 6,561 paths where they multiply."""

    def __init__(self):
        self.gains, self.calls = list(LIMITS), {"low": -1.0}

    def limited(self, v, high):
        if v > high:
            return high
        if v < self.calls["low"] * high:
            return self.calls["low"] * high
        return v

    def by_method(self, t, x, u, p):
        return [
            self.limited(v, high) * gain
            for v, high, gain in zip(u, LIMITS, self.gains, strict=True)
        ]

    def by_chain(self, t, x, u, p):
        forces = np.zeros(N)
        for i in range(N):
            if u[i] > self.gains[i]:
                forces[i] = self.gains[i]
            elif u[i] < -self.gains[i]:
                forces[i] = -self.gains[i]
            elif u[i] > 0:
                forces[i] = u[i] ** 2
            else:
                forces[i] = u[i]
        return forces

    def by_total(self, t, x, u, p):
        total, largest, used = 0.0, -math.inf, []
        for v in u:
            if v > 0.5 and v < 1.5:
                total += v
                used.append(v)
            else:
                total -= 0.5
                used.append(0.0)
            if v > largest:
                largest = v
        return [*used[:6], total, largest]


def by_lambda(t, x, u, p):
    shaped = lambda v: v if v > 0 else (0.1 * v if v > -1 else -0.1)  # noqa: E731
    return [shaped(v) for v in u]


def by_inner_function(t, x, u, p):
    def shaped(v):
        def sign(w):
            return 1.0 if w > 0 else -1.0 if w < 0 else 0.0

        if abs(v) > 1:
            return sign(v) * 2.0
        return sign(v - 0.2) * v

    return [shaped(v) for v in u]


def by_expression(t, x, u, p):
    return [
        v if v > high else (high and v < 0 and -v) or 2.0
        for v, high in zip(u, LIMITS, strict=True)
    ]


def by_try(t, x, u, p):
    ratios = []
    for a, b in zip(u, u[::-1], strict=True):
        try:
            ratios.append(float(a) / float(b))
        except ZeroDivisionError:
            ratios.append(math.copysign(9.0, a))
    return ratios


def by_match(t, x, u, p):
    forces = []
    for v in u:
        match v > 0, v > 1:
            case True, True:
                force = 1.0
            case True, False:
                force = v
            case _:
                force = 0.0
        forces.append(force)
    return forces


def by_conversion(t, x, u, p):
    forces = []
    for v in u:
        v = float(v)
        while v > 1.5:
            v = 1.5
        forces.append(v)
        if v < -1.5:
            break
    return [*forces, 0.0, *[0.0] * (N - 1 - len(forces))][:N]


METHODS = [Thrusters().by_method, Thrusters().by_chain, Thrusters().by_total]
FUNCTIONS = [by_lambda, by_inner_function, by_expression, by_try, by_match]


@pytest.mark.parametrize(
    "function", [*METHODS, *FUNCTIONS], ids=lambda one: one.__name__
)
def test_branches_of_many_elements_are_traced(function):
    block = static(function, N, N)
    for shift in range(N):
        as_it_runs(block, "output", 0.0, [], np.roll(U, shift))
    assert len(block.array_record("output").operations) < 60 * N


def test_what_a_branch_leaves_behind_is_merged():
    """A variable, a list, an item, an attribute; and a variable that one branch alone sets."""

    class Shape:
        level = 0.0

    def bound(t, x, u, p):
        row, table, shape = [0.0, 0.0], {"a": 1.0}, Shape()
        if u[0] > 0:
            row[1], table["a"], shape.level, only = u[1], u[2], 2.0, 5.0
        else:
            row[0], y = u[2], 3.0
        if u[0] > 0:
            y = only
        return [row[0], row[1], table["a"], shape.level, y]

    block = static(bound, 3, 5)
    for u in ([1.0, 2.0, 3.0], [-1.0, 2.0, 3.0]):
        as_it_runs(block, "output", 0.0, [], u)


def test_functions_that_return_early_multiply_no_further_than_allowed():
    def early(t, x, u, p):
        for k in range(N):
            if u[k] > 1.1:
                return [u[k], float(k)]
        return [0.0, -1.0]

    block = static(early, N, 2)
    for shift in range(N):
        as_it_runs(block, "output", 0.0, [], np.roll(U, shift))


def test_without_source_paths_multiply():
    """The text of the function is not its file's."""
    lines = ["def many(t, x, u, p):", "    y = 0.0"]
    lines += [f"    if u[{k}] > {k}.5: y += u[{k}]" for k in range(N)]
    lines += ["    if y > 3: y = 3.0", "    return [y]"]
    space = {}
    exec("\n".join(lines), space)
    with pytest.raises(Unread, match="more than 256 execution paths"):
        static(space["many"], N).array_record("output")


def test_a_changed_file_is_not_used(tmp_path, monkeypatch):
    """Source that does not compile to the function's own code is ignored."""
    monkeypatch.syspath_prepend(tmp_path)
    file = tmp_path / "edited_law.py"
    file.write_text(
        "def law(t, x, u, p):\n    return [u[0] if u[0] > 0 else 0.5 * u[0]]\n"
    )
    import edited_law

    file.write_text(
        "def law(t, x, u, p):\n    return [u[0] if u[0] > 0 else 7.0 * u[0]]\n"
    )
    assert (
        as_it_runs(static(edited_law.law), "output", 0.0, [], [-1.0, 0.0, 0.0])[0]
        == -0.5
    )


def test_decorated_functions_keep_their_decorator():
    def doubled(function):
        def inner(*arguments):
            return 2.0 * np.asarray(function(*arguments))

        inner.__wrapped__ = function
        return inner

    @doubled
    def law(t, x, u, p):
        return [u[0] if u[0] > 0 else 0.0]

    assert as_it_runs(static(law), "output", 0.0, [], [1.0, 0.0, 0.0])[0] == 2.0


# --- indices that signals determine ---------------------------------------------------------------

ROWS = 300
ANGLES = np.linspace(0.0, 6.0, ROWS)
PATH = np.column_stack([10.0 * np.cos(ANGLES), 10.0 * np.sin(ANGLES), ANGLES])
CX, CY = PATH[:, 0].tolist(), tuple(PATH[:, 1].tolist())
POINTS = [tuple(row) for row in PATH.tolist()]
NEXT = (np.arange(ROWS) + 1) % ROWS


def nearest(u):
    return np.argmin((PATH[:, 0] - u[0]) ** 2 + (PATH[:, 1] - u[1]) ** 2)


INDICES = {
    "a row": lambda t, x, u, p: PATH[nearest(u)],
    "the next row": lambda t, x, u, p: PATH[nearest(u) + 1],
    "a row ahead": lambda t, x, u, p: PATH[min(nearest(u) + 8, ROWS - 1)],
    "a row on a ring": lambda t, x, u, p: PATH[(nearest(u) + 9) % ROWS],
    "an index of an index": lambda t, x, u, p: PATH[NEXT[nearest(u)]],
    "rows of a list": lambda t, x, u, p: POINTS[nearest(u)],
    "an item of a list": lambda t, x, u, p: [CX[nearest(u)], CY[nearest(u)], 0.0],
    "one of many": lambda t, x, u, p: PATH[nearest(u), [2, 0, 1]],
    "an integer": lambda t, x, u, p: PATH[int(abs(u[0]) * 3)],
    "from the end": lambda t, x, u, p: PATH[-int(abs(u[0]) * 3) - 1],
    "a floor": lambda t, x, u, p: PATH[int(np.floor(abs(u[1]) * 7))],
    "clipped": lambda t, x, u, p: PATH[max(0, min(int(u[0] * 60), ROWS - 1))],
    "a search": lambda t, x, u, p: PATH[
        np.clip(np.searchsorted(ANGLES, u[0]), 0, ROWS - 1)
    ],
    "bins": lambda t, x, u, p: PATH[min(np.digitize(u[0], ANGLES), ROWS - 1)],
    "taken": lambda t, x, u, p: np.take(PATH, nearest(u), axis=0),
    "two rows": lambda t, x, u, p: PATH[[nearest(u), NEXT[nearest(u)]]].sum(axis=0),
    "found in a list": lambda t, x, u, p: PATH[by_hand(u)],
}


def by_hand(u):
    distances = [math.hypot(a - u[0], b - u[1]) for a, b in zip(CX, CY, strict=True)]
    return distances.index(min(distances))


@pytest.mark.parametrize("name", INDICES)
def test_an_index_is_one_operation(name):
    block = static(INDICES[name], 2, 3)
    for u in ([9.0, 1.0], [-7.0, 4.0], [0.3, -9.5], [2.0, 0.1]):
        as_it_runs(block, "output", 0.0, [], u, 1e-12)
    most = 10 * ROWS if name == "found in a list" else 60
    assert len(block.array_record("output").operations) < most


def test_waypoints_by_a_state_that_counts():
    """A leg is a sampled state; the run goes through all of 1,000 legs."""
    ends = np.arange(1.0, 1001.0)

    def update(t, x, u, p):
        leg = int(x[1])
        reached = x[0] > ends[leg] - 0.05
        return [x[0] + 0.1, min(leg + 1, len(ends) - 1) if reached else leg]

    course = control.nlsys(
        update, None, inputs=0, outputs=2, states=2, dt=0.1, name="course"
    )
    run = clpt.simulate(course, 0.1 * np.arange(5001))
    assert run.attrs["engine"] == "native"
    expected = control.input_output_response(
        course, 0.1 * np.arange(5001), 0, [0.0, 0.0]
    )
    np.testing.assert_array_equal(run.states.values.T, expected.states)


def test_arrays_that_nothing_may_write_into_are_left_as_they_are():
    def output(t, x, u, params):
        v = sorted([u[0], 9.0])[0]  # two paths
        gain = params["gain"] if v > 0.5 else params["other"]
        return [gain * v if v > 0 else params["fixed"].sum()]

    fixed = np.array([1.0, 2.0])
    fixed.flags.writeable = False
    static_block = clpt.Block(
        "table",
        output=lambda t, x, u, p: {"rows_out": p.rows},
        outputs={"rows_out": 2},
        parameters={"rows": fixed},
    )
    params = {"gain": 2.0, "other": 3.0, "fixed": fixed}
    limit = control.nlsys(
        None, output, params=params, inputs=1, outputs=1, name="limit"
    )
    wires = {"inplist": ["limit.u[0]"], "outlist": ["limit.y[0]", "table"]}
    names = {"inputs": ["v"], "outputs": ["y", "r0", "r1"]}
    loop = control.interconnect([static_block, limit], **wires, **names)
    read = readings(loop)
    for u, y in ((0.7, 1.4), (0.2, 0.6), (-1.0, 3.0)):
        for name in ("python", "native"):
            assert read[name](0.0, [], [u])[1] == pytest.approx(
                [y, 1.0, 2.0], abs=1e-15
            )
