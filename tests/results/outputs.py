# SPDX-License-Identifier: GPL-3.0-or-later
#
# outputs.py FOURLINK DECK... - decks with outputs against their own rows, 7201 of a turn: an extreme is at least the best of them, and
# beyond it by less than its neighbours are below it, or a row itself; an unbounded one needs an end of a range; the ranges have the rows that there are.
import csv
import io
import math
import subprocess
import sys

fourlink, decks = sys.argv[1], sys.argv[2:]
STEP = 0.05  # deg
failed, compared, unbounded, ranges, limits = [], 0, 0, 0, 0


def run(*arguments):
    done = subprocess.run([fourlink, '-f', 'csv', *arguments], capture_output=True, text=True, timeout=300)
    return list(csv.reader(io.StringIO(done.stdout)))


def number(cell):
    return float(cell) if cell else math.nan


def is_at_end(facts, angle):
    """At an end of a range, where the column has a limit and no row."""
    return angle and any(abs((float(angle) - x + 180) % 360 - 180) < 1e-3 for key in ('theta2_from', 'theta2_to') for x in facts[key])


def is_there(deck, branch, name, told, angle):
    """A row between those that were asked has this value: a dip beside an end of the range."""
    line = run('-b', branch, '-c', name, '--at=%s deg' % angle, deck)[1]
    return abs(number(line[1]) - told) <= 1e-9 * abs(told)


def is_whole(facts):
    """1 range; a slider in a slot of a link can go beyond all bounds between two rows, where one range ends and another begins."""
    return all(high - low > 360 - 1e-6 for low, high in zip(facts['theta2_from'], facts['theta2_to']))


