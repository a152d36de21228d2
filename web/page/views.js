/* SPDX-License-Identifier: GPL-3.0-or-later
**
** views.js - what is shown beside the drawing: curve, table, facts, solutions, checks; each is filled when it is seen.  The
** position of the drawing is marked in curve and table, and a click there goes to another one.
**
** `page` has ask(TASK, GIVEN), run(OPTIONS) of the command, hasTask(), select(LINE), controls, solution(), choose(K),
** failed(ERROR), isUsable(), whether the deck has no mistakes, and wantDiagrams(), which is called when they are seen.
*/
web.views = function (find, page) {

const {html} = fourlink;
const CURVES = ["curve-y", "curve-y2", "curve-y3", "curve-y4"], PAGE = 200;
let deck = null, data = null, drawing = null;
let first = 0, shown = {}, asked = new Set(), filling = 0, halted = null; /* a view that was stopped */
let curve = null; /* the cursor of the curves */

/* ------------------------------------------------------------------------------------------------ the position */

/* Where a list is nearest to a number; of several places the one to begin with, or the first. */
function nearest(list, wanted, begin = 0) {
    return list.reduce((best, x, i) => Math.abs(x - wanted) < Math.abs(list[best] - wanted) ? i : best, begin);
}

/* The step of a drawing that is nearest to an angle or a time. */
const nearestStep = (of, wanted) => nearest(of.steps, wanted, of.start);

const TURN = {deg: 360, rad: 2 * Math.PI, mrad: 2000 * Math.PI, rev: 1};

/* Go to a crank angle; turns are not counted. */
function goToAngle(angle) {
    if (!data || data.over !== "theta2")
        return;
    const turn = TURN[data.units.angle], off = data.steps.map((x) => Math.abs(x - angle - turn * Math.round((x - angle) / turn)));
    page.controls.stop();
    page.controls.go(off.indexOf(Math.min(...off)));
}

function branchNow() {
    return drawing ? drawing.branch() : 0;
}
const branchNumber = () => data && data.branches[branchNow()] && data.branches[branchNow()].name === "crossed" ? -1 : 1;

function seen(i) {
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
    const line = lines[nearest(rowValues, data.steps[i])];
    if (marked === line)
        return;
    if (marked)
        marked.classList.remove("now");
    line.classList.add("now");
    if (!find("view-table").hidden)
        keepInSight(find("table-place"), line);
}
function keepInSight(place, line) {
    const head = place.querySelector("thead").offsetHeight, from = line.offsetTop - head, to = line.offsetTop + line.offsetHeight;
    if (from < place.scrollTop || to > place.scrollTop + place.clientHeight)
        place.scrollTop = from - (place.clientHeight - head) / 2;
}

/* ------------------------------------------------------------------------------------------------ the views */

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

const fillers = {
    async curve() {
        const x = find("curve-x").value, names = [...new Set(CURVES.map((id) => find(id).value).filter((name) => name))];
        const {over, figure} = await page.ask("curve", {names: [x, ...names]});
        find("curve-place").innerHTML = figure;
        const sheet = find("curve-place").querySelector("svg");
        if (sheet)
            sheet.style.setProperty("--aspect", sheet.viewBox.baseVal.width / sheet.viewBox.baseVal.height);
        curve = fourlink.cursor(find("curve-place"), over, (i) => page.controls.go(i));
        curve(drawing ? drawing.row() : 0, branchNow());
    },
    async table() {
        const branch = branchNumber(), count = Math.min(PAGE, deck.rows - first), width = deck.columns.length;
        const {rows} = await page.ask("rows", {branch, first, count, width});
        const over = Math.max(0, deck.columns.findIndex((c) => c.name === data.over));
        web.tables.table(find("table-place"), deck.columns, data.columns, rows);
        rowValues = deck.columns[over].name === data.over ? rows.map((row) => row.values[over]) : [];
        find("table-place").querySelectorAll("tbody tr").forEach((line, k) => line.addEventListener("click", () => {
            page.controls.stop();
            if (rowValues.length)
                page.controls.go(nearestStep(data, rowValues[k]));
        }));
        find("pages").hidden = deck.rows <= PAGE;
        find("rows-shown").textContent = "rows " + (first + 1) + " to " + (first + count) + " of " + deck.rows +
            (data.branches.length > 1 ? ", " + data.branches[branchNow()].name : "");
        find("rows-before").disabled = first === 0;
        find("rows-after").disabled = first + count >= deck.rows;
        markRow(drawing.row());
    },
    async facts() {
        const {out} = await page.run(["--summary", "--format=json", "--units=" + (data ? data.units.length : "m")]), facts = JSON.parse(out || "{}").facts || [];
        const parts = facts.map((fact) => /^(?:(\w+)\()?(.*?)\)?$/.exec(fact.name));
        const {labels} = await page.ask("labels", {names: parts.map((part) => part[2])});
        const list = facts.map((fact, k) => ({...fact, of: parts[k][1] || "", label: labels[k]}));
        web.tables.facts(find("facts-place"), list, data ? data.units.angle : "deg", goToAngle);
    },
    async checks() {
        const {out} = deck.expected ? await page.run(["--check"]) : {out: ""};
        find("no-checks").hidden = deck.expected > 0;
        web.tables.checks(find("checks-place"), out, page.select);
    },
    async solutions() {
        find("no-solutions").hidden = page.hasTask();
        const {out} = page.hasTask() ? await page.run([]) : {out: ""};
        web.tables.solutions(find("solutions-place"), out, page.solution(), page.choose);
    }
};

const isOpen = (id) => id === "curve" || !find("view-" + id).hidden;

/* Of the table, what it shows: a branch, and its first row. */
const stateOf = (which) => which === "table" ? branchNumber() + ":" + first : true;

/* Fill a view, unless it is up to date; once more, if something has changed meanwhile. */
async function fillOne(which) {
    if (!deck || !page.isUsable() || !isOpen(which) || (which === "table" && !data))
        return;
    first = Math.min(first, Math.floor((deck.rows - 1) / PAGE) * PAGE);
    if (shown[which] === stateOf(which) || halted === which || asked.has(which))
        return;
    shown[which] = stateOf(which);
    filling++;
    asked.add(which);
    try {
        await fillers[which]();
    } catch (error) {
        shown[which] = false;
        halted = which;
        page.failed(error);
    }
    asked.delete(which);
    filling--;
    fillOne(which);
}

/* Fill the views that are open. */
function fill() {
    Object.keys(fillers).filter(isOpen).forEach(fillOne);
}

const tabs = [...document.querySelectorAll("[role=tab]")];
function openTab(tab) {
    for (const x of tabs) {
        x.setAttribute("aria-selected", String(x === tab));
        x.tabIndex = x === tab ? 0 : -1;
        find(x.getAttribute("aria-controls")).hidden = x !== tab;
    }
    if (tab.id === "tab-diagrams" && drawing) {
        drawing.layOut();
        page.wantDiagrams();
    }
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

return {
    /* A deck, its drawing and the drawing's data, which may be null. */
    take(newDeck, newData, newDrawing) {
        [deck, data, drawing] = [newDeck, newData, newDrawing];
        shown = {};
        offer();
        fill();
    },
    seen, nearestStep, isOpen,
    branch: () => ({number: branchNumber(), name: data ? data.branches[branchNow()].name : ""}),
    open: (id) => openTab(find("tab-" + id)),
    retry() { halted = null; },
    isIdle: () => filling === 0
};
};
