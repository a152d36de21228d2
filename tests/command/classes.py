# SPDX-License-Identifier: GPL-3.0-or-later
#
# classes.py FOURLINK N [SEED] - N classes, each with an exercise, a list of names and a folder of answers as learning platforms
# hand them out, with the slips that people make.  The marks are computed here from the same files, with the equations of a
# four-bar, and compared with the program's, student by student and question by question; so is what belongs to nobody.
import cmath
import csv
import io
import math
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile

fourlink, count, seed = os.path.abspath(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]) if len(sys.argv) > 3 else 1
FIRST = ['Ada', 'Ben', 'Zoë', 'Björn', 'Jean-Luc', 'Mary Ann', 'Søren', 'José', 'Li', 'Wei', 'Dániel', 'Chloé', 'Omar', 'Eve', 'Ivo', 'Łukasz',
         'Anna Maria', 'Ravi', '伟', 'Анна']
LAST = ["O'Neil", 'Li', 'Ray', 'Ott', 'de la Cruz', 'Müller', 'Smith-Jones', 'Abel', 'Wang', 'Nuñez', 'Kim', 'van Dyk', 'Sanz', 'O’Hara', 'Grant',
        'Eng', 'May', 'Ito', '王', 'Иванова']
STRANGERS = ['Quentin Zander', 'Ulla Vest', 'Bob Tanner', 'Yusuf Haddad']
DEG = math.pi / 180
UNITS = {'deg': DEG, '°': DEG, 'degrees': DEG, 'rad': 1, 'rad/s': 1, 'rpm': 2 * math.pi / 60, 'mm': None}
WRITTEN = {'theta3': ['theta3', 'Theta_3', 'θ3', 'θ₃'], 'theta4': ['theta4', 'θ4', 'THETA4'], 'omega3': ['omega3', 'ω3', 'Omega_3'],
           'omega4': ['omega4', 'ω₄', 'Omega4'], 'swing': ['swing', 'Swing'], 'mu_min': ['mu_min', 'Mu_min', 'μ_min'],
           'mu_max': ['mu_max', 'MU_MAX']}
MEANT = {w.lower().replace('_', ''): n for n, ws in WRITTEN.items() for w in ws}
FACTS = ('swing', 'mu_min', 'mu_max')

# ------------------------------------------------------------------------------------------------------------- a four-bar


class FourBar:
    """Lengths ground, crank, coupler, rocker, and the speed of the crank; the assembly mode with C on the left of BD."""

    def __init__(self, lengths, speed):
        self.a, self.r2, self.r3, self.r4 = lengths
        self.speed = speed

    def links(self, theta2):
        crank = cmath.rect(self.r2, theta2)
        diagonal = self.a - crank  # from B to D
        d = abs(diagonal)
        angle = math.acos((self.r3**2 + d**2 - self.r4**2) / (2 * self.r3 * d))
        coupler = cmath.rect(self.r3, cmath.phase(diagonal) + angle)
        return crank, coupler, crank + coupler - self.a

    def value(self, name, theta2):
        """The value in SI units of a name, at a crank angle for a column."""
        if name in FACTS:
            return self.fact(name)
        crank, coupler, rocker = self.links(theta2)
        if name.startswith('theta'):
            return cmath.phase(coupler if name == 'theta3' else rocker)
        # i w2 crank + i w3 coupler = i w4 rocker
        w3 = -self.speed * (crank.conjugate() * rocker).imag / (coupler.conjugate() * rocker).imag
        w4 = self.speed * (crank.conjugate() * coupler).imag / (rocker.conjugate() * coupler).imag
        return w3 if name == 'omega3' else w4

    def fact(self, name):
        if name == 'swing':  # between the positions in which crank and coupler are in one line
            def rocker_to(c):
                return math.acos((self.a**2 + self.r4**2 - c**2) / (2 * self.a * self.r4))
            return abs(rocker_to(self.r3 + self.r2) - rocker_to(self.r3 - self.r2))
        mus = []
        for d in (self.a - self.r2, self.a + self.r2):  # the extremes are at a crank angle of 0 and 180 deg
            mu = math.acos((self.r3**2 + self.r4**2 - d**2) / (2 * self.r3 * self.r4))
            mus.append(mu)
        acute = [min(mu, math.pi - mu) for mu in mus]
        through = (mus[0] - math.pi / 2) * (mus[1] - math.pi / 2) < 0
        return min(acute) if name == 'mu_min' else math.pi / 2 if through else max(acute)


