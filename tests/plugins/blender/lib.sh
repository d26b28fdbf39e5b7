# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by the tests: a Blender with a home of its own, which sees nothing of the user's and leaves nothing behind.
# shellcheck shell=bash
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

# need PROGRAM...: ends the test as skipped (77) where one is missing, or as failed where CI is "true".
need() {
  local program
  for program in "$@"; do
    if ! command -v "$program" >/dev/null; then
      echo "$program is not installed"
      [ "${CI:-}" = true ] && exit 1
      exit 77
    fi
  done
}

home=$(mktemp -d)
trap 'rm -rf "$home"' EXIT
export HOME=$home BLENDER_USER_SCRIPTS=$home/scripts BLENDER_USER_CONFIG=$home/config TMPDIR=$home
export PYTHONDONTWRITEBYTECODE=1
mkdir -p "$BLENDER_USER_SCRIPTS/addons" "$BLENDER_USER_CONFIG"

# link_addon: the add-on as the build has put it together.
link_addon() {
  ln -s "$DUCTUS_BUILD/plugins/blender/ductus_addon" "$BLENDER_USER_SCRIPTS/addons/ductus_addon"
}
