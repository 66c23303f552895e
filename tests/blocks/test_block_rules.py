"""What a block's equations may say: refused by function, line and replacement."""

import inspect
import math
from math import exp

import numpy as np
import pytest
import sympy

from clpt_control.blocks import Block, opaque, words
from clpt_control.blocks.functions import helpers_of
from clpt_control.blocks.rules import check_equations
from clpt_control.blocks.symbolic import expressions
from clpt_control.blocks.words import clip, floor, lookup, maximum, minimum, sign, where
from clpt_control.errors import ArgumentError, BlockError
from clpt_control.native import readings

TABLE = [1.0, 2.0]
RATE = 0.5
NAMES = {"a": 1.0}


# --- refused; each marks the line it is refused at --------------------------------------------


def says_if(t, x, u, p, y):
    y[0] = 0.0
    if u[0] > 0:  # here
        y[0] = 1.0


def says_ternary(t, x, u, p, y):
    y[0] = 1.0 if u[0] > 0 else 0.0  # here


def says_numpy(t, x, u, p, y):
    y[0] = u[0]
    y[0] = np.exp(u[0])  # here


def says_while(t, x, u, p, y):
    y[0] = 0.0
    while y[0] < 3:  # here
        y[0] += 1.0


def says_lambda(t, x, u, p, y):
    f = lambda a: a  # noqa: E731  # here
    y[0] = f(u[0])


def says_list(t, x, u, p, y):
    values = [2 * a for a in u]  # here
    y[0] = values[0]


def says_generator(t, x, u, p, y):
    y[0] = sum(a for a in u)  # here


def says_and(t, x, u, p, y):
    y[0] = where(u[0] > 0 and u[1] > 0, 1.0, 0.0)  # here


def says_or(t, x, u, p, y):
    y[0] = where(u[0] > 0 or u[1] > 0, 1.0, 0.0)  # here


def says_max(t, x, u, p, y):
    y[0] = max(u[0], u[1])  # here


def says_min(t, x, u, p, y):
    y[0] = min(u[0], u[1])  # here


def says_abs(t, x, u, p, y):
    y[0] = abs(u[0])  # here


def says_sum(t, x, u, p, y):
    y[0] = sum(u)  # here


def says_round(t, x, u, p, y):
    y[0] = round(u[0])  # here


def says_unknown(t, x, u, p, y):
    y[0] = wibble(u[0])  # noqa: F821  # here


def says_nested(t, x, u, p, y):
    def inner(a):  # here
        return a

    y[0] = inner(u[0])


def says_print(t, x, u, p, y):
    y[0] = u[0]
    print(u[0])  # here


def says_loop_over_array(t, x, u, p, y):
    y[0] = 0.0
    for a in u:  # here
        y[0] += a


def says_enumerate(t, x, u, p, y):
    for i, a in enumerate(u):  # here
        y[i] = a


def says_global_list(t, x, u, p, y):
    y[0] = TABLE[0]  # here


def says_global_dict(t, x, u, p, y):
    y[0] = NAMES["a"]  # here


def says_try(t, x, u, p, y):
    try:  # here
        y[0] = math.sqrt(u[0])
    except ValueError:
        y[0] = 0.0


def says_assert(t, x, u, p, y):
    assert u[0] > 0  # here
    y[0] = u[0]


def says_raise(t, x, u, p, y):
    raise ValueError  # here


def says_break(t, x, u, p, y):
    for i in range(2):
        y[i] = u[i]
        break  # here


def says_continue(t, x, u, p, y):
    for _i in range(2):
        continue  # here


def says_import(t, x, u, p, y):
    import cmath  # here

    y[0] = cmath.pi


def says_global(t, x, u, p, y):
    global RATE  # here
    y[0] = RATE


def says_string(t, x, u, p, y):
    y[0] = len(f"{u[0]}")  # here


def says_open(t, x, u, p, y):
    y[0] = open(u[0])  # noqa: SIM115, PTH123  # here


def says_chained(t, x, u, p, y):
    y[0] = where(0 < u[0] < 1, 1.0, 0.0)  # here


def says_not(t, x, u, p, y):
    y[0] = where(not u[0] > 0, 1.0, 0.0)  # here


def says_in(t, x, u, p, y):
    y[0] = where(u[0] in (1.0, 2.0), 1.0, 0.0)  # here


def says_method(t, x, u, p, y):
    y[0] = u.max()  # here


def says_match(t, x, u, p, y):
    match u[0]:  # here
        case 1:
            y[0] = 1.0


def says_yield(t, x, u, p, y):
    y[0] = u[0]
    yield 1.0  # here


