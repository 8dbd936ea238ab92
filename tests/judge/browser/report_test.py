#!/usr/bin/env python3
"""The report in a real browser: report_test.py LANCER SCREENSHOT.png

Needs python3, chromium and chromium-driver; without them it exits with 77, which ctest calls skipped.
"""
import os
import struct
import subprocess
import zlib

import page_case


def write_png(path, color_at, width=96, height=64):
    rows = b"".join(b"\0" + bytes(v for x in range(width) for v in color_at(x, y)) for y in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows))
                     + chunk(b"IEND", b""))


def disc(radius, color):
    return lambda x, y: color if (x - 48) ** 2 + (y - 32) ** 2 < radius ** 2 else (2 * x, 3 * y, 90)


VISIBLE = "return [...document.querySelectorAll('article')].filter(a => !a.hidden).map(a => a.dataset.name)"


class ReportPage(page_case.PageTest):
    @classmethod
    def make(cls, root):
        for side in ("ours", "theirs"):
            (root / side).mkdir()
            write_png(root / side / "equal.png", disc(20, (200, 80, 60)))
        write_png(root / "ours" / "moved.png", disc(20, (60, 160, 80)))
        write_png(root / "theirs" / "moved.png", disc(24, (60, 160, 80)))
        write_png(root / "ours" / "lonely.png", disc(10, (0, 0, 0)))
        run = subprocess.run([cls.lancer, "compare", root / "ours", root / "theirs", "--report", root / "report"],
                             capture_output=True, text=True, check=False)
        assert run.returncode == 1, run.stderr

    def card(self, name):
        return "#" + self.page.run("return [...document.querySelectorAll('article')]"
                                   ".find(a => a.dataset.name === arguments[0]).id", name)

    def test_worst_comes_first_and_pictures_are_there(self):
        self.assertEqual(self.page.run(VISIBLE), ["lonely.png", "moved.png", "equal.png"])
        widths = self.page.run("return [...document.querySelectorAll('.frame img')].map(i => i.naturalWidth)")
        self.assertEqual(widths, [96] * 6)
        self.page.screenshot(self.screenshot)
        self.assertGreater(os.path.getsize(self.screenshot), 10_000)

    def test_nothing_is_loaded(self):
        self.assert_nothing_is_loaded()

    def test_search_filters_cards_and_rows(self):
        self.page.type("#search", "moved")
        self.assertEqual(self.page.run(VISIBLE), ["moved.png"])
        rows = self.page.run("return [...document.querySelectorAll('#overview tbody tr')]"
                             ".filter(r => r.offsetParent !== null).length")
        self.assertEqual(rows, 1)
        self.assertIn("1 of 3", self.page.run("return document.getElementById('shown').textContent"))
        self.page.press("\ue00c")  # Escape
        self.assertEqual(len(self.page.run(VISIBLE)), 3)

    def test_verdict_buttons_filter(self):
        self.page.click("[data-verdict-filter=agrees]")
        self.assertEqual(self.page.run(VISIBLE), ["equal.png"])
        self.page.click("[data-verdict-filter=all]")
        self.assertEqual(len(self.page.run(VISIBLE)), 3)

    def test_order_by_name(self):
        self.page.run("const s = document.getElementById('sort'); s.value = 'name';"
                      "s.dispatchEvent(new Event('change'))")
        self.assertEqual(self.page.run(VISIBLE), ["equal.png", "lonely.png", "moved.png"])

    def clip(self, card):
        return self.page.run("return getComputedStyle(document.querySelector(arguments[0] + ' .right .frame'))"
                             ".clipPath", card)

    def test_slider_by_mouse_and_keys(self):
        card = self.card("moved.png")
        self.assertEqual(self.clip(card), "none")
        self.page.click(card + " [data-set=slider]")
        self.assertIn("50%", self.clip(card))
        left, right = (self.page.run("return document.querySelector(arguments[0]).getBoundingClientRect().left",
                                     f"{card} .{side} .frame") for side in ("left", "right"))
        self.assertEqual(left, right, "the pictures lie on each other")
        self.page.drag(card + " .left .frame", 0.5, 0.2)
        share = float(self.clip(card).split()[-1].rstrip("%)"))
        self.assertAlmostEqual(share, 20, delta=2)
        self.page.run("document.activeElement.blur()")
        self.page.press("\ue014")  # arrow to the right
        self.assertAlmostEqual(float(self.clip(card).split()[-1].rstrip("%)")), share + 2, delta=0.6)

    def test_blink_shows_one_and_then_the_other(self):
        card = self.card("moved.png")
        self.page.click(card + " [data-set=blink]")
        seen = self.page.run("""
            const animation = document.querySelector(arguments[0] + ' .right .frame').getAnimations()[0];
            animation.pause();
            return [0.1, 0.6].map(share => {
              animation.currentTime = share * animation.effect.getTiming().duration;
              return getComputedStyle(animation.effect.target).opacity; });""", card)
        self.assertEqual(seen, ["1", "0"])
        self.page.click(card + " [data-set=side]")
        self.assertEqual(self.page.run("return document.getAnimations().length"), 0)

    def test_the_loupe_shows_exact_values(self):
        card = self.card("moved.png")
        self.page.run("document.querySelector(arguments[0] + ' a[data-pixel]').click()", card)
        texts = {side: self.page.run("return document.querySelector(arguments[0]).textContent",
                                     f"{card} .glass.{side} output").split("\n") for side in ("left", "right")}
        row = self.page.run("return [...document.querySelector(arguments[0] + ' .worst tbody tr').cells]"
                            ".map(c => c.textContent)", card)
        self.assertEqual(len(texts["left"]), 3)
        for column, side in ((3, "left"), (4, "right")):
            for listed, shown in zip(row[column].split(), texts[side]):
                self.assertAlmostEqual(float(listed), float(shown), delta=1e-5)
        self.assertIn("Pixel " + row[0], self.page.run(
            "return document.querySelector(arguments[0] + ' .loupe .at').textContent", card))
        drawn = self.page.run("""
            const canvas = document.querySelector(arguments[0] + ' .glass.left canvas');
            return [...canvas.getContext('2d').getImageData(55, 55, 1, 1).data].slice(0, 3);""", card)
        decoded = [float(v) for v in texts["left"]]
        for byte, value in zip(drawn, decoded):
            encoded = 12.92 * value if value <= 0.0031308 else 1.055 * value ** (1 / 2.4) - 0.055
            self.assertAlmostEqual(byte, 255 * encoded, delta=1)

    def test_rings_can_be_switched_off(self):
        card = self.card("moved.png")
        shown = ("return getComputedStyle(document.querySelector(arguments[0] + ' .heat .frame svg')).display")
        self.assertNotEqual(self.page.run(shown, card), "none")
        self.page.run("document.querySelector(arguments[0] + ' .rings input').click()", card)
        self.assertEqual(self.page.run(shown, card), "none")

    def test_nothing_is_wider_than_a_telephone(self):
        self.page.run("document.body.style.width = '400px'")
        wide = self.page.run("""
            return [...document.querySelectorAll('article *')].filter(e => e.offsetParent &&
                !e.closest('.table') && e.getBoundingClientRect().right > 402).map(e => e.className || e.tagName);""")
        self.assertEqual(wide, [])

    def test_keys_go_from_pair_to_pair(self):
        focused = "return document.activeElement.dataset.name || ''"
        self.page.press("j")
        self.assertEqual(self.page.run(focused), "lonely.png")
        self.page.press("j")
        self.assertEqual(self.page.run(focused), "moved.png")
        self.page.press("2")
        self.assertIn("%", self.clip(self.card("moved.png")))
        self.page.press("1")
        self.assertEqual(self.clip(self.card("moved.png")), "none")
        self.page.press("k")
        self.assertEqual(self.page.run(focused), "lonely.png")
        self.page.press("/")
        self.assertEqual(self.page.run("return document.activeElement.id"), "search")

    def test_text_is_readable_in_light_and_dark(self):
        contrast = """
            const light = c => { const [r, g, b] = c.match(/[\\d.]+/g).map(Number).map(v => v / 255)
                .map(v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
                return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
            const back = e => { for (; e; e = e.parentElement) {
                const c = getComputedStyle(e).backgroundColor; if (!c.endsWith(', 0)')) return light(c); } };
            return Math.min(...[...document.querySelectorAll('h1, h2, td, .badge, .soft, button, li, dd')]
                .filter(e => e.offsetParent).map(e => { const a = light(getComputedStyle(e).color), b = back(e);
                return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05); }));"""
        backgrounds = set()
        for _ in range(2):
            self.assertGreaterEqual(self.page.run(contrast), 4.5, "WCAG 2.1, AA")
            backgrounds.add(self.page.run("return getComputedStyle(document.body).backgroundColor"))
            self.page.click("#theme")
        self.assertEqual(len(backgrounds), 2)


if __name__ == "__main__":
    page_case.run("the report", __doc__)
