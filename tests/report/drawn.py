# SPDX-License-Identifier: GPL-3.0-or-later
#
# drawn.py rows|page FOURLINK FOLDER... - the mechanics of the drawing of a report.
#
# `rows`: the numbers that the drawing is made from.  `page`: what the page's script draws of them, in node or in
# Chromium.  Places come from lengths and crank angle (linkage.py), forces from the table.
import csv
import io
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, os.pardir), os.path.join(HERE, os.pardir, 'pictures')]
import drawn as pictures  # noqa: E402
from linkage import Checks, Program, SKIPPED, cross, decks_of, dot, si_of  # noqa: E402

checks = Checks()
pictures.checks = checks
MINUS, ALPHA = '\u2212', '\u03b1'
ROWS = 6  # of each branch


class Report:
    """The rows of a report, and its script."""

    def __init__(self, deck):
        path = os.path.join(deck.program.folder, 'report.html')
        deck.program.run('--report=' + path, '--branch=both', *deck.options, deck.path)
        with open(path, encoding='utf-8') as page:
            self.text = page.read()
        match = re.search(r'id="fourlink-rows">(.*?)</script>', self.text, re.S)
        self.data = json.loads(match.group(1)) if match else None
        self.script = re.search(r'<script>//<!\[CDATA\[\n(.*?)//\]\]></script>', self.text, re.S).group(1)

    def track(self, branch, name, i):
        """A vector or a number; None if the row has none."""
        track = self.data['branches'][branch]['tracks'].get(name)
        if track is None:
            return None
        parts = [x[i] if isinstance(x, list) else x for x in track]
        return None if None in parts else complex(*parts) if len(parts) == 2 else parts[0]


def body_label(label):
    """The name that a picture gives this label."""
    name, sub, sup = label
    if name == MINUS + 'm a':
        return '-m aG'
    if name == MINUS + 'I' + ALPHA:
        return '-I' + ALPHA
    if name == 'T' and sub == 's':
        return 'Ts'
    return name + sub.translate(str.maketrans('1234', '\u2081\u2082\u2083\u2084'))


def expected_polygons(deck, position, row):
    """Label -> (start, vector) of the sides of both polygons."""
    k = deck.factor('speed', 'length')
    n = deck.factor('acceleration', 'length')

    def parts(link, r):
        return -n * position.omega[link] ** 2 * r, n * 1j * position.alpha[link] * r
    vB = k * position.velocity(3, 0)
    aBn, aBt = parts(2, position.B)
    speed, acceleration = {'vB': (0, vB)}, {'aBn': (0, aBn), 'aBt': (aBn, aBt)}
    if deck.slot:
        vB4 = k * 1j * position.omega[4] * (position.B - position.D)
        speed.update({'vB4': (0, vB4), 'vBB4': (vB4, k * position.slide_v * position.axis[3])})
        b, t = parts(4, position.B - position.D)
        cor = 1j * position.axis[3] * 2 * n * position.omega[4] * position.slide_v
        acceleration.update({'aB4n': (0, b), 'aB4t': (b, t), 'aCor': (b + t, cor),
                             'aBB4': (b + t + cor, n * position.slide_a * position.axis[3])})
    else:
        vC = k * position.velocity(3, deck.length(3))
        speed.update({'vC': (0, vC), 'vCB': (vB, vC - vB)})
        c, t = parts(3, position.C - position.B)
        acceleration.update({'aCBn': (aBn + aBt, c), 'aCBt': (aBn + aBt + c, t)})
        if deck.slides:
            acceleration['aC'] = (0, n * position.acceleration(3, deck.length(3)))
        else:
            c, t = parts(4, position.C - position.D)
            acceleration.update({'aCn': (0, c), 'aCt': (c, t)})
    return speed, acceleration


def images(deck, position, row, kind):
    """Track -> image of centres of mass and of tracer points."""
    k = deck.factor('speed' if kind == 'v' else 'acceleration', 'length')
    motion = position.velocity if kind == 'v' else position.acceleration
    found = {'%sG%d' % (kind, link): k * motion(link, deck.cg(link)) for link in (2, 3, 4) if deck.mass(link) > 0}
    for i, (name, link) in enumerate(deck.points()):
        found['%sP%d' % (kind, i)] = row.vector('%s.%s' % (name, kind))
    return found


def places(deck, position, row):
    """Track -> place."""
    found = {'A': position.A, 'B': position.B}
    if not deck.slot:
        found['C'] = position.C
    if not deck.slides:
        found['D'] = position.D
    for link in (2, 3, 4):
        if deck.mass(link) > 0:
            found['G%d' % link] = position.point(link, deck.cg(link))
    for i, (name, link) in enumerate(deck.points()):
        found['P%d' % i] = row.vector(name + '.')
    for i, (name, spring) in enumerate(deck.springs().items()):
        if not pictures.is_torsional(deck, name):
            for end, link, at in (('P', 'link', 'at'), ('Q', 'to', 'to_at')):
                found['K%d%s' % (i, end)] = position.point(deck.link_number(spring[link]), deck.vector('spring %s.%s' % (name, at)))
    if deck.slot:
        own_foot = position.D + 1j * deck.offset_of_slide() * position.axis[3]
        near, far = deck.slide_range(1)
        found['S1'], found['S2'] = (own_foot + position.label * x * position.axis[3] for x in (near, far))
        found['R'] = position.end if deck.length(4) else own_foot
    if deck.slides:
        e = 1j * deck.number('ground.offset')
        found['S1'], found['S2'] = position.label * deck.nearest() + e, position.label * deck.dead_centre() + e
    return found


def check_tracks(report, branch, i, wanted, size, what):
    for name, value in wanted.items():
        checks.near('%s %s' % (what, name), report.track(branch, name, i), value, size, 6e-5)


