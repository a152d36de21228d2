/* SPDX-License-Identifier: GPL-3.0-or-later
**
** editor.js - the text of the deck: line numbers, colours, messages at their lines, undo.
**
** The text is a textarea whose letters are not seen: behind it they stand again, in colours.  A line that is longer than the
** editor is wide goes on below, in both at the same letter.  It has an undo of its own, since dragging in the drawing changes the
** text too.
*/
web.editor = function (area, gutter, layer, changed) {

const colours = layer.querySelector("pre");
const {html} = fourlink;
const LINE = 20, BORDER = 8, GAP = 16, MOST_STEPS = 500; /* px */
let steps = [], undone = [], present = {text: "", from: 0, to: 0}, group = null, time = 0, marks = [];

const snapshot = () => ({text: area.value, from: area.selectionStart, to: area.selectionEnd});

/* Keep the text before a change; changes of one kind that follow at once are one step. */
function keep(kind) {
    const now = performance.now();
    if (area.value === present.text)
        return false;
    if (kind === null || kind !== group || now - time > 1000) {
        steps.push(present);
        steps.splice(0, steps.length - MOST_STEPS);
    }
    undone = [];
    group = kind;
    time = now;
    present = snapshot();
    return true;
}

/* The numbers stand at the first rows of their lines. */
function number() {
    colour();
    layOut();
}

const escaped = (words) => words.replace(/&/g, "&amp;").replace(/</g, "&lt;");
const inColour = (kind, words) => words && "<span class=\"in-" + kind + "\">" + escaped(words) + "</span>";
const withNumbers = (words) => words.split(/(?<![\w.])([-+\u2212]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)/)
    .map((part, k) => k % 2 ? inColour("number", part) : escaped(part)).join("");

/* A line as markup: its section, key, numbers and comment in colours. */
function lineInColour(line) {
    const words = web.text.bare(line), setting = /^(\s*)([^=\[\s][^=]*?)(\s*=)(.*)$/.exec(words);
    const shown = /^\s*\[/.test(words) ? inColour("section", words)
        : setting ? setting[1] + inColour("key", setting[2]) + setting[3] + withNumbers(setting[4]) : withNumbers(words);
    return shown + inColour("comment", line.slice(words.length));
}

function colour() {
    colours.innerHTML = area.value.split("\n").map((line) => "<div>" + lineInColour(line) + "</div>").join("");
}

function layOut() {
    layer.firstChild.style.width = area.clientWidth - 2 * BORDER + "px";
    const heights = [...colours.children].map((line) => line.offsetHeight || LINE);
    gutter.firstChild.replaceChildren(...heights.map((high, i) => {
        const made = html("div", {}, String(i + 1));
        made.style.height = high + "px";
        return made;
    }));
    for (const made of marks)
        place(made);
}

/* Put a message over its line, its words behind the last letter. */
function place(made) {
    const line = colours.children[made.dataset.line - 1];
    if (!line)
        return;
    const range = document.createRange(), from = layer.firstChild.getBoundingClientRect();
    range.selectNodeContents(line);
    const last = [...range.getClientRects()].pop();
    made.style.top = line.offsetTop + "px";
    made.style.height = (line.offsetHeight || LINE) + "px";
    made.firstChild.style.left = BORDER + (last ? last.right - from.left : 0) + GAP + "px";
}

function scroll() {
    layer.firstChild.style.transform = "translateY(" + -area.scrollTop + "px)";
    gutter.firstChild.style.transform = "translateY(" + -area.scrollTop + "px)";
}

/* Show messages at the ends of their lines. */
function mark(messages) {
    const texts = area.value.split("\n"), seen = new Map();
    for (const message of messages)
        if (message.line > 0 && message.line <= texts.length)
            seen.set(message.line, (seen.get(message.line) || []).concat(message));
    marks = [...seen].map(([line, list]) => {
        const words = list.map((m) => m.text.replace(/^.*?:\d+: (error|note|defect): /, "")).join("; ");
        const made = html("div", {class: "mark " + (list.find((m) => m.kind !== "note") || list[0]).kind}, html("span", {}, words));
        made.dataset.line = line;
        return made;
    });
    layer.firstChild.replaceChildren(...marks, colours);
    marks.forEach(place);
    area.setAttribute("aria-invalid", messages.some((m) => m.kind === "error") ? "true" : "false");
}

/* Put a text in the place of all; of one kind, it is one step. */
function put(text, kind) {
    const {selectionStart, selectionEnd, scrollTop} = area;
    if (text === area.value)
        return;
    area.value = text;
    area.setSelectionRange(Math.min(selectionStart, text.length), Math.min(selectionEnd, text.length));
    area.scrollTop = scrollTop;
    if (kind === group)
        time = performance.now();
    keep(kind || null);
    number();
    scroll();
    changed();
}

/* Put the first text, which cannot be undone. */
function begin(text) {
    area.value = text;
    present = snapshot();
    number();
    changed();
}

function go(from, to) {
    if (!from.length)
        return;
    const step = from.pop(), {scrollTop} = area;
    to.push(present);
    present = step;
    group = null;
    area.value = step.text;
    area.setSelectionRange(step.from, step.to);
    area.scrollTop = scrollTop;
    number();
    scroll();
    changed();
}
const undo = () => go(steps, undone);
const redo = () => go(undone, steps);

/* Select a line, from 1. */
function select(line) {
    const before = area.value.split("\n").slice(0, line - 1).reduce((sum, x) => sum + x.length + 1, 0);
    const end = area.value.indexOf("\n", before);
    area.focus();
    area.setSelectionRange(before, end < 0 ? area.value.length : end);
    area.scrollTop = Math.max(0, colours.children[line - 1].offsetTop - area.clientHeight / 2);
}

area.addEventListener("input", (event) => {
    number();
    scroll();
    if (keep(event.inputType || null))
        changed();
});
area.addEventListener("beforeinput", (event) => {
    if (area.selectionStart !== area.selectionEnd || area.selectionStart !== present.from)
        group = null; /* elsewhere */
    if (event.inputType !== "historyUndo" && event.inputType !== "historyRedo")
        return;
    event.preventDefault();
    (event.inputType === "historyUndo" ? undo : redo)();
});
area.addEventListener("keydown", (event) => {
    const key = event.key.toLowerCase();
    if (!(event.ctrlKey || event.metaKey) || event.altKey || (key !== "z" && key !== "y"))
        return;
    event.preventDefault();
    (key === "y" || event.shiftKey ? redo : undo)();
});
area.addEventListener("scroll", scroll);
new ResizeObserver(layOut).observe(area);

return {begin, put, undo, redo, mark, select, text: () => area.value,
        can: () => [steps.length > 0, undone.length > 0],
        /* The next change begins a step. */
        close: () => { group = null; }};
};
