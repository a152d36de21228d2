/* SPDX-License-Identifier: GPL-3.0-or-later
**
** curve.js - columns over another as curves: a diagram for each unit.
*/
web.curve = function (place, go) {

const {html, svg, htmlLabel, unitText, withUnit, makePanel, begin, end, measure, line, circle, text, pairs, roundUp} = fourlink;
let curves = [], x = null, over = [0, 1], diagrams = [], row = 0, branch = 0;

const finite = (list) => list.filter((u) => typeof u === "number");
const isPoint = (u, v) => typeof u === "number" && typeof v === "number";
const shown = (value) => String(Number(value.toPrecision(4))).replace("-", "\u2212");

/* An angle goes on beyond 180 degrees, as its extremes do. */
function unwound(list, unit) {
    const turn = {deg: 360, rad: 2 * Math.PI}[unit];
    let before = null;
    return !turn ? list : list.map((v) => {
        if (typeof v !== "number")
            return v;
        before = before === null ? v : v - turn * Math.round((v - before) / turn);
        return before;
    });
}

/* Round values that divide a range into about `count` parts; degrees in parts of a turn. */
function ticksOf(low, high, count, isDegrees) {
    const least = (high - low) / count, parts = [5, 10, 15, 30, 45, 60, 90, 180, 360], list = [];
    const step = isDegrees && least > 2 && least <= 360 ? parts.find((part) => part >= least) : roundUp(least);
    for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++)
        list.push(Number((k * step).toPrecision(12)));
    return list;
}

function rangeOf(columns) {
    const list = curves.flatMap((curve) => columns.flatMap((j) => finite(curve.columns[j])));
    let low = list.reduce((a, b) => Math.min(a, b), Infinity), high = list.reduce((a, b) => Math.max(a, b), -Infinity);
    if (!(low <= high))
        [low, high] = [0, 1];
    const rest = high > low ? 0 : Math.abs(low) / 2 || 1;
    return [low - rest, high + rest];
}

/* The axis of x, or that of y with `isUp`: lines, numbers, and the function that gives pixels. */
function axis(panel, range, unit, isUp) {
    const [low, high] = range, ends = isUp ? [panel.height - 44, 22] : [74, panel.width - 18];
    const at = (u) => ends[0] + (u - low) / (high - low) * (ends[1] - ends[0]);
    for (const u of ticksOf(low, high, isUp ? panel.height / 60 : panel.width / 90, unit === "deg")) {
        const p = at(u);
        panel.ink.append(svg("polyline", {class: "grid", points: pairs(isUp ? [[74, p], [panel.width - 18, p]]
                                                                         : [[p, panel.height - 44], [p, 22]])}),
                         svg("text", isUp ? {x: 68, y: p + 4, class: "small right"} : {x: p, y: panel.height - 28, class: "small middle"},
                             String(u).replace("-", "\u2212")));
    }
    return at;
}

/* A name with its unit at an axis. */
function nameAxis(panel, columns, attributes) {
    const made = svg("text", attributes), unit = unitText(columns[0].unit);
    columns.forEach((c, k) => {
        made.append(k ? ", " : "", svg("tspan", {class: c.label[1] || c.label[0].length === 1 ? "variable" : null}, c.label[0]));
        if (c.label[1])
            made.append(svg("tspan", {dy: 4, class: "small"}, c.label[1]), svg("tspan", {dy: -4}, "\u200a"));
    });
    made.append(unit ? " (" + unit + ")" : "");
    panel.ink.append(made);
}

/* The rows of the largest and of the smallest value of a column on the branch that is shown. */
function extremesOf(j) {
    const list = curves[branch] ? curves[branch].columns[j] : [], rows = list.map((v, i) => i).filter((i) => typeof list[i] === "number");
    const most = (better) => rows.reduce((best, i) => best < 0 || better(list[i], list[best]) ? i : best, -1);
    return [most((a, b) => a > b), most((a, b) => a < b)].filter((i, k, both) => i >= 0 && (k === 0 || list[i] !== list[both[0]]));
}