def check_polygons(report, deck, branch, i, position, row):
    for polygon, wanted, kind in zip(report.data['polygons'], expected_polygons(deck, position, row), 'va'):
        size = max(abs(v) for start, v in wanted.values())
        corners, pole = {polygon['pole']: 0j}, polygon['pole']
        checks.that(sorted(''.join(side['label']) for side in polygon['sides']) == sorted(wanted), 'sides of the', polygon['title'])
        for side in polygon['sides']:
            name, v = ''.join(side['label']), report.track(branch, side['of'], i)
            start, vector = wanted.get(name, (0, 0))
            checks.near('side %s of the %s' % (name, polygon['title']), v, vector, size, 6e-5)
            checks.near('start of side ' + name, corners.get(side['from']), start, size, 2e-4)
            end = corners[side['from']] + v
            checks.near('the %s closes with %s' % (polygon['title'], name), corners.setdefault(side['to'], end), end, size, 3e-4)
        for p, q in polygon['lines']:
            checks.that(p in corners and q in corners, 'a line between corners')
        own = images(deck, position, row, kind)
        checks.that(sorted(x['of'] for x in polygon['images']) == sorted(own), 'images of the', polygon['title'])
        check_tracks(report, branch, i, own, max([size] + [abs(x) for x in own.values()]), 'image')


def check_bodies(report, deck, branch, i, position, row):
    """Each body: forces and torques are those that act on it, at their places; their sums are 0."""
    data = report.data
    k = deck.factor('torque', 'length', 'force')
    for link in (2, 3, 4):
        acting = pictures.acting_on(deck, position, row, link)
        wanted = {}
        for x in acting:
            wanted.setdefault(x.name, []).append(x)
        largest = max([abs(x.force) for x in acting] + [1e-9 * abs(row.vector('F12')), 1e-300])
        total, moment, sizes = 0, 0, 0
        seen = set()
        for force in data['forces']:
            if force['on'] != link:
                continue
            name = body_label(force['label'])
            F, at = force['sign'] * report.track(branch, force['of'], i), report.track(branch, force['at'], i)
            total += F
            moment += k * cross(at, F)
            sizes += k * max(abs(at), deck.length(2)) * abs(F)
            if name == 'friction' and not F:
                continue
            own = wanted.get(name)
            if not checks.that(own or abs(F) < 1e-4 * largest, 'a force %s on link %d' % (name, link), F):
                continue
            if own:
                nearest = min(own, key=lambda x: abs(x.force - F))
                seen.add(name)
                checks.near('%s on link %d' % (name, link), F, nearest.force, largest, 6e-5)
                checks.near('the place of %s on link %d' % (name, link), at, nearest.at, deck.length(2) + abs(nearest.at), 6e-5)
                pen = {pictures.PIN_FORCE: 'pin', pictures.LOAD: 'load', pictures.RESULT: 'inertia'}[nearest.kind]
                checks.that(force['pen'] == pen, 'the pen of', name, force['pen'])
        for name, own in wanted.items():
            checks.that(name in seen or all(abs(x.force) <= 1e-9 * largest for x in own), 'no force', name, 'on link', link)
        checks.near('forces on link %d' % link, total, 0, largest, 3e-4)
        own_torques = {t[0]: t for t in pictures.torques_on(deck, position, row, link, acting)}
        for torque in data['torques']:
            if torque['on'] != link:
                continue
            name = body_label(torque['label'])
            value = torque['sign'] * report.track(branch, torque['of'], i)
            moment += value
            sizes += abs(value)
            if name in own_torques:
                own = own_torques.pop(name)
                checks.near('%s on link %d' % (name, link), value, own[2], abs(own[2]) + 1e-6 * sizes, 1e-4)
                checks.near('the place of ' + name, report.track(branch, torque['at'], i), own[1], deck.length(2) + abs(own[1]), 6e-5)
            elif torque['label'][0] == 'M' and torque['label'][1] in ('A', 'B', 'C', 'D'):  # of friction, against the sliding
                pin = torque['label'][1]
                neighbour = {'A': (1, 2), 'B': (2, 3), 'C': (3, 4), 'D': (1, 4)}[pin]
                other = neighbour[0] if neighbour[1] == link else neighbour[1]
                turning = position.omega[link] - position.omega[other]
                if 'friction_' + pin in row:
                    checks.near('friction at %s on link %d' % (pin, link), value, -math.copysign(row['friction_' + pin], turning),
                                row['friction_' + pin] + 1e-12, 1e-4)
                if not value:
                    continue
                checks.near('the place of friction at ' + pin, report.track(branch, torque['at'], i),
                            {'A': position.A, 'B': position.B, 'C': position.C, 'D': position.D}[pin], deck.length(2) * 10, 6e-5)
            else:
                checks.that(abs(value) <= 1e-6 * sizes, 'a torque %s on link %d' % (name, link), value)
        for name, own in own_torques.items():
            checks.that(abs(own[2]) <= 1e-6 * (sizes + abs(own[2])), 'no torque', name, 'on link', link)
        checks.near('moments on link %d' % link, moment, 0, sizes + 1e-300, 3e-4)


