/* SPDX-License-Identifier: GPL-3.0-or-later
**
** questions.js - the line under the deck: what the command answers to --at, --solve, --best, --check or any options.
*/
web.questions = function (find, run, take) {

const {html} = fourlink;
/* What is asked, the option, and a question to begin with. */
const KINDS = {
    at: ["Rows where", "--at=", "theta4 = 120 deg"],
    solve: ["Which value gives", "--solve=", "crank.length = 20 mm .. 34 mm where swing = 40 deg"],
    best: ["Best design", "--best=", "max mu_min"],
    check: ["Check", "--check", null],
    options: ["fourlink …", null, "--summary --units=SI"]
};

/* The words of a command line; quotes hold a word together. */
function wordsOf(line) {
    return [...line.matchAll(/(?:[^\s'"]|'[^']*'|"[^"]*")+/g)].map((found) => found[0].replace(/'([^']*)'|"([^"]*)"/g, "$1$2"));
}

function optionsOf(kind, words) {
    const [, option, example] = KINDS[kind];
    return option === null ? wordsOf(words) : [example === null ? option : option + words];
}

function choose() {
    const example = KINDS[find("ask-kind").value][2];
    find("ask-words").disabled = example === null;
    find("ask-words").placeholder = example || "";
}

async function ask(event) {
    event.preventDefault();
    const kind = find("ask-kind").value, words = find("ask-words").value.trim() || KINDS[kind][2];
    const {out, messages, files} = await run(optionsOf(kind, words));
    const isDeck = /^\s*mechanism\s*=/m.test(out);
    find("answer-text").textContent = messages + out || (files.length ? "" : "Nothing.");
    find("answer").hidden = false;
    find("answer-take").hidden = !isDeck;
    find("answer-take").onclick = () => take(out);
    for (const file of files.filter((x) => x.text))
        fourlink.save(file.name, "text/plain", file.text);
    find("answer-text").focus();
}

find("ask-kind").append(...Object.entries(KINDS).map(([value, [words]]) => html("option", {value}, words)));
find("ask-kind").addEventListener("change", choose);
find("ask").addEventListener("submit", ask);
find("answer-close").addEventListener("click", () => {
    find("answer").hidden = true;
    find("ask-words").focus();
});
choose();
};
