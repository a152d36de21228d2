/* SPDX-License-Identifier: GPL-3.0-or-later
**
** player.js - moves the drawings of a report or of the page.
**
** The program has drawn them at all steps; see moving_json.c.  This script says where each place is at a step and puts it there.
** A sheet has the width that the page gives it: what is drawn is scaled with it, texts keep their size, so labels.js finds room
** for them.
*/
fourlink.draw = (function () {

const {html, svg, withUnit, stepText, cellText, htmlLabel} = fourlink;
const SIGNS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789!#$%'*+,-./:;=?@[]^_`{|}~ ";
const PER_PIXEL = 40, PER_RADIAN = 20000; /* as in moving_json.c */
const HALF_WIDE = 0.32, HEAD = 0.025, LEAST_HEAD = 14, BLUR = 0.7, SHORTER = 0.8, BASELINE = 5, LOWER = 4, HIGHER = 6, ARC_STEP = 0.1037, LINE = 18; /* as in svg.c, canvas.c and display.h */
const MOST_ZOOM = 12, DIAMETERS = 8; /* of a disc */
const indexOf = new Map([...SIGNS].map((sign, k) => [sign, k])), MANY = SIGNS.length;

/* ---------------------------------------------------------------------------------------------------- places */

/* The numbers of a series: each differs by so much from where the two before lead to.  A number stays one. */
function numbersOf(words, parts) {
    const list = [];
    if (typeof words === "number")
        return words;
    for (let k = 0, last = 0, before = 0; k < words.length; k++) {
        let small = indexOf.get(words[k]);
        if (small === undefined) {
            const end = words.indexOf(")", k);
            small = Number(words.slice(k + 1, end));
            k = end;
        } else if (small < 62) {
            small -= 30;
        } else {
            const isLong = small >= 80, most = isLong ? 4 * MANY * MANY : 9 * MANY;
            small = MANY * (small - (isLong ? 80 : 62)) + indexOf.get(words[++k]);
            small = (isLong ? MANY * small + indexOf.get(words[++k]) : small) - most;
        }
        const here = small + 2 * last - before;
        before = list.length ? last : here;
        last = here;
        list.push(here / parts);
    }
    return list;
}

const inFrame = ({x, y, c, s, unit}, [p, q]) => [x + p * unit * c - q * s, y + p * unit * s + q * c];

/* Where the frames of a panel are at step i and a part of the way to the next, the sheet before them, and the places in them,
** with the angles of their frames. */
function sceneryAt({frames, places}, i, part) {
    const all = [{x: 0, y: 0, c: 1, s: 0, unit: 1, angle: 0}];
    const at = (x) => typeof x === "number" ? x : part ? x[i] + part * (x[i + 1] - x[i]) : x[i];
    const placeOf = ([f, p, q]) => [...inFrame(all[f], [at(p), at(q)]), all[f].angle];
    for (const [p, q, own] of frames) {
        const [x, y] = placeOf(places[p]), to = q >= 0 ? placeOf(places[q]) : [x, y];
        const angle = q === -1 ? at(own) : Math.atan2(to[1] - y, to[0] - x);
        all.push({x, y, c: Math.cos(angle), s: Math.sin(angle), unit: q >= 0 && own ? Math.hypot(to[0] - x, to[1] - y) : 1, angle});
    }
    return {frames: all, places: places.map(placeOf)};
}

/* ----------------------------------------------------------------------------------------------------- items */

const digits = (x, unit = 100) => Math.round(x * unit) / unit;
const piecesOf = (d) => d.split("M").slice(1).map((piece) => piece.split("L").map((at) => at.split(",").map(Number)));
const wayOf = (places) => places.map((p, k) => (k ? "L" : "M") + digits(p[0]) + "," + digits(p[1])).join("");

/* Words with their subscripts and superscripts, as tspans. */
function svgWords(words) {
    let at = 0;
    return words.map((part) => {
        const [text, level] = [].concat(part), to = level < 0 ? LOWER : level > 0 ? -HIGHER : 0;
        const made = svg("tspan", {dy: to - at || null, class: to ? "script" : null}, text);
        at = to;
        return made;
    });
}

function htmlWords(words) {
    return words.map((part) => typeof part === "string" ? part : html(part[1] < 0 ? "sub" : "sup", {}, part[0]));
}

/* The words of an item that change: of step i, with their unit. */
function valuesOf({values = []}) {
    const list = values.flatMap((decimals, k) => k % 3 ? [] : decimals < 0 ? Array(-decimals).fill(values[k + 2]) :
        numbersOf(values[k + 1], 10 ** decimals).map((x) => [String(x).replace("-", "−"), ...values[k + 2]]));
    return (i) => list[i] || [];
}

/* Of an arrow, its line and its head, by their corners. */
function arrowOf([from, to], most) {
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1, head = Math.min(most, SHORTER * length);
    const u = [(from[0] - to[0]) / length, (from[1] - to[1]) / length];
    const at = (along, across) => [to[0] + along * u[0] - across * u[1], to[1] + along * u[1] + across * u[0]];
    return [[from, at(SHORTER * head, 0)], [to, at(head, HALF_WIDE * head), at(head, -HALF_WIDE * head)]];
}

/* The length of a head, which does not become too small when the sheet does. */
const headOf = (size, scale) => Math.max(size, LEAST_HEAD / scale);

function arrowWays(places, most) {
    const [line, head] = arrowOf(places, most);
    return [wayOf(line), wayOf(head) + "z"];
}

/* The corners of an arc or a spiral. */
function arcOf([centre, turns], [first, last]) {
    const from = turns[0] / 100 - centre[2], span = turns[1] / 100, count = 8 + Math.floor(Math.abs(span) / ARC_STEP);
    return Array.from({length: count + 1}, (_, k) => {
        const radius = first + k / count * (last - first), angle = from + k / count * span;
        return [centre[0] + radius * Math.cos(angle), centre[1] - radius * Math.sin(angle)];
    });
}

const quarters = ([x, y], r) => [1, -1].map((s) => wayOf([[x, y], [x + s * r, y]]) + "A" + r + "," + r + " 0 0 1 " + digits(x) + "," +
                                                   digits(y + s * r) + "z").join("");

/* What is drawn for an item, and how its elements are set from its places: {elements, set}.  A text is not scaled: it is
** set with the scale and the shift of the sheet. */
const makers = {
    path: (item, kind) => {
        const way = svg("path", {...kind, d: item.d}), pieces = piecesOf(item.d);
        return {elements: [way], pieces, set(places, i, of, at, frame) {
            if (frame.unit !== 1)
                way.setAttribute("d", pieces.map((piece) => wayOf(piece.map((p) => inFrame(frame, p)))).join(""));
            else if (item.in)
                way.setAttribute("transform", "translate(" + digits(frame.x) + "," + digits(frame.y) + ") rotate(" + digits(frame.angle * 180 / Math.PI, 1e4) + ")");
        }};
    },
    line: (item, kind) => {
        const way = svg("path", kind);
        return {elements: [way], set: (places) => way.setAttribute("d", wayOf(places))};
    },
    arc: (item, kind) => {
        const way = svg("path", kind);
        return {elements: [way], set: (places) => way.setAttribute("d", wayOf(arcOf(places, item.radius)))};
    },
    arrow: (item, kind) => {
        const parts = [svg("path", kind), svg("path", {class: "h-" + item.look})];
        return {elements: parts, set: (places, i, scale) => {
            arrowWays(places, headOf(item.size, scale)).forEach((way, k) => parts[k].setAttribute("d", way));
        }};
    },
    disc: (item, kind) => {
        const circle = svg("circle", {...kind, r: item.size || 0});
        return {elements: [circle], set: ([at]) => ["cx", "cy"].forEach((name, k) => circle.setAttribute(name, digits(at[k])))};
    },
    centre: (item, kind) => {
        const {elements, set} = makers.disc(item, kind), black = svg("path", {class: "solid"});
        return {elements: [...elements, black], set: (places) => {
            set(places);
            black.setAttribute("d", quarters(places[0], item.size));
        }};
    },
    label: (item, kind) => ({elements: [svg("text", {...kind, "text-anchor": "middle"}, ...svgWords(item.words))], isText: true, set() {}}),
    text: (item, kind) => {
        const made = svg("text", {...kind, "text-anchor": item.anchor || "middle"}, ...svgWords(item.words)), values = valuesOf(item);
        return {elements: [made], isText: true, set: ([at, off], i, scale, shift) => {
            made.setAttribute("x", digits(scale * at[0] + shift[0] + off[0]));
            made.setAttribute("y", digits(scale * at[1] + shift[1] + off[1] + BASELINE));
            if (item.values)
                made.replaceChildren(...svgWords([...item.words, ...values(i)]));
        }};
    }
};

const isGone = (item, i) => item.gone !== undefined && item.gone.filter((step) => step <= i).length % 2 === 1;

/* ---------------------------------------------------------------------------------------------------- labels */

/* Add the lines between corners to a list, each [x, y, x, y, half its width]. */
function addLines(list, corners, half) {
    for (let k = 1; k < corners.length; k++)
        list.push([...corners[k - 1].slice(0, 2), ...corners[k].slice(0, 2), half]);
}

/* Half the width of a line, and a bit for what is smoothed. */
const halves = new Map();
function halfOf(element) {
    const look = element.getAttribute("class");
    if (!halves.has(look)) {
        const {stroke, strokeWidth} = window.getComputedStyle(element);
        halves.set(look, (stroke === "none" ? 0 : parseFloat(strokeWidth) / 2) + BLUR);
    }
    return halves.get(look);
}

/* The lines of a path in a frame. */
function linesOfPath(pieces, half, frame) {
    const list = [];
    for (const piece of pieces)
        addLines(list, piece.map((p) => inFrame(frame, p)), half);
    return list;
}

/* Add what labels are not to cover of an item that moves; a disc by its diameters. */
function addItem(list, {item, elements: [made]}, places, scale) {
    const at = item.at.map((k) => places[k]), r = item.size, half = halfOf(made) / scale;
    if (item.as === "line") {
        addLines(list, at, half);
    } else if (item.as === "arrow") {
        const [line, head] = arrowOf(at, headOf(r, scale));
        addLines(list, line, half);
        addLines(list, [...head, head[0]], BLUR / scale);
    } else if (item.as === "arc") {
        addLines(list, arcOf(at, item.radius), half);
    } else if (r && item.as !== "label") {
        for (let k = 0; k < DIAMETERS; k++) {
            const x = r * Math.cos(k * Math.PI / DIAMETERS), y = r * Math.sin(k * Math.PI / DIAMETERS);
            addLines(list, [[at[0][0] - x, at[0][1] - y], [at[0][0] + x, at[0][1] + y]], half);
        }
    }
}

/* Of a text its width, and how far its letters are above and below the line on which they stand, in pixels. */
function sizeOf(made, words) {
    const size = parseFloat(window.getComputedStyle(made).fontSize), has = (sign) => words.some((part) => part[1] * sign > 0 && typeof part !== "string");
    return {width: made.getComputedTextLength(), up: has(1) ? 6 + 0.55 * size : 0.74 * size,
            down: has(-1) ? 4.5 : /[gjpqy(,\u2080-\u209c]/.test(made.textContent) ? 3 : 0.5};
}

/* ---------------------------------------------------------------------------------------------------- panels */

/* A figure with one drawing, its caption, what its lines mean, and its values. */
function makePanel(title, size) {
    const ink = svg("g", {}), texts = svg("g", {}), handle = svg("g", {class: "handle"});
    const drawing = svg("svg", {class: "fourlink sheet", role: "img"}, ink, texts, handle);
    const caption = html("span", {}, title), key = html("p", {class: "key"}), list = html("ul", {class: "values"});
    const figure = html("figure", {class: "panel " + size}, drawing, html("figcaption", {}, caption), key, list);
    let data = null, scenery = null, parts = [], notes = [], now = 0, cranks = null, scale = 1, zoom = 1, shift = [0, 0];
    let labels = null, named = [], scenes = new Map(), frame = null, count = 1;

    /* Take the drawing of a branch, of so many steps. */
    function take(newData, steps) {
        data = newData;
        cranks = null;
        scenery = {places: data.places.map(([f, p, q]) => [f, numbersOf(p, PER_PIXEL), numbersOf(q, PER_PIXEL)]),
                   frames: data.frames.map(([p, q, own]) => [p, q, typeof own === "string" ? numbersOf(own, PER_RADIAN) : own])};
        count = steps;
        parts = data.items.map((item) => ({item, ...makers[item.as](item, {class: item.look || null, "data-name": item.name || null})}));
        ink.replaceChildren(...parts.filter((part) => !part.isText).flatMap((part) => part.elements));
        texts.replaceChildren(...parts.filter((part) => part.isText).flatMap((part) => part.elements));
        key.replaceChildren(...data.key.flatMap(({look, words}) => [html("span", {}, svg("svg", {class: "fourlink sample", viewBox: "0 0 26 8"},
            svg("path", {class: look, d: "M0,4H26"})), ...htmlWords(words)), " "]));
        const tips = new Set(data.items.filter((item) => item.as === "arrow").map((item) => item.at[1]));
        named = parts.filter(({item}) => item.as === "label");
        labels = fourlink.labels.make(named.map(({item}) => ({at: item.at[0], behind: item.at[1], radius: item.size || 0,
            rank: tips.has(item.at[0]) ? 0 : item.size ? 1 : 2, name: JSON.stringify(item.words)})), labels);
        notes = data.notes.map((item) => ({item, made: html("li", {}), values: valuesOf(item)}));
        list.replaceChildren(...notes.map((note) => note.made));
        layOut();
    }
    /* Take the width that the page gives the sheet. */
    function layOut() {
        drawing.style.setProperty("--aspect", data.sheet[2] / data.sheet[3]);
        const width = drawing.clientWidth || data.sheet[2], whole = width / data.sheet[2];
        const height = whole * data.sheet[3] + LINE * Math.max(0, 1 - whole); /* the scale below has its words in full */
        scale = zoom * whole;
        shift = [[width, 0], [height, 1]].map(([size, k]) => Math.min(0, Math.max(size * (1 - zoom), shift[k])));
        drawing.setAttribute("viewBox", "0 0 " + width + " " + height);
        drawing.style.aspectRatio = width / height;
        drawing.setAttribute("data-box", data.box.map((x, k) => x * scale + (shift[k] || 0)).join(" "));
        drawing.setAttribute("data-axes", data.axes.join(" "));
        ink.setAttribute("transform", "translate(" + shift.map((x) => digits(x)) + ") scale(" + scale + ")");
        frame = {left: (1 - shift[0]) / scale, top: (1 - shift[1]) / scale, right: (width - 1 - shift[0]) / scale,
                 bottom: (height - 1 - shift[1]) / scale, pixel: 1 / scale, reach: 4 * HALF_WIDE * headOf(HEAD * data.sheet[2], scale)};
        scenes.clear();
        for (const x of [...labels.labels, ...parts]) /* letters may have another size */
            x.size = x.width = x.lines = null;
    }
    /* What labels are not to cover at a step, and where their places are. */
    function sceneAt(i, part) {
        const {places, frames} = sceneryAt(scenery, i, part), lines = [], curves = [], texts = [];
        for (const part of parts) {
            const {item, elements: [made]} = part;
            if (isGone(item, i))
                continue;
            if (item.as === "path") {
                part.lines = !item.in && part.lines || linesOfPath(part.pieces, halfOf(made) / scale, frames[item.in || 0]);
                (item.name && item.name !== "scale" ? curves : lines).push(...part.lines);
            } else if (item.as !== "text") {
                addItem(lines, part, places, scale);
            } else {
                const [at, off] = item.at.map((k) => places[k]), w = (part.width = part.width || made.getComputedTextLength()) / 2 / scale;
                const right = {start: 1, end: -1}[item.anchor] || 0;
                texts.push({x: at[0] + off[0] / scale + right * w, y: at[1] + off[1] / scale, w, h: 7 / scale});
            }
        }
        return {places, lines, curves, texts, near: [], isThere: (k) => !isGone(named[k].item, i)};
    }
    function sceneOf(i) {
        if (i < 0 || i >= count)
            return null;
        if (!scenes.has(i))
            scenes.set(i, sceneAt(i, 0));
        return scenes.get(i);
    }
    /* Put the labels beside their places. */
    function putLabels(i, part, way) {
        const isNew = labels.labels.some((label) => !label.size);
        if (isNew)
            named.forEach(({elements: [made]}) => made.setAttribute("display", "inline")); /* what is not shown has no width */
        labels.labels.forEach((label, k) => {
            label.size = label.size || sizeOf(named[k].elements[0], named[k].item.words);
            label.w = label.size.width / 2 / scale;
            label.h = (label.size.up + label.size.down) / 2 / scale;
        });
        const boxes = labels.place(part ? sceneAt(i, part) : sceneOf(i), (n) => sceneOf(i + n * way), frame);
        named.forEach(({elements: [made]}, k) => {
            const box = boxes.get(k);
            made.setAttribute("display", box ? "inline" : "none");
            if (!box)
                return;
            made.setAttribute("x", digits(scale * box.x + shift[0]));
            made.setAttribute("y", digits(scale * (box.y - box.h) + shift[1] + labels.labels[k].size.up));
        });
    }
    /* Make what is at a place of the sheet larger; show its other parts. */
    function zoomBy(factor, at) {
        const next = Math.max(1, Math.min(MOST_ZOOM, zoom * factor));
        shift = shift.map((x, k) => at[k] - (at[k] - x) * next / zoom);
        zoom = next;
    }
    function moveBy(way) {
        shift = shift.map((x, k) => x + way[k]);
    }
    /* Show step i and a part of the way to the next. */
    function show(i, part, name) {
        const {places, frames} = sceneryAt(scenery, i, part), isWithin = part > 0 && i === now, way = i < now ? -1 : 1;
        now = i;
        drawing.setAttribute("aria-label", title + ": " + name);
        for (const {item, elements, set} of parts) {
            const gone = isGone(item, i);
            if (item.gone)
                elements.forEach((x) => { x.setAttribute("display", gone ? "none" : "inline"); });
            if (!gone)
                set((item.at || []).map((k) => places[k]), i, scale, shift, frames[item.in || 0]);
        }
        putLabels(i, part, way);
        if (isWithin)
            return; /* values are those of the step */
        for (const {item, made, values} of notes) {
            made.hidden = isGone(item, i);
            made.replaceChildren(...htmlWords([...item.words, ...values(i)]));
        }
    }
    /* Of a pin or a point at step i, in pixels of the sheet; null where it is not there. */
    function place(name, i = now) {
        const item = data.items.find((x) => x.name === name && (x.as === "disc" || x.as === "centre"));
        return item && !isGone(item, i) ? sceneryAt(scenery, i, 0).places[item.at[0]].slice(0, 2).map((x, k) => scale * x + shift[k]) : null;
    }
    /* The step whose crank points to a place: of several, the nearest to the present one. */
    function rowAt([x, y], count) {
        let best = now, least = Infinity;
        cranks = cranks || Array.from({length: count}, (_, i) => [place("A", i), place("B", i)]);
        cranks.forEach(([A, B], i) => {
            const off = Math.atan2(B[1] - A[1], B[0] - A[0]) - Math.atan2(y - A[1], x - A[0]), steps = Math.abs(i - now);
            const cost = 1 - Math.cos(off) + 1e-9 * Math.min(steps, count - 1 - steps);
            if (cost < least)
                [best, least] = [i, cost];
        });
        return best;
    }
    /* Of a place in the sheet, in the unit of the axes, turned to and fro by the angle by which the x axis rises. */
    function planeOf(at, turn) {
        const [left, top, width, height] = data.box, [x0, x1, y0, y1] = data.axes, c = Math.cos(turn), s = Math.sin(turn);
        const [p, q] = at.map((x, k) => (x - shift[k]) / scale);
        const x = x0 + (p - left) / width * (x1 - x0), y = y1 - (q - top) / height * (y1 - y0);
        return [c * x + s * y, c * y - s * x];
    }
    function sheetOf([p, q], turn) {
        const [left, top, width, height] = data.box, [x0, x1, y0, y1] = data.axes, c = Math.cos(turn), s = Math.sin(turn);
        const x = c * p - s * q, y = s * p + c * q;
        return [left + (x - x0) / (x1 - x0) * width, top + (y1 - y) / (y1 - y0) * height].map((z, k) => scale * z + shift[k]);
    }
    return {title, figure, drawing, caption, handle, take, layOut, zoomBy, moveBy, show, place, rowAt, planeOf, sheetOf,
            isSeen: () => !figure.closest("[hidden]"), zoom: () => zoom,
            pixel: () => (data.axes[1] - data.axes[0]) / data.box[2] / scale};
}

/* Where the crank can be held. */
function putHandle(panel) {
    const [A, B] = [panel.place("A"), panel.place("B")];
    panel.handle.replaceChildren(svg("path", {d: wayOf([A, B]), "stroke-width": 26}), svg("circle", {cx: B[0], cy: B[1], r: 22}));
}

/* ------------------------------------------------------------------------------------------ the row of the table */

function tableRow(data, place) {
    const list = html("dl", {class: "cells"}), columns = (of) => of.columns.filter((c) => !c.rounding);
    const cells = columns(data).map((column) => {
        const cell = html("dd", {"data-column": column.name});
        list.append(html("div", {title: column.meaning}, html("dt", {}, htmlLabel(column.label)), cell));
        return cell;
    });
    place.append(html("section", {class: "panel whole", "aria-label": "Row of the table"},
                      html("p", {class: "caption"}, "Row of the table"), list));
    return (branch, i) => columns(data).forEach((column, j) => {
        const value = branch.table[i][data.columns.indexOf(column)];
        cells[j].textContent = withUnit(cellText(column, value), column.unit);
    });
}

/* ------------------------------------------------------------------------------------------------------ the page */

/* What the drawings consist of, whatever their numbers. */
const head = (data) => JSON.stringify([data.over, data.units, data.columns.map((c) => [c.name, c.unit])]);
function structure(data) {
    return JSON.stringify([head(data), data.branches.map((b) => [b.name, b.panels.map((panel) => panel.title)])]);
}

/* Make the drawings in `place`, an element, from `data`, all but the mechanism in `more` if it is given; returns their
** functions. */
function draw(data, place, more) {
    const panels = data.branches[0].panels.map(({title, size}) => makePanel(title, size)), main = panels[0];
    const grid = html("div", {class: "panels"}, ...panels.slice(more ? 1 : 0).map((panel) => panel.figure));
    const showRow = tableRow(data, grid);
    let branch = data.branches[0], now = data.start, isBrief = false;
    place.replaceChildren(more ? html("div", {class: "panels"}, main.figure) : grid);
    if (more)
        more.replaceChildren(grid);

    const name = () => (data.branches.length > 1 ? branch.name + ", " : "") +
        (data.over === "time" ? "t = " : "θ₂ = ") + stepText(data, now);
    /* Show a step; between two of them, which have positions, what moves is between their places. */
    function show(i) {
        const row = Math.max(0, Math.min(data.steps.length - 1, Math.floor(i))), isNew = row !== now;
        now = row;
        const part = i > row && row + 1 < data.steps.length && !branch.reasons[row] && !branch.reasons[row + 1] ? i - row : 0;
        for (const panel of panels)
            if (isBrief ? panel === main : panel.isSeen())
                panel.show(now, part, name());
        if (part && !isNew)
            return;
        main.caption.textContent = main.title + " at " + name() +
            (data.why && now === data.start && branch === data.branches[0] ? ", " + data.why : "");
        putHandle(main);
        showRow(branch, now);
    }
    function layOut() {
        for (const panel of panels)
            panel.layOut();
        show(now);
    }
    const branchNow = () => Math.max(0, data.branches.findIndex((x) => x.name === branch.name));
    function choose(k) {
        branch = data.branches[k];
        panels.forEach((panel, j) => panel.take(branch.panels[j], data.steps.length));
        show(now);
    }
    /* Take other numbers while something is dragged: of the branch that is shown, the mechanism alone, at a row; false if
    ** it is another mechanism. */
    function updateBriefly(next, row) {
        const [only] = next.branches;
        if (head(next) !== head(data) || only.panels[0].title !== main.title)
            return false;
        isBrief = true;
        Object.assign(data, {...next, branches: data.branches});
        branch = only;
        main.take(only.panels[0], data.steps.length);
        show(row);
        return true;
    }
    /* Take other numbers of the same mechanism; false if it is another one. */
    function update(next) {
        const k = branchNow();
        if (structure(next) !== structure(data))
            return false;
        isBrief = false;
        Object.assign(data, next);
        choose(k);
        return true;
    }
    choose(0);
    return {panels, show, choose, layOut, update, updateBriefly, name, row: () => now, branch: branchNow,
            reason: (i) => branch.reasons[i] || "",
            main: {panel: main, handle: main.handle, place: (name) => main.place(name), pixel: main.pixel,
                   rowAt: (at) => main.rowAt(at, data.steps.length), planeOf: (at) => main.planeOf(at, data.turn),
                   sheetOf: (p) => main.sheetOf(p, data.turn)}};
}

return draw;
}());
