"""Rodas5P, the method for stiff equations: its tableau and its formulas.

A Rosenbrock method of order 5,

    (I / (h g) - f_x) U_s = f(t + c_s h, x + sum_j a_sj U_j) + sum_j C_sj / h U_j + d_s h f_t
    new state = the last argument + U_8, whose error U_8 estimates

Eight stages, stiffly accurate, A- and L-stable, with dense output of order 4, which is far less
exact than the ends of steps where the equations are very stiff; so steps end at samples.  The
matrix is factored by `implicit`, where each U_s takes the place of the rate of its stage.

Steinebach, Construction of Rosenbrock-Wanner method Rodas5P and numerical benchmarks within the
Julia Differential Equations package, BIT Numerical Mathematics 63, 2023, 27; the form above is
that of Hairer and Wanner, Solving Ordinary Differential Equations II, 1996, section IV.7.
"""

from functools import partial

from numpy import maximum, minimum, power

from ..solver.solver_layout import (
    ADDEND,
    ARGUMENT,
    SOLVED,
    STATE,
    STEP_SIZE,
    TIME_SLOPE,
    TRIAL_SIZE,
)
from .formulas import (
    Formula,
    New,
    StepTape,
    accept_or_reject,
    attempt,
    fmuladd,
    in_order,
    interpolant_terms,
    mean_square,
    stage_time,
    weighted_sum,
)

GAMMA = 0.21193756319429014
# fmt: off
A = (
    (),
    (3.0,),
    (2.849394379747939, 0.45842242204463923),
    (-6.954028509809101, 2.489845061869568, -10.358996098473584),
    (2.8029986275628964, 0.5072464736228206, -0.3988312541770524, -0.04721187230404641),
    (-7.502846399306121, 2.561846144803919, -11.627539656261098, -0.18268767659942256,
     0.030198172008377946),
)  # a stage behind these has the argument of the one before it, and 1
C = (
    (),
    (-14.155112264123755,),
    (-17.97296035885952, -2.859693295451294),
    (147.12150275711716, -1.41221402718213, 71.68940251302358),
    (165.43517024871676, -0.4592823456491126, 42.90938336958603, -5.961986721573306),
    (24.854864614690072, -3.0009227002832186, 47.4931110020768, 5.5814197821558125,
     -0.6610691825249471),
    (30.91273214028599, -3.1208243349937974, 77.79954646070892, 34.28646028294783,
     -19.097331116725623, -28.087943162872662),
    (37.80277123390563, -3.2571969029072276, 112.26918849496327, 66.9347231244047,
     -40.06618937091002, -54.66780262877968, -9.48861652309627),
)
TIMES = (  # c
    0.0, 0.6358126895828704, 0.4095798393397535, 0.9769306725060716, 0.4288403609558664,
    1.0, 1.0, 1.0,
)
OF_TIME = (  # d
    GAMMA, -0.42387512638858027, -0.3384627126235924, 1.8046452872882734, 2.325825639765069,
    0.0, 0.0, 0.0,
)
BETWEEN = (  # terms of the interpolant: y0 + s (y1 - y0 + (1 - s) (k_1 + s (k_2 + s k_3)))
    (25.948786856663858, -2.5579724845846235, 10.433815404888879, -2.3679251022685204,
     0.524948541321073, 1.1241088310450404, 0.4272876194431874, -0.17202221070155493),
    (-9.91568850695171, -0.9689944594115154, 3.0438037242978453, -24.495224566215796,
     20.176138334709044, 15.98066361424651, -6.789040303419874, -6.710236069923372),
    (11.419903575922262, 2.8879645146136994, 72.92137995996029, 80.12511834622643,
     -52.072871366152654, -59.78993625266729, -0.15582684282751913, 4.883087185713722),
)
# fmt: on


def weights(s: int) -> tuple[float, ...]:
    """Return a_sj of a stage, counted from 0; of stage 8 they make the new state."""
    return A[s] if s < len(A) else (*A[-1], *(1.0,) * (s - len(A) + 1))


def _stage_implicit(number: int, s: StepTape) -> New:
    """The argument of a stage, counted from 0, and the term added to its rate on the right."""
    h = s.lane(TRIAL_SIZE)
    addend = (OF_TIME[number] * h) * s.z(TIME_SLOPE)
    argument = s.z(STATE)
    if number:
        total = weighted_sum(s, C[number], SOLVED)
        addend = fmuladd(1.0 / h, total, addend)
        argument = argument + weighted_sum(s, weights(number), SOLVED)
    rows = {ARGUMENT: argument, ADDEND: addend}
    return rows, stage_time(s, TIMES[number])


def _control_implicit(s: StepTape) -> New:
    """The new state, the estimate of its error, of order 5, and the length of the next step."""
    stages = len(C)
    change = weighted_sum(s, weights(stages), SOLVED)
    state = s.z(STATE) + change
    largest = maximum(abs(s.z(STATE)), abs(state))
    error = s.z(SOLVED + stages - 1)
    error = error / s.tolerance(largest)
    square = mean_square(s, error)
    factor = 0.9 * power(maximum(square, 1e-30), -0.1)  # error^(-1/5)
    # the step before may be short because of a sample, or the end of a segment
    least = minimum(s.lane(TRIAL_SIZE) * factor, s.lane(STEP_SIZE))
    return {ARGUMENT: state}, accept_or_reject(s, square, factor, 6.0, least)


def _dense_implicit(s: StepTape) -> New:
    """The terms of the interpolant."""
    k1, k2, k3 = [weighted_sum(s, weights, SOLVED) for weights in BETWEEN]
    delta = s.z(ARGUMENT) - s.z(STATE)
    return interpolant_terms(s, delta, k1, k2 + k3, -k3), {}


def formulas() -> list[Formula]:
    """Return the formulas in the solver's order."""
    stages: list[Formula] = [
        partial(_stage_implicit, number) for number in range(len(C))
    ]
    return in_order(
        _control_implicit,
        _dense_implicit,
        stages,
        attempt=partial(attempt, diagonal=GAMMA),
    )
