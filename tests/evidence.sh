#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# evidence.sh - the figures of the documents are those of runs: doc/evidence/trials.jsonl has the last run of each trial of
# tests/trials.txt, one line of JSON each.
#
#   evidence.sh record FILE TRIAL WHEN STATUS SECONDS SAID   a run; SAID is a file with its figures (trials.sh calls this)
#   evidence.sh write                                        the runs into doc/reliability.md and doc/accuracy.md
#   evidence.sh check                                        these are as `write` leaves them, and no other figure stands there
#   evidence.sh age [COMMITS]                                each trial has a run, none older than so many commits (200)
set -u
top=$(cd "$(dirname "$0")/.." && pwd)
runs=$top/doc/evidence/trials.jsonl
documents="$top/doc/reliability.md $top/doc/accuracy.md"
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
passed=0
failed=0

check() { # WHAT COMMAND...: it succeeds
    what=$1
    shift
    if "$@"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $what"
        return 1
    fi
}
finish() {
    echo "$passed passed, $failed failed"
    [ "$failed" -eq 0 ]
    exit
}

git() { command git -C "$top" "$@"; }
has_history() {
    command -v git >/dev/null && git rev-parse --git-dir >/dev/null 2>&1 && [ "$(git rev-parse --is-shallow-repository)" = false ]
}

# ----------------------------------------------------------------------------------------------- record

record() {
    file=$1 trial=$2 when=$3 status=$4 seconds=$5 said=$6
    has_history || { echo 'evidence.sh: no record: there is no history of commits' >&2 && return 0; }
    if ! git diff --quiet HEAD -- ':!doc'; then
        echo "evidence.sh: no record of $trial: the sources are not those of a commit" >&2
        return 0
    fi
    machine="$(uname -m), gcc $(gcc -dumpfullversion), GSL $(gsl-config --version)"
    {
        [ ! -f "$file" ] || grep -v "^{\"trial\":\"$trial\"," "$file"
        printf '{"trial":"%s","commit":"%s","date":"%s","run":"%s","machine":"%s","seconds":%d,"status":%d,"said":"%s"}\n' "$trial" \
            "$(git rev-parse --short=10 HEAD)" "$(date -u +%Y-%m-%d)" "$when" "$machine" "$seconds" "$status" \
            "$(sed 's/[\\"]/\\&/g' "$said" | awk '{printf "%s%s", (NR > 1 ? "\\n" : ""), $0}')"
    } | sort >"$work/runs"
    cp "$work/runs" "$file"
}

# ------------------------------------------------------------------------------------------------ write

# block NAME...: lines of these trials, or of all of them for `all`.  Numbers of five digits and more get commas.
block() {
    LC_ALL=C awk -v wanted=" $* " '
        function member(name,  t) {
            if (!match($0, "\"" name "\":")) return ""
            t = substr($0, RSTART + RLENGTH)
            if (t !~ /^"/) {sub(/[,}].*/, "", t); return t}
            match(t, /^"([^\\"]|\\.)*/)
            t = substr(t, 2, RLENGTH - 1)
            gsub(/\\n/, "\n", t)
            gsub(/\\/, "", t)
            return t
        }
        function with_commas(t,  out, n) {
            while (match(t, /[0-9.]+(e[-+]?[0-9]+)?/)) {
                n = substr(t, RSTART, RLENGTH)
                out = out substr(t, 1, RSTART - 1)
                t = substr(t, RSTART + RLENGTH)
                if (n ~ /^[0-9]+$/ && length(n) > 4) while (match(n, /^[0-9][0-9][0-9][0-9]+/))
                    n = substr(n, 1, RLENGTH - 3) "," substr(n, RLENGTH - 2)
                out = out n
            }
            return out t
        }
        function time(s) {return s < 120 ? s " s" : s < 7200 ? int(s / 60 + 0.5) " min" : sprintf("%.1f h", s / 3600)}
        function put(start, t,  n, word, i, l) { # in lines, which begin with so many spaces after the first
            n = split(t, word, " ")
            l = start
            gsub(/[^ ]/, " ", start)
            for (i = 1; i <= n; i++) {
                if (length(l word[i]) > 118) {print l; l = start}
                l = l (i > 1 && l != start ? " " : "") word[i]
            }
            print l
        }
        FNR == NR {run[member("trial")] = $0; next}
        /^[^ #]/ {
            name = what = $0
            sub(/:.*/, "", name)
            sub(/^[^:]*: */, "", what)
            if (wanted != " all " && !index(wanted, " " name " ")) next
            if (!(name in run)) {put("- ", "**" what "** (`" name "`): no run on record"); next}
            $0 = run[name]
            what = "**" what "** (`" name "`" (member("run") == "night" ? "" : ", shortened") ", " member("date") ", " member("commit") \
                ", " time(member("seconds") + 0) (member("status") + 0 ? ", failed" : "") ")"
            n = split(with_commas(member("said")), said, "\n")
            if (n > 3) {
                put("- ", what)
                for (i = 1; i <= n; i++) put("  - ", said[i])
            } else {
                for (i = 1; i <= n; i++) what = what (i > 1 ? "; " : ": ") said[i]
                put("- ", what)
            }
        }' "$runs" "$top/tests/trials.txt"
}

# written FILE: the document with the blocks of the present runs
written() {
    while IFS= read -r line; do
        printf '%s\n' "$line"
        case $line in '<!-- evidence: '*) ;; *) continue ;; esac
        names=${line#<!-- evidence: }
        block ${names% -->}
        while IFS= read -r line && [ "$line" != '<!-- end -->' ]; do :; done
        printf '%s\n' "$line"
    done <"$1"
}

