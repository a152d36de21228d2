/* SPDX-License-Identifier: GPL-3.0-or-later
**
** worker.js - runs the program beside the page, so that the page can stop it.
**
** A request is {id, task, ...}, its answer {id, ...} or {id, failed: WHY}.  The first is {bytes}, the program,
** compressed by gzip.
*/
"use strict";

let program = null, ready = null, isOpen = false; /* a deck without mistakes */
const encoder = new TextEncoder(), decoder = new TextDecoder();
const bytes = (from, length) => new Uint8Array(program.memory.buffer, from, length);

/* The program uses neither files nor clock: what it imports answers that there is no such thing. */
async function start(packed) {
    if (!self.DecompressionStream)
        throw new Error("the page needs a browser of 2023 or later");
    const code = await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
    const module = new WebAssembly.Module(code), imports = {};
    for (const {module: from, name} of WebAssembly.Module.imports(module)) {
        imports[from] = imports[from] || {};
        imports[from][name] = from === "env" ? () => 0 : () => 52; /* ENOSYS of WASI */
    }
    program = new WebAssembly.Instance(module, imports).exports;
    if (program._initialize)
        program._initialize();
}

/* Put texts, each with a final zero, into the room for the next call; returns their lengths with it. */
function give(...texts) {
    const parts = texts.map((text) => encoder.encode(text + "\0"));
    const length = parts.reduce((sum, part) => sum + part.length, 0), room = program.web_room(length);
    if (!room)
        throw new Error("not enough memory");
    let at = room;
    for (const part of parts) {
        bytes(at, part.length).set(part);
        at += part.length;
    }
    return parts.map((part) => part.length);
}

function answer(done) {
    if (!done)
        throw new Error("not enough memory");
    return decoder.decode(bytes(program.web_answer(), program.web_answer_length()));
}

function textAt(place) {
    let end = place;
    while (bytes(end, 1)[0])
        end++;
    return decoder.decode(bytes(place, end - place));
}

const tasks = {
    /* Open a deck; with its drawing if there is one. */
    open({name, text, at, branch, held}) {
        isOpen = false;
        const [nameLength, length] = give(name, text);
        const status = program.web_open(nameLength, length - 1);
        const tellsWhy = status === 36 || status >= 52 && status <= 57; /* mistakes; there is no linkage */
        if (status !== 0 && !tellsWhy)
            throw new Error(textAt(program.web_status_text(status)));
        const deck = JSON.parse(answer(true));
        deck.usable = isOpen = status === 0;
        const scene = deck.usable && program.web_scene(branch || 0, at === undefined ? deck.from : at, held ? 1 : 0);
        return {deck, scene: scene ? answer(true) : null};
    },
    /* The style sheet of all drawings. */
    style() {
        return {text: answer(program.web_style())};
    },
    curve({names}) {
        give("table.columns=" + names.join());
        if (!program.web_curve())
            throw new Error("the deck has more loads or points than a drawing shows");
        const text = answer(true), end = text.indexOf("\n");
        return {over: JSON.parse(text.slice(0, end)), figure: text.slice(end + 1)};
    },
    /* Rows of the table: numbers, a row after the other, and after each row its status, "ok" if it has numbers. */
    rows({branch, first, count, width}) {
        const place = program.web_rows(branch, first, count);
        if (!place)
            throw new Error("not enough memory");
        const all = new Float64Array(program.memory.buffer, place, count * (width + 1)), rows = [];
        for (let i = 0; i < count; i++) {
            const row = all.slice(i * (width + 1), (i + 1) * (width + 1));
            rows.push({values: row.subarray(0, width), status: textAt(program.web_status_text(row[width]))});
        }
        return {rows};
    },
    sheet({format, content}) {
        return {text: answer(program.web_sheet({table: 0, csv: 1, json: 2}[format],
                                               {rows: 0, summary: 1, check: 2}[content]))};
    },
    /* The facts, and their names typeset: max(F12) as max and the label of F12. */
    facts() {
        const {text} = tasks.sheet({format: "json", content: "summary"}), facts = JSON.parse(text).facts || [];
        return {facts: facts.map((fact) => {
            const [, of, name] = /^(?:(\w+)\()?(.*?)\)?$/.exec(fact.name);
            give(name);
            return {...fact, of: of || "", label: JSON.parse(answer(program.web_label()))};
        })};
    },
    report({angle}) {
        give(angle || "");
        const done = program.web_report(), text = answer(done);
        if (done === 2)
            throw new Error(text);
        return {text};
    },
    /* Quantities in SI units; null where a text is none. */
    quantities({lengths, angles}) {
        const read = (isAngle) => (text) => {
            give(text);
            const value = program.web_quantity(isAngle);
            return Number.isNaN(value) ? null : value;
        };
        return {lengths: lengths.map(read(0)), angles: angles.map(read(1))};
    }
};

self.onmessage = async ({data}) => {
    if (data.bytes) {
        ready = start(data.bytes);
        ready.catch(() => {}); /* told in the answer to each request */
        return;
    }
    try {
        await ready;
        const begun = performance.now();
        if (data.task !== "open" && data.task !== "style" && !isOpen)
            throw new Error("no deck is open");
        const made = tasks[data.task](data);
        self.postMessage({id: data.id, time: performance.now() - begun, ...made});
    } catch (error) {
        self.postMessage({id: data.id, failed: String(error.message || error)});
    }
};
