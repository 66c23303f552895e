"""The command `clpt`.

Results go to standard output, progress and complaints to standard error.  Exit
status 0 is done, 1 a run that failed, 2 a user's mistake, 130 an interrupt;
each failure is one sentence.  Commands import what they need when they run, so
that `clpt --help` answers at once.
"""

import errno
import gc
import io
import os
import sys
import warnings
from contextlib import suppress

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

LONGEST = 1200  # letters of a sentence; names and values may have more
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
    warnings.showwarning = lambda *_: None  # what is wrong is said by sentences
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors="backslashreplace")  # names of files may hold any bytes
    try:
        status = app(standalone_mode=False)
        sys.stdout.flush()
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
        _complain("out of memory; give less at once: fewer samples, members, files or places", 1)
    except OSError as error:
        if error.errno != errno.ENOSPC or error.filename is not None:
            _fault(error)
        with suppress(OSError, ValueError):  # what is left to write is let go
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        _complain("standard output: no space left; give it a place with more", 2)
    except Exception as error:
        _fault(error)
    if status == 130:
        _complain(INTERRUPTED, 130)
    sys.exit(status if isinstance(status, int) else 0)


def _fault(error: Exception) -> None:
    """Say that a fault is ours, in one line all the same."""
    cause: BaseException | None = error
    while cause is not None:  # an interrupted import of compiled code fails as it likes
        if isinstance(cause, KeyboardInterrupt):
            _complain(INTERRUPTED, 130)
        cause = cause.__cause__ or cause.__context__
    if os.environ.get("CLPT_TRACEBACK"):
        raise error
    kind = type(error).__name__
    _complain(f"fault in clpt: {kind}: {error}; CLPT_TRACEBACK=1 shows where", 1)


def _complain(sentence: str, status: int) -> None:
    line = " ".join(sentence.split()).encode(errors="backslashreplace").decode()
    if len(line) > LONGEST:
        line = f"{line[: LONGEST // 2]} ... {line[-LONGEST // 2 :]}"
    typer.echo(f"clpt: {line}", err=True)
    sys.exit(status)
