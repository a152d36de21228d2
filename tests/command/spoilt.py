# SPDX-License-Identifier: GPL-3.0-or-later
#
# spoilt.py FOURLINK N [SEED] - N files of answers, written as people do: commas, colons, spreadsheets, other letters, no header, other
# line ends and encodings, which cost nothing; then one line that is spoilt, which costs the values that it should and no more.
import os
import random
import subprocess
import sys
import tempfile

fourlink, count, seed = sys.argv[1], int(sys.argv[2]), int(sys.argv[3]) if len(sys.argv) > 3 else 1
DECK = '''mechanism = four-bar
[ground]
length = 200 mm
[crank]
length = 50 mm
[coupler]
length = 180 mm
mass = 1.2 kg
uniform = yes
[rocker]
length = 120 mm
mass = 0.8 kg
uniform = yes
[load L]
link = rocker
torque = -20 N m
[motion]
speed = 200 rpm
interval = 10 deg
[table]
branch = open
columns = theta3, theta4, omega4, F12, Ts
[expect]
%s
[grading]
tolerance = 1 %%, 0.5 deg
'''
NAMES = {'theta3': ['theta3', 'Theta3', 'THETA_3', 'θ3', 'θ₃', 'theta_3'], 'theta4': ['theta4', 'θ4', 'Theta_4'],
         'omega4': ['omega4', 'OMEGA4', 'ω4', 'ω₄'], 'F12': ['F12', 'f12', 'F_12'], 'Ts': ['Ts', 'TS', 'ts', 'T_s']}
UNITS = {'theta3': ['deg', '°', 'degrees'], 'theta4': ['deg', '°'], 'omega4': ['rad/s', 'rad/sec'], 'F12': ['N', 'newton'], 'Ts': ['N m', 'N.m', 'Nm']}


def run(*words):
    return subprocess.run([fourlink, *words], capture_output=True, encoding='utf-8', errors='replace')


def truth(folder, deck):
    """(angle, name, value) of all values that are asked."""
    out = run('--format=csv', '--at=60 deg, 200 deg', deck).stdout.splitlines()
    names = [name.split(' ')[0] for name in out[0].split(',')]
    values = []
    for angle, line in zip(('60', '200'), out[1:]):
        values += [(angle, name, float(x)) for name, x in zip(names, line.split(',')) if name in NAMES]
    return values


def written(r, values, spoilt):
    """The text of a file, and how many values are lost."""
    form = r.choice(['=', ':', '=', ';', '\t', ','])
    comma = form != ',' and r.random() < 0.4
    lines, lost, where = [], 0, None
    header = form in '=:' and r.random() < 0.8
    if form in ';\t,' and r.random() < 0.7:
        lines.append(form.join(('name', 'value', 'unit')))

    def put(name, value, unit):
        if form in '=:':
            lines.append('%s%s%s%s%s %s' % (name, r.choice(['', ' ']), form, r.choice(['', ' ', '  ']), value, unit))
        else:
            lines.append(form.join((name, value, unit)) if unit else form.join((name, value)))
    target = r.randrange(len(values)) if spoilt else None
    kind = r.choice(['value', 'line', 'name', 'place']) if spoilt else None
    bad_angle = values[target][0] if kind == 'place' else None
    for i, (angle, name, value) in enumerate(values):
        if angle != where:
            where = angle
            if header:
                lines.append('[expect]')
            if angle == bad_angle:
                put('at', 'about ' + angle, 'deg')
            else:
                put(r.choice(['at', 'At', 'AT']), angle, r.choice(['deg', '°']) if form in '=:' else 'deg')
            if r.random() < 0.5:
                put('branch', 'open', '')
        number = '%.6g' % value
        number = number.replace('.', ',') if comma else number
        own = r.choice(NAMES[name])
        lost += angle == bad_angle
        if i == target and kind != 'place':
            lost += 1
            if kind == 'value':
                number = 'x' + number
            elif kind == 'name':
                own = 'zz' + own
            else:
                lines.append('something else')
                continue
        put(own, number, r.choice(UNITS[name]))
        if r.random() < 0.1:
            lines.append('')
    text = r.choice(['\n', '\r\n']).join(lines) + r.choice(['', '\n'])
    if not any(c in text for c in '=:') and form in '=:':
        return None
    return text, lost


def main():
    r = random.Random(seed)
    passed = failed = 0
    with tempfile.TemporaryDirectory() as folder:
        deck, answers = os.path.join(folder, 'a.deck'), os.path.join(folder, 'answers.txt')
        with open(deck, 'w', encoding='utf-8') as file:
            file.write(DECK % '')
        values = truth(folder, deck)
        asked = ''
        for angle in ('60', '200'):
            asked += '[expect]\nat = %s deg\nbranch = open\n' % angle + ''.join('%s = 0 %s\n' % (n, UNITS[n][0]) for a, n, _ in values if a == angle)
        with open(deck, 'w', encoding='utf-8') as file:
            file.write(DECK.replace('[expect]\n%s', '%s') % asked)
        for i in range(count):
            text, lost = written(r, values, i % 2)
            with open(answers, 'wb') as file:
                file.write(text.encode(r.choice(['utf-8', 'utf-8', 'utf-8-sig', 'utf-16'])))
            done = run('--check=' + answers, '--scores', '--format=csv', deck)
            cells = done.stdout.splitlines()[-1].split(',') if done.stdout else ['', '-1', '-1']
            if (float(cells[1]), float(cells[2])) == (len(values) - lost, len(values)):
                passed += 1
            else:
                failed += 1
                if failed < 4:
                    print('FAILED: %s of %s, not %d of %d:\n%s\n%s' % (cells[1], cells[2], len(values) - lost, len(values), text, done.stderr))
    print('%d files of answers, %d wrong' % (count, failed))
    return failed > 0


sys.exit(main())
