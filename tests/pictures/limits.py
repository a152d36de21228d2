# SPDX-License-Identifier: GPL-3.0-or-later
#
# limits.py FOURLINK DATA DECKS - the picture of limits: swing, stroke and dead positions against the triangles that
# they are, the transmission angle against that of the table, instantaneous centres against the velocities of the table.
# A listing with one number changed is found wrong.
import cmath
import math
import os
import re
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
from linkage import Checks, Deck, Program, cross, dot, si_of  # noqa: E402
from panels import Listing  # noqa: E402

CRANK, COUPLER, FOLLOWER, RESULT = 'crank', 'coupler', 'follower', 'result'

DOUBLE_ROCKER = """mechanism = four-bar
[units]
length = mm
[ground]
length = 120
angle = 25 deg
[crank]
length = 100
[coupler]
length = 40
[rocker]
length = 95
[motion]
speed = 60 rpm
interval = 10 deg
"""
SPRINGLESS = """mechanism = slider-crank
[units]
length = mm
[ground]
offset = 15
[crank]
length = 50
[rod]
length = 180
[motion]
speed = -200 rpm
interval = 10 deg
"""


def heads(panel):
    return [line for line in panel.lines if line.style == RESULT and line.is_arrow]


def arc_ends(panel, centre):
    """The directions of both ends of the arc with heads about a point."""
    return sorted(cmath.phase(line.end - centre) % (2 * math.pi) for line in heads(panel))


def links(panel, style):
    return [line for line in panel.lines if line.style == style and not line.is_arrow]


def check_swing(checks, deck, panel, side):
    """The triangle ACD at a limit, with AC = b - a and a + b: cos(ADC) = (d^2 + c^2 - AC^2) / (2 d c)."""
    a, b, c, d = (deck.length(link) for link in (2, 3, 4, 1))
    wanted = sorted((side * (math.pi - math.acos((d * d + c * c - AC * AC) / (2 * d * c)))) % (2 * math.pi) for AC in (b - a, a + b))
    found = arc_ends(panel, d)
    if checks.that(len(found) == 2, 'two ends of the swing', found):
        for x, y in zip(found, wanted):
            checks.near('an end of the swing', x, y, 1, 2e-5)
    for crank, coupler in zip(links(panel, CRANK), links(panel, COUPLER)):
        checks.near('crank and coupler are in line', cross(crank.vector, coupler.vector), 0, a * b, 2e-5)
    checks.near('the note of the swing', float(re.match('[0-9.]+', panel.note('swing')).group(0)), math.degrees(wanted[1] - wanted[0]), 180, 1e-4)


def check_stroke(checks, deck, panel, side):
    """x^2 + e^2 = (l + r)^2 and (l - r)^2; of a yoke linkage.py has them"""
    r, l, e = deck.length(2), deck.length(3), deck.number('ground.offset')
    wanted = sorted((deck.nearest(), deck.dead_centre()) if deck.yoke else
                    [side * math.sqrt((l + k * r) ** 2 - e * e) for k in (1, -1)])
    found = sorted(line.end.real for line in heads(panel))
    if checks.that(len(found) == 2, 'two ends of the stroke', found):
        for x, y in zip(found, wanted):
            checks.near('an end of the stroke', x, y, l + r, 2e-6)
    checks.near('the note of the stroke', float(panel.note('stroke').split(' ')[0]), wanted[1] - wanted[0], l, 1e-4)


def check_dead(checks, deck, panel):
    """BD is b + c or |b - c|."""
    a, b, c, d = (deck.length(link) for link in (2, 3, 4, 1))
    couplers, rockers = links(panel, COUPLER), links(panel, FOLLOWER)
    checks.that(len(couplers) == 4, 'four dead positions', len(couplers))
    for coupler, rocker in zip(couplers, rockers):
        checks.near('coupler and rocker are in line', cross(coupler.vector, rocker.vector), 0, b * c, 2e-5)
        BD = abs(coupler.start - d)
        checks.near('BD', min(abs(BD - b - c), abs(BD - abs(b - c))), 0, d, 2e-6)
    angles = sorted(cmath.phase(line.end) % (2 * math.pi) for line in links(panel, CRANK))
    wanted = [math.acos((a * a + d * d - BD * BD) / (2 * a * d)) for BD in (b + c, abs(b - c)) if abs(a * a + d * d - BD * BD) < 2 * a * d]
    wanted = sorted(x % (2 * math.pi) for angle in wanted for x in (angle, -angle))
    for x, y in zip(angles, wanted):
        checks.near('a dead position', x, y, 1, 2e-5)


