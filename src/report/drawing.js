/* SPDX-License-Identifier: GPL-3.0-or-later
**
** drawing.js - the interactive drawing of a report.
**
** It does no mechanics.  The program computes rows, one for each crank angle, and this script draws them: the
** mechanism, the polygons of velocity and acceleration, the free bodies, and the row of the table.  Of a row it
** knows tracks: a vector or a number by its name, as rows.c makes them.  What is drawn from which track stands in
** the same data, from scene.c.
**
** Drawings are SVG, in pixels, with y downwards.  `data` is that JSON, `i` the number of a row.
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
    return unit === "1" ? "" : unit.replace(/2/g, "²").replace(/\./g, "·");
}

/* Digits as superscripts. */
function raised(text) {
    return text.replace(/\d/g, (digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit]).replace("-", "⁻").replace("+", "");
}

/* A number with four significant digits; very large or small ones with a power of ten. */
function numberText(value) {
    if (value === null || typeof value !== "number")
        return value === null ? "–" : String(value).replace("-", "−").replace("inf", "∞");
    const size = Math.abs(value);
    let text = value === 0 ? "0" : value.toPrecision(4);
    if (size !== 0 && (size < 1e-3 || size >= 1e5)) {
        const parts = value.toExponential(3).split("e");
        text = parts[0] + "×10" + raised(parts[1]);
    }
    return text.replace("-", "−");
}

function quantityText(value, unit) {
    return (numberText(value) + " " + unitText(unit)).trim();
}

/* An angle in the deck's unit. */
function angleText(data, angle) {
    const text = String(angle).replace("-", "−");
    return data.units.angle === "deg" ? text + "°" : text + " " + unitText(data.units.angle);
}

/* A label is [name, subscript, superscript].  A short name of the program's own is a variable, in italics. */
function labelText(label) {
    return label[0] + (label[1] ? "_" + label[1] : "") + (label[2] ? "^" + label[2] : "");
}

function isVariable(label) {
    return label[1] !== "" || label[0].length === 1;
}

function htmlLabel(label) {
    const made = html("span", {}, html(isVariable(label) ? "i" : "span", {}, label[0]));
    if (label[1])
        made.append(html("sub", {}, label[1]));
    if (label[2])
        made.append(html("sup", {}, label[2]));
    return made;
}

function svgLabel(label) {
    const made = svg("text", {}, svg("tspan", {class: isVariable(label) ? "variable" : null}, label[0]));
    if (label[1])
        made.append(svg("tspan", {dy: 4, class: "small"}, label[1]));
    if (label[2])
        made.append(svg("tspan", {dy: label[1] ? -10 : -5, class: "small"}, label[2]));
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
    function vector(name, i) {
        const track = branch.tracks[name];
        const x = track ? pick(track[0], i) : null, y = track ? pick(track[1], i) : null;
        return typeof x === "number" && typeof y === "number" ? [c * x - s * y, -s * x - c * y] : null;
    }
    return {number, vector, reason: (i) => branch.reasons[i] || "", count: data.angles.length,
            x: [c, -s]};
}

/* ---------------------------------------------------------------------------------------------------- panels */

/* A panel is a figure with one drawing, a caption and a list of values, which stay while the drawing changes. */
function makePanel(title, kind) {
    const drawing = svg("svg", {class: "sheet", role: "img"});
    const list = html("ul", {class: "values"});
    const figure = html("figure", {class: "panel " + kind}, drawing,
                        html("figcaption", {}, title), list);
    return {figure, drawing, list, title, ink: svg("g", {}), boxes: [], width: 0, height: 0};
}

/* Begin a drawing: empty, in the pixels that the page gives it. */
function begin(panel, name) {
    panel.boxes = [];
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
    line(panel, kind, ...points);
    head(panel, kind, points[24], direction(minus(points[24], points[22])));
}

