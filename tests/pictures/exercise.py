# SPDX-License-Identifier: GPL-3.0-or-later
#
# exercise.py FOURLINK DECK... - the figure of an exercise tells nothing that is computed: each number beside it stands in the deck
# outside of [expect], in either form of a vector, or is the crank angle of the figure; each name of [expect] is in it.
import math
import os
import re
import subprocess
import sys
import tempfile

fourlink, decks = sys.argv[1], sys.argv[2:]
NUMBER = r'[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?'


def numbers_of(text):
    return {float(word) for word in re.findall(NUMBER, text)}


def given(deck):
    """The numbers of a deck without its [expect] and [misprint], and the names that these ask for."""
    numbers, names, asks = set(), [], False
    with open(deck, encoding='utf-8', errors='replace') as file:
        for line in file:
            line = line.split('#')[0].replace('−', '-').strip()
            if line.startswith('['):
                asks = re.match(r'\[\s*(expect|misprint)', line, re.I) is not None
                continue
            key, _, value = line.partition('=')
            if not asks:
                numbers |= numbers_of(value) | {-x for x in numbers_of(value)}
            elif line and key.strip() not in ('at', 'branch', 'tolerance'):
                names.append(key.strip())
            else:
                numbers |= numbers_of(value)
    return numbers, names


def is_near(x, numbers):
    return any(abs(x - y) <= 1e-5 * max(abs(x), abs(y)) for y in numbers)


def main():
    drawn = told = failed = 0
    with tempfile.TemporaryDirectory() as folder:
        picture = os.path.join(folder, 'x.svg')
        for deck in decks:
            with open(deck, encoding='utf-8', errors='replace') as file:
                if re.search(r'^\s*\[(sweep|synthesis)', file.read(), re.M):  # of which it shows one
                    continue
            done = subprocess.run([fourlink, '--plot=' + picture, '--plot-kind=exercise', deck], capture_output=True)
            if done.returncode not in (0, 1) or not os.path.exists(picture):
                continue
            drawn += 1
            with open(picture, encoding='utf-8') as file:
                lines = re.findall(r'<text[^>]*>([^<]*)</text>', file.read())
            os.remove(picture)
            numbers, names = given(deck)
            parts = {}
            for name in set(names) - {line.replace('asked: ', '') for line in lines}:
                failed += 1
                print('FAILED: %s: %s is not asked' % (deck, name))
            for line in lines:
                name, sign, value = line.partition(' = ')
                if not sign or 'fourlink' in line or name == 'θ₂':
                    continue
                told += 1
                x = float(re.match(NUMBER, value.replace('−', '-')).group())
                if re.match('load .* [xy]$', name):  # of a force that may be given by size and angle
                    parts.setdefault(name[:-2], []).append(x)
                elif x and not is_near(x, numbers):
                    failed += 1
                    print('FAILED: %s: %s' % (deck, line))
            for name, pair in parts.items():
                if not is_near(math.hypot(*pair[:2]), numbers) and not all(is_near(x, numbers | {0.0}) for x in pair):
                    failed += 1
                    print('FAILED: %s: %s %s' % (deck, name, pair))
    print('%d figures of exercises, %d values, %d not given' % (drawn, told, failed))
    return failed > 0 or not drawn


sys.exit(main())
