"""What a reader takes away from a workbench and comes back with: links, pictures, tables, code."""

import csv
import io
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from playwright.sync_api import Page

from standin import opened, show, table
from workbench_page import locus, one, picture


class TestAddress:
    def test_a_link_gives_the_same_view(self, browser, page, explorer):
        show(page, K_A=-2.5, K_R=0.25, gyro=96, feedback="total")
        one(page, lambda: page.locator(".bar select").first.select_option("K_C"))
        one(page, lambda: page.locator("[data-panel=responses] select").first.select_option("1"))
        locus(page).focus()
        one(page, lambda: page.keyboard.press("+"))
        page.wait_for_function("location.hash.includes('view.window')")
        address = page.evaluate("location.href")
        assert address.split("#")[1].startswith(
            "rate-attitude:K_A=-2.5,K_C=10,K_R=0.25,gyro=96,feedback=total"
        )
        with opened(browser, explorer, address) as other:
            other.wait_for_function("state.gyro === 96")
            other.wait_for_timeout(100)
            assert (table(other) == table(page)).all()
            assert picture(other) == picture(page)
            for plane in ("map", "responses"):
                for where in (page, other):
                    where.locator(f"canvas[data-plane={plane}]").scroll_into_view_if_needed()
                    where.wait_for_timeout(100)
                    where.wait_for_function("!el.querySelector('.stale')")
                assert picture(other, plane) == picture(page, plane)

    def test_other_parts_and_nonsense_are_left_alone(self, browser, explorer):
        address = (
            "about:blank#single-sensor:K_z=2&rate-attitude:K_A=nan,gyro=3.5,K_R=0.25,feedback=%ZZ,K_C=%E0%A4"
        )
        with opened(browser, explorer, address) as page:
            page.wait_for_function("state.K_R === 0.25")
            assert page.evaluate("[state.K_A, state.gyro, state.feedback, state.K_C]") == [
                1.8,
                60,
                "total",
                10,
            ]
            show(page, K_A=4.0)
            page.wait_for_function("location.hash.includes('K_A=4')")
            assert page.evaluate("location.hash").startswith("#single-sensor:K_z=2&rate-attitude:K_A=4,")
            page.get_by_role("button", name="Reset").click()
            page.wait_for_function("location.hash === '#single-sensor:K_z=2'")

    def test_a_link_counts_though_the_view_writes_before_the_page_tells_of_it(self, page):
        """What a view shows is written a moment after its drawing, perhaps just after a click on a link."""
        page.evaluate(
            """() => {
                location.hash = '#rate-attitude:K_A=4'
                history.replaceState(null, '', location.pathname)
            }"""
        )
        page.wait_for_function("state.K_A === 4", timeout=5000)
        page.wait_for_function("location.hash.includes('K_A=4')", timeout=5000)

    def test_an_untouched_view_leaves_the_address(self, browser, explorer):
        with opened(browser, explorer, "about:blank#fig-8") as page:
            page.wait_for_timeout(300)
            assert page.evaluate("location.hash") == "#fig-8"


class TestTakeAway:
    @pytest.fixture
    def page(self, browser, explorer):
        with opened(browser, explorer, accept_downloads=True) as page:
            page.locator("[data-panel=takeaway] summary").click()
            yield page

    def saved(self, page: Page, name: str) -> str:
        with page.expect_download() as download:
            page.get_by_role("button", name=name).click()
        return Path(download.value.path()).read_text(encoding="utf-8")

    def test_the_picture_is_svg(self, page):
        page.wait_for_function("el.querySelector('canvas').ariaLabel ?? false")
        show(page, magnify=10)
        text = self.saved(page, "Picture (SVG)")
        root = ElementTree.fromstring(text)
        space = "{http://www.w3.org/2000/svg}"
        assert root.tag == f"{space}svg"
        assert "NaN" not in text
        assert "Root locus in K_A" in root.find(f"{space}title").text
        colors = {path.get("stroke") for path in root.iter(f"{space}path")}
        assert set(page.evaluate("Object.values(state.payload.branches)")) <= {
            (c or "").upper() for c in colors
        } | {c for c in colors if c}
        assert "Re s (1/s)" in {text.text for text in root.iter(f"{space}text")}

    def test_the_svg_looks_like_the_canvas(self, browser, page):
        text = self.saved(page, "Picture (SVG)")
        sizes = page.evaluate(
            """async (svg) => {
                 const image = new Image();
                 image.src = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
                 await image.decode();
                 const shown = el.querySelector('[data-plane=locus]');
                 const { width, height } = shown;
                 const made = Object.assign(document.createElement('canvas'), { width, height });
                 const g = made.getContext('2d');
                 g.drawImage(image, 0, 0, width, height);
                 const both = [g, shown.getContext('2d')];
                 const [a, b] = both.map((c) => c.getImageData(0, 0, width, height).data);
                 let off = 0;
                 for (let k = 0; k < a.length; k += 4) off += b[k + 3] && Math.abs(a[k] - b[k]) > 64 ? 1 : 0;
                 return off / (a.length / 4);
               }""",
            text,
        )
        assert sizes < 0.01

    def test_the_poles_are_those_of_the_table(self, page):
        rows = list(csv.DictReader(io.StringIO(self.saved(page, "Poles (CSV)"))))
        poles = np.array([complex(float(r["real (1/s)"]), float(r["imaginary (1/s)"])) for r in rows])
        assert (poles == table(page)).all()
        assert [r["leaves from"] for r in rows] == page.evaluate(
            "[...el.querySelectorAll('.poles tbody tr')].map((row) => row.dataset.branch)"
        )

    def test_names_and_table_tell_the_gains(self, page):
        show(page, K_A=-2.5, feedback="rigid body")
        with page.expect_download() as download:
            page.get_by_role("button", name="Poles (CSV)").click()
        given = "K_A=-2.5_K_C=10_K_R=0.618_gyro=60_feedback=rigid-body"
        assert download.value.suggested_filename == f"rate-attitude_{given}_poles.csv"
        rows = list(csv.DictReader(io.StringIO(Path(download.value.path()).read_text(encoding="utf-8"))))
        assert len(rows) == len(table(page))
        for row in rows:
            assert (float(row["K_A"]), float(row["K_R"]), row["gyro"]) == (-2.5, 0.618, "60")
            assert row["feedback"] == "rigid body"
        with page.expect_download() as download:
            page.get_by_role("button", name="Picture (SVG)").click()
        assert download.value.suggested_filename == f"rate-attitude_{given}_locus.svg"

    def test_no_clipboard_is_said_in_words(self, page):
        page.evaluate("Object.defineProperty(navigator, 'clipboard', { value: undefined })")
        page.get_by_role("button", name="Copy link").click()
        assert "in the address bar" in page.locator(".said").inner_text()

    def test_the_link_is_copied(self, page):
        page.evaluate(
            """() => {
                 const value = { writeText: async (text) => { window.got = text; } };
                 Object.defineProperty(navigator, 'clipboard', { value });
               }"""
        )
        show(page, K_A=3.0)
        page.get_by_role("button", name="Copy link").click()
        page.wait_for_function("window.got")
        assert "#rate-attitude:K_A=3," in page.evaluate("window.got")
