# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_plot.sh FOURLINK DATA - the pictures: --plot, --plot-kind, --plot-at, --plot-script.
# Prints each failed check, and in the end "N passed, M failed".  Without gnuplot only what does not need
# it is tried.
decks=$(cd "$(dirname "$0")/../decks" && pwd)
. "$(dirname "$0")/../harness.sh"
fourbar=$decks/coupler-point.deck
engine=$decks/engine.deck
set +u # a number that is missing is a failed check
kinds='mechanism motion forces turning-moment polar vectors klein animation'
not() { ! "$@"; }
newline='
'

# ------------------------------------------------------------------------------- options and mistakes

# refused MESSAGE ARGUMENT...: before anything is done
refused() {
    usage "$@"
    check "a file was written: fourlink $*" test ! -e x.svg
}
for name in x.bmp x.svgz svg x.svg.gz '' x.; do
    refused 'the name of a picture ends in .svg, .png, .pdf, .txt or .gif' --plot="$name" "$fourbar"
done
refused "--plot-kind must be mechanism, motion, forces, turning-moment, polar, vectors, klein or animation, not 'foo'" \
    --plot=x.svg --plot-kind=foo "$fourbar"
refused "did you mean 'motion'?" --plot=x.svg --plot-kind=motoin "$fourbar"
refused '--plot-kind must be' --plot=x.svg --plot-kind= "$fourbar"
refused '--plot-kind needs --plot or --plot-script' --plot-kind=motion "$fourbar"
refused '--plot-at needs --plot or --plot-script' --plot-at='40 deg' "$fourbar"
refused 'a picture is of one deck' --plot=x.svg "$fourbar" "$engine"
refused 'a picture is of one deck' --plot-script=x.gp "$fourbar" "$engine"
refused "an animation needs a name that ends in .gif, not 'x.svg'" --plot=x.svg --plot-kind=animation "$fourbar"
refused '--plot needs a value' "$fourbar" --plot
refused '-p needs a value' "$fourbar" -p
refused '--plot-at needs a value' "$fourbar" --plot=x.svg --plot-at
refused '--plot-script needs a value' "$fourbar" --plot-script

# at MESSAGE ANGLES [DECK]: refused after the table, which is printed all the same
run 0 "$fourbar"
mv out table
at() {
    for option in --plot=x.svg --plot-script=x.svg; do
        run 2 $option --plot-at="$2" "${3:-$fourbar}"
        says '--plot-at: error:'
        says "$1"
        lines err 1
        [ $# -gt 2 ] || same out table
        check 'no picture of a wrong angle' test ! -e x.svg
    done
}
at "'40 mm' is a length; expected an angle" '40 mm'
at 'expected an angle' ''
at 'expected an angle' '40 deg,'
at 'expected an angle' '40 deg,,50 deg'
at 'expected an angle' 'nowhere'
at 'more than 24 positions' 1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25
at 'the motion does not reach theta2 = 150' 150 "$data/me3491-exercise-1.deck"
at 'the motion does not reach theta2 = 150 deg' '20 deg, 150 deg' "$data/me3491-exercise-1.deck"
run 0 --plot-script=x.gp --plot-at=1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24 "$fourbar"
quiet

# cannot MESSAGE KIND ARGUMENT...: no such picture of this deck; the table is there
cannot() {
    message=$1
    kind=$2
    shift 2
    "$fourlink" "$@" >table 2>err
    rm -f x.gp
    run 2 --plot-script=x.gp --plot-kind=$kind "$@"
    says "--plot-kind: error: $message"
    lines err 1
    same out table
    check "a script of nothing: $kind" test ! -e x.gp
}
cannot "Klein's construction is for a slider-crank" klein "$fourbar"
for kind in forces turning-moment polar; do
    cannot 'there are no forces to draw: the deck has no masses and no loads' $kind "$alvi"
done
moment='the turning moment needs a crank that turns fully, at constant speed'
cannot "$moment" turning-moment "$data/me3491-exercise-1.deck"
cannot "$moment" turning-moment "$fourbar" --set=motion.speed=0
cannot "$moment" turning-moment "$fourbar" --set='motion.acceleration=1 rad/s2'
for kind in mechanism vectors animation; do
    cannot 'the links do not reach: B and D are too far apart' $kind "$data/me3491-exercise-1.deck" \
        --set='motion.from=150 deg' --set='motion.to=200 deg'
done
for kind in motion forces polar; do
    cannot 'the links reach at no angle of the motion' $kind "$data/me3491-exercise-1.deck" \
        --set='motion.from=150 deg' --set='motion.to=200 deg'
done

# ------------------------------------------------------------------------------- files that are not written

run 0 "$fourbar"
mv out table
cp "$fourbar" input.svg
cp "$fourbar" input.copy
ln -s input.svg link.svg
for option in --plot=input.svg --plot=./input.svg --plot=link.svg --plot-script=input.svg --plot-script=link.svg; do
    run 3 $option input.svg
    says 'it is an input'
    same input.svg input.copy
done
"$fourlink" --plot=input.svg <input.svg >out 2>err
check 'standard input is not written over' test $? -eq 3
same input.svg input.copy
mkdir folder.svg
run 3 --plot-script=folder.svg "$fourbar"
says 'folder.svg: Is a directory'
same out table
run 3 --plot-script=missing/x.gp "$fourbar"
says 'missing/x.gp: No such file'
same out table
run 3 --plot=x.svg missing.deck
nothing
says 'missing.deck'
check 'no picture without a deck' test ! -e x.svg
printf 'title = nothing\n' >empty.deck
run 2 --plot=x.svg empty.deck
check 'no picture of a wrong deck' test ! -e x.svg
# one file is not both results and picture
for pair in '--output=both.svg --plot=both.svg' '--output=both.svg --plot-script=both.svg' \
    '--plot=both.svg --plot-script=both.svg' '--output=./both.svg --plot=both.svg'; do
    rm -f both.svg
    "$fourlink" $pair "$fourbar" >out 2>err
    check "one file for two: $pair" test $? -ne 0
done
# - is standard output, as for --output
"$fourlink" --plot-script=- "$fourbar" >out 2>err
check '--plot-script=- writes no file of that name' test ! -e ./-

# -------------------------------------------------------------------------------------- gnuplot missing

# broken WHAT PATH MESSAGE: exit status 3, the table, no picture, no old picture touched
broken() {
    for old in yes no; do
        rm -rf pictures
        mkdir pictures
        [ $old = no ] || echo old >pictures/x.svg
        env PATH="$2" "$fourlink" --plot=pictures/x.svg "$fourbar" >out 2>err </dev/null
        check "$1: exit status $?" test $? -eq 3
        same out table
        says 'cannot draw pictures/x.svg'
        says "$3"
        if [ $old = yes ]; then
            check "$1: the old picture" test "$(cat pictures/x.svg)" = old
            only_file pictures x.svg
        else
            only_file pictures ''
        fi
    done
}
broken 'no gnuplot' /nonexistent gnuplot-nox
mkdir bin
broken 'no gnuplot in an empty folder' "$work/bin" gnuplot-nox
"$(command -v env)" PATH=/nonexistent "$fourlink" --plot-script=x.gp "$fourbar" >out 2>err
check 'a script needs no gnuplot' test $? -eq 0
quiet

fake() {
    printf '%s\n' '#!/bin/sh' "$@" >bin/gnuplot
    chmod +x bin/gnuplot
}
fake 'echo half of a picture' 'echo this is what went wrong >&2' 'exit 1'
broken 'gnuplot fails' "$work/bin" 'gnuplot failed'
says 'this is what went wrong'
fake 'echo half of a picture' 'kill -9 $$'
broken 'gnuplot is killed' "$work/bin" 'gnuplot failed'
fake 'exec 0<&-' 'exit 2'
broken 'gnuplot reads nothing' "$work/bin" 'gnuplot failed'
chmod -x bin/gnuplot
broken 'gnuplot cannot be run' "$work/bin" 'gnuplot'

# What is written is what gnuplot says: a fake one that repeats its script.
fake 'cat'
rm -f x.svg x.gp
env PATH="$work/bin:$PATH" "$fourlink" --plot=x.svg "$fourbar" >out 2>err
check 'a fake gnuplot' test $? -eq 0
quiet
same out table
run 0 --plot-script=x.gp "$fourbar"
same x.svg x.gp
check 'the head of the script' grep -q '^# mechanism of a deck, by fourlink [0-9.]*: for gnuplot 5 or later$' x.gp
rm bin/gnuplot

# ------------------------------------------------------------------------------------------- vectors
# The arrows of the scripts, as numbers: no gnuplot is needed.

# vectors SCRIPT: "PANEL<tab>PEN<tab>X1 Y1 X2 Y2" of each arrow with a head, and "PANEL<tab>note<tab>NAME VALUE"
arrows() {
    awk -v head="${2:-head}" '
        /^unset arrow; unset label; unset object/ {n = 0}
        /^set arrow / && $7 == head {split($4, a, ","); split($6, b, ",")
            line[++n] = $NF "\t" a[1] " " a[2] " " b[1] " " b[2]}
        /^set label .* at graph/ {words = $0; sub(/^set label ./, "", words); sub(/. at graph.*/, "", words)
            line[++n] = "note\t" words}
        /^set title / {title = $0; sub(/^set title ./, "", title); sub(/" offset [^"]*$/, "", title); gsub(/\047\047/, "\047", title)
            for (i = 1; i <= n; i++) print title "\t" line[i]; n = 0}' "$1"
}
# number COLUMN: of the one row in csv
number() {
    awk -F, -v name="$1" 'NR == 1 {for (i = 1; i <= NF; i++) {sub(/ .*/, "", $i); if ($i == name) c = i}}
        NR == 2 {print c ? $c : "none"}' csv
}
near() { # near WHAT X Y TOLERANCE, relative to Y
    check "$1: $2, expected $3" awk -v x="$2" -v y="$3" -v e="$4" 'BEGIN {
        d = x - y; s = y < 0 ? -y : y; exit !(x != "" && y != "none" && d <= e * s + 1e-9 && -d <= e * s + 1e-9)}'
}
# sum of the arrows of a panel: the size of their sum, that of the largest, their number, number of notes
closing() {
    awk -F '\t' -v panel="$1" '$1 == panel && $2 == "note" {notes++}
        $1 == panel && $2 != "note" {split($3, p, " "); x = p[3] - p[1]; y = p[4] - p[2]; X += x; Y += y; n++
            s = sqrt(x * x + y * y); if (s > big) big = s}
        END {s = sqrt(X * X + Y * Y); limit = (n == notes ? 1e-4 : 0.02) * big
            print s, big, n + 0, notes + 0; exit !(n >= 2 && notes >= n && notes - n < 4 && s <= limit)}' arrows
}
closes() { closing "$1" >/dev/null; }
# arrow PANEL NUMBER: "DX DY X2 Y2" of its arrow number so many
arrow() {
    awk -F '\t' -v panel="$1" -v k="$2" '$1 == panel && $2 != "note" && ++n == k {split($3, p, " ")
        printf "%.9g %.9g %.9g %.9g\n", p[3] - p[1], p[4] - p[2], p[3], p[4]}' arrows
}
size() { awk -v x="$1" -v y="$2" 'BEGIN {printf "%.9g\n", sqrt(x * x + y * y)}'; }
note() { awk -F '\t' -v panel="$1" -v name="$2" '$1 == panel && $2 == "note" && index($3, name " ") == 1 {
    split(substr($3, length(name) + 2), w, " "); print w[1]}' arrows; }

