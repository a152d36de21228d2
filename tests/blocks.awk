# SPDX-License-Identifier: GPL-3.0-or-later
#
# blocks.awk - the blocks of a FILE.test, as blocks.sh describes them.

BEGIN {
    stop = ENVIRON["STOP_AT_FAILURE"]
}

/^  / && writing != "" {content = content substr($0, 3) "\n"; next}
writing != "" {end_file()}
/^#/ || /^needs / {next}
/^$/ {run_block(); next}
/^file / {
    run_block()
    writing = $2
    content = ""
    if (NF > 2) {
        while ((getline text <$3) > 0) content = content text "\n"
        close($3)
    }
    next
}
/^\$ / {
    if (status_given || wanted || rows || complete) run_block()
    if (script == "") {script = substr($0, 3); place = FNR}
    else script = script "\n" substr($0, 3)
    next
}
/^= / {status = $2; status_given = 1; next}
/^\{\} / {row[++rows] = substr($0, 3); row_place[rows] = FNR; next}
/^[|!+-]( |$|[0-9*])/ {
    kind[++wanted] = substr($0, 1, 1)
    want[wanted] = /^.[0-9*]/ ? substr($0, 2) : " " substr($0, 3)
    next
}
/^\.$/ {complete = 1; next}
{fail(FNR, "no line of a block: " $0)}

END {
    if (writing != "") end_file()
    run_block()
    print passed + 0 " passed, " failed + 0 " failed"
    exit failed > 0
}

function end_file() {
    if (index(content, "{}")) {template = writing; template_text = content}
    else write_file(writing, content)
    writing = ""
}
function write_file(name, text) {
    printf "%s", text >name
    close(name)
}

# The block that has been read, once or for each of its rows.
function run_block(    i, k, n, fixed, part, one, text) {
    if (script == "" && (wanted || rows || status_given || complete)) fail(FNR, "expectations without a command")
    if (script != "") {
        fixed = wanted + 0
        if (!rows) run(script)
        for (i = 1; i <= rows; i++) {
            n = split(row[i], part, / +=> /)
            sub(/^ +/, "", part[1])
            for (k = 2; k <= n; k++) {
                kind[fixed + k - 1] = status >= 2 ? "!" : "|"
                want[fixed + k - 1] = " " part[k]
            }
            wanted = fixed + n - 1
            one = script
            if (index(script, "{}")) one = put(script, part[1])
            else {
                text = part[1]
                gsub(/ *\/\/ */, "\n", text)
                write_file(template, put(template_text, text))
            }
            place = row_place[i]
            run(one)
        }
    }
    script = ""
    wanted = rows = status = status_given = complete = 0
}
function put(text, value,    at, all) {
    while ((at = index(text, "{}")) > 0) {
        all = all substr(text, 1, at - 1) value
        text = substr(text, at + 2)
    }
    return all text
}

function run(command,    ended, i, j, n, at, found, any, times, results, lines, n_out, n_err, text) {
    ended = system("{ " command "\n} >../out 2>../err </dev/null")
    for (n_out = 0; (getline out[n_out + 1] <"../out") > 0;) n_out++
    for (n_err = 0; (getline err[n_err + 1] <"../err") > 0;) n_err++
    close("../out")
    close("../err")
    failing = command
    result(ended == status, "exit status " ended ", expected " status + 0 (n_err ? "; " err[1] : ""))
    at = 0
    for (i = 1; i <= wanted; i++) {
        text = want[i]
        if (kind[i] == "|") {
            results++
            lines++
            n = cut(substr(text, 2), pattern)
            found = 0
            for (j = at + 1; j <= n_out && !found; j++)
                if (matches(1, n, 1, cut(out[j], words))) found = j
            if (found) at = found
            result(found, "no line" text (at ? " below line " at " of the results" : ""))
        } else {
            n = 0
            times = text ~ /^[0-9]/ ? text + 0 : 0
            any = text ~ /^[*]/
            sub(/^[0-9*]* /, "", text)
            if (kind[i] == "!") {
                for (j = 1; j <= n_err; j++) if (index(err[j], text)) {n++; err_wanted[j] = 1}
                result(any || n == (times ? times : 1),
                       n " messages have " text (n_err ? "; the first is " err[1] : ""))
            } else {
                for (j = 1; j <= n_out; j++) if (text == "" || index(out[j], text)) n++
                results += kind[i] == "+"
                result(kind[i] == "-" ? !n : times ? n == times : n, n " lines of the results have " text)
            }
        }
    }
    for (j = 1; j <= n_err; j++) {
        if (!err_wanted[j] && err[j] !~ /--help/) result(0, "a message that is not expected: " err[j])
        delete err_wanted[j]
    }
    if (complete) result(n_out == lines, n_out " lines of results, " lines + 0 " are expected; the last is " out[n_out])
    if (status >= 2 && !results) result(!n_out, "results where none are expected: " out[1])
}

# A line cut into words; a comma is one, and a semicolon.
function cut(line, into) {
    gsub(/\r$/, "", line)
    gsub(/[,;]/, " & ", line)
    return split(line, into, " ")
}

# Do words[j..m] match pattern[i..n]?
function matches(i, n, j, m,    k) {
    while (i <= n && pattern[i] != "...") {
        if (j > m || !same(words[j], pattern[i])) return 0
        i++
        j++
    }
    if (i > n) return j > m
    if (i == n) return 1
    for (k = j; k <= m; k++) if (matches(i + 1, n, k, m)) return 1
    return 0
}

# A number with decimals has half of the last one as its tolerance, one without is exact but for rounding.
function same(word, shown,    digits, power, d) {
    if (word == shown) return 1
    if (!number(word) || !number(shown)) return 0
    d = word - shown
    if (d < 0) d = -d
    power = shown ~ /e/ ? substr(shown, index(shown, "e") + 1) : 0
    sub(/e.*/, "", shown)
    digits = index(shown, ".") ? length(shown) - index(shown, ".") : 0
    return digits ? d <= 0.50001 * 10 ^ (power - digits) : d <= 1e-9 * (shown < 0 ? -shown : shown)
}
function number(word) { return word ~ /^[-+]?[0-9]+([.][0-9]+)?(e[-+]?[0-9]+)?$/ }

function result(good, what) {
    if (good) passed++
    else fail(place, what)
}
function fail(line, what) {
    failed++
    print FILENAME ":" line ": " substr(what, 1, 300)
    sub(/.*\n/, "", failing) # the last line of a script
    if (failing != "") print "        " substr(failing, 1, 300)
    if (stop) {print passed + 0 " passed, " failed " failed"; exit 1}
}
