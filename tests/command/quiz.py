# SPDX-License-Identifier: GPL-3.0-or-later
#
# quiz.py [--moocloze] FOURLINK DECK... - the quiz of each deck with [expect], read back by the grammar of Moodle's embedded answers
# (question/type/multianswer/questiontype.php): a question for each design, a field for each value.  Values and tolerances
# are those of --check, the marks in the same proportion; what is right gets all marks, a slip its part and its hint, and no
# title or text becomes a field.  The figure is well-formed.  With --moocloze each field of a value is also written by that
# package of PyPI, and has to begin as it does.
import base64
import csv
import html
import io
import math
import os
import random
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..'))
from linkage import Checks, si_of  # noqa: E402

moocloze = None
if sys.argv[1] == '--moocloze':
    import moocloze
    del sys.argv[1]
fourlink, decks = sys.argv[1], sys.argv[2:]
checks = Checks()
NUMBER = r'-?(?:[0-9]+[.,]?[0-9]*|[.,][0-9]+)(?:[eE][-+]?[0-9]+)?'
ALTERNATIVE = r'(=|%-?[0-9]+%)?(.+?(?<!\\)(?<!&)(?=[~#}]|$))(#(.*?(?<!\\)(?=[~}]|$)))?'
FIELD = re.compile(r'\{([0-9]*):(NUMERICAL|NM|MULTICHOICE|MC|SHORTANSWER|SA|MW):((?:%s)(?:~(?:%s))*)\}' % (ALTERNATIVE, ALTERNATIVE))
WILD = ['{1:NUMERICAL:=3}', 'no #1', 'a & b', '<b>', 'x ~ y', '50 % = half', ']]>', '"quoted"', "it's", 'a/b', '{', '}', '\\', 'Ärger', '&amp;', '$course$']
counts = {'questions': 0, 'fields': 0, 'slips': 0}


def run(*words):
    done = subprocess.run([fourlink, *words], capture_output=True, encoding='utf-8', errors='replace')
    return done.returncode, done.stdout, done.stderr


def alternatives(text):
    """[(part, answer, hint)] of the inside of a field."""
    found, end = [], 0
    while end < len(text):
        m = re.compile(ALTERNATIVE).match(text, end)
        end = m.end() + 1  # behind the ~
        part = m.group(1) or ''
        found.append((1 if part == '=' else float(part.strip('%')) / 100 if part else 0, m.group(2), html.unescape(m.group(4) or '')))
    return found


def grade(field, number):
    """What Moodle gives for a number: the first that agrees, and its hint."""
    for part, answer, hint in alternatives(field):
        m = re.fullmatch('(%s)(?::(%s))?' % (NUMBER, NUMBER), answer)
        checks.that(m, 'not a number:', answer)
        if m and abs(number - float(m.group(1))) <= float(m.group(2) or 0) * (1 + 1e-9):
            return part, hint
    return 0, ''


def expected(deck, design, *options):
    """The lines of --check of a design, and all marks if there are no misprints, which alone can have no value here."""
    words = ['--check', '-f', 'csv', *options, deck] if not design else ['--check', '-f', 'csv', '--design=%d' % design, *options, deck]
    _, out, _ = run(*words)
    lines = list(csv.DictReader(io.StringIO(out)))
    asked = [x for x in lines if x['name'] and x['result'] not in ('misprint confirmed', 'not a misprint', 'no value')]
    has_others = any(x['name'] and x not in asked for x in lines)
    return asked, None if has_others else sum(float(x['of']) for x in lines if x['of'])


def number(words):
    try:
        return float(words)
    except ValueError:
        return None


