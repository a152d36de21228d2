# SPDX-License-Identifier: GPL-3.0-or-later
#
# drawn_angle.py FOURLINK SCENES FOLDER... - the position that a report, or the page, draws first is the deck's.
#
# For every deck, and for one instant at other crank angles: the drawing starts at the crank angle of the sample
# calculation, which is that of [motion] at if there is one, and the values of its row are those of the csv.
import glob
import json
import math
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..'))
from linkage import drawn_units  # noqa: E402

fourlink, scenes, folders = sys.argv[1], sys.argv[2], sys.argv[3:]
passed = failed = 0


def check(what, ok):
    global passed, failed
    passed += bool(ok)
    failed += not ok
    if not ok:
        print('FAILED:', what)


def run(*arguments):
    return subprocess.run([fourlink, *arguments], capture_output=True, encoding='utf-8', errors='replace')


def check_page(path, what, data):
    """What the page draws first of a deck: its own instant, else its first crank angle."""
    page = subprocess.run([scenes, path], capture_output=True, encoding='utf-8')
    if page.returncode == 0:
        scene = json.loads(page.stdout)
        start = scene['steps'][scene['start']]
        check(f'{what}: the page starts at {start}, the deck at {scene["from"]}', abs(start - scene['from']) < 1e-9 * (1 + abs(start)))
    else:
        check(f'{what}: the page draws nothing: {page.stderr}', False)


def try_deck(path, folder, *options):
    page = os.path.join(folder, 'r.html')
    if os.path.exists(page):
        os.remove(page)
    run('--report=' + page, *options, path)
    if not os.path.exists(page):
        return
    with open(page, encoding='utf-8') as file:
        text = file.read()
    rows = re.search(r'id="fourlink-rows">(.*?)</script>', text, re.S)
    what = f'{os.path.basename(path)} {" ".join(options)}'
    if not rows:
        return
    data = json.loads(rows[1])
    if data['over'] != 'theta2':
        return
    start = data['steps'][data['start']]
    caption = re.search(r'>At θ₂ = ([-−0-9.e+]+)', text)
    if caption:
        said = float(caption[1].replace('−', '-'))
        check(f'{what}: the drawing starts at {start}, the sample is at {said}', abs(start - said) <= 1e-5 * (1 + abs(said)))
    if not options:
        check_page(path, what, data)
    at = next((o.split('=')[-1].split()[0] for o in options if o.startswith('--set=motion.at')), None)
    if at is not None:
        check(f'{what}: the drawing starts at {start}', abs(start - float(at)) < 1e-9 * (1 + abs(start)))
    names = [c['name'] for c in data['columns']]
    units = drawn_units(path)
    branch = data['branches'][0]
    csv = run('--format=csv', '--branch=' + branch['name'], f'--at={start!r}', '--columns=' + ','.join(names), *units, *options, path).stdout
    lines = [line.split(',') for line in csv.splitlines() if not line.startswith('#')]
    if len(lines) < 2:
        check(f'{what}: a row at {start}', False)
        return
    table = branch['table'][data['start']]
    columns = dict(zip((h.split(' (')[0] for h in lines[0]), lines[1]))
    for name, drawn, column in zip(names, table, data['columns']):
        value = columns.get(name, '')
        if drawn is None or isinstance(drawn, str) or value in ('', 'inf', '-inf') or column.get('rounding'):
            continue
        value = float(value)
        near = 10.0 ** -column['decimals'] if column['form'] != 'exponent' else abs(value) * 1e-2
        check(f'{what}: {name} = {drawn} in the drawing, {value} in the csv', math.isclose(drawn, value, rel_tol=1e-3, abs_tol=near))


with tempfile.TemporaryDirectory() as scratch:
    decks = sorted(path for folder in folders for path in glob.glob(os.path.join(folder, '*.deck')))
    for deck in decks:
        try_deck(deck, scratch)
    for deck in ('sarkar-1.11.deck', 'alvi-5.1.deck', 'gas-engine.deck', 'whitworth-150-100.deck'):
        for path in (p for p in decks if os.path.basename(p) == deck):
            for at in ('60', '-45', '405', '0', '-720', '719.5'):
                for speed in ('10', '-10'):
                    try_deck(path, scratch, f'--set=motion.at={at} deg', f'--set=motion.speed={speed} rad/s')
print(f'{passed} passed, {failed} failed')
sys.exit(failed > 0 or passed < 100)
