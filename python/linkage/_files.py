"""Files that are written as a whole or not at all."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path


def write_all(folder: str | os.PathLike, texts: dict[str, str]) -> None:
    """Writes texts into a folder, which is made if it is missing.

    Each file appears complete: it is written next to its name and then renamed.
    """
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in texts.items():
        handle, written = tempfile.mkstemp(dir=folder, prefix=f".{name}.")
        try:
            with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as file:
                file.write(text)
            os.chmod(written, 0o644)
            os.replace(written, folder / name)
        except BaseException:
            os.unlink(written)
            raise
