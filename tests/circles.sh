# SPDX-License-Identifier: GPL-3.0-or-later
#
# circles.sh NM OBJECT... - no circle of calls between the files of the command: a file calls those below it, whatever
# the headers declare.  Prints the files of a circle; exits with 1 if there is one.
set -u
nm=$1
shift

# FILE FILE: the first needs a name that the second defines
"$nm" -A "$@" | awk '
    {file = $1; sub(/\.(o|obj):.*/, "", file); sub(/.*fourlink_command\.dir\//, "", file)}
    $(NF - 1) == "U" {n++; from[n] = file; name[n] = $NF}
    $(NF - 1) ~ /^[TDRBVC]$/ {at[$NF] = file; n_defined++}
    END {
        for (i = 1; i <= n; i++)
            if (name[i] in at && at[name[i]] != from[i]) print from[i], at[name[i]]
        if (n_defined < 100) print "no-names objects\nobjects no-names" # a circle too
    }' | sort -u | tsort 2>&1 >/dev/null | grep -v 'contains a loop' && { echo '0 passed, 1 failed'; exit 1; }
echo '1 passed, 0 failed'
