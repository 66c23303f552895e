"""Public names: each room finds all of its own, and type checkers see them."""

import inspect
import subprocess
import sys
from pathlib import Path

import pytest

import clpt_control

PACKAGE = Path(clpt_control.__file__).parent
ROOMS = [name for name in clpt_control.__all__ if inspect.ismodule(getattr(clpt_control, name))]
FOUND = (  # by clpt.<tab>
    "theory.prove",
    "theory.audit",
    "ensemble.run_ensemble",
    "conformance.conformance",
    "draw",
    "connect",
    "simulation.explained_variance",
    *(name for name, value in vars(clpt_control.errors).items() if inspect.isclass(value)),
)


@pytest.mark.parametrize("name", FOUND)
def test_the_face_finds(name):
    value = clpt_control
    for part in name.split("."):
        assert part in dir(value)
        value = getattr(value, part)


@pytest.mark.parametrize("room", ["", *ROOMS])
def test_every_name_of_a_room_is_there(room):
    module = getattr(clpt_control, room) if room else clpt_control
    assert module.__doc__
    for name in module.__all__:
        assert getattr(module, name) is not None
        assert name in dir(module)
    with pytest.raises(AttributeError):
        _ = module.no_such_name


@pytest.mark.parametrize("room", ROOMS)
def test_no_name_is_a_file_too(room):
    """Importing a file puts it on its room, in place of a function of the same name."""
    module = getattr(clpt_control, room)
    files = {path.stem for path in (PACKAGE / room).iterdir()}
    both = {n for n in module.__all__ if n in files and not inspect.ismodule(getattr(module, n))}
    assert both == set()


def test_importing_the_package_is_light():
    heavy = ("control", "sympy", "matplotlib", "xarray", "pandas", "scipy", "pydantic")
    code = f"import clpt_control, sys; print([m for m in {heavy} if m in sys.modules])"
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert ran.stdout.strip() == "[]"
