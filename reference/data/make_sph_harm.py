#!/usr/bin/env python3
"""Writes sph_harm.csv: real spherical harmonics out of SciPy's complex ones.

The table is the one place where this project's basis meets somebody else's: Gaunt tensors, products and
logarithms look the same under most sign conventions, so they cannot tell a wrong one.

SciPy's sph_harm_y(l, m, theta, phi) has theta from the pole (+Z), phi from +X towards +Y, and the
Condon-Shortley phase. The real basis without that phase is

    m = 0    Re Y_l^0
    m > 0    sqrt(2) (-1)^m Re Y_l^m
    m < 0    sqrt(2) (-1)^m Im Y_l^|m|

One row a direction: x, y, z, then 36 values (order 6) at index l*l + l + m. Numbers are written so that
they read back to the same f64.

    python3 make_sph_harm.py > sph_harm.csv        (needs scipy >= 1.15)
"""

import math

import numpy
import scipy
from scipy.special import sph_harm_y

ORDER = 6


def directions():
    """Axes, corners, tilts near both poles, and a spiral over the whole sphere."""
    for axis in range(3):
        for sign in (1.0, -1.0):
            yield [sign if i == axis else 0.0 for i in range(3)]
    for corner in range(8):
        yield [1.0 if corner >> i & 1 else -1.0 for i in range(3)]
    for tilt in (1e-2, 1e-5, 1e-9):
        yield [0.6 * math.sin(tilt), 0.8 * math.sin(tilt), math.cos(tilt)]
        yield [-0.8 * math.sin(tilt), 0.6 * math.sin(tilt), -math.cos(tilt)]
    golden = math.pi * (3.0 - math.sqrt(5.0))
    count = 24
    for i in range(count):
        z = 1.0 - (2.0 * i + 1.0) / count
        r = math.sqrt(1.0 - z * z)
        yield [r * math.cos(golden * i), r * math.sin(golden * i), z]


def real(l, m, theta, phi):
    y = sph_harm_y(l, abs(m), theta, phi)
    if m == 0:
        return y.real
    return math.sqrt(2.0) * (-1) ** abs(m) * (y.real if m > 0 else y.imag)


def main():
    print(f"# Real spherical harmonics from scipy {scipy.__version__}, written by make_sph_harm.py: x,y,z,y_0..y_35")
    for v in directions():
        x, y, z = (numpy.array(v) / math.sqrt(sum(c * c for c in v))).tolist()
        theta = math.atan2(math.hypot(x, y), z)
        phi = math.atan2(y, x)
        values = [float(real(l, m, theta, phi)) for l in range(ORDER) for m in range(-l, l + 1)]
        print(",".join(repr(c) for c in [x, y, z, *values]))


if __name__ == "__main__":
    main()
