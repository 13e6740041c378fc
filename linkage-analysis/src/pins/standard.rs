//! Diameters that can be bought.

/// Preferred diameters of clevis pins in mm, a selection of those of ISO 2340 (without head) and
/// ISO 2341 (with head).
pub const STANDARD_DIAMETERS: [f64; 21] = [
    3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0, 24.0, 30.0, 36.0, 40.0, 45.0, 50.0, 55.0,
    60.0, 70.0, 80.0, 90.0, 100.0,
];

/// The smallest of the [`STANDARD_DIAMETERS`] that is not below a diameter in mm; `None` beyond 100
/// mm and for values that are not a positive number.
///
/// ```
/// use linkage_analysis::pins::standard_diameter;
///
/// assert_eq!(standard_diameter(12.1), Some(16.0));
/// assert_eq!(standard_diameter(12.0), Some(12.0));
/// assert_eq!(standard_diameter(100.5), None);
/// ```
#[must_use]
pub fn standard_diameter(diameter: f64) -> Option<f64> {
    let mut enough = STANDARD_DIAMETERS.into_iter().filter(|&d| d >= diameter);
    if diameter > 0.0 { enough.next() } else { None }
}
