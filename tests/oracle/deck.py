# SPDX-License-Identifier: GPL-3.0-or-later
#
# deck.py - reads decks by itself: sections, keys, numbers with units, points, vectors, curves (fourlink-deck(5)).  All
# values are in SI units and radians.  Points and vectors are complex numbers, x + i y.
import cmath
import math
import os
import re

TURN = 2 * math.pi

# value, and powers of m, kg, s and rad
UNITS = {'': (1, 0, 0, 0, 0), '1': (1, 0, 0, 0, 0), '%': (0.01, 0, 0, 0, 0),
         'm': (1, 1, 0, 0, 0), 'mm': (1e-3, 1, 0, 0, 0), 'cm': (1e-2, 1, 0, 0, 0), 'km': (1e3, 1, 0, 0, 0),
         'L': (1e-3, 3, 0, 0, 0), 'cc': (1e-6, 3, 0, 0, 0),
         'in': (0.0254, 1, 0, 0, 0), 'ft': (0.3048, 1, 0, 0, 0),
         'kg': (1, 0, 1, 0, 0), 'g': (1e-3, 0, 1, 0, 0), 't': (1e3, 0, 1, 0, 0), 'lb': (0.45359237, 0, 1, 0, 0),
         's': (1, 0, 0, 1, 0), 'ms': (1e-3, 0, 0, 1, 0), 'min': (60, 0, 0, 1, 0), 'h': (3600, 0, 0, 1, 0),
         'rad': (1, 0, 0, 0, 1), 'mrad': (1e-3, 0, 0, 0, 1), 'deg': (TURN / 360, 0, 0, 0, 1), 'rev': (TURN, 0, 0, 0, 1),
         'rpm': (TURN / 60, 0, 0, -1, 1), 'Hz': (1, 0, 0, -1, 0),
         'N': (1, 1, 1, -2, 0), 'kN': (1e3, 1, 1, -2, 0), 'MN': (1e6, 1, 1, -2, 0), 'kgf': (9.80665, 1, 1, -2, 0),
         'J': (1, 2, 1, -2, 0), 'kJ': (1e3, 2, 1, -2, 0), 'W': (1, 2, 1, -3, 0), 'kW': (1e3, 2, 1, -3, 0),
         'Pa': (1, -1, 1, -2, 0), 'kPa': (1e3, -1, 1, -2, 0), 'MPa': (1e6, -1, 1, -2, 0), 'GPa': (1e9, -1, 1, -2, 0),
         'bar': (1e5, -1, 1, -2, 0), 'atm': (101325, -1, 1, -2, 0)}
POUND = 0.45359237 * 9.80665
UNITS.update({'oz': (0.45359237 / 16, 0, 1, 0, 0), 'lbf': (POUND, 1, 1, -2, 0), 'kip': (1e3 * POUND, 1, 1, -2, 0),
              'ounces': (0.45359237 / 16, 0, 1, 0, 0), 'ozf': (POUND / 16, 1, 1, -2, 0), 'slug': (POUND / 0.3048, 0, 1, 0, 0), 'blob': (POUND / 0.0254, 0, 1, 0, 0),
              'psi': (POUND / 0.0254**2, -1, 1, -2, 0), 'hp': (550 * 0.3048 * POUND, 2, 1, -3, 0)})

# the units of bare numbers, by the keys of [units]
BARE = {'number': '', 'length': 'm', 'angle': 'deg', 'mass': 'kg', 'time': 's', 'speed': 'm/s', 'acceleration': 'm/s2',
        'angular_speed': 'rad/s', 'angular_acceleration': 'rad/s2', 'inertia': 'kg m2', 'force': 'N', 'torque': 'N m',
        'volume': 'm3', 'pressure': 'Pa', 'power': 'W', 'energy': 'J', 'stiffness': 'N/m', 'damping': 'N s/m'}

PLAIN = str.maketrans({'\u2212': '-', '\u2009': ' ', '\u202f': ' ', '\u00a0': ' ', '\u00b7': ' ', '\u22c5': ' ',
                       '\u00d7': ' ', '\u00b0': ' deg', '\u00b2': '2', '\u00b3': '3'})
