# SPDX-License-Identifier: GPL-3.0-or-later
#
# listing.py SVG - what a picture shows, a line for each item, in the units of its axes; for tests that read lines.
#
#     set arrow from X,Y to U,V head|nohead ls LOOK       a line of a drawing; LOOK: its number in view/look.h
#     set arrow from X,graph 0 to X,graph 1 nohead ls 9   one from the bottom of a diagram to its top
#     set object circle at X,Y size R front fc rgb 'white'|'black' ...; a centre of mass has four arcs
#     set label "WORDS" at X,Y left|center|right front    a text at a place; of a curve's number with tc lt CURVE
#     set label "WORDS" at graph 1.02, graph 1 offset 0,-LINE left    a text beside the axes
#     set label "" at X,Y point pt 7|6 ps SIZE            a mark of a curve, black or open
#     $NAME << EOD, X Y, EOD                              a curve, with blank lines in its gaps
#     plot $NAME using 1:2 with lines ls|lt N title "WORDS", ...      what the curves of a panel are, at its end
import re
import sys
import xml.etree.ElementTree as tree

SVG = '{http://www.w3.org/2000/svg}'
LOOKS = ['', 'ground', 'crank', 'coupler', 'follower', 'path', 'ghost', 'force', 'load', 'construction', 'result', 'other', 'leader', 'sense']
POINTS = re.compile(r'([ML])([-0-9.]+),([-0-9.]+)')


def style_of(look):
    """ls or lt and the number of a look."""
    if look in LOOKS:
        return 'ls %d' % LOOKS.index(look)
    match = re.fullmatch(r'(path|curve|jump)(\d+)', look)
    return 'ls %d' % (len(LOOKS) + int(match.group(2)) - 2) if match.group(1) == 'path' else 'lt ' + match.group(2)


def quoted(words):
    return '"%s"' % words.replace('\\', '\\134').replace('"', '\\042').replace('`', '\\140')


def words_of(text):
    return ''.join(text.itertext()).replace('\u2212', '-')


def points_of(path):
    return [(letter, complex(float(x), float(y))) for letter, x, y in POINTS.findall(path.get('d'))]


STEPS = 720  # of a motion
STILL = 60  # frames of a picture that moves


def resampled(pieces):
    """A curve over a quantity that only grows, or falls, at even steps; another one as it is."""
    ways = {p.real < q.real for piece in pieces for p, q in zip(piece, piece[1:]) if p.real != q.real}
    if len(ways) != 1 or sum(map(len, pieces)) < 20 or any(p.real == q.real for piece in pieces for p, q in zip(piece, piece[1:])):
        return pieces
    first, last = pieces[0][0].real, pieces[-1][-1].real
    found = []
    for piece in pieces:
        k, own = 0, []
        for i in range(STEPS + 1):
            x = first + (last - first) * i / STEPS
            if not min(piece[0].real, piece[-1].real) - 1e-9 * abs(last) <= x <= max(piece[0].real, piece[-1].real) + 1e-9 * abs(last):
                continue
            while k < len(piece) - 2 and (x > piece[k + 1].real) == (last > first) and x != piece[k + 1].real:
                k += 1
            p, q = piece[k:k + 2]
            own.append(complex(x, p.imag + (x - p.real) / (q.real - p.real) * (q.imag - p.imag)))
        found += [own] if own else []
    return found


