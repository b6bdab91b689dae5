"""The built book without MathJax and the theme's icons: formulas stay text, and pages open with less work."""

from pathlib import PurePosixPath
from urllib.parse import urlsplit

from serve import Handler

STAND_INS = {
    "tex-chtml.js": b"MathJax.startup = { ...MathJax.startup, promise: Promise.resolve() };",
    "fontawesome.js": b"",
}
"""What scripts that no view needs are answered with, by the names of their files."""


class PlainHandler(Handler):
    """Answers a page's scripts for formulas and icons with stand-ins, and all else from the folder."""

    def do_GET(self) -> None:
        """Answer."""
        name = PurePosixPath(urlsplit(self.path).path).name
        if name in STAND_INS:
            self.answer(STAND_INS[name], "text/javascript")
        else:
            super().do_GET()

    def answer(self, body: bytes, kind: str) -> None:
        """Answer with a text of a kind."""
        self.send_response(200)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)
