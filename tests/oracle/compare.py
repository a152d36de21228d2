# SPDX-License-Identifier: GPL-3.0-or-later
#
# compare.py [--rows] FOURLINK DECK... - the oracle against the program: every column of each row, statuses, facts, extremes,
# means, crossings, inputs; with --rows only the rows.  Prints what differs, how many values of each kind were compared
# with the worst difference, and which decks were left out.
#
# The one tolerance: a value may differ by a part of its scale (TOLERANCE).  In a row the scale of a quantity is its
# largest value there, and at least what the motion and the masses give it (scales_of); it is multiplied by the square of
# 1 / sin(mu), by which rounding grows near a dead position, and, if less of a value is determined, as of a direction of a
# small force, by what columns.py says.  Along a motion the scale of a column is its largest value away from dead positions.
import csv
import io
import os
import re
import subprocess
import sys
import time
import traceback
import warnings
import zlib

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import facts  # noqa: E402
from columns import columns  # noqa: E402
from deck import NUMBER, UNITS, Deck, si_name, unit_of  # noqa: E402
from machine import LOCKED, TURN, Machine  # noqa: E402
from motion import Given, Integrated, Stops  # noqa: E402
from search import NEAR, Track, actual  # noqa: E402

TOLERANCE = {'row': 2e-12, 'row of an integrated motion': 1e-9, 'extreme': 1e-9, 'extreme near a dead position': 1e-6,
             'mean': 1e-9, 'crossing': 1e-9, 'fact': 1e-9, 'fact of an integrated motion': 1e-8, 'input': 1e-14}
ROUNDING = ('residual', 'superposition', 'energy_residual')  # are 0 but for rounding
UNCERTAIN = 1e9  # a value that is so many times less certain than others is not compared
WORDS = {'cannot be assembled: B and D are too far apart': 'apart', 'cannot be assembled: B and D are too close together': 'apart',
         'the rod does not reach the line of stroke': 'apart', 'dead position: the motion is not determined by the crank': 'dead',
         'change point: the motion can continue in two ways': 'change', 'friction locks the mechanism': 'locked'}

OUTPUT_APART = tuple(' cannot be assembled: ' + why for why in ('its rod does not reach', 'P is nearer to its pin than the offset of its slot',
                                                               'it does not reach the slot'))


def meaning_of(words):
    return 'apart' if words.endswith(OUTPUT_APART) else WORDS.get(words)


class Tally:
    """Counts what was compared, and keeps the worst of each kind."""

    def __init__(self):
        self.count, self.worst, self.failed, self.undecided, self.left_out = {}, {}, [], {}, []

    def compare(self, sort, kind, told, found, scale, where):
        """Arrays or numbers; the worst of those that are to be compared."""
        told, found, scale = np.broadcast_arrays(np.asarray(told, float), np.asarray(found).astype(float), np.asarray(scale, float))
        with np.errstate(all='ignore'):
            error = np.where(told == found, 0, abs(told - found) / scale)
        error = np.where(np.isnan(told) & np.isnan(found), 0, np.where(np.isnan(error), np.inf, error)).ravel()
        if not error.size:
            return
        self.count[sort, kind] = self.count.get((sort, kind), 0) + error.size
        k = int(np.argmax(error))
        if error[k] > TOLERANCE[sort]:
            self.failed.append('%s: %s: %.17g, oracle %.17g (%.1e of the scale)' % (where(k), sort, told.ravel()[k], found.ravel()[k], error[k]))
        elif error[k] >= self.worst.get((sort, kind), (0,))[0]:
            self.worst[sort, kind] = error[k], where(k)

    def that(self, is_so, sort, kind, words):
        self.count[sort, kind] = self.count.get((sort, kind), 0) + 1
        if not is_so:
            self.failed.append('%s: %s' % (sort, words))

    def skip(self, why):
        self.undecided[why] = self.undecided.get(why, 0) + 1

    def report(self):
        for line in self.failed[:200]:
            print('FAILED: ' + line)
        for words in self.left_out:
            print('left out: ' + words)
        print('%-32s %-12s %10s %10s' % ('', 'in', 'values', 'worst'))
        for key in sorted(self.count):
            worst, where = self.worst.get(key, (0, ''))
            print('%-32s %-12s %10d %10.1e %s' % (key + (self.count[key], worst, where)))
        print('not decided: ' + (', '.join('%s %d' % item for item in sorted(self.undecided.items())) or 'nothing'))
        print('%d passed, %d failed' % (sum(self.count.values()) - len(self.failed), len(self.failed)))