# ------------------------------------------------------------------------------------------------ check

# Files of tests, sources and data by the names that a document may give them: "NAME FILE", and "TEST FILE" for a
# function of a file of tests.
index_names() {
    (
        cd "$top"
        find tests src include data -type f ! -name '*.svg' | awk '{
            print $0, $0
            name = $0
            while (sub(/^[^\/]*\//, "", name)) {print name, $0; stem = name; if (sub(/\.[a-z0-9]*$/, "", stem)) print stem, $0}}'
        grep -ro --include='*.c' '^TEST([a-z0-9_]*)' tests | sed 's/\(.*\):TEST(\(.*\))/\2 \1/'
        sed -n 's/.*add_long_trial(\([a-z0-9_]*\) .*/\1 tests\/CMakeLists.txt/p' tests/CMakeLists.txt
    )
}

# figures FILE: "FIGURE NAME..." for each number of a paragraph or an item outside of blocks and code, with the names
# there in back quotes.  Numbers of one or two digits are none.
figures() {
    LC_ALL=C awk '
        function flush(  t, names, n, figure) {
            t = text
            while (match(t, /`[^`]*`/)) {
                n = substr(t, RSTART + 1, RLENGTH - 2)
                gsub(/[^A-Za-z0-9_.*\/ -]/, "", n)
                names = names " " n
                t = substr(t, RSTART + RLENGTH)
            }
            gsub(/`[^`]*`|\]\([^)]*\)/, " ", text)
            while (match(text, /[0-9][0-9,]*(\.[0-9]+)?(e-?[0-9]+)?/)) {
                figure = substr(text, RSTART, RLENGTH)
                before = substr(text, 1, RSTART - 1)
                text = substr(text, RSTART + RLENGTH)
                gsub(/,/, "", figure)
                if (before !~ /[A-Za-z0-9_]$/ && text !~ /^[A-Za-z0-9_]/ && (length(figure) > 2 || figure ~ /e/)) print figure names
            }
            text = ""
        }
        /^```/ {code = !code; next}
        /^<!-- evidence: / {block = 1}
        /^<!-- end -->/ {block = 0; next}
        code || block {next}
        /^ *$/ || /^#/ || /^- / {flush()}
        !/^#/ {text = text " " $0}
        END {flush()}' "$1"
}

# stands FIGURE NAME...: it is in one of these
stands() {
    figure=$1
    shift
    for name; do
        case $name in
        _*) pattern="[a-z_]*$name" ;;
        *) pattern=$(printf '%s\n' "$name" | sed 's/[.]/\\./g; s/[*]/[^ ]*/g') ;;
        esac
        for file in $(sed -n "s|^$pattern \(.*\)|\1|p" "$work/index"); do
            grep -qF -e "$figure" "$top/$file" && return
        done
    done
    return 1
}

check_all() {
    check 'doc/evidence: a line is no run' test -z "$(grep -vE '^\{"trial":"[a-z-]+","commit":"[0-9a-f]+","date":"[0-9-]+","run":"(ci|short|night)","machine":".*","seconds":[0-9]+,"status":[0-9]+,"said":".*"\}$' "$runs")"
    trial_names >"$work/trials"
    check "doc/evidence: a trial is not in tests/trials.txt: $(run_names | comm -23 - "$work/trials" | tr '\n' ' ')" \
        test -z "$(run_names | comm -23 - "$work/trials")"
    index_names >"$work/index"
    for document in $documents; do
        written "$document" >"$work/written"
        check "${document#"$top"/} is not what the runs say: sh tests/evidence.sh write" cmp -s "$document" "$work/written"
        figures "$document" >"$work/figures"
        while read -r figure names; do
            set -f
            check "${document#"$top"/}: $figure stands in none of: $names" stands "$figure" $names
            set +f
        done <"$work/figures"
    done
}
trial_names() { sed -n 's/^\([a-z-]*\):.*/\1/p' "$top/tests/trials.txt" | sort; }
run_names() { sed 's/^{"trial":"\([a-z-]*\)".*/\1/' "$runs" | sort; }

# Each trial has a run, whose commit is in the history, and not far back.
check_age() {
    trial_names >"$work/trials"
    for trial in $(run_names | comm -13 - "$work/trials"); do
        check "$trial: no run on record: sh tests/nightly.sh $trial" false
    done
    has_history || { echo 'skipped: there is no history of commits' && exit 77; }
    sed 's/^{"trial":"\([a-z-]*\)","commit":"\([0-9a-f]*\)".*/\1 \2/' "$runs" >"$work/commits"
    while read -r trial commit; do
        check "$trial: its commit, $commit, is not in the history" git merge-base --is-ancestor "$commit" HEAD 2>/dev/null || continue
        age=$(git rev-list --count "$commit..HEAD")
        check "$trial: its last run is $age commits old: sh tests/nightly.sh $trial" test "$age" -le "$1"
    done <"$work/commits"
}

what=${1-}
[ $# -eq 0 ] || shift
case $what in
record) record "$@" ;;
write)
    for document in $documents; do
        written "$document" >"$work/written" && cp "$work/written" "$document"
    done
    ;;
check)
    check_all
    finish
    ;;
age)
    check_age "${1:-200}"
    finish
    ;;
*) echo 'usage: evidence.sh record|write|check|age' >&2 && exit 2 ;;
esac
