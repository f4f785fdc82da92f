#!/usr/bin/env bash
# tests/slurm/trials.sh PROGRAM FAULTY [--kills N] [TRIAL...]
#
# Regressions on a real Slurm of two nodes, which it starts in a folder of its own and stops again.
# PROGRAM runs them; FAULTY has a bench with a fault. Each trial is named, with its seconds; without
# a TRIAL all of them. A node is killed N times, by default 20. Needs root, slurm-wlm and munge.
# The trial `figures`, only by name, times a regression of $COSIM_TRIAL_CLOCKS clocks a shape (ten
# million) on one node and on two; that says something where nothing else runs.
# Status: 0 all so, 1 not, 2 could not be tried.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/cluster.sh"

program=$(realpath "$1") faulty=$(realpath "$2") kills=20 trials=()
shift 2
while (($#)); do
  case $1 in
    --kills) kills=$2 && shift ;;
    *) trials+=("$1") ;;
  esac
  shift
done
if ((EUID != 0)); then
  echo "trials.sh: needs root, for a Slurm of several nodes" >&2
  exit 2
fi

folder=$(mktemp -d)
cluster=''
mounted=''
finish() {
  local pid
  for pid in $(jobs -rp); do kill -KILL "$pid" 2> /dev/null || true; done
  cluster_stop
  [[ ! $mounted ]] || umount "$mounted"
  rm -rf "$folder"
}
trap finish EXIT
trap 'exit 130' INT
trap 'exit 143' TERM
cd "$folder"

