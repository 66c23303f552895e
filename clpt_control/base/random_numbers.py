"""Random numbers as a hash of integers: no state, so in any order and in any backend.

h -> h^2 + c h + key  modulo a prime, in exact double arithmetic
n = sqrt(-2 log a) cos(2 pi b),  a and b uniform     (Box and Muller, 1958)
"""

import numpy as np

MODULUS = 67108859.0  # the largest prime below 2^26: products stay exact in a double


def remainder(a):
    """Return a mod MODULUS, exact for 0 <= a < 2^53."""
    return a - MODULUS * np.floor(a / MODULUS)


def hash_fraction(seed, k, axis, stream):
    """Return a fraction in (0, 1), the hash of four whole numbers.

    Rounds of h -> h^2 + c h + key modulo a prime, in exact double arithmetic.
    """
    h = remainder(remainder(seed) + 40503.0)
    series = axis * 2.0 + stream
    for i in range(4):
        h = remainder(h * h + 1299709.0 + 15485863.0 * i)
        h = (
            h * 31415821.0
            + remainder(k) * (2.0 * i + 3.0)
            + series * (7919.0 + 104729.0 * i)
        )
        h = remainder(h)
    return (h + 0.5) / MODULUS


def normal(seed, k, axis):
    """Return standard normal numbers of the hash, as Box and Muller."""
    radius = np.sqrt(-2 * np.log(hash_fraction(seed, k, axis, 0)))
    return radius * np.cos(2 * np.pi * hash_fraction(seed, k, axis, 1))
