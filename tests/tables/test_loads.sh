#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_loads.sh FOURLINK DATA - loads in the link's frame and between two crank angles, curves of torque,
# indicator cards in files, tracer points: one deck against another that must give the same numbers.
. "$(dirname "$0")/../harness.sh"

# close FILE FILE: the same numbers to 1e-9, field by field
close() {
    paste -d, "$1" "$2" | awk -F, -v bad=0 '
        function size(x) {return x < 0 ? -x : x}
        {for (i = 1; i <= NF / 2; i++) {
            x = $i; y = $(i + NF / 2)
            if (x ~ /^[-+0-9.e]+$/) {n++; if (size(x - y) > 1e-9 * (1 + size(x) + size(y))) bad++}
            else if (x != y) bad++}}
        END {if (bad || n < 10) print bad " of " n " differ"; exit bad || n < 10}'
}
differs() { ! close "$1" "$2" >/dev/null; }

# forces: the torques and pin forces of a deck, from standard input
forces() { "$fourlink" -f csv -c theta2,F12x,F12y,F34x,F34y,Ts "$@" 2>err | tr -d '\r'; }

linkage() {
    cat <<'DECK'
mechanism = four-bar
[ground]
length = 80 mm
[crank]
length = 20 mm
mass = 0.1 kg
[coupler]
length = 66 mm
[rocker]
length = 56 mm
[motion]
speed = 10.5 rad/s
DECK
}

# A force that turns with the crank is, at each angle, one in ground axes turned by that angle.
for angle in 0 40 200; do
    { linkage; printf 'at = %s deg\n[load]\nlink = crank\nat = 15 mm\nframe = link\nforce = 50 N at 30 deg\n' $angle; } |
        forces >turning
    { linkage; printf 'at = %s deg\n[load]\nlink = crank\nat = 15 mm\nforce = 50 N at %s deg\n' $angle $((angle + 30)); } |
        forces >fixed
    check "a force that turns with the crank, at $angle deg" close turning fixed
done
{ linkage; printf '[load]\nlink = crank\nat = 15 mm\nforce = 50 N at 30 deg\n'; } | forces >fixed
{ linkage; printf '[load]\nlink = crank\nat = 15 mm\nforce = 50 N at 30 deg\nframe = link\n'; } | forces >turning
check 'and not one in ground axes' differs turning fixed

# A force off the link's line is the same force on it with a torque.
{ linkage; printf '[load]\nlink = rocker\nat = (30, 10) mm\nforce = (0, 20) N\nframe = link\n'; } | forces >one
{ linkage; printf '[load]\nlink = rocker\nat = (0, 10) mm\nforce = (0, 20) N\nframe = link\n[load]\nlink = rocker\ntorque = 0.6 N m\n'; } |
    forces >two
check 'a force moved along the link, with its torque' close one two

# A load between two crank angles: there as if it always acted, elsewhere as if it were not there.  It acts where the crank
# enters the range, and not where it leaves.
{ linkage; printf 'from = 0 deg\nto = 720 deg\n[load L]\nlink = rocker\ntorque = 3 N m\nfrom = 100 deg\nto = 200 deg\n'; } >window.deck
forces window.deck >window
{ linkage; printf 'from = 0 deg\nto = 720 deg\n[load L]\nlink = rocker\ntorque = 3 N m\n'; } | forces >always
{ linkage; printf 'from = 0 deg\nto = 720 deg\n'; } | forces >never
inside='{t = $2 % 360} t >= 100 && t < 200'
outside='{t = $2 % 360} t < 100 || t >= 200'
for file in window always never; do
    tail -n +2 $file | awk -F, "$inside" >$file.inside
    tail -n +2 $file | awk -F, "$outside" >$file.outside
done
check 'a load within its angles, in two revolutions' close window.inside always.inside
check 'and outside them' close window.outside never.outside
check 'which is not the same' differs window.outside always.outside
# over the end of the revolution, and running backwards
forces -s 'load L.from=300 deg' -s 'load L.to=400 deg' window.deck >across
tail -n +2 across | awk -F, '{t = $2 % 360} t >= 300 || t < 40' >across.inside
tail -n +2 always | awk -F, '{t = $2 % 360} t >= 300 || t < 40' >always.inside
check 'a load over 360 deg' close across.inside always.inside
forces -s 'motion.speed=-10.5' -s 'motion.from=720 deg' -s 'motion.to=0 deg' window.deck | tail -n +2 |
    sort -t, -k1,1 -k2,2n >back
