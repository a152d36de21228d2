# SPDX-License-Identifier: GPL-3.0-or-later
#
# readable.py inside|apart|both SVG - the texts of a picture that go beyond its edge, or that stand on another; nothing
# if all can be read.
import re
import sys
import xml.etree.ElementTree as tree

LETTER, LINE = 6.5, 9  # pixels that a letter takes at least


class Text:
    def __init__(self, group, words):
        self.words = words
        self.x, self.y = map(float, re.match(r'translate\(([-0-9.]+),([-0-9.]+)\)', group.get('transform')).groups())
        width = LETTER * len(words)
        self.left = self.x - {'start': 0, 'middle': width / 2, 'end': width}[group.get('text-anchor')]
        self.right = self.left + width

    def is_on(self, other):
        return self.left < other.right and other.left < self.right and abs(self.y - other.y) < LINE


def texts(picture):
    """Those that are not turned; one in a box is in the file twice."""
    found = {}
    for group in picture.iter('{http://www.w3.org/2000/svg}g'):
        for text in group.findall('{http://www.w3.org/2000/svg}text'):
            words = ''.join(text.itertext())
            if words.strip() and 'rotate' not in group.get('transform'):
                one = Text(group, words)
                found[words, one.x, one.y] = one
    return list(found.values())


def main(question, path):
    picture = tree.parse(path).getroot()
    width, height = float(picture.get('width')), float(picture.get('height'))
    all_texts = texts(picture)
    assert len(all_texts) > 5 and width > 100, 'hardly a text in ' + path
    for i, text in enumerate(all_texts):
        if question != 'apart' and (text.left < 0 or text.right > width or not 0 < text.y < height):
            print(text.words, 'is beyond the edge')
        for other in all_texts[:i]:
            if question != 'inside' and text.is_on(other) and text.words != other.words:
                print(text.words, 'is on', other.words)


main(*sys.argv[1:])
