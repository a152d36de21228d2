# SPDX-License-Identifier: GPL-3.0-or-later
#
# drawn.py FOURLINK FOLDER... - the mechanics of what is drawn: of each deck, on both branches, at a dozen crank angles.
#
# It reads the pictures `mechanism`, `vectors` and `klein` (items.awk).  Places come from lengths and crank
# angle (linkage.py), forces from the table; what is drawn has to agree with them, polygons to close, and each free body
# to be in equilibrium.
import cmath
import math
import os
import re
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
from linkage import Checks, Deck, Program, cross, crossing, decks_of, dot, foot, si_of  # noqa: E402
from panels import Listing, plain  # noqa: E402

# Styles of lines
GROUND, CRANK, COUPLER, FOLLOWER, PIN_FORCE, LOAD = 'ground', 'crank', 'coupler', 'follower', 'force', 'load'
OF_LINK = ['', GROUND, CRANK, COUPLER, FOLLOWER]
THIN, RESULT, OTHER, GHOST, LEADER, SENSE = 'construction', 'result', 'other', 'ghost', 'leader', 'sense'
GHOSTS = 12
ANGLES = 12
PREFIXES = {'': 1, 'n': 1e-9, '\u00b5': 1e-6, 'm': 1e-3, 'k': 1e3, 'M': 1e6, 'G': 1e9}

checks = Checks()


def value_of(words, unit):
    """The number of "12.3 kN" in the unit N; None if it is no such quantity."""
    match = re.fullmatch(r'(-?[0-9.e+-]+) (\S+)', words or '')
    if not match or not plain(match.group(2)).endswith(unit):
        return None
    prefix = plain(match.group(2))[:-len(unit)]
    return float(match.group(1)) * PREFIXES[prefix] if prefix in PREFIXES else None


def entries(panel, unit):
    """(NAME, VALUE) of the notes of this unit beside a drawing, in their order."""
    found = []
    for note in panel.notes:
        name, equals, words = note.rpartition(' = ')
        value = value_of(words, unit) if equals else None
        if value is not None:
            found.append((name, value))
    return found


def extent(panel):
    """The size of a drawing, by which it is compared."""
    places = [p for line in panel.lines for p in (line.start, line.end)] + [d[0] for d in panel.discs]
    return max([abs(p) for p in places] + [1e-300])


def has_line(panel, what, p, q, style, size):
    near = 1e-5 * size
    checks.that(any(line.style == style and ((abs(line.start - p) < near and abs(line.end - q) < near) or
                                             (abs(line.start - q) < near and abs(line.end - p) < near)) for line in panel.lines),
                what, 'from', p, 'to', q, 'in', panel.title)


def has_disc(panel, what, at, size, colour=None, quarters=False):
    checks.that(any(abs(disc[0] - at) < 1e-5 * size and disc[2] == quarters and colour in (None, disc[3]) for disc in panel.discs),
                what, 'at', at, 'in', panel.title)


def in_book(name):
    """The driving torque as pictures name it."""
    return 'Tₛ' if name == 'Ts' else name


def short(name, most=16):
    """A long name as it stands beside its point."""
    return name if len(name) <= most else name[:most - 1] + '…'


def has_label(panel, words):
    checks.that(any(label[0] == words for label in panel.labels), 'the letter', words, 'in', panel.title)


def boxes(panel, style):
    """The rectangles of this style: (middle, half of its first side, half of its second side)."""
    lines = [line for line in panel.lines if line.style == style and not line.is_arrow]
    found = []
    for k in range(len(lines) - 3):
        four = lines[k:k + 4]
        if all(abs(four[j].end - four[(j + 1) % 4].start) < 1e-6 * (abs(four[0].vector) + abs(four[1].vector)) for j in range(4)) and \
                abs(four[0].vector + four[2].vector) < 3e-5 * abs(four[0].vector) + 3e-6 * abs(four[0].start):
            found.append(((four[0].start + four[1].end) / 2, four[0].vector / 2, four[1].vector / 2))
    return found


# ------------------------------------------------------------------------------------------- the mechanism


def check_block(panel, what, style, at, axis, size):
    """A piston or a slider: a rectangle around its pin, along its axis, longer than it is wide."""
    mine = [box for box in boxes(panel, style) if abs(box[0] - at) < 1e-5 * size]
    if not checks.that(mine, what, 'at', at, 'in', panel.title):
        return 0
    along, across = min(mine, key=lambda box: abs(cross(box[1], axis)) / abs(box[1]))[1:]  # a slot may be around it
    checks.near('axis of the ' + what, cross(along, axis), 0, 2e-5 * abs(along) + 1e-6 * size, 1)
    checks.near('corners of the ' + what, dot(along, across) / abs(across), 0, 2e-5 * abs(along) + 1e-5 * size, 1)
    checks.that(1.2 * abs(across) < abs(along) < 2 * abs(across), 'sides of the', what)
    return abs(along)


def check_lever(panel, deck, position, half, size):
    """A slotted lever: its arm from D to the slot, which the slider needs from one end of its way to the other."""
    near, far = deck.slide_range(position.side if not deck.has_change_point() else 1)
    u = position.axis[3]
    own_foot = position.D + 1j * deck.offset_of_slide() * u  # of the perpendicular from D on the slide
    slots = [box for box in boxes(panel, FOLLOWER) if abs(cross(box[0] - own_foot, u)) < 1e-5 * size]
    if not checks.that(slots, 'the slot in', panel.title):
        return
    middle, along, across = slots[0]
    margin = 1.5 * half
    checks.near('middle of the slot', dot(middle - own_foot, u), (near + far) / 2, size, 5e-6)
    checks.near('length of the slot', abs(along), (far - near) / 2 + margin, size, 5e-6)
    checks.near('width of the slot', abs(across), 7 / 11 * half, size, 5e-6)
    checks.near('direction of the slot', cross(along, u) / abs(along), 0, 1, 2e-5)
    root = position.end if deck.length(4) else own_foot
    checks.near('the arm ends on the slide', cross(root - own_foot, u), 0, size, 1e-9)
    if abs(root - position.D) > 1e-6 * size:
        has_line(panel, 'the arm of the lever', position.D, root, FOLLOWER, size)
    coordinate = dot(root - own_foot, u)
    if coordinate < near - margin - 1e-6 * size or coordinate > far + margin + 1e-6 * size:
        end = near - margin if coordinate < near else far + margin
        has_line(panel, 'the arm goes on to the slot', root, own_foot + end * u, FOLLOWER, size)


def check_guide(panel, deck, position, half, size):
    """Two lines along the stroke of a piston, which is between them; both ends of its stroke are within them."""
    e, side = 1j * deck.number('ground.offset'), position.label
    lines = [line for line in panel.lines if line.style == GROUND and abs(line.vector.imag) < 1e-6 * size and
             abs(abs((line.start - e).imag) - 7 / 11 * half) < 1e-5 * size]
    if not checks.that(len(lines) == 2, 'two lines of the guide in', panel.title, len(lines)):
        return
    far = deck.dead_centre() + 1.5 * half
    near = deck.nearest() - 1.5 * half
    for line in lines:
        ends = sorted((line.start.real, line.end.real))
        checks.near('first end of the guide', ends[0], near if side > 0 else -far, size)
        checks.near('last end of the guide', ends[1], far if side > 0 else -near, size)
        checks.that(ends[0] < position.C.real - half < position.C.real + half < ends[1],
                    'the piston is in its guide', ends, position.C.real, half)
    checks.near('the piston is between the lines', (lines[0].start + lines[1].start).imag / 2, e.imag, size)