for deck in "$fourbar" "$engine"; do
    case $deck in
    "$fourbar") links='crank coupler rocker' r=0.020 f=0.056 angles='20 190 333' ;;
    *) links='crank rod piston' r=0.150 f=0 angles='40 120 333' ;;
    esac
    for angle in $angles; do
        for branch in open crossed; do
            run 0 --plot-script=v.gp --plot-kind=vectors --plot-at="$angle deg" --branch=$branch "$deck"
            quiet
            arrows v.gp >arrows
            "$fourlink" --format=csv --branch=$branch --set="motion.at=$angle deg" --columns=all "$deck" >csv
            where="$(basename "$deck"), $branch, $angle deg"
            for link in $links; do
                check "forces on the $link: $where: $(closing "forces on the $link")" closes "forces on the $link"
            done
            # each polygon is a chain
            check "the forces follow each other: $where" awk -F '\t' 'function far(a, b) {return a - b > 0.02 * big || b - a > 0.02 * big}
                $1 ~ /^forces on/ && $2 != "note" {split($3, p, " ")
                    big = 1 + sqrt((p[3] - p[1]) ^ 2 + (p[4] - p[2]) ^ 2) + sqrt(x * x + y * y)
                    if (last == $1 && (far(p[1], x) || far(p[2], y))) bad = 1; x = p[3]; y = p[4]; last = $1; n++}
                END {exit !(n > 5 && !bad)}' arrows
            # the first of the crank is F12
            set -- $(arrow 'forces on the crank' 1)
            near "F12x: $where" "$1" "$(number F12x)" 1e-5
            near "F12y: $where" "$2" "$(number F12y)" 1e-5
            near "F12: $where" "$(note 'forces on the crank' F12)" "$(number F12)" 1e-4
            set -- $(arrow 'forces on the crank' 2)
            near "F32 = -F23: $where" "$1" "$(number F23x | awk '{print -$1}')" 1e-5
            for link in $links; do
                [ $link = crank ] || near "F34 on the $link: $where" \
                    "$(note "forces on the $link" $([ $link = coupler ] || [ $link = rod ] && echo F43 || echo F34))" \
                    "$(number F34)" 1e-4
            done
            near "Ts: $where" "$(note 'free body of the crank' Ts)" "$(number Ts)" 1e-4

            # velocities: vB + vCB = vC
            check "three velocities: $where" test "$(grep -c '^velocity polygon	[2-4]	' arrows)" -eq 3
            set -- $(arrow 'velocity polygon' 1) $(arrow 'velocity polygon' 3) $(arrow 'velocity polygon' 2)
            near "vB + vCB = vC, x: $where" "$(awk -v x="$1" -v y="$5" 'BEGIN {printf "%.9g", x + y}')" "$9" 1e-5
            near "vB + vCB = vC, y: $where" "$(awk -v x="$2" -v y="$6" 'BEGIN {printf "%.9g", x + y}')" "${10}" 2e-5
            near "vB: $where" "$(size "$1" "$2")" "$(number omega2 | awk -v r=$r '{printf "%.9g", $1 * r}')" 1e-6
            near "vB is at right angles to the crank: $where" "$(number theta2 | awk -v x="$1" -v y="$2" '{
                t = $1 / 57.29577951308232; print 1 + (x * cos(t) + y * sin(t)) / sqrt(x * x + y * y)}')" 1 1e-6
            side=$([ $branch = open ] && echo 1 || echo -1)
            if [ $f != 0 ]; then
                near "vC: $where" "$(size "$9" "${10}")" "$(number omega4 | awk -v f=$f '{s = $1 * f; printf "%.9g", s < 0 ? -s : s}')" 1e-5
                near "note of vC: $where" "$(note 'velocity polygon' vC)" "$(size "$9" "${10}")" 1e-4
            else
                near "vC: $where" "$(awk -v x="$9" -v s=$side 'BEGIN {print -s * x}')" "$(number v)" 1e-5
            fi

            # accelerations: both ways meet in c', small parts left out
            check "accelerations meet: $where" awk -F '\t' -v four=$f '$1 == "acceleration polygon" && $2 != "note" {
                    split($3, p, " "); s = sqrt((p[3] - p[1]) ^ 2 + (p[4] - p[2]) ^ 2); if (s > big) big = s
                    if ($2 < 4) {x = p[3]; y = p[4]; n++} else {X = p[3]; Y = p[4]; m++}}
                $1 == "acceleration polygon" && $2 == "note" {notes++}
                END {d = sqrt((x - X) ^ 2 + (y - Y) ^ 2); exit !(n && m && notes >= n + m && d <= (notes == n + m ? 1e-5 : 0.02) * big)}' arrows
            near "aB: $where" "$(note 'acceleration polygon' aBn)" "$(number omega2 | awk -v r=$r '{print $1 * $1 * r}')" 1e-4
            if [ $f != 0 ]; then
                near "aCn: $where" "$(note 'acceleration polygon' aCn)" "$(number omega4 | awk -v f=$f '{print $1 * $1 * f}')" 1e-4
                near "aCt: $where" "$(note 'acceleration polygon' aCt)" "$(number alpha4 | awk -v f=$f '{s = $1 * f; print s < 0 ? -s : s}')" 1e-4
            else
                near "aC: $where" "$(note 'acceleration polygon' aC)" "$(number a | awk '{print $1 < 0 ? -$1 : $1}')" 1e-4
            fi
        done
    done
