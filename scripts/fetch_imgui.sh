#!/bin/sh
# fetch_imgui.sh FOLDER: puts Dear ImGui's sources into FOLDER, from Debian's source package.
#
# Debian's libimgui-dev has no sources that could be compiled for the browser, and in bookworm it is too old. So this
# asks apt for the source package of trixie: from the mirror that this machine already uses, with a state of its own,
# so that neither the machine's settings nor root are touched. Fails where there is no such mirror; cmake/imgui.cmake
# then goes elsewhere.
set -eu

folder=$1
suite=trixie
sha256=ecce377df0f90b292f15dcbd83d438bddc162b2388c881132bde18c787572a1c # imgui_1.90.1+ds.orig.tar.xz

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/lists/partial" "$work/cache/archives/partial" "$work/parts" "$work/unpacked"

private_apt() {
  (cd "$work" && apt-get -qq -o Dir::State::Lists="$work/lists" -o Dir::Cache="$work/cache" \
    -o Dir::Etc::SourceList="$work/sources.list" -o Dir::Etc::SourceParts="$work/parts" \
    -o APT::Sandbox::User= -o Acquire::Languages=none "$@")
}

fetch_from() {
  echo "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $1 $suite main" >"$work/sources.list"
  private_apt update && private_apt source --download-only imgui &&
    echo "$sha256  $(echo "$work"/imgui_*.orig.tar.xz)" | sha256sum --check --quiet
}

# Where no lists were fetched yet, the label is empty: then each mirror is worth a try. The signature decides.
# shellcheck disable=SC2016 # apt fills these in
mirrors=$(apt-get indextargets --format '$(LABEL)|$(REPO_URI)' 'Created-By: Packages' |
  sed -n 's/^Debian|//p; s/^|//p' | sort -u)
for mirror in $mirrors; do
  if fetch_from "$mirror"; then
    tar -xf "$work"/imgui_*.orig.tar.xz -C "$work/unpacked" --strip-components=1
    mkdir -p "$(dirname "$folder")"
    rm -rf "$folder"
    mv "$work/unpacked" "$folder"
    exit 0
  fi
done
echo "Debian's archive is not among this machine's apt sources, or has no such source package" >&2
exit 1