class Panel:
    def __init__(self, group, picture, frame):
        self.picture = picture
        self.left, self.top, self.width, self.height = (float(x) for x in group.get('data-box').replace(',', ' ').split())
        self.x0, self.x1, self.y0, self.y1 = map(float, group.get('data-axes').split())
        self.lines, self.blocks, self.plots, self.keys, self.numbers = [], [], [], [], {'x': [], 'y': []}
        self.notes, self.titles, self.sample = [], {}, None
        self.items = [item for item in (group if frame is None else frame) if item.tag not in (SVG + 'g', SVG + 'animate')]

    def x(self, px):
        return self.x0 + (px - self.left) / self.width * (self.x1 - self.x0)

    def y(self, py):
        return self.y1 - (py - self.top) / self.height * (self.y1 - self.y0)

    def at(self, p):
        return '%.9g,%.9g' % (self.x(p.real) or 0, self.y(p.imag) or 0)

    def read(self):
        i = 0
        while i < len(self.items):
            item = self.items[i]
            kind, classes = item.tag.replace(SVG, ''), item.get('class', '').split()
            name = item.get('data-name', '')
            following = self.items[i + 1] if i + 1 < len(self.items) else None
            if kind == 'text':
                self.text(item, classes, name)
            elif kind == 'circle':
                self.circle(item, classes, name)
                if 'centre' in classes:
                    i += 1 # its black quarters
            elif name == 'key':
                self.sample = classes[0]
            elif classes[0] not in ('grid', 'axis', 'above', 'below') and name:
                self.curve(item, classes[0], name)
            elif classes[0] not in ('grid', 'axis', 'above', 'below'):
                head = following is not None and following.get('class') == 'h-' + classes[0]
                self.line(item, classes[0], following if head else None)
                i += head
            i += 1

    def text(self, item, classes, name):
        words = words_of(item)
        at = complex(float(item.get('x')), float(item.get('y')) - 5)
        if name == 'title':
            self.titles['title'] = words
        elif name in ('x', 'y'):
            self.titles[name + 'label'] = words
        elif name in ('x-number', 'y-number'):
            self.numbers[name[0]].append(float(words))
        elif name == 'note':
            self.notes.append((round((at.imag - self.top) / 18), words))
        elif name == 'key':
            self.keys.append((self.sample, words))
        else:
            colour = [c for c in classes if re.match(r'h-curve\d', c)]
            self.lines.append('set label %s at %s %s front%s' % (
                quoted(words), self.at(at), {None: 'left', 'middle': 'center', 'end': 'right'}[item.get('text-anchor')],
                ' tc lt ' + colour[0][7:] if colour else ' boxed' if 'halo' in classes else ''))

    def circle(self, item, classes, name):
        at, r = complex(float(item.get('cx')), float(item.get('cy'))), float(item.get('r'))
        if name == 'key':
            self.sample = 'mark'
        elif 'mark' in classes:
            dot = 'set label "" at %s point pt %d ps %.2g lc rgb \'black\' front'
            self.lines.append(dot % (self.at(at), 6 if 'open' in classes else 7, r / 5 if r != 5 else 1.2))
        else:
            size = r / self.width * abs(self.x1 - self.x0)
            disc = "set object circle at %s size %.9g %sfront fc rgb '%s' fs solid border lc rgb 'black'%s"
            if 'centre' in classes:
                self.lines += [disc % (self.at(at), size, 'arc [%d:%d] ' % (90 * k, 90 * k + 90), 'white' if k % 2 else 'black', '')
                               for k in range(4)]
            else:
                self.lines.append(disc % (self.at(at), size, '', 'white' if 'open' in classes else 'black', ' lw 1.5'))

    def line(self, item, look, head):
        points = [p for _, p in points_of(item)]
        if head is not None:
            points[-1] = points_of(head)[0][1]
        style = style_of(look)
        for k, (p, q) in enumerate(zip(points, points[1:])):
            bottom, top = self.top + self.height, self.top
            if p.real == q.real and {round(p.imag, 2), round(q.imag, 2)} == {round(bottom, 2), round(top, 2)} and look == 'construction':
                self.lines.append('set arrow from %.6g,graph 0 to %.6g,graph 1 nohead %s' % (self.x(p.real), self.x(q.real), style))
                continue
            is_last = head is not None and k == len(points) - 2
            self.lines.append('set arrow from %s to %s %s%s' % (
                self.at(p), self.at(q), 'head filled ' if is_last else 'nohead ', style))

    def curve(self, item, look, name):
        pieces = []
        for letter, p in points_of(item):
            if letter == 'M':
                pieces.append([])
            pieces[-1].append(complex(self.x(p.real), self.y(p.imag)))
        rows = []
        for piece in resampled(pieces) if self.picture.even else pieces:
            rows += ([''] if rows else []) + ['%.9g %.9g' % (p.real, p.imag) for p in piece]
        name = re.sub(r'\W', '_', name)
        self.blocks.append((name, rows))
        self.plots.append((name, look))

    def tics(self, axis):
        """The step of the numbers of an axis; 0 if there is but one."""
        found = self.numbers[axis]
        return found[1] - found[0] if len(found) > 1 else 0

    def listing(self):
        w, h = self.picture.width, self.picture.height
        found = []
        print = found.append
        print('unset arrow; unset label; unset object')
        found += self.lines
        for line, words in self.notes:
            print('set label %s at graph 1.02, graph 1 offset 0,%d left noenhanced' % (quoted(words), -line))
        print('set lmargin at screen %.6g; set rmargin at screen %.6g' % (self.left / w, (self.left + self.width) / w))
        print('set tmargin at screen %.6g; set bmargin at screen %.6g' % (1 - self.top / h, 1 - (self.top + self.height) / h))
        print("set format '%%g'; set xtics %.7g; set ytics %.7g" % (self.tics('x'), self.tics('y')))
        print('set xrange [%.9g:%.9g]\nset yrange [%.9g:%.9g]' % (self.x0, self.x1, self.y0, self.y1))
        for what in ('title', 'xlabel', 'ylabel'):
            if what in self.titles:
                print('set %s %s%s' % (what, quoted(self.titles[what]), ' offset 0,0' if what == 'title' else ''))
        for name, rows in self.blocks:
            if name == 'mean_line':
                print('mean = ' + rows[0].split()[1])
            print('$%s << EOD\n%s\nEOD' % (name, '\n'.join(rows)))
        keys = dict(self.keys)
        plots = ['$%s using 1:2 with lines %s title %s' % (name, style_of(look), quoted(keys.pop(look, ''))) for name, look in self.plots]
        plots += ['NaN with %s title %s' % ('points' if look == 'mark' else 'area' if look in ('above', 'below') else 'lines ' + style_of(look),
                                            quoted(words)) for look, words in keys.items()]
        print('plot ' + (', '.join(plots) or 'NaN notitle'))
        return '\n'.join(found)


