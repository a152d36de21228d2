#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_report_pictures.sh FOURLINK DATA - reports with their pictures.
. "$(dirname "$0")/../harness.sh"
engine=$decks/engine.deck

# the same on every run, whatever the locale; no date and no folder of this machine
run 0 --report=r.html "$engine"
quiet
nothing
mv r.html first.html
LC_ALL=de_DE.UTF-8 TZ=Asia/Tokyo "$fourlink" --report=x.html "$engine"
same x.html first.html
check 'a folder of temporary files' none -F "$work" first.html

# pictures of all kinds of mechanisms, in a page that is sound
for deck in "$engine" "$decks/coupler-point.deck" "$data/khurmi-5.2.deck" "$data/gerstmayr-run-up.deck"; do
    run 0 --report=r.html "$deck"
    "$programs/check_page" r.html "$deck" >wrong 2>&1
    check "$(tail -n 5 wrong)" test ! -s wrong
    check "pictures of $deck" grep -q '<svg[^>]* class="fourlink"' r.html
done

finish
