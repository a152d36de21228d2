#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_sweeps.sh FOURLINK DATA - pictures of a sweep: outputs over the quantity that it varies.
. "$(dirname "$0")/../command/sweeps.sh"
block() { curve_of "$1" t.list; }

sweep 'motion.speed = 10 rad/s, 20 rad/s' 'crank.length & coupler.length = 18 mm & 60 mm, 20 mm & 66 mm, 22 mm & 70 mm' \
    'output = mu_min, max(Ts)'
run 0 -f csv -b open --units=mm t.deck
tr -d '\r' <out >designs
listed 0 t.list --plot-kind=columns -b open t.deck
quiet
for k in 0 1; do
    [ $k = 0 ] && block mu_min_open >points || block max_Ts__open >points
    check 'a curve for each speed' test "$(sed '/./!d' points | wc -l)" -eq 6 -a "$(grep -c '^$' points)" -eq 1
    check "the points of output $k" awk -v c=$((6 + k)) '
        NR == FNR {if (NF) {n++; x[n] = $1; y[n] = $2}; next}
        FNR > 1 {split($0, w, ","); m++; if ((w[3] - x[m]) ^ 2 > 1e-6 || (w[c] - y[m]) ^ 2 > 1e-4 * w[c] ^ 2) bad = 1}
        END {exit bad || n != m || n != 6}' points designs
done
check 'over the crank' grep -qx 'x crank.length (mm)' t.list
check 'lines' grep -qx 'key curve1 open' t.list
# designs in no order are points; a design without a value is a gap
sweep 'coupler.length = 66 mm, 62 mm, 70 mm' 'output = mu_min'
listed 0 t.list --plot-kind=columns -b open t.deck
check 'points' awk '/^curve/ {bad = 1} /^key mark / {n++} END {exit bad || !n}' t.list
sweep 'crank.length = 10 mm to 30 mm step 10 mm' 'coupler.length = 60 mm to 64 mm step 2 mm' 'output = swing'
listed 0 t.list --plot-kind=columns -b open -s 'sweep.crank.length = 10 mm, 40 mm' t.deck
check 'what does not swing has no point' test "$(grep -c '^mark black' t.list)" -eq 3

# a range is on the x axis, not a tolerance that changes faster
sweep 'crank.length = 20 mm to 40 mm step 5 mm' 'coupler.length = 66 mm +- 1 mm normal' 'samples = 8' 'output = mu_min, swing'
listed 0 t.list --plot-kind=columns -b open t.deck
check 'the range is on the x axis' grep -qx 'x crank.length (mm)' t.list
places() { awk '/^drawn/ {exit} /^mark/ {print $4}' t.list | sort -u | wc -l; }
check "places on it: $(places)" test "$(places)" -eq 5
sweep 'coupler.length = 66 mm +- 1 mm normal' 'samples = 8' 'output = mu_min'
listed 0 t.list --plot-kind=columns -b open t.deck
check 'a tolerance alone is' grep -qx 'x coupler.length (mm)' t.list
check 'the name of the deck is not cut' grep -q '^subtitle t.deck, ' t.list

# what is refused
sweep 'crank.length = 18 mm, 20 mm'
# without outputs `columns` draws those of the first design
listed 0 t.list --plot-kind=columns -c theta4 t.deck
check 'the first design' grep -q '^subtitle t.deck, first design of its sweep' t.list
sweep 'crank.length = 18 mm, 20 mm' 'output = type'
listed 2 t.list --plot-kind=columns t.deck
says 'no design of the [sweep] has a number to draw'
sweep 'crank.length = 18 mm' 'output = mu_min'
listed 2 t.list --plot-kind=columns t.deck
says 'the [sweep] has a single design'
sweep 'crank.length = 18 mm, 20 mm' 'output = mu_min'
listed 2 t.list --plot-kind=columns --plot-x=theta4 t.deck
says '--plot-x: error: the outputs of a [sweep] are drawn over what it varies'
# designs that are missing in the picture are told, unless the table does
sweep 'ground.length = 80 mm, 800 mm' 'output = max(Ts), mu_min'
listed 1 t.list --plot-kind=columns t.deck
nothing
says '2 of 4 lines of the [sweep] could not be computed'
listed 1 t.list --plot-kind=columns --output=t.txt t.deck
quiet
check 'the table' test -s t.txt
usage "did you mean 'columns'?" --plot=p.svg --plot-kind=column t.deck
usage "--plot-kind must be " --plot=p.svg --plot-kind=histogram t.deck

# a table of any number of columns beside the outputs
{ sed '/^\[expect\]/,$d; /^\[misprint\]/,$d' "$data/dfa-example-2.deck"; printf '[sweep]\ncrank.stroke = 200 mm, 210 mm\noutput = max(Ts)\n'; } >all.deck
listed 0 t.list --plot-kind=columns -s table.columns=all all.deck
check 'the output is drawn' test "$(grep -c '^curve' t.list)" -ge 1

# of many designs the spread, against the sorted values of each place: 31 x 15 designs
sweep 'crank.length = 10 mm to 25 mm in 31' 'coupler.length = 60 mm to 72 mm in 15' 'output = mu_min'
run 0 -f csv -b open --units=mm t.deck
tr -d '\r' <out | sed 1d | sort -t, -k3,3g -k5,5g >designs
listed 0 t.list --plot-kind=columns -b open t.deck
quiet
for size in least median greatest; do
    block mu_min_open_$size >points
    check "the $size of each place where the curve bends" awk -F'[, ]' -v size=$size '
        NR == FNR {x[FNR] = $1; y[FNR] = $2; n = FNR; next}
        {k[$3]++; v[$3, k[$3]] = $5}
        END {
            for (at in k)
                for (i = 1; i <= n; i++)
                    if ((at - x[i]) ^ 2 < 1e-7) {
                        wanted = v[at, size == "least" ? 1 : size == "median" ? (k[at] + 1) / 2 : k[at]]
                        found++
                        wrong += k[at] != 31 || (wanted - y[i]) ^ 2 > 1e-6 * wanted ^ 2
                    }
            exit wrong || found < 5 || found != n
        }' points designs
done
check 'no point is drawn' test "$(grep -c '^mark' t.list)" -eq 0
check 'the key of the spread' grep -qx 'key curve1 open, median' t.list
sweep 'crank.length = 10 mm to 25 mm in 500' 'output = mu_min'
listed 0 t.list --plot-kind=columns -b open t.deck
check 'a curve of 500 designs has no points' test "$(grep -c '^mark' t.list)" -eq 0 -a "$(grep -c '^key' t.list)" -eq 1

finish
