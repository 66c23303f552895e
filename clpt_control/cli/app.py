"""All commands of `clpt`."""

import typer

from .diagram import diagram
from .ensemble import ensemble
from .excitation import excitation
from .fit import fit
from .init import init
from .paper import paper
from .prove import prove
from .replay import replay
from .run import run
from .tides import tides

app = typer.Typer(
    name="clpt",
    help="Adaptive learning for controlled Lagrangian particle tracking.",
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
)

for command in (init, paper, run, diagram, ensemble, prove, excitation, fit, tides, replay):
    app.command()(command)
