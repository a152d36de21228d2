# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_check.sh FOURLINK DATA - --summary and --check from outside: what they print, exit status.
# Prints each failed check, and in the end "N passed, M failed".
. "$(dirname "$0")/../harness.sh"

# csv OUT: the records of a csv file, its fields separated by |, which none of them has.  A record that
# is not RFC 4180 (quotes within a bare field, text after a closing quote, no CR LF) becomes "bad".
csv() {
    awk '{
        if (!sub(/\r$/, "")) {print "bad: no CR LF: " $0; next}
        line = $0; record = ""; bad = 0; first = 1
        while (1) {
            if (substr(line, 1, 1) == "\"") {
                field = ""; line = substr(line, 2)
                while ((i = index(line, "\"")) && substr(line, i + 1, 1) == "\"") {
                    field = field substr(line, 1, i); line = substr(line, i + 2)
                }
                if (!i) bad = 1
                field = field substr(line, 1, i - 1); line = substr(line, i + 1)
                if (line != "" && substr(line, 1, 1) != ",") bad = 1
            } else {
                i = index(line, ",")
                field = i ? substr(line, 1, i - 1) : line
                line = i ? substr(line, i) : ""
                if (index(field, "\"")) bad = 1
            }
            record = record (first ? "" : "|") field; first = 0
            if (line == "" || bad) break
            line = substr(line, 2)
        }
        print bad ? "bad: " $0 : record
    }' "$1"
}

cat >engine.deck <<'EOD'
title = An engine
mechanism = slider-crank
[crank]
length = 100 mm
[rod]
length = 300 mm
[piston]
mass = 3 kg
[gas]
bore = 100 mm
indicator = 0 deg 1 bar, 20 deg 30 bar, 90 deg 6 bar, 180 deg 1 bar, 540 deg 1 bar, 660 deg 3 bar
[motion]
speed = 120 rpm
cycle = 720 deg
interval = 40 deg
[flywheel]
fluctuation = 0.02
EOD
cat >good.deck <<'EOD'
mechanism = slider-crank
[crank]
length = 100 mm
[rod]
length = 300 mm
[motion]
speed = 120 rpm
[expect]
n = 3.0
stroke = 200 mm
type = slider-crank, the crank turns fully
[expect]
at = 90 deg
phi = 19.47 deg
[misprint]
n = 4
EOD

# ---------------------------------------------------------------------------- --summary, table

for form in -S --summary; do
    run 0 $form "$alvi"
    quiet
done
prints '# Crank-rocker of Alvi et al., section 5.1'
holds 'the type in words' '$1 == "type" && /crank-rocker$/ {ok = 1} END {exit !ok}'
holds 'limits of both branches, with unit and crank angle' '
    function near(x, y) {return x - y < 1e-7 && y - x < 1e-7}
    $1 == "theta4_max" && $3 == "deg" && $5 == "open" {
        open = near($2, 145.906609189) && near($4, 223.031532078)}
    $1 == "theta4_max" && $3 == "deg" && $5 == "crossed" {
        crossed = near($2, -103.818044198) && near($4, 320.778684351)}
    END {exit !(open && crossed)}'
holds 'extremes of the columns' '
    function near(x, y, d) {return x - y < d && y - x < d}
    $1 == "min(theta4)" && $5 == "open" {ok = near($2, 103.818044198, 1e-8) && near($4, 39.2213156, 1e-5)}
    $1 == "max(mu)" {mu++}
    $1 == "max(theta2)" || $1 == "max(F12x)" {bad = 1}
    END {exit !ok || mu != 2 || bad}'
holds 'no rows' '/^ *[-0-9.]/ {bad = 1} END {exit bad}'
run 0 -S -b crossed -c mu "$alvi"
check 'one branch' none -w open out
holds 'the columns that are chosen' '/^(max|min)\(/ {n++} END {exit n != 2}'
# coarse or fine, at the same angles
run 0 -S -i 40 "$alvi"
cp out coarse
run 0 -S -i 3 "$alvi"
same out coarse
run 0 -S -o summary "$alvi"
nothing
same summary coarse
"$fourlink" -S -i 40 <"$alvi" >out
same out coarse

run 0 -S engine.deck
for fact in n stroke inner_dead_centre outer_dead_centre mean_torque mean_power energy_fluctuation \
    energy_coefficient flywheel_inertia flywheel_fluctuation 'max(Ts)' 'min(x)'; do
    holds "the fact $fact, twice at most" '$1 == "'"$fact"'" {n++} END {exit n < 1 || n > 2}'
