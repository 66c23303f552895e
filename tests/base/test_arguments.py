"""Every public name refuses wrong arguments in one sentence, takes what it may, ignores nothing."""

import ast
import dataclasses
import inspect
import math
import pickle
import re
import textwrap
import tomllib
from collections.abc import Iterable
from itertools import product
from pathlib import Path

import control
import numpy as np
import pytest
import utide
import xarray
from error_sentences import says
from law_blocks import papers_law
from responses import response
from synthetic_vehicle import Made
from team_scenarios import write_team
from test_documentation import methods, public_objects

import clpt_control as clpt
from clpt_control.base.arguments import Seed, as_python_type, fits, kinds_of, public

SCENARIO = clpt.paper_scenario().with_values({"run.duration": 40})
OF_FIXES = clpt.Scenario(
    basis={
        "kernel": "gaussian",
        "centers": [[0, 0]],
        "widths": [1e5],
        "constituents": ["steady"],
    },
    learning={"law": "fix-regression"},
)
PLACE = {"latitude": 40.0, "longitude": -70.0}
WAY = {"east": 10.0, "north": 0.0}


def estimator():
    """Return an estimator at its first fix."""
    found = clpt.currents.FlowEstimator(OF_FIXES)
    found.fix(0.0, *PLACE.values())
    return found


OF_TEAM = {
    "coupling": 0.5,
    "edges": [("a", "b")],
    "members": {"a": SCENARIO, "b": SCENARIO},
}
TEAM = clpt.Team(**OF_TEAM)
(CLPE,) = (block for block in clpt.paper_blocks(SCENARIO) if block.name == "clpe")
DIVES = clpt.gliders.sample_dives()[:8]
HOURS = np.datetime64("2020-01-01") + np.arange(720) * np.timedelta64(3600, "s")
TIDE = 0.1 * np.cos(np.arange(720) * 2 * np.pi / 12.42)


def line(t, x, u, p):
    return u[0]


LAG = control.tf([1], [1, 1])
WRONG = {
    **{
        "None": None,
        "3": 3,
        "nan": math.nan,
        "True": True,
        "text": "mine.toml",
        "nothing": "",
    },
    **{
        "empty": [],
        "numbers": [1, 2],
        "nested": [[1.0], [1.0, 2.0]],
        "object": object(),
    },
    **{
        "dict": {},
        "dict of numbers": {"a": 1},
        "path": Path("no such folder") / "mine.toml",
    },
    **{"array": np.zeros((2, 3)), "of one": np.array(2.0), "of text": np.array(["a"])},
    **{
        "dataset": xarray.Dataset({"a": ("b", [1.0])}),
        "response": control.step_response(LAG),
    },
    **{
        "dataarray": xarray.DataArray([1.0], dims="time"),
        "function": line,
        "system": LAG,
    },
    **{"scenario": SCENARIO, "block": CLPE, "dive": DIVES[0]},
}


def wrong_values():
    """Return values each of which is wrong nearly everywhere; a generator is read once."""
    return {**WRONG, "generator": (one for one in [3])}


OF_PARTS = {  # what they must be given
    **dict.fromkeys(["rise", "width", "on", "delay", "dt", "kp"], 1.0),
    **dict.fromkeys(["std", "period", "mass", "damping"], 1.0),
    **{"L": [[1.0]], "Q": [[1.0]], "R": [[1.0]], "M": np.eye(3), "D": np.eye(3)},
    **{"low": -1.0, "high": 1.0, "off": -1.0, "at": [0.0, 1.0], "values": [0.0, 2.0]},
    **{"places": [(0.0, 1.0)], "angles": [0.0]},
}
LINEAR = {"system": control.ss(-1, 1, 1, 0)}
TO = {"end": (9e3, 40.01, -70.0), "through_water": (1000.0, 0.0)}

# what a function of the user's own raises is its own error
CALLED = ("progress", "inputs")
LONG = """animate audit design_track export
fit_parameters prove report run_ensemble sensitivity tune_law"""
LISTS = ("check",)  # a sentence for each failure
OF_THE_ENGINE = {  # called at each step, and checked by no one
    "Block": (
        "values",
        "on_arrays",
        "parameters_at",
        "interval_at",
        "having",
        "with_params",
    ),
    "Sampled": ("samples_at", "values"),
    "Diagram": ("linearize",),  # it is python-control's
    "Replay": ("surfacing", "start", "imagine", "feed"),
}