def says_copysign(t, x, u, p, y):
    y[0] = math.copysign(1.0, u[0])  # here


def says_isnan(t, x, u, p, y):
    y[0] = where(math.isnan(u[0]), 0.0, u[0])  # here


REFUSED = [
    (says_if, "`if`", "where(condition, a, b)"),
    (says_ternary, "`a if c else b`", "where(c, a, b)"),
    (says_numpy, "`np` (numpy)", "math.*"),
    (says_while, "`while`", "for i in range(n)"),
    (says_lambda, "`lambda`", "at the top of the module"),
    (says_list, "a comprehension", "for i in range(n)"),
    (says_generator, "", "for i in range(n)"),
    (says_and, "`and`/`or`", "where(...)"),
    (says_or, "`and`/`or`", "where(...)"),
    (says_max, "`max`", "maximum(a, b)"),
    (says_min, "`min`", "minimum(a, b)"),
    (says_abs, "`abs`", "math.fabs(a)"),
    (says_sum, "`sum`", "for i in range(n)"),
    (says_round, "`round`", "floor(a + 0.5)"),
    (says_unknown, "the unknown name `wibble`", "define it in the module"),
    (says_nested, "a function inside a function", "at the top of the module"),
    (says_print, "`print`", "an output port"),
    (says_loop_over_array, "a loop over anything but range", "for i in range(n)"),
    (says_enumerate, "a loop over anything but range", "for i in range(n)"),
    (says_global_list, "`TABLE` (list)", "arithmetic"),
    (says_global_dict, "`NAMES` (dict)", "arithmetic"),
    (says_try, "`try`", "where, clip or maximum"),
    (says_assert, "`assert`", "before the block is made"),
    (says_raise, "`raise`", "before the block is made"),
    (says_break, "`break`", "where"),
    (says_continue, "`continue`", "where"),
    (says_import, "`import`", "at the top of the module"),
    (says_global, "`global`", "the block's parameters"),
    (says_string, "a string", "numbers only"),
    (says_open, "`open`", "math"),
    (says_chained, "", "where(...)"),
    (says_not, "`not`", "where"),
    (says_in, "`in`", ""),
    (says_method, "max", ""),
    (says_match, "`match`", "where"),
    (says_yield, "`yield`", ""),
    (says_copysign, "copysign", ""),
    (says_isnan, "isnan", ""),
]


def marked_line(function):
    lines, first = inspect.getsourcelines(function)
    return first + next(k for k, line in enumerate(lines) if line.rstrip().endswith("# here"))


@pytest.mark.parametrize(
    ("function", "what", "instead"), REFUSED, ids=[case[0].__name__ for case in REFUSED]
)
def test_refused_by_function_line_and_replacement(function, what, instead):
    with pytest.raises(BlockError) as caught:
        Block("mine", output=function, inputs={"u": 2}, outputs={"y": 2})
    sentence = str(caught.value)
    assert sentence.startswith("mine.output, line "), sentence
    assert f"line {marked_line(function)}:" in sentence
    assert what in sentence
    assert "not allowed here" in sentence
    assert instead in sentence.split("not allowed here", 1)[1]


@pytest.mark.parametrize("function", [says_if, says_numpy, says_print])
def test_update_is_checked_too(function):
    with pytest.raises(BlockError, match=rf"mine\.update, line {marked_line(function)}:"):
        Block("mine", update=function, inputs={"u": 2}, states={"x": 2})


def test_closure_is_refused():
    gain = 2.0

    def closes(t, x, u, p, y):
        y[0] = gain * u[0]

    with pytest.raises(BlockError, match=r"mine\.output: closes closes over gain.*parameters"):
        Block("mine", output=closes, inputs={"u": 1}, outputs={"y": 1})


@pytest.mark.parametrize("thing", [np.exp, math.exp, len, words])
def test_only_plain_functions(thing):
    with pytest.raises(BlockError, match="is not a plain function"):
        check_equations(thing, "mine.output")


# --- helpers ----------------------------------------------------------------------------------


def bad_helper(a):
    return np.sqrt(a)  # here


def middle_helper(a):
    return 2.0 * bad_helper(a)


def calls_bad_helper(t, x, u, p, y):
    y[0] = middle_helper(u[0])


def test_helpers_of_helpers_are_checked():
    with pytest.raises(BlockError) as caught:
        Block("mine", output=calls_bad_helper, inputs={"u": 1}, outputs={"y": 1})
    sentence = str(caught.value)
    assert "mine.output -> middle_helper -> bad_helper" in sentence
    assert f"line {marked_line(bad_helper)}:" in sentence


