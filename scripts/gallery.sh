#!/bin/sh
# gallery.sh PROGRAM: draws every preset into docs/pictures and writes docs/gallery.md, which shows them.
set -eu
program=$1
pictures=docs/pictures/gallery
mkdir -p "$pictures"
{
  echo "# The presets"
  echo
  echo "Each drawn by \`make gallery\` (\`terrella render --preset NAME --time 20\`)."
  "$(dirname "$0")/preset_titles.sh" "$program" | while IFS="$(printf '\t')" read -r name title; do
    "$program" render --preset "$name" --time 20 --size 480x270 --out "$pictures/$name.png"
    echo
    echo "## $title"
    echo
    about=$(python3 -c 'import json, sys; print(json.load(open(sys.argv[1]))["about"])' "presets/$name.json")
    echo "$about."
    echo
    echo "![$title](pictures/gallery/$name.png)"
  done
} > docs/gallery.md
