/* SPDX-License-Identifier: GPL-3.0-or-later
**
** exercises.js - ten exercises for drive.js: the decks of doc/tutorial.md, and of data/ those whose sources print
** answers.
**
** Of each: its deck, cells of the row at the first crank angle of the drawing, facts, and the score of its check.
*/
"use strict";

const fs = require("node:fs");
const path = require("node:path");

module.exports = function (root) {
    const read = (name) => fs.readFileSync(path.join(root, name), "utf8");
    const tutorial = read("doc/tutorial.md");

    /* The block of the tutorial that is a file. */
    function block(name) {
        const found = new RegExp("<!-- > " + name + " -->\n```ini\n([^`]*)```").exec(tutorial);
        return found[1];
    }
    const published = {"khurmi-5.2": 6, "hibbeler-16-59": 3, "sarkar-1.1": 5, "marghitu-5.6": 9, "scilab-3886-22.10": 5,
                       "dfa-example-2": 13, "whitworth-150-100": 2};
    return [
        {name: "the tutorial's crusher", deck: block("crusher.deck"),
         row: [["theta3", "73.7398°"], ["omega4", "26.1799\u00a0rad/s"], ["mu", "53.1301°"]],
         facts: ["type crank-rocker", "swing 49.2756 °"]},
        {name: "the tutorial's engine", deck: block("engine.deck"),
         row: [["v", "15.8436\u00a0m/s"], ["a", "856.53\u00a0m/s²"], ["omega3", "-40.1874\u00a0rad/s"]]},
        {name: "the tutorial's exercise", deck: read("data/me3491-exercise-4.deck"),
         facts: ["F12 6539.01 N", "mean_power \u221232906.1 W", "time_ratio 1.02384"], score: "2 of 2"}
    ].concat(Object.entries(published).map(([name, count]) => (
        {name, deck: read("data/" + name + ".deck"), score: count + " of " + count})));
};
