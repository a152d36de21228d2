#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_sample.sh FOURLINK DATA [all] - the sample calculations of chosen decks, evaluated from their printed numbers;
# with "all" those of every deck at more angles, and the reports are sound pages, each of both branches.
. "$(dirname "$0")/../harness.sh"

[ "${3-}" ] && angles='10 200 359' branches='open crossed' || angles=275 branches=crossed
# sample DECK ARGUMENT...: the report r-NUMBER.html, of all that check_sample.c checks
n=0
sample() {
    n=$((n + 1))
    "$fourlink" --report=r-$n.html "$@" 2>err
    status=$?
    check "exit status $status: $* $(cat err)" test $status -le 1
}
for deck in "$data"/*.deck "$decks"/*.deck; do
    case ${3-}$deck in
    */bad.deck | */mistakes.deck | */reach.deck) continue ;;
    all* | */shaper-by-slot.deck | */alvi-5.1.deck | */me3491-exercise-4.deck | */rubbing-lever.deck | */gerstmayr-run-up.deck | */oscillating-cylinder.deck | \
        */gas-engine.deck | */scotch-yoke-pump.deck) ;;
    *) continue ;;
    esac
    sample "$deck" --branch=open
    [ "${3-}" ] || continue
    # a yoke has one branch, and the range of an input is that of one; an output may not reach the other
    grep -q -e '^mechanism = scotch-yoke' -e '^input *=' -e '^\[output' "$deck" || sample "$deck" --branch=crossed
    "$programs/check_page" r-$n.html "$deck" >wrong 2>&1
    check "$deck: $(tail -n 3 wrong)" test ! -s wrong
done

# kinds, with and without offset, with an accelerated crank, at any angle
cat >norton.deck <<'END'
mechanism = inverted-slider-crank
[ground]
length = 200 mm
[crank]
length = 80 mm
mass = 0.1 kg
cg = 40 mm
[slider]
mass = 0.3 kg
cg = (-0.15, 0.01) m
inertia = 0.001 kg m2
[lever]
length = 130 mm
angle = 60 deg
mass = 0.15 kg
cg = 65 mm
inertia = 7e-4 kg m2
[load a]
link = slider
at = (-0.35, 0) m
force = (0, -100) N
torque = 3 N m
[load b]
link = lever
frame = link
at = (50, 10) mm
force = (20, -10) N
[motion]
speed = 10 rad/s
interval = 30 deg
END
sed 's/^length = 130 mm$/offset = 25 mm/; /^angle/d' norton.deck >offset.deck
printf 'mechanism = slider-crank\n[crank]\nlength = 30 mm\nmass = 1 kg\n[rod]\nlength = 100 mm\nmass = 2 kg\ncg = 40 mm\ngyration = 30 mm
[ground]\noffset = -20 mm\n[piston]\nmass = 3 kg\n[motion]\nspeed = 90 rpm\ninterval = 30 deg\n' >crank.deck
for deck in norton.deck offset.deck crank.deck ${3+"$matrix" "$alvi" "$decks/engine.deck" "$decks/pump.deck" "$data/crank-rocker-75.deck"}; do
    for branch in $branches; do
        for angle in $angles; do
            sample "$deck" --branch=$branch --plot-at="$angle deg" --set='motion.acceleration=7.5 rad/s2'
        done
    done
done
# other units than those of the deck: where they do not go together a result stands in both, with a factor for m a and P
for units in 'in, lbf' 'ft, slug, hp' 'cm, kN, kW' 'mm, kgf, rpm, m/s'; do
    for deck in norton.deck crank.deck ${3+"$alvi" "$data/me3491-exercise-4.deck" "$data/four-bar-on-a-ram.deck"}; do
        sample "$deck" --branch=open --units="$units"
    done
done
# the crank from an input, on both sides of it
sed '/^interval/d; /^\[expect\]/,$d' "$data/scotch-yoke-pump.deck" >yoke.deck
sed '/^interval/d' norton.deck >lever.deck
sed '/^interval/d' crank.deck >piston.deck
while read -r deck input at unit; do
    for side in rising falling; do
        sample $deck.deck --branch=open -s motion.input=$input -s "motion.at=$at $unit" -s "motion.speed=0.7 ${unit#m}/s" -s motion.side=$side
    done
done <<'END'
lever slide 180 mm
lever theta4 2.6 rad
piston x 20 mm
piston C.x 95 mm
yoke x 20 mm
yoke C.x -15 mm
END
# friction: the moments of pins, the force of a guide, also of one whose couple presses its edges
for deck in norton.deck offset.deck; do
    { cat $deck; printf '[friction]\nA = 0.1\nradius_A = 15 mm\nB = 8 %%\nradius_B = 10 mm\nD = 0.1\nradius_D = 9 mm\nguide = 0.1\nguide_length = 50 mm\n'; } >rubbed-$deck
