#!/bin/sh
# serve.sh FOLDER: serves a folder to this machine only, at port 8000 or the next one that is free.
set -eu

port=$(python3 - <<'PYTHON'
import socket
port = 8000
while True:
    with socket.socket() as probe:
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind(("127.0.0.1", port))
            break
        except OSError:
            port += 1
print(port)
PYTHON
)
echo "Terrella is at http://127.0.0.1:$port/ (Ctrl-C ends it)"
exec python3 -m http.server --bind 127.0.0.1 --directory "$1" "$port" >/dev/null 2>&1
