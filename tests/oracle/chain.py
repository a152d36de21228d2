# SPDX-License-Identifier: GPL-3.0-or-later
#
# chain.py - the motion and the forces of any plane chain of rigid bodies: absolute coordinates, constraints, multipliers.
#
# The coordinates q of a body are the place of its centre of mass and its angle.  The constraints C(q) = 0 have as many
# equations as there are coordinates, the last of them the driver's, C = p(q) - p(t).  With the matrix C_q,
#
#    C_q q' = p',   C_q q" = p" - c,   c the terms of C" without q"
#    M q" + C_q^T lambda = Q
#
# so that -C_q^T lambda are the forces of the joints, and -lambda of the driver is its force or torque.  Arrays have a
# row for each position; the numbers are long doubles, whose rounding is 1 / 2000 of the program's where a machine has them.
import numpy as np

REAL, COMPLEX = np.longdouble, np.clongdouble


def turned(u, v):
    """The part of v along u: with u unit vectors."""
    return u.real * v.real + u.imag * v.imag


def cross(u, v):
    return u.real * v.imag - u.imag * v.real


def solve(A, B):
    """Solve A X = B for a stack of matrices, by elimination with row pivots (LAPACK has no long doubles)."""
    m = A.shape[1]
    A = np.ascontiguousarray(np.moveaxis(np.concatenate((A, B), axis=2), 0, 2))  # the positions go last
    for k in range(m):
        pivot = np.argmax(abs(A[k:, k]), axis=0)[None, None]
        if pivot.any():
            chosen = np.take_along_axis(A[k:], pivot, 0)
            np.put_along_axis(A[k:], pivot, A[None, k], 0)
            A[k] = chosen
        A[k, k + 1:] /= A[k, k]
        for i in range(k + 1, m):
            A[i, k + 1:] -= A[i, k] * A[k, k + 1:]
    X = A[:, m:]
    for k in range(m - 2, -1, -1):
        X[k] -= (A[k, k + 1:m, None] * X[k + 1:]).sum(axis=0)
    return np.moveaxis(X, 2, 0)


class Along:
    """w . (P - Q) = value: a direction w of body k (0: the ground), P on body i and Q on body j."""

    def __init__(self, k, w, i, p, j, q, value=0):
        self.k, self.w, self.i, self.p, self.j, self.q, self.value = k, w, i, p, j, q, value

    def parts(self, s):
        return self.w * s.e[self.k], s.place(self.i, self.p) - s.place(self.j, self.q)

    def error(self, s):
        w, d = self.parts(s)
        return turned(w, d) - self.value

    def gradient(self, s):
        """(body, d/dx, d/dy, d/dphi) of each body."""
        w, d = self.parts(s)
        for body, at, sign in ((self.i, self.p, 1), (self.j, self.q, -1)):
            yield body, sign * w.real, sign * w.imag, sign * turned(w, 1j * s.arm(body, at))
        yield self.k, 0, 0, turned(1j * w, d)

    def curvature(self, s):
        w, d = self.parts(s)
        dv = s.velocity(self.i, self.p) - s.velocity(self.j, self.q)
        omega = s.omega[self.k]
        return turned(w, s.centripetal(self.i, self.p) - s.centripetal(self.j, self.q)) + 2 * omega * turned(1j * w, dv) \
            - omega ** 2 * turned(w, d)


class Angle:
    """phi of body i - phi of body j = value."""

    def __init__(self, i, j, value=0):
        self.i, self.j, self.value = i, j, value

    def error(self, s):
        return s.phi[self.i] - s.phi[self.j] - self.value

    def gradient(self, s):
        return (self.i, 0, 0, 1), (self.j, 0, 0, -1)

    def curvature(self, s):
        return 0


class Distance:
    """|P - Q| = value: an actuator; its force, -lambda, pushes the ends apart."""

    def __init__(self, i, p, j, q, value=0):
        self.i, self.p, self.j, self.q, self.value = i, p, j, q, value

    def error(self, s):
        return abs(s.place(self.i, self.p) - s.place(self.j, self.q)) - self.value

    def gradient(self, s):
        r = s.place(self.i, self.p) - s.place(self.j, self.q)
        w = r / abs(r)
        for body, at, sign in ((self.i, self.p, 1), (self.j, self.q, -1)):
            yield body, sign * w.real, sign * w.imag, sign * turned(w, 1j * s.arm(body, at))

    def curvature(self, s):
        r = s.place(self.i, self.p) - s.place(self.j, self.q)
        v, n = s.velocity(self.i, self.p) - s.velocity(self.j, self.q), abs(r)
        return turned(r, s.centripetal(self.i, self.p) - s.centripetal(self.j, self.q)) / n + cross(r, v) ** 2 / n ** 3