done
{ cat crank.deck; printf '[load P]\nlink = piston\nforce = -900 N\n[friction]\nA = 0.1\nradius_A = 15 mm\nC = 0.08\nradius_C = 10 mm\nguide = 0.1\n'; } >rubbed-crank.deck
{ cat "$data/me3491-matrix.deck"; printf '[friction]\nA = 0.1\nradius_A = 5 mm\nB = 0.08\nradius_B = 4 mm\nC = 0.1\nradius_C = 3 mm\nD = 0.1\nradius_D = 2 mm\n'; } >rubbed-linkage.deck
for deck in rubbed-*.deck; do
    for branch in $branches; do
        for angle in $angles; do
            sample $deck --branch=$branch --plot-at="$angle deg" --set='motion.acceleration=7.5 rad/s2'
            check "friction of $deck" grep -q '<h3>Friction</h3>' r-$n.html
            case $deck in
            rubbed-linkage.deck) check 'it has no guide' none 'the guide has the force' r-$n.html ;;
            *) check 'its guide' grep -q 'the guide has the force μ |N|' r-$n.html ;;
            esac
            [ $deck != rubbed-crank.deck ] || check 'pin B does not rub' none 'Pin B has none' r-$n.html
        done
    done
done
check 'what s and h are' grep -q 'is h; θ₃ is the angle of the slide:' r-$n.html
# outputs of all types, also on one another and with a pin on a moving link
"$programs/random_decks" outputs ${3+6}8 . && "$programs/random_decks" slots ${3+6}8 .
for deck in outputs-*.deck slots-*.deck; do
    for angle in $angles; do
        sample $deck --branch=open --plot-at="$angle deg"
        grep -q 'id="equation-' r-$n.html || n=$((n - 1)) # it has no position there
    done
done
cat r-*.html >whole
for end in slider rocker; do
    for words in "drives the $end by its other pin" "runs in a slot of the $end" "Pin Q of the $end runs in a slot of the"; do
        check "an output: $words" grep -q "$words" whole
    done
done
check 'outputs that float' grep -q 'The pin D of the rocker, on the' whole
check 'an output on another' grep -q 'number 2: forces' whole
rm -f whole
rm -f "r-$((n + 1)).html"
"$programs/check_sample" r-*.html >checked 2>&1
check "$(head -n 5 checked)" test "$(sed 's/,.*//' checked)" = "$n samples"

fails() { ! "$@"; }
# the results are those of the table
PATH=$work/empty "$fourlink" --report=r.html "$data/me3491-matrix.deck" --plot-at='40 deg' -b open
check 'results of the reference' "$programs/check_sample" r.html omega3=-3.15487 omega4=0.0732971 alpha3=20.9565 \
    alpha4=56.4558 Ts=0.0313823 theta3=0.680440 theta4=1.81201

# the engine method is that of the columns, by the series too
for branch in open crossed; do
    for deck in "$data/dfa-example-2.deck" "$data/me3491-example-2.deck" "$data/khurmi-22.1.deck" crank.deck; do
        "$fourlink" --report=engine.html -b $branch "$deck" >out 2>err || check "$deck: $(cat err)" test $? -eq 1
        run 0 -f csv -b $branch -c theta2,piston_effort,rod_force,side_thrust,crank_effort,radial_force,T_piston,T_engine "$deck"
        at=$(sed -n 's/.*<p>At θ₂ = \([^,]*\)°, .*/\1/p' engine.html | sed 's/−/-/')
        values=$(tr -d '\r' <out | awk -F, -v at="$at" '$2 - at < 1e-9 && at - $2 < 1e-9 {print "F=" $3, "Frod=" $4, "FN=" $5, "FT=" $6, "FR=" $7, "Tpiston=" $8, "Tengine=" $9; exit}')
        check "the engine method of $deck at $at: $values" test "$values"
        check "the engine method of $deck at $at" "$programs/check_sample" engine.html $values
    done
done
check 'of an engine without gas, masses and loads there is none' fails grep -q 'Engine method' r-1.html

# Klein's construction, the flywheel by the facts, what drives
check 'Klein of an engine' grep -q "<h3>Klein's construction</h3>" engine.html
for deck in "$data/khurmi-16.11.deck" "$data/me3491-exercise-4.deck"; do
    "$fourlink" --report=wheel.html -b open "$deck" >out 2>err || check "$deck: $(cat err)" test $? -eq 1
    run 0 -f csv -b open -c energy_fluctuation,energy_coefficient "$deck"
    set -- $(tail -n 1 out | tr -d '\r' | tr ',' ' ')
    check "the flywheel of $deck: $*" "$programs/check_sample" wheel.html "ΔE=$2" Ce=$3
