#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# nightly.sh [SECONDS] - trials that need servers, an index of Python packages or much time, which .ci/run leaves out: sweeps
# over a real sshd and on a real Slurm, the Python package as pip installs it, more random decks than .ci/run has time for,
# and each fuzzer for so many seconds (600).
# For Debian 12 or later, as root; it installs what is missing.
# It prints how much it tried and ends with the line "N passed, M failed".
. "$(dirname "$0")/foreign.sh"
seconds=${1:-600}

install cmake make gcc clang python3-venv libclang-rt-dev libgsl-dev libcmocka-dev parallel rsync
# Servers are not started: engines.sh starts its own.
RUNLEVEL=1
export RUNLEVEL
install munge openssh-client openssh-server slurm-client slurmctld slurmd

configure native
build native fourlink_command
build native fourlink_shared
status=0
timeout -k 10 900 sh "$source/tests/command/engines.sh" native/build/fourlink "$source/data" </dev/null >engines.txt 2>&1 ||
    status=1
cat engines.txt
count $status 'sweeps over ssh and on Slurm'
status=0
grep '^skipped' engines.txt && status=1
count $status 'a server is missing'

status=0
sh "$source/tests/test_python.sh" native/build/fourlink native/build/libfourlink.so wheel || status=1
count $status 'the Python package as pip installs it'
build native all
trial() { # COMMAND...
    status=0
    "$@" || status=1
    count $status "$*"
}
trial sh "$source/tests/random_trial.sh" native/build/random_decks machines 300 \
    sh "$source/tests/python.sh" "$source/tests/tables/people.py" native/build/fourlink
trial native/build/brute_extremes 300
trial native/build/brute_extremes 100 1000
trial native/build/brute_crossings 200 9
trial native/build/brute_fits 200 2 60
trial sh "$source/tests/command/failed_allocations.sh" native/build/fourlink "$source/data" native/build/tests/libfailing_malloc.so
trial sh "$source/tests/results/integrated_motions.sh" native/build/integrated_motions native/build/random_decks 1000
status=0
AT_ONCE=$(nproc) sh "$source/tests/fuzz/fuzz.sh" "$seconds" "$work/build-fuzz" || status=1
count $status 'the fuzzers'
finish
