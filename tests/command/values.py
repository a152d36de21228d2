# SPDX-License-Identifier: GPL-3.0-or-later
#
# values.py FOURLINK DECK... - values of decks, a line for each branch: each has the value that --summary prints of one deck, as the
# number of a column that is named alone, or of many decks at once.
import csv
import io
import subprocess
import sys

fourlink, decks = sys.argv[1], sys.argv[2:]
MOST = 60  # values at once
compared = failed = 0


def run(*arguments):
    done = subprocess.run([fourlink, *arguments], capture_output=True, text=True, check=False)
    return done.returncode, list(csv.DictReader(io.StringIO(done.stdout))), done.stderr


def is_near(found, wanted, part):
    """The search of one extreme and that of all together agree to 12 digits."""
    try:
        x, y = float(found[0]), float(wanted[0])
        return found[1] == wanted[1] and abs(x - y) <= part * max(abs(x), abs(y)) + 1e-9 * (wanted[1] == 'deg') + 1e-15
    except ValueError:
        return found[0] == wanted[0]  # words


def expect(what, found, wanted, part=1e-11):
    global compared, failed
    compared += 1
    if found != wanted and not (isinstance(found, tuple) and is_near(found, wanted, part)):
        failed += 1
        print('FAILED: %s: %s, not %s' % (what, found, wanted))


def summary(deck):
    """(name, branch) -> (value, unit); branch '' if it is the same on both.  The first of a fact that is there twice."""
    status, rows, _ = run('--summary', '-f', 'csv', deck)
    found = {}
    for row in rows if status <= 1 else []:
        name = row['name']
        if not set(name) & set(' ,') and row['value']:
            found.setdefault((name, row['branch']), (row['value'], row['unit']))
    return {key: value for key, value in found.items() if key[0] != 'end'}, any('dead' in row['value'] for row in rows if row['name'] == 'end')


everywhere = {}
for deck in decks:
    wanted, is_dead = summary(deck)
    names = sorted({name for name, _ in wanted})
    # where friction jams the linkage near a dead position, or a computed motion runs into one, the edge of the rows scatters; where the
    # force of a guide changes its sign friction jumps, at a place that is known to 1e-11 rad
    rubs = any(name.startswith('friction.') for name in names)
    jams = rubs and any(name == 'theta2_from' and float(value[0]) for (name, _), value in wanted.items())
    part = 1e-7 if jams or is_dead else 5e-11 if rubs else 1e-11
    for k in range(0, len(names), MOST):
        status, rows, told = run('-f', 'csv', '--columns=' + ','.join(names[k:k + MOST]), deck)
        if not rows:
            expect(deck, told.strip(), 'lines')
        for row in rows:
            for name in names[k:k + MOST]:
                found = [(row[head], head[len(name) + 2:-1]) for head in row if head.rpartition(' (')[0] == name]
                value = wanted.get((name, row['branch'])) or wanted.get((name, ''))
                if value and not (name.endswith('(efficiency)') and abs(float(value[0])) < 1e-13):  # of what does no work
                    expect('%s, %s, %s' % (deck, row['branch'], name), found[0] if len(found) == 1 else found, value, part)
    everywhere[deck] = wanted

# the same of all decks in one call
common = ['mu_min', 'crank.length', 'crank_turns']
status, rows, told = run('-f', 'csv', '--columns=' + ','.join(common), *decks)
for row in rows:
    for name in common:
        value = everywhere[row['deck']].get((name, row['branch'])) or everywhere[row['deck']].get((name, ''))
        if value:
            expect('%s among many, %s' % (row['deck'], name), (row.get('%s (%s)' % (name, value[1])), value[1]), value)
print('%d decks, %d values compared, %d wrong' % (len(decks), compared, failed))
sys.exit(failed > 0 or compared == 0)
