"""Fewer samples between fixes: enough for the tolerances of these tests."""

import pytest

from clpt_control.estimation import segments

SAMPLES = 33  # of a track between two fixes


@pytest.fixture(autouse=True)
def few_samples(monkeypatch):
    monkeypatch.setattr(segments, "SAMPLES", SAMPLES)
