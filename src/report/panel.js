/* SPDX-License-Identifier: GPL-3.0-or-later
**
** panel.js - what the drawings of a report are made with: texts, vectors, and panels with lines, arrows, labels.
**
** A panel is SVG, in pixels, with y downwards.  `data` is the JSON of the program's rows, `i` the number of a row.
*/
"use strict";

const fourlink = (function () {

/* ------------------------------------------------------------------------------------------ elements, texts */

function element(space, name, attributes, children) {
    const made = document.createElementNS(space, name);
    for (const key in attributes)
        if (attributes[key] !== null)
            made.setAttribute(key, attributes[key]);
    made.append(...(children || []));
    return made;
}

function html(name, attributes, ...children) {
    return element("http://www.w3.org/1999/xhtml", name, attributes, children);
}

function svg(name, attributes, ...children) {
    return element("http://www.w3.org/2000/svg", name, attributes, children);
}

/* A unit as it is written by hand: m/s2 becomes m/s². */
function unitText(unit) {
    return unit === "1" ? "" : unit === "deg" ? "°" : unit.replace(/2/g, "²").replace(/3/g, "³").replace(/\./g, "·");
}

/* A number, already in words, with its unit. */
function withUnit(words, unit) {
    const shown = unitText(unit);
    return words + (shown && shown !== "°" ? "\u00a0" : "") + shown;
}

/* Digits as superscripts. */
function raised(text) {
    return text.replace(/\d/g, (digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit]).replace("-", "⁻");
}

/* A number with so many significant digits; very large or small ones with a prefix or with a power of ten. */
function quantityText(value, unit, precision) {
    const prefixes = ["n", "µ", "m", "", "k", "M", "G"];
    if (typeof value !== "number")
        return "–";
    let exponent = value === 0 ? 0 : Math.floor(Math.log10(Math.abs(value)) + 1e-9), end = "", shown = value;
    if (exponent < -3 || exponent >= 5) {
        const step = Math.floor(exponent / 3) + 3;
        if (["N", "N.m", "m", "m/s", "m/s2"].includes(unit) && prefixes[step] !== undefined) {
            shown = value / Math.pow(1000, step - 3);
            unit = prefixes[step] + unit;
        } else {
            shown = value / Math.pow(10, exponent);
            end = "×10" + raised(String(exponent));
        }
    }
    const digits = shown === 0 ? 1 : Math.floor(Math.log10(Math.abs(shown)) + 1e-9) + 1;
    const text = precision && value !== 0 ? shown.toFixed(Math.max(0, precision - digits)) : String(Number(shown.toPrecision(6)));
    return withUnit(text.replace("-", "−") + end, unit).replace("\u00a0", " ");
}

/* Step i of the motion, in the deck's unit: its crank angle, or its time if the deck has rows by time. */
function stepText(data, i) {
    const text = String(Number(data.steps[i].toPrecision(6))).replace("-", "−"), unit = data.units[data.over === "time" ? "time" : "angle"];
    return withUnit(text, unit).replace("\u00a0", " ");
}

/* A number as the program's table writes it. */
function cellText(column, value) {
    if (typeof value !== "number")
        return value === null ? "–" : value;
    const text = column.form === "angle" ? String(value) : column.form === "exponent"
        ? value.toExponential(column.decimals) : value.toFixed(column.decimals);
    return text.replace(/^-(?=[0.]+$)/, "");
}

/* Save words as a file. */
function save(file, type, words) {
    const address = URL.createObjectURL(new Blob([words], {type}));
    html("a", {href: address, download: file}).click();
    setTimeout(() => URL.revokeObjectURL(address), 1000);
}

/* Where a pointer is in a drawing, in its pixels. */
function placeOf(event, sheet) {
    const box = sheet.getBoundingClientRect(), view = sheet.viewBox.baseVal;
    return [(event.clientX - box.left) * view.width / box.width, (event.clientY - box.top) * view.height / box.height];
}

/* Let a drawing have all that a pointer does until it is up. */
function hold(event, sheet) {
    event.preventDefault();
    try {
        sheet.setPointerCapture(event.pointerId);
    } catch (error) { /* a pointer that is already gone */ }
}

/* A label is [name, subscript, superscript].  A short name of the program's own is a variable, in italics. */
function isVariable(label) {
    return label[1] !== "" || label[0].length === 1;
}

function htmlLabel(label) {
    const parts = label[0].split(/(?<=_)/).flatMap((part, k) => k ? [html("wbr"), part] : [part]); /* lines may end there */
    const made = html("span", {}, html(isVariable(label) ? "i" : "span", {}, ...parts));
    if (label[1])
        made.append(html("sub", {}, label[1]));
    if (label[2])
        made.append(html("sup", {}, label[2]));
    return made;
}

function svgLabel(label, kind) {
    const made = svg("text", {class: kind || null},
                     svg("tspan", {class: isVariable(label) && !kind ? "variable" : null}, label[0]));
    if (label[1])
        made.append(svg("tspan", {dy: 4, class: "small"}, label[1]));
    if (label[2]) /* a prime is high already */
        made.append(svg("tspan", {dy: (label[1] ? -4 : 0) - (label[2] === "′" ? 0 : 6), class: "small"}, label[2]));
    return made;
}

/* --------------------------------------------------------------------------------------------------- vectors */

const add = (p, q) => [p[0] + q[0], p[1] + q[1]];
const minus = (p, q) => [p[0] - q[0], p[1] - q[1]];
const times = (k, p) => [k * p[0], k * p[1]];
const size = (p) => Math.hypot(p[0], p[1]);
const middle = (p, q) => times(0.5, add(p, q));

/* The unit vector of p; of a vector of length 0, `otherwise`. */
function direction(p, otherwise) {
    return size(p) > 0 ? times(1 / size(p), p) : otherwise || [0, -1];
}

/* 1, 2 or 5 times a power of ten, at most x. */
function roundDown(x) {
    const power = Math.pow(10, Math.floor(Math.log10(x) + 1e-9));
    return power * (x / power >= 5 ? 5 : x / power >= 2 ? 2 : 1);
}

/* The convex hull of points. */
function hull(points) {
    const sorted = points.slice().sort((p, q) => p[0] - q[0] || p[1] - q[1]);
    const turns = (p, q, r) => (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    const chain = (list) => list.reduce((kept, p) => {
        while (kept.length > 1 && turns(kept[kept.length - 2], kept[kept.length - 1], p) <= 0)
            kept.pop();
        return kept.concat([p]);
    }, []);
    return chain(sorted).slice(0, -1).concat(chain(sorted.reverse()).slice(0, -1));
}

/* The tracks of a branch. */
function tracksOf(data, branch) {
    const pick = (values, i) => Array.isArray(values) ? values[i] : values;
    const c = Math.cos(data.turn), s = Math.sin(data.turn);

    /* Null where the row has no such number, a vector in the page's directions, turned as the machine stands. */
    function number(name, i) {
        const track = branch.tracks[name];
        const value = track ? pick(track[0], i) : null;
        return typeof value === "number" ? value : null;
    }
    const turned = (x, y) => [c * x - s * y, -s * x - c * y];
    function vector(name, i) {
        const track = branch.tracks[name];
        const x = track ? pick(track[0], i) : null, y = track ? pick(track[1], i) : null;
        return typeof x === "number" && typeof y === "number" ? turned(x, y) : null;
    }
    return {number, vector, turned, reason: (i) => branch.reasons[i] || "", count: data.steps.length,
            largest: branch.largest, x: [c, -s]};
}

/* ---------------------------------------------------------------------------------------------------- panels */

/* A panel is a figure with one drawing, a caption and a list of values, which stay while the drawing changes. */
function makePanel(title, kind) {
    const drawing = svg("svg", {class: "sheet", role: "img"});
    const list = html("ul", {class: "values"}), caption = html("span", {}, title);
    const figure = html("figure", {class: "panel " + kind}, drawing,
                        html("figcaption", {}, caption), list);
    return {figure, drawing, caption, list, title, ink: svg("g", {}), boxes: [], dots: [], labels: [], kept: new Map(),
            width: 0, height: 0};
}

/* Begin a drawing: empty, in the pixels that the page gives it. */
function begin(panel, name) {
    panel.boxes = []; /* of texts */
    panel.dots = [];  /* on lines: texts keep away from them */
    panel.labels = []; /* to be placed */
    panel.ink.replaceChildren();
    panel.drawing.setAttribute("aria-label", panel.title + ": " + name);
}

function measure(panel) {
    panel.width = panel.drawing.clientWidth || 600;
    panel.height = panel.drawing.clientHeight || 400;
    panel.drawing.setAttribute("viewBox", "0 0 " + panel.width + " " + panel.height);
    if (!panel.ink.parentNode)
        panel.drawing.append(panel.ink);
}

const digits = (x) => Math.round(x * 1000) / 1000;
const pairs = (points) => points.map((p) => digits(p[0]) + "," + digits(p[1])).join(" ");

function line(panel, kind, ...points) {
    panel.ink.append(svg("polyline", {class: kind, points: pairs(points)}));
    for (let j = 1; j < points.length; j++)
        for (let way = 0, v = minus(points[j], points[j - 1]); way < size(v) && way < 2000; way += 7)
            panel.dots.push(add(points[j - 1], times(way / size(v), v)));
}

function area(panel, kind, points) {
    panel.ink.append(svg("polygon", {class: kind, points: pairs(points)}));
}

function circle(panel, kind, at, radius, name) {
    panel.ink.append(svg("circle", {class: kind, cx: digits(at[0]), cy: digits(at[1]), r: radius,
                                    "data-name": name || null}));
}

/* A head at `to`, in the direction u. */
function head(panel, kind, to, u) {
    const side = [-u[1], u[0]], root = minus(to, times(11, u));
    area(panel, kind + " head", [to, add(root, times(4, side)), minus(root, times(4, side))]);
}

/* A vector as an arrow; without a head if it is shorter than one. */
function arrow(panel, kind, from, v) {
    const length = size(v), u = direction(v);
    if (length < 1)
        return;
    line(panel, kind, from, length > 12 ? add(from, times(length - 8, u)) : add(from, v));
    if (length > 12)
        head(panel, kind, add(from, v), u);
}

/* A torque as an arc around a point with a head, counter-clockwise for value > 0. */
function torque(panel, kind, at, value, radius) {
    const points = [];
    const sign = value > 0 ? -1 : 1;
    for (let k = 0; k <= 24; k++) {
        const angle = Math.PI / 2 + sign * (0.25 + k / 24 * 1.3) * Math.PI;
        points.push(add(at, [radius * Math.cos(angle), radius * Math.sin(angle)]));
    }
    panel.boxes.push([at[0] - radius, at[1] - radius, at[0] + radius, at[1] + radius]);
    line(panel, kind, ...points);
    head(panel, kind, points[24], direction(minus(points[24], points[22])));
}

/* A label beside a place: in the direction d, or around it where it covers nothing; `end` places all. */
function text(panel, at, d, label, gap, kind) {
    panel.labels.push({at, u: direction(d, [0.7, -0.7]), label, gap: gap || 6, kind});
}

const TURNS = [0, 45, -45, 90, -90, 135, -135, 180, 22, -22, 67, -67, 112, -112];
const FAR = [0, 14, 24, 38, 54];
const NEAR = 20; /* a label farther away has a line to its place */

const overlap = (a, b) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];

/* The places that a label may have, with what is against each: lines crossed, the edge, the distance. */
function candidates(panel, item) {
    const {label, at, u, gap} = item, list = [];
    const half = [(label[0].length * 8.2 + (label[1] + label[2]).length * 7) / 2 + 1, 9];
    const reach = [gap + FAR[4] + 2 * half[0], gap + FAR[4] + 2 * half[1]];
    const dots = panel.dots.filter((p) => Math.abs(p[0] - at[0]) < reach[0] && Math.abs(p[1] - at[1]) < reach[1]);
    for (const turn of TURNS)
        for (const far of FAR) {
            const c = Math.cos(turn * Math.PI / 180), s = Math.sin(turn * Math.PI / 180);
            const v = [c * u[0] - s * u[1], s * u[0] + c * u[1]];
            const place = add(at, [v[0] * (gap + far + half[0]), v[1] * (gap + far + half[1])]);
            const box = [place[0] - half[0], place[1] - half[1], place[0] + half[0], place[1] + half[1]];
            const crossed = dots.filter((p) => box[0] < p[0] && p[0] < box[2] && box[1] < p[1] && p[1] < box[3]).length;
            const outside = box[0] < 0 || box[1] < 0 || box[2] > panel.width || box[3] > panel.height;
            list.push({box, place, far, number: list.length,
                       cost: 4000 * outside + 25 * crossed + Math.abs(turn) / 2 + 2 * far});
        }
    return list;
}

/* Choose the best place beside the labels that have one; the place of the last drawing is as good as others. */
function choose(panel, item, taken) {
    const name = item.label.join() + item.name, kept = panel.kept.get(name);
    let least = Infinity;
    for (const one of item.list) {
        const cost = one.cost - (one.number === kept ? 12 : 0) +
            200 * panel.boxes.filter((box) => overlap(box, one.box)).length +
            200 * taken.filter((other) => other !== item && other.best && overlap(other.best.box, one.box)).length;
        if (cost < least) {
            least = cost;
            item.best = one;
        }
    }
}

/* Place the labels of a drawing, when all its lines are there. */
function end(panel) {
    const list = panel.labels;
    list.forEach((item, k) => {
        item.name = k;
        item.list = candidates(panel, item);
        choose(panel, item, list);
    });
    list.forEach((item) => choose(panel, item, list)); /* again: later ones may stand in the way */
    for (const {best, label, kind, at, name} of list) {
        const made = svgLabel(label, kind);
        if (best.far > NEAR)
            panel.ink.append(svg("polyline", {class: "leader", points: pairs([at, [
                Math.max(best.box[0], Math.min(at[0], best.box[2])), Math.max(best.box[1], Math.min(at[1], best.box[3]))]])}));
        made.setAttribute("x", digits(best.box[0] + 1));
        made.setAttribute("y", digits(best.place[1] + 5));
        panel.ink.append(made);
        panel.kept.set(label.join() + name, best.number);
    }
}

/* A scale: an arrow or a bar of a round value, `k` pixels for one unit; returns its right end. */
function scaleBar(panel, kind, left, k, unit) {
    if (!(k > 0 && k < Infinity))
        return left;
    const value = roundDown(Math.min(110, panel.width / 5) / k), from = [left, panel.height - 14];
    const to = add(from, [value * k, 0]), words = quantityText(value, unit, 0);
    if (kind === "length")
        line(panel, "scale", add(from, [0, -4]), add(from, [0, 4]), from, to, add(to, [0, -4]), add(to, [0, 4]));
    else
        arrow(panel, "scale " + kind, from, [value * k, 0]);
    panel.ink.append(svg("text", {x: digits(to[0] + 6), y: panel.height - 9, class: "small"}, words));
    panel.boxes.push([left, panel.height - 24, to[0] + 12 + 7 * words.length, panel.height]);
    return to[0] + 30 + 7 * words.length;
}

/* The scale and the origin with which all marks [x, y, dx, dy] fit a panel: x and y are in the drawing's unit, dx
** and dy, of arrows, in pixels.  Arrows become smaller, to `part` of their length, before the drawing itself does. */
function fit(panel, marks, edge) {
    const list = marks.filter((m) => m.every(Number.isFinite));
    const border = Math.min(edge, panel.width / 8, panel.height / 8);
    const room = [Math.max(panel.width - 2 * border, 10), Math.max(panel.height - 2 * border - 20, 10)];
    const ends = (scale, part, j) => {
        let low = Infinity, high = -Infinity;
        for (const m of list) {
            low = Math.min(low, m[j] * scale + part * m[j + 2]);
            high = Math.max(high, m[j] * scale + part * m[j + 2]);
        }
        return low <= high ? [low, high] : [0, 0];
    };
    const fits = (scale, part) => [0, 1].every((j) => {
        const [low, high] = ends(scale, part, j);
        return high - low <= room[j];
    });
    const most = Math.min(...[0, 1].map((j) => {
        const [low, high] = ends(1, 0, j);
        return room[j] / (high - low);
    }));
    const largest = most > 0 && most < Infinity ? most : 1;
    let scale = 0, part = 1.25;
    while (scale < 0.65 * largest && part > 0.2) {
        let least = 0, upper = largest;
        part *= 0.8;
        for (let k = 0; k < 30; k++) {
            scale = (least + upper) / 2;
            if (fits(scale, part))
                least = scale;
            else
                upper = scale;
        }
        scale = least;
    }
    scale = Math.max(scale, 0.5 * largest);
    const [x, y] = [0, 1].map((j) => ends(scale, part, j));
    return {scale, part, origin: [(panel.width - x[0] - x[1]) / 2, (panel.height - 20 - y[0] - y[1]) / 2]};
}

/* 1, 2 or 5 times a power of ten, at least x; 1 for 0. */
function roundUp(x) {
    return x > 0 ? 10 / roundDown(10 / x * (1 + 1e-9)) : 1;
}

/* The largest of sizes that is not out of proportion to the others, as values near a dead position are. */
function usual(sizes) {
    const sorted = sizes.filter((x) => x > 0).sort((x, y) => x - y);
    return sorted.length ? Math.min(sorted[sorted.length - 1], 3 * sorted[Math.floor(sorted.length / 2)]) : 1;
}

/* The list of values beside a drawing: its entries stay, their numbers change. */
function makeValues(panel, entries) {
    panel.list.replaceChildren();
    return entries.map((entry) => {
        const value = html("span", {class: "number"});
        panel.list.append(html("li", {}, html("span", {class: "swatch " + entry.kind}), htmlLabel(entry.label),
                               " = ", value));
        return (number, hasNoArrow) => {
            value.textContent = quantityText(number, entry.unit, 4);
            value.setAttribute("class", hasNoArrow ? "number no-arrow" : "number");
        };
    });
}

/* The numbers 0 ... count - 1 of rows that have a position. */
function reached(tracks) {
    return Array.from({length: tracks.count}, (_, i) => i).filter((i) => !tracks.reason(i));
}

/* Forces, or torques, that are not 0 in every row. */
function present(list, tracks, rows) {
    return list.filter((x) => rows.some((i) => {
        const v = tracks.vector(x.of, i);
        return v ? size(v) > 0 : tracks.number(x.of, i);
    }));
}

return {html, svg, unitText, withUnit, quantityText, stepText, cellText, save, placeOf, hold, htmlLabel, add, minus, times, size, middle, direction, hull, tracksOf,
        makePanel, begin, end, measure, line, area, circle, head, arrow, torque, text, scaleBar, fit, roundUp, usual, makeValues,
        reached, present, pairs, digits};
}());