/* Put a label beside a place: in the direction d, or around it where it covers no other label. */
function text(panel, at, d, label, gap) {
    const made = svgLabel(label), u = direction(d, [0.7, -0.7]);
    const half = [(label[0].length * 7.6 + (label[1] + label[2]).length * 6) / 2 + 1, 9];
    let best = null;
    for (const turn of [0, 45, -45, 90, -90, 135, -135, 180])
        for (const far of [gap || 6, (gap || 6) + 14]) {
            const c = Math.cos(turn * Math.PI / 180), s = Math.sin(turn * Math.PI / 180);
            const v = [c * u[0] - s * u[1], s * u[0] + c * u[1]];
            const place = add(at, [v[0] * (far + half[0]), v[1] * (far + half[1])]);
            const box = [place[0] - half[0], place[1] - half[1], place[0] + half[0], place[1] + half[1]];
            const covered = panel.boxes.filter((b) => b[0] < box[2] && box[0] < b[2] && b[1] < box[3] &&
                                               box[1] < b[3]).length;
            const outside = box[0] < 0 || box[1] < 0 || box[2] > panel.width || box[3] > panel.height;
            const cost = 100 * covered + 300 * outside + Math.abs(turn) + far;
            if (!best || cost < best.cost)
                best = {cost, box, place};
        }
    panel.boxes.push(best.box);
    made.setAttribute("x", digits(best.box[0] + 1));
    made.setAttribute("y", digits(best.place[1] + 5));
    panel.ink.append(made);
}

/* A scale: an arrow or a bar of a round value, `k` pixels for one unit; returns its right end. */
function scaleBar(panel, kind, left, k, unit) {
    const value = roundDown(Math.min(110, panel.width / 5) / k), from = [left, panel.height - 14];
    const to = add(from, [value * k, 0]), words = quantityText(value, unit).replace(/\.?0+(?= |$|×)/, "");
    if (kind === "length")
        line(panel, "scale", add(from, [0, -4]), add(from, [0, 4]), from, to, add(to, [0, -4]), add(to, [0, 4]));
    else
        arrow(panel, "scale " + kind, from, [value * k, 0]);
    panel.ink.append(svg("text", {x: digits(to[0] + 6), y: panel.height - 9, class: "small"}, words));
    panel.boxes.push([left, panel.height - 24, to[0] + 12 + 7 * words.length, panel.height]);
    return to[0] + 30 + 7 * words.length;
}

/* The scale and the origin with which all marks [x, y, dx, dy] fit a panel: x and y are in the drawing's unit, dx
** and dy in pixels. */
function fit(panel, marks, edge) {
    const low = [0, 0], high = [0, 0];
    const spread = (scale, j) => {
        low[j] = Infinity;
        high[j] = -Infinity;
        for (const m of marks) {
            low[j] = Math.min(low[j], m[j] * scale + m[j + 2]);
            high[j] = Math.max(high[j], m[j] * scale + m[j + 2]);
        }
        return high[j] - low[j];
    };
    const width = Math.max(panel.width - 2 * edge, 10), height = Math.max(panel.height - 2 * edge - 20, 10);
    const bare = [0, 1].map((j) => {
        const list = marks.map((m) => m[j]);
        return list.reduce((a, b) => Math.max(a, b), -Infinity) - list.reduce((a, b) => Math.min(a, b), Infinity);
    });
    let least = 0, most = Math.min(width / bare[0], height / bare[1]);
    if (!(most > 0 && most < Infinity))
        most = least = 1;
    for (let k = 0; k < 40; k++) {
        const scale = (least + most) / 2;
        if (spread(scale, 0) <= width && spread(scale, 1) <= height)
            least = scale;
        else
            most = scale;
    }
    spread(least, 0);
    spread(least, 1);
    return {scale: least, origin: [(panel.width - low[0] - high[0]) / 2, (panel.height - 20 - low[1] - high[1]) / 2]};
}

