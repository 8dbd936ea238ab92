#!/bin/bash
# A picture in parts: as many tasks as the array has, then one that joins them.
#
#   sbatch [--array=1-32] picture.sh SCENE OUT [options of lancer render]
#
# Parts stand in OUT.parts until OUT is there. What is whole is not drawn again: a task that a lost machine took along
# is queued anew by Slurm and goes on, and the same command after a change draws what has changed.
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

# The task that joins waits for all of the array. Once: a task that is queued anew has a count of restarts.
if [ "$number" = 1 ] && [ "${SLURM_RESTART_COUNT-0}" = 0 ]; then
    names=()
    for ((i = 1; i <= parts; ++i)); do names+=("$folder/$i-of-$parts.exr"); done
    sbatch --job-name=lancer-join --dependency="afterok:$SLURM_ARRAY_JOB_ID" --kill-on-invalid-dep=yes \
        --wrap="$(printf '%q ' "$lancer" join "${names[@]}" -o "$out")" || exit
fi

"$lancer" render "$scene" "$@" --threads "${SLURM_CPUS_PER_TASK-1}" --quiet \
    --part "$number/$parts" --resume -o "$folder/$number-of-$parts.exr"
code=$?
# 75: a passing trouble of this machine.
[ $code = 75 ] && [ "${SLURM_RESTART_COUNT-0}" -lt 5 ] && scontrol requeue "${SLURM_ARRAY_JOB_ID}_$number" && sleep 60
exit $code
