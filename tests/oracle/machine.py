# SPDX-License-Identifier: GPL-3.0-or-later
#
# machine.py - the machine of a deck as a chain (chain.py): its links and joints, what acts on them, friction.  Links
# have their numbers less 1: the ground is body 0, the crank 1.
import copy

import numpy as np

from chain import (REAL, Along, Angle, Chain, Pin, Slide, cross, meet, reach, root, solve, turned)
from deck import steffen, unit_of

KINDS = {'four-bar': ('ground', 'crank', 'coupler', 'rocker'), 'slider-crank': ('ground', 'crank', 'rod', 'piston'),
         'inverted-slider-crank': ('ground', 'crank', 'slider', 'lever'), 'scotch-yoke': ('ground', 'crank', 'slider', 'yoke')}
TURN, PI = 2 * np.arccos(REAL(-1)), np.arccos(REAL(-1))
ON_LINE = 1e-13   # of the sum of lengths: links that can lie in one line
STANDSTILL = 1e-12  # of unit crank speed: a joint is at rest
OK, APART, DEAD, CHANGE, LOCKED, NO_DIRECTION = 'ok', 'apart', 'dead', 'change', 'locked', 'no direction'


class Spring:
    """A spring or damper between two bodies."""

    def __init__(self, machine, name, keys):
        deck = machine.deck
        self.name, self.machine = name, machine
        self.i, self.j = (machine.links.index(keys.get(key, '').lower()) for key in ('link', 'to'))
        of = [unit_of(keys[key].split(None, 1)[1])[1] for key in ('stiffness', 'damping') if key in keys]
        self.torsional = any(powers[0] == 2 for powers in of)
        self.k, self.c = (deck.number(keys, key, 'stiffness') for key in ('stiffness', 'damping'))
        self.free = deck.number(keys, 'free_angle', 'angle') if self.torsional else deck.number(keys, 'free_length', 'length')
        self.preload = deck.number(keys, 'preload', 'torque' if self.torsional else 'force')
        self.p, self.q = (machine.point(body, keys.get(key, '')) for body, key in ((self.i, 'at'), (self.j, 'to_at')))
        self.only, self.first_angles = keys.get('only'), {}

    def find(self, s):
        """Length or angle, its rate, tension or torque, and the direction from P to Q."""
        if self.torsional:
            x, u = self.machine.winding(s, self.i) - self.machine.winding(s, self.j) + self.turns(s), 0
            rate = s.omega[self.i] - s.omega[self.j]
        else:
            r = s.place(self.j, self.q) - s.place(self.i, self.p)
            x = abs(r)
            u = r / np.where(x > 0, x, 1)
            rate = turned(u, s.velocity(self.j, self.q) - s.velocity(self.i, self.p))
        past = x - self.free
        acts = past < 0 if self.only == 'pushes' else past > 0 if self.only == 'pulls' else past == past
        return x, rate, acts * (self.preload + self.k * past + self.c * rate), u, acts * (self.k * past / 2 + self.preload) * past

    def turns(self, s):
        """Whole turns, so that it begins within half a turn of its free angle."""
        if s.label not in self.first_angles:
            first = self.machine.first_state(s.label)
            angle = self.machine.winding(first, self.i) - self.machine.winding(first, self.j) - self.free
            self.first_angles[s.label] = angle[0]
        return -TURN * np.floor(self.first_angles[s.label] / TURN + 0.5)

    def efforts(self, s):
        _, _, T, u, _ = self.find(s)
        act = self.machine.chain.effort
        if self.torsional:
            return act(s, self.i, 0, 0, -T) + act(s, self.j, 0, 0, T)
        return act(s, self.i, s.place(self.i, self.p), T * u) + act(s, self.j, s.place(self.j, self.q), -T * u)