class Picture:
    def __init__(self, path, even):
        self.even = even
        root = tree.parse(path).getroot()
        self.width, self.height = float(root.get('width')), float(root.get('height'))
        self.heads = [words_of(text) for text in root.findall(SVG + 'text')]
        self.panels = []
        moving = [(item, animate) for item in root.iter() for animate in item.findall(SVG + 'animate') if item.tag != SVG + 'g']
        n = max([len(animate.get('values').split(';')) for _, animate in moving] + [1])
        for k in range(n - 1 if n > STILL else n):  # of a motion that repeats the last is the first
            for item, animate in moving:
                item.set(animate.get('attributeName'), animate.get('values').split(';')[k])
            for group in root.findall(SVG + 'g'):
                frames = group.findall(SVG + 'g')  # shown one after the other
                for frame in frames or [None]:
                    self.panels.append(Panel(group, self, frame))
                    self.panels[-1].read()

    def listing(self):
        lines = ['set terminal svg size %d,%d ' % (self.width, self.height)]
        if self.heads:
            lines.append('title = %s\nsource = %s' % tuple(map(quoted, self.heads)))
        for panel in self.panels:
            lines.append(panel.listing())
        return '\n'.join(lines) + '\n'


def listing(path, even=False):
    """`even`: curves at even steps."""
    return Picture(path, even).listing()


if __name__ == '__main__':
    sys.stdout.reconfigure(encoding='utf-8')
    print(listing(sys.argv[1], True), end='')
