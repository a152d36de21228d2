# SPDX-License-Identifier: GPL-3.0-or-later
#
# csv_difference.awk - compares the csv of two machines or versions:
#
#   awk [-v most=TOLERANCE] [-v without=COLUMNS] -f csv_difference.awk FILE OTHER
#
# Prints "same", "within" or "differs", the number of values, and the largest difference of a value, divided by the
# largest value of its column.  More than TOLERANCE (2e-12) differs, and so do other words.  COLUMNS are names, with
# a blank between them, whose values are not compared.  Angles are compared modulo 360 deg; the residual, which is
# rounding itself, has the largest value 1, and that of the energy, which has the error of the integration, 10.
function size(x) { return x < 0 ? -x : x }

function is_number(x) { return x ~ /^-?[0-9.]+(e[-+]?[0-9]+)?$/ }

BEGIN {
    FS = ","
    most = most == "" ? 2e-12 : most + 0
    while (more1 = (getline line1 <ARGV[1]) > 0) {
        if ((getline line2 <ARGV[2]) <= 0)
            bad = 1
        sub(/\r$/, "", line1)
        sub(/\r$/, "", line2)
        n = split(line1, x)
        if (split(line2, y) != n)
            bad = 1
        if (!rows++)
            n_names = split(line1, names)
        for (i = 1; i <= n; i++) {
            name = names[i]
            sub(/ .*/, "", name)
            if (rows > 1 && index(" " without " ", " " name " "))
                continue
            if (!is_number(x[i]) || !is_number(y[i])) {
                bad += x[i] != y[i]
                continue
            }
            values++
            changed += x[i] != y[i]
            if (size(x[i]) > largest[i])
                largest[i] = size(x[i])
            d = size(x[i] - y[i])
            if (names[i] ~ /\(deg\)$/ && d > 180)
                d = size(d - 360)
            if (d > difference[i])
                difference[i] = d
        }
    }
    if ((getline line2 <ARGV[2]) > 0)
        bad = 1
    for (i in difference) {
        if (names[i] ~ /residual/)
            largest[i] = names[i] ~ /^energy/ ? 10 : 1
        d = difference[i] / (largest[i] > 0 ? largest[i] : 1)
        if (d > worst) {
            worst = d
            where = names[i]
        }
    }
    print (bad || worst > most ? "differs" : changed ? "within" : "same"), values + 0, worst + 0, where
}
