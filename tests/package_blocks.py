"""Every kind of block of the package, for several numbers of functions, by name."""

import control
import numpy as np
import pytest

from clpt_control import parts
from clpt_control.blocks import (
    clpe,
    consensus,
    disturbance,
    field,
    flow,
    learner,
    localization,
    lyapunov,
    reference,
    vehicle,
)
from clpt_control.blocks.laws.law import Gains, Truth
from clpt_control.blocks.laws.table import LAWS
from clpt_control.currents.plane import GriddedField
from clpt_control.theory.proving.theorem_loop import theorem_scenario

SIZES = (1, 2, 3, 5)
GAINS = {
    "one": Gains(0.7, 0.7, 0.7, one=True),
    "each": Gains(0.7, 0.4, 1.3, one=False),
    "held": Gains(0.7, 0.0, 0.0, one=False),
}


def basis_parameters(rng, N):
    return (
        rng.uniform(-3, 3, (N, 2)),
        rng.uniform(1, 4, N),
        rng.uniform(0, 2, N),
        rng.uniform(-3, 3, N),
    )


def grid(rng):
    axes = [np.linspace(0, 90, 5), np.linspace(-4, 4, 6), np.linspace(-5, 5, 7)]
    return GriddedField(*axes, *rng.standard_normal((2, 5, 6, 7)))


def package_blocks():
    rng = np.random.default_rng(7)
    yield "clpe", clpe.clpe()
    yield "vehicle", vehicle.vehicle()
    yield "learning_model", learner.learning_model()
    yield "learning_model-hedged", learner.learning_model(hedged=True)
    yield "speed_limit", vehicle.speed_limit(1.5)
    yield "hedging", vehicle.hedging()
    for count in (1, 2, 7):
        points = rng.uniform(-3, 3, (count, 2))
        yield f"reference-{count}", reference.reference(points, dwell=1.7)
    yield "reference-circle", reference.reference(reference.circle(3.0, 10), dwell=0.1)
    for kind in disturbance.KINDS:
        yield (
            f"disturbance-{kind}",
            disturbance.disturbance(kind, [0.3, -0.7], period=1.3, seed=5.0),
        )
    yield "measurement", localization.measurement(0.3, 1.3, 5.0)
    yield "fixes", localization.fixes(0.3, 5.0, 0.4, 5.0)
    yield "vehicle-measured", vehicle.vehicle(localization.TRUE)
    for outside in ("raise", "clip", "stop"):
        yield f"field-{outside}", field.gridded_flow(grid(rng), outside)
        yield f"field-{outside}-disturbed", field.gridded_flow(grid(rng), outside, disturbed=True)
    yield "V-of-a-team", consensus.total_candidate(["a", "b", "c"])
    for N in SIZES:
        a, b, theta = rng.uniform(-1, 1, (3, 2, N))
        KD, GammaD = rng.uniform(0.5, 2, (2, 2))
        for kernel in flow.KERNELS:
            for name, position in (("basis_x", "x"), ("basis_z", "z")):
                yield (
                    f"{name}-{kernel}-{N}",
                    flow.flow_basis(name, position, kernel, *basis_parameters(rng, N)),
                )
        for disturbed in (False, True):
            yield f"true_flow-{disturbed}-{N}", flow.true_flow(theta, disturbed)
        yield f"modeled_flow-{N}", flow.modeled_flow(a)
        yield f"vehicle_controller-{N}", vehicle.vehicle_controller(a, KD, GammaD)
        at_z = vehicle.vehicle_controller(a, KD, GammaD, position="z")
        yield f"vehicle_controller-z-{N}", at_z
        yield f"vehicle_controller-limited-{N}", vehicle.vehicle_controller(a, KD, GammaD, True)
        yield f"learning_controller-{N}", learner.learning_controller(N)
        yield f"injection-known-{N}", learner.known_flow_injection(b, a)
        yield f"injection-learned-{N}", learner.learned_flow_injection(a)
        for name, law in LAWS.items():
            scenario = theorem_scenario(N, name)
            for way, gains in GAINS.items():
                block = law.block(scenario.known_to_law._replace(gains=gains))
                yield f"law-{name}-{way}-{N}", block
                if law.at_fixes:
                    late = scenario.with_values({"localization.latency": 2.0})
                    yield f"law-{name}-late-{way}-{N}", law.block(late.known_to_law)
                if way == "one":
                    yield f"V-{name}-{N}", law.V(block.parameters, Truth(theta, KD, GammaD))
        yield f"error_system-{N}", clpe.error_system(N, KD)
        yield f"parameter_system-{N}", clpe.parameter_system(N, 0.7)
        for neighbours in ([], ["b"], ["b", "c"]):
            block = consensus.consensus_block("a", neighbours, N, 0.4)
            yield f"consensus-{len(neighbours)}-{N}", block
        learned = LAWS["learned-flow"].block(theorem_scenario(N, "learned-flow").known_to_law)
        yield f"law-in-a-team-{N}", consensus.pulled_law(learned)
        for law in lyapunov.CANDIDATES:
            p = lyapunov.weighted([0.7] * 3, theta, KD, GammaD)
            yield f"lyapunov-{law}-{N}", lyapunov.lyapunov_candidate(law, p)


