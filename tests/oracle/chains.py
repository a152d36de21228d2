# SPDX-License-Identifier: GPL-3.0-or-later
#
# chains.py - the oracle's chain (chain.py) beside values of another method: links that are driven at the piston, the rocker,
# the yoke, the slide or by an actuator, and pairs of links that hang on one of the four.  The values are from closed forms
# with Newton's and Euler's equations of each body, in 40 digits.
#
# Each row is moved by the crank, then by its real driver at the same speed and acceleration: the motion is to be the same.
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..'))
from chain import REAL, Along, Angle, Chain, Distance, Pin, Slide, meet, reach  # noqa: E402
from linkage import Checks  # noqa: E402

checks = Checks()
worst = [0.0]
CLOSE = 3e-11  # of the largest number of a row: the values have twelve digits


def at(length, degrees):
    return length * np.exp(1j * np.radians(degrees))


class Rig:
    """Bodies, joints, loads, and where they are at a crank angle."""

    def __init__(self, bodies, joints, place, loads, gravity=-9.81j, torques=()):
        self.bodies, self.joints, self.place, self.loads, self.gravity, self.torques = bodies, joints, place, loads, gravity, torques

    def state(self, theta2, omega2, alpha2):
        theta = np.array([np.radians(REAL(theta2))], REAL)
        chain = Chain(self.bodies, self.joints, Angle(1, 0))
        s = chain.close(chain.begin(*self.place(theta)), theta)
        return chain.move(s, np.array([omega2]), np.array([alpha2]))

    def row(self, s, driver):
        """The joints' forces, and the effort of the driver."""
        chain = Chain(self.bodies, self.joints, driver)
        s.inverse = chain.inverse(s)
        Q = chain.weight(s, self.gravity) - chain.inertia_effort(s)
        for body, point, force in self.loads:
            Q = Q + chain.effort(s, body, s.place(body, point), force)
        for body, torque in self.torques:
            Q = Q + chain.effort(s, body, s.r[body], 0, torque)
        found, effort = chain.forces(s, chain.multipliers(s, [Q])[0])
        return [complex(force[0]) for force, _ in found], float(effort[0])

    def moves_alike(self, s, driver):
        """The same motion from the rate and the second rate of the driver."""
        chain = Chain(self.bodies, self.joints, driver)
        rows = np.zeros((1, 3 * chain.n), REAL)
        for body, *parts in driver.gradient(s):
            for m in range(3):
                if body:
                    rows[:, 3 * (body - 1) + m] += parts[m]
        def of(a, alpha):
            return sum(rows[:, 3 * k] * a[k + 1].real + rows[:, 3 * k + 1] * a[k + 1].imag + rows[:, 3 * k + 2] * alpha[k + 1] for k in range(chain.n))
        driven = chain.begin([s.place(k, 0) for k in range(1, chain.n + 1)], s.phi[1:])
        driver.value = 0
        driven = chain.close(driven, driver.error(s))
        chain.move(driven, of(s.v, s.omega), of(s.a, s.alpha) + driver.curvature(s))
        return max(float(abs(x - y).max()) for p, q in ((s.alpha, driven.alpha), (s.omega, driven.omega), (s.phi, driven.phi)) for x, y in zip(p, q)
                   if np.ndim(y))


def compare(what, found, wanted, size):
    error = abs(found - wanted) / size
    worst[0] = max(worst[0], error)
    checks.that(error < CLOSE, '%s: %s, not %s' % (what, found, wanted))


def four_bar(a, b, c, d, bodies, loads, **others):
    def place(theta):
        B = a * np.exp(1j * theta)
        C = meet(B, b, d, c, 1)
        return [0 * B, B, d + 0 * B], [theta, np.angle(C - B), np.angle(C - d)]
    return Rig(bodies, [Pin(1, 0, 0, 0), Pin(2, 0, 1, a), Pin(3, c, 2, b), Pin(3, 0, 0, d)], place, loads, **others)


