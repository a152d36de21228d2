/* SPDX-License-Identifier: GPL-3.0-or-later
**
** menus.js - the decks that the page has: new ones, examples by their mechanisms, designs by their tasks.
**
** `load` is called with the name, the text, and whether it is a design.
*/
web.menus = function (find, load) {

const {html} = fourlink;
const [examples, templates, designs] = ["examples", "templates", "designs"].map((id) => JSON.parse(find(id).textContent));
const FIRST = "new-four-bar.deck"; /* the template that the page begins with */
const KINDS = [["four-bar", "Four-bar linkages"], ["slider-crank", "Slider-cranks"],
               ["inverted-slider-crank", "Inverted slider-cranks"], ["scotch-yoke", "Scotch yokes"]];
const OTHER_WORDS = {boom: "inverted-slider-crank"}; /* of decks in data/ */
const kindOf = (text) => {
    const word = (/^\s*mechanism\s*=\s*(\S+)/m.exec(text) || [])[1];
    return OTHER_WORDS[word] || word;
};
const offerGroup = (label, files, words) => find("example").append(html("optgroup", {label},
    ...files.map((file) => html("option", {value: file}, words(file)))));

offerGroup("New deck", Object.keys(templates).filter((file) => file.startsWith("new-")), (file) => web.text.titleOf(templates[file]));
const TASKS = [["function", "A function"], ["motion", "Three positions"], ["path", "A path"], ["quick-return", "A quick return"], ["cognate", "A cognate"]];
for (const [kind, label] of KINDS)
    offerGroup(label, Object.keys(examples).filter((file) => kindOf(examples[file]) === kind),
               (file) => web.text.titleOf(examples[file]) || file);
for (const [task, label] of TASKS) {
    const files = Object.keys({...templates, ...designs}).filter((file) => web.text.value({...templates, ...designs}[file], "synthesis", "task") === task);
    if (files.length)
        find("design").append(html("optgroup", {label}, ...files.map((file) => html("option", {value: file}, web.text.titleOf({...templates, ...designs}[file]) || file))));
}
for (const id of ["example", "design"])
    find(id).addEventListener("change", () => {
        const file = find(id).value, text = {...examples, ...templates, ...(id === "design" ? designs : {})}[file];
        find(id).value = "";
        if (text !== undefined)
            load(file, text, id === "design");
    });

return {first: templates[FIRST]};
};
