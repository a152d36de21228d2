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

/* A fact's name: a symbol, words, or the mean of one. */
function nameOf(fact) {
    return fact.of ? [fact.of + "(", htmlLabel(fact.label), ")"] : [htmlLabel(fact.label)];
}

/* The extremes of a column on a branch together: [[largest, smallest] ...]; one of them may be missing.  Those of a
** residual are rounding. */
function pairsOf(extremes) {
    const pairs = new Map();
    for (const f of extremes.filter((x) => !/residual/.test(x.label[0]))) {
        const key = f.label + " " + f.branch;
        pairs.set(key, Object.assign(pairs.get(key) || [], {[f.of === "max" ? 0 : 1]: f}));
    }
    return [...pairs.values()];
}

/* Facts and extremes; `go` goes to the crank angle of one. */
function facts(place, list, angleUnit, go) {
    const figure = (f) => html("td", {class: "figure"}, f ? shown(f.value, 6) : "");
    const at = (f) => {
        if (!f || typeof f.theta2 !== "number")
            return html("td", {class: "figure"});
        const button = html("button", {type: "button", class: "plain"}, withUnit(shown(f.theta2, 6), angleUnit));
        button.addEventListener("click", () => go(f.theta2));
        return html("td", {class: "figure"}, button);
    };
    const isExtreme = (f) => f.of === "max" || f.of === "min";
    const put = (kind, names, lines) => html("table", {class: kind}, head(...names), html("tbody", {}, ...lines));
    const single = list.filter((f) => !isExtreme(f)).map((f) => html("tr", {},
        html("th", {scope: "row", title: f.name}, ...nameOf(f)), figure(f), html("td", {}, unitText(f.unit || "")), at(f),
        html("td", {}, f.branch || ""), html("td", {}, f.meaning)));
    const pairs = pairsOf(list.filter(isExtreme)).map(([most, least]) => {
        const one = most || least;
        return html("tr", {}, html("th", {scope: "row", title: one.meaning}, htmlLabel(one.label)), figure(most),
                    html("td", {}, unitText(one.unit || "")), at(most), figure(least), at(least), html("td", {}, one.branch || ""));
    });
    place.replaceChildren(put("facts", ["Fact", "Value", "Unit", "at θ₂", "Branch", "Meaning"], single));
    if (pairs.length)
        place.append(put("facts", ["Column", "Largest", "Unit", "at θ₂", "Smallest", "at θ₂", "Branch"], pairs));
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

/* The solutions of a [synthesis], as --synthesis lists them; `choose` takes one of them. */
function solutions(place, text, chosen, choose) {
    const head = text.split("\n").filter((x) => /^#/.test(x)), parts = head.map((line) => /^#\s+(\d+): (.*)$/.exec(line));
    const offered = parts.filter((x) => x).map(([, k, words]) => {
        const radio = html("input", {type: "radio", name: "solution", value: k});
        radio.checked = Number(k) === chosen;
        radio.addEventListener("change", () => choose(Number(k)));
        return html("li", {}, html("label", {}, radio, " " + words));
    });
    const end = text.search(/^(?!#)/m), rest = text.slice(0, end).split("\n").filter((line) => !/^#\s+\d+: |^# Found/.test(line));
    place.replaceChildren(html("ol", {class: "solutions"}, ...offered), html("pre", {}, rest.map((line) => line.slice(2)).join("\n")));
}

return {table, facts, checks, solutions, shown};
}());
