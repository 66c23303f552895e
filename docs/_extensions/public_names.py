"""`{names} ROOM`: a table of public names, and after it what the docstring of each says."""

import inspect
from importlib import import_module

from sphinx.util.docutils import SphinxDirective


class Names(SphinxDirective):
    """The names that stand in the block, a line each, of the room that its argument names."""

    required_arguments = 1
    has_content = True

    def run(self) -> list:
        """Write what autosummary and autodoc are asked, and parse it."""
        room = self.arguments[0]
        table = [".. autosummary::", "   :nosignatures:", "", *(f"   {n}" for n in self.content)]
        lines = [f".. currentmodule:: {room}", "", *table, ""]
        for name in self.content:
            lines += entry(name, getattr(import_module(room), name))
        text = "\n".join(["```{eval-rst}", *lines, "```"])
        return self.parse_text_to_nodes(text)


def entry(name: str, value: object) -> list[str]:
    """The directive for a name, with the methods of a class; those of a module are words."""
    if inspect.ismodule(value):
        return [f".. automodule:: {value.__name__}", ""]
    if inspect.isclass(value):
        return [f".. autoclass:: {name}", "   :members:", ""]
    return [f".. autofunction:: {name}", ""]


def setup(app):
    """Add the directive."""
    app.add_directive("names", Names)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
