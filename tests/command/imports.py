# SPDX-License-Identifier: GPL-3.0-or-later
#
# imports.py FOURLINK N [SEED] - N links of PMKS+ in both of its forms, of random four-bars and slider-cranks with points, masses and forces,
# and with two more links that end in a fixed pin, in a slide or on another link: the deck moves as the drawing does, stepped along in small steps by intersections of circles and lines, and has the
# torque of virtual work.  Each is also spoilt at random places, or cut off: the command refuses it, or prints a deck that is read.
import cmath
import csv
import io
import math
import os
import random
import re
import subprocess
import sys
import tempfile

fourlink, count, seed = sys.argv[1], int(sys.argv[2]), int(sys.argv[3]) if len(sys.argv) > 3 else 1
UNITS = {'cm': 1e-2, 'm': 1, 'in': 0.0254, 'mm': 1e-3}
STEPS, TURN = 40, 0.02  # rad


def run(*words, text=None):
    return subprocess.run([fourlink, *words], capture_output=True, encoding='utf-8', errors='replace', input=text)


def place(r):
    return complex(round(r.uniform(-9, 9), 3), round(r.uniform(-9, 9), 3))


def cross(u, v):
    return (u.conjugate() * v).imag


def along_read(along):
    """A direction as three decimals of a radian say it."""
    written = round(along, 3)
    step = 15 * round(math.degrees(written) / 15)
    return math.radians(step) if abs(math.degrees(written) - step) <= 0.03 else written


class Linkage:
    """A drawing, and its places when the crank has turned."""

    def __init__(self, r):
        self.slides = r.random() < 0.4
        self.A, self.B, self.C, self.D = (place(r) for _ in range(4))
        self.along = r.choice([math.radians(15 * r.randrange(-12, 13)), r.uniform(-3, 3)])
        self.E = [(r.choice([2, 3] if self.slides else [2, 3, 4]), place(r)) for _ in range(r.randrange(3))]
        self.u = cmath.rect(1, along_read(self.along))
        self.further = r.choice(['pivot', 'slide', 'to']) if self.E and r.random() < 0.6 else ''
        if self.further != 'to' and self.E and self.E[-1][0] == 2:
            self.further = ''  # it would be another loop of four links
        self.Q, self.G, self.on = place(r), place(r), [place(r), place(r)]
        self.along_Q = r.choice([math.radians(15 * r.randrange(-12, 13)), r.uniform(-3, 3)])
        self.w = cmath.rect(1, along_read(self.along_Q))
        self.to = r.choice([k for k in (2, 3, 4) if k != self.E[-1][0] and not (k == 4 and self.slides)]) if self.E else 0
    def is_clear(self):
        sides = [abs(self.B - self.A), abs(self.C - self.B)] + ([] if self.slides else [abs(self.C - self.D), abs(self.D - self.A)])
        return min(sides) > 1 and abs(self.side(self.B, self.C)) > 0.3 and self.is_further_clear()

    def is_further_clear(self):
        if not self.further:
            return True
        rod = self.Q - self.E[-1][1]
        if self.further == 'slide':
            return abs(rod) > 1 and abs((rod.conjugate() * self.w).real) > 0.3 * abs(rod)
        other = self.Q - self.G
        return min(abs(rod), abs(other)) > 1 and abs(cross(rod, other)) > 0.3 * abs(rod) * abs(other)

    def next_Q(self, P, G, before):
        """The pin between the two further links, as next_C."""
        rod = abs(self.Q - self.E[-1][1])
        if self.further == 'slide':
            foot = self.Q + self.w * (self.w.conjugate() * (P - self.Q)).real
            square = rod**2 - abs(foot - P) ** 2
            both = [foot + s * self.w * math.sqrt(max(square, 0)) for s in (1, -1)]
        else:
            other, apart = abs(self.Q - self.G), G - P
            x = (abs(apart) ** 2 + rod**2 - other**2) / (2 * abs(apart))
            square = rod**2 - x**2
            both = [P + apart / abs(apart) * complex(x, s * math.sqrt(max(square, 0))) for s in (1, -1)]
        if square < 0.01:
            return None
        return min(both, key=lambda Q: abs(Q - before))

    def further_points(self, B, C, before):
        """Q, and the points on the rod and on the other link; None: they do not go on."""
        P = self.moved(*self.E[-1], B, C)
        G = self.moved(self.to, self.G, B, C) if self.further == 'to' else self.G
        Q = self.next_Q(P, G, before)
        if Q is None:
            return None
        on_rod = self.moved(5, self.on[0], B, C, Q)
        turn = 1 if self.further == 'slide' else (Q - G) / (self.Q - self.G)
        return [Q, on_rod, Q + (self.on[1] - self.Q) * turn]

    def side(self, B, C):
        """Sine of the angle in which two assemblies meet."""
        rod = (C - B) / abs(C - B)
        return (rod.conjugate() * self.u).real if self.slides else cross(rod, (C - self.D) / abs(C - self.D))

    def next_C(self, B, before):
        """C on its circle about B and its line or circle, the intersection nearer to the one before; None: there is none."""
        rod = abs(self.C - self.B)
        if self.slides:
            foot = self.C + self.u * (self.u.conjugate() * (B - self.C)).real
            square = rod**2 - abs(foot - B) ** 2
            both = [foot + s * self.u * math.sqrt(max(square, 0)) for s in (1, -1)]
        else:
            other, apart = abs(self.C - self.D), self.D - B
            x = (abs(apart) ** 2 + rod**2 - other**2) / (2 * abs(apart))
            square = rod**2 - x**2
            both = [B + apart / abs(apart) * complex(x, s * math.sqrt(max(square, 0))) for s in (1, -1)]
        if square < 0.01:
            return None
        return min(both, key=lambda C: abs(C - before))

    def moved(self, link, point, B, C, Q=None):
        """Where a point of a link is, at places of B, C and, for the rod of an output, Q."""
        if link == 5:
            P = self.moved(*self.E[-1], B, C)
            return P + (point - self.E[-1][1]) * (Q - P) / (self.Q - self.E[-1][1])
        from_to = {2: (self.A, self.B, self.A, B), 3: (self.B, self.C, B, C), 4: (self.D, self.C, self.D, C)}[link]
        return from_to[2] + (point - from_to[0]) * (from_to[3] - from_to[2]) / (from_to[1] - from_to[0])


