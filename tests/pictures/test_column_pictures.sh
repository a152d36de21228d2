#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_column_pictures.sh FOURLINK DATA - pictures of columns: title and description, whatever the deck and its title
# are called; formats.
. "$(dirname "$0")/pictures.sh"
needs rsvg-convert librsvg2-bin
run 0 --plot=x.svg --plot-kind=columns -c theta4,P.x "$fourbar"
quiet
svg x.svg
shows x.svg 'θ₄ (°)' 'P.x (mm)' open crossed
# described TITLE DESCRIPTION: those of x.svg
described() {
    check "title of x.svg: $(grep '^<title>' x.svg)" grep -qxF -e "<title>$1</title>" x.svg
    check "description of x.svg: $(grep '^<desc>' x.svg)" grep -qxF -e "<desc>$2</desc>" x.svg
    check 'one description' test "$(grep -c '<desc>' x.svg)" -eq 1
}
cp "$fourbar" four.deck
run 0 --plot=x.svg --plot-kind=columns -c theta4,P.x --plot-x=time four.deck
described 'Crank-rocker with a coupler point' 'four.deck, open and crossed branches: theta4, P.x over time'
run 0 --plot=x.svg --plot-kind=vectors four.deck
described 'Crank-rocker with a coupler point' 'four.deck, open branch: polygons of velocity, acceleration and forces, at θ₂ = 60°'
run 0 --plot=x.svg -b crossed four.deck
described 'Crank-rocker with a coupler point' 'four.deck, crossed branch: mechanism with its loads and pin forces, at θ₂ = 60°'
sed '/^title/d' four.deck >'a&b<c>]]>"d.deck'
run 0 --plot=x.svg --plot-kind=motion 'a&b<c>]]>"d.deck'
described 'a&amp;b&lt;c&gt;]]&gt;&quot;d.deck' \
    'a&amp;b&lt;c&gt;]]&gt;&quot;d.deck, open and crossed branches: positions, velocities and accelerations over the crank angle'
svg x.svg
check ']]> of a text' none ']]>' x.svg
# a control character in a file name, bytes that are not UTF-8 in a title
{
    printf 'title = a\377b \357\277\277 ]]> c\n'
    cat 'a&b<c>]]>"d.deck'
} >"$(printf 'x\001y.deck')"
run 0 --plot=x.svg --plot-kind=motion "$(printf 'x\001y.deck')"
svg x.svg
check 'no control character' awk '/[\001-\010\013\014\016-\037]/ {bad = 1} END {exit bad}' x.svg
check 'UTF-8' iconv -f UTF-8 -t UTF-16 -o /dev/null x.svg
for ending in png pdf txt; do
    run 0 --plot=x.$ending --plot-kind=columns -c theta4 "$fourbar"
    quiet
    check "x.$ending" test -s x.$ending
    check "no title in x.$ending" none -a '<title>' x.$ending
done

finish