done
holds 'power = torque x speed, dE = I Cs omega^2, dE = coefficient x torque x cycle' '
    function close_to(x, y) {return x != 0 && (x - y) / x < 1e-9 && (y - x) / x < 1e-9}
    /crossed/ {next} {value[$1] = $2}
    END {pi = atan2(0, -1); w = 4 * pi
         exit !(close_to(value["mean_power"], value["mean_torque"] * w) &&
                close_to(value["energy_fluctuation"], value["flywheel_inertia"] * 0.02 * w * w) &&
                close_to(value["energy_fluctuation"],
                         value["energy_coefficient"] * value["mean_torque"] * 4 * pi) &&
                value["mean_torque"] > 0 && value["flywheel_fluctuation"] == 0.02)}'
# no forces are asked for by the columns, and the turning moment is there all the same
run 0 -S -c x,v engine.deck
prints 'mean_torque'
check 'no extremes of other columns' none -F 'max(Ts)' out
run 0 -S -s 'motion.acceleration=1 rad/s2' engine.deck
check 'no turning moment of an accelerated crank' none -E 'torque|energy|flywheel' out
run 0 -S "$alvi" engine.deck
check 'each deck under its name' test "$(grep -c '^# deck: ' out)" -eq 2
run 3 -S missing.deck engine.deck
prints 'mean_torque'

# ------------------------------------------------------------------------------ --summary, csv

run 0 -S -f csv -b open -c theta4 "$alvi"
quiet
csv out >records
cp records out
check 'RFC 4180' none '^bad' out
check 'the header' test "$(head -n 1 out)" = 'name|value|unit|theta2|branch'
holds 'five fields' 'BEGIN {FS = "|"} NF != 5 {bad = 1} END {exit bad || NR < 10}'
check 'the type' grep -qx 'type|crank-rocker|||' out
holds 'a limit' '
    BEGIN {FS = "|"} function near(x, y) {return x - y < 1e-11 && y - x < 1e-11}
    $1 == "theta4_min" {ok = near($2, 103.8180441982515182) && $3 == "deg" &&
                             near($4, 39.22131564862997612) && $5 == "open"}
    END {exit !ok}'
holds '17 digits' '
    BEGIN {FS = "|"} NR > 2 && sprintf("%.17g", $2) != $2 {bad = 1} length($2) > 16 {long++}
    END {exit bad || long < 5}'
run 0 -S -f csv engine.deck
csv out >records
check 'a comma in a fact is quoted' grep -qx 'type|slider-crank, the crank turns fully|||' records
check 'the quotes' grep -q '^type,"slider-crank, the crank turns fully",,,' out
check 'the end of the lines' test "$(grep -c "$cr\$" out)" -eq "$(wc -l <out)"
cp engine.deck 'a "b", c.deck'
run 0 -S -f csv "$alvi" 'a "b", c.deck'
csv out >records
cp records out
check 'RFC 4180, with names of decks' none '^bad' out
check 'a column deck' test "$(head -n 1 out)" = 'deck|name|value|unit|theta2|branch'
check 'one header' test "$(grep -c 'name|value' out)" -eq 1
check 'its name' grep -q '^a "b", c.deck|mean_torque|' out
holds 'six fields' 'BEGIN {FS = "|"} NF != 6 {bad = 1} END {exit bad}'
# the same numbers in both formats
run 0 -S -f csv -b open engine.deck
csv out >records
run 0 -S -b open engine.deck
awk 'NR == FNR {split($0, field, "|"); if (field[1] != "type") value[field[1]] = field[2]; next}
    /^#/ || $1 == "type" {next}
    {d = $2 - value[$1]; if (d < 0) d = -d; if (d > 1e-10 * (value[$1] < 0 ? -value[$1] : value[$1])) bad = 1
     n++}
    END {exit bad || n < 10}' records out
check 'the same numbers as a table and in csv' test $? -eq 0

# --------------------------------------------------------------------------------------- --check

for form in -C --check; do
    run 0 $form good.deck
    quiet
done
lines out 6
check 'a line for each' grep -Eq '^ok +good.deck:9: n = 3\.0, computed 3, open$' out
check 'with its unit' grep -Eq '^ok +good.deck:10: stroke = 200 mm, computed 0\.2 m, open$' out
check 'in words' grep -Eq '^ok +good.deck:11: type = .*, computed slider-crank, the crank turns fully, open$' out
check 'with its angle' grep -Eq '^ok +good.deck:14: phi = 19\.47 deg, computed 19\.4712206345 deg at 90 deg, open$' out
check 'a misprint' grep -Eq '^misprint confirmed +good.deck:16: n = 4, computed 3, open$' out
check 'the sum' test "$(tail -n 1 out)" = '# ok: 4, misprint confirmed: 1, differs: 0, not a misprint: 0, no value: 0'

