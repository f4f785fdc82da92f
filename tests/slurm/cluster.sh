# shellcheck shell=bash
# A Slurm of two nodes on this machine, all of it in one folder: munged with its key, socket, pid, log
# and seed files, slurmctld and two slurmd that listen on 127.0.0.1, on three ports from
# $COSIM_SLURM_PORT (17020) on. To be sourced; needs root.
#   cluster_start FOLDER   starts it and waits until both nodes are idle; SLURM_CONF then names it
#   cluster_stop           stops every daemon and whatever it started
#   node_kill N            takes node N away at once, with its steps and their processes
#   node_start N           brings it back
#   controller_stop, controller_start

cluster_port=${COSIM_SLURM_PORT:-17020}

cluster_start() {
  cluster=$1
  local host
  host=$(hostname -s)
  mkdir -p "$cluster"/{munge,state,spool-n1,spool-n2}
  # munged wants its folders safe from others, and none of those above writable by them.
  chmod 711 "$cluster"
  dd if=/dev/urandom of="$cluster/munge/key" bs=128 count=1 status=none
  chmod 600 "$cluster/munge/key"
  chmod 711 "$cluster/munge"
  munge_pid=$cluster/munge/pid
  munged --force --key-file="$cluster/munge/key" --socket="$cluster/munge/socket" \
    --pid-file="$munge_pid" --log-file="$cluster/munge/log" --seed-file="$cluster/munge/seed" \
    2> "$cluster/munge/said" || { cat "$cluster/munge/said" && return 1; }
  cat > "$cluster/slurm.conf" << END
ClusterName=trial
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$cluster_port
AuthType=auth/munge
AuthInfo=socket=$cluster/munge/socket,cred_expire=15
CryptoType=crypto/munge
SlurmUser=root
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
SlurmdTimeout=10
SlurmctldTimeout=10
KillWait=5
MinJobAge=30
SchedulerParameters=sched_interval=1,sched_min_interval=100000,batch_sched_delay=1
MaxArraySize=1001
StateSaveLocation=$cluster/state
SlurmdSpoolDir=$cluster/spool-%n
SlurmctldPidFile=$cluster/slurmctld.pid
SlurmdPidFile=$cluster/slurmd-%n.pid
SlurmctldLogFile=$cluster/slurmctld.log
SlurmdLogFile=$cluster/slurmd-%n.log
NodeName=n[1-2] NodeHostname=$host NodeAddr=127.0.0.1 Port=[$((cluster_port + 1))-$((cluster_port + 2))] CPUs=1 RealMemory=2000 State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
  export SLURM_CONF=$cluster/slurm.conf
  controller_start
  node_start 1
  node_start 2
  nodes_idle
}

controller_start() { slurmctld -f "$SLURM_CONF"; }
controller_stop() { stop_by "$cluster/slurmctld.pid"; }
node_start() { slurmd -f "$SLURM_CONF" -N "n$1"; }

nodes_idle() {
  local i
  for ((i = 0; i < 300; ++i)); do
    [[ $(sinfo -h -o '%D %t' 2> /dev/null) != "2 idle" ]] || return 0
    sleep 0.2
  done
  sinfo >&2
  tail -n 5 "$cluster"/*.log >&2
  return 1
}

# stop_by FILE [SIGNAL]: the daemon of a pid file, until it is gone.
stop_by() {
  local pid i
  [[ -s $1 ]] || return 0
  pid=$(< "$1")
  kill "-${2:-TERM}" "$pid" 2> /dev/null || return 0
  for ((i = 0; i < 100; ++i)); do
    kill -0 "$pid" 2> /dev/null || return 0
    sleep 0.1
  done
  kill -KILL "$pid" 2> /dev/null || true
}

# below PID...: the processes that these have started, and theirs.
below() {
  local pid
  for pid; do
    # shellcheck disable=SC2046  # numbers
    below $(ps -o pid= --ppid "$pid")
    echo "$pid"
  done
}

# steps_of PATTERN: the step daemons of the nodes, by the logs that they write.
steps_of() {
  local pid
  while read -r pid; do
    [[ ! $(find "/proc/$pid/fd" -lname "$cluster/slurmd-$1.log" 2> /dev/null) ]] || echo "$pid"
  done < <(ps -eo pid=,comm= | awk '$2 ~ /slurmstepd/ { print $1 }')
}

node_kill() {
  local pids
  mapfile -t pids < <(steps_of "n$1")
  mapfile -t pids < <(below "${pids[@]}")
  pids+=("$(< "$cluster/slurmd-n$1.pid")")
  kill -KILL "${pids[@]}" 2> /dev/null || true
}

cluster_stop() {
  local pids
  [[ $cluster ]] || return 0
  mapfile -t pids < <(steps_of 'n[12]')
  mapfile -t pids < <(below "${pids[@]}")
  ((${#pids[@]} == 0)) || kill -KILL "${pids[@]}" 2> /dev/null || true
  stop_by "$cluster/slurmd-n1.pid"
  stop_by "$cluster/slurmd-n2.pid"
  controller_stop
  stop_by "$munge_pid"
}
