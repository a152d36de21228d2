# SPDX-License-Identifier: GPL-3.0-or-later
#
# items.awk [-v even=1] SVG - the items of a picture by their names, a line for each, with places in the units of its axes.
# `even`: curves over a quantity that only grows, or falls, at even steps.  It needs svg.awk.  LOOK is the class of a line.
#
#     picture WIDTH HEIGHT
#     title WORDS, subtitle WORDS
#     panel                               it begins
#     line|arrow LOOK X Y U V             of a drawing
#     upright LOOK X                      a line from the bottom of a diagram to its top
#     disc|quarter white|black X Y R      a centre of mass has four quarters
#     text left|center|right LOOK X Y WORDS        LOOK: curve1, halo, or -
#     mark black|open SIZE X Y            of a curve
#     note WORDS                          beside the axes
#     box WIDTH HEIGHT                    of the axes, in pixels
#     step X Y, range X0 X1 Y0 Y1         of the axes
#     name WORDS, x WORDS, y WORDS        of the panel, of its axes
#     curve NAME LOOK                     its places X Y, with blank lines in gaps, and `end`
#     key LOOK WORDS                      of curves, marks and areas
#     drawn                               the panel ends
BEGIN {
    STEPS = 720 # of a motion
    STILL = 60  # frames of a picture that moves
}

# The places of a path: kind, M or L, px and py; how many.
function read_places(path, part, xy, n, i, k) {
    gsub(/[ML]/, " &", path)
    n = split(path, part, " ")
    for (i = 1; i <= n; i++)
        if (part[i] ~ /^[ML]/) {
            split(substr(part[i], 2), xy, ",")
            kind[++k] = substr(part[i], 1, 1)
            px[k] = moved_x(xy[1], xy[2])
            py[k] = moved_y(xy[1], xy[2])
        }
    return k + 0
}

# Where the group of an element is in this frame: gone so far, and turned by an angle.
function find_group(i, frame) {
    gone_x = gone_y = turned = 0
    if (!group_of[i])
        return
    split(value_of(goes[group_of[i]], frame), way, ",")
    gone_x = way[1]
    gone_y = way[2]
    turned = value_of(turns[group_of[i]], frame) * atan2(0, -1) / 180
}
function value_of(list, frame, values, n) {
    n = split(list, values, ";")
    return values[frame > n ? n : frame]
}
function moved_x(x, y) {
    return gone_x + cos(turned) * x - sin(turned) * y
}
function moved_y(x, y) {
    return gone_y + sin(turned) * x + cos(turned) * y
}

# ---------------------------------------------------------------------------------------------- panel

function x_of(pixels) {
    return x0 + (pixels - left) / width * (x1 - x0)
}
function y_of(pixels) {
    return y1 - (pixels - top) / height * (y1 - y0)
}
function at(x, y) { # without -0
    x = x_of(x)
    y = y_of(y)
    return sprintf("%.9g %.9g", x == 0 ? 0 : x, y == 0 ? 0 : y)
}

function put_text(tag, line, class, name, words, x, y, axis, anchor, colour) {
    words = words_of(line)
    x = attribute(tag, "x")
    y = attribute(tag, "y") - 5
    if (name == "title" || name == "x" || name == "y")
        titles[name] = words
    else if (name == "x-number" || name == "y-number") {
        axis = substr(name, 1, 1)
        if (++numbers[axis] <= 2)
            tic[axis, numbers[axis]] = words
    } else if (name == "note") {
        noted[++notes] = words
    } else if (name == "key") {
        put_key(sample, words)
    } else {
        anchor = attribute(tag, "text-anchor")
        colour = match(class, /h-curve[0-9]+/) ? substr(class, RSTART + 2, RLENGTH - 2) : class ~ /halo/ ? "halo" : "-"
        print "text", (anchor == "" ? "left" : anchor == "end" ? "right" : "center"), colour, at(x, y), words
    }
}

function put_key(look, words) {
    if (!(look in key))
        keys[++n_keys] = look
    key[look] = words
}