def public_callables():
    for name, value in public_objects():
        if inspect.isclass(value):
            unchecked = OF_THE_ENGINE.get(value.__name__, ())
            for own, method in methods(value):
                if inspect.isfunction(method) and own not in unchecked:
                    yield pytest.param(method, id=method.__qualname__)
            if issubclass(value, Exception):
                continue
        if inspect.signature(value).parameters:
            yield pytest.param(value, id=name)


@pytest.fixture(scope="module")
def right(tmp_path_factory):
    """Arguments that are allowed: by their name, and by function where the name is not enough."""
    folder = tmp_path_factory.mktemp("right")
    loop = clpt.closed_loop(SCENARIO, external=["zc"])
    replay, run = clpt.replay.replay_dives(DIVES), clpt.simulate(SCENARIO)
    clpt.save_run(run, folder / "run.nc")
    clpt.save_scenario(SCENARIO, folder / "s.toml")
    write_team(folder / "team.toml", TEAM)
    clpt.gliders.write_dive_table(DIVES, folder / "sample.csv")
    currents = clpt.currents.sample_currents()
    fit = clpt.currents.fit_current(currents, (40.9, 41.55, -69.9, -69.0))
    shoals = fit.save(folder / "shoals.toml")
    dive = list(inspect.signature(clpt.gliders.Dive).parameters)[:11]
    fit = {"lat": 40.0, "constit": ["M2"], "trend": False, "verbose": False}
    tides = utide.solve(HOURS, TIDE, TIDE, **fit)
    ensemble = clpt.run_ensemble(SCENARIO, "learning.gain=0.5:1", 2)
    named = {
        **{
            "scenario": SCENARIO,
            "run": run,
            "team": TEAM,
            "diagram": loop,
            "block": CLPE,
        },
        **{"replay": replay, "dives": DIVES, "dive": DIVES[0], "source": SCENARIO},
        **{"window": 20.0, "start": 0.0, "path": folder / "s.toml", "folder": folder},
        **{
            "flow_model": Made(lambda *_: (0.0, 0.0)),
            "law_block": papers_law(),
            "samples": 4,
        },
        **{"constituents": ["M2"], "names": ["M2"], "where": "here", "hours": 720.0},
        **{"system": loop, "runs": {"a": run}, "data": ensemble, "lag": 0.1},
    }
    own = {
        "connect": {"blocks": [CLPE], "external": ["x", "z"]},
        "evaluate": {"timepts": [0.0, 1.0], "inputs": np.zeros((2, 4))},
        "lookup": {"table": [1.0, 2.0], "index": 1.0},
        "tidal_basis": {"tides": tides, "epoch": HOURS[0], "unit": "m s-1"},
        "flow_estimate": {"source": run, "scenario": None, "every": 5.0},
        "FlowEstimator": {"scenario": OF_FIXES},
        "FlowEstimator.fix": {"self": estimator(), "time": 60.0, **PLACE},
        "FlowEstimator.move": {"self": estimator(), "time": 60.0, **WAY},
        **{
            f"FlowEstimator.{name}": {"self": estimator(), "time": 60.0, **PLACE}
            for name in ("flow", "guaranteed")
        },
        "FlowEstimator.save": {"self": estimator(), "path": folder / "state"},
        "FlowEstimator.forecast": {
            "self": estimator(),
            "stretches": [(60.0, 1.0, 0.0)],
        },
        "known_flow_scenario": {"theta": np.zeros((2, 3))},
        "make_dive": {"number": 1, "start": (0.0, 40.0, -70.0), **TO},
        **{
            "aims": {"self": replay, "targets": [(40.0, -70.0)], "start": None},
            "period": {"constituent": "M2"},
        },
        "flow_velocity": {"points": np.zeros((2, 2)), "timepts": 0.0},
        "load_run": {"path": folder / "run.nc"},
        **{
            name: {"source": currents, "names": None}
            for name in ("read_currents", "fit_current")
        },
        "read_flow_model": {"path": currents},
        "load_scenario": {"path": folder / "team.toml"},
        "read_dives": {"paths": [folder / "sample.csv"]},
        "write_dive_table": {"path": folder / "dives.csv"},
        "animate": {"path": folder / "film.gif"},
        "report": {"path": folder / "page.html"},
        "run_ensemble": {"system": SCENARIO, "vary": "learning.gain=0.5:1"},
        "fit_parameters": {"data": run, "parameters": {"adaptation.gain": 1.0}},
        **{name: {"timepts": [0.0, 1.0]} for name in ("sensitivity", "prepare")},
        "linearize": {"x": np.ones(14)},
        "flow_map": {"source": run},
        "explained_variance": {
            "scenario": shoals,
            "run": clpt.simulate(shoals),
            "window": None,
        },
        "export": {"path": folder / "loop.fmu"},
        **{
            "save_run": {"path": folder / "other.nc"},
            "draw": {"path": folder / "loop.svg"},
        },
        "save_scenario": {"path": folder / "other.toml"},
        "Block": {"name": "b", "output": line, "inputs": {"u": 1}, "outputs": {"y": 1}},
        "Block.breakpoints": {"self": CLPE, "t0": 0.0, "t1": 1.0},
        "Block.with_values": {"self": CLPE, "changes": {}},
        "Equations.derivative": {"self": clpt.equations(loop), "expression": "gain"},
        "Guard.message": {"self": clpt.Guard(line, "stop", lambda t, u, p: "")}
        | {"t": 0.0, "u": [1.0]},
        "Sampled": {"inner": CLPE, "period": 1.0},
        "Guard": {"distance": line, "policy": "stop", "sentence": line},
        **{
            "Replay.forecast": {"self": replay},
            "Replay.ahead": {"self": replay},
            "Replay.next_dive": {"self": replay},
            **{name: {"self": replay} for name in ("summary", "dataset")},
            "lyapunov": {**LINEAR, "where": None},
            "observer": LINEAR,
            "enclose": {**LINEAR, "timepts": [0.0, 1.0]},
            "verify": {**LINEAR, "timepts": [0.0, 1.0], "always": "t < 9"},
            "kalman_filter": LINEAR,
        },
        "Replay.step": {"self": clpt.replay.replay_dives(DIVES[:3]), "dive": DIVES[5]},
        "Scenario": tomllib.loads((folder / "s.toml").read_text()),
        "Scenario.basis_block": {"self": SCENARIO},
        "Scenario.with_values": {"self": SCENARIO, "values": {}},
        **{"Team": OF_TEAM, "Team.neighbours": {"self": TEAM, "name": "a"}},
        "Dive": dict(
            zip(dive, [1, 0.0, 40.0, -70.0, 9e3, 40.0, -70.0, *[0.0] * 4], strict=True)
        ),
    }
    return named, own