def spelt(x):
    return '%r' % x if x != int(x) else '%d' % x


def link_text(r, m, form, unit, masses, force, settings):
    """The link, and the names of A, B, C, D."""
    names = r.sample('ABCDEFGHIJKLM', 12) if r.random() < 0.5 else list('ABCDEFGHIJKL')
    bodies = {2: [], 3: [], 4: []}
    ids = {2: names[0] + names[1], 3: names[1] + names[2] + 'x', 4: names[2] + names[3] + 'y'}
    joints = [[names[0], m.A, [2], 0, 1, 1], [names[1], m.B, [2, 3], 0, 0, 0]]
    if m.slides and form == 1:
        joints.append([names[2], m.C, [3], 1, 1, 0])
    else:
        joints.append([names[2], m.C, [3, 4], 0, 0, 0])
        joints.append([names[3], m.C if m.slides else m.D, [4], m.slides, 1, 0])
    joints += [[names[4 + i], point, [link], 0, 0, 0] for i, (link, point) in enumerate(m.E)]
    if m.further:  # two more links; the rod of a slide may be alone
        ids[5], ids[6] = names[6] + 'z', r.choice([names[7] + 'z', 'A', 'rod', names[8]])
        bodies[5] = []
        own = m.further == 'slide' and form == 1
        joints[-1][2].append(5)
        joints.append([names[6], m.Q, [5] if own else [5, 6], own, own, 0])
        joints.append([names[8], m.on[0], [5], 0, 0, 0])
        if not own:
            bodies[6] = []
            joints.append([names[7], m.Q if m.further == 'slide' else m.G, [m.to, 6] if m.further == 'to' else [6], m.further == 'slide', m.further != 'to', 0])
            joints.append([names[9], m.on[1], [6], 0, 0, 0])
    order = list(range(len(joints)))
    r.shuffle(order)
    j = ''
    for i in order:
        name, at, links, slides, fixed, is_input = joints[i]
        angle = spelt(round(m.along_Q if 5 in links or 6 in links else m.along, 3)) if slides else '0' if form == 1 else 'Null'
        fields = [name, spelt(at.real), spelt(at.imag), '|'.join(ids[k] for k in links), 'P' if slides else 'R', 't' if fixed else 'f', angle]
        j += ','.join(fields + (['0.1', 't' if is_input else 'f', ''] if form == 1 else ['t' if is_input else 'f'])) + '\n'
        for k in links:
            bodies[k].append(name)
    l = ''
    for k in bodies:
        if not bodies[k]:
            continue
        mass = masses.get(k, (1, 1, 0, 0))
        is_slide = k == 4 and m.slides or k == 6 and m.further == 'slide'
        fields = [ids[k]] + (['P' if is_slide else 'R'] if form == 2 else [])
        fields += ['Null'] * 4 if form == 2 and is_slide else [spelt(x) for x in mass]
        l += ','.join(fields + ['|'.join(bodies[k]), 'F1' if force and force[0] == k else '', 'line', '1', '2', '3', '4', '5', '6', '7', '8']) + '\n'
    f = ''
    if force:
        link, at, tip, size, fixed, outward = force
        f = ','.join(['F1', ids[link], spelt(at.real), spelt(at.imag), spelt(tip.real), spelt(tip.imag), 't' if fixed else 'f',
                      'true' if outward else 'false'] + ([spelt(size.real), spelt(size.imag)] if form == 1 else [spelt(abs(size))])) + '\n'
    speed, clockwise, gravity = settings
    text = 'j=%s&l=%s&f=%s%s&s=%s,%s,%s,%s' % (j, l, f, '&pp=&tp=' if form == 1 else '', spelt(speed), 'true' if clockwise else 'false',
                                            'true' if gravity else 'false', unit)
    if r.random() < 0.7:
        text = text.replace('\n', '%0A').replace('|', '%7C')
    return r.choice(['', 'https://app.example.org/?']) + text + r.choice(['', '\n']), names