def run(fourlink, *arguments):
    done = subprocess.run([fourlink, '-f', 'csv', *arguments], capture_output=True, stdin=subprocess.DEVNULL, text=True, timeout=300)
    return list(csv.reader(io.StringIO(done.stdout))), done.stderr


def number(cell):
    """A cell of csv."""
    return float(cell) if cell else np.nan


def scales_of(m, s, values, small, units):
    """unit -> the scale of its quantity in each row."""
    w, al, r = abs(s.omega2.astype(float)), abs(s.alpha2.astype(float)), float(m.a)
    force = sum(mass * np.abs(s.a[k] - m.g).astype(float) for k, (mass, _, _) in enumerate(m.masses) if k) + 1e-300
    scale = {'m': r, 'm/s': r * w, 'm/s2': r * (w * w + al), 'rad/s': w, 'rad/s2': w * w + al, 'N': force, 'rad': 1,
             'kg.m2': sum(mass for mass, _, _ in m.masses) * r * r, '1': 1, 'm2': r * r, 's': 1e-300}
    if m.gas:
        scale.update({'m3': float(m.bore_area * sum(m.length)), 'Pa': m.largest_pressure})
    scale = {unit: value + 0 * w for unit, value in scale.items()}
    for name, value in values.items():
        if name in units and name not in small and units[name] not in ('1', 'rad'):
            value = abs(np.asarray(value).astype(float) + 0 * w)
            scale[units[name]] = np.fmax(scale.get(units[name], 0 * w), np.where(np.isfinite(value), value, 0))
    lever = np.maximum(scale['m'], r)
    scale['N.m'] = np.fmax(scale.get('N.m', 0 * w), scale['N'] * r)
    scale['N'] = np.fmax(scale['N'], scale['N.m'] / lever)
    scale['W'] = np.fmax(scale.get('W', 0 * w), scale['N.m'] * w)
    return scale


def compare_rows(tally, name_of_deck, m, motion, label, heads, rows, forces):
    """The rows of a branch."""
    where = '%s, %s' % (name_of_deck, 'open' if label > 0 else 'crossed')
    integrated = isinstance(motion, Integrated)
    why = None
    try:
        (theta2, omega2, alpha2, t), why = motion.table(label)
    except Stops as stop:
        theta2, why = [], stop.args[1]
        if why == 'does not start' and rows[0][-1] == 'ok':
            rows = rows[1:]
    told = [row[-1] for row in rows]
    early = why and why not in (None,)
    if early:
        last = told[-1] if told else ''
        agrees = {'stalls': last.startswith('stalls'), 'does not start': last.startswith('does not start'),
                  'no steady motion': last.startswith('no steady')}.get(why, meaning_of(last) in ('apart', 'dead', 'change', why) or last.startswith('near'))
        tally.that(agrees, 'status', 'ends', '%s: ends with %r, oracle: %s' % (where, last, why))
        rows = rows[:len(theta2)]
        told = told[:len(theta2)]
        theta2, omega2, alpha2, t = (x[:len(rows)] for x in (theta2, omega2, alpha2, t)) if len(theta2) else ([],) * 4
    tally.that(len(theta2) == len(rows), 'status', 'rows', '%s: %d rows, oracle %d' % (where, len(rows), len(theta2)))
    if len(theta2) != len(rows) or not rows:
        return
    s = m.state(theta2, omega2, alpha2, label, sense=motion.sense_of(label) if not integrated else motion.sense)
    s.sense = np.where(s.omega2 != 0, np.sign(s.omega2), s.sense)
    values, small = columns(m, s, forces) if s.which.any() else ({}, {})
    status = s.status.copy()
    if forces and s.which.any():
        status[np.nonzero(s.which)[0][s.locked]] = LOCKED
    ok = np.array([x == 'ok' or x.startswith('near a dead') for x in told])
    for k, (ours, theirs) in enumerate(zip(status, told)):
        sine = s.sine[s.which[:k].sum()] if s.which[k] else 0
        if ours == LOCKED or theirs.startswith('friction') and sine < 0.02:
            continue
        tally.that(ok[k] if ours == 'ok' else meaning_of(theirs) == ours or theirs.startswith('near'), 'status', 'words',
                   '%s at %s: %r, oracle: %s' % (where, rows[k][1], theirs, ours))
    compare = ok & s.which
    if not compare.any():
        return
    if integrated:
        values.update(actual(m, motion, s))
    values['time'] = t[s.which]
    inside = (np.cumsum(s.which) - 1)[compare]
    units = {name: si_name(unit) for name, unit in heads}
    scale = scales_of(m, s, values, small, units)
    condition = (1 / s.sine.astype(float) ** 2)[inside]
    sort = 'row of an integrated motion' if integrated else 'row'
    for j, (name, unit) in enumerate(heads):
        if name in ('branch', 'status'):
            continue
        if name not in values:
            tally.failed.append('%s: unknown column %s' % (where, name))
            continue
        theirs = np.array([number(row[j]) for row, there in zip(rows, compare) if there]) * unit_of(unit or '')[0]
        ours = (np.asarray(values[name]) + 0 * s.theta2)[inside]
        kind = units[name]
        size = scale[kind][inside] * (condition if name not in ('theta2', 'omega2', 'alpha2', 'time') else 1)
        if name in ROUNDING:
            tally.compare(sort, 'rounding', theirs, 0 * theirs, 1e3 * condition, lambda k: '%s, %s at %s' % (where, name, rows[k][1]))
            continue
        if name == 'mechanical_advantage':  # by its reciprocal, which is finite
            theirs, ours = 1 / theirs, 1 / ours
        doubt = uncertainty(name, values, small, scale, s)[inside]
        sure = doubt < UNCERTAIN
        if not sure.all():
            tally.skip('rows of rounding')
        if kind == 'rad' and name != 'theta2':
            theirs = ours + (theirs - ours + TURN / 2) % TURN - TURN / 2
        at = [row[1] for row, there in zip(rows, compare) if there]
        tally.compare(sort, kind, theirs[sure], ours[sure], (size * doubt)[sure], lambda k: '%s, %s at %s' % (where, name, np.array(at)[sure][k]))


