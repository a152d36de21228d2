# SPDX-License-Identifier: GPL-3.0-or-later
#
# panels.py - reads the items of a picture (items.awk): what it draws, panel by panel.  Places are complex numbers.

LETTERS = {'θ': 'theta', 'ω': 'omega', 'α': 'alpha', 'γ': 'gamma', 'φ': 'phi', 'μ': 'mu', '°': 'deg', '·': '.'}
SCRIPTS = str.maketrans('₀₁₂₃₄ₛₓᵧ²³', '01234sxy23')


def plain(words):
    """A name or a unit of a book as tables have it: θ₂ is theta2, m/s² is m/s2, F₁₂ along is F12_along."""
    return ''.join(LETTERS.get(c, c) for c in words.translate(SCRIPTS)).replace(' ', '_')


def axis_of(label):
    """Name and unit of "F₁₂ along (N)", as tables have them."""
    name, unit = label[:-1].rsplit(' (', 1)
    return plain(name), plain(unit)


class Line:
    """A straight line or an arrow, with its style: the class of its look."""

    def __init__(self, start, end, is_arrow, style):
        self.start, self.end, self.is_arrow, self.style = start, end, is_arrow, style
        self.vector = end - start

    def turned(self, factor):
        return Line(self.start * factor, self.end * factor, self.is_arrow, self.style)


class Panel:
    """One drawing or diagram of a picture."""

    def __init__(self):
        self.lines, self.marks, self.discs, self.labels, self.notes, self.dots = [], [], [], [], [], []
        self.range, self.step, self.titles, self.blocks, self.looks, self.keys = {}, {}, {}, {}, {}, {}
        self.width = self.height = 0  # pixels, of the axes

    @property
    def title(self):
        return self.titles.get('name', '')

    @property
    def mean(self):
        return self.blocks['mean_line'][0].imag if 'mean_line' in self.blocks else None

    def curves(self):
        """The name of each curve, and its words in the key; None if it has none."""
        return [(name, self.keys.get(look)) for name, look in self.looks.items()]

    def note(self, name):
        """The value and the unit of the note NAME = VALUE UNIT; None if there is none."""
        for words in self.notes:
            if words.startswith(name + ' = '):
                return words[len(name) + 3:]
        return None

    def read(self, what, rest, turn):
        fields = rest.split(' ')

        def place(k):
            return complex(float(fields[k]), float(fields[k + 1]))
        if what in ('line', 'arrow'):
            self.lines.append(Line(place(1) * turn, place(3) * turn, what == 'arrow', fields[0]))
        elif what == 'upright':
            self.marks.append(float(fields[1]))
        elif what in ('disc', 'quarter'):
            self.discs.append((place(1) * turn, float(fields[3]), what == 'quarter', fields[0]))
        elif what == 'text':
            self.labels.append((' '.join(fields[4:]), place(2), fields[0], fields[1]))
        elif what == 'mark':
            self.dots.append((place(2), fields[0]))
        elif what == 'note':
            self.notes.append(rest)
        elif what == 'box':
            self.width, self.height = map(float, fields)
        elif what == 'step':
            self.step = dict(zip('xy', map(float, fields)))
        elif what == 'range':
            self.range = {'x': (float(fields[0]), float(fields[1])), 'y': (float(fields[2]), float(fields[3]))}
        elif what == 'key':
            self.keys[fields[0]] = ' '.join(fields[1:])
        else:
            self.titles[what] = rest


class Listing:
    def __init__(self, text, turn=1):
        """`turn`: the factor that turns drawings back."""
        self.panels, self.title, self.subtitle = [], '', ''
        panel = rows = None
        for line in text.split('\n')[:-1]:
            what, _, rest = line.partition(' ')
            if line == 'end':
                rows = None
            elif rows is not None:
                rows.append(complex(*map(float, line.split())) if line else None)
            elif what == 'panel':
                panel = Panel()
            elif what == 'drawn':
                self.panels.append(panel)
            elif what == 'curve':
                name, look = rest.split()
                rows = panel.blocks[name] = []
                panel.looks[name] = look
            elif what in ('title', 'subtitle'):
                setattr(self, what, rest)
            elif what != 'picture':
                panel.read(what, rest, turn)
