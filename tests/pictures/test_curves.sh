#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_curves.sh FOURLINK DATA - the curves of the pictures against the table.
. "$(dirname "$0")/pictures.sh"

needs_gnuplot
pictures_of "$fourbar" mechanism motion forces turning-moment
run 0 --plot=coupler-point-polar.svg --plot-kind=polar --branch=both "$fourbar"
pictures_of "$engine" motion forces turning-moment

# curves SVG: "PANEL<tab>NUMBER<tab>INDEX<tab>X<tab>Y<tab>DX<tab>DY" of each point of each curve, in the
# values of the axes as their numbers tell them; DX and DY are those of a pixel.
curves() {
    awk '
    function tic() {
        if (!x_or_y) return
        if (x_or_y == 1) {if (!nx++) {x1 = at; vx1 = value} x2 = at; vx2 = value}
        else {if (!ny++) {y1 = at; vy1 = value} y2 = at; vy2 = value}
    }
    function finish_curve(  i, from) {
        from = n > 2 && !move[1] && move[2] ? 2 : 0     # the sample in the key
        for (i = from; i < n; i++)
            printf "%s\t%d\t%d\t%.9g\t%.9g\t%.9g\t%.9g\n", panel, number, i - from, vx1 + (px[i] - x1) * sx,
                vy1 + (py[i] - y1) * sy, sx, sy
    }
    /<g id="gnuplot_plot_/ {
        id = $0; sub(/.*<g id="gnuplot_plot_/, "", id); sub(/".*/, "", id)
        number = id + 0; letter = id; gsub(/[0-9]/, "", letter)
        if (letter != panel) {panel = letter; sx = (vx2 - vx1) / (x2 - x1); sy = (vy2 - vy1) / (y2 - y1)}
        n = depth = 0; inside = 1; path = 0
    }
    inside {
        line = $0
        if (line ~ /<path /) {path = 1; sub(/.* d=./, "", line)}
        if (path) {
            if (index(line, "\047")) {path = 0; sub(/\047.*/, "", line)}
            k = split(line, w, " ")
            for (i = 1; i <= k; i++) {
                if (w[i] !~ /^[ML]/) continue
                split(substr(w[i], 2), p, ",")
                m = substr(w[i], 1, 1) == "M"
                if (m && n && p[1] == px[n - 1] && p[2] == py[n - 1]) continue  # a long line goes on
                px[n] = p[1]; py[n] = p[2]; move[n] = m; n++
            }
        }
        line = $0
        depth += gsub(/<g[ >]/, "", line) - gsub(/<\/g>/, "", line)
        if (depth == 0) {finish_curve(); inside = 0; nx = ny = 0}
        next
    }
    /<path .*translate\(/ && !/gridline/ {
        line = $0; sub(/.* d=.M/, "", line); split(line, w, /[ ,L]+/)
        length_of_tic = w[1] - w[3] + w[2] - w[4]
        if (length_of_tic * length_of_tic > 400) next   # the frame, before a label
        x_or_y = w[2] == w[4] ? 2 : w[1] == w[3] ? 1 : 0
        at = x_or_y == 2 ? w[2] : w[1]
        getline
        value = $0; sub(/^[^>]*>/, "", value); sub(/<.*/, "", value); gsub(/ /, "", value)
        if (value ~ /^-?[0-9.]+(e[-+]?[0-9]+)?$/) tic()
    }' "$1"
}
# follows PANEL NUMBER POINTS STEP BRANCH X Y [FACTOR]: each row of csv on a branch is the point STEP further
# on of a curve of so many points in the file curves, to 0.3 pixels; angles by whole turns; at least 7 rows.
follows() {
    awk -F '[,\t]' -v panel="$1" -v number="$2" -v points="$3" -v step="$4" -v branch="$5" -v xname="$6" -v yname="$7" \
        -v factor="${8:-1}" '
        function off(x, y, pixel) {x -= y; if (x < 0) x = -x; if (pixel < 0) pixel = -pixel; return !(x <= 0.3 * pixel)}
        FNR == 1 && NR != 1 {for (i = 1; i <= NF; i++) {sub(/ .*/, "", $i); if ($i == xname) cx = i; if ($i == yname) cy = i}; next}
        NR == FNR {if ($1 == panel && $2 == number) {x[$3] = $4; y[$3] = $5; sx = $6; sy = $7; n++}; next}
        $1 == branch && cx && cy {
            # points that fall into one pixel may be drawn as one
            i = rows++ * step; X = $cx; Y = $cy * factor
            while (n < points && i > 0 && (!(i in x) || off(x[i], X, sx) || off(y[i], Y, sy)) && rows * step - step - i < points - n) i--
            if (yname ~ /^theta/) Y += 360 * int((y[i] - Y) / 360 + (y[i] > Y ? 0.5 : -0.5))
            if (!(i in x) || off(x[i], X, sx) || off(y[i], Y, sy)) bad = 1
            if (rows == 1) first = Y; if (off(Y, first, sy)) moves = 1}
        END {exit !(rows >= 7 && n <= points && n >= points - 2 && !bad && moves)}' curves csv
}
compare() {
    check "$1: curve $2 of panel $3 against $8, $6" follows "$3" "$2" "$4" "$5" "$6" "$7" "$8" "${9:-1}"
}
# equal PANEL: one scale on both axes, up and to the right
equal() {
    check "equal scales of panel $1" awk -F '\t' -v panel="$1" '$1 == panel {r = -$7 / $6; n++; if (r < 0.995 || r > 1.005) bad = 1}
        END {exit !(n && !bad)}' curves
}
csv() { "$fourlink" --format=csv --interval='30 deg' --columns="$1" "$2" >csv; }

