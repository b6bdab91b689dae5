"""Figures for print: every ``draw_*`` takes axes and a result, and returns the axes."""

from rlswaim.figures.style import use_book_style

__all__ = ["use_book_style"]
