//! Numbers in docs.

/// Digits of angles in degrees: all that anyone writes, none that come from the radians between.
const DIGITS: usize = 9;

/// A number as an engineer writes it.
fn decimal(x: f64) -> String {
    let plain = x == 0.0 || (1e-4..1e9).contains(&x.abs());
    if plain {
        format!("{x}")
    } else {
        format!("{x:e}")
    }
}

/// A number in a unit, without the unit; of an angle in radians `25 deg`.
pub fn in_degrees(x: f64, unit: &str) -> String {
    if unit != "rad" {
        return decimal(x);
    }
    let degrees = format!("{:.*e}", DIGITS - 1, x.to_degrees());
    // A number that is not finite is printed as it is.
    let degrees: f64 = degrees.parse().unwrap_or(x);
    format!("{} deg", decimal(degrees))
}

#[cfg(test)]
mod tests {
    use super::in_degrees;

    #[test]
    fn angles_are_told_as_they_were_written() {
        for (degrees, told) in [
            (25.0_f64, "25 deg"),
            (-62.5, "-62.5 deg"),
            (30.0 / 3600.0, "0.00833333333 deg"),
            (0.0, "0 deg"),
            (720.0, "720 deg"),
        ] {
            assert_eq!(in_degrees(degrees.to_radians(), "rad"), told);
        }
        assert_eq!(in_degrees(0.012, "mm"), "0.012");
        assert_eq!(in_degrees(f64::NAN, "rad"), "NaN deg");
    }
}
