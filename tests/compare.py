# SPDX-License-Identifier: GPL-3.0-or-later
#
# compare.py OLD NEW DECK... - do two builds of the program print the same of these decks?  Rows, summary, check, matrix and
# json; reports of every tenth deck.  Exit statuses and messages are compared word for word, numbers of rows within 1e-9 of
# their column's scale, extremes within 1e-6 of it.  Prints what differs, which rows of a table ten times as fine lie
# beyond an extreme (where a joint with friction stands still they may), how much is the same to the byte, and "N passed, M
# failed".
#
# compare.py --csv FILE OTHER [TOLERANCE [COLUMN...]] - compares the csv of two machines or versions.  Prints "same", "within"
# or "differs", the number of values, and the largest difference, with the name of its column; more than TOLERANCE (2e-12)
# differs, and so do other words.  The values of each COLUMN are not compared; +COLUMN is one that OTHER has besides.
#
# The one tolerance: a value may differ by a part of the scale of its column, which is its largest value; of a column that is
# small beside others of its unit, which may be rounding error, a thousandth of theirs.  Angles are compared modulo 360 deg;
# what is rounding error itself has the scale 1, the residual of the energy, with the error of the integration, 10.
import csv
import io
import math
import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

OUTPUTS = {
    'csv': ['--format=csv', '--columns=all'],
    'table': [],
    'summary': ['--format=csv', '--summary', '--columns=all'],
    'check': ['--check'],
    'matrix': ['--matrix'],
    'json': ['--format=json'],
}
ROWS, EXTREMES = 1e-9, 1e-6
NUMBER = re.compile(r'-?\d[\d.]*(?:e[-+]?\d+)?|-?inf|nan')


def run(program, arguments):
    """Exit status, output and messages."""
    try:
        done = subprocess.run([program] + arguments, capture_output=True, stdin=subprocess.DEVNULL, timeout=300)
    except subprocess.TimeoutExpired:
        return 'no end', b'', b''
    return done.returncode, done.stdout, done.stderr


def records_of(output):
    return list(csv.reader(io.StringIO(output), strict=True))


def sizes_of(records):
    """The scale of each column, by its name without its unit."""
    found = {}
    for record in records[1:]:
        for name, value in zip(records[0], record):
            if re.fullmatch(NUMBER, value) and math.isfinite(float(value)):
                key = name.split(' ')[0]
                found[key] = max(found.get(key, 0), abs(float(value)))
    units = dict(name.split(' ', 1) for name in (records[0] if records else ()) if ' ' in name)
    of_unit = {unit: max(found.get(key, 0) for key in units if units[key] == unit) for unit in units.values()}
    return {key: max(size, 1e-3 * of_unit.get(units.get(key), 0)) for key, size in found.items()}


def size_of(column, sizes):
    """The scale; 1 for a column of zeros or words."""
    if column == 'energy_residual':
        return 10
    return 1 if 'residual' in column or column == 'superposition' else sizes.get(column) or 1


def difference(old, new):
    """The words that differ apart from numbers, and the largest difference of a number."""
    if re.sub(NUMBER, '#', old).split() != re.sub(NUMBER, '#', new).split():
        return math.inf
    worst = 0
    for a, b in zip(re.findall(NUMBER, old), re.findall(NUMBER, new)):
        if a != b:
            worst = max(worst, abs(float(a) - float(b)) if math.isfinite(float(a)) and math.isfinite(float(b)) else math.inf)
    return worst


def compare_records(ours, theirs, sizes, omitted=()):
    """How many numbers, and of each column the largest difference, of its scale, with both values; inf: other words."""
    count, worst = 0, {}
    if [len(row) for row in ours] != [len(row) for row in theirs] or ours[:1] != theirs[:1]:
        worst['rows'] = math.inf, len(ours), len(theirs)
    for row, other in zip(ours[1:], theirs[1:]):
        for name, a, b in zip(ours[0], row, other):
            if name.split(' ')[0] in omitted:
                continue
            count += bool(re.fullmatch(NUMBER, a)) and math.isfinite(float(a))
            d = difference(a, b) if a != b else 0
            d = abs(d - 360) if name.endswith('(deg)') and 180 < d < math.inf else d
            worst[name] = max(worst.get(name, (0, a, b)), (d / size_of(name.split(' ')[0], sizes), a, b))
    return count, worst


def compare_csv(old, new, sizes):
    for name, (d, a, b) in compare_records(records_of(old), records_of(new), sizes)[1].items():
        if d > ROWS:
            yield '%s: %s, %s' % (name, a, b)