def columns(deck, folder, *options):
    name = os.path.join(folder, 'x.deck')
    with open(name, 'w') as file:
        file.write(deck)
    done = run('-f', 'csv', *options, name)
    rows = list(csv.reader(io.StringIO(done.stdout)))
    if len(rows) < 2:
        return done.stderr
    return [dict(zip((head.split(' (')[0] for head in rows[0]), row)) for row in rows[1:]]


def compare(r, m, form, deck, names, unit, force, masses, settings, folder):
    """The worst difference, relative; or what is wrong."""
    scale = UNITS[unit]
    shown = columns(deck, folder, '-c', 'pins.drawn')
    if isinstance(shown, str):
        return shown
    branch = shown[0]['branch']
    drawn = math.radians(float(shown[0]['pins.drawn']))
    points = [('joint_' if names[4 + i] in 'ABCD' else '') + names[4 + i] for i in range(len(m.E))]
    further = m.further_points(m.B, m.C, m.Q) if m.further else []
    steps, C, B = [(0, m.B, m.C, further)], m.C, m.B
    for i in range(1, STEPS):
        B = m.A + (m.B - m.A) * cmath.rect(1, TURN * i)
        C = m.next_C(B, C)
        if C is not None and m.further:
            further = m.further_points(B, C, further[0])
        if C is None or further is None:
            break
        steps.append((i, B, C, further))
    if m.further:
        own = m.further == 'slide' and form == 1
        further_names = [names[6], names[8]] + ([] if own else [names[9]])
        points += [('joint_' if name in 'ABCD' else '') + name for name in further_names]
    wanted = ['B.x', 'B.y', 'C.x', 'C.y'] + [p + '.' + c for p in points for c in 'xy'] + ['omega2']
    wanted += ['Ts'] if force and unit in ('cm', 'm') and not masses else []
    rows = columns(deck, folder, '-b', branch, '-c', ','.join(wanted), '--units=m, N, N m',
                   '--at=' + ', '.join('%.17g rad' % (drawn + TURN * i) for i, _, _, _ in steps))
    if isinstance(rows, str) or len(rows) != len(steps):
        return str(rows)
    worst = 0
    for (i, B, C, further), row in zip(steps, rows):
        found = [float(row[name]) for name in wanted]
        expected = [B.real, B.imag, C.real, C.imag]
        for link, point in m.E:
            P = m.moved(link, point, B, C)
            expected += [P.real, P.imag]
        for P in further[:len(points) - len(m.E)]:
            expected += [P.real, P.imag]
        expected = [x * scale for x in expected] + [settings[0] * math.pi / 30 * (-1 if settings[1] else 1)]
        differences = [abs(x - y) / (20 * scale) for x, y in zip(found[:-1], expected)] + [abs(found[len(expected) - 1] - expected[-1])]
        worst = max(worst, *differences[:len(expected)])
        if 'Ts' in wanted and 0 < i < len(steps) - 1:
            link, at, tip, size, fixed, outward = force
            direction = (tip - at) / abs(tip - at) * (1 if outward else -1)
            h = 1e-5
            ends = []
            for way_h in (1, -1):
                near_B = m.A + (B - m.A) * cmath.rect(1, way_h * h)
                near_C = m.next_C(near_B, C)
                near_Q = m.further_points(near_B, near_C, further[0])[0] if m.further else None
                ends.append(m.moved(link, at, near_B, near_C, near_Q))
            Q = further[0] if m.further else None
            if not fixed:  # it turns with the link
                direction *= m.moved(link, at + 1, B, C, Q) - m.moved(link, at, B, C, Q)
            per_angle = (ends[0] - ends[1]) / (2 * h) * scale
            torque = -abs(size) * (direction.conjugate() * per_angle).real
            worst = max(worst, 1e-4 * abs(float(row['Ts']) - torque) / (abs(size) * max(abs(per_angle), 20 * scale)))
    if masses and unit in ('cm', 'm'):
        names_of = {2: 'crank', 3: 'rod' if m.slides else 'coupler', 4: 'rocker'}
        own = {k: v for k, v in masses.items() if k < 4 or k == 4 and not m.slides}
        row = columns(deck, folder, '-c', ','.join('%s.mass,%s.inertia,%s.cg_place.x' % ((names_of[k],) * 3) for k in own), '--units=kg, kg m2, m')
        if isinstance(row, str):
            return row
        size = 1e-3 if unit == 'cm' else 1
        for k, (mass, inertia, x, _) in own.items():
            for key, value in (('mass', mass * size), ('inertia', inertia * scale**2), ('cg_place.x', x * scale)):
                worst = max(worst, abs(float(row[0][names_of[k] + '.' + key]) - value) / max(abs(value), 1e-9))
        if m.further:  # its link from E to Q, which is the rod or the rocker, in the axes of this
            name = re.search(r'\[output (\w+)\]', deck).group(1)
            is_rocker = m.further == 'to' and name.endswith(names[6] + 'z')
            keys = ['output %s.%s%s' % (name, '' if is_rocker else 'rod_', key) for key in ('mass', 'cg.x', 'cg.y')]
            row = columns(deck, folder, '-c', ','.join(keys), '--units=kg, m')
            if isinstance(row, str):
                return row
            P = m.E[-1][1]
            centre = (complex(*masses[5][2:]) - P) * abs(m.Q - P) / (m.Q - P) * scale
            found = [float(row[0][key]) for key in keys]
            worst = max(worst, abs(found[0] - masses[5][0] * size), abs(complex(*found[1:]) - centre) / (20 * scale))
    return worst


