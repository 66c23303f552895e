"""`{names} ROOM`: a table of public names, and after it the docstring of each."""

import inspect
from importlib import import_module

from sphinx.util.docutils import SphinxDirective


class Names(SphinxDirective):
    """The names in the block, a line each, or all names of the room that its argument names."""

    required_arguments = 1
    has_content = True

    def run(self) -> list:
        """Write the table and what autodoc is asked, and parse both."""
        room = import_module(self.arguments[0])
        values = {name: getattr(room, name) for name in self.content or room.__all__}
        lines = [f".. currentmodule:: {self.arguments[0]}", "", ".. list-table::", ""]
        for name, value in values.items():
            kind = "mod" if inspect.ismodule(value) else "obj"
            target = value.__name__ if kind == "mod" else name
            summary = inspect.getdoc(value).splitlines()[0]
            lines += [f"   * - :py:{kind}:`{name} <{target}>`", f"     - {summary}"]
        for name, value in values.items():
            lines += ["", *entry(name, value)]
        return self.parse_text_to_nodes("\n".join(["```{eval-rst}", *lines, "```"]))


def entry(name: str, value: object) -> list[str]:
    """The directive for a name, with the methods of a class; those of a module are words."""
    if inspect.ismodule(value):
        return [f".. automodule:: {value.__name__}", "   :members:", ""]
    if inspect.isclass(value):
        return [f".. autoclass:: {name}", "   :members:", ""]
    return [f".. autofunction:: {name}", ""]


def setup(app):
    """Add the directive."""
    app.add_directive("names", Names)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
