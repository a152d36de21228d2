/* SPDX-License-Identifier: GPL-3.0-or-later
**
** narrow.js SOURCES REPORT... - draws rows of reports in panels of phones and of a desk, for test_narrow.sh: every attribute is
** a number where it should be, the mechanism is as wide as its sheet allows.  A line for
** each thing that is wrong, and at the end how many drawings were looked at.
*/
"use strict";

const fs = require("node:fs");
const path = require("node:path");
const {below, scriptOf} = require("./document.js");

const [sources, ...reports] = process.argv.slice(2);
let drawings = 0;

/* Attributes that are no numbers, and words of a number that is none. */
const isWrong = (words) => /NaN|Infinity|undefined/.test(words);
const wrongIn = (place) => [...below(place)].flatMap((x) => [...Object.values(x.attributes), x.words]).filter(isWrong);

for (const file of reports) {
    const page = fs.readFileSync(file, "utf8"), name = path.basename(file, ".html");
    const data = JSON.parse(/id="fourlink-rows">([^]*?)<\/script>/.exec(page)[1]);
    for (const width of [296, 330, 960]) {
        const {fourlink, Element} = scriptOf(["elements.js", "labels.js", "player.js"].map((x) => path.join(sources, x)), width);
        const place = new Element("div"), drawing = fourlink.draw(data, place);
        data.branches.forEach((branch, k) => {
            drawing.choose(k);
            const found = new Set(), sheet = drawing.panels[0].drawing.attributes.viewBox.split(" ").map(Number);
            const most = [Infinity, Infinity, -Infinity, -Infinity];
            for (let i = 0; i < data.steps.length; i += 7) {
                drawing.show(i);
                drawings++;
                wrongIn(place).slice(0, 1).forEach((x) => found.add(x));
                for (const [x, y] of ["A", "B", "C", "D", "P0"].map((pin) => drawing.main.place(pin)).filter((at) => at))
                    [x, y, x, y].forEach((value, j) => { most[j] = j < 2 ? Math.min(most[j], value) : Math.max(most[j], value); });
            }
            if (sheet[2] !== width || most[0] < -1 || most[1] < -1 || most[2] > sheet[2] + 1 || most[3] > sheet[3] + 1)
                found.add("pins from " + most + " in a sheet of " + sheet);
            if (!(Math.max(most[2] - most[0], most[3] - most[1]) > 0.25 * Math.min(sheet[2], sheet[3])))
                found.add("a blob: pins from " + most);
            for (const x of [...found].slice(0, 3))
                console.log("FAILED: " + name + ", " + width + " pixels, " + branch.name + ": " + x);
        });
    }
}
console.log(drawings + " drawings");
