//! The native part of the Python package `linkage`: mechanisms, assemblies and sweeps of
//! `linkage-engine` as objects of Python.
//!
//! Everything here takes checked arguments: names, shapes and defaults are the concern of the
//! package's Python files, which are the public interface.

mod analysis;
mod assembly;
mod circuits;
mod derivatives;
mod description;
mod design;
mod follower;
mod mechanism;
mod page;
mod raised;
mod random;
mod searches;
mod sweep;
mod text;

/// The module `linkage._linkage`.
#[pyo3::pymodule(gil_used = false)]
mod _linkage {
    #[pymodule_export]
    use crate::assembly::Assembly;
    #[pymodule_export]
    use crate::design::design;
    #[pymodule_export]
    use crate::follower::Follower;
    #[pymodule_export]
    use crate::mechanism::Mechanism;
    #[pymodule_export]
    use crate::random::{Study, random_study, read_study};
    #[pymodule_export]
    use crate::text::compile;
}
