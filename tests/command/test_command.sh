# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_command.sh FOURLINK DATA - the command from outside: options, files, formats, exit status.
# Prints each failed check, and in the end "N passed, M failed".
. "$(dirname "$0")/../harness.sh"

cat >reach.deck <<'EOF'
title = A crank that cannot turn fully
mechanism = four-bar
[crank]
length = 300 mm
[coupler]
length = 400 mm
[rocker]
length = 500 mm
[ground]
length = 750 mm
[motion]
speed = 1 rad/s
interval = 40 deg
EOF
cat >engine.deck <<'EOF'
title = An engine
mechanism = slider-crank
[crank]
length = 300 mm
[rod]
length = 1.2 m
mass = 290 kg
cg = 0.8 m
inertia = 50 kg m2
[piston]
mass = 250 kg
[motion]
speed = 120 rpm
interval = 30 deg
EOF
cat >bad.deck <<'EOF'
mechanism = four-bar
[ground]
length = 80 mm
[crank]
length = -20 mm
[coupler]
lenght = 66 mm
[rocker]
length = 56 kg
EOF

# ------------------------------------------------------------------------- help, version, list

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

run 0 --list "$alvi"
quiet
for name in theta2 time omega2 alpha2 theta3 omega3 alpha3 theta4 omega4 alpha4 mu; do
    check "--list: $name" grep -q "^$name " out
done
check '--list: no forces without masses' none '^F12x ' out
check '--list: unit' grep -Eq '^omega4 +rad/s ' out
for name in thet phi velc; do
    check "--list: the source's $name" grep -qw "$name" out
done
mv out list
run 0 -l "$alvi"
same out list
run 0 -l "$matrix"
for name in F12x F14y Ts F34_dir power residual; do
    check "--list: $name" grep -q "^$name " out
done
run 0 -l engine.deck
for name in x v a phi N M14; do
    check "--list: $name" grep -q "^$name " out
done
check '--list: a slider-crank has no rocker' none '^theta4 ' out
run 0 -l "$alvi" -s 'units.angle=rad'
check '--list: unit of the deck' grep -Eq '^theta3 +rad ' out
# each name of the list is one that --columns takes
sed '1d;/^$/,$d' out | cut -d' ' -f1 >names
while read -r name; do
    run 0 -c "$name" "$alvi"
done <names

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
usage '--format must be table, csv or paper' --format=xml "$alvi"
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
refused "fourlink: --interval: error: '10 mm' is a length; expected an angle" -i '10 mm'
refused "fourlink: --interval: error: '1,5': the decimal mark" -i 1,5
refused 'fourlink: --interval: error: expected a value' -i ''
refused "fourlink: --interval: error: 'nan' is not a finite number" -i nan
refused 'fourlink: --branch: error: expected open, crossed or both' -b left
refused "did you mean 'crossed'?" --branch=crosed
refused "fourlink: --columns: error: unknown column 'theta5'" -c theta2,theta5
refused "did you mean 'omega3'?" -c omgea3
refused "fourlink: --columns: error: the column 'Ts' needs masses" -c Ts
refused "fourlink: --columns: error: the column 'x' is one of the other mechanism" -c x
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

# -------------------------------------------------------------------- exit status and messages

run 2 bad.deck
nothing
says 'bad.deck:5: error: the length must be positive, not -20 mm'
says "bad.deck:7: error: unknown key 'lenght' in [coupler]; did you mean 'length'?"
says "bad.deck:9: error: '56 kg' is a mass; expected a length"
lines err 4
cut -d: -f2 err >numbers
sort -n numbers >sorted
same numbers sorted
run 2 -c nonsense bad.deck # all mistakes in one run, those of the options as well
says 'bad.deck:5: error:'
says "fourlink: --columns: error: unknown column 'nonsense'"
for format in table csv paper; do
    run 2 -f $format bad.deck
    nothing
done
run 2 -l bad.deck
nothing
run 2 -m "$alvi"
nothing
says '--matrix'
run 2 -f paper engine.deck
nothing
says '--format=paper'

run 3 missing.deck
nothing
says 'missing.deck'
says 'No such file'
run 3 "$work"
nothing
says 'Is a directory'
: >empty.deck
run 2 empty.deck
nothing
says 'empty.deck:1: error:'
printf 'mechanism = four-bar\000\n' >null.deck
run 2 null.deck
nothing
says 'null.deck:1: error: a control character (0x00)'

