/* SPDX-License-Identifier: GPL-3.0-or-later
**
** main.js - the page: the deck in its editor goes to the program, its answer to the views.
*/
(function () {

const {html} = fourlink;
const find = (id) => document.getElementById(id);
const NOTICE = 12000;
const MOST_TEXT = 1e5, LARGEST = 64e6, MOST_ROWS = 100000;
const TOO_LARGE = "larger than 100 kB: the page edits smaller decks; use the program itself";
let name = "my.deck", deck = null, data = null, drawing = null, working = false, again = false, restart = null;
let instant = null, fresh = true; /* a new deck begins at its own crank angle */
let wasHeld = false; /* when the deck was opened last */
let solution = 1, textOfSolution = null; /* of its [synthesis], and the text whose solution was chosen */
let startAt = null; /* the crank angle at which a linkage was drawn */
let drawnDeck = ""; /* the kind and title of what was drawn last */

const program = web.program((is) => { find("busy").hidden = !is; });
const editor = web.editor(find("deck"), find("gutter"), find("layer"), () => {
    views.retry();
    follow();
    evaluate();
});
const handles = web.handles(editor, program.ask, () => {
    controls.stop();
    if (data.over === "theta2")
        controls.go(data.start);
});
const zoom = web.zoom(find, () => handles.show());
const controls = fourlink.controls((id) => find("fourlink-" + id), (i) => {
    handles.show();
    if (!handles.isHeld())
        views.seen(i);
});
const views = web.views(find, {ask: program.ask, run: (options) => runShown(options), hasTask: () => hasTask(), select: editor.select, controls,
                               solution: () => solution, choose, failed,
                               isUsable: () => Boolean(deck && deck.usable),
                               /* The diagrams are seen: they have not been drawn yet. */
                               wantDiagrams: () => drawing && drawing.panels.length < 2 && evaluate()});

function fail(error) {
    tell(error.message === "stopped" ? "Stopped." : "This failed: " + error.message);
}

/* A view could not be filled: the program begins anew, and has no deck yet. */
function failed(error) {
    fail(error);
    evaluate();
}

/* Show a solution of the [synthesis]. */
function choose(k) {
    solution = k;
    textOfSolution = editor.text();
    evaluate();
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
            ". A saved table has all." : ""].filter((x) => x);
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

/* The step of the next drawing that is nearest to what is now shown; as drawn it stays as drawn. */
function sameRow(next) {
    if (next.page && data && drawing && drawing.row() === data.start)
        return next.start;
    return data && drawing && data.over === next.over ? views.nearestStep(next, data.steps[drawing.row()]) : next.start;
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
            if (drawing.updateBriefly(next, row)) /* what is held stays, whatever becomes of the linkage */
                controls.renew(row);
        } else if (drawing && drawing.update(next)) {
            controls.renew(row);
        } else {
            const isSame = deck.kind + deck.title === drawnDeck; /* edited, or with its diagrams: its branch stays */
            const before = isSame ? views.branch().name : "", plays = isSame && find("fourlink-play").textContent === "Pause";
            drawnDeck = deck.kind + deck.title;
            data = next;
            drawing = fourlink.draw(data, find("fourlink-panels"), find("diagrams"));
            drawing.choose(Math.max(0, data.branches.findIndex((x) => x.name === before)));
            controls.take(data, drawing, row);
            if (plays)
                controls.play();
        }
        if (startAt !== null && !handles.isHeld()) {
            controls.go(views.nearestStep(next, startAt));
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
    if (!handles.isHeld()) /* the rest is shown when it is let go */
        views.take(deck, data, drawing);
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
    const held = handles.isHeld(), letGo = wasHeld && !held;
    if (held)
        textOfSolution = text;
    else if (text !== textOfSolution)
        solution = 1;
    wasHeld = held;
    try {
        const answer = await program.ask("open", {name, text, held, letGo, branch: held ? views.branch().number : 0, brief: !views.isOpen("diagrams"),
                                                  solution: held || letGo ? 1 : solution});
        if (letGo)
            solution = answer.deck.solution || 1;
        take(answer);
        fresh = false;
        if (!deck.usable && solution > 1) { /* there may be fewer than before */
            solution = 1;
            again = true;
        }
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
    const title = web.text.titleOf(text).normalize("NFKD").replace(/[\u0300-\u036f]/g, "").toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "");
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

/* --------------------------------------------------------------------------------------------- files and links */

web.files(find, {
    name: () => name, text: editor.text, tell, relink, branch: () => data ? views.branch().name : "both",
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
/* A link of PMKS+ becomes its deck, with what it has no place for in comments. */
const LINK = /^\s*(https?:\S*\?)?j=/;

async function importLink(text) {
    const {out, messages} = await program.ask("run", {name: "link.txt", text, options: ["--import"]});
    if (out)
        load("linkage.deck", messages.replace(/^.*?: note: /gm, "# ") + out);
    else
        tell(messages.trim());
}
find("deck").addEventListener("input", () => {
    if (isPasted && LINK.test(find("deck").value))
        importLink(find("deck").value);
    else if (isPasted && /^\s*mechanism\s*=/m.test(find("deck").value)) {
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

const menus = web.menus(find, (file, text, isDesign) => {
    load(file, text);
    if (isDesign)
        views.open("solutions");
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
window.addEventListener("beforeprint", () => {
    find("printed-title").textContent = deck && deck.title ? deck.title : name;
    find("printed").textContent = editor.text();
});
window.addEventListener("resize", () => handles.show()); /* the drawing has found its new scale */

/* For the tests: whether all is answered and drawn, and how long that took, in ms. */
window.fourlinkPage = {isIdle: () => !working && !again && views.isIdle(), firstDrawing: 0, times: []};

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
        load("crank-rocker.deck", menus.first, true);
        playFirst();
    }
    if (!linked && /^#(deck|plain)=/.test(location.hash))
        tell("The link is damaged: it has no deck.");
}
window.addEventListener("hashchange", () => begin(false));
begin(true);
}());
