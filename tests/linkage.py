# SPDX-License-Identifier: GPL-3.0-or-later
#
# linkage.py - what the tests of drawings share: the numbers of a deck, its table, and its geometry from lengths and
# crank angle alone, by other equations than the program's.
#
# Places and vectors are complex numbers, x + i y: i z is z turned by 90 deg, (u / v).imag the cross product and so on.
# All values have the deck's units; Deck.factor converts between these.
import cmath
import csv
import io
import math
import os
import re
import subprocess
import sys
import xml.etree.ElementTree as xml

PICTURES = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'pictures')
SKIPPED = 77  # ctest's SKIP_RETURN_CODE
KINDS = ('four-bar', 'slider-crank', 'inverted-slider-crank', 'scotch-yoke')
NAMES = {'four-bar': ('ground', 'crank', 'coupler', 'rocker'), 'slider-crank': ('ground', 'crank', 'rod', 'piston'),
         'inverted-slider-crank': ('ground', 'crank', 'slider', 'lever'),
         'scotch-yoke': ('ground', 'crank', 'slider', 'yoke')}
SI = {'1': 1, 'm': 1, 'mm': 1e-3, 'cm': 1e-2, 'in': 0.0254, 'ft': 0.3048, 's': 1, 'min': 60, 'N': 1, 'kN': 1e3, 'kg': 1, 'J': 1,
      'W': 1, 'kW': 1e3, 'Pa': 1, 'lb': 0.45359237, 'psi': 4.4482216152605 / 0.0254**2,
      'hp': 550 * 0.3048 * 4.4482216152605, 'rad': 1, 'deg': math.pi / 180, 'lbf': 4.4482216152605}


def si_of(unit):
    """The SI value of a unit such as kN.ft or m/s2."""
    value = 1
    for sign, word in re.findall(r'([./]|^)([^./]+)', unit):
        name, power = re.fullmatch(r'([A-Za-z1]+?)(\d?)', word).groups()
        factor = SI[name] ** int(power or 1)
        value = value / factor if sign == '/' else value * factor
    return value


def dot(u, v):
    return (u.conjugate() * v).real


def cross(u, v):
    return (u.conjugate() * v).imag


def foot(point, on, direction):
    """The foot of the perpendicular from a point on the line through `on`."""
    return on + direction * dot(direction, point - on) / abs(direction) ** 2


def crossing(p, u, q, v):
    """Where the line through p along u meets that through q along v."""
    return p + u * cross(q - p, v) / cross(u, v)


# with inches; an energy cannot be told from a torque there
CUSTOMARY = 'in/s,in/s2,lb,lb.in2,lbf,lbf.in,hp,psi,lbf/in,lbf.s/in,lbf.in/rad,lbf.in.s/rad'


def drawn_units(path):
    """The option that gives results the units that pictures of a deck have, by that in which the crank is written."""
    with open(path, encoding='utf-8', errors='replace') as deck:
        text = re.sub('[#;].*', '', deck.read())
    sections = dict(re.findall(r'^\[(\w+)\] *\n([^[]*)', text, re.M))
    own = re.search(r'^length *=', sections.get('units', ''), re.M)
    crank = re.search(r'^(?:length|stroke) *= *[-+\d.,e]+ *([a-z]+) *$', sections.get('crank', ''), re.M)
    crank = crank or re.search(r'^B *= *(?:\([^)]*\)|[-+\d.e]+) *([a-z]+)', sections.get('pins', ''), re.M)
    if not crank or own:
        return []
    unit = crank.group(1)
    others = CUSTOMARY.replace('in', unit) if unit in ('in', 'ft') else 'm/s,m/s2'
    return ['--units=%s,%s' % (unit, others)]


