# SPDX-License-Identifier: GPL-3.0-or-later
#
# tables.py FOURLINK EXPECTATIONS DECK... - the tables of reports have the inputs, facts, extremes, rows and expected values that
# the other outputs have: json of --summary and --check, and the table.
import json
import os
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
from linkage import Checks, drawn_units  # noqa: E402

H = '{http://www.w3.org/1999/xhtml}'
checks = Checks()


def words_of(cell):
    return ''.join(cell.itertext())


def body(table):
    """The cells of each row, as the page shows them; a name that is typeset, as the deck has it."""
    return [[cell.get('data-name') or words_of(cell) for cell in row] for row in table.find(H + 'tbody')]


def tables_by_heading(root):
    """The body of each table of facts, under its caption: "Table 3. Turning moment", "Table 1. Inputs as understood (12)"."""
    found, titles, summary = {}, [], None
    for element in root.iter():
        if element.tag == H + 'summary':
            summary = element
        if element.tag != H + 'table':
            continue
        caption = element.find(H + 'caption')
        title = words_of(summary if caption is None else caption)
        number, heading = re.fullmatch(r'Table (\d+)\. (.*?)(?: \(\d+\))?', title).groups()
        titles.append(int(number))
        if element.get('class') == 'facts':
            found[heading] = body(element)
    checks.that(titles == list(range(1, len(titles) + 1)), 'the numbers of tables', titles)
    return found


def number(value, digits=6):
    if value is None:
        return '–'
    if isinstance(value, str):
        return {'inf': '∞', '-inf': '−∞'}.get(value, value)
    return '%.*g' % (digits, value)


def angle(fact, digits=6):
    return '' if fact['theta2'] is None else '%.*g°' % (digits, fact['theta2'])


def unit(fact):
    """As it is written by hand."""
    return {'1': '', 'deg': '°'}.get(fact['unit'], fact['unit'].replace('.', '·').replace('2', '²').replace('3', '³'))


def is_words(fact):
    return isinstance(fact['value'], str) and 'inf' not in fact['value']


def wanted_fact(fact):
    """What the table has of it: words take the place of value, unit, angle and branch."""
    if is_words(fact):
        return [fact['name'], fact['value'], fact['meaning']]
    return [fact['name'], number(fact['value']), unit(fact), angle(fact), fact['branch'] or '', fact['meaning']]


def wanted_input(value):
    if is_words(value):
        return [value['name'], value['value'], value['meaning']]
    return [value['name'], number(value['value']), unit(value), value['meaning']]


def once(facts):
    """A fact that is the same on both branches stands there once, without a branch."""
    kept = {}
    for fact in facts:
        if kept.setdefault(tuple(wanted_fact(fact)[:4]), fact) is not fact:
            kept[tuple(wanted_fact(fact)[:4])] = dict(fact, branch=None)
    return list(kept.values())


def check_facts(found, summary):
    checks.that(found.get('Inputs as understood') == [wanted_input(v) for v in summary['inputs']], 'the inputs')
    facts = once(fact for fact in summary['facts'] if '(' not in fact['name'])
    shown = [row for heading in ('Type and key facts', 'Turning moment', 'Actual motion') for row in found.get(heading, [])]
    for fact in facts:
        checks.that(wanted_fact(fact) in shown, 'the fact', wanted_fact(fact), 'is not shown')
    checks.that(len(shown) == len(facts), 'facts', len(shown), 'expected', len(facts))


def check_extremes(found, summary, branches):
    for branch in branches:
        shown = {row[0]: row[1:] for row in found.get('Smallest and largest values, %s branch' % branch, [])}
        extremes = {fact['name']: fact for fact in summary['facts']
                    if '(' in fact['name'] and fact['branch'] in (branch, None) and fact['name'][:3] in ('min', 'max') and 'residual' not in fact['name']}
        names = {name[4:-1] for name in extremes}
        checks.that(names <= set(shown), 'columns with extremes', names - set(shown), branch)
        for name in names & set(shown):
            least, most = extremes.get('min(%s)' % name), extremes.get('max(%s)' % name)
            if least and most:
                checks.that(shown[name] == [unit(least), number(least['value']), angle(least), number(most['value']), angle(most)],
                            'extremes of', name, branch, shown[name])


