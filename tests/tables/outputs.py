# SPDX-License-Identifier: GPL-3.0-or-later
#
# outputs.py FOURLINK CHECK_PAGE DECK... - laws of what is printed: the table has the numbers of the csv, and so have json, a
# report (check_page of the build) and the points of curves; a printed deck gives the same; values of --expect are right for
# --check; parts of a sweep, its range cut in two, and its designs, make the whole; options go in any order.  The options of a
# deck are beside it, one a line, in .options (random_decks).  Numbers are compared word for word, those of a
# table to half of their last digit, points of curves to the width of a line.
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
from decimal import Decimal

TESTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..')
sys.path[:0] = [TESTS, os.path.join(TESTS, 'pictures')]
import diagrams  # noqa: E402
from linkage import Checks, Deck, Program, si_of  # noqa: E402

fourlink, check_page = (os.path.abspath(program) for program in sys.argv[1:3])
LINE_WIDTH = 1  # pixels


class Law(Checks):
    """A law, with its count of decks and of what was compared."""

    def __init__(self, name):
        super().__init__(20)
        self.name, self.decks = name, 0

    def at(self, deck):
        self.where, self.decks = '%s, %s' % (self.name, os.path.basename(deck)), self.decks + 1


TABLE, JSON, PRINTED, CHECKED, REPORT, CURVES, PARTS, CUT, DESIGNS, ORDER = LAWS = [Law(name) for name in (
    'table beside csv', 'json beside csv', '--print-deck', '--expect, --check', 'report beside csv', 'curves beside rows', '--part',
    'a sweep cut in two', '--design', 'options in any order')]


def run(*words, folder=None):
    done = subprocess.run([fourlink, *words], capture_output=True, stdin=subprocess.DEVNULL, encoding='utf-8', errors='replace',
                          timeout=600, cwd=folder)
    return done.returncode, done.stdout, done.stderr


def records(text):
    return list(csv.reader(io.StringIO(text)))


def is_as_shown(shown, cell):
    """A number of the table, which is rounded, and that of the csv."""
    if shown == 'nan' or cell == '':
        return shown == 'nan' and cell == ''
    if 'inf' in shown or 'inf' in cell:
        return shown == cell
    shown, cell = Decimal(shown), Decimal(cell)
    return abs(shown - cell) <= Decimal('0.5001') * Decimal(1).scaleb(shown.as_tuple().exponent)


def check_table(deck):
    TABLE.at(deck)
    lines = records(run('-f', 'csv', '-c', 'all', '--units=SI', deck)[1])
    rows = [line.split() for line in run('-c', 'all', '-s', 'table.digits=15', '--units=SI', deck)[1].splitlines()
            if line and not line.startswith('#')]
    wanted = [line[1:-1] for line in lines[1:] if line[-1] == 'ok' or line[-1].startswith('near')]
    if TABLE.that(len(rows) == len(wanted), len(rows), 'rows, not', len(wanted)):
        for row, line in zip(rows, wanted):
            for head, shown, cell in zip(lines[0][1:], row, line):
                TABLE.that(is_as_shown(shown, cell), head, shown, 'for', cell)


def check_json(deck, lines):
    """The same numbers, word for word."""
    JSON.at(deck)
    found = json.loads(run('-f', 'json', '-c', 'all', deck)[1], parse_float=str, parse_int=str)
    rows = [(part['branch'], row) for part in found['branches'] for row in part['rows']]
    JSON.that(len(rows) == len(lines) - 1, len(rows), 'rows, not', len(lines) - 1)
    for (branch, row), line in zip(rows, lines[1:]):
        JSON.that([branch, row['status']] == [line[0], line[-1]], branch, row['status'], 'for', line[0], line[-1])
        for head, value, cell in zip(lines[0][1:], row.get('values') or (), line[1:]):
            JSON.that((value or '') == cell, head, value, 'for', cell)


def check_printed(deck, folder):
    """With a number set."""
    PRINTED.at(deck)
    change = '--set=crank.mass=0.4 kg'
    whole = run('-f', 'csv', '-c', 'all', change, deck)
    status, text, _ = run('--print-deck', change, deck)
    if not PRINTED.that(status == 0, 'status', status):
        return
    path = os.path.join(folder, os.path.basename(deck))
    with open(path, 'w', encoding='utf-8') as out:
        out.write(text)
    PRINTED.that(run('-f', 'csv', '-c', 'all', path)[:2] == whole[:2], 'the table of the printed deck is another')
    PRINTED.that(run('--print-deck', path)[1] == text, 'printed again it is another')


