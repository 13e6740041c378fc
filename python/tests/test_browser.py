"""A mechanism in a notebook: its page is alive inside of the frame."""

import shutil
import subprocess

import pytest
from conftest import required

BROWSERS = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"]


def test_the_frame_shows_the_page(bar, m, tmp_path):
    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    if browser is None:
        assert not required("LINKAGE_BROWSER")
        pytest.skip("no browser")
    sizes = []
    for shown in ("", bar._repr_html_(), m._repr_html_()):
        (tmp_path / "page.html").write_text(f"<!doctype html><body>{shown}</body>", encoding="utf-8")
        picture = tmp_path / "picture.png"
        command = [
            browser, "--headless", "--no-sandbox", "--disable-gpu", "--enable-logging=stderr",
            "--window-size=1000,700", "--virtual-time-budget=4000",
            f"--screenshot={picture}", (tmp_path / "page.html").as_uri(),
        ]  # fmt: skip
        done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
        assert "Uncaught" not in done.stderr
        sizes.append(picture.stat().st_size)
    # Drawing, plots and texts take many more bytes than an empty page.
    assert min(sizes[1:]) > 8 * sizes[0], sizes
