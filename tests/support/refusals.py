"""A mistake is refused by one sentence."""

import pytest

from clpt_control import DataError


def refuses(said, call, *given, error=DataError, **more):
    """Find a pattern in the one line that a call raises; return that line."""
    with pytest.raises(error, match=said) as caught:
        call(*given, **more)
    assert "\n" not in str(caught.value)
    return str(caught.value)
