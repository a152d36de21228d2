/* SPDX-License-Identifier: GPL-3.0-or-later
**
** link.js - a deck within an address: #deck=NAME:TEXT, compressed, or #plain= where the browser cannot compress.
*/
web.link = (function () {

async function pass(bytes, stream) {
    return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
}

function toText(bytes) {
    let words = "";
    for (let i = 0; i < bytes.length; i += 4096)
        words += String.fromCharCode(...bytes.subarray(i, i + 4096));
    return btoa(words).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "");
}

function toBytes(words) {
    return Uint8Array.from(atob(words.replace(/-/g, "+").replace(/_/g, "/")), (c) => c.charCodeAt(0));
}

async function make(name, text) {
    const whole = name + "\n" + text;
    if (!window.CompressionStream)
        return "#plain=" + encodeURIComponent(whole);
    return "#deck=" + toText(await pass(new TextEncoder().encode(whole), new CompressionStream("deflate-raw")));
}

/* {name, text} of an address; null if it has none, or one that cannot be read. */
async function read(hash) {
    try {
        const whole = hash.startsWith("#plain=") ? decodeURIComponent(hash.slice(7))
            : hash.startsWith("#deck=") ? new TextDecoder("utf-8", {fatal: true}).decode(
                await pass(toBytes(hash.slice(6)), new DecompressionStream("deflate-raw"))) : "";
        const end = whole.indexOf("\n");
        return end > 0 ? {name: whole.slice(0, end), text: whole.slice(end + 1)} : null;
    } catch (error) {
        return null;
    }
}

return {make, read};
}());
