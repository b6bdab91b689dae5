"""Write into each built page what it may load and run, so that any server sends it: no text runs as code.

An inline script may run if its hash stands in the policy.  Hashes cannot allow an inline
handler, so that the theme's two buttons get a name each, and ``page_buttons.js`` listens to them.
"""

import base64
import hashlib
import re
import shutil
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx

BUTTONS = Path(__file__).parent / "page_buttons.js"
HANDLERS = {'onclick="window.print()"': "print", 'onclick="toggleFullScreen()"': "full-screen"}
SCRIPT = re.compile(r"<script(?P<attributes>[^>]*)>(?P<text>.*?)</script>", re.DOTALL)
META = re.compile(r'\n *<meta http-equiv="Content-Security-Policy"[^>]*>')
POLICY = (
    "default-src 'self'; base-uri 'self'; object-src 'none'; script-src 'self' blob: {hashes}; "
    "worker-src 'self' blob:; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
    "font-src 'self' data:; connect-src 'self' blob:"
)


def inline_scripts(page: str) -> list[str]:
    """Return the texts of a page's inline scripts, without those that hold data alone."""
    return [
        found["text"]
        for found in SCRIPT.finditer(page)
        if "src=" not in found["attributes"] and "json" not in found["attributes"]
    ]


def content_hash(text: str) -> str:
    """Return the hash of an inline script as a policy names it."""
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"


def with_policy(page: str) -> str:
    """Return a page with its policy as the first element of its head, and without inline handlers."""
    for handler, name in HANDLERS.items():
        page = page.replace(handler, f'data-page-button="{name}"')
    hashes = sorted({content_hash(text) for text in inline_scripts(page)})
    policy = POLICY.format(hashes=" ".join(hashes))
    meta = f'\n    <meta http-equiv="Content-Security-Policy" content="{policy}">'
    return META.sub("", page).replace("<head>", f"<head>{meta}", 1)


def write(app: Sphinx, exception: Exception | None) -> None:
    """Put the policy into all pages, those of an earlier build too."""
    if exception is None and app.builder.format == "html":
        out = Path(app.outdir)
        shutil.copy(BUTTONS, out / "_static" / BUTTONS.name)
        for path in out.rglob("*.html"):
            path.write_text(with_policy(path.read_text(encoding="utf-8")), encoding="utf-8")


def setup(app: Sphinx) -> dict[str, Any]:
    """Register with Sphinx, after all that writes into pages."""
    app.connect("build-finished", write, priority=900)
    app.add_js_file(BUTTONS.name)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
