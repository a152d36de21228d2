/* SPDX-License-Identifier: GPL-3.0-or-later
**
** draw.js - a new linkage is drawn: pivots, pins and the line of a slider by clicks or typed; the deck is written meanwhile.
**
** `put` puts a text into the editor, `done` is called at the end, with the crank angle that was drawn, in deg.
*/
web.draw = function (find, put, done) {

const {html, svg} = fourlink, {KINDS, size, minus, degrees, short, deckOf, settingsOf} = web.drawn;
const WIDE = 240, HIGH = 150, FROM = [-60, -50], GRID = 10; /* mm */

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
        return [svg("path", {d: way(at[i], at[k]), class: isNext ? "next" : "drawn", style: "stroke-width:" + (isNext ? 0.8 : 1.6)}),
                svg("text", {x: middle[0] + 2, y: middle[1] - 2, style: "font-size:5px"}, short(size(minus(at[k], at[i]))) + " mm")];
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
    const both = new RegExp("^\\(?\\s*" + number + "\\s*,\\s*" + number + "\\s*\\)?(?:\\s*mm)?$").exec(text);
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
