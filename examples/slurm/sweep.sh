#!/bin/bash
# Many scenes: each task of the array validates every N-th one. What POV-Ray draws is kept in LANCER_CACHE, which all
# machines must see; a last run without --part takes it from there and writes the report of them all.
#
#   LANCER_CACHE=/shared/cache sbatch [--array=1-32] sweep.sh REPORT-FOLDER SCENE...
#SBATCH --job-name=lancer
#SBATCH --array=1-8
#SBATCH --requeue
#SBATCH --open-mode=append
set -u
report=$1
shift
lancer=${LANCER-lancer}
: "${LANCER_CACHE:?name a folder that all machines see}"
export LANCER_CACHE

if [ "$SLURM_ARRAY_TASK_ID" = 1 ] && [ "${SLURM_RESTART_COUNT-0}" = 0 ]; then
    sbatch --job-name=lancer-report --dependency="afterany:$SLURM_ARRAY_JOB_ID" \
        --wrap="$(printf '%q ' "$lancer" validate --report "$report" "$@")" || exit
fi

"$lancer" validate --part "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" --jobs "${SLURM_CPUS_PER_TASK-1}" "$@"
code=$?
# 1: a scene differs, which the report says. 75: a passing trouble of this machine.
[ $code = 75 ] && [ "${SLURM_RESTART_COUNT-0}" -lt 5 ] &&
    scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID" && sleep 60
exit $code
