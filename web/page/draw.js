/* SPDX-License-Identifier: GPL-3.0-or-later
**
** draw.js - a new linkage is drawn: pivots, pins and the line of a slider by clicks or typed; the deck is written meanwhile.
**
** `put` puts a text into the editor, `done` is called at the end, with the crank angle that was drawn, in deg.
*/
web.draw = function (find, put, done) {

const {html, svg} = fourlink;
const WIDE = 240, HIGH = 150, FROM = [-60, -50], GRID = 10; /* mm */
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

/* ------------------------------------------------------------------------------------------------ the deck */

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

/* ------------------------------------------------------------------------------------------------ the board */

const board = find("board"), words = html("label", {for: "board-words"}), typed = html("input", {id: "board-words", autocomplete: "off"});
const cancel = html("button", {type: "button"}, "Cancel");
const grid = svg("g", {class: "grid"}), drawn = svg("g", {}), sheet = svg("svg", {class: "fourlink", viewBox: [0, 0, WIDE, HIGH].join(" "), role: "img", "aria-label": "Board to draw on"},
                                                                      grid, drawn);
let kind = null, points = [], pointer = null;

const toSheet = (p) => [p[0] - FROM[0], HIGH - (p[1] - FROM[1])];
const ofSheet = ([x, y]) => [Math.round(x + FROM[0]), Math.round(HIGH - y + FROM[1])];
const way = (p, q) => "M" + toSheet(p) + "L" + toSheet(q);

for (let x = 0; x <= WIDE; x += GRID)
    grid.append(svg("path", {d: "M" + x + ",0v" + HIGH}));
for (let y = 0; y <= HIGH; y += GRID)
    grid.append(svg("path", {d: "M0," + y + "h" + WIDE}));
board.append(html("p", {class: "tools"}, words, typed, cancel), sheet);

function show() {
    const {lines, points: names} = KINDS[kind], at = [...points, ...(pointer && points.length ? [pointer] : [])];
    const parts = lines.filter(([i, k]) => at[i] && at[k]).map(([i, k]) => {
        const isNext = k >= points.length, middle = toSheet([(at[i][0] + at[k][0]) / 2, (at[i][1] + at[k][1]) / 2]);
        return [svg("path", {d: way(at[i], at[k]), class: isNext ? "next" : "drawn", "stroke-width": 1, style: "stroke-width:" + (isNext ? 0.8 : 1.6)}),
                svg("text", {x: middle[0] + 2, y: middle[1] - 2, "font-size": 5, style: "font-size:5px"}, short(size(minus(at[k], at[i]))) + " mm")];
    });
    drawn.replaceChildren(...parts.flat(), ...points.map((p) => svg("circle", {cx: toSheet(p)[0], cy: toSheet(p)[1], r: 2, style: "stroke-width:0.7"})));
    words.textContent = "Click " + names[points.length] + ", or type";
    typed.placeholder = points.length ? "40 at 60 deg, or 40, or (30, 20)" : "(0, 0)";
}

function place(p) {
    if (points.length && size(minus(p, points[points.length - 1])) === 0)
        return;
    points.push(p);
    typed.value = "";
    put(deckOf(kind, points));
    if (points.length < KINDS[kind].points.length)
        return show();
    const {axis} = settingsOf(kind, points), turn = degrees(minus(points[1], points[0])) - axis;
    end();
    done((turn % 360 + 360) % 360);
}

function end() {
    board.hidden = true;
    find("fourlink-panels").hidden = false;
    kind = null;
}

/* A point that was typed: (x, y), or a length from the last point, at an angle or towards the pointer; null if it is none. */
function read(text) {
    const number = "(-?[\\d.]+)\\s*(?:mm|deg|°)?", last = points[points.length - 1];
    const both = new RegExp("^\\(?\\s*" + number + "\\s*,\\s*" + number + "\\s*\\)?$").exec(text);
    const polar = new RegExp("^" + number + "(?:\\s+at\\s+" + number + ")?$").exec(text);
    if (both)
        return [Number(both[1]), Number(both[2])];
    if (!polar || !last)
        return null;
    const towards = pointer && size(minus(pointer, last)) > 0 ? degrees(minus(pointer, last)) : 0;
    const angle = (polar[2] === undefined ? towards : Number(polar[2])) * Math.PI / 180;
    return [last[0] + Number(polar[1]) * Math.cos(angle), last[1] + Number(polar[1]) * Math.sin(angle)];
}

sheet.addEventListener("pointermove", (event) => {
    pointer = ofSheet(fourlink.placeOf(event, sheet));
    show();
});
sheet.addEventListener("pointerdown", (event) => {
    event.preventDefault();
    place(ofSheet(fourlink.placeOf(event, sheet)));
});
typed.addEventListener("keydown", (event) => {
    const p = event.key === "Enter" && read(typed.value.trim());
    if (event.key === "Escape")
        return cancel.click();
    if (event.key !== "Enter")
        return;
    event.preventDefault();
    typed.setAttribute("aria-invalid", String(!p));
    if (p)
        place(p);
});
cancel.addEventListener("click", end);

find("draw").append(...Object.entries(KINDS).map(([value, {words}]) => html("option", {value}, words)));
find("draw").addEventListener("change", () => {
    kind = find("draw").value || null;
    find("draw").value = "";
    if (!kind)
        return;
    points = [];
    pointer = null;
    board.hidden = false;
    find("fourlink-panels").hidden = true;
    show();
    typed.focus();
    board.scrollIntoView({block: "nearest"});
});
};

/* ------------------------------------------------------------------------------------------------ what is added */

/* A deck with a point, a load or masses more; they are dragged or edited then. */
web.added = (function () {

const freeName = (text, kind, names) => names.find((name) => !web.text.sections(text).includes(kind + " " + name)) || names[0] + Date.now() % 1000;
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

return {
    point(text) {
        const link = linkOf(text, "coupler", "rod"), half = web.text.rounded(lengthOf(text, link) / 2, lengthOf(text, link) / 50);
        return append(text, ["[point " + freeName(text, "point", ["P", "Q", "R", "S", "T", "U"]) + "]", "link = " + link,
                             "at   = (" + half + ", " + half + ")" + unitOf(text, link)]);
    },
    load(text) {
        const link = linkOf(text, "rocker", "rod", "coupler");
        return append(text, ["[load " + freeName(text, "load", ["F", "F2", "F3", "F4", "F5"]) + "]", "link  = " + link,
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
}());
