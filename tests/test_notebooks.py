"""The cells of every tutorial and of the gallery run as one file in an empty folder.

`make docs` runs them as notebooks, but keeps results until a page changes; here they meet
today's package.  What a page says in numbers it asserts, in cells that are not shown.
"""

import importlib.util
import re
import sys
from pathlib import Path

import pytest
from processes import ran

ROOT = Path(__file__).parent.parent
CELL = re.compile(r"^```\{code-cell\}[^\n]*\n(?::[^\n]*\n)*(.*?)^```$", re.M | re.S)
PAGES = [
    path
    for folder in ("tutorials", "gallery")
    for path in sorted((ROOT / "docs" / folder).glob("*.md"))
    if CELL.search(path.read_text("utf-8"))
]


def test_there_are_pages():
    assert len(PAGES) > 10


@pytest.mark.slow
@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.stem)
def test_the_cells_run(path, tmp_path):
    code = "\n".join(CELL.findall(path.read_text("utf-8")))
    if "IPython" in code and importlib.util.find_spec("IPython") is None:
        pytest.skip("IPython is not installed; `make docs` installs it")
    (tmp_path / "page.py").write_text(
        f"import matplotlib\n\nmatplotlib.use('agg')\n{code}", "utf-8"
    )
    ran(sys.executable, "page.py", cwd=tmp_path)
