"""A workbench on a page of its own: its planes, where its poles stand on the page, and its redraws."""

import numpy as np
from playwright.sync_api import Page

import rlswaim as rl
from rlswaim import explorers
from standin import table

EQUATIONS = rl.printed_equations()
VIEWS = {
    "IV": explorers.rate_attitude_explorer,
    "V": explorers.single_sensor_explorer,
    "VI": explorers.two_sensor_explorer,
    "VII": explorers.dual_actuation_explorer,
}


def locus(page: Page):
    return page.locator("canvas[data-plane=locus]")


def picture(page: Page, plane: str = "locus") -> str:
    return page.evaluate("plane => el.querySelector(`[data-plane=${plane}]`).toDataURL()", plane)


def marks(page: Page) -> np.ndarray:
    """Return where the poles stand on the page, px: shape (n, 2), nan where they are not shown."""
    return np.array(
        page.evaluate(
            """() => [...el.querySelectorAll('.handles button')].map((button) => {
                 const { x, y, width, height } = button.getBoundingClientRect();
                 return button.hidden ? [NaN, NaN] : [x + width / 2, y + height / 2];
               })"""
        ),
        dtype=float,
    )


def to_pixels(page: Page, pole: complex) -> tuple[float, float]:
    """Return where a pole stands on the page: two shown marks fix the scale."""
    at, poles = marks(page), table(page)
    shown = [i for i in range(len(poles)) if not np.isnan(at[i, 0])]
    i, j = max(shown, key=lambda k: poles[k].real), min(shown, key=lambda k: poles[k].real)
    scale = (at[i, 0] - at[j, 0]) / (poles[i].real - poles[j].real)
    x = at[i, 0] + scale * (pole.real - poles[i].real)
    return x, at[i, 1] - scale * (pole.imag - poles[i].imag)


def scale_of(page: Page) -> float:
    return abs(to_pixels(page, 1j)[1] - to_pixels(page, 0j)[1])


def one(page: Page, act) -> None:
    """Do something and wait for the drawing that follows."""
    page.evaluate("() => { window.next = drawn(); }")
    act()
    page.evaluate("() => window.next")


def mode_2(**gains: float) -> complex:
    """Return the upper pole near mode 2."""
    given = {"K_A": 1.8, "K_C": 10, "K_R": 0.618, "gyro": 60, **gains}  # else those of Figure 8
    poles = rl.rate_attitude(EQUATIONS, **given).poles()
    return min((p for p in poles if p.imag > 0), key=lambda p: abs(p - (0.5 + 3j)))
