//! Motions against independent methods: elliptic functions, quadrature, energies, published times.

mod elliptic;
mod faults;
mod machines;
mod motions;
