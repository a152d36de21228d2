/* SPDX-License-Identifier: GPL-3.0-or-later
**
** drive.js PAGE FOURLINK ROOT [FOLDER] - drives the page in headless Chromium: types, drags, presses keys, reads,
** and compares with the command FOURLINK.  ROOT is the folder of the sources, FOLDER one of more decks to compare.
*/
"use strict";

const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");
const {spawnSync} = require("node:child_process");
const {open, wait} = require("./browser.js");
const exercisesOf = require("./exercises.js");
const pinsOf = require("./pins.js");
const studioOf = require("./studio.js");

const [page, fourlink, root, folder] = process.argv.slice(2).map((x) => path.resolve(x));
const work = fs.mkdtempSync(path.join(os.tmpdir(), "fourlink-web-"));
const address = "file://" + page;
let passed = 0, failed = 0, b;

function check(what, is) {
    if (is) {
        passed++;
    } else {
        failed++;
        console.log("FAILED: " + what.slice(0, 400));
    }
}

/* What the command says and prints of a deck, alone in its folder. */
function command(name, text, ...options) {
    fs.writeFileSync(path.join(work, name), text);
    const made = spawnSync(fourlink, [...options, name], {cwd: work, encoding: "utf8", maxBuffer: 2e7});
    fs.unlinkSync(path.join(work, name));
    return {out: made.stdout, messages: made.stderr.split("\n").filter((x) => x), status: made.error ? 3 : made.status}; /* 3: more than the page writes too */
}

const value = (id) => b.evaluate(`document.getElementById("${id}").value`);
const text = (id) => b.evaluate(`document.getElementById("${id}").textContent`);
const click = (id) => b.evaluate(`document.getElementById("${id}").click()`);
const settled = () => b.until("window.fourlinkPage.isIdle()", "an answer", 60000);
const messages = () => b.evaluate(`[...document.querySelectorAll("#messages li:not(.page)")].map((x) => x.textContent)`);

/* Put a deck into the page at once. */
async function put(name, words) {
    await b.evaluate(`(() => {
        const set = (id, words, kind) => {
            const element = document.getElementById(id);
            element.value = words;
            element.dispatchEvent(new Event(kind, {bubbles: true}));
        };
        set("name", ${JSON.stringify(name)}, "change");
        set("deck", ${JSON.stringify(words)}, "input");
    })()`);
    await settled();
}

/* The file that a button of the menu saves: {name, text}. */
async function saved(button) {
    await b.evaluate(`window.kept = null; (() => {
        const make = URL.createObjectURL;
        URL.createObjectURL = (blob) => { window.kept = {blob}; return make.call(URL, blob); };
        const click = HTMLAnchorElement.prototype.click;
        HTMLAnchorElement.prototype.click = function () {
            window.kept.name = this.download;
            HTMLAnchorElement.prototype.click = click;
            URL.createObjectURL = make;
        };
    })()`);
    await click(button);
    await b.until("window.kept && window.kept.name", "a file", 20000);
    return b.evaluate("window.kept.blob.text().then((text) => ({name: window.kept.name, text}))");
}

/* -------------------------------------------------------------------------------- messages and numbers of decks */

