# SPDX-License-Identifier: GPL-3.0-or-later
#
# look.py SVG - what is wrong with the colours of a picture on white paper, in colour or in grey; nothing if all is well.
#
# Contrast and luminance as in the Web Content Accessibility Guidelines 2.1: L = 0.2126 R + 0.7152 G + 0.0722 B of the
# linear components, contrast (1 + 0.05) / (L + 0.05).
import re
import sys

NAMES = ' ground crank coupler follower path ghost force load construction result other leader sense'.split(' ')
GROUND, CRANK, COUPLER, FOLLOWER, PATH, GHOST, FORCE, LOAD, CONSTRUCTION, RESULT, OTHER, LEADER, SENSE = range(1, 14)


def luminance(colour):
    parts = [int(colour[k:k + 2], 16) / 255 for k in (0, 2, 4)]
    linear = [x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4 for x in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def lightness(colour):
    """L* of CIE 1976, from 0 to 100."""
    return 116 * luminance(colour) ** (1 / 3) - 16


def main(path):
    styles, curves = {}, {}
    with open(path, encoding='utf-8') as text:
        for line in text:
            match = re.match(r'\.fourlink \.(\w+)\{stroke:#(\w{6});stroke-width:([0-9.]+)(?:;stroke-dasharray:([0-9,]+))?\}', line)
            if not match:
                continue
            name, colour, width, dashes = match.groups()
            found = float(width), dashes, colour
            if name in NAMES:
                styles[NAMES.index(name)] = found
            elif name.startswith('curve'):
                curves[int(name[5:])] = found
    wrong = []
    for what, found, numbers in (('style', styles, (GROUND, CRANK, COUPLER, FOLLOWER, FORCE, LOAD, CONSTRUCTION, RESULT, SENSE)),
                                 ('curve', curves, range(1, 7))):
        for k in numbers:
            contrast = 1.05 / (luminance(found[k][2]) + 0.05)
            if contrast < 4.5:
                wrong.append('%s %d has a contrast of %.2f' % (what, k, contrast))
    for k in (PATH, OTHER, LEADER):
        if 1.05 / (luminance(styles[k][2]) + 0.05) < 3:
            wrong.append('line %d is pale' % k)
    links = [styles[k] for k in (CRANK, COUPLER, FOLLOWER)]
    for i in range(3):
        for j in range(i):
            if abs(lightness(links[i][2]) - lightness(links[j][2])) < 10:
                wrong.append('links %d and %d are equal in grey' % (j + 2, i + 2))
            if abs(links[i][0] - links[j][0]) < 0.5:
                wrong.append('links %d and %d are equally wide' % (j + 2, i + 2))
    arrows = [styles[k][:2] for k in (FORCE, LOAD, RESULT)]
    if len(set(arrows)) < 3:
        wrong.append('forces, loads and inertia have the same width and dashes')
    if len({curve[1] for curve in curves.values()}) < 6:
        wrong.append('curves have the same dashes')
    print('\n'.join(wrong), end='')


main(sys.argv[1])
