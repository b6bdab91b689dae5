"""Serve a folder on this machine alone: `python tests/serve.py FOLDER PORT`."""

import errno
import sys
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path


class Handler(SimpleHTTPRequestHandler):
    """Answers without a line for each request."""

    def log_message(self, format: str, *args: object) -> None:
        """Say nothing."""


def server(folder: Path, port: int = 0, handler: type[Handler] = Handler) -> ThreadingHTTPServer:
    """Return a server of the folder on 127.0.0.1; port 0 takes a free one."""
    return ThreadingHTTPServer(("127.0.0.1", port), partial(handler, directory=str(folder)))


def main(folder: str, port: str) -> str | None:
    """Serve until interrupted; return what went wrong."""
    if not port.isdecimal() or not 0 < int(port) < 65536:
        return f"rlswaim: got PORT={port}, wanted a number from 1 to 65535"
    try:
        with server(Path(folder), int(port)) as running:
            print(f"rlswaim: http://127.0.0.1:{port} (Ctrl-C stops)", flush=True)
            running.serve_forever()
    except KeyboardInterrupt:
        return None
    except OSError as error:
        if error.errno not in (errno.EADDRINUSE, errno.EACCES):
            raise
        why = "is taken" if error.errno == errno.EADDRINUSE else "needs more rights"
        return f"rlswaim: port {port} {why}; choose another one, for instance: make serve PORT=8765"
    return None


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
