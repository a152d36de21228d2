#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_options.sh FOURLINK DATA - help, version, and the forms and values of the options.
. "$(dirname "$0")/../harness.sh"

for option in --help -h; do
    run 0 $option
    quiet
    prints 'Usage: fourlink [OPTION]... [DECK]...'
    for name in format output branch interval columns set matrix list help version; do
        prints "--$name"
    done
    prints 'Exit status: 0'
    holds 'the second line of the help is empty, the third a sentence' \
        'NR == 2 && $0 != "" {bad = 1} NR == 3 && !/^[A-Z].*[a-z]/ {bad = 1} END {exit bad}'
    holds 'no line of the help is longer than a screen is wide' 'length > 100 {bad = 1} END {exit bad}'
done
for option in --version -V; do
    run 0 $option
    quiet
    check 'version' grep -Eqx 'fourlink [0-9]+\.[0-9]+\.[0-9]+' out
done
run 0 --help nonexistent.deck
prints 'Usage:'

# ------------------------------------------------------------------------------------- options

run 0 "$alvi"
quiet
mv out table
for form in '-f table' -ftable --format=table '--format table' '-b both' -bboth --branch=both \
    '--branch both' -- '--'; do
    run 0 $form "$alvi"
    same out table
done
run 0 "$alvi" --format=table
same out table
run 0 --format=csv --format=table "$alvi" # the last one counts
same out table

run 0 --format=csv "$alvi"
quiet
mv out csv
differ csv table
for form in '-f csv' -fcsv '--format csv'; do
    run 0 $form "$alvi"
    same out csv
done

run 0 --interval='5 deg' "$alvi"
mv out expected
check '--interval has its effect' test "$(grep -vc '^#\|^$' expected)" -eq 146
run 0 -i '5 deg' "$alvi" && same out expected
run 0 -i5 "$alvi" && same out expected
run 0 --interval 5deg "$alvi" && same out expected
run 0 --set='motion.interval=5 deg' "$alvi" && same out expected
run 0 -s 'motion.interval=5 deg' "$alvi" && same out expected
run 0 -smotion.interval=5 "$alvi" && same out expected
run 0 --set 'Motion.INTERVAL = 0.0138888888888888888888888888888 rev' "$alvi"
check '--interval in revolutions' test "$(grep -vc '^#\|^$' out)" -eq 146

run 0 --branch=crossed "$alvi"
mv out expected
check '--branch=crossed' none 'branch: open' expected
run 0 -b crossed "$alvi" && same out expected
run 0 -bcrossed "$alvi" && same out expected
run 0 -s table.branch=crossed "$alvi" && same out expected

run 0 --columns=theta2,mu "$alvi"
mv out expected
check '--columns' grep -q '^# *theta2 *mu$' expected
for form in '-c theta2,mu' -ctheta2,mu '--columns theta2,mu' '-c Theta2,MU' '-s table.columns=theta2,mu'; do
    run 0 $form "$alvi"
    same out expected
done
run 0 -c 'theta2 mu' "$alvi" && same out expected
run 0 -c all "$matrix"
grep '^# *theta2 ' out | head -n 1 | tr -s '# ' '\n\n' | sed '/^$/d' >all
run 0 -l "$matrix"
sed '1d;/^$/,$d' out | cut -d' ' -f1 >listed
same all listed

run 0 --matrix "$matrix"
mv out expected
run 0 -m "$matrix" && same out expected
run 0 -mftable "$matrix" && same out expected
run 0 --matrix -b open "$matrix"
mv out expected
run 0 -mbopen "$matrix" && same out expected
run 0 -mb open "$matrix" && same out expected

cp "$alvi" ./-alvi.deck
run 0 -- -alvi.deck && same out table
run 2 -alvi.deck

usage "unknown option '--frobnicate'" --frobnicate "$alvi"
usage "unknown option '--formt'; did you mean '--format'?" --formt=csv "$alvi"
usage "unknown option '-z'" -z "$alvi"
usage "unknown option '-z'" -mz "$alvi"
usage '--format must be table, csv, json or paper' --format=xml "$alvi"
usage "'xml'" -f xml "$alvi"
usage '--format must be' --format= "$alvi"
usage '--format needs a value' "$alvi" --format
usage '-f needs a value' "$alvi" -f
usage '-o needs a value' "$alvi" -mo
usage '--matrix takes no value' --matrix=yes "$alvi"
usage '--help takes no value' --help=x
usage '--matrix' --matrix --format=csv "$matrix"
usage '--matrix' -mfpaper "$matrix"

# refused MESSAGE ARGUMENT...: the value is not one for the deck
refused() {
    message=$1
    shift
    run 2 "$@" "$alvi"
    nothing
    says "$message"
}
refused 'fourlink: --interval: error: the interval must be positive, not 0' -i 0
refused 'fourlink: --interval: error: the interval must be positive, not -10 deg' --interval='-10 deg'
refused 'fourlink: --interval: error: more than 10,000,000 rows by angle (3.6e14): give a larger interval or a shorter range' --list -i '1e-12 deg'
refused 'fourlink: --set: error: more than 10,000,000 rows by angle (20000001)' --list -s 'motion.interval=0.5 deg' -s 'motion.to=1e7 deg'
refused "fourlink: --interval: error: '10 mm' is a length; expected an angle" -i '10 mm'
refused "fourlink: --interval: error: '1,5': a comma as decimal mark: write 1.5" -i 1,5
refused 'fourlink: --interval: error: expected a value' -i ''
refused "fourlink: --interval: error: 'nan' is not a finite number" -i nan
refused 'fourlink: --branch: error: expected open, crossed or both' -b left
refused "did you mean 'crossed'?" --branch=crosed
refused "fourlink: --columns: error: unknown column 'theta5'" -c theta2,theta5
refused "fourlink: --columns: error: unknown column 'force13'; see --list" -c force13
refused "did you mean 'omega3'?" -c omgea3
run 2 -c torque "$matrix"
says "fourlink: --columns: error: unknown column 'torque'; did you mean 'Ts'?"
run 2 -c theta2,force12 "$matrix"
says "fourlink: --columns: error: unknown column 'force12'; did you mean 'F12'?"
refused "fourlink: --columns: error: the column 'Ts' needs masses" -c Ts
refused "fourlink: --columns: error: the column 'x' belongs to the slider-crank" -c x
refused 'fourlink: --columns: error: ' -c ''
refused 'fourlink: --columns: error: ' -c ,
refused "fourlink: --set: error: unknown section 'crnak'; did you mean 'crank'?" -s 'crnak.length=1'
refused "fourlink: --set: error: unknown key 'mas' in [crank]; did you mean 'mass'?" -s 'crank.mas=1'
refused 'fourlink: --set: error: expected [SECTION.]KEY=VALUE' -s crank
refused 'fourlink: --set: error: the length must be positive, not -1 mm' -s 'crank.length=-1 mm'
refused "fourlink: --set: error: unknown unit 'mmm'" -s 'crank.length=1 mmm'
run 2 -i 0 -b left -c nonsense "$alvi"
for option in --interval --branch; do
    says "fourlink: $option: error:"
done

finish
