#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# engines.sh FOURLINK DATA - the recipes of doc/sweeps.md for several machines and for Slurm, as they stand
# there: over a real sshd, which is two machines with a port and a home each, and on a real Slurm of one node.
# Both listen on this machine alone, with keys and files of their own in a scratch folder.  Every daemon has
# a time limit, ends with the script, and would end without it.
. "$(dirname "$0")/sweeps.sh"

limit=300
daemons=
PATH=$(dirname "$fourlink"):$PATH:/usr/sbin:/sbin
export PATH
chmod 755 "$work" # munged wants its socket where everyone can reach it

end_daemons() {
    for pid in $daemons; do
        kill "$pid" 2>/dev/null
    done
    for pid in $daemons; do
        wait "$pid" 2>/dev/null
    done
    daemons=
}
trap 'end_daemons; chmod -R u+w "$work"; rm -rf "$work"' EXIT

# daemon LOG COMMAND...: in the background, at most $limit seconds
daemon() {
    log=$1
    shift
    timeout -k 5 $limit "$@" >"$log" 2>&1 </dev/null &
    daemons="$! $daemons" # the last one started ends first
}

# wait_for SECONDS COMMAND...: until the command succeeds
wait_for() {
    turns=$(($1 * 5))
    shift
    while ! timeout 5 "$@" >/dev/null 2>&1; do
        turns=$((turns - 1))
        [ $turns -gt 0 ] || return 1
        sleep 0.2
    done
}

there() {
    for command; do
        command -v "$command" >/dev/null || { echo "skipped: $command is not there" && return 1; }
    done
}

# free_port: a port above the last on which nothing listens
last_port=$((20000 + $$ % 10000))
free_port() {
    last_port=$((last_port + 1))
    while grep -q "$(printf ':%04X ' $last_port)" /proc/net/tcp; do
        last_port=$((last_port + 1))
    done
}

# a_sweep: sweep.deck in this folder, some of whose designs cannot be assembled, and whole.csv
a_sweep() {
    base >sweep.deck
    printf '%s\n' '[sweep]' 'crank.length = 18 mm to 34 mm in 9' 'rocker.length = 56 mm +- 0.1 mm' \
        'samples = 20' 'output = mu_min, type, max(Ts)' >>sweep.deck
    run 0 -f csv -o whole.csv sweep.deck
    grep -c , whole.csv >count
}

# joined: the eight parts, joined as doc/sweeps.md says, are the whole
joined() {
    check 'eight parts' test -s part8.csv
    cat part1.csv part2.csv part3.csv part4.csv part5.csv part6.csv part7.csv part8.csv >sweep.csv
    same sweep.csv whole.csv
}

# machine NAME: a line of the daemon's and of the client's configuration
machine() {
    free_port
    mkdir -p "$work/$1"
    printf '#!/bin/sh\nHOME=%s\nexport HOME\ncd && echo "$SSH_ORIGINAL_COMMAND" >>commands && exec sh -c "$SSH_ORIGINAL_COMMAND"\n' \
        "$work/$1" >"$work/$1.sh"
    chmod +x "$work/$1.sh"
    echo "Port $last_port" >>sshd_ports
    printf 'Match LocalPort %s\n  ForceCommand %s\n' $last_port "$work/$1.sh" >>sshd_matches
    printf 'Host %s\n  Port %s\n' "$1" $last_port >>ssh_config
}

