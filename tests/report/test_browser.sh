#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_browser.sh - the interactive drawing of a report, driven in headless Chromium; the page on paper.
. "$(dirname "$0")/../harness.sh"
tests=$(dirname "$decks")/report

needs chromium chromium
needs pdftotext poppler-utils

# browse OPTION... FILE: Chromium without a window, with a profile of its own, which talks to nobody.
browse() {
    rm -rf profile
    timeout 300 chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-dev-shm-usage \
        --disable-background-networking --disable-component-update --disable-sync --user-data-dir="$work/profile" \
        --virtual-time-budget=20000 --enable-logging=stderr --v=0 "$@" 2>browser.err
}

# prepare NAME: NAME.html becomes NAME-test.html, with a script that collects errors before all others and
# drive.js after them.
prepare() {
    awk -v drive="$tests/drive.js" '
        /<head>/ && !done {print; print "<script>window.problems = []; window.onerror = function (m) {" \
            "window.problems.push(m); };</script>"; done = 1; next}
        /<\/body>/ {print "<script>"; while ((getline l <drive) > 0) print l; print "</script>"}
        {print}' "$1.html" >"$1-test.html"
}

# places NAME POINTS TURN: the drawn places of NAME.out are those of NAME.csv within half a pixel, at ten crank angles
# or more on each branch.  POINTS are the names in the drawing, in the order of the columns; the drawing is turned by
# TURN degrees.
places() {
    awk -F, -v points="$2" -v turn="$3" '
        BEGIN {n = split(points, name, " "); c = cos(turn * atan2(0, -1) / 180); s = sin(turn * atan2(0, -1) / 180)}
        FNR == NR {
            if (FNR > 1 && $0 ~ /,ok/)
                for (i = 1; i <= n; i++) {x[$1, $2 + 0, name[i]] = $(1 + 2 * i); y[$1, $2 + 0, name[i]] = $(2 + 2 * i)}
            next
        }
        {split($0, w, " ")}
        w[1] == "place" && ((w[2], w[3] + 0, w[4]) in x) {
            k = w[2] SUBSEP (w[3] + 0) SUBSEP w[4]
            dx = w[7] * (c * x[k] - s * y[k]) + w[8] - w[5]
            dy = w[9] - w[7] * (s * x[k] + c * y[k]) - w[6]
            seen[w[2], w[4]]++; pairs[w[2], w[4]] = 1
            if (dx * dx + dy * dy > 0.25) {bad++; print "far: " $0, dx, dy}
        }
        END {
            for (p in pairs) {count++; if (seen[p] < 10) {bad++; print p, seen[p]}}
            exit bad > 0 || count < n
        }' "$1.csv" "$1.out" >places.out
    status=$?
    check "$1: $(head -n 2 places.out)" test $status -eq 0
}

# drive NAME: the report is opened and driven; all that drive.js tried went well.
drive() {
    prepare "$1"
    browse --window-size=1600,1000 --dump-dom "file://$work/$1-test.html" >"$1.out"
    check "$1: drive.js came to its end: $(tail -n 3 browser.err)" grep -q '^end$' "$1.out"
    check "$1: $(grep '^failed' "$1.out" | head -n 3)" none '^failed' "$1.out"
    check "$1: console: $(grep CONSOLE browser.err)" none 'CONSOLE' browser.err
    check "$1: too few checks" test "$(grep -c '^ok' "$1.out")" -ge 7
}

# narrow NAME: in windows of 360 and 320 pixels, which are frames here, nothing overflows, each attribute of a drawing
# is sound, and the mechanism has its least height.
narrow() {
    for width in 360 320; do
        cat >narrow.html <<END
<!DOCTYPE html><body><iframe src="$1-test.html" width="$width" height="800" style="border: 0"></iframe><pre></pre>
<script>onmessage = (event) => { document.querySelector("pre").textContent += event.data + "\n"; };</script>
END
        browse --window-size=1000,1000 --dump-dom "file://$work/narrow.html" >narrow.out
        check "$1: $(grep "width $width" narrow.out)" grep -q "ok width $width" narrow.out
        check "$1: $(grep 'drawn' narrow.out)" grep -q 'ok drawn' narrow.out
        check "$1, $width px: $(grep 'equations' narrow.out)" grep -q 'ok equations' narrow.out
    done
}

