"""Prove an adaptive law of your own, or see where it fails.

The law is a block that takes any of the diagram's signals and makes alpha, K, Gamma.  By default
V is Eq. (24), each error weighed by the inverse of the gain with which the law adapts it, so that
the terms with e cancel; gains are read off the law's equations,

    alpha' = -gain e phi + rest,    K' = -gain z e + rest,    Gamma' = gain zc e + rest

`verdict` says what follows from V' along the closed loop.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from inspect import signature
from typing import Any

import control
import numpy as np
import sympy
from sympy.core.function import AppliedUndef

from ...arguments import Count, Seed, public
from ...blocks.laws.law import LEARNED, Law, Truth
from ...blocks.lyapunov import lyapunov_candidate, weighted
from ...engine.diagram.interconnection import Diagram, connect
from ...engine.diagram.wiring import read_anew
from ...engine.model.block import Block
from ...errors import DiagramError
from ...scenario.experiment import Scenario
from ...simulation.loops import loop_of
from ...simulation.user_parts import functions_of
from ...simulation.user_parts import law_block as as_law_block
from ..promises import truth_of
from .exact import tidied
from .invariant_loop import InvariantLoop
from .invariants import invariant_steps
from .judge import Verdict, judge
from .law_candidate import LawCandidate
from .paper_symbols import paper_name
from .steps import first_failure, worked_out
from .symbolic_loop import TIME, flat, refuse_no_value, symbolic_loop
from .theorem_loop import (
    mixed_candidate,
    rate_of_V,
    theorem_loop,
    theorem_scenario,
    tied,
    truth_in,
)

SLOWER = ", where the flow stays slower than the vehicle (hedging)"
ANY = "clpt.theory.lyapunov(diagram, V) judges a V of your own on any diagram"
Candidate = Callable[..., Block]  # makes V of the truth
Gains = Callable[[list], list]  # of V, made of the law's parameters


def fitted_V(law: Block, N: int) -> tuple[Candidate, Gains, bool]:
    """Return what makes V fitted to a law, of the truth, its gains, and whether V' > 0 refutes.

    The gains with which a law adapts alpha, K and Gamma are the factors of -e phi, -e z and e zc in
    their rates, without their sign; 1 where there is none.  V refutes the law where each that is
    not held has a gain, and a V of squares can take what is beside it; else V is a guess, and
    refutes nothing.  Where these products drive each other's rates, by a matrix that is symmetric
    and positive definite, V weighs the errors by its inverse.
    """
    alone = connect([law], external=list(law.input_ports), name=law.name)
    loop = symbolic_loop(alone, jumps=True)
    refuse_no_value(loop, law.name)
    nothing = np.zeros(2 * N, dtype=object)
    e, apart = np.array([sympy.Function(f"e_{i}", real=True)(TIME) for i in (1, 2)]), {}
    if {"x", "z"} <= set(loop.inputs):  # e may be written x - z
        apart = dict(zip(loop.inputs["x"], e + loop.inputs["z"], strict=True))
    with_phi, with_z, with_zc = (
        loop.inputs.get(u, nothing) for u in ("phi_x", "z", "zc")
    )
    products = [
        *np.ravel(np.outer(e, with_phi[:N])),
        *(e * with_z[:2]),
        *(-e * with_zc[:2]),
    ]
    learned = [m for port in LEARNED for m in np.ravel(loop.signals.get(port, nothing))]
    rates = [tidied(loop.derivative(sympy.sympify(m)).xreplace(apart)) for m in learned]
    gains, rests, refutes = list[sympy.Expr](), {}, True
    for state, rate, product in zip(learned, rates, products, strict=True):
        factor = -_factor(rate, product, {*loop.values})
        number = factor.xreplace(loop.values)
        refutes &= number != 0 or rate == 0
        gains.append(
            factor if number.is_positive else -factor if number else sympy.S.One
        )
        rests[state] = sympy.expand(rate + factor * product) / gains[-1]
    inverse = None
    if any(rest.has(*e) for rest in rests.values()):
        M = [[-_factor(rate, p, {*loop.values}) for p in products] for rate in rates]
        M = sympy.Matrix(M).xreplace(loop.values)
        if M.is_symmetric() and not M.is_diagonal() and M.is_positive_definite:
            inverse = M.inv()
    inputs = [
        s for port, symbols in loop.inputs.items() if port != "e" for s in symbols.flat
    ]
    still = {s: sympy.Dummy(real=True) for s in inputs}
    rests = {s: rest.xreplace(still) for s, rest in rests.items() if s.is_Symbol}
    refutes = refutes and len(rests) == len(learned) and inverse is None
    refutes = refutes and _weighed_by_squares(rests, {*loop.values, *still.values()})
    own, weights = (
        flat(loop.parameters[law.name]),
        gains if inverse is None else [*inverse],
    )

    def of(parameters: list) -> list[sympy.Expr]:
        pairs = zip(own, parameters, strict=True)
        names = {s: name for s, name in pairs if isinstance(s, sympy.Symbol)}
        return [weight.xreplace(names) for weight in weights]

    if inverse is not None:
        return partial(mixed_candidate, np.array(inverse, dtype=float)), of, refutes
    numbers = [float(gain.subs(loop.values)) for gain in gains]
    alpha, (K, Gamma) = (
        np.reshape(numbers[:-4], (2, N)),
        np.reshape(numbers[-4:], (2, 2)),
    )
    each = {"gain": alpha, "gain_K": K, "gain_Gamma": Gamma}

    def fitted(truth: Truth) -> Block:
        return lyapunov_candidate(
            "learned-flow", weighted([1.0] * 3, *truth)._replace(**each)
        )

    return fitted, of, refutes


def _weighed_by_squares(rests: dict, known: set) -> bool:
    """Return whether a V of squares can take what a law has beside its gains.

    It cannot where that holds e or time, as gains that change do, or states of the law's
    own, which need not come to every value, or where it weighs the errors in another way.
    """
    if any(rest.free_symbols - set(rests) - known for rest in rests.values()):
        return False
    slopes = {(a, b): sympy.diff(rest, b) for a, rest in rests.items() for b in rests}
    return all(
        sympy.expand(slope - slopes[b, a]) == 0 for (a, b), slope in slopes.items()
    )


def _factor(rate: sympy.Expr, product: sympy.Expr, parameters: set) -> sympy.Expr:
    """Return the factor of a product in a rate, made of parameters alone."""
    if product == 0:  # the law does not read a signal of it
        return sympy.S.Zero
    terms = [term / product for term in sympy.Add.make_args(rate)]
    known = (
        q for q in terms if not q.atoms(AppliedUndef) and q.free_symbols <= parameters
    )
    return sympy.Add(*known)


@public
def prove(
    law_block: Block | Diagram | control.NonlinearIOSystem,
    V: Candidate | None = None,
    points: Count = 10_000,
    seed: Seed = 0,
    invariants: Callable[..., dict] | None = None,
    semidefinite: Sequence[str] = (),
    losses: Callable[..., list[tuple]] | None = None,
    start: Mapping[str, Any] | None = None,
) -> Verdict:
    """Prove or refute an adaptive law by V' along the closed loop.

    Parameters
    ----------
    law_block : Block, control.NonlinearIOSystem or Diagram
        With outputs alpha[2N], K[2], Gamma[2] and inputs among the diagram's ports, such
        as e[2], phi_x[N], z[2], zc[2]; or a `closed_loop` with such a law, and nothing else of
        your own, nor a disturbance, noise, held gains or a limit of the speed without hedging.
    V : callable, optional
        A function of signals, as `lyapunov` takes it: ``lambda s: s.e @ s.e / 2 + ...``, which
        may ask for signals of the loop (``s.e``, ``s.alpha``, ``s.K``, ...), the truth
        (``s.theta``, ``s.KD``, ``s.GammaD``) and the law's parameters. Or a function of the truth,
        ``V(truth)`` or ``V(truth, parameters)``, that makes a Block with the output V[1].
        By default Eq. (24), each error weighed by the gain with which the
        law adapts it, or by the inverse of a matrix of gains.
    points : int, optional
        Random points at which the running blocks are called.
    seed : int, optional
        Of the random points.
    invariants : callable, optional
        ``invariants(states, parameters, truth)``, state -> what it is in the others, where they
        begin so; V' is then -e^T KD e less `losses`, and V has to be given.
    start : mapping, optional
        Initial values of the law's own states, by name, from which `invariants` hold. Default: 0.
    semidefinite : sequence of str, optional
        States that are symmetric positive semidefinite matrices; where V weighs errors by one,
        that it begins positive definite.
    losses : callable, optional
        ``losses(states, parameters, truth)``, what V' loses: products, tuples of factors that are
        not negative.

    Returns
    -------
    Verdict
        `status`: ``"proved"``, ``"bounded"``, ``"refuted"`` or ``"open"``; `residual`, what V'
        has beyond its fall; `point`, where V' > 0; and the `steps` that were tried. A law whose
        states jump is ``"refuted at a jump"`` where V rises there, however far off, and only
        ``"proved between jumps"`` where nothing is known of V there.

    Raises
    ------
    DiagramError
        If the law does not make alpha[2N], K[2] and Gamma[2], or has the name of a block that
        holds the truth.
    BlockError
        If its equations cannot be read.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> from clpt_control.blocks.laws.table import LAWS
    >>> clpt.theory.prove(LAWS["learned-flow"].of(2, gain=0.5), points=200).status
    'proved'
    """
    if isinstance(law_block, Diagram) and law_block.origin is not None:
        loop = loop_of(law_block)
        if beside := loop.changes.description or _beside(loop.scenario):
            raise DiagramError(
                f"{law_block.name}: has {beside}, so V' is not its law's alone; a law is judged in "
                f"the paper's own diagram without, or give it as a Block; {ANY}"
            )
        law_block = loop.changes.law or loop.scenario.law_block
        if loop.scenario.vehicle.max_speed is not None:
            more = (V, points, seed, invariants, semidefinite, losses, start)
            verdict = prove(law_block, *more)
            return replace(verdict, claim=f"{verdict.claim}{SLOWER}")
    if isinstance(law_block, control.NonlinearIOSystem):
        law_block = as_law_block(law_block)
    if not isinstance(law_block, Block):
        raise DiagramError(
            f"{law_block.name}: is a {type(law_block).__name__}; a law is judged in the paper's "
            f"own diagram, give it as a Block; {ANY}"
        )
    for field in law_block.parameters._fields:
        if paper_name(law_block.name, field) not in (None, "gamma"):
            raise DiagramError(
                f"{law_block.name}: its parameter {field} would be taken for what the paper's "
                "block of this name holds, which no law knows; give the law another name"
            )
    read_anew(law_block)
    N = functions_of(law_block)
    theorem_loop(N, "learned-flow", law_block=law_block)  # refuses what is no law
    with worked_out(law_block.name):
        if invariants is None:  # one V that does not fall refutes no law
            of_V = (
                fitted_V(law_block, N)
                if V is None
                else (_maker(V, law_block), None, False)
            )
            return judge(_candidate(law_block, N, *of_V, points, seed))
        if V is None:
            raise DiagramError(
                f"{law_block.name}: a law whose states keep relations needs its V"
            )
        make = _maker(V, law_block)
        part = {
            "invariants": invariants,
            "semidefinite": semidefinite,
            "losses": losses,
        }
        row = Law(law_block.name, rates=law_block.values, V_rate="-e^T KD e - losses")
        row = row.with_parts(part)
        case = InvariantLoop(row, N, blocks=(law_block, make), start=start or {})
        steps, (apart, existing) = (
            invariant_steps(row, points, case, seed),
            case.existing(),
        )
        failed = first_failure(steps)
        known = "proved" if existing.holds else f"proved {apart}"
        return Verdict(
            "open" if failed else known,
            failed or f"V' = {row.V_rate}",
            case.V,
            rate_of_V(case.loop).xreplace(case.tied),
            steps=(*steps, existing),
            residual=case.beside,
            diagram=case.loop.diagram,
        )


def _beside(scenario: Scenario) -> str:
    """Return what of a scenario adds to V' of its law, or takes from it, or nothing."""
    flow, fixes, limit = (
        scenario.flow,
        scenario.localization,
        scenario.vehicle.max_speed,
    )
    adds = {
        "a disturbance": flow.disturbance is not None,
        "a measured flow": flow.field is not None,
        "noise in its positions": fixes is not None and fixes.noise > 0,
        "a limit of its speed without hedging": limit is not None
        and not scenario.hedged,
        "K and Gamma that are held": not scenario.learning.adapt_gains,
    }
    return next((what for what, has in adds.items() if has), "")


