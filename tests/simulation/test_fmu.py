"""Functional mock-up units: what an importer reads and calls, and the numbers that it gets.

FMI's public checker, FMPy, is asked where it is installed (`pip install fmpy`).
"""

import ctypes
import tempfile
import zipfile
from xml.etree import ElementTree

import control
import numpy as np
import pytest
from example_models import MODELS, discrete
from test_export import library, needs_cc, tables_over_time

import clpt_control as clpt
from clpt_control import ClptError


class Importer:
    """A small importer: it integrates by Runge and Kutta's method, and stops at events."""

    def __init__(self, path, folder):
        with zipfile.ZipFile(path) as file:
            self.model = ElementTree.fromstring(file.read("modelDescription.xml"))
            (source,) = (name for name in file.namelist() if name.endswith(".c"))
            self.library = library(file.read(source), folder)
        self.kinds = {one.get("name"): one.attrib for one in self.model.iter("Float64")}
        self.states = [name for name in self.kinds if name.startswith("state.")]
        make = self.library.fmi3InstantiateModelExchange
        make.restype = ctypes.c_void_p
        token = self.model.get("instantiationToken").encode()
        other, self.at = (
            make(b"", t, b"", False, False, None, None) for t in (b"another", token)
        )
        assert other is None

    def call(self, name, *arguments):
        assert (
            getattr(self.library, f"fmi3{name}")(ctypes.c_void_p(self.at), *arguments)
            == 0
        )

    def exchange(self, kind, names, values):
        places = (ctypes.c_uint32 * len(names))(
            *([*self.kinds].index(name) for name in names)
        )
        count, data = ctypes.c_size_t(len(names)), np.array(values, dtype=float)
        self.call(
            f"{kind}Float64", places, count, data.ctypes.data_as(ctypes.c_void_p), count
        )
        return data

    def get(self, *names):
        return self.exchange("Get", names, np.zeros(len(names)))

    def initialize(self, **given):
        no = ctypes.c_double(0.0)
        self.call("EnterInitializationMode", False, no, no, False, no)
        self.exchange("Set", [*given], [*given.values()])
        self.call("ExitInitializationMode")
        return self.update()

    def update(self):
        flags, following = [ctypes.c_bool() for _ in range(5)], ctypes.c_double()
        self.call("UpdateDiscreteStates", *map(ctypes.byref, (*flags, following)))
        return following.value if flags[4].value else np.inf

    def rates(self, t, x):
        pointer, n, dx = ctypes.c_void_p, ctypes.c_size_t(len(x)), np.zeros(len(x))
        self.call("SetTime", ctypes.c_double(t))
        self.call("SetContinuousStates", x.ctypes.data_as(pointer), n)
        self.call("GetContinuousStateDerivatives", dx.ctypes.data_as(pointer), n)
        return dx

    def run(self, until, following, h):
        t, x = 0.0, self.get(*self.states)
        while t < until - 1e-12:
            stop = min(until, following)
            step = (stop - t) / np.ceil((stop - t) / h - 1e-9)
            a = self.rates(t, x)
            b = self.rates(t + step / 2, x + step / 2 * a)
            c = self.rates(t + step / 2, x + step / 2 * b)
            d = self.rates(t + step, x + step * c)
            t, x = t + step, x + step / 6 * (a + 2 * b + 2 * c + d)
            self.rates(t, x)
            if t >= following - 1e-12:
                following, x = self.update(), self.get(*self.states)
        return x


def end_of(name):
    """Return the time of the end of a model's run, its inputs by name, and its states there."""
    system, start, u, *_ = MODELS[name]
    inputs = dict(
        zip([label.partition("[")[0] for label in system.input_labels], u, strict=True)
    )
    until = 25.0 if name == "papers-loop" else 6.0
    run = clpt.simulate(system, [0.0, until], u or None, start, rtol=1e-11, atol=1e-13)
    return until, inputs, run.states[-1]


def description(system, folder):
    clpt.export(system, folder / "model.fmu")
    with zipfile.ZipFile(folder / "model.fmu") as file:
        return ElementTree.fromstring(file.read("modelDescription.xml"))


@needs_cc
def test_units_and_least_values_stand_in_the_description(tmp_path):
    tank = clpt.Block(
        "tank",
        update=lambda t, x, u, p: {"h": (u.q - p.a * x.h) / p.A},
        inputs={"q": 1},
        states={"h": 1},
        parameters={"a": 0.5, "A": 2.0},
        units={"h": "m", "q": "m3/s", "A": "m^2", "a": "% of flow"},
    )
    model = description(tank, tmp_path)
    units = {one.get("name"): one.get("unit") for one in model.iter("Float64")}
    assert units == {
        **{"time": None, "der(state.h)": None, "state.h": "m", "h": "m"},
        **{"q": "m3/s", "tank.A": "m^2", "tank.a": "% of flow"},
    }
    bases = {
        one.get("name"): [part.attrib for part in one] for one in model.iter("Unit")
    }
    assert bases == {
        **{"m": [{"m": "1"}], "m3/s": [{"m": "3", "s": "-1"}]},
        **{"m^2": [{"m": "2"}], "% of flow": []},
    }
    lag = description(clpt.parts.point_vehicle(mass=2.0, damping=0.0), tmp_path)
    least = {one.get("name"): one.get("min") for one in lag.iter("Float64")}
    assert 0.0 < float(least["point_vehicle.mass"]) < 1e-300
    assert float(least["point_vehicle.damping"]) == 0.0


