#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_picture_links.sh FOURLINK DATA - a picture that is replaced: links, rights, what a failure leaves.
. "$(dirname "$0")/pictures.sh"
pictures_of "$fourbar" mechanism

# --- files: a link stays one, rights stay, nothing is left beside
mkdir place
run 0 --plot=place/x.svg "$fourbar"
only_file place x.svg
ln -s place/x.svg to.svg
echo old >place/x.svg
chmod 640 place/x.svg
run 0 --plot=to.svg "$fourbar"
same place/x.svg coupler-point-mechanism.svg
check 'a link stays one' test -h to.svg
check 'rights stay' test "$(ls -l place/x.svg | cut -c1-10)" = -rw-r-----
only_file place x.svg
mkdir folder.svg
run 3 --plot=folder.svg "$fourbar"
says 'cannot write folder.svg: Is a directory'
nothing
run 3 --plot=missing/x.svg "$fourbar"
says 'cannot write missing/x.svg: No such file'
nothing
if [ "$(id -u)" -ne 0 ]; then
    chmod 555 place
    run 3 --plot=place/new.svg "$fourbar"
    says 'Permission denied'
    chmod 755 place
    chmod 444 place/x.svg
    run 3 --plot=place/x.svg "$fourbar"
    only_file place x.svg
fi

finish
