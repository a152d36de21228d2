# SPDX-License-Identifier: GPL-3.0-or-later
#
# motion.py - the rows of a deck: crank angle, speed, acceleration and time, given or integrated.
import numpy as np

from chain import REAL
from deck import steffen
from machine import APART, CHANGE, DEAD, LOCKED, OK, TURN

class Given:
    """A given motion: constant acceleration, held values, a run-up and a revolution, one instant."""

    def __init__(self, m):
        number = m.deck.number
        self.speed = number('motion', 'speed', 'angular_speed')
        self.acceleration = number('motion', 'acceleration', 'angular_acceleration')
        self.hold = m.deck.word('motion', 'hold') == 'yes'
        self.run_up = number('motion', 'run_up', 'angle')
        sense = -1 if (self.speed or self.acceleration) < 0 else 1
        start = number('motion', 'from', 'angle')
        if 'at' in m.deck.section('motion'):
            start = end = number('motion', 'at', 'angle')
        elif self.run_up:
            end = start + sense * (self.run_up + float(TURN))
        elif 'turns' in m.deck.section('motion'):
            end = start + number('motion', 'turns', 'number') * float(TURN)
        else:
            end = number('motion', 'to', 'angle', start + sense * m.cycle)
        self.start, self.end, self.sense = start, end, -1 if end < start else 1
        self.length = abs(end - start)
        if not self.hold and not self.run_up and self.speed * self.acceleration < 0:
            self.length = min(self.length, self.speed ** 2 / (2 * abs(self.acceleration)))
        self.stops = self.length < abs(end - start) * (1 - 1e-12)
        self.interval = number('motion', 'interval', 'angle', float(TURN) / 36)
        self.has_time = (self.acceleration != 0 and not self.hold) or (self.acceleration == 0 and self.speed != 0)

    def rows(self):
        """Angles passed, of the rows."""
        n = self.length / self.interval
        whole = int(n * (1 + 1e-12) + 1e-9)
        passed = np.arange(whole + 1) * REAL(self.interval)
        if not self.stops and n - whole > 1e-9:
            passed = np.append(passed, REAL(self.length))
        return passed

    def at(self, passed):
        """theta2, omega2, alpha2, time after the crank has turned through some angles."""
        s = self.sense * np.asarray(passed, REAL)
        theta2, zero = self.start + s, 0 * s
        if self.hold or self.acceleration == 0:
            time = s / self.speed if self.speed and not self.acceleration else zero
            return theta2, zero + self.speed, zero + self.acceleration, time
        end = self.sense * self.run_up if self.run_up else s
        first = np.where(abs(s) < abs(end), s, end) if self.run_up else s
        square = self.speed ** 2 + 2 * self.acceleration * first
        omega = self.sense_of_speed() * np.sqrt(np.maximum(square, 0))
        with np.errstate(all='ignore'):
            time = np.where(self.speed + omega != 0, 2 * first / (self.speed + omega), 0) + np.where(s != first, (s - first) / omega, 0)
        later = abs(s) >= abs(end) * (1 - 1e-12) if self.run_up else zero != 0
        return theta2, omega, np.where(later, 0, self.acceleration), time

    def sense_of(self, label):
        """Of the loads at rest: that of [friction]."""
        return None

    def sense_of_speed(self):
        return -1 if (self.speed or self.acceleration) < 0 else 1

    def table(self, label):
        """Crank angle, speed, acceleration and time of the rows, the same on both branches; the reason of an early end."""
        return self.along(label, self.rows()), None

    def along(self, label, p):
        return self.at(p)


# ---------------------------------------------------------------------------------------------- integrated motions

NODES, WEIGHTS = (x.astype(REAL) for x in np.polynomial.legendre.leggauss(10))
NODES, WEIGHTS = (NODES + 1) / 2, WEIGHTS / 2
P = np.polynomial.legendre.legvander(2 * NODES - 1, len(NODES))
COEFFICIENTS = (2 * np.arange(len(NODES))[:, None] + 1) * (P[:, :-1] * WEIGHTS[:, None]).T  # of values at the nodes
ROUGH = 1e-14  # of a motion: the two last coefficients of a panel that is fine enough


