/* SPDX-License-Identifier: GPL-3.0-or-later
**
** elements.js - elements, texts and files for the scripts of a report and of the page.
*/
"use strict";

const fourlink = (function () {

function element(space, name, attributes, children) {
    const made = document.createElementNS(space, name);
    for (const key in attributes)
        if (attributes[key] !== null)
            made.setAttribute(key, attributes[key]);
    made.append(...(children || []));
    return made;
}

function html(name, attributes, ...children) {
    return element("http://www.w3.org/1999/xhtml", name, attributes, children);
}

function svg(name, attributes, ...children) {
    return element("http://www.w3.org/2000/svg", name, attributes, children);
}

/* A unit as it is written by hand: m/s2 becomes m/s². */
function unitText(unit) {
    return unit === "1" ? "" : unit === "deg" ? "°" : unit.replace(/2/g, "²").replace(/3/g, "³").replace(/\./g, "·");
}

/* A number, already in words, with its unit. */
function withUnit(words, unit) {
    const shown = unitText(unit);
    return words + (shown && shown !== "°" ? "\u00a0" : "") + shown;
}

/* Step i of the motion, in the deck's unit: its crank angle, or its time if the deck has rows by time. */
function stepText(data, i) {
    const text = String(Number(data.steps[i].toPrecision(6))).replace("-", "−"), unit = data.units[data.over === "time" ? "time" : "angle"];
    return withUnit(text, unit).replace("\u00a0", " ");
}

/* A number as the program's table writes it. */
function cellText(column, value) {
    if (typeof value !== "number")
        return value === null ? "–" : value;
    const text = column.form === "angle" ? String(value) : column.form === "exponent"
        ? value.toExponential(column.decimals) : value.toFixed(column.decimals);
    return text.replace(/^-(?=[0.]+$)/, "");
}

/* Save words as a file. */
function save(file, type, words) {
    const address = URL.createObjectURL(new Blob([words], {type}));
    html("a", {href: address, download: file}).click();
    setTimeout(() => URL.revokeObjectURL(address), 1000);
}

/* Where a pointer is in a drawing, in its pixels. */
function placeOf(event, sheet) {
    const {x, y} = new DOMPoint(event.clientX, event.clientY).matrixTransform(sheet.getScreenCTM().inverse());
    return [x, y];
}

/* Let a drawing have all that a pointer does until it is up. */
function hold(event, sheet) {
    event.preventDefault();
    try {
        sheet.setPointerCapture(event.pointerId);
    } catch (error) { /* a pointer that is already gone */ }
}

/* A label is [name, subscript, superscript].  A short name of the program's own is a variable, in italics. */
function isVariable(label) {
    return label[1] !== "" || label[0].length === 1;
}

function htmlLabel(label) {
    const parts = label[0].split(/(?<=_)/).flatMap((part, k) => k ? [html("wbr"), part] : [part]); /* lines may end there */
    const made = html("span", {}, html(isVariable(label) ? "i" : "span", {}, ...parts));
    if (label[1])
        made.append(html("sub", {}, label[1]));
    if (label[2])
        made.append(html("sup", {}, label[2]));
    return made;
}

return {html, svg, unitText, withUnit, stepText, cellText, save, placeOf, hold, isVariable, htmlLabel};
}());
