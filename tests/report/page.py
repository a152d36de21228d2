# SPDX-License-Identifier: GPL-3.0-or-later
#
# page.py REPORT [DECK [CSV]] - checks a report: one line for each thing that is wrong, nothing if all is well.
#
# It is XML, needs no other file, its headings are in order, its figures are numbered and have alternative
# texts, its ids are unique; it holds the deck as it is, and the rows as in the csv file.
import base64
import re
import sys
import xml.etree.ElementTree as xml

H = '{http://www.w3.org/1999/xhtml}'


def text(element):
    return ''.join(element.itertext())


def printable(data):
    """What a page shows of a file: no control characters, no bytes that are not UTF-8."""
    words = data.decode('utf-8', 'replace').replace('\r\n', '\n')
    return re.sub('[\0-\x08\x0b-\x1f\x7f-\x9f\ufffe\uffff]', '\ufffd', words)


def check_structure(root):
    levels = [int(e.tag[-1]) for e in root.iter() if re.fullmatch(H + 'h[1-6]', str(e.tag))]
    if levels[:1] != [1] or levels.count(1) != 1:
        yield 'not one h1, at the beginning: %s' % levels
    for before, after in zip(levels, levels[1:]):
        if after > before + 1:
            yield 'a heading h%d under h%d' % (after, before)
    numbers = [text(e).split()[0] for e in root.iter(H + 'h2')]
    if numbers != [str(i + 1) for i in range(len(numbers))]:
        yield 'sections are numbered %s' % numbers
    ids = [e.get('id') for e in root.iter() if e.get('id')]
    for i in set(ids):
        if ids.count(i) > 1:
            yield 'the id %s comes %d times' % (i, ids.count(i))
    for e in root.iter():
        for name in ('src', 'href'):
            value = e.get(name, '#')
            if not value.startswith(('#', 'data:image/svg+xml;base64,')):
                yield 'a reference to another file: %s' % value[:80]
            if value.startswith('#') and len(value) > 1 and value[1:] not in ids:
                yield 'a link to nothing: %s' % value
    for e in root.iter(H + 'th'):
        if e.get('scope') not in ('col', 'row'):
            yield 'a heading of a table without scope: %s' % text(e)
    for e in root.iter(H + 'table'):
        widths = {sum(int(cell.get('colspan', 1)) for cell in row) for row in e.iter(H + 'tr')}
        if len(widths) > 1:
            yield 'rows of a table with %s cells' % sorted(widths)
    for e in root.iter(H + 'button'):
        if e.get('data-from') and e.get('data-from') not in ids:
            yield 'a button that saves nothing: %s' % e.get('data-from')


def check_figures(root):
    n = 0
    for figure in root.iter(H + 'figure'):
        picture = figure.find(H + 'img')
        if picture is None:
            continue
        n += 1
        caption = figure.find(H + 'figcaption')
        if caption is None or not text(caption).startswith('Figure %d. ' % n):
            yield 'figure %d has the caption %s' % (n, caption is not None and text(caption))
        if len(picture.get('alt', '')) < 10:
            yield 'figure %d has no alternative text' % n
        svg = base64.b64decode(picture.get('src').split(',', 1)[1], validate=True)
        xml.fromstring(svg)
        if b'<script' in svg:
            yield 'a script in figure %d' % n


def check_deck(root, name):
    data = open(name, 'rb').read()
    shown = [text(e) for e in root.iter(H + 'pre') if e.get('class') == 'deck']
    wanted = printable(data)
    if len(shown) != 1 or shown[0].rstrip('\n') != wanted.rstrip('\n'):
        yield 'the deck is not there as it is'


def check_csv(root, name):
    rows = [text(e) for e in root.iter(H + 'pre') if e.get('id') == 'csv-rows']
    if rows != [printable(open(name, 'rb').read())]:
        yield 'the rows are not those of the csv file'


def check(report, deck=None, csv=None):
    data = open(report, 'rb').read()
    if len(data) > 1000000:
        yield '%d bytes' % len(data)
    if not data.startswith(b'<!DOCTYPE html>\n'):
        yield 'no document type'
    root = xml.fromstring(data)
    yield from check_structure(root)
    yield from check_figures(root)
    if deck:
        yield from check_deck(root, deck)
    if csv:
        yield from check_csv(root, csv)


wrong = list(check(*sys.argv[1:]))
for line in wrong:
    print('%s: %s' % (sys.argv[1], line))
sys.exit(bool(wrong))
