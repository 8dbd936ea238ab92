# shellcheck shell=bash
# A Slurm cluster of two nodes, n1 and n2, on this machine: Debian's daemons, as root, without systemd. Sourced.

cluster=$(mktemp -d "${TMPDIR-/tmp}/lancer-slurm-XXXXXX")
export SLURM_CONF=$cluster/slurm.conf

# free_ports COUNT: numbers of ports that nobody listens at now.
free_ports() {
    python3 -c 'import socket, sys
sockets = [socket.socket() for _ in range(int(sys.argv[1]))]
for s in sockets: s.bind(("127.0.0.1", 0))
print(*[s.getsockname()[1] for s in sockets])' "$1"
}

start_cluster() {
    local host ports
    host=$(hostname -s)
    read -ra ports <<< "$(free_ports 3)"
    mkdir "$cluster/state" "$cluster/n1" "$cluster/n2"
    head -c 1024 /dev/urandom > "$cluster/key"
    chmod 600 "$cluster/key"
    munged --force --key-file="$cluster/key" --socket="$cluster/munge" --pid-file="$cluster/munged.pid" \
        --log-file="$cluster/munged.log" --seed-file="$cluster/seed" || return
    # A lost node is noticed after 3 s. Without cred_expire, a task that is queued again would wait
    # two minutes.
    cat > "$SLURM_CONF" << END
ClusterName=lancer
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=${ports[0]}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$cluster/munge,cred_expire=5
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
StateSaveLocation=$cluster/state
SlurmdSpoolDir=$cluster/%n
SlurmctldPidFile=$cluster/slurmctld.pid
SlurmdPidFile=$cluster/slurmd-%n.pid
SlurmctldLogFile=$cluster/slurmctld.log
SlurmdLogFile=$cluster/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
ReturnToService=2
SlurmdTimeout=3
KillWait=1
SchedulerType=sched/builtin
SchedulerParameters=sched_interval=1,batch_sched_delay=0
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
NodeName=n1 NodeHostname=$host NodeAddr=127.0.0.1 Port=${ports[1]} CPUs=1
NodeName=n2 NodeHostname=$host NodeAddr=127.0.0.1 Port=${ports[2]} CPUs=1
PartitionName=all Nodes=n1,n2 Default=YES State=UP
END
    slurmctld -i -c && start_node n1 && start_node n2
}

start_node() { slurmd -N "$1"; }

# processes_of NAME: the processes on that node, and the steps that started them.
processes_of() {
    local file process parent
    # shellcheck disable=SC2013
    for file in $(grep -slzxF "SLURMD_NODENAME=$1" /proc/[0-9]*/environ); do
        grep -qszxF "SLURM_CONF=$SLURM_CONF" "$file" || continue
        process=${file//[^0-9]/}
        parent=$(ps -o ppid= -p "$process" | tr -d ' ')
        grep -qs slurmstepd "/proc/$parent/cmdline" && echo "$parent"
        echo "$process"
    done
}

# kill_node NAME: kills its daemon and everything that runs on it at once, like a power failure.
kill_node() {
    local all
    read -ra all -d '' < <(cat "$cluster/slurmd-$1.pid"; processes_of "$1")
    kill -9 "${all[@]}"
}

stop_cluster() {
    local file
    for file in "$cluster"/slurmd-*.pid "$cluster"/slurmctld.pid "$cluster"/munged.pid; do
        [ -f "$file" ] && kill -9 "$(cat "$file")" 2> /dev/null
    done
    rm -rf "$cluster"
}

# wait_for SECONDS COMMAND...: repeats the command until it succeeds.
wait_for() {
    local end=$((SECONDS + $1))
    shift
    until "$@"; do
        [ $SECONDS -lt $end ] || return 1
        sleep 0.2
    done
}
queue_is_empty() { [ -z "$(squeue -h)" ]; }
