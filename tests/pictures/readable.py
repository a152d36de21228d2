# SPDX-License-Identifier: GPL-3.0-or-later
#
# readable.py inside|apart|both SVG - the texts of a picture that go beyond its edge, or that stand on another; nothing
# if all can be read.
import re
import sys
import xml.etree.ElementTree as tree

LETTER, LINE = 6.5, 9  # pixels that a letter takes at least


SVG = '{http://www.w3.org/2000/svg}'


class Text:
    def __init__(self, text):
        self.words = ''.join(text.itertext()).replace('\u2212', '-')
        self.x, self.y = float(text.get('x')), float(text.get('y'))
        width = LETTER * len(self.words)
        self.left = self.x - {None: 0, 'middle': width / 2, 'end': width}[text.get('text-anchor')]
        self.right = self.left + width

    def is_on(self, other):
        return self.left < other.right and other.left < self.right and abs(self.y - other.y) < LINE


def texts(picture):
    """Those that are not turned."""
    found = (Text(text) for text in picture.iter(SVG + 'text') if not text.get('transform'))
    return [text for text in found if text.words.strip()]


def main(question, path):
    picture = tree.parse(path).getroot()
    width, height = float(picture.get('width')), float(picture.get('height'))
    all_texts = texts(picture)
    assert len(all_texts) > 5 and width > 100, 'hardly a text in ' + path
    for i, text in enumerate(all_texts):
        if question != 'apart' and (text.left < 0 or text.right > width or not 0 < text.y < height):
            print(text.words, 'is beyond the edge')
        for other in all_texts[:i]:
            if question != 'inside' and text.is_on(other) and (text.words, text.x) != (other.words, other.x):
                print(text.words, 'is on', other.words)


main(*sys.argv[1:])
