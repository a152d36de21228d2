# SPDX-License-Identifier: GPL-3.0-or-later
#
# tables.awk CELLS json=1 SUMMARY text=1 ROWS [matrix=1 MATRIX] [check=1 CHECK] - the tables of a report (cells.c) have the
# inputs, facts, extremes, rows and expected values that the other outputs have: json of --summary and --check, the table
# with --wide, and the matrix.  Prints what is wrong, then "N passed, M failed".
function that(is_so, what) {
    if (is_so)
        passed++
    else if (++failed <= 40)
        print "FAILED: " where ": " what
}
function near(what, found, expected, slack, d) {
    d = found - expected
    that(d <= slack && -d <= slack, what ": " found ", expected " expected)
}

# ------------------------------------------------------------------------------------------------- JSON, one object a line

# The value of a key; is_text: it is in quotation marks, has_value: it is not null.
function get(key, rest) {
    is_text = has_value = 0
    if (!match($0, "\"" key "\":"))
        return ""
    rest = substr($0, RSTART + RLENGTH)
    is_text = substr(rest, 1, 1) == "\""
    if (is_text)
        match(rest, /^"([^"\\]|\\.)*"/)
    else
        match(rest, /^[^,}]*/)
    rest = substr(rest, 1 + is_text, RLENGTH - 2 * is_text)
    has_value = is_text || rest != "null"
    gsub(/\\"/, "\"", rest)
    return has_value ? rest : ""
}
function number(key, digits, value) {
    value = get(key)
    return !has_value ? "–" : value == "inf" ? "∞" : value == "-inf" ? "−∞" : is_text ? value : sprintf("%." digits "g", value)
}
function angle(digits, value) {
    value = get("theta2")
    return has_value ? sprintf("%." digits "g°", value) : ""
}
# As it is written by hand.
function unit(words) {
    words = get("unit")
    if (words == "1" || words == "deg")
        return words == "deg" ? "°" : ""
    gsub(/\./, "·", words)
    gsub(/2/, "²", words)
    gsub(/3/, "³", words)
    return words
}
function is_words(value) { # they take the place of value, unit, angle and branch
    value = get("value")
    return is_text && value !~ /inf/
}

# ------------------------------------------------------------------------------------------------------ cells

BEGIN {
    FS = "\t"
    in_si["N"] = in_si["m"] = 1
    in_si["cm"] = 0.01
    in_si["mm"] = 0.001
    in_si["in"] = 0.0254
    in_si["ft"] = 0.3048
    in_si["lbf"] = 4.4482216152605
    in_si["kgf"] = 9.80665
}
FNR == 1 { files++ }
files == 1 && /^table/ {
    class = $2
    title = $3
    that(title ~ "^Table " ++tables "\\. ", "the number of the table " title)
    sub(/^Table [0-9]*\. /, "", title)
    branch = title ~ / open branch /  ? "open" : "crossed"
    tables_of[class]++
    if (class == "facts works" && split(title, of_works, /[()]|·/) > 2) { # "Terms of virtual work (N·mm)"
        force = in_si[of_works[2]]
        torque = force * in_si[of_works[3]]
    }
    if (class == "rows")
        that(title ~ " " (tables_of["rows"] == 1 ? "open" : "crossed") " branch ", "the title " title)
    sub(/ \([0-9]+\)$/, "", title)
    next
}
files == 1 {
    sub(/^row\t/, "")
    if (class == "rows" && NF > 2) # not a heading, nor a reason of all its cells
        row[branch, ++rows[branch]] = $0
    else if (class == "facts sides" && !sides_done)
        side[++sides] = $0
    else if (class ~ /^facts( broad)?$/) {
        if (title !~ /^(Expected|Smallest)/)
            gsub(/\t\t+/, "\t") # a column that is empty is left out
        shown[title, ++shown_n[title]] = $0
        has[title, $0] = 1
        line_of[title, $1] = $0
    }
    next
}

# ------------------------------------------------------------------------------------------------------ summary