/* Cells of csv; quoted ones hold no line ends here. */
const cells = (line) => (line.match(/("([^"]|"")*"|[^,]*)(,|$)/g) || []).map((x) => x.replace(/,$/, ""));

/* The largest difference of two csv files in parts of the largest value of its column, and where; -1: other words. */
function difference(one, other) {
    const x = one.trim().split(/\r?\n/).map(cells), y = other.trim().split(/\r?\n/).map(cells);
    let worst = 0, where = "", count = 0;
    if (x.length !== y.length)
        return {worst: -1, where: x.length + " and " + y.length + " lines", count};
    const isNumber = (s) => /^-?[0-9.]+(e[-+]?[0-9]+)?$/.test(s);
    for (let j = 0; j < x[0].length; j++) {
        const isRest = /^(energy_)?residual/.test(x[0][j]), isAngle = /\(deg\)$/.test(x[0][j]);
        const size = Math.max(0, ...x.slice(1).map((row) => isNumber(row[j] || "") ? Math.abs(row[j]) : 0));
        const largest = isRest ? 1e4 : size > 1e-12 ? size : 1; /* less is rounding in a whole column */
        for (let i = 0; i < x.length; i++) {
            const [p, q] = [x[i][j], y[i][j]];
            if (!isNumber(p || "") || !isNumber(q || "")) {
                if (p !== q)
                    return {worst: -1, where: x[0][j] + ": " + p + " and " + q, count};
                continue;
            }
            count++;
            let d = Math.abs(p - q);
            d = (isAngle && d > 180 ? Math.abs(d - 360) : d) / largest;
            if (d > worst)
                [worst, where] = [d, x[0][j] + " line " + (i + 1) + ": " + p + " and " + q];
        }
    }
    return {worst, where, count};
}

const total = {decks: 0, messages: 0, values: 0, worst: 0, where: ""};

async function compare(name, words) {
    const wanted = command(name, words, "--format=csv");
    const expected = wanted.messages.filter((x) => !/^fourlink: \S+: note: /.test(x)); /* of files, which a page has not */
    await put(name, words);
    const found = await messages();
    total.decks++;
    total.messages += expected.length;
    check(name + " says " + JSON.stringify(found.find((x, i) => x !== expected[i])) + " and not " +
          JSON.stringify(expected.find((x, i) => x !== found[i])) + "\n" + words, expected.join("\n") === found.join("\n"));
    if (wanted.status > 1 || /^\s*\[sweep\]/m.test(words))
        return;
    const {worst, where, count} = difference(wanted.out, (await saved("save-csv")).text);
    const isIntegrated = /^\s*mode\s*=\s*(free|run-up|steady)/m.test(words); /* in the page and natively with an error of 1e-11 */
    total.values += count;
    if (worst > total.worst && !isIntegrated)
        [total.worst, total.where] = [worst, name + ", " + where];
    check(name + ": " + where + ": " + worst, worst >= 0 && worst <= (isIntegrated ? 2e-11 : 1e-12));
}

/* All decks of a folder whose text a textarea can hold. */
async function compareAll(from, rename) {
    const files = fs.readdirSync(from).filter((x) => x.endsWith(".deck")).sort(), seen = new Set();
    for (const file of files) {
        const bytes = fs.readFileSync(path.join(from, file)), words = bytes.toString("utf8").replace(/\r\n?/g, "\n");
        if (seen.has(words) || words.length > 1e6 || words.includes("\0") || words.startsWith("\ufeff") ||
            (!bytes.equals(Buffer.from(bytes.toString("utf8")))))
            continue;
        seen.add(words);
        await compare(rename ? "x.deck" : file, words);
    }
}

/* The tables of the decks of data/ have the command's numbers, in closed form all digits of them unless the motion is
** integrated; and a mistake is told as it is typed. */
async function tryTables() {
    const files = fs.readdirSync(path.join(root, "data")).filter((x) => x.endsWith(".deck"));
    let values = 0;
    for (const file of files) {
        const words = fs.readFileSync(path.join(root, "data", file), "utf8"), wanted = command(file, words, "--format=csv").out;
        await put(file, words);
        const {worst, where, count} = difference(wanted, (await saved("save-csv")).text);
        check(file + ": " + where + ": " + worst, count > 0 && worst >= 0 && worst <= 1e-9);
        values += count;
        if (/^\s*(mode|exponent)\s*=/m.test(words))
            continue;
        const closed = "solver = dyad\n" + words.replace(/^\s*solver\s*=.*$/m, "");
        await put(file, closed);
        check(file + ": other digits", (await saved("save-csv")).text === command(file, closed, "--format=csv").out);
    }
    check(files.length + " decks, " + values + " values", files.length > 30 && values > 5000);
    const name = "alvi-5.1.deck", words = fs.readFileSync(path.join(root, "data", name), "utf8");
    await put(name, words);
    check("no mistake: " + await messages(), (await messages()).length === 0);
    await typeDeck(words.replace("length = 66 mm", "lenght = 66 mm"));
    const line = words.split("\n").indexOf("length = 66 mm") + 1, told = (await messages()).join("\n");
    check("a mistake: " + told, told.startsWith(name + ":" + line + ": error: ") && told.includes("lenght"));
}

/* ------------------------------------------------------------------------------------------------- by hand */

async function load(name) {
    await b.evaluate(`(() => {
        const menu = document.getElementById("example");
        menu.value = ${JSON.stringify(name)};
        menu.dispatchEvent(new Event("change"));
    })()`);
    await settled();
}

/* A text is typed in place of what is there. */
async function typeDeck(words) {
    await b.evaluate(`document.getElementById("deck").focus(); document.getElementById("deck").select()`);
    await b.type(words);
    await settled();
}

const middle = (selector) => b.evaluate(`(() => {
    const box = document.querySelector(${JSON.stringify(selector)}).getBoundingClientRect();
    return [box.x + box.width / 2, box.y + box.height / 2];
})()`);
const pin = (name) => middle(`.panel.whole circle[data-name="${name}"]`);

async function drag(from, to, steps = 6) {
    await b.mouse("mousePressed", ...from);
    for (let k = 1; k <= steps; k++) {
        await b.mouse("mouseMoved", from[0] + (to[0] - from[0]) * k / steps, from[1] + (to[1] - from[1]) * k / steps);
        await wait(20);
    }
    await b.mouse("mouseReleased", ...to);
    await settled();
}

/* The lines in which two decks differ, [before, after]. */
function changes(before, after) {
    const x = before.split("\n"), y = after.split("\n");
    return x.length === y.length ? x.map((line, i) => [line, y[i]]).filter(([p, q]) => p !== q) : null;
}

async function tryTyping() {
    await load("alvi-5.1.deck");
    const good = fs.readFileSync(path.join(root, "data/alvi-5.1.deck"), "utf8");
    const seen = await b.evaluate(`(() => {
        const area = document.getElementById("deck"), lines = [...document.querySelectorAll("#colours > div")];
        const numbers = [...document.querySelectorAll("#gutter pre > div")].map((x) => x.getBoundingClientRect().top);
        return [area.scrollWidth <= area.clientWidth, lines.some((x) => x.offsetHeight > 30),
                Math.abs(area.scrollHeight - Math.max(area.clientHeight, document.getElementById("colours").offsetHeight + 8)) < 2,
                lines.every((x, i) => Math.abs(x.getBoundingClientRect().top - numbers[i]) < 1)];
    })()`);
    check("long lines go on below, numbers at their beginnings: " + seen, seen.every((x) => x));
    await typeDeck(good.replace("length = 66 mm", "lenght = 66 mm"));
    check("a mistake as one types: " + await messages(), (await messages())[0] ===
          "alvi-5.1.deck:14: error: unknown key 'lenght' in [coupler]; did you mean 'length'?");
    check("the mistake stands at its line", await b.evaluate(`(() => {
        const mark = document.querySelector("#layer .mark");
        return mark.offsetTop === document.querySelectorAll("#colours > div")[13].offsetTop && mark.textContent.startsWith("unknown key 'lenght'");
    })()`));
    check("the text is invalid for a screen reader", await b.evaluate(
        `document.getElementById("deck").getAttribute("aria-invalid") === "true"`));
    await b.evaluate(`document.querySelector("#messages button").click()`);
    check("the message leads to its line", await b.evaluate(
        `(() => { const a = document.getElementById("deck"); return a.value.slice(a.selectionStart, a.selectionEnd); })()`) ===
        "lenght = 66 mm");
    await b.type("length = 66 mm");
    await settled();
    check("it is mended: " + await messages(), (await messages()).length === 0 && await value("deck") === good);
    await b.key("z", 2);
    await settled();
    check("Ctrl+Z takes it back", /lenght/.test(await value("deck")) && (await messages()).length === 1);
    await b.key("y", 2);
    await settled();
    check("Ctrl+Y does it again", await value("deck") === good);
}

async function tryCrank() {
    await load("alvi-5.1.deck");
    const A = await pin("A"), B = await pin("B"), r = Math.hypot(B[0] - A[0], B[1] - A[1]);
    await drag(B, [A[0] + r * Math.cos(1), A[1] - r * Math.sin(1)], 8);
    const shown = parseFloat(await text("fourlink-shown"));
    check("the crank is dragged to 57.3 deg: " + shown, Math.abs(shown - 57.3) < 2);
    check("which leaves the deck", await value("deck") === fs.readFileSync(path.join(root, "data/alvi-5.1.deck"), "utf8"));
    await b.evaluate(`document.getElementById("fourlink-angle").focus()`);
    await b.key("Home");
    await b.key("ArrowRight");
    check("keys move the slider: " + await text("fourlink-shown"), await text("fourlink-shown") !== "0°");
    await click("fourlink-play");
    const before = await text("fourlink-shown");
    await wait(700);
    check("it plays", await text("fourlink-shown") !== before && await text("fourlink-play") === "Pause");
    await click("fourlink-play");
    const after = await text("fourlink-shown");
    await wait(200);
    check("and stops", await text("fourlink-shown") === after);
    await b.evaluate(`document.querySelectorAll("#fourlink-branches input")[1].click()`);
    check("the other assembly mode", (await b.evaluate(
        `document.querySelector(".panel.whole svg").getAttribute("aria-label")`)).includes("crossed"));
}

/* Rows by time: the slider is the time, at whose end the row is the command's last. */
async function tryTime() {
    const words = fs.readFileSync(path.join(root, "tests/fuzz/decks/free.deck"), "utf8");
    const label = () => b.evaluate(`document.getElementById("fourlink-angle").labels[0].textContent`);
    await put("free.deck", words);
    check("the slider is the time: " + await label(), await label() === "Time");
    await b.evaluate(`document.getElementById("fourlink-angle").focus()`);
    await b.key("End");
    check("to its end: " + await text("fourlink-shown"), await text("fourlink-shown") === "0.5 s");
    const rows = command("free.deck", words, "--branch=open", "--columns=theta2", "--format=csv").out.trim().split(/\r?\n/);
    const wanted = Number(rows[rows.length - 1].split(",")[1]);
    const found = await b.evaluate(`parseFloat(document.querySelector('[data-column="theta2"]').textContent)`);
    check("the row at its end: " + found + ", not " + wanted, Math.abs(found - wanted) < 1e-6);
    await load("alvi-5.1.deck");
    check("the slider is the angle: " + await label(), await label() === "Crank angle θ2");
}

/* Each knob is dragged: these lines of the deck change, and it goes where the pointer is. */
async function tryKnobs(name, wanted) {
    await load(name);
    const before = await value("deck");
    for (const [knob, way, ...keys] of wanted) {
        await b.until(`document.querySelector('[data-knob="${knob}"]')`, "a ring for " + knob);
        const from = await middle(`[data-knob="${knob}"] .ring`), to = [from[0] + way[0], from[1] + way[1]];
        await drag(from, to);
        const made = changes(before, await value("deck"));
        check(name + ", " + knob + ": " + JSON.stringify(made), made && made.length === keys.length &&
              made.every(([p, q], i) => p.trim().startsWith(keys[i]) && q.trim().startsWith(keys[i]) &&
                         p.replace(/[-+.\d]/g, "") === q.replace(/[-+.\d]/g, "")));
        check(name + ", " + knob + " has no mistake: " + await messages(), !(await messages()).some((x) => /error/.test(x)));
        check("numbers are short: " + JSON.stringify(made), made && made.every(([, q]) => !/\d\.\d{4}/.test(q.replace(/[#;].*/, ""))));
        await click("undo");
        await settled();
        check(name + ", " + knob + ": one step of undo", await value("deck") === before);
    }
}

async function tryDragging() {
    await click("change");
    await tryKnobs("me3491-exercise-4.deck", [
        ["B", [20, 2], "length"], ["C", [15, -20], "length", "length"], ["D", [18, 3], "length"],
        ["G2", [6, -3], "cg"], ["G4", [8, 9], "cg"], ["P0", [-10, 12], "at"]]);
    await tryKnobs("me3491-example-1.deck", [["B", [9, -8], "stroke"], ["C", [25, 2], "length"], ["G3", [12, 3], "cg"]]);
    await tryKnobs("new-scotch-yoke.deck", [["B", [10, -8], "length"], ["C", [3, -12], "offset"], ["G4", [20, -4], "cg"]]);
    await tryKnobs("oscillating-cylinder.deck", [["B", [10, 0], "length"], ["D", [20, 0], "length"]]);
    await load("me3491-exercise-4.deck");
    await b.until(`document.querySelector('[data-knob="G4"]')`, "rings");
    await b.evaluate(`document.querySelector('[data-knob="D"]').focus()`);
    const before = await value("deck");
    for (let k = 0; k < 3; k++)
        await b.key("ArrowRight", 8);
    await settled();
    const made = changes(before, await value("deck"));
    check("arrow keys move a pin: " + JSON.stringify(made), made && made.length === 1 && parseFloat(made[0][1].split("=")[1]) > 151);
    await click("change");
}

async function tryFiles() {
    const words = fs.readFileSync(path.join(root, "data/me3491-exercise-4.deck"), "utf8"), name = "me3491-exercise-4.deck";
    await load(name);
    const deck = await saved("save-deck"), json = await saved("save-json"), report = await saved("save-report");
    check("the deck is saved as it is", deck.name === name && deck.text === words);
    check("json: " + json.text.slice(0, 80), json.name === "me3491-exercise-4.json" && JSON.parse(json.text).mechanism === "four-bar linkage");
    check("the report", report.name === "me3491-exercise-4.html" && /<h2>.*Sample calculation/.test(report.text) &&
          /id="fourlink-rows"/.test(report.text) && /<\/html>\s*$/.test(report.text));
    fs.writeFileSync(path.join(work, "report.html"), report.text);
    await b.go("about:blank");
    await b.go("file://" + path.join(work, "report.html"));
    await b.until("document.querySelector('.panel.whole circle')", "the drawing of the report");
    const row = command(name, words).out.split("\n").find((x) => /^ *-180 /.test(x)).trim().split(/ +/).slice(0, 5);
    fs.writeFileSync(path.join(work, "report.pdf"), Buffer.from((await b.page("Page.printToPDF")).data, "base64"));
    const paper = spawnSync("pdftotext", ["-layout", path.join(work, "report.pdf"), "-"], {encoding: "utf8"}).stdout;
    check("on paper, the report has the row " + row, new RegExp("^ *" + row.join(" +") + " ", "m").test(paper));
    const native = path.join(work, "native.html");
    command(name, words, "--report=" + native, "--plot-at=0 deg");
    const part = (text, from, to) => text.slice(text.indexOf(from), text.indexOf(to, text.indexOf(from)));
    check("the report is the command's", fs.readFileSync(native, "utf8") === report.text);
    for (const [from, to] of [["<style>", "</style>"], ["<script>//", "</script>"]])
        check("the report has the command's " + from, part(fs.readFileSync(native, "utf8"), from, to) === part(report.text, from, to));
    await b.go(address);
    await b.until("window.fourlinkPage && document.querySelector('.panel.whole circle')", "the page");
    await load(name);
    await click("save-link");
    await b.until("location.hash.length > 20", "a link");
    const hash = await b.evaluate("location.hash");
    check("a short link: " + hash.length, hash.startsWith("#deck=") && hash.length < words.length);
    await b.go("about:blank");
    await b.go(address + hash);
    await b.until("window.fourlinkPage && document.querySelector('.panel.whole circle')", "the linked deck");
    check("the link carries the deck", await value("deck") === words && await value("name") === name);
    await b.go("about:blank");
    await b.go(address + "#deck=AAAA");
    await b.until("window.fourlinkPage && document.querySelector('.panel.whole circle')", "the page");
    check("a damaged link: " + await text("notice"), /damaged/.test(await text("notice")));
    await b.go("about:blank");
    await b.go(address + "#plain=" + encodeURIComponent("y.deck\n" + words));
    await b.until("window.fourlinkPage && document.querySelector('.panel.whole circle')", "the plain link");
    check("a plain link", await value("deck") === words && await value("name") === "y.deck");
}

/* An address that carries a deck follows the text. */
async function tryAddress() {
    const words = fs.readFileSync(path.join(root, "data/alvi-5.1.deck"), "utf8"), hash = () => b.evaluate("location.hash");
    await b.go("about:blank");
    await b.go(address);
    await b.until("window.fourlinkPage && document.querySelector('.panel.whole circle')", "the page");
    await put("alvi-5.1.deck", words.replace("length = 66 mm", "length = 67 mm"));
    await wait(600);
    check("no address without a link", await hash() === "");
    await click("save-link");
    await b.until("location.hash.length > 20", "a link");
    const first = await hash();
    await put("alvi-5.1.deck", words.replace("length = 66 mm", "length = 68 mm"));
    await b.until("location.hash !== " + JSON.stringify(first), "another address");
    const second = await hash();
    await b.go("about:blank");
    await b.go(address + second);
    await b.until("window.fourlinkPage && document.querySelector('.panel.whole circle')", "the linked deck");
    check("the address has the text as it was edited", (await value("deck")).includes("length = 68 mm"));
    await b.go("about:blank");
    await b.go(address);
    await b.until("window.fourlinkPage && document.querySelector('.panel.whole circle')", "the page");
}

/* A template for each mechanism, and the examples under their mechanisms. */
async function tryExamples() {
    const groups = await b.evaluate(`[...document.querySelectorAll("#example optgroup")].map((group) =>
        [group.label, [...group.children].map((x) => x.value)])`);
    check("groups: " + groups.map((x) => x[0]), groups.length === 5 && groups[0][0] === "New deck" && groups[0][1].length === 4);
    const shown = groups.slice(1).flatMap((x) => x[1]).sort().join();
    check("all examples: " + shown, shown === fs.readdirSync(path.join(root, "data")).filter((x) => x.endsWith(".deck")).sort().join());
    const kinds = new Set();
    for (const name of groups[0][1]) {
        await load(name);
        kinds.add(/mechanism = (\S+)/.exec(await value("deck"))[1]);
        check(name + ": " + await messages(), (await messages()).length === 0);
        check(name + " is drawn", await b.evaluate(`document.querySelectorAll(".panel svg circle").length > 5`));
        const look = await b.evaluate(`(() => { const x = getComputedStyle(document.querySelector(".panel.whole path.crank")); return [x.stroke, x.fill, x.strokeWidth]; })()`);
        check(name + ", the look of the crank: " + look, look.join() === "rgb(10, 47, 122),none,5px");
    }
    check("mechanisms: " + [...kinds], kinds.size === 4);
}

/* Places in per cent of a link, and `mid`, can be dragged; they stay per cent. */
async function tryShares() {
    const deck = (at) => "mechanism = four-bar\n[units]\nlength = mm\n[ground]\nlength = 100\n[crank]\nlength = 35\n[coupler]\nlength = 90\n" +
        "mass = 1 kg\ncg = " + at + "\ninertia = 0\n[rocker]\nlength = 70\n[motion]\nspeed = 10 rad/s\n";
    await click("change");
    for (const at of ["mid", "50 %", "50%"]) {
        await put("share.deck", deck(at));
        await b.until(`document.querySelector('[data-knob="G3"]')`, "a ring for G3 at " + at);
        const [B, C] = [await pin("B"), await pin("C")], from = await middle('[data-knob="G3"] .ring');
        await drag(from, [from[0] + 0.2 * (C[0] - B[0]), from[1] + 0.2 * (C[1] - B[1])]);
        const made = changes(deck(at), await value("deck")), share = made && made.length === 1 && /^cg = ([\d.]+) %$/.exec(made[0][1]);
        check(at + " is dragged to 70 %: " + JSON.stringify(made), share && Math.abs(share[1] - 70) < 1);
        check("without a mistake: " + await messages(), !(await messages()).some((x) => /error/.test(x)));
    }
    await click("change");
}

/* Several curves, a diagram for each unit, with their extremes: those of the command's picture.  A click goes to a row. */
async function tryCurves() {
    await load("me3491-exercise-4.deck");
    await b.evaluate(`for (const [id, name] of [["curve-y", "omega4"], ["curve-y2", "F12"], ["curve-y3", "F14"]]) {
        document.getElementById(id).value = name;
        document.getElementById(id).dispatchEvent(new Event("change"));
    }`);
    await settled();
    const found = await b.evaluate(`[...document.querySelectorAll("#curve-place g.panel")].map((panel) => ({
        curves: [...panel.querySelectorAll("path[data-name]")].map((x) => x.getAttribute("data-name") + " " + x.getAttribute("d")),
        texts: [...panel.querySelectorAll("text")].map((x) => x.textContent)}))`);
    check("diagrams: " + found.length, found.length === 2 && found.every((panel) => panel.curves.length > 0));
    const file = path.join(work, "curves.svg");
    command("x.deck", await value("deck"), "--columns=theta2,omega4,F12,F14", "--plot-kind=columns", "--plot=" + file);
    const texts = [...fs.readFileSync(file, "utf8").matchAll(/<text[^>]*>([^<]*)<\/text>/g)].map((x) => x[1]);
    const rest = found.flatMap((panel) => panel.texts).filter((x) => /\d\.\d/.test(x) && !texts.includes(x));
    check("values beside the curves that the command's picture does not have: " + rest, rest.length === 0);
    const cursor = () => b.evaluate(`[...document.querySelectorAll("#curve-place .cursor")].map((x) => x.getAttribute("d"))`);
    const before = await cursor(), shown = await text("fourlink-shown");
    const box = await b.evaluate(`(() => { const x = document.querySelector("#curve-place svg").getBoundingClientRect(); return [x.x, x.y, x.width, x.height]; })()`);
    await b.mouse("mousePressed", box[0] + 0.35 * box[2], box[1] + 0.25 * box[3]);
    await b.mouse("mouseReleased", box[0] + 0.35 * box[2], box[1] + 0.25 * box[3]);
    await settled();
    check("a click goes to a row: " + shown + ", " + await text("fourlink-shown"), await text("fourlink-shown") !== shown);
    check("the cursor follows", before.length === 2 && (await cursor()).every((d, k) => d && d !== before[k]));
    for (const id of ["curve-y2", "curve-y3"])
        await b.evaluate(`document.getElementById("${id}").value = ""`);
    await b.evaluate(`document.getElementById("curve-y").value = "theta4";
        document.getElementById("curve-y").dispatchEvent(new Event("change"));`);
    await settled();
    check("one again", await b.evaluate(`document.querySelectorAll("#curve-place g.panel").length === 1`));
    await click("tab-table");
}

/* A [synthesis]: a mark for each wanted position, on the path of the point, of pin C, or of the piston. */
async function tryWanted() {
    const folder = path.join(root, "data/synthesis");
    for (const [file, count, way] of [["three-positions", 3, "path of P"], ["log10", 3, "path of C"], ["power-nine", 9, "path of C"],
                                      ["quadratic-slider", 3, "path of C"]]) {
        await put(file + ".deck", fs.readFileSync(path.join(folder, file + ".deck"), "utf8"));
        const far = await b.evaluate(`(() => {
            const path = document.querySelector(".panel.whole path[data-name='${way}']"), length = path.getTotalLength();
            const points = Array.from({length: 2001}, (_, k) => path.getPointAtLength(length * k / 2000));
            return [...document.querySelectorAll(".panel.whole circle[data-name^=wanted]")].map((x) => Math.min(...points.map((p) =>
                Math.hypot(p.x - x.getAttribute("cx"), p.y - x.getAttribute("cy")))));
        })()`);
        check(file + ": " + count + " wanted positions, pixels from the path: " + far, far.length === count && Math.max(...far) < 3);
    }
    /* Defects are told as by the command; so is why there is no linkage. */
    const motion = (left) => "mechanism = four-bar\n[synthesis]\ntask = motion\npositions = (0, 0) mm 0 deg, (24, 10) mm -30 deg, (40, 5) mm -50 deg\n" +
        "left = " + left + "\nright = fixed (50, 0) mm\n";
    for (const [words, count] of [[motion("rotations -40 deg -70 deg"), 4], [motion("fixed (50, 0) mm"), 1]]) {
        const wanted = command("x.deck", words, "--synthesis").messages;
        await put("x.deck", words);
        check("found: " + await messages(), wanted.length === count && wanted.join("\n") === (await messages()).join("\n"));
    }
    await load("alvi-5.1.deck");
    check("none without a task", await b.evaluate(`document.querySelectorAll("[data-name^=wanted]").length === 0`));
}

/* A deck that is pasted in place of all is named after its title; a link of PMKS+ becomes a deck. */
async function tryPasted() {
    const link = "j=A,1,2,AB,R,t,0,0.1,t,%0AB,-3,5,AB|BC,R,f,0,0.1,f,%0AC,-11,17,BC|CG,R,f,0,0.1,f,%0AG,1,22,CG,R,t,0,0.1,f,&f=&s=10,false,false,cm";
    await paste(fs.readFileSync(path.join(root, "tests/report/look/springs.deck"), "utf8"));
    check("the name of what was pasted: " + await value("name"), await value("name") === "ruttelsieb-mit-federn-und-dampfer.deck");
    await paste(link);
    await b.until(`document.getElementById("name").value === "linkage.deck"`, "the deck of a link", 10000);
    await settled();
    check("the deck of a link: " + await value("deck"), /^# joint G is pin D of the deck\nmechanism = four-bar\n\n\[pins\]\nA = \(1, 2\) cm\n/.test(await value("deck")));
    await load("alvi-5.1.deck");
}

async function paste(words) {
    await load("alvi-5.1.deck");
    await b.evaluate(`(() => {
        const area = document.getElementById("deck");
        area.focus();
        area.select();
        area.dispatchEvent(new ClipboardEvent("paste", {bubbles: true, cancelable: true}));
    })()`);
    await b.type(words);
    await wait(100);
    await settled();
}

/* On a phone: the drawing is more than a blob, no attribute is without a number, a notice covers no drawing. */
async function tryPhone() {
    const folder = path.join(root, "tests/report/look");
    for (const width of [320, 360]) {
        await b.size(width, 740);
        for (const file of fs.readdirSync(folder)) {
            await put(file, fs.readFileSync(path.join(folder, file), "utf8"));
            const found = await b.evaluate(`(() => {
                const sheets = [...document.querySelectorAll("svg.sheet")], main = sheets[0].getBoundingClientRect();
                const wrong = sheets.flatMap((sheet) => [...sheet.querySelectorAll("*")].flatMap((x) => [...x.attributes].map((a) => a.value)
                    .concat(x.children.length ? [] : x.textContent)).filter((words) => /NaN|Infinity|undefined/.test(words)));
                return {wrong: wrong.slice(0, 3), height: main.height, wide: document.documentElement.scrollWidth};
            })()`);
            check(width + " px, " + file + ": " + JSON.stringify(found), found.wrong.length === 0 && found.height >= 100 && found.wide <= width);
        }
        await click("save-link");
        await b.until("document.getElementById('notice').textContent", "a notice");
        const covered = await b.evaluate(`(() => {
            const [x, y] = ["#notice", "svg.sheet"].map((s) => document.querySelector(s).getBoundingClientRect());
            window.scrollTo(0, 0);
            return x.bottom > y.top && x.top < y.bottom;
        })()`);
        check(width + " px: the notice covers the drawing", !covered);
        await b.evaluate("history.replaceState(null, '', location.pathname)");
    }
    /* no blank block between the drawing and the deck where they are below each other */
    await b.size(700, 900);
    await load("alvi-5.1.deck");
    const gap = await b.evaluate(`document.querySelector(".deck-side").getBoundingClientRect().top -
        document.querySelector("#curve-place svg").getBoundingClientRect().bottom`);
    check("700 px: a blank block of " + gap + " px", gap < 40);
    await b.size(1280, 900);
}

async function tryHostile() {
    const evil = '</script><img src=x onerror="window.evil=1"><b class="evil">';
    await put(evil + ".deck", "title = \"" + evil + "\"\nmechanism = four-bar\n[ground]\nlength = 80 mm\n[crank]\nlength = 20 mm\n" +
              "[coupler]\nlength = 66 mm\n[rocker]\nlength = 56 mm\n[point " + evil.replace(/[[\]=]/g, "") + "]\nlink = coupler\nat = (1, 2) mm\n" +
              "[load " + evil.replace(/[[\]=]/g, "") + "]\nlink = rocker\ntorque = 1 N m\n[motion]\nspeed = 1 rad/s\n[expect]\ntype = " + evil + "\n" + evil);
    for (const tab of ["table", "facts", "diagrams", "solutions", "checks", "table"]) {
        await click("tab-" + tab);
        await settled();
    }
    await put("x.deck", "title = \"" + evil + "\"\nmechanism = four-bar\n[ground]\nlength = 80 mm\n[crank]\nlength = 20 mm\n" +
              "[coupler]\nlength = 66 mm\n[rocker]\nlength = 56 mm\n[point <b>P</b>]\nlink = coupler\nat = (1, 2) mm\n");
    for (const tab of ["table", "facts", "diagrams", "solutions", "checks", "table"]) {
        await click("tab-" + tab);
        await settled();
    }
    check("texts of a deck never become markup", await b.evaluate(
        `window.evil === undefined && !document.querySelector(".evil, main img, #fourlink-panels b, header img")`));
}

async function tryLimits() {
    const good = fs.readFileSync(path.join(root, "data/alvi-5.1.deck"), "utf8");
    const begun = Date.now();
    await put("large.deck", good.replace("interval = 40 deg", "interval = 0.00036 deg"));
    const told = await b.evaluate("document.querySelector('#messages .page').textContent");
    check("a million rows: " + told, /^1000001 rows: the page writes files of at most 100000\./.test(told));
    check("in " + (Date.now() - begun) + " ms", Date.now() - begun < 5000);
    await click("save-csv");
    await wait(100);
    check("no csv of them: " + await text("notice"), /^1000001 rows: /.test(await text("notice")));
    await click("tab-table");
    await b.until("document.querySelectorAll('#table-place tr').length > 100", "the table");
    await click("tab-facts");
    await wait(1500);
    await b.evaluate(`document.getElementById("stop").click()`);
    await put("alvi-5.1.deck", good);
    check("the page goes on", (await messages()).length === 0);
    await click("tab-table");
    const answer = await b.evaluate(`(async () => {
        const input = document.getElementById("open"), list = new DataTransfer();
        list.items.add(new File([new Uint8Array(65e6)], "huge.deck"));
        input.files = list.files;
        input.dispatchEvent(new Event("change"));
        await new Promise((done) => setTimeout(done, 300));
        return document.getElementById("notice").textContent;
    })()`);
    const comment = "# a comment of forty characters and more\n", again = Date.now();
    await put("alvi-5.1.deck", good + comment.repeat(2400));
    console.log("a deck of 99 kB: " + (Date.now() - again) + " ms");
    check("2400 lines have no mistakes", (await messages()).length === 0);
    await put("alvi-5.1.deck", good);
    await b.evaluate(`(() => {
        const data = new DataTransfer();
        data.setData("text", ${JSON.stringify(comment)}.repeat(3000));
        document.getElementById("deck").dispatchEvent(new InputEvent("beforeinput", {dataTransfer: data, cancelable: true}));
    })()`);
    check("more is refused: " + await text("notice"), /^larger than 100 kB/.test(await text("notice")));
    check("64 MB: " + answer, answer === "huge.deck: larger than 64 MB: not a deck");
    check("the deck is still there", await value("deck") === good);
}

/* ------------------------------------------------------------------------------------------ the ten exercises */

async function column(name) {
    return b.evaluate(`(() => {
        const cell = document.querySelector('[data-column="${name}"]');
        return cell ? cell.textContent : null;
    })()`);
}

async function tryExercises() {
    for (const exercise of exercisesOf(root)) {
        await click("tab-table");
        await typeDeck(exercise.deck);
        check(exercise.name + ": " + await messages(), !(await messages()).some((x) => /error/.test(x)));
        for (const [name, wanted] of exercise.row || [])
            check(exercise.name + ", " + name + ": " + await column(name) + ", not " + wanted, await column(name) === wanted);
        if (exercise.facts) {
            await click("tab-facts");
            await b.until("document.querySelector('#facts-place tbody tr')", "facts");
            await settled();
            const facts = await b.evaluate(`[...document.querySelectorAll("#facts-place tbody tr")].map((row) =>
                [...row.children].slice(0, 3).map((cell) => cell.textContent).join(" ").trim())`);
            for (const fact of exercise.facts)
                check(exercise.name + ": no " + fact + " in " + facts.slice(0, 30), facts.includes(fact));
        }
        if (exercise.score) {
            await click("tab-checks");
            await b.until("document.querySelector('#checks-place li.total')", "comparisons");
            await settled();
            const found = await b.evaluate(`[...document.querySelectorAll("#checks-place li")].map((x) => x.textContent).join("\\n")`);
            const wanted = command(await value("name"), exercise.deck, "--check").out.trim();
            check(exercise.name + ": " + found, found.endsWith("# score: " + exercise.score) && found === wanted);
        }
    }
    await click("tab-table");
}

/* --------------------------------------------------------------------------------------------- time, keyboard, layout */

async function tryTimes() {
    await b.go("about:blank");
    await b.go(address);
    await b.until("document.querySelector('.panel.whole circle')", "the first drawing");
    const first = await b.evaluate("window.fourlinkPage.firstDrawing");
    check("first drawing after " + first + " ms", first < 1000);
    await load("me3491-exercise-4.deck");
    await click("change");
    await b.until(`document.querySelector('[data-knob="P0"]')`, "a ring");
    const times = [];
    const from = await middle('[data-knob="P0"] .ring');
    await b.evaluate("window.fourlinkPage.times.length = 0");
    await drag(from, [from[0] + 60, from[1] + 40], 40);
    times.push(...await b.evaluate("window.fourlinkPage.times"));
    await click("change");
    times.sort((x, y) => x - y);
    const typical = times[Math.floor(times.length / 4)]; /* when nothing else runs */
    console.log("first drawing " + Math.round(first) + " ms; redraw while dragging, of " + times.length + ": lower quartile " +
                typical.toFixed(1) + " ms, longest " + times[times.length - 1].toFixed(1) + " ms");
    check("redraw while dragging: " + typical, typical < 16.7);
}

/* Everything can be reached with Tab, and each control has a name. */
async function tryKeyboard() {
    await load("me3491-exercise-4.deck");
    await click("change");
    await settled();
    await b.evaluate("document.activeElement.blur()");
    const seen = new Set();
    for (let k = 0; k < 60; k++) {
        await b.key("Tab");
        seen.add(await b.evaluate(`(() => {
            const e = document.activeElement;
            return e.id || e.getAttribute("data-knob") || e.name || e.textContent.slice(0, 20);
        })()`));
    }
    for (const id of ["example", "open", "undo", "deck", "name", "fourlink-angle", "fourlink-play", "tab-table", "change", "ask-words", "zoom-in", "B", "P0"])
        check("Tab reaches " + id + ": " + [...seen], seen.has(id) || (id === "undo" && !seen.has(id)));
    await click("change");
    const nameless = await b.evaluate(`[...document.querySelectorAll("button, input, select, textarea, [role]")].filter((e) =>
        !e.textContent.trim() && !e.getAttribute("aria-label") && !e.getAttribute("aria-labelledby") &&
        !(e.labels && e.labels.length) && !/^(status|tabpanel)$/.test(e.getAttribute("role"))).map((e) => e.outerHTML.slice(0, 80))`);
    check("without a name: " + nameless, nameless.length === 0);
}

async function tryLayout() {
    for (const width of [360, 768, 1280, 2560]) {
        await b.size(width, 900);
        for (const name of ["me3491-exercise-4.deck", "alvi-5.1.deck"]) {
            await load(name);
            for (const tab of ["table", "facts", "diagrams", "solutions", "checks", "manual"]) {
                await click("tab-" + tab);
                await settled();
                const wide = await b.evaluate("document.documentElement.scrollWidth");
                check(width + " px, " + tab + ": " + wide, wide <= width);
            }
            await click("tab-table");
        }
    }
    await b.size(1280, 900);
    await b.go("about:blank");
    await b.page("Page.addScriptToEvaluateOnNewDocument", {source: `window.shift = 0;
        new PerformanceObserver((list) => list.getEntries().forEach((e) => { window.shift += e.value; }))
            .observe({type: "layout-shift", buffered: true});`});
    await b.go(address);
    await b.until("document.querySelector('.panel.whole circle')", "the page");
    await wait(500);
    const shift = await b.evaluate("window.shift");
    check("layout shift " + shift, shift < 0.01);
    const place = await b.evaluate("document.querySelector('.panel.whole svg').getBoundingClientRect().top");
    for (const words of ["title = x\n", fs.readFileSync(path.join(root, "data/me3491-example-1.deck"), "utf8")]) {
        await put("x.deck", words);
        check("the drawing stays in its place", place ===
              await b.evaluate("document.querySelector('.panel.whole svg').getBoundingClientRect().top"));
    }
}

async function main() {
    b = await open();
    await b.size(1280, 900);
    await b.go(address);
    await b.until("document.querySelector('.panel.whole circle')", "the first drawing");
    const tools = {check, command, value, text, click, settled, put, saved, load, middle, drag, changes, messages, difference, work, browser: () => b};
    for (const [what, run] of [...studioOf(tools, root, address), ...pinsOf(tools), ["tables", tryTables], ["typing", tryTyping], ["crank", tryCrank], ["time", tryTime], ["dragging", tryDragging],
                               ["exercises", tryExercises], ["hostile", tryHostile], ["limits", tryLimits], ["keyboard", tryKeyboard], ["files", tryFiles],
                               ["address", tryAddress], ["examples", tryExamples], ["shares", tryShares], ["curves", tryCurves],
                               ["wanted", tryWanted], ["pasted", tryPasted], ["phone", tryPhone],
                               ["layout", tryLayout], ["times", tryTimes],
                               ["decks", async () => {
                                   await compareAll(path.join(root, "data"));
                                   await compareAll(path.join(root, "tests/decks"));
                                   if (folder)
                                       await compareAll(folder, true);
                                   console.log(total.decks + " decks, " + total.messages + " messages, " + total.values +
                                               " values, largest difference " + total.worst + ", " + total.where);
                               }]]) {
        if (process.env.TRY && !process.env.TRY.split(",").includes(what))
            continue;
        try {
            await run();
        } catch (error) {
            check(what + ": " + error.stack, false);
        }
        check(what + ": errors in the page: " + b.problems, b.problems.length === 0);
        b.problems.length = 0;
    }
    await b.close();
    fs.rmSync(work, {recursive: true});
    console.log(passed + " passed, " + failed + " failed");
    process.exitCode = failed ? 1 : 0;
}

main();