@pytest.mark.parametrize("function", list(public_callables()))
@pytest.mark.filterwarnings(
    "ignore:initial_state is too short"
)  # as python-control says it
def test_wrong_arguments_are_one_sentence(function, right, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)  # "mine.toml" is a good name of a file to write
    named, own = right
    every = inspect.signature(function).parameters.items()
    parameters = {
        name: one
        for name, one in every
        if one.kind not in (one.VAR_POSITIONAL, one.VAR_KEYWORD)
    }
    needed = [
        n for n, one in parameters.items() if n in named or one.default is one.empty
    ]
    given = {name: named.get(name, OF_PARTS.get(name)) for name in needed}
    given |= own.get(function.__qualname__, {})
    if function.__name__ not in LONG.split() and [*parameters] != ["self"]:
        # else a right argument that is refused asks nothing of the others
        function(**given)
    for argument in [one for one in parameters if one not in ("self", "optional")]:
        for label, value in wrong_values().items():
            if callable(value) and argument in CALLED:
                continue
            if function.__name__ in LONG.split():
                kinds = kinds_of(
                    function.__annotations__[argument], function.__globals__
                )
                if fits(as_python_type(wrong_values()[label], kinds), kinds):
                    continue
            try:
                function(**{**given, argument: value})
            except Exception as error:
                lines = str(error).count("\n") if function.__name__ not in LISTS else 0
                if not isinstance(error, clpt.ClptError) or lines:
                    raise AssertionError(f"{argument} = {label}: {error!r}") from error


# --- what is said --------------------------------------------------------------------------------