class Output:
    """A rod on a point P of a body, and a slider or a rocker on the rod: bodies first and first + 1.  By a slot: a block without mass."""

    def __init__(self, machine, name, keys, first):
        deck = machine.deck
        self.name, self.first, self.machine = name, first, machine
        self.i, self.p = machine.body(keys['link']), machine.point(machine.body(keys['link']), keys['at'])
        self.rod, self.slides = deck.number(keys, 'rod', 'length'), 'line' in keys
        self.slot = keys.get('slot')  # output, link
        self.slot_angle = deck.number(keys, 'slot_angle', 'angle')
        self.offset = deck.number(keys, 'offset', 'length')
        self.r = 0 if self.slides else deck.number(keys, 'length', 'length')
        self.side = -1 if keys.get('side') in ('behind', 'right') else 1
        self.j = machine.body(keys['to']) if 'to' in keys else 0
        self.q = machine.point(self.j, keys['to_at']) if 'to' in keys else deck.vector(keys['line' if self.slides else 'pivot'], 'length')
        self.angle = deck.number(keys, 'angle', 'angle')
        self.u = np.exp(1j * REAL(self.angle))
        masses = []
        for front, length in (('rod_', self.rod), ('', self.r)):
            own = {key[len(front):]: value for key, value in keys.items() if key.startswith(front) and (front or not key.startswith('rod_'))}
            m = deck.number(own, 'mass', 'mass')
            if own.get('uniform') == 'yes':
                masses.append((m, m * length ** 2 / 12, complex(length / 2)))
            else:
                masses.append((m, deck.number(own, 'inertia', 'inertia', m * deck.number(own, 'gyration', 'length') ** 2), deck.point(own.get('cg', ''), length)))
        machine.masses += masses
        machine.length += [self.rod, self.r]

    def joints(self):
        end, e = self.first + 1, np.exp(1j * REAL(self.slot_angle))
        if self.slot == 'output':
            hang = Pin(self.first, 0, self.i, self.p), \
                Slide(self.first, 0, end, 0, e, self.slot_angle) if self.slides else Slide(self.first, 0, end, 1j * self.offset, 1, 0)
        elif self.slot:
            hang = Slide(self.first, 0, self.i, self.p, e, self.slot_angle), Pin(end, self.r, self.first, 0)
        else:
            hang = Pin(self.first, 0, self.i, self.p), Pin(end, self.r, self.first, self.rod)
        guide = Slide(self.first + 1, 0, 0, self.q, self.u, self.angle) if self.slides else Pin(self.first + 1, 0, self.j, self.q)
        return {self.name + '.P': hang[0], self.name + '.Q': hang[1], self.name + '.D': guide}

    def guess(self, point):
        """Origins and angles of both bodies; point(body, at) is where a point of a body is."""
        P, R = point(self.i, self.p), point(self.j, self.q)
        if self.slot:
            return self.guess_by_slot(P, R, point(self.i, self.p + np.exp(1j * REAL(self.slot_angle))) - P)
        if self.slides:
            Q = reach(P, self.rod, R, self.u, self.side)
            return (P, Q), (np.angle(Q - P), self.angle + 0 * P.real)
        Q = meet(P, self.rod, R, self.r, self.side)
        return (P, R), (np.angle(Q - P), np.angle(Q - R))

    def guess_by_slot(self, P, R, e):
        """e is the direction of a slot in the carrying body."""
        if self.slides:
            e = self.u * np.exp(1j * REAL(self.slot_angle)) + 0 * P if self.slot == 'output' else e
            Q = R + cross(P - R, e) / cross(self.u, e) * self.u
            return (P if self.slot == 'output' else Q, Q), (np.angle(e), self.angle + 0 * P.real)
        if self.slot == 'output':
            r = P - R
            e = r / (self.side * root(abs(r) ** 2 - self.offset ** 2, abs(r)) + 1j * self.offset)
            return (P, R), (np.angle(e), np.angle(e))
        c = turned(1j * e, P - R) / self.r
        axis = c * 1j * e + self.side * root(1 - c ** 2, 1) * e
        return (R + self.r * axis, R), (np.angle(e) + 0 * axis.real, np.angle(axis))

    def arm(self, s):
        """From the origin of slider or rocker to the block."""
        return s.place(self.first, 0) - s.place(self.first + 1, 0)

    def slide(self, s):
        """The place of the block along its slot, and its rate."""
        e, body = s.e[self.first], self.first + 1 if self.slot == 'output' else self.i
        at = (s.place(self.first, 0) - s.r[body]) / s.e[body] + self.machine.masses[body][2]  # in the axes of that body
        start = 0 if self.slot == 'output' else self.p
        return turned(e, s.place(self.first, 0) - s.place(body, start)), turned(e, s.velocity(self.first, 0) - s.velocity(body, at))

    def sine(self, s):
        if self.slot and self.slides:
            return abs(cross(s.e[self.first], self.u))
        if self.slot:
            return abs(turned(s.e[self.first], self.arm(s))) / abs(self.arm(s))
        rod, end = s.e[self.first], s.e[self.first + 1]
        return abs(turned(rod, end)) if self.slides else abs(cross(rod, end))


