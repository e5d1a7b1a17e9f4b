#!/bin/sh
# Renders the golden pictures of tests/golden anew: run it after a change that is meant to be seen, look at what
# `git diff --stat tests/golden` names, and commit the pictures with the change.
# Usage: tools/update_goldens.sh [BUILD], the folder of a finished build (default: build/release).
set -eu
cd "$(dirname "$0")/.."
build=${1:-build/release}
tests=$build/tests/golden_tests
if [ ! -x "$tests" ]; then
  echo "error: $tests is missing; build it first (cmake --build $build)" >&2
  exit 1
fi
SINEW_UPDATE_GOLDENS=1 "$tests" --gtest_filter='*Golden.IsWhatItWas*' --gtest_brief=1
echo "$(find tests/golden -name '*.png' | wc -l) pictures in tests/golden; look at them before they are committed"
