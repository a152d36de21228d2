#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
#
# faults.py - do the tests notice small faults?  mutate.sh runs it.
#
#   faults.py put TREE N SEED LIST [FOLDER...]   put N faults into the sources of TREE, or of these folders of src/, all at
#                                           once, each behind a switch, and list them
#   faults.py again TREE OUT LIST [FOLDER...]   put those in again that survived in an earlier run
#   faults.py scripts TREE BUILD N SEED OUT [FILE...]   put N faults into the scripts, one after the other, and run the
#                                           tests of ctest that read scripts as they are, by node (faults.js)
#   faults.py run BUILD LIST OUT [CONFIG]   run, for each fault, the tests that reach it, until one fails
#   faults.py table TREE OUT KNOWN          the table by folder, and the survivors that have no reason in KNOWN
#
# One build holds all faults, so that a fault costs only the tests that reach it.  A fault is
# (FLK_FAULT(7) ? faulty : right); the variable FAULT names the one that is on, REACHED a file in which each test leaves
# what it reached.  Candidates are found by libclang, so that each is an expression or a statement of a function.
import collections
import concurrent.futures
import json
import mmap
import os
import pathlib
import random
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time

MOST = 10000  # faults in one build

SWITCH_H = """#ifndef FLK_FAULT_H
#define FLK_FAULT_H
extern volatile char *flk_fault_reached;
extern int flk_fault_on;
#define FLK_FAULT(n) (flk_fault_reached[n] = 1, flk_fault_on == (n))
#endif
"""
SWITCH_C = """#include <fcntl.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>
#include "base/fault.h"
static volatile char nowhere[%d];
volatile char *flk_fault_reached = nowhere;
int flk_fault_on = -1;
__attribute__((constructor)) static void flk_fault_begin(void)
{
    const char *on = getenv("FAULT"), *name = getenv("REACHED");
    int file = name ? open(name, O_RDWR) : -1;
    void *map = file < 0 ? MAP_FAILED : mmap(NULL, sizeof nowhere, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (file >= 0)
        close(file); /* it may be 0 or 1, which a test has closed */
    if (map != MAP_FAILED)
        flk_fault_reached = map;
    if (on)
        flk_fault_on = atoi(on);
}
""" % MOST

# ------------------------------------------------------------------------------------------ candidates

SWAPS = {'+': '-', '-': '+', '*': '/', '/': '*', '%': '/', '+=': '-=', '-=': '+=', '*=': '/=', '/=': '*='}
COMPARE = {'<': ['<=', '>='], '>': ['>=', '<='], '<=': ['<', '>'], '>=': ['>', '<'], '==': ['!='], '!=': ['==']}
LOGIC = {'&&': '||', '||': '&&'}
TWINS = [('min', 'max'), ('sin', 'cos'), ('floor', 'ceil'), ('smallest', 'largest'), ('lowest', 'highest'), ('first', 'last')]
SYMMETRIC = ('strcmp', 'strncmp', 'memcmp', 'gsl_hypot', 'flk_length', 'gsl_complex_add', 'gsl_complex_mul', 'GSL_MAX_DBL',
             'GSL_MIN_DBL', 'flk_dimension_equal', 'flk_text_equal', 'flk_text_same', 'memory_get', 'system_is_same')

Candidate = collections.namedtuple('Candidate', 'file start end line sort right faulty statement')


def twin(name):
    for a, b in TWINS:
        for one, other in ((a, b), (b, a)):
            if re.search(r'(^|_)%s($|_)' % one, name):
                return re.sub(r'(^|_)%s($|_)' % one, r'\g<1>%s\g<2>' % other, name)
    return None


