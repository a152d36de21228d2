# SPDX-License-Identifier: GPL-3.0-or-later
"""scale.py FOURLINK PRINTED_ROWS DECK [PICTURE] - time over the number of rows and designs.  MOST in the environment: no more
than 10^MOST.

Each cell of the table is a process: seconds on the wall.  The same rows by printed_rows.c, by
batched.py (numpy), and positions alone by pylinkage, where it is installed; designs in one process, and in parts on all
cores by GNU parallel.  The picture is an SVG file of the same numbers.
"""
import math
import os
import subprocess
import sys
import time

fourlink, printed, deck = sys.argv[1:4]
here = os.path.dirname(os.path.abspath(__file__))
columns = ("theta2,theta3,omega3,alpha3,theta4,omega4,alpha4,mu,F12x,F12y,F23x,F23y,F34x,F34y,F14x,F14y,Ts,omega2,alpha2,"
           "power")
swept = ["--set", "sweep.output=mu_min, swing", deck]


def rows(n):
    return [fourlink, "--branch=open", "--set", "solver=dyad", "--columns=" + columns, f"--interval={360 / (n - 1)!r} deg", deck]


def designs(n, part=""):
    return [fourlink, *([part] if part else []), "--set", f"sweep.crank.length=18 mm to 22 mm in {n}", *swept]


def parts(n):
    cores = os.cpu_count()
    words = " ".join(f"'{word}'" for word in designs(n, f"--part={{}}/{cores}"))
    return ["parallel", "-k", words, ":::", *[str(i + 1) for i in range(cores)]]


pylinkage = """
import sys
from pylinkage import Crank, Ground, Linkage, RRRDyad
n = int(sys.argv[1])
A, D = Ground(0, 0), Ground(80, 0)
B = Crank(A, 20, 2 * 3.141592653589793 / n)
C = RRRDyad(B.output, D, 66, 56, 50, 50)
linkage = Linkage([A, D, B, C])
for places in linkage.step(iterations=n):
    print(*["%.6g" % x for place in places[2:] for x in place])
"""
programs = [
    ("rows", "fourlink, 20 columns", rows, 7),
    ("rows", "a C program with printf", lambda n: [printed, str(n)], 7),
    ("rows", "numpy, batched, savetxt", lambda n: [sys.executable, here + "/batched.py", str(n)], 6),
    ("rows", "pylinkage, 4 positions", lambda n: [sys.executable, "-c", pylinkage, str(n)], 5),
    ("designs", "fourlink, one process", designs, 7),
    ("designs", f"fourlink, {os.cpu_count()} parts", parts, 7),
]


def run(command):
    start = time.monotonic()
    child = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    status = child.wait()
    return time.monotonic() - start, status


def slope(points):
    """Of log time over log number, from the last two decades."""
    (n1, t1), (n2, t2) = points[-3], points[-1]
    return math.log(t2 / t1) / math.log(n2 / n1)


measured = []
for what, name, command, most in programs:
    points = []
    for exponent in range(2 if what == "designs" else 3, min(most, int(os.environ.get("MOST", most))) + 1):
        seconds, status = min(run(command(10**exponent)) for _ in range(3 if exponent < 6 else 1))
        if status:
            print("left out:", name, file=sys.stderr)
            break
        points.append((10**exponent, seconds))
    if len(points) > 2:
        measured.append((what, name, points))
for unit in ("rows", "designs"):
    of_unit = [(name, points) for what, name, points in measured if what == unit]
    most = max(points[-1][0] for _, points in of_unit)
    exponents = range(2 if unit == "designs" else 3, round(math.log10(most)) + 1)
    print(f"| seconds for so many {unit} |" + "".join(f" 10^{k} |" for k in exponents) + " slope |")
    print("|---|" + "---|" * (len(exponents) + 1))
    for name, points in of_unit:
        cells = {n: f"{seconds:.3g}" for n, seconds in points}
        print(f"| {name} |" + "".join(f" {cells.get(10**k, '')} |" for k in exponents) + f" {slope(points):.2f} |")
    print()

if len(sys.argv) > 4:
    width, height, left, bottom, decade = 720, 430, 60, 390, 62
    x = lambda n: left + (math.log10(n) - 2) * 90
    y = lambda seconds: bottom - (math.log10(seconds) + 3) * decade
    looks = ["#1b6ca8", "#b5452c", "#3a7d44", "#7a5195", "#1b6ca8", "#1b6ca8"]
    dashes = ["", "", "", "", "8 4", "2 4"]
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="13">',
           f'<rect width="{width}" height="{height}" fill="#fff"/>']
    for k in range(2, 9):
        out.append(f'<path d="M{x(10**k)} {bottom}V{y(1000)}" stroke="#ddd"/><text x="{x(10**k)}" y="{bottom + 18}" '
                   f'text-anchor="middle">10<tspan dy="-5" font-size="9">{k}</tspan></text>')
    for k in range(-3, 4):
        label = f"{10.0**k:g}" + (" s" if k == 3 else "")
        out.append(f'<path d="M{left} {y(10.0**k)}H{x(1e8)}" stroke="#ddd"/><text x="{left - 6}" y="{y(10.0**k) + 4}" '
                   f'text-anchor="end">{label}</text>')
    out.append(f'<text x="{(left + x(1e8)) / 2}" y="{height - 6}" text-anchor="middle">rows or designs</text>')
    for (what, name, points), colour, dash in zip(measured, looks, dashes):
        line = " ".join(f"{x(n):.1f},{y(max(seconds, 1e-3)):.1f}" for n, seconds in points)
        out.append(f'<polyline points="{line}" fill="none" stroke="{colour}" stroke-width="2" stroke-dasharray="{dash}"/>')
    for i, ((what, name, _), colour, dash) in enumerate(zip(measured, looks, dashes)):
        out.append(f'<path d="M{left + 10} {y(1000) + 12 + 18 * i}h34" stroke="{colour}" stroke-width="2" '
                   f'stroke-dasharray="{dash}"/><text x="{left + 50}" y="{y(1000) + 16 + 18 * i}">{what}: {name}</text>')
    out.append("</svg>\n")
    with open(sys.argv[4], "w", encoding="utf-8") as file:
        file.write("\n".join(out))
