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
for name in x.bmp x.gif x.svgz svg x.svg.gz '' x.; do
    refused '--plot needs a file name that ends in .svg, .png, .pdf or .txt, or -' --plot="$name" "$fourbar"
done
refused "--plot-kind must be mechanism, motion, forces, turning-moment, polar, vectors, limits, klein, animation, speed, error or columns, not 'foo'" \
    --plot=x.svg --plot-kind=foo "$fourbar"
refused "did you mean 'motion'?" --plot=x.svg --plot-kind=motoin "$fourbar"
refused '--plot-kind must be' --plot=x.svg --plot-kind= "$fourbar"
refused '--plot-kind needs --plot' --plot-kind=motion "$fourbar"
refused '--plot-at needs --plot or --report' --plot-at='40 deg' "$fourbar"
refused '--plot takes one deck' --plot=x.svg "$fourbar" "$engine"
refused '--plot-x needs --plot' --plot-x=time "$fourbar"
refused '--plot-x works with --plot-kind=columns, not with mechanism' --plot=x.svg --plot-x=time "$fourbar"
refused '--plot-x works with --plot-kind=columns, not with forces' --plot=x.svg --plot-kind=forces --plot-x=time "$fourbar"
refused '--plot-at works with' --plot=x.svg --plot-kind=columns --plot-at=40 "$fourbar"
refused '--plot-x needs a value' "$fourbar" --plot=x.svg --plot-x
refused "an animation needs a file name that ends in .svg, not 'x.txt'" --plot=x.txt --plot-kind=animation "$fourbar"
refused '--plot needs a value' "$fourbar" --plot
refused '-p needs a value' "$fourbar" -p
refused '--plot-at needs a value' "$fourbar" --plot=x.svg --plot-at
refused "unknown option '--plot-script'" "$fourbar" --plot-script=x

