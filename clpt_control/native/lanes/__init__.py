"""Eight runs at once: a block's equations read in SIMD lanes.

    f(t, x, u, p, out)  with  float -> <8 x double>

The functions here are for compiled code (`numba.njit`): there a `Lanes` value
holds a number of eight runs, and the block's own function, compiled by
`lane_compiled`, works on all eight at once.  Each lane gets the bits it would
get in any other lane and beside any neighbours.
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
