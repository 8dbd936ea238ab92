#!/usr/bin/env bash
# packages_test.sh BUILD: tests the Debian packages of a build. They have the same bytes twice, pass
# lintian, and can be installed, used and purged in a clean Debian, leaving nothing behind. Exit
# code 77 (skipped) without lintian or the right to make a root, which CI has.
set -u
build=$1
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
for program in cpack dpkg-deb dpkg-shlibdeps lintian povray python3; do
    command -v "$program" > /dev/null || {
        echo "skipped: there is no $program (cmake/packages.sh)"
        exit 77
    }
done
if [ "$(id -u)" != 0 ] || ! unshare --mount true 2> /dev/null; then
    echo "skipped: a clean root takes root's rights"
    exit 77
fi
place=$(mktemp -d "${TMPDIR-/tmp}/lancer-packages-XXXXXX")
trap 'rm -rf "$place"' EXIT
fail() {
    echo "FAILED: $*"
    exit 1
}
# ok WORDS COMMAND...: expects the command to succeed; otherwise shows its output.
ok() {
    local words=$1
    shift
    "$@" > "$place/log" 2>&1 || {
        cat "$place/log"
        fail "$words"
    }
}
export SOURCE_DATE_EPOCH=1700000000

# Two runs with whatever may differ between two people.
release() { "$root/release" --build "$build" --pack-size 32x24 -o "$place/$1"; }
ok "a release" release first
(umask 077; TZ=Asia/Tokyo LC_ALL=C.UTF-8 HOME=/nowhere ok "a second release" release second) || exit 1
diff -r "$place/first" "$place/second" || fail "the same sources made other bytes"
cd "$place/first" || exit 1
ls -l
sha256sum --quiet -c SHA256SUMS || fail "SHA256SUMS is wrong"
[ "$(sha256sum --quiet -c --strict SHA256SUMS 2>&1; wc -l < SHA256SUMS)" = 6 ] || fail "SHA256SUMS has not six files"
# Both were packed from one build, so a file's time and owner must not come from there.
for file in *.tar.gz; do tar --full-time --utc -tvf "$file"; done > "$place/list"
for file in *.deb; do dpkg-deb --fsys-tarfile "$file" | tar --full-time --utc -tv; done >> "$place/list"
grep -v 'root/root .* 2023-11-14 22:13:20 ' "$place/list" && fail "another time or owner"
grep -aq "$root" ./*.deb && fail "a package says where it was built"
packed=$(tar -tzf lancer-*-reference-pack.tar.gz | grep -c '/scene.json$')
scenes=$(git -C "$root" ls-tree -r --name-only HEAD scenes | grep '\.lancer$' | grep -vc /bad/)
[ "$packed" = "$scenes" ] || fail "the reference pack has $packed of $scenes scenes"
tar -xzOf lancer-*-reference-pack.tar.gz | grep -aq "$root" && fail "the reference pack says where it was made"
debs=("$PWD"/lancer_*.deb "$PWD"/lancer-pictures_*.deb)
size=$(stat -c %s "${debs[0]}")
[ "$size" -lt 8000000 ] || fail "lancer's package has $size bytes, and may have 8,000,000"

ok "lintian" lintian --fail-on error,warning --allow-root "${debs[@]}"
dpkg-deb -f "${debs[0]}" Depends | grep -qi openimageio && fail "lancer depends on OpenImageIO"
dpkg-deb -f "${debs[1]}" Depends | grep -q libopenimageio || fail "the pictures do not depend on OpenImageIO"

clean=$place/root
mkdir "$clean"
ok "a clean root" python3 "$root/tests/install/clean_root.py" "$clean" --with povray "${debs[@]}"
cp "${debs[@]}" lancer-*-linux-*.tar.gz "$clean/tmp"
cp "$root/tests/install/in_clean_root.sh" "$clean/tmp"
# The mounts disappear with the shell that made them.
# shellcheck disable=SC2016  # $1 is the inner shell's
unshare --mount bash -c '
    mount -t proc proc "$1/proc" && touch "$1/dev/null" && mount --bind /dev/null "$1/dev/null" &&
        exec chroot "$1" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/tmp bash /tmp/in_clean_root.sh' x "$clean" || fail "in the clean root"
echo "packages: done in $SECONDS s"