# printed NAME SIZE PAGES: on this paper the report has at most so many pages, no letter is smaller than 7 pt, the
# first page has the contents and what is given, one of the first two the drawing, the last the deck; each has its
# number and the title.
printed() {
    awk -v size="$2" '/<\/body>/ {print "<style>@page {size: " size "}</style>"} {print}' "$1.html" >paper.html
    browse --no-pdf-header-footer --print-to-pdf="$work/printed.pdf" "file://$work/paper.html" >/dev/null
    pdftohtml -q -xml -i -zoom 3 -stdout printed.pdf >printed.xml 2>/dev/null
    pages=$(grep -c '<page ' printed.xml)
    check "$1 on $2 has $pages pages, not $3 at most" test "$pages" -ge 3 -a "$pages" -le "$3"
    awk -F'"' '/<fontspec/ && !($2 in size) {size[$2] = $4}
        /<text / {for (i = 1; i < NF; i++) if ($i ~ / font=$/ && size[$(i + 1)] < 20.5) print size[$(i + 1)] / 3 " pt: " $0}' printed.xml >small.out
    check "$1 on $2: $(head -n 2 small.out)" test ! -s small.out
    pdftotext -f 1 -l 1 -layout printed.pdf first.out
    pdftotext -f "$pages" -l "$pages" -layout printed.pdf last.out
    for words in Name Date '2 Mechanism and results' '1 Given data' 'Table 1'; do
        check "$1 on $2: no '$words' on the first page" grep -q "$words" first.out
    done
    pdftotext -f 1 -l 2 -layout printed.pdf first.out
    check "$1 on $2: no drawing on the first pages" grep -q 'Figure 1' first.out
    for page in $(seq "$pages"); do
        check "$1 on $2: no number of page $page" \
            sh -c "pdftotext -f $page -l $page -layout printed.pdf - | grep -q ' $page */ *$pages\$'"
    done
    check "$1 on $2: the deck is not at the end" grep -q 'Made by fourlink' last.out
}

# full NAME SIZE: of the report just printed no page but the last is less than half full, and no heading or title of a table is
# the last of its column.
full() {
    cp printed.pdf "$1-$2.pdf"
    pdftotext -bbox-layout printed.pdf full.out
    sed -n 's/.*<h[23][^>]*>\([^<]*\)<.*/\1/p; s/.*<caption>\([^<]*\)<.*/\1/p; s/.*<summary>\([^<]*\)<.*/\1/p' "$1.html" |
        sed 's/&lt;/</g; s/&amp;/\&/g' >headings.out
    awk -f full.awk headings.out full.out >wrong.out
    status=$?
    check "$1 on $2: $(head -n 3 wrong.out)" test $status -eq 0
}

# paper NAME SIZE: printed on this paper, each figure begins and ends on the same page and within its width.  For that
# each gets three words: at its beginning, at its end, and at its right edge.
paper() {
    awk -v size="$2" '
        /<\/body>/ {
            print "<style>@page {size: " size "} .mark {position: absolute; font: 4px monospace} " \
                "figure {position: relative}</style><script>document.querySelectorAll(" \
                "\"figure:not([hidden]), .panel:not([hidden])\").forEach((f, k) => {" \
                "for (const [word, place] of [[\"begin\", \"top: 0; left: 0\"], [\"end\", \"bottom: 0; left: 0\"], " \
                "[\"right\", \"top: 50%; right: 0\"]]) {const m = document.createElement(\"span\"); " \
                "m.className = \"mark\"; m.style = place; m.textContent = \"zz\" + word + k; f.append(m); " \
                "f.style.position = \"relative\"}});</script>"
        }
        {print}' "$1.html" >paper.html
    browse --no-pdf-header-footer --print-to-pdf="$work/$1-$2.pdf" "file://$work/paper.html" >/dev/null
    pdftotext -bbox "$1-$2.pdf" paper.out
    awk -f figures.awk paper.out >cut.out
    status=$?
    check "$1 on $2: $(head -n 3 cut.out)" test $status -eq 0
}

# rows NAME [SED]: the report, changed by SED and printed, has all cells of NAME.table on its paper.
rows() {
    sed -e "${2-}" "$1.html" >rows.html
    browse --no-pdf-header-footer --print-to-pdf="$work/rows.pdf" "file://$work/rows.html" >/dev/null
    pdftotext -bbox rows.pdf rows.out
    awk -f cells.awk "$1.table" rows.out >missing.out
    status=$?
    check "$1, printed after '${2-}': $(head -n 3 missing.out)" test $status -eq 0
}