def _candidate(
    law: Block, N: int, make: Candidate, gains: Gains | None, *more: Any
) -> LawCandidate:
    true = truth_of(theorem_scenario(N, "learned-flow"))
    candidate = make(true)
    diagram = theorem_loop(N, "learned-flow", law_block=law, candidate=candidate)
    loop = symbolic_loop(diagram, jumps=True)
    known = tied(loop, candidate, make, (true, truth_in(loop)))
    if gains is not None:
        p = loop.parameters[candidate.name]
        fields = (
            ("inverse",) if "inverse" in p._fields else ("gain", "gain_K", "gain_Gamma")
        )
        theirs = [s for field in fields for s in np.ravel(getattr(p, field))]
        known |= zip(theirs, gains(flat(loop.parameters[law.name])), strict=True)
    return LawCandidate(loop, candidate, law, known, *more)


def _maker(V: Candidate, law: Block) -> Candidate:
    """Return a function that makes a candidate of the truth, under a name that no block has.

    A candidate may ask for the law's parameters, too.
    """
    if isinstance(V, control.InputOutputSystem):
        raise DiagramError(
            f"{V.name}: is made, and would know one truth; give V(truth) or V(truth, parameters), "
            "a function that makes a Block with the output V[1]"
        )

    def make(truth: Truth) -> Block:
        block = V(*(truth, law.parameters)[: len(signature(V).parameters)])
        if not isinstance(block, Block) or block.output_ports != {"V": 1}:
            raise DiagramError(f"{block}: a candidate makes V[1] and nothing else")
        read_anew(block)
        return block.copy("candidate")

    try:
        make(truth_of(theorem_scenario(functions_of(law), "learned-flow")))
    except AttributeError:  # the truth alone has no signals
        return partial(_block_of_signals, V, law)
    return make