# a row that cannot be computed
run 1 reach.deck
quiet
prints '# theta2 = 200 deg: the links do not reach: B and D are too far apart'
run 1 -f csv reach.deck
run 1 -f paper reach.deck
prints '# 200 deg, open: the links do not reach'
run 0 -s 'motion.from=-40 deg' -s 'motion.to=40 deg' reach.deck
run 1 -s 'motion.at=180 deg' reach.deck
run 1 -s 'motion.acceleration=-1 rad/s2' "$alvi" -s 'motion.speed=1 rad/s'
prints '# the crank comes to rest at'

# standard input
"$fourlink" <"$alvi" >out 2>err
check 'a deck on standard input' test $? -eq 0
same out table
"$fourlink" - <"$alvi" >out 2>err
same out table
"$fourlink" <bad.deck >out 2>err
check 'a bad deck on standard input' test $? -eq 2
nothing
says '<stdin>:5: error:'
cat "$alvi" | "$fourlink" -f csv - >out
same out csv
"$fourlink" <empty.deck >out 2>err
check 'nothing on standard input' test $? -eq 2
nothing
"$fourlink" <&- >out 2>err
check 'standard input closed' test $? -eq 3
nothing

# several decks, one of them bad: the others still run, and the status is the worst
run 0 -f csv "$alvi" engine.deck
check 'two decks' grep -q '^engine.deck,crossed,' out
for worst in '2 bad.deck' '3 missing.deck' '1 reach.deck'; do
    run ${worst%% *} -f csv "$alvi" ${worst#* } engine.deck
    check "alvi runs with $worst" grep -q "^$alvi,open,40,38.98" out
    check "engine runs with $worst" grep -q '^engine.deck,open,' out
done
run 3 missing.deck bad.deck reach.deck
says 'missing.deck'
says 'bad.deck:5'
prints 'A crank that cannot turn fully'
run 2 reach.deck bad.deck
run 3 -f csv bad.deck missing.deck
nothing
run 0 "$alvi" engine.deck
prints "# deck: $alvi"
prints '# deck: engine.deck'
holds 'four blocks, two blank lines apart' '
    /^$/ {blank++; next} {if (blank) {blocks++; if (blank != 2) bad = 1} blank = 0}
    END {exit bad || blocks != 3}'

# writing fails
if [ -c /dev/full ]; then
    for arguments in "$alvi" "-i 0.1 $alvi" "-f csv $alvi" --help --version "-l $alvi" "-m $matrix"; do
        "$fourlink" $arguments >/dev/full 2>err
        check "/dev/full: fourlink $arguments" test $? -eq 3
        says 'No space left on device'
    done
fi
"$fourlink" "$alvi" 2>err >&-
check 'standard output closed' test $? -eq 3
says 'standard output'

# ----------------------------------------------------------------------------------- --output

mkdir o
run 0 -o o/x "$alvi"
quiet
nothing
same o/x table
only_file o x
check 'the mode of a new file' test "$(ls -l o/x | cut -c1-10)" = -rw-r--r--
for form in '-oo/x' '--output=o/x' '--output o/x'; do
    rm o/x
    run 0 $form "$alvi"
    same o/x table
done
(umask 077 && "$fourlink" -o o/private "$alvi")
check 'the mode of a new file follows the umask' test "$(ls -l o/private | cut -c1-10)" = -rw-------
rm o/private

echo old >o/x
chmod 640 o/x
run 0 --output=o/x --format=csv "$alvi"
same o/x csv
check 'permissions are kept' test "$(ls -l o/x | cut -c1-10)" = -rw-r-----

# a failure leaves the old file, and none beside it
echo old >o/x
cp o/x old
run 2 -o o/x bad.deck
same o/x old
run 3 -o o/x missing.deck
same o/x old
usage '--format' -o o/x -f xml "$alvi"
same o/x old
(
    trap '' XFSZ
    ulimit -f 8
    exec "$fourlink" -o o/x -i 0.1 "$alvi" 2>>err
)
check 'a file that cannot grow' test $? -eq 3
same o/x old
only_file o x
# the file of a new name is not there at all
(
    trap '' XFSZ
    ulimit -f 8
    exec "$fourlink" -o o/new -i 0.1 "$alvi" 2>>err
)
check 'a new file that cannot grow' test $? -eq 3
only_file o x
"$fourlink" -o o/x -i 0.00001 "$alvi" 2>err &
pid=$!
sleep 0.3 2>/dev/null || sleep 1
kill $pid
wait $pid 2>/dev/null
same o/x old
only_file o x # also after a signal
rm -f o/x.*

# rows that could not be computed are results like others
run 1 -o o/x reach.deck
check 'rows that fail are written' grep -q '^# theta2 = 200 deg: ' o/x
# and so are the good decks beside a bad one
run 2 -o o/x "$alvi" bad.deck
check 'good decks are written' grep -q '38.9863' o/x

run 3 -o nowhere/x "$alvi"
says 'nowhere/x'
says 'No such file'
run 3 -o o "$alvi"
says 'Is a directory'
run 3 -o '' "$alvi"
only_file o x
check 'no temporary file here' test -z "$(ls -A | grep '^\.[A-Za-z0-9]')"
if [ "$(id -u)" -ne 0 ]; then
    mkdir locked
    echo old >locked/x
    chmod 444 locked/x
    run 3 -o locked/x "$alvi"
    says 'locked/x'
    same locked/x old
    chmod 644 locked/x
    chmod 555 locked
    run 3 -o locked/y "$alvi"
    says 'locked/y'
    only_file locked x
fi

# symbolic links are followed
mkdir links
echo old >links/target
ln -s target links/link
run 0 -o links/link "$alvi"
check 'a link stays a link' test -h links/link
same links/target table
ln -s absent links/dangling
run 0 -o links/dangling "$alvi"
check 'a link to nothing stays a link' test -h links/dangling
check 'the file it leads to is made' test -f links/absent
ln -s loop links/loop
run 3 -o links/loop "$alvi"
check 'a link to itself stays' test -h links/loop

# devices and pipes are written directly
mkfifo pipe
cat pipe >from_pipe &
run 0 -o pipe "$alvi"
wait $!
same from_pipe table
check 'a pipe stays a pipe' test -p pipe
# Not with the machine's own devices where a mistake of the program could replace them.
if [ ! -w /dev ]; then
    run 0 -o /dev/null "$alvi"
    nothing
    run 3 -o /dev/full "$alvi"
    says '/dev/full'
    says 'No space left on device'
    "$fourlink" -o /dev/stdout "$alvi" | cat >out
    same out table
fi
if [ -e /dev/fd/1 ]; then
    mkdir own
    ln -s /dev/fd/1 own/stdout # as /dev/stdout is
    "$fourlink" -o own/stdout "$alvi" | cat >out
    same out table
    {
        echo before
        "$fourlink" -o own/stdout "$alvi"
        echo after
    } >out 2>err
    {
        echo before
        cat table
        echo after
    } >expected
    same out expected
    check 'standard output is still a link' test -h own/stdout
    # the file that standard output is may have been deleted
    (rm deleted && exec "$fourlink" -o own/stdout "$alvi") >deleted 2>err
    check 'standard output, deleted, is still a link' test -h own/stdout
    only_file own stdout
fi

# a deck is not overwritten
cp "$alvi" mine.deck
ln -s mine.deck alias.deck
ln mine.deck hard.deck
for name in mine.deck ./mine.deck alias.deck hard.deck; do
    run 3 -o $name mine.deck
    says "$name"
    same mine.deck "$alvi"
done
run 3 -o mine.deck "$alvi" alias.deck
same mine.deck "$alvi"
"$fourlink" -o mine.deck <mine.deck >out 2>err
check 'the deck on standard input is not overwritten' test $? -eq 3
same mine.deck "$alvi"

# ------------------------------------------------------------------------------ format: table

cp table out
prints '# Crank-rocker of Alvi et al., section 5.1'
holds 'two blocks of ten rows, two blank lines apart' '
    /^$/ {blank++; next}
    {if (blank && blank != 2) bad = 1; if (blank) blocks++; blank = 0}
    /^#/ {next}
    {rows[blocks + 0]++}
    END {exit bad || blocks != 1 || rows[0] != 10 || rows[1] != 10}'
holds 'besides comments, numbers' '
    /^#/ || /^$/ {next}
    {for (i = 1; i <= NF; i++) if ($i !~ /^-?[0-9]+(\.[0-9]+)?(e[-+][0-9]+)?$/) bad = 1}
    END {exit bad}'
holds 'aligned' '/^#/ || /^$/ {next} {if (n++ && length != width) bad = 1; width = length} END {exit bad}'
holds 'names and units above each column' '
    /^# *theta2/ {names = NF - 1} /^# *deg/ {units = NF - 1} /^ *40 / && NF != names {bad = 1}
    END {exit bad || names != 8 || units != 8}'
holds 'each branch under its comment' '
    /^# branch: / {branch = $3} $1 == 40 {sign[branch] = $2 > 0 ? 1 : -1}
    END {exit !(sign["open"] == 1 && sign["crossed"] == -1)}'
# reference values of the equations solved by other means
run 0 -b open -s table.digits=9 "$alvi"
holds 'the row of 40 deg' '
    function near(x, y) {return x - y < 1e-6 && y - x < 1e-6}
    $1 == 40 {ok = near($2, 38.986348) && near($3, -3.1548742) && near($4, 20.9564894) &&
              near($5, 103.820765) && near($6, 0.0732971) && near($7, 56.4557805)}
    END {exit !ok}'
run 0 -b open -c theta2,F12x,F12y,F23x,F34y,F14x,F14y,Ts -s table.digits=9 "$matrix"
holds 'the forces at 40 deg' '
    function near(x, y) {return x - y < 1e-6 && y - x < 1e-6}
    $1 == 40 {ok = near($2, 7.06332168) && near($3, 8.4656654) && near($4, 7.14777808) &&
              near($5, 4.98155676) && near($6, -8.24612757) && near($7, -2.589694) &&
              near($8, 0.03138230954551688)}
    END {exit !ok}'

# constant_fields: the rows of the table have a field for each name above them.
constant_fields() {
    holds 'as many fields in each row as names above' \
        '/^# *theta2 +theta3 / {n = NF - 1} /^#/ || /^$/ {next} {rows++} NF != n {bad = 1}
        END {exit bad || n < 3 || rows < 2}'
}
run 1 reach.deck
constant_fields
holds 'a row that cannot be computed is a comment' '
    /^# theta2 = (160|200) deg: ./ {comments++} $1 == 160 || $1 == 200 {bad = 1}
    $1 == 40 {rows++}
    END {exit bad || comments != 4 || rows != 2}'
run 0 engine.deck
constant_fields
# a peak between the rows from which the widths of the columns are taken
cat >peak.deck <<'EOF'
mechanism = four-bar
[ground]
length = 80 mm
[crank]
length = 20 mm
[coupler]
length = 80.0000001 mm
[rocker]
length = 20 mm
[motion]
speed = 10 rad/s
interval = 0.1 deg
EOF
run 1 peak.deck
constant_fields
run 0 -s 'motion.speed=1e9 rad/s' "$matrix"
constant_fields
# 0 has no sign, in whichever form it is written
run 1 -s 'crank.length=300 mm' -s 'rod.length=100 mm' -s motion.interval=90 engine.deck
check 'no -0 in the table' none -Ee '-0(\.0*)?(e[-+]?[0-9]+)?( |$)' out
run 0 -s motion.speed=0 engine.deck
check 'no -0 in the table of a machine at rest' none -Ee '-0(\.0*)?(e[-+]?[0-9]+)?( |$)' out
run 0 -s 'motion.speed=0' "$alvi"
constant_fields
for units in 'length=in' 'angle=rad' 'angle=rev' 'angular_speed=rpm' 'force=kip' 'torque=N m'; do
    run 0 -s "units.$units" "$matrix"
    constant_fields
    holds 'a unit above each column' '/^# branch: open/ {getline; getline; exit !/^#/}'
done
run 0 -s 'motion.at=40 deg' "$alvi"
holds 'one instant, a row for each branch' '/^ *40 / {n++} !/^#/ && NF {rows++} END {exit n != 2 || rows != 2}'
run 0 -i 7 "$alvi"
holds 'the last row is the end of the range' '!/^#/ && NF {last = $1} END {exit last != 360}'
run 0 -i 0.1 "$alvi"
holds 'no rounding in the angles' '!/^#/ && NF && $1 !~ /^[0-9]+\.[0-9]$/ {bad = 1} END {exit bad}'

# -------------------------------------------------------------------------------- format: csv

cp csv out
check 'every line ends in CR LF' test "$(grep -c "$cr\$" out)" -eq "$(wc -l <out)"
check 'no other CR' test "$(tr -cd '\r' <out | wc -c)" -eq "$(wc -l <out)"
lines out 21
header='branch,theta2 (deg),theta3 (deg),omega3 (rad/s),alpha3 (rad/s2),theta4 (deg),omega4 (rad/s),alpha4 (rad/s2),mu (deg),status'
check 'the header' test "$(head -n 1 out)" = "$header$cr"
check 'one header' test "$(grep -c theta2 out)" -eq 1
tr -d '\r' <csv >out
holds 'fields, branches, status' '
    BEGIN {FS = ","} NF != 10 {bad = 1} NR > 1 && $10 != "ok" {bad = 1} NR > 1 {n[$1]++}
    END {exit bad || n["open"] != 10 || n["crossed"] != 10}'
holds '17 significant digits' '
    BEGIN {FS = ","}
    NR > 1 {for (i = 2; i < NF; i++) {
        if (sprintf("%.17g", $i) != $i) bad = 1
        digits = $i; gsub(/[-.]|e.*/, "", digits); if (length(digits) >= 16) long++}}
    END {exit bad || long < 100}'
check 'the row of 40 deg' grep -q '^open,40,38\.98634752[0-9]*,-3\.15487421[0-9]*,20\.956489[0-9]*,103\.8207648[0-9]*,' out

run 1 -f csv reach.deck
check 'empty cells and the reason' grep -q "^open,200,,,,,,,,the links do not reach: B and D are too far apart$cr\$" out
check 'numbers beside them' grep -q '^open,40,[-0-9.e]*,[-0-9.e]*,[-0-9.e]*,[-0-9.e]*,[-0-9.e]*,[-0-9.e]*,[-0-9.e]*,ok' out

# quoting, and one header for several decks
cp "$alvi" 'a "b", c.deck'
run 0 -f csv 'a "b", c.deck' engine.deck
check 'quotes' grep -q '^"a ""b"", c.deck",open,0,' out
check 'one header for both' test "$(grep -c theta2 out)" -eq 1
check 'its first column' grep -q '^deck,branch,theta2 (deg),' out
sed 's/^"[^,]*, c.deck"/A/' out | tr -d '\r' >plain
mv plain out
holds 'the union of the columns, empty where a deck has none' '
    BEGIN {FS = ","}
    NR == 1 {n = NF; for (i = 1; i <= NF; i++) at[$i] = i}
    NF != n {bad = 1}
    $1 == "A" && ($(at["x (m)"]) != "" || $(at["theta4 (deg)"]) == "") {bad = 1}
    $1 == "engine.deck" && ($(at["x (m)"]) == "" || $(at["theta4 (deg)"]) != "") {bad = 1}
    END {exit bad || !at["x (m)"] || !at["theta4 (deg)"] || at["status"] != n}'
"$fourlink" -f csv - engine.deck <"$alvi" >out
check 'standard input among several decks' grep -q '^<stdin>,open,40,38.98' out

# decks of different units share no column: none may be lost
number=0
for units in 'm:deg:rad/s:rad/s2:N:N m:W' 'mm:rad:rpm:rpm/s:kN:lbf ft:kW' \
    'cm:mrad:deg/s:deg/s2:lbf:lbf in:hp' 'in:rev:rev/s:rev/s2:kgf:kgf m:J/s'; do
    number=$((number + 1))
    echo "$units" | {
        IFS=: read -r length angle speed acceleration force torque power
        cat "$matrix"
        printf '[units]\nlength = %s\nangle = %s\nangular_speed = %s\nangular_acceleration = %s\n' \
            "$length" "$angle" "$speed" "$acceleration"
        printf 'force = %s\ntorque = %s\npower = %s\n' "$force" "$torque" "$power"
    } >units$number.deck
done
run 0 -f csv -c all units1.deck units2.deck units3.deck units4.deck
for column in 'Ts (N.m)' 'Ts (lbf.ft)' 'Ts (lbf.in)' 'Ts (kgf.m)' 'power (J/s)'; do
    check "the column $column of several decks" grep -qF ",$column," out
done

# ------------------------------------------------------------------------------ format: paper

# Alvi, section 5.1, its misprints mended: 103.821 at 40 deg; velb 3.26 for 3.20 at 120 deg; accb
# 23.99 for 23.93 at 160 and 200 deg; accb 22.42 for -22.42 at 280 deg.
tr ' ' '\t' >expected <<'EOF'
thet Vela acca phi beta velc velb Accc Accb
00 10.5 0.00 -110.74 -52.51 -3.50 -3.50 -37.58 18.56
00 10.5 0.00 110.74 52.51 -3.50 -3.50 37.58 -18.56
40 10.5 0.00 -126.30 -61.47 -4.06 -0.83 15.50 50.99
40 10.5 0.00 103.82 38.99 0.07 -3.15 56.46 20.96
80 10.5 0.00 -139.02 -58.74 -2.51 2.03 26.17 31.04
80 10.5 0.00 110.16 29.87 2.92 -1.62 27.30 22.42
120 10.5 0.00 -145.28 -48.22 -0.77 3.20 26.64 4.54
120 10.5 0.00 123.49 26.44 3.77 -0.20 -0.66 21.44
160 10.5 0.00 -144.69 -36.44 1.12 2.75 29.94 -16.40
160 10.5 0.00 136.77 28.52 2.96 1.32 -22.41 23.93
200 10.5 0.00 -136.77 -28.52 2.96 1.32 22.41 -23.93
200 10.5 0.00 144.69 36.44 1.12 2.75 -29.94 16.40
240 10.5 0.00 -123.49 -26.44 3.77 -0.20 0.66 -21.44
240 10.5 0.00 145.28 48.22 -0.77 3.20 -26.64 -4.54
280 10.5 0.00 -110.16 -29.87 2.92 -1.62 -27.30 -22.42
280 10.5 0.00 139.02 58.74 -2.51 2.03 -26.17 -31.04
320 10.5 0.00 -103.82 -38.99 0.07 -3.15 -56.46 -20.96
320 10.5 0.00 126.30 61.47 -4.06 -0.83 -15.50 -50.99
EOF
for form in '-f paper' -fpaper --format=paper '--format paper'; do
    run 0 $form "$alvi"
    quiet
    same out expected
done
run 0 -f paper -s units.angle=rad -s units.angular_speed=rpm "$alvi"
same out expected
grep -v "^[0-9]*${tab}10.5${tab}0.00${tab}-" expected >open
run 0 -f paper -b open "$alvi"
same out open
run 0 -f paper -s motion.at=40 -b open "$alvi"
lines out 2

# ----------------------------------------------------------------------------------- --matrix

run 0 --matrix "$matrix"
quiet
holds 'nine rows of nine coefficients, x and b, that hold: A x = b' '
    /^#/ || /^$/ {if (n && n != 9) bad = 1; if (n) blocks++; n = 0
                  if (/^$/) next
                  if (/theta2/) titles++
                  next}
    {if (NF != 11) bad = 1
     n++; x[n] = $10; b[n] = $11; for (j = 1; j <= 9; j++) A[n, j] = $j
     if (n == 9) for (i = 1; i <= 9; i++) {
         sum = 0; size = 0
         for (j = 1; j <= 9; j++) {t = A[i, j] * x[j]; sum += t; size += t < 0 ? -t : t}
         d = sum - b[i]; if (d < 0) d = -d
         if (d > 1e-5 * size + 1e-9) bad = 1
         if (size > 0) nonzero++}}
    END {if (n == 9) blocks++; exit bad || blocks != 20 || titles != 20 || nonzero != 180}'
