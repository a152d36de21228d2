# SPDX-License-Identifier: GPL-3.0-or-later
#
# hints.py FOURLINK DECK... - sheets of answers with one slip each: the opposite sign or force, another unit, the other branch,
# another row, angles clockwise, in radians or from other axes, no weights, another gravity, angles of a four-bar rounded before
# the rest is computed from them.  The value with the slip is that
# of the table of a deck with the slip in it, or is computed here.  Where it is beyond the tolerance, the hint must be that of
# a slip with that value; a right answer has none.  Decks whose motion is computed, or is that of something else than the
# crank, are left out.
import csv
import io
import math
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..'))
from linkage import Checks  # noqa: E402

fourlink, decks = sys.argv[1], sys.argv[2:]
checks = Checks()
WANTED = ('Ts', 'F12x', 'F23x', 'F23y', 'F23_dir', 'F34y', 'F14x', 'F14_dir', 'theta3', 'theta4', 'omega3', 'omega4', 'alpha4', 'x', 'v', 'a')
PART = 1e-4  # of a value, its tolerance
GRADING = 'grading.tolerance=%g %%' % (100 * PART)
FACTORS = (('1/1000 of this', 1000), ('is 1000 times', 1 / 1000), ('180/pi', math.pi / 180), ('pi/180', 180 / math.pi))
counts = {}


def run(deck, *words):
    done = subprocess.run([fourlink, '-b', 'open', *words, deck], capture_output=True, encoding='utf-8', errors='replace')
    return done.stdout


def rows_of(deck, *words):
    """[{name: (value, unit)}] of a table."""
    lines = [line for line in csv.reader(io.StringIO(run(deck, '-f', 'csv', *words))) if line and not line[0].startswith('#')]
    names = [re.match(r'(\S+)(?: \((.*)\))?$', head).groups() for head in lines[0]] if lines else []
    return [{name: (float(value), unit or '') for (name, unit), value in zip(names, line) if is_number(value)} for line in lines[1:]]


def is_number(words):
    try:
        return math.isfinite(float(words))
    except ValueError:
        return False


def row_at(deck, angle, *words):
    """{name: value} of the row at a crank angle; {} if there is none."""
    rows = rows_of(deck, '-c', 'all', '--at=' + angle, *words)
    return {name: value for name, (value, _) in rows[0].items()} if len(rows) == 1 else {}


def is_direction(name):
    return name.startswith('theta') or name.endswith('_dir')


def apart(name, x, y):
    d = abs(x - y)
    return abs((d + 180) % 360 - 180) if is_direction(name) else d


def is_near(name, x, y, right):
    return apart(name, x, y) <= PART * abs(right) + 1e-9


def speed_of(deck):
    """rad/s, of the crank; 0: none is given."""
    with open(deck, encoding='utf-8') as file:
        m = re.search(r'^\[motion\]\n(?:.*\n)*?speed = (\S+) rad/s$', file.read(), re.M)
    return float(m.group(1)) if m else 0


def other_axes(deck):
    """How much larger, deg, the crank angle is in the other axes; their name, and the words of the hint."""
    page, own = (re.search(r'x of link 1 at +(\S+) deg', run(deck, *words)) for words in (('-s', 'axes=page'), ()))
    angle = float(page.group(1)) if page else 0
    return (-angle, 'ground', 'from link 1') if own else (angle, 'page', 'of the page')


