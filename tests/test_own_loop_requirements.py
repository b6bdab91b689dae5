"""What is asked of one's own loop, in s and in z: verdicts against numpy and python-control, the region."""

import base64
from io import BytesIO

import control
import matplotlib.pyplot as plt
import numpy as np
import pytest

import rlswaim as rl
from livepage import number
from standin import SITE, opened
from test_requirement_panel import PANEL, ask, row
from workbench_page import picture

LOOPS = {
    "s": (control.tf([1], [1, 2, 2, 0]), 0.6),
    "z": (control.tf([0.1, 0.08], [1, -1.5, 0.55], 0.1), 0.7),
    "z without time": (control.tf([0.1, 0.08], [1, -1.5, 0.55], True), 0.7),
    "z, a pole on the negative axis": (control.tf([1], np.poly([0.5, -0.4, 0.1]), 0.2), 0.05),
    "margin at frequency 0": (control.tf([1], [1, -1]), 1.5),
}


@pytest.fixture(params=LOOPS)
def named(browser, request):
    loop, k = LOOPS[request.param]
    with opened(browser, rl.explore(loop, k)) as page:
        page.evaluate("panel => { el.querySelector(panel).open = true; }", PANEL)
        yield page, loop, k


def limits_of(loop, k: float) -> dict[str, float]:
    """Return what python-control and numpy find of the closed loop, by the name of each requirement."""
    poles = control.feedback(k * loop).poles()
    period = 1.0 if loop.dt is True else loop.dt
    s = np.log(poles.astype(complex)) / period if period else poles
    zeta = (-s.real / abs(s)).min()
    margins = control.stability_margins(k * loop, returnall=True)
    gains = [abs(20 * np.log10(g)) for g in margins[0] if np.isfinite(g) and g > 0]
    phases = [abs((p + 180) % 360 - 180) for p in margins[1]]
    found = {"zeta": zeta, "settling": np.log(50) / (-s.real).min(), "sigma": (-s.real).min()}
    found |= {"overshoot": 100 * np.exp(-np.pi * zeta / np.sqrt(1 - zeta**2)) if zeta < 1 else 0.0}
    if period:
        found |= {"radius": abs(poles).max()}
        del found["sigma"]
    return found | {"gain": min(gains, default=np.inf), "phase": min(phases, default=np.inf)}


def test_each_holds_up_to_what_the_loop_has(named):
    page, loop, k = named
    ceilings = {"settling", "overshoot", "radius"}
    for kind, limit in limits_of(loop, k).items():
        if kind == "zeta" and limit > 0.999:
            assert ask(page, kind, 0.999).startswith("holds: 1")
            continue
        if kind == "overshoot" and limit == 0:
            assert ask(page, kind, 0.1).startswith("holds: 0 %")
            continue
        if not np.isfinite(limit) or limit > 175:
            assert ask(page, kind, 60).startswith("holds")
            continue
        below, above = ask(page, kind, 0.9995 * limit), ask(page, kind, 1.0005 * limit)
        good, bad = (above, below) if kind in ceilings else (below, above)
        assert good.startswith("holds: "), (kind, limit, good)
        assert bad.startswith("does not hold: "), (kind, limit, bad)
        assert number(bad.split(": ")[1].split(" ")[0].strip("°")) == pytest.approx(limit, rel=0.006)
    offered = {"s": "sigma", "z": "radius"}["z" if loop.dt else "s"]
    assert row(page, offered).is_visible()
    assert not row(page, {"sigma": "radius", "radius": "sigma"}[offered]).is_visible()


def test_units_are_those_of_the_loop(browser):
    for name, unit in {"z": "s", "z without time": "samples"}.items():
        loop, k = LOOPS[name]
        with opened(browser, rl.explore(loop, k)) as page:
            page.evaluate("panel => { el.querySelector(panel).open = true; }", PANEL)
            said = ask(page, "settling", 1000)
            assert said.split(" (")[0].split(" ")[-1] == unit
            assert ask(page, "phase", 1).endswith("rad/sample" if name.endswith("time") else "rad/s")


WINDOW = f"{SITE}#own-loop:view.window=0_-0.07_2.4"  # z from -1.2 to 1.2, the lower border at -0.07j
LEFT, RIGHT, BELOW = 44, 10, 36  # px of margin about the plane


def pixels(page) -> np.ndarray:
    found = plt.imread(BytesIO(base64.b64decode(picture(page).split(",")[1])))
    return np.rint(255 * found[..., :3]).astype(int)


@pytest.mark.parametrize(("kind", "bound"), [("radius", 0.7), ("zeta", 0.5), ("settling", 1.5)])
def test_the_region_in_z_is_hatched_where_no_pole_may_be(browser, kind, bound):
    """A pixel changes only where the bound says that no pole may be, and in each part of that region."""
    with opened(browser, rl.explore(*LOOPS["z"]), WINDOW) as page:
        page.evaluate("panel => { el.querySelector(panel).open = true; }", PANEL)
        page.wait_for_timeout(200)
        before = pixels(page)
        ask(page, kind, bound)
        after = pixels(page)
        rows, columns = np.nonzero(abs(before - after).sum(axis=2) > 30)
        height, width = before.shape[:2]
        scale = (width - LEFT - RIGHT) / 2.4
        z = (columns - LEFT) / scale - 1.2 + 1j * ((height - BELOW - rows) / scale - 0.07)
        seen = z[(z.imag > 0.02) & (abs(z) > 0.02)]
        limit = {"radius": bound, "settling": 50 ** (-0.1 / bound)}.get(kind)

        def border(angle):
            return np.exp(-angle * bound / np.sqrt(1 - bound**2)) if limit is None else limit

        assert (border(np.angle(seen)) - abs(seen)).max() < 0.02
        for angle in (0.4, 1.2, 2.0, 2.8):
            near = seen[abs(np.angle(seen) - angle) < 0.2]
            for beyond in (border(angle) + 0.07, 1.1):
                assert (abs(abs(near) - beyond) < 0.05).sum() > 5, (angle, beyond)
