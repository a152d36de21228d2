#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# qemu.sh [ARCHITECTURE...] - other processors: i386 (32 bits), arm64, s390x (big-endian), by Debian's cross
# compilers and qemu-user, with that architecture's GSL and C library; and musl, another C library.  Runs the
# tests there and compares the results of decks with this machine's; of x87, i386 without SSE2, the results only,
# because tests count on the rounding of doubles.  For Debian 12 or later on amd64, as root, because it installs
# packages.
. "$(dirname "$0")/foreign.sh"
machines=${*:-i386 x87 arm64 s390x musl}
# These compile, preload a library, or take an hour when emulated.
slow='install|readme|includes|fast_math|failed_allocations|brute'

install cmake make gcc libgsl-dev libcmocka-dev dpkg-dev
for machine in $machines; do
    case $machine in
    i386 | x87) install qemu-user gcc-i686-linux-gnu libc6-dev-i386-cross ;;
    arm64) install qemu-user gcc-aarch64-linux-gnu libc6-dev-arm64-cross ;;
    s390x) install qemu-user gcc-s390x-linux-gnu libc6-dev-s390x-cross ;;
    musl) install musl-tools ;;
    *) echo "qemu.sh: unknown machine $machine" >&2 && exit 2 ;;
    esac
done

# root_of ARCHITECTURE: its libraries in the folder ARCHITECTURE/root, from Debian's packages.
root_of() {
    [ -e "$1/root/usr/include/cmocka.h" ] && return
    architecture=$1
    mkdir -p "$1/packages" "$1/root"
    private_apt "$1" update || true # an index of another suite may be missing
    (
        cd "$1/packages"
        private_apt "$1" download libgsl-dev libgsl27 libgslcblas0 libcmocka-dev libcmocka0 libc6 libgcc-s1
    )
    for package in "$1"/packages/*.deb; do dpkg -x "$package" "$1/root"; done
}

# processor NAME ARCHITECTURE COMPILER LIBRARIES ARGUMENT...: with arguments for cmake
processor() {
    name=$1
    architecture=$2
    root_of "$architecture"
    root=$work/$architecture/root
    compiler=/usr/bin/$3-gcc
    libraries=$root/usr/lib/$4
    shift 4
    configure "$name" -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR="$architecture" -DCMAKE_C_COMPILER="$compiler" \
        -DGSL_INCLUDE_DIR="$root/usr/include" -DGSL_LIBRARY="$libraries/libgsl.so" \
        -DGSL_CBLAS_LIBRARY="$libraries/libgslcblas.so" -DGSL_VERSION=2.7.1 \
        -DCMOCKA_INCLUDE_DIR="$root/usr/include" -DCMOCKA_LIBRARY="$libraries/libcmocka.so" "$@"
}

# With GSL and cmocka from Debian's sources.
musl() {
    build_gsl musl x86_64-linux-musl musl-gcc
    build_cmocka musl -DCMAKE_C_COMPILER=musl-gcc
    usr=$work/musl/usr
    configure musl -DCMAKE_C_COMPILER=/usr/bin/musl-gcc -DCMAKE_EXE_LINKER_FLAGS=-static \
        -DGSL_INCLUDE_DIR="$usr/include" -DGSL_LIBRARY="$usr/lib/libgsl.a" \
        -DGSL_CBLAS_LIBRARY="$usr/lib/libgslcblas.a" -DGSL_VERSION=2.7.1 \
        -DCMOCKA_INCLUDE_DIR="$usr/include" -DCMOCKA_LIBRARY="$usr/lib/libcmocka.a"
}

# compile MACHINE TARGET: fourlink_command or all, to be run by qemu.
compile() {
    build "$1" "$2"
    case $1 in
    i386 | x87)
        # an amd64 processor runs them itself, if the kernel lets it
        root=$work/i386/root
        loader="$root/lib/ld-linux.so.2 --library-path $root/lib/i386-linux-gnu:$root/usr/lib/i386-linux-gnu"
        $loader --version >/dev/null 2>&1 || loader="qemu-i386 -L $root"
        emulate "$1" "$loader"
        ;;
    arm64) emulate arm64 "qemu-aarch64 -L $work/arm64/root" ;;
    s390x) emulate s390x "qemu-s390x -L $work/s390x/root" ;;
    esac
}

configure native
build native fourlink_command
random_decks 60
results native/build/fourlink native/results
for machine in $machines; do
    case $machine in
    i386) processor i386 i386 i686-linux-gnu i386-linux-gnu ;;
    x87) processor x87 i386 i686-linux-gnu i386-linux-gnu -DFOURLINK_I386=OFF ;;
    arm64) processor arm64 arm64 aarch64-linux-gnu aarch64-linux-gnu ;;
    s390x) processor s390x s390x s390x-linux-gnu s390x-linux-gnu ;;
    musl) musl ;;
    esac
    compile "$machine" fourlink_command
    compare "$machine"
done
for machine in $machines; do
    [ "$machine" != x87 ] || continue
    compile "$machine" all
    run_tests "$machine" "$slow"
done
finish