def slips_of(deck, angle, interval, right):
    """[(kind, words of the hint, {name: value})]"""
    number = float(angle.split()[0])
    rows = [('branch', 'crossed branch', row_at(deck, angle, '-b', 'crossed')),
            ('row', 'neighbouring row', row_at(deck, '%.17g deg' % (number - interval))),
            ('row', 'neighbouring row', row_at(deck, '%.17g deg' % (number + interval))),
            *[('clockwise', 'counter-clockwise', row_at(deck, '%.17g deg' % (k - number))) for k in (0, 360, -360)],
            ('radians', 'theta2 = .* rad', row_at(deck, '%.17g deg' % (number * 180 / math.pi % 360))),
            ('radians', 'theta2 = .* rad', row_at(deck, '%.17g deg' % (number * 180 / math.pi % 360 - 360))),
            ('no weights', 'without the weights', row_at(deck, angle, '-s', 'gravity.acceleration=0 m/s2')),
            ('gravity 9.8', 'gravity 9.8 m', row_at(deck, angle, '-s', 'gravity.acceleration=9.8 m/s2')),
            ('gravity 9.81', 'gravity 9.81 m', row_at(deck, angle, '-s', 'gravity.acceleration=9.81 m/s2')),
            ('gravity 10', 'gravity 10 m', row_at(deck, angle, '-s', 'gravity.acceleration=10 m/s2')),
            ('gravity 32.2', r'gravity 32.2 ft', row_at(deck, angle, '-s', 'gravity.acceleration=32.2 ft/s2')),
            ('axes', 'of the page', row_at(deck, angle, '-s', 'axes=page')), ('axes', 'from link 1', row_at(deck, angle, '-s', 'axes=ground'))]
    rows += [('speed', 'rpm', row_at(deck, angle, '-s', 'motion.speed=%.17g rad/s' % (speed_of(deck) * factor)))
             for factor in (30 / math.pi, math.pi / 30) if speed_of(deck)]
    shift, axes, words = other_axes(deck)
    rows.append(('axes of the values', words, row_at(deck, '%.17g deg' % (number + shift), '-s', 'axes=' + axes)))
    rows.append(('sign', '(sign|direction) is the opposite', {n: v + 180 if n.endswith('_dir') else -v for n, v in right.items()}))
    rows.append(('rpm', 'rpm for rad/s', {n: v * 30 / math.pi for n, v in right.items() if n.startswith('omega')}))
    large = {n: v for n, v in right.items() if abs(v) > 1e-3}
    rows += [('factor', words, {n: v * factor for n, v in large.items()}) for words, factor in FACTORS]
    rows += [('factor', 'rpm', {n: v * factor for n, v in large.items() if n != 'x' and not is_direction(n)})
             for factor in (30 / math.pi, math.pi / 30, (30 / math.pi)**2, (math.pi / 30)**2)]
    return rows


def lengths_of(deck):
    """Ground, crank, coupler and rocker of a four-bar, m, and the angle of the ground; None for others."""
    with open(deck, encoding='utf-8') as file:
        text = file.read()
    found = [re.search(r'^\[%s\]\n(?:[a-z].*\n)*?length = ([0-9.e-]+) (mm|m)\n' % link, text, re.M) for link in ('ground', 'crank', 'coupler', 'rocker')]
    if 'four-bar' not in text or not all(found) or re.search(r'^(angle|axes) *=|^\[(pins|output)', text, re.M):
        return None
    return [float(m.group(1)) * (1e-3 if m.group(2) == 'mm' else 1) for m in found]


