#!/usr/bin/env bash
# A Slurm of one node for a test: `one_node_slurm.sh FOLDER COMMAND...` starts munge and Slurm below FOLDER, runs the command
# with SLURM_CONF set, and stops what it started. Needs root; exit code 77 if this machine cannot.
set -euo pipefail
folder="$(mkdir -p "$1" && cd "$1" && pwd)"
shift
cannot() { echo "one_node_slurm: $*" >&2; exit 77; }
[ "$(id -u)" -eq 0 ] || cannot "not root"
for program in munged slurmctld slurmd sbatch squeue; do
  command -v "$program" >/dev/null || [ -x "/usr/sbin/$program" ] || cannot "no $program: ./limpet cluster installs it"
done
PATH="$PATH:/usr/sbin"
node="$(hostname -s)"
started=()
# By its process: never by name. A daemon's child may outlive it for a moment.
stop() {
  local pid
  for pid in "${started[@]}"; do kill "$pid" 2>/dev/null || true; done
  for pid in "${started[@]}"; do
    for _ in $(seq 100); do kill -0 "$pid" 2>/dev/null || break; sleep 0.1; done
    kill -KILL "$pid" 2>/dev/null || true
  done
}
trap stop EXIT
mkdir -p "$folder/state" "$folder/spool"
port() { python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])' 2>/dev/null || echo "$1"; }
# A socket of its own: another munge of this machine goes on.
dd if=/dev/urandom of="$folder/munge.key" bs=128 count=1 status=none
chmod 600 "$folder/munge.key"
munged --foreground --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" --pid-file="$folder/munge.pid" \
  --log-file="$folder/munge.log" --seed-file="$folder/munge.seed" >"$folder/munge.out" 2>&1 &
started+=($!)
cat >"$folder/slurm.conf" <<CONF
ClusterName=limpet
SlurmctldHost=$node(127.0.0.1)
SlurmctldPort=$(port 26817)
SlurmdPort=$(port 26818)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CredType=cred/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerType=sched/backfill
SchedulerParameters=batch_sched_delay=0,sched_min_interval=0,sched_interval=1
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
ReturnToService=2
MaxArraySize=10001
NodeName=$node NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=1000 State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF="$folder/slurm.conf"
slurmctld -D -f "$SLURM_CONF" >/dev/null 2>&1 &
started+=($!)
slurmd -D -f "$SLURM_CONF" >/dev/null 2>&1 &
started+=($!)
for _ in $(seq 150); do
  [ "$(sinfo -h -o %t 2>/dev/null)" = idle ] && break
  sleep 0.2
done
[ "$(sinfo -h -o %t 2>/dev/null)" = idle ] || cannot "Slurm does not come up: $(tail -n 3 "$folder"/slurm*.log)"
"$@"