def check_angle(panel, name, at, theta, angle_unit, size):
    """An arc from the x axis to the direction of a link, and its value beside the drawing."""
    rays = [line for line in panel.lines if line.style == THIN and abs(line.start - at) < 1e-5 * size and
            abs(line.vector.imag) < 1e-5 * size and line.vector.real > 0]
    arcs = []
    for ray in rays:
        radius = abs(ray.vector) / 1.5
        arcs += [[line for line in panel.lines if line.style == THIN and not line.is_arrow and
                  abs(abs(line.start - at) - radius) < 1e-5 * size and abs(abs(line.end - at) - radius) < 1e-5 * size]]
    swept = [sum(cmath.phase((line.end - at) / (line.start - at)) for line in arc) for arc in arcs]
    limits = [{0.0}.union(cmath.phase((p - at) / abs(p - at)) for line in arc for p in (line.start, line.end)) for arc in arcs]
    # an arc is drawn counter-clockwise, from 0 to theta or from theta to 0
    fits = [abs(abs(theta) - total) < 1e-4 and any(abs(cmath.rect(1, theta) - cmath.rect(1, end)) < 1e-4 for end in ends)
            for total, ends in zip(swept, limits)]
    checks.that(any(fits), 'the arc of', name, theta, swept, 'in', panel.title)
    note = panel.note(name)
    printed = float(re.match(r'[-0-9.e+]+', note).group(0)) if note else None
    checks.near('value of ' + name, printed, theta / angle_unit, max(abs(theta / angle_unit), 1e-6), 6e-4)


def pin_between(position, link, other):
    """The pin of two links, at which a torsional spring acts on both."""
    return {(1, 2): position.A, (2, 3): position.B, (3, 4): position.C, (1, 4): position.D}.get(tuple(sorted((link, other))))


def check_springs(panel, deck, position, size):
    for name, spring in deck.springs().items():
        links = [deck.link_number(spring[key]) for key in ('link', 'to')]
        has_label(panel, name)
        dark = [line for line in panel.lines if line.style == GROUND]
        if 'stiffness' in spring and deck.units['spring %s.stiffness' % name].endswith('/rad') or \
                'damping' in spring and deck.units['spring %s.damping' % name].endswith('s/rad'):
            pin = pin_between(position, *links)
            if pin is None:
                continue
            chains = [[]]
            for line in dark:
                if chains[-1] and chains[-1][-1].end != line.start:
                    chains.append([])
                chains[-1].append(line)
            spiral = max((c for c in chains if abs(c[0].start - pin) < 0.4 * abs(c[-1].end - pin)), key=len, default=[])
            if not checks.that(len(spiral) >= 55, 'the spiral of', name, len(spiral), 'lines about', pin, 'in', panel.title):
                continue
            # from the direction of link `to` to that of `link`; the ground lies below
            ends = []
            for link in links:
                away = 1 if abs(position.origin[link] - pin) < 0.5 * deck.length(link) or link == 1 else -1
                ends.append(-1j if link == 1 else away * position.axis[link])
            outer = spiral[-1].end - pin
            turns = sum(cmath.phase((line.end - pin) / (line.start - pin)) for line in spiral)
            checks.near('the outer end of ' + name, outer / abs(outer), ends[0], 1, 1e-4)
            checks.near('the turns of ' + name, cmath.rect(1, turns), ends[0] / ends[1], 1, 1e-3)
            checks.that(4 * math.pi - 0.3 < turns < 6 * math.pi + 0.3, 'two turns of', name, turns)
        else:
            P, Q = (position.point(link, deck.vector('spring %s.%s' % (name, at))) for link, at in zip(links, ('at', 'to_at')))
            has_line(panel, 'the first end of ' + name, P, P + 0.2 * (Q - P), GROUND, size)
            has_line(panel, 'the last end of ' + name, Q, Q + 0.2 * (P - Q), GROUND, size)
            beside = [dot(p - P, Q - P) / abs(Q - P) ** 2 for line in dark for p in (line.start, line.end)
                      if abs(cross(p - P, Q - P)) < 0.08 * size * abs(Q - P)]
            checks.that(sum(0.2 < x < 0.8 for x in beside) >= 8, 'the coil or damper of', name)
            for link, end in zip(links, (P, Q)):
                if link != 1:
                    has_disc(panel, 'the end of ' + name, end, size, 'black')


def corners_of(points):
    """The corners of the convex hull, by the gift wrapping of R. A. Jarvis (1973): from a corner go on to that point to
    the right of which no other lies."""
    start = at = min(points, key=lambda p: (p.real, p.imag))
    found = []
    while True:
        found.append(at)
        others = [p for p in points if p != at]
        following = others[0]
        for p in others:
            side = cross(following - at, p - at)
            if side < 0 or side == 0 and abs(p - at) > abs(following - at):
                following = p
        at = following
        if at == start or len(found) > len(points):
            return found


def check_outlines(panel, deck, position, row, size):
    """A link with tracer points has the outline of its pins and points."""
    ends = {2: position.B, 3: position.B if deck.slot else position.C, 4: position.C}
    if deck.slot:
        ends[4] = position.end
    for link in (2, 3, 4):
        points = [row.vector(name + '.') for name, own in deck.points() if own == link]
        if not points:
            continue
        corners = corners_of(points + [position.origin[link], ends[link]])
        flat = len(corners) < 3 or abs(cross(corners[1] - corners[0], corners[2] - corners[0])) < 1e-9 * size ** 2
        for p, q in zip(corners, corners[1:] + corners[:1]) if not flat else ():
            has_line(panel, 'the outline of link %d' % link, p, q, OF_LINK[link], size)


def check_places(panel, deck, position, row, size, has_angles=True):
    """The links, pins, letters and centres of mass of a mechanism."""
    has_line(panel, 'the crank', position.A, position.B, CRANK, size)
    half = 0
    if deck.slot:
        half = check_block(panel, 'slider', COUPLER, position.B, position.axis[3], size)
        check_lever(panel, deck, position, half, size)
    else:
        has_line(panel, 'the coupler', position.B, position.C, COUPLER, size)
    if deck.slides:
        half = check_block(panel, 'piston', FOLLOWER, position.C, 1, size)
        check_guide(panel, deck, position, half, size)
    elif not deck.slot:
        has_line(panel, 'the rocker', position.D, position.C, FOLLOWER, size)
    for letter, at in (('A', position.A), ('B', position.B), ('C', position.C), ('D', position.D)):
        if letter == 'D' and deck.slides:
            continue
        if letter == 'C' and deck.yoke:
            has_label(panel, letter)
            continue
        has_disc(panel, 'pin ' + letter, at, size, 'white')
        if letter != 'C' or not deck.slot:
            has_label(panel, letter)
    for at in (position.A,) if deck.slides else (position.A, position.D):
        legs = [line for line in panel.lines if line.style == GROUND and abs(line.start - at) < 1e-5 * size and
                line.vector.imag < 0 and line.vector.real]
        checks.that(len(legs) == 2 and abs(legs[0].vector + legs[1].vector.conjugate()) < 4e-6 * size, 'the support at', at)
    centres = {link: position.point(link, deck.cg(link)) for link in (2, 3, 4) if deck.mass(link) > 0}
    for link, at in centres.items():
        has_disc(panel, 'centre of mass of link %d' % link, at, size, quarters=True)
    for at, _, is_quarter, _ in panel.discs:
        checks.that(not is_quarter or any(abs(at - one) < 1e-5 * size for one in centres.values()), 'no mass has its centre at', at)
    for name, link in deck.points():
        has_disc(panel, 'point ' + name, row.vector(name + '.'), size, 'black')
        has_label(panel, short(name))
    if has_angles:
        unit = si_of(deck.unit('angle'))
        check_angle(panel, 'θ₂', position.A, math.fmod(row['theta2'] * unit, 2 * math.pi), unit, size)
        if not deck.slot or deck.yoke or deck.number('lever.angle'):
            check_angle(panel, 'θ₃', position.C if deck.yoke else position.B, row['theta3'] * unit, unit, size)
        if not deck.slides:
            check_angle(panel, 'θ₄', position.D, row['theta4'] * unit, unit, size)
    check_sense(panel, position.A, row['omega2'] if 'omega2' in row else 0, size)
    check_springs(panel, deck, position, size)
    check_outlines(panel, deck, position, row, size)


def check_sense(panel, A, omega, size):
    """An arc about A with its head in the sense of the crank."""
    lines = [line for line in panel.lines if line.style == SENSE]
    heads = [line for line in lines if line.is_arrow]
    checks.that(len(heads) == (1 if omega else 0), 'one arrow of the sense of rotation', len(heads))
    for line in heads:
        checks.that(math.copysign(1, cross(line.start - A, line.vector)) == math.copysign(1, omega), 'the sense of rotation', omega)
        has_label(panel, 'ω₂')
    for line in lines:
        checks.near('its arc is about A', abs(line.end - A), abs(lines[0].end - A), size, 1e-5)


