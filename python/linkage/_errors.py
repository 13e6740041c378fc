"""Exceptions, with the messages of the compiler."""

from __future__ import annotations

from typing import NamedTuple


class Message(NamedTuple):
    """A message of the compiler.

    Lines and columns count from 1, columns in characters; the end is after the last character.
    All four are 0 for a message about no position.
    """

    text: str
    is_mistake: bool
    line: int
    column: int
    end_line: int
    end_column: int


def messages(located: list) -> list[Message]:
    """Returns messages of the native module."""
    return [Message(text, is_mistake, *position) for text, is_mistake, position in located]


class LinkageError(ValueError):
    """Base of all exceptions about mechanisms."""


class CompileError(LinkageError):
    """A text with mistakes. Printed, it has each message with its line of the source.

    Attributes
    ----------
    messages : list of Message
        All mistakes, in the order of the text.
    line : int
        The line of the first mistake, counted from 1; 0 if it has none.
    """

    def __init__(self, text: str, located: list = ()):
        super().__init__(text, located)
        self.messages = messages(located)

    def __str__(self) -> str:
        return self.args[0]

    @property
    def line(self) -> int:
        return self.messages[0].line if self.messages else 0


class AssemblyError(LinkageError):
    """Dimensions with which the loops do not close, or inputs at which there is no assembly."""


class DesignError(LinkageError):
    """A design problem with mistakes, all of them at once, or one without a design."""


class AnalysisError(LinkageError):
    """Figures that do not exist: of an empty range, or of tolerances below zero."""
