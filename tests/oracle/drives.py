# SPDX-License-Identifier: GPL-3.0-or-later
#
# drives.py FOURLINK N [FIRST [outputs|dead]] - N random machines of the four kinds, moved by an input and driven anywhere,
# against absolute coordinates with multipliers whose driver is at its real place (chains.py): the crank's motion, the effort, pin
# forces.  With `outputs` each has a pair of links on one of the four, and is moved by that or by an actuator between any links;
# with `dead` each is near a dead position of the crank.
#
# The crank angle, its speed and its acceleration are chosen; the value of the input and its rates, which the deck gets, are
# those of the chain in long doubles.  Wild ones have lengths of several orders, or are close to where the input or the
# crank is dead; with `dead` the sine of all positions is below 0.1.  A row may differ by its scale times what is known of it:
# (size / K)^2, and 1 / sine of the position.
import csv
import io
import random
import subprocess
import sys

import numpy as np

sys.argv, arguments = sys.argv[:1], sys.argv[1:]
from chains import REAL, Along, Angle, Distance, four_bar, inverted, slider_crank, with_rocker, with_slider, yoke  # noqa: E402

EPS = 2.2e-16
fourlink, n, first = arguments[0], int(arguments[1]), int(arguments[2]) if len(arguments) > 2 else 0
with_outputs, only_dead = arguments[3:] == ['outputs'], arguments[3:] == ['dead']
DOUBT = 1000
count, worst, failed, near_dead, refused = {}, {}, 0, 0, 0


def link(name, body, length=None, more=''):
    mass, inertia, centre = body
    centre = complex(centre)
    return '[%s]\n%s%smass = %.17g kg\ninertia = %.17g kg m2\ncg = (%.17g, %.17g) m\n' % (
        name, 'length = %.17g m\n' % length if length else '', more, mass, inertia, centre.real, centre.imag)