def countdown(a):
    return where(a > 0, a - 1.0, a)


def twice(t, x, u, p, y):
    y[0] = countdown(u[0]) + countdown(u[1])


def test_helpers_of_names_functions_not_words():
    assert helpers_of(twice) == {"countdown": countdown}
    assert helpers_of(countdown) == {}


# --- allowed ----------------------------------------------------------------------------------


def says_everything(t, x, u, p, y):
    """Everything that is allowed, in one function."""
    total = 0.0
    first, second = u[0:2], u[2:4]
    for i in range(len(first)):
        for j in range(0, 2):
            total += first[i] * second[j]
    a = where(total > 0.0, total, -total)
    a = minimum(a, maximum(0.5, RATE)) + clip(u[0], -1.0, 1.0) + sign(u[1]) * floor(u[2])
    a += exp(-math.fabs(u[3])) + math.pi * math.cos(t) + math.sqrt(u[0] ** 2 + 1)
    a += float(3) + 2 + countdown(t) + 7 // 2 + 7 % 2
    y[0] = a
    y[1] = -a


def says_lookup(t, x, u, p, y):
    y[0] = lookup(p.table, u[0])


def annotated(t: float, x: np.ndarray, u: np.ndarray, p, y: np.ndarray) -> None:
    """Annotations and docstrings say nothing to the readers."""
    scale: float = 2.0
    y[0] = scale * u[0]


@pytest.mark.parametrize("function", [says_everything, says_lookup, annotated, twice])
def test_allowed(function):
    check_equations(function, "mine.output")


def test_everything_allowed_is_read_alike():
    block = Block("mine", output=says_everything, inputs={"u": 4}, outputs={"y": 2})
    u, out = [0.3, -0.8, 2.6, 1.1], np.zeros(2)
    says_everything(0.7, None, u, None, out)
    for name, ask in readings(block).items():
        np.testing.assert_allclose(ask(0.7, [], u)[1], out, rtol=1e-14, err_msg=name)


# --- opaque helpers ---------------------------------------------------------------------------


@opaque
def gust(t, height):
    return math.sin(t) * height


def windy(t, x, u, p, y):
    y[0] = 2.0 * gust(t, u[0])


def test_opaque_helper_is_an_undefined_function():
    block = Block("mine", output=windy, inputs={"u": 1}, outputs={"y": 1})
    t, h = sympy.symbols("t h", real=True)
    (found,) = expressions(block.output_record, lambda name, *where: t if name == "t" else h)
    (gusts,) = found.atoms(sympy.core.function.AppliedUndef)
    assert gusts.func.__name__.endswith("gust()")
    assert gusts.args == (t, h)
    assert found == 2 * gusts
    assert found.diff(h) != 0


def test_opaque_helper_is_run_in_every_reading():
    block = Block("mine", output=windy, inputs={"u": 1}, outputs={"y": 1})
    for name, ask in readings(block).items():
        assert ask(math.pi / 2, [], [3.0])[1] == pytest.approx([6.0], rel=1e-15), name


@opaque
def bad_gust(t):
    return np.sin(t)


def windy_and_bad(t, x, u, p, y):
    y[0] = bad_gust(t)


def test_opaque_helpers_are_run_so_they_are_checked():
    with pytest.raises(BlockError, match="bad_gust, line"):
        check_equations(windy_and_bad, "mine.output")


# --- ports and parameters ---------------------------------------------------------------------


def test_declarations_that_cannot_work():
    with pytest.raises(BlockError, match="without states needs `output`"):
        Block("mine", inputs={"u": 1})
    with pytest.raises(BlockError, match="`update` and `states` belong together"):
        Block("mine", update=twice, output=twice, outputs={"y": 1})
    with pytest.raises(BlockError, match="outputs are the states; leave them out"):
        Block("mine", update=twice, states={"x": 1}, outputs={"y": 1})
    with pytest.raises(BlockError, match="must be a NamedTuple, not dict"):
        Block("mine", output=twice, outputs={"y": 1}, parameters={"k": 1.0})
    with pytest.raises(BlockError, match=r"needs a parameter `interval = -1\.0`"):
        Block("mine", output=twice, outputs={"y": 1}, breakpoints=lambda p, a, b: np.zeros(0))


def test_ports_have_sizes():
    with pytest.raises(ArgumentError, match=r"inputs = \['e'\]: must be a dict .* \{'e': 2\}$"):
        Block("a", output=lambda t, x, u, p, y: None, inputs=["e"], outputs={"y": 1})
