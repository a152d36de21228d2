#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_pdf.sh FOURLINK DATA - a report as pdf, with browsers that are scripts: what they are told, what is said if there is
# none or if it fails, and that nothing is left behind.  test_browser.sh has the real one.
. "$(dirname "$0")/../harness.sh"

# browser NAME LINES: a program of this name in bin/.  It has the page as its last argument.
browser() {
    mkdir -p bin
    { echo '#!/bin/sh'; echo 'printf "%s\n" "$@" >'"$work/told"; echo 'for page; do :; done'; cat; } >"bin/$1"
    chmod +x "bin/$1"
}
report() { PATH=$work/bin:/usr/bin:/bin "$fourlink" "$@" >out 2>err; }
nothing_left() { check "left: $(ls | grep fourlink)" sh -c '! ls | grep -q fourlink'; }

browser chromium <<'END'
cp "$page" page.html
printf '%%PDF-1.4 of %s bytes\n' "$(wc -c <"$page")"
END
report --report=x.pdf "$alvi"
check "as pdf: $?" test $? -eq 0
quiet
check 'the pdf is what the browser printed' test "$(cat x.pdf)" = "%PDF-1.4 of $(wc -c <page.html) bytes"
nothing_left
check 'the page is known by its name' sh -c 'tail -n 1 told | grep -q "/\{0,1\}fourlink......\.html$"'
for option in --headless --print-to-pdf=/dev/stdout --no-pdf-header-footer; do
    check "$option" grep -qxF -- $option told
done
run 0 --report=y.html "$alvi"
differs=$(diff page.html y.html | grep -c '^[<>]')
check "the page is the report, but for the paper: $differs lines" test "$differs" -eq 2
check 'A4' grep -q '@page {size: A4; @top-left' page.html
check 'whoever opens a page chooses the paper' none '@page {size' y.html
report --report=x.pdf --set length=in "$alvi" || report --report=x.pdf --set units.length=in "$alvi"
check 'Letter, with inches' grep -q '@page {size: Letter; @top-left' page.html

# Beside the file, in a folder whose name has what is special in an address.
mkdir 'a #%20?'
report --report='a #%20?/x.PDF' "$alvi"
check 'a folder with signs' test -s 'a #%20?/x.PDF' -a "$(ls 'a #%20?' | wc -l)" -eq 1

# As root a browser may ask for --no-sandbox, which is given then alone.
browser chromium <<'END'
case " $* " in *" --no-sandbox "*) echo "%PDF without" && exit ;; esac
echo 'Running as root without --no-sandbox is not supported.' >&2
exit 1
END
report --report=x.pdf "$alvi"
check 'without a sandbox where it is asked for' test "$(cat x.pdf)" = '%PDF without'

# What fails leaves the old file.
browser chromium <<'END'
echo 'no display' >&2
exit 1
END
echo old >x.pdf
report --report=x.pdf "$alvi"
check "a browser that fails: $?" test $? -eq 3
says 'cannot print x.pdf: chromium failed: no display'
check 'the old file is kept' test "$(cat x.pdf)" = old
nothing_left
browser chromium </dev/null
report --report=x.pdf "$alvi"
check "a browser that prints nothing: $?" test $? -eq 3
says 'cannot print x.pdf: chromium failed'
check 'the old file is kept still' test "$(cat x.pdf)" = old
report --report=no/x.pdf "$alvi"
check "no folder: $?" test $? -eq 3
says 'cannot print no/x.pdf: No such file or directory'

# The next one, and none.
rm bin/chromium
browser google-chrome <<'END'
echo '%PDF by another'
END
PATH=$work/bin "$fourlink" --report=x.pdf "$alvi" >out 2>err
check 'another browser' test "$(cat x.pdf)" = '%PDF by another'
sed 's/^length/lenght/' "$alvi" >bad.deck
PATH=$work/bin "$fourlink" --report=bad.pdf bad.deck >out 2>err
check "a deck with mistakes: $?" test $? -eq 2
check 'its report is printed' test -s bad.pdf
"$(command -v env)" PATH=/nonexistent "$fourlink" --report=z.pdf "$alvi" >out 2>err
check "without a browser: $?" test $? -eq 3 -a ! -e z.pdf
says 'Chromium, which makes pdf of a report, is not installed; its package is chromium (Debian, Ubuntu)'
nothing_left
usage "--report needs a file name that ends in .html or .pdf, not 'x.ps'" --report=x.ps "$alvi"
finish
