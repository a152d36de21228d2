# SPDX-License-Identifier: GPL-3.0-or-later
#
# search.py - columns along a motion by brute force: extremes by dense samples, parabolas and limits, means by Gauss's rule
# from corner to corner, crossings by bisection.
import numpy as np

from chain import REAL
from columns import columns
from machine import CHANGE, OK, TURN
from motion import COEFFICIENTS, NODES, WEIGHTS

STEP = float(TURN) / 1440
NEAR = 0.05  # sine of the transmission angle, and share of the largest speed: near a dead position or at rest
RELIABLE = 1e-5  # sine below which the oracle's digits do not suffice for accelerations
LIMIT = 1e-4  # root of the distance, rad, from a dead position from which its limits are taken


class Track:
    """The columns of a branch along its motion, by the angle p that the crank has turned through."""

    def __init__(self, m, motion, label, forces):
        self.m, self.motion, self.label, self.forces = m, motion, label, forces
        self.length = float(motion.length)
        self.angle = lambda p: motion.start + motion.sense * np.asarray(p, REAL)
        ends = sorted((float(self.angle(0)), float(self.angle(self.length))))
        self.corners = [motion.sense * (x - motion.start) for x in m.corners(label, *ends)]
        self.corners += [x for x in (getattr(motion, 'run_up', 0),) if x]
        self.find_edges()
        fine = np.concatenate([STEP * np.arange(int(self.length / STEP) + 1), [self.length]] + [
            at + side * np.array([1e-10, 1e-6, 1e-4]) for at in self.corners for side in (-1, 1)] + [
            at + side * 0.05 * 0.5 ** np.arange(2, 22) for at, side, _ in self.edges])
        self.p = np.unique(fine[(fine >= 0) & (fine <= self.length)])
        self.values = self.at(self.p)
        self.limits = self.find_limits()

    def at(self, p):
        """Name -> values, nan where there is no row; the condition of rows is values['condition']."""
        p = np.asarray(p, REAL)
        theta2, omega2, alpha2, time = self.motion.along(self.label, p)
        s = self.m.state(theta2, omega2, alpha2, self.label)
        found = {}
        if s.which.any():
            v, small = columns(self.m, s, self.forces)
            v.update(('1 / ' + name, value) for name, value in small.items())
            if hasattr(self.motion, 'motor'):
                v.update(actual(self.m, self.motion, s))
            missing = s.locked if self.forces else np.zeros(len(s.theta2), bool)
            rows = np.nonzero(s.which)[0]
            for name, value in v.items():
                full = np.full(len(p), np.nan, REAL)
                full[rows] = np.where(missing | (s.sine < RELIABLE), np.nan, value)
                found[name] = full
            self.small = small
        found.update(theta2=theta2, omega2=omega2, alpha2=alpha2, time=time)
        return found

    def is_there(self, p):
        return self.m.state(self.angle(p), 1, 0, self.label).status == OK

    def find_edges(self):
        """Ends of what can be reached, and change points: (p, side on which there are rows, whether it is a change point)."""
        grid = np.concatenate((np.arange(0, self.length, STEP), [self.length])) + 0.0
        there = self.is_there(grid)
        k = np.nonzero(there[1:] != there[:-1])[0]
        self.edges = []
        if len(k):
            good, bad = np.where(there[k], grid[k], grid[k + 1]), np.where(there[k], grid[k + 1], grid[k])
            for _ in range(60):
                middle = (good + bad) / 2
                ok = self.is_there(middle)
                good, bad = np.where(ok, middle, good), np.where(ok, bad, middle)
            self.edges = [(float(x), 1 if x > y else -1, False) for x, y in zip(good, bad)]
        for change in self.m.changes:
            for at in [x for x in np.arange(-400, 401) * float(TURN) + float(change)]:
                p = self.motion.sense * (at - self.motion.start)
                self.edges = [e for e in self.edges if abs(e[0] - p) > 1e-5]
                self.edges += [(p, side, True) for side in (-1, 1) if 0 < p + side * 1e-3 < self.length]

    def find_limits(self):
        """For each edge a dictionary: name -> limit, or inf of its sign where a column grows without bound."""
        found = []
        for at, side, is_change in self.edges:
            x = LIMIT * np.array([1, 2, 4])
            p = at + side * (x if is_change else x * x)
            if is_change and self.motion.along(self.label, np.array([at]))[1][0] == 0 or p.min() < 0 or p.max() > self.length:
                continue
            v = self.at(p)
            limit = {}
            for name, (a, b, c) in v.items():
                grows = abs(a) > 1.6 * abs(b) > 2.5 * abs(c) and a * b > 0
                limit[name] = np.copysign(np.inf, a) if grows else (8 * a - 6 * b + c) / 3
            found.append((at, limit))
        return found

    def size(self, name):
        """The largest magnitude away from dead positions and rest, or else the median."""
        v = abs(self.values[name].astype(float))
        speed = abs(self.values['omega2'].astype(float))
        far = np.isfinite(v) & (1 / self.values['condition'].astype(float) > NEAR) & ((speed > NEAR * np.nanmax(speed)) | (speed.max() == 0)) \
            if 'condition' in self.values else np.isfinite(v)
        return v[far].max() if far.any() else np.median(v[np.isfinite(v)]) if np.isfinite(v).any() else np.nan

    def followed(self, name, is_angle):
        """The samples of a column; an angle goes on over turns, or None where the samples do not tell how."""
        v = self.values[name]
        if not is_angle or name == 'theta2' or not np.isfinite(v).any():
            return v
        ok = np.isfinite(v)
        w = np.unwrap(v[ok].astype(float))
        if len(w) > 1 and (abs(np.diff(w)).max() > 0.7 or not ok.all()):
            return None
        full = np.full(len(v), np.nan, REAL)
        full[ok] = v[ok] + TURN * np.round((w - v[ok]) / TURN)
        return full

    def extremes(self, names, angles):
        """(name, sign) -> (best of rows, p, best of limits): sign 1 for the largest, -1 for the smallest."""
        best = {}
        for name in names:
            v = self.followed(name, name in angles)
            if v is None or not np.isfinite(v.astype(float)).any():
                continue
            for sign in (1, -1):
                k = int(np.nanargmax(sign * v))
                best[name, sign] = [v[k], self.p[k], k, v]
        keys = [key for key in best if 0 < best[key][2] < len(self.p) - 1]
        for shrink in (1, 20):
            x, who = [], []
            for key in keys:
                value, at, k, v = best[key]
                h = min(self.p[k] - self.p[k - 1], self.p[k + 1] - self.p[k]) / shrink
                x += [at - h, at, at + h]
            if not x:
                break
            v = self.at(np.clip(x, 0, self.length))
            y = np.stack([v[key[0]][3 * i:3 * i + 3] for i, key in enumerate(keys)])
            d2, d1 = y[:, 0] - 2 * y[:, 1] + y[:, 2], (y[:, 2] - y[:, 0]) / 2
            x = np.array(x).reshape(-1, 3)
            with np.errstate(all='ignore'):
                move = np.clip(np.where(d2 != 0, -d1 / d2, 0), -1, 1) * (x[:, 1] - x[:, 0])
            top = np.clip(x[:, 1] + np.where(np.isfinite(move), move, 0), 0, self.length)
            v = self.at(top)
            for i, key in enumerate(keys):
                value = v[key[0]][i]
                if key[0] in angles and np.isfinite(value):
                    value += TURN * np.round((best[key][0] - value) / TURN)
                if key[1] * value > key[1] * best[key][0]:
                    best[key][:2] = value, top[i]
        result = {}
        for (name, sign), (value, at, k, v) in best.items():
            limits = [limit[name] for _, limit in self.limits if name in limit and not np.isnan(limit[name])]
            if name in angles and limits:
                near = v[np.isfinite(v.astype(float))][-1]
                limits = [x + TURN * np.round((near - x) / TURN) for x in limits if abs(x) < 1e3]
            result[name, sign] = value, at, sign * max([sign * x for x in limits]) if limits else np.nan
        return result

    def has_pole(self, name):
        """1 if a column passes through infinity between samples."""
        v = self.values.get('1 / ' + name, np.ones(2))
        return bool((v[1:] * v[:-1] <= 0).any())

    def means(self, names, angles):
        """name -> (mean, rms); left out are columns that the rule does not integrate exactly."""
        cuts = np.unique(np.clip(np.concatenate((self.corners, [e[0] for e in self.edges], [0, self.length], np.arange(0, self.length, float(TURN) / 96))), 0, self.length))
        cuts = cuts[np.append(True, np.diff(cuts) > 1e-9)]
        dead = np.array([e[0] for e in self.edges if not e[2]] + [1e9])
        a, b = cuts[:-1].astype(REAL), cuts[1:].astype(REAL)
        at_a, at_b = (abs(x[:, None] - dead).min(axis=1) < 1e-9 for x in (a, b))
        f = np.where(at_a[:, None], NODES ** 2, np.where(at_b[:, None], 1 - (1 - NODES) ** 2, NODES))
        rate = np.where(at_a[:, None], 2 * NODES, np.where(at_b[:, None], 2 * (1 - NODES), 1)) * (b - a)[:, None]
        v = self.at((a[:, None] + (b - a)[:, None] * f).ravel())
        there = np.isfinite(v['condition'].astype(float)).reshape(f.shape).all(axis=1) if 'condition' in v else np.zeros(len(a), bool)
        whole = (rate[there] @ WEIGHTS).sum()
        found = {}
        for name in names:
            y = v[name].reshape(f.shape)[there] if name in v else np.zeros((0, 1))
            if name in angles and y.size and name != 'theta2':
                w = np.unwrap(y.ravel().astype(float))
                if len(w) > 1 and abs(np.diff(w)).max() > 0.7 or not there.all():
                    continue
                y = y + TURN * np.round((w.reshape(y.shape) - y) / TURN)
            if not y.size or not np.isfinite(y.astype(float)).all():
                continue
            g = y * rate[there]
            h = y * g
            rough = [abs(x @ COEFFICIENTS[-2:].T).sum() / (abs(x) @ WEIGHTS).sum() if x.any() else 0 for x in (g, h)]
            if max(rough) < 1e-10:
                found[name] = (g @ WEIGHTS).sum() / whole, np.sqrt((h @ WEIGHTS).sum() / whole)
        return found

    def crossings(self, name, value, is_angle):
        """Angles p at which a column has a value; None if samples do not tell."""
        y = self.values[name] - value
        if is_angle:
            y = (y + TURN / 2) % TURN - TURN / 2
        k = np.nonzero((y[1:] * y[:-1] < 0) & (abs(y[1:] - y[:-1]) < (2 if is_angle else np.inf)))[0]
        low, high, f = self.p[k], self.p[k + 1], y[k]
        for _ in range(55 if len(k) else 0):
            middle = (low + high) / 2
            g = self.at(middle)[name] - value
            if is_angle:
                g = (g + TURN / 2) % TURN - TURN / 2
            low, high = np.where(g * f > 0, middle, low), np.where(g * f > 0, high, middle)
        return list((low + high) / 2)


def actual(m, motion, s):
    """The columns of an integrated motion."""
    inertia = motion.motor.inertia
    J = m.chain.power(s, m.chain.inertia_effort(m.chain.scale(s.select(slice(None)), 0 * s.theta2, 0 * s.theta2 + 1)))
    return {'T_motor': motion.motor.torque(s.omega2), 'J': J, 'energy': (J + inertia) * s.omega2 ** 2 / 2, 'energy_residual': 0 * J}
