# SPDX-License-Identifier: GPL-3.0-or-later
#
# csv_difference.py FILE OTHER [TOLERANCE [COLUMN...]] - compares the csv of two machines or versions.
#
# Prints "same", "within" or "differs", the number of values, and the largest difference of a value, divided by the
# largest value of its column (of one that is small beside others of its unit, a thousandth of theirs: all of it may be
# rounding), with the name of the column.  More than TOLERANCE (2e-12) differs, and so do other words.
# The values of each COLUMN are not compared; +COLUMN is one that OTHER has besides.  Angles are compared modulo 360 deg; the residual, which is rounding
# itself, has the largest value 1, and that of the energy, which has the error of the integration, 10.
import csv
import re
import sys

from compare import sizes_of

NUMBER = re.compile(r'-?[0-9.]+(e[-+]?[0-9]+)?$')


def records(path):
    with open(path, newline='', encoding='utf-8') as file:
        return list(csv.reader(file, strict=True))


def without(rows, added):
    """Rows without the columns that were added."""
    keep = [i for i, name in enumerate(rows[0] if rows else []) if '+' + name.split(' ')[0] not in added]
    return [[row[i] for i in keep if i < len(row)] for row in rows]


def compared(head, ours, theirs, omitted):
    """Do the words agree?  And how many values, and of each column the largest difference."""
    agree = [len(row) for row in ours] == [len(row) for row in theirs] and ours[:1] == theirs[:1]
    count, difference = 0, {}
    for row, other in zip(ours[1:], theirs[1:]):
        for name, a, b in zip(head, row, other):
            if name.split(' ')[0] in omitted:
                continue
            if not NUMBER.match(a) or not NUMBER.match(b):
                agree = agree and a == b
                continue
            count += 1
            d = abs(float(a) - float(b))
            d = abs(d - 360) if name.endswith('(deg)') and d > 180 else d
            difference[name] = max(difference.get(name, 0), d)
    return agree, count, difference


def size_of(name, sizes):
    """What the differences of a column are divided by."""
    if 'residual' in name:
        return 10 if name.startswith('energy') else 1
    return sizes.get(name.split(' ')[0]) or 1


def main(path, other, most='2e-12', *omitted):
    ours, theirs = records(path), without(records(other), omitted)
    agree, count, difference = compared(ours[0] if ours else [], ours, theirs, omitted)
    with open(path, 'rb') as file:
        sizes = sizes_of(file.read())
    worst, where = max(((d / size_of(name, sizes), name) for name, d in difference.items()), default=(0, ''))
    outcome = 'differs' if not agree or worst > float(most) else 'same' if ours == theirs else 'within'
    print(outcome, count, '%g' % worst, where)


main(*sys.argv[1:])
