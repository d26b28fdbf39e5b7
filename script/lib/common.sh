# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by the other scripts: where the project is, what it needs, and how they speak.
# shellcheck shell=bash

set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

packages=(
  build-essential cmake ninja-build pkg-config python3 clang-format
  libcairo2-dev libflann-dev libgeos-dev libjson-c-dev liblapacke-dev libmypaint-dev libopenimageio-dev libxml2-dev
  zlib1g-dev
  libgimp2.0-dev
  libcmocka-dev
)

# The programs that the plug-ins are tried in, and what looks at their windows.
host_packages=(
  gimp inkscape blender
  python3-lxml python3-cssselect python3-numpy
  xvfb xauth xdotool x11-utils imagemagick openbox
)

# What bench/helpinghand/run needs beside the build.
# shellcheck disable=SC2034
bench_packages=(python3-numpy python3-sklearn)

say() { printf '==> %s\n' "$*"; }

die() {
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

# run_quietly TITLE COMMAND...: prints the command's output only if it fails.
run_quietly() {
  local title=$1 log
  shift
  say "$title"
  log=$(mktemp)
  if ! "$@" >"$log" 2>&1 </dev/null; then
    cat "$log" >&2
    rm -f "$log"
    die "failed: $*"
  fi
  rm -f "$log"
}

# missing_packages PACKAGE...
missing_packages() {
  local package
  for package in "$@"; do
    if ! dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed'; then
      printf '%s\n' "$package"
    fi
  done
}

# install_packages [PACKAGE...]: what the build needs, and these.
install_packages() {
  local -a missing as_root=()
  command -v dpkg-query >/dev/null || die "this needs Debian's packages: ${packages[*]} $*"
  mapfile -t missing < <(missing_packages "${packages[@]}" "$@")
  if [ ${#missing[@]} -eq 0 ]; then
    return
  fi
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || die "not root and no sudo here; have these packages installed: ${missing[*]}"
    as_root=(sudo)
  fi
  as_root+=(env DEBIAN_FRONTEND=noninteractive)
  run_quietly "Reading the package lists" "${as_root[@]}" apt-get update
  run_quietly "Installing ${missing[*]}" "${as_root[@]}" apt-get install -y --no-install-recommends "${missing[@]}"
}

# build PRESET: configures if needed and builds.
build() {
  cd "$root"
  run_quietly "Configuring build/$1" cmake --preset "$1"
  run_quietly "Building build/$1 (some minutes the first time)" cmake --build --preset "$1"
}
