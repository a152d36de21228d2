# SPDX-License-Identifier: GPL-3.0-or-later
#
# panels.py - reads the listing of a picture (listing.awk): what it draws, panel by panel.  Places are complex numbers.
import re

NUMBER = r'([-+0-9.eE]+)'
ARROW = re.compile(r'set arrow from %s,%s to %s,%s (nohead|head)\b.*?(?:ls|lt) (\d+)' % ((NUMBER,) * 4))
MARK = re.compile(r'set arrow from %s,graph 0 to %s,graph 1' % (NUMBER, NUMBER))
DISC = re.compile(r"set object circle at %s,%s size %s (arc \[\d+:\d+\] )?front fc rgb '(\w+)'" % ((NUMBER,) * 3))
LABEL = re.compile(r'set label (".*"|\'.*\') at %s,%s (left|center|right) front(.*)' % (NUMBER, NUMBER))
NOTE = re.compile(r'set label (".*"|\'.*\') at graph 1.02, graph 1 offset 0,(-?\d+) left')
DOT = re.compile(r'set label "" at %s,%s point pt (\d+)' % (NUMBER, NUMBER))
RANGE = re.compile(r'set ([xy])range \[%s:%s\]' % (NUMBER, NUMBER))
TICS = re.compile(r'set (?:([xy])tics|tics) %s' % NUMBER)
MARGIN = re.compile(r'([lrtb])margin at screen %s' % NUMBER)
TITLE = re.compile(r'set (title|xlabel|ylabel) (".*")')


LETTERS = {'θ': 'theta', 'ω': 'omega', 'α': 'alpha', 'γ': 'gamma', 'φ': 'phi', 'μ': 'mu', '°': 'deg', '·': '.'}
SCRIPTS = str.maketrans('₀₁₂₃₄ₛₓᵧ²³', '01234sxy23')


def plain(words):
    """A name or a unit of a book as tables have it: θ₂ is theta2, m/s² is m/s2, F₁₂ along is F12_along."""
    return ''.join(LETTERS.get(c, c) for c in words.translate(SCRIPTS)).replace(' ', '_')


def axis_of(label):
    """Name and unit of "F₁₂ along (N)", as tables have them."""
    name, unit = label[:-1].rsplit(' (', 1)
    return plain(name), plain(unit)


def unquoted(words):
    if words[0] == "'":
        return words[1:-1].replace("''", "'")
    return re.sub(r'\\(\d{3})', lambda m: chr(int(m.group(1), 8)), words[1:-1])


def shown(line, words):
    """The text of a label, without the marks of subscripts if it has any."""
    words = unquoted(words)
    return re.sub(r'[_^]\{([^}]*)\}', r'\1', words) if line.endswith(' enhanced') else words


class Line:
    """A straight line or an arrow, with its style."""

    def __init__(self, start, end, is_arrow, style):
        self.start, self.end, self.is_arrow, self.style = start, end, is_arrow, style
        self.vector = end - start

    def turned(self, factor):
        return Line(self.start * factor, self.end * factor, self.is_arrow, self.style)


class Panel:
    """One drawing or diagram of a picture."""

    def __init__(self):
        self.lines, self.marks, self.discs, self.labels, self.notes, self.dots = [], [], [], [], [], []
        self.range, self.tics, self.margin, self.titles, self.plots = {}, {}, {}, {}, ''
        self.mean = None

    @property
    def title(self):
        return self.titles.get('title', '')

    def curves(self):
        """Of the plot command: block, style and title of each curve."""
        found, block = [], None
        for words in re.split(r', (?:\\\n *)?(?=\$|NaN|mean|[-0-9.]+ with|\'\')', re.sub(r'^plot ', '', self.plots)):
            match = re.match(r"\$(\w+) ", words)
            block = match.group(1) if match else block if words.startswith("''") else words.split()[0]
            title = re.search(r'title (".*"|\'.*\')', words)
            found.append((block, words, unquoted(title.group(1)) if title else None))
        return found

    def note(self, name):
        """The value and the unit of the note NAME = VALUE UNIT; None if there is none."""
        for words in self.notes:
            if words.startswith(name + ' = '):
                return words[len(name) + 3:]
        return None


class Listing:
    def __init__(self, text, turn=1):
        """`turn`: the factor that turns drawings back."""
        self.panels, self.blocks, self.title, self.source = [], {}, '', ''
        self.width = self.height = 0
        panel, rows, plot = Panel(), None, None
        for line in text.split('\n'):
            if rows is not None:
                if line == 'EOD':
                    rows = None
                else:
                    rows.append(complex(*map(float, line.split())) if line.strip() else None)
                continue
            if plot is not None:
                plot += '\n' + line
            elif line.startswith('$') and line.endswith(' << EOD'):
                rows = self.blocks[line[1:-7]] = []
                continue
            elif line.startswith('plot '):
                plot = line
            if plot is not None:
                if not plot.endswith('\\'):
                    panel.plots = plot
                    panel.blocks = {name: self.blocks[name] for name in re.findall(r'\$(\w+) using', plot)}
                    self.panels.append(panel)
                    panel, plot = Panel(), None
                continue
            self.read(panel, line, turn)

    def read(self, panel, line, turn):
        if line.startswith('unset label') or line.startswith('unset arrow'):
            kept = panel.mean
            panel.__init__()
            panel.mean = kept
        elif line.startswith('set arrow'):
            match = ARROW.match(line)
            if match:
                x, y, u, v = map(float, match.groups()[:4])
                panel.lines.append(Line(complex(x, y) * turn, complex(u, v) * turn, match.group(5) == 'head', int(match.group(6))))
            else:
                panel.marks.append(float(MARK.match(line).group(1)))
        elif line.startswith('set object circle'):
            x, y, size, arc, colour = DISC.match(line).groups()
            panel.discs.append((complex(float(x), float(y)) * turn, float(size), bool(arc), colour))
        elif line.startswith('set label'):
            note, label, dot = NOTE.match(line), LABEL.match(line), DOT.match(line)
            if dot:
                panel.dots.append((complex(float(dot.group(1)), float(dot.group(2))), int(dot.group(3))))
            elif note:
                panel.notes.append(shown(line, note.group(1)))
            elif label:
                panel.labels.append((shown(line, label.group(1)), complex(float(label.group(2)), float(label.group(3))),
                                     label.group(4), label.group(5)))
            else:
                panel.labels.append((line, None, '', ''))
        elif line.startswith('mean = '):
            panel.mean = float(line[7:])
        elif line.startswith('title = '):
            self.title = unquoted(line[8:])
        elif line.startswith('source = '):
            self.source = line[9:]
        elif line.startswith('set terminal'):
            size = re.search(r'size (\d+),(\d+)', line)
            self.width, self.height = int(size.group(1)), int(size.group(2))
        if not line.startswith(('set lmargin', 'set tmargin', 'set format', 'set xrange', 'set yrange', 'set tics', 'set xtics', 'set title',
                                'set xlabel', 'set ylabel')):
            return
        for axis, low, high in RANGE.findall(line):
            panel.range[axis] = (float(low), float(high))
        for axis, step in TICS.findall(line):
            panel.tics[axis or 'xy'] = float(step)
        for side, place in MARGIN.findall(line):
            panel.margin[side] = float(place)
        for what, words in TITLE.findall(line):
            panel.titles[what] = unquoted(words)
