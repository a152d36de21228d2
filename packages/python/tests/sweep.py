# SPDX-License-Identifier: GPL-3.0-or-later
"""sweep.py [DESIGNS] - max(Ts) of so many cranks (100,000), by the package and by the command, in one run."""
import os
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

import fourlink

TOP = Path(__file__).resolve().parents[3]
DECK = TOP / "data" / "me3491-matrix.deck"
n = int(sys.argv[1]) if len(sys.argv) > 1 else 100_000

start = time.perf_counter()
r = fourlink.open(DECK)
own = np.empty(n)
for i, length in enumerate(np.linspace(18, 22, n)):
    r.set("crank.length", length)
    own[i] = r["max(Ts)"]
by_package = time.perf_counter() - start

start = time.perf_counter()
done = subprocess.run([os.environ.get("FOURLINK", str(TOP / "build" / "fourlink")), "-f", "csv", "-b", "open",
                       "-s", f"sweep.crank.length=18 mm to 22 mm in {n}", "-s", "sweep.output=max(Ts)", str(DECK)],
                      capture_output=True, text=True, check=True)
by_command = time.perf_counter() - start
printed = np.array([float(line.split(",")[3]) for line in done.stdout.splitlines()[1:]])
print(f"{n} designs: package {by_package:.2f} s, command {by_command:.2f} s, ratio {by_package / by_command:.2f}; "
      f"largest difference {np.max(np.abs(own - printed)):.1e} N.m")
