/* SPDX-License-Identifier: GPL-3.0-or-later
**
** pins.js - for drive.js: pins by their places on a page are dragged, and points that a linkage passes.
**
** The places of two other knobs, in the deck and on the screen, tell where a place of the page is on the screen.
*/
"use strict";

const fs = require("node:fs");
const path = require("node:path");

const rows = "\n[motion]\nspeed = 60 rpm\ninterval = 10 deg\n";
const point = "\n[point P]\nlink = LINK\nplace = (40, 50) mm\n";
const load = "\n[load F]\nlink = LINK\nplace = (35, 20) mm\nforce = (-20, 0) N\n";

const decks = {
    "drawn four-bar": {
        text: "title = drawn four-bar\nmechanism = four-bar\n\n[pins]\nA = (10, 20) mm\nB = (25, 42) mm\nC = (75, 60) mm\nD = (90, 10) mm\n" +
            (point + load).replace(/LINK/g, "coupler") + rows,
        knobs: ["A", "B", "C", "D", "point P place", "load F place"]},
    "drawn slider-crank": {
        text: "title = drawn slider-crank\nmechanism = slider-crank\n\n[pins]\nA = (-20, 5) mm\nB = (-5, 35) mm\nC = (80, 62) mm\n" +
            "guide = (10, 40) mm, (150, 84) mm\n" + point.replace("LINK", "rod") + rows,
        knobs: ["A", "B", "point P place"]},
    "drawn lever, axes of the ground": {
        text: "title = drawn lever\nmechanism = inverted-slider-crank\naxes = ground\n\n[pins]\nA = (10, 20) mm\nB = (-2, 45) mm\n" +
            "C = (30, 70) mm\nD = (60, -20) mm\n" + rows.replace("interval", "from = 20 deg\ninterval"),
        knobs: ["A", "B", "D"]},
    "drawn yoke": {
        text: "title = drawn yoke\nmechanism = scotch-yoke\n\n[pins]\nA = (3, 4) mm\nB = (20, 30) mm\nguide = (0, 10) mm, (60, 30) mm\n" + rows,
        knobs: ["A", "B", "guide 1", "guide 2"]},
    "in inches": {
        text: "title = in inches\nmechanism = four-bar\n\n[units]\nlength = in\n\n[pins]\nA = (0, 0)\nB = (1, 2)\nC = (60, 80) mm\n" +
            "D = 4 in at -20 deg\n" + rows,
        knobs: ["B", "C"]}
};

