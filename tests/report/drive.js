/* SPDX-License-Identifier: GPL-3.0-or-later
**
** drive.js - drives the controls of a report for test_browser.sh, which appends it to a copy: it moves the slider,
** drags the crank, presses keys, plays, and writes what it finds as the text of the page, a line each:
**
**    place BRANCH ROW POINT PX PY SCALE X0 Y0   where a pin or a point is drawn, and the scale of the drawing
**    cell BRANCH ROW COLUMN TEXT                the row of the table
**    ok WHAT, failed WHAT                       what was tried
*/
"use strict";

(async function () {
    const lines = [];
    const find = (id) => document.getElementById("fourlink-" + id);
    const data = JSON.parse(find("rows").textContent);
    const slider = find("angle"), last = data.steps.length - 1;
    const sheet = document.querySelector(".panel.whole svg");
    const check = (what, is) => lines.push((is ? "ok " : "failed ") + what);
    const circle = (name) => sheet.querySelector("circle[data-name='" + name + "']");
    const scale = () => Number(/scale\((.*)\)/.exec(sheet.querySelector("g").getAttribute("transform"))[1]);
    const placeOf = (circle) => ["cx", "cy"].map((name) => Number(circle.getAttribute(name)) * scale());
    /* Pixels for a unit, and where the origin is: from the box and the axes of the sheet. */
    const view = () => {
        const [left, top, width, height] = sheet.dataset.box.split(" ").map(Number), [x0, x1, y0, y1] = sheet.dataset.axes.split(" ").map(Number);
        return [width / (x1 - x0), left - x0 * width / (x1 - x0), top + y1 * height / (y1 - y0)];
    };
    const wait = (time) => new Promise((done) => setTimeout(done, time));
    const move = (row) => {
        slider.value = row;
        slider.dispatchEvent(new Event("input", {bubbles: true}));
    };
    const press = (key) => slider.dispatchEvent(new KeyboardEvent("keydown", {key, bubbles: true, cancelable: true}));
    const row = () => Number(slider.value);
    const drawn = () => [...document.querySelectorAll("svg.sheet")].map((x) => x.innerHTML).join("");

    /* every row can be drawn; ten of them, and more, are compared with the program's table */
    function compare(branch) {
        const broken = [];
        for (let i = 0; i <= last; i++) {
            move(i);
            if (/NaN|undefined|Infinity/.test(drawn()))
                broken.push(i);
            for (const name of ["A", "B", "C", "D"].concat(data.points.map((p) => p.of)))
                if (circle(name) && circle(name).getAttribute("display") !== "none")
                    lines.push(["place", branch, data.steps[i], name, ...placeOf(circle(name)), ...view()].join(" "));
            for (const cell of document.querySelectorAll("[data-column]"))
                lines.push(["cell", branch, data.steps[i], cell.dataset.column, cell.textContent].join(" "));
        }
        check("no number is missing in the drawing, " + branch + ": " + broken.slice(0, 5), broken.length === 0);
    }

    /* The crank is dragged to where a row has its crank pin. */
    function dragTo(from, to) {
        move(to);
        const goal = placeOf(circle("B"));
        move(from);
        const handle = sheet.querySelector(".handle circle"), box = sheet.getBoundingClientRect();
        const ratio = box.width / sheet.viewBox.baseVal.width;
        const start = handle.getBoundingClientRect();
        const send = (kind, target, x, y) => target.dispatchEvent(new PointerEvent(kind, {
            bubbles: true, cancelable: true, pointerId: 7, pointerType: "touch", clientX: x, clientY: y}));
        send("pointerdown", handle, start.left + start.width / 2, start.top + start.height / 2);
        const held = row();
        send("pointermove", sheet, box.left + goal[0] * ratio, box.top + goal[1] * ratio);
        const moved = row();
        send("pointerup", sheet, box.left + goal[0] * ratio, box.top + goal[1] * ratio);
        send("pointermove", sheet, start.left + start.width / 2, start.top + start.height / 2);
        check("dragged from row " + from + " to " + to + ": held at " + held + ", moved to " + moved + ", left at " +
              row(), held === from && moved === to && row() === to);
    }

    function tryKeys() {
        const seen = [];
        move(5);
        for (const key of ["ArrowRight", "ArrowUp", "ArrowLeft", "ArrowDown", "End", "ArrowRight", "Home", "ArrowLeft",
                           "PageUp", "PageDown", "x"]) {
            press(key);
            seen.push(row());
        }
        const page = Math.max(1, Math.round((last + 1) / 24));
        check("keys: " + seen, String(seen) === String([6, 7, 6, 5, last, last, 0, 0, page, 0, 0]));
    }

    async function tryPlay() {
        window.requestAnimationFrame = (step) => setTimeout(() => step(performance.now()), 16);
        window.cancelAnimationFrame = clearTimeout; /* without a window there are no frames */
        const before = row();
        await wait(400);
        check("does not play by itself", row() === before);
        find("play").click();
        for (let k = 0; k < 50 && row() === before; k++)
            await wait(100);
        const there = row();
        check("plays: " + before + " to " + there, there !== before && find("play").textContent === "Pause");
        find("play").click();
        const rest = row();
        await wait(400);
        check("pauses: " + rest + " to " + row(), row() === rest && find("play").textContent === "Play");
    }

    function trySaving() {
        const buttons = [...document.querySelectorAll("button[data-save]")], saved = [];
        const real = HTMLAnchorElement.prototype.click;
        HTMLAnchorElement.prototype.click = function () { saved.push(this.download + this.href.slice(0, 5)); };
        buttons.forEach((button) => button.click());
        HTMLAnchorElement.prototype.click = real;
        check("saves " + saved, buttons.length > 0 && saved.length === buttons.length &&
              buttons.every((button, k) => !button.hidden && saved[k] === button.dataset.save + "blob:" &&
                            document.getElementById(button.dataset.from).textContent.length > 20));
    }

    /* On paper all tables are open, and their parts have all cells; afterwards they are as before. */
    function tryPaper() {
        const folds = [...document.querySelectorAll("details.table")], state = () => folds.map((x) => x.outerHTML).join("");
        const lines = (tables) => Array.from(tables[0].rows, (_, i) => tables.flatMap((table, k) =>
            [...table.rows[i].cells].slice(k ? 1 : 0).map((cell) => cell.textContent))).join("\n");
        const before = state();
        check("tables are folded", folds.length > 0 && folds.every((x) => !x.open));
        window.dispatchEvent(new Event("beforeprint"));
        for (const fold of folds) {
            const [whole, ...parts] = fold.querySelectorAll("table");
            check("on paper, " + parts.length + " parts", fold.open && whole.hidden === parts.length > 0 && parts.every((x) => !x.hidden) &&
                  (!whole.matches(".rows") || lines(parts) === lines([whole])));
        }
        window.dispatchEvent(new Event("afterprint"));
        check("tables are as before", state() === before);
    }

    if (window.parent !== window) { /* in a frame of a narrow page */
        const wide = document.documentElement.scrollWidth;
        const wrong = [];
        for (let k = 0; k <= 8; k++) {
            move(Math.round(last * k / 8));
            for (const x of document.querySelectorAll("svg.sheet *"))
                wrong.push(...[...x.attributes].map((a) => a.name + "=" + a.value).concat(x.children.length ? [] : x.textContent)
                    .filter((words) => /NaN|Infinity|undefined/.test(words)));
        }
        window.parent.postMessage((wrong.length || sheet.clientHeight < 100 ? "failed" : "ok") + " drawn, " + sheet.clientHeight +
                                  " pixels high: " + wrong.slice(0, 3), "*");
        const cut = [...document.querySelectorAll(".equation")].filter((x) => !x.querySelector("math.matrix") &&
            [...x.querySelectorAll("math")].some((m) => m.getBoundingClientRect().right > x.getBoundingClientRect().right + 1));
        window.parent.postMessage((cut.length ? "failed" : "ok") + " equations: " + cut.length + " are cut: " +
                                  (cut.length ? cut[0].textContent : ""), "*");
        window.parent.postMessage((wide <= window.innerWidth ? "ok" : "failed") + " width " + window.innerWidth + ": " + wide, "*");
        return;
    }
    check("no error: " + window.problems, window.problems.length === 0);
    check("the pictures without script are hidden", [...document.querySelectorAll("figure.mechanism, figure.vectors")]
        .every((x) => getComputedStyle(x).display === "none"));
    check("width " + window.innerWidth + ": " + document.documentElement.scrollWidth,
          document.documentElement.scrollWidth <= window.innerWidth);
    check("the drawing has its room", sheet.clientWidth > 200 && sheet.clientHeight > 150);
    check("the slider is named " + slider.labels[0].textContent,
          slider.labels[0].textContent === (data.over === "time" ? "Time" : "Crank angle θ2"));
    check("names are texts", !document.querySelector("script.evil, b.evil") && window.evil === undefined);
    const radios = [...document.querySelectorAll("#fourlink-branches input")];
    compare(data.branches[0].name);
    if (radios.length > 1) {
        radios[1].click();
        compare(data.branches[1].name);
        radios[0].click();
    }
    if (last > 40) {
        dragTo(3, 30);
        dragTo(30, 11);
        tryKeys();
        await tryPlay();
    }
    trySaving();
    tryPaper();
    check("no error at the end: " + window.problems, window.problems.length === 0);
    document.body.replaceChildren(Object.assign(document.createElement("pre"), {textContent: "\n" + lines.join("\n") + "\nend\n"}));
}());
