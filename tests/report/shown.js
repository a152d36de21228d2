/* SPDX-License-Identifier: GPL-3.0-or-later
**
** shown.js SOURCES SCENE TABLE - what stands beside the drawings of a report, and where a pointer is in them.
**
** SOURCES is src/report, SCENE a file from tests/web/scenes.c, TABLE the table of one branch that the command printed with
** --wide.  At each step that is a row of the table the cells beside the drawing have its numbers, their names and units
** in words; the caption tells the crank angle.  Points of the sheet and of the mechanism's plane go to and fro, the pins are where they
** are drawn, and of a pointer the row is the one whose crank points to it.  A line for what is wrong.
*/
"use strict";

const fs = require("node:fs");
const path = require("node:path");
const {scriptOf} = require("./document.js");

const [sources, sceneFile, tableFile] = process.argv.slice(2);
const {fourlink, Element} = scriptOf(["elements.js", "labels.js", "player.js"].map((x) => path.join(sources, x)), 600);
const scene = JSON.parse(fs.readFileSync(sceneFile, "utf8")), lines = fs.readFileSync(tableFile, "utf8").split("\n");
let compared = 0, wrong = 0;

function that(holds, ...what) {
    compared++;
    if (!holds && ++wrong <= 5)
        console.log("FAILED: " + path.basename(sceneFile) + ": " + what.join(" "));
}
const near = (p, q, size) => Math.hypot(p[0] - q[0], p[1] - q[1]) < size;
/* As a number, and half a unit of its last digit. */
const valueOf = (words) => {
    const [, digits, power] = /^-?\d+\.?(\d*)(?:e([-+]?\d+))?$/.exec(words) || [null, "", ""];
    return [Number(words), 0.5001 * Math.pow(10, Number(power || 0) - digits.length)];
};
const isSame = (x, y) => x === y || Math.abs(valueOf(x)[0] - valueOf(y)[0]) <= Math.max(valueOf(x)[1], valueOf(y)[1]);
const plain = (words) => words.replace(/−/g, "-").replace(/[\u00a0°]/g, " ").trim();

function* all(element) {
    for (const child of element.children) {
        yield child;
        yield* all(child);
    }
}

