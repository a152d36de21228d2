/* SPDX-License-Identifier: GPL-3.0-or-later
**
** program.js - the program, in a worker that can be stopped.
*/
web.program = function (busy) {

const code = Uint8Array.from(atob(document.getElementById("program").textContent.trim()), (c) => c.charCodeAt(0));
const address = URL.createObjectURL(new Blob([document.getElementById("worker").textContent], {type: "text/javascript"}));
let worker = null, waiting = new Map(), last = 0, slow = null;

function start() {
    worker = new Worker(address);
    worker.onmessage = ({data}) => settle(data);
    worker.onerror = (event) => {
        event.preventDefault();
        stop(event.message || "the program failed");
    };
    worker.postMessage({bytes: code});
}

function settle(data) {
    const request = waiting.get(data.id);
    if (!request)
        return;
    waiting.delete(data.id);
    watch();
    if (data.failed !== undefined)
        request.reject(new Error(data.failed));
    else
        request.resolve(data);
}

/* Tell after a while that the program is at work. */
function watch() {
    if (waiting.size && slow === null) {
        slow = setTimeout(() => busy(true), 400);
    } else if (!waiting.size && slow !== null) {
        clearTimeout(slow);
        slow = null;
        busy(false);
    }
}

/* End what it is doing. */
function stop(why) {
    const left = [...waiting.values()];
    worker.terminate();
    waiting = new Map();
    watch();
    start();
    left.forEach((request) => request.reject(new Error(why || "stopped")));
}

/* Ask for a task of worker.js; a promise of its answer. */
function ask(task, given) {
    return new Promise((resolve, reject) => {
        waiting.set(++last, {resolve, reject});
        worker.postMessage({id: last, task, ...given});
        watch();
    });
}

start();
return {ask, stop};
};
