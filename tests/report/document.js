/* SPDX-License-Identifier: GPL-3.0-or-later
**
** document.js - a document for node that is just large enough for the scripts of a report.
**
**    scriptOf(FILES, width)    the scripts run, with panels of this width; 0: each has its own.  Returns `fourlink`.
**    LETTER                    the width of all letters
*/
"use strict";

const fs = require("node:fs");

const LETTER = 7.8;

class Element {
    constructor(name) {
        Object.assign(this, {tagName: name, attributes: {}, children: [], words: "", style: {setProperty() {}}, dataset: {}, parentNode: null, hidden: false});
    }
    setAttribute(name, value) { this.attributes[name] = String(value); }
    getAttribute(name) { return name in this.attributes ? this.attributes[name] : null; }
    closest() { return null; } /* nothing is hidden */
    append(...items) {
        for (const item of items)
            if (item instanceof Element) {
                if (item.parentNode)
                    item.parentNode.children = item.parentNode.children.filter((x) => x !== item);
                item.parentNode = this;
                this.children.push(item);
            } else {
                const text = new Element("#text");
                text.words = String(item);
                this.children.push(text);
            }
    }
    replaceChildren(...items) {
        this.children.forEach((x) => { x.parentNode = null; });
        this.children = [];
        this.append(...items);
    }
    set textContent(words) {
        this.children = [];
        this.words = String(words);
    }
    getComputedTextLength() { return LETTER * this.textContent.length; }
    get textContent() { return this.words + this.children.map((x) => x.textContent).join(""); }
}

/* Elements below one, in the order of the document; those that are not shown and all below them are left out. */
function* below(element) {
    for (const child of element.children)
        if (!child.hidden && child.getAttribute("display") !== "none") {
            yield child;
            yield* below(child);
        }
}

function scriptOf(files, width) {
    const STYLE = {fontSize: "14px", stroke: "none", strokeWidth: "0"};
    class Sized extends Element {
        get clientWidth() { return width; }
    }
    const document = {createElementNS: (space, name) => new Sized(name), getElementById: () => null, querySelectorAll: () => []};
    const words = files.map((file) => fs.readFileSync(file, "utf8")).join("\n");
    return {Element: Sized, fourlink: new Function("document", "window", words + "\nreturn fourlink;")(document, {addEventListener: () => {}, getComputedStyle: () => STYLE})};
}

module.exports = {below, scriptOf, LETTER};
