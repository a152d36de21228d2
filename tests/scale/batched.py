# SPDX-License-Identifier: GPL-3.0-or-later
"""batched.py ROWS - the same 20 columns by numpy: blocks of 4096 rows, the nine equations by numpy.linalg.solve."""
import sys

import numpy as np

a, b, c, d = 0.020, 0.066, 0.056, 0.080
mass = [0.10, 0.30, 0.25]
inertia = [m * k * k for m, k in zip(mass, (0.008, 0.025, 0.020))]
centre = [0.010, 0.030 * np.exp(1j * np.radians(10)), 0.028 * np.exp(1j * np.radians(-5))]
omega2, gravity, torque = 10.5, -9.81j, 0.5


def rows(theta2):
    e2 = np.exp(1j * theta2)
    B = a * e2
    f = d - B
    size = abs(f)
    beta = np.arccos((size**2 + b * b - c * c) / (2 * b * size))
    theta3 = np.angle(f) + beta
    e3 = np.exp(1j * theta3)
    e4 = (B + b * e3 - d) / c
    theta4 = np.angle(e4)
    sine = np.sin(theta4 - theta3)
    omega3 = -a * omega2 * np.sin(theta4 - theta2) / (b * sine)
    omega4 = -a * omega2 * np.sin(theta3 - theta2) / (c * sine)
    known = -a * omega2**2 * e2 - b * omega3**2 * e3 + c * omega4**2 * e4
    alpha3 = -(known * e4.conj()).real / (b * sine)
    alpha4 = -(known * e3.conj()).real / (c * sine)
    arm = [centre[0] * e2, centre[1] * e3, centre[2] * e4]
    of_B = -omega2**2 * B
    acceleration = [-omega2**2 * arm[0], of_B + (1j * alpha3 - omega3**2) * arm[1], (1j * alpha4 - omega4**2) * arm[2]]
    n = len(theta2)
    A, right = np.zeros((n, 9, 9)), np.zeros((n, 9))
    far = [B - arm[0], b * e3 - arm[1], c * e4 - arm[2]]
    ends = [((0, -arm[0], 1), (2, far[0], -1)), ((2, -arm[1], 1), (4, far[1], -1)), ((6, -arm[2], 1), (4, far[2], 1))]
    for i in range(3):
        force = mass[i] * (acceleration[i] - gravity)
        right[:, 3 * i], right[:, 3 * i + 1] = force.real, force.imag
        right[:, 3 * i + 2] = inertia[i] * (0, alpha3, alpha4)[i] - (torque if i == 2 else 0)
        for column, r, sign in ends[i]:
            A[:, 3 * i, column] = A[:, 3 * i + 1, column + 1] = sign
            A[:, 3 * i + 2, column] = -sign * r.imag
            A[:, 3 * i + 2, column + 1] = sign * r.real
    A[:, 2, 8] = 1
    x = np.linalg.solve(A, right[:, :, None])[:, :, 0]
    mu = abs(np.angle(e3 * e4.conj()))
    mu = np.minimum(mu, np.pi - mu)
    degrees = np.degrees
    one = np.ones(n)
    return np.column_stack([degrees(theta2), degrees(theta3), omega3, alpha3, degrees(theta4), omega4, alpha4,
                            degrees(mu), x, omega2 * one, 0 * one, omega2 * x[:, 8]])


total = int(float(sys.argv[1]))
for first in range(0, total, 4096):
    theta2 = 2 * np.pi / total * np.arange(first, min(first + 4096, total))
    np.savetxt(sys.stdout, rows(theta2), "%11.5f")