EVENTS = "papers-loop", "mrac", "sampled-tank", "teeth"


@needs_cc
@pytest.mark.parametrize("name", EVENTS)
def test_an_importer_gets_the_run(name, tmp_path):
    until, inputs, end = end_of(name)
    clpt.export(MODELS[name].system, tmp_path / "model.fmu", MODELS[name].start)
    found = Importer(tmp_path / "model.fmu", tmp_path)
    following = found.initialize(**inputs)
    assert np.allclose(found.run(until, following, 5e-3), end, rtol=1e-7, atol=1e-9)


@pytest.mark.long
@needs_cc
def test_values_are_set_and_what_is_fixed_is_not(tmp_path):
    def importer(system, **given):
        clpt.export(system, tmp_path / "lag.fmu", **given)
        return Importer(tmp_path / "lag.fmu", tmp_path)

    rate = lambda t, x, u, p: [-p["k"] * x[0] if p["fast"] > 0 else 0 * x[0]]  # noqa: E731
    ports = {"states": ["x"], "inputs": ["u"], "outputs": ["y"], "name": "lag"}
    system = control.nlsys(rate, params={"k": 2.0, "fast": 1.0}, **ports)
    found = importer(system, initial_state=[3.0], params={"k": 4.0})
    assert found.kinds["lag.fast"]["variability"] == "constant"
    assert found.kinds["lag.k"]["causality"] == "parameter"
    assert found.get("state.x", "der(state.x)", "lag.k", "y").tolist() == [
        3.0,
        -12.0,
        4.0,
        3.0,
    ]
    found.initialize(**{"lag.k": 0.5, "state.x": 2.0})
    assert found.get("der(state.x)", "y").tolist() == [-1.0, 2.0]
    found.call("Reset")
    assert found.get("der(state.x)").tolist() == [-12.0]
    assert found.library.fmi3GetFloat32(found.at) == 3  # an error: there is none
    limits = [
        importer(clpt.parts.pid(1.0, 0.2)).kinds[f"pid.{end}"]
        for end in ("low", "high")
    ]
    # XML Schema, part 2, 3.2.5
    assert [one["start"] for one in limits] == ["-INF", "INF"]


@needs_cc
def test_parameters_behind_a_table_over_time_are_set_by_their_names(tmp_path):
    system = tables_over_time(jumps=True)
    clpt.export(system, tmp_path / "loop.fmu")
    found = Importer(tmp_path / "loop.fmu", tmp_path)
    given = {"lag.m": 1.5, "lag.w": [0.3, -1.0, 2.0], "table.k": 4.0}
    assert found.get("first.v[2]", "table.h", "lag.m", "lag.w[1]").tolist() == [
        0.3,
        7.0,
        0.5,
        2.0,
    ]
    weights = {f"lag.w[{k}]": value for k, value in enumerate(given["lag.w"])}
    following = found.initialize(**{"lag.m": 1.5, "table.k": 4.0}, **weights)
    right = clpt.simulate(system, [0.0, 2.0], params=given, rtol=1e-10, atol=1e-12)
    ends = found.run(2.0, following, 1e-3)
    np.testing.assert_allclose(ends, right.states.values[-1], rtol=1e-6)


@pytest.mark.parametrize("lost", ["a compiler", "a folder"])
def test_where_nothing_can_be_compiled_it_holds_its_source(
    lost, tmp_path, monkeypatch, capsys
):
    if lost == "a compiler":
        monkeypatch.setenv("CC", "no-compiler-of-this-name")
    else:
        monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "none"))
    for name in ("lag.fmu", "again.fmu"):
        clpt.export(control.tf(1, [1, 1], name="lag" * 100), tmp_path / name)
    assert (tmp_path / "lag.fmu").read_bytes() == (tmp_path / "again.fmu").read_bytes()
    assert "clpt: the FMU holds its source alone" in capsys.readouterr().err
    with zipfile.ZipFile(tmp_path / "lag.fmu") as file:
        # a name that a folder may hold
        source = file.getinfo(f"sources/{'lag' * 20}.c")
        assert not [name for name in file.namelist() if name.startswith("binaries")]
    assert source.compress_size < 0.5 * source.file_size


def test_what_has_no_model_exchange_is_refused(tmp_path):
    with pytest.raises(
        ClptError, match=r"time is discrete; clpt\.export to C has its step"
    ):
        clpt.export(discrete(), tmp_path / "model.fmu")
    assert not (tmp_path / "model.fmu").exists()


@needs_cc
@pytest.mark.parametrize("name", [*EVENTS, "names"])
def test_the_public_checker_finds_nothing(name, tmp_path):
    fmpy = pytest.importorskip("fmpy", reason="FMPy is not installed")
    from fmpy.validation import validate_fmu

    until, inputs, end = end_of(name) if name != "names" else (1.0, {}, None)
    file = str(tmp_path / "model.fmu")
    clpt.export(MODELS[name].system, file, MODELS[name].start)
    assert validate_fmu(file) == []
    options = {"start_values": inputs, "output": Importer(file, tmp_path).states}
    last = fmpy.simulate_fmu(file, start_time=0.0, stop_time=until, **options)[-1]
    assert end is None or np.allclose([*last][1:], end, rtol=1e-6, atol=1e-8)