def integrals(f):
    """Integrals of the Legendre polynomials from 0 to f."""
    v = np.polynomial.legendre.legvander(2 * np.atleast_1d(np.asarray(f, REAL)) - 1, len(NODES))
    k = np.arange(1, len(NODES))
    return np.concatenate(((v[:, :1] + v[:, 1:2]) / 2, (v[:, 2:] - v[:, :-2]) / (2 * (2 * k + 1))), axis=1)


UP_TO = integrals(NODES) @ COEFFICIENTS  # the integral from 0 to each node


class Stops(Exception):
    """The motion ends after an angle, for a reason."""


class Motor:
    """Its torque on the crank, and the inertia on the shaft."""

    def __init__(self, m):
        number, keys = m.deck.number, m.deck.section('motor')
        self.ratio = number(keys, 'ratio', 'number', 1.0)
        self.inertia = number('flywheel', 'inertia', 'inertia') + self.ratio ** 2 * number(keys, 'inertia', 'inertia')
        self.balances = keys.get('torque') == 'constant'
        self.T = 0 if self.balances else number(keys, 'torque', 'torque')
        self.at_motor = lambda w: self.T + 0 * w
        if 'curve' in keys:
            self.at_motor = steffen(m.deck.curve(keys['curve'], 'angular_speed', 'torque'))
        elif 'stall_torque' in keys:
            T, w0 = number(keys, 'stall_torque', 'torque'), number(keys, 'no_load_speed', 'angular_speed')
            self.at_motor = lambda w: T * (1 - w / w0)
        elif 'power' in keys:
            power, T = number(keys, 'power', 'power'), number(keys, 'max_torque', 'torque')
            self.at_motor = lambda w: np.where(w * T > power, power / np.where(w == 0, 1, w), T)

    def torque(self, omega2):
        return self.ratio * self.at_motor(self.ratio * omega2)


