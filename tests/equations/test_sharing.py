"""What is written into a part of an array is written into the array, as in NumPy."""

import numpy as np
import pytest

import clpt_control as clpt


def splits(t, x, u, p):
    y = u * 1.0
    a, _b = np.split(y, 2)
    a[:] = 0
    return y


def writes_a_row(t, x, u, p):
    y = u * 1.0
    a = y.reshape(2, 2)
    a[0] = 0
    return y


def reshapes(t, x, u, p):
    y = u * 1.0
    a = np.reshape(y, (2, 2))
    a[0, 0] = 9.0
    return y


def writes_behind_a_shape(t, x, u, p):
    y = u * 1.0
    a = np.reshape(y, (2, 2))
    y[0] = 9.0
    return a.ravel()


def ravels(t, x, u, p):
    y = np.array([[u[0], u[1]], [u[2], u[3]]])
    a = y.ravel()
    a[0] = 9.0
    return y.ravel()


def flattens(t, x, u, p):
    y = np.array([[u[0], u[1]], [u[2], u[3]]])
    a = y.flatten()
    a[0] = 9.0
    return y.ravel()


def squeezes(t, x, u, p):
    y = u[None] * 1.0
    a = np.squeeze(y)
    a[0] = 9.0
    return y[0]


def transposes(t, x, u, p):
    y = u.reshape(2, 2) * 1.0
    a = y.T
    a[0, 1] = 9.0
    return y.ravel()


def writes_behind_a_transpose(t, x, u, p):
    y = u.reshape(2, 2) * 1.0
    a = y.T
    y[0, 1] = 9.0
    return a.ravel()


def swaps(t, x, u, p):
    y = u.reshape(2, 2) * 1.0
    a = np.swapaxes(y, 0, 1)
    a[0, 1] = 9.0
    return y.ravel()


def splits_across(t, x, u, p):
    y = u * 1.0
    _a, b = np.hsplit(y, 2)
    b[0] = 9
    return y


def flips(t, x, u, p):
    y = u * 1.0
    a = np.flip(y)
    a[0] = 9
    return y


def part_of_a_transpose(t, x, u, p):
    y = u * 1.0
    a = y.reshape(2, 2).T[1]
    a[0] = 9
    return y


def fills_a_shape(t, x, u, p):
    y = np.zeros(4).reshape(2, 2)
    y[0, 1] = u[2]
    return y.ravel()


def copies(t, x, u, p):
    y = u * 1.0
    a = y.reshape(2, 2).copy()
    a[0, 0] = 9
    return y + a.ravel()


def puts(t, x, u, p):
    y = u * 1.0
    np.put(y, [1], u[0])
    return y


def fills_a_diagonal(t, x, u, p):
    y = np.outer(u[:2], u[2:])
    np.fill_diagonal(y, u[0])
    return y.ravel()


def sorts(t, x, u, p):
    y = -u
    y.sort()
    return y


def reshapes_zeros(t, x, u, p):
    y = np.zeros(4)
    a = np.reshape(y, (2, 2))
    a[0, 1] = u[3]
    np.flip(y)[0] = u[1]
    return y


def writes_what_is_asked(t, x, u, p):
    y, z = u * 1.0, np.zeros(2)
    np.clip(y, 1.5, u[2], out=y)
    np.sum(y.reshape(2, 2), axis=0, out=z)
    np.multiply(y[2:], z, out=y[:2])
    np.negative(y, out=y, where=y > 3.0)
    return y


SHARING = [
    writes_what_is_asked,
    puts,
    fills_a_diagonal,
    sorts,
    reshapes_zeros,
    splits,
    writes_a_row,
    reshapes,
    writes_behind_a_shape,
    ravels,
    flattens,
    squeezes,
    transposes,
    writes_behind_a_transpose,
    swaps,
    splits_across,
    flips,
    part_of_a_transpose,
    fills_a_shape,
    copies,
]


@pytest.mark.parametrize("function", SHARING)
def test_parts_share_what_is_written(function):
    block = clpt.Block("mine", output=function, inputs={"u": 4}, outputs={"y": 4})
    given = np.array([1.0, 2.0, 3.0, 4.0])
    (found,) = block.array_record("output").values(lambda group, name: given, {})
    np.testing.assert_array_equal(found, block.output(0.0, [], given))
