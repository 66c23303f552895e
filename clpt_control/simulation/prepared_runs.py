"""Prepared runs: a diagram that is run many times, as a fit or a search does.

`prepare` reads and compiles a diagram once.  Each call takes other parameters, inputs and initial
states, and returns arrays.  It does without the Dataset of `simulate`, and compares the run with
the functions in Python at the first calls and then at one of many.
"""

from collections.abc import Mapping
from typing import Any, NamedTuple

import control
import numpy as np

from ..base.arguments import known, public
from ..base.errors import SimulationError
from ..base.labelled import unlabelled
from ..engine.codegen.directional_derivatives import is_remade
from ..engine.diagram.wiring import Params
from ..engine.model.system import System
from .diagram_runs import DiagramRun, fields_of
from .requests import Request, request_of
from .run_cache import diagram_key

ALWAYS = 8  # first calls, each compared with Python
SELDOM = 64  # later one of so many calls is compared


class Samples(NamedTuple):
    """States (nt, nstates) and outputs (nt, noutputs) of a prepared run, at its times."""

    states: np.ndarray
    outputs: np.ndarray


class PreparedRun:
    """A diagram that is ready to run; `prepare` returns it.

    ``run(initial_state, inputs, params)`` returns `Samples`.  An argument that is left out has the
    value that `prepare` was given.
    """

    def __init__(self, request: Request, params: Mapping[str, Any]):
        self._request = request
        self._calls = 0
        self._engine: str | None = None
        self._params = dict(params)  # of calls that leave them out
        self._make(self._params)

    def _make(self, params: Mapping[str, Any]) -> None:
        """Read and compile the diagram."""
        self._made_for = params
        arguments = self._arguments(params)
        self._key = diagram_key(*arguments)
        with self._request.drawn_around():
            self._run = run = DiagramRun(*arguments, varied=tuple(params))
        self._is_quick = run.runner.engine == "native" and run.runner.nstates
        # parameters with which code is made anew
        self._fixed = {key for key in params if self._is_quick and self._is_fixed(key)}

    def _arguments(self, params: Mapping[str, Any]) -> tuple[Any, Any, Any, Any]:
        """Return the arguments of a `DiagramRun`."""
        return self._request.diagram, params, self._request.sizes, self._engine

    def _is_fixed(self, key: str) -> bool:
        """Return whether code is made anew for another value of a parameter."""
        wiring = self._run.wiring
        fields = fields_of(wiring, [key])
        blocks, name = {k for k, _ in fields}, key.rpartition(".")[2]
        for k, (_, block) in enumerate(wiring.blocks):
            inner = block.unsampled  # may have a list of this name
            if k not in blocks and isinstance(inner, System) and inner.mentions(name):
                return True
        return not fields or is_remade(wiring, fields)

    @public
    def __call__(
        self, initial_state: Any = None, inputs: Any = None, params: Params = None
    ) -> Samples:
        """Run from an initial state, with inputs and parameters; return states and outputs."""
        request = self._request
        key = diagram_key(*self._arguments(self._made_for))
        if key is None or self._key is None or key[0] != self._key[0]:
            # the diagram, or what its functions read, has changed
            self._make(self._made_for)
        if initial_state is not None:
            request = request.with_state(initial_state)
        if inputs is not None:
            request = request.with_inputs(inputs)
        runner = self._run.runner
        if params or self._made_for is not self._params:
            runner = self._runner_with(params or {})
        is_compared = True
        if self._is_quick:
            runner.comparisons, self._calls = self._calls, self._calls + 1
            is_compared = runner.comparisons < ALWAYS or not runner.comparisons % SELDOM
        solution, signals = self._run.solve(request, runner, is_compared)
        if solution.engine == "python":
            self._engine = "python"  # of the calls that follow
        times = request.times
        if len(solution.t) < len(times) or solution.t[-1] != times[-1]:
            raise SimulationError(
                f"{self._run.name}: the run ended at t = {solution.t[-1]:.9g}, before the last of "
                f"its times: {solution.message}. Use simulate"
            )
        outputs = signals[:, : len(self._run.wiring.outputs)]
        skipped = request.skipped
        return Samples(solution.x[skipped:], outputs[skipped:])

    def _runner_with(self, params: Mapping[str, Any]) -> Any:
        """Return the runner with parameters; one that code was made for is compiled again."""
        for key, value in params.items():
            if key not in self._params:
                raise SimulationError(
                    f"params: {key} was not given to prepare. {known(key, self._params)}"
                )
            shape = np.shape(self._params[key])
            array = unlabelled(f"params['{key}']", value)
            if array.shape != shape:
                raise SimulationError(
                    f"params['{key}'] = {value}: must have the shape {shape}, as in prepare"
                )
        every = {**self._params, **params}
        if not self._is_quick:
            return DiagramRun(*self._arguments(every)).runner
        if any(not _same(every[key], self._made_for[key]) for key in self._fixed):
            self._make(every)
            return self._run.runner
        runner = self._run.runner
        return runner.with_parameters(runner.wiring.parameters(every))


def _same(value: Any, other: Any) -> bool:
    return type(value) is type(other) and np.array_equal(value, other)


@public
def prepare(
    system: control.InputOutputSystem,
    timepts: Any,
    inputs: Any = None,
    initial_state: Any = None,
    params: Params = None,
    *,
    rtol: float | None = None,
    atol: float | None = None,
    method: str | None = None,
    max_step: float = np.inf,
) -> PreparedRun:
    """Prepare a diagram that is run many times.

    Parameters
    ----------
    system : control.InputOutputSystem
        A diagram of continuous time.
    timepts : array_like
        Times of the samples.
    inputs, initial_state : optional
        As `simulate` takes them, for calls that leave them out.
    params : mapping, optional
        Call-time parameters, ``{"k": 1.0}``. A call may change those that are named here.
    rtol, atol, method, max_step : optional
        As `simulate` takes them.

    Returns
    -------
    PreparedRun
        ``run(initial_state, inputs, params)`` returns arrays: ``states`` of shape (nt, nstates) and
        ``outputs`` (nt, noutputs). A dict of states changes those that it names. The first 8 calls,
        and one of 64 after them, are compared with the functions in Python. A function that has
        changed counts at the next call.

    Raises
    ------
    SimulationError
        If the run cannot go on, ends before the last time, or an argument is not allowed.

    Examples
    --------
    >>> import control
    >>> import clpt_control as clpt
    >>> decay = control.nlsys(lambda t, x, u, p: [-p["k"] * x[0]], None, inputs=0, states=1,
    ...                       params={"k": 1.0}, name="decay")
    >>> run = clpt.prepare(decay, [0.0, 1.0], initial_state=[1.0], params={"k": 1.0})
    >>> float(run(params={"k": 2.0}).states[-1, 0].round(6))
    0.135335
    """
    if system.dt:
        raise SimulationError(
            f"{system.name}: is a diagram of discrete time, which prepare does not take. "
            "Use simulate"
        )
    request = request_of(
        system,
        timepts,
        inputs,
        initial_state,
        rtol=rtol,
        atol=atol,
        method=method,
        max_step=max_step,
    )
    return PreparedRun(request, params or {})