json && FNR == 1 { is_input = 1 }
json && /^"facts"/ { is_input = 0 }
json && /^\{"name"/ {
    wanted = is_words() ? get("name") "\t" get("value") : get("name") "\t" number("value", 6) "\t" unit()
    if (is_input) {
        wanted = wanted "\t" get("meaning")
        gsub(/\t\t+/, "\t", wanted)
        that(shown["Inputs as understood", ++inputs] == wanted, "the input " wanted ", shown " shown["Inputs as understood", inputs])
        next
    }
    name = get("name")
    own = get("branch")
    if (name !~ /\(/) {
        keep_fact()
        next
    }
    if (name !~ /^m(in|ax)/ || name ~ /residual/)
        next
    column = substr(name, 5, length(name) - 5)
    for (k = 0; k < 2; k++) {
        of = k ? "crossed" : "open"
        if (own != "" && own != of)
            continue
        extreme[of, column, substr(name, 1, 3)] = number("value", 6) "\t" angle(6)
        if (substr(name, 1, 3) == "min")
            unit_of[of, column] = unit()
        columns[of, column] = 1
    }
}
# A fact that is the same on both branches stands there once, without a branch.
function keep_fact(key) {
    key = is_words() ? wanted "\t" get("meaning") : wanted "\t" angle(6)
    if (key in fact_at) {
        fact_branch[fact_at[key]] = ""
        return
    }
    fact_at[key] = ++facts
    fact[facts] = key
    fact_branch[facts] = own
    fact_meaning[facts] = get("meaning")
    fact_is_words[facts] = is_words()
}
function check_facts(i, line, titles, n, k, found) {
    n = split("Type and key facts,Turning moment,Actual motion", titles, ",")
    for (i = 1; i <= facts; i++) {
        line = fact_is_words[i] ? fact[i] : fact[i] "\t" fact_branch[i] "\t" fact_meaning[i]
        gsub(/\t\t+/, "\t", line)
        found = 0
        for (k = 1; k <= n; k++)
            found += (titles[k], line) in has
        that(found, "the fact is not shown: " line)
    }
    for (k = 1; k <= n; k++)
        found_facts += shown_n[titles[k]]
    that(found_facts == facts, found_facts " facts, expected " facts)
}
function check_extremes(key, part, title, line) {
    for (key in columns) {
        split(key, part, SUBSEP)
        title = "Smallest and largest values, " part[1] " branch"
        line = line_of[title, part[2]]
        that(line != "", "no extremes of " part[2] ", " part[1])
        if ((key, "min") in extreme && (key, "max") in extreme)
            that(line == part[2] "\t" unit_of[key] "\t" extreme[key, "min"] "\t" extreme[key, "max"], "the extremes " line)
    }
}

# ----------------------------------------------------------------------------------------------------- rows, the matrix

text && /^# branch: / { of = substr($0, 11) }
text && !/^#/ && !/^$/ {
    line = $0
    sub(/^ +/, "", line)
    gsub(/ +/, "\t", line)
    n_rows[of]++
    that(row[of, n_rows[of]] == line, "the row " row[of, n_rows[of]] ", expected " line)
}
matrix && !/^#/ && !/^$/ {
    split($0, part, " +")
    for (n = 0; (n + 1) in part; n++)
        ;
    right[++n_right] = part[n]
    size = part[n] > size ? part[n] : -part[n] > size ? -part[n] : size
}
# What is known of the nine equations: m a less weight less loads.
function check_sides(i, part, scale) {
    that(sides == 9 && n_right == 9, sides " equations, the matrix has " n_right)
    for (i = 1; i <= sides; i++) {
        gsub(/−/, "-", side[i])
        split(side[i], part, "\t")
        scale = part[1] ~ /moments$/ ? torque : force
        near("the right side of " part[1], part[5] * scale, right[i], 1e-5 * size)
        near("the parts of " part[1], (part[2] + part[3] + part[4]) * scale, right[i], 1e-4 * size)
        that(part[1] !~ /moments$/ || part[3] + 0 == 0, "a weight has a moment: " side[i])
    }
}

# ------------------------------------------------------------------------------------------------------ expected values

check && /^\{"result"/ {
    computed = number("computed", 9)
    is_known = has_value
    wanted = get("name") "\t" angle(9) "\t" get("branch") "\t" get("printed") "\t" (is_known ? computed : "") "\t" unit()
    tolerance = number("tolerance", 6)
    wanted = wanted "\t" (has_value ? tolerance : "") "\t" get("result") (is_known ? "" : ": " get("message"))
    line = shown["Expected values", ++checks]
    that(line == wanted, "the expected value " line ", expected " wanted)
}

END {
    check_facts()
    check_extremes()
    that(inputs > 0 && inputs == shown_n["Inputs as understood"], "inputs: " inputs)
    that(tables_of["rows"] == 2, "tables of rows: " tables_of["rows"])
    that(n_rows["open"] == rows["open"] && n_rows["crossed"] == rows["crossed"] && rows["open"], "rows: " rows["open"] ", " rows["crossed"])
    if (n_right && sides) # a motor's motion has no instant of its own
        check_sides()
    that(checks + 0 == shown_n["Expected values"] + 0, "expected values: " shown_n["Expected values"] ", json has " checks)
    print passed " passed, " failed + 0 " failed"
    exit failed > 0
}
