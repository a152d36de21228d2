/* SPDX-License-Identifier: GPL-3.0-or-later
**
** drawn.js FOURLINK ROOT [COUNT [SEED]] - random linkages as they are drawn on the page: the command computes their decks, and
** has pins B and C, the slide or the yoke where they were drawn.
*/
"use strict";

const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");
const {spawnSync} = require("node:child_process");

const [fourlink, root] = process.argv.slice(2, 4).map((x) => path.resolve(x)), count = Number(process.argv[4] || 4000);
let state = Number(process.argv[5] || 1), tried = 0, failed = 0, worst = 0, where = "", skipped = 0;
const work = fs.mkdtempSync(path.join(os.tmpdir(), "fourlink-drawn-"));
const read = (name) => fs.readFileSync(path.join(root, "web/page", name), "utf8");
const drawn = new Function(read("text.js") + read("drawn.js") + "return web.drawn;")();

function random(low, high) { /* Park and Miller's generator */
    state = state * 48271 % 2147483647;
    return low + (high - low) * state / 2147483647;
}
const point = () => [Math.round(random(-60, 180)), Math.round(random(-50, 100))];
const size = ([x, y]) => Math.hypot(x, y), minus = (p, q) => [p[0] - q[0], p[1] - q[1]];

/* The values of columns at an angle, by name; null if there is no position. */
function valuesAt(file, branch, angle, columns) {
    const made = spawnSync(fourlink, ["--branch=" + branch, "--at=" + angle + " deg", "--columns=" + columns.join(), "--format=csv", "--units=mm", file], {encoding: "utf8"});
    const [head, row] = made.stdout.trim().split("\n");
    if (made.status > 1 || !row)
        throw new Error(made.stderr + fs.readFileSync(file, "utf8"));
    const cells = row.split(","), names = head.split(",").map((x) => x.replace(/ .*/, ""));
    return row.endsWith(",ok") ? Object.fromEntries(names.map((x, k) => [x, Number(cells[k])])) : null;
}

/* Where a place is from A, in axes that are turned. */
function seen(p, A, axis) {
    const [x, y] = minus(p, A), c = Math.cos(axis * Math.PI / 180), s = Math.sin(axis * Math.PI / 180);
    return [c * x + s * y, c * y - s * x];
}

const file = path.join(work, "x.deck");
for (let k = 0; k < count; k++) {
    const kind = Object.keys(drawn.KINDS)[k % 4], points = drawn.KINDS[kind].points.map(point), [A, B, C, D] = points;
    if (points.some((p, i) => points.some((q, j) => j > i && size(minus(p, q)) < 5))) {
        skipped++;
        continue;
    }
    const {axis, branch} = drawn.settingsOf(kind, points), turn = drawn.degrees(minus(B, A)) - axis;
    fs.writeFileSync(file, drawn.deckOf(kind, points));
    const wanted = {}, put = (name, p) => [wanted[name + ".x"], wanted[name + ".y"]] = seen(p, A, axis);
    put("B", B);
    let room = 0.02; /* lengths are rounded to 0.01 mm; near a dead position pins move much for that */
    if (kind === "four-bar" || kind === "slider-crank") {
        const u = kind === "four-bar" ? minus(D, C) : [Math.sin(axis * Math.PI / 180), -Math.cos(axis * Math.PI / 180)];
        const v = minus(C, B), sine = Math.abs(kind === "four-bar" ? (u[0] * v[1] - u[1] * v[0]) / size(u) / size(v) : (u[0] * -v[1] + u[1] * v[0]) / size(v));
        const level = kind === "four-bar" ? drawn.degrees(minus(D, A)) : drawn.degrees(minus(D, C));
        if (sine < 0.15 || Math.abs(level - axis) > 1e-9 && Math.abs(Math.abs(level - axis) - 360) > 1e-9) {
            skipped++; /* near a dead position, or drawn nearly level and made so */
            continue;
        }
        room /= sine * sine;
        put("C", C);
    } else if (kind === "inverted-slider-crank") {
        if (Math.abs(drawn.degrees(minus(C, A)) - axis) > 1e-9 || size(minus(B, C)) < 5) {
            skipped++;
            continue;
        }
        wanted.theta4 = drawn.degrees(minus(B, C)) - axis;
    } else {
        put("C", [B[0], C[1]]);
        wanted.slide = B[1] - C[1];
    }
    const found = valuesAt(file, branch, ((turn % 360) + 360) % 360, Object.keys(wanted));
    tried++;
    for (const name in wanted) {
        let off = found ? Math.abs(found[name] - wanted[name]) : Infinity;
        if (name === "theta4")
            off = Math.min(off % 360, 360 - off % 360) * size(minus(B, C)) * Math.PI / 180;
        if (!(off <= room)) {
            failed++;
            console.log("FAILED: " + kind + " " + JSON.stringify(points) + ", " + name + ": " + (found && found[name]) + ", not " + wanted[name] + "\n" + fs.readFileSync(file, "utf8"));
        }
        if (off / room > worst)
            [worst, where] = [off / room, kind + " " + JSON.stringify(points) + " " + name];
    }
}
fs.rmSync(work, {recursive: true});
console.log(tried + " linkages as drawn (" + skipped + " left out: dead or nearly level), worst " + worst.toFixed(3) + " of what rounding to 0.01 mm allows, " + where);
console.log((tried - failed) + " passed, " + failed + " failed");
process.exitCode = failed || tried < count / 2 ? 1 : 0;
