//! Accuracy proof of linkage: every kind of group against the references of `linkage-reference`. All of it is in `tests`.
//!
//! The references stand in a package of their own, since they are too slow without optimisation, which would take most of the time here: these tests
//! are made of generated code for hundreds of mechanisms.