def check_extremes(deck, branch, names, rows, facts, where):
    """Of columns that have no jumps: angles and what has friction are left out by the caller."""
    global compared, unbounded
    for k, name in enumerate(names):
        values = [row[k] if row else math.nan for row in rows]
        there = [i for i, x in enumerate(values) if x == x]
        if not there:
            continue
        size = sorted(abs(values[i]) for i in there)[len(there) // 2] + 1e-12
        for sign, which in ((1, 'max'), (-1, 'min')):
            told = facts.get('%s(%s)' % (which, name))
            if told is None:
                failed.append('%s, %s: no %s(%s)' % (deck, branch, which, name))
                continue
            i = max(there, key=lambda i: sign * values[i])
            inside = 0 < i < len(rows) - 1 and rows[i - 1] and rows[i + 1]
            beside = max(abs(values[i] - values[j]) for j in (i - 1, i + 1)) if inside else 0
            compared += 1
            if math.isinf(told):
                unbounded += 1
                if told != sign * math.inf or all(rows) and is_whole(facts):  # some grow within the last step before an end
                    failed.append('%s, %s: %s(%s) %g, rows say %g' % (deck, branch, which, name, told, values[i]))
            elif sign * (told - values[i]) < -1e-9 * max(size, abs(told)) or \
                    inside and sign * (told - values[i]) > beside + 1e-9 * size and not is_at_end(facts, where['%s(%s)' % (which, name)]) and \
                    not is_there(deck, branch, name, told, where['%s(%s)' % (which, name)]):
                failed.append('%s, %s: %s(%s) %.12g, rows say %.12g' % (deck, branch, which, name, told, values[i]))


def check_limits(deck, branch, output, kind, angles, values, facts):
    """Stroke or swing, and the time ratio, of an output whose rows make a whole turn: both ends of its way are rows, or between two."""
    global limits
    for i in range(1, len(values)):
        if kind == 'theta':
            values[i] = values[i - 1] + (values[i] - values[i - 1] + 180) % 360 - 180
    way, low, high = ('stroke', 'x_min', 'x_max') if kind == 'x' else ('swing', 'theta_min', 'theta_max')
    told = facts.get('%s.%s' % (output, way))
    if kind == 'theta' and abs(values[-1] - values[0]) > 180:  # it turns fully
        if told is not None:
            failed.append('%s, %s: %s has a swing and turns fully' % (deck, branch, output))
        return
    i, j = values.index(min(values)), values.index(max(values))
    slack = 2 * max(abs(values[k] - values[k - 1]) for at in (i, j) for k in (max(at, 1), min(at + 1, len(values) - 1))) + 1e-9 * (values[j] - values[i])
    limits += 1
    if told is None or not -1e-9 * told <= told - (values[j] - values[i]) <= slack:
        failed.append('%s, %s: %s.%s %s, rows say %.12g' % (deck, branch, output, way, told, values[j] - values[i]))
        return
    least, most = facts['%s.%s' % (output, low)], facts['%s.%s' % (output, high)]
    apart = (least - values[i] + 180) % 360 - 180 if kind == 'theta' else least - values[i]
    if abs(apart) > slack or abs(most - least - told) > 1e-9 * (abs(most) + abs(least)):
        failed.append('%s, %s: %s from %.12g to %.12g, rows say %.12g' % (deck, branch, output, least, most, values[i]))
    turns = sum((values[k] - values[k - 1]) * (values[(k + 1) % len(values) or 1] - values[k]) < 0 for k in range(1, len(values)))
    ratio, span = facts.get(output + '.time_ratio'), abs(angles[i] - angles[j])
    span = max(span, 360 - span)
    flat = any(abs(values[k] - values[k - 1]) < 1e-12 * told for k in range(1, len(values)))
    if not flat and (turns == 2) != (ratio is not None):
        failed.append('%s, %s: %s turns back %d times, time ratio %s' % (deck, branch, output, turns, ratio))
    elif ratio is not None and turns == 2 and abs(ratio - span / (360 - span)) > 2 * STEP * (1 + ratio) ** 2 / 180:
        failed.append('%s, %s: %s.time_ratio %.12g, rows say %.5g' % (deck, branch, output, ratio, span / (360 - span)))


def check_ranges(deck, branch, angles, rows, facts):
    """theta2_from, theta2_to: a row is there if its angle is in one of them."""
    global ranges
    pairs = list(zip(facts['theta2_from'], facts['theta2_to']))
    for angle, row in zip(angles, rows):
        near = min((abs((angle - x + 180) % 360 - 180) for pair in pairs for x in pair), default=360)
        inside = any((angle - low) % 360 <= high - low for low, high in pairs)
        if near > 1e-4 and inside != bool(row):
            failed.append('%s, %s: at %g deg the ranges %s are wrong' % (deck, branch, angle, pairs))
            return
        ranges += 1


for deck in decks:
    with open(deck, 'rb') as file:
        text = file.read()
    if b'[output' not in text or b'[pins]' in text or b'\ninput' in text or b'[friction]' in text:  # that jumps where a joint reverses
        continue
    head = run('--interval=%g deg' % STEP, '-c', 'all', deck)
    if not head:
        failed.append('%s: no rows' % deck)
        continue
    names = [name.split(' (')[0] for name in head[0]]
    units = [name.split('(')[-1].rstrip(')') for name in head[0]]
    own = [k for k, name in enumerate(names) if name[:2] in ('P.', 'Q.', 'R.') and units[k] != 'deg' or name in ('Ts', 'F12x', 'F14y', 'Fsy', 'Ms')]
    wanted = [names[k] for k in own]
    lines = run('--summary', '-c', ','.join(wanted), deck)
    theta2 = names.index('theta2')
    for branch in ('open', 'crossed'):
        found = [line for line in head[1:] if line and line[0] == branch]
        if not found:
            continue
        rows = [[number(line[k]) for k in own] if line[-1] == 'ok' or line[-1].startswith('near') else None for line in found]
        facts, where = {'theta2_from': [], 'theta2_to': []}, {}
        for line in lines:
            if len(line) >= 5 and line[-1] in (branch, ''):
                if line[0] in facts and line[0].startswith('theta2_'):
                    facts[line[0]].append(float(line[1]) * (1 if line[2] == 'deg' else 180 / math.pi))
                elif line[0].split('.')[-1] in ('x_min', 'x_max', 'stroke', 'theta_min', 'theta_max', 'swing', 'time_ratio') and line[-1] == branch:
                    facts[line[0]] = float(line[1])
                elif '(' in line[0]:
                    facts[line[0]], where[line[0]] = number(line[1]), line[3]
        check_extremes(deck, branch, wanted, rows, facts, where)
        if all(rows) and len(rows) > 7000 and is_whole(facts):
            for k, name in enumerate(names):
                output, dot, kind = name.rpartition('.')
                if kind in ('x', 'theta') and output in ('P', 'Q', 'R') and '%s.mu' % output in names:
                    turned = 180 / math.pi if units[k] == 'rad' else 1
                    check_limits(deck, branch, output, kind, [float(line[theta2]) for line in found], [float(line[k]) * turned for line in found], facts)
        check_ranges(deck, branch, [float(line[theta2]) for line in found], rows, facts)
for line in failed[:40]:
    print('FAILED: ' + line)
print('outputs: %d extremes, %d of them unbounded, %d rows in or out of the ranges, %d strokes and swings' % (compared, unbounded, ranges, limits))
print('%d passed, %d failed' % (compared + ranges + limits - len(failed), len(failed)))
sys.exit(len(failed) > 0)
