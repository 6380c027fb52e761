#!/bin/sh
# A cluster of two nodes on the loopback of this one machine, for tests: Slurm's controller, two of its node daemons
# and munge, all of them below one folder, without cgroups and apart from any cluster that the machine belongs to.
#   cluster.sh start FOLDER     prints what to evaluate:  eval "$(cluster.sh start FOLDER)"
#   cluster.sh stop FOLDER
# Slurm's commands find the cluster by SLURM_CONF, which `start` prints. Needs root and the packages slurm-wlm and
# munge, and ends with 77 where they are missing.
set -eu
unset CDPATH
verb=$1
mkdir -p "$2"
folder=$(cd "$2" && pwd -P)
PATH=$PATH:/usr/sbin
export SLURM_CONF="$folder/slurm.conf"
cannot() { echo "  slurm    no cluster here: $1" >&2; exit 77; }
end() {
  [ -f "$1" ] || return 0
  pid=$(cat "$1")
  kill "$pid" 2>/dev/null || true
  for _ in $(seq 50); do kill -0 "$pid" 2>/dev/null || return 0; sleep 0.1; done
  kill -9 "$pid"
}

configure() {
  cores=$(($(nproc) > 1 ? $(nproc) / 2 : 1))
  base=$((20000 + $$ % 10000))
  dd if=/dev/urandom of="$folder/key" bs=1 count=1024 2>/dev/null
  chmod 400 "$folder/key"
  cat > "$SLURM_CONF" <<CONF
ClusterName=loopback
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmctldPort=$base
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket,cred_expire=5
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool-%n
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd-%n.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_min_interval=0,batch_sched_delay=0
MpiDefault=none
InactiveLimit=0
KillWait=2
MaxArraySize=1001
NodeName=node1 NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=$((base + 1)) CPUs=$cores
NodeName=node2 NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=$((base + 2)) CPUs=$cores
PartitionName=all Nodes=node1,node2 Default=YES MaxTime=INFINITE State=UP
CONF
}

case $verb in
start)
  [ "$(id -u)" = 0 ] || cannot "that takes root"
  for tool in munged slurmctld slurmd srun; do
    command -v $tool >/dev/null || cannot "$tool is missing (apt-get install slurm-wlm munge)"
  done
  mkdir -p "$folder/state" "$folder/spool-node1" "$folder/spool-node2"
  configure
  munged --force --key-file="$folder/key" --socket="$folder/munge.socket" --pid-file="$folder/munged.pid" \
    --log-file="$folder/munged.log" --seed-file="$folder/munged.seed" >/dev/null 2>&1 || cannot "munged does not start"
  slurmctld -c >/dev/null 2>&1 || cannot "slurmctld does not start ($folder/slurmctld.log)"
  for n in 1 2; do
    slurmd -N "node$n" >/dev/null 2>&1 || cannot "slurmd does not start ($folder/slurmd-node$n.log)"
  done
  for _ in $(seq 60); do
    [ "$(sinfo -h -N -t idle -o %N 2>/dev/null | sort -u | wc -l)" = 2 ] && break
    sleep 0.5
  done
  [ "$(sinfo -h -N -t idle -o %N | sort -u | wc -l)" = 2 ] || cannot "the nodes do not answer ($folder/slurmd-*.log)"
  echo "export SLURM_CONF='$SLURM_CONF'" ;;
stop)
  scancel -u root 2>/dev/null || true
  for daemon in slurmd-node1 slurmd-node2 slurmctld munged; do end "$folder/$daemon.pid"; done ;;
*) echo "cluster.sh start|stop FOLDER" >&2; exit 2 ;;
esac