# ------------------------------------------------------------------------------------------------- a file of answers, read


def number_of(words):
    return float(words) if re.fullmatch(r'[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?', words) else None


def si_value(value):
    """The SI value of words such as 12.5 deg and their unit, '' for a bare number, which stays as it is; None if they are none that
    an angle or an angular velocity can have."""
    if number_of(value.strip()) is not None:
        return number_of(value.strip()), ''
    m = re.fullmatch(r'(\S+?)\s*(deg|°|degrees|rad/s|rad|rpm|mm)', value.strip())
    number = number_of(m.group(1)) if m else None
    return None if number is None or UNITS[m.group(2)] is None else (number * UNITS[m.group(2)], m.group(2))


def is_angle(unit):
    return unit in ('deg', '°', 'degrees', 'rad')


def read_answers(path):
    """{(name, crank angle or None): [words of a value, ...]} of a file."""
    with open(path, 'rb') as file:
        text = file.read().decode('utf-8-sig')
    sign = '=' if re.search('[=:]', text) else next((c for c in ';\t,' if c in text), '=')
    if sign != ',' and re.search(r'\d,\d', text) and not re.search(r'\d\.\d', text):
        text = re.sub(r'(?<=\d),(?=\d)', '.', text)
    answers, where, lost = {}, None, False
    for line in text.splitlines():
        line = line.split('#')[0].strip()
        if line.startswith('['):
            where, lost = None, False
        elif line:
            pieces = line.split('=' if '=' in line else ':', 1) if sign == '=' else line.split(sign)
            if len(pieces) < 2:
                continue
            name, value = pieces[0].strip(), ' '.join(p.strip() for p in pieces[1:])
            if name.lower() == 'at':
                angle = si_value(value)
                where, lost = (angle[0], False) if angle and is_angle(angle[1]) else (None, True)
            elif not lost and value:
                meant = MEANT.get(name.lower().replace('_', '').replace(' ', ''))
                answers.setdefault((meant, None if meant in FACTS else where), []).append(value)
    return answers