def rows_of(report, table, deck):
    """(branch, i, row) of some rows that are in the table as well."""
    steps = {round(x, 6): i for i, x in enumerate(report.data['steps'])}
    for k, branch in enumerate(report.data['branches']):
        rows = [row for row in table[branch['name']] if round(row['theta2'], 6) in steps and pictures.is_sound(deck, row)]
        for row in rows[k::max(1, len(rows) // ROWS)][:ROWS]:
            i = steps[round(row['theta2'], 6)]
            if str(i) not in branch['reasons']:
                yield k, i, row


def check_scene(report, deck):
    data = report.data
    checks.near('the turn of the drawing', data['turn'], deck.turn, 1, 1e-9)
    shapes = ['bar', 'block', 'slot'] if deck.slot else ['bar', 'bar', 'block'] if deck.slides else ['bar'] * 3
    pins = [['A', 'B'], ['B'], ['B', 'D']] if deck.slot else [['A', 'B'], ['B', 'C'], ['C']] if deck.slides else \
        [['A', 'B'], ['B', 'C'], ['C', 'D']]
    for link, shape, own, name in zip(data['links'], shapes, pins, deck.links[1:]):
        checks.that(link['shape'] == shape and link['pins'] == own and link['name'] == name, 'a link', link)
        checks.that(('centre' in link) == (deck.mass(link['link']) > 0), 'the centre of mass of link', link['link'])
        checks.that(link['points'] == ['P%d' % i for i, p in enumerate(deck.points()) if p[1] == link['link']], 'points of', link)
    checks.that(data['supports'] == (['A'] if deck.slides else ['A', 'D']), 'supports', data['supports'])
    heavy = any(deck.mass(link) > 0 for link in (2, 3, 4))
    checks.that(data['gravity'] == (heavy and bool(deck.vector('gravity'))), 'gravity')
    checks.that([p['label'][0] for p in data['points']] == [name for name, link in deck.points()], 'names of points')
    joints = {(1, 2): 'A', (2, 3): 'B', (3, 4): 'B' if deck.slot else 'C', (1, 4): 'C' if deck.slides else 'D'}
    for drawn, (name, spring) in zip(data['springs'], deck.springs().items()):
        links = tuple(deck.link_number(spring[key]) for key in ('link', 'to'))
        if pictures.is_torsional(deck, name):
            checks.that(drawn.get('pin') == joints.get(tuple(sorted(links)), drawn.get('pin')), 'the pin of', name, drawn)
        else:
            checks.that(tuple(drawn['on']) == links, 'the links of', name, drawn)
        checks.that(drawn['coil'] == ('stiffness' in spring) and drawn['damper'] == ('damping' in spring), 'spring', name, drawn)
    for quantity, unit in data['units'].items():
        checks.that(unit == (deck.unit(quantity) or unit), 'the unit of', quantity, unit)


def check_table(report, table):
    """Each number of the page's table is that of the table, rounded."""
    names = [c['name'] for c in report.data['columns']]
    for k, i, row in table:
        for column, cell in zip(report.data['columns'], report.data['branches'][k]['table'][i]):
            value = row.values.get(column['name'], '')
            if isinstance(cell, (int, float)) and value not in ('', 'inf', '-inf'):
                half = 0.5000001 * 10 ** -column['decimals'] * (10 ** math.floor(math.log10(abs(cell))) if column['form'] == 'exponent' and cell else 1)
                checks.near('the cell ' + column['name'], cell, float(value), half + 1e-9 * abs(cell), 1)
    checks.that(len(names) > 0)


def number_of(cell):
    """The number of a cell; None if it has none."""
    words = re.sub(r'<[^>]*>', '', cell).strip().replace(MINUS, '-')
    try:
        return float(words.split()[0].rstrip('\u00b0'))
    except (ValueError, IndexError):
        return None


def last_digit(cell):
    """Half a unit of the last digit that is printed."""
    mantissa, _, power = re.sub(r'<[^>]*>', '', cell).split()[0].partition('e')
    return 0.51 * 10.0 ** (int(power or 0) - len(mantissa.partition('.')[2]))


largest_differences = []


def check_agreement(report, table):
    """The report's own check: the rows of each branch, the largest residual, and a difference that is rounding."""
    for branch, rows in table.items():
        sound = [row for row in rows if row.is_ok and 'residual' in row]
        if not sound or 'F12x' not in sound[0]:
            continue
        match = re.search(r'<tr><th scope="row">%s</th><td>(\d+)</td><td>([^<]*)</td><td>([^<]*)</td></tr>' % branch, report.text)
        if checks.that(match, 'the balance of the branch', branch):
            checks.that(int(match.group(1)) == len(sound), 'rows of the balance', match.group(1), len(sound))
            largest = max(abs(row['residual']) for row in sound)
            checks.that(abs(float(match.group(2)) - largest) <= 0.051 * largest, 'the largest residual', match.group(2), largest)
            checks.that(0 <= float(match.group(3)) < 1e-9, 'the largest difference', match.group(3))
            largest_differences.append(float(match.group(3)))


def check_printed_rows(report, table):
    """The tables of the page are those of the program, rounded to their digits."""
    blocks = re.findall(r'<table class="rows">(.*?)</table>', report.text, re.S)
    for block, (branch, rows) in zip(blocks, table.items()):
        names = re.findall(r'<th scope="col"[^>]* data-name="(.*?)">', block)
        printed = [re.findall(r'<td[^>]*>(.*?)</td>', row) for row in re.findall(r'<tr>(<td>.*?)</tr>', block, re.S)]
        printed = [cells for cells in printed if len(cells) == len(names)]
        sound = [row for row in rows if row.is_ok]
        checks.that(len(printed) == len(sound), 'rows of the table, ', branch, len(printed), len(sound))
        for cells, row in zip(printed, sound):
            for name, cell in zip(names, cells):
                value = number_of(cell)
                if value is not None and name in row:
                    checks.near('the cell %s of the %s branch' % (name, branch), value, row[name], last_digit(cell) + 1e-12 * abs(value), 1)


def check_facts(report, deck):
    """Inputs, facts and extremes of the page are those of the summary."""
    printed, heading = {}, ''
    for part in re.findall(r'<(?:caption|summary)>(Table [0-9]*\. )(.*?)(?: \([0-9]*\))?</(?:caption|summary)>|<tr>(<th scope="row".*?)</tr>', report.text, re.S):
        part = part[1:]
        if part[0]:
            heading = part[0]
            continue
        name = ''.join(re.match(r'<th scope="row"(?: data-name="(.*?)">.*?|>(.*?))</th>', part[1]).groups(''))
        cells = re.findall(r'<td[^>]*>(.*?)</td>', part[1])
        if heading.startswith('Smallest'):
            branch = 'open' if 'open' in heading else 'crossed'
            printed['min(%s)' % name, branch], printed['max(%s)' % name, branch] = cells[1:3], cells[3:5]
        elif len(cells) == 5 and heading in ('Type and key facts', 'Turning moment', 'Actual motion'):
            printed[name, cells[3]] = (cells[0], cells[2], cells[1])
        elif len(cells) == 3 and heading == 'Inputs as understood':
            printed[name, ''] = (cells[0], '', cells[1])
    own = csv.DictReader(io.StringIO(deck.program.run('--summary', '-f', 'csv', '--branch=both', *deck.options, deck.path)))
    n = 0
    for row in own:
        cells = printed.get((row['name'], row['branch'])) or printed.get((row['name'], ''))
        value = number_of(cells[0]) if cells else None
        if value is None or row['value'] in ('', 'inf', '-inf'):
            continue
        n += 1
        wanted = float(row['value'])
        checks.near('%s of the %s branch' % (row['name'], row['branch']), value, wanted, 1e-5 * abs(wanted) + 1e-9, 1)
        if len(cells) == 3:
            unit = {'1': '', 'deg': '\u00b0'}.get(row['unit'], row['unit'].replace('.', '\u00b7').replace('2', '\u00b2'))
            checks.that(cells[2] == unit, 'the unit of', row['name'], cells[2])
        if row['theta2'] and cells[1]:
            checks.near('the angle of ' + row['name'], number_of(cells[1]), float(row['theta2']), 1e-4 + 1e-5 * abs(float(row['theta2'])), 1)
        elif row['theta2'] and not (wanted != 0 and cells[0] == '0'): # which is rounding, printed as 0
            checks.that(False, 'no angle of', row['name'])
    checks.that(n > 8, 'facts', n)


def prepared(program, folder, folders):
    """(deck, report, rows) of each deck: a deck for one instant with rows over a turn."""
    only = os.environ.get('ONLY')
    for deck in decks_of(program, folders):
        if only and only not in deck.name:
            continue
        if pictures.is_slow(deck):
            continue
        own = pictures.varied(deck, folder)
        report = Report(own)
        if report.data and report.data['over'] == 'theta2':
            table = own.table('--branch=both')
            yield own, report, list(rows_of(report, table, own)), table


def check_rows(program, folder, folders):
    for k, (deck, report, rows, table) in enumerate(prepared(program, folder, folders)):
        checks.where = deck.name
        check_agreement(report, table)
        check_printed_rows(report, table)
        if k % 4 == 1:
            check_facts(report, deck)
        check_scene(report, deck)
        check_table(report, rows)
        checks.that(len(rows) >= ROWS or deck.number('motion.from') != 0, 'rows', len(rows))
        for branch, i, row in rows:
            checks.where = '%s, %s, %s' % (deck.name, row.branch, row.values['theta2'])
            position = deck.at(row)
            own = places(deck, position, row)
            size = max([abs(p) for p in own.values()])
            check_tracks(report, branch, i, own, size, 'place')
            check_polygons(report, deck, branch, i, position, row)
            if 'F12x' in row:
                check_bodies(report, deck, branch, i, position, row)


    checks.where = 'all decks'
    checks.that(max(largest_differences + [0]) > 0 or os.environ.get('ONLY'), 'two solutions differ by rounding')


# ------------------------------------------------------------------------------------------- what the page draws


def run_script(script, inputs, folder):
    """What page_drawn.js writes down; None and what is missing if nothing can run it."""
    names = [os.path.join(folder, name) for name in ('script.js', 'input.json', 'output.json')]
    for name, text in zip(names, (script, json.dumps(inputs))):
        with open(name, 'w', encoding='utf-8') as out:
            out.write(text)
    program = os.path.join(HERE, 'page_drawn.js')
    if shutil.which('node'):
        subprocess.run(['node', program] + names, check=True)
        with open(names[2], encoding='utf-8') as out:
            return json.load(out)
    if not shutil.which('chromium'):
        return None
    with open(program, encoding='utf-8') as text:
        collector = text.read()
    page = os.path.join(folder, 'page.html')
    with open(page, 'w', encoding='utf-8') as out:
        out.write('<!DOCTYPE html><html><body><script>%s</script><script>%s</script><script id="inputs" type="application/json">%s</script>'
                  '<script>document.body.replaceChildren(Object.assign(document.createElement("pre"), {id: "done", textContent: '
                  'JSON.stringify(collect(fourlink, document, JSON.parse(document.getElementById("inputs").textContent)))}));</script>'
                  '</body></html>' % (script, collector, json.dumps(inputs).replace('<', '\\u003c')))
    done = subprocess.run(['chromium', '--headless', '--no-sandbox', '--disable-gpu', '--no-first-run', '--disable-background-networking',
                           '--user-data-dir=' + os.path.join(folder, 'profile'), '--dump-dom', 'file://' + page],
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, timeout=300)
    words = re.search(r'<pre id="done">(.*?)</pre>', done.stdout.decode('utf-8'), re.S).group(1)
    for entity, letter in (('&lt;', '<'), ('&gt;', '>'), ('&nbsp;', '\u00a0'), ('&amp;', '&')):
        words = words.replace(entity, letter)
    return json.loads(words)


class Sheet:
    """What stands in a panel: lines, areas, circles, texts; arrows and arcs of torques put together.  Pixels are complex
    numbers with y upwards, so that all is as in the frame of the mechanism."""

    def __init__(self, panel):
        self.title, self.values = panel['title'], panel['values']
        self.place = panel['place']
        self.lines, self.areas, self.circles, self.texts, self.paths = [], [], [], [], []
        self.arrows, self.arcs = [], []
        self.bars = {}
        self.walk(panel['sheet'])
        self.join()

    def walk(self, element):
        tag, attributes, words, children = element
        kind = attributes.get('class', '')
        if kind == 'inset':  # the crank again, enlarged
            return
        if tag in ('polyline', 'polygon'):
            points = [complex(float(p.split(',')[0]), -float(p.split(',')[1])) for p in attributes['points'].split()]
            (self.lines if tag == 'polyline' else self.areas).append((kind, points, len(self.lines) + len(self.areas)))
        elif tag == 'circle':
            self.circles.append((kind, complex(float(attributes['cx']), -float(attributes['cy'])), float(attributes['r']),
                                 attributes.get('data-name')))
        elif tag == 'path':
            self.paths.append((kind, attributes['d']))
        elif tag == 'text':
            words = words or ''.join(text_of(c) for c in children)
            self.texts.append((words, complex(float(attributes['x']), -float(attributes['y'])), kind, len(self.lines) + len(self.areas)))
            return
        for child in children:
            self.walk(child)

    def join(self):
        """Lines that are followed by their heads."""
        heads = {number: points for kind, points, number in self.areas if kind.endswith(' head')}
        rest = []
        for kind, points, number in self.lines:
            tip = heads.get(number + 1)
            if tip and len(points) == 25:
                self.arcs.append((kind, points, tip))
            elif tip:
                self.arrows.append((kind, points[0], tip[0], tip))
            else:
                rest.append((kind, points))
        self.lines = rest

    def scale_of(self, kind, unit):
        """Pixels for a unit, of the scale bar with this unit."""
        bars = [(tip - start, start) for own, start, tip, head in self.arrows if own == 'scale ' + kind]
        if kind == 'length':
            bars = [(points[3] - points[2], points[2]) for own, points in self.lines if own == 'scale']
        if not bars:
            return None
        vector, start = bars[0]
        for words, at, own, number in self.texts:
            if own == 'small' and abs(at.imag - start.imag) < 12 and 0 < (at - start - vector).real < 14:
                value = printed(words, unit)
                return vector.real / value if value and abs(vector.imag) < 1e-9 else None
        return None


def text_of(element):
    return element[2] + ''.join(text_of(c) for c in element[3])


def printed(words, unit):
    """The number of a text such as "−2.5×10⁻³ N" or "3 kN"."""
    unit = '' if unit == '1' else unit.replace('2', '²').replace('.', '·')
    match = re.fullmatch(r'([\u2212-]?[0-9.]+)(?:×10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))? ?(\S*)', words)
    if not match:
        return None
    number = float(match.group(1).replace(MINUS, '-'))
    if match.group(2):
        number *= 10.0 ** int(match.group(2).translate(str.maketrans('⁻⁰¹²³⁴⁵⁶⁷⁸⁹', '-0123456789')))
    rest = match.group(3)
    if not rest.endswith(unit) or rest[:len(rest) - len(unit)] not in pictures.PREFIXES:
        return None
    return number * pictures.PREFIXES[rest[:len(rest) - len(unit)]]


def check_values(sheet, wanted, unit):
    """The list beside a drawing: names with values."""
    found = {}
    for item in sheet.values:
        name, _, words = item.rpartition(' = ')
        value = printed(words, unit)
        if value is not None:
            found.setdefault(name, []).append(value)
    for name, value in wanted:
        checks.that(name in found and min(abs(x - value) for x in found[name]) <= 6e-4 * abs(value) + 1e-12, 'the value of', name, value,
                    found.get(name), 'in', sheet.title)


def label_text(name):
    return name.translate(str.maketrans('\u2081\u2082\u2083\u2084', '1234'))


def near_pixels(what, found, wanted, allowed=0.12):
    return checks.near(what, found, wanted, 1, allowed)


def turned(deck, v):
    return v * complex(math.cos(deck.turn), math.sin(deck.turn))


def has_polyline(sheet, what, kind, points):
    checks.that(any(own == kind and len(drawn) == len(points) and
                    (all(abs(a - b) < 0.12 for a, b in zip(drawn, points)) or all(abs(a - b) < 0.12 for a, b in zip(drawn, points[::-1])))
                    for own, drawn in sheet.lines), what, points, 'in', sheet.title)


def pick_arrow(arrows, kind, start, vector, tolerance):
    for arrow in arrows:
        if arrow[0] == kind and abs(arrow[1] - start) < tolerance and abs(arrow[2] - arrow[1] - vector) < tolerance:
            arrows.remove(arrow)
            return arrow
    return None


def check_head(arrow):
    """The head ends at the tip, in the direction of the arrow."""
    kind, start, tip, head = arrow
    back = (head[1] + head[2]) / 2
    near_pixels('a head along its arrow', (tip - back) / abs(tip - back), (tip - start) / abs(tip - start), 0.02)


def check_arrows(sheet, deck, unit_scale, wanted, place, largest):
    """Forces as arrows: start, direction, length times the stated scale; none but these."""
    arrows = [arrow for arrow in sheet.arrows if arrow[0] in ('pin', 'load', 'inertia')]
    gravity = [a for a in arrows if abs(a[1] - (18 - 14j)) < 0.01]
    if gravity:
        near_pixels('the arrow of gravity', gravity[0][2] - gravity[0][1], -36j, 0.01)
        arrows.remove(gravity[0])
    kinds = {pictures.PIN_FORCE: 'pin', pictures.LOAD: 'load', pictures.RESULT: 'inertia'}
    for x in wanted:
        v = unit_scale * turned(deck, x.force)
        arrow = pick_arrow(arrows, kinds[x.kind], place(x.at), v, 0.3 + 1e-3 * abs(v))
        if abs(v) < 13 and not arrow:
            continue  # without a head
        if checks.that(arrow, 'the arrow of', x.name, 'at', place(x.at), 'along', v, 'in', sheet.title):
            check_head(arrow)
            tip = [t for t in sheet.texts if t[0] in [web_name(x.name, link) for link in (2, 3, 4)]]
            checks.that(tip, 'the name of', x.name)
    checks.that(not arrows, 'other arrows', arrows, 'in', sheet.title)


def check_arcs(sheet, deck, wanted, place, rounding):
    """Torques as arcs about their places, in the sense of their values."""
    arcs = list(sheet.arcs)
    for name, at, value, kind in wanted:
        own = [arc for arc in arcs if arc[0] == kind and abs(arc[1][0] - place(at)) < 60 and
               abs(abs(arc[1][0] - place(at)) - abs(arc[1][12] - place(at))) < 0.5 and
               abs(abs(arc[1][24] - place(at)) - abs(arc[1][12] - place(at))) < 0.5]
        if abs(value) < rounding and not own:
            continue
        if abs(value) < rounding:
            arcs.remove(own[0])
            continue
        if not checks.that(own, 'the arc of', name, 'about', place(at), 'in', sheet.title):
            continue
        kind, points, head = own[0]
        arcs.remove(own[0])
        sense = sum(cross(p - place(at), q - p) for p, q in zip(points, points[1:]))
        checks.that(sense * value > 0, 'the sense of', name, value, 'in', sheet.title)
        near_pixels('the head of %s is at its end' % name, head[0], points[24], 0.01)
        back = (head[1] + head[2]) / 2
        checks.that(cross(back - place(at), head[0] - back) * value > 0, 'the head of', name)
        checks.that(any(t[0] == label_text(name) for t in sheet.texts), 'the name of', name)
    if deck.has_change_point():  # whose links may turn evenly, but for rounding
        arcs = [arc for arc in arcs if arc[0] != 'inertia']
    checks.that(not arcs, 'other arcs', [(a[0], a[1][0]) for a in arcs], 'in', sheet.title)


def rounded_corners(area):
    return sum(area) / len(area)


def check_links(sheet, deck, position, place, links):
    """The links of a drawing: bars between pins, blocks around them, slots."""
    u = turned(deck, position.axis[3]) if deck.slot else turned(deck, 1)
    for link in links:
        if deck.slot and link == 4:
            slots = [points for kind, points, number in sheet.areas if kind == 'link4 slot']
            own_foot = position.D + 1j * deck.offset_of_slide() * position.axis[3]
            near, far = deck.slide_range(1)
            ends = [own_foot + position.label * x * position.axis[3] for x in (near, far)]
            if not checks.that(len(slots) == 1, 'the slot'):
                continue
            middle = (place(ends[0]) + place(ends[1])) / 2
            near_pixels('the middle of the slot', rounded_corners(slots[0]), middle)
            along = max((q - p for p, q in zip(slots[0], slots[0][1:])), key=abs)
            across = min((q - p for p, q in zip(slots[0], slots[0][1:])), key=abs)
            half = abs(across) / 1.24
            near_pixels('the length of the slot', abs(along), abs(place(ends[0]) - place(ends[1])) + 3.2 * half, 0.15)
            near_pixels('the direction of the slot', cross(along, u) / abs(along), 0, 0.01)
            root = position.end if deck.length(4) else own_foot
            has_polyline(sheet, 'the lever', 'link4', [place(position.D), place(root), middle])
        elif deck.slot and link == 3 or deck.slides and link == 4:
            blocks = [points for kind, points, number in sheet.areas if kind == 'link%d block' % link]
            if not checks.that(len(blocks) == 1, 'the block'):
                continue
            near_pixels('the middle of the block', rounded_corners(blocks[0]), place(position.B if deck.slot else position.C))
            along = max((q - p for p, q in zip(blocks[0], blocks[0][1:])), key=abs)
            near_pixels('the direction of the block', cross(along, u) / abs(along), 0, 0.01)
        else:
            ends = {2: (position.A, position.B), 3: (position.B, position.C), 4: (position.C, position.D)}[link]
            has_polyline(sheet, 'link %d' % link, 'link%d' % link, [place(p) for p in ends])
        if deck.mass(link) > 0:
            at = place(position.point(link, deck.cg(link)))
            checks.that(any(kind == 'centre' and abs(c - at) < 0.12 for kind, c, r, name in sheet.circles), 'centre of mass of link', link)


def check_main(sheet, deck, position, row, report, branch, i):
    scale, x0, y0 = sheet.place
    place = lambda p: complex(x0, -y0) + scale * turned(deck, p)  # noqa: E731
    own = places(deck, position, row)
    for name in ('A', 'B', 'C', 'D'):
        if name in own:
            at = [c for kind, c, r, own_name in sheet.circles if own_name == name and kind == 'pivot']
            near_pixels('pin ' + name, at[0] if at else None, place(own[name]))
            checks.that(any(t[0] == name for t in sheet.texts), 'the letter', name)
    for k, (name, link) in enumerate(deck.points()):
        at = [c for kind, c, r, own_name in sheet.circles if own_name == 'P%d' % k]
        near_pixels('point ' + name, at[0] if at else None, place(own['P%d' % k]))
    check_links(sheet, deck, position, place, (2, 3, 4))
    bar = sheet.scale_of('length', deck.unit('length'))
    near_pixels('the scale of lengths', bar and bar / scale, 1, 1e-3)
    supports = [points for kind, points, number in sheet.areas if kind == 'support']
    checks.that(len(supports) == (1 if deck.slides else 2), 'supports', len(supports))
    for triangle, at in zip(supports, (position.A, position.D)):
        near_pixels('a support', triangle[0], place(at))
        checks.that(triangle[1].imag < triangle[0].imag and triangle[2].imag < triangle[0].imag, 'a support is below its pin')
    if deck.slides:
        lines = [points for kind, points in sheet.lines if kind == 'ground' and abs(points[1] - points[0]) > 40]
        u = turned(deck, 1)
        ends = sorted((dot(u, place(own[name])) for name in ('S1', 'S2')))
        half = [abs(p[0] - p[1]) for kind, p, number in sheet.areas if kind == 'link4 block'][0] / 2
        for line in lines:
            along = sorted(dot(u, p) for p in line)
            near_pixels('the first end of the guide', along[0], ends[0] - 1.8 * half, 0.2)
            near_pixels('the last end of the guide', along[1], ends[1] + 1.8 * half, 0.2)
        checks.that(len(lines) == 2, 'the lines of the guide', len(lines))
        if len(lines) == 2:
            near_pixels('the piston is between them', cross(u, (lines[0][0] + lines[1][0]) / 2), cross(u, place(position.C)), 0.2)
    # the crank angle: an arc from the x axis to the crank
    arcs = [points for kind, points in sheet.lines if kind == 'construction' and len(points) == 33]
    if checks.that(len(arcs) == 1, 'the arc of the crank angle'):
        A = place(position.A)
        start, end = (arcs[0][k] - A for k in (0, -1))
        theta = row['theta2'] * si_of(deck.unit('angle'))
        near_pixels('the arc begins on the x axis', start / abs(start), turned(deck, 1), 0.01 + 0.1 / abs(start))
        near_pixels('the arc ends on the crank', end / abs(end), turned(deck, position.axis[2]), 0.01 + 0.1 / abs(end))
        swept = sum(cross(p - A, q - A) for p, q in zip(arcs[0], arcs[0][1:]))
        checks.that(swept * theta >= 0 or abs(math.remainder(theta, 2 * math.pi)) < 1e-6, 'the sense of the arc', swept, theta)
    # springs: from end to end
    for k, (name, spring) in enumerate(deck.springs().items()):
        if 'K%dP' % k in own:
            P, Q = place(own['K%dP' % k]), place(own['K%dQ' % k])
            for start, end in ((P, Q), (Q, P)):
                checks.that(any(kind == 'spring' and abs(points[0] - start) < 0.12 and abs(points[1] - start - 0.2 * (end - start)) < 0.12
                                for kind, points in sheet.lines), 'an end of', name)
        checks.that(any(t[0] == name for t in sheet.texts), 'the name of', name)
    # paths go through their points
    for kind, d in sheet.paths:
        if kind.startswith('path'):
            name = 'C' if 'construction' in kind else 'P%d' % [k for k in range(len(deck.points())) if 'path%d' % (k % 6) in kind.split()][0]
            points = [complex(float(x), -float(y)) for x, y in re.findall(r'[ML]([-0-9.]+),([-0-9.]+)', d)]
            checks.that(min(abs(p - place(own[name])) for p in points) < 0.2, 'the path of', name)
    if 'F12x' not in row:
        return
    acting = []
    for link in (2, 3, 4):
        acting += [x for x in pictures.acting_on(deck, position, row, link)
                   if x.name not in ('F₃₂', 'F₄₃', '-m aG')]
    wanted = [x for x in acting if x.force]
    if not wanted:
        return
    k = sheet.scale_of('pin', deck.unit('force'))
    if checks.that(k, 'a scale of forces'):
        largest = max(abs(x.force) for x in wanted)
        check_arrows(sheet, deck, k, wanted, place, largest)
        check_values(sheet, [(label_text(x.name), abs(x.force)) for x in wanted if abs(x.force) > 1e-3 * largest], deck.unit('force'))
    torques = [(x.name, x.origin, x.torque, 'load') for x in acting if x.torque]
    torques += [('Ts', position.A, row['Ts'], 'pin')] + ([('M₁₄', position.C, row['M14'], 'pin')] if deck.slides else []) + \
        ([('M₃₄', position.B, row['M34'], 'pin')] if deck.slot else [])
    torques = visible_torques(torques, report, branch)
    check_arcs(sheet, deck, torques, place, 1e-11 * abs(row.vector('F12')) * deck.length(2) * deck.factor('torque', 'length', 'force'))


def visible_torques(torques, report, branch):
    """Those that are not rounding, which the rows write as 0."""
    sizes = {}
    for torque in report.data['torques']:
        track = report.data['branches'][branch]['tracks'][torque['of']][0]
        values = [abs(x) for x in (track if isinstance(track, list) else [track]) if x is not None]
        sizes.setdefault(body_label(torque['label']), []).append(max(values or [0]))
    return [t for t in torques if abs(t[2]) > 1.1e-9 * max(sizes.get(t[0], [0])) and max(sizes.get(t[0], [0])) > 0 and t[2]]


def check_polygon_sheet(sheet, deck, wanted, own_images, unit, corners):
    size = max(abs(v) for start, v in wanted.values())
    if size == 0:
        return
    k = sheet.scale_of('vector', unit)
    if not checks.that(k, 'the scale of the', sheet.title):
        return
    pole = [c for kind, c, r, name in sheet.circles if name in ('o', 'o\u2032')]
    if not checks.that(pole, 'the pole of the', sheet.title):
        return
    pens = {'vB': 2, 'vC': 4, 'vCB': 3, 'vB4': 4, 'vBB4': 3, 'aBn': 2, 'aBt': 2, 'aCBn': 3, 'aCBt': 3, 'aCn': 4, 'aCt': 4, 'aC': 4,
            'aB4n': 4, 'aB4t': 4, 'aCor': 5, 'aBB4': 3}
    arrows = [a for a in sheet.arrows if a[0].startswith('link')]
    for name, (start, vector) in wanted.items():
        v = k * turned(deck, vector)
        at = pole[0] + k * turned(deck, start)
        if abs(v) < 13:
            pick_arrow(arrows, 'link%d' % pens[name], at, v, 0.3 + 1e-3 * k * size)
            continue
        arrow = pick_arrow(arrows, 'link%d' % pens[name], at, v, 0.3 + 1e-3 * k * size)
        if checks.that(arrow, 'the arrow of', name, 'from', at, 'along', v, 'in', sheet.title):
            check_head(arrow)
            checks.that(abs(v) < 15 or any(t[0] == name for t in sheet.texts), 'the name of', name)
    checks.that(not [a for a in arrows if abs(a[2] - a[1]) > 14], 'other arrows', arrows)
    for name, at in own_images.items():
        end = pole[0] + k * turned(deck, at)
        checks.that(any(kind == 'dot' and abs(c - end) < 0.3 + 1e-3 * k * size for kind, c, r, own in sheet.circles), 'the image', name)
        checks.that(any(kind == 'construction' and abs(p[0] - pole[0]) < 0.01 and abs(p[1] - end) < 0.3 + 1e-3 * k * size
                        for kind, p in sheet.lines), 'the line to the image', name)
    check_values(sheet, [(name, abs(v)) for name, (start, v) in wanted.items() if abs(v) > 1e-3 * size], unit)
    for name, at in corners.items():
        found = [c for kind, c, r, own in sheet.circles if own == name]
        near_pixels('corner ' + name, found[0] if found else None, pole[0] + k * turned(deck, at), 0.3 + 1e-3 * k * size)


def check_body_sheet(sheet, deck, position, row, link, report, branch, i):
    pins = {2: 'AB', 3: 'B' if deck.slot else 'BC', 4: 'BD' if deck.slot else 'C' if deck.slides else 'CD'}[link]
    at = {'A': position.A, 'B': position.B, 'C': position.C, 'D': position.D}
    drawn = {name: c for kind, c, r, name in sheet.circles if kind == 'pivot'}
    if not checks.that(sorted(drawn) == sorted(pins), 'pins of the', sheet.title, drawn):
        return
    first = pins[-1]
    if len(pins) == 2:
        scale = abs(drawn[pins[0]] - drawn[pins[1]]) / abs(at[pins[0]] - at[pins[1]])
    else:
        scale = 0
    wanted = [x for x in pictures.acting_on(deck, position, row, link) if x.force]
    if not scale:  # a block has the scale of its loads and centre of mass, if they are off its pin
        off = [p for p in [position.point(link, deck.cg(link))] if deck.mass(link) > 0 and abs(p - at[first]) > 1e-9 * deck.length(2)]
        centres = [c for kind, c, r, name in sheet.circles if kind == 'centre']
        if off and centres:
            scale = abs(centres[0] - drawn[first]) / abs(off[0] - at[first])
    place = lambda p: drawn[first] + scale * turned(deck, p - at[first])  # noqa: E731
    for name in pins:
        near_pixels('pin ' + name, drawn[name], place(at[name]))
    largest = max([abs(x.force) for x in wanted] + [0])
    if not scale and any(abs(x.at - at[first]) > 1e-9 * deck.length(2) for x in wanted):
        return  # nothing tells its scale
    if scale:
        check_links(sheet, deck, position, place, (link,))
    if largest:
        k = sheet.scale_of('pin', deck.unit('force'))
        if checks.that(k, 'a scale of forces in the', sheet.title):
            check_arrows(sheet, deck, k, wanted, place, largest)
            check_values(sheet, [(web_name(x.name, link), abs(x.force)) for x in wanted if abs(x.force) > 1e-3 * largest], deck.unit('force'))
    torques = pictures.torques_on(deck, position, row, link, pictures.acting_on(deck, position, row, link))
    kinds = {pictures.PIN_FORCE: 'pin', pictures.LOAD: 'load', pictures.RESULT: 'inertia'}
    torques = [(web_name(t[0], link), t[1], t[2], kinds[t[3]]) for t in visible_torques(torques, report, branch)]
    for torque in report.data['torques']:  # friction in pins
        if torque['on'] == link and torque['label'][0] == 'M' and torque['label'][1] in ('A', 'B', 'C', 'D'):
            value = torque['sign'] * report.track(branch, torque['of'], i)
            if value:
                torques.append((''.join(torque['label']), at[torque['label'][1]], value, 'load'))
    check_arcs(sheet, deck, torques, place, 1e-11 * abs(row.vector('F12')) * deck.length(2) * deck.factor('torque', 'length', 'force'))
    check_values(sheet, [(label_text(t[0]), t[2]) for t in torques if abs(t[2]) > 1e-6], deck.unit('torque'))


def web_name(name, link):
    return {'-m aG': MINUS + 'm aG%d' % link, '-I' + ALPHA: MINUS + 'I' + ALPHA + str(link)}.get(name, label_text(name))


def corners_of(deck, wanted, kind):
    prime = '\u2032' if kind == 'a' else ''
    ends = {name: start + v for name, (start, v) in wanted.items()}
    if deck.slot:
        return {'b' + prime: ends['vB' if kind == 'v' else 'aBt'], 'b\u2084' + prime: ends['vB4' if kind == 'v' else 'aB4t']}
    return {'b' + prime: ends['vB' if kind == 'v' else 'aBt'], 'c' + prime: ends['vCB' if kind == 'v' else 'aCBt']}


def thinned(data, keep):
    """The data with these rows alone: the page looks at all of them to choose its scale, which takes its time."""
    branches = []
    for branch in data['branches']:
        tracks = {name: [[x[i] for i in keep] if isinstance(x, list) else x for x in track] for name, track in branch['tracks'].items()}
        reasons = {str(k): branch['reasons'][str(i)] for k, i in enumerate(keep) if str(i) in branch['reasons']}
        branches.append(dict(branch, tracks=tracks, reasons=reasons, table=[branch['table'][i] for i in keep]))
    return dict(data, steps=[data['steps'][i] for i in keep], start=0, branches=branches)


def check_page(program, folder, folders):
    inputs, decks, script = [], [], ''
    for deck, report, rows, table in prepared(program, folder, folders):
        by_branch = [[x for x in rows if x[0] == k][::2] for k in range(len(report.data['branches']))]
        keep = sorted({x[1] for own in by_branch for x in own}.union(range(0, len(report.data['steps']), 40)))
        inputs.append({'data': thinned(report.data, keep), 'rows': [[keep.index(x[1]) for x in own] for own in by_branch]})
        decks.append((deck, report, by_branch))
        script = report.script
    drawings = run_script(script, inputs, folder)
    if drawings is None:
        print('skipped: neither node nor chromium is there, which run the script of a report')
        return SKIPPED
    for (deck, report, by_branch), branches in zip(decks, drawings):
        for rows, drawn in zip(by_branch, branches):
            for (k, i, row), panels in zip(rows, drawn):
                checks.where = '%s, %s, %s' % (deck.name, row.branch, row.values['theta2'])
                position = deck.at(row)
                sheets = [Sheet(panel) for panel in panels]
                checks.that(len(sheets) == (6 if 'F12x' in row else 3), 'panels', len(sheets))
                check_main(sheets[0], deck, position, row, report, k, i)
                for sheet, wanted, kind, quantity in zip(sheets[1:3], expected_polygons(deck, position, row), 'va', ('speed', 'acceleration')):
                    check_polygon_sheet(sheet, deck, wanted, images(deck, position, row, kind), deck.unit(quantity), corners_of(deck, wanted, kind))
                for link, sheet in enumerate(sheets[3:], 2):
                    check_body_sheet(sheet, deck, position, row, link, report, k, i)
    return None


def main(what, fourlink, folders):
    with tempfile.TemporaryDirectory() as folder:
        program = Program(fourlink, folder)
        status = (check_page if what == 'page' else check_rows)(program, folder, folders)
    return status or checks.finish()


if __name__ == '__main__':
    sys.exit(main(sys.argv[1], sys.argv[2], sys.argv[3:]))
