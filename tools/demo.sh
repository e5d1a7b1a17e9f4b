#!/usr/bin/env bash
# From nothing to pictures on a fresh Debian 12: installs what is needed, builds, renders the embedded scene.
set -euo pipefail
cd "$(dirname "$0")/.."
source tools/install.sh
install_packages without-tests
prepare_environment
cmake --preset release -DSINEW_TESTS=OFF > /dev/null
cmake --build build/release
mkdir -p out
build/release/sinew render -o out/curl_####.png
echo
echo "The pictures are in $PWD/out: curl_0000.png to curl_0047.png, a woman who curls an arm while its biceps swells."
echo "Try: build/release/sinew render YOUR_CHARACTER.glb -o out/character.png"