class Leg:
    """The motion from an angle on in one sense, over the angle p that is passed: w = omega2^2 / 2, dw/dp = +-alpha2, by
    collocation at Gauss points of panels, which end at rows and corners.  A panel beside a rest is even in the root of p.

    All panels are solved at once by Newton's method: in each the correction is affine in that of its beginning, so that
    they follow from one another.  `basis` has a column for what is given, the first w and the torque of a motor."""

    def __init__(self, m, motor, label, start, sense, points, first, at_end=False):
        self.m, self.motor, self.label, self.start, self.sense, self.first = m, motor, label, start, sense, first
        points = [REAL(x) for x in points]
        self.begin, self.end = points[0], points[-1]
        self.panels = [[0, 0, a, b] for a, b in zip(points, points[1:])]  # kind, origin, from, to
        if first == 0:
            self.panels[0] = [1, points[0], REAL(0), np.sqrt(points[1] - points[0])]
        if at_end:
            a, b = points[-2:]
            middle = (a + b) / 2
            self.panels[-1:] = [[0, 0, a, middle] if first or len(points) > 2 else [1, a, REAL(0), np.sqrt(middle - a)],
                                [2, b, np.sqrt(b - middle), REAL(0)]]
        self.w, self.s, self.known = None, None, []

    def place(self):
        """The nodes' angles, and the machine there."""
        kind, origin, a, b = (np.array([panel[k] for panel in self.panels], REAL) for k in range(4))
        x = a[:, None] + (b - a)[:, None] * NODES
        k = kind[:, None]
        self.p = np.where(k == 0, x, origin[:, None] + np.where(k == 1, 1, -1) * x * x)
        self.dp = (b - a)[:, None] * np.where(k == 0, 1, np.where(k == 1, 2, -2) * x)
        self.ends = np.where(kind == 0, b, origin + np.where(kind == 1, 1, -1) * b * b)
        names = [tuple(panel) for panel in self.panels]
        new = [k for k, name in enumerate(names) if name not in self.known]
        if new or self.s is None:
            p = self.p[new].ravel()
            s = self.m.state(self.start + self.sense * p, self.sense, 0, self.label, sense=self.sense)
            if not s.which.all():
                bad = np.argmin(s.which)
                raise Stops(p[bad], s.status[bad])
            s = self.s.joined(s) if self.s else s
        else:
            s = self.s
        self.known += [names[k] for k in new]
        order = [self.known.index(name) for name in names]
        self.s = s.select((np.array(order)[:, None] * len(NODES) + np.arange(len(NODES))).ravel())
        self.known = names

    def acceleration(self, s, w, start=None):
        """alpha2 in the sense of the motion, and 1 / (J + I)."""
        m, motor, sense = self.m, self.motor, self.sense
        s = s.select(slice(None))
        omega = sense * np.sqrt(2 * np.maximum(w, 0))
        s.omega2 = omega
        J = m.chain.power(s, m.chain.inertia_effort(m.chain.scale(s, 0, 1)))
        T = motor.torque(omega)
        m.chain.scale(s, omega, 0 * omega)
        net = T + m.chain.power(s, m.applied(s) + m.chain.weight(s, m.g) - m.chain.inertia_effort(s))
        total = J + motor.inertia
        alpha = net / total
        if m.rubs:
            before = None
            for _ in range(30):
                m.chain.scale(s, omega, alpha)
                m.forces(s)
                error = -s.x[-1] + motor.inertia * alpha - T
                slope = total if before is None else np.where(abs(alpha - before[0]) > 1e-12 * abs(alpha) + 1e-300, (error - before[1]) / (alpha - before[0]), total)
                slope = np.where(slope > total / 100, slope, total)
                before = alpha, error
                alpha = alpha - error / slope
                if (abs(alpha - before[0]) <= 1e-16 * abs(alpha).max()).all():
                    break
            if s.locked.any():
                raise Stops(self.p.ravel()[np.argmax(s.locked)], LOCKED)
        return sense * alpha, 1 / total

    def torque(self, speed):
        """What accelerates the crank at the nodes, at a constant speed."""
        alpha, inverse = self.acceleration(self.s, speed ** 2 / 2 + 0 * self.s.theta2)
        return (alpha / inverse).reshape(self.p.shape)

    def solve(self, periodic=None, mean_speed=None):
        """w and t at the nodes and at the panels' ends.  Periodic: for the first w too, and with a mean speed the torque."""
        for _ in range(60):
            self.place()
            shape = self.p.shape
            if self.w is None:
                self.w = np.full(shape, self.first, REAL)
                if self.first == 0:
                    alpha = self.acceleration(self.s.select(slice(1)), np.zeros(1, REAL))[0]
                    if alpha[0] <= 0:
                        raise Stops(0, 'does not start')
                    self.w = alpha[0] * (self.p - self.begin)
            last = np.inf
            for _ in range(25 if not periodic else 60):
                w = self.w.ravel()
                F, inverse = (x.reshape(shape) for x in self.acceleration(self.s, w))
                h = 1e-7 * np.maximum(abs(w), 1e-12 * abs(w).max())
                D = (self.acceleration(self.s, w + h)[0] - F.ravel()).reshape(shape) / h.reshape(shape)
                change = self.correct(F, D, inverse * self.motor.ratio * self.sense, periodic, mean_speed)
                if change <= 1e-17 or (change < (1e-9 if periodic else 1e-13) and change > last / 2):
                    break
                last = change
            else:
                raise ArithmeticError('no convergence')
            self.F = self.acceleration(self.s, self.w.ravel())[0].reshape(self.w.shape)
            if not self.refine():
                return self
        return self

    def correct(self, F, D, G, periodic, mean_speed):
        """A step of Newton's method; returns its size, relative to the largest w."""
        n, dp = len(F), self.dp
        A = UP_TO[None] * dp[:, None, :]
        M = np.linalg.inv((np.eye(len(NODES)) - A * D[:, None, :]).astype(float)).astype(REAL)
        begin = np.array([0, 1, 0], REAL)
        nodes = np.zeros(F.shape + (3,), REAL)
        for k in range(n):
            known = np.stack((A[k] @ (F[k] - D[k] * self.w[k]), 0 * F[k], A[k] @ G[k]), axis=1)
            right = known + begin
            nodes[k] = M[k] @ right
            nodes[k] += M[k] @ (right - nodes[k] + A[k] @ (D[k][:, None] * nodes[k]))  # the inverse has double precision
            begin = begin + (WEIGHTS * dp[k]) @ (np.stack((F[k] - D[k] * self.w[k], 0 * F[k], G[k]), axis=1) + D[k][:, None] * nodes[k])
        self.rate = begin[1]
        first, torque = self.first, REAL(0)
        if periodic and mean_speed is None:
            first = begin[0] / (1 - begin[1])
        elif periodic:  # w returns, and the time is cycle / mean speed
            root = (2 * np.maximum(self.w, 1e-12 * abs(self.w).max())) ** -0.5
            g = [(WEIGHTS * dp * -root ** 3 * nodes[:, :, k]).sum() for k in range(3)]
            time = (WEIGHTS * dp * (root + root ** 3 * self.w)).sum() + g[0] - self.ends[-1] / abs(mean_speed)
            first, torque = (float(x) for x in np.linalg.solve(np.array([[begin[1] - 1, begin[2]], [g[1], g[2]]], float), -np.array([begin[0], time], float)))
        if first <= 0 and periodic:
            first = 0.3 * self.first
        new = nodes[:, :, 0] + nodes[:, :, 1] * first + nodes[:, :, 2] * torque
        if periodic:  # no step to a stall
            new = np.clip(new, 0.1 * self.w, 10 * self.w)
        change = abs(new - self.w).max() / (abs(new).max() + 1e-300)
        self.w, self.first = new, first
        self.motor.T += torque
        return change

    def refine(self):
        """Cut panels in which the collocation is not exact; returns how many."""
        dt = self.dp / np.sqrt(2 * np.maximum(self.w, 1e-30 + 1e-9 * abs(self.w).max()))
        rough = np.zeros(len(self.w), bool)
        for values, whole in ((self.F * self.dp, abs(self.w).max()), (dt, (dt @ WEIGHTS).sum())):
            tail = abs(values @ COEFFICIENTS[-2:].T).sum(axis=1)
            rough |= (tail > ROUGH * whole) & ~(self.w < 0).all(axis=1)
        wide = abs(self.dp).sum(axis=1) > 1e-9
        for change in self.m.changes:  # beside it rows are rounding
            at = (self.start + self.sense * self.p - change + TURN / 2) % TURN - TURN / 2
            wide &= (abs(at).min(axis=1) > 1e-3)
        rough &= wide
        if not rough.any():  # a corner may be between the last node of a panel and its end
            for f in (1e-6, 1 - 1e-6):
                kind, origin, a, b = (np.array([panel[k] for panel in self.panels], REAL) for k in range(4))
                x = a + (b - a) * f
                p = np.where(kind == 0, x, origin + np.where(kind == 1, 1, -1) * x * x)
                s = self.m.state(self.start + self.sense * p, self.sense, 0, self.label, sense=self.sense)
                if s.which.all():
                    found = self.acceleration(s, self.speeds(p)[0])[0]
                    smooth = np.array([np.polynomial.legendre.legval(2 * f - 1, COEFFICIENTS @ F) for F in self.F])
                    rough |= abs((found - smooth) * (b - a)) > 1e-10 * abs(self.w).max()
            rough &= wide
        if not rough.any() or len(self.w) > 4000:
            return 0
        parts, panels, w = 4, [], []
        for panel, own, cut in zip(self.panels, self.w, rough):
            if not cut:
                panels.append(panel)
                w.append(own)
                continue
            kind, origin, a, b = panel
            for k in range(parts):
                panels.append([kind, origin, a + (b - a) * k / parts, a + (b - a) * (k + 1) / parts])
                w.append(np.polynomial.legendre.legval(2 * (k + NODES) / parts - 1, COEFFICIENTS @ own))
        self.panels, self.w = panels, np.array(w)
        return rough.sum()

    def within(self, p):
        """Panel and part of it for angles passed."""
        k = np.clip(np.searchsorted(self.ends, np.asarray(p, REAL) * (1 - 1e-15), 'left'), 0, len(self.ends) - 1)
        kind, origin, a, b = (np.array([self.panels[i][j] for i in k], REAL) for j in range(4))
        x = np.where(kind == 0, p, np.sqrt(np.maximum(np.where(kind == 1, p - origin, origin - p), 0)))
        return k, np.clip((x - a) / (b - a), 0, 1)

    def speeds(self, p):
        """w and t where the crank has turned through p."""
        k, f = self.within(p)
        begin = np.concatenate(([REAL(self.first)], self.first + np.cumsum((self.F * self.dp) @ WEIGHTS)))
        rate = self.dp / np.sqrt(2 * np.maximum(self.w, 1e-30 * abs(self.w).max()))
        start = np.concatenate(([REAL(0)], np.cumsum(rate @ WEIGHTS)))
        weights = integrals(f) @ COEFFICIENTS
        return begin[k] + (weights * (self.F * self.dp)[k]).sum(axis=1), start[k] + (weights * rate[k]).sum(axis=1)

    def rest(self):
        """Where w gets to 0, or None."""
        p = np.unique(np.concatenate((self.p.ravel(), self.ends)))
        down = np.nonzero(self.speeds(p)[0][1:] < 0)[0]
        if not len(down):
            return None
        low, high = p[down[0]], p[down[0] + 1]
        for _ in range(70):
            middle = (low + high) / 2
            low, high = (middle, high) if self.speeds([middle])[0][0] > 0 else (low, middle)
        return low


