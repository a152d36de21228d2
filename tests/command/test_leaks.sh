#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_leaks.sh FOURLINK DATA LIVE_BLOCKS - the program frees all memory that it asked for, whatever it was asked to do; live_blocks.c
# counts.  test_valgrind and the sanitizers try more, at night.
. "$(dirname "$0")/../harness.sh"
live_blocks=$3

# freed ARGUMENT...
freed() {
    rm -f leaks
    LEAKS=$work/leaks LD_PRELOAD=$live_blocks "$fourlink" "$@" >out 2>err </dev/null
    check "blocks that are not freed: $(cat leaks): fourlink $*" test "$(cat leaks)" = 0
}

# a program that does not free three blocks is found; a static one cannot be watched
LEAKS=$work/leaks LD_PRELOAD=$live_blocks "$programs/leaking"
[ -s leaks ] || { echo 'skipped: nothing can be loaded before this C library' && exit 77; }
check 'three blocks are found' test "$(cat leaks)" = 3

printf 'Ada\nBo\n' >names.txt
mkdir answers told
printf '[expect]\nmu_min = 30 deg\nswimg = 3\n' | tee answers/ada.expect >answers/bo.expect
for deck in "$decks/coupler-point.deck" "$decks/engine.deck" "$decks/rubbing-lever.deck" "$pictures/varied/leaning-yoke.deck" \
    "$pictures/varied/slanted-linkage.deck"; do
    freed "$deck"
    freed --summary "$deck"
    freed --list "$deck"
    freed --format=json --output=rows.json "$deck"
    freed --report=r.html "$deck"
    freed --plot=x.txt "$deck"
    freed --print-deck --set='crank.length=21 mm' "$deck"
    freed --answers=answers --feedback=told/ "$deck"
done
for kind in mechanism motion forces turning-moment polar vectors limits klein columns animation; do
    freed --plot=x.svg --plot-kind=$kind "$decks/engine.deck"
    freed --plot=x.svg --plot-kind=$kind --columns=F12,Ts "$pictures/varied/slanted-linkage.deck"
done
freed --check "$data/me3491-matrix.deck" "$alvi"
freed --synthesis --report=r.html "$data/synthesis/three-positions.deck"
freed --synthesis --plot=x.svg --plot-kind=error "$data/synthesis/log10.deck"
freed --synthesis "$data/synthesis/best-return.deck"
{ cat "$alvi" && printf '[sweep]\ncrank.length = 18 mm to 22 mm in 3\noutput = swing, max(omega4)\n'; } >sweep.deck
freed sweep.deck
freed --plot=x.svg sweep.deck
freed --design=2 --format=csv sweep.deck
freed --best='max swing' sweep.deck
freed --best='max swing' --format=csv sweep.deck
freed --best='max swing' --format=jsonl sweep.deck "$alvi"
freed --solve='coupler.length = 50 mm .. 80 mm where swing = 40 deg' --format=csv "$alvi" sweep.deck "$data/khurmi-5.1.deck"
freed --format=jsonl --check "$alvi"
freed --solve='coupler.length = 50 mm .. 80 mm' --at='swing = 40 deg' "$alvi"
freed --names=names.txt --design=all --output=told/ sweep.deck
freed "$data/gerstmayr-run-up.deck"
freed --plot=x.svg --plot-kind=speed "$data/gerstmayr-run-up.deck"
# refused
freed "$decks/bad.deck"
freed "$decks/mistakes.deck"
freed --at='theta3 = 40' --columns=none "$alvi"
freed none.deck
freed --plot=/none/x.svg "$alvi"
freed --help
freed --catalogue
finish
