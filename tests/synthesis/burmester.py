#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
#
# burmester.py FOURLINK [N [SEED]] - five poses of N random linkages.  A link that is pinned at w to the coupler and at m to
# the ground keeps its length: |z_i + e^(i phi_i) w - m| is the same for all five.  These four equations are solved here by
# Newton's method from many starts; there are at most four links (L. Burmester, Lehrbuch der Kinematik, 1888).  Each pair of
# them that is a linkage without defect is to be among those that the command finds, met exactly.
import cmath
import math
import random
import subprocess
import sys

fourlink = sys.argv[1]
number = int(sys.argv[2]) if len(sys.argv) > 2 else 100
seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
STARTS = 1500
LEAST_MU = 1.0     # deg, in the working range; as good as dead is left out
FARTHEST = 15.0    # a link or a pivot, in sizes of the task; others are hard to find for both


def pose_at(ground, crank, coupler, rocker, branch, theta2):
    """B and the direction of the coupler, A at 0 and D at `ground`."""
    B = cmath.rect(crank, theta2)
    f = ground - B
    x = (coupler ** 2 - rocker ** 2 + abs(f) ** 2) / (2 * abs(f))
    if coupler ** 2 < x * x:
        return None
    return B, cmath.phase(complex(x, branch * math.sqrt(coupler ** 2 - x * x)) * f)


def turns_fully(g, a, b, c):
    s = sorted([g, a, b, c])
    return s[0] + s[3] < s[1] + s[2] and (a == s[0] or g == s[0])


def draw(rng):
    """Five poses of a linkage whose crank turns fully: [(place, angle)], in mm and rad."""
    while True:
        g, a, b, c = [rng.uniform(20, 120) for _ in range(4)]
        if turns_fully(g, a, b, c):
            break
    branch, way = rng.choice([1, -1]), rng.choice([1, -1])
    first, turn = rng.uniform(0, 2 * math.pi), rng.uniform(1.5, 5.5)
    w, axes = complex(rng.uniform(-60, 60), rng.uniform(-60, 60)), cmath.rect(1, rng.uniform(0, 6.28))
    poses = []
    for k in range(5):
        B, angle = pose_at(g, a, b, c, branch, first + way * turn * (k + rng.uniform(-0.2, 0.2)) / 4)
        poses.append((axes * (B + w * cmath.rect(1, angle)) + complex(10, -20), angle + cmath.phase(axes)))
    return poses


def solve(M, r):
    """M x = r by elimination; None if M is singular."""
    M = [row[:] + [y] for row, y in zip(M, r)]
    for k in range(4):
        p = max(range(k, 4), key=lambda i: abs(M[i][k]))
        if abs(M[p][k]) < 1e-300:
            return None
        M[k], M[p] = M[p], M[k]
        for i in range(4):
            if i != k:
                q = M[i][k] / M[k][k]
                M[i] = [x - q * y for x, y in zip(M[i], M[k])]
    return [M[k][4] / M[k][k] for k in range(4)]


def links(poses, rng):
    """All (w, m) of links, w in the coupler's axes."""
    centre = sum(z for z, _ in poses) / 5
    size = math.sqrt(sum(abs(z - centre) ** 2 for z, _ in poses) / 5)
    z = [(p - centre) / size for p, _ in poses]
    e = [cmath.rect(1, angle) for _, angle in poses]
    found = []
    for _ in range(STARTS):
        span = 10 ** rng.uniform(-0.5, 1)
        x = [span * rng.gauss(0, 1) for _ in range(4)]
        for step in range(40):
            w, m = complex(x[0], x[1]), complex(x[2], x[3])
            d = [z[i] + e[i] * w - m for i in range(5)]
            r = [abs(d[i]) ** 2 - abs(d[0]) ** 2 for i in range(1, 5)]
            M = []
            for i in range(1, 5):  # d|d|^2 = 2 Re(conj(d) dd)
                by_w = d[i].conjugate() * e[i] - d[0].conjugate() * e[0]
                by_m = d[0].conjugate() - d[i].conjugate()
                M.append([2 * by_w.real, -2 * by_w.imag, 2 * by_m.real, -2 * by_m.imag])
            dx = solve(M, r)
            if dx is None:
                break
            far = math.sqrt(sum(t * t for t in dx))
            most = 1 + math.sqrt(sum(t * t for t in x))
            x = [a - b * min(1, most / max(far, 1e-300)) for a, b in zip(x, dx)]
            if far < 1e-13 * most:
                break
        else:
            continue
        if dx is None or max(abs(t) for t in x) > FARTHEST:
            continue
        w, m = complex(x[0], x[1]), complex(x[2], x[3])
        if all(abs(w - p) + abs(m - q) > 1e-6 * (abs(w) + abs(m)) for p, q in found):
            found.append((w, m))
    return [(w * size, m * size + centre) for w, m in found]