sed 's/^stroke = 200/stroke = 210/; s/^n = 4/n = 3/' good.deck >wrong.deck
run 1 -C wrong.deck
quiet
check 'what differs' grep -q '^differs  *wrong.deck:10: ' out
check 'what is no misprint' grep -q '^not a misprint  *wrong.deck:16: ' out
check 'the sum' test "$(tail -n 1 out)" = '# ok: 3, misprint confirmed: 0, differs: 1, not a misprint: 1, no value: 0'
sed 's/^stroke = 200/stroke = 210/' good.deck >differs.deck
run 1 -C differs.deck
sed 's/^n = 4/n = 3/' good.deck >no-misprint.deck
run 1 -C no-misprint.deck
# the same physics, another deck
run 1 -C -s 'rod.length=310 mm' good.deck
check 'a changed deck' grep -q '^differs  *good.deck:9: ' out
"$fourlink" -C <wrong.deck >out 2>err
check 'standard input' test $? -eq 1
prints '<stdin>:10: stroke'

# exit status 2: nothing to compare, or not to be compared: no value, and why
run 2 -C "$alvi"
nothing
says "$alvi:1: error: nothing to check"
sed 's/^stroke/strok/' good.deck >unknown.deck
run 2 -C unknown.deck
check 'no value, and the others' grep -q '^no value  *unknown.deck:10: strok' out
says "unknown.deck:10: error: 'strok' is no column and no fact of this deck"
sed 's/^phi = 19.47 deg/phi = 19.47 mm/' good.deck >unit.deck
run 2 -C unit.deck
check 'no value, and the others' grep -q '^no value  *unit.deck:14: phi' out
says "unit.deck:14: error: '19.47 mm' is a length; expected an angle"
run 2 -C -s 'crank.length=2 m' good.deck
check 'no value where the rod does not reach' grep -q '^no value  *good.deck:14: ' out
says 'good.deck:14: error: no value at theta2 = 90 deg, open: the rod does not reach'
run 3 -C missing.deck
says 'missing.deck'
run 0 -C -o report good.deck
nothing
"$fourlink" -C good.deck >out
same out report

# ---------------------------------------------------------------------------------- --check=FILE

cat >answers <<'EOD'
# the answers
[expect]
n = 3.0
[misprint]
stroke = 22 cm
EOD
for form in --check=answers "--check=$work/answers"; do
    run 0 $form good.deck
    quiet
done
lines out 3
prints "answers:3: n = 3.0, computed 3, open"
prints "misprint confirmed"
check 'in place of those of the deck' none good.deck out
run 0 --check=answers wrong.deck # which has other expectations of its own
sed '/^\[expect\]/,$d' good.deck >plain.deck
run 0 --check=answers plain.deck
run 2 --check=answers -C plain.deck # the last one counts: the deck's own, of which there are none
sed 's/22 cm/20 cm/' answers >wrong-answers
run 1 --check=wrong-answers good.deck
prints 'not a misprint'
run 1 --check=answers -s 'rod.length=200 mm' good.deck

# a missing file, and one that is a folder
run 3 --check=missing good.deck
nothing
says 'fourlink: cannot read missing: No such file or directory'
run 3 --check=. good.deck
nothing

# bad lines in it
cat >bad <<'EOD'
[expect]
strok = 200 mm
n = three
[crank]
length = 200 mm
[expect]
stroke
at = 5 mm
EOD
run 2 --check=bad good.deck
nothing
says 'bad:4: error: expected [expect] or [misprint] in this file, not [crank]'
says "bad:7: error: expected 'key = value' or '[section]', not 'stroke'"
says "bad:8: error: '5 mm' is a length; expected an angle"
cat >bad <<'EOD'

[expect]
xyzzy = 200 mm
n = three
EOD
run 2 --check=bad good.deck
check 'no value of both' test "$(grep -c '^no value' out)" -eq 2
says "bad:3: error: 'xyzzy' is no column and no fact of this deck"
says "bad:4: error: expected a number, such as 0.02, not 'three'"
echo 'n = 3' >bad
run 2 --check=bad good.deck
nothing
check 'a value before the first section, with its line' grep -q '^bad:1: error: ' err
printf '# nothing\n\n' >bad
run 2 --check=bad good.deck
nothing
says 'bad:1: error: nothing to check'
printf '[expect]\n\001 = 3\n' >bad
run 2 --check=bad good.deck
check 'a control character, with its line' grep -q '^bad:2: error: ' err
: >bad
run 2 --check=bad good.deck
says 'bad:1: error: nothing to check'
# carriage returns, a byte order mark, no end of the last line
printf '\357\273\277[expect]\r\nn = 3.0\r\nstroke = 200 mm' >answers-dos
run 0 --check=answers-dos good.deck
prints '# ok: 2,'