class Exercise:
    def __init__(self, r):
        while True:
            lengths = [r.uniform(60, 120) for _ in range(4)]
            lengths[1] = r.uniform(10, 40)
            s = sorted(lengths)
            if s[0] == lengths[1] and s[0] + s[3] < 0.98 * (s[1] + s[2]):
                break
        self.lengths = [round(x, 2) for x in lengths]
        self.rpm = r.choice([100, 240, -300, 50])
        self.angles = r.sample([20, 40, 75, 110, 165, 200, 250, 310], r.choice([1, 1, 2]))
        asked = r.sample(FACTS, r.choice([0, 1, 2]))
        self.questions = [(name, None) for name in asked]
        columns = ['theta3', 'theta4', 'omega3', 'omega4']
        for angle in self.angles:
            self.questions += [(name, angle) for name in r.sample(columns, r.choice([1, 2, 3]))]
        self.percent, self.degrees = r.choice([0.5, 1, 2]), r.choice([0.2, 0.5, 1])
        self.is_strict, self.is_half = r.random() < 0.3, r.random() < 0.3
        self.marks = {name: r.choice([2, 3, 0.5]) for name, _ in self.questions if r.random() < 0.3}

    def linkage(self):
        return FourBar(self.lengths, self.rpm * 2 * math.pi / 60)

    def deck(self):
        words = 'title = An exercise\nmechanism = four-bar\n'
        for link, length in zip(('ground', 'crank', 'coupler', 'rocker'), self.lengths):
            words += '[%s]\nlength = %g mm\n' % (link, length)
        words += '[motion]\nspeed = %g rpm\ninterval = 10 deg\n[table]\nbranch = open\n' % self.rpm
        for angle in [None] + self.angles:
            names = [name for name, at in self.questions if at == angle]
            if names:
                words += '[expect]\n' + ('at = %g deg\n' % angle if angle else '')
                words += ''.join('%s = 0 %s\n' % (name, 'rad/s' if name.startswith('omega') else 'deg') for name in names)
        words += '[grading]\ntolerance = %g %%, %g deg\n' % (self.percent, self.degrees)
        words += 'units = %s\n' % ('strict' if self.is_strict else 'lenient') if self.is_strict or len(self.questions) % 2 else ''
        words += 'hint = half\n' if self.is_half else ''
        return words + ''.join('%s = %g marks\n' % item for item in self.marks.items())

    def marks_of(self, path, linkage):
        """The least and the most marks of each question for a file: other slips than a sign, of which half may be lost, are not known here."""
        answers, marks = read_answers(path), []
        for name, angle in self.questions:
            given = [v for (n, at), values in answers.items() for v in values
                     if n == name and (at is None if angle is None else at is not None and abs(at - angle * DEG) < 1e-9)]
            parts = [self.part_of(name, value, linkage.value(name, (angle or 0) * DEG)) for value in given]
            marks.append(tuple(self.marks.get(name, 1) * (min(bound) if parts else 0) for bound in (zip(*parts) if parts else ((), ()))))
        return marks

    def part_of(self, name, words, computed):
        if self.is_right(name, words, computed):
            return 1, 1
        value = si_value(words)
        if not self.is_half or not value or value[1] and is_angle(value[1]) == name.startswith('omega'):
            return 0, 0
        si = value[0] if value[1] else value[0] * (1 if name.startswith('omega') else DEG)
        return (0.5, 0.5) if self.agrees(name, -si, computed) else (0, 0.5)

    def is_right(self, name, words, computed):
        value = si_value(words)
        if value and not value[1]:
            return self.is_right_bare(name, value[0], computed)
        if not value or is_angle(value[1]) == name.startswith('omega'):
            return False
        return self.agrees(name, value[0], computed)

    def is_right_bare(self, name, number, computed):
        """A number without a unit is in deg or rad/s, or in another unit where the exercise is lenient."""
        is_omega = name.startswith('omega')
        if self.agrees(name, number * (1 if is_omega else DEG), computed):
            return True
        least = 2 * (self.percent / 100 * abs(computed) + 1e-9 if is_omega else self.degrees * DEG)
        if self.is_strict or number == 0 or abs(computed) <= least:
            return False
        return any(self.agrees(name, number * factor, computed) for factor in ((UNITS['rpm'], DEG) if is_omega else (1,)))

    def agrees(self, name, value, computed):
        if name.startswith('omega'):
            return abs(value - computed) <= self.percent / 100 * abs(computed) + 1e-9
        off = (value - computed + math.pi) % (2 * math.pi) - math.pi
        return abs(off) <= self.degrees * DEG * (1 + 1e-9)


# ------------------------------------------------------------------------------------------------------- what students write


def number_words(r, x, comma):
    words = '%.6g' % x
    return words.replace('.', ',') if comma else words