class Finder:
    """The candidates of one source file."""

    def __init__(self, clang, index, tree, name, chance):
        self.clang, self.K, self.index = clang, clang.CursorKind, index
        self.path, self.name, self.chance = str(tree / name), name, chance
        self.arguments = ['-I%s/src' % tree, '-I%s/include' % tree, '-std=gnu11', '-Werror=implicit-function-declaration',
                          '-Werror=int-conversion', '-Werror=incompatible-pointer-types']
        self.source = pathlib.Path(self.path).read_bytes()
        unit = index.parse(self.path, self.arguments, options=clang.TranslationUnit.PARSE_DETAILED_PROCESSING_RECORD)
        self.macros = [(c.extent.start.offset, c.extent.end.offset) for c in unit.cursor.get_children()
                       if c.kind == self.K.MACRO_INSTANTIATION and self.is_here(c)]
        self.found = []
        for c in unit.cursor.get_children():
            if c.kind == self.K.FUNCTION_DECL and c.is_definition() and self.is_here(c):
                self.locals = [d for d in c.walk_preorder() if d.kind in (self.K.VAR_DECL, self.K.PARM_DECL)]
                self.visit(c, None, 0)

    def is_here(self, c):
        return c.location.file is not None and c.location.file.name == self.path

    def text(self, c):
        return self.source[c.extent.start.offset:c.extent.end.offset].decode('utf-8')

    def add(self, c, sort, faulty, end=None, statement=False):
        start, end = c.extent.start.offset, end or c.extent.end.offset
        right = self.source[start:end].decode('utf-8')
        if not any(a <= start and end <= b for a, b in self.macros) and faulty != right:
            self.found.append(Candidate(self.name, start, end, c.extent.start.line, sort, right, faulty, statement))

    def between(self, a, b):
        gap = self.source[a.extent.end.offset:b.extent.start.offset].decode('utf-8')
        return re.sub(r'/\*.*?\*/', '', gap, flags=re.S)

    def visit(self, c, parent, place):
        K = self.K
        if c.kind == K.VAR_DECL and (c.storage_class == self.clang.StorageClass.STATIC or
                                     c.type.kind == self.clang.TypeKind.CONSTANTARRAY):
            return
        children = list(c.get_children())
        if c.kind == K.CASE_STMT:
            children = children[1:]
        getattr(self, c.kind.name.lower(), lambda *_: None)(c, children)
        if parent is not None:
            self.statement(c, parent, place)
        for i, child in enumerate(children):
            self.visit(child, c, i)

    def binary_operator(self, c, children):
        if len(children) != 2:
            return
        sign = self.between(*children).strip()
        a, b = self.source[c.extent.start.offset:children[0].extent.end.offset].decode(), \
            self.source[children[1].extent.start.offset:c.extent.end.offset].decode()
        if sign in SWAPS:
            self.add(c, 'arithmetic', '%s %s %s' % (a, SWAPS[sign], b))
        elif sign in COMPARE:
            self.add(c, 'comparison', '%s %s %s' % (a, self.chance.choice(COMPARE[sign]), b))
        elif sign in LOGIC:
            self.add(c, 'logic', '(%s) %s (%s)' % (a, LOGIC[sign], b))

    compound_assignment_operator = binary_operator

    def unary_operator(self, c, children):
        if self.text(c)[:1] in ('!', '-'):
            self.add(c, 'logic' if self.text(c)[0] == '!' else 'sign', self.text(children[0]))

    def if_stmt(self, c, children):
        self.add(children[0], 'logic', '!(%s)' % self.text(children[0]))

    def integer_literal(self, c, children):
        t = self.text(c)
        if re.fullmatch('[0-9]+', t):
            n = int(t)
            self.add(c, 'constant', str(self.chance.choice([n + 1, n - 1] if n else [1])))

    def floating_literal(self, c, children):
        self.add(c, 'constant', self.chance.choice(['-%s', '(%s * 2)', '(%s / 2)']) % self.text(c))

    def call_expr(self, c, children):
        arguments = list(c.get_arguments())
        pairs = [(i, j) for i in range(len(arguments)) for j in range(i)
                 if arguments[i].type.get_canonical().spelling == arguments[j].type.get_canonical().spelling and
                 self.text(arguments[i]) != self.text(arguments[j])]
        if pairs and c.spelling not in SYMMETRIC:
            i, j = self.chance.choice(pairs)
            texts = [self.text(a) for a in arguments]
            texts[i], texts[j] = texts[j], texts[i]
            self.add(c, 'arguments', '%s(%s)' % (self.text(children[0]), ', '.join(texts)))
        other = twin(c.spelling)
        if other and children and self.text(children[0]) == c.spelling:
            self.add(c, 'twin', other + self.text(c)[len(c.spelling):])

    def member_ref_expr(self, c, children):
        t = self.text(c)
        other = {'x': 'y', 'y': 'x'}.get(c.spelling) or twin(c.spelling)
        if other and t.endswith(c.spelling):
            self.add(c, 'twin', t[:-len(c.spelling)] + other)

    def decl_ref_expr(self, c, children):
        d = c.referenced
        if d is None or d.kind not in (self.K.VAR_DECL, self.K.PARM_DECL) or self.text(c) != c.spelling:
            return
        sort = d.type.get_canonical().spelling.replace('const ', '')
        others = sorted({o.spelling for o in self.locals if o.spelling != c.spelling and
                         o.type.get_canonical().spelling.replace('const ', '') == sort and
                         o.location.offset < c.location.offset})
        if others and '[' not in sort:
            self.add(c, 'variable', self.chance.choice(others))

    def statement(self, c, parent, place):
        K = self.K
        n = len(list(parent.get_children()))
        is_statement = parent.kind == K.COMPOUND_STMT or (parent.kind == K.IF_STMT and place > 0) or \
            (parent.kind in (K.FOR_STMT, K.WHILE_STMT, K.CASE_STMT, K.DEFAULT_STMT) and place == n - 1)
        assigns = c.kind in (K.CALL_EXPR, K.COMPOUND_ASSIGNMENT_OPERATOR, K.BREAK_STMT, K.CONTINUE_STMT, K.BINARY_OPERATOR)
        if is_statement and assigns:
            end = c.extent.end.offset
            semicolon = re.match(rb'\s*;', self.source[end:])
            if semicolon:
                self.add(c, 'statement', ';', end + semicolon.end(), True)