class Load:
    """A given force and torque."""

    def __init__(self, machine, keys):
        deck, self.machine = machine.deck, machine
        self.body = machine.body(keys['link'])
        self.at = machine.point(self.body, keys.get('at', ''))
        self.in_link = keys.get('frame') == 'link'
        self.window = [deck.number(keys, key, 'angle', None) for key in ('from', 'to')]
        if self.window[0] is not None and self.window[1] is None or self.window[1] is not None and self.window[0] is None:
            self.window = [x or 0 for x in self.window]
        self.over = keys.get('over', 'theta2').lower()
        quantity = {'theta2': 'angle', 'theta4': 'angle', 'x': 'length', 'slide': 'length', 'v': 'speed', 'slide_v': 'speed'}
        self.argument = quantity.get(self.over, 'angular_speed')
        self.exponent = deck.number(keys, 'exponent', 'number', 1.0)
        self.at_speed = deck.number(keys, 'at_speed', self.argument) if 'at_speed' in keys else 0
        self.curves, self.back = [], 'back' in keys
        own = 'torque' if 'torque' in keys else 'force'
        self.force, self.torque = (self.follow(keys.get(key), key) for key in ('force', 'torque'))
        self.force_back, self.torque_back = (self.follow(keys.get('back') if key == own else keys.get(key), key) for key in ('force', 'torque'))

    def follow(self, text, quantity):
        """A value as a function of the variable."""
        points = self.machine.deck.curve(text, self.argument, quantity) if text else None
        if points is None:
            value = self.machine.deck.vector(text, quantity) if text else 0
            return lambda x: value + 0 * x
        period = {'theta2': self.machine.cycle, 'theta4': float(TURN)}.get(self.over, 0)
        parts = [steffen([(x, f(y)) for x, y in points], period) for f in (lambda y: complex(y).real, lambda y: complex(y).imag)]
        self.curves.append(parts[0])
        return lambda x: parts[0](x) + 1j * parts[1](x)

    def is_on(self, s):
        if self.window[0] is None:
            return 1
        low, high = self.window
        cycle = self.machine.cycle
        passed = np.where(s.sense < 0, high - s.theta2, s.theta2 - low)
        passed = passed - cycle * np.floor(passed / cycle + 1e-12)
        return passed < high - low - 1e-12 * cycle

    def values(self, s):
        m = self.machine
        x = m.variable(s, self.over)
        if self.at_speed:
            factor = np.sign(x) * (abs(x) / self.at_speed) ** self.exponent
            return self.force(0 * x) * factor, np.real(self.torque(0 * x)) * factor
        force, torque = self.force(x), self.torque(x)
        if self.back:
            rate = m.variable(s.unit, {'theta2': 'omega2', 'theta4': 'omega4', 'x': 'v', 'slide': 'slide_v'}[self.over]) * s.sense
            falls = rate < -STANDSTILL * (m.a if self.over in ('x', 'slide') else 1)
            force, torque = np.where(falls, self.force_back(x), force), np.where(falls, self.torque_back(x), torque)
        on = self.is_on(s)
        return force * on, np.real(torque) * on

    def efforts(self, s):
        F, T = self.values(s)
        return self.machine.chain.effort(s, self.body, s.place(self.body, self.at), F * (s.e[self.body] if self.in_link else 1), T)


