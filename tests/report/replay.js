/* SPDX-License-Identifier: GPL-3.0-or-later
**
** replay.js SOURCES SCENE FRAMES [slots] - whether the script of a report draws what the program drew.
**
** SOURCES is src/report, SCENE and FRAMES are from tests/web/scenes.c: the drawings as one motion, and each of them as it was before,
** an SVG.  At each step each line, disc and text of the SVG has to be in the document at the same place, and nothing else;
** keys and values beside the drawing too.  A place that is held by the frame of a body, or along a way, stays
** there; with `slots`, the deck has outputs by slots, which are longer at steps at which the block is beyond their ends.  A label is near its place; labels.js of the tests measures more.  A line for what is wrong, at
** the end how many drawings were compared and the largest distance in pixels.
*/
"use strict";

const fs = require("node:fs");
const path = require("node:path");
const {below, scriptOf, LETTER} = require("./document.js");

const [sources, sceneFile, framesFile, slots] = process.argv.slice(2);
const NEAR = 0.2, REACH = 55; /* pixels: of a label, which may stand beyond a disc or a block */
const {fourlink, Element} = scriptOf(["elements.js", "labels.js", "player.js"].map((x) => path.join(sources, x)), 0);
const scene = JSON.parse(fs.readFileSync(sceneFile, "utf8"));
const numbers = (words) => (words.match(/-?\d+(\.\d+)?(e-?\d+)?/g) || []).map(Number);
const plain = (words) => words.replace(/&lt;/g, "<").replace(/&gt;/g, ">").replace(/&quot;/g, "\"").replace(/&#39;/g, "'").replace(/&amp;/g, "&");
let compared = 0, wrong = 0, worst = 0, labels = 0, out = 0, held = 0;

function fail(where, what) {
    if (++wrong <= 5)
        console.log("FAILED: " + where + ": " + what);
}

/* An arc by its ends and its middle, in however many parts it is drawn. */
function arcOf(look, places) {
    const count = places.length / 2, at = (k) => [places[2 * k], places[2 * k + 1]];
    const [p, q] = [at(Math.floor((count - 1) / 2)), at(Math.ceil((count - 1) / 2))];
    return ["arc " + look, [...at(0), (p[0] + q[0]) / 2, (p[1] + q[1]) / 2, ...at(count - 1)]];
}

/* Pieces of a path, each [name, numbers]. */
function piecesOf(look, d, name) {
    return d.split(/(?=M)/).filter((x) => x).map((x) => !name && x.split("L").length > 8 ? arcOf(look, numbers(x)) : ["path " + look + " " + x.replace(/[-\d.e]+/g, "#").replace(/ +/g, " "), numbers(x), name]);
}

/* A path where its transform moves it: so far, turned by so many degrees. */
function moved(d, [x, y, degrees]) {
    const c = Math.cos(degrees * Math.PI / 180), s = Math.sin(degrees * Math.PI / 180);
    return x === undefined ? d : d.replace(/([-\d.e]+),([-\d.e]+)/g, (at, p, q) => (x + c * p - s * q) + "," + (y + s * p + c * q));
}

/* What an SVG of the program shows: items of the drawing, keys, values. */
function shownBy(svg) {
    const items = [], labels = [], keys = [], notes = [];
    for (const [, tag, attributes, words] of svg.matchAll(/<(path|circle|text)([^>]*?)(?:\/>|>(.*?)<\/text>)/g)) {
        const get = (name) => { const found = new RegExp("(?:^| )" + name + "=\"([^\"]*)\"").exec(attributes); return found ? found[1] : ""; };
        const name = get("data-name"), look = get("class");
        if (name === "note" || name === "key") {
            if (tag === "text")
                (name === "key" ? keys : notes).push(plain(words.replace(/<[^>]*>/g, "")));
        } else if (tag === "path") {
            items.push(...piecesOf(look, get("d"), name));
        } else if (tag === "circle") {
            items.push(["circle " + look, ["cx", "cy", "r"].map((x) => Number(get(x)))]);
        } else if (look === "halo") {
            labels.push([plain(words.replace(/<[^>]*>/g, "")), [Number(get("x")), Number(get("y"))]]);
        } else {
            items.push(["text " + look + " " + (get("text-anchor") || "start") + " " + plain(words.replace(/<[^>]*>/g, "")), [Number(get("x")), Number(get("y"))]]);
        }
    }
    return {items, labels, keys, notes};
}

/* What the document shows in a panel. */
function shownIn(panel) {
    const items = [], labels = [], [ink, texts] = panel.drawing.children;
    for (const x of [...below(ink), ...below(texts)]) {
        const look = x.getAttribute("class") || "", turn = numbers(x.getAttribute("transform") || "");
        if (x.tagName === "path")
            items.push(...piecesOf(look, moved(x.getAttribute("d"), turn), x.getAttribute("data-name")));
        else if (x.tagName === "circle")
            items.push(["circle " + look, ["cx", "cy", "r"].map((name) => Number(x.getAttribute(name)))]);
        else if (x.tagName === "text" && look === "halo")
            labels.push([x.textContent, ["x", "y"].map((name) => Number(x.getAttribute(name)))]);
        else if (x.tagName === "text")
            items.push(["text " + look + " " + x.getAttribute("text-anchor") + " " + x.textContent, ["x", "y"].map((name) => Number(x.getAttribute(name)))]);
    }
    const [, , key, list] = panel.figure.children;
    return {items, labels, keys: key.children.filter((x) => x.tagName === "span").map((x) => x.textContent),
            notes: list.children.filter((x) => !x.hidden).map((x) => x.textContent)};
}

const isFar = (p, q) => p.length !== q.length ? Infinity : p.reduce((most, x, k) => Math.max(most, Math.abs(x - q[k])), 0);

/* Each item of one list has its own in the other. */
function compare(where, wanted, found) {
    const rest = found.items.slice();
    for (const [name, at] of wanted.items) {
        let best = -1, least = Infinity;
        rest.forEach(([other, place], k) => {
            const far = other === name ? isFar(at, place) : Infinity;
            if (far < least)
                [best, least] = [k, far];
        });
        if (least > NEAR) {
            fail(where, name.slice(0, 60) + " at " + at.slice(0, 6) + (best < 0 ? " is missing" : " is at " + rest[best][1].slice(0, 6)));
        } else {
            worst = Math.max(worst, least);
            rest.splice(best, 1);
        }
    }
    rest.forEach(([name, at]) => fail(where, name.slice(0, 60) + " at " + at.slice(0, 6) + " is too much"));
    const left = wanted.labels.slice();
    for (const [name, [x, y]] of found.labels) {
        const half = LETTER * name.length / 2;
        const k = left.findIndex(([other, at]) => other === name && Math.hypot(Math.max(0, Math.abs(at[0] - x) - half), at[1] - y) < REACH);
        if (k < 0)
            fail(where, "the label " + name + " at " + x + ", " + y);
        else
            left.splice(k, 1);
    }
    labels += wanted.labels.length;
    out += left.length;
    if (wanted.notes.slice().sort().join("\n") !== found.notes.slice().sort().join("\n"))
        fail(where, "values: " + found.notes + ", not " + wanted.notes);
    const missing = wanted.keys.filter((x) => !found.keys.includes(x));
    if (missing.length)
        fail(where, "not in the key: " + missing);
}

/* Curves, which have names and stand still, are in the first step alone. */
function addCurves(list, first) {
    return first && first !== list ? {items: list.items.concat(first.items.filter((x) => x[2] && x[2] !== "scale")), labels: list.labels, keys: first.keys, notes: list.notes} : list;
}

const place = new Element("div"), drawing = fourlink.draw(scene, place);
/* Places that are said to move with a body, or along a way, and do not; those that do. */
for (const panel of scene.branches.flatMap((branch) => branch.panels))
    for (const [f, x, y] of panel.places)
        if (f && panel.frames[f - 1].length > 1) {
            held++;
            if (!slots && (typeof x === "string" || typeof y === "string"))
                fail(panel.title, "a place moves in frame " + f);
        }
const count = scene.branches.map((branch) => branch.panels.length);
const firsts = new Map();
for (const frame of fs.readFileSync(framesFile, "utf8").split(/^@ /m).slice(1)) {
    const [, number, step] = /^(\d+) (\d+)\n/.exec(frame).map(Number);
    let branch = 0, k = number;
    while (k >= count[branch])
        k -= count[branch++];
    if (drawing.branch() !== branch)
        drawing.choose(branch);
    drawing.show(step);
    const where = [path.basename(sceneFile, ".json"), scene.branches[branch].name, scene.branches[branch].panels[k].title, scene.steps[step]].join(", ");
    const wanted = shownBy(frame);
    if (step === 0)
        firsts.set(number, wanted);
    compare(where, addCurves(wanted, firsts.get(number)), shownIn(drawing.panels[k]));
    compared++;
}
console.log(compared + " drawings, " + wrong + " wrong, " + labels + " labels, " + worst.toFixed(3) + " pixels at most, " + out + " left out, " + held + " places in frames");