def guarded(source, chosen):
    """The source with its chosen candidates (number, candidate) behind switches, and where each of these stands."""
    out, at, places = [b'#include "base/fault.h"\n#line 1\n'], 0, []
    size = len(out[0])
    for number, c in sorted(chosen, key=lambda item: item[1].start):
        if c.statement:
            new = '{ if (!FLK_FAULT(%d)) { %s } }' % (number, c.right)
        else:
            new = '(FLK_FAULT(%d) ? (%s) : (%s))' % (number, c.faulty, c.right)
        for piece in (source[at:c.start], new.encode()):
            out.append(piece)
            size += len(piece)
        places.append((size - len(new.encode()), size, number))
        at = c.end
    return b''.join(out + [source[at:]]), places


def compiling(finder, chosen):
    """The guarded source without those candidates that do not compile, and the numbers of these."""
    bad = set()
    while True:
        left = [item for item in chosen if item[0] not in bad]
        text, places = guarded(finder.source, left)
        unit = finder.index.parse(finder.path, finder.arguments, unsaved_files=[(finder.path, text.decode())])
        errors = [d for d in unit.diagnostics if d.severity >= 3]
        if not errors or not left:
            return text, bad
        here = {n for d in errors for a, b, n in places if d.location.offset >= a and d.location.offset <= b}
        bad |= here or {n for _, _, n in places}  # one that breaks what is around it: none of this file


def choose(finders, n, chance):
    """n candidates, evenly over folders, and in each over the sorts; none inside another."""
    by_folder = collections.defaultdict(list)
    for f in finders:
        by_folder[f.name.split('/')[1]] += f.found
    chosen, taken = [], collections.defaultdict(list)
    folders = sorted(by_folder)
    for k, folder in enumerate(folders):
        wanted = n * (k + 1) // len(folders) - n * k // len(folders)
        sorts = collections.defaultdict(list)
        for c in by_folder[folder]:
            sorts[c.sort].append(c)
        while wanted and sorts:
            sort = chance.choice(sorted(sorts))
            c = sorts[sort].pop(chance.randrange(len(sorts[sort])))
            if not sorts[sort]:
                del sorts[sort]
            if all(c.end <= a or b <= c.start for a, b in taken[c.file]):
                taken[c.file].append((c.start, c.end))
                chosen.append(c)
                wanted -= 1
    return chosen


