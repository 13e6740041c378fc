//! Programs of this package are in `src/bin` and `tests/ui`; the library is empty.