done
check 'the arrows of a load bear its name' grep -q '^forces on the piston	note	gas ' arrows
run 0 --plot-script=v.gp --plot-kind=vectors "$fourbar"
check 'a load by its name' grep -q '^set label .push. at' v.gp
check 'the weights' grep -q '^set label .W3 2.943 N. at' v.gp

# Klein's construction against its columns, which are positive towards the piston and, OM, with its speed.
for angle in 20 140 300; do
    for branch in open crossed; do
        where="$branch, $angle deg"
        side=$([ $branch = open ] && echo 1 || echo -1)
        run 0 --plot-script=k.gp --plot-kind=klein --plot-at="$angle deg" --branch=$branch "$engine"
        quiet
        "$fourlink" --format=csv --branch=$branch --set="motion.at=$angle deg" \
            --columns=klein_OM,klein_ON,klein_BM,klein_BQ,klein_QN,v,a,omega2 "$engine" >csv
        arrows k.gp nohead | grep "^Klein's construction, $branch, theta2 = $angle deg	" >arrows
        set -- $(awk -F '\t' -v s=$side '$2 == 4 {split($3, p, " "); print s * p[1], p[2], p[3], p[4]}' arrows)
        near "ON: $where" "$1" "$(number klein_ON)" 1e-5
        near "N is on the line of stroke: $where" "$2" 0 0
        near "ON ends in O: $where" "$3$4" 00 0
        near "a = omega2^2 ON: $where" "$(number omega2 | awk -v x="$1" '{print $1 * $1 * x / 1000}')" "$(number a)" 2e-5
        set -- $(awk -F '\t' -v s=$side '$2 == 10 {split($3, p, " "); print p[3], s * p[4]; exit}' arrows)
        near "M is above O: $where" "$1" 0 0
        near "OM: $where" "$2" "$(number klein_OM)" 1e-5
        near "v = omega2 OM: $where" "$(number omega2 | awk -v x="$2" '{print $1 * x / 1000}')" "$(number v)" 2e-5
        set -- $(awk -F '\t' '$2 == 10 && ++n > 1 {split($3, p, " "); print p[3] - p[1], p[4] - p[2]}' arrows)
        near "BQ: $where" "$(size "$1" "$2")" "$(number klein_BQ)" 2e-5
        near "QN: $where" "$(size "$3" "$4")" "$(number klein_QN | awk '{print $1 < 0 ? -$1 : $1}')" 2e-5
        near "QN is at right angles to BQ: $where" "$(awk -v a="$1" -v b="$2" -v c="$3" -v d="$4" 'BEGIN {
            print 1 + (a * c + b * d) / sqrt((a * a + b * b) * (c * c + d * d))}')" 1 1e-4
        for name in OM BM BQ QN ON; do
            near "note of $name: $where" "$(awk -F '\t' -v name="$name = " '$2 == "note" && index($3, name) == 1 {
                split($3, w, " "); print w[3]}' arrows)" "$(number klein_$name)" 1e-4
        done
    done
done

# A file that the deck names is an input, and a link to a file is that file.
sed 's/^pressure *=.*/indicator = file card.txt/' "$engine" >card.deck
printf '0 1e5\n90 20e5\n180 3e5\n' >card.txt
cp card.txt before.txt
for option in --output=card.txt --plot-script=card.txt; do
    run 3 "$option" card.deck
    says 'it is an input'
    same card.txt before.txt
done
: >aim.svg
ln -s aim.svg alias.svg
run 3 --output=aim.svg --plot=alias.svg card.deck
says 'two results would be written to it'
check 'the file is as it was' test ! -s aim.svg

# ------------------------------------------------------------------------------------------- gnuplot

command -v gnuplot >/dev/null || {
    echo 'skipped: gnuplot is not there'
    finish
}