def finders_of(tree, chance, wanted):
    """The candidates of each source file of TREE that is wanted; TREE gets what switches them."""
    import clang.cindex as clang

    (tree / 'src/base/fault.h').write_text(SWITCH_H)
    (tree / 'src/base/fault.c').write_text(SWITCH_C)
    names = sorted(str(p.relative_to(tree)) for p in tree.glob('src/*/*.c')
                   if not re.search('_windows|assets|base/fault', p.name + str(p)))
    index = clang.Index.create()
    return [Finder(clang, index, tree, name, chance) for name in names if wanted(name)]


def squeezed(words):
    return ' '.join(words.split())


def line_of(source, at):
    """The line of a place."""
    return squeezed(source[source.rfind(b'\n', 0, at) + 1:source.find(b'\n', at)].decode('utf-8'))


def write(finders, final, listing):
    for f in finders:
        text, _ = guarded(f.source, [item for item in final if item[1].file == f.name])
        pathlib.Path(f.path).write_bytes(text)
    sources = {f.name: f.source for f in finders}
    json.dump([dict(c._asdict(), number=number, within=line_of(sources[c.file], c.start)) for number, c in sorted(final)],
              open(listing, 'w'), indent=1)


def put(tree, n, seed, listing, *only):
    tree, chance = pathlib.Path(tree).resolve(), random.Random(seed)
    finders = finders_of(tree, chance, lambda name: not only or name.split('/')[1] in only)
    # twice as many as asked, for those that do not compile
    chosen = list(enumerate(choose(finders, n * 2, chance)))
    kept, share = [], collections.Counter()
    for f in finders:
        text, bad = compiling(f, [item for item in chosen if item[1].file == f.name])
        kept += [item for item in chosen if item[1].file == f.name and item[0] not in bad]
    chance.shuffle(kept)
    folders = sorted({f.name.split('/')[1] for f in finders})
    most = -(-n // len(folders))
    final = []
    for number, c in kept:
        folder = c.file.split('/')[1]
        if share[folder] < most and len(final) < n:
            share[folder] += 1
            final.append((number, c))
    write(finders, final, listing)
    print('candidates: %d; faults put in: %d, in %d folders' %
          (sum(len(f.found) for f in finders), len(final), len(folders)))


def again(tree, out, listing, *only):
    """Put those of an earlier run in again that survived, where the sources have them now."""
    tree, final = pathlib.Path(tree).resolve(), []
    old = [f for f in json.load(open(out)) if 'by' not in f and (not only or f['file'].split('/')[1] in only)]
    finders = finders_of(tree, random.Random(0), lambda name: any(f['file'] == name for f in old))
    for finder in finders:
        for f in (f for f in old if f['file'] == finder.name):
            there = sorted((c for c in finder.found if (c.sort, c.right) == (f['sort'], f['right'])),
                           key=lambda c: (abs(c.line - f['line']), abs(c.start - f['start'])))
            for c in there:
                item = f['number'], c._replace(faulty=f['faulty'])
                beside = [d for _, d in final if d.file == c.file]
                if all(c.end <= d.start or d.end <= c.start for d in beside) and not compiling(finder, [item])[1]:
                    final.append(item)
                    break
            else:
                print('gone: %s:%d: %s' % (f['file'], f['line'], f['right']))
    write(finders, final, listing)
    print('faults put in again: %d' % len(final))


# ------------------------------------------------------------------------------------------ tests


def tests_of(build, config):
    shown = subprocess.run(['ctest', '--test-dir', build, '--show-only=json-v1'] + (['-C', config] if config else []),
                           capture_output=True, check=True).stdout
    tests = []
    for t in json.loads(shown)['tests']:
        properties = {p['name']: p['value'] for p in t.get('properties', [])}
        if 'command' in t and (not config or config in properties.get('LABELS', [])):
            tests.append(dict(name=t['name'], command=t['command'], folder=properties.get('WORKING_DIRECTORY', build),
                              skip=properties.get('SKIP_RETURN_CODE'), lock=threading.Lock(),
                              environment=dict(e.split('=', 1) for e in properties.get('ENVIRONMENT', []))))
    return tests


def passes(test, limit, **variables):
    """The status of a test is 0, or that of one that is skipped; and the seconds that it took."""
    environment = dict(os.environ, **test['environment'], STOP_AT_FAILURE='1', **variables)
    with test['lock']:
        begin = time.time()
        with tempfile.TemporaryDirectory() as scratch:
            p = subprocess.Popen(test['command'], cwd=test['folder'], env=dict(environment, TMPDIR=scratch),
                                 stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                 start_new_session=True)
            try:
                status = p.wait(limit)
            except subprocess.TimeoutExpired:
                status = 'late'
            try:
                os.killpg(p.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
            p.wait()
        return status == 0 or status == test['skip'], time.time() - begin


def measure(test):
    """Which faults the test reaches, none of them being on."""
    with tempfile.NamedTemporaryFile() as file:
        file.write(bytes(MOST))
        file.flush()
        test['passes'], test['seconds'] = passes(test, 600, REACHED=file.name)
        with mmap.mmap(file.fileno(), MOST) as seen:
            test['reached'] = {i for i in range(MOST) if seen[i]}
    return test


def run(build, listing, out, config=None):
    faults = json.load(open(listing))
    old = {f['number']: f for f in json.load(open(out))} if os.path.exists(out) else {}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        tests = list(pool.map(measure, tests_of(build, config)))
    for t in tests:
        if not t['passes']:
            print('left out, it fails without a fault:', t['name'])
    tests = sorted((t for t in tests if t['passes']), key=lambda t: t['seconds'])
    column = config or 'ctest'

    def judge(f):
        f = old.get(f['number'], f)
        if 'by' in f:
            return f
        f['reached'] = sum(f['number'] in t['reached'] for t in tests) + f.get('reached', 0)
        for t in tests:
            if f['number'] in t['reached'] and not passes(t, 10 + 10 * t['seconds'], FAULT=str(f['number']))[0]:
                f['by'], f['in'] = t['name'], column
                break
        print('%s %s:%d %s' % ('noticed' if 'by' in f else 'survived', f['file'], f['line'], f.get('by', '')), flush=True)
        return f

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        faults = list(pool.map(judge, faults))
    json.dump(faults, open(out, 'w'), indent=1)


# ------------------------------------------------------------------------------------------ scripts


def scripts(tree, build, n, seed, out, *only):
    """A script is no part of the build for these tests, so that a fault is a change of its file in TREE."""
    tree, chance = pathlib.Path(tree).resolve(), random.Random(seed)
    files = only or ['src/report/elements.js', 'src/report/player.js', 'web/page/drawn.js']  # what these tests read
    shown = subprocess.run(['node', 'tests/faults.js', *files], cwd=tree, capture_output=True, check=True).stdout
    by_file = collections.defaultdict(list)
    for f in json.loads(shown):
        by_file[f['file']].append(f)
    tests = [t for t in tests_of(build, None) if t['name'] in ('test_replayed', 'test_drawn_decks')]
    if not all(passes(t, 600)[0] for t in tests):
        sys.exit('the tests fail without a fault')
    faults = []
    for number in range(n):
        name = files[number % len(files)]
        f = by_file[name].pop(chance.randrange(len(by_file[name])))
        path = tree / name
        source = path.read_bytes()
        f.update(number=number, faulty=chance.choice(f['faulty']), within=line_of(source, f['start']), statement=False, reached=1)
        path.write_bytes(source[:f['start']] + f['faulty'].encode() + source[f['end']:])
        try:
            for t in tests:
                if not passes(t, 120)[0]:
                    f['by'], f['in'] = t['name'], 'ctest'
                    break
        finally:
            path.write_bytes(source)
        print('%s %s:%d %s -> %s' % ('noticed' if 'by' in f else 'survived', f['file'], f['line'], squeezed(f['right']), squeezed(f['faulty'])),
              flush=True)
        faults.append(f)
    json.dump(faults, open(out, 'w'), indent=1)


# ------------------------------------------------------------------------------------------ what survived


def same_code(tree, f):
    """1 if the fault leaves the machine code as it is."""
    if f['file'].endswith('.js'):
        return 0
    codes = []
    for text in (f['right'], ';' if f['statement'] else '(%s)' % f['faulty']):
        path = pathlib.Path(tree) / f['file']
        source = path.read_bytes()
        if source[f['start']:f['end']].decode('utf-8', 'replace') != f['right']:
            return 0  # the sources have changed since
        new = source[:f['start']] + text.encode() + source[f['end']:]
        with tempfile.NamedTemporaryFile() as object_file:
            subprocess.run(['cc', '-w', '-O2', '-std=gnu11', '-ffp-contract=off', '-I', tree + '/src', '-I', tree + '/include',
                            '-I', str(path.parent), '-xc', '-c', '-', '-o', object_file.name], input=new, check=True)
            codes.append(object_file.read())
    return codes[0] == codes[1]


def key_of(f):
    return '%s: %s' % (f['file'], f['within']), '%s -> %s' % (squeezed(f['right']), squeezed(f['faulty']))


def reasons(tree, known):
    """Of each survivor that is known: why no test has to notice it.  Reasons whose line is gone are told."""
    table, place = {}, None
    for line in open(known):
        line = line.rstrip('\n')
        if line.startswith(('src/', 'web/')):
            place = line
            file, words = line.split(': ', 1)
            path = pathlib.Path(tree) / file
            if not path.exists() or words not in [squeezed(x) for x in path.read_text().split('\n')]:
                print('gone:', line)
        elif line.startswith('  '):
            change, why = line.strip().split(' | ')
            table[place, change] = why
    return table


def table(tree, out, known):
    faults, why = json.load(open(out)), reasons(tree, known)
    rows = collections.defaultdict(collections.Counter)
    for f in faults:
        row = rows['scripts' if f['file'].endswith('.js') else f['file'].split('/')[1]]
        if 'by' not in f and same_code(tree, f):
            row['same code'] += 1
        else:
            row['faults'] += 1
            if 'by' in f:
                row[f['in']] += 1
            elif key_of(f) in why:
                row['no effect' if why[key_of(f)].startswith('no effect') else 'known'] += 1
            else:
                row['left'] += 1
                print('survived%s: %s:%d (%s): %s' % ('' if f['reached'] else ', not reached', f['file'], f['line'], f['sort'],
                                                    key_of(f)[1]))
    print('%-10s %7s %6s %5s %9s %6s %5s %7s' % ('folder', 'faults', 'ctest', 'long', 'no effect', 'known', 'left', 'share'))
    rows['all'] = sum((rows[k] for k in list(rows)), collections.Counter())
    for folder, r in rows.items():
        able = r['faults'] - r['no effect']
        print('%-10s %7d %6d %5d %9d %6d %5d %6.1f %%' % (folder, r['faults'], r['ctest'], r['long'], r['no effect'], r['known'],
                                                        r['left'], 100 * r['ctest'] / able if able else 100))
    return 1 if rows['all']['left'] else 0


if __name__ == '__main__':
    command, arguments = sys.argv[1], sys.argv[2:]
    if command == 'put':
        put(arguments[0], int(arguments[1]), *arguments[2:])
    elif command == 'again':
        again(*arguments)
    elif command == 'scripts':
        scripts(arguments[0], arguments[1], int(arguments[2]), *arguments[3:])
    elif command == 'run':
        run(*arguments)
    elif command == 'table':
        sys.exit(table(*arguments))
    else:
        sys.exit(__doc__)
