"""Pages inside of notebooks."""

from __future__ import annotations

from html import escape


def frame(page: str, title: str) -> str:
    """Returns a frame with a page, apart from the styles and scripts around it."""
    return (
        f'<iframe title="{escape(title)}" srcdoc="{escape(page)}" '
        'sandbox="allow-scripts allow-downloads" '
        'style="width: 100%; height: 640px; border: 1px solid #8888"></iframe>'
    )
