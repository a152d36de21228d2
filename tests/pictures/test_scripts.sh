#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_scripts.sh FOURLINK DATA - the scripts draw the pictures.
. "$(dirname "$0")/pictures.sh"

needs_gnuplot
pictures_of "$fourbar" mechanism motion forces turning-moment polar vectors limits animation
pictures_of "$engine" $kinds

for deck in "$fourbar" "$engine"; do
    base=$(basename "$deck" .deck)
    for kind in $kinds; do
        [ $kind = klein ] && [ $base = coupler-point ] && continue
        picture=$base-$kind.svg
        [ $kind = animation ] && picture=$base.gif
        rm -f x.gp
        run 0 --plot-script=x.gp --plot-kind=$kind "$deck"
        quiet
        nothing
        draw x.gp
        same_drawing drawn $picture
        case $kind in animation | forces | polar | vectors) continue ;; esac
        mkdir scripts
        run 0 --plot-script=x.gp --plot=scripts/x.svg --plot-kind=$kind "$deck"
        only_file scripts '' # the script is not run
        draw x.gp
        same_drawing scripts/x.svg $picture
        rm -r scripts
    done
done
run 0 --plot=x.png "$fourbar"
mv x.png y.png
run 0 --plot=x.png --plot-script=x.gp "$fourbar"
draw x.gp
same x.png y.png

finish