def check_numbers(panel, deck, position, back):
    """The number of a link stands close to it, closer than 40 pixels."""
    ends = {'2': (position.A, position.B), '3': (position.B, position.C), '4': (position.D, position.C)}
    scale = (panel.range['x'][1] - panel.range['x'][0]) / panel.width
    found = 0
    for words, at, side, rest in panel.labels:
        if words not in ends or at is None or deck.slot or deck.slides and words == '4':
            continue
        p, q = ends[words]
        at = at * back
        part = min(1, max(0, dot(at - p, q - p) / abs(q - p) ** 2))
        checks.that(abs(at - p - part * (q - p)) < 40 * scale, 'the number', words, 'is beside its link', at, p, q)
        found += 1
    return found


def check_insets(titles, deck, panel, size):
    """A crank, and a rocker, that is very short is drawn enlarged as well."""
    small = deck.length(2) < 0.03 * size
    checks.that(not small or 'at the crank, enlarged' in titles, 'an inset of a short crank', titles)
    checks.that(deck.length(2) < 0.2 * size or 'at the crank, enlarged' not in titles, 'no inset of a long crank', titles)


def check_inset_forces(panel, forces, deck):
    """An inset has the forces that act on its link, on one scale."""
    pin = 'AB' if 'crank' in panel.title else 'CD'
    lines = [line for line in split_arrows(panel, 1)[0] if line.is_arrow]
    found = [(line, x) for x in forces for line in lines if x.pin and x.pin in pin and abs(line.start - x.at) < 1e-5 * abs(line.vector)]
    largest = max(abs(x.force) for x in forces if x.pin and x.pin in pin)
    checks.that(len(found) >= len([x for x in forces if x.pin and x.pin in pin and abs(x.force) > 0.1 * largest]),
                'arrows of', panel.title, len(found))
    found = [(line, x) for line, x in found if abs(x.force) > 0.2 * largest]  # a smaller one may have no arrow
    alone = [(line, x) for line, x in found if len([y for _, y in found if y is x]) == 1]
    for x in dict.fromkeys(x for _, x in found if alone):
        scale = alone[0][0].vector / alone[0][1].force
        own = [line.vector / scale for line, y in found if y is x]  # where two forces act, the nearest
        checks.near(x.name + ' ' + panel.title, min(own, key=lambda F: abs(F - x.force)), x.force, largest, 2e-5)
        has_label(panel, x.name)


def check_labels(panel):
    """Names stand within the axes; the listing's reader does not turn them."""
    x, y = panel.range['x'], panel.range['y']
    for words, at, side, rest in panel.labels:
        if at is not None:
            checks.that(x[0] <= at.real <= x[1] and y[0] <= at.imag <= y[1], 'the label', words, 'is within the axes', at, x, y)


def check_frame(panel, drawn=None):
    """All that is drawn is within the axes, which have one scale and as many pixels as they have room."""
    x, y = panel.range['x'], panel.range['y']
    width, height = panel.width, panel.height
    slack = 1e-6 * max(map(abs, x + y))  # of seven digits
    checks.near('one scale in ' + panel.title, (x[1] - x[0]) / width, (y[1] - y[0]) / height, 1e-4 * (x[1] - x[0]) / width + slack / height, 1)
    for p in drawn:
        if not (x[0] - slack <= p.real <= x[1] + slack and y[0] - slack <= p.imag <= y[1] + slack):
            checks.that(False, 'beyond the frame of', panel.title, p, x, y)
            return
    checks.that(True)


# ----------------------------------------------------------------------------------------------- polygons


def check_sides(panel, unit, expected, size, is_chain=False):
    """The sides of a polygon: as many as notes, each with its value; `expected` are (name, start, vector) of each."""
    sides = [line for line in panel.lines if line.style not in (THIN, LEADER)]
    notes = entries(panel, unit)
    wanted = [x for x in expected if abs(x[2]) > 1e-12 * size]
    if size == 0:
        checks.that(any('zero' in label[0] for label in panel.labels), 'it is said that all is zero in', panel.title)
        return []
    found = []
    if not checks.that(len(sides) == len(notes) == len(wanted), 'sides of the', panel.title, len(sides), len(notes),
                       [x[0] for x in wanted]):
        return []
    for line, (name, value), (own_name, start, vector) in zip(sides, notes, wanted):
        checks.that(name == own_name, 'a side', name, 'in place of', own_name)
        checks.near('%s in the %s' % (name, panel.title), line.vector, vector, size, 3e-6)
        checks.near('the note of ' + name, value, abs(vector), max(abs(vector), 1e-9 * size), 1e-4)
        if start is not None:
            checks.near('the start of %s in the %s' % (name, panel.title), line.start, start, size, 5e-6)
        checks.that(line.is_arrow or abs(vector) < 0.0101 * size, name, 'has a head')
        if line.is_arrow:
            has_label(panel, name)
        found.append((name, line.vector))
    return found


def check_closing(panel, size, *ways):
    """Ways along sides from one corner to another: (names of a way, names of another)."""
    sums = {}
    sides = [line for line in panel.lines if line.style not in (THIN, LEADER)]
    for line, note in zip(sides, panel.notes):
        sums[note.rpartition(' = ')[0]] = line.vector
    for first, second in ways:
        checks.near('the %s closes' % panel.title, sum(sums.get(x, 0) for x in first), sum(sums.get(x, 0) for x in second), size, 5e-6)


def check_images(panel, deck, row, motion, prime, size):
    """Lines from the pole to the images of centres of mass and tracer points, with dots and letters."""
    if size == 0:
        return
    places = [('g%s%s' % (prime, '₂₃₄'[link - 2]), motion(link, deck.cg(link))) for link in (2, 3, 4) if deck.mass(link) > 0]
    for name, link in deck.points():
        kind = 'a' if prime else 'v'
        places.append((short(name, 9) + prime, row.vector('%s.%s' % (name, kind))))
    for letter, at in places:
        has_line(panel, 'the image ' + letter, 0, at, THIN, max(size, abs(at)))
        has_disc(panel, 'the image ' + letter, at, max(size, abs(at)), 'black')
        has_label(panel, letter)


def check_velocities(panel, deck, position, row):
    unit, k = deck.unit('speed'), deck.factor('speed', 'length')
    vB = k * position.velocity(3, 0)
    if deck.slot:
        vB4 = k * (position.velocity(4, 0) + 1j * position.omega[4] * (position.B - position.D))
        sides = [('vB', 0, vB), ('vB4', 0, vB4), ('vBB4', vB4, row['slide_v'] * position.axis[3])]
        ways, corners = (['vB'], ['vB4', 'vBB4']), ('o', 'b', 'b4')
    else:
        vC = k * position.velocity(3, deck.length(3))
        sides = [('vB', 0, vB), ('vC', 0, vC), ('vCB', vB, vC - vB)]
        ways, corners = (['vC'], ['vB', 'vCB']), ('o', 'b', 'c')
    size = max(abs(x[2]) for x in sides)
    check_sides(panel, unit, sides, size)
    check_closing(panel, size, ways)
    check_images(panel, deck, row, lambda link, at: k * position.velocity(link, at), '', size)
    for letter in corners if size else ():
        has_label(panel, letter)


