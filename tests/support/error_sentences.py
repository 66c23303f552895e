"""A mistake is an error of one sentence."""

import pytest


def says(error, said, call, *given, **options):
    """Call what must fail: the error is of this kind, has these words, if any, and one line."""
    with pytest.raises(error, match=said or None) as caught:
        call(*given, **options)
    assert "\n" not in str(caught.value)
