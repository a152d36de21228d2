/* SPDX-License-Identifier: GPL-3.0-or-later
**
** curve.js - a column over another as a curve.
*/
web.curve = function (place, go) {

const {svg, unitText, makePanel, begin, measure, line, circle, pairs, roundUp} = fourlink;
const panel = makePanel("Curve", "whole");
let curves = [], names = ["", ""], row = 0, branch = 0, view = null;
place.append(panel.figure);
panel.figure.querySelector("figcaption").remove();
panel.list.remove();
begin(panel, "none yet");

const finite = (list) => list.filter((x) => typeof x === "number");

/* Round values that divide a range into about `count` parts; degrees in parts of a turn. */
function ticksOf(low, high, count, isDegrees) {
    const least = (high - low) / count, parts = [5, 10, 15, 30, 45, 60, 90, 180, 360], list = [];
    const step = isDegrees && least > 2 && least <= 360 ? parts.find((x) => x >= least) : roundUp(least);
    for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++)
        list.push(Number((k * step).toPrecision(12)));
    return list;
}

function rangeOf(j) {
    const list = curves.flatMap((curve) => finite(curve.columns[j]));
    let low = list.reduce((a, b) => Math.min(a, b), Infinity), high = list.reduce((a, b) => Math.max(a, b), -Infinity);
    if (!(low <= high))
        [low, high] = [0, 1];
    const rest = high > low ? 0 : Math.abs(low) / 2 || 1;
    return [low - rest, high + rest];
}

function axis(j) {
    const [low, high] = rangeOf(j), edge = j ? [panel.height - 44, 22] : [74, panel.width - 18];
    const at = (x) => edge[0] + (x - low) / (high - low) * (edge[1] - edge[0]);
    const ticks = ticksOf(low, high, j ? panel.height / 60 : panel.width / 90, /\(deg\)$/.test(names[j]));
    for (const x of ticks) {
        const p = at(x);
        line(panel, "grid", ...(j ? [[74, p], [panel.width - 18, p]] : [[p, panel.height - 44], [p, 22]]));
        panel.ink.append(svg("text", j ? {x: 68, y: p + 4, class: "small right"} : {x: p, y: panel.height - 28, class: "small middle"},
                             String(x).replace("-", "\u2212")));
    }
    return at;
}

function draw() {
    begin(panel, names[1] + " over " + names[0]);
    measure(panel);
    if (!curves.length)
        return;
    const x = axis(0), y = axis(1);
    view = {x, y};
    panel.ink.append(svg("text", {x: panel.width - 18, y: panel.height - 8, class: "right"}, names[0]));
    panel.ink.append(svg("text", {x: 8, y: 16}, names[1]));
    curves.forEach((curve, k) => {
        let way = "", broken = true;
        curve.columns[0].forEach((u, i) => {
            const v = curve.columns[1][i], there = typeof u === "number" && typeof v === "number";
            way += there ? (broken ? "M" : "L") + pairs([[x(u), y(v)]]) : "";
            broken = !there;
        });
        panel.ink.append(svg("path", {class: k === branch ? "curve" : "curve other", d: way || "M0,0"}));
    });
    const now = curves[branch] && curves[branch].columns.map((list) => list[row]);
    if (now && now.every((u) => typeof u === "number"))
        circle(panel, "here", [x(now[0]), y(now[1])], 5, "here");
}

/* The row whose point is nearest to a place. */
function follow(event) {
    const box = panel.drawing.getBoundingClientRect(), curve = curves[branch];
    const at = [event.clientX - box.left, event.clientY - box.top];
    let best = -1, least = Infinity;
    for (let i = 0; curve && i < curve.columns[0].length; i++) {
        const [u, v] = curve.columns.map((list) => list[i]);
        const far = typeof u === "number" && typeof v === "number" ? Math.hypot(view.x(u) - at[0], view.y(v) - at[1]) : Infinity;
        if (far < least)
            [best, least] = [i, far];
    }
    if (best >= 0)
        go(best);
}
panel.drawing.addEventListener("pointerdown", (event) => {
    panel.drawing.setPointerCapture(event.pointerId);
    follow(event);
});
panel.drawing.addEventListener("pointermove", (event) => {
    if (event.buttons)
        follow(event);
});

return {
    draw,
    take(list, x, y) {
        const label = (c) => c.name + (unitText(c.unit) ? " (" + unitText(c.unit) + ")" : "");
        curves = list;
        names = [label(x), label(y)];
        draw();
    },
    show(i, k) {
        row = i;
        branch = k;
        draw();
    }
};
};
