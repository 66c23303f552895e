"""What tests of ensembles vary, and how they compare stores and datasets."""

VARY = ["learning.gain=0.2:2.0", "flow.parameters~normal:0.1", "learning.position=-1:1"]


def files(folder):
    """Every file of a store with its bytes."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


def assert_identical(one, other):
    assert set(one.variables) == set(other.variables)
    for name in one.variables:
        assert one[name].dims == other[name].dims
        assert one[name].values.tobytes() == other[name].values.tobytes(), name