def uncertainty(name, values, small, scale, s):
    """By how much more than its quantity a column is uncertain, in each row."""
    one = np.ones(len(s.theta2))
    with np.errstate(all='ignore'):
        if name in small and name != 'mechanical_advantage':
            return np.nan_to_num(1 / small[name].astype(float) ** 2, nan=np.inf)
        if name.endswith('_dir'):
            size = abs(values[name[:-4]].astype(float))
            return np.nan_to_num(scale['N'] / size, nan=np.inf)
        if re.fullmatch('h[234]', name):
            k = int(name[1])
            size = abs(values['Fi%d' % k].astype(float))
            return np.nan_to_num((scale['N'] / size) ** 2, nan=np.inf)
        if name == 'efficiency':
            return np.nan_to_num(scale['N.m'] / np.minimum(abs(values['Ts']), abs(values['Ts0'])).astype(float), nan=np.inf)
    return one


def compare_extremes(tally, where, track, told, units):
    """told: (statistic, column) -> (value, p or None)."""
    angles = {name for name, unit in units.items() if unit == 'rad'}
    names = [name for name in {name for _, name in told} if name in track.values and name not in ROUNDING and name != 'theta2']
    best = track.extremes(names, angles)
    asked = [(key, value, p) for key, (value, p) in told.items() if key[0] in ('max', 'min') and p is not None]
    there = track.at(np.clip([p for _, _, p in asked], 0, track.length)) if asked else {}
    place = {key: i for i, (key, _, _) in enumerate(asked)}
    unit_size = {}
    for name in names:
        size = track.size(name)
        unit_size[units[name]] = max(unit_size.get(units[name], 0), size if np.isfinite(size) else 0)
    for name in names:
        own = track.size(name)
        if not own > 1e-9 * unit_size[units[name]]:
            tally.skip('extremes of rounding')
            continue
        doubtful = name.endswith('_dir') or name == 'efficiency' or name in track.small and name not in ('mechanical_advantage', 'mu')
        for sign, statistic in ((1, 'max'), (-1, 'min')):
            key = statistic, name
            if key not in told or (name, sign) not in best:
                tally.skip('extremes of angles that jump' if name in angles else 'extremes without rows')
                continue
            value, p = told[key]
            row, at, limit = best[name, sign]
            label = lambda k: '%s, %s(%s)' % (where, statistic, name)
            if np.isinf(value):
                tally.that(np.isinf(limit) or track.has_pole(name), 'extreme', 'unbounded', '%s is %g, oracle %g at %g' % (label(0), value, row, at))
                continue
            if np.isinf(limit) or doubtful:
                tally.skip('extremes near poles')
                if np.isinf(limit) and not doubtful and sign * limit > 0:
                    tally.that(False, 'extreme', 'unbounded', '%s is %g, oracle: unbounded' % (label(0), value))
                continue
            near = is_near(track, at)
            size = max(own, abs(value))
            sort = 'extreme near a dead position' if near else 'extreme'
            missed = max(sign * (float(row) - value), 0)
            if name in angles:
                missed = min(missed, abs((missed + TURN / 2) % TURN - TURN / 2))
            tally.compare(sort, units[name], missed, 0, size, lambda k: label(k) + ' missed at %.9g, %.17g for %.17g' % (at, row, value))
            if np.isfinite(limit):
                missed = max(sign * (float(limit) - value), 0)
                missed = abs((missed + TURN / 2) % TURN - TURN / 2) if name in angles else missed
                tally.compare('extreme near a dead position', units[name], missed, 0, size, lambda k: label(k) + ' limit')
            if key in place:
                own_value = there[name][place[key]] if name in there else np.nan
                near = is_near(track, p)
                candidates = [own_value] + [lim[name] for at_, lim in track.limits if abs(at_ - p) < 1e-5 and name in lim]
                off = [abs(float(x) - value) for x in candidates if np.isfinite(float(x))]
                off = [abs((x + TURN / 2) % TURN - TURN / 2) if name in angles else x for x in off]
                if not off:
                    tally.skip('extremes told where there is no row')
                    continue
                corner = min([abs(p - c) for c in track.corners], default=1) < 1e-5
                if corner and min(off) > 1e-9 * size:
                    tally.skip('extremes at corners')
                    continue
                tally.compare('extreme near a dead position' if near else 'extreme', units[name], min(off), 0, size, lambda k: label(k) + ' is not the row at %.12g' % p)


