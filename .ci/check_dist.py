"""What lies in dist/: the files of the repository, nothing less and nothing more.

`make dist` runs it.  The wheel has each file of the package and its metadata; the sdist each file
of the repository but what only the repository needs; the conda recipe renders.
"""

import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

from rattler_build import Stage0Recipe

OURS = ("clpt_control/",)
MADE = {"PKG-INFO", "setup.cfg"}
ONLY_HERE = (".ci/", ".github/", ".gitignore", ".readthedocs.yaml")


def differ(kind, found, wanted):
    """Print what is missing and what is too much; return whether anything is."""
    for word, names in (("lacks", wanted - found), ("has besides", found - wanted)):
        for name in sorted(names):
            print(f"{kind} {word} {name}", file=sys.stderr)
    return found != wanted


def main():
    """Compare, render, and end with 1 where something is wrong."""
    here = subprocess.run(
        ["git", "ls-files"], capture_output=True, text=True, check=True
    )
    files = set(here.stdout.splitlines())
    [wheel], [sdist] = Path("dist").glob("*.whl"), Path("dist").glob("*.tar.gz")
    with zipfile.ZipFile(wheel) as opened:
        packed = {name for name in opened.namelist() if ".dist-info/" not in name}
    with tarfile.open(sdist) as opened:
        inside = (member.name for member in opened if member.isfile())
        source = {name.split("/", 1)[1] for name in inside}
    source = {name for name in source - MADE if ".egg-info/" not in name}
    wrong = differ("the wheel", packed, {n for n in files if n.startswith(OURS)})
    wrong |= differ(
        "the sdist", source, {n for n in files if not n.startswith(ONLY_HERE)}
    )
    [made] = Stage0Recipe.from_file("conda-recipe/recipe.yaml").render()
    recipe = made.recipe.to_dict()["package"]
    print(f"{wheel}: {len(packed)} files; {sdist}: {len(source)}; conda: {recipe}")
    sys.exit(wrong)


if __name__ == "__main__":
    main()