# Every tag is closed by its own, every & is the start of an entity, and there is nothing behind </svg>.
well_formed() {
    awk 'BEGIN {RS = "<"; entity = "&(lt|gt|amp|quot|apos|#[0-9]+|#x[0-9a-fA-F]+);"}
        NR == 1 {if ($0 != "") exit bad = 1; next}
        /^[?!]/ {next}
        {end = index($0, ">"); if (!end) exit bad = 1
            tag = substr($0, 1, end - 1); words = substr($0, end + 1); all = $0
            gsub(entity, "", all); if (all ~ /&/) exit bad = 1
            n = split(tag, part, /[ \t\n\/]+/)
            if (tag ~ /^\//) {if (!depth || stack[depth] != part[2]) exit bad = 1; depth--; last = part[2]}
            else if (tag !~ /\/$/) stack[++depth] = part[1]
            if (!depth && words !~ /^[ \t\r\n]*$/) exit bad = 1
            if (substr(tag, 1, 1) != "/") count++}
        END {exit !(!bad && depth == 0 && last == "svg" && count > 10)}' "$1"
}
svg() { # svg FILE: a whole picture
    check "$1: the head of an SVG file" test "$(head -c 14 "$1")" = '<?xml version='
    check "$1: ends in </svg>" test "$(tail -n 3 "$1" | tr -d '\n')" = '</g></svg>'
    check "$1: well-formed" well_formed "$1"
}
# words FILE: its texts, one a line, without the escapes of XML
words() {
    sed -n 's/.*<text[^>]*>\(.*\)<\/text>.*/\1/p' "$1" |
        sed 's/<[^>]*>//g; s/&lt;/</g; s/&gt;/>/g; s/&quot;/"/g; s/&apos;/'"'"'/g; s/&#160;/ /g; s/&amp;/\&/g'
}
shows() { # shows FILE TEXT...: each is a text of its own in the picture
    file=$1
    words "$file" >"$work/texts"
    shift
    for text in "$@"; do
        check "$file: no text '$text'" grep -qxF -e "$text" "$work/texts"
    done
}
# bytes FILE FROM COUNT: as numbers
bytes() { od -An -v -tu1 -j "$2" -N "$3" "$1" | tr -s ' \n' '  ' | sed 's/^ //; s/ $//'; }
magic() { check "$1: begins with $(bytes "$1" 0 8)" test "$(bytes "$1" 0 "$2")" = "$3"; }
# The number of pictures of a GIF file, after walking over all its blocks to its very end; -1 if it is broken.
frames() {
    od -An -v -tu1 "$1" | awk '{for (i = 1; i <= NF; i++) b[n++] = $i}
        function blocks() {while (i < n && b[i]) i += b[i] + 1; i++}
        END {i = 13; if (b[10] >= 128) i += 3 * 2 ^ (b[10] % 8 + 1)
            while (i < n) {
                if (b[i] == 59) {i++; ended = 1; break}
                else if (b[i] == 33) {if (b[i + 1] == 249) control++; i += 2; blocks()}
                else if (b[i] == 44) {images++; flags = b[i + 9]; i += 10
                    if (flags >= 128) i += 3 * 2 ^ (flags % 8 + 1); i++; blocks()}
                else break}
            print ended && i == n && (control == images || images == 1) ? images + 0 : -1}'
}

# --- each kind, of both mechanisms
version=$("$fourlink" --version | sed -n 's/^fourlink //p')
for deck in "$fourbar" "$engine"; do
    base=$(basename "$deck" .deck)
    run 0 "$deck"
    mv out table
    for kind in $kinds; do
        picture=$base-$kind.svg
        [ $kind = animation ] && picture=$base.gif
        if [ $kind = klein ] && [ $base = coupler-point ]; then
            run 2 --plot=$picture --plot-kind=$kind "$deck"
            says "Klein's construction is for a slider-crank"
            check 'no picture of it' test ! -e $picture
            continue
        fi
        run 0 --plot=$picture --plot-kind=$kind "$deck"
        quiet
        same out table
        check "the rights of $picture" test "$(ls -l $picture | cut -c1-10)" = -rw-r--r--
        [ $kind = animation ] && continue
        svg $picture
        shows $picture "$(sed -n 's/^title *= *//p' "$deck")" "$deck  |  fourlink $version"
    done
done
shows coupler-point-mechanism.svg 'open, theta2 = 60 deg' 'crossed, theta2 = 60 deg' 'x (mm)' 'y (mm)' 'path of C' \
    'path of P' A B C D P F12 F23 F34 F14 push W2 W3 W4 Ts 'push 12 N' 'W3 2.943 N' 'θ₂ = 60°'
shows coupler-point-motion.svg open crossed 'theta2 (deg)' 'theta3 (deg)' 'theta4 (deg)' 'omega3 (rad/s)' \
    'omega4 (rad/s)' 'alpha3 (rad/s2)' 'alpha4 (rad/s2)'
shows coupler-point-forces.svg open crossed F12 F23 F34 F14 Ts 'force (N)' 'Ts (N.m)' 'theta2 (deg)'
shows coupler-point-turning-moment.svg 'theta2 (deg)' 'turning moment -Ts (N.m)' -Ts mean above below
shows coupler-point-polar.svg open crossed 'F12_along (N)' 'F12_across (N)' 'F32_along (N)' 'F23_along (N)' \
    'F43_across (N)' 'F34_along (N)' 'F14_along (N)' 'F14_across (N)' "F14, ground on rocker, in the rocker's axes"
shows coupler-point-vectors.svg 'open, theta2 = 60 deg' 'velocity polygon' 'acceleration polygon' \
    'free body of the crank' 'free body of the coupler' 'free body of the rocker' 'forces on the crank' \
    'forces on the coupler' 'forces on the rocker' vB vC vCB aBn aCBn aCBt aCn aCt '-m aG' 'x (m/s)' 'y (m/s2)' \
    'x (N)' 'x (mm)' push
shows engine-mechanism.svg 'open, theta2 = 60 deg' 'x (mm)' 'path of C' gas N F12 F23 F34 Ts 'gas 20774 N' 'θ₃ = -16.78°'
shows engine-motion.svg open crossed 'x (mm)' 'v (m/s)' 'a (m/s2)' 'theta3 (deg)' 'omega3 (rad/s)' 'alpha3 (rad/s2)'
shows engine-forces.svg F12 F23 F34 N Ts 'force (N)' 'Ts (N.m)'
shows engine-turning-moment.svg 'turning moment -Ts (N.m)' mean
shows engine-polar.svg 'F12_along (N)' 'F43_across (N)' open crossed
shows engine-vectors.svg 'velocity polygon' 'free body of the rod' 'free body of the piston' 'forces on the piston' gas aC
shows engine-klein.svg "Klein's construction, open, theta2 = 60 deg" O B C M Q N K L 'OM = 152.52 mm' 'x (mm)'
check 'the engine has no rocker' none rocker engine-vectors.svg

# --- the other kinds of file
run 0 --plot=x.png "$fourbar"
quiet
magic x.png 8 '137 80 78 71 13 10 26 10'
check "x.png: width and height $(bytes x.png 16 8)" test "$(bytes x.png 16 8)" = '0 0 3 132 0 0 4 48'
check 'x.png: its end' test "$(tail -c 8 x.png | head -c 4)" = IEND
run 0 --plot=x.PDF --branch=open "$fourbar"
quiet
check 'x.PDF: the head' test "$(head -c 5 x.PDF)" = '%PDF-'
check 'x.PDF: the end' test "$(tail -n 1 x.PDF)" = '%%EOF'
magic coupler-point.gif 6 '71 73 70 56 57 97'
magic engine.gif 6 '71 73 70 56 57 97'
check "pictures of the animation: $(frames coupler-point.gif)" test "$(frames coupler-point.gif)" -eq 60
check "pictures of the animation: $(frames engine.gif)" test "$(frames engine.gif)" -eq 60
run 0 --plot=x.gif --plot-kind=motion "$fourbar"
quiet
check "x.gif: $(frames x.gif) pictures" test "$(frames x.gif)" -eq 1
run 0 "$fourbar"
mv out table
run 0 --plot=x.txt "$fourbar"
quiet
same out table
for text in 'Crank-rocker with a coupler point' 'coupler-point.deck' 'open, theta2 = 60 deg' 'path of P' 'F12'; do
    check "x.txt: $text" grep -qF -e "$text" x.txt
done
tr -d '\f' <x.txt >x.lines # gnuplot begins its page with a form feed
check 'x.txt: nothing but text' none '[[:cntrl:]]' x.lines
run 0 --plot=- "$fourbar"
cat table x.txt >expected
same out expected
run 0 -p - --output=o.txt "$fourbar"
same out x.txt
same o.txt table
"$fourlink" --plot=- - <"$fourbar" >out 2>err
check 'a deck from standard input' grep -qF '<stdin>  |  fourlink' out
if [ -c /dev/full ]; then
    ln -s /dev/full full.txt
    run 3 --plot=full.txt "$fourbar"
    says 'No space left on device'
    ln -s /dev/full full.gif
    run 3 --plot=full.gif "$fourbar"
    says 'No space left on device'
    "$fourlink" --plot=- --output=o.txt "$fourbar" >/dev/full 2>err
    check '--plot=- on a full disk' test $? -eq 3
fi

# --- files: a link stays one, rights stay, nothing is left beside
mkdir place
run 0 --plot=place/x.svg "$fourbar"
only_file place x.svg
ln -s place/x.svg to.svg
echo old >place/x.svg
chmod 640 place/x.svg
run 0 --plot=to.svg "$fourbar"
same place/x.svg coupler-point-mechanism.svg
check 'a link stays one' test -h to.svg
check 'rights stay' test "$(ls -l place/x.svg | cut -c1-10)" = -rw-r-----
only_file place x.svg
run 3 --plot=folder.svg "$fourbar"
says 'cannot write folder.svg: Is a directory'
same out table
run 3 --plot=missing/x.svg "$fourbar"
says 'cannot write missing/x.svg: No such file'
same out table
if [ "$(id -u)" -ne 0 ]; then
    chmod 555 place
    run 3 --plot=place/new.svg "$fourbar"
    says 'Permission denied'
    chmod 755 place
    chmod 444 place/x.svg
    run 3 --plot=place/x.svg "$fourbar"
    only_file place x.svg
fi

# -------------------------------------------------------------------------------- curves against the table

# curves SVG: "PANEL<tab>NUMBER<tab>INDEX<tab>X<tab>Y<tab>DX<tab>DY" of each point of each curve, in the
# values of the axes as their numbers tell them; DX and DY are those of a pixel.
curves() {
    awk '
    function tic() {
        if (!x_or_y) return
        if (x_or_y == 1) {if (!nx++) {x1 = at; vx1 = value} x2 = at; vx2 = value}
        else {if (!ny++) {y1 = at; vy1 = value} y2 = at; vy2 = value}
    }
    function finish_curve(  i, from) {
        from = n > 2 && !move[1] && move[2] ? 2 : 0     # the sample in the key
        for (i = from; i < n; i++)
            printf "%s\t%d\t%d\t%.9g\t%.9g\t%.9g\t%.9g\n", panel, number, i - from, vx1 + (px[i] - x1) * sx,
                vy1 + (py[i] - y1) * sy, sx, sy
    }
    /<g id="gnuplot_plot_/ {
        id = $0; sub(/.*<g id="gnuplot_plot_/, "", id); sub(/".*/, "", id)
        number = id + 0; letter = id; gsub(/[0-9]/, "", letter)
        if (letter != panel) {panel = letter; sx = (vx2 - vx1) / (x2 - x1); sy = (vy2 - vy1) / (y2 - y1)}
        n = depth = 0; inside = 1; path = 0
    }
    inside {
        line = $0
        if (line ~ /<path /) {path = 1; sub(/.* d=./, "", line)}
        if (path) {
            if (index(line, "\047")) {path = 0; sub(/\047.*/, "", line)}
            k = split(line, w, " ")
            for (i = 1; i <= k; i++) {
                if (w[i] !~ /^[ML]/) continue
                split(substr(w[i], 2), p, ",")
                m = substr(w[i], 1, 1) == "M"
                if (m && n && p[1] == px[n - 1] && p[2] == py[n - 1]) continue  # a long line goes on
                px[n] = p[1]; py[n] = p[2]; move[n] = m; n++
            }
        }
        line = $0
        depth += gsub(/<g[ >]/, "", line) - gsub(/<\/g>/, "", line)
        if (depth == 0) {finish_curve(); inside = 0; nx = ny = 0}
        next
    }
    /<path .*translate\(/ && !/gridline/ {
        line = $0; sub(/.* d=.M/, "", line); split(line, w, /[ ,L]+/)
        length_of_tic = w[1] - w[3] + w[2] - w[4]
        if (length_of_tic * length_of_tic > 400) next   # the frame, before a label
        x_or_y = w[2] == w[4] ? 2 : w[1] == w[3] ? 1 : 0
        at = x_or_y == 2 ? w[2] : w[1]
        getline
        value = $0; sub(/^[^>]*>/, "", value); sub(/<.*/, "", value); gsub(/ /, "", value)
        if (value ~ /^-?[0-9.]+(e[-+]?[0-9]+)?$/) tic()
    }' "$1"
}
# follows PANEL NUMBER POINTS STEP BRANCH X Y [FACTOR]: each row of csv on a branch is the point STEP further
# on of a curve of so many points in the file curves, to 0.3 pixels; angles by whole turns; at least 7 rows.
follows() {
    awk -F '[,\t]' -v panel="$1" -v number="$2" -v points="$3" -v step="$4" -v branch="$5" -v xname="$6" -v yname="$7" \
        -v factor="${8:-1}" '
        function off(x, y, pixel) {x -= y; if (x < 0) x = -x; if (pixel < 0) pixel = -pixel; return !(x <= 0.3 * pixel)}
        FNR == 1 && NR != 1 {for (i = 1; i <= NF; i++) {sub(/ .*/, "", $i); if ($i == xname) cx = i; if ($i == yname) cy = i}; next}
        NR == FNR {if ($1 == panel && $2 == number) {x[$3] = $4; y[$3] = $5; sx = $6; sy = $7; n++}; next}
        $1 == branch && cx && cy {
            # points that fall into one pixel may be drawn as one
            i = rows++ * step; X = $cx; Y = $cy * factor
            while (n < points && i > 0 && (!(i in x) || off(x[i], X, sx) || off(y[i], Y, sy)) && rows * step - step - i < points - n) i--
            if (yname ~ /^theta/) Y += 360 * int((y[i] - Y) / 360 + (y[i] > Y ? 0.5 : -0.5))
            if (!(i in x) || off(x[i], X, sx) || off(y[i], Y, sy)) bad = 1
            if (rows == 1) first = Y; if (off(Y, first, sy)) moves = 1}
        END {exit !(rows >= 7 && n <= points && n >= points - 2 && !bad && moves)}' curves csv
}
compare() {
    check "$1: curve $2 of panel $3 against $8, $6" follows "$3" "$2" "$4" "$5" "$6" "$7" "$8" "${9:-1}"
}
# equal PANEL: one scale on both axes, up and to the right
equal() {
    check "equal scales of panel $1" awk -F '\t' -v panel="$1" '$1 == panel {r = -$7 / $6; n++; if (r < 0.995 || r > 1.005) bad = 1}
        END {exit !(n && !bad)}' curves
}
csv() { "$fourlink" --format=csv --interval='30 deg' --columns="$1" "$2" >csv; }

csv theta2,theta3,theta4,omega3,omega4,alpha3,alpha4,F12,F23,F34,F14,Ts,F14_along,F14_across,F12_along,F12_across "$fourbar"
curves coupler-point-motion.svg >curves
number=1
for branch in open crossed; do
    compare motion $number a 721 60 $branch theta2 theta3
    compare motion $number b 721 60 $branch theta2 theta4
    compare motion $number c 721 60 $branch theta2 omega3
    compare motion $number d 721 60 $branch theta2 omega4
    compare motion $number e 721 60 $branch theta2 alpha3
    compare motion $number f 721 60 $branch theta2 alpha4
    number=2
done
# the comparison can fail
check 'another column is another curve' not follows d 1 721 60 open theta2 omega3
check 'another branch is another curve' not follows d 1 721 60 crossed theta2 omega4
check 'a little more is too much' not follows d 1 721 60 open theta2 omega4 1.02

curves coupler-point-forces.svg >curves
for branch in open crossed; do
    set -- a b
    [ $branch = open ] || set -- c d
    number=1
    for name in F12 F23 F34 F14; do
        compare forces $number $1 721 60 $branch theta2 $name
        number=$((number + 1))
    done
    compare forces 1 $2 721 60 $branch theta2 Ts
done
curves coupler-point-polar.svg >curves
compare polar 1 a 721 60 open F12_along F12_across
compare polar 1 f 721 60 open F14_along F14_across
compare polar 3 f 721 60 crossed F14_along F14_across
for panel in a b c d e f; do
    equal $panel
done
curves coupler-point-turning-moment.svg >curves
compare turning-moment 3 a 721 60 open theta2 Ts -1
compare turning-moment 3 b 721 60 crossed theta2 Ts -1

{
    cat "$fourbar"
    printf '[point C]\nlink = coupler\nat = 66 mm\n'
} >pins.deck
csv theta2,C.x,C.y,P.x,P.y pins.deck
curves coupler-point-mechanism.svg >curves
compare mechanism 1 a 181 15 open C.x C.y
compare mechanism 2 a 181 15 open P.x P.y
compare mechanism 1 b 181 15 crossed C.x C.y
compare mechanism 2 b 181 15 crossed P.x P.y
equal a
equal b
run 0 --plot=x.svg --plot-at='250 deg' "$fourbar"
shows x.svg 'open, theta2 = 250 deg' 'crossed, theta2 = 250 deg'

csv theta2,x,v,a,omega3,F12,F34,N,Ts "$engine"
curves engine-motion.svg >curves
compare engine 1 b 721 60 open theta2 x
compare engine 1 d 721 60 open theta2 v
compare engine 2 d 721 60 crossed theta2 v
compare engine 1 f 721 60 open theta2 a
compare engine 2 c 721 60 crossed theta2 omega3
curves engine-forces.svg >curves
compare engine 1 a 721 60 open theta2 F12
compare engine 4 a 721 60 open theta2 N
compare engine 1 b 721 60 open theta2 Ts
curves engine-turning-moment.svg >curves
compare engine 3 a 721 60 open theta2 Ts -1

# --- the energies beside the turning moment
# energies SVG BRANCH DECK: their sum over a cycle is 0; the greatest sum on the way is the fluctuation
energies() {
    fluctuation=$("$fourlink" --summary --format=csv "$3" | tr -d "$cr" | awk -F, -v b="$2" '$1 == "energy_fluctuation" && $NF == b {print $2}')
    mean=$("$fourlink" --summary --format=csv "$3" | tr -d "$cr" | awk -F, -v b="$2" '$1 == "mean_torque" && $NF == b {print $2}')
    words "$1" | awk -v branch="$2" -v E="$fluctuation" -v T="$mean" '
        function off(x, y, e) {x -= y; if (x < 0) x = -x; return !(x <= e)}
        /: mean / {
            split($0, w, /: mean | N\.m, fluctuation of energy | J/)
            if (w[1] == branch) {mean = w[2]; given = w[3]}}
        END {exit off(mean, T, 1e-4 * (T < 0 ? -T : T) + 1e-9) || off(given, E, 1e-4 * E)}' || return 1
    "$fourlink" --plot-script=t.gp --plot-kind=turning-moment --branch=$2 "$3" >/dev/null
    awk -v E="$fluctuation" '/^set label .* J. at / {words = $0; sub(/^set label ./, "", words); split(words, w, " ")
            s += w[1]; if (s > high) high = s; if (s < low) low = s; n++}
        END {d = high - low - E; exit !(n >= 2 && s < 0.002 * E && s > -0.002 * E && d < 0.002 * E && d > -0.002 * E)}' t.gp || return 1
    # each number stands in the picture, too
    sed -n 's/^set label .\(.* J\). at .*/\1/p' t.gp >numbers
    words "$1" >texts
    while read -r number; do
        grep -qxF -e "$number" texts || return 1
    done <numbers
}
for branch in open crossed; do
    check "energies of the four-bar, $branch" energies coupler-point-turning-moment.svg $branch "$fourbar"
    check "energies of the engine, $branch" energies engine-turning-moment.svg $branch "$engine"
