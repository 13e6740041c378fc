//! Pins: formulas against textbook figures and beams by hand, both directions against each other, wrong input.
#![cfg(feature = "std")]

mod input;
mod mountings;
mod property;

use linkage_analysis::pins::{Fit, Limit, Member, Mounting, Pin, Width};

/// A member that bears any pressure.
fn strong(width: Width) -> Member {
    Member {
        width,
        pressure: Limit::allowable(1e9),
    }
}

fn clevis(fit: Fit, rod: Member, fork: Member) -> Mounting {
    Mounting::Clevis { fit, rod, fork }
}

/// A pin of 90 MPa in bending and 60 MPa in shear.
fn pin(load: f64, mounting: Mounting) -> Pin {
    Pin {
        load,
        mounting,
        bending: Limit::allowable(90.0),
        shear: Limit::allowable(60.0),
    }
}

fn near(value: f64, known: f64, error: f64) {
    assert!((value - known).abs() <= error, "{value} instead of {known}");
}