class LawSignals:
    """The signals, parameters and true values that a V of a law may ask for: s.e, s.theta."""

    def __init__(self, ports: Mapping[str, Any], signals: Any, parameters: Any):
        self._ports, self._signals, self._parameters = ports, signals, parameters

    def __getattr__(self, name: str) -> Any:
        if name in self._ports:
            return getattr(self._signals, name)
        if hasattr(self._parameters, name):
            return getattr(self._parameters, name)
        names = ", ".join([*self._ports, *self._parameters._fields])
        raise DiagramError(f"V asks for s.{name}; s has {names}")


def _block_of_signals(V: Callable[[Any], Any], law: Block, truth: Truth) -> Block:
    """Return V as a block, of a function of the loop's signals."""
    loop = theorem_loop(functions_of(law), "learned-flow", law_block=law)
    parts = [part for part in loop.syslist if part.output_ports != {"V": 1}]
    shapes = {port: s for part in parts for port, s in part.declared["outputs"].items()}
    shapes |= {"phi_x": ("N",), "phi_z": ("N",), "zc": (2,)}
    parameters = {**law.parameters._asdict(), **truth._asdict()}

    def block(ports: Mapping[str, Any], fields: Mapping[str, Any]) -> Block:
        return Block(
            "candidate",
            output=lambda t, x, u, p: {"V": V(LawSignals(ports, u, p))},
            inputs=ports,
            outputs={"V": 1},
            parameters=fields,
            shapes={"theta": (2, "N")} if "theta" in fields else {},
            sizes={"N": functions_of(law)},
        )

    record = block(shapes, parameters).array_record("output")
    ports, fields = (
        {name: every[name] for name in every if name in {*record.leaves(group)}}
        for group, every in (("u", shapes), ("p", parameters))
    )
    return block(ports, fields)