done
check 'the energies of another branch are others' not energies coupler-point-turning-moment.svg open "$engine"

# ----------------------------------------------------------------------------------------------- scripts

# In a locale without a degree sign gnuplot complains of that before it reads anything.
a_gnuplot() { LC_ALL=C.UTF-8 gnuplot "$@"; }
# draw SCRIPT: run it; what gnuplot says is in the file said, but for the number of pictures of an animation
draw() {
    a_gnuplot - <"$1" >drawn 2>said.all
    drawn=$?
    grep -v '^[0-9]* frames in animation sequence' said.all >said
    check "gnuplot: exit status $drawn of $1" test $drawn -eq 0
    check "gnuplot on $1: $(head -n 2 said)" test ! -s said
}
for deck in "$fourbar" "$engine"; do
    base=$(basename "$deck" .deck)
    run 0 "$deck"
    mv out table
    for kind in $kinds; do
        [ $kind = klein ] && [ $base = coupler-point ] && continue
        picture=$base-$kind.svg
        [ $kind = animation ] && picture=$base.gif
        rm -f x.gp
        run 0 --plot-script=x.gp --plot-kind=$kind "$deck"
        quiet
        same out table
        draw x.gp
        same drawn $picture
        case $kind in animation | forces | polar | vectors) continue ;; esac
        mkdir scripts
        run 0 --plot-script=x.gp --plot=scripts/x.svg --plot-kind=$kind "$deck"
        only_file scripts '' # the script is not run
        draw x.gp
        same scripts/x.svg $picture
        rm -r scripts
    done
