/* SPDX-License-Identifier: GPL-3.0-or-later
**
** tables.js - the table of the deck, its facts, its comparisons.
*/
web.tables = (function () {

const {html, htmlLabel, unitText, withUnit, cellText} = fourlink;

/* A number with so many significant digits, or words. */
function shown(value, digits) {
    if (typeof value !== "number")
        return value === null || value === undefined ? "" : String(value);
    if (Number.isNaN(value))
        return "nan";
    if (!Number.isFinite(value))
        return value > 0 ? "inf" : "-inf";
    const text = value.toPrecision(digits);
    return (/e/.test(text) ? text : String(Number(text))).replace("-", "\u2212");
}

function head(...names) {
    return html("thead", {}, html("tr", {}, ...names.map((name) => html("th", {scope: "col"}, name))));
}

/* Rows of a branch: `scene` has the form of each column. */
function table(place, columns, forms, rows) {
    const cell = (form, x) => Number.isNaN(x) ? "nan" : !Number.isFinite(x) ? (x > 0 ? "inf" : "-inf")
        : cellText(form, form.form === "angle" ? Number(x.toPrecision(12)) : x);
    const body = html("tbody", {}, ...rows.map((row) => {
        const line = html("tr", {}, ...columns.map((c, j) => html(j ? "td" : "th", j ? {} : {scope: "row"}, cell(forms[j], row.values[j]))));
        if (row.status !== "ok")
            line.replaceChildren(...columns.slice(0, 1).map((c, j) => html("th", {scope: "row"}, cell(forms[j], row.values[j]))),
                                 html("td", {colspan: columns.length - 1 || 1, class: "missing"}, row.status));
        return line;
    }));
    const names = columns.map((c) => html("th", {scope: "col", title: c.meaning}, htmlLabel(c.label), html("br"),
                                          html("span", {class: "unit"}, unitText(c.unit) || "\u00a0")));
    place.replaceChildren(html("table", {class: "rows"}, html("thead", {}, html("tr", {}, ...names)), body));
}

/* A fact's name: a symbol, words, or the largest value of one. */
function nameOf(fact) {
    return fact.of ? [fact.of + "(", htmlLabel(fact.label), ")"] : [htmlLabel(fact.label)];
}

function facts(place, list, angleUnit) {
    const lines = list.map((f) => html("tr", {}, html("th", {scope: "row", title: f.name}, ...nameOf(f)),
        html("td", {class: "figure"}, shown(f.value, 6)), html("td", {}, unitText(f.unit || "")),
        html("td", {class: "figure"}, f.theta2 === null ? "" : withUnit(shown(f.theta2, 6), angleUnit)),
        html("td", {}, f.branch || ""), html("td", {}, f.meaning)));
    place.replaceChildren(html("table", {class: "facts"}, head("Fact", "Value", "Unit", "at θ₂", "Branch", "Meaning"),
                               html("tbody", {}, ...lines)));
}

/* What --check prints, a line each; `select` selects a line of the deck. */
function checks(place, text, select) {
    const lines = text.split("\n").filter((x) => x);
    place.replaceChildren(html("ol", {class: "checks"}, ...lines.map((words) => {
        const at = /^(ok|differs|misprint confirmed|not a misprint|no value) .*?:(\d+):/.exec(words);
        const made = html("li", {class: !at ? "total" : /^(ok|misprint)/.test(words) ? "good" : "bad"});
        const button = at && html("button", {type: "button", class: "plain"}, words);
        if (at)
            button.addEventListener("click", () => select(Number(at[2])));
        made.append(button || words);
        return made;
    })));
}

return {table, facts, checks, shown};
}());
