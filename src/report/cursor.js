/* SPDX-License-Identifier: GPL-3.0-or-later
**
** cursor.js - a line in diagrams that shows the row of the drawing; a click or a finger in one of them goes to a row.
**
** `place` has a picture of the program; `over` what its panels are drawn over, by branch and row.  Returns the function that
** shows a row of a branch.
*/
fourlink.cursor = function (place, over, go) {

const sheet = place.querySelector("svg.fourlink"), numbers = (words) => words.trim().split(/[ ,]+/).map(Number);
const panels = sheet ? [...sheet.querySelectorAll("g.panel")].map((group) => {
    const line = fourlink.svg("path", {class: "cursor"});
    group.append(line);
    return {line, box: numbers(group.dataset.box), axes: numbers(group.dataset.axes)};
}) : [];
let branch = 0;

function show(i, k) {
    branch = k;
    for (const {line, box: [left, top, width, height], axes: [from, to]} of panels) {
        const part = (over[k][i] - from) / (to - from);
        if (part >= 0 && part <= 1)
            line.setAttribute("d", "M" + (left + part * width) + "," + top + "v" + height);
        else
            line.removeAttribute("d");
    }
}

function follow(event) {
    const [x, y] = fourlink.placeOf(event, sheet);
    const panel = panels.find(({box: [left, top, width, height]}) => x >= left && x <= left + width && y >= top && y <= top + height);
    if (!panel)
        return;
    const {box: [left, , width], axes: [from, to]} = panel, wanted = from + (x - left) / width * (to - from);
    go(over[branch].reduce((best, u, i) => Math.abs(u - wanted) < Math.abs(over[branch][best] - wanted) ? i : best, 0));
}

if (sheet) {
    sheet.addEventListener("pointerdown", follow);
    sheet.addEventListener("pointermove", (event) => {
        if (event.buttons)
            follow(event);
    });
}
return show;
};
