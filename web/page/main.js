/* SPDX-License-Identifier: GPL-3.0-or-later
**
** main.js - the page: the deck in its editor goes to the program, its answer to the views.
*/
(function () {

const {html, save} = fourlink;
const find = (id) => document.getElementById(id);
const examples = JSON.parse(find("examples").textContent), templates = JSON.parse(find("templates").textContent);
const CURVES = ["curve-y", "curve-y2", "curve-y3", "curve-y4"];
const MOST_TEXT = 1e5, LARGEST = 64e6, MOST_ROWS = 100000, PAGE = 200;
const TOO_LARGE = "larger than 100 kB: the page edits smaller decks; use the program itself";
let name = "my.deck", deck = null, data = null, drawing = null, working = false, again = false, restart = null;
let instant = null, fresh = true; /* a new deck begins at its own crank angle */
let first = 0, shown = {}, filling = 0, halted = null; /* a view that was stopped */

const program = web.program((is) => { find("busy").hidden = !is; });
const editor = web.editor(find("deck"), find("gutter"), find("layer"), () => {
    halted = null;
    follow();
    evaluate();
});
const handles = web.handles(editor, program.ask);
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
    quiet = setTimeout(() => { find("notice").textContent = ""; }, 12000);
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

/* The row of the drawing that is nearest to the angle or the time now shown. */
function sameRow(next) {
    const now = data && drawing && data.over === next.over ? data.steps[drawing.row()] : undefined;
    let best = next.start;
    if (now !== undefined)
        next.steps.forEach((x, i) => { best = Math.abs(x - now) < Math.abs(next.steps[best] - now) ? i : best; });
    return best;
}

function take(answer) {
    const begun = performance.now();
    const next = answer.scene && JSON.parse(answer.scene);
    deck = answer.deck;
    showMessages(deck.messages, deck.more, limits());
    find("results").classList.toggle("stale", !deck.usable);
    find("stale").hidden = deck.usable;
    if (!deck.usable)
        return;
    document.title = (deck.title || name) + " \u2013 fourlink";
    find("no-drawing").hidden = Boolean(next && next.branches.length);
    if (next && next.branches.length) {
        const row = fresh || (deck.instant && deck.from !== instant) ? next.start : sameRow(next);
        instant = deck.instant ? deck.from : null;
        if (drawing && drawing.update(next)) {
            controls.renew(row);
        } else {
            data = next;
            drawing = fourlink.draw(data, find("fourlink-panels"));
            controls.take(data, drawing, row);
        }
        handles.take(data, drawing);
        window.fourlinkPage.firstDrawing = window.fourlinkPage.firstDrawing || performance.now();
        window.fourlinkPage.times.push(performance.now() - begun);
    } else {
        data = drawing = null;
        find("fourlink-panels").replaceChildren();
    }
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
    try {
        const answer = await program.ask("open", {name, text, held: handles.isHeld()});
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
    if (!find("view-curve").hidden && curve)
        curve(i, branchNow());
    if (!find("view-table").hidden && shown.table !== branchNumber() + ":" + first)
        fill();
}

/* The names that the curve can have. */
function offer() {
    const names = deck.all.map((c) => c.name), further = html("option", {value: ""}, "none");
    for (const [id, usual] of [["curve-x", "theta2"], ["curve-y", "theta4"], ["curve-y2", ""], ["curve-y3", ""], ["curve-y4", ""]]) {
        const select = find(id), before = select.value || usual;
        if (select.dataset.names !== names.join()) {
            const fallback = id === "curve-x" ? names[0] : usual ? (deck.columns.find((c) => c.name !== "theta2") || deck.all[0]).name : "";
            select.replaceChildren(...(usual ? [] : [further.cloneNode(true)]),
                                   ...deck.all.map((c) => html("option", {value: c.name, title: c.meaning}, c.name)));
            select.dataset.names = names.join();
            select.value = names.includes(before) || before === "" ? before : fallback;
        }
    }
    find("tab-checks").disabled = false;
}

const views = {
    async curve() {
        const x = find("curve-x").value, names = [...new Set(CURVES.map((id) => find(id).value).filter((name) => name))];
        const {over, figure} = await program.ask("curve", {names: [x, ...names]});
        find("curve-place").innerHTML = figure;
        curve = fourlink.cursor(find("curve-place"), over, (i) => controls.go(i));
        curve(drawing ? drawing.row() : 0, branchNow());
    },
    async table() {
        const branch = branchNumber(), count = Math.min(PAGE, deck.rows - first), width = deck.columns.length;
        const {rows} = await program.ask("rows", {branch, first, count, width});
        web.tables.table(find("table-place"), deck.columns, data.columns, rows);
        find("rows-shown").textContent = "rows " + (first + 1) + " to " + (first + count) + " of " + deck.rows +
            (data.branches.length > 1 ? ", " + data.branches[branchNow()].name : "");
        find("rows-before").disabled = first === 0;
        find("rows-after").disabled = first + count >= deck.rows;
        shown.table = branch + ":" + first;
    },
    async facts() {
        const {facts} = await program.ask("facts", {});
        web.tables.facts(find("facts-place"), facts, data ? data.units.angle : "deg");
    },
    async checks() {
        const {text} = deck.expected ? await program.ask("sheet", {format: "table", content: "check"}) : {text: ""};
        find("no-checks").hidden = deck.expected > 0;
        web.tables.checks(find("checks-place"), text, editor.select);
    }
};

/* Fill the view that is open, unless it is up to date. */
async function fill() {
    const which = Object.keys(views).find((id) => !find("view-" + id).hidden);
    if (!which || !deck || !deck.usable || (which === "table" && !data))
        return;
    if (which === "table")
        first = Math.min(first, Math.floor((deck.rows - 1) / PAGE) * PAGE);
    if (shown[which] === true || halted === which)
        return;
    if (which !== "table")
        shown[which] = true;
    filling++;
    try {
        await views[which]();
    } catch (error) {
        shown[which] = false;
        fail(error);
        halted = which;
        evaluate(); /* the program begins anew, and has no deck yet */
    }
    filling--;
}

const tabs = [...document.querySelectorAll("[role=tab]")];
function openTab(tab) {
    for (const x of tabs) {
        x.setAttribute("aria-selected", String(x === tab));
        x.tabIndex = x === tab ? 0 : -1;
        find(x.getAttribute("aria-controls")).hidden = x !== tab;
    }
    if (tab.id === "tab-drawing" && drawing)
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

const own = (id) => find(id).textContent.trimStart();
const stem = () => name.replace(/\.deck$/, "");

async function saveSheet(format, type) {
    if (!deck || !deck.usable)
        return tell("The deck has mistakes.");
    if (deck.rows > MOST_ROWS)
        return tell(limits()[0]);
    save(stem() + "." + format, type, (await program.ask("sheet", {format, content: "rows"})).text);
}

const actions = {
    async copy() {
        try {
            await navigator.clipboard.writeText(editor.text());
            tell("The deck is copied.");
        } catch (error) {
            find("deck").select();
            tell(document.execCommand("copy") ? "The deck is copied." : "The browser does not allow it to be copied.");
        }
    },
    deck: () => save(name, "text/plain", editor.text()),
    csv: () => saveSheet("csv", "text/csv"),
    json: () => saveSheet("json", "application/json"),
    async report() {
        if (!deck || !deck.usable)
            return tell("The deck has mistakes.");
        const at = data && data.over === "theta2" ? data.steps[drawing.row()] + " " + data.units.angle : "";
        const {text} = await program.ask("report", {angle: at});
        const end = text.lastIndexOf("@SCRIPT@\n"); /* the deck may have such a line too, before it */
        save(stem() + ".html", "text/html", text.slice(0, end).replace("@STYLE@\n", () => own("report-style")) +
             own("report-script") + text.slice(end + 9));
    },
    async link() {
        await relink();
        try {
            await navigator.clipboard.writeText(location.href);
            tell("The link is in the address bar, and copied.");
        } catch (error) {
            tell("The link is in the address bar.");
        }
    },
    print: () => window.print()
};
for (const id in actions)
    find("save-" + id).addEventListener("click", async () => {
        try {
            await actions[id]();
        } catch (error) {
            fail(error);
        }
        find("save-menu").open = false;
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

offerGroup("New deck", Object.keys(templates), (file) => titleOf(templates[file]));
for (const [kind, label] of KINDS)
    offerGroup(label, Object.keys(examples).filter((file) => (/^\s*mechanism\s*=\s*(\S+)/m.exec(examples[file]) || [])[1] === kind),
               (file) => titleOf(examples[file]) || file);
find("example").addEventListener("change", () => {
    const file = find("example").value, text = {...examples, ...templates}[file];
    if (text !== undefined)
        load(file, text);
    find("example").value = "";
});
find("undo").addEventListener("click", () => editor.undo());
find("redo").addEventListener("click", () => editor.redo());
find("stop").addEventListener("click", () => program.stop());
find("change").addEventListener("click", () => {
    const on = find("change").getAttribute("aria-pressed") !== "true";
    find("change").setAttribute("aria-pressed", String(on));
    handles.set(on);
});
handles.onRelease(() => {
    if (drawing)
        evaluate();
});
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
    find("printed").textContent = editor.text();
});
window.addEventListener("resize", () => handles.show()); /* the drawing has found its new scale */

/* For the tests: whether all is answered and drawn, and how long that took, in ms. */
window.fourlinkPage = {isIdle: () => !working && !again && filling === 0, firstDrawing: 0, times: []};

async function begin(isFirst) {
    if (isFirst)
        document.head.append(html("style", {}, (await program.ask("style", {})).text));
    const linked = await web.link.read(location.hash);
    if (linked)
        load(linked.name, linked.text, isFirst);
    else if (isFirst)
        load("alvi-5.1.deck", examples["alvi-5.1.deck"], true);
    if (!linked && /^#(deck|plain)=/.test(location.hash))
        tell("The link is damaged: it has no deck.");
}
window.addEventListener("hashchange", () => begin(false));
begin(true);
}());
