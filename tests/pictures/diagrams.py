# SPDX-License-Identifier: GPL-3.0-or-later
#
# diagrams.py FOURLINK DATA DECKS - the numbers of diagrams, from their items: each row of the table is on its curve,
# extremes, areas and bins are computed again from the drawn or printed numbers, and texts keep away from curves.
import csv
import io
import math
import os
import re
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
from linkage import Checks, Deck, Program, si_of  # noqa: E402
from panels import Listing, axis_of, plain  # noqa: E402

checks = Checks()
STEPS = 720
LETTER, LINE = 9, 18  # pixels of a text


def fine_table(deck, *options):
    """The rows at the samples of a curve, by branch."""
    unit = si_of(deck.units.get('motion.to', 'deg'))
    span = abs(deck.number('motion.to', 360) - deck.number('motion.from')) if 'motion.turns' not in deck.inputs else \
        deck.number('motion.turns') * 2 * math.pi / unit
    return deck.table('--interval=%.17g %s' % (abs(span) / STEPS, deck.units.get('motion.to', 'deg')), '--branch=both', *options)


def turn_of(deck, name):
    unit = deck.columns.get(name, '')
    return 2 * math.pi / si_of(unit) if unit in ('deg', 'rad') and name != 'theta2' else 0


def pieces(points):
    found = [[]]
    for p in points:
        if p is None:
            found.append([])
        else:
            found[-1].append(p)
    return [piece for piece in found if piece]


def distance(at, p, q):
    """Of a place from the line between two others."""
    way = q - p
    part = min(1, max(0, ((at - p) * way.conjugate()).real / abs(way) ** 2)) if way else 0
    return abs(at - p - part * way)


NEAR = 0.06  # pixels: a curve leaves out points that are closer to its straight lines


def sound_rows(deck, rows, name):
    return [row for row in rows if row.is_ok and name in row and row['mu'] * si_of(deck.unit('angle')) >= 1e-3]


def lines_of(points):
    return [(p, q) for piece in pieces(points) for p, q in zip(piece, piece[1:])]


def off_curve(deck, pixels, points, rows, name, over='theta2'):
    """How many rows have no curve, and the distance of the worst from it, in pixels, with its place."""
    turn = turn_of(deck, name)
    lines = sorted(lines_of(points), key=lambda line: min(line[0].real, line[1].real))
    missing, worst, at = 0, 0.0, None
    for row in sound_rows(deck, rows, name):
        x, y = row[over], row[name]
        if not turn and not 1 < pixels.at(complex(x, y)).imag < pixels.height - 1:
            continue  # beyond the frame
        slack = 0.02 / abs(pixels.kx)
        own = [(p, q) for p, q in lines if min(p.real, q.real) - slack <= x <= max(p.real, q.real) + slack]
        if not own:
            missing += 1
            continue
        off = []
        for p, q in own:
            shift = turn * round((p.imag - y) / turn) if turn else 0
            off.append(distance(pixels.at(complex(x, y + shift)), pixels.at(p), pixels.at(q)))
        if min(off) > worst:
            worst, at = min(off), x
    return missing, worst, at


