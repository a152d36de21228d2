/* SPDX-License-Identifier: GPL-3.0-or-later
**
** worker.js - runs the program beside the page, so that the page can stop it.
**
** A request is {id, task, ...}, its answer {id, ...} or {id, failed: WHY}.  The first is {bytes}, the program,
** compressed by gzip.
*/
"use strict";

let code = null, program = null, ready = null, isOpen = false; /* a deck without mistakes */
const encoder = new TextEncoder(), decoder = new TextDecoder();
const bytes = (from, length, of = program) => new Uint8Array(of.memory.buffer, from, length);
const ENOSYS = 52; /* of WASI */

/* A new instance of the program.  It has neither files nor clock: what it imports answers that there is no such thing,
** but for the streams 1 and 2, which `write` takes. */
function instance(write) {
    const imports = {};
    let made = null;
    for (const {module: from, name} of WebAssembly.Module.imports(code)) {
        imports[from] = imports[from] || {};
        imports[from][name] = from === "env" ? () => 0 : () => ENOSYS;
    }
    imports.wasi_snapshot_preview1.fd_write = (stream, parts, count, total) => {
        const view = new DataView(made.memory.buffer);
        let sum = 0;
        for (let k = 0; k < count; k++) {
            const from = view.getUint32(parts + 8 * k, true), length = view.getUint32(parts + 8 * k + 4, true);
            write(stream, bytes(from, length, made).slice());
            sum += length;
        }
        view.setUint32(total, sum, true);
        return 0;
    };
    made = new WebAssembly.Instance(code, imports).exports;
    if (made._initialize)
        made._initialize();
    return made;
}

async function start(packed) {
    if (!self.DecompressionStream)
        throw new Error("the page needs a browser of 2023 or later");
    const whole = await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
    code = new WebAssembly.Module(whole);
    program = instance(() => {});
}

/* Put texts, each with a final zero, into the room for the next call; returns their lengths with it. */
function give(texts, to = program) {
    const parts = texts.map((text) => encoder.encode(text + "\0"));
    const length = parts.reduce((sum, part) => sum + part.length, 0), room = to.web_room(length);
    if (!room)
        throw new Error("not enough memory");
    let at = room;
    for (const part of parts) {
        bytes(at, part.length, to).set(part);
        at += part.length;
    }
    return parts.map((part) => part.length);
}

function answer(done) {
    if (!done)
        throw new Error("not enough memory");
    return decoder.decode(bytes(program.web_answer(), program.web_answer_length()));
}

function textAt(place, of = program) {
    let end = place;
    while (bytes(end, 1, of)[0])
        end++;
    return decoder.decode(bytes(place, end - place, of));
}

const tasks = {
    /* Open a deck; with its drawing if there is one, `brief`: of the mechanism alone. */
    open({name, text, at, branch, held, letGo, brief, solution}) {
        isOpen = false;
        const [nameLength, length] = give([name, text]);
        const status = program.web_open(nameLength, length - 1, solution || 1, held ? 1 : letGo ? 2 : 0);
        const tellsWhy = status === 36 || status >= 52 && status <= 57; /* mistakes; there is no linkage */
        if (status !== 0 && !tellsWhy)
            throw new Error(textAt(program.web_status_text(status)));
        const deck = JSON.parse(answer(true));
        deck.usable = isOpen = status === 0;
        const scene = deck.usable && program.web_scene(branch || 0, at === undefined ? deck.start : at, held ? 1 : brief ? 2 : 0);
        return {deck, scene: scene ? answer(true) : null};
    },
    /* The style sheet of all drawings. */
    style() {
        return {text: answer(program.web_style())};
    },
    curve({names}) {
        give(["table.columns=" + names.join()]);
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
    /* Run the command, `fourlink ARGUMENTS NAME`, in an instance of its own: what it prints, and the files it writes. */
    run({name, text, options}) {
        const printed = {1: [], 2: []}, files = [];
        const whole = (parts) => parts.map((part) => decoder.decode(part, {stream: true})).join("") + decoder.decode();
        const made = instance((stream, part) => (printed[stream] || []).push(part));
        const before = options.includes("--import") ? options : [...options, "--"];
        const lengths = give(["fourlink", ...before, name, text], made);
        const status = made.web_command(before.length + 2, lengths[lengths.length - 1] - 1);
        for (let k = 0, at; (at = made.web_written_name(k)); k++)
            files.push({name: textAt(at, made), text: decoder.decode(bytes(made.web_written(k), made.web_written_length(k), made))});
        return {status, out: whole(printed[1]), messages: whole(printed[2]), files};
    },
    /* The names of facts and columns, typeset. */
    labels({names}) {
        return {labels: names.map((name) => {
            give([name]);
            return JSON.parse(answer(program.web_label()));
        })};
    },
    /* Quantities in SI units; null where a text is none. */
    quantities({lengths, angles}) {
        const read = (isAngle) => (text) => {
            give([text]);
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
        if (!["open", "style", "run"].includes(data.task) && !isOpen)
            throw new Error("no deck is open");
        const made = tasks[data.task](data);
        self.postMessage({id: data.id, time: performance.now() - begun, ...made});
    } catch (error) {
        self.postMessage({id: data.id, failed: String(error.message || error)});
    }
};
