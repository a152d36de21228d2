/* SPDX-License-Identifier: GPL-3.0-or-later
**
** drawn.js - the deck of a linkage that was drawn, and decks to which something is added.
*/
web.drawn = (function () {

const LEVEL = 3; /* deg; a line that is so nearly level is meant to be */

const A = "pin A, the pivot of the crank", B = "pin B, the end of the crank";
/* What is clicked for each mechanism, and the lines between, as pairs of points. */
const KINDS = {
    "four-bar": {words: "four-bar linkage", points: [A, B, "pin C, the end of the coupler", "pin D, the pivot of the rocker"],
                 lines: [[0, 1], [1, 2], [2, 3]]},
    "slider-crank": {words: "slider-crank", points: [A, B, "pin C, on the piston", "another point of the line of stroke"],
                     lines: [[0, 1], [1, 2], [2, 3]]},
    "inverted-slider-crank": {words: "slotted lever", points: [A, B, "pin D, the pivot of the lever"], lines: [[0, 1], [1, 2]]},
    "scotch-yoke": {words: "Scotch yoke", points: [A, B, "a point of the guide, which is level"], lines: [[0, 1], [1, 2]]}
};

const minus = (p, q) => [p[0] - q[0], p[1] - q[1]], size = (p) => Math.hypot(p[0], p[1]);
const cross = (p, q) => p[0] * q[1] - p[1] * q[0], dot = (p, q) => p[0] * q[0] + p[1] * q[1];
const degrees = (p) => Math.atan2(p[1], p[0]) * 180 / Math.PI;
const short = (x) => String(Number(x.toFixed(2)) + 0);
const level = (angle) => Math.abs(angle) < LEVEL ? 0 : Math.abs(Math.abs(angle) - 180) < LEVEL ? 180 : angle;

/* Sections of a kind for the points so far: [[section, key, value], ...], the angle of its x axis, and its branch. */
function settingsOf(kind, [A, B, C, D]) {
    const list = [], put = (section, key, value) => list.push([section, key, value]);
    const length = (section, p, q) => p && q && put(section, "length", short(size(minus(q, p))));
    let axis = 0, branch = "open";
    if (kind === "four-bar") {
        axis = D ? level(degrees(minus(D, A))) : 0;
        length("ground", A, D);
        branch = D && cross(minus(D, B), minus(C, B)) < 0 ? "crossed" : "open";
    } else if (kind === "slider-crank" && D) {
        axis = level(degrees(minus(D, C)));
        const u = [Math.cos(axis * Math.PI / 180), Math.sin(axis * Math.PI / 180)];
        put("ground", "offset", short(cross(u, minus(C, A))));
        branch = dot(u, minus(C, B)) < 0 ? "crossed" : "open";
    } else if (kind === "inverted-slider-crank") {
        axis = C ? level(degrees(minus(C, A))) : 0;
        length("ground", A, C);
    } else if (kind === "scotch-yoke" && C) {
        put("ground", "offset", short(C[1] - A[1]));
    }
    if (axis)
        put("ground", "angle", short(axis) + " deg");
    length("crank", A, B);
    if (kind === "four-bar" || kind === "slider-crank")
        length(kind === "four-bar" ? "coupler" : "rod", B, C);
    if (kind === "four-bar")
        length("rocker", D, C);
    return {list, axis, branch};
}

function deckOf(kind, points) {
    const {list, branch} = settingsOf(kind, points), lines = ["title     = My " + KINDS[kind].words, "mechanism = " + kind, "", "[units]", "length = mm"];
    let now = "";
    for (const [section, key, value] of list) {
        if (section !== now)
            lines.push("", "[" + section + "]");
        now = section;
        lines.push(key + " = " + value);
    }
    if (points.length === KINDS[kind].points.length)
        lines.push(...(branch === "crossed" ? ["", "[table]", "branch = crossed"] : []), "", "[motion]", "speed    = 60 rpm", "interval = 5 deg");
    return lines.join("\n") + "\n";
}

/* ------------------------------------------------------------------------------------------------ what is added */

/* A name that no section of the kind has: F, F2, F3 ... */
function freeName(text, kind, name) {
    const taken = web.text.sections(text);
    let n = 1;
    while (taken.includes(kind + " " + name + (n > 1 ? n : "")))
        n++;
    return name + (n > 1 ? n : "");
}
const lengthOf = (text, section) => {
    const numbers = web.text.numbers(text, section, "length");
    return numbers ? web.text.read(text, numbers[0]) : 0;
};
const unitOf = (text, section) => {
    const numbers = web.text.numbers(text, section, "length");
    return numbers && numbers[0].unit.trim() ? " " + numbers[0].unit.trim() : "";
};
const append = (text, lines) => text.replace(/\n*$/, "\n\n") + lines.join("\n") + "\n";

/* The first of these sections that has a length: the link on which it is seen best. */
const linkOf = (text, ...names) => names.find((name) => lengthOf(text, name) > 0) || "crank";

/* A deck with a point, a load or masses more; they are dragged or edited then. */
const added = {
    point(text) {
        const link = linkOf(text, "coupler", "rod"), half = web.text.rounded(lengthOf(text, link) / 2, lengthOf(text, link) / 50);
        return append(text, ["[point " + freeName(text, "point", "P") + "]", "link = " + link,
                             "at   = (" + half + ", " + half + ")" + unitOf(text, link)]);
    },
    load(text) {
        const link = linkOf(text, "rocker", "rod", "coupler");
        return append(text, ["[load " + freeName(text, "load", "F") + "]", "link  = " + link,
                             "at    = " + web.text.rounded(lengthOf(text, link) / 2, lengthOf(text, link) / 50) + unitOf(text, link), "force = (-20, 0) N"]);
    },
    masses(text) {
        const lines = text.split("\n"), made = [];
        let section = "";
        for (const line of lines) {
            const head = /^\s*\[([^\]]*)\]/.exec(line);
            made.push(line);
            section = head ? head[1].trim().toLowerCase() : section;
            if (/^(crank|coupler|rocker|rod)$/.test(section) && /^\s*length\s*=/.test(line) && !web.text.find(text, section, "mass"))
                made.push("mass    = 1 kg", "uniform = yes");
        }
        return made.join("\n");
    }
};

return {KINDS, minus, size, degrees, short, settingsOf, deckOf, added};
}());
