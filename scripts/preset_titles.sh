#!/bin/sh
# preset_titles.sh PROGRAM: name and title of every preset, a line each, with a tab between.
set -eu
"$1" presets --json | python3 -c '
import json, sys
for preset in json.load(sys.stdin):
    print(preset["name"], preset["title"], sep="\t")
'
