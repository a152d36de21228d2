/* SPDX-License-Identifier: GPL-3.0-or-later
**
** labels.js FOURLINK WIDTHS EVERY DECK... - the labels of the moving drawings of reports, measured in Chromium.
**
** Each report is opened in windows of these widths, in pixels, with a comma between them; at every so many of its steps the labels
** of all drawings are compared with what else is there, as the document has it.  A line of a table for each width:
**
**    labels    on how many labels and steps
**    overlaps  labels with another text on them
**    lines     labels with a line, an arrow, an arc or a disc on them
**    curves    labels with the path of a point on them
**    clipped   labels that are not wholly in the sheet
**    far       labels farther from their place than two widths of an arrow: from a pin's disc, from the outline of a pin's block
**    left out  labels that are not shown
**    jumps     labels whose side is more than 45 degrees from that at the step before, against the arrow if it is the name of one
**    never     labels of forces and letters of pins that are shown at no step of a branch
**    ms        of all drawings of a step, at most and on average
**
** Exit status 1: there are some where there should be none.
*/
"use strict";

const {spawnSync} = require("node:child_process");
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");
const {open} = require("../web/browser.js");

const [fourlink, widths, every, ...decks] = process.argv.slice(2);

/* This function is run in the page. */
function measure(every) {
    const PER_PIXEL = 40, PER_RADIAN = 20000, HALF_WIDE = 0.32, HEAD = 0.025, LEAST_HEAD = 14, ROUNDING = 0.1;
    const SIGNS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789!#$%'*+,-./:;=?@[]^_`{|}~ ";
    const data = JSON.parse(document.getElementById("fourlink-rows").textContent);
    const drawing = fourlink.draw(data, document.getElementById("fourlink-panels"), document.getElementById("fourlink-more"));
    const sum = {labels: 0, overlaps: 0, lines: 0, curves: 0, clipped: 0, far: 0, out: 0, jumps: 0, never: 0, steps: 0, ms: 0, most: 0, examples: []};
    const widthsOf = new Map(), strokes = new Map();

    /* A series: differences of second order, of one to three signs or (number) each; or a number that stays. */
    function series(words, parts) {
        const list = [], at = (k) => SIGNS.indexOf(words[k]);
        if (typeof words === "number")
            return () => words;
        for (let k = 0; k < words.length; k++) {
            const n = list.length, sign = at(k);
            let d = sign - 30;
            if (sign < 0) {
                d = parseInt(words.slice(k + 1), 10);
                k = words.indexOf(")", k);
            } else if (sign >= 80) {
                d = (sign - 84) * 7744 + at(k + 1) * 88 + at(k + 2);
                k += 2;
            } else if (sign >= 62) {
                d = (sign - 71) * 88 + at(k + 1);
                k++;
            }
            list.push(n ? d + 2 * list[n - 1] - list[Math.max(0, n - 2)] : d);
        }
        return (i) => list[i] / parts;
    }
    /* Where the places of a panel are at a step, through the frames that hold them. */
    function placesOf(panel) {
        const places = panel.places.map(([f, x, y]) => [f, series(x, PER_PIXEL), series(y, PER_PIXEL)]);
        const turns = panel.frames.map((x) => x[1] === -1 && series(x[2], PER_RADIAN));
        return (i) => {
            const placeAt = (k) => {
                const [f, x, y] = places[k];
                if (!f)
                    return [x(i), y(i)];
                const [p, q, way] = panel.frames[f - 1], from = placeAt(p), to = q >= 0 ? placeAt(q) : null;
                const u = to ? [to[0] - from[0], to[1] - from[1]] : turns[f - 1] ? [Math.cos(turns[f - 1](i)), Math.sin(turns[f - 1](i))] : [1, 0];
                const l = Math.hypot(...u) || 1, s = to && way ? x(i) : x(i) / l, t = y(i) / l;
                return [from[0] + s * u[0] - t * u[1], from[1] + s * u[1] + t * u[0]];
            };
            return places.map((x, k) => placeAt(k));
        };
    }
    /* The ink of a text: letters stand on the line, what is below or above it has its own size. */
    function boxOf(text) {
        const words = text.textContent, key = words + getComputedStyle(text).fontSize, size = parseFloat(getComputedStyle(text).fontSize);
        if (!widthsOf.has(key)) {
            const shifts = [...text.querySelectorAll("tspan.script")].map((x) => Number(x.getAttribute("dy")));
            widthsOf.set(key, {half: text.getBBox().width / 2, up: shifts.some((x) => x < 0) ? 6 + 0.55 * size : 0.74 * size,
                               down: shifts.some((x) => x > 0) ? 4.5 : /[gjpqy,;()\u2080-\u209c]/.test(words) ? 3 : 0.5});
        }
        const {half, up, down} = widthsOf.get(key), x = Number(text.getAttribute("x")), y = Number(text.getAttribute("y"));
        const middle = {start: x + half, end: x - half}[text.getAttribute("text-anchor")] || x;
        return {left: middle - half, right: middle + half, top: y - up, bottom: y + down, x: middle, y: y - 0.37 * size};
    }
    function strokeOf(element) {
        const look = element.getAttribute("class");
        if (!strokes.has(look))
            strokes.set(look, getComputedStyle(element).stroke === "none" ? 0 : parseFloat(getComputedStyle(element).strokeWidth) / 2);
        return strokes.get(look);
    }
    /* Lines and discs of a sheet, in its pixels. */
    function inkOf(group) {
        const [dx, dy, scale] = group.getAttribute("transform").match(/-?[\d.]+(e-?\d+)?/g).map(Number), lines = [], discs = [];
        for (const x of group.children) {
            if (x.getAttribute("display") === "none" || x.getAttribute("class") === "solid")
                continue;
            if (x.tagName === "circle") {
                discs.push({x: scale * x.getAttribute("cx") + dx, y: scale * x.getAttribute("cy") + dy, r: scale * x.getAttribute("r")});
                continue;
            }
            const [tx, ty, degrees] = (x.getAttribute("transform") || "0 0 0").match(/-?[\d.]+(e-?\d+)?/g).map(Number);
            const c = Math.cos(degrees * Math.PI / 180), s = Math.sin(degrees * Math.PI / 180);
            const d = x.getAttribute("d"), half = strokeOf(x), isCurve = /^path of/.test(x.getAttribute("data-name") || "");
            for (const piece of d.split(/(?=M)/)) {
                const at = [...piece.matchAll(/(-?[\d.]+(?:e-?\d+)?),(-?[\d.]+(?:e-?\d+)?)/g)].map(([, p, q]) => [scale * (tx + c * p - s * q) + dx, scale * (ty + s * p + c * q) + dy]);
                if (/z/.test(piece))
                    at.push(at[0]);
                for (let k = 1; k < at.length; k++)
                    if (at[k].join() !== at[k - 1].join()) /* of no length: nothing is drawn */
                        lines.push({from: at[k - 1], to: at[k], half, isCurve, isHead: /z/.test(piece)});
            }
        }
        return {lines, discs, scale, dx, dy};
    }
    /* Whether a line comes nearer than half its width to a box, by cutting it to the box. */
    function crosses({from, to, half}, b) {
        let low = 0, high = 1;
        for (const [p, q, least, most] of [[from[0], to[0], b.left - half, b.right + half], [from[1], to[1], b.top - half, b.bottom + half]]) {
            if (p === q) {
                if (p <= least + ROUNDING || p >= most - ROUNDING)
                    return false;
                continue;
            }
            const s = (least + ROUNDING - p) / (q - p), t = (most - ROUNDING - p) / (q - p);
            low = Math.max(low, Math.min(s, t));
            high = Math.min(high, Math.max(s, t));
        }
        return low < high;
    }
    const wordsOf = (item) => item.words.map((x) => [].concat(x)[0]).join("");
    const apart = (x, y, b) => Math.hypot(Math.max(b.left - x, 0, x - b.right), Math.max(b.top - y, 0, y - b.bottom));
    const laysOn = (a, b) => a.left < b.right - ROUNDING && b.left < a.right - ROUNDING && a.top < b.bottom - ROUNDING && b.top < a.bottom - ROUNDING;
    const isGone = (item, i) => item.gone !== undefined && item.gone.filter((step) => step <= i).length % 2 === 1;
    const isMiddle = (p, a, b) => Math.hypot(p[0] - (a[0] + b[0]) / 2, p[1] - (a[1] + b[1]) / 2) < 0.5;
    const turnOfWay = (a, b) => Math.atan2(b[1] - a[1], b[0] - a[0]);
    const turnOf = (a, b) => Math.abs(Math.atan2(Math.sin(a - b), Math.cos(a - b))) * 180 / Math.PI;

    for (let k = 0; k < data.branches.length; k++) {
        drawing.choose(k);
        const seen = data.branches[k].panels.map((panel) => ({places: placesOf(panel), before: new Map(), shown: new Map()}));
        for (let i = 0; i < data.steps.length; i += every) {
            const began = performance.now();
            drawing.show(i);
            const took = performance.now() - began;
            sum.steps++;
            sum.ms += took;
            sum.most = Math.max(sum.most, took);
            data.branches[k].panels.forEach((panel, n) => {
                const sheet = drawing.panels[n].drawing, [group, texts] = sheet.children, ink = inkOf(group), places = seen[n].places(i);
                const [, , width, height] = sheet.getAttribute("viewBox").split(" ").map(Number);
                const items = panel.items.filter((x) => x.as === "text" || x.as === "label"), boxes = [];
                const most = 2 * 2 * HALF_WIDE * Math.max(HEAD * panel.sheet[2] * ink.scale, LEAST_HEAD) + ROUNDING;
                items.forEach((item, j) => {
                    const made = texts.children[j];
                    if (isGone(item, i))
                        return;
                    const isLabel = item.as === "label" || item.name !== "scale", isShown = made.getAttribute("display") !== "none";
                    const arrow = panel.items.find((x) => x.as === "arrow" && x.at[1] === item.at[0] && !isGone(x, i));
                    const pin = panel.items.find((x) => x.as === "disc" && x.at[0] === item.at[0]);
                    const key = j, isWanted = isLabel && (/^F/.test(item.words[0]) && arrow || pin && /^[A-Z]$/.test(item.words[0]));
                    if (isWanted)
                        seen[n].shown.set(key, seen[n].shown.get(key) || isShown);
                    if (isLabel)
                        sum.labels++;
                    if (isLabel && !isShown)
                        sum.out++;
                    if (isShown)
                        boxes.push({item, key, isLabel, arrow, pin, ...boxOf(made)});
                    else
                        seen[n].before.delete(key);
                });
                for (const b of boxes.filter((x) => x.isLabel)) {
                    const [x, y] = places[b.item.at[0]].map((z, c) => ink.scale * z + [ink.dx, ink.dy][c]), found = [];
                    const radius = ink.scale * Math.max(b.item.size || 0, b.pin && b.pin.size || 0);
                    if (boxes.some((o) => o !== b && laysOn(o, b)))
                        found.push("overlaps");
                    if (ink.lines.some((o) => !o.isCurve && crosses(o, b)) || ink.discs.some((o) => apart(o.x, o.y, b) < o.r - ROUNDING))
                        found.push("lines");
                    if (ink.lines.some((o) => o.isCurve && crosses(o, b)))
                        found.push("curves");
                    if (b.left < 0 || b.top < 0 || b.right > width || b.bottom > height)
                        found.push("clipped");
                    if (apart(x, y, b) - radius > most)
                        found.push("far");
                    const tip = places[b.item.at[0]], arrow = b.arrow || panel.items.find((o) => o.as === "arrow" && !isGone(o, i) && isMiddle(tip, places[o.at[0]], places[o.at[1]]));
                    const side = Math.atan2(b.y - y, b.x - x) - (arrow ? turnOfWay(places[arrow.at[0]], places[arrow.at[1]]) : 0);
                    if (seen[n].before.has(b.key) && turnOf(side, seen[n].before.get(b.key)) > 45)
                        found.push("jumps");
                    seen[n].before.set(b.key, side);
                    for (const what of found) {
                        sum[what]++;
                        if (what !== "jumps" && what !== "curves" && sum.examples.filter((z) => z.startsWith(what)).length < 3)
                            sum.examples.push(what + ": " + wordsOf(b.item) + " in " + panel.title + " at " + data.steps[i] + ", " + data.branches[k].name);
                    }
                }
            });
        }
        seen.forEach(({shown}, n) => shown.forEach((isShown, key) => {
            if (!isShown) {
                const item = data.branches[k].panels[n].items.filter((x) => x.as === "text" || x.as === "label")[key];
                sum.never++;
                sum.examples.push("never: " + wordsOf(item) + " in " + data.branches[k].panels[n].title + ", " + data.branches[k].name);
            }
        }));
    }
    return sum;
}

