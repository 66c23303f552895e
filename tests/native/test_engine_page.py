"""The page on the engine leads to every file; `test_pages_run` runs its commands."""

import re
from pathlib import Path

import clpt_control

PACKAGE = Path(clpt_control.__file__).parent
PAGE = PACKAGE.parent / "docs" / "engine.md"


def test_every_file_of_the_engine_is_on_the_page():
    links = {
        (PAGE.parent / name).resolve() for name in re.findall(r"\]\((\S+?)\)", PAGE.read_text())
    }
    assert all(link.exists() for link in links)
    files = {path for path in (PACKAGE / "native").glob("*.py") if path.stem != "__init__"}
    assert files <= links
