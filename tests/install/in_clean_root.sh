#!/usr/bin/env bash
# Runs inside a clean root with Lancer's packages in /tmp: installs, uses and purges them.
set -u
fail() {
    echo "FAILED: $*"
    [ -f /tmp/log ] && cat /tmp/log
    exit 1
}
ok() {
    local words=$1
    shift
    "$@" > /tmp/log 2>&1 || fail "$words"
}
# Everything that belongs to packages or that they could leave behind; dpkg's own records change.
everything() {
    find / -xdev \( -path /proc -o -path /tmp -o -path /var/lib/dpkg -o -path /var/log/dpkg.log \) -prune -o -print | sort
}
# Runs a command as an unprivileged user in a folder of its own.
user() { chroot --userspec=12345:12345 / env HOME=/tmp/home bash -c 'cd /tmp/home && "$@"' x "$@"; }

ldconfig
mkdir /tmp/home && chown 12345:12345 /tmp/home
dpkg --configure --pending > /tmp/log 2>&1
everything > /tmp/before

ok "installing lancer" dpkg -i /tmp/lancer_*.deb
scenes=/usr/share/doc/lancer/scenes
ok "a PNG" user lancer render "$scenes/ten_lines.lancer" --size 160x120 -o room.png
[ -s /tmp/home/room.png ] || fail "there is no PNG"
user lancer render "$scenes/ten_lines.lancer" --size 160x120 -o room.exr > /tmp/log 2>&1
code=$?
if [ $code != 4 ] || ! grep -q lancer-pictures /tmp/log; then fail "an EXR without lancer-pictures: exit code $code"; fi

ok "installing lancer-pictures" dpkg -i /tmp/lancer-pictures_*.deb
ok "an EXR" user lancer render "$scenes/ten_lines.lancer" --size 160x120 -o room.exr
ok "the EXR is the PNG" user lancer compare room.png room.exr --fail 0.01 --fail-percent 1   # of what a PNG clips
ok "validating a scene" user lancer validate "$scenes/shapes/cylinder.lancer" --size 160x120
for file in man/man1/lancer.1.gz man/man1/lancer-render.1.gz bash-completion/completions/lancer \
    zsh/vendor-completions/_lancer fish/vendor_completions.d/lancer.fish doc/lancer/copyright \
    doc/lancer/docs/language.md doc/lancer/examples/picture.mk doc/lancer/scenes/gallery/bracket.lancer doc/lancer-pictures/copyright; do
    [ -s "/usr/share/$file" ] || fail "/usr/share/$file is not there"
done

# A package that another one needs must stay.
dpkg -P lancer > /tmp/log 2>&1 && fail "lancer was purged under lancer-pictures"
ok "purging" dpkg -P lancer-pictures lancer
everything > /tmp/after
diff /tmp/before /tmp/after || fail "purging left something, or took too much"

# The archive, in the folder of an unprivileged user, with the libraries that it contains.
ok "unpacking the archive" user tar -xf /tmp/lancer-*-linux-*.tar.gz
mv /tmp/home/lancer-*-linux-* "/tmp/home/any where"
program="/tmp/home/any where/bin/lancer"
for library in libfmt libpng16 libsleef; do
    ldd "$program" | grep -q "$library.* => /tmp/home/any where/" || fail "the archive does not bring $library"
done
ok "a PNG by the archive's program" user "$program" render "/tmp/home/any where/share/doc/lancer/scenes/ten_lines.lancer" \
    --size 160x120 -o archive.png
cmp /tmp/home/room.png /tmp/home/archive.png || fail "the archive's program draws another picture"
ok "an EXR by the archive's program" user "$program" render "/tmp/home/any where/share/doc/lancer/scenes/ten_lines.lancer" \
    --size 160x120 -o archive.exr