prints 'F12x'
prints 'Ts'
run 0 -m -b open -s motion.at=40 "$matrix"
check 'x is the solution of the table' grep -Eq ' 7\.06332168 ' out
run 0 -m engine.deck
prints 'M14'
run 1 -m -s 'crank.mass=1 kg' reach.deck
prints 'branch: open: the links do not reach'

# -------------------------------------------------------------- the same everywhere, every time

for arguments in "-f csv -c all $matrix" "$matrix" "-m $matrix" "-f paper $alvi" "-c all engine.deck"; do
    "$fourlink" $arguments >first
    "$fourlink" $arguments >second
    check "something is printed: fourlink $arguments" test -s first
    same first second
    env LC_ALL=de_DE.UTF-8 "$fourlink" $arguments >second
    same first second
    env LC_ALL=fr_FR.UTF-8 LANG=tr_TR.UTF-8 LC_NUMERIC=de_DE.UTF-8 "$fourlink" $arguments >second
    same first second
    (cd / && exec env -i "$fourlink" $(echo "$arguments" | sed "s|engine.deck|$work/engine.deck|")) >second
    same first second
done
env LC_ALL=de_DE.UTF-8 "$fourlink" -i '2.5 deg' "$alvi" >second
"$fourlink" -i '2.5 deg' "$alvi" >first
same first second

