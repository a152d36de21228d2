/* SPDX-License-Identifier: GPL-3.0-or-later
**
** faults.js FILE... - the small faults that faults.py may put into scripts, as JSON: of each its place in bytes, its line, sort, text and
** the faulty text.  For Debian's node-acorn.
*/
"use strict";

const fs = require("node:fs");
const acorn = require(process.env.ACORN || "/usr/share/nodejs/acorn");
const SWAPS = {"+": "-", "-": "+", "*": "/", "/": "*", "%": "/", "+=": "-=", "-=": "+=", "*=": "/=", "/=": "*="};
const COMPARE = {"<": ["<=", ">="], ">": [">=", "<="], "<=": ["<", ">"], ">=": [">", "<"], "===": ["!=="], "!==": ["==="], "==": ["!="], "!=": ["=="]};
const TWINS = {x: "y", y: "x", min: "max", max: "min", sin: "cos", cos: "sin", floor: "ceil", ceil: "floor", first: "last", last: "first"};
const found = [];

for (const file of process.argv.slice(2)) {
    const source = fs.readFileSync(file, "utf8"), text = (x) => source.slice(x.start, x.end);
    const add = (x, sort, ...faulty) => found.push({file, start: Buffer.byteLength(source.slice(0, x.start)), end: Buffer.byteLength(source.slice(0, x.end)),
        line: x.loc.start.line, sort, right: text(x), faulty});

    (function visit(x, parent) {
        if (!x || typeof x.type !== "string")
            return;
        if (x.type === "BinaryExpression" || x.type === "AssignmentExpression") {
            if (SWAPS[x.operator])
                add(x, "arithmetic", `${text(x.left)} ${SWAPS[x.operator]} ${text(x.right)}`);
            else if (COMPARE[x.operator])
                add(x, "comparison", ...COMPARE[x.operator].map((sign) => `${text(x.left)} ${sign} ${text(x.right)}`));
        } else if (x.type === "LogicalExpression" && x.operator !== "??") {
            add(x, "logic", `(${text(x.left)}) ${x.operator === "&&" ? "||" : "&&"} (${text(x.right)})`);
        } else if (x.type === "IfStatement" || x.type === "ConditionalExpression") {
            add(x.test, "logic", `!(${text(x.test)})`);
        } else if (x.type === "UnaryExpression" && "!-".includes(x.operator)) {
            add(x, x.operator === "!" ? "logic" : "sign", text(x.argument));
        } else if (x.type === "Literal" && typeof x.value === "number") {
            add(x, "constant", String(x.value + 1), String(x.value === 0 ? 1 : -x.value), `(${x.value} / 2)`);
        } else if (x.type === "CallExpression" && x.arguments.length > 1 && x.arguments.every((y) => y.type !== "SpreadElement")) {
            const swapped = x.arguments.map(text);
            [swapped[0], swapped[1]] = [swapped[1], swapped[0]];
            if (swapped[0] !== swapped[1])
                add(x, "arguments", `${text(x.callee)}(${swapped.join(", ")})`);
        } else if (x.type === "MemberExpression" && !x.computed && TWINS[x.property.name]) {
            add(x.property, "twin", TWINS[x.property.name]);
        } else if (x.type === "ExpressionStatement" && !x.directive && parent.type === "BlockStatement") {
            add(x, "statement", ";");
        }
        for (const key of Object.keys(x))
            for (const child of Array.isArray(x[key]) ? x[key] : [x[key]])
                if (child && typeof child === "object" && key !== "loc")
                    visit(child, x);
    })(acorn.parse(source, {ecmaVersion: 2022, locations: true}), {type: ""});
}
console.log(JSON.stringify(found));