def write_answers(r, exercise, linkage, slip):
    """The text of a file, with a slip."""
    form = r.choice(['=', '=', '=', ':', ';', '\t'])
    comma = r.random() < 0.2
    lines = [] if form in '=:' else [form.join(('name', 'value', 'unit'))] if r.random() < 0.5 else []
    target = r.randrange(len(exercise.questions))
    lost_angle = exercise.questions[target][1]
    before = 'nothing'

    def put(name, value, unit):
        if form in '=:':
            lines.append('%s %s %s%s' % (name, form, value, ' ' + unit if unit else ''))
        else:
            lines.append(form.join((name, value, unit)))
    for i, (name, angle) in enumerate(exercise.questions):
        if angle != before and form in '=:' and (before != 'nothing' or r.random() < 0.9):
            lines.append('[expect]')
        if angle != before and angle and not (slip == 'no place' and angle == lost_angle):
            at = {'place': 'about %g' % angle, 'other place': '%g' % (angle + 1)}.get(slip, '%g' % angle)
            put('at', at if angle == lost_angle else '%g' % angle, 'deg')
        before = angle
        x = linkage.value(name, (angle or 0) * DEG)
        unit = r.choice(['deg', 'deg', 'rad'] + (['°'] if form in '=:' else [])) if not name.startswith('omega') else r.choice(['rad/s', 'rpm'])
        words, own = number_words(r, x / UNITS[unit], comma), r.choice(WRITTEN[name])
        if i == target and slip == 'value':
            words = number_words(r, r.choice([1.4, -1, 0.5]) * x / UNITS[unit], comma)
        elif i == target and slip == 'name':
            own = 'zz' + own
        if slip == 'bare':
            unit = ''
        elif i == target and slip == 'unit':
            unit = 'mm'
        elif i == target and slip == 'words':
            words = 'x' + words
        elif i == target and slip == 'missing':
            continue
        elif i == target and slip == 'empty':
            lines.append(own + ' =' if form == '=' else '')
            continue
        put(own, words, unit)
        if i == target and slip == 'twice':
            put(own, number_words(r, 2 * x / UNITS[unit], comma), unit)
        if i == target and slip == 'not asked':
            put('gamma' if angle else 'theta4_min', '12', 'deg')
        if i == target and slip == 'line':
            lines.append('see my notes')
    if slip == 'tolerance' and form == '=':
        lines.append('tolerance = 1000 %')
    return r.choice(['\n', '\r\n']).join(lines) + '\n'


SLIPS = ['bare', 'bare', 'value', 'name', 'unit', 'words', 'missing', 'empty', 'twice', 'not asked', 'line', 'place', 'other place', 'no place', 'tolerance']

# ------------------------------------------------------------------------------------------------------- names of files


def words_of(name):
    return [w for w in re.split(r'[\s\-.,]+', re.sub("['’]", '', plain(name))) if w]


def plain(name):
    table = {'ë': 'e', 'ö': 'o', 'ü': 'u', 'é': 'e', 'á': 'a', 'ø': 'o', 'ñ': 'n', 'ł': 'l'}
    return ''.join(table.get(c, c) for c in ''.join(c.lower() if ord(c) < 0x180 else c for c in name))


class Student:
    def __init__(self, r, first, last, number):
        self.first, self.last, self.number = first, last, number
        self.name = first + ' ' + last
        self.user = '%s%d' % ('u' + str(r.randrange(100, 999)), number % 1000)
        self.email = self.user + '@school.edu'
        self.files = []  # paths within the folder that count for this student


def squeezed(words):
    return re.sub(r'[\W_]', '', words.lower())


def file_name(r, style, x, date):
    """A name of a file, or folder and file, in the style of a platform."""
    own = r.choice(['hw4', 'hw4 (final) (2)', 'answers', 'kinematics', 'Exercise 3'])
    ending = r.choice(['.txt', '.txt', '.expect', '.expect.txt', '.csv', '.TXT'])
    number = r.randrange(100000, 999999)
    name = r.choice([x.name, x.name, x.last + ' ' + x.first])
    clock = '%d%02d %s' % (r.randrange(1, 12), r.randrange(60), r.choice(['AM', 'PM']))
    if style == 'moodle':
        return '%s_%d_assignsubmission_file_%s%s' % (name, number, own, ending)
    if style == 'moodle folders':
        return '%s_%d_assignsubmission_file/%s%s' % (name, number, own, ending)
    if style == 'canvas':
        return '%s%s_%d_%d_%s%s' % (squeezed(x.last + x.first), r.choice(['', '', '_LATE']), number, number + 7, own, ending)
    if style == 'brightspace':
        return '%d-%d - %s - Nov %d, 2026 %s%s' % (number, number + 3, x.name, date, clock, ending)
    if style == 'brightspace folders':
        return '%d-%d - %s - Nov %d, 2026 %s/%s%s' % (number, number + 3, x.name, date, clock, own, ending)
    if style == 'blackboard':
        return 'Homework 4_%s_attempt_2026-11-%02d-10-30-00_%s%s' % (x.user, date, own, ending)
    if style == 'ids':
        return r.choice(['%d', 'hw4_%d', 'hw4 %d (1)']) % x.number + ending
    if style == 'surname':
        return '%s - hw4%s' % (x.last, ending)
    return r.choice([x.name, x.name.replace(' ', '_'), x.last + ', ' + x.first, x.name.upper() if x.name.isascii() else x.name]) + ending


