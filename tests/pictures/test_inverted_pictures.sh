#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_inverted_pictures.sh FOURLINK DATA - pictures of an oscillating cylinder.
. "$(dirname "$0")/pictures.sh"
cp "$data/oscillating-cylinder.deck" cylinder.deck
for kind in mechanism motion vectors; do
    run 0 -b open --plot-kind=$kind --plot=picture.svg cylinder.deck
    check "a picture, $kind" [ -s picture.svg ]
done
run 0 -b open --plot-kind=vectors --plot-at='35 deg' --plot=vectors.svg cylinder.deck
shows vectors.svg aCor # the term of Coriolis is drawn

finish
