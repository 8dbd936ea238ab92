# shellcheck shell=bash disable=SC2034
# Debian packages that ./run and ./test need, and the function that installs the missing ones.
# To be sourced. docs/building.md says what each package is for.

packages_to_build=(
    cmake ninja-build g++
    libglm-dev tao-pegtl-dev libfmt-dev libpng-dev libsleef-dev
    libopenimageio-dev openimageio-tools libtiff-dev libjpeg-dev libseccomp-dev libtinyobjloader-dev
    nlohmann-json3-dev libcli11-dev libboost-dev
)
packages_to_release=(
    git dpkg-dev
)
packages_to_test=(
    libgtest-dev libgmock-dev librapidcheck-dev libbenchmark-dev libmpfr-dev
    povray tachyon clang-format-14 python3 chromium chromium-driver
    lld slurmctld slurmd slurm-client munge make parallel
    "${packages_to_release[@]}" lintian man-db zsh fish
)
packages_to_test_all=(
    clang-14 clang-tidy-14 libclang-rt-14-dev llvm-14
)

# install_missing PACKAGE...: installs those that are missing by apt-get. If none is missing, it
# needs neither root nor a network.
install_missing() {
    if ! command -v dpkg-query > /dev/null || ! command -v apt-get > /dev/null; then
        echo "This is no Debian system: packages are not installed for you (docs/building.md lists them)." >&2
        return 0
    fi
    local package missing=()
    for package in "$@"; do
        [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2> /dev/null)" = installed ] ||
            missing+=("$package")
    done
    [ ${#missing[@]} -gt 0 ] || return 0

    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo > /dev/null || {
            echo "Missing packages: ${missing[*]}" >&2
            echo "Install them as root, or install sudo, and try again." >&2
            return 1
        }
        as_root=(sudo)
    fi
    echo "Installing ${missing[*]}" >&2
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -q >&2 || return 1
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install -q -y --no-install-recommends "${missing[@]}" >&2
}

# configure_and_build PRESET [TARGET...]: configures once, with the options in the array
# configure_options; then the build tool finds what has changed.
configure_options=()
configure_and_build() {
    local preset=$1
    shift
    if command -v ccache > /dev/null; then export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER-ccache}; fi
    if [ ! -f "build/$preset/build.ninja" ]; then cmake --preset "$preset" "${configure_options[@]}" > "build/$preset.log" 2>&1 || {
        cat "build/$preset.log"
        return 1
    }; fi
    cmake --build "build/$preset" ${1:+--target "$@"}
}
