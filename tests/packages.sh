#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# packages.sh [SUITE...] - Debian packages and the source archive in bare roots that debootstrap makes, of Debian
# 12 (bookworm) and of testing if no suite is named.  As root, on a Debian machine whose apt has a registry.
#
# In each root: the two set-up commands of README.md, in the source archive, without git and sudo; the packages
# that cpack makes, and lintian.  In a second root: the packages installed, used, and removed without trace.
# ROOTS names a folder with SUITE.tar of bare roots, which saves debootstrap.
set -u
[ "$(id -u)" -eq 0 ] || { echo 'packages.sh: must be root, for debootstrap and chroot' >&2 && exit 2; }
for command in debootstrap unshare cmake git; do
    command -v $command >/dev/null || { echo "packages.sh: $command is not there" >&2 && exit 2; }
done
top=$(cd "$(dirname "$0")/.." && pwd)
work=$(mktemp -d) || exit 1
trap 'rm -rf --one-file-system "$work"' EXIT
trap 'exit 1' HUP INT TERM
cd "$work" || exit 1
umask 022
passed=0
failed=0

# check WHAT COMMAND...: the command succeeds; its output is in the file log, where the next one can read it.
check() {
    what=$1
    shift
    "$@" >output 2>&1 </dev/null
    status=$?
    mv output log
    if [ $status -eq 0 ]; then
        passed=$((passed + 1))
        echo "  $what"
    else
        failed=$((failed + 1))
        echo "FAILED: $what"
        tail -n 30 log
    fi
}

# in_root ROOT COMMAND: in that root, as root, with processes of its own; the mounts go with them.
in_root() {
    timeout -k 10 3600 unshare --mount --pid --fork --kill-child sh -c 'mount -t proc proc "$1/proc" &&
        mount --rbind /dev "$1/dev" && chroot "$1" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 \
        DEBIAN_FRONTEND=noninteractive CTEST_PARALLEL_LEVEL="$(nproc)" sh -c "cd && $2"' sh "$1" "$2"
}

