#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_page_report.sh FOURLINK DATA SCENES - the report that the page saves is the command's, but for the csv of its
# tables, which the page saves itself.
. "$(dirname "$0")/../harness.sh"

# body REPORT: from its body to its script, without that csv
body() { sed -n '/<body/,/<script>/p' "$1" | sed '/<button .*data-save=/d; /<pre id="csv-rows"/,/<\/pre>/d'; }
for deck in "$data/me3491-exercise-4.deck" "$decks/engine.deck" "$data/gerstmayr-run-up.deck"; do
    run 0 --report=command.html "$deck"
    "$3" "$deck" report >page.html
    check "a report of the page: $?" test -s page.html
    body command.html >command
    body page.html >page
    check "figures of $deck: $(grep -c '<svg' page)" test "$(grep -c '<svg' page)" -ge 4
    same page command
done

finish
