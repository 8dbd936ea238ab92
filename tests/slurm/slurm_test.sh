#!/usr/bin/env bash
# slurm_test.sh LANCER: tests the recipes of docs/many-machines.md. The scripts of examples/slurm/
# run on a cluster of two nodes, one of which is lost during the run. Exit code 77 (skipped) without
# Slurm or the right to run it, which CI has.
set -u
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
export LANCER=$1
for program in slurmctld slurmd sbatch munged make parallel; do
    command -v "$program" > /dev/null || {
        echo "skipped: there is no $program (cmake/packages.sh)"
        exit 77
    }
done
[ "$(id -u)" = 0 ] || {
    echo "skipped: a cluster's daemons are root's"
    exit 77
}
# shellcheck source=tests/slurm/cluster.sh
source "$root/tests/slurm/cluster.sh"
place=$(mktemp -d "${TMPDIR-/tmp}/lancer-slurm-test-XXXXXX")
finish() {
    stop_cluster
    rm -rf "$place"
}
trap finish EXIT
fail() {
    echo "FAILED: $*"
    sinfo
    squeue
    tail -n 30 "$cluster"/*.log "$place"/*.out
    exit 1
}
cd "$place" || exit 1
cp -r "$root/scenes/gallery" .
scene=gallery/chess.lancer
size=(--size 240x180 --samples 6)

start_cluster || fail "the cluster did not start"
nodes_are_up() { [ "$(sinfo -h -t idle -o %D)" = 2 ]; }
wait_for 20 nodes_are_up || fail "the nodes did not come up"

echo "== a picture in eight parts, of which a lost node takes one along"
sbatch -o "picture-%a.out" "$root/examples/slurm/picture.sh" "$scene" big.png "${size[@]}" || fail "sbatch"
drawing_on_second() { [ -e big.png.parts/1-of-8.exr ] && [ -e big.png.parts/2-of-8.exr ] && [ -n "$(processes_of n2)" ]; }
wait_for 60 drawing_on_second || fail "nothing ran on the second node"
kill_node n2
sleep 6
start_node n2
wait_for 120 queue_is_empty || fail "the queue did not end"
grep -q "requeue" "$cluster/slurmctld.log" || fail "no task was queued anew"
"$LANCER" render "$scene" "${size[@]}" -q -o whole.png || fail "render"
cmp big.png whole.png || fail "joined parts are not the whole"

echo "== once more: nothing is drawn"
before=$(stat -c '%n %Y %i' big.png.parts/*)
for number in 1 2 3 4 5 6 7 8; do
    "$LANCER" render "$scene" "${size[@]}" --resume --part $number/8 -o big.png.parts/$number-of-8.exr > kept.txt 2>&1 ||
        fail "part $number"
    grep -q "^kept" kept.txt || fail "part $number was drawn again: $(cat kept.txt)"
done
[ "$before" = "$(stat -c '%n %Y %i' big.png.parts/*)" ] || fail "a part was written again"

# The first run of each task fails with the code of a temporary failure, and the scripts queue it
# again.
printf '#!/bin/bash\nmark=%q/tired-$SLURM_JOB_ID\n%s\nexec %q "$@"\n' "$place" \
    '[ "$SLURM_JOB_NAME" != lancer ] || [ -e "$mark" ] || { touch "$mark"; exit 75; }' "$LANCER" > tired
chmod +x tired

echo "== a small picture, an animation and a sweep, whose tasks all fail once with exit code 75"
printf 'camera { position [0, 1, 5] look_at [0, 0, 0] } light point { position [4, 6, 3] }\n%s\n' \
    'sphere { radius 1 + 0.1 * frame }' > ball.lancer
cp ball.lancer other.lancer
LANCER=$place/tired sbatch --array=1-2 -o "small-%a.out" "$root/examples/slurm/picture.sh" ball.lancer small.png \
    --size 64x48 --max-error 0.02 || fail "sbatch"
LANCER=$place/tired sbatch --array=1-2 -o "animation-%a.out" "$root/examples/slurm/animation.sh" ball.lancer 1..5 f-%d.png --size 32x24 ||
    fail "sbatch"
LANCER=$place/tired LANCER_CACHE=$place/cache sbatch --array=1-2 -o "sweep-%a.out" "$root/examples/slurm/sweep.sh" \
    report ball.lancer other.lancer || fail "sbatch"
LANCER=$LANCER LANCER_SWEEP=stability LANCER_CACHE=$place/cache sbatch --array=1-2 -o "stability-%a.out" \
    "$root/examples/slurm/sweep.sh" stable ball.lancer || fail "sbatch"
wait_for 120 queue_is_empty || fail "the queue did not end"
"$LANCER" render ball.lancer --frames 1..5 --size 32x24 --resume -o f-%d.png > kept.txt || fail "frames"
grep -q "wrote 0 pictures, kept 5" kept.txt || fail "frames: $(cat kept.txt)"
[ -f report/index.html ] || fail "there is no report"
[ -s stable/stability.json ] || fail "nothing is told of stability"
[ "$(find . -maxdepth 1 -name 'tired-*' | wc -l)" = 6 ] || fail "not every task has failed once"
[ -f small.png ] || fail "the small picture was not joined"
"$LANCER" join small.png.parts/*.exr -o again.png > told.txt || fail "join"
grep -q "^RMSE 0.0" told.txt || fail "no error is told: $(cat told.txt)"
cmp small.png again.png || fail "the small picture is not what its parts are"

echo "== make and GNU parallel"
make -s -j2 -f "$root/examples/picture.mk" LANCER="$LANCER" SCENE=ball.lancer OUT=made.png PARTS=3 OPTIONS='--size 64x48' ||
    fail "make"
mkdir parts
parallel --will-cite -j2 "$LANCER" render ball.lancer --size 64x48 -q --resume --part {}/3 -o parts/{}.exr ::: 1 2 3 || fail "parallel"
"$LANCER" join -q parts/*.exr -o parallel.png || fail "join"
"$LANCER" render -q ball.lancer --size 64x48 -o ball.png || fail "render"
cmp made.png ball.png || fail "make: joined parts are not the whole"
cmp parallel.png ball.png || fail "parallel: joined parts are not the whole"
echo "ok after $SECONDS s"
