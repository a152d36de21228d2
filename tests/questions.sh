# SPDX-License-Identifier: GPL-3.0-or-later
#
# questions.sh - questions about JSON for one jq, whose start takes longer than its work; sourced after harness.sh.
asked=0 comma=

# about FILE: what the next questions are about, a list of the objects in it
about() {
    asked=$((asked + 1))
    cp "$1" asked.$asked
}
# question WORDS PROGRAM: the program is true of that list
question() {
    printf '%s([$list%d | %s] | last)\n' "$comma" $asked "$2" >>program
    printf '%s\n' "$1" | paste -sd' ' - >>questions
    comma=,
}
# answer: ask them all
answer() {
    set --
    while [ $asked -gt 0 ]; do
        set -- --slurpfile list$asked asked.$asked "$@"
        asked=$((asked - 1))
    done
    jq -cn "$@" -f program >truths 2>&1
    while read -r words; do
        read -r truth <&3 || truth='no answer'
        check "$words: $truth" test "$truth" = true
    done <questions 3<truths
}