def check_accelerations(panel, deck, position, row):
    unit, k = deck.unit('acceleration'), deck.factor('acceleration', 'length')

    def parts(link, r):  # -omega^2 r, alpha x r
        return -k * position.omega[link] ** 2 * r, k * 1j * position.alpha[link] * r
    aBn, aBt = parts(2, position.B)
    sides = [('aBn', 0, aBn), ('aBt', aBn, aBt)]
    aB = aBn + aBt
    if deck.yoke:
        aB4 = k * position.acceleration(4, 0)
        sides += [('aB4', 0, aB4), ('aBB4', aB4, row['slide_a'] * position.axis[3])]
        ways, corners = (['aBn', 'aBt'], ['aB4', 'aBB4']), ("o'", "b'", "b4'")
        lines = [(0, aB)]
    elif deck.slot:
        n, t = parts(4, position.B - position.D)
        u = position.axis[3]
        cor = 1j * u * row['coriolis']
        checks.near('the acceleration of Coriolis', row['coriolis'],
                    2 * k * position.omega[4] * position.slide_v, abs(aB) + abs(cor), 1e-9)
        sides += [('aB4n', 0, n), ('aB4t', n, t), ('aCor', n + t, cor), ('aBB4', n + t + cor, row['slide_a'] * u)]
        ways, corners = (['aBn', 'aBt'], ['aB4n', 'aB4t', 'aCor', 'aBB4']), ("o'", "b'", "b4'")
        lines = [(0, aB), (0, n + t)]
    else:
        n, t = parts(3, position.C - position.B)
        aC = k * position.acceleration(3, deck.length(3))
        sides += [('aCBn', aB, n), ('aCBt', aB + n, t)]
        own = ['aC'] if deck.slides else ['aCn', 'aCt']
        if deck.slides:
            sides.append(('aC', 0, aC))
        else:
            cn, ct = parts(4, position.C - position.D)
            sides += [('aCn', 0, cn), ('aCt', cn, ct)]
        ways, corners = (own, ['aBn', 'aBt', 'aCBn', 'aCBt']), ("o'", "b'", "c'")
        lines = [(0, aC), (aB, aC)]
    size = max(abs(x[2]) for x in sides)
    check_sides(panel, unit, sides, size)
    check_closing(panel, size, ways)
    check_images(panel, deck, row, lambda link, at: k * position.acceleration(link, at), "'", size)
    for p, q in lines if size else ():
        if abs(p - q) > 1e-9 * size:
            has_line(panel, 'the resultant', p, q, THIN, size)
    for letter in corners if size else ():
        has_label(panel, letter)


# ------------------------------------------------------------------------------------------------- forces


class Acting:
    """A force or a torque on a link: its vector or value, and its place."""

    def __init__(self, name, at, force=0j, torque=0.0, pin=None, kind=PIN_FORCE):
        self.name, self.at, self.force, self.torque, self.pin, self.kind = name, at, force, torque, pin, kind


def is_on(load, theta2, omega2):
    """Whether a load acts at a crank angle in degrees: within from and to, if it has them; at an edge, if the crank enters."""
    if 'from' not in load and 'to' not in load:
        return True
    start, end = float(load.get('from', 0)), float(load.get('to', 360))
    passed, all_of_it = (theta2 - start) % 360, (end - start) % 360
    return abs(end - start) >= 360 or (passed < all_of_it if omega2 >= 0 else 0 < passed <= all_of_it)


def is_torsional(deck, name):
    return any(deck.units.get('spring %s.%s' % (name, key), '').endswith('rad') for key in ('stiffness', 'damping'))


DRIVES = {'theta4': 'link 4', 'rocker': 'link 4', 'lever': 'link 4', 'x': 'link 4', 'C.x': 'link 4', 'piston': 'link 4', 'yoke': 'link 4',
          'slide': 'slide'}


def driving(deck, position, row, link, is_free):
    """What drives, if not the crank, on a link: a torque on link 4, a force along x on one that slides, the force that pushes the slider
    along the slide, or the force of an actuator, which pushes its ends apart; the last two are seen on a link cut free."""
    given = deck.text.split('[expect]')[0]
    word = {key: re.search(r'^%s\s*=\s*(\S+)' % key, given, re.M) for key in ('drive', 'input')}
    rams = re.findall(r'^\[actuator (.*)\]', deck.text, re.M)
    name = word['drive'].group(1) if word['drive'] else rams[0] if rams else word['input'].group(1) if word['input'] else 'crank'
    kind = DRIVES.get(name, name)
    if kind == 'link 4' and link == 4:
        if deck.slides:
            return [Acting('drive', position.C, row['drive'], kind=LOAD)]
        torque = Acting('drive', position.D, torque=row['drive'], kind=LOAD)
        torque.origin = position.D
        return [torque]
    if kind == 'slide' and link in (3, 4) and is_free:
        return [Acting('drive', position.B, row['drive'] * position.axis[3] * (1 if link == 3 else -1), kind=LOAD)]
    if name not in rams or not is_free:
        return []
    ends = [deck.link_number(deck.inputs['actuator %s.%s' % (name, key)]) for key in ('link', 'to')]
    at = [position.point(ends[k], deck.vector('actuator %s.%s' % (name, ('at', 'to_at')[k]))) for k in (0, 1)]
    return [Acting(name, at[k], row['drive'] * (at[k] - at[1 - k]) / abs(at[1 - k] - at[k]), kind=LOAD) for k in (0, 1) if ends[k] == link]


def acting_on(deck, position, row, link, is_free=True):
    """All that acts on a link, in the order in which it is drawn; forces of a spring only on a link cut free."""
    found = []
    if link == 2:
        found += [Acting('F₁₂', position.A, row.vector('F12'), pin='A'), Acting('F₃₂', position.B, -row.vector('F23'), pin='B')]
    elif link == 3:
        found += [Acting('F₂₃', position.B, row.vector('F23'), pin='B'), Acting('F₄₃', position.joint, -row.vector('F34'), pin='C')]
    else:
        found.append(Acting('F₃₄', position.joint, row.vector('F34'), pin='C'))
        if deck.slides:
            found.append(Acting('N', position.C, 1j * row['N']))
        else:
            found.append(Acting('F₁₄', position.D, row.vector('F14'), pin='D'))
    G = position.point(link, deck.cg(link))
    gravity = deck.gravity()
    newton = 1 / si_of(deck.unit('force'))
    found.append(Acting('W' + '₂₃₄'[link - 2], G, deck.mass(link) * gravity * newton, kind=LOAD))
    for name, load in deck.loads().items():
        if deck.link_number(load['link']) != link:
            continue
        section = ('load ' + name).strip()
        own = deck.vector(section + '.force') * (position.axis[link] if load.get('frame') == 'link' else 1)
        at = position.point(link, deck.vector(section + '.at'))
        active = is_on(load, row['theta2'] * si_of(deck.unit('angle')) / si_of('deg'), row['omega2'])
        torque = load.get('torque', 0)
        torque = math.nan if torque == 'a curve' else float(torque) if active else 0  # nan: as equilibrium has it
        found.append(Acting(name, at, own if active else 0, torque, kind=LOAD))
        found[-1].origin = position.origin[link]
    for name, spring in deck.springs().items() if is_free else ():
        ends = [deck.link_number(spring[key]) for key in ('link', 'to')]
        for k in (0, 1):
            if ends[k] != link:
                continue
            if is_torsional(deck, name):
                found.append(Acting(name, position.origin[link], torque=row[name + '.torque'] * (-1, 1)[k], kind=LOAD))
                found[-1].origin = pin_between(position, *ends)
            else:
                P, Q = (position.point(ends[j], deck.vector('spring %s.%s' % (name, ('at', 'to_at')[j]))) for j in (k, 1 - k))
                found.append(Acting(name, P, row[name + '.force'] * (Q - P) / abs(Q - P), kind=LOAD))
    if 'gas_force' in row and row['gas_force'] and (link == 4 if deck.slides else deck.slot and link in (3, 4)):
        if deck.slides:
            force = complex(-position.side * row['gas_force'], 0)
        else:
            force = row['gas_force'] * position.axis[3] * (1 if link == 3 else -1)
        found.append(Acting('gas', position.origin[link], force, kind=LOAD))
    if 'friction_guide' in row and deck.slides and link == 4 and deck.number('friction.guide'):
        # against the motion of the piston; that of a slider on its lever is in F34
        force = complex(-math.copysign(row['friction_guide'], position.velocity(4, 0).real), 0)
        found.append(Acting('friction', position.C, force, kind=LOAD))
    found += driving(deck, position, row, link, is_free)
    if is_free:
        a = position.acceleration(link, deck.cg(link)) * si_of(deck.unit('length'))
        found.append(Acting('-m aG', G, -deck.mass(link) * a * newton, kind=RESULT))
    return found


