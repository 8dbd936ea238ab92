#!/bin/bash
# Many scenes: each task of the array takes every N-th one (for stability, every N-th change).
# POV-Ray's pictures, truths and samples are stored in LANCER_CACHE, which all machines must see. A
# last run without --part takes them from there and writes the report of all scenes.
#
#   LANCER_CACHE=/shared/cache sbatch [--array=1-32] sweep.sh REPORT-FOLDER SCENE...
#
# LANCER_SWEEP is the command for each scene: validate (the default), tradeoff or stability.
#SBATCH --job-name=lancer
#SBATCH --array=1-8
#SBATCH --requeue
#SBATCH --open-mode=append
set -u
report=$1
shift
lancer=${LANCER-lancer}
sweep=${LANCER_SWEEP-validate}
cpus=${SLURM_CPUS_PER_TASK-1}
: "${LANCER_CACHE:?name a folder that all machines see}"
export LANCER_CACHE

case $sweep in
    validate) share=(--jobs "$cpus") last=(--report "$report") ;;
    tradeoff) share=(--threads "$cpus" --quiet) last=(--report "$report") ;;
    stability)
        mkdir -p "$report" || exit
        share=(--threads "$cpus" --quiet) last=(--json "$report/stability.json")
        ;;
    *)
        echo "sweep.sh: LANCER_SWEEP is '$sweep', not validate, tradeoff or stability" >&2
        exit 2
        ;;
esac

if [ "$SLURM_ARRAY_TASK_ID" = 1 ] && [ "${SLURM_RESTART_COUNT-0}" = 0 ]; then
    sbatch --job-name=lancer-report --dependency="afterany:$SLURM_ARRAY_JOB_ID" \
        --wrap="$(printf '%q ' "$lancer" "$sweep" "${last[@]}" "$@")" || exit
fi

"$lancer" "$sweep" --part "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" "${share[@]}" "$@"
code=$?
# 1: a scene differs, as the report says. 75: a temporary failure of this machine.
[ $code = 75 ] && [ "${SLURM_RESTART_COUNT-0}" -lt 5 ] &&
    scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID" && sleep 60
exit $code