def machine(r):
    """The rig, its deck, its inputs and drives, its branch, its crank, the largest arm, and the cosines of its dead positions."""
    size = 10 ** r.uniform(-3, 3) if r.random() < 0.2 else 0.1
    wild = r.random() < 0.2
    some = (lambda: size * 10 ** r.uniform(-1.5, 1.5)) if wild else (lambda: size * r.uniform(1, 5))
    kind, side = r.randrange(4), r.choice((1, -1))
    bodies = [(r.uniform(0.1, 5), size ** 2 * r.uniform(0.01, 2), size * complex(r.uniform(-1, 1), r.uniform(-1, 1))) for _ in range(3)]
    force, at = complex(r.uniform(-300, 300), r.uniform(-300, 300)), size * complex(r.uniform(-2, 2), r.uniform(-2, 2))
    a = some()
    ram = size * complex(r.uniform(-2, 2), r.uniform(-2, 2)), size * complex(r.uniform(-4, 4), r.uniform(-4, 4))
    if kind == 0:
        b, c, d = some(), some(), some()
        rig = four_bar(a, b, c, d, bodies, [(2, at, force)])
        place = rig.place

        def placed(theta):
            origins, angles = place(theta)
            if side < 0:
                B = origins[1]
                C = B + b * np.exp(1j * angles[1])
                w = (d - B) / abs(d - B)
                C = B + w * np.conj((C - B) / w)
                angles = [angles[0], np.angle(C - B), np.angle(C - d)]
            return origins, angles
        rig.place = placed
        text = 'mechanism = four-bar\n[ground]\nlength = %.17g m\n' % d + link('crank', bodies[0], a) + link('coupler', bodies[1], b) + link('rocker', bodies[2], c)
        text += '[load work]\nlink = coupler\n'
        drives = {'rocker': Angle(3, 0), 'ram': Distance(3, ram[0], 0, ram[1])}
        inputs = {'theta4': Angle(3, 0), 'ram.length': Distance(3, ram[0], 0, ram[1])}
        follower, dead = 'rocker', [(a * a + d * d - f * f) / (2 * a * d) for f in (b + c, b - c)]
    elif kind == 1:
        l, e = some() + a * (not wild), r.choice((0, r.uniform(-0.5, 0.5) * size))
        bodies[2] = bodies[2][:2] + (0,)
        rig = slider_crank(a, l, e, bodies, [(2, at, force)], side)
        text = 'mechanism = slider-crank\n[ground]\noffset = %.17g m\n' % e + link('crank', bodies[0], a) + link('rod', bodies[1], l)
        text += '[piston]\nmass = %.17g kg\n[load work]\nlink = rod\n' % bodies[2][0]
        drives, inputs, follower = {'piston': Along(0, 1, 3, 0, 0, 0)}, {'C.x': Along(0, 1, 3, 0, 0, 0)}, None
        dead = [np.cos(np.arcsin(f / a)) * r.choice((1, -1)) for f in (e + l, e - l) if abs(f) < a]
    elif kind == 2:
        d, h = some(), r.choice((0, r.uniform(-0.3, 0.3) * size))
        rig = inverted(a, d, h, bodies, [(3, at, force)], side)
        text = 'mechanism = inverted-slider-crank\n[ground]\nlength = %.17g m\n' % d + link('crank', bodies[0], a) + link('slider', bodies[1])
        text += link('lever', bodies[2], None, 'offset = %.17g m\n' % h) + '[load work]\nlink = lever\n'
        drives = {'lever': Angle(3, 0), 'slide': Along(3, 1, 2, 0, 3, 0), 'ram': Distance(3, ram[0], 0, ram[1])}
        inputs = {'theta4': Angle(3, 0), 'slide': Along(3, 1, 2, 0, 3, 0), 'ram.length': Distance(3, ram[0], 0, ram[1])}
        follower, dead = 'lever', [(a * a + d * d - h * h) / (2 * a * d)]
    else:
        side, beta, e = 1, r.uniform(30, 150), r.choice((0, r.uniform(-0.5, 0.5) * size))
        rig = yoke(a, np.radians(REAL(beta)), e, bodies, [(3, at, force)])
        text = 'mechanism = scotch-yoke\n[ground]\noffset = %.17g m\n' % e + link('crank', bodies[0], a) + link('slider', bodies[1])
        text += link('yoke', bodies[2], None, 'angle = %.17g deg\n' % beta) + '[load work]\nlink = yoke\n'
        drives, inputs, follower = {'yoke': Along(0, 1, 3, 0, 0, 0)}, {'C.x': Along(0, 1, 3, 0, 0, 0)}, None
        dead = []
    text += 'force = (%.17g, %.17g) N\nat = (%.17g, %.17g) m\n' % (force.real, force.imag, at.real, at.imag)
    if follower:
        text += '[actuator ram]\nlink = %s\nat = (%.17g, %.17g) m\nto = ground\nto_at = (%.17g, %.17g) m\n' % (
            follower, ram[0].real, ram[0].imag, ram[1].real, ram[1].imag)
    drives['crank'] = Angle(1, 0)
    reach = max([size, a] + [abs(b[2]) for b in bodies])
    return kind, rig, text, drives, inputs, side, a, reach, [f for f in dead if abs(f) < 1]


LINKS = (('crank', 'coupler', 'rocker'), ('crank', 'rod', 'piston'), ('crank', 'slider', 'lever'), ('crank', 'slider', 'yoke'))