STYLES = ['moodle', 'moodle folders', 'canvas', 'brightspace', 'brightspace folders', 'blackboard', 'ids', 'plain']


def write_list(r, students, path):
    """A list of names, or what a platform exports; returns its style."""
    style = r.choice(['list', 'moodle', 'canvas', 'names', 'brightspace'])
    out = io.StringIO()
    sign = r.choice([',', ';', '\t'])
    put = csv.writer(out, delimiter=sign, lineterminator=r.choice(['\n', '\r\n']))
    order = students[:]
    r.shuffle(order)
    if style == 'list':
        out.write(''.join(x.name + '\n' for x in order))
    elif style == 'moodle':
        put.writerow(['Surname', 'First name', 'ID number', 'Email address', 'Group'])
        for x in order:
            put.writerow([x.last, x.first, x.number, x.email, 'A'])
    elif style == 'canvas':
        put.writerow(['Student', 'ID', 'SIS Login ID', 'Section'])
        for x in order:
            put.writerow([x.name, x.number, x.user, 'Section 1'])
    elif style == 'brightspace':
        put.writerow(['OrgDefinedId', 'Username', 'Last Name', 'First Name', 'Email'])
        for x in order:
            put.writerow([x.number, x.user, x.last, x.first, x.email])
    else:
        put.writerow(['id', 'name', 'late'])
        for x in order:
            put.writerow([x.number, x.name, r.choice(['', 0])])
    with open(path, 'wb') as file:
        file.write(r.choice([b'', b'\xef\xbb\xbf']) + out.getvalue().encode())
    return style, order


def fits_part(x, words):
    return all(w in words_of(x.name) for w in words)


