"""What the tests of all pages share: the browser, its log, and how they are started."""
import pathlib
import shutil
import sys
import tempfile
import unittest

from webdriver import Browser


class PageTest(unittest.TestCase):
    """A page in a real browser. A test's class says in make(root) how the page comes to be in root/report."""

    lancer = screenshot = chromedriver = chromium = None  # set by run()

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.root = pathlib.Path(cls.folder.name)
        cls.make(cls.root)
        cls.url = (cls.root / "report" / "index.html").as_uri()
        cls.page = Browser(cls.chromedriver, cls.chromium)

    @classmethod
    def tearDownClass(cls):
        cls.page.close()
        cls.folder.cleanup()

    def setUp(self):
        self.page.open(self.url)

    def tearDown(self):
        errors = [entry for entry in self.page.log() if entry["level"] in ("SEVERE", "WARNING")]
        self.assertEqual(errors, [])

    def assert_nothing_is_loaded(self):
        loaded = self.page.run("return performance.getEntriesByType('resource').map(r => r.name)"
                               ".filter(n => !n.startsWith('data:'))")
        self.assertEqual(loaded, [])


def run(what, usage):
    """Runs the tests of the file that was started with LANCER SCREENSHOT.png; `what` is tested."""
    if len(sys.argv) != 3:
        sys.exit(usage)
    PageTest.lancer, PageTest.screenshot = sys.argv[1:]
    PageTest.chromedriver = shutil.which("chromedriver")
    PageTest.chromium = shutil.which("chromium") or shutil.which("google-chrome")
    if not (PageTest.chromedriver and PageTest.chromium):
        print(f"NOT TESTED: {what} in a browser needs chromium and chromium-driver")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1], verbosity=2)
