# SPDX-License-Identifier: GPL-3.0-or-later
#
# rubbing.py FOURLINK DECK... - rubbing speeds of pins: in every row the radius in the deck's text times the difference of the
# angular speeds of the two links, from the csv; max() and min() against rows at a fortieth of the interval.
import csv
import io
import math
import os
import re
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..'))
from linkage import Checks, si_of  # noqa: E402

fourlink, decks = sys.argv[1], sys.argv[2:]
checks = Checks()
PINS = {'four-bar': {'A': (2, 1), 'B': (3, 2), 'C': (4, 3), 'D': (4, 1)}, 'slider-crank': {'A': (2, 1), 'B': (3, 2), 'C': (4, 3)},
        'inverted-slider-crank': {'A': (2, 1), 'B': (3, 2), 'D': (4, 1)},
        'scotch-yoke': {'A': (2, 1), 'B': (3, 2)}}


def rows(deck, columns, *options):
    text = subprocess.run([fourlink, '--format=csv', '--units=SI', '--columns=' + ','.join(columns), *options, deck], capture_output=True,
                          encoding='utf-8').stdout
    return [row for row in csv.DictReader(io.StringIO(re.sub(r' \([^)]*\)', '', text))) if row['status'] == 'ok']


def check(deck):
    with open(deck, encoding='utf-8') as file:
        text = file.read()
    friction = re.search(r'^\[friction\]\n([^[]*)', text, re.M)
    if not friction or not re.search(r'^radius', friction[1], re.M):
        return
    kind = re.search(r'^mechanism = (\S+)', text, re.M)[1]
    radii = {key[7:]: float(number) * si_of(unit) for key, number, unit in re.findall(r'^(radius(?:_[A-D])?) = (\S+) (\S+)', friction[1], re.M)}
    pins = {pin: links for pin, links in PINS[kind].items() if radii.get(pin, radii.get('', 0)) > 0}
    names = ['rubbing_' + pin for pin in pins]
    speeds = ['omega2', 'omega3'] + ([] if kind in ('slider-crank', 'scotch-yoke') else ['omega4'])
    found = rows(deck, speeds + names)
    for row in found:
        for pin, (high, low) in pins.items():
            omega = {link: float(row.get('omega%d' % link, 0)) for link in (high, low)}
            wanted = radii.get(pin, radii.get('')) * (omega[high] - omega[low])
            size = radii.get(pin, radii.get('')) * max(map(abs, omega.values()))
            checks.that(abs(float(row['rubbing_' + pin]) - wanted) <= 1e-12 * size, pin, row, wanted)
    if re.search(r'^mode = ', text, re.M):
        return
    dense = rows(deck, names, '--interval=0.25 deg')
    for value in rows(deck, ['%s(%s)' % (which, name) for name in names for which in ('max', 'min')]):
        of = [row for row in dense if row['branch'] == value['branch']]
        for name in names:
            all_of = [float(row[name]) for row in of]
            size = max(map(abs, all_of), default=0)
            if not all_of or not value['max(%s)' % name]:
                continue
            for which, best, sign in (('max', max(all_of), 1), ('min', min(all_of), -1)):
                more = sign * (float(value['%s(%s)' % (which, name)]) - best)
                checks.that(more >= -1e-9 * size and (more <= 0.02 * size or math.isinf(more) or size > 1e3), which, name, value, best)


for deck in decks:
    checks.where = os.path.basename(deck)
    check(deck)
sys.exit(checks.finish())
