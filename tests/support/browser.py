"""A real browser, for our pages."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, Route, sync_playwright

CHROMIUM = Path("/usr/bin/chromium")
#: No sandbox, no shared memory: tests may run as root in a container, which may have little of it.
#: The rest keeps it from calling home.
_ARGUMENTS = [
    "--no-sandbox",
    "--disable-dev-shm-usage",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]

#: Widths of a laptop and of a phone, in CSS pixels.
WIDTHS = (1280, 400)


@contextmanager
def chromium() -> Iterator[Browser]:
    """Of the Debian package, which is what readers' browsers are made of, too."""
    if not CHROMIUM.exists():
        pytest.fail(
            f"{CHROMIUM} is missing: ./etendue test installs it; or apt-get install chromium",
            pytrace=False,
        )
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=_ARGUMENTS)
        try:
            yield browser
        finally:
            browser.close()


class Visit:
    """A page of ours in the browser, without a network, and what it complained of."""

    def __init__(self, browser: Browser, file: Path, width: int = WIDTHS[0]) -> None:
        self.complaints: list[str] = []
        self._url = file.as_uri()
        self.page: Page = browser.new_page(viewport={"width": width, "height": 800})
        self.page.on("console", lambda message: self._complain("console", message.text))
        self.page.on("pageerror", lambda error: self._complain("error", str(error)))
        self.page.route("**/*", self._refuse_all_but_the_page)
        self.page.goto(self._url)

    def _complain(self, kind: str, what: str) -> None:
        self.complaints.append(f"{kind}: {what}")

    def _refuse_all_but_the_page(self, route: Route) -> None:
        url = route.request.url
        if url == self._url or url.startswith("data:"):
            route.continue_()
        else:
            self._complain("request", url)
            route.abort()

    def unfold(self) -> None:
        """What a reader opens at a click."""
        self.page.evaluate(
            "document.querySelectorAll('details').forEach((d) => { d.open = true; })"
        )

    def pictures_that_do_not_decode(self) -> list[str]:
        """Their alternative texts."""
        broken: list[str] = self.page.evaluate(
            """async () => {
                 const broken = [];
                 for (const image of document.images) {
                   await image.decode().catch(() => {});
                   if (!(image.naturalWidth > 0)) broken.push(image.alt);
                 }
                 return broken;
               }"""
        )
        return broken

    def what_sticks_out(self) -> list[str]:
        """What reaches beyond the window at the right or left, unless it lies in a part that
        scrolls by itself."""
        found: list[str] = self.page.evaluate(
            """() => {
                 const width = document.documentElement.clientWidth;
                 const scrolls = (element) => element.closest(".scroll") !== null &&
                     !element.classList.contains("scroll");
                 const out = [...document.body.querySelectorAll("*")].filter((element) => {
                   const box = element.getBoundingClientRect();
                   return !scrolls(element) && (box.right > width + 0.5 || box.left < -0.5);
                 }).map((element) => element.outerHTML.slice(0, 80));
                 if (document.documentElement.scrollWidth > width) out.push("the page scrolls");
                 return out;
               }"""
        )
        return found

    def smallest_text(self) -> float:
        """Font size in CSS pixels, of texts and of labels in drawings, as shown."""
        size: float = self.page.evaluate(
            """() => {
                 const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
                 let smallest = Infinity;
                 while (walker.nextNode()) {
                   const parent = walker.currentNode.parentElement;
                   if (!walker.currentNode.data.trim() || parent.matches("script, style")) continue;
                   smallest = Math.min(smallest, parseFloat(getComputedStyle(parent).fontSize));
                 }
                 for (const image of document.querySelectorAll("img[data-font-size]")) {
                   const scale = image.clientWidth / image.naturalWidth;
                   smallest = Math.min(smallest, scale * image.dataset.fontSize);
                 }
                 return smallest;
               }"""
        )
        return size


def check_page(browser: Browser, file: Path, width: int) -> None:
    """What must hold of every page of ours, at every width."""
    visit = Visit(browser, file, width)
    try:
        visit.unfold()
        assert visit.pictures_that_do_not_decode() == []
        assert visit.what_sticks_out() == []
        assert visit.smallest_text() >= 12
        assert visit.complaints == []
    finally:
        visit.page.close()