def is_near(track, p):
    """1 near a dead position, a change point or rest."""
    i = int(np.argmin(abs(track.p - p)))
    v = track.values
    rows = slice(max(i - 2, 0), i + 3)
    sine = 1 / v['condition'][rows].astype(float)
    speed = abs(v['omega2'].astype(float))
    return not (sine > NEAR).all() or not (speed[rows] > NEAR * np.nanmax(speed)).all() or any(abs(e[0] - p) < 0.05 for e in track.edges)


def compare_facts(tally, where, told, found, sort):
    """told: name -> list of (value, unit)."""
    for name, value in found.items():
        values = value if isinstance(value, list) else [value]
        turn = float(TURN) * (1 + 1e-9) if name.endswith(('_from', '_to')) else np.inf
        for (given, unit), own in zip(sorted((x % turn, unit) for x, unit in told.get(name, [])), sorted(float(x) % turn for x in values)):
            scale = 1 if unit == 'deg' else abs(own) or 1
            if unit == 'deg':
                given = own + (given - own + float(TURN) / 2) % float(TURN) - float(TURN) / 2
                scale = 1e3 if name in ('theta2_from', 'theta2_to') or '_dead_centre' in name else 1
            tally.compare(sort, name, given, own, scale, lambda k: '%s, %s' % (where, name))


def compare_inputs(tally, path, deck, lines):
    """Inputs that are a number with a unit."""
    for name, value, unit in ((line[0], line[1], line[2]) for line in lines if '.' in line[0] and '(' not in line[0]):
        section, key = name.split('.', 1)
        kind, _, own = section.partition(' ')
        for which, label, keys in deck.sections:
            match = which == kind and label == own and re.fullmatch(r'(%s) +([A-Za-z]\S*(?: [A-Za-z]\S*)*)' % NUMBER, keys.get(key, ''))
            if match and all(word in UNITS for word in re.findall(r'[A-Za-z]+', match[2])):
                tally.compare('input', 'inputs', float(value) * unit_of(unit)[0], float(match[1]) * unit_of(match[2])[0], abs(float(match[1]) * unit_of(match[2])[0]) or 1,
                              lambda k: '%s, %s' % (path, name))


