"""Names and forms that people write first: of states, times, tables, laws and equations."""

import numpy as np
import pandas as pd
import pytest
from error_sentences import says

import clpt_control as clpt

TIMES = np.linspace(0.0, 4.0, 21)


def room():
    """A room that cools: temp' = q - k temp."""
    return clpt.Block(
        "room",
        update=lambda t, x, u, p: {"temp": u.q - p.k * x.temp},
        states={"temp": 1},
        inputs={"q": 1},
        parameters={"k": 0.5},
    )


def test_a_state_of_one_number_has_its_name_alone():
    loop = clpt.connect([room(), clpt.parts.lag(1.0, u="temp", y="shown")], "q")
    run = clpt.simulate(loop, TIMES, 1.0)
    warm = run.states.sel(state="room_temp")
    np.testing.assert_allclose(warm, 2 * (1 - np.exp(-TIMES / 2)), atol=1e-8)


def test_two_samples_are_noted():
    noted = "two samples, for more see np.linspace"
    assert noted in clpt.simulate(room(), (0, 10)).attrs["message"]
    assert noted not in clpt.simulate(room(), TIMES).attrs["message"]


@pytest.mark.parametrize(
    ("operation", "text", "latex"),
    [
        (
            np.equal,
            "where(Eq(mode(t), 1), a(t), 0)",
            r"a & \text{for}\: \mathrm{mode} = 1 \\0 &",
        ),
        (np.not_equal, "where(not_(Eq(mode(t), 1)), a(t), 0)", r"\mathrm{mode} \neq 1"),
        (np.less_equal, "where(le(mode(t), 1), a(t), 0)", r"\mathrm{mode} \leq 1"),
    ],
)
def test_a_comparison_of_equals_is_an_equation(operation, text, latex):
    switch = clpt.Block(
        "switch",
        output=lambda t, x, u, p: np.where(operation(u.mode, 1), u.a, 0.0),
        inputs={"mode": 1, "a": 1},
        outputs={"y": 1},
    )
    equations = clpt.equations(switch)
    assert f"{equations}" == f"y = {text}"
    assert latex in equations.latex()


@pytest.mark.parametrize("form", ["column", "index", "timepts"])
def test_a_table_of_pandas_is_fitted(form):
    """temp = 3 exp(-0.7 t) of a room without heating."""
    table = pd.DataFrame({"temp": 3 * np.exp(-0.7 * TIMES)})
    given = {"timepts": TIMES} if form == "timepts" else {}
    if form != "timepts":
        table["time"] = TIMES
    if form == "index":
        table = table.set_index("time")
    found = clpt.fit_parameters(
        room(),
        table[["temp"]] if form != "column" else table[["time", "temp"]],
        {"room.k": 0.5, "x0.temp": 1.0},
        **given,
    )
    assert [*found.values.values()] == pytest.approx([0.7, 3.0], rel=1e-6)


def test_a_table_without_times_is_refused():
    table = pd.DataFrame({"temp": np.exp(-TIMES)})
    said = "timepts: is required with arrays, or a table without `time`"
    says(clpt.ClptError, said, clpt.fit_parameters, room(), table, {"room.k": 0.5})


@pytest.mark.long
def test_a_law_is_proved_by_its_name():
    verdict = clpt.prove("sigma", points=50)
    assert (verdict.status, verdict.conclusion) == ("proved", "ultimately bounded")
    said = "there is no sigmaa. Did you mean 'sigma'"
    says(clpt.ArgumentError, said, clpt.prove, "sigmaa")


def test_sentences_name_what_is_missing():
    run = clpt.simulate(room(), TIMES, 1.0)
    said = "has no output 'position'. It has temp"
    says(clpt.ClptError, said, run.clpt.linearize, 1.0, output="position")
    ports = {"output": lambda t, x, u, p: u.a, "inputs": {"a": 1}}
    says(clpt.ClptError, r"`outputs=\{'y': 1\}`", lambda: clpt.Block("b", **ports))
    says(
        clpt.ClptError,
        r"such as \{'y': 1\}",
        lambda: clpt.Block("b", outputs="y", **ports),
    )
    rows = np.ones((21, 1))
    said = r"shape \(21, 1\): give \(1, 21\)"
    says(clpt.ClptError, said, clpt.simulate, room(), TIMES, rows)