cat >cells.awk <<'END'
FNR == NR {
    if (!/^#/ && NF) {n++; for (i = 1; i <= NF; i++) wanted[$i]++}
    next
}
/<page / {split($0, w, "\""); width = w[2]}
/<word / {
    split($0, w, "\"")
    if (w[6] > width || w[2] < 0) {bad++; print "beside the paper: " $0}
    sub(/<\/word>.*/, ""); sub(/.*>/, "")
    if ($0 == "Tables") split("", found)
    found[$0]++
}
END {
    for (x in wanted) if (found[x] < wanted[x]) {bad++; print found[x] + 0 " times " x ", not " wanted[x]}
    exit bad > 0 || n < 10
}
END

cat >figures.awk <<'END'
/<page / {page++; split($0, w, "\""); width = w[2]}
/>zz(begin|end|right)[0-9]+</ {
    match($0, />zz[a-z]+/); word = substr($0, RSTART + 3, RLENGTH - 3)
    match($0, /[0-9]+<\/word/); k = substr($0, RSTART, RLENGTH - 6)
    split($0, w, "\"")
    on[word, k] = page; figures[k] = 1
    if (w[6] > width || w[2] < 0) {bad++; print "figure " k " is wider than page " page}
}
END {
    for (k in figures) {
        n++
        if (!on["begin", k] || on["begin", k] != on["end", k] || on["begin", k] != on["right", k])
            {bad++; print "figure " k " begins on page " on["begin", k] ", ends on page " on["end", k]}
    }
    if (n < 3) {bad++; print n + 0 " figures"}
    exit bad > 0
}
END

# A line of a page is left, top, right, bottom and its words; a heading has another line below it, within 130 points and
# partly above each other.
cat >full.awk <<'END'
FNR == NR {is_heading[$0] = 1; next}
/<page / {page++; split($0, w, "\""); height = w[4]; pages = page}
/<line / {split($0, w, "\""); n++; on[n] = page; left[n] = w[2]; top[n] = w[4]; right[n] = w[6]; bottom[n] = w[8]; next}
/<word / {
    sub(/<\/word>.*/, ""); sub(/.*>/, "")
    gsub(/&lt;/, "<"); gsub(/&amp;/, "\\&")
    words[n] = words[n] (words[n] == "" ? "" : " ") $0
    if (bottom[n] < height - 31 && bottom[n] > lowest[page])
        lowest[page] = bottom[n]
    half[page] = height / 2
}
END {
    for (i = 1; i <= n; i++) {
        if (!(words[i] in is_heading))
            continue
        if (words[i] ~ /^[0-9]/ && !seen[words[i]]++) # of the contents
            continue
        headings++
        if (words[i] ~ /Discussion/) { # empty lines are below, which fill the page too
            if (bottom[i] + 110 > lowest[on[i]])
                lowest[on[i]] = bottom[i] + 110
            continue
        }
        below = 0
        for (k = 1; k <= n; k++)
            if (k != i && on[k] == on[i] && top[k] > top[i] + 2 && top[k] < top[i] + 130 && left[k] < right[i] + 60 && right[k] > left[i] && bottom[k] < height - 31)
                below = 1
        if (!below)
            {bad++; print "page " on[i] " ends with " words[i]}
    }
    for (k = 1; k < pages; k++)
        if (lowest[k] < half[k])
            {bad++; print "page " k " is half empty"}
    if (headings < 8)
        {bad++; print headings + 0 " headings"}
    exit bad > 0
}
END

# ---------------------------------------------------------------- the drawing follows the slider, the crank, the keys

run 0 --report=alvi.html "$alvi"
run 0 -f csv --units=mm -c theta2,B.x,B.y,C.x,C.y -o alvi.csv --set table.branch=both --set motion.interval='20 deg' "$alvi"
drive alvi
places alvi 'B C' 0
check "alvi: both branches" grep -q '^place crossed' alvi.out
narrow alvi

# The row of the table is the program's.
run 0 -c theta2,theta3,theta4,omega4 "$alvi"
check "the row at 80 deg: $(grep '^cell open 80 theta4' alvi.out)" \
    test "$(awk '$1 == 80 {print $3; exit}' out)" = "$(awk '$1 == "cell" && $2 == "open" && $3 == 80 && $4 == "theta4" {sub(/°$/, "", $5); print $5}' alvi.out)"

run 0 --report=crusher.html "$data/me3491-exercise-4.deck"
run 0 -f csv -c theta2,B.x,B.y,C.x,C.y,E.x,E.y -o crusher.csv "$data/me3491-exercise-4.deck"
drive crusher
places crusher 'B C P0' 0
check 'crusher: its wide table is divided on paper' grep -q '^ok on paper, 2 parts' crusher.out
narrow crusher

# Rows by time: half a turn and more of a motor that starts.
sed '/^turns/d; /^interval/d; s/^mode .*/mode = run-up\nrows = time\ntime_step = 10 ms\nduration = 0.4 s/' \
    "$data/../doc/motor-pump.deck" >motor.deck
run 0 -b open --report=motor.html motor.deck
run 0 -b open -f csv --units=mm -c time,B.x,B.y,C.x,C.y -o motor.csv motor.deck
drive motor
places motor 'B C' 0

# A vertical engine stands upright; its one instant has become a cycle.
run 0 --report=engine.html "$data/me3491-example-2.deck"
sed 's/^at  *= .*/interval = 10 deg/' "$data/me3491-example-2.deck" >cycle.deck
run 0 -f csv -c theta2,B.x,B.y,C.x,C.y -o engine.csv cycle.deck
drive engine
places engine 'B C' 90
check "engine: the instant is a row" grep -q '^place open 45 B' engine.out

run 0 --report=cylinder.html "$data/oscillating-cylinder.deck"
run 0 -f csv --units=mm -c theta2,B.x,B.y -o cylinder.csv "$data/oscillating-cylinder.deck"
drive cylinder
places cylinder 'B' 0

# Where the linkage cannot be assembled the crank is drawn alone.
cat >limited.deck <<'END'
title     = </script><script class="evil">window.evil = 1</script> & "quotes" ]]> <b class="evil">
mechanism = four-bar
[ground]
length = 100 mm
[crank]
length = 80 mm
mass   = 1 kg
cg     = 40 mm
[coupler]
length = 50 mm
[rocker]
length = 60 mm
[point P]
link = coupler
at   = (20, 30) mm
[load ]]>&<!--<script>]
link  = rocker
force = (0, -5) N
at    = (60, 0) mm
[motion]
speed    = 10 rad/s
interval = 10 deg
END
"$fourlink" --report=limited.html limited.deck 2>err
check "limited: $(head -n 2 err)" test -s limited.html
"$fourlink" -f csv --units=mm -c theta2,B.x,B.y,C.x,C.y -o limited.csv limited.deck 2>/dev/null
drive limited
places limited 'B C' 0
check "limited: the crank alone" grep -q '^place open 180 B' limited.out
check "limited: no coupler" none '^place open 180 C' limited.out

