/* SPDX-License-Identifier: GPL-3.0-or-later
**
** main.js - the page: the deck in its editor goes to the program, its answer to the views.
*/
(function () {

const {html} = fourlink;
const find = (id) => document.getElementById(id);
const [examples, templates, designs] = ["examples", "templates", "designs"].map((id) => JSON.parse(find(id).textContent));
const FIRST = "new-four-bar.deck"; /* the template that the page begins with */
const CURVES = ["curve-y", "curve-y2", "curve-y3", "curve-y4"], NOTICE = 12000;
const MOST_TEXT = 1e5, LARGEST = 64e6, MOST_ROWS = 100000, PAGE = 200;
const TOO_LARGE = "larger than 100 kB: the page edits smaller decks; use the program itself";
let name = "my.deck", deck = null, data = null, drawing = null, working = false, again = false, restart = null;
let instant = null, fresh = true; /* a new deck begins at its own crank angle */
let first = 0, shown = {}, asked = new Set(), filling = 0, halted = null; /* a view that was stopped */
let solution = 1, textOfSolution = null; /* of its [synthesis], and the text whose solution was chosen */
let startAt = null; /* the crank angle at which a linkage was drawn */

const program = web.program((is) => { find("busy").hidden = !is; });
const editor = web.editor(find("deck"), find("gutter"), find("layer"), () => {
    halted = null;
    follow();
    evaluate();
});
const handles = web.handles(editor, program.ask);
const zoom = web.zoom(find, () => handles.show());
let curve = null; /* the cursor of the curves */
const controls = fourlink.controls((id) => find("fourlink-" + id), seen);

function fail(error) {
    tell(error.message === "stopped" ? "Stopped." : "This failed: " + error.message);
}

let quiet = null;

/* Tell something for a while. */
function tell(words) {
    find("notice").textContent = words;
    clearTimeout(quiet);
    quiet = setTimeout(() => { find("notice").textContent = ""; }, NOTICE);
}

/* ------------------------------------------------------------------------------------------------ the command */

/* The options of what is shown: of a [sweep] one design, of a [synthesis] the solution that was chosen. */
function ofShown() {
    return [...(deck && deck.designs ? ["--design=" + deck.design] : []), ...(hasTask() ? ["--solution=" + solution] : [])];
}
const hasTask = () => web.text.sections(editor.text()).some((x) => x.toLowerCase() === "synthesis");

/* Run the command on the deck: its status, what it prints, the files it writes. */
function run(options) {
    return program.ask("run", {name, text: editor.text(), options: [...(hasTask() ? ["--synthesis"] : []), ...options]});
}
const runShown = (options) => run([...ofShown(), ...options]);

/* Of all designs of a [sweep]; with a [synthesis], of the deck of the linkage that it finds. */
async function runRows(options) {
    const text = hasTask() ? (await runShown([])).out : editor.text();
    return program.ask("run", {name, text, options});
}

/* ------------------------------------------------------------------------------------------------ the deck */

/* What the page leaves to the program itself. */
function limits() {
    return [deck.rows > MOST_ROWS ? deck.rows + " rows: the page writes files of at most " + MOST_ROWS +
            ". Take a larger interval, or the program itself." : "",
            deck.designs ? "A [sweep] of " + deck.designs + " designs: the page shows design " + deck.design +
            ". The program itself prints all." : ""].filter((x) => x);
}

function showMessages(list, more, others) {
    const place = find("messages");
    editor.mark(list);
    place.replaceChildren(...list.map((message) => {
        const item = html("li", {class: message.kind});
        const button = message.line > 0 && html("button", {type: "button", class: "plain"}, message.text);
        if (button)
            button.addEventListener("click", () => editor.select(message.line));
        item.append(button || message.text);
        return item;
    }));
    if (more)
        place.append(html("li", {class: "error"}, "fourlink: and " + more + " more " + list[0].kind + (more > 1 ? "s" : "")));
    place.append(...others.map((words) => html("li", {class: "page"}, words)));
}

/* The step of a drawing that is nearest to an angle or a time. */
function nearestStep(of, wanted) {
    return of.steps.reduce((best, x, i) => Math.abs(x - wanted) < Math.abs(of.steps[best] - wanted) ? i : best, of.start);
}

const TURN = {deg: 360, rad: 2 * Math.PI, mrad: 2000 * Math.PI, rev: 1};

/* Go to a crank angle; turns are not counted. */
function goToAngle(angle) {
    if (!data || data.over !== "theta2")
        return;
    const turn = TURN[data.units.angle], off = data.steps.map((x) => Math.abs(x - angle - turn * Math.round((x - angle) / turn)));
    controls.stop();
    controls.go(off.indexOf(Math.min(...off)));
}

/* The step of the next drawing that is nearest to what is now shown. */
function sameRow(next) {
    return data && drawing && data.over === next.over ? nearestStep(next, data.steps[drawing.row()]) : next.start;
}

function take(answer) {
    const begun = performance.now();
    const next = answer.scene && JSON.parse(answer.scene);
    deck = answer.deck;
    showMessages(deck.messages, deck.more, limits());
    for (const part of document.querySelectorAll("#results, .shown"))
        part.classList.toggle("stale", !deck.usable);
    find("stale").hidden = deck.usable;
    if (!deck.usable)
        return;
    document.title = (deck.title || name) + " \u2013 fourlink";
    find("no-drawing").hidden = Boolean(next && next.branches.length);
    if (next && next.branches.length) {
        const row = fresh || (deck.instant && deck.from !== instant) ? next.start : sameRow(next);
        instant = deck.instant ? deck.from : null;
        if (handles.isHeld()) {
            if (drawing.updateBriefly(next)) /* what is held stays, whatever becomes of the linkage */
                controls.renew(drawing.row());
        } else if (drawing && drawing.update(next)) {
            controls.renew(row);
        } else {
            data = next;
            drawing = fourlink.draw(data, find("fourlink-panels"), find("diagrams"));
            controls.take(data, drawing, row);
        }
        if (startAt !== null && !handles.isHeld()) {
            controls.go(nearestStep(next, startAt));
            startAt = null;
        }
        zoom(drawing);
        handles.take(data, drawing);
        window.fourlinkPage.firstDrawing = window.fourlinkPage.firstDrawing || performance.now();
        window.fourlinkPage.times.push(performance.now() - begun);
    } else if (!handles.isHeld()) {
        data = drawing = null;
        find("fourlink-panels").replaceChildren();
        find("diagrams").replaceChildren();
    }
    if (handles.isHeld())
        return; /* the rest is shown when it is let go */
    shown = {};
    offer();
    fill();
}

/* Give the text to the program; while it works, only the newest text waits. */
async function evaluate() {
    const text = editor.text();
    const [undo, redo] = editor.can();
    find("undo").disabled = !undo;
    find("redo").disabled = !redo;
    if (working) {
        again = true;
        if (restart === null)
            restart = setTimeout(() => program.stop("stopped"), 3000);
        return;
    }
    working = true;
    again = false;
    if (text !== textOfSolution)
        solution = 1;
    try {
        const answer = await program.ask("open", {name, text, held: handles.isHeld(), branch: handles.isHeld() ? branchNumber() : 0, solution});
        take(answer);
        fresh = false;
    } catch (error) {
        if (!again)
            fail(error);
    }
    clearTimeout(restart);
    restart = null;
    working = false;
    if (again)
        evaluate();
}

/* Once the address carries a deck it follows the text. */
let following = null;

async function relink() {
    history.replaceState(null, "", await web.link.make(name, editor.text()));
}
function follow() {
    clearTimeout(following);
    if (/^#(deck|plain)=/.test(location.hash))
        following = setTimeout(relink, 300);
}

/* The name of a file for a text: its title in small letters. */
function nameFor(text) {
    const title = titleOf(text).normalize("NFKD").replace(/[\u0300-\u036f]/g, "").toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "");
    return (title.slice(0, 40).replace(/-$/, "") || "my") + ".deck";
}
function rename(newName) {
    name = newName;
    find("name").value = name;
}

function load(newName, text, isFirst) {
    if (text.length > MOST_TEXT) {
        tell(text.length > LARGEST ? newName + ": larger than 64 MB: not a deck"
            : newName + ": " + TOO_LARGE);
        return;
    }
    rename(newName);
    fresh = true;
    editor.close();
    const words = text.replace(/\r\n?/g, "\n");
    if (isFirst)
        editor.begin(words);
    else if (words === editor.text())
        evaluate();
    else
        editor.put(words);
}

/* ------------------------------------------------------------------------------------------------ the views */

function branchNow() {
    return drawing ? drawing.branch() : 0;
}
const branchNumber = () => data && data.branches[branchNow()] && data.branches[branchNow()].name === "crossed" ? -1 : 1;

function seen(i) {
    handles.show();
    if (handles.isHeld())
        return;
    if (curve)
        curve(i, branchNow());
    fillOne("table"); /* of the other branch */
    markRow(i);
}

/* Mark the row of the table that is nearest to what is shown. */
let rowValues = [];
function markRow(i) {
    const marked = find("table-place").querySelector("tr.now"), lines = find("table-place").querySelectorAll("tbody tr");
    if (!data || !rowValues.length)
        return;
    const nearest = rowValues.reduce((best, x, k) => Math.abs(x - data.steps[i]) < Math.abs(rowValues[best] - data.steps[i]) ? k : best, 0);
    if (marked === lines[nearest])
        return;
    if (marked)
        marked.classList.remove("now");
    lines[nearest].classList.add("now");
    if (!find("view-table").hidden)
        keepInSight(find("table-place"), lines[nearest]);
}
function keepInSight(place, line) {
    const head = place.querySelector("thead").offsetHeight, from = line.offsetTop - head, to = line.offsetTop + line.offsetHeight;
    if (from < place.scrollTop || to > place.scrollTop + place.clientHeight)
        place.scrollTop = from - (place.clientHeight - head) / 2;
}

/* The names that the curve can have. */
function offer() {
    const names = deck.all.map((c) => c.name), further = html("option", {value: ""}, "none");
    for (const [id, usual] of [["curve-x", "theta2"], ["curve-y", names.includes("Ts") ? "Ts" : "theta4"], ["curve-y2", ""], ["curve-y3", ""], ["curve-y4", ""]]) {
        const select = find(id), before = select.value || usual;
        if (select.dataset.names !== names.join()) {
            const fallback = id === "curve-x" ? names[0] : usual ? (deck.columns.find((c) => c.name !== "theta2") || deck.all[0]).name : "";
            select.replaceChildren(...(usual ? [] : [further.cloneNode(true)]),
                                   ...deck.all.map((c) => html("option", {value: c.name, title: c.meaning}, c.name)));
            select.dataset.names = names.join();
            select.value = names.includes(before) || before === "" ? before : fallback;
        }
    }
}

const views = {
    async curve() {
        const x = find("curve-x").value, names = [...new Set(CURVES.map((id) => find(id).value).filter((name) => name))];
        const {over, figure} = await program.ask("curve", {names: [x, ...names]});
        find("curve-place").innerHTML = figure;
        const sheet = find("curve-place").querySelector("svg");
        if (sheet)
            sheet.style.setProperty("--aspect", sheet.viewBox.baseVal.width / sheet.viewBox.baseVal.height);
        curve = fourlink.cursor(find("curve-place"), over, (i) => controls.go(i));
        curve(drawing ? drawing.row() : 0, branchNow());
    },
    async table() {
        const branch = branchNumber(), count = Math.min(PAGE, deck.rows - first), width = deck.columns.length;
        const {rows} = await program.ask("rows", {branch, first, count, width});
        const over = Math.max(0, deck.columns.findIndex((c) => c.name === data.over));
        web.tables.table(find("table-place"), deck.columns, data.columns, rows);
        rowValues = deck.columns[over].name === data.over ? rows.map((row) => row.values[over]) : [];
        find("table-place").querySelectorAll("tbody tr").forEach((line, k) => line.addEventListener("click", () => {
            controls.stop();
            if (rowValues.length)
                controls.go(nearestStep(data, rowValues[k]));
        }));
        find("pages").hidden = deck.rows <= PAGE;
        find("rows-shown").textContent = "rows " + (first + 1) + " to " + (first + count) + " of " + deck.rows +
            (data.branches.length > 1 ? ", " + data.branches[branchNow()].name : "");
        find("rows-before").disabled = first === 0;
        find("rows-after").disabled = first + count >= deck.rows;
        markRow(drawing.row());
    },
    async facts() {
        const {out} = await runShown(["--summary", "--format=json", "--units=" + (data ? data.units.length : "m")]), facts = JSON.parse(out || "{}").facts || [];
        const parts = facts.map((fact) => /^(?:(\w+)\()?(.*?)\)?$/.exec(fact.name));
        const {labels} = await program.ask("labels", {names: parts.map((part) => part[2])});
        const list = facts.map((fact, k) => ({...fact, of: parts[k][1] || "", label: labels[k]}));
        web.tables.facts(find("facts-place"), list, data ? data.units.angle : "deg", goToAngle);
    },
    async checks() {
        const {out} = deck.expected ? await runShown(["--check"]) : {out: ""};
        find("no-checks").hidden = deck.expected > 0;
        web.tables.checks(find("checks-place"), out, editor.select);
    },
    async solutions() {
        find("no-solutions").hidden = hasTask();
        const {out} = hasTask() ? await runShown([]) : {out: ""};
        web.tables.solutions(find("solutions-place"), out, solution, (k) => {
            solution = k;
            textOfSolution = editor.text();
            evaluate();
        });
    }
};

const isOpen = (id) => id === "curve" || !find("view-" + id).hidden;

/* Of the table, what it shows: a branch, and its first row. */
const stateOf = (which) => which === "table" ? branchNumber() + ":" + first : true;

/* Fill a view, unless it is up to date; once more, if something has changed meanwhile. */
async function fillOne(which) {
    if (!deck.usable || !isOpen(which) || (which === "table" && !data))
        return;
    first = Math.min(first, Math.floor((deck.rows - 1) / PAGE) * PAGE);
    if (shown[which] === stateOf(which) || halted === which || asked.has(which))
        return;
    shown[which] = stateOf(which);
    filling++;
    asked.add(which);
    try {
        await views[which]();
    } catch (error) {
        shown[which] = false;
        fail(error);
        halted = which;
        evaluate(); /* the program begins anew, and has no deck yet */
    }
    asked.delete(which);
    filling--;
    fillOne(which);
}

/* Fill the views that are open. */
function fill() {
    if (deck && deck.usable)
        Object.keys(views).filter(isOpen).forEach(fillOne);
}

const tabs = [...document.querySelectorAll("[role=tab]")];
function openTab(tab) {
    for (const x of tabs) {
        x.setAttribute("aria-selected", String(x === tab));
        x.tabIndex = x === tab ? 0 : -1;
        find(x.getAttribute("aria-controls")).hidden = x !== tab;
    }
    if (tab.id === "tab-diagrams" && drawing)
        drawing.layOut();
    handles.show();
    halted = null;
    fill();
}
tabs.forEach((tab, k) => {
    tab.addEventListener("click", () => openTab(tab));
    tab.addEventListener("keydown", (event) => {
        const to = {ArrowRight: k + 1, ArrowLeft: k - 1, Home: 0, End: tabs.length - 1}[event.key];
        if (to === undefined)
            return;
        event.preventDefault();
        const next = tabs[(to + tabs.length) % tabs.length];
        next.focus();
        openTab(next);
    });
});

/* --------------------------------------------------------------------------------------------- files and links */

web.files(find, {
    name: () => name, text: editor.text, tell, relink, branch: () => data ? data.branches[branchNow()].name : "both",
    /* The crank angle of the drawing, for a deck that does not have one only. */
    angle: () => data && data.over === "theta2" && !deck.instant ? data.steps[drawing.row()] + " " + data.units.angle : "",
    run(options) {
        if (!deck || !deck.usable)
            throw new Error("the deck has mistakes");
        if (deck.rows > MOST_ROWS)
            throw new Error(limits()[0]);
        return options[0].startsWith("--format") ? runRows(options) : runShown(options);
    }
});
web.questions(find, run, (text) => load(nameFor(text), text));
web.manual(find);
web.draw(find, (text) => {
    rename(nameFor(text));
    editor.put(text);
}, (angle) => {
    startAt = angle;
    fresh = true;
    evaluate();
    handles.set(true);
    find("change").setAttribute("aria-pressed", "true");
});

find("open").addEventListener("change", async () => {
    const file = find("open").files[0];
    find("open").value = "";
    if (file && file.size > LARGEST)
        tell(file.name + ": larger than 64 MB: not a deck");
    else if (file)
        load(file.name, await file.text());
});
find("deck").addEventListener("beforeinput", (event) => {
    const words = event.data || (event.dataTransfer && event.dataTransfer.getData("text")) || "";
    if (words.length + editor.text().length > MOST_TEXT && words.length > 1000) {
        event.preventDefault();
        tell(TOO_LARGE);
    }
});
/* A deck that is pasted in place of all has a name of its own. */
let isPasted = false;
find("deck").addEventListener("paste", () => {
    const area = find("deck");
    isPasted = area.selectionEnd - area.selectionStart >= area.value.trim().length;
});
find("deck").addEventListener("input", () => {
    if (isPasted && /^\s*mechanism\s*=/m.test(find("deck").value)) {
        fresh = true;
        rename(nameFor(find("deck").value));
        evaluate();
    }
    isPasted = false;
});
find("name").addEventListener("change", () => {
    rename(find("name").value.trim() || "my.deck");
    follow();
    evaluate();
});

/* ------------------------------------------------------------------------------------------------ the rest */

const KINDS = [["four-bar", "Four-bar linkages"], ["slider-crank", "Slider-cranks"],
               ["inverted-slider-crank", "Inverted slider-cranks"], ["scotch-yoke", "Scotch yokes"]];
const titleOf = (text) => {
    const found = /^\s*title\s*=\s*"?(.*?)"?\s*$/m.exec(text);
    return found ? found[1].replace(/\s[#;].*/, "") : "";
};
const offerGroup = (label, files, words) => find("example").append(html("optgroup", {label},
    ...files.map((file) => html("option", {value: file}, words(file)))));

offerGroup("New deck", Object.keys(templates).filter((file) => file.startsWith("new-")), (file) => titleOf(templates[file]));
const TASKS = [["function", "A function"], ["motion", "Three positions"], ["path", "A path"], ["quick-return", "A quick return"], ["cognate", "A cognate"]];
for (const [kind, label] of KINDS)
    offerGroup(label, Object.keys(examples).filter((file) => (/^\s*mechanism\s*=\s*(\S+)/m.exec(examples[file]) || [])[1] === kind),
               (file) => titleOf(examples[file]) || file);
for (const [task, label] of TASKS) {
    const files = Object.keys({...templates, ...designs}).filter((file) => web.text.value({...templates, ...designs}[file], "synthesis", "task") === task);
    if (files.length)
        find("design").append(html("optgroup", {label}, ...files.map((file) => html("option", {value: file}, titleOf({...templates, ...designs}[file]) || file))));
}
for (const id of ["example", "design"])
    find(id).addEventListener("change", () => {
        const file = find(id).value, text = {...examples, ...templates, ...(id === "design" ? designs : {})}[file];
        find(id).value = "";
        if (text === undefined)
            return;
        load(file, text);
        if (id === "design")
            openTab(find("tab-solutions"));
    });
find("add").append(...[["point", "a point"], ["load", "a load"], ["masses", "masses"]].map(([value, words]) => html("option", {value}, words)));
find("add").addEventListener("change", () => {
    const kind = find("add").value;
    find("add").value = "";
    if (kind) {
        editor.close();
        editor.put(web.drawn.added[kind](editor.text()));
    }
});
find("undo").addEventListener("click", () => editor.undo());
find("redo").addEventListener("click", () => editor.redo());
find("stop").addEventListener("click", () => program.stop());
find("change").addEventListener("click", () => {
    const on = find("change").getAttribute("aria-pressed") !== "true";
    find("change").setAttribute("aria-pressed", String(on));
    handles.set(on);
});
handles.onRelease(evaluate);
for (const id of ["curve-x", ...CURVES])
    find(id).addEventListener("change", () => {
        shown.curve = false;
        halted = null;
        fill();
    });
for (const [id, way] of [["rows-before", -PAGE], ["rows-after", PAGE]])
    find(id).addEventListener("click", () => {
        first = Math.max(0, first + way);
        shown.table = false;
        fill();
    });
window.addEventListener("beforeprint", () => {
    find("printed-title").textContent = deck && deck.title ? deck.title : name;
    find("printed").textContent = editor.text();
});
window.addEventListener("resize", () => handles.show()); /* the drawing has found its new scale */

/* For the tests: whether all is answered and drawn, and how long that took, in ms. */
window.fourlinkPage = {isIdle: () => !working && !again && filling === 0, firstDrawing: 0, times: []};

/* The page begins in motion; whoever touches it, or wants less motion, has it still. */
function playFirst() {
    if (window.matchMedia("(prefers-reduced-motion: reduce)").matches)
        return;
    let waits = setInterval(() => {
        if (!drawing)
            return;
        clearInterval(waits);
        waits = null;
        controls.play();
    }, 50);
    const still = (event) => {
        clearInterval(waits);
        if (event.target !== find("fourlink-play"))
            controls.stop();
        for (const kind of ["pointerdown", "keydown", "input", "change"])
            document.removeEventListener(kind, still, true);
    };
    for (const kind of ["pointerdown", "keydown", "input", "change"])
        document.addEventListener(kind, still, true);
}

async function begin(isFirst) {
    if (isFirst)
        document.head.append(html("style", {}, (await program.ask("style", {})).text));
    const linked = await web.link.read(location.hash);
    if (linked)
        load(linked.name, linked.text, isFirst);
    else if (isFirst) {
        load("crank-rocker.deck", templates[FIRST], true);
        playFirst();
    }
    if (!linked && /^#(deck|plain)=/.test(location.hash))
        tell("The link is damaged: it has no deck.");
}
window.addEventListener("hashchange", () => begin(false));
begin(true);
}());