def compare_summary(old, new, sizes):
    ours, theirs = ({tuple(r[:1] + r[4:]): r for r in csv.reader(io.StringIO(text))} for text in (old, new))
    for key in sorted(set(ours) ^ set(theirs)):
        yield '%s is in one only' % ', '.join(key)
    for key in set(ours) & set(theirs):
        a, b = ours[key][1], theirs[key][1]
        column = re.sub(r'^\w+\((.*)\)$', r'\1', key[0])
        if a != b and difference(a, b) > EXTREMES * size_of(column, sizes):
            yield '%s: %s, %s' % (', '.join(key), a, b)


def beyond_extremes(program, deck, summary, sizes):
    """Rows of a finer table beyond the extremes of the summary."""
    wanted = {}
    for r in csv.reader(io.StringIO(summary)):
        match = re.fullmatch(r'(max|min)\((.*)\)', r[0])
        if match and re.fullmatch(NUMBER, r[1]):
            for branch in (r[4],) if r[4] else ('open', 'crossed'):
                wanted[match.group(2), branch, match.group(1)] = float(r[1])
    interval = [r[1:3] for r in csv.reader(io.StringIO(summary)) if r[0] == 'motion.interval']
    if not interval:
        return
    fine = '--interval=%.17g %s' % (float(interval[0][0]) / 10, interval[0][1])
    records = list(csv.reader(io.StringIO(run(program, ['--format=csv', '--columns=all', fine, deck])[1].decode())))
    for record in records[1:]:
        for name, value in zip(records[0], record):
            column = name.split(' ')[0]
            if name.endswith(('(deg)', '(rad)')) or not re.fullmatch(NUMBER, value) or not math.isfinite(float(value)):
                continue
            for which, sign in (('max', 1), ('min', -1)):
                limit = wanted.get((column, record[0], which))
                if limit is not None and sign * (float(value) - limit) > EXTREMES * size_of(column, sizes):
                    yield '%s of %s is %s, at %s a row has %s' % (which, column, limit, record[1], value)


def compare(old, new, deck, has_report):
    """What differs, and how many outputs are the same to the byte."""
    wrong, same, summary, sizes = [], 0, '', {}
    outputs = dict(OUTPUTS)
    with tempfile.TemporaryDirectory() as folder:
        if has_report:
            outputs['report'] = ['--report=' + os.path.join(folder, 'r.html')]
        for name, arguments in outputs.items():
            results = []
            for program in (old, new):
                status, out, messages = run(program, arguments + [deck])
                if name == 'report' and os.path.exists(os.path.join(folder, 'r.html')):
                    with open(os.path.join(folder, 'r.html'), 'rb') as page:
                        out = page.read()
                results.append((status, out, messages))
            (status, out, messages), (status_new, out_new, messages_new) = results
            if (status, messages) != (status_new, messages_new):
                wrong.append('%s: %s %r, %s %r' % (name, status, messages[:200], status_new, messages_new[:200]))
            sizes = sizes_of(records_of(out.decode('utf-8', 'replace'))) if name == 'csv' else sizes
            summary = out_new.decode('utf-8', 'replace') if name == 'summary' else summary
            if out == out_new:
                same += 1
                continue
            texts = out.decode('utf-8', 'replace'), out_new.decode('utf-8', 'replace')
            if name == 'csv':
                found = list(compare_csv(*texts, sizes))
            elif name == 'summary':
                found = list(compare_summary(*texts, sizes))
            else:
                found = ['other words'] if difference(*texts) == math.inf else []
            wrong += ['%s: %s' % (name, words) for words in found]
    return deck, wrong, list(beyond_extremes(new, deck, summary, sizes)), same, len(outputs)


def compare_files(path, other, most='2e-12', *omitted):
    ours, theirs = (records_of(open(name, newline='', encoding='utf-8').read()) for name in (path, other))
    keep = [i for i, name in enumerate(theirs[0] if theirs else []) if '+' + name.split(' ')[0] not in omitted]
    theirs = [[row[i] for i in keep if i < len(row)] for row in theirs]
    count, found = compare_records(ours, theirs, sizes_of(ours), omitted)
    worst, where = max(((d, name) for name, (d, _, _) in found.items()), default=(0, ''))
    print('differs' if worst > float(most) else 'same' if ours == theirs else 'within', count, '%g' % worst, where)


def main(old, new, *decks):
    same = outputs = failed = 0
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for deck, wrong, beyond, n, of in pool.map(lambda k: compare(old, new, decks[k], k % 10 == 0), range(len(decks))):
            same, outputs, failed = same + n, outputs + of, failed + bool(wrong)
            for line in wrong[:20] + beyond[:3]:
                print('%s: %s' % (os.path.basename(deck), line))
    print('%d of %d outputs are the same to the byte' % (same, outputs))
    print('%d passed, %d failed' % (len(decks) - failed, failed))
    return failed > 0


if __name__ == '__main__':
    sys.exit(compare_files(*sys.argv[2:]) if sys.argv[1] == '--csv' else main(*sys.argv[1:]))
