# SPDX-License-Identifier: GPL-3.0-or-later
#
# people.py FOURLINK DECK... - what people read is in the deck's units, what programs read in SI: every number of each table
# and summary against that of the csv, converted by the factors of linkage.py; the units against a rule written here.
# Decks with [units] are left out.  Each deck is tried as it is and with all its lengths in cm, in, ft and m.
import csv
import io
import math
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..'))
from linkage import Checks, si_of  # noqa: E402

fourlink, decks = sys.argv[1], sys.argv[2:]
checks = Checks()

# quantities by their SI unit: where the crank is in inches or feet, L; a torque and an energy have names of their own
CUSTOMARY = {'m/s': 'L/s', 'm/s2': 'L/s2', 'kg': 'lb', 'kg.m2': 'lb.L2', 'kg.m': 'lb.L', 'N': 'lbf', 'N.m': 'lbf.L', 'J': 'lbf.L',
             'W': 'hp', 'Pa': 'psi', 'N/m': 'lbf/L', 'N.s/m': 'lbf.s/L', 'N.m/rad': 'lbf.L/rad', 'N.m.s/rad': 'lbf.L.s/rad'}

ROUNDING = ('residual', 'superposition', 'energy_residual')  # shown with fewer digits


def unit_for(si, length):
    """The unit that people get for one of SI, with the crank in this unit of length."""
    if si in ('m', 'm2', 'm3'):
        return length + si[1:]
    return CUSTOMARY[si].replace('L', length) if length in ('in', 'ft') and si in CUSTOMARY else si


def run(*words):
    done = subprocess.run([fourlink, *words], capture_output=True, encoding='utf-8', errors='replace')
    return done.returncode, done.stdout


def same(shown, value, digits=12):
    return shown == value or math.isnan(shown) and math.isnan(value) or abs(shown - value) <= 10 ** -digits * max(abs(value), 1e-300)


def check_value(what, shown, unit, value, si, length, floor=0.0):
    wanted = unit_for(si, length)
    checks.that(unit == wanted, '%s: in %s, not %s' % (what, unit, wanted))
    if unit == wanted:
        converted = value * si_of(si) / si_of(wanted)
        checks.that(same(shown, converted) or abs(shown - converted) <= floor, '%s: %r, not %r %s' % (what, shown, converted, unit))


def check_rows(deck, length):
    status, text = run('-c', 'all', '-b', 'open', '-s', 'table.digits=15', deck)
    other, records = run('-c', 'all', '-b', 'open', '-f', 'csv', deck)
    checks.that(status == other, 'status %d for people, %d in csv' % (status, other))
    lines = [line for line in text.splitlines() if line]
    heads = [line[1:].split() for line in lines if line.startswith('# theta2') or line.startswith('# time')]
    units = [lines[i + 1][1:].split() for i, line in enumerate(lines) if line.startswith('# theta2') or line.startswith('# time')]
    rows = [[float(x) for x in line.split()] for line in lines if not line.startswith('#')]
    table = [line for line in csv.reader(io.StringIO(records)) if line and not line[0].startswith('#')]
    names = [re.fullmatch(r'(\S+)(?: \((.*)\))?', name).groups() for name in table[0]] if table else []
    keep = [i for i, (name, _) in enumerate(names) if name not in ('branch', 'status') + ROUNDING]
    ordinary = [line for line in table[1:] if line[-1] == 'ok']
    if not heads or not ordinary:
        return
    checks.that(len(rows) == len(ordinary), '%d rows, not %d' % (len(rows), len(ordinary)))
    largest = {}
    for i in keep:
        sizes = [abs(float(line[i])) for line in ordinary if line[i]]
        largest[names[i][1]] = max([largest.get(names[i][1], 0)] + sizes)
    for i in keep:
        name, si = names[i]
        if name not in heads[0]:
            continue
        j = heads[0].index(name)
        sizes = [abs(float(line[i])) for line in ordinary if line[i]] or [0]
        if max(sizes) < 1e-9 * largest[si]:
            continue  # rounding, such as a couple without friction
        scale = si_of(si or '1') / si_of(unit_for(si or '1', length))
        for shown, line in zip(rows, ordinary):
            value = float(line[i]) if line[i] else math.nan
            check_value(name, shown[j], units[0][j], value, si or '1', length, 1e-11 * largest[si] * scale)


def check_summary(deck, length):
    status, text = run('--summary', '-b', 'open', '-s', 'table.digits=15', deck)
    other, records = run('--summary', '-b', 'open', '-f', 'csv', deck)
    checks.that(status == other, 'status %d for people, %d in csv' % (status, other))
    facts = {}
    for line in text.splitlines():
        found = re.match(r'((?:\w+ )*[\w.]+) +(-?[\d.]+(?:e[-+]\d+)?) +(\S+) ', line)
        if found and not line.startswith('#'):
            facts.setdefault(found[1], []).append((float(found[2]), found[3]))
    for line in csv.reader(io.StringIO(records)):
        if len(line) > 2 and facts.get(line[0]) and line[2] and line[0] not in ROUNDING:
            shown, unit = facts[line[0]].pop(0)  # one for each range
            check_value(line[0], shown, unit, float(line[1]), line[2], length, 1e-11)


def main():
    with tempfile.TemporaryDirectory() as folder:
        for path in decks:
            with open(path, encoding='utf-8') as file:
                text = file.read()
            if re.search(r'^\[units\]', text, re.M) or not re.search(r'^\[crank\]', text, re.M):
                continue
            for length in ('mm', 'cm', 'in', 'ft', 'm'):
                checks.where = '%s in %s' % (os.path.basename(path), length)
                changed = re.sub(r'(?<=[\d.)]) (?:mm|cm|in|m)(?= *(?:$|#|,|\+|at\b))', ' ' + length, text, flags=re.M)
                changed = re.sub(r'(\[crank\][^[]*?(?:length|stroke) *= *[\d.]+) \w+', r'\1 ' + length, changed)
                deck = os.path.join(folder, 'people.deck')
                with open(deck, 'w', encoding='utf-8') as file:
                    file.write(changed)
                if run('--print-deck', deck)[0] == 0:
                    check_rows(deck, length)
                    check_summary(deck, length)
    return checks.finish()


sys.exit(main())