# -------------------------------------------------------------------------------- --check, csv

run 1 -C -f csv wrong.deck
quiet
check 'the end of the lines' test "$(grep -c "$cr\$" out)" -eq "$(wc -l <out)"
csv out >records
cp records out
check 'RFC 4180' none '^bad' out
lines out 6
check 'the header' test "$(head -n 1 out)" = \
    'file|line|result|name|theta2|branch|unit|printed|computed|tolerance'
holds 'ten fields' 'BEGIN {FS = "|"} NF != 10 {bad = 1} END {exit bad}'
check 'a difference' grep -Eqx 'wrong.deck\|10\|differs\|stroke\|\|open\|m\|210 mm\|0\.(2|19999999999999[0-9]*|200000000000000[0-9]*)\|0\.000(5|500000000000[0-9]*|49999999999[0-9]*)' out
check 'words' grep -qx 'wrong.deck|11|ok|type||open||slider-crank, the crank turns fully|slider-crank, the crank turns fully|' out
check 'an angle' grep -Eqx 'wrong.deck\|14\|ok\|phi\|90\|open\|deg\|19\.47 deg\|19\.4712206[0-9]*\|0\.00(5|50000000[0-9]*|499999[0-9]*)' out
check 'no misprint' grep -Eqx 'wrong.deck\|16\|not a misprint\|n\|\|open\|1\|3\|(3|2\.99999999999999[0-9]*)\|0\.5' out
run 0 -C -f csv good.deck
run 2 -C -f csv unknown.deck
check 'no half of a report' none -F 'good.deck|' out

# several decks and one file of answers, as a class is marked
mkdir class
for name in anna ben 'c, "d"'; do cp plain.deck "class/$name.deck"; done
sed 's/300 mm/310 mm/' plain.deck >class/ben.deck
run 1 --check=answers -f csv class/anna.deck class/ben.deck 'class/c, "d".deck'
csv out >records
cp records out
check 'RFC 4180, names with commas and quotes' none '^bad' out
lines out 7
check 'a column deck' test "$(head -n 1 out)" = \
    'deck|file|line|result|name|theta2|branch|unit|printed|computed|tolerance'
check 'Anna' grep -q '^class/anna.deck|answers|3|ok|n|' out
check 'Ben' grep -q '^class/ben.deck|answers|3|differs|n|' out
check 'c, "d"' grep -q '^class/c, "d".deck|answers|3|ok|n|' out
holds 'two lines each' 'BEGIN {FS = "|"} NR > 1 {n[$1]++} END {for (d in n) if (n[d] != 2) bad = 1; exit bad}'
run 0 --check=answers -f csv class/anna.deck 'class/c, "d".deck'
# each deck is graded whatever becomes of the others; the status is the worst
sed 's/100 mm/100 mn/' plain.deck >class/broken.deck
run 2 --check=answers -f csv class/broken.deck class/ben.deck class/anna.deck
says 'class/broken.deck:3: error: '
csv out >records
check 'the others' test "$(grep -c '^class/anna.deck|\|^class/ben.deck|' records)" -eq 4
run 3 --check=answers -f csv class/missing.deck class/ben.deck class/anna.deck
csv out >records
check 'the others' test "$(grep -c '^class/anna.deck|\|^class/ben.deck|' records)" -eq 4
run 1 --check=answers class/anna.deck class/ben.deck
check 'each under its name' test "$(grep -c '^# deck: class/' out)" -eq 2
check 'a sum for each' test "$(grep -c '^# ok: ' out)" -eq 2
# answers from standard input, or a pipe, which can be read but once
"$fourlink" --check=- class/anna.deck <answers >out 2>err
check 'answers on standard input' test $? -eq 0
prints 'n = 3.0'
"$fourlink" --check=- class/anna.deck 'class/c, "d".deck' <answers >out 2>err
status=$?
check "answers on standard input for two decks: $(head -n 1 err)" test $status -eq 0
check 'both are graded' test "$(grep -c 'n = 3.0' out)" -eq 2

# ------------------------------------------------------------------------- a file for each deck