SAID = {  # call -> the sentence
    lambda: clpt.simulate("mine.toml"): (
        "simulate: system = 'mine.toml': must be a Scenario, a Team or a diagram; "
        "clpt.load_scenario('mine.toml') reads a scenario's file"
    ),
    lambda: clpt.Block("b", output=line, inputs=["u"], outputs={"y": 1}): (
        "Block: inputs = ['u']: must be a dict of whole numbers or texts or tuples of whole "
        "numbers or texts by name or None, such as {'e': 2}"
    ),
    lambda: clpt.simulate(SCENARIO, rtol=math.nan): (
        "simulate: rtol = nan: must be a number or None"
    ),
    lambda: clpt.closed_loop(SCENARIO, law="sigma"): (
        "closed_loop: law = 'sigma': must be a Block, a diagram or None, such as "
        "clpt.Block('adaptation', ...); scenario.with_values({'learning.law': 'sigma'}) takes a "
        "law by name"
    ),
    lambda: clpt.export(SCENARIO, "l.c", part="learner", watch=[True]): (
        "export: watch = [True]: must be a list of diagrams, such as "
        "clpt.gramian(scenario, 40).watch"
    ),
    lambda: clpt.check(CLPE, samples=0): (
        "check: samples = 0: must be a whole number, 1 or more"
    ),
    lambda: clpt.tune_law(SCENARIO, laws="sigma"): (
        "tune_law: laws = 'sigma': must be a list of texts. Give a list: ['sigma']"
    ),
    lambda: SCENARIO.with_values("learning.gain=2"): (
        "Scenario.with_values: values = 'learning.gain=2': must be a dict of values by name, such "
        "as {'learning.gain': 2.0}"
    ),
    lambda: clpt.compare("run.nc"): (
        "compare: runs = 'run.nc': must be a dict of xarray.Datasets by name or a list of "
        "xarray.Datasets; "
        "clpt.simulate(scenario) makes a run, clpt.load_run('run.nc') reads one"
    ),
}


@pytest.mark.parametrize("call", SAID)
def test_the_sentence_says_what_to_try(call):
    says(clpt.ArgumentError, f"^{re.escape(SAID[call])}$", call)
    assert issubclass(clpt.ArgumentError, TypeError)


# --- the mechanism -------------------------------------------------------------------------------


@public
def example(
    number: float, whole: int = 1, *, names: Iterable[str] = (), values: np.ndarray | None = None,
    pair: tuple[float, float] = (0.0, 0.0), run: "xarray.Dataset | None" = None, seed: Seed = 0,
) -> tuple:  # fmt: skip
    return number, whole, names, values, pair, run, seed


@pytest.mark.parametrize(
    "number", [1, 1.5, np.float32(2), np.int8(3), np.array(4.0), math.inf]
)
def test_numbers_of_all_kinds_are_numbers(number):
    assert example(number)[0] == number
    assert np.ndim(example(xarray.DataArray(2.5))[0]) == 0


def test_what_can_be_made_plain_is():
    found = example(
        1, names=(name for name in "ab"), values=[[1, 2], [3, 4]], pair=[1, 2]
    )
    assert (found[2], found[3].shape, found[4]) == (["a", "b"], (2, 2), (1, 2))


@pytest.mark.parametrize(
    ("given", "more", "said"),
    [
        (
            (),
            {},
            "example: missing a required argument: 'number'. Its arguments are number, w",
        ),
        (
            (1, 2, 3),
            {},
            "example: too many positional arguments. Its arguments are number, w",
        ),
        (
            (1,),
            {"number": 1},
            "example: multiple values for argument 'number'. Its argume",
        ),
        (
            (1,),
            {"nothing": 3},
            "example: nothing= is not an argument. It has number, whole",
        ),
        (
            (1,),
            {"Value": 3},
            "example: Value= is not an argument. Did you mean 'values'?",
        ),
    ],
)
def test_what_lacks_or_is_too_much_is_named(given, more, said):
    says(clpt.ArgumentError, f"^{re.escape(said)}", example, *given, **more)


def test_arguments_are_named_where_ports_have_other_names():
    says(clpt.ArgumentError, "^pid: Kp= is .*mean 'kp'", clpt.parts.pid, Kp=1)
    says(
        clpt.ArgumentError,
        "required argument: 'kp'.*dt, signals, name$",
        clpt.parts.pid,
    )


def test_a_public_function_stays_itself():
    assert [*inspect.signature(clpt.simulate).parameters][:2] == ["system", "timepts"]
    assert pickle.loads(pickle.dumps(clpt.simulate)) is clpt.simulate
    assert inspect.getsource(clpt.simulate).count("def simulate") == 1
    # doctest asks
    assert clpt.simulate.__globals__ is clpt.simulate.__wrapped__.__globals__


