#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_wide_text.sh FOURLINK DATA - decks, cards and answers in UTF-16, as Notepad and PowerShell save them.
. "$(dirname "$0")/../harness.sh"

# wide CODE FILE: the file in UTF-16LE or UTF-16BE, with its mark and CR LF
wide() {
    case $1 in UTF-16LE) printf '\377\376' ;; *) printf '\376\377' ;; esac
    sed "s/\$/$cr/" "$2" | iconv -f UTF-8 -t "$1"
}

cat >card.csv <<'EOD'
Angle [deg];Pressure [bar]
0;1
20,5;32,5
180;4
EOD
cat >answers <<'EOD'
[expect]
stroke = 100 mm
at = 90°
x = 56.35 mm
EOD
cat >x.deck <<'EOD'
title = Kurbel ä−ö
mechanism = slider-crank
[crank]
length = 50 mm
[rod]
length = 200 mm
[gas]
bore = 80 mm
indicator = file card.csv
[motion]
speed = 10 rad/s
interval = 90°
EOD
run 0 x.deck
cp out plain
run 0 --check=answers x.deck
cp out checked
run 0 --print-deck --set='rod.length=210 mm' x.deck
cp out changed
cp x.deck x8
cp card.csv card8
cp answers answers8
for code in UTF-16LE UTF-16BE; do
    wide $code x8 >x.deck
    wide $code card8 >card.csv
    wide $code answers8 >answers
    run 0 x.deck
    quiet
    same out plain
    run 0 --check=answers x.deck
    same out checked
    # with the mark, in UTF-8
    run 0 --print-deck --set='rod.length=210 mm' x.deck
    { printf '\357\273\277' && sed "s/\$/$cr/" changed; } >expected
    same out expected
    run 0 --report=x.html x.deck
    check 'the text of the deck' grep -q '>title = Kurbel ä−ö</span>' x.html
    check 'its lines' grep -q '"line-12">interval = 90°</span>' x.html
    # the place of a mistake: in a deck, a card, answers
    sed 's/^bore/boer/' x8 >bad8
    wide $code bad8 >bad.deck
    run 2 bad.deck
    says "bad.deck:8: error: unknown key 'boer' in [gas]; did you mean 'bore'?"
    run 2 --report=x.html bad.deck
    check 'the mistake in the text' grep -q '<mark class="text-line" id="line-8">boer' x.html
    sed 's/^180;4/180;x/' card8 >bad8
    wide $code bad8 >card.csv
    run 2 x.deck
    says 'card.csv:4: error:'
    wide $code card8 >card.csv
    echo 'xyzzy = 1' >>answers8
    wide $code answers8 >answers
    run 2 --check=answers x.deck
    says "answers:5: error: 'xyzzy' is neither a column nor a fact of this deck"
    sed '$d' answers8 >a && mv a answers8
done

# without the mark
iconv -f UTF-8 -t UTF-16LE x8 >x.deck
run 2 x.deck
nothing
says 'x.deck:1: error: UTF-16 without its mark, or no text: save the file as UTF-8'

finish
