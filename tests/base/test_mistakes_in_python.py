"""Mistakes in Python: one sentence names the argument, the value and a remedy that works."""

import re

import control
import numpy as np
import pytest
from error_sentences import says
from test_arguments import OF_FIXES

import clpt_control as clpt

parts = clpt.parts
NAN, INF = float("nan"), float("inf")
TIMES = np.linspace(0.0, 2.0, 21)
PEN = control.nlsys(
    lambda t, x, u, p: [x[1], -p["g"] * np.sin(x[0]) - p["d"] * x[1] + u[0]],
    states=["angle", "rate"],
    inputs=["torque"],
    outputs=["angle", "rate"],
    params={"g": 9.81, "d": 0.5},
    name="pen",
)
PLANT = control.ss([[0, 1], [-1, -1]], [[0], [1]], [[1, 0]], 0, inputs="f", outputs="q")
SHORT = clpt.paper_scenario().with_values({"run.duration": 20})
BLOW_UP = clpt.Block("up", update=lambda t, x, u, p: x.x**2, states={"x": 1})
TWO = parts.lag(1, signals=2)
LIMITED = clpt.connect(
    [parts.saturation(-1, 1, y="u", u="c"), parts.lag(1)], external="c"
)
AT_SEA = clpt.simulate(SHORT.with_values({"origin": [36.7, -122.1]}))
RUN = clpt.simulate(PEN, TIMES, 0.0, [1, 0])


def runs():
    """Return two runs by name."""
    run = clpt.simulate(SHORT)
    return {"a": run, "b": run}


def prepared(*given, **named):
    return clpt.prepare(PEN, TIMES, 0.0, [1, 0], {"d": 0.5})(*given, **named)


def called(block, **fields):
    """Run a block with other values of its parameters."""
    params = {f"{block.name}.{field}": value for field, value in fields.items()}
    return clpt.simulate(block, [0, 1], 0.0, params=params)


def estimator():
    """Return an estimator at its first fix."""
    found = clpt.currents.FlowEstimator(OF_FIXES)
    found.fix(1777593600.0, 36.7, -122.1)
    return found


def fitted(start):
    data = {"angle": RUN.angle.values}
    return clpt.fit_parameters(PEN, data, {"g": start}, TIMES, initial_state=[1, 0])


def vary(**named):
    return clpt.run_ensemble(PEN, {"d": [0.1, 0.2]}, timepts=TIMES, **named)


