# SPDX-License-Identifier: GPL-3.0-or-later
#
# class.py FOURLINK [STUDENTS] - a class of 2,000, each with a variant of their own and 20 questions: decks, forms and the list are
# written, and all answers marked, in 10 s of a processor and 100 MB each.  Every 40th student has answers of another's variant, the others right ones.
import csv
import os
import random
import resource
import subprocess
import sys
import tempfile

fourlink, students = os.path.abspath(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 2000
SECONDS, MEGABYTES = 10, 100
COLUMNS = ['theta3', 'theta4', 'omega3', 'omega4', 'alpha3', 'alpha4', 'F12', 'F23', 'F34', 'Ts']
DECK = '''mechanism = four-bar
[ground]
length = 80 mm
[crank]
length = 20 mm
[coupler]
length = 66 mm
mass = 0.2 kg
uniform = yes
[rocker]
length = 56 mm
mass = 0.3 kg
uniform = yes
[motion]
speed = 300 rpm
interval = 10 deg
[table]
branch = open
%s[grading]
tolerance = 0.01 %%, 0.01 deg
[sweep]
crank.length = 15 mm to 25 mm step 0.1 mm
motion.speed = 100 rpm to 600 rpm step 20 rpm
''' % ''.join('[expect]\nat = %d deg\n%s' % (angle, ''.join(name + ' = 0\n' for name in COLUMNS)) for angle in (40, 200))


def run(*words):
    began = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([fourlink, *words], capture_output=True, text=True)
    end = resource.getrusage(resource.RUSAGE_CHILDREN)
    return done, end.ru_utime + end.ru_stime - began.ru_utime - began.ru_stime


def main():
    r = random.Random(5)
    parts = ['ka', 'lo', 'mi', 'ren', 'tas', 'vo', 'zu', 'bel', 'dor', 'fin', 'gar', 'hel']
    names = set()
    while len(names) < students:
        names.add(tuple(''.join(r.choice(parts) for _ in range(3)).capitalize() + end for end in ('a', 'sen')))
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        with open('class.csv', 'w') as file:
            file.write('Surname,First name,ID number\n' + ''.join('%s,%s,%d\n' % (x[1], x[0], 50000 + i) for i, x in enumerate(sorted(names))))
        with open('variants.deck', 'w') as file:
            file.write(DECK)
        written, first = run('--design=all', '--names=class.csv', '--print-deck', '--output=out/', 'variants.deck')
        os.mkdir('answers')
        with open('out/class.csv') as file:
            rows = list(csv.DictReader(file))
        for i, row in enumerate(rows):
            design = int(row['design'])
            design += i % 40 == 0
            text, _ = run('--design=%d' % design, '--expect', '--at=40 deg, 200 deg', '--columns=' + ','.join(COLUMNS), 'variants.deck')
            with open('answers/%s%s_%d_%d_hw4.txt' % (row['Surname'].lower(), row['First name'].lower(), 9000 + i, i + 7), 'w') as file:
                file.write(text.stdout)
        marked, second = run('--answers=answers', '--scores', '--names=out/class.csv', '--format=csv', 'variants.deck')
        os.chdir('/')
    marks = list(csv.DictReader(marked.stdout.splitlines()))
    wrong = sum((row['right'] == '20') != (i % 40 != 0) for i, row in enumerate(marks)) + abs(len(marks) - students)
    most = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
    print('%d students: written in %.1f s, marked in %.1f s, %.0f MB, %d wrong' % (students, first, second, most, wrong))
    return written.returncode or wrong > 0 or max(first, second) > SECONDS or most > MEGABYTES


sys.exit(main())
