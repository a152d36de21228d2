# SPDX-License-Identifier: GPL-3.0-or-later
#
# svg.awk - functions that read the pictures of the command, which have one element a line.

# An attribute of a tag; "" if it has none.
function attribute(tag, name, rest) {
    name = " " name "=\""
    if (!index(tag, name))
        return ""
    rest = substr(tag, index(tag, name) + length(name))
    return unescaped(substr(rest, 1, index(rest, "\"") - 1))
}

function unescaped(words) {
    if (!index(words, "&"))
        return words
    gsub(/&lt;/, "<", words)
    gsub(/&gt;/, ">", words)
    gsub(/&quot;/, "\"", words)
    gsub(/&#39;/, "'", words)
    gsub(/&amp;/, "\\&", words)
    return words
}

# The words of an element, without the tags within.
function words_of(line) {
    gsub(/<[^>]*>/, "", line)
    gsub(/−/, "-", line)
    return unescaped(line)
}