function put_circle(tag, class, name, x, y, r, size, k) {
    x = moved_x(attribute(tag, "cx"), attribute(tag, "cy"))
    y = moved_y(attribute(tag, "cx"), attribute(tag, "cy"))
    r = attribute(tag, "r") + 0
    size = sprintf("%.9g", r / width * (x1 > x0 ? x1 - x0 : x0 - x1))
    if (name == "key")
        sample = "mark"
    else if (class ~ /mark/)
        print "mark", (class ~ /open/ ? "open" : "black"), r, at(x, y)
    else if (class ~ /centre/)
        for (k = 0; k < 4; k++)
            print "quarter", (k % 2 ? "white" : "black"), at(x, y), size
    else
        print "disc", (class ~ /open/ ? "white" : "black"), at(x, y), size
}

# A line of a drawing; `head`: the path of its arrow's head, or "".
function put_line(path, look, head, tip_x, tip_y, n, k, is_upright) {
    if (head != "") {
        read_places(head)
        tip_x = px[1]
        tip_y = py[1]
    }
    n = read_places(path)
    if (head != "") {
        px[n] = tip_x
        py[n] = tip_y
    }
    for (k = 1; k < n; k++) {
        is_upright = px[k] == px[k + 1] && look == "construction" && \
            (is_about(py[k], top) && is_about(py[k + 1], top + height) || is_about(py[k + 1], top) && is_about(py[k], top + height))
        if (is_upright)
            printf "upright %s %.6g\n", look, x_of(px[k])
        else
            print (head != "" && k == n - 1 ? "arrow" : "line"), look, at(px[k], py[k]), at(px[k + 1], py[k + 1])
    }
}

function is_about(x, y) {
    return x - y < 0.005 && y - x < 0.005
}

# --------------------------------------------------------------------------------------------- curves

# Keep a curve as a block of lines.
function keep_curve(path, look, name, n, i) {
    n = read_places(path)
    for (i = 1; i <= n; i++) {
        px[i] = x_of(px[i])
        py[i] = y_of(py[i])
    }
    gsub(/[[:punct:] ]|…/, "_", name)
    block[++curves] = name
    pen[curves] = look
    rows[curves] = even && is_function(n) ? even_rows(n) : own_rows(n)
}

# 1 if x only grows, or falls, along a curve of some length.
function is_function(n, i, is_rising) {
    is_rising = px[n] > px[1]
    for (i = 2; i <= n; i++)
        if (kind[i] == "L" && px[i] == px[i - 1] || px[i] != px[i - 1] && (px[i] > px[i - 1]) != is_rising)
            return 0
    return n >= 20
}

function own_rows(n, i, lines) {
    for (i = 1; i <= n; i++)
        lines = lines (i == 1 ? "" : kind[i] == "M" ? "\n\n" : "\n") sprintf("%.9g %.9g", px[i], py[i])
    return lines
}

function even_rows(n, from, to, k, i, x, low, high, slack, is_rising, lines, piece) {
    is_rising = px[n] > px[1]
    slack = 1e-9 * (px[n] < 0 ? -px[n] : px[n])
    for (from = 1; from <= n; from = to + 1) {
        for (to = from; to < n && kind[to + 1] == "L"; to++)
            ;
        low = (is_rising ? px[from] : px[to]) - slack
        high = (is_rising ? px[to] : px[from]) + slack
        piece = ""
        k = from
        for (i = 0; i <= STEPS; i++) {
            x = px[1] + (px[n] - px[1]) * i / STEPS
            if (x < low || x > high)
                continue
            while (k < to - 1 && x != px[k + 1] && (x > px[k + 1]) == is_rising)
                k++
            piece = piece (piece == "" ? "" : "\n") \
                sprintf("%.9g %.9g", x, py[k] + (x - px[k]) / (px[k + 1] - px[k]) * (py[k + 1] - py[k]))
        }
        if (piece != "")
            lines = lines (lines == "" ? "" : "\n\n") piece
    }
    return lines
}

# --------------------------------------------------------------------------------------------- panels

