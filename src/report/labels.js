/* SPDX-License-Identifier: GPL-3.0-or-later
**
** labels.js - where the labels of a moving drawing stand: near their places, on no line and on no other label.
**
** A label is tried around its place in SIDES directions, of which the first leads away from the place behind it, each at RINGS
** distances up to two widths of an arrow.  It keeps its side while that is free; then it takes the one that stays free longest
** in the steps to come.  A label for which there is no room, or none on its side, is placed before the others; one without room is left out if that does
** not help.
**
** All lengths are those of the sheet: when the page makes it narrower, texts become larger in it.
*/
fourlink.labels = (function () {

const SIDES = 36, RINGS = [0.1, 0.3, 0.5, 0.7, 0.95];
const AHEAD = 16, TURN = 8, POOR = 12; /* steps that are looked at; by so many a side must be better for each of SIDES farther, or if poor */
const TRIES = 8, FEWER = 3, APART = 1; /* for labels without room, and for those that jump; pixels between two labels */
const JUMP = 4.5, MOST_LABELS = 100; /* a side that is so many of SIDES farther; one label left out is worse than all jumps */

/* Whether a line, [x, y, x, y, half its width], goes through a box, by its middle and half its sides. */
function crosses([x1, y1, x2, y2, half], box) {
    const {x, y} = box, w = box.w + half, h = box.h + half, dx = x2 - x1, dy = y2 - y1;
    if (x1 <= x - w && x2 <= x - w || x1 >= x + w && x2 >= x + w || y1 <= y - h && y2 <= y - h || y1 >= y + h && y2 >= y + h)
        return false;
    /* if it does not, all corners of the box are on one side of it */
    return Math.abs(dx * (y - y1) - dy * (x - x1)) < Math.abs(dx) * h + Math.abs(dy) * w;
}

/* The labels of a drawing, each {name, at, behind, radius, rank}: the numbers of two places, how far from the first it begins, and
** who comes first; before it is placed it gets w and h, half its sides.  From the labels `before` those of the same names have
** their sides. */
function make(labels, before) {
    const sides = labels.map(({name}, k) => before && before.labels[k] && before.labels[k].name === name ? before.sides[k] : null);
    const order = labels.map((label, k) => k).sort((j, k) => labels[j].rank - labels[k].rank || j - k);
    let frame = null, kept = new Map();

    /* The box of a label on one of its sides, which are numbered ring by ring. */
    function boxOf(k, side, {places}) {
        const {at, behind, radius, w, h} = labels[k], [x, y] = places[at], [p, q] = places[behind];
        const angle = Math.atan2(y - q, x - p) + 2 * Math.PI * side / SIDES, c = Math.cos(angle), s = Math.sin(angle);
        const gap = radius + frame.reach * RINGS[Math.floor(side / SIDES)], most = Math.max(Math.abs(c), Math.abs(s));
        let way = [(w + gap) * Math.abs(c) / most - w, (h + gap) * Math.abs(s) / most - h];
        if (way[0] > 0 && way[1] > 0) { /* the box has a corner nearest to the place */
            const far = Math.hypot(...way);
            way = way.map((z) => z * gap / far);
        }
        return {x: x + Math.sign(c) * (w + way[0]), y: y + Math.sign(s) * (h + way[1]), w, h};
    }
    /* Of the lines of a scene those that are near a label. */
    function linesNear(k, scene) {
        if (!scene.near[k]) {
            const {at, radius, w, h} = labels[k], [x, y] = scene.places[at], far = radius + frame.reach;
            const area = {x, y, w: far + 2 * w, h: far + 2 * h}, isNear = (line) => crosses(line, area);
            scene.near[k] = {lines: scene.lines.filter(isNear), curves: scene.curves.filter(isNear)};
        }
        return scene.near[k];
    }
    function isFree(k, box, scene) {
        return box.x - box.w >= frame.left && box.x + box.w <= frame.right && box.y - box.h >= frame.top && box.y + box.h <= frame.bottom &&
            !linesNear(k, scene).lines.some((line) => crosses(line, box));
    }
    /* Whether a box is on the path of a point, or nearer to the place of another label than to its own. */
    function isPoor(k, box, scene) {
        const far = ([x, y]) => Math.hypot(Math.max(0, Math.abs(x - box.x) - box.w), Math.max(0, Math.abs(y - box.y) - box.h));
        const {at, radius} = labels[k], own = Math.max(0, far(scene.places[at]) - radius);
        return linesNear(k, scene).curves.some((line) => crosses(line, box)) ||
            order.some((j) => labels[j].at !== at && scene.isThere(j) && far(scene.places[labels[j].at]) - labels[j].radius < own);
    }
    const touches = (a, b) => Math.abs(a.x - b.x) < a.w + b.w + APART * frame.pixel && Math.abs(a.y - b.y) < a.h + b.h + APART * frame.pixel;
    const isApart = (box, others) => !others.some((other) => touches(box, other));

    /* The free sides of a label: the first is the one nearest to its present side, or to where it begins. */
    function freeOf(k, scene) {
        const first = (sides[k] || 0) % SIDES, list = [];
        for (let side = 0; side < SIDES * RINGS.length; side++) {
            const box = boxOf(k, side, scene), turn = Math.abs((side - first + 1.5 * SIDES) % SIDES - SIDES / 2);
            if (isFree(k, box, scene))
                list.push({side, box, far: turn + Math.floor(side / SIDES) / 10, isPoor: isPoor(k, box, scene), stays: 0});
        }
        return list.sort((p, q) => p.far - q.far);
    }
    /* Where the other labels are in a scene, if they keep their sides. */
    function othersOf(k, scene) {
        if (!kept.has(scene))
            kept.set(scene, order.filter((j) => sides[j] !== null && scene.isThere(j)).map((j) => ({j, box: boxOf(j, sides[j], scene)})));
        return kept.get(scene).filter(({j}) => j !== k).map(({box}) => box);
    }
    /* For how many steps a side stays free. */
    function stays(k, side, later) {
        let n = 1;
        for (let scene; n < AHEAD && (scene = later(n)); n++) {
            const box = scene.isThere(k) && boxOf(k, side, scene);
            if (!box || !isFree(k, box, scene) || !isApart(box, othersOf(k, scene)))
                return n;
        }
        return AHEAD;
    }
    /* Of the free sides that are on no other label, the one that stays free longest, if it is not poor or far from that before. */
    function choose(k, free, taken, later) {
        let best = null, most = -Infinity;
        for (const one of free) {
            if (!isApart(one.box, taken))
                continue;
            one.stays = one.stays || (sides[k] === null ? AHEAD : stays(k, one.side, later));
            const value = one.stays - TURN * one.far - (one.isPoor ? POOR : 0);
            if (value > most)
                [best, most] = [one, value];
        }
        return best;
    }
    /* Place labels, some before all others, then those that keep their sides; returns sides by label, who is left out and who
       jumps. */
    function attempt(here, before, free, scene, later) {
        const put = new Map(), taken = [...scene.texts], out = [], jumped = [];
        const take = (k, one) => {
            put.set(k, one);
            taken.push(one.box);
        };
        function find(k) {
            if (!free.has(k))
                free.set(k, freeOf(k, scene));
            const one = choose(k, free.get(k), taken, later);
            if (!one) {
                out.push(k);
                return;
            }
            take(k, one);
            if (sides[k] !== null && one.far > JUMP)
                jumped.push(k);
        }
        function cannotStay(k) {
            const box = sides[k] !== null && boxOf(k, sides[k], scene);
            if (!box || !isFree(k, box, scene) || !isApart(box, taken))
                return true;
            take(k, {side: sides[k], box});
            return false;
        }
        before.forEach(find);
        here.filter((k) => !before.includes(k)).filter(cannotStay).forEach(find);
        return {put, out, jumped, cost: MOST_LABELS * out.length + jumped.length};
    }
    /* Place the labels of a scene, {places, lines, curves, texts, near, isThere}, where `near` is [] at first; later(n) is that of the
    ** n-th step from there, or null.  The frame is {left, top, right, bottom, pixel, reach}.  Returns the boxes, by label. */
    function place(scene, later, newFrame) {
        const here = order.filter(scene.isThere), free = new Map();
        frame = newFrame;
        kept = new Map();
        const inNeed = ({out, jumped}) => [...out, ...jumped];
        let best = attempt(here, [], free, scene, later), first = inNeed(best);
        for (let n = 1; n < (best.out.length ? TRIES : FEWER) && best.cost && first.length; n++) {
            const next = attempt(here, first, free, scene, later), more = inNeed(next).filter((k) => !first.includes(k));
            if (next.cost < best.cost)
                best = next;
            first = more.length ? [...more, ...first] : [];
        }
        best.put.forEach(({side}, k) => { sides[k] = side; });
        return new Map([...best.put].map(([k, {box}]) => [k, box]));
    }
    return {labels, sides, place};
}

return {make};
}());
