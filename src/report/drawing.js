/* SPDX-License-Identifier: GPL-3.0-or-later
**
** drawing.js - the interactive drawing of a report.
**
** It does no mechanics.  The program computes rows, one for each step, and this script draws them: the
** mechanism, the polygons of velocity and acceleration, the free bodies, and the row of the table.  Of a row it
** knows tracks: a vector or a number by its name, as view/tracks.c makes them.  What is drawn from which track stands
** in the same data, from view/scene.c.
*/
fourlink.draw = (function () {

const {html, svg, withUnit, quantityText, stepText, cellText, htmlLabel, add, minus, times, size, middle, direction, hull, tracksOf,
       makePanel, begin, end, measure, line, area, circle, head, arrow, torque, text, scaleBar, fit, roundUp, usual, makeValues,
       reached, present, pairs, digits} = fourlink;

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
    panel.boxes.push([at[0] - 15, at[1] + 4, at[0] + 15, at[1] + 24]);
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

const dot = (p, q) => p[0] * q[0] + p[1] * q[1];
const apart = (p, from, u) => Math.abs(u[0] * (p[1] - from[1]) - u[1] * (p[0] - from[0]));

/* What a link carries beside its pins: tracer points, its centre of mass, the places of its loads. */
function carriedBy(data, link) {
    const loads = data.forces.filter((f) => f.on === link.link && f.pen === "load" && !f.inner).map((f) => f.at);
    return [...new Set(link.points.concat(link.centre || [], loads))].filter((name) => !link.pins.includes(name));
}

/* A lever: from its pin to its slot, and on to the points that lie beyond. */
function drawLever(panel, kind, place, slide, half, carried) {
    const from = place("S1"), to = place("S2"), D = place("D"), R = place("R"), past = 1.6 * half;
    const near = minus(from, times(past, slide)), far = add(to, times(past, slide));
    const across = times(0.62 * half, [-slide[1], slide[0]]), along = (p) => dot(minus(p, from), slide);
    const reach = carried.map(along), root = along(R) < along(near) ? R : near;
    if (carried.some((p) => apart(p, from, slide) > 2))
        area(panel, kind + " body", hull([D, near, far, ...carried]));
    area(panel, kind + " slot", [add(near, across), add(far, across), minus(far, across), minus(near, across)]);
    line(panel, kind, D, R, middle(from, to));
    if (Math.max(...reach) > along(far))
        line(panel, kind, far, add(from, times(Math.max(...reach), slide)));
    if (Math.min(...reach) < along(root))
        line(panel, kind, root, add(from, times(Math.min(...reach), slide)));
}

/* A bar between its pins, with a body where it carries something off its line or beyond its ends. */
function drawBar(panel, kind, ends, carried, hasPoints) {
    const axis = direction(minus(ends[1], ends[0])), along = (p) => dot(minus(p, ends[0]), axis);
    const all = ends.concat(carried), isBeyond = (p) => along(p) < -2 || along(p) > along(ends[1]) + 2;
    if (hasPoints || carried.some((p) => apart(p, ends[0], axis) > 2))
        area(panel, kind + " body", hull(all));
    else if (carried.some(isBeyond))
        area(panel, kind + " body", all.sort((p, q) => along(p) - along(q)));
    line(panel, kind, ...ends);
}

/* A link, its places in pixels: `place` gives that of a track. */
function drawLink(panel, link, place, half, data) {
    const kind = "link" + link.link, ends = link.pins.map(place);
    const slide = place("S1") && place("S2") ? direction(minus(place("S2"), place("S1")), [1, 0]) : [1, 0];
    const carried = carriedBy(data, link).map(place).filter((p) => p);
    if (link.shape === "slot") {
        drawLever(panel, kind, place, slide, half, carried);
    } else if (link.shape === "block") {
        if (link.points.length)
            area(panel, kind + " body", hull(ends.concat(link.points.map(place))));
        block(panel, kind + " block", ends[0], slide, half);
    } else {
        drawBar(panel, kind, ends, carried, link.points.length);
    }
}

/* The number of a link, beside its middle. */
function drawNumber(panel, link, place) {
    const [from, to] = link.pins.map(place), label = [String(link.link), "", ""];
    if (link.shape === "block")
        text(panel, from, [0.7, 0.7], label, 16, "of-link");
    else
        text(panel, link.shape === "slot" ? add(to, times(0.3, minus(from, to))) : middle(from, to),
             [from[1] - to[1], to[0] - from[0]], label, 3, "of-link");
}

/* A spring, a damper, or both side by side; a torsional spring is a spiral around its pin. */
function drawSpring(panel, spring, links, place) {
    if (spring.pin) {
        const points = [], pin = place(spring.pin);
        for (let k = 0; k <= 60; k++)
            points.push(add(pin, times(7 + 10 * k / 60, [Math.cos(k / 5), Math.sin(k / 5)])));
        line(panel, "spring", ...points);
        text(panel, add(pin, [0, 17]), [0, 1], spring.label, 3);
        return;
    }
    const [from, to] = spring.ends.map(place), along = minus(to, from);
    if (size(along) === 0)
        return;
    const across = times(7, direction([-along[1], along[0]])), side = spring.coil && spring.damper ? 1.4 : 0;
    const at = (x, y) => add(from, add(times(x, along), times(y, across)));
    const put = (y, ...points) => line(panel, "spring", ...points.map((p) => at(p[0], p[1] + y)));
    spring.on.forEach((link, k) => {
        const end = k ? to : from, body = links.find((x) => x.link === link);
        if (body && body.shape === "bar")
            line(panel, "construction", place(body.pins[0]), end, place(body.pins[1]));
        if (body)
            circle(panel, "dot", end, 3);
        else
            ground(panel, at(k, -1.2), at(k, 1.2), times(k ? 1 : -1, direction(along)));
    });
    put(0, [0, 0], [0.2, 0], [0.2, side], [0.2, -side]);
    put(0, [1, 0], [0.8, 0], [0.8, side], [0.8, -side]);
    if (spring.coil)
        put(side, [0.2, 0], ...Array.from({length: 23}, (_, k) => [0.2 + 0.6 * (k + 0.5) / 23, k % 2 ? 1 : -1]), [0.8, 0]);
    if (spring.damper) {
        put(-side, [0.2, 0], [0.3, 0]);
        put(-side, [0.7, 1], [0.3, 1], [0.3, -1], [0.7, -1]);
        put(-side, [0.55, -0.7], [0.55, 0.7]);
        put(-side, [0.55, 0], [0.8, 0]);
    }
    text(panel, at(0.5, side + 1), across, spring.label, 3);
}

/* An arrow of so few pixels would have a head and no tail. */
const isTiny = (pixels, longest) => pixels < 0.02 * longest;

/* Pixels for a unit of force: `longest` stands for 1, 2 or 5 times a power of ten, at least the largest force of the
** motion, but of row i where it has larger ones, or where all are so small that none had an arrow. */
function forceScale(forces, tracks, i, longest) {
    const largest = Math.max(0, ...forces.map((f) => size(tracks.vector(f.of, i) || [0, 0])));
    return longest / roundUp(isTiny(largest, roundUp(tracks.largest)) ? largest : Math.max(largest, tracks.largest));
}

/* The list of forces and torques beside a drawing; returns what puts their values of row i into it. */
function makeForceValues(data, panel, forces, torques) {
    const entry = (unit) => (f) => ({label: f.label, unit, kind: f.pen});
    const put = makeValues(panel, forces.map(entry(data.units.force)).concat(torques.map(entry(data.units.torque))));
    return (tracks, i, longest) => {
        const k = forceScale(forces, tracks, i, longest);
        const sizeOf = (v) => v && size(v), signed = (f, x) => x === null ? null : f.sign * x;
        forces.forEach((f, j) => {
            const v = sizeOf(tracks.vector(f.of, i));
            put[j](v, v > 0 && isTiny(k * v, longest));
        });
        torques.forEach((f, j) => put[forces.length + j](signed(f, tracks.number(f.of, i))));
    };
}

/* ----------------------------------------------------------------------------------------------- the mechanism */

const SHORT = 20; /* pixels of a crank */
const ENLARGED = 1.7; /* at least, in an inset */
const NUMBERED = 12; /* wanted positions at most */
const NARROW = 420; /* pixels of a panel that has no room for weights and numbers of links */

function mechanism(data, panel) {
    let tracks, rows, view, forces, torques, putValues, cached, now = 0;
    const handle = svg("g", {class: "handle"});
    const isOfWhole = (f) => f.sign > 0 && f.pen !== "inertia" && (!f.inner || f.spring);
    const names = data.forces.filter(isOfWhole), turning = data.torques.filter(isOfWhole);
    const places = ["A", "B", "C", "D"].concat(data.points.map((p) => p.of), ...data.springs.map((x) => x.ends || []));
    const place = (name, i) => {
        const v = tracks.vector(name, i);
        return v && add(view.origin, times(view.scale, v));
    };
    const carried = data.links.flatMap((link) => carriedBy(data, link));
    const largest = () => Math.max(9, Math.min(20, 0.04 * Math.min(panel.width, panel.height)));
    const longest = () => 0.2 * Math.min(panel.width, panel.height);
    const isNarrow = () => panel.width < NARROW;
    const isWeight = (f) => /^W\d$/.test(f.of);
    /* Half a block: one at the crank pin does not cover a short crank. */
    const atCrank = data.links.some((link) => link.shape === "slot");
    const half = () => atCrank ? Math.max(5, Math.min(largest(), 0.4 * size(minus(place("B", now), place("A", now))))) : largest();
    const wanted = () => data.wanted || [];
    panel.drawing.append(panel.ink, handle);

    /* Take a branch; `held`: of the same drawing. */
    function choose(branch, held) {
        tracks = tracksOf(data, branch);
        rows = reached(tracks);
        if (held)
            return;
        forces = present(names, tracks, rows);
        torques = present(turning, tracks, rows);
        putValues = makeForceValues(data, panel, forces, torques);
    }

    /* Find the scale at which all rows fit, with their arrows. */
    function layOut() {
        measure(panel);
        const marks = [], edge = 2.2 * largest();
        for (const i of rows.length ? rows : [0]) {
            for (const name of places.concat(carried))
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
                    marks.push([...at, ...times(forceScale(forces, tracks, i, longest()), v)]);
            }
        }
        for (const p of wanted().flatMap((position) => position.lines.flat().concat([position.mark])))
            marks.push([...tracks.turned(...p), 0, 0]);
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
            if (way && data.steps.length > 1)
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

    /* The positions for which a linkage was found by synthesis. */
    function drawWanted() {
        const at = (p) => add(view.origin, times(view.scale, tracks.turned(...p)));
        wanted().forEach((position, k) => {
            for (const points of position.lines)
                line(panel, "wanted", ...points.map(at));
            circle(panel, "wanted", at(position.mark), 5, "wanted " + (k + 1));
            if (wanted().length <= NUMBERED)
                text(panel, at(position.mark), [0.8, 0.8], [String(k + 1), "", ""], 5, "small");
        });
    }

    /* The crank angle, from the x axis. */
    function drawAngle(i) {
        const A = place("A", i), B = minus(place("B", i), A), x = tracks.x;
        const cross = x[0] * B[1] - x[1] * B[0], dot = x[0] * B[0] + x[1] * B[1];
        const radius = Math.min(30, 0.55 * size(B)), sign = data.over === "theta2" && data.steps[i] < 0 ? -1 : 1, turn = 2 * Math.PI;
        const angle = (sign * Math.atan2(-cross, dot) + turn) % turn, points = [];
        for (let k = 0; k <= 32; k++) {
            const at = Math.atan2(x[1], x[0]) - sign * angle * k / 32;
            points.push(add(A, times(radius, [Math.cos(at), Math.sin(at)])));
        }
        line(panel, "construction", A, add(A, times(radius + 14, x)));
        line(panel, "construction", ...points);
        text(panel, points[16], minus(points[16], A), ["θ", "2", ""], 1);
    }

    /* The sense in which the crank turns. */
    function drawSense(i) {
        const A = place("A", i), r = minus(place("B", i), A), v = tracks.vector("vB", i) || [0, 0];
        const turning = r[0] * v[1] - r[1] * v[0], sign = turning > 0 ? 1 : -1, points = [];
        const radius = Math.max(34, Math.min(58, 0.75 * size(r)));
        if (Math.abs(turning) <= 1e-12 * size(r) * size(v))
            return;
        for (let k = 0; k <= 19; k++) {
            const angle = Math.atan2(r[1], r[0]) + sign * (0.3 + k / 19);
            points.push(add(A, times(radius, [Math.cos(angle), Math.sin(angle)])));
        }
        line(panel, "sense", ...points);
        head(panel, "sense", points[19], direction(minus(points[19], points[16])));
        text(panel, points[10], minus(points[10], A), ["ω", "2", ""], 2);
    }

    function drawTorques(i) {
        for (const t of torques)
            if (tracks.number(t.of, i)) {
                torque(panel, t.pen, place(t.at, i), tracks.number(t.of, i), (isNarrow() ? -6 : 0) + (t.spring ? 25 : 20));
                if (!t.spring) /* the spring has the name */
                    text(panel, add(place(t.at, i), [-14, 14]), [-1, 1], t.label, 3);
            }
    }

    function drawForces(i) {
        const k = forceScale(forces, tracks, i, view.part * longest());
        let bar = scaleBar(panel, "length", 12, view.scale, data.units.length);
        for (const f of forces) {
            const v = tracks.vector(f.of, i), at = place(f.at, i);
            if (!v || isTiny(k * size(v), view.part * longest()) || (isNarrow() && isWeight(f)))
                continue;
            arrow(panel, f.pen, at, times(k, v));
            if (!f.spring)
                text(panel, add(at, times(k, v)), v, f.label, 3);
        }
        if (forces.length)
            scaleBar(panel, "pin", bar, k, data.units.force);
    }

    /* At right angles to the stroke of a piston. */
    function slideNormal(i) {
        const u = direction(minus(place("S2", i), place("S1", i)));
        return [u[1], -u[0]];
    }

    /* A crank that is too short to be seen is drawn again, enlarged, where there is room. */
    function drawInset(i) {
        const A = place("A", i), r = size(minus(place("B", i), A)), side = Math.max(90, Math.min(170, 0.38 * panel.height));
        const k = 0.28 * side / r;
        if (r >= SHORT || k < ENLARGED || tracks.reason(i))
            return;
        const corners = [[1, 0], [1, 1], [0.5, 0], [0.5, 1], [0, 1], [0.2, 0]].map((c) => (
            [6 + c[0] * (panel.width - side - 12), 6 + c[1] * (panel.height - side - 36)]));
        const box = (at) => [at[0], at[1], at[0] + side, at[1] + side];
        const inside = (at) => panel.dots.filter((p) => p[0] > at[0] && p[0] < at[0] + side && p[1] > at[1] && p[1] < at[1] + side);
        const at = corners.reduce((best, x) => inside(x).length < inside(best).length ? x : best);
        if (inside(at).length > 6)
            return;
        const heart = add(at, [side / 2, side / 2]);
        const near = (name) => place(name, i) && add(heart, times(k, minus(place(name, i), A)));
        const clip = svg("clipPath", {id: "fourlink-inset"}, svg("rect", {x: digits(at[0]), y: digits(at[1]), width: side, height: side}));
        const ink = svg("g", {"clip-path": "url(#fourlink-inset)"}), own = {ink, boxes: [], dots: []};
        const frame = svg("rect", {class: "frame", x: digits(at[0]), y: digits(at[1]), width: side, height: side});
        support(own, heart);
        for (const link of data.links.slice().reverse())
            drawLink(own, link, near, 0.4 * k * r, data);
        const towards = direction(minus(near("B"), heart)), isUp = towards[1] < 0;
        for (const [pin, out] of [["A", [towards[0] > 0 ? -1 : 1, 0]], ["B", towards]]) { /* A is beside its support */
            circle(own, "pivot", near(pin), 4.5);
            ink.append(svg("text", {x: digits(near(pin)[0] + 16 * out[0] - 5), y: digits(near(pin)[1] + 15 * out[1] + 5)},
                           svg("tspan", {class: "variable"}, pin)));
        }
        ink.append(svg("text", {x: digits(at[0] + 6), y: digits(at[1] + (isUp ? side - 7 : 16)), class: "small"},
                       quantityText(k, "1", 2) + " : 1"));
        panel.ink.append(svg("g", {class: "inset"}, clip, svg("circle", {class: "leader", cx: digits(A[0]), cy: digits(A[1]), r: digits(r + 8)}),
                             frame, ink));
        panel.boxes.push(box(at));
    }

    /* The letters at the pins, away from their links. */
    function drawLetters(i) {
        const A = place("A", i), B = place("B", i), C = place("C", i), D = place("D", i);
        const away = (p, q, r) => add(direction(minus(p, q)), direction(minus(p, r)));
        text(panel, A, C || D ? away(A, B, B) : [0, 1], ["A", "", ""], 6);
        text(panel, B, C ? away(B, A, C) : minus(B, A), ["B", "", ""], 6);
        if (C)
            text(panel, C, D ? away(C, B, D) : slideNormal(i), ["C", "", ""], D ? 6 : 0.9 * half());
        if (D)
            text(panel, D, minus(D, C || B), ["D", "", ""], 6);
        for (const p of data.points)
            if (place(p.of, i))
                text(panel, place(p.of, i), [0.8, -0.8], p.label, 4);
    }

    function drawDirections() {
        if (data.gravity) {
            arrow(panel, "load", [18, 14], [0, 36]);
            text(panel, [18, 44], [1, 0], ["g", "", ""], 6);
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
        drawWanted();
        if (reason) {
            support(panel, place("A", i));
            line(panel, "link2", place("A", i), place("B", i));
            panel.ink.append(svg("text", {x: panel.width / 2, y: 24, class: "reason"}, reason));
        } else {
            for (const link of data.links.slice().reverse()) /* the crank is on top */
                drawLink(panel, link, (track) => place(track, i), half(), data);
            for (const spring of data.springs)
                drawSpring(panel, spring, data.links, (track) => place(track, i));
            for (const link of data.links)
                if (link.centre)
                    centre(panel, place(link.centre, i));
        }
        drawAngle(i);
        drawSense(i);
        for (const pin of ["D", "A", "B", "C"])
            if (place(pin, i))
                circle(panel, "pivot", place(pin, i), 4.5, pin);
        for (const p of data.points)
            if (place(p.of, i))
                circle(panel, "dot", place(p.of, i), 3.5, p.of);
        drawTorques(i);
        drawLetters(i);
        drawForces(i);
        drawInset(i);
        if (!reason && !isNarrow())
            for (const link of data.links)
                drawNumber(panel, link, (track) => place(track, i));
        end(panel);
        drawHandle(i);
        putValues(tracks, i, view.part * longest());
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

    /* The shape of the panel: that of the machine, within limits. */
    function shape() {
        const corners = [[], []];
        for (const branch of data.branches) {
            tracks = tracksOf(data, branch);
            for (const i of reached(tracks))
                for (const name of places.concat("S1", "S2"))
                    if (tracks.vector(name, i))
                        tracks.vector(name, i).forEach((x, j) => corners[j].push(x));
        }
        const [width, height] = corners.map((list) => list.reduce((a, b) => Math.max(a, b), -Infinity) -
                                            list.reduce((a, b) => Math.min(a, b), Infinity));
        const pad = 0.4 * Math.max(width, height), ratio = (width + pad) / (height + pad);
        if (ratio > 0)
            panel.drawing.style.aspectRatio = Math.max(1.25, Math.min(2.2, ratio));
    }

    /* The same drawing of other rows: the scale stays. */
    function hold() {
        cached = paths();
    }

    /* Of a place in the drawing, in the frame of link 1; turning to and fro is the same here, since y is downwards. */
    function planeOf(at) {
        const [x, y] = times(1 / view.scale, minus(at, view.origin));
        const c = Math.cos(data.turn), s = Math.sin(data.turn);
        return [c * x - s * y, -s * x - c * y];
    }

    return {panel, shape, choose, layOut, hold, show, handle, rowAt, planeOf, place: (name) => place(name, now),
            pixel: () => 1 / view.scale};
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

    /* The middle of a polygon, which stays in the middle of the panel. */
    function heartOf(found) {
        const ends = [0, 1].map((j) => Object.values(found).map((p) => p[j]));
        return ends.map((list) => (Math.min(...list) + Math.max(...list)) / 2);
    }

    function choose(branch, held) {
        tracks = tracksOf(data, branch);
        rows = reached(tracks);
        if (held)
            return;
        put = makeValues(panel, described.sides.map((x) => ({label: x.label, unit, kind: "link" + x.pen})));
    }

    /* Find the scale of all rows; of one row alone, on paper. */
    function layOut(only) {
        const marks = [];
        measure(panel);
        const all = (rows.includes(only) ? [only] : rows).map(corners).filter((found) => found);
        const sizes = all.map((found) => Math.max(...Object.values(found).map(size)));
        const limit = usual(sizes);
        all.forEach((found, k) => {
            const heart = heartOf(found);
            if (sizes[k] <= limit * (1 + 1e-9))
                Object.values(found).forEach((p) => marks.push([...minus(p, heart), 0, 0]));
        });
        view = fit(panel, marks.length ? marks : [[0, 0, 0, 0]], 34);
    }

    /* The scale of a row: smaller than that of the others by 2, 5, 10 ... where the polygon would not fit. */
    function scaleOf(found) {
        let scale = view.scale;
        const heart = heartOf(found), fits = (p) => {
            const at = add(view.origin, times(scale, minus(p, heart)));
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
        const scale = scaleOf(found), middle = heartOf(found);
        const place = (key) => add(view.origin, times(scale, minus(found[key], middle)));
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
            const letter = key.replace("'", "′").replace("4", "₄");
            circle(panel, "dot", place(key), 2.5, letter);
            text(panel, place(key), minus(place(key), heart), [letter, "", ""], 4);
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
        end(panel);
    }

    return {panel, choose, layOut, show};
}

/* ------------------------------------------------------------------------------------------------- free bodies */

function freeBody(data, panel, link) {
    let tracks, rows, view, forces, torques, putValues;
    const mine = (list) => list.filter((x) => x.on === link.link);
    const longest = () => (link.shape === "block" ? 0.3 : 0.2) * Math.min(panel.width, panel.height);
    const half = () => Math.max(10, 0.07 * Math.min(panel.width, panel.height));

    /* Where the body is held in the drawing: the middle between its pins, or the pin of a lever. */
    function heart(i) {
        const pins = link.pins.map((pin) => tracks.vector(pin, i));
        return link.shape === "slot" ? pins[1] : pins.length > 1 ? middle(pins[0], pins[1]) : pins[0];
    }

    function choose(branch, held) {
        tracks = tracksOf(data, branch);
        rows = reached(tracks);
        if (held)
            return;
        forces = present(mine(data.forces), tracks, rows);
        torques = present(mine(data.torques), tracks, rows);
        putValues = makeForceValues(data, panel, forces, torques);
    }

    function layOut() {
        const marks = [[0, 0, half(), half()], [0, 0, -half(), -half()]];
        const names = link.pins.concat(link.points, link.centre || []);
        measure(panel);
        for (const i of rows) {
            for (const name of names)
                marks.push([...minus(tracks.vector(name, i), heart(i)), 0, 0]);
            for (const name of link.shape === "slot" ? ["S1", "S2"] : [])
                for (const edge of [1.8 * half(), -1.8 * half()])
                    marks.push([...minus(tracks.vector(name, i), heart(i)), edge, edge]);
            for (const f of torques.filter((x) => x.inner))
                for (const edge of [-34, 34])
                    marks.push([...minus(tracks.vector(f.at, i), heart(i)), edge, edge]);
            for (const f of forces) {
                const at = minus(tracks.vector(f.at, i), heart(i));
                marks.push([...at, ...times(f.sign * forceScale(forces, tracks, i, longest()), tracks.vector(f.of, i))]);
            }
        }
        view = fit(panel, marks, 30);
    }

    function show(i, name) {
        begin(panel, name);
        putValues(tracks, i, view.part * longest());
        if (tracks.reason(i))
            return;
        const place = (track) => {
            const v = tracks.vector(track, i);
            return v && add(view.origin, times(view.scale, minus(v, heart(i))));
        };
        const k = forceScale(forces, tracks, i, view.part * longest());
        drawLink(panel, link, place, half(), data);
        for (const f of forces) /* lines to loads that act off the link's line */
            if (!link.pins.includes(f.at) && f.pen === "load")
                line(panel, "construction", ...link.pins.map(place), place(f.at));
        if (link.centre)
            centre(panel, place(link.centre));
        torques.forEach((f, j) => {
            const value = tracks.number(f.of, i), side = f.pen === "pin" ? -1 : 1;
            if (!value)
                return;
            torque(panel, f.pen, place(f.at), f.sign * value,
                   17 + 5 * torques.slice(0, j).filter((x) => x.at === f.at).length);
            text(panel, add(place(f.at), [side * 14, 14]), [side, 0.7], f.label, 5);
        });
        link.pins.forEach((pin, j) => {
            const other = place(link.pins[1 - j] || pin);
            circle(panel, "pivot", place(pin), 4.5, pin);
            text(panel, place(pin), minus(place(pin), other), [pin, "", ""], 6);
        });
        for (const f of forces) {
            const v = times(f.sign * k, tracks.vector(f.of, i));
            if (isTiny(size(v), view.part * longest()))
                continue;
            arrow(panel, f.pen, place(f.at), v);
            text(panel, add(place(f.at), v), v, f.label, 3);
        }
        if (forces.length)
            scaleBar(panel, "pin", 12, k, data.units.force);
        end(panel);
    }

    return {panel, choose, layOut, show};
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
    return {
        show(branch, i) {
            columns(data).forEach((column, j) => {
                const value = branch.table[i][data.columns.indexOf(column)];
                cells[j].textContent = withUnit(cellText(column, value), column.unit);
            });
        }
    };
}

/* ----------------------------------------------------------------------------------------------------- the page */

/* What the colours mean. */
function keyOf(data) {
    const key = html("p", {class: "key"});
    const entry = (kind, ...words) => key.append(html("span", {}, html("span", {class: "swatch " + kind}), ...words), " ");
    for (const link of data.links)
        entry("link" + link.link, link.link + " " + link.name);
    if (data.forces.some((f) => f.pen === "pin"))
        entry("pin", "pin force ", htmlLabel(["F", "ij", ""]), ", by link i on link j; 1 is the ground");
    if (data.forces.some((f) => f.pen === "load"))
        entry("load", data.springs.length ? "load, weight or spring" : "load or weight");
    if (data.forces.some((f) => f.pen === "inertia"))
        entry("inertia", "inertia force and torque, in the free bodies");
    data.points.forEach((p, k) => entry("path" + k % 6, "path of " + p.label[0]));
    if (data.wanted)
        entry("wanted", "wanted positions");
    return key;
}

/* The polygons that have a side in some row: none if the crank has no speed. */
function drawnPolygons(data) {
    return data.polygons.filter((x) => data.branches.some((branch) => {
        const tracks = tracksOf(data, branch);
        return present(x.sides, tracks, reached(tracks)).length > 0;
    }));
}

/* What the drawing consists of, whatever its numbers. */
function structure(data) {
    return JSON.stringify([data.over, data.units, data.gravity, data.forced, data.supports, data.links, data.points, drawnPolygons(data),
                           data.forces, data.torques, (data.wanted || []).length, data.columns.map((c) => [c.name, c.unit]),
                           data.branches.map((b) => b.name)]);
}

/* Make the drawing in `place`, an element, from `data`, all but the mechanism in `more` if it is given; returns its
** functions. */
function draw(data, place, more) {
    const main = mechanism(data, makePanel("Mechanism", "whole"));
    const views = [main].concat(drawnPolygons(data).map((x) => polygon(data, makePanel(x.title, "half"), x)));
    if (data.forced)
        for (const link of data.links)
            views.push(freeBody(data, makePanel("Free body of the " + link.name, "third"), link));
    const grid = html("div", {class: "panels"}, ...views.slice(more ? 1 : 0).map((view) => view.panel.figure));
    const row = tableRow(data, grid);
    let branch = data.branches[0], now = data.start;
    main.panel.figure.append(keyOf(data));
    place.replaceChildren(more ? html("div", {class: "panels"}, main.panel.figure) : grid);
    if (more)
        more.replaceChildren(grid);
    main.shape();

    const name = () => (data.branches.length > 1 ? branch.name + ", " : "") +
        (data.over === "time" ? "t = " : "θ₂ = ") + stepText(data, now);
    function show(i) {
        now = Math.max(0, Math.min(data.steps.length - 1, i));
        for (const view of views)
            view.show(now, name());
        main.panel.caption.textContent = main.panel.title + " at " + name() +
            (data.why && now === data.start && branch === data.branches[0] ? ", " + data.why : "");
        row.show(branch, now);
    }
    function layOut(isOnPaper) {
        for (const view of views)
            view.layOut(isOnPaper ? now : null);
        show(now);
    }
    function choose(k) {
        branch = data.branches[k];
        for (const view of views)
            view.choose(branch);
        layOut();
    }
    /* Take other numbers of the same mechanism, at the same scale if `held`; false if it is another one. */
    function update(next, held) {
        const k = data.branches.indexOf(branch);
        if (structure(next) !== structure(data))
            return false;
        Object.assign(data, next);
        branch = data.branches[k];
        for (const view of views)
            view.choose(branch, held);
        if (held)
            main.hold();
        else
            layOut();
        return true;
    }
    choose(0);
    return {show, choose, layOut, update, main, name, row: () => now, branch: () => data.branches.indexOf(branch),
            reason: (i) => branch.reasons[i] || ""};
}

return draw;
}());