done
run 0 --plot=x.png "$fourbar"
mv x.png y.png
run 0 --plot=x.png --plot-script=x.gp "$fourbar"
draw x.gp
same x.png y.png

# ----------------------------------------------------------------------------------- names and titles

# Each name is that of the deck, of the picture, of the script; nothing of it is executed.
mkdir names
for name in 'a b' "it's" "''" 'q"q' 'x$(touch pwned)' '`touch pwned`' '|touch pwned' '|touch pwned;' '| touch pwned #' \
    'x;touch pwned;x' '!touch pwned' '-x' '--' '100%s%d%n' 'a\nb\' '~x' '~' 'x'"'"'; system("touch pwned"); y='"'"'' \
    '<touch pwned' '@x' '#x' '$x' 'θ' 'a&b<c>' "two${newline}system('touch pwned')${newline}!touch pwned${newline}lines"; do
    cp "$alvi" "names/$name.deck"
    cd names || exit 1
    show=$(printf "%s" "$name" | tr '\n' ' ')
    "$fourlink" --plot-kind=vectors --plot="$name.svg" -- "$name.deck" >../out 2>../err
    status=$?
    case $name in
    *"$newline"*) # may be refused
        check "executed: $show" test ! -e pwned
        [ $status -eq 0 ] && svg "$name.svg"
        rm -f "$name.svg"
        "$fourlink" --plot-kind=vectors --plot="$name.svg" --plot-script=x.gp "$alvi" >../out 2>../err &&
            a_gnuplot - <x.gp >../drawn 2>../said
        check "executed by the script: $show" test ! -e pwned
        ;;
    *)
        check "exit status $status: $show" test $status -eq 0
        cd .. && quiet && cd names || exit 1
        check "not the files of $show: $(ls -A)" test "$(ls -A | wc -l)" -eq 2
        svg "./$name.svg"
        shows "./$name.svg" "$name.deck  |  fourlink $version"
        mv "./$name.svg" ../before.svg
        "$fourlink" --plot-kind=vectors --plot="$name.svg" --plot-script="$name.gp" -- "$name.deck" >../out 2>../err
        check "script: exit status $?: $show" test $? -eq 0
        a_gnuplot - <"./$name.gp" >../drawn 2>../said
        check "gnuplot: exit status $?: $show" test $? -eq 0
        check "gnuplot on $show: $(head -n 2 ../said)" test ! -s ../said
        check "executed by the script: $show" test ! -e pwned
        check "the script of $show has written: $(ls -A)" test "$(ls -A | wc -l)" -eq 3
        same "./$name.svg" ../before.svg
        ;;
    esac
    cd .. || exit 1
    check "executed: $show" test -z "$(find . -name 'pwned*')"
    rm -rf names
    mkdir names
done

# titles and names of loads and points as they are
titles='plain title
'"it's"' a "title"
back\slash\n \
_^{}@&~ a_1 b^2
<b>&amp;</b> & <!-- >
100 % %s %d %n
$(touch pwned) `touch pwned`
x; system("touch pwned") y
Zähne, θ₂, 四杆, ½
'"'"' . system("touch pwned") . '"'"'
!touch pwned
{/Symbol q} @x'
printf "%s\n" "$titles" >titles
while IFS= read -r title; do
    sed '/^title/d' "$alvi" >body
    { printf 'title = %s\n' "$title" && cat body; } >t.deck
    run 0 --plot=x.svg --plot-kind=vectors t.deck
    quiet
    svg x.svg
    shows x.svg "$title"
done <titles
check 'executed by a title' test ! -e pwned
for name in "o'clock" 'a"b' '<F&G>' '%s%n' 'a\' '`touch-pwned`' '_^{}@' 'θ'; do
    sed "s/^\[load push\]/[load $(printf '%s' "$name" | sed 's/[\\&]/\\&/g')]/" "$fourbar" >t.deck
    run 0 --plot=x.svg t.deck
    quiet
    svg x.svg
    shows x.svg "$name" "$name 12 N"
done
awk 'BEGIN {for (i = 0; i < 60; i++) s = s "äé"; print "title = " s s s s}' >long.deck
sed '/^title/d' "$fourbar" >>long.deck
run 0 --plot=x.svg long.deck
svg x.svg
sed '/^title/d' "$alvi" >untitled.deck
run 0 --plot=x.svg untitled.deck
shows x.svg 'untitled.deck' "untitled.deck  |  fourlink $version"

# --------------------------------------------------------------------------------------------- odd decks

all='mechanism motion forces turning-moment polar vectors klein'
# odd NAME KINDS ARGUMENT...: each kind draws without a word of gnuplot, or says why not
odd() {
    name=$1
    wanted=$2
    shift 2
    drawn_kinds=
    for kind in $wanted; do
        rm -f x.gp
        "$fourlink" --plot-script=x.gp --plot-kind=$kind "$@" >out 2>err
        case $? in
        0 | 1)
            drawn_kinds="$drawn_kinds $kind"
            check "$name, $kind: messages: $(head -n 2 err)" test ! -s err
            check "$name, $kind: what is no number is in the script" \
                awk '/plot NaN notitle/ {next} tolower($0) ~ /(^|[^a-z])-?(nan|inf)([^a-z]|$)/ {bad = 1} END {exit bad}' x.gp
            a_gnuplot - <x.gp >drawn 2>said.all
            check "$name, $kind: gnuplot: exit status $?" test $? -eq 0
            grep -v '^[0-9]* frames in animation sequence' said.all >said
            check "$name, $kind: gnuplot: $(head -n 2 said)" test ! -s said
            [ $kind = animation ] && continue
            check "$name, $kind: ends in </svg>" test "$(tail -n 3 drawn | tr -d '\n')" = '</g></svg>'
            ;;
        2)
            check "$name, $kind: one message: $(head -n 2 err)" grep -q '^fourlink: --plot-kind: error: ' err
            check "$name, $kind: a script of nothing" test ! -e x.gp
            ;;
        *) check "$name, $kind: another exit status; $(head -n 2 err)" false ;;
        esac
    done
}
draws() { check "$name draws:$drawn_kinds, not: $1" test "$drawn_kinds" = " $1"; }