function put(diagram) {
    const {panel, columns} = diagram;
    begin(panel, columns.map((c) => c.name).join(", ") + " over " + x.name);
    measure(panel);
    const u = axis(panel, over, x.unit, false), v = axis(panel, rangeOf(columns.map((c) => c.at)), columns[0].unit, true);
    diagram.view = {u, v};
    nameAxis(panel, [x], {x: panel.width - 18, y: panel.height - 8, class: "right"});
    nameAxis(panel, columns, {x: 8, y: 14});
    panel.boxes.push([0, 0, 200, 20], [0, panel.height - 38, panel.width, panel.height]); /* names and numbers of the axes */
    for (const column of columns)
        curves.forEach((curve, k) => {
            let way = "", broken = true;
            curve.columns[0].forEach((p, i) => {
                const q = curve.columns[column.at][i], there = isPoint(p, q);
                way += there ? (broken ? "M" : "L") + pairs([[u(p), v(q)]]) : "";
                if (there && k === branch)
                    panel.dots.push([u(p), v(q)]);
                broken = !there;
            });
            panel.ink.append(svg("path", {class: k === branch ? "curve path" + column.pen : "curve other", d: way || "M0,0"}));
        });
    columns.forEach((column, k) => {
        const list = curves[branch] ? curves[branch].columns : [], rows = extremesOf(column.at);
        const words = rows.map((i) => shown(list[column.at][i]) + " at " + withUnit(shown(list[0][i]), x.unit));
        diagram.words[k].textContent = rows.length > 1 ? "largest " + words[0] + ", smallest " + words[1] : words.length ? words[0] : "no value";
        rows.forEach((i, isLeast) => {
            const at = [u(list[0][i]), v(list[column.at][i])];
            circle(panel, "dot", at, 3.5, "extreme");
            text(panel, at, [0, isLeast ? 1 : -1], [shown(list[column.at][i]), "", ""], 5, "small");
        });
    });
    end(panel);
    for (const column of columns) {
        const now = curves[branch] && [0, column.at].map((j) => curves[branch].columns[j][row]);
        if (now && isPoint(...now))
            circle(panel, "here", [u(now[0]), v(now[1])], 5, "here");
    }
}

function draw() {
    diagrams.forEach(put);
}

/* The row whose point is nearest to a place. */
function follow(diagram, event) {
    const box = diagram.panel.drawing.getBoundingClientRect(), curve = curves[branch], {u, v} = diagram.view;
    const at = [event.clientX - box.left, event.clientY - box.top];
    let best = -1, least = Infinity;
    for (const column of diagram.columns)
        for (let i = 0; curve && i < curve.columns[0].length; i++) {
            const [p, q] = [curve.columns[0][i], curve.columns[column.at][i]];
            const far = isPoint(p, q) ? Math.hypot(u(p) - at[0], v(q) - at[1]) : Infinity;
            if (far < least)
                [best, least] = [i, far];
        }
    if (best >= 0)
        go(best);
}

/* A diagram of columns with one unit. */
function diagramOf(columns) {
    const panel = makePanel("Curves of " + columns.map((c) => c.name).join(", "), "whole"), sheet = panel.drawing;
    const diagram = {panel, columns, words: [], view: null};
    panel.figure.querySelector("figcaption").remove();
    for (const column of columns) {
        const words = html("span", {class: "number"});
        panel.list.append(html("li", {title: column.meaning}, html("span", {class: "swatch path" + column.pen}), htmlLabel(column.label), ": ", words));
        diagram.words.push(words);
    }
    sheet.addEventListener("pointerdown", (event) => {
        sheet.setPointerCapture(event.pointerId);
        follow(diagram, event);
    });
    sheet.addEventListener("pointermove", (event) => {
        if (event.buttons)
            follow(diagram, event);
    });
    return diagram;
}

return {
    draw,
    /* Curves of each branch, their first column over which the others are drawn. */
    take(list, xColumn, yColumns) {
        const groups = new Map();
        const units = [xColumn, ...yColumns].map((column) => column.unit);
        curves = list.map((curve) => ({...curve, columns: curve.columns.map((values, j) => unwound(values, units[j]))}));
        x = xColumn;
        over = rangeOf([0]);
        yColumns.forEach((column, k) => groups.set(column.unit, (groups.get(column.unit) || []).concat({...column, at: k + 1, pen: k})));
        diagrams = [...groups.values()].map(diagramOf);
        place.className = diagrams.length > 1 ? "several" : "";
        place.replaceChildren(...diagrams.map((diagram) => diagram.panel.figure));
        draw();
    },
    show(i, k) {
        row = i;
        branch = k;
        draw();
    }
};
};