def slider_crank(a, l, e, bodies, loads, side=1, **others):
    def place(theta):
        B = a * np.exp(1j * theta)
        C = reach(B, l, 1j * e, 1 + 0j, side)
        return [0 * B, B, C], [theta, np.angle(C - B), 0 * theta]
    return Rig(bodies, [Pin(1, 0, 0, 0), Pin(2, 0, 1, a), Pin(3, 0, 2, l), Slide(3, 0, 0, 1j * e, 1, 0)], place, loads, **others)


def inverted(a, d, h, bodies, loads, side=1, **others):
    def place(theta):
        B = a * np.exp(1j * theta)
        r = B - d
        lever = np.angle(r) - np.angle(side * np.sqrt(abs(r) ** 2 - h * h) + 1j * h)
        return [0 * B, B, d + 0 * B], [theta, lever, lever]
    return Rig(bodies, [Pin(1, 0, 0, 0), Pin(2, 0, 1, a), Slide(2, 0, 3, 1j * h, 1, 0), Pin(3, 0, 0, d)], place, loads, **others)


def yoke(a, beta, e, bodies, loads):
    def place(theta):
        B = a * np.exp(1j * theta)
        C = B.real + (e - B.imag) / np.tan(beta) + 1j * e
        return [0 * B, B, C], [theta, 0 * theta, 0 * theta]
    slot = np.exp(1j * REAL(beta))
    return Rig(bodies, [Pin(1, 0, 0, 0), Pin(2, 0, 1, a), Slide(2, 0, 3, 0, slot, 0), Slide(3, 0, 0, 1j * e, 1, 0)], place, loads)


def with_pair(rig, bodies, joints, begin, loads, torques=()):
    """The same with two more bodies; begin(theta, place of a point of a body) gives their origins and angles."""
    def place(theta):
        origins, angles = rig.place(theta)

        def point(body, p):
            return origins[body - 1] + np.exp(1j * angles[body - 1]) * p if body else p
        more, turned = begin(point)
        return origins + more, angles + turned
    return Rig(rig.bodies + bodies, rig.joints + joints, place, rig.loads + loads, rig.gravity, torques)


def with_slider(rig, k, p, rod, line, u, side, bodies, force):
    def begin(point):
        P = point(k, p)
        Q = reach(P, rod, line, u, side)
        return [P, Q], [np.angle(Q - P), np.angle(u) + 0 * P.real]
    joints = [Pin(4, 0, k, p), Pin(5, 0, 4, rod), Slide(5, 0, 0, line, u, np.angle(u))]
    return with_pair(rig, bodies, joints, begin, [(5, 0, force)])


def with_rocker(rig, k, p, rod, j, pivot, rocker, side, bodies, force):
    def begin(point):
        P, R = point(k, p), point(j, pivot)
        Q = meet(P, rod, R, rocker, side)
        return [P, R + 0 * P], [np.angle(Q - P), np.angle(Q - R)]
    joints = [Pin(4, 0, k, p), Pin(5, rocker, 4, rod), Pin(5, 0, j, pivot)]
    return with_pair(rig, bodies, joints, begin, [(5, rocker, force)])


# -------------------------------------------------------------------------------------------------- drives