def test_what_a_function_raises_itself_is_left_alone():
    @public
    def broken(number: float) -> None:
        raise KeyError("its own")

    with pytest.raises(KeyError, match="its own"):
        broken(1.0)


# --- no argument is ignored ----------------------------------------------------------------------

SHORT = clpt.paper_scenario().with_values({"run.duration": 2})
LOOP, STEERED = clpt.closed_loop(SHORT), clpt.closed_loop(SHORT, external="zc")
ENGINES = ("native", "python")


def public_functions():
    for name, value in public_objects():
        found = {name: value}
        if inspect.isclass(value):
            bases = {inner for base in value.__bases__ for inner in dir(base)}
            found = {
                f"{name}.{n}": method for n, method in methods(value) if n not in bases
            }
            if not dataclasses.is_dataclass(value):
                found[name] = vars(value).get("__init__")
        yield from (
            pytest.param(one, id=n)
            for n, one in found.items()
            if inspect.isfunction(one)
        )


@pytest.mark.parametrize("function", list(public_functions()))
def test_every_argument_is_used(function):
    (made,) = ast.parse(textwrap.dedent(inspect.getsource(function))).body
    names = (
        node
        for line in made.body
        for node in ast.walk(line)
        if isinstance(node, ast.Name)
    )
    used = {node.id for node in names if isinstance(node.ctx, ast.Load)}
    assert set(inspect.signature(function).parameters) - {"self", "cls"} <= used


NAN, INF = float("nan"), float("inf")
OF_RUNS = {
    "timepts": ([1.0, 0.0], [1.0], [0.0, 0.0], [0.0, NAN], [0.0, INF]),
    "initial_state": ("rest", [1.0] * 15, np.full(14, 1j)),
    "inputs": (
        np.full((2, 2), 1j),
        [[1.0, 2.0]],
        [[1.0], [1.0, 2.0, 3.0]],
        lambda t: [t],
    ),
    "rtol": (-1.0, NAN),
    "atol": (-1.0, NAN),
    "max_step": (0.0,),
    "first_step": (-1.0, NAN),
    "method": ("RK45",),
    "params": ([1.0], {"adaptation.gan": 1.0}),
}


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("name", OF_RUNS)
def test_engines_refuse_the_same_by_its_name(name, engine):
    systems = ((SHORT, None), (LOOP, [0.0, 2.0]), (STEERED, [0.0, 2.0]))
    for wrong, (system, times) in product(OF_RUNS[name], systems):
        given = {"timepts": times, name: wrong, "engine": engine}
        says(clpt.ClptError, f"{name}|unknown param", clpt.simulate, system, **given)


def test_there_is_no_other_engine():
    values = [one.values[0] for one in public_functions()]
    assert {f for f in values if "engine" in inspect.signature(f).parameters} == {
        clpt.simulate
    }
    said = "must be one of native, python"
    says(clpt.ClptError, said, clpt.simulate, LOOP, [0.0, 2.0], engine="fast")


def test_a_tolerance_of_nothing_is_not_the_default():
    """One of the two may be 0, and is taken as given; both are refused."""
    start = clpt.initial_state(SHORT)
    ran = [
        response(LOOP, [0.0, 2.0], initial_state=start, atol=a).states
        for a in (0.1, 1.0)
    ]
    assert abs(ran[0] - ran[1]).max() > 0
    said = "one of them must be above 0"
    says(clpt.ClptError, said, clpt.simulate, LOOP, [0.0, 2.0], rtol=0.0, atol=0.0)


def test_an_unknown_keyword_is_refused_where_keywords_are_handed_on():
    given = 1, (0.0,) * 3, (0.0,) * 3, (0.0, 0.0)
    make = clpt.gliders.make_dive
    says(clpt.ArgumentError, "^Dive: doubts= .*mean .doubt.", make, *given, doubts=1)


def test_help_shows_signatures_that_can_be_read():
    shown = [
        str(inspect.signature(getattr(clpt.parts, name))) for name in clpt.parts.__all__
    ]
    assert [one for one in shown if "_typing" in one] == []


# --- names of python-control -----------------------------------------------------------------


