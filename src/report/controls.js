/* SPDX-License-Identifier: GPL-3.0-or-later
**
** controls.js - what a report does with its drawing: slider, crank, play, assembly mode; the buttons that save a
** table; tables on paper.
*/
Object.assign(fourlink, (function () {

/* Let the crank be dragged, by mouse or finger. */
function drag(drawing, go) {
    const sheet = drawing.main.panel.drawing;
    let dragged = null;
    const follow = (event) => go(drawing.main.rowAt(fourlink.placeOf(event, sheet)));
    drawing.main.handle.addEventListener("pointerdown", (event) => {
        dragged = event.pointerId;
        fourlink.hold(event, sheet);
        follow(event);
    });
    sheet.addEventListener("pointermove", (event) => {
        if (event.pointerId === dragged)
            follow(event);
    });
    for (const end of ["pointerup", "pointercancel"])
        sheet.addEventListener(end, () => { dragged = null; });
}

/* The controls of a drawing: slider, crank, play, assembly mode.  `find` finds their elements; `take` gives them a
** drawing and its data, and begins at a row; `seen` is called with each row that is shown. */
function controls(find, seen) {
    const slider = find("angle"), shown = find("shown"), button = find("play"), status = find("status");
    let data = null, drawing = null, last = 0, playing = null;

    function go(i) {
        const before = drawing.row();
        drawing.show(i);
        if (playing !== null && drawing.row() === before)
            return;
        slider.value = drawing.row();
        shown.textContent = fourlink.stepText(data, drawing.row());
        slider.setAttribute("aria-valuetext", drawing.name());
        status.textContent = drawing.reason(drawing.row()); /* read aloud when it changes */
        if (seen)
            seen(drawing.row());
    }
    function stop() {
        if (playing === null)
            return;
        cancelAnimationFrame(playing);
        playing = null;
        button.textContent = "Play";
        status.textContent = drawing.name();
    }
    /* Once through the motion in eight seconds, at the screen's rate; slower for who wants less motion.  Rows without a
    ** position are passed over. */
    function play() {
        const slow = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
        let before = null, rest = 0;
        const step = (time) => {
            let i = drawing.row();
            rest += before === null ? 0 : Math.min((time - before) * (last + 1) / (slow ? 32000 : 8000), last);
            before = time;
            for (let k = 0; k <= last && rest >= 1; k++) {
                i = i === last ? 0 : i + 1;
                rest -= drawing.reason(i) ? 0 : 1;
            }
            go(i + Math.min(rest, 0.999));
            playing = requestAnimationFrame(step);
        };
        button.textContent = "Pause";
        playing = requestAnimationFrame(step);
    }
    function byKey(event) {
        const page = Math.max(1, Math.round((last + 1) / 24));
        const steps = {ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: page, PageDown: -page,
                       Home: -last, End: last}[event.key];
        if (!drawing || !steps || event.altKey || event.ctrlKey || event.metaKey)
            return;
        event.preventDefault();
        stop();
        go(drawing.row() + steps);
    }
    function offerBranches() {
        const group = find("branches"), names = data.branches.map((branch) => branch.name);
        group.hidden = names.length < 2;
        group.querySelectorAll("label").forEach((label) => label.remove());
        names.forEach((name, k) => {
            const radio = fourlink.html("input", {type: "radio", name: "fourlink-branch", value: name});
            radio.checked = k === drawing.branch();
            radio.addEventListener("change", () => {
                drawing.choose(k);
                stop();
                go(drawing.row());
            });
            group.append(fourlink.html("label", {}, radio, " " + name));
        });
    }
    function setRange() {
        const theta2 = fourlink.html("span", {class: "theta"}, "θ", fourlink.html("sub", {}, "2"));
        slider.labels[0].replaceChildren(...(data.over === "time" ? ["Time"] : ["Crank angle ", theta2]));
        last = data.steps.length - 1;
        slider.max = last;
        button.disabled = last === 0;
    }
    function take(newData, newDrawing, row) {
        stop();
        data = newData;
        drawing = newDrawing;
        setRange();
        offerBranches();
        drag(drawing, (i) => {
            stop();
            go(i);
        });
        go(row);
    }
    /* The drawing has taken other numbers. */
    function renew(row) {
        setRange();
        go(row);
    }

    slider.addEventListener("input", () => {
        stop();
        go(Number(slider.value));
    });
    slider.addEventListener("keydown", byKey);
    button.addEventListener("click", () => playing === null ? play() : stop());
    let width = window.innerWidth;
    window.addEventListener("resize", () => {
        if (window.innerWidth !== width && drawing) {
            width = window.innerWidth;
            drawing.layOut();
        }
    });
    /* On paper the drawings of the page have the width of paper, so that their letters keep their size. */
    window.addEventListener("beforeprint", () => {
        stop();
        if (drawing)
            drawing.layOut();
    });
    window.addEventListener("afterprint", () => {
        if (drawing)
            drawing.layOut();
    });
    return {take, renew, go, stop, play};
}

/* Show the buttons that save a table as a file. */
function offerFiles() {
    for (const button of document.querySelectorAll("button[data-save]")) {
        button.hidden = false;
        button.addEventListener("click", () => {
            fourlink.save(button.dataset.save, "text/csv", document.getElementById(button.dataset.from).textContent);
        });
    }
}

/* ---------------------------------------------------------------------------------------- tables on paper */

const LINE = 137, HALF = 66; /* letters, at 7 pt, of a line and of one of two columns; see report.css */

/* The letters that each column needs, with what is between columns. */
function widthsOf(table) {
    const widths = [];
    for (const row of table.rows)
        if ([...row.cells].every((cell) => cell.colSpan === 1))
            [...row.cells].forEach((cell, j) => {
                const words = [...cell.childNodes].map((x) => x.textContent.length + 2);
                widths[j] = Math.max(widths[j] || 0, ...words);
            });
    return widths;
}

/* The columns of each part of a table, [0, 1, 2, 3], [0, 4, 5] ...: each has the first, none is wider than a line. */
function partsOf(widths, line) {
    const parts = [[0]];
    let rest = line - widths[0];
    for (let j = 1; j < widths.length; j++) {
        if (widths[j] > rest) {
            parts.push([0]);
            rest = line - widths[0];
        }
        parts[parts.length - 1].push(j);
        rest -= widths[j];
    }
    return parts;
}

/* No more parts than needed, of about the same width. */
function divide(widths) {
    const count = partsOf(widths, LINE).length;
    let line = LINE;
    while (line > 0 && partsOf(widths, line - 1).length === count)
        line--;
    return partsOf(widths, line);
}

/* Whether a row has a cell for each column, and does not say why it has no numbers. */
const hasNumbers = (row, widths) => row.cells.length === widths.length;

/* A table of some columns of another. */
function partOf(table, columns, widths) {
    const part = table.cloneNode(false);
    part.style.setProperty("--letters", columns.reduce((sum, j) => sum + widths[j], 0));
    for (const group of table.children) {
        const made = group.cloneNode(!group.rows);
        for (const row of group.rows || []) {
            const line = row.cloneNode(!hasNumbers(row, widths));
            if (hasNumbers(row, widths))
                line.append(...columns.map((j) => row.cells[j].cloneNode(true)));
            else
                line.cells[line.cells.length - 1].colSpan = Math.max(1, columns.length - line.cells.length + 1);
            made.append(line);
        }
        part.append(made);
    }
    return part;
}

/* While the page is printed, tables are open and wide ones divided.  A long table stays as it is. */
function printTables() {
    const before = [];
    window.addEventListener("beforeprint", () => {
        for (const table of document.querySelectorAll("table.rows, details table")) {
            const details = table.closest("details"), fold = details || {open: true}, widths = widthsOf(table);
            if (!fold.open && fold.classList.contains("long"))
                continue;
            const columns = table.matches(".rows") ? divide(widths) : [];
            const parts = columns.map((some) => partOf(table, some, widths));
            const isNarrow = parts.length === 1 && widths.reduce((sum, x) => sum + x, 0) <= HALF;
            before.push({fold, details, table, parts, open: fold.open});
            if (details && isNarrow)
                details.classList.add("narrow");
            table.after(...parts);
            table.hidden = parts.length > 0;
            fold.open = true;
        }
    });
    window.addEventListener("afterprint", () => {
        for (const {fold, details, table, parts, open} of before.splice(0)) {
            parts.forEach((part) => part.remove());
            table.hidden = false;
            fold.open = open;
            if (details)
                details.classList.remove("narrow");
        }
    });
}

/* What is wider than its place can be scrolled with the keyboard too. */
function reachScrolling() {
    const parts = [...document.querySelectorAll(".equation, .wide")];
    const look = () => parts.forEach((x) => {
        if (x.scrollWidth > x.clientWidth + 1) {
            x.tabIndex = 0;
            x.setAttribute("role", "group");
            x.setAttribute("aria-label", x.matches(".wide") ? "Table" : "Equation");
        }
    });
    look();
    window.addEventListener("resize", look);
    window.addEventListener("toggle", look, true);
}

/* Lines of equations end between terms.  A fraction that is still wider than the paper or the screen has smaller
   letters: on paper a browser would make the whole page smaller. */
function fitEquations() {
    const equations = [...document.querySelectorAll(".equation math")];
    const fit = (usual, least) => {
        equations.forEach((x) => x.style.removeProperty("font-size"));
        const rooms = equations.map((x) => {
            const box = x.getBoundingClientRect(), edge = x.closest(".equation").getBoundingClientRect().right;
            return (edge - box.left) / box.width;
        });
        equations.forEach((x, k) => {
            if (rooms[k] < 1)
                x.style.fontSize = Math.max(least, usual * rooms[k]) + "rem";
        });
    };
    const onScreen = () => fit(0.88, 0.5);
    window.addEventListener("beforeprint", () => fit(0.86, 0.81));
    window.addEventListener("afterprint", onScreen);
    window.addEventListener("resize", onScreen);
    onScreen();
}

/* ------------------------------------------------------------------------------------------------ the report */

/* Of a report: the drawing takes the place of the pictures that stand there without a script. */
function start() {
    const rows = document.getElementById("fourlink-rows"), place = document.getElementById("fourlink-panels");
    offerFiles();
    printTables();
    fourlink.typed.start();
    window.addEventListener("beforeprint", () => document.documentElement.classList.add("on-paper"));
    window.addEventListener("afterprint", () => document.documentElement.classList.remove("on-paper"));
    fitEquations();
    reachScrolling();
    if (!rows || !place)
        return;
    const data = Object.assign(JSON.parse(rows.textContent), {why: place.dataset.why});
    if (!data.branches.length)
        return;
    const more = document.getElementById("fourlink-more");
    for (const part of [place, more, document.getElementById("fourlink-controls")])
        part.hidden = false;
    const cursors = [...document.querySelectorAll("figure.motion, figure.forces")].map((figure) => (
        fourlink.cursor(figure, data.branches.map(() => data.steps), (i) => made.go(i))));
    const drawing = fourlink.draw(data, place, more);
    const made = controls((id) => document.getElementById("fourlink-" + id), (i) => cursors.forEach((show) => show(i, drawing.branch())));
    made.take(data, drawing, data.start);
    giveNumbers([...place.querySelectorAll("figcaption")], [...more.querySelectorAll("figcaption")]);
    document.documentElement.classList.add("moving");
}

/* The numbers of the pictures go to the drawings that take their place on the screen: the mechanism, the polygons of
   the motion, and the free bodies. */
function giveNumbers([main], panels) {
    const pictures = [...document.querySelectorAll("figure.mechanism, figure.vectors")];
    const places = {mechanism: main, "vectors of-motion": panels[0], "vectors of-forces": panels.find((x) => x.closest(".third"))};
    for (const picture of pictures)
        if (places[picture.className])
            places[picture.className].prepend(picture.querySelector("figcaption").textContent.split(".")[0] + ". ");
}

return {controls, start};
}()));

fourlink.start();