# no number that is none, whatever the deck
finite() {
    "$fourlink" "$@" >out 2>err
    status=$?
    check "exit status $status: fourlink $*" test $status -le 2
    check "nan or inf: fourlink $*" none -Eiw -e '[-+]?(nan|inf|infinity)' out
}
long=$(awk 'BEGIN {printf "m"; for (i = 0; i < 60; i++) printf ".km4"; for (i = 0; i < 60; i++) printf "/km4"}')
for format in table csv paper; do
    for change in 'motion.speed=0' 'motion.speed=1e29 rad/s' 'motion.acceleration=1e29 rad/s2' \
        'motion.speed=-0' 'motion.speed=1e-300' 'crank.length=1e-14 m' 'crank.mass=1e29 kg' \
        'crank.inertia=1e29 kg m2' 'gravity.acceleration=0' 'crank.length=70 mm' \
        'ground.length=20 mm' 'coupler.length=80 mm' 'crank.length=1e14 m' 'motion.at=1e29 rad' \
        'motion.from=1e15' 'table.digits=17' 'load Tl.torque=1e29 N m' "units.length=$long" \
        'units.torque=N m' 'load Tl.force=1e29 N at 20 deg'; do
        finite -f $format -s "$change" "$matrix"
    done
done
finite -s "units.length=$long" engine.deck
finite -f csv -s "units.length=$long" engine.deck
run 0 -f csv -c all engine.deck
run 0 -f csv -c all -s 'motion.speed=0' -s 'rod.mass=0' -s 'rod.inertia=0' -s 'piston.mass=0' engine.deck
check 'a machine at rest without weight' none -Eiw 'nan|inf' out

