"""The examples of the page `docs/python.md` run."""

import re

import pytest
from conftest import ROOT


def test_examples_of_the_page(tmp_path, monkeypatch):
    pytest.importorskip("uncertainties")
    page = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
    blocks = re.findall(r"```(\w+)\n(.*?)```", page, re.DOTALL)
    (tmp_path / "four_bar.mech").write_text(blocks[0][1], encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("LINKAGE_CACHE", str(tmp_path / "cache"))
    programs = [text for language, text in blocks if language == "python"]
    assert len(programs) == 5
    exec("\n".join(programs), {})