const place = new Element("div"), drawing = fourlink.draw(scene, place), branch = scene.branches[0];
const names = lines.find((x) => /^# theta2 /.test(x)).slice(2).trim().split(/\s+/);
const rows = lines.filter((x) => /^ *-?[0-9]/.test(x)).map((x) => x.trim().split(/\s+/));
const cells = new Map([...all(place)].filter((x) => x.getAttribute("data-column")).map((x) => [x.getAttribute("data-column"), x]));

that(rows.length > 0 && cells.size === names.length, cells.size, "cells,", names.length, "columns,", rows.length, "rows");
for (const row of rows) {
    const step = scene.steps.indexOf(Number(row[0]));
    if (step < 0)
        continue;
    drawing.show(step);
    names.forEach((name, k) => {
        const words = plain(cells.get(name).textContent).split(" ")[0];
        that(isSame(words, row[k]), name, "at", row[0], "is", words, "not", row[k]);
    });
    const caption = drawing.panels[0].caption.textContent;
    that(plain(caption).includes("θ₂ = " + Number(row[0])) && (scene.branches.length === 1 || caption.includes(branch.name)), caption);
    /* the crank, and a place beyond it, at which a pointer holds it */
    const [A, B] = [drawing.main.place("A"), drawing.main.place("B")];
    for (const reach of [0.5, 1, 2]) {
        const found = drawing.main.rowAt([A[0] + reach * (B[0] - A[0]), A[1] + reach * (B[1] - A[1])]), away = Math.abs(found - step);
        that(Math.min(away, scene.steps.length - 1 - away) <= 1, "the row of a pointer", found, "not", step);
    }
    const a = drawing.main.planeOf(A), b = drawing.main.planeOf(B), angle = Math.atan2(b[1] - a[1], b[0] - a[0]) * 180 / Math.PI;
    const rounded = 0.1 / Math.hypot(B[0] - A[0], B[1] - A[1]) * 180 / Math.PI; /* pixels, as places follow others */
    that(Math.abs((angle - Number(row[0]) + 36180) % 360 - 180) < Math.max(0.05, rounded), "the crank in its plane is at", angle, "not", row[0]);
    that(Math.hypot(...a) < 0.02 * Math.hypot(b[0] - a[0], b[1] - a[1]), "A in its plane is at", a);
    for (const p of [[0, 0], b, [3 * b[0], -2 * b[1]], [-b[1], 5 * b[0]]])
        that(near(drawing.main.planeOf(drawing.main.sheetOf(p)), p, 1e-9 * Math.hypot(...b)), "to and fro", p);
    that(near(drawing.main.sheetOf(b), B, 1e-6), "B in the sheet");
}
/* a machine that stands at an angle is turned back to its own axes */
const straight = drawing.main.planeOf(drawing.main.place("B"));
for (const turn of [0.7, -2]) {
    const before = scene.turn;
    scene.turn = before + turn;
    const turned = drawing.main.planeOf(drawing.main.place("B"));
    const back = [Math.cos(turn) * turned[0] - Math.sin(turn) * turned[1], Math.sin(turn) * turned[0] + Math.cos(turn) * turned[1]];
    that(near(back, straight, 1e-9 * Math.hypot(...straight)), "turned by", turn, turned, "not", straight);
    that(near(drawing.main.planeOf(drawing.main.sheetOf([3, -8])), [3, -8], 1e-6), "to and fro when turned");
    scene.turn = before;
}
/* what words are made of numbers and units */
for (const [column, value, words] of [[{form: "fixed", decimals: 3}, -0.0004, "0.000"], [{form: "fixed", decimals: 1}, -2.25, "-2.3"], [{form: "fixed", decimals: 0}, 7, "7"],
    [{form: "exponent", decimals: 2}, 12345, "1.23e+4"], [{form: "angle", decimals: 0}, 12.5, "12.5"], [{form: "fixed", decimals: 2}, null, "–"], [{form: "fixed", decimals: 2}, "inf", "inf"]])
    that(fourlink.cellText(column, value) === words, "cell", value, fourlink.cellText(column, value));
for (const [unit, words] of [["m/s2", "m/s²"], ["kg.m2", "kg·m²"], ["deg", "°"], ["1", ""], ["mm", "mm"], ["in3", "in³"]])
    that(fourlink.unitText(unit) === words, "unit", unit);
that(fourlink.withUnit("3", "mm") === "3\u00a0mm" && fourlink.withUnit("3", "deg") === "3°" && fourlink.withUnit("3", "1") === "3", "numbers with units");
for (const [label, variable, words] of [[["θ", "2", ""], "i", ["sub"]], [["time_ratio", "", ""], "span", ["wbr"]], [["a", "B", "n"], "i", ["sub", "sup"]], [["μ", "", ""], "i", []]]) {
    const made = fourlink.htmlLabel(label), tags = [...all(made)].map((x) => x.tagName).filter((x) => x !== "#text");
    that(tags[0] === variable && tags.slice(1).join() === words.join() && made.textContent === label.join(""), "label", label, tags, made.textContent);
}
/* other numbers: of the same mechanism they are taken, of another they are not */
const other = JSON.parse(JSON.stringify(scene));
that(drawing.update(other) && drawing.updateBriefly(other, 0) && drawing.update(other), "the same again");
const renamed = JSON.parse(JSON.stringify(scene));
renamed.branches[0].panels[0].title += "!";
that(!drawing.update(renamed) && !drawing.updateBriefly(renamed, 0), "another drawing");
const longer = JSON.parse(JSON.stringify(scene));
longer.columns[1].unit = "furlong";
that(!drawing.update(longer) && !drawing.updateBriefly(longer), "other units");
console.log(compared + " compared, " + wrong + " wrong");
