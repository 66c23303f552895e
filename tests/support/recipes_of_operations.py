"""Recipes of CONTRIBUTING on operations and functions of NumPy, as data."""

from recipes import Recipe, Step

FUNCTIONS = "tests/engine/trace/test_functions.py"
ROW = "        np.cbrt,\n"


def part(name, without, text):
    """Return the step that adds a field to the row of an operation."""
    edit = "clpt_control/engine/record/operations.py", ROW, f"{ROW}        {text},\n"
    return Step(name, without, (edit,))


OPERATION = Recipe(
    "Add an operation",
    (
        Step(
            "row and NumPy function",
            "np.cbrt of signals is not traced",
            (
                (
                    "clpt_control/engine/record/operations.py",
                    '    "log10": _libm(',
                    f'    "cbrt": Row(\n{ROW}    ),\n    "log10": _libm(',
                ),
            ),
        ),
        part(
            "slopes",
            "the derivative of `cbrt`",
            "slopes=(lambda a, f: 1.0 / (3.0 * f * f),)",
        ),
        part(
            "SymPy",
            "the backend 'symbolic'",
            "sympy=lambda s, a: s.sign(a) * s.Abs(a) ** s.Rational(1, 3)",
        ),
        part("machine code", "cbrt: has no machine code", 'llvm="libm"'),
        part("C", "missing 1 required keyword-only argument: 'c'", 'c="cbrt"'),
        Step(
            "no composition",
            "test_a_function_is_an_operation_or_made_of_others",
            (
                (
                    "clpt_control/engine/trace/ufuncs.py",
                    '    "cbrt": lambda a: np.sign(a) * np.fabs(a) ** (1 / 3),\n',
                    "",
                ),
            ),
        ),
    ),
    """
    import numpy as np, warnings
    import sys; sys.path.insert(0, "tests/support")
    import clpt_control as clpt
    from all_backends import compare_backends

    def root(t, x, u, p):
        return np.cbrt(u[0])

    block = clpt.Block("root", output=root, inputs={"u": 1}, outputs={"y": 1})
    warnings.simplefilter("error")
    compare_backends(block)
    assert clpt.simulate(block, [0.0, 1.0], 8.0).y.values.tolist() == [2.0, 2.0]
    assert "cbrt(" in clpt.export(block), "no cbrt in C"
    slope = clpt.linearize(block, [], [8.0]).D[0, 0]
    assert abs(slope - 1 / 12) < 1e-12, f"slope {slope}"
    """,
    ("tests/engine/codegen/test_operations_in_c.py",),
)
FUNCTION = Recipe(
    "Add an operation",
    (
        Step(
            "row",
            "np.real_if_close",
            (
                (
                    "clpt_control/engine/trace/numpy_functions.py",
                    "OF_AN_ARRAY: dict[Any, Callable] = {",
                    "OF_AN_ARRAY: dict[Any, Callable] = {\n"
                    "    np.real_if_close: lambda a, tol=100: a,",
                ),
            ),
        ),
        Step(
            "call",
            "test_each_function_of_the_tables_is_called",
            ((FUNCTIONS, "np.sum(u) ;", "np.sum(u) ; np.real_if_close(u)[1] ;"),),
        ),
    ),
    """
    import numpy as np, warnings
    import sys; sys.path.insert(0, "tests/support")
    import clpt_control as clpt
    from all_backends import compare_backends

    def real(t, x, u, p):
        return np.real_if_close(u.u)

    block = clpt.Block("real", output=real, inputs={"u": 2}, outputs={"y": 2})
    warnings.simplefilter("error")
    compare_backends(block)
    run = clpt.simulate(block, [0.0, 1.0], [1.0, 3.0])
    assert (run.attrs["engine"], run.y.values[0].tolist()) == ("native", [1.0, 3.0])
    """,
    (FUNCTIONS, "-k", "is_called or real_if_close"),
)
UFUNC = Recipe(
    "Add an operation",
    (
        Step(
            "row",
            "np.fmax of signals is not traced",
            (
                (
                    "clpt_control/engine/trace/ufuncs.py",
                    '    "exp2": lambda',
                    '    "fmax": lambda a, b: where((a >= b) | (b != b), a, b),\n'
                    '    "exp2": lambda',
                ),
            ),
        ),
    ),
    """
    import numpy as np
    import sys; sys.path.insert(0, "tests/support")
    import clpt_control as clpt
    from all_backends import compare_backends

    def larger(t, x, u, p):
        return np.fmax(u[0], u[1])

    compare_backends(clpt.Block("larger", output=larger, inputs={"u": 2}, outputs={"y": 1}))
    """,
    (FUNCTIONS, "-k", "fmax"),
)
MEASURED = "tests/engine/codegen/test_elementary.py"
ELEMENTARY = Recipe(
    "Add an operation",
    (
        Step(
            "row",
            "np.logaddexp2 of signals is not traced",
            (
                (
                    "clpt_control/engine/record/operations.py",
                    '    "log10": _libm(',
                    """    "logaddexp2": Row(
        np.logaddexp2,
        (lambda a, b, f: 2.0 ** (a - f), lambda a, b, f: 2.0 ** (b - f)),
        sympy=lambda s, a, b: s.log(2**a + 2**b) / s.log(2),
        exact=False,
        c="logaddexp2_",
    ),
    "log10": _libm(""",
                ),
            ),
        ),
        Step(
            "machine code",
            "logaddexp2: has no machine code",
            (
                (
                    "clpt_control/engine/codegen/elementary.py",
                    "",
                    '''

def logaddexp2(a, b):
    """Return log2(2^a + 2^b)."""
    less = exp(where(a == b, 0.0, -abs(a - b)) * LN2)
    more = 1.0 + less  # log(1 + less) by Kahan
    added = where(more == 1.0, less, log(more) * less / (more - 1.0))
    return where((a > b) | (a != a), a, b) + added * LOG2_E


FUNCTIONS["logaddexp2"] = logaddexp2
''',
                ),
            ),
        ),
        Step(
            "C",
            "'c' refuses: logaddexp2_: is not in data/numpy.c",
            (
                (
                    "clpt_control/data/numpy.c",
                    "static double pick_(",
                    """static double logaddexp2_(double a, double b) {
    const double gap = a == b ? 0.0 : -fabs(a - b);
    return (a > b || isnan(a) ? a : b) + log1p(exp2(gap)) / 0.6931471805599453;
}

static double pick_(""",
                ),
            ),
        ),
        Step(
            "measurement",
            "test_every_function_is_measured",
            (
                (
                    MEASURED,
                    "",
                    """

def test_accuracy_of_logaddexp2():
    a, b = uniform(1, 30), uniform(1, 30)
    exact = lambda a, b: mpmath.log(mpmath.mpf(2)**a + mpmath.mpf(2)**b, 2)
    found = everywhere("logaddexp2", a, b)
    assert relative_error(found, np.stack([a, b], 1), exact) <= 1e-15
""",
                ),
            ),
        ),
    ),
    """
    import numpy as np
    import sys; sys.path.insert(0, "tests/support")
    import clpt_control as clpt
    from all_backends import compare_backends

    def level(t, x, u, p):
        return np.logaddexp2(u[0], u[1])

    compare_backends(clpt.Block("level", output=level, inputs={"u": 2}, outputs={"y": 1}))
    """,
    (FUNCTIONS, MEASURED, "-k", "logaddexp2 or is_measured"),
)
OPERATIONS = {
    "operation": OPERATION,
    "elementary": ELEMENTARY,
    "function": FUNCTION,
    "ufunc": UFUNC,
}