csv theta2,theta3,theta4,omega3,omega4,alpha3,alpha4,F12,F23,F34,F14,Ts,F14_along,F14_across,F12_along,F12_across "$fourbar"
curves coupler-point-motion.svg >curves
number=1
for branch in open crossed; do
    compare motion $number a 721 60 $branch theta2 theta3
    compare motion $number b 721 60 $branch theta2 theta4
    compare motion $number c 721 60 $branch theta2 omega3
    compare motion $number d 721 60 $branch theta2 omega4
    compare motion $number e 721 60 $branch theta2 alpha3
    compare motion $number f 721 60 $branch theta2 alpha4
    number=2
done
# the comparison can fail
check 'another column is another curve' not follows d 1 721 60 open theta2 omega3
check 'another branch is another curve' not follows d 1 721 60 crossed theta2 omega4
check 'a little more is too much' not follows d 1 721 60 open theta2 omega4 1.02

curves coupler-point-forces.svg >curves
for branch in open crossed; do
    set -- a b
    [ $branch = open ] || set -- c d
    number=1
    for name in F12 F23 F34 F14; do
        compare forces $number $1 721 60 $branch theta2 $name
        number=$((number + 1))
    done
    compare forces 1 $2 721 60 $branch theta2 Ts
done
curves coupler-point-polar.svg >curves
compare polar 1 a 721 60 open F12_along F12_across
compare polar 1 f 721 60 open F14_along F14_across
compare polar 3 f 721 60 crossed F14_along F14_across
for panel in a b c d e f; do
    equal $panel
done
curves coupler-point-turning-moment.svg >curves
compare turning-moment 3 a 721 60 open theta2 Ts -1
compare turning-moment 3 b 721 60 crossed theta2 Ts -1

{
    cat "$fourbar"
    printf '[point C]\nlink = coupler\nat = 66 mm\n'
} >pins.deck
csv theta2,C.x,C.y,P.x,P.y pins.deck
curves coupler-point-mechanism.svg >curves
compare mechanism 1 a 181 15 open C.x C.y
compare mechanism 2 a 181 15 open P.x P.y
compare mechanism 1 b 181 15 crossed C.x C.y
compare mechanism 2 b 181 15 crossed P.x P.y
equal a
equal b
run 0 --plot=x.svg --plot-at='250 deg' "$fourbar"
shows x.svg 'open, θ₂ = 250°' 'crossed, θ₂ = 250°'

csv theta2,x,v,a,omega3,F12,F34,N,Ts "$engine"
curves engine-motion.svg >curves
compare engine 1 b 721 60 open theta2 x
compare engine 1 d 721 60 open theta2 v
compare engine 2 d 721 60 crossed theta2 v
compare engine 1 f 721 60 open theta2 a
compare engine 2 c 721 60 crossed theta2 omega3
curves engine-forces.svg >curves
compare engine 1 a 721 60 open theta2 F12
compare engine 4 a 721 60 open theta2 N
compare engine 1 b 721 60 open theta2 Ts
curves engine-turning-moment.svg >curves
compare engine 3 a 721 60 open theta2 Ts -1