fails() {
  printf '%s\n' "FAILED: $*" >&2
  [[ ! -f said ]] || tail -n 20 said >&2
  tail -n 5 "$cluster"/*.log >&2
  exit 1
}

# expect STATUS COMMAND...: what it says goes to the file said.
expect() {
  local status=0
  "${@:2}" > said 2>&1 || status=$?
  ((status == $1)) || fails "${*:2}: status $status for $1"
}
says() { grep -qE -- "$1" "${2:-said}" || fails "does not say: $1"; }
# same RUN: its report is that of the run that was not cut.
same() { cmp "$1/report.json" whole/report.json || fails "$1: another report"; }
queue_empty() { [[ ! $(squeue -h) ]] || fails "left in the queue: $(squeue -h)"; }

# begin RUN ARGUMENTS...: a run in the background, until a job is running. Its number in run.
begin() {
  local name=$1 i
  "$program" regress "${@:2}" > "$name.said" 2>&1 &
  run=$!
  for ((i = 0; i < 600; ++i)); do
    [[ ! $(squeue -h -t RUNNING) ]] || return 0
    kill -0 "$run" 2> /dev/null || return 0
    sleep 0.1
  done
  fails "$name: no job begins"
}
# ends STATUS RUN: that run, begun before.
ends() {
  local status=0
  wait "$run" || status=$?
  cp "$2.said" said
  ((status == $1)) || fails "$2: status $status for $1"
}

# ---- The trials -----------------------------------------------------------------------------------

two_nodes() {
  expect 0 "$program" regress plan.json --folder two --shards 40 --slurm
  same two
  grep -q '"n1": [1-9]' two/times.json || fails "nothing ran on n1"
  grep -q '"n2": [1-9]' two/times.json || fails "nothing ran on n2"
  queue_empty
}

# What is asked of the cluster: by options and by variables.
requests() {
  SBATCH_TIMELIMIT=7 begin asked plan.json --folder asked --shards 6 --slurm --sbatch "comment=trial nice=3"
  [[ $(squeue -h -o '%l %k %y' | sort -u | head -n 1) == "7:00 trial 3" ]] ||
    fails "asked for: $(squeue -h -o '%l %k %y')"
  ends 0 asked
  expect 2 "$program" regress plan.json --folder refused --slurm --sbatch "partition=none"
  says 'sbatch: .*[Ii]nvalid partition'
  queue_empty
}

# Told to end before its time limit, a task puts itself back into the queue.
told_to_end() {
  begin told plan.json --folder told --shards 2 --slurm
  local job
  job=$(squeue -h --array -t RUNNING -o %A | sed -n 1p)
  # Its status is not that of the signal, which is seen below.
  scancel --batch --signal=TERM "$job" || true
  ends 0 told
  same told
  compgen -G 'told/results/slurm-*-1.jsonl' > /dev/null || fails "it was not put back"
}

node_lost() {
  local k node
  for ((k = 1; k <= kills; ++k)); do
    begin "lost$k" plan.json --folder "lost$k" --shards 12 --slurm
    sleep "$((RANDOM % 4)).$((RANDOM % 10))"
    node=$((RANDOM % 2 + 1))
    node_kill "$node"
    # Sometimes it is back before anybody has missed it.
    sleep "$((RANDOM % 2 * 25 + 1))"
    node_start "$node"
    ends 0 "lost$k"
    same "lost$k"
    rm -r "lost$k"
    nodes_idle
  done
}

controller_lost() {
  begin away plan.json --folder away --shards 12 --slurm
  controller_stop
  sleep 8
  controller_start
  ends 0 away
  same away
}

cancelled() {
  begin stopped plan.json --folder stopped --shards 12 --slurm
  kill -TERM "$run"
  ends 143 stopped
  says 'regress --resume'
  sleep 3
  queue_empty
  begin stopped --resume stopped --slurm
  # This time by somebody else.
  # shellcheck disable=SC2046  # numbers
  scancel $(squeue -h -o %A)
  ends 2 stopped
  expect 0 "$program" regress --resume stopped --slurm
  same stopped
  # On this host's cores it goes on as well.
  begin mixed plan.json --folder mixed --shards 12 --slurm
  kill -TERM "$run"
  ends 143 mixed
  expect 0 "$program" regress --resume mixed
  same mixed
}

# The program that waits is killed: what it submitted goes on, and is taken up again.
waiting_lost() {
  begin alone plan.json --folder alone --shards 6 --slurm
  kill -KILL "$run"
  wait "$run" || true
  local jobs
  jobs=$(< alone/slurm/jobs.txt)
  expect 0 "$program" regress --resume alone --slurm
  same alone
  [[ $(< alone/slurm/jobs.txt) == "$jobs" ]] || fails "submitted again"
}

full_and_read_only() {
  mkdir small
  mount -t tmpfs -o size=40m tmpfs small
  mounted=$folder/small
  begin small/run plan.json --folder small/run --shards 30 --slurm
  dd if=/dev/zero of=small/filling bs=64k 2> /dev/null || true
  ends 2 small/run
  says 'No space left on device'
  rm small/filling
  mount -o remount,ro small
  expect 2 "$program" regress --resume small/run --slurm
  says 'Read-only file system'
  mount -o remount,rw small
  expect 0 "$program" regress --resume small/run --slurm
  same small/run
  umount small
  mounted=''
}

two_at_once() {
  begin first plan.json --folder first --shards 12 --slurm
  local one=$run
  expect 2 "$program" regress --resume first --slurm
  says 'another program is running it; wait for its end'
  expect 0 "$program" regress plan.json --folder second --shards 8 --slurm
  same second
  run=$one
  ends 0 first
  same first
}

fault() {
  local where
  expect 1 "$faulty" regress faulty.json --folder fault --shards 12 --slurm
  says '^FAILED: '
  where=$(sed -n 's/^  kept in: //p' said)
  [[ -s fault/$where/smallest.stim ]] || fails "no failure in fault/$where"
  expect 1 "$faulty" replay "fault/$where"
  expect 1 "$faulty" regress faulty.json --folder here --shards 3
  cmp fault/report.json here/report.json || fails "another report than on one host"
}

other_program() {
  begin other plan.json --folder other --shards 4 --slurm
  kill -TERM "$run"
  ends 143 other
  { cat "$program" && printf '+'; } > another
  chmod +x another
  mv another other/"$(basename "$program")"
  expect 2 "$program" regress --resume other --slurm
  cat other/logs/*.txt > logged
  says 'a run of another program or build' logged
  cp "$program" another
  mv another other/"$(basename "$program")"
  expect 0 "$program" regress --resume other --slurm
  same other
}

figures() {
  local nodes began time=()
  for nodes in 1 2; do
    ((nodes == 2)) || scontrol update NodeName=n2 State=DRAIN Reason=figures
    began=$EPOCHREALTIME
    expect 0 "$program" regress plan.json --folder "figures$nodes" --shards 16 --slurm
    time+=("$(awk -v a="$began" -v b="$EPOCHREALTIME" 'BEGIN { printf "%.1f", b - a }')")
    scontrol update NodeName=n2 State=RESUME 2> /dev/null || true
    same "figures$nodes"
  done
  awk -v one="${time[0]}" -v two="${time[1]}" \
    'BEGIN { printf "one node %s s, two nodes %s s: %.2f of it\n", one, two, two / one }'
}

# ---- Running them ---------------------------------------------------------------------------------

all=(two_nodes requests told_to_end node_lost controller_lost cancelled waiting_lost
  full_and_read_only two_at_once fault other_program)
((${#trials[@]})) || trials=("${all[@]}")
for trial in "${trials[@]}"; do
  [[ " ${all[*]} figures " == *" $trial "* ]] || { echo "trials.sh: no such trial: $trial" >&2 && exit 2; }
done
design=$("$program" list | sed -n 's/^\([a-z][a-z0-9_]*\)[:, ].*/\1/p' | head -n 1)
cat > plan.json << END
{"format": 1, "name": "trial", "seed": 4, "tasks": [
  {"name": "any pins", "sweep": "$design", "hostile": ${COSIM_TRIAL_CLOCKS:-10000000}, "minutes": 5},
  {"name": "jobs", "sweep": "$design", "random": 2000, "minutes": 1}]}
END
cat > faulty.json << END
{"format": 1, "name": "trial", "seed": 4, "tasks": [
  {"name": "any pins", "sweep": "$design", "hostile": 500000, "minutes": 5}]}
END
expect 0 "$program" regress plan.json --folder whole --shards 1
cluster_start "$folder/cluster"
for trial in "${trials[@]}"; do
  began=$SECONDS
  "$trial"
  printf '%-20s %4d s\n' "$trial" $((SECONDS - began))
done
echo "as expected"