def torques_on(deck, position, row, link, acting):
    """(name, place, value, style) of the torques on a link, in the order in which they are drawn."""
    found = [(x.name, x.origin, x.torque, LOAD) for x in acting if x.torque]
    if link == 2:
        found.append(('Ts', position.A, row['Ts'] if not is_rounding(deck, row) else 0, PIN_FORCE))
    if deck.slot and link == 3:
        found.append(('M₄₃', position.B, -row['M34'], PIN_FORCE))
    if deck.slot and link == 4:
        found.append(('M₃₄', position.B, row['M34'], PIN_FORCE))
    if deck.slides and link == 4:
        found.append(('M₁₄', position.C, row['M14'], PIN_FORCE))
    I, alpha = deck.inertia(link) / si_of(deck.unit('torque')), position.alpha[link]
    found.append(('-Iα', position.point(link, deck.cg(link)), -I * alpha, RESULT))
    known = sum(x[2] for x in found if not math.isnan(x[2]))
    known += deck.factor('torque', 'length', 'force') * sum(cross(x.at, x.force) for x in acting)
    found = [(name, at, -known if math.isnan(value) else value, style) for name, at, value, style in found]
    return [x for x in found if x[2]]


def is_rounding(deck, row):
    """In a motion that is not given the driving torque may be rounding."""
    arm = deck.length(2) * abs(row.vector('F12')) * deck.factor('torque', 'length', 'force')
    return 'motion.mode' in deck.inputs and abs(row['Ts']) < 1.1e-12 * arm