def check_centres(checks, deck, panel, row):
    """Points of a link move at right angles to their lines to its centre, with the speed omega r."""
    places = {}
    for name, at, noted in centres(panel):
        checks.that(at is not None or abs(noted) > 2 * max(deck.length(link) for link in (1, 2, 3, 4)), 'a dot at', name, noted)
        if at is not None:
            places[name] = at
    position = deck.at(row)
    size = max(abs(position.B), abs(position.C), abs(position.D))
    for name in ('I₁₃', 'I₂₄'):
        if name not in places:
            continue
        I = places[name]
        if name == 'I₁₃':
            points = [(position.B, position.velocity(3, 0))]
            if not deck.slot:
                points.append((position.C, position.velocity(3, deck.length(3))))
            for at, v in points:
                checks.near('a velocity about I13', v, 1j * position.omega[3] * (at - I), abs(position.velocity(3, 0)) + abs(v), 2e-5)
        elif deck.slides:
            checks.near('the velocity of I24', (1j * position.omega[2] * I).real, position.velocity(4, 0).real, abs(position.omega[2]) * size, 2e-5)
        else:
            checks.near('the velocity of I24', position.omega[2] * I, position.omega[4] * (I - position.D), abs(position.omega[2]) * (size + abs(I)), 2e-5)
    return len(places)


def centres(panel):
    """The centres that notes tell, with their dots."""
    for note in panel.notes:
        match = re.match(r'(I₁₃|I₂₄) = \(([-0-9.e+]+), ([-0-9.e+]+)\)', note)
        if match:
            at = complex(float(match.group(2)), float(match.group(3)))
            near = [disc[0] for disc in panel.discs if abs(disc[0] - at) < 1e-3 * abs(at) + 1e-9]
            yield match.group(1), near[0] if near else None, at


def check_transmission(checks, deck, panel, row, position):
    if deck.slot:
        return
    arc = [line for line in panel.lines if line.style == RESULT]
    swept = abs(sum(cmath.phase((line.end - position.C) / (line.start - position.C)) for line in arc))
    checks.near('the arc of mu', swept, row['mu'] * si_of(deck.unit('angle')), 1, 2e-5)
    rod = cmath.phase(position.B - position.C)
    ends = [cmath.phase((p - position.C) / cmath.rect(1, rod)) for p in (arc[0].start, arc[-1].end)]
    checks.near('it begins at the rod', min(map(abs, ends)), 0, 1, 2e-5)


def check_deck(checks, deck, change=lambda text: text):
    """The same of a listing that was changed, which is wrong."""
    drawn = 0
    for branch, rows in deck.table('--branch=both').items():
        good = [row for row in rows if row.is_ok and row['mu'] * si_of(deck.unit('angle')) > 0.1]
        for row in good[1::7][:3]:
            checks.where = '%s, %s, %s' % (deck.name, branch, row.values['theta2'])
            text = change(deck.program.listing(deck, 'limits', '--branch=' + branch, '--plot-at=' + row.values['theta2'] + ' ' + deck.unit('angle')))
            listing = Listing(text, cmath.exp(-1j * deck.turn))
            if not checks.that(len(listing.panels) == 2, 'panels', len(listing.panels)):
                continue
            whole, instant = listing.panels
            side = 1 if branch == 'open' else -1
            if whole.title.endswith(': limits of link 4') and not deck.slot:
                check_swing(checks, deck, whole, side)
            elif whole.title.endswith(': dead centres'):
                check_stroke(checks, deck, whole, side)
            elif whole.title.endswith(': dead positions'):
                check_dead(checks, deck, whole)
            position = deck.at(row)
            drawn += check_centres(checks, deck, instant, row)
            check_transmission(checks, deck, instant, row, position)
    checks.that(drawn > 2, 'centres are drawn', deck.name, drawn)


def farther(pattern):
    """Change the first number behind a pattern by a little."""
    return lambda text: re.sub(pattern + r'(-?[0-9.]+)', lambda m: m.group(0)[:-len(m.group(m.lastindex))] + '%.7g' % (1.02 * float(m.group(m.lastindex)) + 0.1),
                               text, count=1)


def main(fourlink, data, decks):
    checks = Checks()
    with tempfile.TemporaryDirectory() as folder:
        program = Program(fourlink, folder)
        paths = [os.path.join(data, name) for name in ('alvi-5.1.deck', 'khurmi-5.1.deck', 'norton-3-2.deck')]
        for name, text in (('double-rocker.deck', DOUBLE_ROCKER), ('press.deck', SPRINGLESS)):
            paths.append(os.path.join(folder, name))
            with open(paths[-1], 'w', encoding='utf-8') as out:
                out.write(text)
        for path in paths:
            check_deck(checks, Deck(program, path))
        # each of these is seen
        head = r'arrow result \S+ \S+ '
        for path, change in ((paths[0], farther(head)), (paths[4], farther(head)), (paths[3], farther(r'line coupler \S+ \S+ ')),
                             (paths[0], lambda text: re.sub(r'((?:disc|quarter) black )(\S+)', lambda m: '%s%.7g' % (m[1], float(m[2]) * 1.0005 + 1e-6), text)),
                             (paths[1], farther(r'I₁₃ = \('))):
            wrong = Checks(most=0)
            check_deck(wrong, Deck(program, path), change)
            checks.where = os.path.basename(path)
            checks.that(wrong.failed > 0, 'a changed listing is found wrong')
    return checks.finish()


if __name__ == '__main__':
    sys.exit(main(*sys.argv[1:]))