def check_field(what, kind, text, unit, line):
    computed, tolerance = number(line['computed']), number(line['tolerance'])
    if computed is not None and unit and unit != line['unit']:
        factor = si_of(line['unit']) / si_of(unit)
        computed, tolerance = computed * factor, tolerance * factor
    counts['fields'] += 1
    if computed is None or not math.isfinite(computed):
        checks.that(kind == 'SHORTANSWER', what, kind, line['computed'])
        checks.that(line['computed'] in [a for p, a, _ in alternatives(html.unescape(text)) if p == 1], what, text, line['computed'])
        return
    checks.that(kind == 'NUMERICAL', what, kind)
    checks.that(grade(text, computed) == (1, ''), what, 'right is not', text, computed)
    checks.that(grade(text, computed + 0.99 * tolerance)[0] == 1, what, 'within the tolerance', text, tolerance)
    outside = grade(text, computed + 1.01 * tolerance)
    checks.that(outside[0] < 1, what, 'outside of the tolerance', text, tolerance)
    for part, answer, hint in alternatives(text)[1:]:
        if not hint:
            continue
        value = float(answer.split(':')[0])
        counts['slips'] += 1
        checks.that(abs(value - computed) > tolerance, what, 'a slip that is right', answer)
        if 'sign' in hint:
            off = min(abs(value + computed), abs(abs(value + computed) - 360), abs(abs(value + computed) - 2 * math.pi))
            checks.that(off <= 1e-8 * abs(computed) + 1e-7, what, 'not the opposite', answer)
        if 'rpm' in hint:
            checks.that(abs(value - computed * 30 / math.pi) <= 1e-8 * abs(value), what, 'not in rpm', answer)
        checks.that(grade(text, value) == (part, hint), what, 'a slip before it', answer)


def check_format(what, weight, kind, text):
    """A field without its slips is as another program writes it."""
    if not moocloze:
        return
    answer = alternatives(text)[0][1]
    if kind == 'NUMERICAL':
        value, tolerance = answer.split(':')
        other = str(moocloze.Numerical(answer=value, tolerance=tolerance, show_tolerance=False, weight=weight))
    else:
        other = str(moocloze.ShortAnswer(answer=html.unescape(answer), weight=weight))
    checks.that(other == html.unescape('{%d:%s:=%s}' % (weight, kind, answer)), what, other, text)
    counts['written by moocloze too'] = counts.get('written by moocloze too', 0) + 1


def try_deck(deck, title):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, 'quiz.xml')
        options = ['--tolerance=1 %', '-s', 'title=' + title]
        status, _, errors = run('--quiz=' + path, *options, deck)
        if status:
            checks.that(errors, deck, 'no word why')
            checks.that(not os.path.exists(path), deck, 'a file although it failed')
            return
        root = ET.parse(path).getroot()
    questions = root.findall('question')
    shown = title
    checks.that(questions[0].get('type') == 'category', deck, 'no category')
    checks.that(questions[0].find('category/text').text.strip() == '$course$/' + shown.replace('/', '//'), deck, questions[0].find('category/text').text)
    for i, q in enumerate(questions[1:]):
        what = '%s question %d' % (os.path.basename(deck), i + 1)
        design = i + 1 if len(questions) > 2 else 0
        text = q.find('questiontext/text').text
        counts['questions'] += 1
        checks.that(q.get('type') == 'cloze' and q.find('name/text').text.startswith(shown), what, q.find('name/text').text)
        checks.that(shown in html.unescape(text), what, 'no title in the text')
        ET.fromstring(base64.b64decode(q.find('questiontext/file').text))
        ET.fromstring('<p xmlns="http://www.w3.org/1999/xhtml">' + q.find('generalfeedback/text').text + '</p>')
        fields = [(int(m.group(1)), m.group(2), m.group(3), re.match(r' ?([^<]*)', text[m.end():]).group(1)) for m in FIELD.finditer(text)]
        lines, of = expected(deck, design, '--tolerance=1 %')
        if checks.that(len(fields) == len(lines), what, len(fields), 'fields for', len(lines)):
            in_order = sorted(lines, key=lambda x: (int(x['line']) if x['line'] else 0))
            times = sum(f[0] for f in fields) / of if of else 1
            checks.that(abs(times - round(times)) < 1e-9, what, 'marks', [f[0] for f in fields], 'of', of)
            for weight, kind, words, _ in fields:
                check_format(what, weight, kind, words)
            for (weight, kind, words, unit), line in zip(fields, in_order):
                check_field('%s, %s' % (what, line['name']), kind, words, html.unescape(unit), line)


r = random.Random(1)
for each in decks:
    with open(each, encoding='utf-8', errors='replace') as file:
        if re.search(r'^\[expect', file.read(), re.M):
            try_deck(each, ' '.join(r.sample(WILD, 3)))
print('%d decks, %s' % (len(decks), ', '.join('%d %s' % (n, what) for what, n in counts.items())))
sys.exit(checks.finish())
