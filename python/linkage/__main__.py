"""A page from a command line: `python -m linkage four_bar.mech --open`."""

from __future__ import annotations

import argparse
import sys
import webbrowser
from pathlib import Path

from ._errors import LinkageError
from ._files import write_all
from ._text import load


def main(arguments: list[str] | None = None) -> int:
    """Writes the page of a mechanism: drawing, plots and tables. Returns the exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m linkage",
        description="Writes the page of a mechanism as HTML: its drawing moves, with plots and tables.",
    )
    parser.add_argument("file", help="a file with a mechanism, `.mech` or `.rs`")
    parser.add_argument("--name", help="the mechanism, if the file has several")
    parser.add_argument("--output", type=Path, help="by default the name of the file, as `.html`")
    parser.add_argument("--open", action="store_true", help="shows the page in a browser")
    given = parser.parse_args(arguments)
    output = given.output or Path(f"{Path(given.file).stem}.html")
    try:
        page = load(given.file, given.name).page()
        write_all(output.parent, {output.name: page})
    except (LinkageError, OSError) as error:
        print(error, file=sys.stderr)
        return 1
    print(output)
    if given.open:
        webbrowser.open(output.resolve().as_uri())
    return 0


if __name__ == "__main__":
    sys.exit(main())
