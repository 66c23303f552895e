"""Checker of the certificates of `clpt prove`; the file itself is part of the package."""

import runpy
from pathlib import Path

PACKAGE = Path(__file__).parents[1] / "clpt_control"
runpy.run_path(str(PACKAGE / "data" / "check_certificate.py"), run_name="__main__")
