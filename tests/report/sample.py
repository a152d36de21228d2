# SPDX-License-Identifier: GPL-3.0-or-later
#
# sample.py REPORT... [NAME=VALUE...] - checks the sample calculations of reports: evaluates every equation from the
# numbers that are printed in it, and compares it with the printed result.
#
# A printed number is right within half a unit of its last digit (6 significant digits; an angle has 4 decimals of
# a degree).  An equation agrees if the difference can come from that.  With NAME=VALUE, the result NAME has
# that value, within a unit of the last digit.  Prints what is wrong, and how many samples were checked.
import math
import re
import sys
import xml.etree.ElementTree as xml

M = '{http://www.w3.org/1998/Math/MathML}'
H = '{http://www.w3.org/1999/xhtml}'
NAMES = {'sin': 'sin', 'cos': 'cos', 'arcsin': 'asin', 'arccos': 'acos', 'atan2': 'atan2'}
FUNCTIONS = {'sin': math.sin, 'cos': math.cos, 'atan2': math.atan2, 'sqrt': lambda x: math.sqrt(max(x, 0)),
             'asin': lambda x: math.asin(max(-1, min(1, x))), 'acos': lambda x: math.acos(max(-1, min(1, x)))}
OPERATORS = {'/': '/', '\u2212': '-', '+': '+', '\u00b7': '*', '(': '(', ')': ')', ',': ',', '=': '=', '\u2061': '', '\u2062': '*'}


def half_unit(x):
    return 0.5 * 10 ** (math.floor(math.log10(abs(x))) - 5) if x else 0


class Reader:
    """Turns MathML into the text of an expression over the numbers v[0], v[1] ..."""

    def __init__(self):
        self.values, self.errors = [], []

    def number(self, words):
        is_angle = words.endswith('\u00b0')
        x = float(words.rstrip('\u00b0'))
        self.values.append(math.radians(x) if is_angle else x)
        self.errors.append(math.radians(0.5e-4) if is_angle else half_unit(x))
        return 'v[%d]' % (len(self.values) - 1)

    def row(self, elements):
        out, i = '', 0
        elements = [e for e in elements if e.tag not in (M + 'mspace', M + 'mtext')]
        while i < len(elements):
            e = elements[i]
            i += 1
            if e.tag == M + 'mi' and e.text in NAMES:
                out += NAMES[e.text]
                i += elements[i].text == '\u2061'
                if elements[i].tag != M + 'mo':
                    out += '(' + self.element(elements[i]) + ')'
                    i += 1
            else:
                out += self.element(e)
        return out

    def element(self, e):
        if e.tag == M + 'mn':
            return self.number(e.text)
        if e.tag == M + 'mo':
            return OPERATORS[e.text]
        if e.tag == M + 'mrow':
            return '(' + self.row(e) + ')'
        if e.tag == M + 'msqrt':
            return 'sqrt(' + self.row(e) + ')'
        if e.tag == M + 'mfrac':
            return '(' + self.element(e[0]) + '/' + self.element(e[1]) + ')'
        if e.tag == M + 'msup' and e[0].text == '10' and e[1].text != '2':
            return '10**(%s)' % e[1].text.replace('\u2212', '-')
        if e.tag == M + 'msup':
            return self.element(e[0]) + '**2'
        raise ValueError('unexpected ' + e.tag)

    def evaluate(self, expression, values=None):
        return eval(expression, dict(FUNCTIONS, v=values or self.values))

    def bound(self, expression):
        """How far the value may be from that of exact numbers."""
        at = self.evaluate(expression)
        total = 1e-12 * max([abs(x) for x in self.values] + [abs(at)])
        for i, error in enumerate(self.errors):
            worst = 0
            for sign in (1, -1):
                values = list(self.values)
                values[i] += sign * error
                worst = max(worst, abs(self.evaluate(expression, values) - at))
            total += worst
        return total


