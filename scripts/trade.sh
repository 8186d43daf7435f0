#!/bin/sh
# trade.sh PROGRAM FOLDER: what the presets of quality cost and give with every preset, as the tables of docs/trade.md on
# standard output. Reports are kept in FOLDER; a preset whose report is there already is not measured again.
set -eu
program=$1
folder=$2
"$(dirname "$0")/preset_titles.sh" "$program" | while IFS="$(printf '\t')" read -r name title; do
  if [ ! -e "$folder/$name/table.md" ]; then
    "$program" measure --preset "$name" --path --quick --out "$folder/$name" > "$folder.log" 2>&1 < /dev/null
  fi
  echo "### $title"
  echo
  cat "$folder/$name/table.md"
  echo
done
