#!/usr/bin/env bash
# Installs the Khronos glTF validator into build/validator, for tests/cli/validator_test.cpp. Nothing outside the tree is
# touched. Where npm or its registry cannot be reached it says so and fails; the test then says that it was skipped, or
# fails where SINEW_REQUIRE_ASSETS is 1.
set -euo pipefail
cd "$(dirname "$0")/.."

version=2.0.0-dev.3.10
folder=build/validator
installed=$folder/node_modules/gltf-validator/package.json
if grep -qs "\"version\": \"$version\"" "$installed"; then exit 0; fi
mkdir -p "$folder"
npm install --prefix "$folder" --no-save --no-audit --no-fund --loglevel=error "gltf-validator@$version" > /dev/null
grep -q "\"version\": \"$version\"" "$installed"
