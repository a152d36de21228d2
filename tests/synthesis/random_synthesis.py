#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
#
# random_synthesis.py FOURLINK [N [SEED]] - N random problems of each task of [synthesis]: the deck that --synthesis
# prints runs, and --check proves it, or a reason is told; and 10 N decks with mistakes, which end with a status of
# the manual within the time limit.  Prints what was tried; exits with 1 if anything else happens.
import random
import subprocess
import sys
from collections import Counter

fourlink = sys.argv[1]
number = int(sys.argv[2]) if len(sys.argv) > 2 else 1000
random.seed(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
LIMIT = 20  # s
u = random.uniform
failures = []


def run(deck, *options):
    try:
        done = subprocess.run([fourlink, *options, '-'], input=deck, capture_output=True, text=True, timeout=LIMIT)
    except subprocess.TimeoutExpired:
        return -1, '', 'time limit'
    return done.returncode, done.stdout, done.stderr


def some_angles(n, low, high, apart):
    apart = min(apart, (high - low) / (3 * n))
    angles = [a + i * apart for i, a in enumerate(sorted(u(low, high - n * apart) for _ in range(n)))]
    return angles if random.random() < 0.8 else angles[::-1]


def function_points(n):
    theta2, theta4 = some_angles(n, 0, 200, 5), some_angles(n, 0, 200, 5)
    return ('four-bar', '[ground]\nlength = %g mm\n' % u(10, 300), 'task = function\npoints = ' +
            ', '.join('%g deg %g deg' % pair for pair in zip(theta2, theta4)))


def function_range(kind):
    f = random.choice(['x^1.5', 'log10', 'ln', 'exp', 'sqrt', 'power %g' % u(0.3, 4), 'linear', 'square', '1/x'])
    a, b = u(0, 180), u(40, 130)
    out = 'rocker = %g deg to %g deg' % (u(0, 90), u(100, 180))
    if kind == 'slider-crank':
        out = 'piston = %g mm to %g mm' % (u(80, 200), u(20, 70))
    given = '[ground]\nlength = 100 mm\n' if kind == 'four-bar' else ''
    return (kind, given, 'task = function\nfunction = %s\nx = %g to %g\ncrank = %g deg to %g deg\n%s\nprecision = %d' %
            (f, u(0.5, 2), u(2.2, 5), a, a + b, out, random.choice([3, 3, 3, 4, 7, 15])))


def fits():
    n = random.choice([4, 5, 9, 20])
    kind, given, task = function_points(n)
    return kind, given, task + '\nfit = %s\nweights = %s' % (
        random.choice(['equation', 'angle']), ', '.join('%g' % u(0.1, 5) for _ in range(n)))


def dyad():
    choice = random.choice(['fixed (%g, %g) mm', 'moving (%g, %g) mm', 'rotations %g deg %g deg'])
    return choice % (u(-60, 60), u(-60, 60))


def positions(with_angles):
    items = []
    for _ in range(3):
        items.append('(%g, %g) mm' % (u(-50, 50), u(-50, 50)) + (' %g deg' % u(-90, 90) if with_angles else ''))
    return 'positions = ' + ', '.join(items)


def motion():
    return 'four-bar', '', 'task = motion\n%s\nleft = %s\nright = %s' % (positions(True), dyad(), dyad())


def slider_motion():
    return 'slider-crank', '', 'task = motion\n%s\nleft = %s\nright = slider %g deg' % (positions(True), dyad(), u(-180, 180))


def path(with_angles=True):
    return 'four-bar', '', 'task = path\n%s\ntiming = %g deg, %g deg\nright = %s' % (
        positions(with_angles), u(10, 100), u(110, 250), dyad())


def crank_rocker():
    lengths = random.sample(['crank', 'coupler', 'rocker', 'ground'], random.choice([1, 2, 2]))
    if len(lengths) == 1:
        lengths = [random.choice(['ground', 'rocker'])]
    given = ''.join('[%s]\nlength = %g mm\n' % (link, u(20, 60) if link == 'crank' else u(60, 200)) for link in lengths)
    return 'four-bar', given, 'task = quick-return\ntime_ratio = %g\nswing = %g deg\nslow = %s' % (
        u(1, 1.5), u(20, 100), random.choice(['with', 'against']))


def offset_slider():
    stroke = u(50, 150)
    given = random.choice(['', '[crank]\nlength = %g mm\n' % (u(0.35, 0.5) * stroke),
                           '[rod]\nlength = %g mm\n' % (u(1, 4) * stroke),
                           '[ground]\noffset = %g mm\n' % (u(0.05, 0.6) * stroke)])
    return 'slider-crank', given, 'task = quick-return\ntime_ratio = %g\nstroke = %g mm\nslow = %s' % (
        max(1, u(0.95, 1.8)), stroke, random.choice(['with', 'against']))


def lever():
    link = random.choice(['ground', 'crank'])
    kind = random.choice(['time_ratio = %g' % u(1.1, 3), 'swing = %g deg' % u(10, 100),
                          'type = whitworth\ntime_ratio = %g' % u(1.1, 3)])
    return 'inverted-slider-crank', '[%s]\nlength = %g mm\n' % (link, u(50, 200)), 'task = quick-return\n' + kind


def cognate():
    while True:
        a, b, c, d = (u(20, 150) for _ in range(4))
        if max(a, b, c, d) < 0.95 * (a + b + c + d) / 2:
            break
    given = '[crank]\nlength = %g mm\n[coupler]\nlength = %g mm\n[rocker]\nlength = %g mm\n[ground]\nlength = %g mm\n' % (
        a, b, c, d)
    given += '[point Q]\nlink = coupler\nat = (%g, %g) mm\n[table]\nbranch = %s\n' % (
        u(-100, 100), u(-100, 100), random.choice(['open', 'crossed']))
    return 'four-bar', given, 'task = cognate\nwhich = %s' % random.choice(['left', 'right'])


def wanted(problem):
    return 'mechanism = %s\n%s[synthesis]\n%s\n' % problem


def try_task(name, make):
    seen = Counter()
    for _ in range(number):
        deck = wanted(make())
        status, out, err = run(deck, '--synthesis')
        defect = 'defect:' in err
        if status == 1 and not out and 'error:' in err:
            seen['no linkage'] += 1
            continue
        if status not in (0, 1) or (status == 1) != defect or not out:
            failures.append((name, 'status %d: %s' % (status, err), deck))
            continue
        seen['with a defect' if defect else 'good'] += 1
        expects = out.count('[expect]')
        checked, comparison, complaint = run(out, '--check')
        if expects == 0 and '# position' in out:
            seen['no position is reached'] += 1
        elif checked != 0:
            failures.append((name, 'check %d: %s%s' % (checked, comparison[:600], complaint), deck))
        else:
            seen['proved'] += 1
    print('%-28s %s' % (name, ', '.join('%s %d' % item for item in sorted(seen.items()))), flush=True)


def spoil(deck):
    for _ in range(random.choice([1, 1, 2])):
        kind, at = random.choice([0, 1, 1, 2, 3, 4, 4, 5, 5, 5, 5, 6]), random.randrange(len(deck) + 1)
        lines = deck.split('\n')
        i = random.randrange(len(lines))
        if kind == 0:
            deck = deck[:at] + deck[at + random.randint(1, 9):]
        elif kind == 1:
            deck = deck[:at] + random.choice(['0', '-', '(', ')', ',', '=', ' ', '1e300', '1e-300', 'nan', 'deg', 'mm',
                                              '[', '\n', '\u00b0', ' to ', '999999999']) + deck[at:]
        elif kind == 2:
            lines.insert(i, random.choice(lines))
        elif kind == 3:
            del lines[i]
        elif kind == 4:
            key = lines[i].split('=')[0]
            lines[i] = key + '= ' + random.choice(['0', '0 mm', '0 deg', '1', '-1', '1e15 m', '1e-15 m', '360 deg', '180 deg',
                                                   '90 deg, 90 deg, 90 deg', '(0, 0) mm', 'best', 'left', 'fixed (0, 0) mm'])
        elif kind == 5:
            lines[i] = lines[i].replace(random.choice('0123456789'), random.choice(['', '0', '00', '-']))
        else:
            a = random.randrange(len(lines))
            lines[i], lines[a] = lines[a], lines[i]
        if kind >= 2:
            deck = '\n'.join(lines)
    return deck


def try_bad(makers):
    seen = Counter()
    for _ in range(10 * number):
        deck = spoil(wanted(random.choice(makers)()))
        status, out, err = run(deck, '--synthesis')
        seen['status %d' % status] += 1
        if status not in (0, 1, 2) or 'Sanitizer' in err or 'runtime error' in err or (status == 2 and 'error:' not in err):
            failures.append(('bad deck', 'status %d: %s' % (status, err), deck))
    print('%-28s %s' % ('decks with mistakes', ', '.join('%s %d' % item for item in sorted(seen.items()))))


tasks = [('function, three points', lambda: function_points(3)), ('function, range', lambda: function_range('four-bar')),
         ('function, slider-crank', lambda: function_range('slider-crank')), ('function, fits', fits), ('motion', motion),
         ('path', path), ('quick return, four-bar', crank_rocker), ('quick return, slider-crank', offset_slider),
         ('quick return, lever', lever), ('cognate', cognate), ('motion, slider-crank', slider_motion)]
for task in tasks:
    try_task(*task)
try_bad([make for _, make in tasks])
for name, why, deck in failures[:10]:
    print('FAILED: %s: %s\n%s' % (name, why, deck))
print('%d failed' % len(failures))
sys.exit(len(failures) > 0)