def shelf():
    """Each part, continuous and sampled, of one signal and of two."""
    yield "saturation", parts.saturation(-1, [0.5, 1.0], signals=2)
    yield "dead_zone", parts.dead_zone(-0.3, 0.2, signals=2)
    yield "lookup_table", parts.lookup_table([-1, 0, 3], [0, 10, 20], signals=2)
    yield "lag", parts.lag(2.0, 3.0, signals=2, u="v_c", y="v_x")
    yield "delay-pade", parts.delay(0.7, 3, signals=2)
    yield "delay-sampled", parts.delay(0.75, dt=0.25, signals=2)
    yield "hold", parts.hold(0.5, signals=2)
    for way, given in (("lag", {"lag": 0.1}), ("sampled", {"dt": 0.1})):
        yield f"rate_limit-{way}", parts.rate_limit(0.5, 0.7, signals=2, **given)
        yield f"backlash-{way}", parts.backlash(0.4, signals=2, **given)
        yield f"relay-{way}", parts.relay(0.3, -0.2, **given)
    for way, dt in (("continuous", None), ("sampled", 0.1)):
        yield f"pid-{way}", parts.pid(2.0, 0.5, 0.3, -1, 2, dt=dt, signals=2)
        plant = control.ss(
            [[0.5, 0.2], [-0.3, 0.4]], [[0], [1]], [[1, 0], [1, 2]], [[0.1], [0]], dt or 0
        )
        yield f"observer-{way}", parts.observer(plant, [[0.4, 0], [0.1, 0.2]])
        covariances = [[1, 0.2], [0.2, 0.5]], [[0.1, 0.01], [0.01, 0.3]]
        yield f"kalman_filter-{way}", parts.kalman_filter(plant, *covariances, P0=np.eye(2))
    yield "noise", parts.noise(0.3, 1.3, signals=3, seed=5)
    yield "point_vehicle", parts.point_vehicle([60, 90], 30, 20)
    M, Q = [[60, 0, 0], [0, 90, 5], [0, 5, 20]], np.diag([20.0, 40, 10])
    yield "planar_vehicle", parts.planar_vehicle(M, np.diag([30, 60, 20]), Q)
    yield "thrusters", parts.thrusters([(-0.8, -0.2), (-0.8, 0.2)], [0.1, 0], -10, 20, 0.3)


BLOCKS = dict(package_blocks()) | {f"parts.{name}": block for name, block in shelf()}
SIZE_OF_WAY = {"one": 3, "each": 1, "held": None}  # a law's gains -> functions of `make test`
GAINS_APART = ("law-learned-flow-each", "law-composite-memory-each", "law-concurrent-each")
RARELY = ("field-clip-disturbed", "field-raise")  # the other two have both halves of each


def often(case):
    """Whether `make test` asks this block; `make test-slow` asks all."""
    kind, _, N = case.rpartition("-")
    if not N.isdigit() or kind == "reference":
        return case not in RARELY
    way = kind.rpartition("-")[2]
    if way in SIZE_OF_WAY:
        return SIZE_OF_WAY[way] == int(N) and (way != "each" or kind in GAINS_APART)
    return int(N) == 3


EACH = [pytest.param(name, marks=() if often(name) else pytest.mark.slow) for name in BLOCKS]