class Class:
    """A class with its folder: who has handed in what, and what is nobody's."""

    def __init__(self, r, folder):
        self.r, self.folder = r, folder
        self.exercise = Exercise(r)
        self.linkage = self.exercise.linkage()
        names = r.sample([(f, l) for f in FIRST for l in LAST if f != l], r.randrange(3, 25))
        self.students = [Student(r, f, l, 20000 + 17 * i + r.randrange(9)) for i, (f, l) in enumerate(names)]
        self.style, self.order = write_list(r, self.students, os.path.join(folder, 'class.csv'))
        self.wrong = []
        self.prepare()
        os.mkdir(os.path.join(folder, 'answers'))
        self.listed = []  # files that must be listed
        common = r.choice(STYLES)
        for x in self.students:
            self.hand_in(x, common if r.random() < 0.8 else r.choice(STYLES))
        for name in r.sample(STRANGERS, r.choice([0, 0, 1])):
            self.stray(name)

    def prepare(self):
        self.write_deck(self.exercise.deck())

    def write_deck(self, words):
        with open(os.path.join(self.folder, 'exercise.deck'), 'w', encoding='utf-8') as file:
            file.write(words)

    def run(self, *words):
        return subprocess.run([fourlink, *words], cwd=self.folder, capture_output=True, encoding='utf-8', errors='replace')

    def linkage_of(self, x):
        return self.linkage

    def write(self, path, slip, x):
        path = os.path.join(self.folder, 'answers', path)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        if os.path.exists(path):
            return False
        with open(path, 'wb') as file:
            text = '' if slip == 'no text' else write_answers(self.r, self.exercise, self.linkage_of(x), slip)
            file.write(self.r.choice([b'', b'', b'\xef\xbb\xbf']) + text.encode())
        return True

    def hand_in(self, x, style):
        r = self.r
        if self.style in ('list',) and style in ('ids', 'blackboard') or self.style == 'names' and style == 'blackboard':
            style = 'moodle'  # nothing else says whose it is
        if r.random() < 0.1:
            return
        slip = r.choice(SLIPS) if r.random() < 0.6 else r.choice([None, None, None, 'no text'])
        if r.random() < 0.05:
            path = file_name(r, 'surname', x, 1)
            if self.write(path, slip, x):
                others = [y for y in self.students if fits_part(y, words_of(x.last))]
                (x.files if others == [x] else self.listed).append(path)
            return
        date = r.randrange(1, 20)
        path = file_name(r, style, x, date)
        self.write(path, slip, x)
        x.files.append(path)
        if r.random() < 0.1:
            later = file_name(r, style, x, date + r.choice([0, 5]))
            if later.split('/')[0] != path.split('/')[0] and self.write(later, r.choice(SLIPS), x):
                dates = [date_of(p) for p in (path, later)]
                if None in dates or dates[0] == dates[1]:
                    x.files = []
                    self.listed += [path, later]
                else:
                    x.files = [max((path, later), key=date_of)]
                    self.listed.append(min((path, later), key=date_of))

    def stray(self, name):
        path = self.r.choice(['%s.txt', '%s_123456_assignsubmission_file_hw4.txt']) % name
        if self.write(path, None, self.students[0]):
            self.listed.append(path)

    def expected(self):
        """(name, marks of each question) in the order of the list."""
        for x in self.order:
            if x.files:
                yield x.name, self.exercise.marks_of(os.path.join(self.folder, 'answers', x.files[0]), self.linkage_of(x))
            else:
                yield x.name, [(0, 0)] * len(self.exercise.questions)

    def command(self):
        return ['--answers=answers', '--scores', '--format=csv', '--names=class.csv', 'exercise.deck']

    def mistakes(self):
        done = self.run(*self.command())
        if done.returncode < 0:
            return ['signal %d' % -done.returncode]
        rows = list(csv.reader(io.StringIO(done.stdout)))
        first = next((i for i, cell in enumerate(rows[0]) if re.match('(theta|omega)[34] at|swing|mu_m', cell)), 0) if rows else 0
        wrong, self.compared = self.wrong, 0
        if not any(files for _, _, files in os.walk(os.path.join(self.folder, 'answers'))):
            return wrong + ([] if done.returncode == 3 else ['an empty folder is marked'])
        expected = list(self.expected())
        if len(rows) != len(expected) + 1:
            return ['%d rows, not %d: %s' % (len(rows), len(expected) + 1, done.stderr)]
        for (name, marks), row in zip(expected, rows[1:]):
            given = [float(cell or 0) for cell in row[first:]]
            self.compared += len(marks)
            right = len(given) == len(marks) and all(low - 1e-9 <= x <= high + 1e-9 for x, (low, high) in zip(given, marks))
            if row[0] != name or not right or abs(float(row[1]) - sum(given)) > 1e-9:
                wrong.append('%s: %s, not %s %s' % (name, row, marks, next(x.files for x in self.students if x.name == name)))
        for path in self.listed:
            if "'%s'" % path not in done.stderr:
                wrong.append('not listed: ' + path)
        told = re.findall(r"(?:nobody's|not marked|neither)", done.stderr)
        if not self.listed and told:
            wrong.append('listed without need: ' + done.stderr)
        return wrong