over_ssh() {
    there parallel rsync ssh sshd ssh-keygen || return
    echo "GNU parallel over ssh: $(ssh -V 2>&1 | cut -d, -f1), $(parallel --version | sed -n '1s/GNU //p'), two machines"
    ssh-keygen -q -t ed25519 -N '' -f host_key && ssh-keygen -q -t ed25519 -N '' -f user_key || exit 1
    cp user_key.pub authorized_keys
    printf '* %s\n' "$(cut -d' ' -f1,2 host_key.pub)" >known_hosts
    machine host1
    machine host2
    cat - sshd_ports >sshd_config <<CONFIG
ListenAddress 127.0.0.1
HostKey $work/host_key
AuthorizedKeysFile $work/authorized_keys
AuthenticationMethods publickey
PermitRootLogin yes
StrictModes no
UsePAM no
PidFile none
SetEnv PATH=$PATH
CONFIG
    cat sshd_matches >>sshd_config
    cat >>ssh_config <<CONFIG
Host *
  HostName 127.0.0.1
  IdentityFile $work/user_key
  IdentitiesOnly yes
  BatchMode yes
  ConnectTimeout 10
  GlobalKnownHostsFile none
  UserKnownHostsFile $work/known_hosts
CONFIG
    mkdir bin home home/sweep
    printf '#!/bin/sh\nexec %s -F %s "$@"\n' "$(command -v ssh)" "$work/ssh_config" >bin/ssh
    chmod +x bin/ssh
    if [ "$(id -u)" -eq 0 ] && mkdir /run/sshd 2>/dev/null; then # the daemon wants it as root
        trap 'end_daemons; rmdir /run/sshd; chmod -R u+w "$work"; rm -rf "$work"' EXIT
    fi
    daemon sshd.log "$(command -v sshd)" -D -e -f "$work/sshd_config"
    wait_for 10 bin/ssh host1 true
    check "sshd answers: $(cat sshd.log)" bin/ssh host1 true
    rm -f host1/commands

    recipe 'Several machines over ssh' parallel.sh
    cd home/sweep || exit 1
    a_sweep
    HOME=$work/home PATH=$work/bin:$PATH timeout 120 sh "$work/parallel.sh" >out 2>err </dev/null
    # GNU parallel's exit status is the number of parts in which some designs have no value.
    status=$?
    check "no more than the parts with such designs failed: $status; $(head -n 3 err)" test $status -le 8
    joined
    cd "$work" || exit 1
    for host in host1 host2; do
        n=$(grep -c 'rsync --server --sender .*part' $host/commands)
        check "$host had parts" test "$n" -gt 0
        echo "  $host: $n of 8 parts, $(wc -l <$host/commands) commands over ssh"
        check "nothing is left on $host: $(ls -R $host)" test -z "$(find $host -type f ! -name commands)"
    done
    echo "  $(($(cat home/sweep/count) - 1)) lines of designs, byte for byte those of the whole"
    end_daemons
}

slurm_configuration() {
    host=$(hostname -s)
    free_port
    controller_port=$last_port
    free_port
    mkdir state spool
    cat >slurm.conf <<CONFIG
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$controller_port
SlurmdPort=$last_port
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$work/munge.socket
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=0
JobAcctGatherType=jobacct_gather/none
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=p Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONFIG
    SLURM_CONF=$work/slurm.conf
    export SLURM_CONF
}

on_slurm() {
    there munged munge slurmctld slurmd sbatch srun scancel squeue sinfo || return
    echo "Slurm: $(slurmctld -V), one node with $(nproc) processors"
    slurm_configuration
    head -c 128 /dev/urandom >munge.key
    chmod 600 munge.key
    daemon munged.log munged --foreground --key-file="$work/munge.key" --socket="$work/munge.socket" \
        --pid-file="$work/munge.pid" --seed-file="$work/munge.seed"
    wait_for 10 munge -n -o /dev/null --socket="$work/munge.socket"
    check "munged answers: $(cat munged.log)" munge -n -o /dev/null --socket="$work/munge.socket"
    daemon slurmctld.log slurmctld -D -i
    daemon slurmd.log slurmd -D
    wait_for 30 sh -c 'sinfo -h -o %t | grep -qx idle'
    check "the node is idle: $(tail -n 3 slurmctld.log slurmd.log)" sh -c 'sinfo -h -o %t | grep -qx idle'

    mkdir jobs
    recipe Slurm jobs/this-file
    cd jobs || exit 1
    a_sweep
    check "the array ends with success: $(cat slurm-*.out 2>&1)" timeout 90 sbatch --quiet --wait --array=1-8 this-file </dev/null
    joined
    check 'eight jobs' test "$(find . -name 'slurm-*_*.out' | wc -l)" -eq 8
    echo "  an array of 8 jobs, $(($(cat count) - 1)) lines of designs, byte for byte those of the whole"

    # A job that is cancelled leaves nothing of its part.
    rm -f part*.csv slurm-*.out
    sed 's/samples = 20/samples = 10000000/' sweep.deck >long && mv long sweep.deck
    timeout 20 sbatch --quiet --array=1-2 this-file </dev/null
    check 'a job runs' wait_for 20 sh -c 'ls -A | grep -q "^[.]fourlink"' # its temporary file
    timeout 20 scancel --user="$(id -un)"
    check 'the jobs end' wait_for 60 sh -c '[ -z "$(squeue -h)" ]'
    check "cancelled jobs leave no file: $(ls -A)" test -z "$(ls -A | grep -e part -e '^[.]fourlink')"
    echo '  two jobs cancelled: no part, no temporary file'
    cd "$work" || exit 1
    end_daemons
}

over_ssh
on_slurm
finish