def check_expected(deck, folder):
    CHECKED.at(deck)
    status, text, _ = run('--expect', deck)
    path = os.path.join(folder, 'answers.expect')
    with open(path, 'w', encoding='utf-8') as out:
        out.write(text)
    if status <= 1 and '[expect' in text:
        status, text, errors = run('--check=' + path, deck)
        CHECKED.that(status == 0, 'status', status, text.strip().splitlines()[-1:], errors[-200:])


def check_report(deck, folder):
    REPORT.at(deck)
    status, text, errors = run('--report=' + os.path.join(folder, 'r.html'), '--format=csv', '--units=SI', deck)
    if REPORT.that(status <= 1, 'status', status, errors[-200:]) and 'max(' not in text.split('\n')[0]:  # values, no rows
        with open(os.path.join(folder, 'rows.csv'), 'w', encoding='utf-8') as out:
            out.write(text)
        done = subprocess.run([check_page, os.path.join(folder, 'r.html'), deck, os.path.join(folder, 'rows.csv')], capture_output=True, encoding='utf-8', errors='replace')
        wrong = [line for line in done.stdout.splitlines() if not line.endswith(' bytes')]  # of a hundred curves: as long as it is
        REPORT.that(not wrong, *wrong[:3], done.stderr[:100])


def without_spikes(rows, name):
    """The rows between the first and the last, but those of a peak that is narrower than the rows, which no curve shows whole."""
    return [b for a, b, c in zip(rows, rows[1:], rows[2:]) if not (a.is_ok and b.is_ok and c.is_ok and abs(b[name]) > 2 * max(abs(a[name]), abs(c[name])))]


def check_curves(deck, program, lines):
    """Columns in turn, those of the number of the deck on."""
    names = [head.split(' (')[0] for head in lines[0] if ' (' in head and not re.match(r'theta2|time|omega2|alpha2|mechanical|residual|superpos', head)]
    k = sum(map(ord, os.path.basename(deck))) % max(len(names), 1)
    CURVES.at(deck)
    own = Deck(program, deck)
    if own.is_single or 'motion.mode' in own.inputs or 'motion.input' in own.inputs or 'motion.law' in own.inputs or not names or not any(line[-1] == 'ok' for line in lines):
        return
    rows = own.table(*diagrams.both_of(own))
    for panel, name, branch, points in diagrams.columns_of(own, (names + names)[k:k + 3]):
        inner = without_spikes(rows[branch], name)  # at an end a joint may stand still
        missing, worst, at = diagrams.off_curve(own, diagrams.Pixels(panel), points, inner, name)
        angles = [row['theta2'] for row in rows[branch] if row.values['theta2']] or [0]
        turns = abs(angles[-1] - angles[0]) * si_of(own.unit('angle')) / (2 * math.pi)
        CURVES.that(missing <= 2 * max(math.ceil(turns - 1e-9), 1) and worst <= LINE_WIDTH, name, branch, missing, 'rows without a curve', worst, 'pixels off it at', at)
        CURVES.passed += len(rows[branch]) - 1


def check_sweep(deck, folder):
    status, whole, _ = run('-f', 'csv', deck)
    if status > 1:
        return
    lines = records(whole)
    PARTS.at(deck)
    parts = [run('-f', 'csv', '--part=%d/3' % (k + 1), deck)[1] for k in range(3)]
    PARTS.that(''.join(parts) == whole, 'the parts are not the whole')
    DESIGNS.at(deck)
    designs = sorted({int(line[0]) for line in lines[1:]})
    outputs = [head.split(' (')[0] for head in lines[0]]
    with open(deck, encoding='utf-8') as text:
        words = text.read()
    output = re.search(r'^\s*output\s*=\s*(.*)$', words, re.M)
    for design in designs[:1] + designs[-1:]:
        if output:
            alone = run('-f', 'csv', '--design=%d' % design, '-c', output[1], deck)[1]
            of_sweep = [line for line in lines[1:] if int(line[0]) == design]
            found = records(alone)
            for line in found[1:]:
                match = [x for x in of_sweep if x[outputs.index('branch')] == line[0]] if 'branch' in outputs else []
                for name, cell in zip((h.split(' (')[0] for h in found[0]), line):
                    if match and name in outputs and name not in ('branch', 'status', 'yield'):
                        DESIGNS.that(match[0][outputs.index(name)] == cell, 'design', design, name, cell, 'in the sweep', match[0][outputs.index(name)])
    ranges = re.search(r'^(\s*[\w. ]+=\s*)(\d+) (mm) to (\d+) mm step (\d+) mm\s*$', words, re.M)
    if ranges and designs and '+-' not in words and int(ranges[4]) - int(ranges[2]) >= 2 * int(ranges[5]):
        CUT.at(deck)
        middle = int(ranges[2]) + int(ranges[5])
        halves = []
        for low, high in ((ranges[2], middle), (middle + int(ranges[5]), ranges[4])):
            path = os.path.join(folder, 'half.deck')
            with open(path, 'w', encoding='utf-8') as out:
                out.write(words.replace(ranges[0], '%s%s mm to %s mm step %s mm\n' % (ranges[1], low, high, ranges[5])))
            halves += [line[1:] for line in records(run('-f', 'csv', path)[1])[1:]]
        if words.count(' step ') == 1:
            CUT.that(halves == [line[1:] for line in lines[1:]], 'the halves are not the whole')