def content(math_element):
    row = list(math_element)
    return list(row[0]) if len(row) == 1 and row[0].tag == M + 'mrow' else row


def name_of(element):
    return ''.join(element.itertext()).replace('\u03b8', 'theta').replace('\u03c9', 'omega').replace('\u03b1', 'alpha')


def check_equation(div, results):
    lines = [m for line in div if line.get('class') == 'numbers' for m in line.iter(M + 'math')]
    if not lines:
        return None
    reader = Reader()
    parts = reader.row([e for m in lines for e in content(m)]).split('=')
    parts = [p for p in parts if p]
    left, right = reader.evaluate(parts[0]), reader.evaluate(parts[1])
    difference = left - right
    first = content(next(div.iter(M + 'math')))[0]
    results[name_of(first)] = right
    if '\u00b0' in ''.join(lines[-1].itertext()):
        difference = math.remainder(difference, 2 * math.pi)
    # each side has its own numbers, so that both bounds add up
    if abs(difference) > 1.01 * (reader.bound(parts[0]) + reader.bound(parts[1])):
        return '%s: %.9g, but %.9g is printed' % (''.join(div.itertext()), left, right)
    return None


def cell(element):
    words = ''.join(element.itertext()).replace('\u2212', '-')
    power = re.fullmatch(r'(.*)\u00b710(-?\d+)', words)
    return float(power.group(1)) * 10 ** int(power.group(2)) if power else float(words)


def check_matrix(root, solution):
    for table in root.iter(M + 'mtable'):
        for row in table:
            cells = list(row)
            A = [cell(c) for c in cells[:9]]
            b = cell(cells[11])
            left = sum(a * x for a, x in zip(A, solution))
            bound = half_unit(b) + sum(abs(a) * half_unit(x) + abs(x) * half_unit(a) for a, x in zip(A, solution))
            if abs(left - b) > 1.01 * bound + 1e-12 * max(map(abs, solution)):
                yield 'a row of the nine equations: %.9g, but b = %.9g' % (left, b)


def check_sums(root):
    for table in root.iter(H + 'table'):
        kind = table.get('class')
        rows = [[cell(c) for c in row if c.tag == H + 'td'] for row in table.find(H + 'tbody')]
        if kind == 'facts works':
            sums = [(list(column[:-1]), column[-1]) for column in zip(*rows)]
        elif kind == 'facts sides':
            sums = [(row[:3], row[3]) for row in rows]
        else:
            continue
        for terms, total in sums:
            if abs(sum(terms) - total) > 1.01 * (half_unit(total) + sum(map(half_unit, terms))) + 1e-12 * max(map(abs, terms)):
                yield '%s: %s do not add up to %g' % (kind, terms, total)


def check(report, expected):
    section = [e for e in xml.parse(report).iter(H + 'section') if e.get('id') == 'sample'][0]
    results, n, solution = {}, 0, []
    for div in section.iter(H + 'div'):
        if div.get('class') == 'equation':
            wrong = check_equation(div, results)
            n += 1
            if wrong:
                yield wrong
    for ul in section.iter(H + 'ul'):
        if ul.get('class') == 'given solution':
            for item in ul:
                reader = Reader()
                solution.append(reader.evaluate(reader.row(content(item[0])[2:])))
    if solution:
        yield from check_matrix(section, solution)
        yield from check_sums(section)
    for pair in expected:
        name, value = pair.split('=')
        if name not in results:
            yield 'no result %s among %s' % (name, sorted(results))
        elif abs(results[name] - float(value)) > 2 * max(half_unit(float(value)), 1e-9):
            yield '%s = %.9g, expected %s' % (name, results[name], value)
    if not n:
        yield 'no equations'


reports = [word for word in sys.argv[1:] if '=' not in word]
wrong = ['%s: %s' % (name, line) for name in reports for line in check(name, [word for word in sys.argv[1:] if '=' in word])]
print('\n'.join(wrong + ['%d samples' % len(reports)]))
sys.exit(bool(wrong))