MISTAKES = """
clpt.currents.flow_estimate(clpt.gliders.sample_dives(), OF_FIXES.with_values({"basis.widths": [8.0]})) -> m wide: check units.length and basis.widths
clpt.simulate(PEN, TIMES, stop=lambda x: x[0]) -> stop: must take t, outputs and inputs, as lambda t, y, u: y[0] - 1
clpt.save_run(vary(), "a.nc") -> this is an ensemble. Write it by to_netcdf, a grid of members by unstack().to_netcdf
clpt.export(SHORT, "a.fmu", single=True) -> in single precision
clpt.replay([1]) -> clpt.replay: is a module. Call one of clpt.replay.
SHORT.with_values({"basis.phases": [0, 90, 0]}) -> basis.phases: are radians, at most 2 pi
clpt.simulate(PEN, TIMES, 0, [1, 0], rtol=5) -> rtol = 5: must be a number, 0 or more and below 1, or beside a max_step
clpt.run_ensemble(PEN, {"d": ["1", "2"]}, timepts=TIMES) -> d = ["1", "2"]: each value must be a number
clpt.run_ensemble(PEN, {"d": [True, False]}, timepts=TIMES) -> vary: d = [True, False]: must be
parts.pid(0.8, 0.03, 2.0, 100) -> pid: too many positional arguments
parts.thrusters([[0, 1], [1, 0]], [0, 90], -1, 1, 0.1) -> angles = [0, 90]: is in radians, within a turn. Give np.radians(angles)
bool(clpt.lyapunov(PEN, lambda s: s.angle**2)) -> a verdict is no truth value. Ask verdict.status == 'proved'
setattr(SHORT.run, "duration", 40) -> duration: a scenario stays as it is. Make another by scenario.with_values
clpt.Block("b", update=lambda x, t, u, p: -x[0], states={"x": 1}) -> Its arguments are t, x, u, p
clpt.Block("b", update=lambda t, x, u: [0.0], states={"x": 1}) -> but 4 were given. Its arguments are t, x, u, p
clpt.lyapunov(PEN, within={"angle": 1.0}) -> must be a dict of lists of numbers by name or None, such as {'angle': (-1.0, 1.0)}
clpt.lyapunov(PEN, lambda s: s.angle**2, where={"d": (0.1, 1)}) -> where: d is a parameter. Make it an input
clpt.lyapunov(PEN, lambda s: 1.0) -> V = 1: has no state. Give one: lambda s: s.x**2
clpt.lyapunov(PEN, lambda x, u: x) -> a function of signals takes one argument: lambda s: s.x**2
clpt.lyapunov(PEN, lambda s: s.angle**2, where={"torque": 3}) -> or None by name or None, such as {'torque': (-1.0, 1.0)}
clpt.verify(PEN, [0, 1], None, [0, 0], by="3: angle < 1") -> or functions or None, such as (3.0, 'rate < 1')
clpt.verify(PEN, [0, 1], None, [0, 0], always=lambda s: s.angle < 3) -> where the specification holds, such as 0.9 - s.level
clpt.simulate(BLOW_UP, [0, 2], 0.0, [1.0]) -> x[0] of block up has grown to
clpt.simulate(BLOW_UP, [0, 2], 0.0, [1.0, 2.0]) -> must have 1 finite number; it has shape (2,)
clpt.Block("b", update=print, states=["x"]) -> by name or None, such as {'x': 1}
clpt.fit_parameters(parts.lag(1), {"y": [0.0, 0.1]}, {"gain": 1.0}, [0, 1]) -> Did you mean 'lag.gain'?
clpt.fit_parameters(PEN, __import__("pandas").DataFrame({"time": TIMES, "angle": ["low"] * len(TIMES)}), {"d": 1.0}) -> data: column 'angle' has texts. Give numbers
clpt.verify(parts.lag(1), TIMES, 0, 0, params={"lag.gain": [0.4, 0.6]}, always="y < 1") -> is a pair, such as (0.8, 1.2)
clpt.export(parts.lag(1), "lag.fmu", single=True) -> a program of a part or in single precision
estimator().forecast([(3600.0, 0.0, 0.0)]) -> in s since 1970
estimator().fix(np.datetime64("2026-05-02"), 36.7, -122.1) -> s since 1970 UTC
SHORT.with_values({"learning.leak": 1.0}) -> did you mean learning.sigma.leak or switching_sigma.leak
clpt.simulate(TWO, TIMES, [2.0]) -> inputs: shape (1,): give (2,
clpt.simulate(TWO, TIMES, {"u": [2.0]}) -> has 1 rows. Give 2, one per signal
clpt.lyapunov(PEN, np.eye(2)) -> an Expr or None, such as lambda s: s.x**2 + s.y**2
clpt.verify(PEN, [0, 1], None, [0, 0], within={"d": 0.1}, always="angle < 1") -> within = {'d': 0.1}: must be a number or None
clpt.currents.flow_estimate("fixes.csv") -> clpt.gliders.read_dives('dives.csv')[0] is a list of dives
clpt.fit_parameters(parts.lag(1), {1: [0.0, 0.1]}, {"lag.gain": 1.0}, [0, 1]) -> data: 1 is not an output
clpt.run_ensemble(PEN, {"pen.d": [0.4, 0.6]}, 100, timepts=[0, 1]) -> A range is '0.4:0.6'
clpt.fit_parameters(PEN, None, ["d"]) -> must be a dict of values by name, such as {'k': (start, low, high)}
parts.lag(INF) -> lag: lag = inf: must be finite
parts.lag(1, gain=NAN) -> lag: gain = nan: must be finite
parts.lag(1, gian=2) -> lag: gian= is not an argument. Did you mean 'gain'?
parts.pid(INF) -> pid: kp = inf: must be finite
parts.pid(1, INF) -> pid: ki = inf: must be finite
parts.pid(1, kd=1, filter=INF) -> pid: filter = inf: must be finite
parts.pid(1, low=NAN) -> pid: low = nan: must be a number
parts.pid(1, Ki=2) -> pid: Ki= is not an argument. Did you mean 'ki'?
parts.pid(1, fliter=2) -> pid: fliter= is not an argument. Did you mean 'filter'?
parts.pid(1, umax=2) -> pid: umax= is not an argument. Give the limits as low=, high=
parts.pid(1, Y="level") -> pid: has no port or argument 'Y'. Did you mean 'y'?
parts.pid(1, y=3) -> pid: y = 3: must be a name, a text
parts.delay(INF) -> delay: delay = inf: must be finite
parts.delay(1, dt=INF) -> delay: dt = inf: must be finite
parts.delay(1, ordr=3) -> delay: ordr= is not an argument. Did you mean 'order'?
parts.delay(1e9, dt=1e-12) -> delay: delay = 1000000000.0, dt = 1e-12, signals = 1: 1e+21 signals; at most 1,000,000 are allowed. Give a longer dt
parts.delay(1e9, dt=1e-312) -> inf signals; at most
parts.delay(1, order=10**6) -> delay: order = 1000000: must be at most 500. Give dt
parts.lag(1, signals=10**9) -> lag: signals = 1000000000: 1e+09 signals; at most 1,000,000
parts.noise(1, 0.1, signals=10**10) -> noise: signals = 10000000000: 1e+10 signals; at most
parts.hold(1, 10**9) -> hold.u = (1000000000,): 1e+09 signals; at most
clpt.Block("b", update=print, states={"x": (10**6, 10**6)}) -> b.x = (1000000, 1000000): 1e+12 signals
parts.hold(INF) -> hold: dt = inf: must be finite
parts.noise(INF, 0.1) -> noise: std = inf: must be finite
parts.noise(1, INF) -> noise: period = inf: must be finite
parts.noise(1, 0.1, sed=3) -> noise: sed= is not an argument. Did you mean 'seed'?
parts.backlash(INF, lag=0.1) -> backlash: width = inf: must be finite
parts.rate_limit(1, lag=INF) -> rate_limit: lag = inf: must be finite
parts.relay(INF, -1, lag=0.1) -> relay: on = inf: must be finite
parts.relay(1, -1, 0, INF, lag=0.1) -> relay: high = inf: must be finite
parts.dead_zone(1, -1) -> dead_zone: low = 1: must be below high = -1
parts.observer(PLANT, [1, 2, 3]) -> observer.L: has shape (1, 3); must be (2, 1)
parts.lookup_table([0, 1], [0, NAN]) -> lookup_table: values = [0.0, nan]: must be finite; number 1
parts.point_vehicle(INF, 1) -> point_vehicle: mass = inf: must be finite
parts.planar_vehicle(np.diag([1, INF, 1]), np.eye(3)) -> planar_vehicle: M = [[1.0, 0.0, 0.0],
parts.thrusters([[0, INF]], [0], -1, 1, 0.1) -> thrusters: places = [[0.0, inf]]: must be finite
parts.thrusters([[0, 1]], [0], -1, 1, INF) -> thrusters: lag = inf: must be finite
parts.observer(PLANT, [[INF], [1]]) -> observer: L = [[inf], [1.0]]: must be finite
parts.saturation(1, -1) -> saturation: low = 1: must be below high = -1
clpt.compare(runs(), lables=["x", "y"]) -> compare: lables= is not an argument. Did you mean 'labels'?
clpt.compare(runs(), colour="r") -> compare: colour= is not an argument. It has runs, plot, labels
clpt.compare(runs(), "track", axis=2) -> axis: is of the plot 'learning'. Leave it out
runs()["a"].clpt.plot(["track"]) -> Give 'track' alone, not in a list
runs()["a"].clpt.plot(colour="r") -> colour= is not an argument. Did you mean 'color'?
clpt.gramian(PEN, signal=["angle"], timepts=TIMES) -> signal= is not an argument. Did you mean 'signals'?
clpt.gramian(PEN, timepts=TIMES) -> gramian: signals: is required for a diagram
clpt.gramian(RUN, signal=["angle"]) -> gramian: signal: a run has its own times and inputs. Did you mean 'signals'?
clpt.gramian(RUN, signals=["angle"], timepts=TIMES) -> gramian: timepts: a run has its own times and inputs. Leave it out
clpt.gramian(RUN) -> gramian: signals: is required for a diagram
clpt.gramian(SHORT, windows=9) -> gramian: windows= is not an argument. Did you mean 'window'?
clpt.gramian(SHORT, rtoll=1) -> gramian: rtoll= is not an argument. Did you mean 'rtol'?
clpt.gramian(SHORT, x0=1) -> gramian: x0= is not an argument. Give the initial state as initial_state
clpt.Team(members=[SHORT, SHORT], coupling=0.1) -> must be a dict by name, such as {'west': scenario}
clpt.export(PEN, file="a.c") -> export: file= is not an argument. Give the file as path
clpt.export(PEN, params={"g": NAN}) -> params: g = nan: must be
clpt.connect(PEN) -> must be a list of values, such as [plant, controller]
clpt.flow_map(runs()["a"], lat=[0]) -> flow_map: lat= is not an argument. Did you mean 'latitude'?
clpt.flow_map(runs()["a"], [0, NAN]) -> latitude = [0.0, nan]: must be finite; number 1 is nan
clpt.flow_map(AT_SEA, [-121.9], [36.5]) -> latitude: -121.9 is not from -90 to 90. Give latitudes, then longitudes
clpt.flow_map(runs()["a"], time=NAN) -> time = [nan]: must be finite; number 0 is nan
clpt.flow_map(runs()["a"], time=1e9) -> time: must lie within 10 times the length of the run, 20 s. Give
vary(out="a.nc") -> out = a.nc: is a folder, a Zarr store. Give a name such as a.zarr
vary(members=0) -> run_ensemble: members = 0: must be a whole number, 1 or more
vary(threads=0) -> run_ensemble: threads = 0: must be a whole number, 1 or more
vary(summary={"a": lambda run: run.angel.max()}) -> summary: a: <lambda>, line 1: AttributeError: 'Dataset' object has no attribute 'angel'
vary(summary={"a": lambda run: 1 / 0}) -> summary: a: <lambda>, line 1: ZeroDivisionError: division by zero
vary(params={"g": NAN}) -> params: g = nan: must be a number, without NaN
prepared(parms={"d": 1}) -> parms= is not an argument. Did you mean 'params'?
prepared(params={"d": INF}) -> derivative of rate of block pen is not finite
prepared(params={"d": NAN}) -> params: d = nan: must be a number, without NaN
prepared(params={"d": [1, 2]}) -> must have the shape ()
clpt.export(LIMITED, initial_state=[INF]) -> initial_state = [inf]: must be finite
clpt.run_ensemble(LIMITED, {"c": [1, INF]}, timepts=TIMES) -> c = inf: must be finite
clpt.run_ensemble(LIMITED, {"saturation.high": [1, NAN]}, timepts=TIMES) -> each value must be a number
prepared([NAN, 0]) -> initial_state = [nan, 0.0]: must be finite; number 0 is nan
prepared(inputs=NAN) -> inputs: must be finite, not nan. Fill the gaps
estimator().flow(1777593600e3, 36.7, -122) -> time 1777593600000: must be finite, s since 1970. Divide
estimator().flow(1777593600, NAN, -122) -> place (nan, -122): must be latitude and longitude
estimator().guaranteed(1777593600e3, 36.7, -122) -> Divide milliseconds by 1000
clpt.simulate(PEN, TIMES, rtol=INF) -> rtol = inf: must be a number, 0 or more and below 1
clpt.simulate(PEN, TIMES, atol=INF) -> atol = inf: must be a number, 0 or more and finite
clpt.prepare(PEN, TIMES, atol=INF) -> atol = inf: must be a number
clpt.fit_parameters(PEN, {"angle": TIMES}, {"g": 5.0}, TIMES, rtol=INF) -> rtol = inf: must be
clpt.simulate(PEN, TIMES, params=[9.81]) -> such as {'k': 2.0} for a parameter k
clpt.simulate(PEN, [0, NAN, 1]) -> timepts = [0.0, nan, 1.0]: must be finite; number 1 is nan
clpt.simulate(PEN, [0, 2, 1]) -> timepts = [0.0, 2.0, 1.0]: must be at least two increasing times
clpt.simulate(PEN, TIMES, params={"g": NAN}) -> params: g = nan: must be a number, without NaN
clpt.simulate(PEN, TIMES, params={"g": INF}) -> derivative of rate of block pen is not finite
clpt.linearize(PEN, [0, INF], [0]) -> x = [0.0, inf]: must be finite; number 1 is inf
clpt.linearize(PEN, [0, 0], [0], params={"g": NAN}) -> params: g = nan: must be a number
clpt.lyapunov(PEN, at={"angle": NAN}) -> at = {'angle': nan}: must be a dict of numbers by name or None, without NaN
clpt.lyapunov(PEN, at={"angle": 1.0}) -> at this at=, which is no rest. Give another
clpt.currents.read_currents(clpt.currents.sample_currents(), units="furlong") -> units=, --units: units = 'furlong' is not a speed
clpt.lyapunov(PEN, at={"angle": INF}) -> at: angle = inf: must be finite
clpt.currents.fit_current("x.nc", (1, NAN, 2, 3)) -> box = (1, nan, 2, 3): must be a tuple of 4 numbers or None, without NaN
clpt.currents.fit_current("x.nc", ()) -> box = (): must be a tuple of 4 numbers or None, such as (41, 41.5, -69.9, -69.1)
clpt.currents.known_flow_scenario(SHORT, [[1, 2]]) -> known_flow_scenario: theta = [[1.0, 2.0]]: must be an array of numbers of shape (..., 2, 3)
clpt.currents.known_flow_scenario(SHORT, [[1, 2, NAN]]) -> known_flow_scenario: theta = [[1.0, 2.0, nan]]: must be finite
fitted([0, 20]) -> parameters: g = [0, 20]: must be a number to begin at, or (start, low, high)
fitted([5, 0, 20]) -> parameters: g = [5, 0, 20]: must be a number to begin at, or (start, low, high)
fitted(()) -> parameters: g = (): must be a number to begin at, or (start, low, high)
fitted((20, 1, 2)) -> parameters: g = (20, 1, 2): must be a number to begin at, or (start, low, high)
clpt.currents.fit_current("x.nc", width_km=-1) -> width_km = -1: must be a number, positive
called(parts.saturation(-1, 1), low=2) -> saturation: low = 2.0: must be below high = 1.0
called(parts.saturation(-1, 1), low=INF) -> saturation: low = inf: must be below high = 1.0
called(parts.dead_zone(-1, 1), low=2) -> dead_zone: low = 2.0: must be below high = 1.0
called(parts.lag(2), lag=-2) -> lag: lag = -2.0: must be positive
called(parts.lag(2), lag=0) -> lag: lag = 0.0: must be positive
called(parts.lag(2), lag=INF) -> lag: lag = inf: must be finite
called(parts.lag(2), gain=INF) -> lag: gain = inf: must be finite
called(parts.delay(2), delay=-1) -> delay: delay = -1.0: must be positive
called(parts.relay(1, -1, dt=1), off=2) -> relay: off = 2.0: must be below on = 1.0
called(parts.relay(1, -1, dt=1), high=INF) -> relay: high = inf: must be finite
called(parts.rate_limit(1, dt=1), rise=-1) -> rate_limit: rise = -1.0: must be positive
called(parts.backlash(1, lag=1), width=-1) -> backlash: width = -1.0: must be positive
called(parts.backlash(1, lag=1), lag=0) -> backlash: lag = 0.0: must be positive
called(parts.noise(1, 1), std=-1) -> noise: std = -1.0: must be positive or 0
called(parts.pid(1, 1, low=-1, high=1), low=2) -> pid: low = 2.0: must be below high = 1.0
called(parts.pid(1, 1, dt=1), tracking=0.4) -> pid: tracking = 0.4: must be above half of dt
called(parts.pid(1, 1), kp=INF) -> pid: kp = inf: must be finite
called(parts.point_vehicle(1, 1), mass=0) -> point_vehicle: mass = 0.0: must be positive
called(parts.planar_vehicle(np.eye(3), np.eye(3)), M=-np.eye(3)) -> must be symmetric and positive
called(parts.lookup_table([0, 1], [0, 1]), at=[1.0, 0.0]) -> must be two or more increasing
called(parts.noise(1, 1), seed=-1) -> noise: seed = -1.0: must be a whole number, 0 or more
called(parts.noise(1, 1), seed=0.5) -> noise: seed = 0.5: must be a whole number, 0 or more
called(parts.kalman_filter(control.ss(-1, 1, 1, 0), 3, 1), R=[[-4.0]]) -> kalman_filter: R = [[-4.0]]: must be symmetric
setattr(parts.saturation(-1, 1), "parameters", {"low": 2, "high": 1}) -> low = 2: must be below high = 1
clpt.fit_parameters(parts.lag(1), {"y": [0, 0.3, 0.5, 0.6]}, {"lag.lag": -1.0}, [0, 1, 2, 3], 1.0) -> lag: lag = -1.0: must be positive
parts.pid(INF, 0.1, 0.2) -> pid: kp = inf: must be finite
clpt.enclose(PEN, TIMES, 0.0, (1, 0)) -> initial_state = (1, 0): may be one pair or two numbers
called(clpt.Sampled(parts.lag(2), 1), lag=-2) -> lag: lag = -2.0: must be positive
clpt.prepare(parts.lag(2), [0, 1], 1, params={"lag.lag": 1})(params={"lag.lag": -2}) -> lag: lag = -2
clpt.linearize(parts.lag(2), params={"lag.lag": -2}) -> lag: lag = -2.0: must be positive
clpt.run_ensemble(LIMITED, {"saturation.low": [-1, 2]}, timepts=[0, 1]) -> vary: member 1: saturation: low = 2.0: must be below high = 1.0
clpt.run_ensemble(LIMITED, {"saturation.low": [-1, 0.5], "saturation.high": [0.2, 1]}, timepts=[0, 1]) -> vary: member 2: saturation: low = 0.5: must be below high = 0.2
clpt.enclose("tank", [0, 1]) -> enclose: system = 'tank': must be a Scenario or a diagram
clpt.enclose(LIMITED, [0, 1], params={"lag.lag": (-1, 2)}) -> lag: lag = -1.0: must be positive
clpt.fit_parameters(parts.lag(2), {"y": [0, INF, 1]}, {"lag.lag": 1}, [0, 1, 2], 1.0) -> data: y: must be finite; NaN is no measurement
parts.saturation([1, 2], 3) -> saturation: low = [1, 2]: must be one number
parts.thrusters([(0, 1)], 0, 0, 1, 1) -> angles = 0: must be a list of pairs, and an angle for each
clpt.currents.FlowEstimator.load() -> Its arguments are path
clpt.prove("sgma") -> prove: there is no sgma. Did you mean 'sigma'?
clpt.tune_law(SHORT, laws=["sgma"]) -> laws: there is no sgma. Did you mean 'sigma'?
"""  # noqa: E501


