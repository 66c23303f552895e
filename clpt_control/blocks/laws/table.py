"""The table of laws: `learning.law` is a name of it, `clpt laws` prints it, `clpt prove` proves it.

To add a law, write its page and put its row, `LAW`, in here; CONTRIBUTING has the recipe.
"""

from . import composite_least_squares, composite_memory, known_flow, learned_flow
from .law import Law

LAWS: dict[str, Law] = {
    page.LAW.name: page.LAW
    for page in (learned_flow, known_flow, composite_least_squares, composite_memory)
}
