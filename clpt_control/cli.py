"""The command `clpt`.

Results go to standard output, progress and complaints to standard error.  Exit
status 0 is done, 1 a run that failed, 2 a user's mistake, 130 an interrupt;
each failure is one sentence.  Commands import what they need when they run, so
that `clpt --help` answers at once.
"""

import gc
import os
import sys

import typer

from .commands.diagram import diagram
from .commands.ensemble import ensemble
from .commands.excitation import excitation
from .commands.fit import fit
from .commands.init import init
from .commands.paper import paper
from .commands.prove import prove
from .commands.replay import replay
from .commands.run import run
from .commands.tides import tides
from .errors import ClptError, SimulationError

INTERRUPTED = "interrupted; nothing half-written was left"

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


def main() -> None:
    """Run the command line; a failure is a sentence and a status."""
    gc.set_threshold(200_000, 50, 50)  # imports make many objects and no garbage
    try:
        status = app(standalone_mode=False)
    except SimulationError as error:
        _complain(str(error), 1)
    except ClptError as error:
        _complain(str(error), 2)
    except typer.TyperException as error:
        _complain(error.format_message(), 2)
    except (KeyboardInterrupt, typer.Abort):
        _complain(INTERRUPTED, 130)
    except BrokenPipeError:
        sys.exit(0)
    except MemoryError:
        _complain("out of memory; record fewer samples (run.output_step)", 1)
    except Exception as error:  # a fault of ours: one line all the same
        if os.environ.get("CLPT_TRACEBACK"):
            raise
        kind = type(error).__name__
        _complain(f"fault in clpt: {kind}: {error}; CLPT_TRACEBACK=1 shows where", 1)
    if status == 130:
        _complain(INTERRUPTED, 130)
    sys.exit(status if isinstance(status, int) else 0)


def _complain(sentence: str, status: int) -> None:
    line = " ".join(sentence.split())
    typer.echo(f"clpt: {line}", err=True)
    sys.exit(status)