def is_sound(poses, left, right):
    """(lengths, branch) of a linkage without defect; None if it has one."""
    A, D = left[1], right[1]
    B, C = [[z + cmath.rect(1, angle) * x[0] for z, angle in poses] for x in (left, right)]
    lengths = [abs(D - A), abs(B[0] - A), abs(C[0] - B[0]), abs(C[0] - D)]
    if max(lengths) > 100 * min(lengths) or not turns_fully(*lengths):
        return None
    sides = [((D - b).conjugate() * (c - b)).imag for b, c in zip(B, C)]
    if min(sides) * max(sides) <= 0:
        return None
    angles = [cmath.phase((b - A) / (D - A)) for b in B]
    for way in 1, -1:
        rises = [way * (q - p) % (2 * math.pi) for p, q in zip(angles, angles[1:])]
        if sum(rises) < 2 * math.pi:
            break
    else:
        return None
    g, a, b, c = lengths
    for k in range(2001):
        f2 = abs(g - cmath.rect(a, angles[0] + way * sum(rises) * k / 2000)) ** 2
        cosine = abs(b * b + c * c - f2) / (2 * b * c)
        if cosine > math.cos(math.radians(LEAST_MU)):
            return None
    return lengths, 1 if sides[0] > 0 else -1


def found_by_command(poses):
    positions = ', '.join('(%.15g, %.15g) mm %.15g deg' % (z.real, z.imag, math.degrees(angle)) for z, angle in poses)
    deck = 'title = five poses\nmechanism = four-bar\n[synthesis]\ntask = motion\npositions = %s\n[motion]\nspeed = 60 rpm\n' % positions
    done = subprocess.run([fourlink, '--synthesis', '--format=csv', '-'], input=deck, capture_output=True, text=True)
    rows = [line.split(',') for line in done.stdout.splitlines()[1:]]
    return [([float(x) * 1000 for x in row[2:6]], 1 if row[1] == 'open' else -1, row[7]) for row in rows]


def main():
    rng = random.Random(seed)
    n_links, n_wanted, missed, worst = [0] * 7, 0, 0, 0
    for k in range(number):
        poses = draw(rng)
        all_links = links(poses, rng)
        n_links[min(len(all_links), 6)] += 1
        wanted = [is_sound(poses, p, q) for p in all_links for q in all_links if p is not q]
        wanted = [x for x in wanted if x]
        found = found_by_command(poses)
        for lengths, branch in wanted:
            n_wanted += 1
            off = min([max(abs(x - y) for x, y in zip(lengths, other)) / max(lengths) for other, side, defects in found
                       if side == branch and defects == 'none'] or [math.inf])
            if off > 1e-5:
                missed += 1
                print('task %d: %s %s is missed, by %.2g' % (k, ['%.6g' % x for x in lengths], branch, off))
            else:
                worst = max(worst, off)
    print('%d tasks of five poses, with 2, 3, 4 links: %d, %d, %d, others %d; %d linkages without defect, %d missed, lengths within %.2g' %
          (number, n_links[2], n_links[3], n_links[4], number - sum(n_links[2:5]), n_wanted, missed, worst))
    sys.exit(missed > 0)


main()