# --------------------------------------------------------------------------------------------- what says nothing

# shown NAME WORDS: the page of NAME.html has these words when its script has run.
shown() {
    browse --dump-dom "file://$work/$1.html" >"$1.dom"
    check "$1: '$2' is not there" grep -qF -- "$2" "$1.dom"
}

run 0 --report=where.html "$tests/look/inverted.deck"
shown where 'Mechanism at open, θ₂ = 100°, where cut acts'
check 'where: a velocity polygon' grep -q 'Velocity polygon' where.dom
check 'where: no rounding in the row of the table' none 'data-column="residual"' where.dom
check 'where: the caption of the picture' grep -q 'at θ₂ = 100°, where cut acts.</figcaption>' where.html
run 0 --report=odd.html --plot-at='65.12033235 deg' "$tests/look/inverted.deck"
shown odd 'Mechanism at open, θ₂ = 65.1203°<'
run 0 --synthesis --report=still.html "$data/synthesis/khurmi-5.2.deck"
shown still 'Mechanism at θ₂ = 60°'
check 'still: polygons without a speed' none '<span>\(Velocity\|Acceleration\) polygon' still.dom
check 'still: a largest speed without a speed' none 'largest speed' still.html

# ------------------------------------------------------------------------------------------------------- on paper

for size in A4 Letter; do
    paper crusher $size
    paper engine $size