odd 'a crank that cannot turn fully' "$all" "$data/me3491-exercise-1.deck"
draws 'mechanism motion forces polar vectors'
odd 'parallelogram' "$all" "$fourbar" --set='crank.length=40 mm' --set='coupler.length=80 mm' --set='rocker.length=40 mm'
draws 'mechanism motion forces polar vectors'
odd 'deltoid' 'motion polar vectors' "$fourbar" --set='crank.length=40 mm' --set='ground.length=40 mm' --set='coupler.length=80 mm' \
    --set='rocker.length=80 mm'
draws 'motion polar vectors'
odd 'a crank at rest' "$all" "$fourbar" --set=motion.speed=0
draws 'mechanism motion forces polar vectors'
odd 'no force at all' "$all" "$fourbar" --set=motion.speed=0 --set=gravity.acceleration=0 --set='load push.force=(0, 0) N'
draws 'mechanism motion forces polar vectors'
odd 'one instant' "$all" "$data/me3491-example-1.deck"
draws 'mechanism motion forces turning-moment polar vectors klein'
odd 'a run-up' 'mechanism motion forces polar vectors' "$fourbar" --set=motion.speed=0 \
    --set='motion.acceleration=20 rad/s2' --set='motion.run_up=180 deg'
draws 'mechanism motion forces polar vectors'
odd 'a crank that stops' 'motion forces turning-moment' "$fourbar" --set='motion.acceleration=-100 rad/s2'
draws 'motion forces'
odd 'without masses' "$all" "$alvi"
draws 'mechanism motion vectors'
odd 'an offset engine, crossed' 'mechanism motion polar vectors klein' "$engine" --set='ground.offset=60 mm' --branch=crossed
draws 'mechanism motion polar vectors klein'
cat >narrow.deck <<'DECK' # reached within 0.8 deg of 360 deg, between the samples of a drawing
mechanism = four-bar
[ground]
length = 100 mm
[crank]
length = 50 mm
[coupler]
length = 30 mm
[rocker]
length = 20.003 mm
[motion]
speed = 1 rad/s
from = 0.9 deg
to = 360.9 deg
interval = 0.1 deg
DECK
odd 'a narrow reach' 'mechanism vectors' narrow.deck
draws 'mechanism vectors'
odd 'a rod as long as the crank' 'mechanism motion polar klein' "$engine" --set='rod.length=150 mm'
draws 'mechanism motion polar klein'
sed 's/^stroke = 300 mm/length = 150 mm/' "$engine" >short.deck
odd 'a rod shorter than the crank' 'mechanism motion polar klein' short.deck --set='rod.length=120 mm'
draws 'mechanism motion polar klein'
odd 'an engine at its dead centre' 'vectors klein' "$engine" --plot-at='0 deg'
draws 'vectors klein'
odd 'an engine at mid-stroke' 'vectors klein' "$engine" --plot-at='90 deg'
draws 'vectors klein'
odd 'a four-stroke cycle' 'motion turning-moment' "$engine" --set='motion.cycle=720 deg'
draws 'motion turning-moment'
odd 'inches and radians' 'mechanism turning-moment polar vectors' "$fourbar" --set=units.length=in --set=units.angle=rad
draws 'mechanism turning-moment polar vectors'
run 0 --plot=x.svg --set=units.length=in --set=units.angle=rad --plot-at='1 rad' "$fourbar"
shows x.svg 'x (in)' 'y (in)' 'open, theta2 = 1 rad' 'θ₂ = 1 rad'
run 0 --plot=x.svg --set=units.angle=rad --plot-kind=motion "$fourbar"
shows x.svg 'theta2 (rad)' 'theta4 (rad)'
odd 'out of reach' "$all" "$data/me3491-exercise-1.deck" --set='motion.from=150 deg' --set='motion.to=200 deg'
check "nothing is drawn out of reach:$drawn_kinds" test -z "$drawn_kinds"
odd 'a crank that cannot turn fully' animation "$data/me3491-exercise-1.deck"
draws animation
odd 'one instant' animation "$data/me3491-example-1.deck"
draws animation
run 1 --plot=x.gif --set='crank.length=40 mm' --set='rocker.length=40 mm' --set='coupler.length=80 mm' "$fourbar"
check "pictures of the parallelogram: $(frames x.gif)" test "$(frames x.gif)" -gt 50

# ------------------------------------------------------------------------------- what can be read in them

