"""The page of scenarios: `{kernels}` and `{kinds}` are named from their tables in the package."""

from clpt_control.paper.blocks.disturbance import KINDS
from clpt_control.paper.blocks.flow import KERNELS


def with_rows(app, name, source):
    """Name kernels with their formulas, and kinds of disturbances."""
    if name == "scenario":
        kernels = "; ".join(f"`{key}`: {row.formula}" for key, row in KERNELS.items())
        kinds = ", ".join(f"`{kind}`" for kind in KINDS)
        text = source[0].replace("{kernels}", kernels.replace("^2", "²"))
        source[0] = text.replace("{kinds}", kinds)


def setup(app):
    """Fill the page as it is read."""
    app.connect("source-read", with_rows)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
