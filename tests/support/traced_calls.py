"""Calls of a function in which the engine traces it: its states are no numbers there."""

import sys
from contextlib import contextmanager

import numpy as np


@contextmanager
def traced_calls(name):
    """List the calls of functions of a name with tracer arrays, as long as it lasts."""
    calls = []

    def hear(frame, event, _):
        if event == "call" and frame.f_code.co_name == name:
            x = frame.f_locals.get("x")
            if not isinstance(x, np.ndarray | list | tuple):
                calls.append(type(x))

    before = sys.getprofile()
    sys.setprofile(hear)
    try:
        yield calls
    finally:
        sys.setprofile(before)
