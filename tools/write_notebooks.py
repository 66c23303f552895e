"""Write tutorials as Jupyter notebooks with their outputs: python tools/write_notebooks.py.

The cells of a page of docs/tutorials run in an empty folder.  Cells tagged `remove-cell`, which
test the page, are left out.  Links to pages become their texts, since a notebook stands alone.
`make notebooks` installs what is needed.
"""

import argparse
import re
import sys
import tempfile
from pathlib import Path

import nbformat
from myst_nb.core.read import read_myst_markdown_notebook
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError, CellTimeoutError, DeadKernelError

ROOT = Path(__file__).parent.parent
PAGES = ROOT / "docs" / "tutorials"
TEST = "remove-cell"  # tag
HANGS = 3600  # s of wall time for a cell, which no load makes of one that ends
TO_A_PAGE = re.compile(r"\[([^\]]*)\]\((?!https?:)[^)]*\)")


def notebook_of(text):
    """Return the notebook of a page without the cells that test the page."""
    notebook = read_myst_markdown_notebook(text)
    notebook.cells = [
        cell for cell in notebook.cells if TEST not in cell.metadata.get("tags", [])
    ]
    for cell in notebook.cells:
        if cell.cell_type == "markdown":
            cell.source = TO_A_PAGE.sub(r"\1", cell.source)
    return notebook


def main():
    """Run and write each tutorial, or those that are named."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", help="tutorials; default: all")
    parser.add_argument("--out", type=Path, default=ROOT / "build" / "tutorials")
    arguments = parser.parse_args()
    pages = [path for path in sorted(PAGES.glob("*.md")) if path.stem != "index"]
    names = arguments.names or [path.stem for path in pages]
    if unknown := {*names} - {path.stem for path in pages}:
        parser.error(f"no tutorial {', '.join(sorted(unknown))}")
    arguments.out.mkdir(parents=True, exist_ok=True)
    failed = []
    for name in names:
        notebook = notebook_of((PAGES / f"{name}.md").read_text("utf-8"))
        with tempfile.TemporaryDirectory() as folder:
            resources = {"metadata": {"path": folder}}
            client = NotebookClient(notebook, timeout=HANGS, resources=resources)
            client.record_timing = False  # the same file each time
            try:
                client.execute()
            except (CellExecutionError, CellTimeoutError, DeadKernelError) as error:
                failed.append(name)
                print(f"{name}.md: {error}", file=sys.stderr)  # quotes the cell
                continue
        nbformat.write(notebook, arguments.out / f"{name}.ipynb")
        print(f"Wrote {arguments.out / name}.ipynb")
    if failed:
        sys.exit(f"failed: {', '.join(failed)}")


if __name__ == "__main__":
    main()
