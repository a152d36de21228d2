/* SPDX-License-Identifier: GPL-3.0-or-later
**
** zoom.js - the mechanism larger and smaller: buttons, the wheel with Ctrl, two fingers on a touchpad; what is larger than
** its place is moved by dragging it.
*/
web.zoom = function (find, moved) {

const STEP = 1.4;
let drawing = null, held = null;

const panel = () => drawing && drawing.main.panel;
const sheet = () => panel().drawing;
const middle = () => [sheet().viewBox.baseVal.width / 2, sheet().viewBox.baseVal.height / 2];

function apply() {
    drawing.layOut();
    sheet().classList.toggle("moved", panel().zoom() > 1);
    moved();
}
function by(factor, at) {
    if (!drawing)
        return;
    panel().zoomBy(factor, at || middle());
    apply();
}

function byWheel(event) {
    if (!event.ctrlKey && !event.metaKey)
        return;
    event.preventDefault();
    by(Math.exp(-event.deltaY / 300), fourlink.placeOf(event, sheet()));
}
function hold(event) {
    if (panel().zoom() === 1 || event.target.closest(".handle, .knob"))
        return;
    held = {id: event.pointerId, at: fourlink.placeOf(event, sheet())};
    fourlink.hold(event, sheet());
}
function move(event) {
    if (!held || held.id !== event.pointerId)
        return;
    const at = fourlink.placeOf(event, sheet());
    panel().moveBy([at[0] - held.at[0], at[1] - held.at[1]]);
    held.at = at;
    apply();
}
const release = () => { held = null; };

find("zoom-in").addEventListener("click", () => by(STEP));
find("zoom-out").addEventListener("click", () => by(1 / STEP));
find("zoom-fit").addEventListener("click", () => by(0));

/* Take a new drawing. */
return (newDrawing) => {
    if (newDrawing === drawing)
        return;
    drawing = newDrawing;
    sheet().addEventListener("wheel", byWheel, {passive: false});
    sheet().addEventListener("pointerdown", hold);
    sheet().addEventListener("pointermove", move);
    sheet().addEventListener("pointerup", release);
    sheet().addEventListener("pointercancel", release);
};
};