def with_output(r, kind, rig, a, reach):
    """The same with an output on one of its links and an actuator between any two; the lines of both, inputs and drives."""
    size = a * 10 ** r.uniform(-0.3, 0.5)

    def point(most):
        return size * complex(r.uniform(-most, most), r.uniform(-most, most))
    bodies = [(r.uniform(0.1, 3), size ** 2 * r.uniform(0.01, 1), point(1)) for _ in range(2)]
    some = [i for i in (1, 2, 3) if kind < 3 or i != 2]  # a yoke's slider has its axes along the slot
    k, p, rod, force = r.choice(some), point(2), size * r.uniform(1, 5), complex(r.uniform(-300, 300), r.uniform(-300, 300))
    side, names = r.choice((1, -1)), ('ground',) + LINKS[kind] + ('P.rod', 'P')
    text = '[output P]\nlink = %s\nat = (%.17g, %.17g) m\nrod = %.17g m\n' % (names[k], p.real, p.imag, rod)
    if r.random() < 0.5:
        line, angle = point(4), r.uniform(-180, 180)
        u = np.exp(1j * np.radians(REAL(angle)))
        rig = with_slider(rig, k, p, rod, line, u, side, bodies, force)
        text += 'line = (%.17g, %.17g) m\nangle = %.17g deg\nside = %s\n' % (line.real, line.imag, angle, 'ahead' if side > 0 else 'behind')
        inputs, at = {'P.x': Along(0, u, 5, 0, 0, line)}, 0
        drives = {'P': inputs['P.x']}
    else:
        j, length = r.choice([0, 0] + [i for i in some if i != k]), size * r.uniform(1, 5)
        pivot, at = point(2 if j else 4), length
        rig = with_rocker(rig, k, p, rod, j, pivot, length, side, bodies, force)
        text += 'length = %.17g m\nside = %s\n' % (length, 'left' if side > 0 else 'right')
        text += ('to = %s\nto_at' % names[j] if j else 'pivot') + ' = (%.17g, %.17g) m\n' % (pivot.real, pivot.imag)
        inputs, drives = {'P.theta': Angle(5, 0)}, {'P': Angle(5, j)}
    for front, (mass, inertia, centre) in (('rod_', bodies[0]), ('', bodies[1])):
        text += '%smass = %.17g kg\n%sinertia = %.17g kg m2\n%scg = (%.17g, %.17g) m\n' % (
            front, mass, front, inertia, front, centre.real, centre.imag)
    text += '[load cut]\nlink = P\nforce = (%.17g, %.17g) N\nat = (%.17g, 0) m\n' % (force.real, force.imag, at)
    ends, P, Q = r.sample([0, 4, 5] + some, 2), point(2), point(2)
    if 0 in ends:
        ends = sorted(ends, reverse=True)
    text += '[actuator strut]\nlink = %s\nat = (%.17g, %.17g) m\nto = %s\nto_at = (%.17g, %.17g) m\n' % (
        names[ends[0]], P.real, P.imag, names[ends[1]], Q.real, Q.imag)
    inputs['strut.length'] = drives['strut'] = Distance(ends[0], P, ends[1], Q)
    return rig, text, inputs, drives, max(reach, rod, 5 * size)


def rate(driver, s, v, omega):
    return sum(g[1] * v[g[0]].real + g[2] * v[g[0]].imag + g[3] * omega[g[0]] for g in driver.gradient(s) if g[0])


def sine_of(kind, origins, angles):
    """0 in a dead position of the crank."""
    if kind == 0:
        return abs(float(np.sin(angles[2] - angles[1])))
    if kind == 1:
        return abs(float(np.cos(angles[1])))
    if kind == 2:
        r = origins[1] - origins[2]
        return abs(float((r * np.exp(-1j * angles[2])).real / abs(r)))
    return 1


def value(driver, s):
    driver.value = 0
    return float(driver.error(s)[0])


def tell(number, kind, what, found, wanted, doubt, deck):
    global failed
    error = abs(found - wanted) / doubt
    count[what], worst[what] = count.get(what, 0) + 1, max(worst.get(what, 0), error if error == error else 1e9)
    if not error < 1:
        failed += 1
        print('%d, kind %d: %s is %r, not %r, %.2g of what is known' % (number, kind, what, found, wanted, error))
        if failed < 4:
            open('drives-%d.deck' % number, 'w').write(deck)