def check_curve(deck, pixels, points, rows, name, over='theta2'):
    """Each row with a position is on the curve, to NEAR pixels, and its corners are rows; an angle goes on without steps."""
    turn = turn_of(deck, name)
    sound = sound_rows(deck, rows, name)
    for p, q in lines_of(points):
        checks.that(not turn or abs(q.imag - p.imag) < 0.3 * turn, 'a step of', name, p, q)
    missing, worst, at = off_curve(deck, pixels, points, rows, name, over)
    checks.that(missing <= 2, 'rows of', name, 'without a curve', missing)
    checks.that(worst <= NEAR, 'the curve of', name, 'at', at, 'is off by', worst, 'pixels')
    first, last = min(row[over] for row in sound), max(row[over] for row in sound)
    beyond = [p for p in points if p is not None and not first - 1e-3 <= p.real <= last + 1e-3]
    checks.that(not beyond, 'points of', name, 'where there is no row', beyond[:3])
    # a gap in the rows is a gap in the curve
    gaps = sum(1 for a, b in zip(rows, rows[1:]) if a.is_ok != b.is_ok)
    checks.that(len(pieces(points)) >= (gaps + 1) // 2, 'gaps of', name, gaps, len(pieces(points)))
    if turn and rows[0].is_ok and rows[-1].is_ok and gaps and abs(rows[-1]['theta2'] - rows[0]['theta2']) * si_of(deck.unit('angle')) > 6.283:
        drawn = [p for p in points if p is not None]
        checks.near('both ends of %s, of one position, behind a gap' % name, drawn[-1].imag, drawn[0].imag, turn, 1e-3)


class Pixels:
    """Places of a panel in pixels."""

    def __init__(self, panel):
        x, y = panel.range['x'], panel.range['y']
        self.width, self.height = panel.width, panel.height
        self.x0, self.y0 = x[0], y[0]
        self.kx, self.ky = self.width / (x[1] - x[0]), self.height / (y[1] - y[0])

    def at(self, p):
        return complex((p.real - self.x0) * self.kx, (p.imag - self.y0) * self.ky)


def box_of(at, words):
    half = LETTER * len(words) / 2
    return (at.real - half, at.real + half, at.imag - LINE / 2, at.imag + LINE / 2)


def crosses(box, p, q):
    """Liang and Barsky: a line crosses a box."""
    first, last = 0.0, 1.0
    for start, way, low, high in ((p.real, q.real - p.real, box[0], box[1]), (p.imag, q.imag - p.imag, box[2], box[3])):
        if way == 0:
            if not low < start < high:
                return False
            continue
        a, b = sorted(((low - start) / way, (high - start) / way))
        first, last = max(first, a), min(last, b)
    return first < last


def check_texts(panel, of_extremes):
    """Texts are within the axes and on no other; numbers of extremes cover no curve."""
    pixels = Pixels(panel)
    texts = [(words, pixels.at(at), rest) for words, at, side, rest in panel.labels if at is not None and words]
    boxes = [box_of(at, words) for words, at, rest in texts]
    for k, (a, (words, at, rest)) in enumerate(zip(boxes, texts)):
        checks.that(a[0] > -1 and a[1] < pixels.width + 1 and a[2] > -1 and a[3] < pixels.height + 1, 'the text', words, 'is within the axes')
        for b, other in zip(boxes[:k], texts):
            checks.that(min(a[1], b[1]) - max(a[0], b[0]) <= 0.1 or min(a[3], b[3]) - max(a[2], b[2]) <= 0.1, 'texts on each other', words, other[0])
        if of_extremes and rest.startswith('curve'):
            small = (a[0] + 0.5, a[1] - 0.5, a[2] + 0.5, a[3] - 0.5)
            for block, points in panel.blocks.items():
                for piece in pieces(points):
                    drawn = [pixels.at(p) for p in piece]
                    if any(crosses(small, p, q) for p, q in zip(drawn, drawn[1:])):
                        checks.that(False, 'the text', words, 'covers a curve of', panel.titles.get('y'))
                        break


def extremes_of(deck):
    """(NAME, BRANCH) -> value and angle, of the summary."""
    found = {}
    for row in csv.DictReader(io.StringIO(deck.program.run('--summary', '-f', 'csv', '--columns=all', '--branch=both', deck.path))):
        if re.match(r'(max|min)\(', row['name']) and row['theta2'] and row['value'] not in ('inf', '-inf'):
            found[row['name'], row['branch']] = float(row['value']), float(row['theta2'])
    return found


def check_extremes(panel, deck, name, branches, extremes):
    """A dot on each extreme, and its number."""
    turn = turn_of(deck, name)
    pixels = Pixels(panel)
    y = panel.range['y']
    dots = [at for at, kind in panel.dots if kind == 'black']
    numbers = [words for words, at, side, rest in panel.labels if at is not None and rest.startswith('curve')]
    values = [p.imag for points in panel.blocks.values() for p in points if p is not None]
    size = max(abs(v) for v in values)
    for branch in branches:
        both = [extremes.get(('%s(%s)' % (f, name), branch)) for f in ('max', 'min')]
        for k, (extreme, angle) in enumerate(x for x in both if x):
            if not y[0] < extreme < y[1] and not turn or k and abs(extreme - both[0][0]) < 1e-8 * size:
                continue
            near = [at for at in dots if abs(math.remainder(at.real - angle, 360)) < 1e-3 / abs(pixels.kx) + 1e-4]
            fits = [at for at in near if abs(math.remainder(at.imag - extreme, turn) if turn else at.imag - extreme) < 1e-3 / pixels.ky]
            if checks.that(fits, 'the dot of an extreme of', name, branch, angle, extreme, dots):
                shown = [words for words in numbers if abs(float(words) - fits[0].imag) <= 6e-4 * abs(fits[0].imag) + 1e-3 / pixels.ky]
                checks.that(shown or len(numbers) < len(dots), 'the number of an extreme of', name, fits[0], numbers)
    for at in dots:
        off = [distance(pixels.at(at), pixels.at(p), pixels.at(q)) for points in panel.blocks.values() for piece in pieces(points)
               for p, q in zip(piece, piece[1:])]
        checks.that(min(off) < 5, 'a dot on its curve', at, min(off))
    for words, at, side, rest in panel.labels:
        if at is not None and rest.startswith('curve'):
            checks.that(any(abs(float(words) - dot.imag) <= 6e-4 * abs(dot.imag) + 1e-3 / pixels.ky for dot in dots), 'a number of a dot', words)


def check_range(panel, name):
    """The y axis has all of the curve, and little more, unless it is cut."""
    if 'beyond the frame' in panel.title:
        return
    values = [p.imag for points in panel.blocks.values() for p in points if p is not None]
    low, high = panel.range['y']
    span = max(values) - min(values)
    checks.that((low < min(values) or low == 0) and max(values) < high, 'the range of', name, low, high)
    checks.that(high - low <= 1.7 * span or span <= 1e-8 * max(abs(v) for v in values) + 1e-300, 'a range of', name, 'that fits', low, high, span)


def check_over_angle(deck, rows, kind, extremes):
    text = deck.program.listing(deck, kind, '--branch=both')
    if not text:
        return
    listing = Listing(text)
    for panel in listing.panels:
        names = []
        for block, title in panel.curves():
            match = re.fullmatch(r'(\w+)_(open|crossed)', block)
            if not match:
                continue
            name, branch = match.groups()
            names.append((name, branch))
            if name in deck.columns and branch in rows:
                checks.where = '%s, %s of %s, %s' % (deck.name, kind, name, branch)
                check_curve(deck, Pixels(panel), panel.blocks[block], rows[branch], name)
                checks.that(plain(title) in (branch, name), 'the title of a curve', title)
                unit = deck.columns[name]
                checks.that(axis_of(panel.titles['y'])[1] == unit and axis_of(panel.titles['x'])[0] == 'theta2', 'the axes', panel.titles)
        if names:
            check_range(panel, names[0][0])
            check_texts(panel, True)
            if kind == 'motion' and extremes is not None:
                check_extremes(panel, deck, names[0][0], [branch for name, branch in names], extremes)


def both_of(deck):
    is_one = deck.yoke or re.search(r'^ *input *=', deck.text, re.M)  # with an input the branches have ranges of their own
    return [] if is_one else ['--branch=both']  # a yoke has one


def columns_of(deck, names):
    """The curves of columns: panel, column, branch, points."""
    for panel in Listing(deck.program.listing(deck, 'columns', *both_of(deck), '--columns=' + ','.join(names))).panels:
        for block, _ in panel.curves():
            name, branch = re.fullmatch(r'(\w+)_(open|crossed)', block).groups()
            yield panel, [n for n in names if re.sub(r'\W', '_', n) == name][0], branch, panel.blocks[block]


def check_columns(deck, rows, names):
    panels = {}
    for panel, name, branch, points in columns_of(deck, names):
        checks.where = '%s, columns, %s, %s' % (deck.name, name, branch)
        check_curve(deck, Pixels(panel), points, rows[branch], name)
        panels[id(panel)] = panel
    for panel in panels.values():
        check_texts(panel, True)


def check_over_column(deck, x, y, is_to_scale):
    """A column over another: both ranges fit, with a handful of numbers; two lengths have one scale."""
    checks.where = '%s, %s over %s' % (deck.name, y, x)
    listing = Listing(deck.program.listing(deck, 'columns', '--branch=both', '--columns=' + y, '--plot-x=' + x))
    panel = listing.panels[0]
    points = [p for block in panel.blocks.values() for p in block if p is not None]
    fits = []
    for axis, values in (('x', [p.real for p in points]), ('y', [p.imag for p in points])):
        low, high = panel.range[axis]
        checks.that(low < min(values) and max(values) < high, 'all is within the axes', axis, low, high)
        fits.append((high - low) / (max(values) - min(values)))
    checks.that(min(fits) < 1.7 and (is_to_scale or max(fits) < 1.7), 'the ranges fit', fits)
    width = panel.range['x'][1] - panel.range['x'][0]
    checks.that(2 < width / panel.step['x'] < 20, 'numbers at the x axis', width, panel.step)
    pixels = Pixels(panel)
    checks.that(not is_to_scale or abs(pixels.kx / pixels.ky - 1) < 1e-3, 'one scale', pixels.kx, pixels.ky)


def check_polar(deck, rows):
    text = deck.program.listing(deck, 'polar', '--branch=both')
    listing = Listing(text)
    for panel in listing.panels:
        titles = [axis_of(panel.titles[axis])[0] for axis in 'xy']
        for branch in ('open', 'crossed'):
            block = '%s_%s' % (plain(panel.title.split(',')[0]), branch)
            if block not in panel.blocks:
                continue
            checks.where = '%s, polar, %s' % (deck.name, block)
            points = [p for p in panel.blocks[block] if p is not None]
            wanted = [row.vector('', titles[0], titles[1]) for row in rows[branch]
                      if row.is_ok and row['mu'] * si_of(deck.unit('angle')) >= 1e-3]
            size = max(abs(p) for p in wanted)
            pixels = Pixels(panel)
            lines = [(pixels.at(p), pixels.at(q)) for piece in pieces(panel.blocks[block]) for p, q in zip(piece, piece[1:])]
            frame = panel.range['x'] + panel.range['y']
            k = 0
            for p in wanted:  # in their order; the ends of jumps stand between them
                if not (frame[0] < p.real < frame[1] and frame[2] < p.imag < frame[3]):
                    continue
                while k < len(lines) and distance(pixels.at(p), *lines[k]) > NEAR:
                    k += 1
            checks.that(k < len(lines), 'points of the table in their order', titles)
            dots = [at for at, kind in panel.dots if kind == 'black']
            round_ones = [row.vector('', titles[0], titles[1]) for row in rows[branch] if row.is_ok and abs(math.remainder(row['theta2'], 30)) < 1e-6]
            checks.that(all(any(abs(a - b) < 1e-5 * size for a in dots) for b in round_ones), 'dots 30 deg apart', len(dots), len(round_ones))
            jumps = panel.blocks.get(block.replace('_' + branch, '_jumps'), []) if branch == 'open' else []
            # a load that begins or ends is a jump: its ends are on the curve, with most of the step between two samples
            for k in range(0, len(jumps) - 1, 3):
                p, q = jumps[k:k + 2]
                checks.that(all(min(abs(end - x) for x in points) < 1e-4 * size for end in (p, q)), 'the ends of a jump are on the curve', p, q)
                before, after = min(zip(wanted, wanted[1:]), key=lambda step: abs(step[0] - p) + abs(step[1] - q))
                checks.near('the size of a jump', q - p, after - before, abs(after - before), 0.5)
                checks.that(abs(p - before) > 1e-7 * size or abs(q - after) > 1e-7 * size, 'a jump has its own ends', p, q)
            if 'crushing' in deck.text and block.startswith(('F34', 'F14')):
                checks.that(len(jumps) == 5 or branch != 'open', 'two jumps of the load', block)
        size = panel.range['x'][1] - panel.range['x'][0]
        for line in panel.lines:  # in the direction of the motion
            on = [points for name, points in panel.blocks.items() if not name.endswith(('_dots', '_jumps'))
                  if any(p is not None and q is not None and distance(line.start, p, q) + distance(line.end, p, q) < 1e-3 * abs(q - p) + 1e-3 * size
                         and ((q - p) * line.vector.conjugate()).real > 0 for p, q in zip(points, points[1:]))]
            checks.that(on, 'an arrow from a point of the curve to the next', line.start, line.end)
        x, y = panel.range['x'], panel.range['y']
        width, height = panel.width, panel.height
        checks.near('equal scales', (x[1] - x[0]) / width, (y[1] - y[0]) / height, (x[1] - x[0]) / width, 1e-3)
        check_texts(panel, False)


def check_turning(deck, rows):
    """The energies are the areas of the drawn curve above and below its mean; they add up to E max and E min."""
    text = deck.program.listing(deck, 'turning-moment', '--branch=both')
    listing = Listing(text)
    for panel in listing.panels:
        block = [name for name in panel.blocks if name.startswith('turning_')][0]
        branch = block[8:]
        checks.where = '%s, turning moment, %s' % (deck.name, branch)
        points = [p for p in panel.blocks[block] if p is not None]
        sense = -1 if rows[branch][0]['omega2'] < 0 else 1
        unit = si_of(deck.unit('angle'))
        cycle = points[-1].real
        moments = {round(abs(row['theta2']), 5): -sense * row['Ts'] for row in rows[branch] if row.is_ok}
        size = max(abs(m) for m in moments.values())
        pixels = Pixels(panel)
        lines = list(zip(points, points[1:]))
        for at, moment in moments.items():
            off = min(distance(pixels.at(complex(at, moment)), pixels.at(p), pixels.at(q)) for p, q in lines
                      if p.real - 0.01 <= at <= q.real + 0.01)
            checks.that(off <= NEAR, 'the moment at', at, 'is off by', off, 'pixels')
        checks.that(abs(cycle * unit - 2 * math.pi * (2 if '720' in deck.text else 1)) < 1e-3, 'a whole cycle', cycle)
        step = cycle / STEPS
        points = []  # at even steps again
        k = 0
        for i in range(STEPS + 1):
            while k < len(lines) - 1 and lines[k][1].real < i * step:
                k += 1
            p, q = lines[k]
            part = (i * step - p.real) / (q.real - p.real)
            points.append(complex(i * step, p.imag + part * (q.imag - p.imag)))
        mean = sum((p.imag + q.imag) / 2 for p, q in zip(points, points[1:])) / STEPS
        checks.near('the mean', panel.mean, mean, size, 2e-3)
        to_joule = unit * si_of(deck.unit('torque'))
        # areas between crossings of the mean; the first and the last belong together only at the ends of the cycle
        energy, areas, start = 0.0, [], 0
        for k, (p, q) in enumerate(zip(points, points[1:])):
            u, v = p.imag - panel.mean, q.imag - panel.mean
            if u * v < 0:
                t = u / (u - v)
                energy += u * t / 2 * step
                areas.append((energy * to_joule, p.real + t * step))
                energy = v * (1 - t) / 2 * step
            else:
                energy += (u + v) / 2 * step
        areas.append((energy * to_joule, cycle))
        path, lowest, highest, total = 0.0, (0.0, 0.0), (0.0, 0.0), 0.0
        for area, end in areas:
            total += area
            highest, lowest = max(highest, (total, end)), min(lowest, (total, end))
        fluctuation = highest[0] - lowest[0]
        title = re.match(r'%s: mean = (\S+) \S+, ΔE = (\S+) (\S+)' % branch, panel.title)
        if not checks.that(title, 'the title', panel.title):
            continue
        prefix = {'J': 1, 'kJ': 1e3, 'MJ': 1e6, 'mJ': 1e-3, '\u00b5J': 1e-6, 'nJ': 1e-9}
        checks.near('the mean in the title', float(title.group(1)) * (1e3 if 'kN' in panel.title.split(',')[0] and 'kN' not in deck.unit('torque') else 1),
                    panel.mean, size, 1e-4)
        if title.group(3) in prefix:
            checks.near('the fluctuation', float(title.group(2)) * prefix[title.group(3)], fluctuation, fluctuation + 1e-12, 1e-2)
        shown = []
        for words, at, side, rest in panel.labels:
            match = re.fullmatch(r'(-?[0-9.e+-]+) (\S+)', words)
            if match and match.group(2) in prefix:
                shown.append(float(match.group(1)) * prefix[match.group(2)])
        own = [area for area, end in areas]
        for value in shown:
            checks.that(any(abs(value - area) < 0.01 * fluctuation + 0.01 * abs(area) for area in own) or
                        abs(value - own[0] - own[-1]) < 0.01 * fluctuation, 'the area of', value, own)
        checks.that(len(shown) >= 1 or fluctuation < 1e-9, 'an area has its energy')
        checks.that(len([a for a in own if abs(a) > 0.025 * fluctuation]) - len(shown) <= 1, 'energies', shown, own)
        if len(areas) >= 2 and panel.marks:
            for name, (value, at) in (('E max', highest), ('E min', lowest)):
                checks.that(any(abs(math.remainder(mark - at, cycle)) < 1.5 * step for mark in panel.marks), name, 'at', at, panel.marks)
                notes = [note for note in panel.notes if note.startswith(name + ' at ')]
                checks.that(notes and abs(math.remainder(float(re.match(r'[-0-9.e+]+', notes[0][9:]).group(0).rstrip('e')) - at, cycle)) < 1.5 * step,
                            'the note of', name, notes, at)
        check_texts(panel, False)


def check_speed(deck, rows):
    listing = Listing(deck.program.listing(deck, 'speed', '--branch=open'))
    for panel in listing.panels:
        for block, points in panel.blocks.items():
            name = block[:-5]
            over = axis_of(panel.titles['x'])[0]
            checks.where = '%s, speed, %s over %s' % (deck.name, name, over)
            points = [p for p in points if p is not None]
            wanted = [complex(row[over], row[name]) for row in rows['open'] if row.is_ok]
            pixels = Pixels(panel)
            lines = [(pixels.at(p), pixels.at(q)) for p, q in zip(points, points[1:])]
            off = [min(distance(pixels.at(p), a, b) for a, b in lines) for p in wanted]
            checks.that(max(off) <= NEAR, 'points of the table', max(off))


TWO_RANGES = """mechanism = four-bar
[ground]
length = 9.5 m
[crank]
length = 8.4 m
[coupler]
length = 2 m
[rocker]
length = 9.5 m
[motion]
speed = 1 rad/s
from = -90 deg
to = 270 deg
interval = 10 deg
"""


def check_two_ranges(program, folder):
    """The crank moves in two ranges; with the samples of the second an angle does not follow those of the first."""
    path = os.path.join(folder, 'two-ranges.deck')
    with open(path, 'w', encoding='utf-8') as out:
        out.write(TWO_RANGES)
    own = Deck(program, path)
    check_over_angle(own, fine_table(own), 'motion', None)


def main(fourlink, data, decks):
    with tempfile.TemporaryDirectory() as folder:
        program = Program(fourlink, folder)

        def deck(name):
            return Deck(program, os.path.join(decks if os.path.exists(os.path.join(decks, name)) else data, name))
        for name in ('coupler-point.deck', 'engine.deck', 'oscillating-cylinder.deck', 'me3491-exercise-4.deck', 'reach.deck',
                     'whitworth-150-100.deck', 'rubbing-piston.deck', 'me3491-exercise-1.deck'):
            own = deck(name)
            rows = fine_table(own)
            extremes = extremes_of(own)
            check_over_angle(own, rows, 'motion', extremes)
            if 'F12x' in rows['open'][0].values:
                check_over_angle(own, rows, 'forces', None)
                if own.number('motion.from') == 0 and 'motion.acceleration' not in own.inputs:
                    check_turning(own, rows)
                if own.number('motion.from') == 0:
                    check_polar(own, rows)
        own = deck('coupler-point.deck')
        check_columns(own, fine_table(own), ['theta2', 'theta3', 'P.x', 'Ts', 'F12', 'F14'][1:])
        check_over_column(own, 'P.x', 'P.y', True)
        check_over_column(own, 'theta4', 'P.y', False)
        check_over_column(own, 'omega4', 'Ts', False)
        own = deck('reach.deck')
        check_columns(own, fine_table(own), ['theta3', 'theta4', 'omega4', 'mu'])
        own = deck('gerstmayr-run-up.deck')
        check_speed(own, fine_table(own))
        check_two_ranges(program, folder)
    return checks.finish()


if __name__ == '__main__':
    sys.exit(main(*sys.argv[1:4]))