between='{t = $2 % 360} t != 100 && t != 200'
tail -n +2 window | sort -t, -k1,1 -k2,2n | awk -F, "$between" >forth
awk -F, "$between" back >back.between
check 'the other way round (the speed enters squared)' close back.between forth
for edge in 100 200; do
    file=$([ $edge = 200 ] && echo always || echo never)
    awk -F, -v e=$edge '$2 % 360 == e' back >back.edge
    tail -n +2 $file | sort -t, -k1,1 -k2,2n | awk -F, -v e=$edge '$2 % 360 == e' >$file.edge
    check "it enters at 200 deg then, and leaves at 100 deg: $edge deg" close back.edge $file.edge
done

mistake() { # DECK-TEXT MESSAGE
    { linkage; printf "$1"; } | "$fourlink" >out 2>err
    check "exit status 2 for $1" test $? -eq 2
    check "no output for $1" test ! -s out
    check "message '$2': $(cat err)" grep -qF "$2" err
}
mistake '[load]\nlink = rocker\ntorque = 1 N m\nfrom = 200 deg\nto = 100 deg\n' \
    "<stdin>:16: error: the load's 'from' must be less than its 'to', not 200 deg and 100 deg"
mistake '[load]\nlink = piston\ntorque = 1 N m\n' '<stdin>:14: error: a four-bar linkage has no piston'
mistake '[load]\nlink = wheel\ntorque = 1 N m\n' "<stdin>:14: error: expected crank, coupler or rocker, not 'wheel'"
mistake '[load]\nlink = rocker\nframe = world\ntorque = 1 N m\n' '<stdin>:15: error: expected ground or link'
mistake '[units]\nvelocity = m/s\n' "<stdin>:14: error: unknown key 'velocity' in [units]; did you mean 'speed'?"
mistake '[spring]\nlink = wheel\nto = ground\n' "<stdin>:14: error: expected ground, crank, coupler or rocker, not 'wheel'"
mistake '[point]\nlink = coupler\n' '<stdin>:13: error: a point needs a name'
mistake '[point a b]\nlink = coupler\n' '<stdin>:13: error: the name of a point must be one word'
mistake '[point P]\nat = 3 mm\n' '<stdin>:13: error: [point] has no link'
mistake '[load]\nlink = crank\ntorque = 0 deg 1 N m\n[load\n' "<stdin>:16: error: expected ']'"
mistake '[load]\nlink = crank\ntorque = 0 deg 1 N m, 50 deg 2 N m, 40 deg 1 N m\n' \
    '<stdin>:15: error: the angles of a curve must increase'

