//! Elementary functions of the C library.

use std::collections::BTreeMap;
use std::ffi::c_double;

use crate::decode::destination;

#[allow(unsafe_code, reason = "only their addresses are used")]
unsafe extern "C" {
    safe fn sin(x: c_double) -> c_double;
    safe fn cos(x: c_double) -> c_double;
    safe fn tan(x: c_double) -> c_double;
    safe fn asin(x: c_double) -> c_double;
    safe fn acos(x: c_double) -> c_double;
    safe fn atan(x: c_double) -> c_double;
    safe fn atan2(y: c_double, x: c_double) -> c_double;
    safe fn hypot(x: c_double, y: c_double) -> c_double;
    safe fn fma(x: c_double, y: c_double, z: c_double) -> c_double;
    fn sincos(x: c_double, sin: *mut c_double, cos: *mut c_double);
}

/// Names of the functions by address.
pub(crate) fn functions() -> BTreeMap<u64, &'static str> {
    let functions = [
        (sin as *const (), "sin"),
        (cos as *const (), "cos"),
        (sincos as *const (), "sincos"),
        (tan as *const (), "tan"),
        (asin as *const (), "asin"),
        (acos as *const (), "acos"),
        (atan as *const (), "atan"),
        (atan2 as *const (), "atan2"),
        (hypot as *const (), "hypot"),
        (fma as *const (), "fma"),
    ];
    functions
        .map(|(function, name)| (destination(function as u64), name))
        .into()
}