def try_carried(deck, angle):
    """The angles to one digit, and angular velocities and accelerations from them, to two digits: Alvi section 3."""
    lengths = lengths_of(deck)
    right = row = row_at(deck, angle) if lengths else {}
    if not all(n in right for n in ('theta3', 'theta4', 'omega3', 'omega4', 'alpha4')):
        return
    _, a, b, c = lengths
    t2, w2, al2 = math.radians(row['theta2']), row['omega2'], row['alpha2']
    t3, t4 = round(right['theta3']), round(right['theta4'])
    e3, e4 = math.radians(t3), math.radians(t4)
    sine = math.sin(e3 - e4)
    if abs(sine) < 0.1 or w2 == 0:
        return
    w3, w4 = a * math.sin(e4 - t2) / (b * sine) * w2, a * math.sin(e3 - t2) / (c * sine) * w2
    w3, w4 = float('%.3g' % w3), float('%.3g' % w4)
    al4 = (a * al2 * math.sin(e3 - t2) - a * w2**2 * math.cos(e3 - t2) - b * w3**2 + c * w4**2 * math.cos(e3 - e4)) / (c * sine)
    text = 'at = %s\ntheta3 = %.15g deg\ntheta4 = %.15g deg\nomega3 = %.15g rad/s\nomega4 = %.15g rad/s\nalpha4 = %.15g rad/s2\n'
    found = checked(deck, text % (angle, t3, t4, w3, w4, al4), 'grading.theta3=1 deg', 'grading.theta4=1 deg', 'grading.omega3=50 %', 'grading.omega4=50 %')
    if not is_near('alpha4', al4, right['alpha4'], 1.02 * right['alpha4']):
        result, computed, note = found.get(6, ('', '', ''))
        checks.that(result == 'differs' and note, '%s: carried alpha4 = %.15g at %s: %s, computed %s, %s' % (deck, al4, angle, result, computed, note))
        kind = 'carried' if 'it follows from theta3' in note else 'carried, another slip too'
        counts[kind] = counts.get(kind, 0) + 1


def checked(deck, text, *gradings):
    """The lines of --check, by the line of the sheet: (result, computed, note)."""
    with tempfile.NamedTemporaryFile('w', suffix='.expect') as file:
        file.write(text)
        file.flush()
        lines = csv.DictReader(io.StringIO(run(deck, '--check=' + file.name, '-f', 'csv', '-s', GRADING, *[x for g in gradings for x in ('-s', g)])))
        return {int(x['line']): (x['result'], x['computed'], x['note']) for x in lines if x['line']}


def is_given(deck):
    with open(deck, encoding='utf-8', errors='replace') as file:
        return not re.search(r'^ *(\[(motor|sweep|synthesis)|(mode|input|program)\b)', file.read(), re.M)


def try_deck(deck):
    angles = [x['theta2'][0] for x in rows_of(deck, '-c', 'theta2') if 'theta2' in x]
    if len(angles) < 4:
        return 0
    interval = angles[1] - angles[0]
    angle = '%.17g deg' % angles[(7 * len(angles)) // 11]
    there = rows_of(deck, '-c', 'all', '--at=' + angle)
    units = {n: u for n, (_, u) in there[0].items()} if there else {}
    right = {n: v for n, (v, _) in there[0].items() if n in WANTED} if there else {}
    slips = slips_of(deck, angle, abs(interval), right)
    text, wanted, line = 'at = %s\n' % angle, {}, 1
    for name, value in right.items():
        for kind, words, values in slips:
            if name not in values or is_near(name, values[name], value, 1.02 * value):
                continue
            v = values[name]
            if kind == 'axes of the values' and abs(value) < 1e-3 * abs(v):
                continue  # the angle between the axes is known to nine digits
            line += 1
            text += '%s = %.15g %s\n' % (name, v, units[name])
            wanted[line] = (kind, name, v, [w for k, w, x in slips if name in x and is_near(name, x[name], v, x[name] if k == 'factor' else value)])
        line += 1
        text += '%s = %.15g %s\n' % (name, value, units[name])
        wanted[line] = ('right', name, value, [])
    for each in angles[::max(1, len(angles) // 10)]:
        try_carried(deck, '%.17g deg' % each)
    found = checked(deck, text)
    for line, (kind, name, v, words) in wanted.items():
        result, computed, note = found.get(line, ('', '', ''))
        good = result == 'ok' and not note if kind == 'right' else result == 'differs' and any(re.search(w, note) for w in words)
        checks.that(good, '%s: %s = %.15g at %s, %s: %s, computed %s, %s' % (deck, name, v, angle, kind, result, computed, note))
        counts[kind] = counts.get(kind, 0) + 1
    return 1


tried = sum(try_deck(deck) for deck in decks if is_given(deck))
print('%d decks of %d, %d answers: %s' % (tried, len(decks), sum(counts.values()), ', '.join('%s %d' % x for x in sorted(counts.items()))))
sys.exit(checks.finish())