@pytest.mark.parametrize("mistake", MISTAKES.strip().splitlines())
def test_a_mistake_is_one_sentence(mistake, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    call, said = mistake.split(" -> ")
    says(clpt.ClptError, re.escape(said), eval, call, globals())
    assert not [*tmp_path.iterdir()]


REMEDIES = """
parts.pid(1, ki=2)
parts.pid(1, low=-INF, high=INF)
parts.pid(1, ki=1, tracking=INF)
parts.pid(1, y="level")
parts.saturation(-INF, 1)
parts.rate_limit(INF, 1, lag=0.1)
clpt.compare(runs(), labels=["x", "y"])
clpt.compare(runs(), "learning", axis=2)
runs()["a"].clpt.plot("track")
runs()["a"].clpt.plot("clpe", color="r")
clpt.gramian(SHORT, window=9)
clpt.export(PEN, path="a.c")
clpt.connect([PEN], external="torque")
prepared(params={"d": 1})
estimator().flow(1777593600, 36.7, -122)
vary(seed=np.int64(3))
called(parts.saturation(-1, 1), low=0.5)
called(parts.lag(2), lag=1e-9)
called(parts.pid(1, 1, low=-1, high=1), low=-INF)
called(parts.pid(1, 1), ki=0)
called(parts.point_vehicle(1, 1), damping=0)
clpt.run_ensemble(LIMITED, {"saturation.low": [-1, 1.5], "saturation.high": [2, 3]}, timepts=[0, 1])
parts.relay(1, -1, low=2, high=1, lag=0.1)
parts.dead_zone(0, 0)
fitted((5, 0, 20))
clpt.flow_map(runs()["a"], time=[-5, 200])
clpt.currents.known_flow_scenario(SHORT, np.ones((2, 3)))
"""


@pytest.mark.parametrize("call", REMEDIES.strip().splitlines())
def test_the_remedy_works(call, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    eval(call, globals())


def test_a_limit_may_be_infinite_in_each_call():
    of = {"saturation.high": INF}
    free = 5 * (1 - np.exp(-1))  # y' = 5 - y from 0
    run = clpt.prepare(LIMITED, [0, 1], 5.0, params={"saturation.high": 1})
    assert run(params=of).states[-1, 0] == pytest.approx(free, rel=1e-6)
    assert "INFINITY" in clpt.export(LIMITED, params=of)
    varied = {"saturation.high": [1, INF]}
    members = clpt.run_ensemble(LIMITED, varied, timepts=[0, 1], inputs=5.0)
    assert members.y_final.values == pytest.approx([free / 5, free], rel=1e-6)


def test_a_fit_stays_where_its_blocks_take_its_numbers():
    times = np.linspace(0, 3, 20)
    data = {"y": 0.5 * (1 - np.exp(-times))}
    start = {"saturation.high": 0.2, "saturation.low": -0.5}
    fit = clpt.fit_parameters(LIMITED, data, start, times, 5.0)
    assert fit.values["saturation.high"] == pytest.approx(0.5)
    assert fit.values["saturation.low"] < 0.5


def test_a_number_is_a_matrix_of_one_signal():
    plant = control.ss(-1, 1, 1, 0)
    still = clpt.parts.kalman_filter(plant, 3, 1, P0=0)
    P = clpt.simulate(still, [0, 9], [[0, 0], [0, 0]]).P.values[-1]
    assert P.item() == pytest.approx(control.lqe([[-1]], [[1]], [[1]], 3, 1)[1].item())
    observer = clpt.parts.observer(plant, 2.0).linearize([0], [0, 0])
    assert observer.poles() == pytest.approx([-3.0])
    rows = [clpt.parts.observer(PLANT, L).parameters["L"] for L in ([2, 3], [[2], [3]])]
    assert rows[0].tolist() == rows[1].tolist() == [[2.0], [3.0]]


OWN_PARAMS = {  # of any type, as python-control hands them on: x' = -p x, the default and another
    "number": (lambda p: p.get("k", 2.0), {"k": 3.0}),
    "array": (lambda p: p.get("K", np.array([2.0]))[0], {"K": [3.0]}),
    "text": (
        lambda p: 2.0 if p.get("mode", "slow") == "slow" else 3.0,
        {"mode": "fast"},
    ),
    "dict": (lambda p: p.get("car", {"k": 2.0})["k"], {"car": {"k": 3.0}}),
    "function": (lambda p: p.get("f", lambda: 2.0)(), {"f": lambda: 3.0}),
}


@pytest.mark.parametrize("kind", OWN_PARAMS)
def test_a_model_has_params_of_its_own(kind):
    rate, other = OWN_PARAMS[kind]
    model = control.nlsys(
        lambda t, x, u, p: -rate(p) * x, inputs=0, outputs=1, states=1, name="own"
    )
    for params, k in ((None, 2.0), (other, 3.0)):
        run = clpt.simulate(model, TIMES, initial_state=[1.0], params=params)
        assert run.states[-1].item() == pytest.approx(np.exp(-2 * k), rel=1e-6)
