"""A model that python-control's users make: an adaptive loop of two nonlinear systems."""

import control


def mrac():
    """Model reference adaptive control of x' = a x + b u."""
    plant = control.nlsys(
        lambda t, x, u, p: [p["a"] * x[0] + p["b"] * u[0]], name="plant", states=["x"],
        inputs=["u"], outputs=["y"], params={"a": 1.0, "b": 3.0},
    )  # fmt: skip

    def update(t, x, u, p):
        (ym, *_), (y, r) = x, u
        e = y - ym
        return [-4.0 * ym + 4.0 * r, -p["gain"] * e * y, -p["gain"] * e * r]

    law = control.nlsys(
        update, lambda t, x, u, p: [x[1] * u[0] + x[2] * u[1], u[0] - x[0]], name="law",
        states=["ym", "kx", "kr"], inputs=["y", "r"], outputs=["u", "e"], params={"gain": 2.0},
    )  # fmt: skip
    return control.interconnect(
        [plant, law], inputs=["r"], outputs=["y", "e"], name="mrac", check_unused=False
    )