ROWS = [  # rig, driver, crank: angle, speed, acceleration; its effort, F12, torque of the crank if it drove
    ('slider-crank', 'piston', (60, 12, -40), 299.636490199, -1.58949929838 + 13.8189064566j, -14.2395832006),
    ('slider-crank', 'piston', (330, 5, 0), 305.619476274, -7.25336289289 + 15.9597310187j, 9.99268451649),
    ('crossed', 'piston', (75, 20, 50), 280.439514287, 2.94468043924 + 11.1705870958j, -12.2256396258),
    ('crossed', 'piston', (250, -8, 0), 299.068625755, 2.24809320689 + 17.9485853228j, 14.7480445878),
    ('four-bar', 'actuator', (50, 0, 0), -637.754318063, 249.486690939 + 307.790660231j, 11.4165505273),
    ('four-bar', 'actuator', (290, -2, 4), 250.088385108, -36.9039145658 + 111.9502337j, 12.0590523385),
    ('four-bar', 'between', (110, 3, -5), 290.512493772, 30.8266164461 + 169.626510075j, -13.4588628582),
    ('four-bar', 'rocker', (110, 3, -5), -31.1068178398, -35.2439374146 + 107.412874395j, -13.4588628582),
    ('boom', 'slide', (40, 0.2, 0), 5414.97318529, 4071.75803339 - 1176.73933594j, 4281.11597482),
    ('boom', 'slide', (100, 0.3, 0.5), -1513.31214123, -1332.87685727 + 3149.33109756j, -920.95020571),
    ('yoke', 'yoke', (40, 30, 0), 345.238650436, -17.7943277342 - 9.69921383881j, -22.476353059),
    ('yoke', 'yoke', (215, -12, -40), 398.582234559, 8.45442110144 + 10.69609354j, 25.0273154605),
    ('lever', 'lever', (60, 6, 20), -34.090446207, 19.0096459062 + 38.1554437014j, -2.20539589242),
    ('lever', 'slide', (200, -5, 10), 52.8657946138, 54.523381596 + 24.4890860052j, -1.49085003885),
    ('lever crossed', 'slide', (200, -5, 10), -109.863678652, 107.523104125 + 43.77940743j, -3.09822770629)]

LEVER = [(0.8, 0.0015, 0.05 + 0.004j), (0.3, 0.00012, 0.002 - 0.001j), (2.5, 0.035, 0.21 + 0.012j)]
PISTON = [(1.2, 0.003, 0), (0.8, 0.004, 0.07), (0.6, 0, 0)]
RIGS = {
    'slider-crank': slider_crank(0.05, 0.2, 0.01, PISTON, [(3, 0, -300)]),
    'crossed': slider_crank(0.05, 0.2, -0.02, [PISTON[0], (0.8, 0.004, 0.07 + 0.005j), PISTON[2]], [(3, 0, -300)], -1),
    'four-bar': four_bar(0.15, 0.4, 0.35, 0.5, [(2, 0.01, 0.07), (3, 0.05, 0.2 + 0.01j), (4, 0.06, 0.17 - 0.02j)], [(2, 0.2 + 0.1j, -150j)]),
    'boom': inverted(0.8, 1.2, 0, [(40, 9, 1.5), (0, 0, 0), (0, 0, 0)], [(1, 2.5, -2000j)]),
    'yoke': yoke(0.06, np.radians(60), 0.025, [(0.8, 0.0012, 0.02), (0.25, 0.0001, 0), (2.4, 0, 0.15 + 0.01j)], [(3, 0.3, -400)]),
    'lever': inverted(0.12, 0.25, 0.03, LEVER, [(3, 0.45, -150 + 0j)]),
    'lever crossed': inverted(0.12, 0.25, 0.03, LEVER, [(3, 0.45, -150 + 0j)], -1)}
DRIVERS = {'piston': lambda: Along(0, 1, 3, 0, 0, 0), 'yoke': lambda: Along(0, 1, 3, 0, 0, 0), 'rocker': lambda: Angle(3, 0),
           'lever': lambda: Angle(3, 0), 'slide': lambda: Along(3, 1, 2, 0, 3, 0),
           'actuator': lambda: Distance(3, 0.15 + 0.05j, 0, 0.1 - 0.3j), 'between': lambda: Distance(2, 0.1 + 0.05j, 1, -0.05 + 0.1j)}