@pytest.mark.parametrize(
    ("given", "own"),
    [
        ({"T": [0, 1]}, "timepts"),
        ({"t_eval": [0, 1]}, "timepts"),
        ({"timepts": [0, 1], "U": 1.0}, "inputs"),
        ({"timepts": [0, 1], "X0": [1.0]}, "initial_state"),
        ({"timepts": [0, 1], "squeeze": True}, "xarray.Dataset"),
        ({"t_span": [0, 1]}, "timepts"),
        ({"evaluation_times": [0, 1]}, "timepts"),
        ({"timepts": [0, 1], "y0": [1.0]}, "initial_state"),
        ({"timepts": [0, 1], "return_x": True}, "run.states"),
        ({"timepts": [0, 1], "transpose": True}, "xarray.Dataset"),
        ({"timepts": [0, 1], "ignore_errors": True}, "raises an error"),
        ({"timepts": [0, 1], "solve_ivp_method": "LSODA"}, "method"),
        ({"timepts": [0, 1], "solve_ivp_kwargs": {}}, "rtol"),
    ],
)
def test_names_of_other_arguments_name_ours(given, own):
    """Arguments of forced_response and solve_ivp, given to simulate."""
    system = control.ss([[-1.0]], [[1.0]], [[1.0]], 0)
    with pytest.raises(clpt.ArgumentError, match=f"is not an argument.*{own}"):
        clpt.simulate(system, **given)


@pytest.mark.parametrize(
    ("name", "owner", "advice"),
    [
        ("step_info", "control", "clpt.linearize"),
        ("bode_plot", "control", "clpt.linearize"),
        ("lsim", "control.matlab", "clpt.simulate"),
        ("input_output_response", "control", "clpt.simulate"),
        ("interconnect", "control", "clpt.connect"),
    ],
)
def test_functions_of_python_control_are_named(name, owner, advice):
    """The package does not repeat python-control, and says where the function is."""
    with pytest.raises(AttributeError, match=f"is {owner}.{name}. .*{advice}"):
        getattr(clpt, name)


def test_a_name_near_a_public_one_is_named():
    with pytest.raises(AttributeError, match=r"No clpt_control attribute nonsense$"):
        clpt.nonsense  # noqa: B018 - reading it is the test
    with pytest.raises(AttributeError, match=r"plot. Call run\.clpt\.plot\(\)"):
        clpt.plot  # noqa: B018
    with pytest.raises(AttributeError, match=r"Did you mean clpt\.simulate\?"):
        clpt.simulat  # noqa: B018
    with pytest.raises(AttributeError, match=r"Did you mean clpt\.gliders\.read_dives"):
        clpt.gliders.read_dive  # noqa: B018
    with pytest.raises(AttributeError, match=r"Did you mean clpt\.parts\.pid\?"):
        clpt.parts.PID  # noqa: B018


def sampled_loop():
    lag = control.ss([[-1.0]], [[1.0]], [[1.0]], 0, inputs="u", outputs="y", name="lag")
    pid = clpt.parts.pid(2.0, 1.0, 0.0, dt=0.1, r="r", y="y", u="u")
    return clpt.connect([pid, lag], external="r")


@pytest.mark.parametrize("name", ["bode_plot", "nyquist_plot", "poles", "dcgain"])
def test_functions_of_linear_systems_name_the_remedy(name):
    with pytest.raises(AttributeError, match=r"of linear systems. Give .*linearize"):
        getattr(control, name)(sampled_loop())
    assert not hasattr(sampled_loop(), "nonsense")


def test_what_the_advice_names_takes_a_sampled_loop():
    """control.step_info and bode_plot of clpt.linearize(diagram)."""
    linear = clpt.linearize(sampled_loop())["y", "r"]
    assert control.step_info(linear)["SteadyStateValue"] == pytest.approx(1.0)
    response = control.frequency_response(linear, [0.01])
    assert response.magnitude.squeeze() == pytest.approx(1.0, abs=1e-3)


@pytest.mark.parametrize("time", [1777593600000.0, math.nan])  # milliseconds, none
def test_a_fix_in_milliseconds_is_refused(time):
    found = clpt.currents.FlowEstimator(OF_FIXES)
    says(
        clpt.DataError,
        "must be finite, s since .*by 1000",
        found.fix,
        time,
        *PLACE.values(),
    )


def test_files_have_the_ending_of_their_kind(tmp_path):
    run = clpt.simulate(SHORT)
    said = r"x\.csv: a run's name must end in \.nc"
    says(clpt.DataError, said, clpt.save_run, run, tmp_path / "x.csv")
    said = r"x\.nc: a scenario's name must end in \.toml"
    says(clpt.DataError, said, clpt.save_scenario, SHORT, tmp_path / "x.nc")
    assert not [*tmp_path.iterdir()]