class Pin:
    """P of body i is Q of body j; `on` i acts the force of j."""
    guide = False

    def __init__(self, i, p, j, q):
        self.i, self.p, self.j, self.q = i, p, j, q
        self.rows = [Along(0, 1, i, p, j, q), Along(0, 1j, i, p, j, q)]

    def force(self, s, x):
        """Force on i at P, and the couple; x are the multipliers of its equations."""
        return -(x[0] + 1j * x[1]), 0


class Slide:
    """P of body i moves along the line through Q of body j with direction u there; with an angle, i turns with j."""
    guide = True

    def __init__(self, i, p, j, q, u, angle=None):
        self.i, self.p, self.j, self.q, self.u = i, p, j, q, u
        self.rows = [Along(j, 1j * u, i, p, j, q)] + ([] if angle is None else [Angle(i, j, angle)])

    def force(self, s, x):
        return -x[0] * 1j * self.u * s.e[self.j], (-x[1] if len(x) > 1 else 0)


class State:
    """Places and motions of all bodies; body 0 is the ground."""

    def __init__(self, chain, r, phi):
        self.chain, self.r, self.phi = chain, r, phi
        self.turn()

    def turn(self):
        self.e = [np.exp(1j * np.asarray(p, REAL)) for p in self.phi]

    def arm(self, body, at):
        return self.e[body] * (at - self.chain.cg[body])

    def place(self, body, at):
        return self.r[body] + self.arm(body, at)

    def velocity(self, body, at):
        return self.v[body] + 1j * self.omega[body] * self.arm(body, at)

    def centripetal(self, body, at):
        return -self.omega[body] ** 2 * self.arm(body, at)

    def acceleration(self, body, at):
        return self.a[body] + (1j * self.alpha[body] - self.omega[body] ** 2) * self.arm(body, at)

    def select(self, which):
        """The same of some of the rows."""
        copy = object.__new__(State)
        for name, x in vars(self).items():
            setattr(copy, name, x.select(which) if isinstance(x, State) else [y[which] for y in x] if isinstance(x, list) else
                    x[which] if isinstance(x, np.ndarray) and len(x) == len(self.r[0]) else x)
        return copy


    def joined(self, other):
        """The rows of both."""
        copy = object.__new__(State)
        for name, x in vars(self).items():
            y = getattr(other, name)
            setattr(copy, name, x.joined(y) if isinstance(x, State) else [np.concatenate(p) for p in zip(x, y)] if isinstance(x, list) else
                    np.concatenate((x, y)) if isinstance(x, np.ndarray) else x)
        return copy


