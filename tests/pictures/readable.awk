# SPDX-License-Identifier: GPL-3.0-or-later
#
# readable.awk -v question=inside|apart|both SVG - the texts of a picture that go beyond its edge, or that stand on another;
# nothing if all can be read.  It needs svg.awk.
BEGIN {
    LETTER = 6.5 # pixels that a letter takes at least
    LINE = 9
}
/^<svg / {
    width = attribute($0, "width") + 0
    height = attribute($0, "height") + 0
}
/^<text/ && !/ transform=/ { # not those that are turned
    shown = words_of($0)
    if (shown ~ /^ *$/)
        next
    letters = shown
    gsub(/[\200-\277]/, "", letters)
    n++
    words[n] = shown
    place[n] = attribute($0, "x")
    y[n] = attribute($0, "y") + 0
    anchor = attribute($0, "text-anchor")
    left[n] = place[n] - LETTER * length(letters) * (anchor == "" ? 0 : anchor == "middle" ? 0.5 : 1)
    right[n] = left[n] + LETTER * length(letters)
}
function is_on(i, k) {
    return left[i] < right[k] && left[k] < right[i] && y[i] - y[k] < LINE && y[k] - y[i] < LINE
}
END {
    if (n <= 5 || width <= 100)
        print "hardly a text in " FILENAME
    for (i = 1; i <= n; i++) {
        if (question != "apart" && (left[i] < 0 || right[i] > width || y[i] <= 0 || y[i] >= height))
            print words[i] " is beyond the edge"
        for (k = 1; k < i; k++)
            if (question != "inside" && is_on(i, k) && (words[i] != words[k] || place[i] != place[k]))
                print words[i] " is on " words[k]
    }
}