def spoil(r, text):
    if r.random() < 0.3:
        return text[:r.randrange(len(text) - 2)], True
    letters = list(text)
    for _ in range(r.choice([1, 1, 2, 5])):
        k = r.randrange(len(letters))
        r.choice([lambda: letters.__setitem__(k, r.choice(',|%&=.-0123456789eABCDtfPR\n\0é"')), lambda: letters.pop(k) if len(letters) > 9 else None,
                  lambda: letters.insert(k, r.choice(letters)), lambda: letters.insert(k, ''.join(r.choices(letters, k=30)))])()
    return ''.join(letters), False


def main():
    r = random.Random(seed)
    failed, worst, read, refused = 0, 0, 0, 0
    with tempfile.TemporaryDirectory() as folder:
        for i in range(count):
            m = Linkage(r)
            while not m.is_clear():
                m = Linkage(r)
            form, unit = r.choice([1, 2]), r.choice(list(UNITS))
            masses = {k: (round(r.uniform(0, 9), 3), round(r.uniform(0, 9), 3), place(r).real, place(r).imag) for k in (2, 3, 4, 5)}
            masses = masses if r.random() < 0.3 else {}
            force = (r.choice([2, 3, 5] if m.further else [2, 3]), place(r), place(r), complex(r.randrange(1, 99), r.randrange(99)), r.random() < 0.6, r.random() < 0.6)
            force = force if r.random() < 0.5 else None
            settings = (r.choice([10, 33.5, 100]), r.random() < 0.3, r.random() < 0.3)
            text, names = link_text(r, m, form, unit, masses, force, settings)
            done = run('--import=-', text=text)
            found = compare(r, m, form, done.stdout, names, unit, force, masses, settings, folder) if done.returncode == 0 else done.stderr
            if isinstance(found, str) or not found < 1e-11:
                failed += 1
                print('FAILED: %s\n%s\n%s\n%s' % (found, text, done.stdout, done.stderr) if failed < 4 else 'FAILED')
            else:
                worst = max(worst, found)
            for _ in range(4):
                bad, is_cut = spoil(r, text)
                done = run('--import=-', text=bad)
                ok = done.returncode == 2 and not done.stdout and ': error: ' in done.stderr
                if done.returncode == 0:
                    read += 1
                    ok = not is_cut and run('-S', '-', text=done.stdout).returncode in (0, 1)
                    ok |= is_cut and text.rstrip().endswith('mm')  # without its last letter a metre
                refused += done.returncode == 2
                if not ok:
                    failed += 1
                    print('FAILED: status %d\n%r\n%s\n%s' % (done.returncode, bad, done.stdout, done.stderr))
    print('%d links, worst difference %.1g; %d spoilt ones read, %d refused; %d wrong' % (count, worst, read, refused, failed))
    return failed > 0


sys.exit(main())
