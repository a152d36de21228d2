#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# random_trial.sh RANDOM_DECKS SORT N COMMAND... - runs COMMAND on the decks of data/, of tests/decks and N random ones, whose
# names are put behind it, without the two of tests/decks that have mistakes.  RANDOM_DECKS is random_decks of the build.
set -u
make=$1 sort=$2 n=$3
shift 3
tests=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
"$make" "$sort" "$n" "$work" || exit 1
cp "$tests"/../data/*.deck "$tests"/decks/*.deck "$work" && rm "$work/bad.deck" "$work/mistakes.deck" || exit 1
"$@" "$work"/*.deck
