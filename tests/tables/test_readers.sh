#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_readers.sh FOURLINK DATA READER - the format table as another program reads it, without options for comments:
# gnuplot, Octave, numpy.loadtxt; and pandas.
. "$(dirname "$0")/../harness.sh"

reader=$3
case $reader in
gnuplot) needs gnuplot gnuplot-nox ;;
octave) needs octave octave ;;
*) # a module of Python
    for python in python3 /usr/bin/python3; do
        "$python" -c "import $reader" >/dev/null 2>&1 && break
        python=
    done
    [ "$python" ] || {
        echo "skipped: $reader is not installed (Debian: python3-$reader)"
        exit 77
    }
    ;;
esac

# numbers FILE: its rows, columns and the sum of its last column, by awk; lines with # and blank lines apart.
numbers() {
    awk '/^#/ || !NF {next} n && NF != n {exit bad = 1}
        {n = NF; rows++; if ($NF != "nan" && $NF != "inf" && $NF != "-inf") sum += $NF}
        {for (i = 1; i <= NF; i++) if ($i !~ /^-?([0-9]+(\.[0-9]+)?(e[-+][0-9]+)?|inf|nan)$/) exit bad = 1}
        END {if (bad) print "no table"; else printf "%d %d %.6g\n", rows, n, sum}' "$1"
}

by_numpy() {
    "$python" -c "
import numpy
a = numpy.loadtxt('$1', ndmin=2)
c = a[:, -1]
print('%d %d %.6g' % (a.shape + (c[numpy.isfinite(c)].sum() + 0.0,)))"
}
by_pandas() {
    "$python" -c "
import pandas, numpy
a = pandas.read_csv('$1', sep=r'\s+', comment='#', header=None)
c = a.iloc[:, -1].to_numpy(dtype=float)
print('%d %d %.6g' % (a.shape + (c[numpy.isfinite(c)].sum() + 0.0,)))"
}
by_octave() {
    octave --no-gui --no-init-file --quiet --eval "
a = load('$1'); c = a(:, end);
printf('%d %d %.6g\n', rows(a), columns(a), sum(c(isfinite(c))) + 0)" 2>/dev/null
}
# gnuplot takes no nan or inf into its sum, and counts the other records
by_gnuplot() {
    gnuplot -e "set print '-'; stats '$1' using (abs(column($2)) < 1e300 ? column($2) : NaN) nooutput; print sprintf('%d %d %.6g', STATS_records + STATS_invalid, STATS_columns, STATS_sum)" 2>&1
}

# reads FILE: the program reads the same rows, columns and sum.
reads() {
    expected=$(numbers "$1")
    columns=$(echo "$expected" | cut -d' ' -f2)
    check "a table: $1: $expected" test "${expected#no}" = "$expected"
    result=$("by_$reader" "$1" "$columns" 2>&1)
    check "$1 by $reader: '$result', expected '$expected'" test "$result" = "$expected"
}

"$fourlink" -c theta2,theta4,F12x,Ts "$matrix" >rows
reads rows
"$fourlink" -c theta2,theta4,mu "$decks/reach.deck" >reach # with stretches that are not reached
reads reach
"$fourlink" -b open -i 0.1 -s 'motion.from=110.4 deg' -s 'motion.to=110.6 deg' -c theta2,mu \
    -s 'motion.speed=100 rpm' "$data/me3491-exercise-1.deck" >near # with words about a row that is there
reads near
"$fourlink" -c all "$data/me3491-example-2.deck" >all
reads all
"$fourlink" -i '120 deg' "$alvi" "$decks/reach.deck" -c theta2,mu >two
reads two

# sweep VALUES OUTPUT FILE
sweep() {
    { sed '/^interval/d' "$alvi" && printf '[sweep]\ncrank.length = %s\n%s\n' "$1" "$2"; } >sweep.deck
    "$fourlink" sweep.deck >"$3" 2>err
}
sweep '18 mm to 22 mm step 1 mm' 'output = swing, max(omega4), type, time_ratio, mu_min' designs
reads designs
check 'branch and type in their columns' awk '
    /^#/ {next}
    {n++; if ($1 != int((n + 1) / 2) || $3 != (n % 2 ? 1 : -1) || $6 != 1) bad = 1}
    END {exit bad || n != 10}' designs
sweep '20 mm, 300 mm, 50 mm' 'output = swing, type' odd # one is refused, one has no swing
check 'the reason in a line with #' grep -q '^# the crank, 300 mm, is longer' odd
reads odd
sweep '20 mm, 100 mm' 'output = type, swing' missing # the second does not swing
check 'nan' grep -q ' nan$' missing
reads missing
sweep '20 mm, 56 mm' '' each # rows of each design
reads each
{ cat "$alvi" && printf '[sweep]\nrocker.length = 10 mm, 56 mm\noutput = mu_min, max(omega4)\n'; } >bound.deck
"$fourlink" bound.deck >bound
check 'inf' grep -q ' inf$' bound
reads bound
"$fourlink" "$(dirname "$data")/doc/tolerance.deck" >tolerance
reads tolerance

# a title that looks like the head of Octave's own text files
sed 's/^title.*/title = name: matrix/' "$alvi" >title.deck
"$fourlink" -c theta2,mu title.deck >title
reads title
sed -e '/^interval/d' -e '$a [sweep]\ncrank.length = 20 mm, 30 mm\noutput = type' title.deck >types.deck
"$fourlink" types.deck >types
reads types

# gnuplot's index is the branch.
if [ $reader = gnuplot ]; then
    check 'a block for each branch' test "$(gnuplot -e "set print '-'; stats 'rows' using 2 index 1 nooutput; print STATS_records" 2>&1)" = \
        "$(awk '/^# branch: crossed/ {on = 1} on && !/^#/ && NF' rows | wc -l)"
fi

finish
