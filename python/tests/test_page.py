"""The examples of the page `docs/python.md` run."""

import re
import subprocess
import sys

import pytest
from conftest import ROOT


def test_examples_of_the_page(tmp_path, monkeypatch):
    pytest.importorskip("uncertainties")
    page = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
    blocks = re.findall(r"```(\w+)\n(.*?)```", page, re.DOTALL)
    mechanism = next(text for _, text in blocks if text.startswith("pub struct FourBar"))
    (tmp_path / "four_bar.mech").write_text(mechanism, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("LINKAGE_CACHE", str(tmp_path / "cache"))
    programs = [text for language, text in blocks if language == "python"]
    assert len(programs) == 7
    exec("\n".join(programs), {})


def test_a_command_writes_the_page(bar, tmp_path):
    (tmp_path / "four_bar.mech").write_text(bar.source, encoding="utf-8")

    def run(*arguments):
        command = [sys.executable, "-m", "linkage", *arguments]
        return subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)

    done = run("four_bar.mech")
    assert done.stdout == "four_bar.html\n" and done.returncode == 0, done.stderr
    assert (tmp_path / "four_bar.html").read_text(encoding="utf-8") == bar.page()
    assert run("four_bar.mech", "--output", "b.html", "--name", "FourBar").stdout == "b.html\n"
    missing = run("missing.mech")
    assert missing.returncode == 1 and "missing.mech" in missing.stderr
    wrong = run("four_bar.mech", "--name", "Five")
    assert wrong.returncode == 1 and wrong.stderr.startswith("`four_bar.mech` has no mechanism")
