/* SPDX-License-Identifier: GPL-3.0-or-later
**
** studio.js - what drive.js tries of the page by eye and hand: its first screen, a linkage that is drawn, designs, questions,
** pictures to take along, zoom, one cursor, the manual.
**
** `at` has what drive.js has: check, command, value, text, click, settled, put, saved, load, middle, drag, changes.
*/
"use strict";

const fs = require("node:fs");
const path = require("node:path");
const {wait} = require("./browser.js");

module.exports = function (at, root, address) {
    const {check, command, value, text, click, settled, put, saved, load, middle, drag, changes, messages} = at;
    const b = () => at.browser();
    const choose = (id, wanted) => b().evaluate(`(() => {
        const menu = document.getElementById("${id}");
        menu.value = ${JSON.stringify(wanted)};
        menu.dispatchEvent(new Event("change", {bubbles: true}));
    })()`);
    const box = (selector) => b().evaluate(`(() => { const x = document.querySelector(${JSON.stringify(selector)}).getBoundingClientRect(); return [x.x, x.y, x.width, x.height]; })()`);
    const press = async (x, y) => {
        await b().mouse("mouseMoved", x, y);
        await b().mouse("mousePressed", x, y);
        await b().mouse("mouseReleased", x, y);
    };

    /* It begins in motion, with a load and a coupler curve, nothing beside the window; a key stops it. */
    async function tryFirst() {
        for (const [width, height] of [[1400, 900], [800, 900], [360, 740]]) {
            await b().size(width, height);
            await b().go("about:blank");
            await b().go(address);
            await b().until("window.fourlinkPage && document.querySelector('.panel.whole circle')", "the page");
            await settled();
            const before = await text("fourlink-shown");
            await wait(600);
            check(width + " px: it moves", await text("fourlink-shown") !== before && await text("fourlink-play") === "Pause");
            const seen = await b().evaluate(`(() => {
                const sheet = document.querySelector(".panel.whole svg.sheet").getBoundingClientRect();
                return {wide: document.documentElement.scrollWidth, top: sheet.top, bottom: sheet.bottom,
                        path: Boolean(document.querySelector(".panel.whole path[data-name='path of P']")),
                        colours: [...new Set([...document.querySelectorAll("#colours span")].map((x) => getComputedStyle(x).color))].length};
            })()`);
            check(width + " px: " + JSON.stringify(seen), seen.wide <= width && seen.path && seen.colours >= 4 &&
                  seen.bottom < height * (width < 500 ? 1.05 : 1));
            if (width >= 1400) {
                const all = await Promise.all(["#curve-place svg", "#fourlink-panels svg.sheet", "#table-place tbody tr:nth-child(4)"].map(box));
                check("drawing, curve and table are seen together: " + JSON.stringify(all), all.every((x) => x[3] > 0 && x[1] + x[3] <= height));
            }
            await b().key("Shift");
            check(width + " px: a key stops it", await text("fourlink-play") === "Play");
        }
        await b().size(1280, 900);
    }

    /* Four clicks make a four-bar; the pins stand where they were clicked, and the command agrees with the deck. */
    async function tryDraw() {
        const points = {"four-bar": [[0, 0], [-20, 34], [60, 70], [90, 0]], "slider-crank": [[0, 0], [20, 30], [110, 10], [150, 10]],
                        "inverted-slider-crank": [[0, 0], [20, 30], [0, -30]], "scotch-yoke": [[0, 0], [20, 30], [60, 10]]};
        const wanted = {"four-bar": ["length = 90", "length = 39.45", "length = 87.73", "length = 76.16"],
                        "slider-crank": ["offset = 10", "length = 36.06", "length = 92.2"],
                        "inverted-slider-crank": ["length = 30", "angle = -90 deg", "length = 36.06"], "scotch-yoke": ["offset = 10", "length = 36.06"]};
        for (const kind in points) {
            await choose("draw", kind);
            for (const [x, y] of points[kind]) {
                const [left, top, width, height] = await box("#board svg.fourlink"), k = Math.min(width / 240, height / 150);
                await press(left + (width - 240 * k) / 2 + k * (x + 60), top + (height - 150 * k) / 2 + k * (150 - (y + 50)));
            }
            await settled();
            const deck = await value("deck");
            for (const line of wanted[kind])
                check(kind + ": no " + line + " in\n" + deck, deck.includes("\n" + line + "\n"));
            check(kind + " has no mistake: " + await messages(), !(await messages()).some((x) => /error/.test(x)) && command("x.deck", deck).status === 0);
            check(kind + " is shown, and can be dragged", await b().evaluate(`document.getElementById("board").hidden &&
                document.getElementById("change").getAttribute("aria-pressed") === "true"`));
            const [A, B] = [await middle(".panel.whole circle[data-name=A]"), await middle(".panel.whole circle[data-name=B]")];
            const drawn = Math.atan2(A[1] - B[1], B[0] - A[0]), clicked = Math.atan2(points[kind][1][1], points[kind][1][0]);
            check(kind + ": the crank at " + drawn + " where it was drawn, " + clicked, Math.abs(drawn - clicked) < 0.06);
            await click("change");
        }
        /* typed */
        await choose("draw", "four-bar");
        for (const words of ["(0, 0)", "40 at 60 deg", "nonsense", "(70, 60)", "(100, 0) mm"]) {
            await b().evaluate(`document.getElementById("board-words").focus(); document.getElementById("board-words").value = ""`);
            await b().type(words);
            await b().key("Enter");
        }
        await settled();
        check("typed: " + await value("deck"), /\n\[ground\]\nlength = 100\n\n\[crank\]\nlength = 40\n/.test(await value("deck")));
        const before = await value("deck");
        for (const kind of ["point", "load", "masses"])
            await choose("add", kind);
        await settled();
        const after = await value("deck");
        check("a point, a load and masses are added: " + await messages() + after, /\[point P\]/.test(after) && /\[load F\]/.test(after) &&
              after.match(/uniform = yes/g).length === 3 && !(await messages()).some((x) => /error/.test(x)) && after !== before);
        await b().until(`document.querySelector('[data-knob="load F"]')`, "a ring for the load");
        const [from] = [await middle('[data-knob="load F"] .ring')];
        await drag(from, [from[0] + 14, from[1] + 6]);
        const made = changes(after, await value("deck"));
        check("the load is dragged: " + JSON.stringify(made), made && made.length === 1 && /^at +=/.test(made[0][1]));
        await click("change");
        await click("undo");
        await settled();
        check("and back", await value("deck") === after);
    }

    /* Decks of designs: their solutions are the command's; one is chosen; what is wanted is dragged. */
    async function tryDesigns() {
        const files = await b().evaluate(`[...document.querySelectorAll("#design option")].map((x) => x.value).filter((x) => x)`);
        const own = fs.readdirSync(path.join(root, "data/synthesis")).filter((x) => x.endsWith(".deck"));
        check("designs: " + files, own.every((x) => files.includes(x)) && files.filter((x) => x.startsWith("design-")).length === 5);
        for (const file of files) {
            await choose("design", file);
            await settled();
            const deck = await value("deck"), wanted = command(file, deck, "--synthesis").out.split("\n").map((x) => /^# +\d+: (.*)$/.exec(x)).filter((x) => x);
            const found = await b().evaluate(`[...document.querySelectorAll(".solutions li")].map((x) => x.textContent.trim())`);
            check(file + ": " + found[0] + ", not " + wanted[0], wanted.length > 0 && found.join() === wanted.map((x) => x[1]).join());
        }
        await choose("design", "design-path.deck");
        await settled();
        const deck = await value("deck");
        await b().evaluate(`document.querySelectorAll(".solutions input")[1].click()`);
        await settled();
        const [second, best] = [2, 1].map((k) => command("x.deck", command("x.deck", deck, "--synthesis", "--solution=" + k).out, "--format=csv").out);
        const {worst} = at.difference((await saved("save-csv")).text, second);
        check("the second solution: " + worst, worst >= 0 && worst < 1e-9 && second !== best);
        /* a position is dragged by a vector: its distances to the others are then those of the marks */
        await choose("design", "design-positions.deck");
        await settled();
        await click("change");
        await b().until(`document.querySelector('[data-knob="wanted 2"]')`, "a ring for position 2");
        const marksNow = () => Promise.all([1, 2, 3].map((k) => middle(`.panel.whole circle[data-name="wanted ${k}"]`)));
        const old = await marksNow(), before = await value("deck"), from = await middle('[data-knob="wanted 2"] .ring');
        await drag(from, [from[0] + 20, from[1] - 16]);
        const after = await value("deck"), made = changes(before, after);
        const [p, q] = [pairsOf(before), pairsOf(after)];
        check("positions: " + JSON.stringify(made), made && made.length === 1 && /^positions/.test(made[0][1]) && String(p[0]) === String(q[0]) && String(p[2]) === String(q[2]));
        const marks = await marksNow();
        const far = (x, y) => Math.hypot(x[0] - y[0], x[1] - y[1]), scale = far(marks[0], marks[2]) / far(q[0], q[2]);
        for (const [i, k] of [[0, 1], [1, 2]])
            check("the marks are where the deck has them: " + far(marks[i], marks[k]) + ", " + scale * far(q[i], q[k]),
                  Math.abs(far(marks[i], marks[k]) - scale * far(q[i], q[k])) < 1.5);
        const dragged = far(p[1], q[1]) * far(old[0], old[2]) / far(p[0], p[2]);
        check("it was dragged so far: " + dragged, Math.abs(dragged / Math.hypot(20, 16) - 1) < 0.05);
        await click("change");
    }
    const pairsOf = (words) => [.../^positions.*$/m.exec(words)[0].matchAll(/\(([-\d.]+), ([-\d.]+)\)/g)].map((x) => [Number(x[1]), Number(x[2])]);

    /* Questions have the command's answers, to the letter. */
    async function tryQuestions() {
        const words = fs.readFileSync(path.join(root, "web/templates/new-four-bar.deck"), "utf8");
        await put("x.deck", words);
        const asked = [["at", "theta4 = 100 deg, 30 deg", "--at=theta4 = 100 deg, 30 deg"], ["at", "thta4 = 100 deg", "--at=thta4 = 100 deg"],
                       ["solve", "crank.length = 20 mm .. 34 mm where swing = 40 deg", "--solve=crank.length = 20 mm .. 34 mm where swing = 40 deg"],
                       ["solve", "nonsense", "--solve=nonsense"], ["best", "max mu_min", "--best=max mu_min"], ["check", "", "--check"],
                       ["options", "--summary --units='in, lbf'", "--summary", "--units=in, lbf"], ["options", "--columns='max(Ts), mu_min'", "--columns=max(Ts), mu_min"]];
        for (const [kind, question, ...options] of asked) {
            await choose("ask-kind", kind);
            await b().evaluate(`document.getElementById("ask-words").value = ${JSON.stringify(question)}; document.getElementById("answer-text").textContent = "?";
                document.querySelector("#ask button").click()`);
            await b().until(`document.getElementById("answer-text").textContent !== "?"`, "an answer");
            const wanted = command("x.deck", words, ...options);
            check(kind + " " + question + ": " + await text("answer-text"), await text("answer-text") === wanted.messages.map((x) => x + "\n").join("") + wanted.out || await text("answer-text") === "Nothing.");
        }
        const sweep = words + "\n[sweep]\ncrank.length = 20 mm to 34 mm step 2 mm\noutput = mu_min\n";
        await put("x.deck", sweep);
        await choose("ask-kind", "best");
        await b().evaluate(`document.getElementById("ask-words").value = "max mu_min"; document.getElementById("answer-text").textContent = "?"; document.querySelector("#ask button").click()`);
        await b().until(`document.getElementById("answer-text").textContent !== "?"`, "an answer");
        await click("answer-take");
        await settled();
        check("the best design is taken: " + await messages(), /^# The best design/.test(await value("deck")) && !(await messages()).some((x) => /error/.test(x)));
        await click("answer-close");
    }

    /* Pictures are the command's; the PNG has twice their size. */
    async function tryPictures() {
        await load("khurmi-5.1.deck");
        const deck = await value("deck"), files = {};
        for (const kind of ["svg", "motion"])
            files[kind] = await saved("save-" + kind);
        const name = path.join(at.work, "picture.svg");
        const branch = await b().evaluate(`(document.querySelector("#fourlink-branches input:checked") || {value: "open"}).value`);
        const angle = (await text("fourlink-shown")).replace("−", "-").replace("°", " deg");
        for (const [kind, ...options] of [["svg", "--plot-at=" + angle], ["motion", "--plot-kind=animation"]]) {
            command("khurmi-5.1.deck", deck, "--plot=" + name, "--branch=" + branch, ...options);
            check("the picture " + files[kind].name, files[kind].text === fs.readFileSync(name, "utf8"));
        }
        check("names: " + files.svg.name + ", " + files.motion.name, files.svg.name === "khurmi-5.1.svg" && files.motion.name === "khurmi-5.1-motion.svg");
        check("it moves", /<animate /.test(files.motion.text));
        await saved("save-png");
        const head = await b().evaluate(`window.kept.blob.arrayBuffer().then((x) => [...new Uint8Array(x).slice(0, 24)])`);
        const width = Number(/width="(\d+)"/.exec(files.svg.text)[1]), found = head[18] * 256 + head[19];
        check("a PNG of " + found + " pixels: " + head.slice(0, 8), head.slice(1, 4).join() === "80,78,71" && found === 2 * width);
    }

    /* Larger: pins keep their places under the pointer; a ring goes where it is dragged; a click fits it again. */
    async function tryZoom() {
        await load("alvi-5.1.deck");
        const pin = (name) => middle(`.panel.whole circle[data-name="${name}"]`), size = () => b().evaluate(`document.querySelector(".panel.whole circle[data-name=C]").getBoundingClientRect().width`);
        const [C, B] = [await pin("C"), await pin("B")], before = await size();
        await b().page("Input.dispatchMouseEvent", {type: "mouseWheel", x: C[0], y: C[1], deltaX: 0, deltaY: -200, modifiers: 2});
        await b().until(`document.querySelector(".panel.whole svg").classList.contains("moved")`, "a larger drawing");
        const [C2, B2] = [await pin("C"), await pin("B")], factor = await size() / before;
        check("C stays: " + C + ", " + C2 + " at " + factor, factor > 1.5 && Math.hypot(C2[0] - C[0], C2[1] - C[1]) < 1);
        check("B moves away from it", Math.abs(Math.hypot(B2[0] - C2[0], B2[1] - C2[1]) / Math.hypot(B[0] - C[0], B[1] - C[1]) / factor - 1) < 0.02);
        await click("change");
        await b().until(`document.querySelector('[data-knob="C"]')`, "a ring");
        const from = await middle('[data-knob="C"] .ring');
        await b().mouse("mousePressed", ...from);
        await b().mouse("mouseMoved", from[0] + 6, from[1] + 5);
        await b().mouse("mouseMoved", from[0] + 12, from[1] + 9);
        await settled();
        const to = await middle('[data-knob="C"] .ring');
        await b().mouse("mouseReleased", from[0] + 12, from[1] + 9);
        await settled();
        check("the ring is where it was dragged: " + from + ", " + to, Math.hypot(to[0] - from[0] - 12, to[1] - from[1] - 9) < 4);
        await click("change");
        const place = await pin("C"), [left, top] = await box(".panel.whole svg.sheet");
        await drag([left + 30, top + 30], [left + 60, top + 50]);
        const moved = await pin("C");
        check("it is moved: " + place + ", " + moved, Math.hypot(moved[0] - place[0] - 30, moved[1] - place[1] - 20) < 2);
        await click("zoom-fit");
        check("it fits", Math.abs(await size() - before) < 0.1);
    }

    /* One cursor: a row of the table, a fact and the curve go to the same position. */
    async function tryCursor() {
        await click("tab-table");
        await load("me3491-exercise-4.deck");
        await b().evaluate(`document.querySelectorAll("#table-place tbody tr")[5].click()`);
        const angle = await b().evaluate(`document.querySelectorAll("#table-place tbody tr")[5].firstChild.textContent`);
        check("a row: " + angle + ", " + await text("fourlink-shown"), parseFloat(angle) === parseFloat((await text("fourlink-shown")).replace("−", "-")));
        check("it is marked", await b().evaluate(`document.querySelectorAll("#table-place tbody tr")[5].className === "now"`));
        await click("tab-facts");
        await b().until("document.querySelector('#facts-place td button')", "facts");
        await settled();
        await b().evaluate(`document.querySelector("#facts-place td button").click()`);
        const fact = (await b().evaluate(`document.querySelector("#facts-place td button").textContent`)).replace("−", "-");
        check("a fact: " + fact + ", " + await text("fourlink-shown"), 
              Math.abs(parseFloat(fact) - 360 - parseFloat((await text("fourlink-shown")).replace("−", "-"))) < 1);
        await click("tab-table");
        /* a clockwise motion has its axis from 0 to -360, as in the command's picture */
        const deck = fs.readFileSync(path.join(root, "web/templates/new-four-bar.deck"), "utf8").replace("100 rpm", "-100 rpm");
        await put("x.deck", deck);
        await choose("curve-y", "Ts");
        await settled();
        const texts = await b().evaluate(`[...document.querySelectorAll("#curve-place text")].map((x) => [x.textContent, x.getBoundingClientRect().x])`);
        const marks = texts.sort((p, q) => p[1] - q[1]).map((x) => x[0]), file = path.join(at.work, "cw.svg");
        command("x.deck", deck, "--columns=theta2,Ts", "--plot-kind=columns", "--plot=" + file);
        const wanted = [...fs.readFileSync(file, "utf8").matchAll(/<text[^>]*>([^<]*)<\/text>/g)].map((x) => x[1]);
        check("the axis begins at 0 and ends at -360: " + marks, marks.indexOf("−180") > marks.indexOf("−60") && marks.indexOf("−360") > marks.indexOf("−180"));
        const extremes = marks.filter((x) => /\d\.\d{2}/.test(x));
        check("the extremes are those of the picture: " + extremes, extremes.length >= 2 && extremes.every((x) => wanted.includes(x)));
    }

    /* Diagrams are drawn when they are seen; branch and position stay. */
    async function tryDiagrams() {
        await click("tab-table");
        await load("alvi-5.1.deck");
        await b().evaluate(`document.querySelectorAll("#fourlink-branches input")[1].click(); document.querySelectorAll("#table-place tbody tr")[2].click()`);
        const before = await text("fourlink-shown"), count = () => b().evaluate(`document.querySelectorAll(".panel svg.sheet").length`);
        check("the mechanism alone: " + await count(), await count() === 1);
        await click("tab-diagrams");
        await settled();
        check("with its diagrams: " + await count(), await count() > 2);
        check("at " + before + ", " + await text("fourlink-shown"), await text("fourlink-shown") === before);
        check("crossed", (await b().evaluate(`document.querySelector(".panel.whole svg").getAttribute("aria-label")`)).includes("crossed"));
        await click("tab-table");
    }

    async function tryManual() {
        await click("tab-manual");
        await b().evaluate(`document.getElementById("manual-search").focus(); document.getElementById("manual-search").value = "indicator"`);
        await b().key("Enter");
        check("the word is found", await b().evaluate(`window.getSelection().toString().toLowerCase()`) === "indicator");
        await choose("manual-contents", await b().evaluate(`[...document.querySelectorAll("#manual-contents option")].find((x) => x.textContent.includes("[flywheel]")).value`));
        check("the contents lead there", (await b().evaluate(`window.getSelection().toString()`)).trim() === "[flywheel]");
        check("it is in sight", await b().evaluate(`(() => { const x = window.getSelection().getRangeAt(0).getBoundingClientRect(), y = document.getElementById("manual").getBoundingClientRect();
            return x.top >= y.top && x.bottom <= y.bottom; })()`));
        await click("tab-table");
    }

    /* A notice goes; one instant outside the first turn has its report; no request leaves the page. */
    async function trySmall() {
        const words = fs.readFileSync(path.join(root, "data/alvi-5.1.deck"), "utf8").replace(/interval = 40 deg/, "at = 400 deg");
        await put("x.deck", words);
        check("an instant beyond a turn has a report", /<\/html>\s*$/.test((await saved("save-report")).text));
        await load("scotch-yoke-pump.deck");
        check("no empty row for one assembly mode", await b().evaluate(`document.getElementById("fourlink-branches").hidden === (document.querySelectorAll("#fourlink-branches input").length < 2) &&
            getComputedStyle(document.getElementById("fourlink-branches")).display === "none"`));
        await put("x.deck", words + "\n[table]\ncolumns = theta2, theta4\n");
        await click("tab-table");
        await settled();
        await b().evaluate(`window.dispatchEvent(new Event("beforeprint"))`);
        check("a narrow table is printed", await b().evaluate(`document.querySelectorAll("#table-place table:not([hidden])").length === 1`));
        check("what is printed has a title: " + await text("printed-title"), (await text("printed-title")).length > 3);
        await b().page("Emulation.setEmulatedMedia", {media: "print"});
        check("the drawing is printed", await b().evaluate(`document.querySelector("#fourlink-panels svg").getBoundingClientRect().width > 300`));
        await b().page("Emulation.setEmulatedMedia", {media: ""});
        await b().evaluate(`window.dispatchEvent(new Event("afterprint"))`);
        check("nothing was fetched: " + await b().evaluate(`performance.getEntriesByType("resource").map((x) => x.name).join()`),
              await b().evaluate(`performance.getEntriesByType("resource").every((x) => /^(blob|data):/.test(x.name))`));
    }

    return [["first", tryFirst], ["draw", tryDraw], ["designs", tryDesigns], ["questions", tryQuestions], ["pictures", tryPictures],
            ["zoom", tryZoom], ["cursor", tryCursor], ["diagrams", tryDiagrams], ["manual", tryManual], ["small", trySmall]];
};