const COLUMNS = ["labels", "overlaps", "lines", "curves", "clipped", "far", "out", "jumps", "never"];
const NONE = ["overlaps", "lines", "clipped", "far", "never"];

async function main() {
    const work = fs.mkdtempSync(path.join(os.tmpdir(), "fourlink-labels-")), browser = await open();
    let status = 0;
    console.log(["  px", ...COLUMNS.map((x) => x.padStart(9)), "ms, most".padStart(9), "mean".padStart(6)].join(" "));
    for (const width of widths.split(",")) {
        const all = Object.fromEntries([...COLUMNS, "steps", "ms", "most"].map((x) => [x, 0])), examples = [];
        await browser.size(Number(width), 900);
        for (const deck of decks) {
            const file = path.join(work, path.basename(deck, ".deck") + ".html");
            spawnSync(fourlink, ["--report=" + file, deck], {stdio: "ignore"}); /* it may lack rows */
            await browser.evaluate("window.old = true");
            await browser.go("file://" + file);
            await browser.until("!window.old && document.readyState === 'complete'", deck);
            if (!await browser.evaluate("Boolean(document.getElementById('fourlink-rows'))"))
                continue;
            const sum = await browser.evaluate("(" + measure + ")(" + every + ")");
            for (const name in all)
                all[name] = name === "most" ? Math.max(all.most, sum.most) : all[name] + sum[name];
            if (process.env.EACH)
                console.log(path.basename(deck, ".deck").padEnd(30), COLUMNS.map((x) => String(sum[x]).padStart(7)).join(""), sum.most.toFixed(1), (sum.ms / sum.steps).toFixed(1));
            examples.push(...sum.examples.map((x) => path.basename(deck, ".deck") + ", " + width + " px, " + x));
        }
        console.log([width.padStart(4), ...COLUMNS.map((x) => String(all[x]).padStart(9)), all.most.toFixed(1).padStart(9), (all.ms / all.steps).toFixed(1).padStart(6)].join(" "));
        if (all.labels)
            console.log("   % " + COLUMNS.map((x) => (100 * all[x] / all.labels).toFixed(2).padStart(9)).join(" "));
        if (NONE.some((x) => all[x]) || !all.labels) {
            status = 1;
            console.log(examples.slice(0, 40).join("\n"));
        }
    }
    for (const problem of browser.problems) {
        console.log("the browser: " + problem);
        status = 1;
    }
    await browser.close();
    fs.rmSync(work, {recursive: true});
    process.exitCode = status;
}

main();