done
run 0 -f csv -b open -c flywheel_inertia,mean_power "$data/khurmi-16.11.deck"
set -- $(tail -n 1 out | tr -d '\r' | tr ',' ' ')
"$fourlink" --report=wheel.html -b open "$data/khurmi-16.11.deck" >out
check "the flywheel: $*" "$programs/check_sample" wheel.html If=$2 Pm=$3
for deck in rocker-driven lever-on-its-slide slide-by-trapezoids rod-end-at-speed boom-on-a-cylinder four-bar-on-a-ram; do
    "$fourlink" --report=driven.html -b open "$data/$deck.deck" >out 2>err
    check "what drives $deck" "$programs/check_sample" driven.html
    check "it is written: $deck" grep -q -e '<h3>What drives</h3>' driven.html
done

# programs, by each law, of places and of speeds, in each part of a law
for law in spline harmonic cycloidal 3-4-5 4-5-6-7 modified-sine cubic trapezoid linear; do
    for of in coordinate speed; do
        {
            sed '/^\[motion/,$d' "$alvi" | sed '/^\[load/,$d'
            echo '[motion]'
            [ $of = coordinate ] && echo 'program = 0 s 10 deg, 0.4 s 90 deg, 0.6 s 120 deg, 1 s 0 deg' ||
                printf 'program_of = speed\nprogram = 0 s 0 rpm, 0.4 s 30 rpm, 0.6 s 10 rpm, 1 s 20 rpm\n'
            printf 'law = %s\ntime_step = 0.05 s\n' $law
        } >program.deck
        for time in 0.02 0.35 0.55 0.95; do
            "$fourlink" --report=program-$law-$of-$time.html --plot-at="time = $time s" -b open program.deck >out 2>err ||
                check "$law of $of: $(cat err)" false
        done
    done
done
"$programs/check_sample" program-*.html >checked 2>&1
check "programs: $(head -n 5 checked)" test "$(sed 's/,.*//' checked)" = '72 samples'
check "with their laws: $(grep -l '<h3>Program</h3>' program-*.html | wc -l)" test "$(grep -l '<h3>Program</h3>' program-*.html | wc -l)" -ge 60
rm -f program-*.html

# friction is that of the columns
check 'no friction without its section' fails grep -q '<h3>Friction</h3>' r.html
sample rubbed-norton.deck --plot-at='95 deg' --branch=open
run 0 -f csv -b open -s 'motion.at=95 deg' -c friction_A,friction_B,friction_D,friction_guide,F34 rubbed-norton.deck
set -- $(tail -n 1 out | tr -d '\r' | tr ',' ' ')
check "friction of the columns: $*" "$programs/check_sample" r-$n.html MA=$2 MB=$3 MD=$4 Fguide=$5 F34=$6
check 'the loads of friction are written' grep -q 'guide, on the lever</th><td>[-0-9.]*</td>' r-$n.html

# those of outputs are those of the columns
"$programs/random_decks" outputs 3 . 1 && "$programs/random_decks" slots 3 . 2
check "$(cat compared 2>/dev/null)" sh "$decks/../report/samples.sh" "$fourlink" "$programs/check_sample" "$data/watt-six-bar.deck" \
    "$data/shaper-by-slot.deck" outputs-[123].deck slots-[234].deck >compared
"$fourlink" --report=wrong.html "$data/watt-six-bar.deck"
check 'an output without a mistake' "$programs/check_sample" wrong.html
for name in F,Px x,P; do
    sed "/\"symbols\"><math[^>]*><mrow><msub><mi>${name%,*}<\/mi><mtext>${name#*,}<\/mtext>/ {
        n
        s|<mn>\([0-9.]*\)</mn>\(</mrow>\)*<mtext>|<mn>1\1</mn>\2<mtext>|
    }" wrong.html >worse.html
    check "a wrong number of an output is found: $name" fails "$programs/check_sample" worse.html
done

# an error is found
sed 's|<mn>0.0732971</mn>|<mn>0.0733971</mn>|' r.html >wrong.html
check "a wrong number is found" fails "$programs/check_sample" wrong.html

"$fourlink" --report=r.html norton.deck --units='mm, kgf'
check 'm a in kgf' grep -q 'Masses are in[^a-z]*kg: m a and I α are divided by 9806.65, as 1[^a-z]*kgf = 9806.65[^a-z]*kg·mm/s²' r.html
sed 's|<mn>\([0-9.]*\)</mn>\(</mrow>\)*<mtext>\([^a-zN]*N·m\)</mtext>|<mn>1\1</mn>\2<mtext>\3</mtext>|' r.html >wrong.html
check "a wrong number in the unit of the tables is found" fails "$programs/check_sample" wrong.html

finish
