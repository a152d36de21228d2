#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# gallery.sh BUILD [FOLDER] - make the pictures of doc/gallery.md, with its own command lines and the program in
# BUILD, in FOLDER (default: doc/gallery).  Fails if a command fails, or a picture that the page shows is not made.
# doc/screens.js makes those of the page and of a report, page.png and report.png.
set -eu
build=$(cd "$1" && pwd)
cd "$(dirname "$0")"
mkdir -p "${2:-gallery}"
folder=$(cd "${2:-gallery}" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
ln -s "$PWD/../data" "$PWD/../web" "$PWD" "$work" # which the command lines name

awk '/^<!-- run -->$/ {next_block = 1} /^```/ {on = next_block && !on; if (!on) next_block = 0; next} on' gallery.md >"$work/commands"
(cd "$work" && PATH=$build:$PATH && export PATH && sh -e ./commands)

n=0
for picture in $(sed -n 's/^!\[.*\](gallery\/\(.*\))$/\1/p' gallery.md); do
  [ -s "$work/$picture" ] || { echo "gallery.sh: no command makes $picture" >&2 && exit 1; }
  mv "$work/$picture" "$folder"
  n=$((n + 1))
done
echo "gallery.sh: $n pictures in $folder"
[ "$n" -gt 0 ]
