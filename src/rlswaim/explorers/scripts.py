"""The built script of all live views and its style sheet, as a front end takes them from a widget.

``make scripts`` builds both from ``js`` and ``css``.
"""

from rlswaim.source.tables import script

MODULE = script("built", "rlswaim-views.js") + "export default rlswaimViews;\n"
"""The script as an ES module: its default export initializes and renders the view that a payload names."""
STYLE = script("built", "rlswaim-views.css")