NUMBER = r'[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?'


def unit_of(text):
    """The value of a unit such as N m/rad in SI, and its powers."""
    value, powers = 1, [0] * 4
    for sign, name, power in re.findall(r'([/ .]|^)\s*([A-Za-z%1]+)\^?(\d*)', text.strip()):
        factor, *own = UNITS[name]
        n = int(power or 1) * (-1 if sign == '/' else 1)
        value *= factor ** n
        powers = [p + n * q for p, q in zip(powers, own)]
    return value, powers


NAMES = {unit_of(name)[1][:4].__repr__(): name for name in ('1', 'm', 'm/s', 'm/s2', 'm2', 'm3', 'Pa', 'kg', 'kg.m2', 'kg.m', 's', 'rad', 'rad/s', 'rad/s2', 'N', 'N.m', 'W')}


def si_name(unit):
    """The SI unit of the quantity that a unit has; N.m for energies too."""
    return NAMES.get(repr(unit_of(unit or '')[1]), unit)


def split(text, mark=','):
    """The parts of a text between marks that are not in parentheses."""
    parts = re.split(r'%s(?![^(]*\))' % re.escape(mark), text)
    return [part.strip() for part in parts if part.strip()]


class Deck:
    """The sections of a deck: (kind, name, {key: text}), in order."""

    def __init__(self, path, changes=()):
        with open(path, 'rb') as file:
            raw = file.read()
        text = raw.decode('utf-16' if raw[:2] in (b'\xff\xfe', b'\xfe\xff') else 'utf-8-sig')
        self.folder = os.path.dirname(path)
        self.sections = [('', '', {})]
        key = None
        for line in text.translate(PLAIN).splitlines():
            line = re.sub(r'(^|\s)[#;](?=([^"]*"[^"]*")*[^"]*$).*', '', line).strip()
            section = re.fullmatch(r'\[\s*(\w+)\s*(.*?)\s*\]', line)
            if section:
                self.sections.append((section[1].lower(), section[2], {}))
                key = None
            elif key and self.sections[-1][2][key].endswith(','):
                self.sections[-1][2][key] += ' ' + line
            elif '=' in line:
                key, value = line.split('=', 1)
                key = key.strip().lower() if not re.fullmatch(r'\s*(radius_)?[A-D]\s*', key) else key.strip()
                self.sections[-1][2][key] = value.strip()
        for kind, key, value in changes:
            self.section(kind, make=True)[key] = value
        own = self.section('units')
        self.bare = {q: own.get(q, unit) for q, unit in BARE.items()}
        for q, per in (('speed', '/s'), ('acceleration', '/s2')):
            if 'length' in own and q not in own:
                self.bare[q] = own['length'] + per

    def section(self, kind, make=False):
        for section in self.sections:
            if section[0] == kind:
                return section[2]
        if make:
            self.sections.append((kind, '', {}))
            return self.sections[-1][2]
        return {}

    def has(self, kind):
        return any(section[0] == kind for section in self.sections)

    def named(self, kind):
        return [(name, keys) for own, name, keys in self.sections if own == kind]

    def word(self, kind, key, default=None):
        return self.section(kind).get(key, default)

    def quantity(self, text, quantity):
        """A number, with a unit or a bare one."""
        number, unit = re.fullmatch(r'(%s)\s*(.*)' % NUMBER, text.strip()).groups()
        return float(number) * unit_of(unit or self.bare[quantity])[0]

    def number(self, kind, key, quantity, default=0.0):
        keys = self.section(kind) if isinstance(kind, str) else kind
        return self.quantity(keys[key], quantity) if key in keys else default

    def vector(self, text, quantity):
        """(43, 25) N, 50 N at 30 deg, or a number along x."""
        pair = re.fullmatch(r'\((.*),(.*)\)\s*(.*)', text.strip())
        if pair:
            return complex(*(self.quantity(x + ' ' + pair[3], quantity) for x in pair.groups()[:2]))
        size, _, angle = text.partition(' at ')
        return self.quantity(size, quantity) * (cmath.rect(1, self.quantity(angle, 'angle')) if angle else 1)

    def point(self, text, length=0.0, cg=0j):
        """A point in the axes of its link, whose line has a length."""
        place = 0j
        for step in split(text or 'origin', '+'):
            words = {'origin': 0, 'mid': length / 2, 'end': length, 'G': cg}
            part = re.fullmatch(r'(%s)\s*%%' % NUMBER, step)
            place += words[step] if step in words else float(part[1]) / 100 * length if part else self.vector(step, 'length')
        return place

    def curve(self, text, argument, quantity):
        """The points of a curve, or None: 0 deg 1 bar, 20 deg 32 bar, ...  or file NAME."""
        if text.split(None, 1)[0] == 'file':
            return self.card(text.split()[1:], argument, quantity)
        points = []
        for item in split(text):
            match = re.fullmatch(r'(%s)(?![\d.eE])\s*([^\d(+-]*?)\s*((?:%s|\().*)' % (NUMBER, NUMBER), item)
            if not match or re.search(r'\bat$', match[2]):  # 50 N at 30 deg is a force
                return None
            points.append((self.quantity(match[1] + ' ' + match[2], argument), self.vector(match[3], quantity)))
        return points

    def card(self, words, argument, quantity):
        units = words[1:3] or [self.bare[argument], self.bare[quantity]]
        points = []
        with open(os.path.join(self.folder, words[0]), encoding='utf-8-sig') as file:
            for line in file:
                line = line.partition('#')[0]
                line = line.replace(',', '.') if ';' in line else line
                cells = re.findall(NUMBER, line) if not re.search(r'[A-Za-z]', re.sub(NUMBER, '', line)) else []
                if len(cells) == 2:
                    points.append(tuple(float(x) * unit_of(unit)[0] for x, unit in zip(cells, units)))
                elif re.search('[A-Za-z]', line):
                    given = re.findall(r'\[(.*?)\]', line) or [x for x in re.split(r'[\s,;]+', line.strip()) if x in UNITS]
                    units = given if len(given) == 2 else units
        return points


