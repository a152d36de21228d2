#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_sweep_mistakes.sh FOURLINK DATA - mistakes in [sweep] and --part, options that a sweep does
# not take.
. "$(dirname "$0")/sweeps.sh"

first=$(($(wc -l <single.deck) + 1)) # the line of [sweep]

# bad LINE MESSAGE SWEEP...: exit 2 with this message, and no other, at the line of t.deck, counted
# from [sweep]
bad() {
    line=$(($1 + first))
    message=$2
    shift 2
    sweep "$@"
    run 2 -f csv t.deck
    nothing
    says "t.deck:$line: error: $message"
    check "more than one message for '$*': $(tail -n 1 err)" test "$(wc -l <err)" -eq 1
}
good='crank.length = 18 mm to 22 mm step 1 mm'
toleranced='crank.length = 20 mm +- 1 mm'

bad 1 "unknown key 'lenght' in [crank]; did you mean 'length'?" 'crank.lenght = 1 mm, 2 mm'
bad 1 "unknown section 'crnk'; did you mean 'crank'?" 'crnk.length = 1 mm, 2 mm'
bad 1 'there is no [point Q] in the deck' 'point Q.at = 1 mm'
bad 1 "unknown key 'mechanism' in [sweep]" 'mechanism = 1'
bad 1 "'crank.cg' has parts: vary its .x, .y, .size or .angle" 'crank.cg = 30 mm, 40 mm'
bad 1 "'crank.length' has no parts that can be varied" 'crank.length.x = 30 mm, 40 mm'
bad 1 "'load W.force' is not in the deck: give it before you vary a part of it" 'load W.force.size = 1 N, 2 N'
bad 1 "'1 kg' is a mass; expected an angle" 'crank.cg.angle = 1 kg, 2 kg'
bad 2 "'crank.cg.y' does not go with another part that varies: use x and y, or size and angle" 'crank.cg.size = 1 mm, 2 mm' 'crank.cg.y = 3 mm, 4 mm'
for key in table.columns sweep.samples expect.x units.length; do
    sweep "$key = 1, 2"
    run 2 t.deck
    nothing
    says "t.deck:$((first + 1)): error: '$key' is not a quantity that can be varied"
done
bad 1 "'1 kg' is a mass; expected a length" 'crank.length = 1 kg, 2 kg'
bad 1 'expected a length' 'crank.length = 18 mm, , 20 mm'
bad 1 "unknown key 'length' in [sweep]; a quantity is named with its section" 'length = 18 mm, 20 mm'
bad 1 "expected a tolerance, such as 0.1 mm or 0.5 %, not ''" 'crank.length = 18 mm +-' 'samples = 2'
bad 1 'a tolerance applies to one value, not to a list or a range' 'crank.length = 18 mm, 20 mm +- 1 mm' 'samples = 2'
bad 1 'a tolerance applies to one value, not to a list or a range' 'crank.length = 18 mm to 20 mm step 1 mm +- 1 mm' 'samples = 2'
bad 1 'a tolerance in per cent needs a value other than 0' 'ground.angle = 0 deg +- 1 %' 'samples = 2'
bad 1 'a range needs its step' 'crank.length = 18 mm to 22 mm'
for range in '18 mm .. 22 mm' '18:1:22 mm' '18 mm - 22 mm'; do
    bad 1 "a range needs 'to' and its step, '20 mm to 30 mm step 2 mm', or the number" "crank.length = $range"
done
bad 1 'the step does not lead' 'crank.length = 18 mm to 22 mm step 0 mm'
bad 1 'the step does not lead' 'crank.length = 18 mm to 22 mm step -1 mm'
bad 1 'the number of values of a range' 'crank.length = 18 mm to 22 mm in 1'
bad 1 'the tolerance, 30 mm, is not smaller than the length, 20 mm' 'crank.length = 20 mm +- 30 mm' 'samples = 3'
bad 1 'the tolerance must be positive, not 0 mm' 'crank.length = 20 mm +- 0 mm' 'samples = 3'
bad 1 'the tolerance must be positive, not -1 mm' 'crank.length = 20 mm +- -1 mm' 'samples = 3'
bad 1 'more than 10,000,000 rows by angle (3.6e14): give a larger interval' 'motion.interval = 1e-12 deg, 2e-12 deg' 'output = mu_min'
bad 0 "a tolerance needs 'samples = NUMBER'" "$toleranced"
bad 2 "'samples' needs a tolerance" "$good" 'samples = 3'
bad 2 'the samples must be positive, not 0' "$toleranced" 'samples = 0'
bad 2 'the samples must be positive, not -4' "$toleranced" 'samples = -4'
bad 2 "expected a whole number, not '1.5'" "$toleranced" 'samples = 1.5'
bad 2 "expected a whole number, not '0.5'" "$toleranced" 'samples = 0.5'
bad 3 'the seed must not be negative: -1' "$toleranced" 'samples = 3' 'seed = -1'
bad 1 "'sweep.crank.length' is not a quantity that can be varied" 'sweep.crank.length = 20 mm to 30 mm step 2 mm'
bad 2 '[sweep] is given twice; first at line' "$good" '[sweep]' "$good"
bad 0 '[sweep] varies nothing' ''
bad 0 '[sweep] varies nothing' 'output = swing'
bad 2 "'crank.length' is given twice" "$good" "$good"
bad 0 'more than 4e9 designs' 'crank.length = 18 mm to 22 mm in 100000' 'rocker.length = 50 mm to 60 mm in 100000'
bad 2 "'mu_mn' is neither a fact nor the max(), min(), mean() or rms() of a column of this deck; did you mean 'mu_min'?" "$good" 'output = swing, mu_mn'
bad 2 "'max(Tx)' is neither a fact nor the max(), min(), mean() or rms()" "$good" 'output = max(Tx)'
for column in mu Ts theta2 time omega2; do # those of the crank, too, have many values
    bad 2 "'$column' has a value in each row: use its max(), min(), mean() or rms()" "$good" "output = $column"
done

sweep "$good"
for part in 5/4 0/4 1/0 x 1 1/ /4 -1/4 1.5/4 1/4x ''; do
    run 2 --part="$part" t.deck
    nothing
    says '--part'
    says "$part"
done
run 2 --part=1/2 single.deck
nothing
says 'single.deck:1: error: --part needs a [sweep]'
cp t.deck u.deck
run 2 --part=1/2 -c mu_min t.deck u.deck
says '--part takes one deck, not several'
run 2 t.deck u.deck
nothing
says "of several decks a [sweep] has to have values, by output or --columns='max(Ts), crank.length'"
for option in --matrix --summary --format=paper --check; do
    run 2 $option t.deck
    nothing
    says 't.deck:1: error: '
done
printf '[expect]\nmu_min = 58\n' >answers
run 2 --check=answers t.deck
nothing
says 't.deck:1: error: --check, --expect, --matrix and --summary work for one design of a [sweep], with --design=N'

finish
