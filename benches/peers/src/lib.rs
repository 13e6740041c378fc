//! Other ways of computing the kernels of the benchmarks, and the harness that times them.
//!
//! K1 is a crank-rocker with a coupler point, K2 the hook needle of a warp-knitting machine (two
//! cranks, a dyad RRR, a dyad RRP on a guide that moves). Each is asked for a point ([`Position`]),
//! for the point with both derivatives ([`Motion`]), and for the point with its sensitivities. K3 (RSSR) and K4
//! (a delta robot) are the same in [`space`].

pub mod c;
pub mod closed;
pub mod differences;
pub mod dual;
pub mod environment;
pub mod exported;
pub mod mechanisms;
pub mod newton;
pub mod plain;
pub mod reference;
pub mod space;
pub mod textbook;
pub mod timing;

pub use linkage_reference::{ROUNDOFF, Random};
pub use num_dual;

/// `x, y`.
pub type Position = [f64; 2];
/// `x, y`, first derivatives, second derivatives.
pub type Motion = [f64; 6];
/// `x, y`, then its derivatives by each of the 7 dimensions of K1.
pub type Sensitivities1 = [f64; 16];
/// `x, y`, then its derivatives by each of the 12 dimensions of K2.
pub type Sensitivities2 = [f64; 26];
