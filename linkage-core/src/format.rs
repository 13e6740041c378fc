//! Lists and numbers in messages.

use core::fmt;

/// Prints with a function, as `fmt::from_fn`, which the oldest supported Rust does not have.
pub fn printed(print: impl Fn(&mut fmt::Formatter<'_>) -> fmt::Result) -> impl fmt::Display {
    struct Printed<F>(F);

    impl<F: Fn(&mut fmt::Formatter<'_>) -> fmt::Result> fmt::Display for Printed<F> {
        fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            self.0(f)
        }
    }

    Printed(print)
}

/// Items with `separator` between them.
pub fn join<'a>(items: &'a [&'a str], separator: &'a str) -> impl fmt::Display + 'a {
    printed(move |f| separated(f, items, separator))
}

/// Numbers with `separator` between them.
pub fn numbers<'a>(items: &'a [usize], separator: &'a str) -> impl fmt::Display + 'a {
    printed(move |f| separated(f, items, separator))
}

fn separated(
    f: &mut fmt::Formatter<'_>,
    items: &[impl fmt::Display],
    separator: &str,
) -> fmt::Result {
    for (index, item) in items.iter().enumerate() {
        let between = if index == 0 { "" } else { separator };
        write!(f, "{between}{item}")?;
    }
    Ok(())
}

/// A position, 0 if it differs from it by less than its accuracy, a share of the width of its
/// range.
#[cfg(feature = "alloc")]
pub fn settled(x: f64, accuracy: f64, width: f64) -> f64 {
    if x.abs() < accuracy * width.abs() {
        0.0
    } else {
        x
    }
}

/// A number rounded to six significant digits, printed as short as possible.
pub fn rounded(x: f64) -> impl fmt::Display {
    printed(move |f| {
        let size = x.abs();
        if size == 0.0 {
            return f.write_str("0");
        }
        if !(1e-4..1e6).contains(&size) {
            return write!(f, "{x:.5e}");
        }
        let mut power = 1.0;
        while size * power < 1e5 {
            power *= 10.0;
        }
        // Adding and subtracting 1.5 * 2^52 rounds to an integer.
        const ROUND: f64 = 6_755_399_441_055_744.0;
        write!(f, "{}", ((x * power + ROUND) - ROUND) / power)
    })
}

#[cfg(all(test, feature = "alloc"))]
mod tests {
    use super::settled;

    #[test]
    fn positions_at_zero_but_for_their_accuracy_are_zero() {
        for (x, expected) in [(-1.6e-8, 0.0), (1.6e-8, 0.0), (1e-6, 1e-6), (-3.0, -3.0)] {
            assert_eq!(settled(x, 1e-7, 6.0).to_bits(), f64::to_bits(expected));
        }
    }
}