class Variants(Class):
    """A class in which each student has a design; some join later, with the list in another order."""

    def prepare(self):
        r, n = self.r, len(self.students)
        crank = self.exercise.lengths[1]
        self.exercise.lengths[1] = round(crank * 0.8, 2)
        least = self.exercise.lengths[1]
        cranks = ['%.4g mm' % (least + (crank - least) * k / n) for k in range(n)]
        words = self.exercise.deck() + '[sweep]\ncrank.length = %s\n' % ', '.join(sorted(set(cranks), key=cranks.index))
        words += 'motion.speed = 100 rpm, 150 rpm, -80 rpm\n'
        self.write_deck(words.replace('mechanism', 'solver = dyad\nmechanism', 1) if r.random() < 0.5 else words)
        joined = r.randrange(0, 4) if n > 6 else 0
        late = r.sample(self.students, joined)
        everybody, self.students = self.students, [x for x in self.students if x not in late]
        path = os.path.join(self.folder, 'class.csv')
        self.style, self.order = write_list(r, self.students, path)
        command = ['--design=all', '--names=class.csv', '--print-deck', '--output=out/', 'exercise.deck']
        self.tell(self.run(*command))
        before = {x: self.handed_out(x) for x in self.students}
        if late or r.random() < 0.5:  # the list again, in another order and another style, with those who join
            self.students = everybody
            self.style, self.order = write_list(r, self.students, path)
            filled = r.choice(list(before))  # who has begun to fill in the form, which stays
            with open(os.path.join(self.folder, 'out', filled.name + '.txt'), 'a', encoding='utf-8') as file:
                file.write('# begun\n')
            before[filled][1] += '# begun\n'
            kept = '1 form is there already, and stays as it is' if len(before) == 1 else '%d forms are there already, and stay as they are' % len(before)
            self.tell(self.run(*command), 'fourlink: out/: note: %s\n' % kept)
            for x, files in before.items():
                if self.handed_out(x) != files:
                    self.wrong.append('another variant than before: ' + x.name)
        self.linkages = {x: self.linkage_in(self.handed_out(x)[0]) for x in self.students}
        if len({(tuple(v.__dict__.values())) for v in self.linkages.values()}) < len(self.students):
            self.wrong.append('two students have one variant')

    def tell(self, done, wanted=''):
        if done.returncode or done.stderr != wanted:
            self.wrong.append('%s: %d' % (done.stderr, done.returncode))

    def handed_out(self, x):
        """The deck and the form of a student."""
        texts = []
        for ending in ('.deck', '.txt'):
            with open(os.path.join(self.folder, 'out', x.name + ending), encoding='utf-8') as file:
                texts.append(file.read())
        if re.search(r'solver|\[(expect|grading|sweep)', texts[0]) or texts[1].count(' =') < len(self.exercise.questions):
            self.wrong.append('what is handed out: ' + x.name)
        return texts

    def linkage_in(self, deck):
        lengths = [float(re.search(r'\[%s\]\nlength = (\S+) mm' % link, deck).group(1)) for link in ('ground', 'crank', 'coupler', 'rocker')]
        return FourBar(lengths, float(re.search(r'speed = (\S+) rpm', deck).group(1)) * 2 * math.pi / 60)

    def linkage_of(self, x):
        return self.linkages[x]

    def command(self):
        return ['--answers=answers', '--scores', '--format=csv', '--names=out/class.csv', 'exercise.deck']


def date_of(path):
    m = re.search(r'Nov (\d+), 2026 (\d+)(\d\d) ([AP])M', path)
    if m:
        day, hour, minute, half = m.groups()
        return int(day) * 1440 + (int(hour) % 12 + 12 * (half == 'P')) * 60 + int(minute)
    m = re.search(r'2026-11-(\d\d)', path)
    return int(m.group(1)) * 1440 + 630 if m else None


def main():
    compared = failed = students = 0
    for i in range(count):
        folder = tempfile.mkdtemp()
        x = (Variants if i % 3 == 2 else Class)(random.Random(seed * 1000003 + i), folder)
        wrong = x.mistakes()
        compared += getattr(x, 'compared', 0)
        students += len(x.students)
        if wrong:
            failed += 1
            if failed < 4:
                print('FAILED: class %d of seed %d: %s' % (i, seed, '\n  '.join(wrong[:6])))
                if os.environ.get('KEEP'):
                    print(folder)
                    continue
        shutil.rmtree(folder)
    print('%d classes, %d students, %d marks compared; %d classes wrong' % (count, students, compared, failed))
    return failed > 0


sys.exit(main())
