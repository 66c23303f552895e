"""Eight runs at once: a block's equations read in SIMD lanes.

    f(t, x, u, p, out)  with  float -> <8 x double>

The functions here are for compiled code (`numba.njit`): there a `Lanes` value
holds a number of eight runs, and the block's own function, compiled by
`lane_compiled`, works on all eight at once.  Each lane gets the bits it would
get in any other lane and beside any neighbours.

Two blocks in one function, phi at x and theta phi, with theta of each run::

    phi, true = lane_compiled(basis.exponential), lane_compiled(flow.true)

    @njit(error_model="numpy")
    def rate(t, x, centers, widths, frequencies, phases, theta, out):
        p_basis = BasisParameters(3, centers, widths, frequencies, phases)  # shared
        p_flow = TrueFlowParameters(3, lane_matrix(theta))                  # (2, 3, 8)
        time, position = lane_vector(t)[0], lane_vector(x)                  # (1, 8), (2, 8)
        u = lane_buffer(5)                              # x[2], phi_x[3], on the stack
        u[0], u[1] = position[0], position[1]
        phi(time, position, position, p_basis, u[2:5])
        true(time, position, u, p_flow, lane_vector(out))
"""

from .exponentials import power
from .intrinsics import (
    absolute,
    all_lanes,
    any_lane,
    copysign,
    fma,
    lane_get,
    lane_numbers,
    lane_set,
    mask_bits,
    select,
    splat,
    square_root,
)
from .kinds import LANES, lane_mask, lanes
from .memory import lane_buffer, lane_matrix, lane_vector
from .reading import WORDS, clip, floor, lane_compiled, lookup, maximum, minimum, sign, where

__all__ = [
    "LANES",
    "WORDS",
    "absolute",
    "all_lanes",
    "any_lane",
    "clip",
    "copysign",
    "floor",
    "fma",
    "lane_buffer",
    "lane_compiled",
    "lane_get",
    "lane_mask",
    "lane_matrix",
    "lane_numbers",
    "lane_set",
    "lane_vector",
    "lanes",
    "lookup",
    "mask_bits",
    "maximum",
    "minimum",
    "power",
    "select",
    "sign",
    "splat",
    "square_root",
    "where",
]
