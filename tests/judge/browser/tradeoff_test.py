#!/usr/bin/env python3
"""The page of `lancer tradeoff` in a real browser: tradeoff_test.py LANCER SCREENSHOT.png

Needs python3, chromium and chromium-driver; without them it exits with 77, which ctest calls skipped.
"""
import os
import subprocess

import page_case

SCENE = """image { width 32 height 24 }
camera front { position [3, 3, 5] look_at [0, 0.5, 0] }
light point { position [4, 6, 3] }
plane { normal [0, 1, 0] material { color [0.8, 0.8, 0.7] } }
sphere { center [0, 1, 0] radius 1 material { color [0.9, 0.3, 0.2] reflection 0.3 } }
"""
RIGHT, LEFT, DOWN = "\ue014", "\ue012", "\ue015"
SHOWN = "return [...document.querySelectorAll('.detail')].filter(d => d.offsetParent).map(d => d.id)"


class TradeOffPage(page_case.PageTest):
    @classmethod
    def make(cls, root):
        (root / "a.lancer").write_text(SCENE)
        run = subprocess.run([cls.lancer, "tradeoff", root / "a.lancer", "--size", "24x18", "--budget", "6", "--no-cache",
                              "--report", root / "report"], capture_output=True, text=True, check=False)
        assert run.returncode == 0, run.stderr
        cls.plot = (root / "report" / "plot.svg").as_uri()

    def shown(self):
        ids = self.page.run(SHOWN)
        self.assertEqual(len(ids), 1, "one setting at a time")
        return ids[0].split("-")[1]

    def test_exact_is_shown_first_with_its_picture(self):
        self.assertIn("exact", self.page.run("return document.querySelector('.detail.now h3').textContent"))
        self.assertEqual(self.page.run("return document.querySelector('.detail.now img').naturalWidth"), 24)
        self.page.screenshot(self.screenshot)
        self.assertGreater(os.path.getsize(self.screenshot), 10_000)

    def test_nothing_is_loaded(self):
        self.assert_nothing_is_loaded()

    def test_pointing_shows_a_setting(self):
        for kind in ("a.point", "tr"):
            for setting in ("2", "1"):
                self.page.run("document.querySelector(arguments[0]).dispatchEvent(new MouseEvent('mouseenter'))",
                              f"{kind}[data-setting='{setting}']")
                self.assertEqual(self.shown(), setting)
        marked = self.page.run("return [...document.querySelectorAll('.now[data-setting]')].map(e => e.dataset.setting)")
        self.assertEqual(set(marked), {"1"})

    def test_keys_go_by_time_and_along_the_frontier(self):
        rows = self.page.run("return [...document.querySelectorAll('.settings tbody tr')].map(r => r.dataset.setting)")
        best = self.page.run("return [...document.querySelectorAll('.settings tr.best')].map(r => r.dataset.setting)")
        self.assertEqual(self.page.run("return document.querySelectorAll('.point[tabindex=\"0\"]').length"), 1)
        self.page.run("document.querySelector(arguments[0]).focus()", f".point[data-setting='{rows[0]}']")
        self.assertEqual(self.shown(), rows[0])
        self.page.press(RIGHT)
        self.page.press(RIGHT)
        self.assertEqual(self.shown(), rows[2])
        self.page.press(LEFT)
        self.assertEqual(self.shown(), rows[1])
        after = [r for r in rows[2:] if r in best]
        self.page.press(DOWN)
        self.assertEqual(self.shown(), after[0])

    def test_advice_leads_to_its_setting(self):
        advised = self.page.run("return document.querySelector('.advice a').dataset.setting")
        self.page.click(".advice a")
        self.assertEqual(self.shown(), advised)
        self.page.open(self.page.run("return location.href"))
        self.page.run("location.reload()")
        self.assertEqual(self.shown(), advised, "its address leads there")

    def test_nothing_is_wider_than_a_telephone(self):
        self.page.run("document.body.style.width = '400px'")
        wide = self.page.run("""
            return [...document.querySelectorAll('main *')].filter(e => e.offsetParent && !e.closest('.table') &&
                e.getBoundingClientRect().right > 402).map(e => e.className || e.tagName);""")
        self.assertEqual(wide, [])

    def test_dots_are_seen_in_light_and_dark(self):
        contrast = """
            const light = c => { const [r, g, b] = c.match(/[\\d.]+/g).map(Number).map(v => v / 255)
                .map(v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
                return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
            const back = light(getComputedStyle(document.querySelector('article')).backgroundColor);
            return Math.min(...[...document.querySelectorAll('.point, .settings td, .scatter text, .advice a')].map(e => {
                const s = getComputedStyle(e), a = light(e.tagName === 'text' ? s.fill : s.color);
                return (Math.max(a, back) + 0.05) / (Math.min(a, back) + 0.05); }));"""
        seen = set()
        for _ in range(2):
            self.assertGreaterEqual(self.page.run(contrast), 3.0, "WCAG 2.1, 1.4.11")
            seen.add(self.page.run("return getComputedStyle(document.body).backgroundColor"))
            self.page.click("#theme")
        self.assertEqual(len(seen), 2)

    def test_the_plot_stands_alone(self):
        self.page.open(self.plot)
        self.assertEqual(self.page.run("return document.documentElement.tagName"), "svg")
        self.assertGreater(self.page.run("return document.querySelectorAll('.point').length"), 5)


if __name__ == "__main__":
    page_case.run("the page", __doc__)
