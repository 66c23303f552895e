"""Every kind of block of the package, the paper's for several numbers of functions."""

import control
import numpy as np
import pytest
from loop_scenarios import LOOPS
from small_scenarios import paper_of

from clpt_control import parts
from clpt_control.paper.blocks import (
    clpe,
    disturbance,
    field,
    flow,
    learner,
    localization,
    lyapunov,
    reference,
    vehicle,
)
from clpt_control.paper.currents.plane import GriddedField
from clpt_control.paper.laws import consensus
from clpt_control.paper.laws.law import Gains, Truth
from clpt_control.paper.laws.table import LAWS

GAINS = {  # of alpha, K and Gamma, by the number of functions
    1: Gains(0.7, 0.4, 1.3, shared=False),
    2: Gains(0.7, 0.0, 0.0, shared=False),
    3: Gains(0.7, 0.7, 0.7, shared=True),
    5: Gains(0.7, 0.4, 1.3, shared=False),
}


def of_no_size():
    """Blocks of the paper without basis functions."""
    rng = np.random.default_rng(7)
    axes = [np.linspace(0, 90, 5), np.linspace(-4, 4, 6), np.linspace(-5, 5, 7)]
    grid = GriddedField(*axes, *rng.standard_normal((2, 5, 6, 7)))
    return [
        *(clpe.clpe(), vehicle.vehicle(), vehicle.vehicle(localization.TRUE)),
        *(vehicle.speed_limit(1.5), vehicle.hedging(), learner.learning_model()),
        learner.learning_model(hedged=True),
        *(
            reference.reference(rng.uniform(-3, 3, (n, 2)), dwell=1.7)
            for n in (1, 2, 7)
        ),
        reference.reference(reference.circle(3.0, 10), dwell=0.1),
        *(disturbance.disturbance(k, [0.3, -0.7], 1.3, 5.0) for k in disturbance.KINDS),
        *(
            localization.measurement(0.3, 1.3, 5.0),
            localization.fixes(0.3, 5.0, 0.4, 5.0),
        ),
        *(field.gridded_flow(grid), field.gridded_flow(grid, "clip", disturbed=True)),
        consensus.total_candidate(["a", "b", "c"]),
    ]


def of_size(N):
    """Blocks of the paper with N basis functions, and all laws."""
    rng = np.random.default_rng(N)
    a, b, theta = rng.uniform(-1, 1, (3, 2, N))
    KD, GammaD = rng.uniform(0.5, 2, (2, 2))
    basis = [
        rng.uniform(-3, 3, (N, 2)),
        *rng.uniform([[1], [0], [-3]], [[4], [2], [3]], (3, N)),
    ]
    weights = lyapunov.weighted([0.7] * 3, theta, KD, GammaD)
    yield from (
        flow.flow_basis("basis_x", "x", kernel, *basis) for kernel in flow.KERNELS
    )
    yield from (flow.true_flow(theta, disturbed) for disturbed in (False, True))
    functions = ("centers", "widths", "frequencies", "phases")
    named = dict(zip(functions, basis, strict=True))
    for kernel in flow.KERNELS:
        yield flow.own_true_flow(theta, kernel, named, kernel == "gaussian")
    yield from [
        *(flow.flow_basis("basis_z", "z", "exponential", *basis), flow.modeled_flow(a)),
        vehicle.vehicle_controller(a, KD, GammaD),
        vehicle.vehicle_controller(a, KD, GammaD, limited=True, position="z"),
        *(learner.learning_controller(N), learner.known_flow_injection(b, a)),
        learner.learned_flow_injection(a),
        *(clpe.error_system(N, KD), clpe.parameter_system(N, 0.7)),
    ]
    yield from (
        consensus.consensus_block("a", s, N, 0.4) for s in ([], ["b"], ["b", "c"])
    )
    yield from (
        lyapunov.lyapunov_candidate(law, weights) for law in lyapunov.CANDIDATES
    )
    for name, law in LAWS.items():
        scenario = paper_of(N, name)
        block = law.block(scenario.known_to_law._replace(gains=GAINS[N]))
        yield from (block, law.V(block.parameters, Truth(theta, KD, GammaD)))
        if name == "learned-flow":
            yield consensus.pulled_law(block)
        if law.at_fixes:
            yield law.block(
                scenario.with_values({"localization.latency": 2.0}).known_to_law
            )


def plant(dt):
    return control.ss(
        [[0.5, 0.2], [-0.3, 0.4]], [[0], [1]], np.eye(2), [[0.1], [0]], dt
    )


TIMES = ({"lag": 0.1}, {"dt": 0.1})
COVARIANCES = [[1, 0.2], [0.2, 0.5]], [[0.1, 0.01], [0.01, 0.3]]
INERTIA = [[60, 0, 0], [0, 90, 5], [0, 5, 20]]
PARTS = {  # each part, continuous and sampled: its arguments by name, the first ones by place
    "backlash": [((0.4,), {"signals": 2, **time}) for time in TIMES],
    "dead_zone": [((-0.3, 0.2), {"signals": 2})],
    "delay": [((0.7, 3), {"signals": 2}), ((0.75,), {"dt": 0.25, "signals": 2})],
    "hold": [((0.5,), {"signals": 2})],
    "kalman_filter": [
        ((plant(dt), *COVARIANCES), {"P0": np.eye(2)}) for dt in (0, 0.1)
    ],
    "lag": [((2.0, 3.0), {"signals": 2, "u": "v_c", "y": "v_x"})],
    "lookup_table": [(([-1, 0, 3], [0, 10, 20]), {"signals": 2})],
    "noise": [((0.3, 1.3), {"signals": 3, "seed": 5})],
    "observer": [((plant(dt), [[0.4, 0], [0.1, 0.2]]), {}) for dt in (0, 0.1)],
    "pid": [
        ((2.0, 0.5, 0.3), {"low": -1, "high": 2, "dt": dt, "signals": 2})
        for dt in (None, 0.1)
    ],
    "planar_vehicle": [((INERTIA, np.diag([30, 60, 20]), np.diag([20.0, 40, 10])), {})],
    "point_vehicle": [(([60, 90], 30, 20), {})],
    "rate_limit": [((0.5, 0.7), {"signals": 2, **time}) for time in TIMES],
    "relay": [((0.3, -0.2), time) for time in TIMES],
    "saturation": [((-1, [0.5, 1.0]), {"signals": 2})],
    "thrusters": [(([(-0.8, -0.2), (-0.8, 0.2)], [0.1, 0], -10, 20, 0.3), {})],
}


def shelf():
    """Every public name of `clpt.parts` with its arguments in PARTS."""
    for name in parts.__all__:
        yield from (
            getattr(parts, name)(*given, **named) for given, named in PARTS[name]
        )


def functions(block):
    """The equations of a block."""
    return block.output_function, block.update_function, block.jump_function


def of_loops(known):
    """Blocks of the paper's loop with other equations than the known ones."""
    tested = {functions(block) for block in known}
    for _, blocks in LOOPS:
        for block in blocks:
            if block.name != "adaptation" and functions(block) not in tested:
                tested.add(functions(block))
                yield block


MADE = [*of_no_size(), *shelf(), *of_size(3)]
MADE += of_loops(MADE)
RARE = [block for N in (1, 2, 5) for block in of_size(N)]  # asked by `make test-slow`
BLOCKS = [*MADE, *RARE]
EACH = [
    pytest.param(one, id=one.name, marks=[pytest.mark.slow] * (k >= len(MADE)))
    for k, one in enumerate(BLOCKS)
]
