# SPDX-License-Identifier: GPL-3.0-or-later
#
# look.awk SVG - what is wrong with the colours of a picture on white paper, in colour or in grey; nothing if all is well.
#
# Contrast and luminance as in the Web Content Accessibility Guidelines 2.1: L = 0.2126 R + 0.7152 G + 0.0722 B of the
# linear components, contrast (1 + 0.05) / (L + 0.05).  Lightness is L* of CIE 1976, from 0 to 100.
function component(digits, x) {
    x = (16 * (index("0123456789ABCDEF", substr(digits, 1, 1)) - 1) + index("0123456789ABCDEF", substr(digits, 2, 1)) - 1) / 255
    return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ^ 2.4
}
/^\.fourlink \.[a-z0-9]+\{stroke:#/ {
    match($0, /\.[a-z0-9]+\{/)
    name = substr($0, RSTART + 1, RLENGTH - 2)
    match($0, /#......;/)
    colour = substr($0, RSTART + 1, 6)
    L = 0.2126 * component(substr(colour, 1, 2)) + 0.7152 * component(substr(colour, 3, 2)) + 0.0722 * component(substr(colour, 5, 2))
    contrast[name] = 1.05 / (L + 0.05)
    lightness[name] = 116 * L ^ (1 / 3) - 16
    width[name] = substr($0, index($0, "stroke-width:") + 13) + 0
    dashes[name] = match($0, /stroke-dasharray:[0-9,]+/) ? substr($0, RSTART, RLENGTH) : ""
}
function need_contrast(names, least, name, n, i) {
    n = split(names, name, " ")
    for (i = 1; i <= n; i++)
        if (!(name[i] in contrast) || contrast[name[i]] < least)
            printf "%s has a contrast of %.2f, expected %g\n", name[i], contrast[name[i]], least
}
function need_difference(one, other) {
    if (lightness[one] - lightness[other] < 10 && lightness[other] - lightness[one] < 10)
        print one " and " other " are equal in grey"
    if (width[one] - width[other] < 0.5 && width[other] - width[one] < 0.5)
        print one " and " other " are equally wide"
}
# How many of these differ, in dashes or with their widths.
function sorts(names, with_width, name, seen, n, i, found) {
    n = split(names, name, " ")
    for (i = 1; i <= n; i++)
        found += !seen[dashes[name[i]] (with_width ? " " width[name[i]] : "")]++
    return found
}
END {
    curves = "curve1 curve2 curve3 curve4 curve5 curve6"
    need_contrast("ground crank coupler follower force load construction result sense " curves, 4.5)
    need_contrast("path other leader", 3)
    need_difference("crank", "coupler")
    need_difference("crank", "follower")
    need_difference("coupler", "follower")
    if (sorts("force load result", 1) < 3)
        print "forces, loads and inertia have the same width and dashes"
    if (sorts(curves, 0) < 6)
        print "curves have the same dashes"
}
