//! What users see is in `tests/ui`; here is nothing.
