/* SPDX-License-Identifier: GPL-3.0-or-later
**
** text.js - numbers in the text of a deck: where they stand, and other numbers in their places.
**
** The program reads the deck; here only those plain numbers are found that can be changed by dragging.
*/
"use strict";

const web = {};

web.text = (function () {

const NUMBER = "[-+\u2212]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][-+]?\\d+)?";
const scalar = new RegExp("^(" + NUMBER + ")(?!\\s*[*/\u03c0\\d.]|\\s*pi\\b)(.*)$", "i");
const pair = new RegExp("^(\\(\\s*)(" + NUMBER + ")(\\s*,\\s*)(" + NUMBER + ")(\\s*\\))(.*)$");

/* A line less its comment, which begins at the start or after a blank. */
function bare(line) {
    const comment = line.search(/(^|\s)[#;]/);
    return comment < 0 ? line : line.slice(0, comment);
}

/* Other names of links, as the program reads them. */
const links = {slider: "piston", boom: "crank", hatch: "crank", tailgate: "crank", tower: "crank", body: "crank", cylinder: "lever"};

const linkMeant = (name) => links[name.toLowerCase()] || name.toLowerCase();

/* Where the value of a key stands, {from, to}; null if the section does not have it. */
function find(text, section, key) {
    const wanted = section.toLowerCase().replace(/\s+/g, " ").trim();
    let at = 0, now = "";
    for (const line of text.split("\n")) {
        const words = bare(line), head = /^\s*\[([^\]]*)\]/.exec(words);
        const setting = /^(\s*([^=\s]+)\s*=\s*)(.*?)\s*$/.exec(words);
        if (head)
            now = head[1].toLowerCase().replace(/\s+/g, " ").trim();
        else if ((now === wanted || links[now] === wanted) && setting && setting[2].toLowerCase() === key.toLowerCase() && setting[3])
            return {from: at + setting[1].length, to: at + setting[1].length + setting[3].length};
        at += line.length + 1;
    }
    return null;
}

/* The numbers of a value: [{name, from, to, unit}], of a length "r", of a point "x" and "y", or "r" and "angle".
** `unit` is what follows the number; "1" before it is a quantity.  "mid" and "40 %" are a "share" of the link's length.
** Null if it has another form. */
function numbers(text, section, key) {
    const place = find(text, section, key);
    if (!place)
        return null;
    const value = text.slice(place.from, place.to), both = pair.exec(value), share = /^(?:mid|([-+]?[\d.]+)\s*%)$/.exec(value);
    if (share)
        return [{name: "share", ...place, unit: "", value: share[1] === undefined ? 50 : Number(share[1])}];
    if (both) {
        const x = place.from + both[1].length, y = x + both[2].length + both[3].length;
        return [{name: "x", from: x, to: x + both[2].length, unit: both[6]},
                {name: "y", from: y, to: y + both[4].length, unit: both[6]}];
    }
    const parts = /^(.*?)(\s+at\s+)(.*)$/.exec(value), radius = scalar.exec(parts ? parts[1] : value);
    const angle = parts && scalar.exec(parts[3]);
    if (!radius || (parts && !angle))
        return null;
    const list = [{name: "r", from: place.from, to: place.from + radius[1].length, unit: radius[2]}];
    if (angle) {
        const from = place.from + parts[1].length + parts[2].length;
        list.push({name: "angle", from, to: from + angle[1].length, unit: angle[2]});
    }
    return list;
}

/* The value of a key in words; null if there is none. */
function value(text, section, key) {
    const place = find(text, section, key);
    return place && text.slice(place.from, place.to);
}

/* The title of a deck; "" without one. */
function titleOf(text) {
    const found = /^\s*title\s*=\s*"?(.*?)"?\s*$/m.exec(text);
    return found ? found[1].replace(/\s[#;].*/, "") : "";
}

/* The names of the sections that a text has, such as "load F". */
const sections = (text) => text.split("\n").map((line) => /^\s*\[([^\]]*)\]/.exec(bare(line))).filter((x) => x).map((x) => x[1].trim());

/* The points of a value, "(1, 2) mm ... (3, 4) mm": [[{name, from, to, unit}, ...], ...]. */
function pairs(text, section, key) {
    const place = find(text, section, key);
    if (!place)
        return [];
    const one = new RegExp("(\\(\\s*)(" + NUMBER + ")(\\s*,\\s*)(" + NUMBER + ")\\s*\\)(\\s*[a-zA-Z]*)", "g");
    return [...text.slice(place.from, place.to).matchAll(one)].map((found) => {
        const x = place.from + found.index + found[1].length, y = x + found[2].length + found[3].length;
        return [{name: "x", from: x, to: x + found[2].length, unit: found[5]},
                {name: "y", from: y, to: y + found[4].length, unit: found[5]}];
    });
}

const read = (text, number) => number.name === "share" ? number.value : Number(text.slice(number.from, number.to).replace("\u2212", "-"));

/* A number rounded to 1, 10, 0.1 ... of which `step` is the eye's share. */
function rounded(value, step) {
    const exponent = Math.max(-12, Math.min(12, Math.floor(Math.log10(step) + 1e-9))), power = Math.pow(10, Math.abs(exponent));
    const near = exponent < 0 ? Math.round(value * power) / power : Math.round(value / power) * power;
    return String(Number((near + 0).toFixed(Math.max(0, -exponent))));
}

/* Put texts in the places of numbers: [[number, text], ...]. */
function replace(text, changes) {
    for (const [number, words] of changes.slice().sort((p, q) => q[0].from - p[0].from))
        text = text.slice(0, number.from) + words + text.slice(number.to);
    return text;
}

return {bare, linkMeant, find, value, titleOf, numbers, pairs, sections, read, rounded, replace};
}());