def check_order(deck, folder):
    """The options, then the deck; the deck, then the options in the opposite order."""
    path = re.sub(r'\.deck$', '.options', deck)
    if not os.path.exists(path):
        return
    with open(path, encoding='utf-8') as text:
        options = list({line.split('=')[0]: line for line in text.read().splitlines()}.values())  # of two the last one counts
    ORDER.at(deck)
    name, results = os.path.basename(deck), []
    for words in options + [name], [name] + options[::-1]:
        with tempfile.TemporaryDirectory(dir=folder) as here:
            for sub in ('answers', 'feedback'):
                os.mkdir(os.path.join(here, sub))
            for file, text in (('answers.expect', '[expect]\nat = 30 deg\nomega2 = 3 rad/s\n'), ('answers/ada.expect', '[expect]\nat = 30 deg\nomega2 = 3 rad/s\n'), ('names.txt', 'Ada\nBo\n')):
                with open(os.path.join(here, file), 'w', encoding='utf-8') as out:
                    out.write(text)
            for source in (deck, os.path.join(os.path.dirname(deck), 'card.csv')):
                if os.path.exists(source):
                    os.symlink(source, os.path.join(here, os.path.basename(source)))
            done = run(*words, folder=here)
            files = {}
            for root, _, found in os.walk(here):
                for file in found:
                    with open(os.path.join(root, file), 'rb') as out:
                        files[os.path.relpath(os.path.join(root, file), here)] = out.read()
            results.append((done, files))
    ORDER.that(results[0][0][:2] == results[1][0][:2], options, results[0][0][0], results[1][0][0])
    ORDER.that(results[0][0][2] == results[1][0][2] or results[0][0][0] == 2, options, results[0][0][2][:200], results[1][0][2][:200])
    ORDER.that(results[0][1] == results[1][1], options, 'other files')


def check(deck, program, folder):
    if os.path.exists(os.path.join(os.path.dirname(deck), 'card.csv')):
        shutil.copy(os.path.join(os.path.dirname(deck), 'card.csv'), folder)  # a deck reads files of its own folder alone
    check_order(deck, folder)
    with open(deck, encoding='utf-8') as text:
        words = text.read()
    if '[sweep]' in words:
        check_sweep(deck, folder)
        return
    if '[synthesis]' in words:
        return
    whole = run('-f', 'csv', '-c', 'all', deck)
    if whole[0] > 1 or run('-f', 'csv', deck)[0] > 1:
        return
    lines = records(whole[1])
    check_table(deck)
    check_json(deck, lines)
    check_printed(deck, folder)
    if not re.search(r'^\[(expect|misprint|grading)', words, re.M):
        check_expected(deck, folder)
    if len(whole[1]) < 200000:
        check_report(deck, folder)
    plain = os.path.join(folder, os.path.basename(deck))
    with open(plain, 'w', encoding='utf-8') as out:
        out.write(re.sub(r'^\[units\][^[]*', '', words, flags=re.M))  # drawn_units of linkage.py knows none of them
    if run('-f', 'csv', plain)[0] <= 1:
        check_curves(plain, program, lines)


def main(decks):
    for deck in map(os.path.abspath, decks):
        with tempfile.TemporaryDirectory(dir=os.path.dirname(deck)) as folder:
            check(deck, Program(fourlink, folder), folder)
    for law in LAWS:
        print('%-24s %6d decks %9d compared' % (law.name, law.decks, law.passed + law.failed))
    failed = sum(law.failed for law in LAWS)
    print('%d passed, %d failed' % (sum(law.passed for law in LAWS), failed))
    return failed > 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[3:]))
