/* SPDX-License-Identifier: GPL-3.0-or-later
**
** browser.js - drives headless Chromium over the DevTools protocol, through a pipe: no package is needed.
*/
"use strict";

const {spawn} = require("node:child_process");
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");

const FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-dev-shm-usage",
               "--disable-background-networking", "--disable-component-update", "--disable-sync",
               "--remote-debugging-pipe"];

const wait = (time) => new Promise((done) => setTimeout(done, time));

/* Open a browser and one page; its functions are below. */
async function open() {
    const profile = fs.mkdtempSync(path.join(os.tmpdir(), "fourlink-web-"));
    const child = spawn("chromium", [...FLAGS, "--user-data-dir=" + profile],
                        {stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"]});
    const waiting = new Map(), problems = [];
    let last = 0, rest = "", session;

    child.stdio[4].setEncoding("utf8");
    child.stdio[4].on("data", (part) => {
        const messages = (rest + part).split("\0");
        rest = messages.pop();
        messages.forEach((words) => take(JSON.parse(words)));
    });
    function take(message) {
        const request = waiting.get(message.id);
        if (message.method === "Runtime.exceptionThrown")
            problems.push(message.params.exceptionDetails.exception?.description || message.params.exceptionDetails.text);
        if (message.method === "Runtime.consoleAPICalled" && message.params.type === "error")
            problems.push(message.params.args.map((x) => x.value).join(" "));
        if (message.method === "Log.entryAdded" && message.params.entry.level === "error")
            problems.push(message.params.entry.text);
        if (!request)
            return;
        waiting.delete(message.id);
        if (message.error)
            request.reject(new Error(request.method + ": " + message.error.message));
        else
            request.resolve(message.result);
    }
    function send(method, params, to) {
        return new Promise((resolve, reject) => {
            waiting.set(++last, {resolve, reject, method});
            child.stdio[3].write(JSON.stringify({id: last, method, params: params || {}, sessionId: to}) + "\0");
        });
    }
    const {targetId} = await send("Target.createTarget", {url: "about:blank"});
    session = (await send("Target.attachToTarget", {targetId, flatten: true})).sessionId;
    const page = (method, params) => send(method, params, session);
    await page("Runtime.enable");
    await page("Log.enable");
    await page("Page.enable");

    /* The value of an expression in the page, which may be a promise. */
    async function evaluate(expression) {
        const {result, exceptionDetails} = await page("Runtime.evaluate", {expression, awaitPromise: true,
                                                                           returnByValue: true});
        if (exceptionDetails)
            throw new Error(exceptionDetails.exception?.description || exceptionDetails.text);
        return result.value;
    }
    /* Wait until an expression is true. */
    async function until(expression, what, most = 120000) {
        for (const end = Date.now() + most; Date.now() < end; await wait(15))
            if (await evaluate("Boolean(" + expression + ")"))
                return;
        throw new Error("in vain: " + (what || expression));
    }
    async function key(name, modifiers = 0) {
        const codes = {Tab: 9, Enter: 13, Escape: 27, Home: 36, End: 35, ArrowLeft: 37, ArrowUp: 38, ArrowRight: 39,
                       ArrowDown: 40, PageUp: 33, PageDown: 34, Backspace: 8, Delete: 46, " ": 32};
        const code = codes[name] || name.toUpperCase().charCodeAt(0);
        const words = name === "Enter" ? "\r" : name.length === 1 && !modifiers ? name : undefined;
        const event = {key: name, code: name.length === 1 && name !== " " ? "Key" + name.toUpperCase() : name === " " ? "Space" : name,
                       windowsVirtualKeyCode: code, modifiers, text: words};
        await page("Input.dispatchKeyEvent", {type: words ? "keyDown" : "rawKeyDown", ...event});
        await page("Input.dispatchKeyEvent", {type: "keyUp", ...event});
    }
    async function mouse(type, x, y) {
        await page("Input.dispatchMouseEvent", {type, x, y, button: "left", buttons: type === "mouseReleased" ? 0 : 1,
                                                clickCount: type === "mouseMoved" ? 0 : 1});
    }
    async function size(width, height, scheme = "light") {
        await page("Emulation.setDeviceMetricsOverride", {width, height, deviceScaleFactor: 1, mobile: false});
        await page("Emulation.setEmulatedMedia", {features: [{name: "prefers-color-scheme", value: scheme}]});
    }
    async function shot(file) {
        fs.writeFileSync(file, Buffer.from((await page("Page.captureScreenshot", {format: "png"})).data, "base64"));
    }
    async function close() {
        const ended = new Promise((done) => child.on("exit", done));
        await send("Browser.close").catch(() => {});
        await ended;
        fs.rmSync(profile, {recursive: true, force: true, maxRetries: 5});
    }
    return {page, evaluate, until, key, mouse, size, shot, close, problems, go: (url) => page("Page.navigate", {url}),
            type: (text) => page("Input.insertText", {text})};
}

module.exports = {open, wait};
