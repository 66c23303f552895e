"""A system as its equations are: "x' = -k*x + d; V = x**2/2; k = 2; input d; at x = 0".

Functions are NumPy's, or Python's, states stand in their order, and k is a parameter.
"""

import builtins

import control
import numpy as np

from clpt_control import Block, lookup

NUMPY = vars(np) | vars(builtins) | {"lookup": lookup}


def system(rates, inputs=(), params=None, **named):
    """A system of python-control: what `rates` takes are its states, t, inputs and parameters."""
    params, inputs = params or {}, list(inputs)
    taken = rates.__code__.co_varnames[: rates.__code__.co_argcount]
    states = [name for name in taken if name not in ("t", *inputs, *params)]

    def update(t, x, u, p):
        known = {
            "t": t,
            **dict(zip(states, x, strict=True)),
            **dict(zip(inputs, u, strict=True)),
        }
        return np.array(
            rates(*(known[name] if name in known else p[name] for name in taken))
        )

    given = {"inputs": inputs or 0, "states": states, "params": params, "name": "plant"}
    return control.nlsys(update, **given | named)


def written(text):
    """The system that is written, its V, and where it rests."""
    rates, params, rest, inputs, level = {}, {}, {}, [], None
    for part in text.split("; "):
        name, _, value = part.partition(" = ")
        if name.endswith("'"):
            rates[name[:-1]] = value
        elif name == "V":
            level = value
        elif name.startswith("at "):
            rest[name[3:]] = float(eval(value, NUMPY))
        elif name.startswith("input "):
            inputs.append(name[6:])
        else:
            params[name] = float(value)
    taken = ", ".join(["t", *rates, *inputs, *params])
    made = eval(f"lambda {taken}: [{', '.join(rates.values())}]", NUMPY)
    return (
        system(made, inputs, params),
        signals(level, [*rates]),
        *[{"at": rest}] * bool(rest),
    )


def signals(level, states):
    """V as a function of signals; half the squares of states where none is given."""
    code = compile(level or f"({' + '.join(f'{s}**2' for s in states)})/2", "V", "eval")
    names = [name for name in code.co_names if name in states or name not in NUMPY]
    return lambda s: eval(code, NUMPY, {name: getattr(s, name) for name in names})


def whole_times(p, t0, t1):
    """Breakpoints at whole times."""
    return np.arange(np.floor(t0) + 1, np.floor(t1) + 1)


TICKS = {"parameters": {"interval": -1.0}, "breakpoints": whole_times}


def ticking(update, jump, name="b", **more):
    """A block of one state that jumps at whole times."""
    return Block(name, update=update, jump=jump, states={"s": 1}, **TICKS | more)


def conclusion_of(verdict):
    """The strongest conclusion; of a rest that is exponentially stable the one without a rate."""
    names = (*verdict.conclusions, "")
    return next(name for name in names if name != "exponentially stable")
