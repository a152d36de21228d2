/* SPDX-License-Identifier: GPL-3.0-or-later
**
** typed.js - what a student types into a report: name, date, discussion.
**
** The browser keeps it, so that it survives a reload; a button saves the report with it.  Where the browser keeps
** nothing the page says so.
*/
fourlink.typed = (function () {

const KEPT = "What you type is kept in this browser. To hand it in, print the report or save it with the button below.";
const LOST = "This browser does not keep what you type: save the report with the button below before you leave.";

/* The store of the browser; null if it has none or does not allow it. */
function storeOf() {
    try {
        const store = window.localStorage;
        store.setItem("fourlink", "1");
        store.removeItem("fourlink");
        return store;
    } catch (error) {
        return null;
    }
}

/* The report as a file: the page as it was, with what has been typed. */
function fileOf() {
    const copy = document.documentElement.cloneNode(true), find = (selector) => copy.querySelectorAll(selector);
    copy.classList.remove("scripted", "moving", "on-paper");
    find("#fourlink-panels, #fourlink-more, .typed, #typed-status").forEach((x) => x.replaceChildren());
    find("#fourlink-controls, #fourlink-panels, #fourlink-more, button[data-save], #typed-save")
        .forEach((x) => x.setAttribute("hidden", "hidden"));
    return "<!DOCTYPE html>\n" + copy.outerHTML + "\n";
}

function start() {
    const fields = ["name", "date", "discussion"].map((x) => document.getElementById("typed-" + x)).filter((x) => x);
    const store = fields.length ? storeOf() : null, button = document.getElementById("typed-save");
    const status = document.getElementById("typed-status");
    let unsaved = false;
    if (!fields.length)
        return;
    document.documentElement.classList.add("scripted");
    for (const field of fields) {
        const key = "fourlink " + location.pathname + " " + document.title + " " + field.id, first = field.value;
        const mirror = () => {
            if (field.localName === "textarea") {
                field.textContent = field.value; /* for a browser that saves the page */
                field.nextElementSibling.textContent = field.value; /* for paper */
                field.style.height = "auto";
                field.style.height = field.scrollHeight + 4 + "px";
            } else {
                field.setAttribute("value", field.value);
            }
        };
        const kept = store && JSON.parse(store.getItem(key) || "null");
        if (kept && kept.first === first) /* of this very report, not of one that was saved with other words */
            field.value = kept.value;
        mirror();
        field.addEventListener("input", () => {
            mirror();
            unsaved = true;
            status.textContent = store ? KEPT : LOST;
            if (store)
                store.setItem(key, JSON.stringify({first, value: field.value}));
        });
    }
    button.hidden = false;
    button.addEventListener("click", () => {
        fourlink.save(decodeURIComponent(location.pathname.split("/").pop()) || "report.html", "text/html", fileOf());
        unsaved = false;
    });
    window.addEventListener("beforeunload", (event) => {
        if (unsaved && !store)
            event.preventDefault();
    });
}

return {start, fileOf};
}());
