"""`{commands}`: every command of `clpt` with its arguments and options, from typer's own help."""

import inspect
from pathlib import Path
from textwrap import dedent

from sphinx.util.docutils import SphinxDirective


class Commands(SphinxDirective):
    """A section for each command."""

    def run(self) -> list:
        """Read the command line and parse what it says as Markdown."""
        from typer.main import get_command

        from clpt_control.app import cli

        for file in Path(cli.__file__).parent.glob("*.py"):
            self.env.note_dependency(str(file))
        text = "\n\n".join(
            section(
                command,
                command.make_context(f"clpt {name}", [], resilient_parsing=True),
            )
            for name, command in get_command(cli.application()).commands.items()
        )
        return self.parse_text_to_nodes(text, allow_section_headings=True)


def section(command, context) -> str:
    """Markdown of a command: its usage, what it does, arguments and options, an example."""
    usage = f"{context.info_name} {' '.join(command.collect_usage_pieces(context))}"
    about, _, example = inspect.cleandoc(command.help or "").partition(
        "\n\b\nExample:\n"
    )
    parts = [f"## {context.info_name}", f"```text\n{usage}\n```", plain(about, "\n\n")]
    for parameter in command.get_params(context):
        record = parameter.get_help_record(context)
        if record and parameter.name != "help":
            words, said = record
            words = (
                parameter.metavar if parameter.param_type_name == "argument" else words
            )
            parts.append(f"`{words}`\n: {plain(said) or '-'}")
    if example:
        parts.append(f"```text\n{dedent(example).strip()}\n```")
    return "\n\n".join(parts)


def plain(text: str, between: str = " ") -> str:
    """Help as Markdown that shows every letter as it is."""
    parts = [" ".join(part.split()) for part in text.replace("\b", "").split("\n\n")]
    shown = between.join(filter(None, parts))
    for letter in "\\*_`<>[]$~":
        shown = shown.replace(letter, f"\\{letter}")
    return shown


def setup(app):
    """Add the directive."""
    app.add_directive("commands", Commands)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
