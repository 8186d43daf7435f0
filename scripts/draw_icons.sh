#!/bin/sh
# draw_icons.sh [PROGRAM]: draws the page's icons and its preview picture anew, into web/page, by the desktop program.
# The planet keeps off the edges, as phones cut icons round.
set -eu

cd "$(dirname "$0")/.."
terrella=${1:-build/native/terrella}

icon() {
  "$terrella" render --preset temperate --set stars.model=none --set camera.altitude=2.6 --samples 3 --size "$1x$1" --out "web/page/$2"
}
icon 192 icon-192.png
icon 512 icon-512.png
icon 180 apple-touch-icon.png
"$terrella" render --preset temperate --samples 2 --size 1200x630 --out web/page/preview.png