def steffen(points, period=0):
    """A curve as a function of arrays: Steffen's interpolation, periodic, or constant beyond its ends.

    M. Steffen, A simple method for monotonic interpolation in one dimension, Astron. Astrophys. 239 (1990).  Slopes:
    (sign s0 + sign s1) min(|s0|, |s1|, |p| / 2), p = (s0 h1 + s1 h0) / (h0 + h1) the parabola's; at ends the secant's.
    """
    import numpy as np
    x = np.array([p[0] for p in points], np.longdouble)
    y = np.array([p[1] for p in points], np.longdouble)
    if period:
        order = np.argsort(x)
        x, y = x[order], y[order]
        x = np.concatenate(([x[-1] - period], x, [x[0] + period, x[min(1, len(x) - 1)] + period]))
        y = np.concatenate(([y[-1]], y, [y[0], y[min(1, len(y) - 1)]]))
    h = np.diff(x)
    s = np.diff(y) / h
    p = (s[:-1] * h[1:] + s[1:] * h[:-1]) / (h[:-1] + h[1:])
    slope = np.zeros_like(y)
    slope[1:-1] = (np.sign(s[:-1]) + np.sign(s[1:])) * np.minimum(np.minimum(abs(s[:-1]), abs(s[1:])), abs(p) / 2)
    if not period:
        slope[0], slope[-1] = s[0], s[-1]

    def value(at):
        at = np.asarray(at, np.longdouble)
        at = x[1] + (at - x[1]) % period if period else np.clip(at, x[0], x[-1])
        i = np.clip(np.searchsorted(x, at, 'right') - 1, 0, len(h) - 1)
        d = at - x[i]
        a = (slope[i] + slope[i + 1] - 2 * s[i]) / h[i] ** 2
        b = (3 * s[i] - 2 * slope[i] - slope[i + 1]) / h[i]
        return ((a * d + b) * d + slope[i]) * d + y[i]

    value.knots = [k for k, _ in points]
    return value