def compare_crossings(tally, fourlink, path, where, track, units, columns_of_deck, branch, motion):
    """Where a few columns have values that lie between their extremes."""
    random = np.random.RandomState(zlib.crc32(where.encode()) % 2 ** 31)
    names = [n for n in columns_of_deck if n in track.values and n not in ROUNDING and units[n] and n not in ('theta2', 'omega2', 'alpha2', 'time')]
    for name in random.permutation(names)[:5]:
        v = track.values[name].astype(float)
        ok = np.isfinite(v) & (track.values['condition'].astype(float) < 10)
        if not ok.any() or np.ptp(v[ok]) < 1e-6 * (track.size(name) + 1e-300) or track.size(name) < 1e-9:
            continue
        value = float('%.9g' % (random.choice(v[ok]) / unit_of(units[name])[0] * random.uniform(0.95, 1.05)))
        si = value * unit_of(units[name])[0]
        lines, errors = run(fourlink, '--at=%s = %.17g %s' % (name, value, units[name]), '-c', 'theta2,' + name, '-b', branch, path)
        if not lines:
            tally.skip('crossings refused')
            continue
        told = np.array([float(line[1]) for line in lines[1:] if line[0] == branch and line[-1].startswith(('ok', 'near'))]) * unit_of('deg')[0]
        p = motion.sense * (told - motion.start)
        own = track.crossings(name, si, units[name] == 'deg')
        size = max(track.size(name), abs(si))
        label = lambda k: '%s, %s = %.17g %s' % (where, name, value, units[name])
        if len(p):
            at = track.at(np.clip(p, 0, track.length))
            rows = at[name]
            if units[name] == 'deg':
                rows = si + (rows - si + TURN / 2) % TURN - TURN / 2
            near = [is_near(track, x) or not np.isfinite(float(r)) or min([abs(x - c) for c in track.corners], default=1) < 1e-6 for x, r in zip(p, rows)]
            keep = ~np.array(near)
            tally.compare('crossing', units[name], rows[keep], si + 0 * p[keep], size, label)
        for x in own:
            if is_near(track, x) or min([abs(x - c) for c in track.corners], default=1) < 1e-6 or name in track.small and name != 'mu':
                tally.skip('crossings near dead positions and corners')
                continue
            tally.that(len(p) and abs(p - x).min() < 1e-6, 'crossing', 'found', '%s: none told at %.9g deg' % (label(0), float(track.angle(x)) * 360 / float(TURN)))


