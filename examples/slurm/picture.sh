#!/bin/bash
# A picture in parts: each task of the array draws one part, then one more task joins them.
#
#   sbatch [--array=1-32] picture.sh SCENE OUT [options of lancer render]
#
# The parts are in OUT.parts until OUT exists. Complete parts are not drawn again. Slurm queues a
# task again when its machine is lost, and the task continues. After a change, the same command
# draws what has changed.
#SBATCH --job-name=lancer
#SBATCH --array=1-8
#SBATCH --requeue
#SBATCH --open-mode=append
set -u
scene=$1 out=$2
shift 2
lancer=${LANCER-lancer}
number=$SLURM_ARRAY_TASK_ID parts=$SLURM_ARRAY_TASK_COUNT
folder=$out.parts
mkdir -p "$folder" || exit 75

# The joining task waits for the whole array. It is queued only once: a task that was queued again
# has a restart count.
if [ "$number" = 1 ] && [ "${SLURM_RESTART_COUNT-0}" = 0 ]; then
    names=()
    for ((i = 1; i <= parts; ++i)); do names+=("$folder/$i-of-$parts.exr"); done
    sbatch --job-name=lancer-join --dependency="afterok:$SLURM_ARRAY_JOB_ID" --kill-on-invalid-dep=yes \
        --wrap="$(printf '%q ' "$lancer" join "${names[@]}" -o "$out")" || exit
fi

"$lancer" render "$scene" "$@" --threads "${SLURM_CPUS_PER_TASK-1}" --quiet \
    --part "$number/$parts" --resume -o "$folder/$number-of-$parts.exr"
code=$?
# 75: a temporary failure of this machine.
[ $code = 75 ] && [ "${SLURM_RESTART_COUNT-0}" -lt 5 ] && scontrol requeue "${SLURM_ARRAY_JOB_ID}_$number" && sleep 60
exit $code
