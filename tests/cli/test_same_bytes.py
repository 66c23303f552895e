"""The same command gives the same bytes: with a cold and a warm cache, 1 and 4 threads, any hashes.

What is printed and each file that is written are compared, byte by byte.  `clpt design` is asked
with one thread: the optimizer of SciPy that it climbs with rounds by the number of BLAS's threads.
"""

import os

import pytest
from processes import CLPT, ran, without_progress
from written import COMMANDS, write_each

THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
TIMED = ("refute", "replay --follow")  # which tell how long something took, or when it was
SAME = [words for words in COMMANDS if not " ".join(words).startswith(TIMED)]
OFTEN = "diagram"  # in `make test`; the others by `make test-processes`


def held(folder):
    files = (path for path in sorted(folder.rglob("*")) if path.is_file())
    return {str(path.relative_to(folder)): path.read_bytes() for path in files}


@pytest.fixture(scope="module")
def given(tmp_path_factory):
    folder = tmp_path_factory.mktemp("given")
    write_each(folder, 420)
    return held(folder)


@pytest.mark.parametrize(
    "words", [c if c[0] == OFTEN else pytest.param(c, marks=pytest.mark.processes) for c in SAME]
)
def test_the_same_command_gives_the_same_bytes(given, tmp_path, words):
    found = []
    for seed, threads in (("1", "1"), ("2", "1" if words[0] == "design" else "4")):
        work = tmp_path / "work"  # the same name: it is part of what is printed
        for name, content in given.items():
            (work / name).parent.mkdir(parents=True, exist_ok=True)
            (work / name).write_bytes(content)
        env = {**os.environ, **dict.fromkeys(THREADS, threads), "PYTHONHASHSEED": seed}
        env["CLPT_CONTROL_CACHE"] = str(tmp_path / "cache")  # cold, then warm
        more = ("--threads", threads) if words[0] == "ensemble" else ()
        done = ran(*CLPT, *words, *more, cwd=work, env=env)
        assert without_progress(done.stderr) == ""
        found.append((done.stdout, held(work)))
        work.rename(tmp_path / f"work{seed}")
    (said, files), (again, others) = found
    assert said == again
    assert files.keys() == others.keys()
    assert [name for name in files if files[name] != others[name]] == []