def compare_deck(tally, fourlink, path, rows_only):
    name = os.path.basename(path)
    lines, told = run(fourlink, '-c', 'all', path)
    if not lines:
        tally.left_out.append('%s: the program has no rows: %s' % (name, told.strip().splitlines()[0][:150] if told.strip() else ''))
        return
    deck = Deck(path)
    for kind in ('sweep', 'synthesis'):
        if deck.has(kind):
            tally.left_out.append('%s has a [%s]' % (name, kind))
            return
    m = Machine(deck)
    integrated = deck.word('motion', 'mode', 'given') != 'given'
    motion = Integrated(m) if integrated else Given(m)
    heads = [re.fullmatch(r'(\S+)(?: \((.*)\))?', head).groups() for head in lines[0]]
    forces = any(head[0] == 'Ts' for head in heads)
    units = {name: unit or '' for name, unit in heads}
    kinds = {name: si_name(unit) for name, unit in heads}
    summary, _ = ([], '') if rows_only else run(fourlink, '--summary', '-c', 'all', path)
    compare_inputs(tally, name, deck, summary)
    told = {}
    for line in summary[1:]:
        told.setdefault((line[0], line[4]), []).append(line)
    if summary:
        compare_facts(tally, name, numbers(told, ''), facts.of_geometry(m), 'fact')
    for branch, label in (('open', 1), ('crossed', -1)):
        rows = [line for line in lines[1:] if line[0] == branch]
        if not rows:
            continue
        compare_rows(tally, name, m, motion, label, heads, rows, forces)
        if not summary:
            continue
        where = '%s, %s' % (name, branch)
        own = numbers(told, branch)
        compare_facts(tally, where, own, facts.of_branch(m, label), 'fact')
        if integrated and label not in motion.paths:
            tally.skip('facts and extremes of rows by time, or without motion')
            continue
        omega, inertia = (motion.speed, deck.number('flywheel', 'inertia', 'inertia'))
        if integrated:
            path_ = motion.paths[label]
            if path_.why is None and (motion.mode == 'steady' or motion.mode == 'free' and motion.length >= m.cycle * (1 - 1e-12)):
                of_motion = motion.facts(path_)
                compare_facts(tally, where, own, of_motion, 'fact of an integrated motion')
                omega, inertia = float(of_motion['mean_speed']), motion.motor.inertia
            if path_.why == 'stalls':
                compare_facts(tally, where, own, {'stall_angle': motion.start + motion.sense * path_.length}, 'fact of an integrated motion')
        if forces and 'mean_torque' in own and omega and motion.__dict__.get('mode') in (None, 'steady'):
            compare_facts(tally, where, own, facts.turning(m, label, omega, inertia), 'fact of an integrated motion' if integrated else 'fact')
        if motion.length < 1e-9 or motion.length > 40 * float(TURN):
            continue
        track = Track(m, motion, label, forces)
        extremes = {}
        for (head, of), found in told.items():
            match = re.fullmatch(r'(max|min)\((.*)\)', head)
            if match and of == branch:
                theta2 = number(found[0][3]) * unit_of('deg')[0]
                p = None if np.isnan(theta2) else motion.sense * (theta2 - motion.start)
                extremes[match.groups()] = float(found[0][1]) * unit_of(found[0][2] if found[0][2] != '1' else '')[0], p
        compare_extremes(tally, where, track, extremes, kinds)
        means = track.means([n for n in track.values if n in units and n not in ROUNDING], {n for n, kind in kinds.items() if kind == 'rad'})
        names = sorted(means)
        for k in range(0, len(names), 30):
            part = names[k:k + 30]
            answer, _ = run(fourlink, '-c', ','.join('mean(%s),rms(%s)' % (n, n) for n in part), '-b', branch, path)
            row = [line for line in answer[1:] if line[0] == branch]
            for n, cells in zip(part, zip(row[0][1::2], row[0][2::2])) if row else ():
                factor = unit_of(units[n] or '')[0]
                for value, ours, what in zip(cells, means[n], ('mean', 'rms')):
                    if value and not (n in track.small and n != 'mu' or n.endswith('_dir') or n == 'efficiency'):
                        tally.compare('mean', kinds[n], number(value) * factor, ours, max(means[n][1], 1e-9 * track.size(n), 1e-300), lambda k: '%s, %s(%s)' % (where, what, n))
        compare_crossings(tally, fourlink, path, where, track, units, [h[0] for h in heads], branch, motion)


def numbers(told, branch):
    """Name -> list of (value, unit) of the facts of a branch."""
    found = {}
    for (name, of), lines in told.items():
        if of == branch and '(' not in name:
            for line in lines:
                if re.fullmatch(NUMBER, line[1]):
                    found.setdefault(name, []).append((float(line[1]) * unit_of(line[2] if line[2] != '1' else '')[0], line[2]))
    return found


def main(arguments):
    rows_only = arguments[:1] == ['--rows']
    fourlink, *decks = arguments[rows_only:]
    tally = Tally()
    warnings.simplefilter('ignore')
    for path in decks:
        begin = time.process_time()
        with open(path, encoding='utf-8', errors='replace') as text:
            words = text.read()
        if re.search(r'^ *(drive|input|program) *=|^ *\[actuator', words, re.M):
            tally.left_out.append('%s: its drive, input or program is not known' % os.path.basename(path))
            continue
        if re.search(r'^ *\[output', words, re.M) and re.search(r'^ *(to_)?place *=', words, re.M):
            tally.left_out.append('%s: the places of its output on the page are not known' % os.path.basename(path))
            continue
        try:
            compare_deck(tally, fourlink, path, rows_only)
        except (ArithmeticError, Stops) as why:
            tally.left_out.append('%s: %s' % (os.path.basename(path), why))
        except Exception:
            tally.failed.append('%s: the oracle fails: %s' % (os.path.basename(path), traceback.format_exc(limit=-2)))
        if os.environ.get('ORACLE_TIMES'):
            print('%s %.1f s' % (path, time.process_time() - begin), file=sys.stderr)
    tally.report()
    return bool(tally.failed or not tally.count)


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
