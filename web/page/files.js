/* SPDX-License-Identifier: GPL-3.0-or-later
**
** files.js - what can be saved and shared: the deck, its link, pictures, tables, the report.
**
** `page` has what is shown: name(), text(), angle() of the drawing with its unit or "", branch(), run(OPTIONS), tell(WORDS),
** relink().
*/
web.files = function (find, page) {

const {save} = fourlink;
const own = (id) => find(id).textContent.trimStart();
const stem = () => page.name().replace(/\.deck$/, "");

/* The file that the command writes; null after a mistake, which is told. */
async function written(options) {
    const {files, messages} = await page.run(options);
    const file = files.find((x) => x.text);
    if (!file)
        page.tell(messages.trim());
    return file ? file.text : null;
}

async function picture(...options) {
    return written(["--plot=picture.svg", "--branch=" + page.branch(), ...options]);
}
const atAngle = () => page.angle() ? ["--plot-at=" + page.angle()] : [];

/* An SVG as a PNG, twice as large. */
async function asPng(words) {
    const image = new Image(), canvas = document.createElement("canvas");
    image.src = URL.createObjectURL(new Blob([words], {type: "image/svg+xml"}));
    await image.decode();
    canvas.width = 2 * image.naturalWidth;
    canvas.height = 2 * image.naturalHeight;
    canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
    URL.revokeObjectURL(image.src);
    return new Promise((done) => canvas.toBlob(done, "image/png"));
}

async function saveTable(format, type) {
    const {out, messages} = await page.run(["--format=" + format]);
    if (out)
        save(stem() + "." + format, type, out);
    else
        page.tell(messages.trim());
}

const actions = {
    async copy() {
        try {
            await navigator.clipboard.writeText(page.text());
            page.tell("The deck is copied.");
        } catch (error) {
            find("deck").select();
            page.tell(document.execCommand("copy") ? "The deck is copied." : "The browser does not allow it to be copied.");
        }
    },
    deck: () => save(page.name(), "text/plain", page.text()),
    async motion() {
        const words = await picture("--plot-kind=animation");
        if (words)
            save(stem() + "-motion.svg", "image/svg+xml", words);
    },
    async svg() {
        const words = await picture(...atAngle());
        if (words)
            save(stem() + ".svg", "image/svg+xml", words);
    },
    async png() {
        const words = await picture(...atAngle());
        if (words)
            save(stem() + ".png", "image/png", await asPng(words));
    },
    csv: () => saveTable("csv", "text/csv"),
    json: () => saveTable("json", "application/json"),
    async report() {
        const text = await written(["--report=report.html", ...atAngle()]);
        if (!text)
            return;
        const end = text.lastIndexOf("@SCRIPT@\n"); /* the deck may have such a line too, before it */
        save(stem() + ".html", "text/html", text.slice(0, end).replace("@STYLE@\n", () => own("report-style")) +
             own("report-script") + text.slice(end + 9));
    },
    async link() {
        await page.relink();
        try {
            await navigator.clipboard.writeText(location.href);
            page.tell("The link is in the address bar, and copied.");
        } catch (error) {
            page.tell("The link is in the address bar.");
        }
    },
    print: () => window.print()
};
for (const id in actions)
    find("save-" + id).addEventListener("click", async () => {
        find("save-menu").open = false;
        try {
            await actions[id]();
        } catch (error) {
            page.tell(error.message === "stopped" ? "Stopped." : error.message);
        }
    });
};
