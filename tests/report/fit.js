/* SPDX-License-Identifier: GPL-3.0-or-later
**
** fit.js SCRIPT - the scale of a drawing, for test_narrow.sh: `fit` of panel.js never reaches 0, and arrows become
** smaller before the mechanism does.  A line for each thing that is wrong.
*/
"use strict";

const fs = require("node:fs");
const fourlink = new Function(fs.readFileSync(process.argv[2], "utf8") + "\nreturn fourlink;")();

function check(what, is) {
    if (!is)
        console.log("FAILED: " + what);
}

const sound = (view) => [view.scale, view.part, ...view.origin].every(Number.isFinite) && view.scale > 0 && view.part > 0;
const bar = [[0, 0, 0, 0], [100, 0, 0, 0], [100, 40, 0, 0]];

for (const [width, height] of [[600, 400], [288, 240], [288, 128], [120, 60], [40, 30], [0, 0]]) {
    const panel = {width, height}, bare = fourlink.fit(panel, bar, 34);
    for (const [name, marks] of [["a bar", bar], ["nothing", []], ["a point", [[5, 5, 0, 0]]], ["a line", bar.slice(0, 2)],
                                 ["NaN", [[NaN, 0, 0, 0], [0, Infinity, 0, 0]]],
                                 ["an arrow at a point", [[5, 5, 80, 0]]],
                                 ["arrows", bar.concat([[0, 0, -60, -60], [100, 40, 60, 60]])],
                                 ["arrows longer than the panel", bar.concat([[0, 0, -3000, -3000], [100, 40, 3000, 3000]])],
                                 ["a tiny machine", bar.map((m) => m.map((x) => 1e-9 * x))],
                                 ["a huge machine", bar.map((m) => m.map((x) => 1e9 * x))]]) {
        const view = fourlink.fit(panel, marks, 34), where = name + " in " + width + " x " + height + ": " + JSON.stringify(view);
        check(where, sound(view));
        if (/arrows/.test(name))
            check(where + " is less than half of " + bare.scale, view.scale >= 0.499 * bare.scale && view.part <= 1);
    }
}
const wide = fourlink.fit({width: 600, height: 400}, bar.concat([[100, 40, 30, -30]]), 34);
check("short arrows keep their length: " + wide.part, wide.part === 1);
const tight = fourlink.fit({width: 288, height: 200}, bar.concat([[0, 0, -90, -90], [100, 40, 90, 90]]), 34);
check("long ones do not: " + tight.part, tight.part < 1);
const [low, high] = [0, 100].map((x) => wide.origin[0] + wide.scale * x);
check("the bar is within the panel: " + low + " to " + high, low >= 33 && high <= 567);
