# SPDX-License-Identifier: GPL-3.0-or-later
#
# solve.py FOURLINK N DECK... - N random questions of --solve: a result is computed for a value of an input, and the question is
# where it has that result.  Each solution, set with --set, has to give it; the value asked for has to be among them; and
# the changes of sign in a sweep of 600 designs have to be the solutions, branch by branch.  Beside another deck its lines have to
# be the same.
import csv
import io
import random
import subprocess
import sys

fourlink, count, decks = sys.argv[1], int(sys.argv[2]), sys.argv[3:]
FINE = 600
NAMES = ('mu_min', 'mu_max', 'swing', 'theta4_swing', 'stroke', 'max(omega4)', 'max(Ts)', 'min(Ts)', 'mean(Ts)', 'max(F12)', 'rms(Ts)', 'max(F34)',
         'theta4 at %s deg', 'F12 at %s deg', 'Ts at %s deg', 'x at %s deg', 'v at %s deg')
KEYS = ('crank.length', 'coupler.length', 'rocker.length', 'ground.length', 'rod.length', 'motion.speed', 'crank.mass', 'lever.offset', 'ground.offset')
r = random.Random(7)
others = random.Random(8)
tried = compared = failed = 0


def run(*arguments):
    done = subprocess.run([fourlink, *arguments], capture_output=True, text=True, check=False)
    return done.returncode, list(csv.DictReader(io.StringIO(done.stdout))), done.stderr


def fail(what):
    global failed
    failed += 1
    if failed <= 10:
        print('FAILED: ' + what)


def number(words):
    try:
        return float(words)
    except (TypeError, ValueError):
        return None


def values_of(deck, name, *options):
    """branch -> value; of a column at an angle through --at."""
    column, _, angle = name.partition(' at ')
    status, rows, _ = run('-f', 'csv', '--columns=' + column, *(['--at=' + angle] if angle else []), *options, deck)
    head = [x for x in rows[0] if x.rpartition(' (')[0] == column] if rows else []
    return {row['branch']: (number(row[head[0]]), head[0]) for row in rows if head and number(row[head[0]]) is not None}


def fine(deck, name, key, low, high, unit):
    """branch -> [(x, value)] of a sweep; values of a deck alone, since a sweep has no columns at angles."""
    if ' at ' in name:
        return None
    _, rows, _ = run('-f', 'csv', '--set', 'sweep.%s=%.17g %s to %.17g %s in %d' % (key, low, unit, high, unit, FINE), '--columns=' + name, deck)
    found = {}
    for row in rows:
        x = [number(row[h]) for h in row if h.rpartition(' (')[0] == key]
        y = [number(row[h]) for h in row if h.rpartition(' (')[0] == name]
        if x and y:
            found.setdefault(row['branch'], []).append((x[0], y[0]))
    return found


def changes(points, wanted):
    """Places where a curve crosses a value, without jumps: there a value differs from its neighbours' line by much."""
    found = []
    for (x, y), (u, v) in zip(points, points[1:]):
        if None not in (y, v) and abs(y) < 1e300 and abs(v) < 1e300 and (y - wanted) * (v - wanted) < 0:
            found.append((x, u, abs(v - y)))
    return found


def lines(rows, deck=None):
    """What the lines of a deck have, without empty fields; of several decks, of this one."""
    return [sorted(v for k, v in row.items() if v and k != 'deck') for row in rows if deck is None or row['deck'] == deck]


while tried < count:
    deck = r.choice(decks)
    inputs = {}
    _, rows, _ = run('--summary', '-f', 'csv', deck)
    for row in rows:
        if row['name'] in KEYS and number(row['value']):
            inputs[row['name']] = (number(row['value']), row['unit'])
    if not inputs:
        continue
    key, name = r.choice(sorted(inputs)), r.choice(NAMES)
    if '%s' in name:
        name = name % r.randrange(0, 360, 7)
    x, unit = inputs[key]
    low, high = sorted((x * r.uniform(0.6, 0.95), x * r.uniform(1.05, 1.5)))
    at = r.uniform(low, high)
    wanted = values_of(deck, name, '--set', '%s=%.17g %s' % (key, at, unit))
    if not wanted:
        continue
    branch = r.choice(sorted(wanted))
    value, head = wanted[branch]
    if abs(value) > 1e300 or abs(value) < 1e-9:  # unbounded, or rounding
        continue
    other = values_of(deck, name, '--set', '%s=%.17g %s' % (key, low, unit)).get(branch)
    if other and abs(other[0] - value) <= 1e-9 * abs(value):  # the result does not depend on the input
        continue
    tried += 1
    result_unit = head.rpartition(' (')[2][:-1]
    question = '%s = %.17g %s .. %.17g %s where %s = %.17g %s' % (key, low, unit, high, unit, name, value, result_unit)
    asked = '--solve=' + question.replace(' 1 ', ' ').removesuffix(' 1')
    status, rows, told = run('-f', 'csv', asked, deck)
    other_deck = others.choice(decks)
    other_status, other_rows, _ = run('-f', 'csv', asked, other_deck)
    both_status, both, _ = run('-f', 'csv', asked, deck, other_deck)
    compared += 2
    expected = [lines(rows), lines(other_rows)] if deck != other_deck else [lines(rows) * 2] * 2
    if [lines(both, deck), lines(both, other_deck)] != expected or both_status != max(status, other_status):
        fail('%s beside %s, %s: %s is not %s' % (deck, other_deck, question, lines(both), expected))
    places = {}
    for row in rows:
        if not row['branch']:  # why there is none
            continue
        places.setdefault(row['branch'], []).append(number(list(row.values())[1]))
    for where, list_ in places.items():
        for place in list_[:3]:
            got = values_of(deck, name, '--set', '%s=%.17g %s' % (key, place, unit)).get(where)
            compared += 1
            turn = 360 if result_unit == 'deg' and ' at ' in name else 0
            off = abs(got[0] - value) if got else None
            if off is None or min(off, abs(off - turn)) > 1e-6 * max(abs(value), 1e-9) + 1e-9:
                fail('%s, %s: %s gives %s' % (deck, question, place, got))
    points = fine(deck, name, key, low, high, unit)
    if points is None:  # at an angle
        compared += 1
        if not any(abs(place - at) <= 1e-6 * abs(at) for place in places.get(branch, [])):
            fail('%s, %s: %s is not among %s %s' % (deck, question, at, places.get(branch), told))
        continue
    for where, list_ in points.items():
        compared += 1
        own = places.get(where, [])
        missed = [c for c in changes(list_, value) if not any(c[0] - 1e-9 * high <= place <= c[1] + 1e-9 * high for place in own)]
        # a jump is no solution: near it the curve is not continuous
        steps = sorted(abs(b[1] - a[1]) for a, b in zip(list_, list_[1:]) if None not in (a[1], b[1]) and abs(a[1]) < 1e300 and abs(b[1]) < 1e300)
        usual = steps[len(steps) // 2] if steps else 0
        missed = [c for c in missed if c[2] < 50 * usual]
        if missed:
            fail('%s, %s: on %s between %s there is one; found %s' % (deck, question, where, missed[0][:2], own))
print('%d questions, %d comparisons, %d wrong' % (tried, compared, failed))
sys.exit(failed > 0)