# A torque as a curve: at its points that of the curve, as a constant.
{ linkage; printf '[load]\nlink = crank\ntorque = 0 deg 1 N m, 90 deg 3 N m,   # goes on\n  200 deg -1 N m\n'; } >curve.deck
for point in '0 1' '90 3' '200 -1' '360 1'; do
    forces -s "motion.at=${point% *} deg" curve.deck >curve
    { linkage; printf 'at = %s deg\n[load]\nlink = crank\ntorque = %s N m\n' ${point% *} ${point#* }; } | forces >constant
    check "a curve of torque at $point" close curve constant
done

# A force as a curve: at its points that of the curve, in either form, as a constant.
{ linkage; printf '[load]\nlink = coupler\nat = mid\nforce = 0 deg (3, 4) N, 90 deg 50 N at 20 deg,\n  200 deg (-1, 2) N\n'; } >curve.deck
for point in '0 (3, 4) N' '90 50 N at 20 deg' '200 (-1, 2) N' '360 (3, 4) N'; do
    forces -s "motion.at=${point%% *} deg" curve.deck >curve
    { linkage; printf 'at = %s deg\n[load]\nlink = coupler\nat = mid\nforce = %s\n' "${point%% *}" "${point#* }"; } |
        forces >constant
    check "a curve of force at $point" close curve constant
done
run 0 --list curve.deck
run 0 --summary curve.deck
holds 'the extremes of Ts' '$1 == "Ts" && $6 == "N.m" {ok = 1} END {exit !ok}'

# An indicator card in the deck and in a file beside it.
mkdir engines
cat >engines/card.txt <<'CARD'
# crank angle, pressure: bare numbers in the deck's units
0, 1
20, 32
60 8   # a blank will do
180 1.5
360,1
CARD
engine() {
    printf 'mechanism = slider-crank\n[units]\npressure = bar\n[crank]\nlength = 50 mm\n[rod]\nlength = 200 mm\n'
    printf 'mass = 1 kg\ncg = 60 mm\ngyration = 50 mm\n[piston]\nmass = 1 kg\n[motion]\nspeed = 1000 rpm\n[gas]\nbore = 80 mm\n'
}
{ engine; echo 'indicator = file card.txt'; } >engines/file.deck
{ engine; echo 'indicator = 0 1, 20 32, 60 8, 180 1.5'; } >engines/inline.deck
forces engines/file.deck >from_file
forces engines/inline.deck >from_deck
check 'a card in a file, relative to the deck' close from_file from_deck
"$fourlink" -f csv -c theta2,gas_force -b open -i 20 engines/file.deck | tr -d '\r' >gas
check 'the gas force at 20 deg is that of 32 bar' awk -F, '$2 == 20 {x = $3 - 32e5 * 3.14159265358979 / 4 * 0.0064; exit !(x < 1e-6 && x > -1e-6)}' gas
# Cards as instruments write them: the same curve from each of these files, in bar.
engine | sed '/^\[units\]/d;/^pressure = bar/d' >engines/head
card() { # NAME KEY: the file from standard input, with the value of the key
    cat >"engines/$1.csv"
    { cat engines/head; echo "indicator = $2"; } >"engines/$1.deck"
    forces "engines/$1.deck" >from_card
    check "$1: $(cat err)" test ! -s err
    check "the card $1" close from_card from_deck
}
printf 'Angle [deg],Pressure [bar]\r\n0,1\r\n20,32\r\n60,8\r\n180,1.5\r\n' | card commas 'file commas.csv'
printf '\357\273\277"Winkel [\302\260]";"p (bar)"\n0,0;1,0\n"20,0";"32,0"\n60;8\n180,0;1,5;\n' | card semicolons 'file semicolons.csv'
printf 'Winkel\tDruck\n\260\tbar\n0\t1\n20\t32\n60\t8\n180\t1.5\n' | card tabs 'file tabs.csv'
printf '0;1\n20;32\n60;8\n180;1,5\n' | card told 'file told.csv deg bar'
printf '0 1\n20 32\n60 8\n180 1.5\n' | card one_unit 'file one_unit.csv bar'
# 45 without a unit are pascals, which is said
sed 's/ bar$//' engines/one_unit.deck >engines/bare.deck
run 0 engines/bare.deck
says "engines/bare.deck:15: note: the values of this curve are read as Pa, the largest as 32 Pa: give their unit, such as 'file card.csv deg bar'"

# The gas as a force on the piston: area times pressure, towards the crank.
area=$(awk 'BEGIN {printf "%.17g", 3.14159265358979323846 / 4 * 0.0064 * 1e5}')
{ engine | sed '/^\[gas\]/,$d'; printf '[load]\nlink = piston\nforce = '
    awk -v a="$area" 'BEGIN {printf "0 %.17g N, 20 %.17g N, 60 %.17g N, 180 %.17g N\n", -a, -32 * a, -8 * a, -1.5 * a}'
    echo '[table]'; echo 'branch = open'; } >engines/force.deck
forces engines/force.deck >from_force
check 'the gas as a force on the piston' close from_force from_deck
for fact in mean_torque energy_fluctuation 'max(Ts)' 'min(F12)'; do
    for deck in force inline; do
        run 0 --summary -f csv -c Ts,F12 engines/$deck.deck
        grep -F "$fact," out | awk -F, '{printf "%.10g\n", $2}' >$deck.fact
    done
    check "$fact of both: $(cat force.fact inline.fact)" test -s force.fact
    same force.fact inline.fact
done

engine_mistake() { # LINES MESSAGE
    { engine; printf "$1"; } >engines/bad.deck
    "$fourlink" engines/bad.deck >out 2>err
    check "exit status 2 for $1" test $? -eq 2
    check "message '$2': $(cat err)" grep -qF "$2" err
}
engine_mistake 'indicator = 0 1\n' 'engines/bad.deck:17: error: a curve needs at least two points'
engine_mistake 'indicator = 0 1, 50 2, 50 3\n' 'engines/bad.deck:17: error: the angles of a curve must increase'
engine_mistake 'indicator = file nothing.txt\n' "engines/bad.deck:17: error: cannot read the file 'nothing.txt'"
# units of other quantities after the name of a file that exists
engine_mistake 'indicator = file card.txt rpm bar\n' "engines/bad.deck:17: error: 'rpm' is an angular speed; expected an angle"
engine_mistake 'indicator = file card.txt deg mm\n' "engines/bad.deck:17: error: 'mm' is a length; expected a pressure"
engine_mistake 'indicator = file card.txt deg baar\n' "engines/bad.deck:17: error: unknown unit 'baar' in 'baar'; did you mean 'bar'?"
engine_mistake 'indicator = file "card.txt" N\n' "engines/bad.deck:17: error: 'N' is a force; expected a pressure"
engine_mistake 'indicator = file nothing.txt rpm bar\n' "engines/bad.deck:17: error: cannot read the file 'nothing.txt rpm'"
printf '0 1\n90 x\n' >engines/broken.txt
engine_mistake 'indicator = file broken.txt\n' 'broken.txt:2: error:'
printf '0 1\n90 2\n80 3\n' >engines/falling.txt
engine_mistake 'indicator = file falling.txt\n' 'falling.txt:3: error: the angles of a curve must increase'
sed 's/bore = 80 mm/bore = 0 mm/' engines/inline.deck >engines/bad.deck
"$fourlink" engines/bad.deck >out 2>err
check 'a bore of 0' grep -qF 'engines/bad.deck:16: error: the bore must be positive, not 0 mm' err
sed '/bore/d' engines/inline.deck >engines/bad.deck
"$fourlink" engines/bad.deck >out 2>err
check 'pressure without a bore' grep -qF 'engines/bad.deck:15: error: [gas] has no bore' err

# Tracer points: the pins, which other columns give, and speed by differences.
{ linkage; printf 'interval = 0.01 deg\nfrom = 10 deg\nto = 10.02 deg\n[point C]\nlink = coupler\nat = 66 mm\n[point K]\nlink = rocker\nat = 56 mm\n'; } >points.deck
"$fourlink" -f csv -b open -c time,C.x,C.y,C.vx,C.ax,C.v,C.a points.deck 2>err | tr -d '\r' >C
"$fourlink" -f csv -b open -c time,K.x,K.y,K.vx,K.ax,K.v,K.a points.deck 2>err | tr -d '\r' | sed 's/K\./C./g' >K
tail -n +2 C >C.rows
tail -n +2 K >K.rows
check 'the pin C as a point of coupler and rocker' close C.rows K.rows
check 'its velocity and acceleration by differences' awk -F, '
    {t[NR] = $2; x[NR] = $3; v[NR] = $5; a[NR] = $6}
    END {d = (x[3] - x[1]) / (t[3] - t[1]) - v[2]; e = (v[3] - v[1]) / (t[3] - t[1]) - a[2]
         exit !(NR == 3 && d * d < 1e-14 && e * e < 1e-10)}' C.rows

# Static analysis is speed 0; torque by virtual work is that of the nine equations.
"$fourlink" -f csv -c Ts,Ts_work,Ts_static,Ts_inertia -s motion.speed=0 "$data/me3491-exercise-1.deck" | tr -d '\r' |
    tail -n +2 >static
check 'at rest all is static' awk -F, '{d = $2 - $3; e = $2 - $4; if (d * d + e * e + $5 * $5 > 1e-18) bad = 1} END {exit bad || NR < 40}' static
"$fourlink" -f csv -b open -c Ts,Ts_static,Ts_inertia "$data/me3491-exercise-1.deck" | tr -d '\r' | tail -n +2 |
    awk -F, '{print $2}' >whole
"$fourlink" -f csv -b open -c Ts,Ts_static,Ts_inertia "$data/me3491-exercise-1.deck" | tr -d '\r' | tail -n +2 |
    awk -F, '{printf "%.17g\n", $3 + $4}' >sum
check 'loads and inertia separately make the whole' close whole sum

# A torsional spring that is wound up is another in each of three turns: its means, by integrals of
# A buffer and a rope with the same numbers are together the spring, in rows, extremes, the turning moment, and in a motion
# that follows from them and swings back.
slide='link = piston\nto = ground\nto_at = (300, 0) mm\nstiffness = 5000 N/m\nfree_length = 90 mm\ndamping = 3 N s/m\n'
rod='[crank]\nlength = 50 mm\nmass = 1 kg\nuniform = yes\n[rod]\nlength = 200 mm\nmass = 0.5 kg\nuniform = yes\n[piston]\nmass = 2 kg\n'
for motion in 'speed = 10 rad/s\ninterval = 7 deg\n' 'mode = free\nspeed = 10 rad/s\nrows = time\ntime_step = 7 ms\nduration = 0.4 s\n'; do
    { printf "mechanism = slider-crank\n${rod}[motion]\n$motion"; printf "[spring S]\n$slide"; } >spring.deck
    { cat spring.deck; printf "only = pushes\n[spring R]\n${slide}only = pulls\n"; } >buffer.deck
    for deck in spring buffer; do
        "$fourlink" -b open -f csv -c theta2,omega2,alpha2,Ts,F12x,F34x,Fsx,Ms $deck.deck >$deck.rows 2>err
        "$fourlink" -b open -f csv -S -c theta2,omega2,alpha2,Ts,F12x,F34x,Fsx,Ms $deck.deck 2>err |
            awk -F, '/^(max|min|mean|energy)/ && $1 !~ /Ts/ {print $1 "," $2}' >$deck.facts
    done
    check "rows with a buffer and a rope, ${motion%%\\n*}" close spring.rows buffer.rows
    check "facts with them" close spring.facts buffer.facts
    check 'each has its turn' sh -c "'$fourlink' -b open -f csv -c S.force,R.force buffer.deck | awk -F, 'NR > 1 && \$2 < 0 {a++; if (\$3 != 0) bad++} NR > 1 && \$3 > 1 {b++} END {exit bad || a < 5 || b < 5}'"
done
mistake '[spring]\nlink = rocker\nto = ground\nat = (1, 0) mm\nto_at = (0, 1) mm\nstiffness = 1 N/m\nonly = pushes\n' \
    '<stdin>:19: error: a spring that only pushes needs a free_length, below which it acts'

# T = k phi and k phi^2 / 2 over phi = theta2 - 180 deg, from -350 to 730 deg.
cat >wound.deck <<'END'
mechanism = slider-crank
[crank]
length = 50 mm
[rod]
length = 200 mm
[spring V]
link       = crank
to         = ground
stiffness  = 0.1 N m/rad
free_angle = 180 deg
[motion]
speed    = 10 rad/s
from     = -350 deg
to       = 730 deg
interval = 90 deg
END
{ cat wound.deck; printf '[sweep]\nspring V.stiffness = 0.1 N m/rad, 0.2 N m/rad\n'; printf 'output = mean(V.torque), mean(V.energy), min(V.energy)\n'; } >means.deck
"$fourlink" -f csv -b open means.deck >out 2>err
check 'means and extremes of a spring that is wound up' awk -F, '
    NR > 1 {
        pi = atan2(0, -1); a = -530 * pi / 180; b = 550 * pi / 180; k = $2
        T = k * (a + b) / 2; U = k * (b * b * b - a * a * a) / 6 / (b - a)
        if (($4 - T) ^ 2 > 1e-24 || ($5 - U) ^ 2 > 1e-22 || $6 > 1e-15) bad++
    }
    END {exit bad || NR != 3}' out

# Where a position turns round, its load is that of the way forward, whatever the rounding of its speed.
{
    printf 'mechanism = slider-crank\n[crank]\nlength = 50 mm\n[rod]\nlength = 200 mm\n[piston]\nmass = 1 kg\n[load L]\nlink = piston\n'
    printf 'over = x\nforce = 0 mm -50 N, 50 mm -30 N\nback = 10 N\n[gravity]\nacceleration = 0 m/s2\n'
    printf '[motion]\nspeed = 10 rad/s\nfrom = -360 deg\nto = 720 deg\ninterval = 180 deg\n'
} >turns.deck
"$fourlink" -f csv -b open -c theta2,F34x,a turns.deck 2>err | tr -d '\r' >out
check 'the load where the piston turns round' awk -F, '
    NR > 1 {w = NR % 2 ? 30 : 50; F = $3 + $4 # a points to the crank
        if ((F - w) ^ 2 > 1e-18) bad++}
    END {exit bad || NR != 8}' out

# A curve that the motion leaves says which value holds there; of speeds too, if the motion is given.
sed 's/^force = .*/force = 20 mm -100 N, 50 mm -300 N/; /^back/d' turns.deck >left.deck
"$fourlink" -b open -c theta2 left.deck >out 2>err
check 'a curve over x that is left' grep -qxF 'left.deck:11: note: x goes from 0 to 100 mm: before 20 and after 50 mm the value of the nearest point holds' err
sed 's/^link = piston/link = rod/; s/^force = .*/torque = 0 mm 1 N m, 100 mm 2 N m;back = 20 mm 3 N m, 50 mm 4 N m/' \
    left.deck | tr ';' '\n' >back.deck
"$fourlink" -b open -c theta2 back.deck >out 2>err
check 'a way back that is left' grep -qxF 'back.deck:12: note: x goes from 0 to 100 mm: before 20 and after 50 mm the value of the nearest point holds' err
sed 's/^force = .*/force = 0 mm -100 N, 100 mm -300 N/' left.deck >kept.deck
"$fourlink" -b open -c theta2 kept.deck >out 2>err
check 'one that is not' test "$(grep -c 'nearest point' err)" -eq 0
sed 's/^over = x/over = v/; s/^force = .*/force = -1 m\/s 100 N, 0.5 m\/s -300 N/' left.deck >fast.deck
"$fourlink" -b open -c theta2 -s motion.interval=10deg fast.deck >out 2>err
check 'a curve over v that is left' grep -q '^fast.deck:11: note: v goes from -0.515[0-9]* to 0.515[0-9]* m/s: before -1 and after 0.5 m/s the value' err

# A dead position is flagged before it is reached.
"$fourlink" -b open -i 0.1 "$data/me3491-exercise-1.deck" -s 'motion.from=110.48 deg' -s 'motion.to=110.6 deg' \
    -s 'motion.speed=100 rpm' >near
check 'near a dead position' grep -q '^# 110.48 deg: near a dead position' near
check 'beyond it' grep -q '^# 110.58 to 110.6 deg: not reached: B and D are too far apart' near

# Rubbing speeds of pins: radius times the difference of the angular speeds of the two links, at every degree.
rubs() { # DECK PINS: pins as NAME:RADIUS:HIGH:LOW, with 0 for the ground
    names=
    for pin in $2; do names=$names,rubbing_${pin%%:*}; done
    run 0 -f csv --units=SI -i '1 deg' -c "omega2,omega3${3-,omega4}$names" "$decks/$1"
    check "rubbing speeds of $1" awk -F, -v pins="$2" '
        NR == 1 {for (i = 1; i <= NF; i++) {sub(/ .*/, "", $i); at[$i] = i}; n = split(pins, pin, " "); next}
        {for (k = 1; k <= n; k++) {
            split(pin[k], p, ":")
            high = ("omega" p[3]) in at ? $at["omega" p[3]] : 0; low = p[4] ? $at["omega" p[4]] : 0
            d = $at["rubbing_" p[1]] - p[2] * (high - low)
            if (d * d > 1e-26 * (1 + high * high)) bad++
            rows++}}
        END {exit bad || rows < 700 * n}' out
}
rubs rubbing-four-bar.deck 'A:0.006:2:0 B:0.005:3:2 C:0.004:4:3 D:0.003:4:0'
rubs rubbing-lever.deck 'A:0.015:2:0 B:0.012:3:2 D:0.018:4:0'
rubs rubbing-piston.deck 'A:0.015:2:0 C:0.008:4:3' ''
# R. S. Khurmi and J. K. Gupta, Theory of Machines: crank 0.5 m, rod 2 m, 180 rpm clockwise at 45 deg
cat >rubbing.deck <<'END'
mechanism = slider-crank
[crank]
length = 0.5 m
[rod]
length = 2 m
[friction]
mu = 0
radius_A = 25 mm
radius_B = 30 mm
radius_C = 15 mm
[motion]
speed = -180 rpm
at = -45 deg
END
run 0 -f csv -b open -c omega3,rubbing_A,rubbing_B,rubbing_C rubbing.deck
check "by hand: $(tail -n 1 out)" awk -F, 'function near(x, y) {return x - y < 1e-12 && y - x < 1e-12}
    NR == 2 {w = 6 * 3.14159265358979323846; s = 0.5 * sin(3.14159265358979323846 / 4); w3 = w * 0.5 * cos(3.14159265358979323846 / 4) / sqrt(4 - s * s)
        exit !(near($2, w3) && near($3, -w * 0.025) && near($4, (w3 + w) * 0.03) && near($5, -w3 * 0.015))}' out
run 2 -c rubbing_A "$alvi"
says "the column 'rubbing_A' needs a [friction] section; the deck has none"
finish
