#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# nightly.sh [short|SECONDS] [TRIAL...] - all trials of trials.txt, or those named, as long as a night has time for: each
# fuzzer for so many SECONDS (600).  `short`: a case of each, an hour and a half on two cores.
#
# For Debian 12 or later, a bare one will do, as root; it installs what is missing.  FOLDER keeps the builds and the logs,
# EVIDENCE is a file for the results (trials.sh).  Ends with the line "N passed, M failed", the trials.
. "$(dirname "$0")/foreign.sh"
when=night
case ${1-} in
short)
    when=short
    shift
    ;;
[0-9]*)
    seconds=$1
    export seconds
    shift
    ;;
esac

# Servers are not started: engines.sh starts its own.
DEBIAN_FRONTEND=noninteractive RUNLEVEL=1 LC_ALL=C.UTF-8
export DEBIAN_FRONTEND RUNLEVEL LC_ALL
install bsdextrautils ca-certificates chromium clang clang-format clang-tidy cmake cmake-data debootstrap dpkg-dev file g++ gcc gfortran git \
    gnuplot-nox jq libclang-rt-dev libcmocka-dev libgsl-dev libmpfr-dev librsvg2-bin llvm locales make man-db munge ninja-build nodejs \
    octave openssh-client openssh-server parallel pkg-config poppler-utils procps python3-clang python3-dev python3-numpy \
    python3-pandas python3-pytest python3-venv rsync slurm-client slurmctld slurmd util-linux valgrind >apt.txt 2>&1 ||
    { tail -n 20 apt.txt && exit 1; }
locale -a | grep -qi '^de_DE\.utf' || localedef -i de_DE -f UTF-8 de_DE.UTF-8

FOLDER=$work sh "$source/tests/trials.sh" $when "$@"
