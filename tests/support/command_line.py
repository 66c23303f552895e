"""The command `clpt` as an object of Typer: names, options and help of its commands."""

from typer.main import get_command

from clpt_control.app.cli import application


def command():
    """Return the command with all its commands."""
    return get_command(application())
