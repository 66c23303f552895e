"""Functions whose text Python has not kept are read as safely as others, or refused."""

import math
import random
import time

import numpy as np
import pytest

from clpt_control.blocks import Block
from clpt_control.blocks.words import WORDS
from clpt_control.errors import BlockError
from clpt_control.native import readings

STATE = [0.0]


def made(body, head="def f(t, x, u, p, y):", **names):
    """A function made by exec; inspect finds no text of it."""
    space = {
        "math": math,
        "np": np,
        "time": time,
        "random": random,
        "STATE": STATE,
        "G": 2.0,
        **WORDS,
        **names,
    }
    exec(f"{head}\n" + "\n".join(f"    {line}" for line in body.split("\n")), space)
    return space["f"]


def block(function):
    return Block("mine", output=function, inputs={"u": 3}, outputs={"y": 1})


REFUSED = {
    "y[0] = u[0]\nif u[0] > 0:\n    y[0] = 1.0": "a choice that depends on a signal or parameter",
    "y[0] = 1.0 if u[0] > 0 else 0.0": "a choice that depends on a signal",
    "y[0] = u[0] and u[1]": "a choice that depends on a signal",
    "y[0] = u[0]\nwhile y[0] < 3:\n    y[0] += 1.0": "a choice that depends on a signal",
    "y[0] = where(u[0] == 1.0, 1.0, 2.0)": "`==` between signals or parameters",
    "y[0] = u[0] * time.time()": "`time` \\(time\\)",
    "y[0] = u[0] * random.random()": "`random` \\(random\\)",
    "y[0] = np.exp(u[0])": "`np` \\(numpy\\)",
    "STATE[0] += 1.0\ny[0] = STATE[0]": "`STATE` \\(list\\)",
    "global G\nG = 3.0\ny[0] = u[0]": "`global`",
    "import time\ny[0] = time.time()": "`import`",
    "y[0] = (lambda a: a)(u[0])": "a function or a comprehension inside a function",
    "y[0] = max(u[0], u[1])": "`max`",
    "y[0] = abs(u[0])": "`abs`",
    "y[0] = u[0]\nprint(u[0])": "`print`",
    "raise ValueError": "`ValueError`",
    "assert G > 0\ny[0] = u[0]": "`raise` or `assert`",
    "try:\n    y[0] = math.sqrt(u[0])\nfinally:\n    y[0] = 0.0": "`try` or `with`",
    "y[0] = wibble(u[0])": "the unknown name `wibble`",
    "y[0] = math.isnan(u[0])": "`math.isnan`",
    "y[0] = float(u[0].real)": "'Number' object has no attribute 'real'",
    "y[0] = STATE.pop()": "`STATE` \\(list\\)",
    "return u[0]": "returning a value",
    "y[0] = u[0]\nyield u[0]": "`yield`",
}


@pytest.mark.parametrize("body", REFUSED)
def test_refused_in_one_sentence(body):
    with pytest.raises(BlockError, match=REFUSED[body]) as caught:
        block(made(body))
    sentence = str(caught.value)
    assert sentence.startswith("mine.output")
    assert "\n" not in sentence


READ = {
    "y[0] = G * math.sin(u[0]) + where(u[1] > 0, u[1], -u[1])": (0.3, -0.7, 2.0),
    "s = 0.0\nfor i in range(3):\n    s += i * u[i]\ny[0] = s": (0.3, -0.7, 2.0),
    "s = 0.0\nfor a in u:\n    s += a\ny[0] = s": (0.3, -0.7, 2.0),
    "k = 3\nwhile k > 0:\n    k -= 1\ny[0] = k + u[k]": (0.3, -0.7, 2.0),
    "y[0] = u[len(u) - 1] ** 2 + floor(u[0])": (0.3, -0.7, 2.0),
}


@pytest.mark.parametrize("body", READ)
def test_read_alike(body):
    function, u, out = made(body), READ[body], np.zeros(1)
    function(0.0, None, u, None, out)
    for name, ask in readings(block(function)).items():
        assert ask(0.0, [], u)[1][0] == pytest.approx(out[0], rel=1e-14), name


def test_one_code_with_other_numbers_is_another_function():
    body = "y[0] = G * u[0] + h(u[1])"
    texts = {}
    for G in (2.0, 3.0, -0.0):
        for k in (1.0, 5.0):
            helper = made("return k * a", "def f(a, *, k=K):", K=k)
            texts[G, k] = readings(block(made(body, G=G, h=helper)))
    for (G, k), asked in texts.items():
        for name, ask in asked.items():
            found = ask(0.0, [], [7.0, 11.0, 0.0])[1][0]
            assert found == pytest.approx(7.0 * G + 11.0 * k, rel=1e-15), (name, G, k)


@pytest.mark.parametrize("default", [[0.0], np.zeros(2), {"a": 1.0}, None, "text"])
@pytest.mark.parametrize("keyword", ["", "*, "])
def test_default_arguments_are_numbers(default, keyword):
    helper = made("return a", f"def f(a, {keyword}memory=M):", M=default)
    kind = type(default).__name__
    with pytest.raises(BlockError, match=f"has a default argument that is a {kind}; only numbers"):
        block(made("y[0] = h(u[0])", h=helper))


def test_text_that_is_not_the_functions_own_hides_nothing(tmp_path):
    file = tmp_path / "harmless.py"
    file.write_text("def f(t, x, u, p, y):\n    y[0] = u[0]\n")
    space = {"time": time}
    text = "def f(t, x, u, p, y):\n    y[0] = u[0] * time.time()\n"
    exec(compile(text, str(file), "exec"), space)
    with pytest.raises(BlockError, match="`time`"):
        block(space["f"])