# at MESSAGE ANGLES [DECK]: refused, and no table printed
at() {
    for option in --plot=x.svg; do
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
sed 's/^from .*/from = 0 deg/; s/^to .*/to = 360 deg/' "$data/me3491-exercise-1.deck" >turning.deck
printf '%s\n' 'mechanism = four-bar' '[ground]' 'length = 5' '[crank]' 'length = 5' '[coupler]' 'length = 6' '[rocker]' \
    'length = 3' '[motion]' 'speed = 1 rad/s' 'interval = 10 deg' >twice.deck
at 'theta2 = 150 deg: the motion goes from 110 to -110 deg' 150 "$data/me3491-exercise-1.deck"
at 'theta2 = 150 deg: the motion goes from 110 to -110 deg' '20 deg, 150 deg' "$data/me3491-exercise-1.deck"
at 'theta2 = 200 deg: the links reach from -110.487 to 110.487 deg' 200 turning.deck
at 'theta2 = 200 deg: the links reach from -110.487 to 110.487 deg' '20 deg, 200 deg' turning.deck
at 'theta2 = 180 deg: the links reach from 34.9152 to 128.316 deg, and from 231.684 to 325.085 deg' 180 twice.deck
run 0 --plot=x.svg --plot-at='40 deg, 50 deg' "$fourbar"
mv x.svg plain.svg
run 0 --plot=x.svg --plot-at='40°, 50 degrees' "$fourbar"
same x.svg plain.svg
run 0 --plot=x.svg --plot-at=1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21,22,23,24 "$fourbar"
quiet

# cannot MESSAGE KIND ARGUMENT...: no such picture of this deck, and no table printed
cannot() {
    message=$1
    kind=$2
    shift 2
    rm -f x.svg
    run 2 --plot=x.svg --plot-kind=$kind --format=table "$@"
    nothing
    run 2 --plot=x.svg --plot-kind=$kind "$@"
    nothing
    says "--plot-kind: error: $message"
    lines err 1
    check "a picture of nothing: $kind" test ! -e x.svg
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

# too_many MESSAGE KIND ARGUMENT...: more than 20,000 rows, and no table printed; with one less there is a picture
too_many() {
    message=$1
    kind=$2
    shift 2
    rm -f x.svg
    run 2 --plot=x.svg --plot-kind=$kind --format=table "$@"
    nothing
    says "error: $message"
    lines err 1
    check "a picture of too many rows: $kind" test ! -e x.svg
}
coarser='20001 rows; a picture shows at most 20,000: give a coarser --interval'
for kind in mechanism motion forces turning-moment polar vectors columns animation; do
    too_many "$coarser" $kind --interval='0.018 deg' --columns=Ts "$fourbar"
done
too_many '360001 rows; a picture shows' motion --interval='0.001 deg' "$fourbar"
run 0 --plot=x.svg --interval='0.018 deg' --set='motion.to=359.982 deg' "$fourbar"
quiet
# rows by time have no interval
time_step='20001 rows; a picture shows at most 20,000: give a coarser time_step with --set=motion.time_step'
too_many "$time_step" motion --set='motion.time_step=0.025 ms' "$decks/../fuzz/decks/free.deck"
# the outputs of a sweep are not rows
{ cat "$fourbar" && printf '[sweep]\ncrank.length = 18 mm, 20 mm\noutput = mu_min\n'; } >outputs.deck
run 0 --plot=x.svg --plot-kind=columns --interval='0.018 deg' outputs.deck
too_many "$coarser" motion --interval='0.018 deg' outputs.deck

# x MESSAGE NAME [DECK]: no such column to draw over
x() {
    rm -f x.svg
    run 2 --plot=x.svg --plot-kind=columns --plot-x="$2" "${3:-$fourbar}"
    nothing
    says "--plot-x: error: $1"
    lines err 1
    check "a picture of nothing over $2" test ! -e x.svg
}
x "unknown column 'foo'" foo
x "unknown column 'thetaa2'; did you mean 'theta2'?" thetaa2
x "unknown column 'timee'; did you mean 'time'?" timee
x "the column 'x' belongs to the slider-crank" x
x "the column 'F12' needs masses, loads or gas; the deck has none" F12 "$alvi"
for name in status branch deck type; do
    x "'$name' is a word, not a number to draw over" $name
done
for name in mu_min 'max(theta4)'; do
    x "'$name' is one value, not a column" "$name"
done
for name in '' all 'theta3,theta4' 'theta3 theta4' 'theta3#' 'theta3;' 'theta3=1' "theta3'"; do
    x 'expected the name of a column, not' "$name"
done
cannot 'no column to draw; name some with --columns' columns --columns=theta2 "$fourbar"
cannot 'a picture shows at most 24 columns; name those to draw with --columns' columns --columns=all "$fourbar"

# --- a picture comes alone, unless a table or another text is asked for
run 0 "$fourbar"
mv out table
for option in --format=table --output=-; do
    run 0 --plot=x.svg $option "$fourbar"
    quiet
    same out table
done
run 0 --plot=x.svg --output=o.txt "$fourbar"
same o.txt table
nothing
run 0 --plot=x.svg --wide --columns=theta4 --interval='10 deg' --branch=open "$fourbar"
nothing
for option in --summary --list --matrix --expect --format=csv; do
    run 0 $option "$fourbar"
    mv out wanted
    run 0 --plot=x.svg $option "$fourbar"
    same out wanted
done
"$fourlink" --check "$alvi" >wanted 2>err
run $? --plot=x.svg --check "$alvi"
same out wanted
# the exit status tells of missing rows, as that of the table does
run 1 --plot=x.svg turning.deck
nothing
says 'turning.deck: 26 of 74 rows could not be computed: cannot be assembled: B and D are too far apart'
lines err 1
check 'the picture is there' test -s x.svg
run 1 --plot=x.svg --format=table turning.deck
quiet
run 1 --plot=x.svg --plot-kind=motion --set='motion.acceleration=-100 rad/s2' "$fourbar"
says 'the crank comes to rest'
lines err 1
run 2 --plot=x.svg --plot-kind=klein turning.deck
lines err 1
run 3 --plot=missing/x.svg turning.deck
lines err 1

# a title that is too long ends in an ellipsis; its letters are of two bytes
long_title >long.deck
for case in mechanism:97 motion:108; do
    run 0 --plot=x.svg --plot-kind=${case%:*} long.deck
    words x.svg | sed -n 's/^\(\(äé\)*\(ä\)*\)…$/\1/p' >title
    check "letters of a long title: $(wc -c <title) bytes" test "$(wc -c <title)" -eq $((2 * ${case#*:} + 1))
done

finish
