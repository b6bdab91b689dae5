"""Figures for print: every ``draw_*`` takes axes and a result, and returns the axes."""