done
needs pdftohtml poppler-utils
for deck in "$tests"/look/*.deck; do
    name=$(basename "$deck" .deck)
    "$fourlink" --report="$name.html" "$deck" 2>err
    prepare "$name"
    narrow "$name"
done
printed inverted A4 10
printed inverted Letter 12
printed friction A4 10
printed runuptime A4 17
printed tracers Letter 7

# Ten reports, in eight pages at most; the longest has nine on Letter, which is lower.
for name in me3491-exercise-4 alvi-5.1 khurmi-16.11 whitworth-150-100 elliptic-trammel marghitu-5.6 scotch-yoke-pump \
    steam-engine-240 hibbeler-16-59 me3491-example-2; do
    "$fourlink" --report="$name.html" "$data/$name.deck" >out 2>err
    printed "$name" A4 8
    full "$name" A4
    [ $name = me3491-example-2 ] && pages=9 || pages=8
    printed "$name" Letter $pages
    full "$name" Letter
done
run 0 --report=real.pdf "$alvi"
check 'as pdf' test "$(pdfinfo real.pdf | sed -n 's/^Pages: *//p')" = "$(pdfinfo alvi-5.1-A4.pdf | sed -n 's/^Pages: *//p')"
check 'as pdf: on A4' sh -c "pdfinfo real.pdf | grep -q '(A4)'"

# What is typed in survives a reload, is in the file that is saved, and on paper.
cat >typed.js <<'END'
const wait = (time) => new Promise((done) => setTimeout(done, time));
(async () => {
    const lines = [], field = (name) => document.getElementById("typed-" + name);
    if (!location.hash) {
        for (const [name, words] of [["name", "Ada L."], ["date", "3 May"], ["discussion", "First.\nSecond & <b>third</b>."]]) {
            field(name).value = words;
            field(name).dispatchEvent(new Event("input", {bubbles: true}));
        }
        const words = fourlink.typed.fileOf();
        lines.push("saved " + /value="Ada L\."/.test(words) + " " + /Second &amp; &lt;b&gt;third/.test(words) + " " + /id="fourlink-panels" hidden/.test(words));
        lines.push("told " + document.getElementById("typed-status").textContent);
        const frame = document.createElement("iframe");
        window.addEventListener("message", (event) => lines.push("again " + event.data));
        frame.src = location.href + "#again";
        document.body.append(frame);
        for (let k = 0; k < 100 && lines.length < 3; k++)
            await wait(100);
        frame.remove();
        document.title = lines.join(" | ");
    } else {
        window.parent.postMessage([field("name").value, field("date").value, field("discussion").value].join(" / "), "*");
    }
})();
END
awk '/<\/body>/ {print "<script>"; while ((getline l <"typed.js") > 0) print l; print "</script>"} {print}' alvi.html >typed.html
browse --dump-dom "file://$work/typed.html" >typed.out
check "saved: $(grep '<title>' typed.out)" grep -q '<title>saved true true true | told What you type is kept' typed.out
check "after a reload: $(grep -A 1 '<title>' typed.out)" sh -c "grep -A 1 '<title>' typed.out | tr '\n' ' ' | grep -q 'again Ada L. / 3 May / First. Second'"
browse --no-pdf-header-footer --print-to-pdf="$work/typed.pdf" "file://$work/typed.html" >/dev/null
pdftotext -layout typed.pdf typed.out
for words in 'Ada L.' '3 May' 'Second & <b>third</b>'; do
    check "not on paper: $words" grep -qF "$words" typed.out
done

# The tables: with script and style, with one of the two, and divided where they are wide.
"$fourlink" "$alvi" >alvi.table
rows alvi
rows alvi '/::details-content {/,/}/d'
rows alvi 's/<script>/<script type="text\/plain">/'
run 0 --report=wide.html "$matrix"
"$fourlink" "$matrix" >wide.table
rows wide

# A table of more than 1000 rows is printed if it is open.
run 0 -b open -c theta2,theta4 -i '0.1 deg' --report=long.html "$alvi"
"$fourlink" -b open -c theta2,theta4 -i '0.1 deg' "$alvi" >long.table
browse --no-pdf-header-footer --print-to-pdf="$work/long.pdf" "file://$work/long.html" >/dev/null
pdftotext -layout long.pdf long.out
check 'a long table is not printed' grep -q 'branch (3601). Open it on screen if it is to be printed' long.out
check 'a long table is printed' none '^ *359\.9  *[0-9]' long.out
rows long 's/<details /<details open="open" /'

# ---------------------------------------------------------------------------------------- without a script, and size

for part in controls panels more; do
    check "$part is hidden until the script starts" grep -q "id=\"fourlink-$part\"[^>]*hidden" alvi.html
done
check "the picture is not" grep -q '<figure class="mechanism" id="figure-[0-9]*">' alvi.html
for report in alvi crusher engine cylinder; do
    check "$report: $(wc -c <$report.html) bytes" test "$(wc -c <$report.html)" -lt 1000000
done

finish
