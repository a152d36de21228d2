# SPDX-License-Identifier: GPL-3.0-or-later
#
# pictures.sh - what the tests of pictures share besides harness.sh: reading pictures and their listings.
. "$(dirname "$0")/../harness.sh"
fourbar=$decks/coupler-point.deck
engine=$decks/engine.deck
set +u # a number that is missing is a failed check
kinds='mechanism motion forces turning-moment polar vectors limits klein animation'
version=$("$fourlink" --version | sed -n 's/^fourlink //p')
not() { ! "$@"; }

# ------------------------------------------------------------------------- items of a picture

# arrows LISTING [line]: "PANEL<tab>LOOK<tab>X1 Y1 X2 Y2" of each arrow, or line, and
# "PANEL<tab>note<tab>NAME VALUE"
arrows() {
    awk -v what="${2:-arrow}" '
        /^panel/ {n = 0}
        $1 == what {line[++n] = $2 "\t" $3 " " $4 " " $5 " " $6}
        sub(/^note /, "note\t") {line[++n] = $0}
        sub(/^name /, "") {for (i = 1; i <= n; i++) print $0 "\t" line[i]}' "$1"
}
# size X Y: of a vector
size() { awk -v x="$1" -v y="$2" 'BEGIN {printf "%.9g\n", sqrt(x * x + y * y)}'; }
# number COLUMN: of the one row in csv
number() {
    awk -F, -v name="$1" 'NR == 1 {for (i = 1; i <= NF; i++) {sub(/ .*/, "", $i); if ($i == name) c = i}}
        NR == 2 {print c ? $c : "none"}' csv
}
near() { # near WHAT X Y TOLERANCE, relative to Y
    check "$1: $2, expected $3" awk -v x="$2" -v y="$3" -v e="$4" 'BEGIN {
        d = x - y; s = y < 0 ? -y : y; exit !(x != "" && y != "none" && d <= e * s + 1e-9 && -d <= e * s + 1e-9)}'
}

# --------------------------------------------------------------------------------------- pictures

# pictures_of DECK KIND...: such pictures, under the names that test_kinds.sh gives them
pictures_of() {
    deck=$1
    shift
    for kind in "$@"; do
        picture=$(basename "$deck" .deck)-$kind.svg
        "$fourlink" --plot=$picture --plot-kind=$kind "$deck" >out 2>err
    done
}
# long_title: the four-bar with a title of 480 letters
long_title() {
    awk 'BEGIN {for (i = 0; i < 60; i++) s = s "äé"; print "title = " s s s s}'
    sed '/^title/d' "$fourbar"
}
svg() { # svg FILE: a whole picture
    check "$1: the head of an SVG file" test "$(head -c 5 "$1")" = '<svg '
    check "$1: ends in </svg>" test "$(tail -n 1 "$1")" = '</svg>'
    check "$1: well-formed" "$programs/well_formed" "$1"
}
# words FILE: its texts, one a line, without the escapes of XML
words() {
    sed -n -e 's/.*<text[^>]*>\(.*\)<\/text>.*/\1/' -e 't text' -e d -e ': text' \
        -e 's/<[^>]*>//g; s/&lt;/</g; s/&gt;/>/g; s/&quot;/"/g; s/&#39;/'"'"'/g; s/&apos;/'"'"'/g; s/&#160;/ /g; s/&amp;/\&/g; s/−/-/g; p' "$1"
}
shows() { # shows FILE TEXT...: each is a text of its own in the picture
    file=$1
    words "$file" >"$work/texts"
    shift
    printf '%s\n' "$@" >"$work/wanted"
    missing=$(grep -vxFf "$work/texts" "$work/wanted")
    check "$file: no text '$missing'" test -z "$missing"
    passed=$((passed + $# - 1))
}
# bytes FILE FROM COUNT: as numbers
bytes() { od -An -v -tu1 -j "$2" -N "$3" "$1" | tr -s ' \n' '  ' | sed 's/^ //; s/ $//'; }
magic() { check "$1: begins with $(bytes "$1" 0 8)" test "$(bytes "$1" 0 "$2")" = "$3"; }
