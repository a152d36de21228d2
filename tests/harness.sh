# SPDX-License-Identifier: GPL-3.0-or-later
#
# harness.sh - what the tests of the command share: sourced with FOURLINK and DATA as arguments, it goes to
# a folder of its own; a test ends with `finish`.
set -u

fourlink=$1
data=$2
case $fourlink in /*) ;; *) fourlink=$PWD/$fourlink ;; esac
programs=${fourlink%/*} # of the tests, which are built beside it
data=$(cd "$data" && pwd)
alvi=$data/alvi-5.1.deck
matrix=$data/me3491-matrix.deck
decks=$(cd "$(dirname "$0")/../decks" && pwd)
pictures=$decks/../pictures
. "$decks/../needs.sh"
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work" 2>/dev/null || { chmod -R u+w "$work" && rm -rf "$work"; }' EXIT
trap 'exit 1' HUP INT TERM
cd "$work" || exit 1
umask 022
passed=0
failed=0
cr=$(printf '\r')
tab=$(printf '\t')

# check WHAT COMMAND...: the command succeeds.
check() {
    what=$1
    shift
    if "$@"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $what" | cut -c1-300
        echo "        $*" | cut -c1-300
        [ -z "${STOP_AT_FAILURE-}" ] || finish
        return 1
    fi
}
# check_file FILE WHAT COMMAND...: the same; where it fails, the first lines of the file are shown.
check_file() {
    with=$1
    shift
    check "$@" || head -n 3 "$with" | cut -c1-300
}

# run STATUS ARGUMENT...: the program ends with this status; its output is in the files out and err.
run() {
    expected=$1
    shift
    "$fourlink" "$@" >out 2>err </dev/null
    status=$?
    check "exit status $status, expected $expected: fourlink $*" test $status -eq "$expected"
}

# says TEXT: the messages have it.  prints TEXT: the results have it.
says() { check_file err "no message '$1'" has_message "$1"; }
has_message() { # in the shell, as the start of grep takes longer
    while IFS= read -r said || [ -n "$said" ]; do
        case $said in *"$1"*) return 0 ;; esac
    done <err
    return 1
}
prints() { check_file out "no '$1' in the output of the last run" grep -qF -e "$1" out; }
quiet() { check_file err 'messages' test ! -s err; }
nothing() { check_file out 'output where none was expected' test ! -s out; }
same() { check "$1 and $2 differ" cmp -s "$1" "$2"; }
differ() { check "$1 and $2 are the same" different "$1" "$2"; }
different() { ! cmp -s "$1" "$2"; }
# usage MESSAGE ARGUMENT...: refused with that message, which leads to the help.
usage() {
    message=$1
    shift
    run 2 "$@"
    nothing
    says "$message"
    says '--help'
}
lines() { check "$1: not $2 lines" test "$(wc -l <"$1")" -eq "$2"; }
holds() { check "$1" awk "$2" out; } # an awk program that exits 0
none() { ! grep -q "$@"; }
only_file() { check "files left: $(ls -A "$1")" test "$(ls -A "$1")" = "$2"; }

# Prints "N passed, M failed", and ends.
finish() {
    echo "$passed passed, $failed failed"
    [ "$failed" -eq 0 ]
    exit
}

# listed STATUS LISTING ARGUMENT...: a picture with these options; LISTING has its items, by items.awk
listed() {
    listed_status=$1 listing=$2
    shift 2
    rm -f listed.svg "$listing"
    run "$listed_status" --plot=listed.svg "$@"
    [ ! -s listed.svg ] || LC_ALL=C awk -v even=1 -f "$pictures/svg.awk" -f "$pictures/items.awk" listed.svg >"$listing"
}
# curve_of NAME LISTING: the places of a curve, X Y a line, with blank lines in its gaps
curve_of() { awk -v name="$1" '$1 == "curve" {on = $2 == name; next} $0 == "end" {on = 0} on' "$2"; }
# places_of WORDS LISTING: X Y of each text with these words
places_of() {
    awk -v words="$1" '$1 == "text" {at = $4 " " $5; sub(/^[^ ]* [^ ]* [^ ]* [^ ]* [^ ]* /, ""); if ($0 == words) print at}' "$2"
}
