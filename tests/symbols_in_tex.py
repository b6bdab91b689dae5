r"""The symbols that a piece of TeX uses: ``\frac{K_A K_{z_a}}{\phi_1(z)}`` has K_A, K_{z_a}, \phi_1(z) and z.

Derivatives, dots and powers are operations, and so no part of a symbol; a bar and a subscript are.
An argument is a part of it where it names a place (G, RG, r, a sensor), not where it is a variable.
"""

import re

PLACE = re.compile(r"\\(?:printed|turned|plus|minus)\{[^{}]*\}")
WORDS = re.compile(r"\\text\{[^{}]*\}|\\(?:begin|end)\{[^{}]*\}(?:\{[c|]+\})?")
OPERATOR = re.compile(
    r"\\(?:frac|dfrac|int|sum|sin|tan|ln|partial|left|right|[bB]igl?|[bB]igr|overline|cancel|quad|text|small"
    r"|cong|geq|pm|times|dot|ddot|hline|[,;!\\{}. ])(?![A-Za-z])"
    r"|d(?=\\ell|\\tau|F_A)"
)
ARGUMENT = re.compile(r"\((G,t|G|RG|r|z_a|z_b|z)\)")
LETTER = re.compile(r"\\mathcal\{[A-Z]\}|\\bar\s*(?:\\[a-z]+|[A-Za-z])|\\[A-Za-z]+|RG|[A-Za-z]")
MODE = re.compile(r"[A-Z]_\{([12])")


def group(tex: str, at: int) -> tuple[str, int]:
    """Return the group that begins at a place: one letter or command, or what stands in braces."""
    if tex[at] != "{":
        found = re.compile(r"\\[A-Za-z]+|.").match(tex, at)
        return found[0], found.end()
    depth, end = 1, at + 1
    while depth:
        depth += {"{": 1, "}": -1}.get(tex[end], 0)
        end += 1
    return tex[at + 1 : end - 1], end


def bare(tex: str) -> str:
    """Return a symbol without spaces, and without braces about one letter, digit or command."""
    tex = re.sub(r"\s+(?![A-Za-z])|(?<![a-z])\s+", "", tex)
    return re.sub(r"(?<=[_^])\{(\\?[A-Za-z]+|\d)\}", lambda m: m[1] if len(m[1]) == 1 else m[0], tex)


def symbols_in(tex: str) -> set[str]:
    """Return the symbols of a piece of TeX, each one once."""
    tex = WORDS.sub(" ", PLACE.sub(" ", tex))
    found, at = set(), 0
    while at < len(tex):
        if skip := OPERATOR.match(tex, at):
            at = skip.end()
            continue
        letter = LETTER.match(tex, at)
        if not letter:
            at += 1
            continue
        name, at = letter[0], letter.end()
        while at < len(tex) and tex[at] in "_^":
            inner, end = group(tex, at + 1)
            name += f"_{{{inner}}}" if tex[at] == "_" else ""
            if tex[at] == "^":
                found |= symbols_in(inner)
            at = end
        if place := ARGUMENT.match(tex, at) if name.startswith((r"\phi", r"\sigma", r"\xi")) else None:
            name, at = name + place[0], place.end()
            found |= symbols_in(place[1])
        found.add(bare(name))
    return found
