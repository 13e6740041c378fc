"""A mechanism in a notebook: its page is alive inside of the frame."""

import shutil
import subprocess

import pytest
from conftest import required

BROWSERS = ["chromium-headless-shell", "chromium", "chromium-browser", "google-chrome", "google-chrome-stable"]


def test_the_frame_shows_the_page(bar, m, tmp_path):
    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    if browser is None:
        assert not required("LINKAGE_BROWSER")
        pytest.skip("no browser")
    empty = picture_size(browser, "", tmp_path)
    for shown in (bar._repr_html_(), m._repr_html_()):
        # Drawing, plots and texts take many more bytes than an empty page. A browser on a busy machine
        # may take the picture too early.
        sizes = (picture_size(browser, shown, tmp_path) for _ in range(4))
        assert any(size > 8 * empty for size in sizes)


def picture_size(browser: str, shown: str, folder) -> int:
    """The bytes of the picture of a page. It is a mistake if a script of it fails."""
    (folder / "page.html").write_text(f"<!doctype html><body>{shown}</body>", encoding="utf-8")
    picture = folder / "picture.png"
    command = [
        browser, "--headless", "--no-sandbox", "--disable-gpu", "--enable-logging=stderr",
        "--window-size=1000,700", "--virtual-time-budget=10000",
        f"--screenshot={picture}", (folder / "page.html").as_uri(),
    ]  # fmt: skip
    done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
    assert "Uncaught" not in done.stderr
    return picture.stat().st_size
