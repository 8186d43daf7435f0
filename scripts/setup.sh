#!/bin/sh
# setup.sh native|web|test|bench|format: installs what that needs and this machine lacks; nothing if it lacks nothing.
#
# What is there is told by its commands and files, not by packages: it may have come from anywhere.
set -eu

packages=""
lacks() { packages="$packages $1"; }

# command_from PACKAGE COMMAND...: any one of the commands will do.
command_from() {
  package=$1
  shift
  for name in "$@"; do
    if command -v "$name" >/dev/null; then return; fi
  done
  lacks "$package"
}

# file_from PACKAGE PATTERN: a file below /usr or /usr/local, with any folder of a machine's type in between.
file_from() {
  for file in /usr/$2 /usr/local/$2; do
    if [ -e "$file" ]; then return; fi
  done
  lacks "$1"
}

header_from() { file_from "$1" "include/$2"; }

build_tools() {
  command_from cmake cmake
  command_from ninja-build ninja
  command_from glslang-tools glslangValidator glslang
  command_from xz-utils xz
  command_from libharfbuzz-bin hb-subset
  file_from fonts-roboto-unhinted "share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Regular.ttf"
  header_from libglm-dev glm/glm.hpp
  header_from nlohmann-json3-dev nlohmann/json.hpp
}

native() {
  build_tools
  command_from g++ c++
  command_from pkg-config pkg-config
  header_from libcli11-dev CLI/CLI.hpp
  header_from libglfw3-dev GLFW/glfw3.h
  header_from libepoxy-dev epoxy/gl.h
  header_from libegl-dev EGL/egl.h
  header_from libpng-dev png.h
  header_from libgtest-dev gtest/gtest.h
  header_from libgmock-dev gmock/gmock.h
  header_from libx11-dev X11/Xlib.h # hands and eyes of the tests of the window
  header_from libxtst-dev X11/extensions/XTest.h
  # A driver that draws without a graphics card, for the tests and for `terrella render`.
  file_from libgl1-mesa-dri "lib/*/dri/swrast_dri.so"
  file_from libegl-mesa0 "share/glvnd/egl_vendor.d/*.json"
}

web() {
  build_tools
  command_from emscripten em++ # brings the python3 that serves the page
  command_from esbuild esbuild
}

browser() {
  command_from nodejs node
  command_from npm npm
  if grep -q '^ID=ubuntu' /etc/os-release 2>/dev/null; then
    command_from chromium-browser chromium chromium-browser google-chrome
  else
    command_from chromium chromium chromium-browser google-chrome
  fi
}

case ${1-} in
  native) native ;;
  web) web ;;
  test) native && web && browser && command_from xvfb Xvfb ;;
  bench) native && web && browser && header_from libbenchmark-dev benchmark/benchmark.h ;;
  format) command_from clang-format clang-format ;;
  *) sed -n 's/^# \(setup.sh .*\)/\1/p' "$0" >&2; exit 2 ;;
esac

packages=$(echo "$packages" | tr ' ' '\n' | sort -u | tr '\n' ' ')
packages=${packages# }
packages=${packages% }
if [ -z "$packages" ]; then exit 0; fi

if ! command -v apt-get >/dev/null; then
  echo "This machine lacks (by the names that Debian gives them): $packages"
  echo "Install them with your package manager, then try again."
  exit 1
fi >&2

install="apt-get update && DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $packages"
echo "Installing: $packages"
if [ "$(id -u)" = 0 ]; then
  sh -c "$install"
elif ! command -v sudo >/dev/null || ! sudo sh -c "$install"; then
  echo "Run this as root, then try again:" >&2
  echo "  $install" >&2
  exit 1
fi
