#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_plot_options.sh FOURLINK DATA - the options of pictures, and pictures that a deck does not have.
. "$(dirname "$0")/pictures.sh"

# refused MESSAGE ARGUMENT...: before anything is done
refused() {
    usage "$@"
    check "a file was written: fourlink $*" test ! -e x.svg
}
for name in x.bmp x.svgz svg x.svg.gz '' x.; do
    refused '--plot needs a file name that ends in .svg, .png, .pdf, .txt or .gif, or -' --plot="$name" "$fourbar"
done
refused "--plot-kind must be mechanism, motion, forces, turning-moment, polar, vectors, klein, animation, histogram or columns, not 'foo'" \
    --plot=x.svg --plot-kind=foo "$fourbar"
refused "did you mean 'motion'?" --plot=x.svg --plot-kind=motoin "$fourbar"
refused '--plot-kind must be' --plot=x.svg --plot-kind= "$fourbar"
refused '--plot-kind needs --plot or --plot-script' --plot-kind=motion "$fourbar"
refused '--plot-at needs --plot or --plot-script' --plot-at='40 deg' "$fourbar"
refused '--plot takes one deck' --plot=x.svg "$fourbar" "$engine"
refused '--plot takes one deck' --plot-script=x.gp "$fourbar" "$engine"
refused "an animation needs a file name that ends in .gif, not 'x.svg'" --plot=x.svg --plot-kind=animation "$fourbar"
refused '--plot needs a value' "$fourbar" --plot
refused '-p needs a value' "$fourbar" -p
refused '--plot-at needs a value' "$fourbar" --plot=x.svg --plot-at
refused '--plot-script needs a value' "$fourbar" --plot-script

# at MESSAGE ANGLES [DECK]: refused, and no table printed
at() {
    for option in --plot=x.svg --plot-script=x.svg; do
        run 2 $option --plot-at="$2" "${3:-$fourbar}"
        says '--plot-at: error:'
        says "$1"
        lines err 1
        nothing
        check 'no picture of a wrong angle' test ! -e x.svg
    done
}
at "'40 mm' is a length; expected an angle" '40 mm'
at 'expected an angle' ''
at 'expected an angle' '40 deg,'
at 'expected an angle' '40 deg,,50 deg'
at 'expected an angle' 'nowhere'
at 'more than 24 positions' 1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24,25
at 'the motion does not reach theta2 = 150' 150 "$data/me3491-exercise-1.deck"
at 'the motion does not reach theta2 = 150 deg' '20 deg, 150 deg' "$data/me3491-exercise-1.deck"
run 0 --plot-script=x.gp --plot-at='40 deg, 50 deg' "$fourbar"
mv x.gp plain.gp
run 0 --plot-script=x.gp --plot-at='40°, 50 degrees' "$fourbar"
same x.gp plain.gp
run 0 --plot-script=x.gp --plot-at=1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24 "$fourbar"
quiet

# cannot MESSAGE KIND ARGUMENT...: no such picture of this deck, and no table printed
cannot() {
    message=$1
    kind=$2
    shift 2
    rm -f x.gp
    run 2 --plot-script=x.gp --plot-kind=$kind "$@"
    says "--plot-kind: error: $message"
    lines err 1
    nothing
    check "a script of nothing: $kind" test ! -e x.gp
}
cannot "Klein's construction needs a slider-crank" klein "$fourbar"
for kind in forces turning-moment polar; do
    cannot 'no forces to draw: the deck has no masses and no loads' $kind "$alvi"
done
moment='the turning moment needs a crank that turns fully, at constant speed'
cannot "$moment" turning-moment "$data/me3491-exercise-1.deck"
cannot "$moment" turning-moment "$fourbar" --set=motion.speed=0
cannot "$moment" turning-moment "$fourbar" --set='motion.acceleration=1 rad/s2'
for kind in mechanism vectors animation; do
    cannot 'cannot be assembled: B and D are too far apart' $kind "$data/me3491-exercise-1.deck" \
        --set='motion.from=150 deg' --set='motion.to=200 deg'
done
for kind in motion forces polar; do
    cannot 'the linkage cannot be assembled at any angle of the motion' $kind "$data/me3491-exercise-1.deck" \
        --set='motion.from=150 deg' --set='motion.to=200 deg'
done

finish
