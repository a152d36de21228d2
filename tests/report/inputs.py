# SPDX-License-Identifier: GPL-3.0-or-later
#
# inputs.py FOURLINK CHECK_SAMPLE DECK... - the sample calculation where another coordinate than the crank angle is prescribed, or
# another link driven.
#
# Of each deck without outputs a few rows are taken, and each coordinate is prescribed as it is there, with its speed and acceleration.
# The equations of the new report are evaluated from their printed numbers by CHECK_SAMPLE; the crank's angle, speed and acceleration in
# them are those of the row, the power of what drives is that of the torque on the crank, and the flywheel's numbers are the facts.
import csv
import io
import math
import os
import re
import subprocess
import sys
import tempfile

COORDINATES = {"theta4": ("theta4", "omega4", "alpha4"), "x": ("x", "v", "a"), "slide": ("slide", "slide_v", "slide_a"),
               "C.x": ("C.x", "C.vx", "C.ax")}
ANGLES = (37, 151, 262)
TAKEN = ("from", "to", "interval", "time_step", "rows", "speed", "acceleration", "start_speed", "input", "at", "side", "drive",
         "program", "program_of", "law", "cycle", "hold", "mode")

fourlink, check_sample, *decks = sys.argv[1:]
prescribed = driven = flywheels = equations = wrong = 0


def run(*words):
    return subprocess.run([fourlink, *words], capture_output=True, text=True, encoding="utf-8", errors="replace")


def row(deck, branch, columns, units="--units=SI"):
    """The values of a row, by default in SI units with angles in degrees, or None."""
    done = run(*[units] * bool(units), "-f", "csv", "-b", branch, "-c", ",".join(columns), deck)
    lines = list(csv.reader(io.StringIO(done.stdout)))
    if len(lines) != 2 or lines[1][-1] != "ok":
        return None
    try:
        return [float(x) for x in lines[1][1:-1]]
    except ValueError:
        return None


def check(deck, branch, what, values):
    """Check the report of a deck, whose sample has these results; True if it has a sample."""
    global equations, wrong
    if run("--report=r.html", "-b", branch, deck).returncode > 1 or not os.path.exists("r.html"):
        return False
    with open("r.html", encoding="utf-8") as page:
        text = page.read()
    if 'id="equation-' not in text or any(re.search("<(mi|mtext)>" + x + "</", text) is None for x in what):
        return False
    done = subprocess.run([check_sample, "r.html", *values], capture_output=True, text=True)
    equations += text.count('id="equation-')
    if done.returncode:
        wrong += 1
        print(deck, branch, what, values, done.stdout[:500], sep="\n")
    return True


def without_motion(text):
    """The deck without its rows, motor and expected values."""
    kept, section = [], ""
    for line in text.splitlines():
        begins = re.match(r"\s*\[(\w+)", line)
        if begins:
            section = begins[1]
        if section in ("expect", "misprint", "table", "motor", "flywheel", "grading", "sweep"):
            continue
        key = re.match(r"\s*(\w+)\s*=", line)
        if section == "motion" and (begins or key and key[1] in TAKEN):
            continue
        kept.append(line)
    return "\n".join(kept) + "\n"


for deck in decks:
    name = os.path.abspath(deck)
    with open(deck, encoding="utf-8", errors="replace") as file:
        text = file.read()
    if re.search(r"^\s*(\[output|\[synthesis|\[pins|unit|axes)", text, re.M) or "\\\n" in text:
        continue
    with tempfile.TemporaryDirectory() as work:
        os.chdir(work)
        base = without_motion(text)
        for branch in ("open", "crossed"):
            if run("-S", name).returncode <= 1 and check(name, branch, ["ΔE"], []):
                flywheels += 1
            for angle in ANGLES:
                with open("crank.deck", "w", encoding="utf-8") as file:
                    file.write(base + "[motion]\nat = %d deg\nspeed = 4 rad/s\nacceleration = -3 rad/s2\nhold = yes\n" % angle)
                for q, columns in COORDINATES.items():
                    found = row("crank.deck", branch, columns)
                    if found is None or abs(found[1]) < 1e-3:
                        continue
                    value, speed, acceleration = found
                    u, v = ("deg", "rad/s") if q == "theta4" else ("m", "m/s")
                    with open("input.deck", "w", encoding="utf-8") as file:
                        file.write(base + "[motion]\ninput = %s\nat = %.17g %s\nspeed = %.17g %s\nacceleration = %.17g %s2\nside = %s\n" %
                                   (q, value, u, speed, v, acceleration, v, "rising" if speed > 0 else "falling"))
                    turned = row("input.deck", branch, ("theta2", "omega2", "alpha2"))
                    if turned is None or abs(math.remainder(turned[0] - angle, 360)) > 1e-6:
                        continue
                    wanted = ["omega2=%.17g" % turned[1], "alpha2=%.17g" % turned[2]]
                    power = row("input.deck", branch, ["power"], "")
                    wanted += ["Pdrive=%.17g" % power[0]] * bool(power)
                    if check("input.deck", branch, ["K"], wanted):
                        prescribed += 1
                        with open("r.html", encoding="utf-8") as page:
                            driven += "<h3>What drives</h3>" in page.read()

print(f"{prescribed} prescribed, {driven} driven, {flywheels} flywheels, {equations} equations, wrong: {wrong}")
sys.exit(not (prescribed and driven and flywheels) or wrong > 0)