class Chain:
    """Bodies 1, 2, ... with (mass, inertia, centre of mass in the axes in which points of the body are given)."""

    def __init__(self, bodies, joints, driver):
        self.mass, self.inertia = ([0] + [body[k] for body in bodies] for k in (0, 1))
        self.cg = [0j] + [complex(body[2]) for body in bodies]
        self.joints, self.driver, self.n = joints, driver, len(bodies)
        self.rows = [row for joint in joints for row in joint.rows] + [driver]

    def matrix(self, s):
        C = np.zeros((len(s.r[1]), len(self.rows), 3 * self.n), REAL)
        for k, row in enumerate(self.rows):
            for body, *parts in row.gradient(s):
                for m in range(3):
                    if body:
                        C[:, k, 3 * (body - 1) + m] += parts[m]
        return C

    def vectors(self, x):
        """The bodies' complex and real parts of a vector of coordinates, those of the ground first."""
        zero = np.zeros(x.shape[:1], REAL)
        return [zero + 0j] + [x[:, k] + 1j * x[:, k + 1] for k in range(0, 3 * self.n, 3)], [zero] + [x[:, k + 2] for k in range(0, 3 * self.n, 3)]

    def begin(self, origins, angles):
        """A state near the wanted one, from the origins and angles of bodies 1, 2, ..."""
        zero = 0 * angles[0]
        phi = [zero] + [p + zero for p in angles]
        return State(self, [zero + 0j] + [o + np.exp(1j * p) * c for o, p, c in zip(origins, phi[1:], self.cg[1:])], phi)

    def close(self, s, value):
        """The places of all bodies for a value of the driver, by Newton's method."""
        self.driver.value = value
        for _ in range(10):
            error = np.stack([row.error(s) + 0 * value for row in self.rows], axis=1)
            s.closure = abs(error).max(axis=1)
            if not (s.closure > 1e-18 * (1 + abs(value))).any():
                break
            step = self.vectors(solve(self.matrix(s), error[:, :, None])[:, :, 0])
            s.r, s.phi = ([x - d for x, d in zip(*pair)] for pair in zip((s.r, s.phi), step))
            s.turn()
        return s

    def inverse(self, s):
        """Of the matrix C_q."""
        C = self.matrix(s)
        return solve(C, np.broadcast_to(np.eye(C.shape[1]), C.shape))

    def move(self, s, rate, second=0):
        """Velocities and accelerations for the rates of the driver."""
        s.inverse = self.inverse(s)
        s.v, s.omega = self.vectors(s.inverse[:, :, -1] * np.asarray(rate, REAL)[:, None])
        right = -np.stack([row.curvature(s) + np.zeros(len(s.inverse), REAL) for row in self.rows], axis=1)
        right[:, -1] += second
        s.a, s.alpha = self.vectors((s.inverse * right[:, None, :]).sum(axis=2))
        return s

    def scale(self, s, rate, second):
        """The same as move from the motion at unit rate, s.unit."""
        s.v, s.omega = ([x * rate for x in part] for part in (s.unit.v, s.unit.omega))
        s.a, s.alpha = ([x * second + y * rate ** 2 for x, y in zip(*part)] for part in ((s.unit.v, s.unit.a), (s.unit.omega, s.unit.alpha)))
        return s

    def power(self, s, effort):
        """Of a vector of coordinates, per rate of the driver."""
        v, omega = s.unit.v, s.unit.omega
        return sum(effort[:, 3 * k - 3] * v[k].real + effort[:, 3 * k - 2] * v[k].imag + effort[:, 3 * k - 1] * omega[k] for k in range(1, self.n + 1))

    def effort(self, s, body, place, force, torque=0):
        """A force on a body at a place, and a torque, as a vector of coordinates."""
        Q = np.zeros((len(s.r[1]), 3 * self.n), REAL)
        if body:
            k = 3 * (body - 1)
            force = np.asarray(force) + 0j
            Q[:, k], Q[:, k + 1] = force.real, force.imag
            Q[:, k + 2] = cross(place - s.r[body], force) + torque
        return Q

    def inertia_effort(self, s):
        """M q"."""
        parts = [x for k in range(1, self.n + 1)
                 for x in (self.mass[k] * s.a[k].real, self.mass[k] * s.a[k].imag, self.inertia[k] * s.alpha[k])]
        return np.stack(parts, axis=1)

    def weight(self, s, gravity):
        return sum(self.effort(s, k, s.r[k], self.mass[k] * gravity) for k in range(1, self.n + 1))

    def multipliers(self, s, efforts):
        """lambda for each of some vectors of coordinates, Q - M q"; a list in the order of the rows."""
        return [list((s.inverse * Q[:, :, None]).sum(axis=1).T) for Q in efforts]

    def forces(self, s, x):
        """(force on i, couple) of each joint, and the effort of the driver."""
        found, k = [], 0
        for joint in self.joints:
            found.append(joint.force(s, x[k:k + len(joint.rows)]))
            k += len(joint.rows)
        return found, -x[-1]


def meet(p, l, q, r, side):
    """The point at distances l from p and r from q, on the left of p -> q if side is 1; nan if there is none."""
    f = q - p
    along = (abs(f) ** 2 + l ** 2 - r ** 2) / (2 * abs(f))
    return p + f / abs(f) * (along + 1j * side * root(l ** 2 - along ** 2, l))


def reach(p, l, q, u, side):
    """The point of the line through q along u at the distance l from p, ahead of p if side is 1."""
    return q + u * (turned(u, p - q) + side * root(l ** 2 - cross(u, p - q) ** 2, l))


def root(x, size):
    """The square root; 0 below 0 by rounding, else nan."""
    with np.errstate(invalid='ignore'):
        return np.sqrt(np.where(abs(x) < 1e-15 * size ** 2, 0, x))