module.exports = function ({check, command, value, text, click, settled, put, middle, drag, changes, messages, browser}) {
    /* Where knobs are, [x, y] in pixels, by name. */
    async function knobs(names) {
        const places = {};
        for (const name of names) {
            await browser().until(`document.querySelector('[data-knob="${name}"]')`, "a ring for " + name);
            places[name] = await middle(`[data-knob="${name}"] .ring`);
        }
        return places;
    }
    /* The place that a deck gives, in mm. */
    function placeOf(deck, name) {
        const [section, key] = / place$/.test(name) ? [name.replace(" place", ""), "place"] : ["pins", name.replace(/ .*/, "")];
        const line = new RegExp("\\[" + section + "\\][^[]*?\\n" + key + " = (.*)").exec(deck)[1];
        const all = [...line.matchAll(/\(([-.\d]+), ([-.\d]+)\)/g)], found = all[/2$/.test(name) ? 1 : 0];
        const inches = !/ mm/.test(line);
        return [1, 2].map((k) => Number(found[k]) * (inches ? 25.4 : 1));
    }
    const far = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1]);

    async function tryOne(name, {text: deck, knobs: names}) {
        await put("drawn.deck", deck);
        for (const knob of names) {
            const at = await knobs(names), [p, q] = names.filter((x) => x !== knob);
            const other = [placeOf(deck, p), q ? placeOf(deck, q) : placeOf(deck, knob)];
            const scale = far(at[p], at[q || knob]) / far(...other);
            const onScreen = ([x, y]) => [at[p][0] + scale * (x - other[0][0]), at[p][1] - scale * (y - other[0][1])];
            check(name + ", " + knob + " is where the deck has it", far(at[knob], onScreen(placeOf(deck, knob))) < 0.5);
            await browser().evaluate(`document.getElementById("fourlink-angle").focus()`);
            await browser().key("End"); /* the crank is elsewhere: what is dragged shows it as drawn */
            const to = [at[knob][0] + 6, at[knob][1] - 4];
            await browser().mouse("mousePressed", ...at[knob]);
            await browser().mouse("mouseMoved", at[knob][0] + 3, at[knob][1] - 2);
            await settled();
            await browser().mouse("mouseMoved", ...to);
            await settled();
            const held = await knobs(names);
            for (const x of names)
                check(name + ": while " + knob + " is held, " + x + " is at " + held[x] + ", not " + (x === knob ? to : at[x]),
                      far(held[x], x === knob ? to : at[x]) < 1.5);
            await browser().mouse("mouseReleased", ...to);
            await settled();
            const now = await value("deck"), made = changes(deck, now);
            check(name + ", " + knob + ": one line changes: " + JSON.stringify(made), made && made.length === 1);
            check(name + ", " + knob + ": " + placeOf(now, knob) + " is where the pointer is", far(onScreen(placeOf(now, knob)), to) < 1.5);
            check(name + ", " + knob + " has no mistake: " + await messages(), !(await messages()).some((x) => /error/.test(x)));
            const shown = await browser().evaluate(`document.querySelector(".panel.whole svg").getAttribute("aria-label")`);
            if (/^[A-D]$/.test(knob)) {
                const B = await middle(`.panel.whole circle[data-name="B"]`), ring = (await knobs(["B"])).B;
                check(name + ", " + knob + ": it is drawn where the deck has B, " + shown, far(B, ring) < 1);
            }
            await click("undo");
            await settled();
            check(name + ", " + knob + ": one step of undo", await value("deck") === deck);
        }
    }

    async function tryPins() {
        await click("change");
        for (const [name, what] of Object.entries(decks))
            await tryOne(name, what);
        /* With the lengths given, they are what a pin changes. */
        const rough = "title = rough\nmechanism = four-bar\n\n[pins]\nrough = yes\nA = (0, 0) mm\nB = (10, 20) mm\nC = (60, 70) mm\nD = (80, 0) mm\n\n" +
            "[ground]\nlength = 80 mm\n\n[crank]\nlength = 22 mm\n\n[coupler]\nlength = 70 mm\n\n[rocker]\nlength = 75 mm\n" + rows;
        await put("rough.deck", rough);
        const {B} = await knobs(["B"]);
        await drag(B, [B[0] + 10, B[1] - 15]);
        const made = changes(rough, await value("deck"));
        check("a rough drawing keeps its pins: " + JSON.stringify(made), made && made.length === 1 && /^length = 22/.test(made[0][0]));
        await click("change");
    }
    /* The linkage goes with its points: it is alike while one of ten is pulled by a little, and when it is let go. */
    async function tryPath() {
        const curve = command("curve.deck", "mechanism = four-bar\n[ground]\nlength = 60 mm\n[crank]\nlength = 25 mm\n[coupler]\nlength = 70 mm\n" +
            "[rocker]\nlength = 55 mm\n[point P]\nlink = coupler\nat = (35, 40) mm\n[motion]\nspeed = 60 rpm\nto = 270 deg\ninterval = 30 deg\n",
            "--branch=open", "--columns=P.x,P.y", "--format=csv").out.trim().split(/\r?\n/).slice(1).map((row) => row.split(",").slice(1, 3).map(Number));
        const points = curve.map(([x, y]) => "(" + (1000 * x).toFixed(2) + ", " + (1000 * y).toFixed(2) + ") mm").join(", ");
        await click("change");
        await put("path.deck", "title = path\nmechanism = four-bar\n\n[synthesis]\ntask = path\npositions = " + points +
                  "\ntiming = " + Array.from({length: 9}, (_, k) => 30 * (k + 1) + " deg").join(", ") + "\n" + rows);
        const shape = async () => {
            const [A, D, P, Q] = [await middle(`.panel.whole circle[data-name="A"]`), await middle(`.panel.whole circle[data-name="D"]`),
                                  ...Object.values(await knobs(["wanted 1", "wanted 8"]))];
            return [far(A, D) / far(P, Q), far(A, P) / far(P, Q)];
        };
        const before = await shape(), deck = await value("deck"), {"wanted 3": at} = await knobs(["wanted 3"]);
        const isAlike = (now) => now.every((x, k) => Math.abs(x - before[k]) < 0.05 * before[k]);
        await browser().mouse("mousePressed", ...at);
        for (let k = 1; k <= 4; k++) {
            await browser().mouse("mouseMoved", at[0] + k, at[1]);
            await settled();
            check("the linkage goes with its points: " + await shape() + ", before " + before, isAlike(await shape()));
        }
        await browser().mouse("mouseReleased", at[0] + 4, at[1]);
        await settled();
        check("it is found again: " + await shape(), isAlike(await shape()));
        const made = changes(deck, await value("deck"));
        check("the third point moves: " + JSON.stringify(made), made && made.length === 1 &&
              made[0][1].split("(").filter((x, i) => x !== made[0][0].split("(")[i]).length === 1);
        await click("change");
    }
    return [["pins", tryPins], ["path", tryPath]];
};
