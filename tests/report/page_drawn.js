/* SPDX-License-Identifier: GPL-3.0-or-later
**
** page_drawn.js - runs the script of a report and writes down what it draws: the elements of each panel, for the rows
** that are asked for.  In node, with a document of its own that is just large enough:
**
**    node page_drawn.js SCRIPT INPUT OUTPUT
**
** In a browser `collect` is called with the page's document.  INPUT is a list of {data, rows}: the rows of a report,
** and by branch the numbers of the rows to draw.
*/
"use strict";

/* An element as [tag, attributes, text, children]. */
function written(element) {
    const attributes = {};
    for (const name of ["class", "points", "cx", "cy", "r", "d", "x", "y", "data-name", "aria-label"])
        if (element.getAttribute(name) !== null)
            attributes[name] = element.getAttribute(name);
    const children = Array.from(element.children, written);
    return [element.tagName.toLowerCase(), attributes, children.length ? "" : element.textContent, children];
}

/* The panels of a drawing: what is in each, and its list of values. */
function panels(place) {
    const found = [];
    const look = (element) => {
        const name = element.getAttribute("class") || "";
        if (element.tagName.toLowerCase() === "figure" && name.startsWith("panel")) {
            const [sheet, caption, list] = element.children;
            found.push({title: caption.textContent, sheet: written(sheet),
                        place: [sheet.dataset.scale, sheet.dataset.x, sheet.dataset.y].map(Number),
                        values: Array.from(list.children, (item) => item.textContent)});
        }
        Array.from(element.children).forEach(look);
    };
    look(place);
    return found;
}

function collect(fourlink, document, inputs) {
    return inputs.map(({data, rows}) => {
        const place = document.createElementNS("http://www.w3.org/1999/xhtml", "div");
        const drawing = fourlink.draw(data, place);
        return rows.map((list, branch) => {
            drawing.choose(branch);
            return list.map((row) => {
                drawing.show(row);
                return panels(place);
            });
        });
    });
}

/* ------------------------------------------------------------------------------------------ a document for node */

class Element {
    constructor(name) {
        Object.assign(this, {tagName: name, attributes: {}, children: [], words: "", style: {}, dataset: {}, parentNode: null});
    }
    setAttribute(name, value) { this.attributes[name] = String(value); }
    getAttribute(name) { return name in this.attributes ? this.attributes[name] : null; }
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
    get textContent() { return this.words + this.children.map((x) => x.textContent).join(""); }
}

if (typeof module === "object")
    module.exports = {Element};

if (typeof require === "function" && require.main === module) {
    const fs = require("fs");
    const [script, input, output] = process.argv.slice(2);
    const document = {createElementNS: (space, name) => new Element(name), getElementById: () => null,
                      querySelectorAll: () => []};
    const window = {addEventListener: () => {}};
    const fourlink = new Function("document", "window", fs.readFileSync(script, "utf8") + "\nreturn fourlink;")(document, window);
    fs.writeFileSync(output, JSON.stringify(collect(fourlink, document, JSON.parse(fs.readFileSync(input, "utf8")))));
}
