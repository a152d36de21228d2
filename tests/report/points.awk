# SPDX-License-Identifier: GPL-3.0-or-later
#
# points.awk REPORT - in each table of a report the numbers of a column have their points below each other: what is kept free
# behind a number and its letters from the point on are together the same in a column.  Prints what is wrong, then
# "N numbers, M wrong"; fails if there is one that is wrong, or fewer than ten numbers.
{
    rest = $0
    while (match(rest, /<table|<tr>|<td class="number" style="--behind: -?[0-9]+">[^<]*|<td|<th/)) {
        part = substr(rest, RSTART, RLENGTH)
        rest = substr(rest, RSTART + RLENGTH)
        if (part == "<table")
            split("", width)
        else if (part == "<tr>")
            column = 0
        else
            column++
        if (part !~ /number/)
            continue
        kept = text = part
        sub(/.*--behind: /, "", kept)
        sub(/.*>/, "", text)
        own = kept + (index(text, ".") ? length(text) - index(text, ".") + 1 : 0)
        numbers++
        if (column in width && width[column] != own || kept + 0 < 0) {
            wrong++
            print "column " column ": " part ", " own " letters and not " width[column]
        }
        width[column] = own
    }
}
END {
    print numbers + 0 " numbers, " wrong + 0 " wrong"
    exit numbers < 10 || wrong > 0
}