def check_drives():
    alike = 0.0
    for name, drive, crank, effort, F12, Ts in ROWS:
        rig, what = RIGS[name], '%s driven at the %s, %g deg' % (name, drive, crank[0])
        s = rig.state(*crank)
        compare(what + ', Ts', rig.row(s, Angle(1, 0))[1], Ts, abs(effort))
        forces, found = rig.row(s, DRIVERS[drive]())
        compare(what + ', its effort', found, effort, abs(effort))
        compare(what + ', F12', forces[0], F12, abs(effort))
        alike = max(alike, rig.moves_alike(s, DRIVERS[drive]()))
    checks.that(alike < 1e-13, 'the motion from the driver differs by %g' % alike)
    return alike


# -------------------------------------------------------------------------------------------------- pairs of links

def check_pairs():
    four = four_bar(0.1, 0.35, 0.3, 0.4, [(0.8, 0.002, 0.05), (2, 0.03, 0.17 + 0.02j), (1.5, 0.02, 0.15)], [])
    quick = inverted(0.15, 0.35, 0, [(2, 0.01, 0.05), (0.5, 0.001, 0), (6, 0.25, 0.3)], [], gravity=9.81)
    watt = four_bar(0.084, 0.12, 0.108, 0.132, [(0.5, 0.001, 0.042), (1.2, 0.01, 0.08 + 0.03j), (1, 0.01, 0.07 - 0.04j)], [])
    engine = slider_crank(0.05, 0.18, 0, [(3, 0.01, -0.01), (0.9, 0.004, 0.06), (0.7, 0, 0)], [])
    ram = [(0.9, 0.012, 0.2 + 0.01j), (2.5, 0.01, 0.03 + 0.02j)]
    u = at(1, 60)
    cases = [  # what, rig, crank, force of the carrying link on the pair at P, torque
        ('a ram', with_slider(four, 3, 0.3 + 0.08j, 0.45, 0.9 + 0.35j, at(1, -10), 1, ram, -200 + 30j), (35, 10, 0),
         150.240267883 + 41.5657758003j, 3.33579005453),
        ('a ram', with_slider(four, 3, 0.3 + 0.08j, 0.45, 0.9 + 0.35j, at(1, -10), 1, ram, -200 + 30j), (160, 10, 50),
         225.368390875 + 152.508344767j, -22.6735748851),
        ('a shaper', with_slider(quick, 3, 0.7, 0.3, -0.5 + 0j, 1j, -1, [(1.1, 0.01, 0.15), (20, 0.1, 0.1 - 0.02j)], -900j), (35, 10, 0),
         -394.483955647 - 481.001520994j, -168.440762566),
        ('a second rocker', with_rocker(four, 2, 0.2 + 0.12j, 0.4, 0, 0.55 + 0.05j, 0.35, 1, [(0.7, 0.01, 0.2), (1.2, 0.015, 0.14 + 0.01j)], -80j),
         (35, 10, 0), -9.66238434848 + 0.246363746528j, 0.827392197894),
        ('a V-engine', with_slider(engine, 1, 0.05, 0.18, 0j, u, 1, [(0.9, 0.004, 0.06), (0.7, 0, 0)], -2500 * u), (35, 10, 0),
         992.952799496 + 2319.7370822j, 66.7052699298),
        ("Watt's six-bar", with_rocker(watt, 2, at(0.18, 30), 0.12, 3, at(0.18, -50), 0.12, 1, [(0.6, 0.002, 0.06), (0.5, 0.002, 0.06)], 20 - 50j),
         (50, 10, 0), -30.474940618 + 6.32362611532j, 8.18202389062)]
    for what, rig, crank, FP, Ts in cases:
        forces, torque = rig.row(rig.state(*crank), Angle(1, 0))
        compare(what + ', F_P', forces[4], FP, abs(FP))
        compare(what + ', Ts', torque, Ts, max(abs(Ts), abs(FP) * 0.1))


if __name__ == '__main__':
    alike = check_drives()
    check_pairs()
    print('chains: worst %.1e of a row, motions by crank and driver %.1e apart' % (worst[0], alike))
    sys.exit(checks.finish())