def check_rows(root, text, branches):
    """The rows of the table: of each branch its head, and the words of its cells; reasons are one cell."""
    wanted = {}
    for line in text.splitlines():
        if line.startswith('# branch: '):
            rows = wanted.setdefault(line[10:], [])
        elif line and not line.startswith('#'):
            rows.append(line.split())
    found = [table for table in root.iter(H + 'table') if table.get('class') == 'rows']
    checks.that(len(found) == len(branches), 'tables of rows', len(found))
    titles = [words_of(title) for title in root.iter(H + 'summary')][1:]
    checks.that(all(' %s branch ' % branch in title for branch, title in zip(branches, titles)), 'the titles of the tables', titles)
    for table, branch in zip(found, branches):
        rows = [row for row in body(table) if len(row) > 1]
        checks.that(len(rows) == len(wanted[branch]), 'rows of', branch, len(rows), len(wanted[branch]))
        for row, line in zip(rows, wanted[branch]):
            checks.that(row == line, 'the row', row, 'expected', line)


def check_sides(root, matrix):
    """What is known of the nine equations: m a less weight less loads, as the table of the matrix has it."""
    tables = [table for table in root.iter(H + 'table') if table.get('class') == 'facts sides']
    right = [float(line.split()[-1]) for line in matrix.splitlines() if not line.startswith('#')]
    if not tables or not right:  # a motor's motion has no instant of its own
        return
    rows = body(tables[0])
    checks.that(len(rows) == len(right) == 9, 'equations', len(rows), len(right))
    size = max(map(abs, right))
    for (name, *words), b in zip(rows, right):
        inertia, weight, loads, found = map(float, words)
        checks.near('the right side of ' + name, found, b, size, 1e-5)
        checks.near('the parts of ' + name, inertia + weight + loads, b, size, 1e-4)
        checks.that(not (name.endswith('moments') and weight), 'a weight has a moment', name)


def wanted_check(c):
    is_known = c['computed'] is not None
    return [c['name'], angle(c, 9), c['branch'] or '', c['printed'], number(c['computed'], 9) if is_known else '', unit(c),
            number(c['tolerance']) if c['tolerance'] is not None else '',
            c['result'] + (': ' + c['message'] if not is_known else '')]


def check_expected(found, outcome):
    wanted = [wanted_check(c) for c in outcome['checks']]
    shown = found.get('Expected values', [])
    checks.that(len(shown) == len(wanted), 'expected values', len(shown), len(wanted))
    for row, line in zip(shown, wanted):
        checks.that(row == line, 'the expected value', row, 'expected', line)


WRONG = """
[expect]
at = 40
phi = 104 deg
theta3 = 347.6 deg
no_such = 1
stroke = 0.1 m
[misprint]
at = 90 deg
phi = 19.47 deg
"""


def main(fourlink, expectations, *decks):
    def run(*words):
        units = [] if words[0].startswith('--report') else drawn_units(words[-1])
        return subprocess.run([fourlink] + units + list(words), capture_output=True, encoding='utf-8').stdout
    folder = tempfile.TemporaryDirectory()
    wrong = os.path.join(folder.name, 'wrong.deck')
    with open(expectations, encoding='utf-8') as given, open(wrong, 'w', encoding='utf-8') as out:
        out.write(given.read() + WRONG)
    for deck in (expectations, wrong) + decks:
        checks.where = os.path.basename(deck)
        report = os.path.join(folder.name, 'tables.html')
        run('--report=' + report, '--branch=both', deck)
        root = xml.parse(report).getroot()
        found = tables_by_heading(root)
        summary = json.loads(run('--format=json', '--summary', '--branch=both', deck))
        branches = ('open', 'crossed')
        check_facts(found, summary)
        check_extremes(found, summary, branches)
        check_rows(root, run('--wide', '--branch=both', deck), branches)
        place = re.search('At θ₂ = ([^,:]*), open branch', words_of(root))
        if place:
            check_sides(root, run('--matrix', '--branch=open', '--set=motion.at=' + place.group(1), deck))
        outcome = run('--format=json', '--check', deck)
        if outcome:
            check_expected(found, json.loads(outcome))
    folder.cleanup()
    return checks.finish()


if __name__ == '__main__':
    sys.exit(main(*sys.argv[1:]))