for deck in "$data"/*.deck; do
    expect=${deck%deck}expect
    if [ -e "$expect" ]; then
        run 0 "--check=$expect" "$deck"
    else
        run 0 --check "$deck"
    fi
    quiet
    holds "values of $deck" '/^(ok|misprint confirmed) / {n++} /^(differs|not)/ {bad = 1} END {exit bad || !n}'
done
for expect in "$data"/*.expect; do
    check "the deck of $expect" test -e "${expect%expect}deck"
done
# two branches, nine angles, six columns
run 0 "--check=$data/alvi-5.1.expect" "$alvi"
holds 'the printout of the paper is compared whole' '/^(ok|misprint confirmed) / {n++} END {exit n != 108}'
run 1 "--check=$data/alvi-5.1.expect" -s 'coupler.length=67 mm' "$alvi"
run 1 -C -s 'coupler.mass=0.31 kg' "$data/me3491-matrix.deck"

# ------------------------------------------------------------------------- option conflicts

for pair in '-C -S' '-C -m' '-C -l' '-S -m' '-S -l' '--check=answers --summary' '-CS' '-SC'; do
    run 2 $pair good.deck
    nothing
    says 'exclude each other'
done
for option in -C -S --check=answers; do
    run 2 -f paper $option "$alvi"
    nothing
    says 'formats table and csv'
done
run 2 --summary=yes good.deck
says '--summary takes no value'
# an empty name is a shell variable that is not set, not the deck's own values
run 2 --check= good.deck
run 2 --chek good.deck
says "did you mean '--check'?"

# ------------------------------------------------------------------- the same everywhere

for arguments in "-S engine.deck" "-S -f csv engine.deck" "-C good.deck" "-C -f csv good.deck"; do
    "$fourlink" $arguments >first
    "$fourlink" $arguments >second
    check "something is printed: fourlink $arguments" test -s first
    same first second
    env LC_ALL=de_DE.UTF-8 "$fourlink" $arguments >second
    same first second
done
# no number that is none
for change in 'motion.speed=0' 'motion.speed=1e29 rad/s' 'crank.length=2 m' 'ground.offset=199 mm' \
    'motion.at=40 deg' 'motion.run_up=90 deg' 'rod.length=1e14 m' 'piston.mass=1e29 kg' \
    'flywheel.fluctuation=1e-29' 'motion.cycle=0.1 deg' 'crank.length=300 mm' \
    'units.energy=MN m' 'motion.to=0' 'gas.bore=1e-14 m'; do
    "$fourlink" -S -s "$change" engine.deck >out 2>err
    status=$?
    check "exit status $status: -S -s $change" test $status -le 2
    check "nan or inf: -S -s $change" none -Eiw -e '[-+]?(nan|inf|infinity)' out
done

# An angle of [expect] is another position in another turn where a cycle takes two, or where one change
# point lets the links come back on the other side.
cat >four-stroke.deck <<'DECK'
mechanism = slider-crank
[crank]
length = 5 cm
[rod]
length = 20 cm
[gas]
bore = 100 mm
indicator = 0 deg 1 bar, 20 deg 30 bar, 180 deg 1 bar, 380 deg 2 bar, 540 deg 1 bar
[motion]
speed = 10 rad/s
cycle = 720 deg
to = 720 deg
[expect]
at = 20 deg
gas_force = 23561.94 N # 30 bar on pi/4 (10 cm)^2
[expect]
at = 380 deg
gas_force = 1570.796 N # 2 bar
[expect]
at = 740 deg
gas_force = 23561.94 N
DECK
run 0 --check four-stroke.deck
run 2 --check -s motion.to=360 four-stroke.deck
says 'does not reach'
cat >change-point.deck <<'DECK'
mechanism = four-bar
[ground]
length = 60 mm
[crank]
length = 50 mm
[coupler]
length = 70 mm
[rocker]
length = 40 mm
[motion]
speed = 1 rad/s
to = 720 deg
[table]
branch = open
columns = theta2, theta4
DECK
run 1 -f csv change-point.deck # the change points themselves have no row
for angle in 40 400; do
    value=$(awk -F, -v x=$angle '$2 == x {print $3}' out)
    printf '[expect]\nat = %s deg\nbranch = open\ntheta4 = %.6f deg\n' $angle "$value" >>change-point.deck
done
check 'two positions' test "$(sed -n 's/^theta4 = //p' change-point.deck | sort -u | wc -l)" -eq 2
run 0 --check change-point.deck

# The facts stand in --list, behind the columns.
run 0 --list "$alvi"
for fact in type K theta2_from mu_min theta4_max swing time_ratio; do
    holds "$fact in the list" "/^fact/ {on = 1} on && \$1 == \"$fact\" {n++} END {exit n != 1}"
done

finish
