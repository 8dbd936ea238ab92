#!/bin/bash
# An animation: each task of the array draws every N-th frame.
#
#   sbatch [--array=1-32] animation.sh SCENE A..B OUT-%04d.png [options of lancer render]
#
# Complete frames of this scene are kept: run it again after a crash or a change.
#SBATCH --job-name=lancer
#SBATCH --array=1-8
#SBATCH --requeue
#SBATCH --open-mode=append
set -u
scene=$1 frames=$2 out=$3
shift 3
"${LANCER-lancer}" render "$scene" "$@" --threads "${SLURM_CPUS_PER_TASK-1}" --quiet \
    --frames "$frames" --part "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" --resume -o "$out"
code=$?
# 75: a temporary failure of this machine.
[ $code = 75 ] && [ "${SLURM_RESTART_COUNT-0}" -lt 5 ] &&
    scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID" && sleep 60
exit $code
