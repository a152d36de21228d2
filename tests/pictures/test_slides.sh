#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_slides.sh FOURLINK DATA - the recipe for gif and mp4 of doc/gallery.md, run as it stands there: a period in equal
# steps, of which the last is to the first frame; it begins anew without a jump, and without a frame twice.
. "$(dirname "$0")/../harness.sh"
needs ffmpeg ffmpeg
needs rsvg-convert librsvg2-bin
page=$data/../doc/gallery.md

# block LANGUAGE: of the section on gif and mp4
block() { awk -v begin="\`\`\`$1" '/^## /{on = /gif and mp4/} /^```/ {inside = on && $0 == begin; next} inside' "$page"; }
block awk >frames.awk
block sh >recipe
check 'there is a recipe' test -s frames.awk -a -s recipe
ln -s "$data" data

# make DECK: the recipe, with another deck
make() {
    rm -f frame-*
    sed "s, data/[^ ]*\.deck, $1," recipe >commands
    PATH=$programs:$PATH sh -e ./commands >out 2>err </dev/null
}

# steps: of the crank in degrees, from each frame to the next and from the last to the first
steps() {
    cat frame-*.svg | awk '/rotate\(/ {turned = $0; sub(/.*rotate\(/, "", turned); turned += 0}
        /<\/g>/ {turned = 0}
        /class="crank"/ {
        sub(/.* d="M/, ""); sub(/".*/, ""); split($0, at, /[ML,]+/)
        angle[n++] = atan2(at[2] - at[4], at[3] - at[1]) * 45 / atan2(1, 1) - turned}
        END {for (k = 0; k < n; k++) {
            step = angle[(k + 1) % n] - angle[k]
            print step - 360 * int(step / 360 + (step < 0 ? -0.5 : 0.5))}}'
}
# are STEP: all of them are this one
are() { steps | awk -v step="$1" '{e = $1 - step; if (e < -0.01 || e > 0.01) bad++} END {exit bad || NR < 2}'; }

# frames FILE, of a video
frames() { ffprobe -v error -count_frames -select_streams v -show_entries stream=nb_read_frames -of csv=p=0 "$1" | tr -d ,; }

# changes FILE: how much each frame of a video that is played twice differs from the one before
changes() {
    ffmpeg -v error -stream_loop 1 -i "$1" -vf 'format=yuv444p,tblend=all_mode=difference,signalstats,metadata=print:key=lavfi.signalstats.YAVG:file=-' \
        -f null - </dev/null | sed -n 's/.*YAVG=//p'
}

check_file err 'the recipe' make data/whitworth-150-100.deck
check 'frames as svg' test "$(ls frame-*.svg | wc -l)" -eq 60
check 'frames as png, all of one size' test "$(for file in frame-*.png; do ffprobe -v error -show_entries stream=width,height -of csv=p=0 "$file"; done |
    sort -u | wc -l)" -eq 1
check 'nothing in them moves' test -z "$(cat frame-*.svg | grep '<animate')"
check 'equal steps, the last to the first frame' are 6
for file in motion.gif motion.mp4; do
    check "$file: frames" test "$(frames $file)" -eq 60
    changes $file >changes
    check "$file: played twice" test "$(wc -l <changes)" -eq 119
    check "$file: it begins anew as it goes on" awk '
        NR == 60 {seam = $1; next}
        {least = NR == 1 || $1 < least ? $1 : least; most = $1 > most ? $1 : most}
        END {exit !(least > 0 && seam >= least && seam <= most)}' changes
done
check 'the gif goes on for ever' test "$(od -A n -t x1 -v motion.gif | tr -d ' \n' | grep -o '4e45545343415045322e30.\{10\}')" = \
    4e45545343415045322e300301000000
check 'any player shows the mp4' test "$(ffprobe -v error -select_streams v -show_entries stream=codec_name,pix_fmt -of csv=p=0 motion.mp4)" = \
    h264,yuv420p

# A cycle of four strokes; clockwise.
grep -v '^ffmpeg\|rsvg-convert' recipe >quick
mv quick recipe
make data/otto-4x4.deck
check 'two turns' are 12
sed 's/^speed .*/speed = -100 rpm/' "$data/whitworth-150-100.deck" >clockwise.deck
make clockwise.deck
check 'clockwise' are -6
finish