# --- the energies beside the turning moment
# energies SVG BRANCH DECK: their sum over a cycle is 0; the greatest sum on the way is the fluctuation
energies() {
    fluctuation=$("$fourlink" --summary --format=csv "$3" | tr -d "$cr" | awk -F, -v b="$2" '$1 == "energy_fluctuation" && $NF == b {print $2}')
    mean=$("$fourlink" --summary --format=csv "$3" | tr -d "$cr" | awk -F, -v b="$2" '$1 == "mean_torque" && $NF == b {print $2}')
    words "$1" | awk -v branch="$2" -v E="$fluctuation" -v T="$mean" '
        function off(x, y, e) {x -= y; if (x < 0) x = -x; return !(x <= e)}
        /: mean / {
            split($0, w, /: mean = | N·m, ΔE = | J/)
            if (w[1] == branch) {mean = w[2]; given = w[3]}}
        END {exit off(mean, T, 1e-4 * (T < 0 ? -T : T) + 1e-9) || off(given, E, 1e-4 * E)}' || return 1
    "$fourlink" --plot-script=t.gp --plot-kind=turning-moment --branch=$2 "$3" >/dev/null
    awk -v E="$fluctuation" '/^set label .* J. at / {words = $0; sub(/^set label ./, "", words); split(words, w, " ")
            s += w[1]; if (s > high) high = s; if (s < low) low = s; n++}
        END {d = high - low - E; exit !(n >= 2 && s < 0.002 * E && s > -0.002 * E && d < 0.002 * E && d > -0.002 * E)}' t.gp || return 1
    # each number stands in the picture, too
    sed -n 's/^set label .\(.* J\). at .*/\1/p' t.gp >numbers
    words "$1" >texts
    while read -r number; do
        grep -qxF -e "$number" texts || return 1
    done <numbers
}
for branch in open crossed; do
    check "energies of the four-bar, $branch" energies coupler-point-turning-moment.svg $branch "$fourbar"
    check "energies of the engine, $branch" energies engine-turning-moment.svg $branch "$engine"
done
# clockwise: the cycle from 0 to 360 deg, and a moment that drives in the sense of rotation is positive
run 0 --plot=clockwise.svg --plot-kind=turning-moment "$data/me3491-exercise-4.deck"
curves clockwise.svg >curves
"$fourlink" --format=csv --interval='30 deg' --columns=theta2,Ts "$data/me3491-exercise-4.deck" |
    awk -F, 'BEGIN {OFS = ","} NR > 1 {$2 = -$2} 1' >csv
compare clockwise 3 a 721 60 open theta2 Ts
shows clockwise.svg '-θ₂, turned clockwise (°)' '2237.1 J' '-2282.3 J' 'E max' 'E min' \
    'E max at 159.5°' 'E min at 292.8°' 'of energy 0.578' 'of speed: no flywheel'
run 0 --plot-script=t.gp --plot-kind=turning-moment "$data/me3491-exercise-4.deck"
# above FILE: each energy that is above 0 stands above the mean, the others below it; on their centroids at least two
above() {
    awk '/^mean = / {mean = $3}
        /^set label .* J. at / {split($6, p, ","); E = substr($3, 2) + 0; if ((E > 0) != (p[2] + 0 > mean + 0)) bad = 1; if (E > 2000 || E < -2000) n++}
        END {exit !(n == 2 && !bad)}' "$1"
}
check 'a clockwise crank gives out energy above the mean' above t.gp
sed 's/^mean = .*/mean = 1e9/' t.gp >wrong.gp
check 'energies on the wrong side are seen' not above wrong.gp
check 'the energies of another branch are others' not energies coupler-point-turning-moment.svg open "$engine"

# --- polar: the shaking force without counterweights and with them, if the deck has any
for apply in yes no; do
    run 0 --plot-script=v.gp --plot-kind=polar --set='motion.speed=20 rad/s' --set=gravity.acceleration=0 --set=balance.crank=yes \
        --set=balance.rocker=yes --set='balance.radius=40 mm' --set=balance.apply=$apply --branch=open "$matrix"
    quiet
    awk '/^\$Fs_before << /, /^EOD/' v.gp | grep '^-*[0-9]' >before
    awk '/^\$Fs_after << /, /^EOD/' v.gp | grep '^-*[0-9]' >after
    check "shaking force before, apply = $apply" awk '{s = $1 * $1 + $2 * $2; if (s > big) big = s} END {exit !(NR == 721 && big > 0.01)}' before
    check "shaking force after, apply = $apply" awk '{s = $1 * $1 + $2 * $2; if (s > big) big = s} END {exit !(NR == 721 && big < 1e-24)}' after
    check 'the key' grep -q "title 'before'.*title 'after'" v.gp
done
run 0 --plot-script=v.gp --plot-kind=polar --branch=open "$matrix"
check 'no counterweights, no shaking force' none Fs v.gp
run 0 --plot-script=v.gp --plot-kind=polar --set=balance.crank=yes --branch=open "$matrix"
check 'without a radius there are no counterweights' none Fs v.gp
run 0 --plot-script=v.gp --plot-kind=polar "$data/khurmi-22.1.deck"
check 'the shaking force of an engine' grep -q 'shaking force, open' v.gp

finish
