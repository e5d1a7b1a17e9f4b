#!/usr/bin/env bash
# Installs what is needed, builds and runs every test: once as released, and what needs no device under the address and
# undefined-behaviour sanitizers as well. Real characters are tested where SINEW_ASSETS names their folder.
set -euo pipefail
cd "$(dirname "$0")/.."
source tools/install.sh
install_packages
prepare_environment

bash tools/install_validator.sh || echo "The Khronos glTF validator is missing: its test will be SKIPPED, or fail where assets are required."

cmake --preset release -DSINEW_TESTS=ON > /dev/null
cmake --build build/release
cmake --preset asan -DSINEW_VULKAN=OFF > /dev/null
cmake --build build/asan

if [ -z "${SINEW_ASSETS:-}" ]; then
  echo "SINEW_ASSETS is not set: tests with real characters will be SKIPPED."
fi
# Pictures are compared with ones that Mesa's CPU driver made.
lavapipe=/usr/share/vulkan/icd.d/lvp_icd.x86_64.json
if [ -e "$lavapipe" ]; then export VK_DRIVER_FILES="${VK_DRIVER_FILES:-$lavapipe}"; fi
ctest --test-dir build/asan --output-on-failure -j "$(nproc)"
ctest --test-dir build/release --output-on-failure -j "$(nproc)"
