/* SPDX-License-Identifier: GPL-3.0-or-later
**
** narrow.js REPORT... - draws all rows of reports in panels of phones and of a desk, for test_narrow.sh, with the
** document of page_drawn.js: every attribute is a number where it should be, the mechanism is more than a blob, labels
** of free bodies do not cover each other.  A line for each thing that is wrong, and at the end how many drawings were looked at.
*/
"use strict";

const fs = require("node:fs");
const path = require("node:path");
const {Element} = require("./page_drawn.js");

/* Width and height of the panels of the mechanism and of the others, in a window of 320, 360 and 1280 pixels. */
const PANELS = [[296, 272, 222], [330, 272, 247], [960, 540, 352]];
let drawings = 0;

/* Attributes that are no numbers, and words of a number that is none. */
function* wrong(element) {
    for (const [name, value] of Object.entries(element.attributes))
        if (/NaN|Infinity|undefined/.test(value))
            yield element.tagName + " " + name + "=" + value;
    if (/NaN|Infinity|undefined/.test(element.words))
        yield element.words;
    for (const child of element.children)
        yield* wrong(child);
}

function* circles(element) {
    if (element.attributes["data-name"])
        yield element;
    for (const child of element.children)
        yield* circles(child);
}

/* Labels of a drawing that cover each other. */
function covered(ink) {
    const boxes = ink.children.filter((x) => x.tagName === "text" && !/small|reason/.test(x.attributes.class || "")).map((made) => {
        const x = Number(made.attributes.x), y = Number(made.attributes.y);
        const width = made.children.reduce((sum, part, k) => sum + part.textContent.length * (k ? 7 : 8), 0);
        return [x, y - 11, x + width, y + 1, made.textContent];
    });
    return boxes.flatMap((a, k) => boxes.slice(k + 1).filter((b) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3])
        .map((b) => a[4] + " on " + b[4]));
}

/* The larger side of the box of all pins. */
function spread(place) {
    const pins = [...circles(place)].map((x) => [Number(x.attributes.cx), Number(x.attributes.cy)]);
    return Math.max(...[0, 1].map((j) => Math.max(...pins.map((p) => p[j])) - Math.min(...pins.map((p) => p[j]))));
}

for (const file of process.argv.slice(2)) {
    const page = fs.readFileSync(file, "utf8"), name = path.basename(file, ".html");
    const script = /<script>\/\/<!\[CDATA\[\n([^]*?)\/\/\]\]><\/script>/.exec(page)[1];
    const data = JSON.parse(/id="fourlink-rows">([^]*?)<\/script>/.exec(page)[1]);
    for (const [width, high, low] of PANELS) {
        class Sized extends Element {
            get clientWidth() { return width; }
            get clientHeight() { return this.isHigh ? high : low; }
        }
        const document = {createElementNS: (space, tag) => new Sized(tag), getElementById: () => null, querySelectorAll: () => []};
        const fourlink = new Function("document", "window", script + "\nreturn fourlink;")(document, {addEventListener: () => {}});
        const place = new Sized("div"), drawing = fourlink.draw(data, place), main = drawing.main.panel.drawing;
        main.isHigh = true;
        data.branches.forEach((branch, k) => {
            drawing.choose(k);
            const found = new Set();
            let widest = 0;
            for (let i = 0; i < data.steps.length; i += 7) {
                drawing.show(i);
                drawings++;
                [...wrong(place)].slice(0, 1).forEach((x) => found.add(x));
                for (const figure of place.children[0].children.filter((x) => /Free body/.test(x.textContent)))
                    covered(figure.children[0].children[0]).slice(0, 1).forEach((x) => found.add(data.steps[i] + ", labels: " + x));
                widest = Math.max(widest, spread(main));
            }
            for (const x of [...found].slice(0, 3))
                console.log("FAILED: " + name + ", " + width + " pixels, " + branch.name + ": " + x);
            if (!(widest > 0.25 * Math.min(width, high)))
                console.log("FAILED: " + name + ", " + width + " pixels: a blob of " + widest + " pixels");
        });
    }
}
console.log(drawings + " drawings");
