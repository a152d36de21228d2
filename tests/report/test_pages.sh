#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_pages.sh FOURLINK DATA - pages of reports are sound: XML, with the deck as it is and the rows of the csv, by check_page.c.
. "$(dirname "$0")/../harness.sh"
fourbar=$decks/coupler-point.deck

# page_is_sound [DECK [CSV]]: the report r.html is, and has that deck and those rows
page_is_sound() {
    "$programs/check_page" r.html "$@" >wrong 2>&1
    check "${1-no deck}: $(tail -n 5 wrong)" test ! -s wrong
}
# sound STATUS DECK [OPTION...]: the report of a deck
sound() {
    status=$1
    deck=$2
    shift 2
    run "$status" --report=r.html "$@" "$deck"
    page_is_sound "$deck"
}
sound 0 "$fourbar"
run 0 --report=r.html --format=csv "$fourbar"
page_is_sound "$fourbar" out
sound 0 "$fourbar" -b open --set='motion.speed=7 rad/s'
sound 0 "$decks/engine.deck"
sound 0 "$decks/expectations.deck"
sound 2 "$decks/mistakes.deck"
sound 1 "$decks/reach.deck"
run 1 --report=r.html "$data/me3491-exercise-1.deck" --set='motion.from=150 deg' --set='motion.to=200 deg'
page_is_sound # without a position
# titles and names do no harm; what is not UTF-8
sed "s|^title.*|title = </title><script>alert('1')</script> \"q\" \&amp; <!-- ]]> \\\\ %s|" "$fourbar" >"a'b\"<&>]]>.deck"
sound 0 "a'b\"<&>]]>.deck"
printf 'title = caf\351 \302\205 \357\277\277 \360\237\230\200\r\n' >odd.deck
sed '/^title/d; s/$/\r/' "$fourbar" >>odd.deck
sound 0 odd.deck
finish
