#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_any_decks.sh FOURLINK DATA [N] - N (20) random decks with keys of every section, each with options (random_schema.h):
# every run ends by itself in five minutes, with a result or a message, and a refusal prints nothing else.  The generator knows each
# option of the command.
. "$(dirname "$0")/../harness.sh"
n=${3-20}

"$programs/random_decks" options | tr -d '\r' | sort >known # Windows ends lines with CR too
"$fourlink" --help | grep -o ' --[a-z-]*[= ]' | tr -d ' =' | grep -vx -e '--help' -e '--version' | sort -u >options
check_file options 'random_schema.h does not know all options, or more' cmp -s known options

"$programs/random_decks" any "$n" . >evenness
check 'a pair of an option and a section was never tried' test "$n" -lt 1000 -o "$(grep -c ' 0 never$' evenness)" -eq 1

refused=0 failed_runs=0
for deck in any-*.deck; do
    mkdir -p run/answers run/feedback && cp "$deck" card.csv run && cd run || exit 1
    printf '[expect]\nat = 30 deg\nomega2 = 3 rad/s\n' | tee answers.expect >answers/ada.expect
    { cat "$deck"; printf '[expect]\nat = 30 deg\nomega2 = 3 rad/s\n'; } >asks.deck
    printf 'Ada\nBo\n' >names.txt
    set --
    while IFS= read -r option; do set -- "$@" "$option"; done <"../${deck%.deck}.options"
    timeout 300 "$fourlink" "$@" "$deck" >../out 2>../err </dev/null
    status=$?
    cd .. && rm -rf run
    check "status $status: fourlink $* $deck" test $status -le 3
    if [ $status -ge 2 ]; then
        check "no message, status $status: fourlink $* $deck" test -s err
        refused=$((refused + 1))
    fi
done
echo "$n decks, $refused refused"
tail -n 2 evenness
finish