def split_arrows(panel, size):
    """The arrows of forces, and torques as (centre, sense, style) from their arcs."""
    forces, torques, arc = [], [], []
    for line in panel.lines:
        if line.style not in (PIN_FORCE, LOAD, RESULT):
            arc = []
        elif not line.is_arrow:
            arc.append(line)
        elif len(arc) >= 20:
            p, q, r = arc[0].start, arc[len(arc) // 2].start, arc[-1].end
            centre = crossing((p + q) / 2, 1j * (q - p), (q + r) / 2, 1j * (r - q))
            torques.append((centre, math.copysign(1, cross(line.start - centre, line.vector)), line.style, abs(p - centre)))
            arc = []
        else:
            forces.append(line)
            arc = []
    return forces, torques


BELOW = 'no arrow below '


def check_scale(panel, deck, largest, forces):
    """The arrow below the drawing shows a force of the value beside it; returns length for a unit of force."""
    bars = [line for line in panel.lines if line.style == THIN and line.is_arrow]
    words = [value_of(label[0], deck.unit('force')) for label in panel.labels]
    words = [x for x in words if x]
    if not checks.that(bars and len(words) == 1, 'a scale of forces in', panel.title, len(bars), words):
        return None
    bar = min(bars, key=lambda line: (line.start * cmath.exp(1j * deck.turn)).imag)
    checks.that(largest / 6 < words[0] and (words[0] <= largest * 1.01 or not panel.title.startswith('free body')), 'a scale of a useful size', words[0], largest)
    height = (bar.start * cmath.exp(1j * deck.turn)).imag
    others = [(p * cmath.exp(1j * deck.turn)).imag for line in panel.lines if line is not bar and line.style != bar.style
              for p in (line.start, line.end)]
    checks.that(height < min(others) - 0.02 * (max(others) - min(others)), 'the scale is below the drawing', height, min(others))
    return abs(bar.vector) / words[0]


def check_free_body(body, polygon, deck, position, row, link, size):
    acting = acting_on(deck, position, row, link)
    torques = torques_on(deck, position, row, link, acting)
    wanted = [x for x in acting if x.force]
    largest = max([abs(x.force) for x in wanted] + [0])
    wanted = [x for x in wanted if abs(x.force) > 1e-12 * largest]  # the others are rounding
    unit = deck.unit('force')
    where = body.title
    # the polygon: the forces in sequence, from one end to the next
    sides = check_sides(polygon, unit, [(x.name, None, x.force) for x in wanted], largest)
    checks.near('the forces close: ' + polygon.title, sum(x[1] for x in sides), 0, largest, 1e-5)
    drawn = [line for line in polygon.lines if line.style != THIN]
    checks.that(not drawn or abs(drawn[0].start) < 1e-5 * largest, 'the first force begins at the origin')
    for line, following in zip(drawn, drawn[1:]):
        checks.near('forces in sequence', following.start, line.end, largest, 1e-5)
    for x in acting:
        if x.force and abs(x.force) > 1e-9 * largest:
            styles = [line.style for line, note in zip(drawn, entries(polygon, unit)) if note[0] == x.name]
            checks.that(x.kind in styles, 'the style of', x.name, styles)
    # the body: each force at its place, in the stated scale
    notes = [note for note in entries(body, unit) if note[1] > 1e-12 * largest]
    checks.that([x.name for x in wanted] == [name for name, value in notes], 'notes of the', where, notes, [x.name for x in wanted])
    for x, (name, value) in zip(wanted, notes):
        checks.near('the note of %s on the %s' % (name, where), value, abs(x.force), abs(x.force) + 1e-9 * largest, 1e-4)
    if not largest:
        return
    lines, arcs = split_arrows(body, size)
    shown = [x for x in wanted if abs(x.force) >= 0.02 * largest]
    scale = check_scale(body, deck, largest, lines)
    if not scale or not checks.that(len(lines) == len(shown), 'arrows of the', where, len(lines), [x.name for x in shown]):
        return
    crank = abs(position.B - position.A)
    length = max(map(abs, deck.slide_range(1))) if link == 4 and deck.yoke else \
        crank if link == 4 and deck.slides or deck.slot and link == 3 else \
        abs(position.origin[link] - (position.B if link == 2 or deck.slot else position.C))
    checks.near('the longest arrow of the ' + where, max(abs(line.vector) for line in lines), 0.65 * length, 1e-4 * length + 1e-5 * size, 1)
    coarse = 1e-6 * size / (scale * largest) * 20  # seven digits of places far from the origin
    enlarged = [float(re.match(r'friction circles ([0-9.]+):1', note).group(1)) for note in body.notes if note.startswith('friction circles')]
    enlarged = enlarged[0] if enlarged else 1
    moment, sum_of_sizes = 0, 0
    k = deck.factor('torque', 'length', 'force')
    for x in wanted:
        at = x.at
        if x in shown:
            line = lines[shown.index(x)]
            checks.near('%s on the %s' % (x.name, where), line.vector, scale * x.force, 2e-5 * scale * largest + 1e-6 * size, 1 + coarse)
            checks.that(line.style == x.kind, 'the style of', x.name, 'on the', where)
            has_label(body, x.name)
            radius = deck.number('friction.circle_' + x.pin) if x.pin else 0
            off = line.start - x.at
            checks.near('the arm of %s is across it' % x.name, dot(off, x.force), 0, size * abs(x.force), 1e-5)
            arm = 0
            if radius and 'friction_' + x.pin in row:
                arm = row['friction_' + x.pin] / (k * abs(x.force)) * enlarged
            checks.near('the place of %s on the %s' % (x.name, where), abs(off), arm, size, 5e-6)
            if arm > 0:
                circle = [l for l in body.lines if l.style == OTHER and abs(abs(l.start - x.at) - enlarged * radius) < 1e-5 * size]
                checks.that(len(circle) >= 60, 'the friction circle at', x.pin, len(circle))
            at = x.at + off / enlarged
        moment += k * cross(at, x.force)
        sum_of_sizes += k * max(abs(at), 0.1 * length) * abs(x.force)
    values = entries(body, deck.unit('torque'))
    big = max([abs(t[2]) for t in torques] + [sum_of_sizes])
    arcs = [arc for arc, (name, value) in zip(arcs, values) if abs(value) > 1e-12 * big] if len(arcs) == len(values) else arcs
    values = [(name, value) for name, value in values if abs(value) > 1e-12 * big]  # the others are rounding
    torques = [t for t in torques if abs(t[2]) > 1e-12 * big]
    checks.that([in_book(t[0]) for t in torques] == [name for name, value in values], 'torques of the', where, values, torques)
    checks.that(len(arcs) == len(values), 'arcs of torques of the', where, len(arcs), values)
    for (name, at, value, style), (own_name, printed), (centre, sense, own_style, radius) in zip(torques, values, arcs):
        checks.near('%s on the %s' % (name, where), printed, value, abs(value), 1e-4)
        checks.that(sense == math.copysign(1, value) and style == own_style, 'the sense of', name, 'on the', where, sense, value)
        checks.near('the centre of %s on the %s' % (name, where), centre, at, size, 1e-5)
        has_label(body, in_book(name))
        moment += sense * abs(printed)
        sum_of_sizes += abs(printed)
    slack = 3e-5 + (0.02 if len(shown) < len(wanted) and deck.number('friction.circle_A') else 0)
    checks.near('the moments on the %s' % where, moment, 0, sum_of_sizes, slack)


def check_body_outline(body, deck, position, link, row, size):
    """The body between its pins, with their letters."""
    pins = {2: (position.A, position.B), 3: (position.B, position.C), 4: (position.C, position.D)}[link]
    if deck.yoke and link == 4:
        letters = 'BC'
    elif deck.slides and link == 4:
        check_block(body, 'piston', FOLLOWER, position.C, 1, size)
        letters = 'C'
    elif deck.slot and link == 3:
        check_block(body, 'slider', COUPLER, position.B, position.axis[3], size)
        letters = 'B'
    elif deck.slot and link == 4:
        letters = 'BD'
    else:
        has_line(body, 'the body', pins[0], pins[1], OF_LINK[link], size)
        letters = {2: 'AB', 3: 'BC', 4: 'CD'}[link]
    for letter in letters:
        has_label(body, letter)
    if deck.mass(link) > 0:
        has_disc(body, 'centre of mass', position.point(link, deck.cg(link)), size, quarters=True)


def check_title(panel, row, before=''):
    angle = re.search(r'θ₂ = (-?[0-9.e+-]+)', panel.title)
    checks.that(panel.title.startswith(before + row.branch + ', ') and angle and
                abs(float(angle.group(1)) - row['theta2']) <= 1e-6 * max(1, abs(row['theta2'])), 'the title', panel.title)


def check_vectors(deck, text, row, position):
    back = cmath.exp(-1j * deck.turn)
    listing = Listing(text, back)
    has_forces = 'F12x' in row
    if not checks.that(len(listing.panels) == (9 if has_forces else 3), 'panels', len(listing.panels)):
        return
    panels = listing.panels
    for panel in panels:
        panel.blocks = {}
        places = [p / back for line in panel.lines for p in (line.start, line.end)] + [label[1] for label in panel.labels if label[1]]
        check_frame(panel, places)
    check_title(panels[0], row)
    check_places(panels[0], deck, position, row, extent(panels[0]))
    check_velocities(panels[1], deck, position, row)
    check_accelerations(panels[2], deck, position, row)
    if not has_forces:
        return
    for link in (2, 3, 4):
        body, polygon = panels[2 * link - 1], panels[2 * link]
        name = deck.links[link - 1]
        checks.that(body.title == 'free body of the ' + name and polygon.title == 'forces on the ' + name, 'titles', body.title)
        size = extent(body)
        check_body_outline(body, deck, position, link, row, size)
        check_free_body(body, polygon, deck, position, row, link, size)


# ---------------------------------------------------------------------------------- the mechanism with its forces


def check_paths(panel, deck, rows, size):
    """Paths: points of a link keep their places on it, at 181 positions; C is where the lengths put it."""
    count = 0
    for block, title in panel.curves():
        if title is None or not title.startswith('path of '):
            continue
        count += 1
        points = [p for p in panel.blocks[block] if p is not None]
        own = title[8:]
        at = [row.vector(own + '.') for row in rows if row.is_ok and own + '.x' in row]
        for place in at:
            off = min([abs(foot_between(place, p, q) - place) for p, q in zip(points, points[1:])] + [abs(points[0] - place)])
            pixel = (panel.range['x'][1] - panel.range['x'][0]) / 400
            step = max(abs(q - p) for p, q in zip(points, points[1:]))
            checks.that(off <= 0.3 * min(step, 0.1 * size) ** 2 / (0.05 * size) + 0.08 * pixel, 'the path passes', own, place, off, pixel)
    tracers = len(deck.points())
    checks.that(count == tracers + (0 if deck.slot else 1), 'paths', count, tracers)


def foot_between(point, p, q):
    if p == q:
        return p
    t = dot(q - p, point - p) / abs(q - p) ** 2
    return p + (q - p) * max(0, min(1, t))


def check_mechanism(deck, text, row, position, rows):
    back = cmath.exp(-1j * deck.turn)
    listing = Listing(text, back)
    insets = [panel.title for panel in listing.panels if panel.title.endswith(', enlarged')]
    if not checks.that(len(listing.panels) == 1 + len(insets), 'panels', len(listing.panels)):
        return
    panel = listing.panels[0]
    check_insets(insets, deck, panel, extent(panel))
    panel.blocks = {name: [p * back if p is not None else None for p in points] for name, points in panel.blocks.items()}
    size = extent(panel)
    check_title(panel, row)
    check_places(panel, deck, position, row, size)
    check_frame(panel, [p / back for line in panel.lines for p in (line.start, line.end)])
    check_labels(panel)
    check_numbers(panel, deck, position, back)
    check_paths(panel, deck, rows, size)
    if 'F12x' not in row:
        checks.that(not any(line.style in (PIN_FORCE,) for line in panel.lines), 'no forces without loads and masses')
        return
    acting, seen = [], set()
    for link in (2, 3, 4):
        acting += acting_on(deck, position, row, link, is_free=False)
    order = ['F₁₂', 'F₂₃', 'F₃₄', 'N' if deck.slides else 'F₁₄']
    acting = [x for name in order for x in acting if x.name == name] + \
             [x for x in acting if x.name not in order and x.name != 'F₃₂' and x.name != 'F₄₃']
    wanted = [x for x in acting if x.force]
    if not wanted:
        return
    springs = [x for name, spring in deck.springs().items() for key in ('link', 'to') if deck.link_number(spring[key]) != 1
               for x in acting_on(deck, position, row, deck.link_number(spring[key])) if x.name == name and x.force]
    largest = max(abs(x.force) for x in wanted + springs)
    wanted = [x for x in wanted if abs(x.force) > 1e-12 * largest]  # the others are rounding
    notes = [n for n in entries(panel, deck.unit('force')) if n[0] not in deck.springs()]
    checks.that([x.name for x in wanted] == [n[0] for n in notes], 'notes of forces', notes, [x.name for x in wanted])
    for x, (name, value) in zip(wanted, notes):
        checks.near('the note of ' + name, value, abs(x.force), abs(x.force) + 1e-9 * largest, 1e-4)
    for name in deck.springs():
        column = name + ('.torque' if is_torsional(deck, name) else '.force')
        value = value_of(panel.note(name), deck.unit('torque' if is_torsional(deck, name) else 'force'))
        checks.near('the note of ' + name, value, row[column], abs(row[column]) + 1e-6, 1e-4)
    lines, arcs = split_arrows(panel, size)
    lines = [line for line in lines if line.style != LOAD or not (line.vector / back).real == 0 or True]
    g = [line for line in lines if line.style == LOAD and abs((line.vector / back).real) < 1e-9 * size and
         not any(abs(line.start - x.at) < 1e-5 * size for x in wanted + springs)]
    has_weight = any(deck.mass(link) > 0 for link in (2, 3, 4)) and deck.vector('gravity')
    checks.that(len(g) == (1 if has_weight else 0), 'an arrow of gravity', len(g))
    for line in g:
        checks.that((line.vector / back).imag < 0, 'gravity acts downwards')
        checks.that(abs((line.vector / back) / abs(line.vector) - deck.vector('gravity') / back / abs(deck.vector('gravity'))) < 1e-6,
                    'the direction of gravity')
    lines = [line for line in lines if line not in g]
    limits = [value_of(n[len(BELOW):], deck.unit('force')) for n in panel.notes if n.startswith(BELOW)]
    least = limits[0] if limits else 0.02 * largest  # of the motion's largest force, or of this position's
    checks.that(0.0199 * largest <= least <= largest, 'arrows of a useful size', least, largest)
    shown = [x for x in wanted + springs if abs(x.force) >= least]
    scale = check_scale(panel, deck, largest, lines)
    if not scale or not checks.that(len(shown) == len(lines), 'arrows', len(lines), [x.name for x in shown]):
        return
    for x, line in zip(shown, lines):
        checks.near(x.name, line.vector / scale, x.force, 50 * least, 2e-5)
        checks.near('the place of ' + x.name, line.start, x.at, size, 5e-6)
        checks.that(line.style == x.kind, 'the style of', x.name)
        has_label(panel, x.name)  # a spring has its name at its coil
    for inset in listing.panels[1:]:
        check_inset_forces(inset, wanted + springs, deck)
    torques = [(x.name, x.origin, x.torque) for link in (2, 3, 4) for x in acting_on(deck, position, row, link) if x.torque]
    if not is_rounding(deck, row) and row['Ts']:
        torques.append(('Tₛ', position.A, row['Ts']))
    checks.that(len(torques) == len(arcs), 'arcs', len(arcs), torques)
    for (name, at, value), (centre, sense, style, radius) in zip(torques, arcs):
        checks.that(sense == math.copysign(1, value), 'the sense of', name, sense, value)
        checks.near('the centre of ' + name, centre, at, size, 1e-5)
        if name not in deck.springs():  # their notes are those of their columns
            checks.near('the note of ' + name, value_of(panel.note(name), deck.unit('torque')), value, abs(value), 1e-4)


def crank_angle(deck, row):
    """The crank angle of a row for --plot-at, where a number without a unit is a value of what is prescribed."""
    unit = ' rad' if deck.unit('angle') == 'rad' else ' deg'
    return row.values['theta2'] + (unit if 'motion.input' in deck.inputs else '')


def check_several(deck, rows):
    """Further positions of --plot-at, thin; and without --plot-at positions in grey, all where the lengths put them."""
    picked = [row for row in rows if row.is_ok][1:5]
    if len(picked) < 2 or deck.is_single:
        return
    text = deck.program.listing(deck, 'mechanism', '--branch=' + picked[0].branch,
                               '--plot-at=' + ','.join(crank_angle(deck, row) for row in picked), *deck.options)
    panel = Listing(text, cmath.exp(-1j * deck.turn)).panels[0]
    size = extent(panel)
    for row in picked[1:]:
        position = deck.at(row)
        has_line(panel, 'the crank of another position', position.A, position.B, OTHER, size)
        if not deck.slot:
            has_line(panel, 'the coupler of another position', position.B, position.C, OTHER, size)
        if deck.slides:
            check_block(panel, 'piston', OTHER, position.C, 1, size)
        elif not deck.slot:
            has_line(panel, 'the rocker of another position', position.D, position.C, OTHER, size)
    panel = Listing(deck.program.listing(deck, 'mechanism', '--branch=' + picked[0].branch, *deck.options),
                   cmath.exp(-1j * deck.turn)).panels[0]
    size = extent(panel)
    turn = 2 * math.pi / si_of(deck.unit('angle'))
    first = [row for row in rows if row.values['theta2'] and abs(row['theta2'] - rows[0]['theta2']) <= turn * (1 + 1e-9)] if rows[0].is_ok else rows
    for k in range(GHOSTS):
        row = first[(len(first) - 1) * k // GHOSTS]
        if row.is_ok:
            position = deck.at(row)
            has_line(panel, 'the crank on its way', position.A, position.B, GHOST, size)


# ---------------------------------------------------------------------------------------- Klein's construction


def check_klein(deck, text, row, position):
    """Points of the construction, from the lengths:

       M    where the line of the rod meets the perpendicular to the stroke through O
       K L  where the circle about B through M meets that on BC as diameter;  KL meets the rod in Q, the x axis in N
       I    where the line of the crank meets the perpendicular to the stroke through C
       g    divides BN as G does BC;  X and Y are the feet of I on the lines of the weight and of the inertia force
    """
    back = cmath.exp(-1j * deck.turn)
    listing = Listing(text, back)
    panel = listing.panels[0]
    check_title(panel, row, "Klein's construction, ")
    size = extent(panel)
    O, B, C = position.A, position.B, position.C
    u = (C - B) / abs(C - B)
    M = crossing(B, u, O, 1j)
    BM = abs(M - B)
    Q = B + u * BM ** 2 / abs(C - B)  # the common chord is the radical axis of the circles: (P - B).(P - M') = 0
    N = crossing(Q, 1j * u, O, 1)
    for p, q, style, what in ((O, N, THIN, 'ON'), (B, M, THIN, 'BM'), (O, B, CRANK, 'the crank'), (O, M, RESULT, 'OM'),
                              (B, Q, RESULT, 'BQ'), (Q, N, RESULT, 'QN'), (N, O, FOLLOWER, 'ON'), (B, C, COUPLER, 'the rod')):
        has_line(panel, what, p, q, style, size)
    meets = BM >= abs(Q - B)
    if meets:
        half = 1j * u * math.sqrt(BM ** 2 - abs(Q - B) ** 2)
        K, L = Q + half, Q - half
        for end in (K, L):
            checks.near('K and L lie on the circle of the rod', abs(end - (B + C) / 2), abs(C - B) / 2, size, 1e-9)
        has_line(panel, 'the chord', K, L, THIN, size)
    for centre, radius, what, steps in ((B, BM, 'about B', 60), ((B + C) / 2, abs(C - B) / 2, 'on the rod', 60)):
        circle = [line for line in panel.lines if line.style == THIN and abs(abs(line.start - centre) - radius) < 1e-5 * size and
                  abs(abs(line.end - centre) - radius) < 1e-5 * size]
        total = sum(abs(cmath.phase((line.end - centre) / (line.start - centre))) for line in circle if radius > 1e-6 * size)
        checks.that(total > 2 * math.pi - 1e-3 or radius <= 1e-6 * size, 'the circle', what, total)
    overhang = [line for line in panel.lines if line.style == THIN and abs(line.start.imag - C.imag) < 1e-5 * size and
                abs(line.end.imag - C.imag) < 1e-5 * size and abs(line.vector) >= abs(C.real)]
    checks.that(len(overhang) >= 1, 'the line of stroke')
    check_block(panel, 'piston', FOLLOWER, C, 1, size)
    for letter in 'OBCMQN' + ('KL' if meets else ''):
        has_label(panel, letter)
    lengths = {'OM': abs(M), 'BM': BM, 'BQ': abs(Q - B), 'QN': abs(N - Q), 'ON': abs(N)}
    rod_mass = deck.mass(3)
    if abs(B.real) > 1e-6 * size:
        I = C.real * B / B.real
        G = position.point(3, deck.cg(3))
        g = B + (N - B) * (G - B) / (C - B)
        gravity = deck.vector('gravity')
        is_near = abs(I) < 3 * abs(C) * (1 - 1e-9) and bool(gravity)
        if abs(abs(I) - 3 * abs(C)) < 1e-6 * size:
            is_near = None
        # with a constant speed of the crank: a_G = omega^2 gO, and alpha3, of the rod as it moves
        still = deck.place(cmath.phase(B), row.branch, cmath.phase(u))
        still.move(1.0, 0.0)
        aG, alpha = still.acceleration(3, deck.cg(3)), still.alpha[3]
        checks.near('gO is the acceleration of G', O - g, aG, size, 1e-9)
        if is_near and rod_mass > 0 and abs(aG) > 1e-6 * size:
            X = foot(I, G, gravity)
            F, I_rod = -rod_mass * aG, deck.inertia(3) / si_of(deck.unit('length')) ** 2
            # the line of F, whose moment about G is -I alpha:  (P - G) x F = -I alpha
            Y = foot(I, G + 1j * F / abs(F) ** 2 * (I_rod * alpha), F)
            for p, q, style, what in ((B, I, THIN, 'BI'), (C, I, THIN, 'CI'), (G, X, THIN, 'GX'), (g, O, PIN_FORCE, 'gO'),
                                      (I, X, LOAD, 'IX'), (I, Y, PIN_FORCE, 'IY'), (B, N, THIN, 'BN')):
                has_line(panel, what, p, q, style, size)
            Z = [line for line in panel.lines if line.style == THIN and abs(line.end - Y) < 5e-6 * size]
            checks.that(any(abs(cross(line.vector, F)) <= 1e-5 * size * abs(F) for line in Z), 'the line of the inertia force')
            has_disc(panel, 'centre of mass of the rod', G, size, quarters=True)
            for letter in 'IXYgG':
                has_label(panel, letter)
            lengths.update({'IX': abs(X - I), 'IY': abs(Y - I)})
    for name, length in lengths.items():
        value = value_of(panel.note(name), deck.unit('length'))
        checks.near('the note of ' + name, abs(value) if value is not None else None, length, size, 1e-4)
        checks.near('the sign of ' + name, value, row['klein_' + name], size, 1e-4)
    unit = {'v': 'speed', 'a': 'acceleration', 'ω₃': 'angular_speed', 'α₃': 'angular_acceleration'}
    constant = deck.place(cmath.phase(B), row.branch, cmath.phase(u))
    constant.move(row['omega2'] * si_of(deck.unit('angular_speed')), 0.0)
    away = position.side if not deck.has_change_point() else 1 if row.branch == 'open' else -1
    readings = {'v': constant.velocity(4, 0).real * away * -deck.factor('speed', 'length'),
                'a': constant.acceleration(4, 0).real * away * -deck.factor('acceleration', 'length'),
                'ω₃': constant.omega[3] / si_of(deck.unit('angular_speed')), 'α₃': constant.alpha[3] / si_of(deck.unit('angular_acceleration'))}
    omega = abs(row['omega2']) * si_of(deck.unit('angular_speed'))
    sizes = {'v': omega * deck.length(3) * deck.factor('speed', 'length'),
             'a': omega ** 2 * deck.length(3) * deck.factor('acceleration', 'length'),
             'ω₃': omega / si_of(deck.unit('angular_speed')), 'α₃': omega ** 2 / si_of(deck.unit('angular_acceleration'))}
    for name, expected in readings.items():
        if abs(expected) <= 1e-12 * abs(sizes[name]):  # rounding error is printed as 0
            expected = 0.0
        notes = [n for n in panel.notes if n.startswith(name + ' = ')]
        value = value_of(notes[0].rpartition(' = ')[2], deck.unit(unit[name])) if notes else None
        checks.near('the reading of ' + name, value, expected, abs(expected) + 1e-9, 2e-4)
    if rod_mass > 0 and 'klein_FT' in row:
        checks.near('the note of FT', value_of(panel.note('FT'), deck.unit('force')), row['klein_FT'], abs(row['klein_FT']) + 1e-9, 1e-4)
    small = deck.length(2) < 0.7 * deck.length(3)
    if checks.that(len(listing.panels) == (2 if small else 1), 'the crank enlarged') and small:
        inset = listing.panels[1]
        for p, q, style, what in ((O, M, RESULT, 'OM'), (Q, N, RESULT, 'QN'), (N, O, FOLLOWER, 'ON'), (O, B, CRANK, 'the crank'),
                                  (B, B + 0.8 * deck.length(2) * u, COUPLER, 'the beginning of the rod')):
            has_line(inset, 'enlarged ' + what, p, q, style, size)
        if meets:
            has_line(inset, 'enlarged chord', K, L, THIN, size)


# ------------------------------------------------------------------------------------------------------ all


def varied(deck, folder):
    """A copy of a deck for one instant, with rows over a turn."""
    if not deck.is_single:
        return deck
    path = os.path.join(folder, deck.name)
    with open(path, 'w', encoding='utf-8') as out:
        section = ''
        for line in deck.text.splitlines():
            section = line.strip() if line.strip().startswith('[') else section
            if section == '[motion]' and re.match(r'\s*at\s*=', line):
                is_held = re.search(r'^hold\s*=', deck.text, re.M) or 'motion.acceleration' not in deck.inputs
                line = 'interval = 30 deg' if is_held else 'interval = 30 deg\nhold = yes'
            out.write(line + '\n')
    return Deck(deck.program, path)


def is_slow(deck):
    """1 for a steady motion, each picture of which takes a second."""
    return deck.inputs.get('motion.mode') == 'steady' and not os.environ.get('ALL')


def chosen_rows(deck):
    """Rows of both branches, a dozen each, at crank angles that are not round."""
    angle = si_of(deck.units.get('motion.interval', 'deg'))
    span = abs(deck.number('motion.to', 360) - deck.number('motion.from')) * si_of(deck.units.get('motion.to', 'deg')) / angle
    turns = deck.number('motion.turns')
    if turns:
        span = abs(turns) * 2 * math.pi / angle
    interval = '%.6g %s' % (0.97 * span / (ANGLES - 1), deck.units.get('motion.interval', 'deg'))
    both = deck.table('--interval=' + interval, '--branch=both' if not is_slow(deck) else '--branch=open')
    deck.options = ('--set=motion.interval=' + interval,)
    return both


def is_sound(deck, row):
    """Away from dead positions, where numbers are limited by rounding, and from where friction in a guide changes its sign."""
    if not row.is_ok or row['mu'] * si_of(deck.unit('angle')) <= 0.02:
        return False
    speed = min([abs(row[name]) for name in ('v', 'slide_v') if name in row.values], default=1)
    return speed * si_of(deck.unit('speed')) > 1e-9 or not {'friction.guide', 'friction.slot'} & set(deck.inputs)


def check_deck(deck, folder):
    if re.search(r'^\[output', deck.text, re.M):  # these pictures are of the four links
        return
    is_prescribed = re.search(r'^input\s*=\s*(?!theta2)', deck.text, re.M)  # rows over the input are taken as they are
    own = deck if is_prescribed else varied(deck, folder)
    both = {} if is_prescribed and deck.is_single else own.table() if is_prescribed else chosen_rows(own)
    has_forces = any('F12x' in row for rows in both.values() for row in rows)
    # each angle on one branch; without forces and of slow motions, fewer; with ALL in the environment, all on both
    share = 1 if os.environ.get('ALL') else 24 if is_slow(own) else 12 if 'motion.mode' in own.inputs else 8 if has_forces else 12
    for branch, rows in both.items():
        for k, row in enumerate(rows):
            if not is_sound(own, row) or (k + (branch == 'open')) % share:
                continue
            checks.where = '%s, %s, %s' % (own.name, branch, row.values['theta2'])
            position = own.at(row)
            at = ('--branch=' + branch, '--plot-at=' + crank_angle(own, row)) + own.options
            check_vectors(own, own.program.listing(own, 'vectors', *at), row, position)
            # in a construction with a rod as long as the crank, K and L are one point
            if own.slides and not own.yoke and own.length(2) != own.length(3) and k % 4 < 2 and not is_slow(own):
                check_klein(own, own.program.listing(own, 'klein', *at), row, position)
            if (k % 4 == 1 or k % 8 == 2) and not is_slow(own):
                check_mechanism(own, own.program.listing(own, 'mechanism', *at), row, position, rows)
        checks.where = '%s, %s' % (own.name, branch)
        if not is_slow(own) and not is_prescribed:
            check_several(own, rows)
    if deck.is_single:  # the picture of the deck's instant
        for branch, rows in deck.table(*(() if is_prescribed else ('--branch=both',))).items():
            checks.where = '%s, %s, its instant' % (deck.name, branch)
            if is_sound(deck, rows[0]):
                check_vectors(deck, deck.program.listing(deck, 'vectors', '--branch=' + branch), rows[0], deck.at(rows[0]))


def main(fourlink, folders):
    with tempfile.TemporaryDirectory() as folder:
        program = Program(fourlink, folder)
        only = os.environ.get('ONLY')
        for deck in decks_of(program, folders):
            if not only or only in deck.name:
                check_deck(deck, folder)
    return checks.finish()


if __name__ == '__main__':
    sys.exit(main(sys.argv[1], sys.argv[2:]))