class Path:
    """Legs one behind the other, from one rest to the next or to an end."""
    WINDOW = 6  # panels that are solved at once

    def __init__(self, m, motor, label, start, sense, length, first, rows=()):
        ends = sorted((start, start + sense * length))
        corners = [sense * (x - start) for x in m.corners(label, *ends)]
        points = np.unique(np.concatenate((corners, np.asarray(rows, float), np.arange(0, length, float(TURN) / 24), [0, length])))
        points = points[(points >= 0) & (points <= length)]
        self.points = list(points[np.append(np.diff(points) > 1e-11, True)])
        self.m, self.motor, self.label, self.start, self.sense, self.first = m, motor, label, start, sense, first
        self.legs, self.why, self.length = [], None, length

    def leg(self, points, first, at_end=False):
        return Leg(self.m, self.motor, self.label, self.start, self.sense, points, first, at_end)

    def run(self):
        points, first, window = self.points, self.first, self.WINDOW
        k = 0
        while k + 1 < len(points):
            part = points[k:k + window + 1]
            try:
                leg = self.leg(part, first).solve()
            except ArithmeticError:
                if window == 1:
                    part = [part[0], (part[0] + part[1]) / 2]
                    points.insert(k + 1, part[1])
                window = max(window // 2, 1)
                continue
            except Stops as stop:
                if window > 1:
                    window //= 2
                    continue
                if not k and stop.args[0] == 0:
                    raise
                self.why, self.length = stop.args[1], part[0]
                break
            rest = leg.rest()
            if rest is not None:
                self.end_at(part, first, float(rest))
                break
            self.legs.append(leg)
            k += len(part) - 1
            first, window = leg.speeds([part[-1]])[0][0], min(self.WINDOW, 2 * window)
        return self

    def end_at(self, part, first, rest):
        """The last leg, to where the crank comes to rest; near it w is even in the root of the distance."""
        for _ in range(4):
            leg = self.leg([x for x in part if x < rest - 1e-9] + [rest], first, at_end=True).solve()
            w, slope = leg.speeds([rest])[0][0], -leg.F[-1, -1]
            rest += float(w / slope)
        self.legs.append(leg)
        self.why, self.length = 'stalls', rest

    def speeds(self, p):
        """w and t where the crank has turned through angles, which rise."""
        p, w, t, start = np.atleast_1d(np.asarray(p, REAL)), [], [], REAL(0)
        for i, leg in enumerate(self.legs):
            here = ((p > leg.begin) | (i == 0)) & ((p <= leg.end) | (leg is self.legs[-1]))
            values = leg.speeds(p[here]) if here.any() else ([], [])
            w += list(values[0])
            t += [start + x for x in values[1]]
            start += leg.speeds([leg.end])[1][0]
        return np.array(w, REAL), np.array(t, REAL)


class Integrated:
    """A motion that follows from motor, loads and inertia."""

    def __init__(self, m):
        number, keys = m.deck.number, m.deck.section('motion')
        self.m, self.mode, self.motor = m, keys['mode'], Motor(m)
        self.start = number(keys, 'from', 'angle')
        self.speed = number(keys, 'speed', 'angular_speed')
        self.mean_speed = number(keys, 'mean_speed', 'angular_speed')
        self.by_time = keys.get('rows') == 'time'
        self.interval = number(keys, 'interval', 'angle', float(TURN) / 36)
        pull = self.mean_speed or self.speed or float(self.motor.torque(REAL(0))) or 1
        end = number(keys, 'to', 'angle', self.start + (-1 if pull < 0 else 1) * m.cycle)
        if 'turns' in keys:
            end = self.start + number(keys, 'turns', 'number') * float(TURN)
        self.end, self.sense, self.length = end, -1 if end < self.start else 1, abs(end - self.start)
        m.direction, self.paths = self.sense, {}

    def rows(self):
        n = self.length / self.interval
        whole = int(n * (1 + 1e-12) + 1e-9)
        passed = np.arange(whole + 1) * REAL(self.interval)
        return np.append(passed, REAL(self.length)) if n - whole > 1e-9 else passed

    def path(self, label, start, sense, length, first):
        return Path(self.m, self.motor, label, start, sense, length, first, [] if self.by_time else self.rows())

    def table(self, label):
        """Crank angle, speed, acceleration and time of the rows that there are; the reason of an early end."""
        if self.by_time:
            return self.table_by_time(label)
        path = self.paths[label] = self.run(label)
        p = self.rows()
        if self.mode != 'steady':
            p = p[p <= path.length * (1 + 1e-12)]
            self.length = path.length
        return self.along(label, p), path.why

    def along(self, label, p):
        """The same where the crank has turned through angles."""
        path = self.paths[label]
        turns = np.floor(p / path.length * (1 + 1e-12)) if self.mode == 'steady' else 0
        rest = p - turns * path.length
        order = np.argsort(rest, kind='stable')
        w, t = (x[np.argsort(order, kind='stable')] for x in path.speeds(rest[order]))
        t = t + turns * path.speeds([path.length])[1][0]
        return self.motion(label, self.start, self.sense, p, w, t)

    def motion(self, label, start, sense, p, w, t):
        """The crank's angle, speed, acceleration and the time; w is 0 in the first row from rest."""
        w = np.where(abs(w) < 1e-25, 0, w)
        leg = Leg(self.m, self.motor, label, start, sense, [0, 1], 1)
        s = self.m.state(start + sense * p, sense, 0, label, sense=sense)
        alpha = np.full(len(p), np.nan, REAL)
        if s.which.any():
            leg.p = p[s.which]
            alpha[s.which] = sense * leg.acceleration(s, w[s.which])[0]
        return start + sense * p, sense * np.sqrt(2 * np.maximum(w, 0)), alpha, t

    def table_by_time(self, label):
        """Where the crank comes to rest it turns back: a path from rest in the other sense."""
        number = self.m.deck.number
        step, duration = number('motion', 'time_step', 'time'), number('motion', 'duration', 'time')
        n = duration / step
        times = np.append(step * np.arange(int(n * (1 + 1e-12) + 1e-9) + 1), [duration] if n - int(n * (1 + 1e-12) + 1e-9) > 1e-9 else [])
        theta2, w, past, why, parts = self.start, REAL(self.speed) ** 2 / 2, REAL(0), None, []
        sense = -1 if self.speed < 0 else 1
        if not self.speed:
            s = self.m.state(theta2, 0, 0, label, sense=1)
            sense = 1 if not s.which.any() or Leg(self.m, self.motor, label, theta2, 1, [0, 1], 1).acceleration(s, 0 * s.theta2)[0][0] >= 0 else -1
        while len(times) and why is None:
            try:
                path = Path(self.m, self.motor, label, theta2, sense, 2 * float(TURN), w).run()
            except Stops as stop:
                if not parts:
                    raise
                why = stop.args[1]
                if why == 'does not start':  # it stays at rest
                    zero, why = np.zeros(len(times), REAL), None
                    parts.append((theta2 + zero, zero, zero, times))
                    times = []
                break
            if not path.legs:
                raise Stops(0, path.why)
            last = path.speeds([path.length])[1][0]
            here = times[times <= past + last]
            low, high = np.zeros(len(here), REAL), np.full(len(here), path.length, REAL)
            for _ in range(75 if len(here) else 0):
                middle = (low + high) / 2
                late = path.speeds(middle)[1] > here - past
                low, high = np.where(late, low, middle), np.where(late, middle, high)
            if len(here):
                parts.append(self.motion(label, theta2, sense, low, path.speeds(low)[0], here))
            times, past = times[len(here):], past + last
            if path.why not in (None, 'stalls'):
                why = path.why
            w = REAL(0) if path.why else path.speeds([path.length])[0][0]
            theta2, sense = theta2 + sense * float(path.length), -sense if path.why else sense
        return [np.concatenate(x) for x in zip(*parts)], why if len(times) else None

    def run(self, label):
        if self.mode != 'steady':
            return self.path(label, self.start, self.sense, self.length, REAL(self.speed) ** 2 / 2).run()
        wanted = self.m.deck.number('flywheel', 'fluctuation', 'number')
        if self.m.deck.word('flywheel', 'exact') != 'yes':
            return self.steady(label)
        rotor, self.motor.inertia = self.motor.inertia, 1  # the flywheel with which the motion has a fluctuation, by secants of its logarithm
        begin = np.log(self.excess_energy(label) / (wanted * self.mean_speed ** 2))
        x, found = [begin, begin + 0.1], []
        for k in range(40):
            self.motor.inertia = rotor + np.exp(x[-1] if k else x[0])
            path = self.steady(label)
            found.append(float(np.log(self.facts(path)['fluctuation_exact'] / wanted)))
            if k and abs(found[-1]) < 1e-13 or k > 1 and abs(x[-1] - x[-2]) < 1e-14:
                break
            if k:
                step = -found[-1] * (x[-1] - x[-2]) / (found[-1] - found[-2])
                x.append(x[-1] + np.clip(step, -2, 2))
                if x[-1] < -28:
                    self.motor.inertia = rotor
                    return self.steady(label)
        return path

    def facts(self, path):
        """Of the last whole cycle of a path, or of one that repeats."""
        cycle = self.m.cycle
        begin = max(path.length - cycle, 0)
        p = np.unique(np.concatenate([leg.p.ravel() for leg in path.legs] + [leg.ends for leg in path.legs] + [[begin, path.length]]))
        p = p[p >= begin]
        w, t = path.speeds(p)
        low, high = peak(lambda x: -path.speeds(x)[0], p), peak(lambda x: path.speeds(x)[0], p)
        least, most = np.sqrt(2 * -low), np.sqrt(2 * high)
        found = {'period': t[-1] - t[0]}
        found['mean_speed'] = self.sense * (path.length - begin) / found['period']
        found['mean_speed_textbook'] = self.sense * (least + most) / 2
        found['fluctuation_exact'] = (most - least) / abs(found['mean_speed'])
        if self.mode == 'steady':
            found['steady_rate'] = path.legs[0].rate
        return found

    def excess_energy(self, label):
        """The largest difference of the energies taken up by a flywheel at a constant speed."""
        path = self.path(label, self.start, self.sense, self.m.cycle, REAL(1))
        leg = path.leg(path.points, REAL(1))
        leg.place()
        torque = leg.torque(REAL(abs(self.mean_speed)))
        work = np.cumsum(((torque - (WEIGHTS * leg.dp * torque).sum() / self.m.cycle) * leg.dp) @ WEIGHTS)
        return float(np.ptp(work))

    def steady(self, label):
        """The motion that repeats: from the lowest speed at which the mean torque of a cycle gets negative."""
        m = self.m
        path = self.path(label, self.start, self.sense, m.cycle, REAL(1))
        leg = path.leg(path.points, REAL(1))
        leg.place()

        def mean_torque(speed):
            return (WEIGHTS * leg.dp * leg.torque(speed)).sum() / m.cycle

        if self.motor.balances:
            speed, self.motor.T = REAL(self.mean_speed), 0
            self.motor.T = -float(mean_torque(speed)) / self.motor.ratio * self.sense
        else:
            speed = np.sqrt(abs(leg.acceleration(leg.s, 0 * leg.s.theta2)[0]).max()) / 100
            before, mean = 0, mean_torque(speed)
            while not (before > 0 and mean <= 0):
                if speed > 1e6:
                    raise Stops(0, 'no steady motion')
                speed *= 1.25
                before, mean = mean, mean_torque(speed)
        leg.first, leg.w = speed ** 2 / 2, np.full(leg.p.shape, speed ** 2 / 2, REAL)
        leg.solve(periodic=True, mean_speed=self.mean_speed or None)
        path.legs = [leg]
        return path


def peak(f, x, with_place=False):
    """The largest value of a function near the largest of its samples, by ever closer ones."""
    y = f(x)
    k = int(np.argmax(y))
    a, b = x[max(k - 1, 0)], x[min(k + 1, len(x) - 1)]
    best = y[k], x[k]
    for _ in range(14):
        grid = a + (b - a) * np.arange(9, dtype=REAL) / 8
        values = f(grid)
        k = int(np.argmax(values))
        best = max(best, (values[k], grid[k]))
        a, b = grid[max(k - 1, 0)], grid[min(k + 1, 8)]
    return best if with_place else best[0]
