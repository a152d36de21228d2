/* SPDX-License-Identifier: GPL-3.0-or-later
**
** screens.js FOURLINK FOLDER - the pictures of the page and of a report in README, page.png and report.png.  Needs Node
** and Chromium.
*/
"use strict";

const {execFileSync} = require("node:child_process");
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");
const {pathToFileURL} = require("node:url");
const {open, wait} = require("../tests/web/browser.js");

const [fourlink, folder] = process.argv.slice(2).map((name) => path.resolve(name));
const root = path.dirname(__dirname), example = "me3491-matrix";

async function main() {
    const work = fs.mkdtempSync(path.join(os.tmpdir(), "fourlink-screens-"));
    const report = path.join(work, "report.html"), browser = await open();

    try {
        execFileSync(fourlink, ["--branch=open", "--report=" + report, path.join(root, "data", example + ".deck")]);
        await browser.size(900, 1200);
        await browser.go(pathToFileURL(report).href);
        await browser.until("document.querySelector('.panel.whole circle')", "the report");
        await wait(500);
        await browser.shot(path.join(folder, "report.png"));
        await browser.size(1400, 900);
        await browser.go(pathToFileURL(path.join(root, "web", "fourlink.html")).href);
        await browser.until("window.fourlinkPage && document.querySelector('.panel.whole circle')", "the page");
        await wait(500);
        await browser.until("window.fourlinkPage.isIdle()", "an answer");
        await wait(1500);
        await browser.shot(path.join(folder, "page.png"));
    } finally {
        await browser.close();
        fs.rmSync(work, {recursive: true, force: true});
    }
}

main().catch((error) => {
    console.error("screens.js: " + error.message);
    process.exit(1);
});