class Machine:
    """Geometry, masses and elements of a deck."""

    def __init__(self, deck):
        self.deck = deck
        self.kind = deck.word('', 'mechanism').lower()
        self.links = KINDS[self.kind]
        self.slides, self.slot = self.kind in ('slider-crank', 'scotch-yoke'), self.links[2] == 'slider'
        self.pinned = not self.slides
        number = deck.number
        self.cycle = number('motion', 'cycle', 'angle', float(TURN))
        self.length = [number(link, 'length', 'length') for link in self.links]
        self.e = number('ground', 'offset', 'length')
        self.beta = number('yoke', 'angle', 'angle', float(PI / 2))
        self.gamma = number('lever', 'angle', 'angle')
        self.h = number('lever', 'offset', 'length') if not self.length[3] else -self.length[3] * np.sin(REAL(self.gamma))
        self.tip = complex(self.length[3], 0 if self.length[3] else self.h)  # a point of the slide, in a lever's axes
        if 'stroke' in deck.section('crank'):
            s, l = number('crank', 'stroke', 'length'), self.length[2]
            self.length[1] = s / 2 if self.kind == 'scotch-yoke' else \
                s * np.sqrt((4 * (l * l - self.e ** 2) - s * s) / (4 * (4 * l * l - s * s)))
        self.snap()
        self.d, self.a, self.b, self.c = self.length
        g = number('gravity', 'acceleration', 'acceleration', 9.81)
        self.g = g * np.exp(1j * (number('gravity', 'direction', 'angle', -float(PI) / 2) - number('ground', 'angle', 'angle')))
        self.masses = [(0, 0, 0j)] + [self.mass_of(k, g) for k in (1, 2, 3)]
        self.balance()
        self.outputs = []
        for name, keys in deck.named('output'):
            self.outputs.append(Output(self, name, keys, len(self.masses)))
        self.build_chain()
        self.alone = self  # the four links, which springs wind up from where these can be assembled
        if self.outputs:
            bare = copy.copy(deck)
            bare.sections = [section for section in deck.sections if section[0] not in ('output', 'load', 'point', 'spring')]
            self.alone = Machine(bare)
        self.springs = [Spring(self, *section) for section in deck.named('spring')]
        self.loads = [Load(self, keys) for _, keys in deck.named('load')]
        self.points = [(name, self.body(keys['link']), self.point(self.body(keys['link']), keys.get('at', '')))
                       for name, keys in deck.named('point')]
        self.read_gas()
        self.read_friction()

    def snap(self):
        """Lengths that can lie in one line but for rounding do so; side = label at theta2 = 0 until a change point."""
        d, a, b, c = (REAL(x) for x in self.length)
        size = d + a + b + c
        self.changes = []  # crank angles
        near = (lambda x: abs(x) <= ON_LINE * (size + abs(self.e)))
        if self.kind == 'four-bar':
            folded = [k for k in (1, -1) if near(a - d - k * (b - c))]
            if near(a + d - b - c) and folded:
                b, c = (a, d) if folded[0] == 1 else (d, a)
            elif near(a + d - b - c):
                d = b + c - a
            elif folded:
                d = a - folded[0] * (b - c)
            self.changes = ([0] if folded else []) + ([PI] if near(a + d - b - c) else [])
        elif self.kind == 'slider-crank':
            for sign, at in ((1, PI / 2), (-1, -PI / 2)):
                if near(b + sign * self.e - a):
                    b = a - sign * REAL(self.e)
                    self.changes.append(at)
        elif self.kind == 'inverted-slider-crank' and near(abs(a - d) - abs(self.h)):
            self.h = (1 if self.h > 0 else -1) * abs(a - d)
            self.changes = [0]
        self.length = [d, a, b, c]

    def side(self, theta2, label):
        """1 or -1: the label changes sides at each change point from theta2 = 0, just behind it."""
        passed = sum(np.floor((theta2 - at) / TURN) - np.floor((1e-30 - at) / TURN) for at in self.changes) if self.changes else 0
        return label * (1 - 2 * (passed % 2))

    def mass_of(self, body, g):
        link, deck = self.links[body], self.deck
        keys = deck.section(link)
        m, l = deck.number(keys, 'mass', 'mass'), float(self.length[body])
        if keys.get('uniform', '').lower() == 'yes':
            return m, m * l * l / 12, complex(l / 2, 0)
        cg = deck.point(keys.get('cg', ''), l)
        inertia = deck.number(keys, 'inertia', 'inertia', m * deck.number(keys, 'gyration', 'length') ** 2)
        if 'swing_period' in keys:
            b = abs(deck.point(keys['swing_pin'], l, cg) - cg)
            inertia = m * (b * (g or 9.81) * (deck.number(keys, 'swing_period', 'time') / float(TURN)) ** 2 - b * b)
        return m, inertia, cg

    def body(self, text):
        """Of one of the four links, or NAME or NAME.rod of an output."""
        for output in self.outputs:
            if text in (output.name, output.name + '.rod'):
                return output.first + (text == output.name)
        return self.links.index(text.lower())

    def point(self, body, text):
        return self.deck.point(text, float(self.length[body]), self.masses[body][2]) if body else self.deck.point(text, float(self.d))

    def build_chain(self):
        a, b, c, d = self.a, self.b, self.c, self.d
        self.joints = {'A': Pin(1, 0, 0, 0), 'B': Pin(2, 0, 1, a)}
        if self.kind == 'four-bar':
            self.joints.update(C=Pin(3, c, 2, b), D=Pin(3, 0, 0, d))
        elif self.kind == 'slider-crank':
            self.joints.update(C=Pin(3, 0, 2, b), guide=Slide(3, 0, 0, 1j * self.e, 1, 0))
        elif self.slides:
            self.joints.update(slot=Slide(2, 0, 3, 0, np.exp(1j * REAL(self.beta)), self.beta), guide=Slide(3, 0, 0, 1j * self.e, 1, 0))
        else:
            self.joints.update(guide=Slide(2, 0, 3, self.tip, np.exp(1j * REAL(self.gamma)), self.gamma), D=Pin(3, 0, 0, d))
        for output in self.outputs:
            self.joints.update(output.joints())
        self.chain = Chain(self.masses[1:], list(self.joints.values()), Angle(1, 0))

    # ------------------------------------------------------------------------------------------------- motion

    def guess(self, theta2, side):
        """Origins and angles of crank, link 3 and link 4."""
        zero = 0 * theta2 + 0j
        B = self.a * np.exp(1j * theta2)
        if self.kind == 'four-bar':
            C = meet(B, self.b, self.d + zero, self.c, side)
            return (zero, B, self.d + zero), (theta2, np.angle(C - B), np.angle(C - self.d))
        if self.kind == 'slider-crank':
            C = reach(B, self.b, 1j * self.e + zero, 1, side)
            return (zero, B, C), (theta2, np.angle(C - B), zero.real)
        if self.slides:
            C = B - np.exp(1j * REAL(self.beta)) * (B.imag - self.e) / np.sin(REAL(self.beta))
            return (zero, B, C), (theta2, self.beta + zero.real, zero.real)
        r = B - self.d
        s = side * root(abs(r) ** 2 - self.h ** 2, self.d)
        slide = np.angle(r / (s + 1j * self.h))
        return (zero, B, self.d + zero), (theta2, slide, slide - self.gamma)

    def state(self, theta2, omega2, alpha2, label, sense=None):
        """Places, motions and the motion at unit crank speed of those crank angles that can be reached; s.which are these,
        s.status the reason for each of all."""
        theta2 = np.atleast_1d(np.asarray(theta2, REAL))
        side = self.side(theta2, label)
        origins, angles = self.guess(theta2, side)
        for output in self.outputs:
            more, turns = output.guess(lambda body, at: origins[body - 1] + np.exp(1j * angles[body - 1]) * at if body else at + 0 * origins[0])
            origins, angles = origins + more, angles + turns
        which = np.isfinite(sum(angles[1::2]))
        status = np.where(which, OK, APART).astype(object)
        pick = (lambda x: (x + 0 * theta2)[which])
        s = self.chain.begin([pick(o) for o in origins], [pick(x) for x in angles])
        s.theta2, s.omega2, s.alpha2, s.label = pick(theta2), pick(omega2), pick(alpha2), label
        s.sense = np.where(s.omega2 != 0, np.sign(s.omega2), self.direction if sense is None else sense)
        s.sine = self.sine(s)
        dead = s.sine ** 2 <= 1e-14
        status[np.nonzero(which)[0][dead]] = DEAD
        for change in self.changes:
            status[(status != OK) & (abs((theta2 - change + PI) % TURN - PI) < 1e-6)] = CHANGE
        s = s.select(~dead)
        self.chain.close(s, s.theta2)
        s.status, s.which, s.sine = status, status == OK, self.sine(s)
        one = s.theta2 * 0 + 1
        s.unit = self.chain.move(s.select(slice(None)), one)
        s.unit.omega2, s.unit.alpha2, s.inverse = one, 0 * one, s.unit.inverse
        return self.chain.scale(s, s.omega2, s.alpha2)

    def sine(self, s):
        """The smallest sine of a transmission angle."""
        found = self.own_sine(s)
        for output in self.outputs:
            found = np.minimum(found, output.sine(s))
        return found

    def own_sine(self, s):
        """That of the four links."""
        if self.kind == 'four-bar':
            return abs(cross(s.e[2], s.e[3]))
        if self.kind == 'slider-crank':
            return abs(s.e[2].real)
        if self.slides:
            return abs(np.sin(REAL(self.beta))) + 0 * s.theta2
        r = s.place(1, self.a) - self.d
        return abs(turned(s.e[2], r)) / abs(r)

    def variable(self, s, name):
        """What a load may follow."""
        C, B = s.place(3, 0), s.place(2, 0)
        u = s.e[2]
        vB = s.velocity(2, 0) - (s.v[3] + 1j * s.omega[3] * (B - s.r[3]))  # relative to link 4
        return {'theta2': lambda: s.theta2, 'theta4': lambda: s.phi[3], 'omega2': lambda: s.omega2, 'omega4': lambda: s.omega[3],
                'x': lambda: self.inner(s) - s.label * C.real, 'v': lambda: -s.label * s.velocity(3, 0).real,
                'slide': lambda: turned(u, B - s.place(3, self.tip if self.pinned else 0)), 'slide_v': lambda: turned(u, vB)}[name]()

    def inner(self, s):
        """How far from A, along x, piston or yoke can go."""
        if self.kind == 'scotch-yoke':
            return (self.e * np.cos(REAL(self.beta)) + self.a) / np.sin(REAL(self.beta))
        return np.sqrt((self.a + self.b) ** 2 - self.e ** 2)

    def first_state(self, label):
        """The first position from theta2 = 0."""
        theta2 = np.arange(0, 3601) * (TURN / 3600) + 1e-6
        m = self.alone
        s = m.state(theta2, 1, 0, label)
        low = theta2[s.which][0]
        if low > 1e-5:  # where it begins
            high = low - TURN / 3600
            for _ in range(60):
                middle = (low + high) / 2
                low, high = (middle, high) if m.state(middle, 1, 0, label).which[0] else (low, middle)
        return m.state(low + 1e-7, 1, 0, label)

    def winding(self, s, body):
        """The angle of a body, which goes on over turns and is smooth where the linkage can be assembled."""
        if body < 2 or self.slides and body == 3 or self.kind == 'scotch-yoke':
            return s.theta2 if body == 1 else s.phi[body] + 0 * s.theta2
        if not hasattr(self, 'windings'):
            self.windings = {}
        if (s.label, body) not in self.windings:  # over two turns, the period with a change point
            theta2 = np.arange(-7200, 7201) * (TURN / 7200) + 1e-7
            t = self.alone.state(theta2, 1, 0, s.label)
            self.windings[s.label, body] = theta2[t.which], np.unwrap(t.phi[body].astype(float)), not t.which.all()
        x, y, gap = self.windings[s.label, body]
        turns = 0 if gap else np.floor(s.theta2 / (2 * TURN) + 0.25)
        at = s.theta2 - 2 * TURN * turns
        if gap:
            turns = np.floor(s.theta2 / TURN)
            at = s.theta2 - TURN * turns
        near = np.interp(at.astype(float), x.astype(float), y)
        whole = 0 if gap else turns * (np.interp(float(TURN), x.astype(float), y) - np.interp(-float(TURN), x.astype(float), y))
        near = near + np.round(whole / TURN) * TURN
        return s.phi[body] + TURN * np.round((near - s.phi[body]) / TURN)

    # ------------------------------------------------------------------------------------------------- forces

    def read_gas(self):
        deck, self.gas = self.deck, None
        if not deck.has('gas'):
            return
        area = PI / 4 * deck.number('gas', 'bore', 'length') ** 2
        back = deck.number('gas', 'back_pressure', 'pressure') * (area - PI / 4 * deck.number('gas', 'piston_rod', 'length') ** 2)
        pressure, card = deck.number('gas', 'pressure', 'pressure'), deck.word('gas', 'indicator')
        self.card = steffen(deck.curve(card, 'angle', 'pressure'), self.cycle) if card else None
        self.bore_area, self.pressure = area, (lambda theta2: self.card(theta2) if card else pressure + 0 * theta2)
        self.gas = (lambda theta2: self.pressure(theta2) * area - back)
        self.largest_pressure = max(abs(y) for _, y in deck.curve(card, 'angle', 'pressure')) if card else abs(pressure)
        self.clearance = deck.section('gas').get('clearance')

    def clearance_volume(self):
        """A share of the displacement, a length along the stroke or a volume."""
        if not self.clearance:
            return 0
        number, unit = self.clearance.split(None, 1)
        value, powers = unit_of(unit)
        return float(number) * value * {0: self.bore_area * self.stroke(), 1: self.bore_area, 3: 1}[powers[0]]

    def stroke(self):
        if self.kind == 'scotch-yoke':
            return 2 * self.a / abs(np.sin(REAL(self.beta)))
        return np.sqrt((self.b + self.a) ** 2 - self.e ** 2) - np.sqrt((self.b - self.a) ** 2 - self.e ** 2)

    def gas_efforts(self, s):
        """On the piston, towards the crank; or on the rod along the slide, and on the cylinder against it."""
        F = self.gas(s.theta2)
        if self.slides:
            return self.chain.effort(s, 3, s.place(3, 0), -s.label * F)
        B = s.place(2, 0)
        return self.chain.effort(s, 2, B, F * s.e[2]) - self.chain.effort(s, 3, B, F * s.e[2])

    def read_friction(self):
        deck = self.deck
        keys, self.rubs, self.radius = deck.section('friction'), {}, {}
        self.direction = -1 if keys.get('direction') == 'backward' else 1
        for name, joint in self.joints.items():
            if '.' in name:  # of an output: no friction
                continue
            if joint.guide:
                self.rubs[name] = deck.number(keys, name, 'number'), deck.number(keys, name + '_length', 'length')
            else:
                mu = deck.number(keys, name if name in keys else 'mu', 'number')
                self.radius[name] = deck.number(keys, 'radius_' + name if 'radius_' + name in keys else 'radius', 'length')
                self.rubs[name] = mu * self.radius[name], 0
        self.rubs = {name: rub for name, rub in self.rubs.items() if rub[0] > 0}

    def joint_speed(self, s, joint):
        """Of body i relative to body j: angular, or along the slide."""
        if not joint.guide:
            return s.omega[joint.i] - s.omega[joint.j]
        place = s.place(joint.i, joint.p)
        there = s.v[joint.j] + 1j * s.omega[joint.j] * (place - s.r[joint.j]) if joint.j else 0
        return turned(joint.u * s.e[joint.j], s.velocity(joint.i, joint.p) - there)

    def unit_friction(self, s, joint):
        """Friction of size 1, against the relative motion."""
        speed = self.joint_speed(s.unit, joint) * s.sense
        sign = np.sign(speed) * (abs(speed) > STANDSTILL * (self.a if joint.guide else 1))
        act = self.chain.effort
        if not joint.guide:
            return sign, act(s, joint.i, 0, 0, -sign) + act(s, joint.j, 0, 0, sign)
        place, along = s.place(joint.i, joint.p), sign * joint.u * s.e[joint.j]
        return sign, act(s, joint.i, place, -along) + act(s, joint.j, place, along)

    def applied(self, s):
        """Springs, loads, gas, without weights."""
        efforts = sum((element.efforts(s) for element in self.springs + self.loads), self.chain.effort(s, 0, 0, 0))
        return efforts + self.gas_efforts(s) if self.gas else efforts

    def forces(self, s):
        """Multipliers of all (x), of loads and weights (static; still: with the friction that these cause), of inertia, without
        friction (x0); the sizes of friction."""
        external, weight, inertia = self.applied(s), self.chain.weight(s, self.g), self.chain.inertia_effort(s)
        units = [self.unit_friction(s, self.joints[name]) for name in self.rubs]
        found = self.chain.multipliers(s, [external + weight, -inertia] + [u for _, u in units])
        s.external, s.weight, s.inertial = external, weight, inertia
        s.static, s.of_inertia = found[:2]
        s.x0 = [p + q for p, q in zip(*found[:2])]
        moves = [sign != 0 for sign, _ in units]
        y, s.locked = self.friction(s, s.x0, found[2:], moves)
        z, s.locked_still = self.friction(s, s.static, found[2:], moves)
        s.still = [x + sum(size * column[k] for size, column in zip(z, found[2:])) for k, x in enumerate(s.static)]
        s.y = dict(zip(self.rubs, y))
        s.x = [x + sum(size * column[k] for size, column in zip(y, found[2:])) for k, x in enumerate(s.x0)]
        s.friction_efforts = sum(size[:, None] * u for size, (_, u) in zip(y, units)) if y else 0 * external
        return s

    def friction(self, s, x0, columns, moves):
        """The sizes y of friction: y = rho |F| of pins, mu max(|N|, 2 |M| / l) of guides, with F = F0 + S y.  By repetition,
        which converges if it contracts; else the solution is followed while friction grows from 0, by Newton's method:
        where the determinant of 1 - dphi/dy gets to 0, the machine is locked."""
        n, names = len(s.theta2), list(self.rubs)
        if not names:
            return [], np.zeros(n, bool)
        of = [dict(zip(self.joints, self.chain.forces(s, x)[0])) for x in [x0] + columns]
        F, M = (np.array([[at[name][k] + 0 * s.theta2 for name in names] for at in of]) for k in (0, 1))  # column, joint, row
        factor, length = (np.array([self.rubs[name][k] for name in names])[:, None] for k in (0, 1))
        factor = factor * np.array(moves)
        lever = np.where(length > 0, 2 / np.where(length > 0, length, 1), 0)

        def sizes(y, rows, with_slopes=True):
            """phi and dphi/dy."""
            f, m = (x[0][:, rows] + (y[:, None] * x[1:][:, :, rows]).sum(axis=0) for x in (F, M))
            by_couple = lever * abs(m) > abs(f)
            phi = factor[:, rows] * np.where(by_couple, lever * abs(m), abs(f))
            if not with_slopes:
                return phi
            slopes = np.where(by_couple, lever * np.sign(m) * M[1:][:, :, rows], turned(F[1:][:, :, rows], f) / np.where(f == 0, 1, abs(f)))
            return phi, factor[:, rows] * slopes

        y, rows = np.zeros((len(names), n), REAL), np.arange(n)
        for _ in range(12):
            new = sizes(y[:, rows], rows, False)
            close = abs(new - y[:, rows]).sum(axis=0) <= 1e-17 * abs(new).sum(axis=0)
            y[:, rows] = new
            rows = rows[~close]
        locked = np.zeros(n, bool)
        if len(rows):  # slower: Newton's method from there, if repetition contracts
            y[:, rows], slopes, fails = newton(lambda y: sizes(y, rows), y[:, rows])
            slopes[~np.isfinite(slopes)] = 9
            rows = rows[fails | (abs(np.linalg.eigvals(slopes)).max(axis=1) >= 1)]
        z, steps = np.zeros((len(names), len(rows)), REAL), 40
        for k in range(steps if len(rows) else 0):
            z, slopes, fails = newton(lambda y: [(k + 1) / REAL(steps) * x for x in sizes(y, rows)], z)
            locked[rows] |= fails | ~(np.linalg.det(np.eye(len(names)) - np.where(np.isfinite(slopes), slopes, 9)) > 0)
            z[:, locked[rows]] = 0
        y[:, rows] = z
        return list(y), locked

    def balance(self):
        """Counterweights; their mass moments follow from the first moment of all masses, sum m r = const + e2 X + e4 Y."""
        deck = self.deck
        keys, self.counterweights, self.reciprocating = deck.section('balance'), {}, 0
        if not deck.has('balance'):
            return
        m, z, a, b = [m[0] for m in self.masses], [m[2] for m in self.masses], self.a, self.b
        fraction = deck.number(keys, 'fraction', 'number')
        if self.kind == 'four-bar':
            own = m[1] * z[1] + m[2] * a * (1 - z[2] / b), m[3] * z[3] + m[2] * self.c / b * z[2]
        elif self.kind == 'slider-crank':
            self.reciprocating = m[3] + m[2] * z[2].real / b
            own = m[1] * z[1] + m[2] * a * (1 - z[2] / b) + fraction * self.reciprocating * a, 0
        elif self.slides:  # the yoke's place is a sin(beta - theta) / sin(beta): a vector at beta - 90 deg from the crank
            own = m[1] * z[1] + m[2] * a + fraction * m[3] * a * (1 + 1j / np.tan(REAL(self.beta))), 0
        else:
            own = m[1] * z[1] + m[2] * a, m[3] * z[3] + m[2] * z[2] * np.exp(1j * REAL(self.gamma))
        radius = deck.number(keys, 'radius', 'length')
        for body, U, wanted in ((1, own[0], keys.get('crank') == 'yes' or 'fraction' in keys), (3, own[1], keys.get('rocker') == 'yes')):
            if not wanted:
                continue
            U = -complex(U)
            self.counterweights['crank' if body == 1 else 'rocker'] = U, abs(U) / radius if radius else None
            if keys.get('apply') == 'yes' and U:
                mass, inertia, cg = self.masses[body]
                extra, place = abs(U) / radius, radius * U / abs(U)
                total = mass + extra
                centre = (mass * cg + U) / total
                inertia += mass * abs(cg - centre) ** 2 + extra * abs(place - centre) ** 2
                self.masses[body] = total, inertia, centre

    # ------------------------------------------------------------------------------------------------ corners

    def switches(self, s):
        """Functions of the position, smooth where they are not 0: where they change sign columns have corners."""
        unit = s.unit
        for load in self.loads:
            x = self.variable(s, load.over) if load.over in ('theta2', 'theta4', 'x', 'slide') else None
            period = {'theta2': self.cycle, 'theta4': float(TURN)}.get(load.over)
            for curve in load.curves if x is not None else []:
                for knot in curve.knots:
                    yield np.sin((x - knot) * PI / period) if period else x - knot
            for edge in load.window if load.window[0] is not None else []:
                yield np.sin((s.theta2 - edge) * PI / self.cycle)
            if load.back and load.over != 'theta2':
                yield self.variable(unit, {'theta4': 'omega4', 'x': 'v', 'slide': 'slide_v'}[load.over])
            if load.at_speed:
                yield self.variable(unit, load.over)
        for spring in self.springs:
            if spring.only:
                yield spring.find(unit)[0] - spring.free
        for knot in self.card.knots if self.gas and self.card else []:
            yield np.sin((s.theta2 - knot) * PI / self.cycle)
        for name in self.rubs:
            if name != 'A':
                yield self.joint_speed(unit, self.joints[name])

    def corners(self, label, low, high):
        """Crank angles of corners between two others."""
        n = int((high - low) / TURN * 720) + 2
        theta2 = low + (high - low) * np.arange(n + 1, dtype=REAL) / n + 1.234e-7
        s = self.state(theta2, 1, 0, label)
        found = [at + TURN * k for at in self.changes for k in range(int(low / TURN) - 2, int(high / TURN) + 3)]
        at = s.theta2
        for i, values in enumerate(self.switches(s)):
            k = np.nonzero((values[1:] * values[:-1] < 0) & (np.diff(at) < 2 * (high - low) / n))[0]
            if not len(k):
                continue
            a, b, fa = at[k], at[k + 1], values[k]
            for _ in range(60):
                middle = (a + b) / 2
                f = list(self.switches(self.state(middle, 1, 0, label)))[i]
                a, b = np.where(f * fa > 0, middle, a), np.where(f * fa > 0, b, middle)
            found += list((a + b) / 2)
        return sorted(float(x) for x in found if low < x < high)


def newton(sizes, y):
    """y = phi(y), from a first y: the solution, dphi/dy there, and where there is none."""
    one = np.eye(len(y))
    for _ in range(25):
        phi, slopes = sizes(y)
        slopes = np.moveaxis(slopes, 2, 0).swapaxes(1, 2)
        with np.errstate(all='ignore'):
            step = solve(one - slopes, (phi - y).T[:, :, None])[:, :, 0].T
        step = np.where(np.isfinite(step), step, 0)
        y = y + step
        if (abs(step).max(axis=0) <= 1e-16 * abs(y).max(axis=0)).all():
            break
    return y, slopes.astype(float), ~(abs(step).max(axis=0) <= 1e-9 * abs(y).max(axis=0))