/* A scale that holds for nearly all rows: what it shows at most in row i, if sizes[i] is the largest there.  Near
** a dead position, where values grow without bound, it shows 2, 5, 10 ... times as much. */
function steady(sizes) {
    const sorted = sizes.filter((x) => x > 0).sort((x, y) => x - y);
    if (!sorted.length)
        return {most: 1, at: () => 1};
    const most = Math.min(sorted[sorted.length - 1], 3 * sorted[Math.floor(sorted.length / 2)]);
    const at = (i) => {
        let steps = most;
        for (let k = 0; steps < sizes[i] * (1 - 1e-9); k++)
            steps = most * [2, 5, 10][k % 3] * Math.pow(10, Math.floor(k / 3));
        return steps;
    };
    return {most, at};
}

/* The list of values beside a drawing: its entries stay, their numbers change. */
function makeValues(panel, entries) {
    panel.list.replaceChildren();
    return entries.map((entry) => {
        const value = html("span", {class: "number"});
        panel.list.append(html("li", {}, html("span", {class: "swatch " + entry.kind}), htmlLabel(entry.label),
                               " = ", value));
        return (number) => { value.textContent = quantityText(number, entry.unit); };
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

/* ------------------------------------------------------------------------------------------- parts of machines */

/* Hatched ground along a line, on the side of d. */
function ground(panel, from, to, d) {
    const u = direction(minus(to, from)), count = Math.floor(size(minus(to, from)) / 8);
    line(panel, "ground", from, to);
    for (let k = 0; k <= count; k++) {
        const at = add(from, times(8 * k, u));
        line(panel, "hatch", at, add(at, add(times(6, d), times(-5, u))));
    }
}

/* A fixed pin: a triangle on ground below it. */
function support(panel, at) {
    area(panel, "support", [at, add(at, [-9, 16]), add(at, [9, 16])]);
    ground(panel, add(at, [-15, 16]), add(at, [15, 16]), [0, 1]);
}

/* A block around a place, along u. */
function block(panel, kind, at, u, half) {
    const along = times(half, u), across = times(0.62 * half, [-u[1], u[0]]);
    area(panel, kind, [add(add(at, along), across), add(minus(at, along), across),
                       minus(minus(at, along), across), minus(add(at, along), across)]);
}

/* A centre of mass. */
function centre(panel, at) {
    circle(panel, "centre", at, 5);
    panel.ink.append(svg("path", {class: "quarter", d: "M" + pairs([at]) + "h5a5,5 0 0 1 -5,5zh-5a5,5 0 0 1 5,-5z"}));
}

/* A link, its places in pixels: `place` gives that of a track. */
function drawLink(panel, link, place, half) {
    const kind = "link" + link.link, ends = link.pins.map(place);
    const slide = place("S1") && place("S2") ? direction(minus(place("S2"), place("S1")), [1, 0]) : [1, 0];
    if (link.shape === "slot") {
        const root = place("R"), from = minus(place("S1"), times(1.6 * half, slide));
        const to = add(place("S2"), times(1.6 * half, slide)), across = times(0.62 * half, [-slide[1], slide[0]]);
        area(panel, kind + " slot", [add(from, across), add(to, across), minus(to, across), minus(from, across)]);
        line(panel, kind, place("D"), root, middle(from, to));
        return;
    }
    if (link.points.length)
        area(panel, kind + " body", hull(ends.concat(link.points.map(place))));
    if (link.shape === "block")
        block(panel, kind + " block", ends[0], slide, half);
    else
        line(panel, kind, ...ends);
}

/* ----------------------------------------------------------------------------------------------- the mechanism */

function mechanism(data, panel) {
    let tracks, rows, view, forces, torques, limit, put, cached, now = 0;
    const handle = svg("g", {class: "handle"});
    const names = data.forces.filter((f) => f.sign > 0 && f.pen !== "inertia");
    const turning = data.torques.filter((f) => f.sign > 0 && f.pen !== "inertia");
    const places = ["A", "B", "C", "D"].concat(data.points.map((p) => p.of));
    const place = (name, i) => {
        const v = tracks.vector(name, i);
        return v && add(view.origin, times(view.scale, v));
    };
    const half = () => Math.max(9, Math.min(20, 0.04 * Math.min(panel.width, panel.height)));
    const longest = () => 0.2 * Math.min(panel.width, panel.height);
    panel.drawing.append(panel.ink, handle);

    /* Take a branch. */
    function choose(branch) {
        tracks = tracksOf(data, branch);
        rows = reached(tracks);
        forces = present(names, tracks, rows);
        torques = present(turning, tracks, rows);
        const largest = (i) => Math.max(0, ...forces.map((f) => size(tracks.vector(f.of, i) || [0, 0])));
        limit = steady(Array.from({length: tracks.count}, (_, i) => largest(i)));
        put = makeValues(panel, forces.map((f) => ({label: f.label, unit: data.units.force, kind: f.pen}))
                         .concat(torques.map((f) => ({label: f.label, unit: data.units.torque, kind: f.pen}))));
    }

    /* Find the scale at which all rows fit, with their arrows. */
    function layOut() {
        const marks = [], edge = 2.2 * half();
        measure(panel);
        for (const i of rows.length ? rows : [0]) {
            for (const name of places)
                if (tracks.vector(name, i))
                    marks.push([...tracks.vector(name, i), 0, 0]);
            for (const name of ["S1", "S2"])
                if (tracks.vector(name, i)) {
                    marks.push([...tracks.vector(name, i), edge, edge]);
                    marks.push([...tracks.vector(name, i), -edge, -edge]);
                }
            for (const f of forces) {
                const v = tracks.vector(f.of, i), at = tracks.vector(f.at, i);
                if (v && at)
                    marks.push([...at, ...times(longest() / limit.at(i), v)]);
            }
        }
        view = fit(panel, marks, 34);
        panel.drawing.dataset.scale = view.scale;
        panel.drawing.dataset.x = view.origin[0];
        panel.drawing.dataset.y = view.origin[1];
        cached = paths();
    }

    /* The paths of C and of the tracer points. */
    function paths() {
        const group = svg("g", {});
        const ways = data.points.map((p, k) => [p.of, "path path" + k % 6]);
        for (const [name, kind] of [["C", "path construction"]].concat(ways)) {
            let way = "", broken = true;
            for (let i = 0; i < tracks.count; i++) {
                const at = tracks.reason(i) ? null : place(name, i);
                way += at ? (broken ? "M" : "L") + pairs([at]) : "";
                broken = !at;
            }
            if (way && data.angles.length > 1)
                group.append(svg("path", {class: kind, d: way}));
        }
        return group;
    }

    function drawFrame(i) {
        const to = place("D", i), from = place("S1", i), h = half();
        for (const name of data.supports)
            if (place(name, i))
                support(panel, place(name, i));
        if (to) {
            line(panel, "construction", place("A", i), to);
        } else if (from) {
            const end = place("S2", i), u = direction(minus(end, from)), n = [-u[1], u[0]];
            for (const side of [1, -1]) {
                const across = times(side * 0.68 * h, n), past = times(1.8 * h, u);
                ground(panel, add(minus(from, past), across), add(add(end, past), across), times(side, n));
            }
        }
    }

    /* The crank angle, from the x axis. */
    function drawAngle(i) {
        const A = place("A", i), B = minus(place("B", i), A), x = tracks.x;
        const cross = x[0] * B[1] - x[1] * B[0], dot = x[0] * B[0] + x[1] * B[1];
        const radius = Math.min(30, 0.55 * size(B)), start = times(radius, x), end = times(radius, direction(B));
        const angle = (Math.atan2(-cross, dot) + 2 * Math.PI) % (2 * Math.PI);
        const bisector = Math.atan2(x[1], x[0]) - angle / 2;
        line(panel, "construction", A, add(A, times(radius + 14, x)));
        panel.ink.append(svg("path", {class: "construction", d: "M" + pairs([add(A, start)]) + "A" + radius + "," +
                                      radius + " 0 " + (angle > Math.PI ? 1 : 0) + " 0 " + pairs([add(A, end)])}));
        text(panel, add(A, times(radius, [Math.cos(bisector), Math.sin(bisector)])),
             [Math.cos(bisector), Math.sin(bisector)], ["θ", "2", ""], 1);
    }

    function drawForces(i) {
        const k = longest() / limit.at(i);
        let bar = scaleBar(panel, "length", 12, view.scale, data.units.length);
        for (const t of torques)
            if (tracks.number(t.of, i)) {
                torque(panel, t.pen, place(t.at, i), tracks.number(t.of, i), 20);
                text(panel, add(place(t.at, i), [-14, 14]), [-1, 1], t.label, 3);
            }
        for (const f of forces) {
            const v = tracks.vector(f.of, i), at = place(f.at, i);
            if (!v || size(v) < 0.02 * limit.at(i))
                continue;
            arrow(panel, f.pen, at, times(k, v));
            text(panel, add(at, times(k, v)), v, f.label, 3);
        }
        if (forces.length)
            scaleBar(panel, "pin", bar, k, data.units.force);
    }

    /* The letters at the pins, away from their links. */
    function drawLetters(i) {
        const A = place("A", i), B = place("B", i), C = place("C", i), D = place("D", i);
        const away = (p, q, r) => add(direction(minus(p, q)), direction(minus(p, r)));
        text(panel, A, C || D ? away(A, B, B) : [0, 1], ["A", "", ""], 6);
        text(panel, B, C ? away(B, A, C) : minus(B, A), ["B", "", ""], 6);
        if (C)
            text(panel, C, D ? away(C, B, D) : [0.3, -1], ["C", "", ""], D ? 6 : 12);
        if (D)
            text(panel, D, minus(D, C || B), ["D", "", ""], 6);
        for (const p of data.points)
            if (place(p.of, i))
                text(panel, place(p.of, i), [0.8, -0.8], p.label, 4);
    }

    function drawDirections() {
        if (data.gravity) {
            arrow(panel, "load", [18, 14], [0, 36]);
            text(panel, [18, 44], [1, 0], ["g", "", ""], 3);
        }
        if (data.turn) {
            arrow(panel, "scale", [48, 44], times(30, tracks.x));
            text(panel, add([48, 44], times(30, tracks.x)), [1, 0], ["x", "", ""], 3);
        }
    }

    function drawHandle(i) {
        const A = place("A", i), B = place("B", i);
        handle.replaceChildren(svg("polyline", {points: pairs([A, B]), "stroke-width": 26}),
                               svg("circle", {cx: digits(B[0]), cy: digits(B[1]), r: 22}));
    }

    function show(i, name) {
        const reason = tracks.reason(i);
        now = i;
        begin(panel, name + (reason ? ": " + reason : ""));
        drawDirections();
        drawFrame(i);
        panel.ink.append(cached);
        if (reason) {
            support(panel, place("A", i));
            line(panel, "link2", place("A", i), place("B", i));
            panel.ink.append(svg("text", {x: panel.width / 2, y: 24, class: "reason"}, reason));
        } else {
            for (const link of data.links)
                drawLink(panel, link, (track) => place(track, i), half());
            for (const link of data.links)
                if (link.centre)
                    centre(panel, place(link.centre, i));
        }
        drawAngle(i);
        for (const pin of ["D", "A", "B", "C"])
            if (place(pin, i))
                circle(panel, "pivot", place(pin, i), 4.5, pin);
        for (const p of data.points)
            if (place(p.of, i))
                circle(panel, "dot", place(p.of, i), 3.5, p.of);
        drawLetters(i);
        drawForces(i);
        drawHandle(i);
        forces.forEach((f, k) => put[k](tracks.vector(f.of, i) && size(tracks.vector(f.of, i))));
        torques.forEach((f, k) => put[forces.length + k](tracks.number(f.of, i)));
    }

    /* The row whose crank points to a place of the drawing: of several, the nearest to the present row. */
    function rowAt(at) {
        const to = direction(minus(at, place("A", now))), count = tracks.count;
        let best = now, least = Infinity;
        for (let i = 0; i < count; i++) {
            const crank = direction(minus(place("B", i), place("A", i)));
            const steps = Math.abs(i - now), around = Math.min(steps, count - 1 - steps);
            const cost = 1 - crank[0] * to[0] - crank[1] * to[1] + 1e-9 * around;
            if (cost < least) {
                least = cost;
                best = i;
            }
        }
        return best;
    }

    return {panel, choose, layOut, show, handle, rowAt};
}

/* ------------------------------------------------------------------------------------------------ the polygons */

function polygon(data, panel, described) {
    const unit = data.units[described.quantity];
    let tracks, view, put, rows;

    /* The corners of row i by their names, and the images; null if the row has none. */
    function corners(i) {
        const found = {[described.pole]: [0, 0]};
        for (const side of described.sides) {
            const v = tracks.vector(side.of, i);
            if (!v)
                return null;
            if (!found[side.to])
                found[side.to] = add(found[side.from], v);
        }
        described.images.forEach((x, k) => { found["image " + k] = tracks.vector(x.of, i); });
        return found;
    }

    function choose(branch) {
        tracks = tracksOf(data, branch);
        rows = reached(tracks);
        put = makeValues(panel, described.sides.map((x) => ({label: x.label, unit, kind: "link" + x.pen})));
    }

    function layOut() {
        const marks = [];
        measure(panel);
        const all = Array.from({length: tracks.count}, (_, i) => tracks.reason(i) ? null : corners(i));
        const sizes = all.map((found) => found ? Math.max(...Object.values(found).map(size)) : 0);
        const limit = steady(sizes);
        all.forEach((found, i) => {
            if (found && sizes[i] <= limit.most * (1 + 1e-9))
                Object.values(found).forEach((p) => marks.push([...p, 0, 0]));
        });
        view = fit(panel, marks.length ? marks : [[0, 0, 0, 0]], 30);
    }

    /* The scale of a row: smaller than that of the others by 2, 5, 10 ... where the polygon would not fit. */
    function scaleOf(found) {
        let scale = view.scale;
        const fits = (p) => {
            const at = add(view.origin, times(scale, p));
            return at[0] > 8 && at[0] < panel.width - 8 && at[1] > 8 && at[1] < panel.height - 24;
        };
        for (let k = 0; k < 60 && !Object.values(found).every(fits); k++)
            scale = view.scale / ([2, 5, 10][k % 3] * Math.pow(10, Math.floor(k / 3)));
        return scale;
    }

    function show(i, name) {
        const found = tracks.reason(i) ? null : corners(i);
        begin(panel, name);
        described.sides.forEach((x, k) => put[k](found && size(tracks.vector(x.of, i))));
        if (!found)
            return;
        const scale = scaleOf(found), place = (key) => add(view.origin, times(scale, found[key]));
        const keys = Object.keys(found), heart = times(1 / keys.length, keys.map(place).reduce(add));
        if (keys.every((key) => size(found[key]) === 0)) {
            panel.ink.append(svg("text", {x: panel.width / 2, y: panel.height / 2, class: "reason"}, described.zero));
            return;
        }
        scaleBar(panel, "vector", 12, scale, unit);
        for (const ends of described.lines)
            line(panel, "construction", place(ends[0]), place(ends[1]));
        described.images.forEach((_, k) => line(panel, "construction", place(described.pole), place("image " + k)));
        for (const side of described.sides)
            arrow(panel, "link" + side.pen, place(side.from), times(scale, tracks.vector(side.of, i)));
        for (const key of keys.filter((x) => !/^_|^image/.test(x))) {
            circle(panel, "dot", place(key), 2.5, key);
            text(panel, place(key), minus(place(key), heart), [key, "", ""], 4);
        }
        described.images.forEach((x, k) => {
            circle(panel, "dot", place("image " + k), 2.5);
            text(panel, place("image " + k), minus(place("image " + k), heart), x.label, 4);
        });
        for (const side of described.sides) {
            const v = times(scale, tracks.vector(side.of, i)), at = add(place(side.from), times(0.5, v));
            const n = [-v[1], v[0]], out = n[0] * (at[0] - heart[0]) + n[1] * (at[1] - heart[1]) < 0 ? -1 : 1;
            if (size(v) > 14)
                text(panel, at, times(out, n), side.label, 3);
        }
    }

    return {panel, choose, layOut, show};
}

/* ------------------------------------------------------------------------------------------------- free bodies */

function freeBody(data, panel, link) {
    let tracks, rows, view, forces, torques, limit, put;
    const mine = (list) => list.filter((x) => x.on === link.link);
    const longest = () => 0.26 * Math.min(panel.width, panel.height);
    const half = () => Math.max(10, 0.07 * Math.min(panel.width, panel.height));

    /* Where the body is held in the drawing: the middle between its pins, or the pin of a lever. */
    function heart(i) {
        const pins = link.pins.map((pin) => tracks.vector(pin, i));
        return link.shape === "slot" ? pins[1] : pins.length > 1 ? middle(pins[0], pins[1]) : pins[0];
    }

    function choose(branch) {
        tracks = tracksOf(data, branch);
        rows = reached(tracks);
        forces = present(mine(data.forces), tracks, rows);
        torques = present(mine(data.torques), tracks, rows);
        const largest = (i) => Math.max(0, ...forces.map((f) => size(tracks.vector(f.of, i) || [0, 0])));
        limit = steady(Array.from({length: tracks.count}, (_, i) => largest(i)));
        put = makeValues(panel, forces.map((f) => ({label: f.label, unit: data.units.force, kind: f.pen}))
                         .concat(torques.map((f) => ({label: f.label, unit: data.units.torque, kind: f.pen}))));
    }

    function layOut() {
        const marks = [[0, 0, half(), half()], [0, 0, -half(), -half()]];
        const names = link.pins.concat(link.points, link.shape === "slot" ? ["S1", "S2"] : []);
        measure(panel);
        for (const i of rows) {
            for (const name of names)
                marks.push([...minus(tracks.vector(name, i), heart(i)), 0, 0]);
            for (const f of forces) {
                const at = minus(tracks.vector(f.at, i), heart(i));
                marks.push([...at, ...times(f.sign * longest() / limit.at(i), tracks.vector(f.of, i))]);
            }
        }
        view = fit(panel, marks, 28);
    }

    function show(i, name) {
        begin(panel, name);
        forces.forEach((f, k) => put[k](tracks.vector(f.of, i) && size(tracks.vector(f.of, i))));
        torques.forEach((f, k) => put[forces.length + k](
            tracks.number(f.of, i) === null ? null : f.sign * tracks.number(f.of, i)));
        if (tracks.reason(i))
            return;
        const place = (track) => {
            const v = tracks.vector(track, i);
            return v && add(view.origin, times(view.scale, minus(v, heart(i))));
        };
        const k = longest() / limit.at(i);
        drawLink(panel, link, place, half());
        for (const f of forces) /* lines to loads that act off the link's line */
            if (!link.pins.includes(f.at) && f.pen === "load")
                line(panel, "construction", ...link.pins.map(place), place(f.at));
        if (link.centre)
            centre(panel, place(link.centre));
        link.pins.forEach((pin, j) => {
            const other = place(link.pins[1 - j] || pin);
            circle(panel, "pivot", place(pin), 4.5, pin);
            text(panel, place(pin), minus(place(pin), other), [pin, "", ""], 6);
        });
        torques.forEach((f, j) => {
            const value = tracks.number(f.of, i), side = f.pen === "pin" ? -1 : 1;
            if (!value)
                return;
            torque(panel, f.pen, place(f.at), f.sign * value, 17 + 5 * j);
            text(panel, add(place(f.at), [side * 14, 14]), [side, 0.7], f.label, 5);
        });
        for (const f of forces) {
            const v = times(f.sign * k, tracks.vector(f.of, i));
            if (size(v) < 0.02 * longest())
                continue;
            arrow(panel, f.pen, place(f.at), v);
            text(panel, add(place(f.at), v), v, f.label, 3);
        }
        if (forces.length)
            scaleBar(panel, "pin", 12, k, data.units.force);
    }

    return {panel, choose, layOut, show};
}

/* ------------------------------------------------------------------------------------------ the row of the table */

/* A number as the program's table writes it. */
function cellText(column, value) {
    if (typeof value !== "number")
        return value === null ? "–" : String(value).replace("-", "−").replace("inf", "∞");
    const text = column.form === "angle" ? String(value) : column.form === "exponent"
        ? value.toExponential(column.decimals) : value.toFixed(column.decimals);
    return text.replace(/^-(?=[0.]+$)/, "");
}

function tableRow(data, place) {
    const list = html("dl", {class: "row"});
    const cells = data.columns.map((column) => {
        const cell = html("dd", {"data-column": column.name});
        list.append(html("div", {title: column.meaning}, html("dt", {}, column.name), cell));
        return cell;
    });
    place.append(html("section", {class: "panel whole", "aria-label": "Row of the table"},
                      html("p", {class: "caption"}, "Row of the table"), list));
    return {
        show(branch, i) {
            data.columns.forEach((column, j) => {
                const unit = unitText(column.unit);
                cells[j].textContent = cellText(column, branch.table[i][j]) + (unit ? " " + unit : "");
            });
        }
    };
}

/* ----------------------------------------------------------------------------------------------------- the page */

/* What the colours mean. */
function keyOf(data) {
    const key = html("p", {class: "key"});
    const entry = (kind, words) => key.append(html("span", {}, html("span", {class: "swatch " + kind}), " " + words), " ");
    for (const link of data.links)
        entry("link" + link.link, link.link + " " + link.name);
    if (data.forces.some((f) => f.pen === "pin"))
        entry("pin", "pin force: Fij, by link i on link j; 1 is the ground");
    if (data.forces.some((f) => f.pen === "load"))
        entry("load", "load or weight");
    if (data.forces.some((f) => f.pen === "inertia"))
        entry("inertia", "inertia force and torque, in the free bodies");
    data.points.forEach((p, k) => entry("path" + k % 6, "path of " + p.label[0]));
    return key;
}

/* Make the drawing in `place`, an element, from `data`; returns its functions. */
function draw(data, place) {
    const main = mechanism(data, makePanel("Mechanism", "whole"));
    const views = [main].concat(data.polygons.map((x) => polygon(data, makePanel(x.title, "half"), x)));
    if (data.forced)
        for (const link of data.links)
            views.push(freeBody(data, makePanel("Free body of the " + link.name, "third"), link));
    const grid = html("div", {class: "panels"}, ...views.map((view) => view.panel.figure));
    const row = tableRow(data, grid);
    let branch = data.branches[0], now = data.start;
    main.panel.figure.append(keyOf(data));
    place.replaceChildren(grid);

    const name = () => (data.branches.length > 1 ? branch.name + ", " : "") + "θ₂ = " +
        angleText(data, data.angles[now]);
    function show(i) {
        now = Math.max(0, Math.min(data.angles.length - 1, i));
        for (const view of views)
            view.show(now, name());
        row.show(branch, now);
    }
    function layOut() {
        for (const view of views)
            view.layOut();
        show(now);
    }
    function choose(k) {
        branch = data.branches[k];
        for (const view of views)
            view.choose(branch);
        layOut();
    }
    choose(0);
    return {show, choose, layOut, main, name, row: () => now, reason: (i) => branch.reasons[i] || ""};
}

return {draw, angleText, element: html};
}());
