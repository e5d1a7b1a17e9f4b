#!/usr/bin/env bash
# Installs the packages of tools/packages.txt that are missing. Sourced by demo.sh, which leaves out those that only tests
# need, and test.sh.
set -euo pipefail

# A Node.js from elsewhere brings its own npm, and Debian's npm would take that Node.js away.
is_there() {
  case "$1" in
    nodejs) command -v node > /dev/null ;;
    npm) command -v npm > /dev/null ;;
    *) false ;;
  esac
}

install_packages() {
  local wanted missing=() list
  list="$(dirname "${BASH_SOURCE[0]}")/packages.txt"
  if [ "${1:-}" = without-tests ]; then
    mapfile -t wanted < <(sed '/^# Tests alone/,$d' "$list" | grep -vE '^\s*(#|$)')
  else
    mapfile -t wanted < <(grep -vE '^\s*(#|$)' "$list")
  fi
  for package in "${wanted[@]}"; do
    if is_there "$package"; then continue; fi
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing+=("$package")
  done
  if [ ${#missing[@]} -eq 0 ]; then return; fi
  local sudo=""
  if [ "$(id -u)" -ne 0 ]; then sudo="sudo"; fi
  echo "installing (this may take some minutes): ${missing[*]}"
  $sudo apt-get update -qq
  $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" > /dev/null
}

# A runtime folder that Vulkan's drivers look for, and a shader cache of this tree's own.
prepare_environment() {
  export XDG_RUNTIME_DIR="${XDG_RUNTIME_DIR:-$(mktemp -d)}"
  export MESA_SHADER_CACHE_DIR="${MESA_SHADER_CACHE_DIR:-$PWD/build/shader-cache}"
  mkdir -p "$MESA_SHADER_CACHE_DIR"
}