# an angle beyond what can be computed is a mistake, not an empty table
run 2 -s 'motion.at=1e30 rad' "$alvi"
nothing

# Memory does not grow with the number of rows.  (A sanitizer needs more address space than this.)
if (ulimit -v 65536 && "$fourlink" "$matrix" >out) 2>err; then
    check 'a million rows in 64 MB' sh -c 'ulimit -v 65536 && exec "$0" -b open -i 0.00036 "$1" | wc -l | grep -q "^ *10000[0-9][0-9]"' "$fourlink" "$matrix"
fi

# Of extremes that are equal the first is told: over two revolutions, and over a clockwise one; angles are
# followed from the first row.
run 0 --summary --format=csv --columns=x,v,theta3 --branch=open --set 'motion.cycle=720 deg' \
    --set 'motion.to=720 deg' "$data/../tests/decks/engine.deck"
check 'max(x) of two revolutions' grep -q '^max(x),\(300\|299.9999\|300.0000\)[0-9]*,mm,1\(80\|79.9999\|80.0000\)[0-9]*,open' out
check 'min(v) of two revolutions' grep -q '^min(v),-16.566[0-9]*,m/s,286.8[0-9]*,open' out
run 0 --summary --format=csv --columns=x --branch=open --set 'motion.speed=-1000 rpm' \
    "$data/../tests/decks/engine.deck"
check 'max(x) clockwise' grep -q '^max(x),\(300\|299.9999\|300.0000\)[0-9]*,mm,-1\(80\|79.9999\|80.0000\)[0-9]*,open' out
run 0 --summary --format=csv --columns=theta4 "$data/me3491-exercise-1.deck"
check 'from the first row of a clockwise range' grep -q '^max(theta4),244.53[0-9]*,deg,-40.1[0-9]*,crossed' out

# A drag link's rocker turns with the crank: in a revolution by a whole turn, from -83.53 deg on.
printf 'mechanism = four-bar\n[ground]\nlength = 60 mm\n[crank]\nlength = 200 mm\n[coupler]\nlength = 180 mm\n' >drag.deck
printf '[rocker]\nlength = 130 mm\n[motion]\nspeed = 1 rad/s\n' >>drag.deck
run 0 --summary --format=csv --columns=theta4 --branch=open drag.deck
check 'max(theta4) of a drag link' grep -q '^max(theta4),276.467[0-9]*,deg,360,open' out
check 'min(theta4) of a drag link' grep -q '^min(theta4),-83.532[0-9]*,deg,0,open' out

finish
