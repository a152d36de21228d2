/* SPDX-License-Identifier: GPL-3.0-or-later
**
** handles.js - pins, centres of mass, tracer points, places of loads, and what a [synthesis] wants, to be dragged: each changes
** numbers of the deck.
**
** A handle knows where it is, the settings of the text that it changes, and how a place in the plane of the mechanism becomes
** their values, in the drawing's unit of length.  `goAsDrawn` shows the position in which [pins] are given.
*/
web.handles = function (editor, ask, goAsDrawn) {

const {svg} = fourlink;
const add = (p, q) => [p[0] + q[0], p[1] + q[1]], minus = (p, q) => [p[0] - q[0], p[1] - q[1]];
const times = (k, p) => [k * p[0], k * p[1]], size = (p) => Math.hypot(p[0], p[1]);
const group = svg("g", {class: "handles"});
let on = false, data = null, drawing = null, factors = {lengths: new Map(), angles: new Map()}, handles = [], held = null;

const dot = (p, q) => p[0] * q[0] + p[1] * q[1];
const turned = (p, angle) => [Math.cos(angle) * p[0] - Math.sin(angle) * p[1], Math.sin(angle) * p[0] + Math.cos(angle) * p[1]];

/* Of a pin or point, in the frame of link 1; null where the linkage cannot be assembled. */
function planeOf(name) {
    const at = drawing.main.place(name);
    return at && drawing.main.planeOf(at);
}

/* ------------------------------------------------------------------------------------- which numbers, what values */

const section = (link) => data.links[link - 2].name;

/* A length of a link, or half its stroke. */
function lengthOf(link, value) {
    return [{section: section(link), key: "length", value}, {section: section(link), key: "stroke", value: (p) => 2 * value(p)}];
}

function pins() {
    const list = [], A = () => planeOf("A"), B = () => planeOf("B"), D = () => planeOf("D");
    const along = (p) => dot(minus(p, A()), times(1 / size(minus(B(), A())), minus(B(), A())));
    list.push({at: "B", words: "pin B", settings: lengthOf(2, along)});
    const shape = data.links[2].shape;
    if (shape === "yoke") {
        list.push({at: "C", words: "C, on the guide", settings: [{section: "ground", key: "offset", value: (p) => p[1]}]});
    } else if (shape !== "lever") {
        const slides = shape === "block";
        const onStroke = (p) => editor.text && web.text.find(editor.text(), "ground", "offset") ? p : [p[0], planeOf("C")[1]];
        list.push({at: "C", words: "pin C", settings: slides
            ? lengthOf(3, (p) => size(minus(onStroke(p), B()))).concat({section: "ground", key: "offset", value: (p) => p[1]})
            : lengthOf(3, (p) => size(minus(p, B()))).concat(lengthOf(4, (p) => size(minus(p, D()))))});
    }
    if (planeOf("D"))
        list.push({at: "D", words: "pin D", settings: [{section: "ground", key: "length", value: (p) => p[0] - A()[0]}]});
    return list;
}

/* Points of links; their settings have coordinates in the link's own axes. */
function points() {
    const centres = data.links.filter((link) => link.centre).map((link) => (
        {at: link.centre, words: "centre of mass of the " + link.name, link, settings: [{section: link.name, key: "cg"}]}));
    const tracers = data.points.map((p) => (
        {at: p.of, words: "point " + p.label[0], link: data.links.find((link) => link.points.includes(p.of)),
         settings: [{section: "point " + p.label[0], key: "at"}]}));
    return centres.concat(tracers);
}

/* A handle where nothing is drawn that has a name: the place follows from its numbers and the axes that `frame` finds. */
function inAxes(handle, link, frame) {
    const where = () => {
        const [found] = present(editor.text(), handle), axes = planeOf("A") && found && frame();
        const local = axes && localOf(editor.text(), found.numbers, link); /* NaN: a unit of a new text is not known yet */
        return axes && Number.isFinite(size(local)) ? drawing.main.sheetOf(add(axes.origin, turned(local, axes.angle))) : null;
    };
    return Object.assign(handle, {link, frame, where});
}

/* Where loads act. */
function loads() {
    const text = editor.text();
    return web.text.sections(text).filter((name) => /^load\b/i.test(name)).map((name) => {
        const on = web.text.linkMeant(web.text.value(text, name, "link") || "");
        const link = data.links.find((x) => x.name === on && x.shape !== "block");
        return inAxes({id: name, words: "where " + name + " acts", settings: [{section: name, key: "at"}]}, link, () => axesOf(link));
    }).filter((handle) => handle.link);
}

/* What a [synthesis] wants: positions and pivots, in its own axes. */
function targets() {
    if (!data.wanted)
        return [];
    const frame = () => ({angle: -data.wanted.direction, origin: turned(times(-1, data.wanted.origin), -data.wanted.direction)});
    const inTask = (at, words, key, index) => ({at, words, link: {}, frame, settings: [{section: "synthesis", key, index}]});
    const isFixed = (key) => /^fixed/.test(web.text.value(editor.text(), "synthesis", key) || "");
    return web.text.pairs(editor.text(), "synthesis", "positions").map((_, k) => inTask("wanted " + (k + 1), "wanted position " + (k + 1), "positions", k))
        .concat([["A", "left"], ["D", "right"]].filter(([, key]) => isFixed(key)).map(([at, key]) => inTask(at, "pivot " + at, key, 0)));
}

/* What stands in the axes of a page: the places of [pins], and those of points and loads as drawn. */
function onPage() {
    if (!data.page)
        return [];
    const frame = () => ({angle: -data.page.direction, origin: turned(times(-1, data.page.A), -data.page.direction)});
    const make = (id, words, section, key, index) => inAxes({id, words, isOnPage: true, settings: [{section, key, index}]}, {}, frame);
    const pins = ["A", "B", "C", "D"].map((pin) => make(pin, "pin " + pin, "pins", pin));
    const guide = [0, 1].map((k) => make("guide " + (k + 1), "the guide", "pins", "guide", k));
    const places = web.text.sections(editor.text()).flatMap((section) => ["place", "to_place", "cg_place"].map((key) => (
        make(section + " " + key, key + " of " + section, section, key))));
    return [...pins, ...guide, ...places];
}

/* The origin of a link's own axes, and the direction of its x axis where the point does not show it. */
function axesOf(link) {
    const pin = link.link === 2 ? "A" : link.link === 3 ? "B" : link.shape === "block" || link.shape === "yoke" ? "C" : "D";
    const [from, to] = link.shape === "bar" ? [pin, link.pins.find((x) => x !== pin)] : ["S1", "S2"];
    const u = link.shape !== "yoke" && planeOf(from) && planeOf(to) ? minus(planeOf(to), planeOf(from)) : [1, 0];
    return {origin: planeOf(pin), angle: Math.atan2(u[1], u[0])};
}

/* ------------------------------------------------------------------------------------------------ the numbers */

const LENGTH = "lengths", ANGLE = "angles";
const kindOf = (number) => number.name === "angle" ? ANGLE : LENGTH;

/* The size of the unit of a number, in the drawing's unit of length or in rad; undefined: it cannot be changed. */
function factorOf(number) {
    if (number.name === "share")
        return 1;
    const kind = kindOf(number), si = factors[kind].get("1" + number.unit);
    return kind === ANGLE ? si : si && si / factors[LENGTH].get("1 " + data.units.length);
}

/* The numbers of the settings of a handle that stand in the text: [{setting, numbers}]. */
function present(text, handle) {
    const numbersOf = ({section, key, index}) => index === undefined ? web.text.numbers(text, section, key)
        : web.text.pairs(text, section, key)[index];
    return handle.settings.map((setting) => ({setting, numbers: numbersOf(setting)}))
        .filter((x) => x.numbers && (x.numbers[0].name !== "share" || handle.link.shape === "bar"));
}

function localOf(text, numbers, link) {
    if (numbers[0].name === "share")
        return [numbers[0].value / 100 * lengthNow(link), 0];
    const value = (name) => {
        const number = numbers.find((x) => x.name === name);
        return number ? web.text.read(text, number) * factorOf(number) : 0;
    };
    return numbers[0].name === "x" ? [value("x"), value("y")]
        : [value("r") * Math.cos(value("angle")), value("r") * Math.sin(value("angle"))];
}

/* The length of a bar, between its pins. */
const lengthNow = (link) => size(minus(planeOf(link.pins[1]), planeOf(link.pins[0])));

/* Where a point is in its link: the axes that take its own coordinates to its place. */
function frameOf(text, handle, numbers) {
    if (handle.frame)
        return handle.frame();
    const axes = axesOf(handle.link), local = localOf(text, numbers, handle.link), g = minus(planeOf(handle.at), axes.origin);
    if (size(local) > 1e-9 * size(g) && size(g) > 0)
        axes.angle = Math.atan2(g[1], g[0]) - Math.atan2(local[1], local[0]);
    return axes;
}

/* The values of numbers for a place in a link's own axes. */
function valuesOf(numbers, p, text, link) {
    if (numbers[0].name === "share")
        return {share: 100 * p[0] / lengthNow(link)};
    if (numbers[0].name === "x")
        return {x: p[0], y: p[1]};
    if (numbers.length === 1)
        return {r: p[0]};
    const sign = web.text.read(text, numbers[0]) < 0 ? -1 : 1;
    return {r: sign * size(p), angle: Math.atan2(sign * p[1], sign * p[0])};
}

/* The text with the numbers for a place `p` in the plane; rounded to what one sees. */
function changed(text, handle, frame, p) {
    const pixel = drawing.main.pixel(), changes = [];
    for (const {setting, numbers} of present(text, handle)) {
        const local = frame && turned(minus(p, frame.origin), -frame.angle);
        const values = handle.link ? valuesOf(numbers, local, text, handle.link) : {r: setting.value(p)};
        for (const number of numbers) {
            const factor = factorOf(number);
            if (number.name === "share") {
                changes.push([number, web.text.rounded(values.share, 100 * pixel / lengthNow(handle.link)) + " %"]);
                continue;
            }
            const step = (number.name === "angle" ? pixel / Math.max(size(local), pixel) : pixel) / factor;
            let value = values[number.name] / factor;
            if (/^(length|stroke)$/.test(setting.key))
                value = Math.max(value, step);
            if (factor && Number.isFinite(value))
                changes.push([number, web.text.rounded(value, step)]);
        }
    }
    return web.text.replace(text, changes);
}

/* ------------------------------------------------------------------------------------------------ to drag them */

const nameOf = (handle) => handle.id || handle.at;
const placeOf = (handle) => handle.where ? handle.where() : drawing.main.place(handle.at);

function place(handle) {
    const at = placeOf(handle);
    handle.mark.style.display = at ? "" : "none";
    if (at)
        for (const part of handle.mark.children) {
            part.setAttribute("cx", at[0]);
            part.setAttribute("cy", at[1]);
        }
}

/* Returns what tells the axes while the handle is pulled: a page stays, whatever becomes of link 1. */
function begin(handle) {
    const found = present(editor.text(), handle);
    editor.close();
    if (handle.isOnPage) {
        goAsDrawn();
        return handle.frame;
    }
    const frame = handle.link && found.length ? frameOf(editor.text(), handle, found[0].numbers) : null;
    return () => frame;
}

function pull(handle, frame, at) {
    editor.put(changed(editor.text(), handle, frame(), drawing.main.planeOf(at)), "drag");
}

function listen(handle) {
    const sheet = drawing.main.panel.drawing;
    handle.mark.addEventListener("pointerdown", (event) => {
        event.stopPropagation();
        handle.mark.focus();
        held = {id: event.pointerId, handle, frame: begin(handle)};
        fourlink.hold(event, sheet);
    });
    handle.mark.addEventListener("keydown", (event) => {
        const far = event.shiftKey ? 10 : 1;
        const way = {ArrowLeft: [-far, 0], ArrowRight: [far, 0], ArrowUp: [0, -far], ArrowDown: [0, far]}[event.key];
        const at = placeOf(handle);
        if (!way || !at || event.ctrlKey || event.metaKey || event.altKey)
            return;
        event.preventDefault();
        pull(handle, begin(handle), add(at, way));
    });
}

function follow(event) {
    if (!held || event.pointerId !== held.id)
        return;
    pull(held.handle, held.frame, fourlink.placeOf(event, drawing.main.panel.drawing));
}

function release(event) {
    if (!held || event.pointerId !== held.id)
        return;
    held = null;
    editor.close();
    released();
}
let released = () => {};

const everything = () => [...pins(), ...points(), ...loads(), ...targets(), ...onPage()];

function make() {
    group.replaceChildren();
    if (drawing)
        drawing.main.panel.drawing.setAttribute("role", on ? "group" : "img"); /* what is in an image cannot be focused */
    handles = on && data ? everything() : [];
    handles = handles.filter((handle) => {
        const found = present(editor.text(), handle);
        return found.length && found.some((x) => x.numbers.every(factorOf));
    });
    const isFirst = (handle, k) => handles.findIndex((x) => nameOf(x) === nameOf(handle)) === k; /* lengths before a rough drawing */
    handles = handles.filter(isFirst);
    for (const handle of handles) {
        const names = present(editor.text(), handle).map((x) => x.setting.section + "." + x.setting.key).join(", ");
        handle.mark = svg("g", {class: "knob", tabindex: 0, role: "button", "data-knob": nameOf(handle),
                                "aria-label": "Move " + handle.words + ": changes " + names + "; arrow keys move it"},
                          svg("circle", {r: 17, class: "reach"}), svg("circle", {r: 8, class: "ring"}));
        group.append(handle.mark);
        listen(handle);
        place(handle);
    }
}

/* Learn the units of all numbers that a handle may change, then show the handles. */
async function prepare() {
    const text = editor.text(), wanted = {lengths: new Set(), angles: new Set()};
    if (!on || !data)
        return make();
    wanted.lengths.add("1 " + data.units.length);
    for (const handle of everything())
        for (const {numbers} of present(text, handle))
            numbers.filter((number) => number.name !== "share").forEach((number) => wanted[kindOf(number)].add("1" + number.unit));
    const lists = {lengths: [...wanted.lengths], angles: [...wanted.angles]};
    try {
        const answer = await ask("quantities", lists);
        for (const kind of [LENGTH, ANGLE])
            factors[kind] = new Map(lists[kind].map((words, k) => [words, answer[kind][k] || undefined]));
    } catch (error) {
        return;
    }
    make();
}

return {
    /* A drawing, new or with other numbers. */
    take(newData, newDrawing) {
        const sheet = newDrawing.main.panel.drawing;
        data = newData;
        if (drawing !== newDrawing) {
            drawing = newDrawing;
            sheet.append(group);
            sheet.addEventListener("pointermove", follow);
            sheet.addEventListener("pointerup", release);
            sheet.addEventListener("pointercancel", release);
        }
        if (!held && !group.contains(document.activeElement))
            prepare();
    },
    show() {
        handles.forEach(place);
    },
    set(is) {
        on = is;
        prepare();
    },
    isHeld: () => held !== null,
    onRelease(call) { released = call; }
};
};
