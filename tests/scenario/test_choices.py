"""What a scenario may choose is what blocks have."""

from typing import get_args

import pytest

from clpt_control.blocks import basis, disturbance
from clpt_control.scenario.tables import Disturbance, Kernel


@pytest.mark.parametrize(
    ("allowed", "made"),
    [
        (get_args(Kernel), basis.KERNELS),
        (get_args(Disturbance.model_fields["kind"].annotation), disturbance.KINDS),
    ],
)
def test_every_choice_is_made(allowed, made):
    assert set(allowed) == set(made)