# A panel from its elements; of a picture that moves with the values of this frame.
function put_panel(frame, i, tag, class, look, name) {
    print "panel"
    n_keys = notes = curves = 0
    split("", key)
    split("", titles)
    split("", numbers)
    sample = ""
    for (i = 1; i <= elements; i++) {
        tag = tag_of(i, frame)
        find_group(i, frame)
        class = attribute(tag, "class")
        look = class
        sub(/ .*/, "", look)
        name = attribute(tag, "data-name")
        if (tag ~ /^<text/)
            put_text(tag, element[i], class, name)
        else if (tag ~ /^<circle/) {
            put_circle(tag, class, name)
            i += class ~ /centre/ # its black quarters
        } else if (name == "key")
            sample = look
        else if (look !~ /^(grid|axis|above|below)$/ && name != "")
            keep_curve(attribute(tag, "d"), look, name)
        else if (look !~ /^(grid|axis|above|below)$/ && i < elements && attribute(element[i + 1], "class") == "h-" look) {
            put_line(attribute(tag, "d"), look, attribute(tag_of(i + 1, frame), "d"))
            i++
        } else if (look !~ /^(grid|axis|above|below)$/)
            put_line(attribute(tag, "d"), look, "")
    }
    put_axes()
    put_curves()
}

# The tag of an element, with its values in this frame.
function tag_of(i, frame, tag, part, n, k, values) {
    n = split(element[i], part, "<animate ")
    tag = substr(part[1], 1, index(part[1], ">"))
    for (k = 2; k <= n; k++) {
        split(attribute(" " part[k], "values"), values, ";")
        match(tag, /^<[a-z]+/) # before its own value, where nothing moves
        tag = substr(tag, 1, RLENGTH) " " attribute(" " part[k], "attributeName") "=\"" values[frame] "\"" substr(tag, RLENGTH + 1)
    }
    return tag
}

function put_axes(i) {
    for (i = 1; i <= notes; i++)
        print "note", noted[i]
    printf "box %.9g %.9g\nstep %.7g %.7g\nrange %.9g %.9g %.9g %.9g\n", width, height, step("x"), step("y"), x0, x1, y0, y1
    if ("title" in titles)
        print "name", titles["title"]
    if ("x" in titles)
        print "x", titles["x"]
    if ("y" in titles)
        print "y", titles["y"]
}

# The step of the numbers of an axis; 0 if there is but one.
function step(axis) {
    return numbers[axis] > 1 ? tic[axis, 2] - tic[axis, 1] : 0
}

function put_curves(i) {
    for (i = 1; i <= curves; i++)
        print "curve", block[i], pen[i] "\n" rows[i] "\nend"
    for (i = 1; i <= n_keys; i++)
        print "key", keys[i], key[keys[i]]
    print "drawn"
}

/^<svg / {
    print "picture", attribute($0, "width"), attribute($0, "height")
}
/^<g class="panel"/ {
    if (heads == 2 && !panels++)
        print "title " head[1] "\nsubtitle " head[2]
    is_inside = 1
    elements = is_grouped = frames = 0
    gsub(/,/, " ")
    split(attribute($0, "data-box"), box, " ")
    split(attribute($0, "data-axes"), axes, " ")
    left = box[1]; top = box[2]; width = box[3]; height = box[4]
    x0 = axes[1]; x1 = axes[2]; y0 = axes[3]; y1 = axes[4]
    next
}
/^<g transform=/ { # what moves with a body
    is_grouped = 1
    rest = substr($0, index($0, "\"translate\""))
    goes[++groups] = attribute(rest, "values")
    turns[groups] = attribute(substr(rest, index(rest, "\"rotate\"")), "values")
    next
}
/^<\/g>/ && is_grouped {
    is_grouped = 0
    next
}
/^<\/g>/ {
    if (!frames)
        put_panel(1)
    for (i = 1; i <= frames - (frames > STILL); i++) # of a motion that repeats the last is the first
        put_panel(i)
    is_inside = 0
    next
}
is_inside {
    element[++elements] = $0
    group_of[elements] = is_grouped ? groups : 0
    if (index($0, "<animate "))
        frames = split(attribute(substr($0, index($0, "<animate ")), "values"), values, ";")
    next
}
/^<text/ { head[++heads] = words_of($0) }