# The first address of a Debian archive in the sources of apt.
mirror() {
    cat /etc/apt/sources.list /etc/apt/sources.list.d/*.sources /etc/apt/sources.list.d/*.list 2>/dev/null |
        awk '$1 == "URIs:" {print $2; exit}
            $1 == "deb" {for (i = 2; i < NF; i++) if ($i ~ /^[a-z]+:/) {print $i; exit}}'
}

# bare_root SUITE ROOT: its apt asks what the machine's apt asks, in the same way
bare_root() {
    mkdir "$2"
    if [ -f "${ROOTS-}/$1.tar" ]; then
        tar xf "$ROOTS/$1.tar" -C "$2"
    else
        debootstrap --variant=minbase "$1" "$2" "$(mirror)" >debootstrap.log 2>&1
    fi || { tail -n 3 debootstrap.log "$2/debootstrap/debootstrap.log" && return 1; }
    apt-config dump | grep '^Acquire::' >"$2/etc/apt/apt.conf.d/99machine"
    cp -r /etc/apt/auth.conf.d /etc/apt/auth.conf "$2/etc/apt" 2>/dev/null
    cp /etc/resolv.conf /etc/hosts "$2/etc"
}

# set_up_commands README: each on one line
set_up_commands() {
    awk '/^## Set-up/ {on = 1} on && /^```/ {if (inside) exit; inside = 1; next}
        on && inside {if (sub(/\\$/, "")) printf "%s", $0; else print}' "$1"
}

# build SUITE: the set-up commands and the packages
build() {
    check "$1: a bare root" bare_root "$1" build || return 1
    tar xzf fourlink-*.tar.gz -C build/root && mv build/root/fourlink-* build/root/source || return 1
    check "$1: no git, no sudo" in_root build '! command -v git && ! command -v sudo'
    set_up_commands "$top/README.md" >commands
    printf 'cd source\n%s\n' "$(sed -n 1p commands)" >build/root/first
    printf 'cd source\n%s\n' "$(sed -n 2p commands)" >build/root/second
    check "$1: the first command of README.md" in_root build 'sh first'
    check "$1: it prints the table of the paper's deck" grep -Eq '^ +40 +38\.9863 +-3\.15487 +20\.9565 +103\.821 ' log
    check "$1: the second command" in_root build 'sh second'
    grep '^[0-9]*% tests passed' log
    in_root build 'dpkg-query -W -f "  with \${Package} \${Version}\n" gcc cmake libgsl-dev libc6' </dev/null

    check "$1: what cpack and lintian need" in_root build 'apt-get install -y --no-install-recommends dpkg-dev file lintian'
    check "$1: cpack" in_root build 'cd source && cmake --preset deb && cmake --build --preset deb && cd build-deb && cpack'
    check "$1: three packages" test "$(find build/root/source/build-deb -maxdepth 1 -name '*.deb' | wc -l)" -eq 3
    check "$1: lintian has no errors" in_root build 'lintian --allow-root --fail-on error source/build-deb/*.deb'
    sed 's/^/  /' log
}

# use SUITE: the packages in another bare root
use() {
    check "$1: a bare root" bare_root "$1" target || return 1
    cp build/root/source/build-deb/*.deb build/root/source/tests/consumers/c90.c target/root
    cp build/root/source/data/me3491-matrix.deck target/root
    check "$1: apt-get update" in_root target 'apt-get update'
    check "$1: the command, installed with what is recommended" in_root target 'apt-get install -y ./fourlink_*.deb'
    check "$1: it runs" in_root target 'fourlink --check /usr/share/fourlink/data/me3491-matrix.deck'
    check "$1: it draws" in_root target 'fourlink --plot=/tmp/a.svg /usr/share/fourlink/data/alvi-5.1.deck && test -s /tmp/a.svg'
    check "$1: manuals and completion" in_root target 'dpkg -L fourlink | grep -q man1/fourlink.1.gz &&
        dpkg -L fourlink | grep -q man5/fourlink-deck.5.gz && dpkg -L fourlink | grep -q completions/fourlink'
    check "$1: the page" in_root target 'grep -q "</html>" /usr/share/fourlink/fourlink.html'
    check "$1: the library" in_root target 'apt-get install -y --no-install-recommends ./libfourlink*.deb gcc libc6-dev pkg-config cmake make'
    check "$1: a caller, shared" in_root target 'cc c90.c $(pkg-config --cflags --libs fourlink) -lm -o shared && ldd shared | grep -q libfourlink.so && ./shared <me3491-matrix.deck'
    check "$1: its answer" grep -q 'theta4 *= 103.820765 deg' log
    check "$1: a caller, static" in_root target 'cc c90.c /usr/lib/*/libfourlink.a -lgsl -lgslcblas -lm -o static && ./static <me3491-matrix.deck'
    check "$1: a caller with find_package" in_root target 'printf "%s\n" "cmake_minimum_required(VERSION 3.21)" "project(c C)" \
        "find_package(fourlink 0.3 REQUIRED)" "add_executable(c c90.c)" "target_link_libraries(c fourlink::fourlink m)" >CMakeLists.txt &&
        cmake -B b . && cmake --build b && b/c <me3491-matrix.deck'
    check "$1: removed" in_root target 'apt-get purge -y fourlink libfourlink-dev "libfourlink0.*"'
    check "$1: no file is left" in_root target '! find / -xdev -path /root -prune -o -path /proc -prune -o -name "*fourlink*" -print | grep .'
    check "$1: dpkg knows no more of it" in_root target '! dpkg -l | grep fourlink && ! ldconfig -p | grep fourlink'
}

echo 'the source archive'
git clone -q "$top" clone && cmake -S clone -B clone/build -DFOURLINK_TESTS=OFF >log 2>&1 || { cat log && exit 1; }
check 'the page is of these sources' sh clone/tests/release.sh
check 'package_source' cmake --build clone/build --target package_source
cp clone/build/fourlink-*.tar.gz . || exit 1
tar tzf fourlink-*.tar.gz | sed 's,^[^/]*/,,; /\/$/d; /^$/d' | sort >packed
(cd clone && git ls-files) | grep -v '^\.\(ci/\|git\)' | sort >listed
check "all $(wc -l <listed) files of git, and no others" diff listed packed

[ $# -gt 0 ] || set -- bookworm testing
for suite; do
    echo "$suite"
    build "$suite" && use "$suite"
    rm -rf --one-file-system build target
done
echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
