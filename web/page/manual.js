/* SPDX-License-Identifier: GPL-3.0-or-later
**
** manual.js - the contents of the manual pages, and a search in them.
*/
web.manual = function (find) {

const {html} = fourlink;
const place = find("manual"), text = place.textContent, lines = text.split("\n");
let last = -1;

/* Bring the letter at `at` to the top, and select so many from there. */
function show(at, count) {
    const range = document.createRange(), node = place.firstChild;
    range.setStart(node, at);
    range.setEnd(node, at + count);
    const box = range.getBoundingClientRect();
    place.scrollTop += box.top - place.getBoundingClientRect().top - 20;
    const selection = window.getSelection();
    selection.removeAllRanges();
    selection.addRange(range);
}

let at = 0;
for (const line of lines) {
    const isPage = /^[A-Z-]+\(\d\)/.test(line), isSection = /^[A-Z][A-Z ,]+$/.test(line), isPart = /^ {3}\S/.test(line);
    if (isPage || isSection || isPart)
        find("manual-contents").append(html("option", {value: at}, isPage ? line.split(" ")[0] : (isPart ? "\u2003\u2003" : "\u2003") + line.trim()));
    at += line.length + 1;
}
find("manual-contents").addEventListener("change", () => {
    const from = Number(find("manual-contents").value);
    show(from, text.indexOf("\n", from) - from);
});
find("manual-search").addEventListener("keydown", (event) => {
    if (event.key !== "Enter")
        return;
    event.preventDefault();
    const wanted = find("manual-search").value.toLowerCase(), whole = text.toLowerCase();
    const next = wanted ? whole.indexOf(wanted, last + 1) : -1;
    last = next >= 0 ? next : wanted ? whole.indexOf(wanted) : -1;
    find("manual-found").textContent = last >= 0 || !wanted ? "" : "not found";
    if (last >= 0)
        show(last, wanted.length);
});
find("manual-search").addEventListener("input", () => { last = -1; });
};