# texts SVG: "X Y ANCHOR LETTERS WORDS" of each text that is not turned; letters are characters.  One in a
# box is there twice.
texts() {
    LC_ALL=C tr -d '\200-\277' <"$1" | LC_ALL=C awk '
        /<g transform="translate\(/ {at = $0; turned = /rotate/; sub(/.*translate\(/, "", at); split(at, p, /[,)]/)
            anchor = $0; sub(/.*text-anchor="/, "", anchor); sub(/".*/, "", anchor)}
        /<text>/ && !turned {words = $0; sub(/.*<text[^>]*>/, "", words); sub(/<\/text>.*/, "", words)
            gsub(/<[^>]*>/, "", words); gsub(/&[a-z0-9#]*;/, "x", words)
            if (words != "") print p[1], p[2], anchor, length(words), words}'
}
# A letter is at least so many pixels wide and high.
boxes='function box() {w = 6.5 * $4; l = $3 == "start" ? $1 : $3 == "end" ? $1 - w : $1 - w / 2; r = l + w}'
inside() { # inside SVG: no text goes beyond the picture
    width=$(sed -n 's/.*<svg *.*width="\([0-9]*\)".*/\1/p; s/^ *width="\([0-9]*\)".*/\1/p' "$1" | head -n 1)
    texts "$1" | LC_ALL=C awk -v width="$width" "$boxes"'
        {box(); if (l < 0 || r > width) {print; bad = 1}; n++} END {exit !(n > 5 && width > 100 && !bad)}' >outside
}
apart() { # apart SVG: no text stands on another
    texts "$1" | LC_ALL=C awk "$boxes"'
        {box(); for (i = 1; i <= n; i++) if (W[i] != $0 && l < R[i] && L[i] < r && $2 - Y[i] < 9 && Y[i] - $2 < 9) {
            print W[i] " / " $0; bad = 1}
         n++; L[n] = l; R[n] = r; Y[n] = $2; W[n] = $0}
        END {exit !(n > 5 && !bad)}' >outside
}
readable() {
    check "$1: texts beyond its edge: $(inside "$1"; head -n 3 outside)" inside "$1"
    check "$1: texts on each other: $(apart "$1"; head -n 3 outside)" apart "$1"
}
sed 's/translate(/translate(9/' engine-vectors.svg >wrong.svg
check 'texts beyond the edge are seen' not inside wrong.svg
sed 's/translate([0-9.]*,[0-9.]*)/translate(100,100)/' engine-vectors.svg >wrong.svg
check 'texts on each other are seen' not apart wrong.svg
for kind in motion forces turning-moment vectors mechanism; do
    readable coupler-point-$kind.svg
    readable engine-$kind.svg
done
inside coupler-point-polar.svg
check "polar: texts beyond its edge: $(head -n 3 outside)" inside coupler-point-polar.svg
for angle in 0 45 90 135 225 300; do
    for branch in open crossed; do
        run 0 --plot=x.svg --plot-kind=klein --plot-at="$angle deg" --branch=$branch "$engine"
        readable x.svg
        shows x.svg O B C M Q N 'v and a count away from' 'the inner dead centre'
        run 0 --plot=x.svg --plot-kind=vectors --plot-at="$angle deg" --branch=$branch "$engine"
        readable x.svg
        run 0 --plot=x.svg --plot-kind=vectors --plot-at="$angle deg" --branch=$branch "$fourbar"
        readable x.svg
    done
done
# lengths of millionths of a millimetre, and a motion that is clockwise
set -- --set='ground.length=80e-9 mm' --set='crank.length=20e-9 mm' --set='coupler.length=66e-9 mm' --set='rocker.length=56e-9 mm' \
    --set='motion.speed=-1000 rad/s'
for kind in vectors motion mechanism; do
    run 0 --plot=x.svg --plot-kind=$kind --branch=open "$@" "$alvi"
    readable x.svg
done

# so many loads that their values need a higher picture
awk '1; END {for (i = 0; i < 36; i++) printf "[load L%d]\nlink = coupler\nat = %d mm\nforce = %d N at %d deg\n", i, i, 5 + i, 10 * i}' \
    "$fourbar" >many.deck
run 0 --plot=x.svg --branch=open many.deck
height=$(sed -n 's/.*<svg *.*height="\([0-9]*\)".*/\1/p; s/^ *width="[0-9]*" height="\([0-9]*\)".*/\1/p' x.svg | head -n 1)
check "values of many loads are in the picture of height $height" \
    test "$(texts x.svg | awk -v h="$height" '$5 ~ /^L[0-9]+$/ && $7 == "N" && $2 < h {n++} END {print n}')" -eq 36
inside x.svg
check "many loads: $(head -n 3 outside)" inside x.svg

# a title that is too long ends in an ellipsis
run 0 --plot=x.svg long.deck
check "a long title: $(inside x.svg; head -n 1 outside)" inside x.svg
check 'a long title is shortened' grep -qF '…</text>' x.svg

# --- in a terminal: 79 columns, no grid over the curves, names of all axes
for deck in "$fourbar" "$engine"; do
    for kind in mechanism motion forces turning-moment polar vectors; do
        run 0 --plot=x.txt --plot-kind=$kind "$deck"
        quiet
        LC_ALL=C tr -d '\200-\277\f' <x.txt >x.letters
        check "$kind in a terminal: $(awk '{if (length($0) > n) n = length($0)} END {print n}' x.letters) columns" \
            awk 'length($0) > 79 {bad = 1} length($0) > 60 {n++} END {exit !(n > 10 && !bad)}' x.letters
        mv x.txt $kind-$(basename "$deck" .deck).txt
    done
done
for name in 'theta3 (deg)' 'theta4 (deg)' 'omega4 (rad/s)' 'alpha4 (rad/s2)' 'theta2 (deg)' 'open ***' 'crossed ###'; do
    check "a terminal's motion: $name" grep -qF -e "$name" motion-coupler-point.txt
done
for name in 'velocity polygon, y (m/s)' 'acceleration polygon, y (m/s2)' 'free body of the rod, y (mm)' 'forces on the piston, y (N)'; do
    check "a terminal's vectors: $name" grep -qF -e "$name" vectors-engine.txt
done
check 'moment and mean are told apart' grep -q -e '-Ts \*\**mean ##*' turning-moment-engine.txt
for kind in motion forces turning-moment polar; do
    run 0 --plot-script=x.gp --plot=x.txt --plot-kind=$kind "$fourbar"
    check "$kind: a grid in a terminal" none '^set grid' x.gp
    run 0 --plot-script=x.gp --plot=x.svg --plot-kind=$kind "$fourbar"
    check "$kind: no grid in a picture" grep -q '^set grid' x.gp
done

# --- an animation has one scale
for deck in "$fourbar" "$engine" "$data/me3491-example-1.deck"; do
    run 0 --plot-script=x.gp --plot-kind=animation "$deck"
    for axis in x y; do
        check "$deck: frames" test "$(grep -c "^set ${axis}range" x.gp)" -eq 60
        check "$deck: ranges of its frames" test "$(grep "^set ${axis}range" x.gp | sort -u | wc -l)" -eq 1
    done
    check "$deck: the letters of its frames move" test "$(grep '^set label "B"' x.gp | sort -u | wc -l)" -gt 10
done

# --- an instant: its speed and acceleration in all positions of a cycle
instant="--set=motion.at=40deg --set=motion.speed=-30rad/s"
for acceleration in 0 50; do
    run 0 --plot=x.svg --plot-script=x.gp --plot-kind=motion --branch=open $instant --set="motion.acceleration=$acceleration rad/s2" "$fourbar"
    check 'a clockwise cycle' grep -q '^set xrange \[0:-360\]$' x.gp
    "$fourlink" --format=csv --branch=open $instant --set="motion.acceleration=$acceleration rad/s2" --set='motion.at=-40 deg' \
        --columns=omega4,alpha4 "$fourbar" >csv
    for name in omega4 alpha4; do
        near "$name of a held instant" "$(awk -v name=$name 'index($0, "$" name "_open ") == 1 {on = 1} /^EOD/ {on = 0}
            on && $1 == -40 {print $2}' x.gp)" "$(number $name)" 1e-6
    done
    [ $acceleration = 0 ] && held=', speed held' || held=', speed and acceleration held'
    check "told: $held" grep -qF "$held  |  fourlink" x.gp
done
run 0 --plot-script=x.gp --plot-kind=motion "$fourbar"
check 'a range is not held' none 'held' x.gp

# --- near a dead position
for kind in forces motion polar; do
    run 0 --plot-script=x.gp --plot-kind=$kind "$data/me3491-exercise-1.deck"
    check "$kind: a peak beyond the frame" awk '/range \[/ && !/xrange \[110/ {n++; r = $3; gsub(/[][]/, "", r); split(r, p, ":")
        if (!(p[2] > p[1] + 0) || p[2] - p[1] > 3000) bad = 1} END {exit !(n >= 4 && !bad)}' x.gp
    [ $kind = polar ] || check "$kind: it is told" grep -q "'beyond the frame near a dead position'" x.gp
    run 0 --plot-script=x.gp --plot-kind=$kind "$fourbar"
    check "$kind: nothing is beyond the frame" none 'beyond the frame' x.gp
done

# --- numbers of extremes: a maximum's above it, a minimum's below; the areas' have the digits of the title
run 0 --plot-script=x.gp --plot-kind=motion "$fourbar"
check 'extremes' awk '/^set label .* pt 7/ {split($NF, o, ","); above += o[2] > 0; below += o[2] < 0; if ($3 ~ /^"-0"$/) bad = 1}
    END {exit !(above >= 6 && below >= 6 && !bad)}' x.gp

# --- the piston's box, and the body out to a centre of mass that is off the line
run 0 --plot-script=v.gp --plot-kind=vectors "$engine"
arrows v.gp nohead >arrows
check 'the box of the piston' test "$(grep -c '^free body of the piston	4	' arrows)" -eq 4
check 'a straight rod' none '^free body of the rod	9	' arrows
run 0 --plot-script=v.gp --plot-kind=vectors --set='rod.cg=(100, 40) mm' "$engine"
arrows v.gp nohead >arrows
check 'a rod with its centre of mass off its line' test "$(grep -c '^free body of the rod	9	' arrows)" -eq 2

# --- a line of stroke that is not level
run 0 --plot=x.svg "$data/dfa-example-2-vertical.deck"
shows x.svg 'x rises at 90 deg'
check 'a level line of stroke' none 'x rises' engine-mechanism.svg

# --- several positions: the forces are on the first, which is thick
run 0 --plot-script=x.gp --branch=open --plot-at='40 deg, 100 deg, 200 deg' "$fourbar"
check 'one crank is thick' test "$(grep -c ' nohead ls 2$' x.gp)" -eq 1
check 'the others are thin' test "$(grep -c ' nohead ls 11$' x.gp)" -eq 6
check 'their angles' grep -q '^set label "200°" at' x.gp

finish