class Program:
    """The program under test."""

    def __init__(self, fourlink, folder):
        self.fourlink, self.folder = os.path.abspath(fourlink), folder
        self.environment = dict(os.environ, LC_ALL='C')

    def run(self, *arguments, statuses=(0, 1)):
        """Run with arguments, the last a deck; its rows and facts have the units of pictures."""
        units = drawn_units(arguments[-1]) if '-f' in arguments else []
        done = subprocess.run([self.fourlink] + units + list(arguments), env=self.environment, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
        if done.returncode not in statuses:
            raise RuntimeError('fourlink %s: %d: %s' % (' '.join(arguments), done.returncode, done.stderr))
        return done.stdout

    def listing(self, deck, kind, *arguments):
        """The items of a picture (items.awk); '' if there is none."""
        name = os.path.join(self.folder, 'picture.svg')
        if os.path.exists(name):
            os.remove(name)
        self.run('--plot=' + name, '--plot-kind=' + kind, *arguments, deck.path)
        if not os.path.exists(name):
            return ''
        xml.parse(name)  # it is well-formed
        scripts = [word for script in ('svg', 'items') for word in ('-f', os.path.join(PICTURES, script + '.awk'))]
        return subprocess.run(['awk'] + scripts + [name], env=self.environment, stdout=subprocess.PIPE, check=True, encoding='utf-8').stdout


class Row:
    """A row of the table: row['F12x'], in the deck's units."""

    def __init__(self, names, cells):
        self.values = dict(zip(names, cells))
        self.is_ok = self.values.get('status') == 'ok'
        self.branch = self.values.get('branch', '')

    def __getitem__(self, name):
        return float(self.values[name])

    def __contains__(self, name):
        return self.values.get(name, '') not in ('', 'inf', '-inf', 'nan')

    def vector(self, name, x='x', y='y'):
        return complex(self[name + x], self[name + y])


class Deck:
    """A deck: its inputs as the program has understood them, and its table."""

    def __init__(self, program, path, *options):
        self.program, self.path, self.options = program, path, options
        self.name = os.path.basename(path)
        with open(path, encoding='utf-8', errors='replace') as text:
            self.text = text.read()
        self.kind = re.search(r'^\s*mechanism\s*=\s*([\w-]+)', self.text, re.M).group(1)
        self.kind = {'boom': KINDS[2]}.get(self.kind, self.kind)
        self.links = NAMES[self.kind]
        self.yoke = self.kind == KINDS[3]
        self.slides, self.slot = self.kind == KINDS[1] or self.yoke, self.kind == KINDS[2] or self.yoke
        self.inputs, self.units = {}, {}
        for row in csv.DictReader(io.StringIO(program.run('--summary', '-f', 'csv', '--columns=theta2', *options, path))):
            if '.' in row['name'] and '(' not in row['name']:
                self.inputs[row['name']] = row['value']
                self.units[row['name']] = row['unit']
        self.names, self.columns = [], {}
        self.is_single = 'motion.at' in self.inputs

    def table(self, *options, columns='all'):
        """Rows of the table by branch."""
        options = [x for x in options if not (self.yoke and x == '--branch=both')]  # it has one
        text = self.program.run('-f', 'csv', '--columns=' + columns, *self.options, *options, self.path)
        lines = list(csv.reader(io.StringIO(text)))
        names = []
        for head in lines[0]:
            name, _, unit = head.partition(' (')
            names.append(name)
            self.columns[name] = unit.rstrip(')')
        rows = {}
        for cells in lines[1:]:
            row = Row(names, cells)
            rows.setdefault(row.branch, []).append(row)
        return rows

    def number(self, name, default=0.0):
        return float(self.inputs.get(name, default))

    def vector(self, name):
        return complex(self.number(name + '.x'), self.number(name + '.y'))

    def length(self, link):
        return self.number(self.links[link - 1] + '.length')

    def mass(self, link):
        """kg"""
        name = self.links[link - 1] + '.mass'
        return self.number(name) * si_of(self.units.get(name, 'kg'))

    def gravity(self):
        """m/s2"""
        return self.vector('gravity') * si_of(self.units.get('gravity.x', 'm/s2'))

    def inertia(self, link):
        return self.number(self.links[link - 1] + '.inertia')

    def cg(self, link):
        return self.vector(self.links[link - 1] + '.cg')

    def link_number(self, name):
        return self.links.index(name) + 1

    def unit(self, quantity):
        """The deck's unit of length, speed, acceleration, force, torque, angle, angular_speed, angular_acceleration."""
        example = {'length': 'B.x', 'speed': 'B.vx', 'acceleration': 'B.ax', 'force': 'F12x', 'torque': 'Ts', 'angle': 'theta2',
                   'angular_speed': 'omega2', 'angular_acceleration': 'alpha2', 'time': 'time'}[quantity]
        return self.columns.get(example, {'force': 'N', 'torque': 'N.m'}.get(quantity, ''))

    def factor(self, quantity, *others):
        """What a product of these units, such as angular_speed length, is in the unit of the first quantity."""
        return math.prod(si_of(self.unit(x)) for x in others) / si_of(self.unit(quantity))

    @property
    def turn(self):
        """The angle by which drawings are turned, so that gravity acts downwards."""
        g = self.vector('gravity')
        return math.atan2(-g.real, -g.imag) if g else 0.0

    def loads(self):
        """The loads of the deck by name."""
        found = {}
        for name, value in self.inputs.items():
            match = re.fullmatch(r'load ?(.*?)\.([a-z_.]+)', name)
            if match:
                found.setdefault(match.group(1), {})[match.group(2)] = value
        return found

    def springs(self):
        found = {}
        for name, value in self.inputs.items():
            match = re.fullmatch(r'spring ?(.*?)\.([a-z_.]+)', name)
            if match:
                found.setdefault(match.group(1), {})[match.group(2)] = value
        return found

    def points(self):
        """Names of the tracer points and their links, as the text of the deck has them."""
        found, name = [], None
        for line in self.text.splitlines():
            line = line.split('#')[0].strip()
            section = re.fullmatch(r'\[(\w+)\s*(.*?)\]', line)
            if section:
                name = section.group(2) if section.group(1).lower() == 'point' else None
            elif name is not None and re.match(r'link\s*=', line):
                found.append((name, self.link_number(line.split('=')[1].strip())))
        return found

    def has_change_point(self):
        """1 if all links can lie in one line, where both branches meet."""
        a, b, c, d = (self.length(link) for link in (2, 3, 4, 1))
        if self.yoke:
            return False
        if self.slides:
            return abs(b - a) <= abs(self.number('ground.offset')) + 1e-9 * b and \
                abs(abs(b - a) - abs(self.number('ground.offset'))) < 1e-9 * b
        if self.slot:
            return abs(abs(a - d) - abs(self.offset_of_slide())) < 1e-9 * d
        return min(abs(a + d - b - c), abs(a - d - b + c), abs(a - d + b - c)) < 1e-9 * (a + b + c + d)

    def offset_of_slide(self):
        """h: the slide passes D at this distance, on the left of its axis; in a yoke the origin is on it."""
        if self.yoke:
            return 0
        if 'lever.offset' in self.inputs:
            return self.number('lever.offset')
        gamma = self.number('lever.angle') * si_of(self.units.get('lever.angle', 'deg'))
        return -self.length(4) * math.sin(gamma)

    def slot_angle(self):
        """rad, of the slot of a yoke"""
        return self.number('yoke.angle', 90) * si_of(self.units.get('yoke.angle', 'deg'))

    def place(self, theta2, branch, like=None):
        """The position, from lengths and the crank angle in rad.  Past a change point the branch is that whose coupler or
        slide has the direction `like`."""
        side = 1 if branch == 'open' else -1
        if like is not None and self.has_change_point():
            both = [Position(self, theta2, s) for s in (1, -1)]
            return min(both, key=lambda p: abs(p.axis[3] - cmath.rect(1, like)))
        return Position(self, theta2, side)

    def at(self, row):
        """The position and motion of a row: crank angle, speed and acceleration are its, all else is geometry."""
        angle = si_of(self.unit('angle'))
        position = self.place(row['theta2'] * angle, row.branch, row['theta3'] * angle)
        position.label = 1 if row.branch == 'open' else -1
        position.move(row['omega2'] * si_of(self.unit('angular_speed')), row['alpha2'] * si_of(self.unit('angular_acceleration')))
        return position

    def dead_centre(self):
        """How far from A, along x, the piston can go: rod and crank in one line."""
        e = self.number('ground.offset')
        if self.yoke:  # the crank is at right angles to the slot
            return e / math.tan(self.slot_angle()) + self.length(2) / math.sin(self.slot_angle())
        return math.sqrt((self.length(2) + self.length(3)) ** 2 - e * e)

    def nearest(self):
        """How near to A, along x, the piston comes: rod and crank in one line, folded; or the rod is across the stroke;
        through a change point to the other side."""
        r, l, e = self.length(2), self.length(3), self.number('ground.offset')
        if self.yoke:
            return e / math.tan(self.slot_angle()) - r / math.sin(self.slot_angle())
        if self.has_change_point():
            return -self.dead_centre()
        return math.sqrt((l - r) ** 2 - e * e) if l - r >= abs(e) else -math.sqrt(r * r - (l - abs(e)) ** 2)

    def slide_range(self, side):
        """The smallest and the largest coordinate of B along the slide."""
        if self.yoke:
            return tuple((k * self.length(2) - self.number('ground.offset')) / math.sin(self.slot_angle()) for k in (-1, 1))
        h, a, d = self.offset_of_slide(), self.length(2), self.length(1)
        far = math.sqrt((a + d) ** 2 - h * h)
        near = math.sqrt(max((a - d) ** 2 - h * h, 0))
        if self.has_change_point():
            near = -far
        return (near, far) if side > 0 else (-far, -near)


class Position:
    """The links at a crank angle: their origins and axes, then speeds and accelerations of their points.

    four-bar          B = a e^(i theta2);  C on the circles about B (radius b) and D = d (radius c), to the left of B -> D
                      if `side` is 1
    slider-crank      C = x + i e, |C - B| = l, on the +x side of B if `side` is 1
    inverted          B - D = (s + i h) u,  u along the slide,  s = side sqrt(|B - D|^2 - h^2)
    yoke              B - C = s u,  C = x + i e

    `joint` is where links 3 and 4 act on each other.
    """

    def __init__(self, deck, theta2, side):
        self.deck, self.side = deck, side
        a, b = deck.length(2), deck.length(3)
        self.A, self.B = 0j, cmath.rect(a, theta2)
        self.D = complex(deck.length(1), 0)
        self.axis = {2: cmath.rect(1, theta2)}
        if deck.yoke:
            u = cmath.rect(1, deck.slot_angle())
            self.s = (self.B.imag - deck.number('ground.offset')) / u.imag
            self.axis[3], self.axis[4] = u, 1
            self.C = self.D = self.end = self.B - self.s * u
        elif deck.slides:
            e = deck.number('ground.offset')
            self.C = self.B.real + side * math.sqrt(max(b * b - (e - self.B.imag) ** 2, 0)) + 1j * e
            self.axis[3], self.axis[4] = (self.C - self.B) / b, 1
            self.D = self.C
        elif deck.slot:
            r, h = self.B - self.D, deck.offset_of_slide()
            self.s = side * math.sqrt(max(abs(r) ** 2 - h * h, 0))
            self.axis[3] = r / complex(self.s, h)
            gamma = deck.number('lever.angle') * si_of(deck.units.get('lever.angle', 'deg'))
            self.axis[4] = self.axis[3] * cmath.exp(-1j * gamma)
            self.C = self.B
            self.end = self.D + deck.length(4) * self.axis[4]  # of the arm of the lever
        else:
            f, c = self.D - self.B, deck.length(4)
            along = (abs(f) ** 2 + b * b - c * c) / (2 * abs(f))
            across = math.sqrt(max(b * b - along * along, 0))
            self.C = self.B + f / abs(f) * complex(along, side * across)
            self.axis[3], self.axis[4] = (self.C - self.B) / b, (self.C - self.D) / c
        self.joint = self.B if deck.slot else self.C
        self.origin = {1: 0j, 2: self.A, 3: self.B, 4: self.C if deck.slides else self.D}

    def point(self, link, at):
        """A point of a link, given in the link's own axes; of the ground in x and y."""
        return at if link == 1 else self.origin[link] + at * self.axis[link]

    def move(self, omega2, alpha2):
        """Speeds and accelerations, rad/s and the deck's length per s, from the loop equations:

           v_B = i omega2 B,    a_B = (i alpha2 - omega2^2) B
           four-bar:      v_B + i omega3 r3 = i omega4 r4;  times r3 or r4 the unknown across drops out
           slider-crank:  the y components of v_C and a_C are 0
           inverted:      v_B = s' u + i omega (B - D),  a_B = s" u + 2 i omega s' u + (i alpha - omega^2) (B - D)
        """
        self.omega, self.alpha = {1: 0, 2: omega2}, {1: 0, 2: alpha2}
        vB, aB = 1j * omega2 * self.B, (1j * alpha2 - omega2 ** 2) * self.B
        r3 = self.C - self.B
        if self.deck.yoke:  # v_B = v_C + s' u: along y alone s' is left
            u = self.axis[3]
            self.slide_v, self.slide_a = vB.imag / u.imag, aB.imag / u.imag
            self.omega.update({3: 0, 4: 0})
            self.alpha.update({3: 0, 4: 0})
            self.v0 = {2: 0, 3: vB, 4: vB - self.slide_v * u}
            self.a0 = {2: 0, 3: aB, 4: aB - self.slide_a * u}
        elif self.deck.slides:
            w = -vB.imag / r3.real
            alpha = -(aB.imag - w * w * r3.imag) / r3.real
            self.omega.update({3: w, 4: 0})
            self.alpha.update({3: alpha, 4: 0})
            self.v0 = {2: 0, 3: vB, 4: vB + 1j * w * r3}
            self.a0 = {2: 0, 3: aB, 4: aB + (1j * alpha - w * w) * r3}
        elif self.deck.slot:
            u, h = self.axis[3], self.deck.offset_of_slide()
            own = vB / u
            w = own.imag / self.s
            self.slide_v = own.real + w * h
            own = aB / u
            alpha = (own.imag - 2 * w * self.slide_v + w * w * h) / self.s
            self.slide_a = own.real + alpha * h + w * w * self.s
            self.omega.update({3: w, 4: w})
            self.alpha.update({3: alpha, 4: alpha})
            self.v0, self.a0 = {2: 0, 3: vB, 4: 0}, {2: 0, 3: aB, 4: 0}
        else:
            r4 = self.C - self.D
            w4 = dot(vB, r3) / dot(1j * r4, r3)
            w3 = -dot(vB, r4) / dot(1j * r3, r4)
            known = aB - w3 ** 2 * r3 + w4 ** 2 * r4  # + i alpha3 r3 - i alpha4 r4 = 0
            self.omega.update({3: w3, 4: w4})
            self.alpha.update({3: -dot(known, r4) / dot(1j * r3, r4), 4: dot(known, r3) / dot(1j * r4, r3)})
            self.v0, self.a0 = {2: 0, 3: vB, 4: 0}, {2: 0, 3: aB, 4: 0}

    def velocity(self, link, at):
        return 0 if link == 1 else self.v0[link] + 1j * self.omega[link] * at * self.axis[link]

    def acceleration(self, link, at):
        return 0 if link == 1 else self.a0[link] + (1j * self.alpha[link] - self.omega[link] ** 2) * at * self.axis[link]


class Checks:
    """Counts what was checked, and prints what is wrong: at most `most` lines."""

    def __init__(self, most=40):
        self.passed, self.failed, self.most = 0, 0, most
        self.where = ''

    def that(self, is_so, *words):
        if is_so:
            self.passed += 1
            return True
        self.failed += 1
        if self.failed <= self.most:
            print('FAILED: %s: %s' % (self.where, ' '.join(str(word) for word in words))[:400])
        if self.most and os.environ.get('STOP_AT_FAILURE'):  # one that prints none is to find a fault
            sys.exit(1)
        return False

    def near(self, what, found, expected, size, tolerance=2e-6):
        """Numbers or complex numbers, within a tolerance of the size of the drawing."""
        if found is None or expected is None:
            return self.that(False, what, 'found', found, 'expected', expected)
        return self.that(abs(found - expected) <= tolerance * size, what, 'found', found, 'expected', expected)

    def finish(self):
        print('%d passed, %d failed' % (self.passed, self.failed))
        return self.failed > 0 or self.passed == 0


# Of each kind: without and with masses, turned, loads that jump, friction, a motor, given accelerations, one instant
CHOSEN = ('alvi-5.1', 'me3491-matrix', 'me3491-exercise-4', 'sarkar-1.11', 'coupler-point', 'n-four-bar', 'rubbing-four-bar',
          'dfa-example-2-vertical', 'eccentric-60', 'khurmi-16.11', 'gerstmayr-run-up', 'steam-engine-240', 'gas-engine',
          'rubbing-piston', 'oscillating-cylinder', 'rubbing-lever', 'slotted-lever', 'scotch-yoke-pump', 'scotch-yoke-actuator',
          'rubbing-yoke')


def decks_of(program, folders):
    """The chosen decks of these folders; with ALL in the environment all that have no mistakes."""
    found = []
    for folder in folders:
        for name in sorted(os.listdir(folder)):
            base, end = os.path.splitext(name)
            if end == '.deck' and (base in CHOSEN or os.environ.get('ALL') and base not in ('bad', 'mistakes')):
                found.append(Deck(program, os.path.join(folder, name)))
    return [deck for deck in found if 'motion.law' not in deck.inputs]  # a program over time has no interval of angles
