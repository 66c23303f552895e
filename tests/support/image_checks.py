"""Whether a picture shows anything, whatever its fonts and compression."""

import matplotlib.image


def inked(path):
    """Return the share of a PNG's pixels that are not its background."""
    pixels = matplotlib.image.imread(path)
    return float((abs(pixels - pixels[0, 0]).max(axis=2) > 0.1).mean())