def try_one(number):
    global near_dead, refused
    r = random.Random(number)
    kind, rig, text, drives, inputs, side, a, reach, dead = machine(r)
    while only_dead and (not dead or kind != number % 3):
        kind, rig, text, drives, inputs, side, a, reach, dead = machine(r)
    if with_outputs:
        rig, more, inputs, others, reach = with_output(r, kind, rig, a, reach)
        text, drives = text + more, dict(drives, **others)
    theta2, omega2 = r.uniform(0, 360), r.choice((1, -1)) * 10 ** r.uniform(-1, 1.5)
    if not only_dead and r.random() < 0.2:
        theta2 = 90.0 * r.randrange(4) + r.choice((1, -1)) * 10 ** r.uniform(-4, 0.5)
    elif dead and (only_dead or r.random() < 0.6):
        theta2 = r.choice((1, -1)) * np.degrees(np.arccos(r.choice(dead))) + r.choice((1, -1)) * 10 ** r.uniform(-4, 1)
        if kind == 1:
            theta2 = r.choice((theta2, -theta2))
    alpha2 = r.choice((0, r.uniform(-100, 100)))
    with np.errstate(all='ignore'):
        s = rig.state(theta2, omega2, alpha2)
        unit = rig.state(theta2, 1, 0)
    if not np.isfinite(sum(abs(f) for f in s.alpha[2:])).all():
        return
    rates = max(1, float(abs(unit.omega[2][0])), float(abs(unit.omega[3][0])) if kind in (0, 2) else 1)
    if with_outputs:
        rates = max([rates] + [float(abs(f[0])) for f in unit.omega[4:]])
    grows = max(rates, 1 / sine_of(kind, *rig.place(np.radians(REAL(theta2)))))
    name, drive = r.choice(sorted(inputs)), r.choice(sorted(drives))
    q, p = inputs[name], drives[drive]
    x, K = value(q, s), float(rate(q, unit, unit.v, unit.omega)[0])
    v, acc = float(rate(q, s, s.v, s.omega)[0]), float((rate(q, s, s.a, s.alpha) + q.curvature(s))[0])
    size = 1 if isinstance(q, Angle) else a
    bends = grows
    if with_outputs:  # L, and what it is made of
        L = float((rate(q, unit, unit.a, unit.alpha) + q.curvature(unit))[0]) / size
        bends = max([grows, abs(L)] + [float(abs(f[0])) for f in unit.alpha[4:]])
    Kp = float(rate(p, unit, unit.v, unit.omega)[0]) / (1 if isinstance(p, Angle) else a)
    if not (abs(K) > 1e-4 * size and abs(Kp) > 1e-4 and grows < 1e4) or (only_dead and not grows > 10):
        return
    near_dead += grows > 10
    u = ('rad', 'rad/s', 'rad/s2') if isinstance(q, Angle) else ('m', 'm/s', 'm/s2')
    deck = text + '[motion]\ninput = %s\ndrive = %s\nside = %s\nat = %.17g %s\nspeed = %.17g %s\nacceleration = %.17g %s\nnear = %.17g deg\n' % (
        name, drive, 'rising' if K > 0 else 'falling', x, u[0], v, u[1], acc, u[2], theta2)
    deck += '[table]\nbranch = %s\n' % ('open' if side > 0 else 'crossed')
    deck = 'solver = %s\n' % r.choice(('dyad', 'matrix')) + deck
    columns = 'theta2,omega2,alpha2,F12x,F12y,' + ('Ts' if drive == 'crank' else 'drive')
    done = subprocess.run([fourlink, '-f', 'csv', '-c', columns], input=deck, capture_output=True, text=True)
    rows = list(csv.reader(io.StringIO(done.stdout)))
    if len(rows) != 2 or not rows[1][1]:
        refused += 1
        print('%d, kind %d: no row: %s' % (number, kind, (done.stderr.strip().split('\n') or [''])[-1] or rows[1][-1]))
        return
    found = [float(f) for f in rows[1][1:-1]]
    near = max(1, size / abs(K))
    doubt = DOUBT * EPS * near ** 2 * grows ** 3
    forces, effort = rig.row(s, p)
    scale = max(abs(f) for f in forces + [1])
    moved = sum(b[0] * reach + b[1] / a for b in rig.bodies)
    scale = max(scale, sum(b[0] for b in rig.bodies) * 9.81 + moved * (omega2 ** 2 * max(grows ** 3, bends * grows) + abs(alpha2) * grows))
    tell(number, kind, 'theta2', np.radians((found[0] - theta2 + 180) % 360 - 180), 0, DOUBT * EPS * near * grows, deck)
    tell(number, kind, 'omega2', found[1], omega2, doubt * abs(omega2), deck)
    tell(number, kind, 'alpha2', found[2], alpha2, doubt * near * (abs(alpha2) + omega2 ** 2 * bends), deck)
    doubt *= near / Kp ** 2 * grows * (10 if with_outputs else 1)  # arms of five links
    tell(number, kind, 'F12', complex(found[3], found[4]), forces[0], doubt * scale, deck)
    tell(number, kind, 'effort', found[5], effort, doubt * scale * (a if isinstance(p, Angle) else 1), deck)
    count['kind %d' % kind] = count.get('kind %d' % kind, 0) + 1
    count['by ' + name] = count.get('by ' + name, 0) + 1
    count['driven at ' + drive] = count.get('driven at ' + drive, 0) + 1


number = first
while count.get('theta2', 0) < n and number < first + 40 * n:
    try_one(number)
    number += 1
print('%d machines of %d compared, %d near a dead position of the crank, %d without a row; %s' % (
    count.get('theta2', 0), number - first, near_dead, refused, ', '.join('%s %d' % x for x in sorted(count.items()))))
print('worst, of what is known: %s' % ', '.join('%s %.2g' % x for x in sorted(worst.items())))
sys.exit(failed > 0)
