//! Standard tolerance grades of ISO 286-1.

use core::fmt;

/// Upper ends of the ranges of sizes, in mm; the lower end belongs to the range before.
const UP_TO: [f64; 21] = [
    3.0, 6.0, 10.0, 18.0, 30.0, 50.0, 80.0, 120.0, 180.0, 250.0, 315.0, 400.0, 500.0, 630.0, 800.0,
    1000.0, 1250.0, 1600.0, 2000.0, 2500.0, 3150.0,
];

/// IT01 and IT0 for sizes up to 500 mm, in um.
const FINEST: [[f64; 2]; 13] = [
    [0.3, 0.5],
    [0.4, 0.6],
    [0.4, 0.6],
    [0.5, 0.8],
    [0.6, 1.0],
    [0.6, 1.0],
    [0.8, 1.2],
    [1.0, 1.5],
    [1.2, 2.0],
    [2.0, 3.0],
    [2.5, 4.0],
    [3.0, 5.0],
    [4.0, 6.0],
];

/// IT1 to IT18 for each range of sizes, in um.
#[rustfmt::skip]
const STANDARD: [[f64; 18]; 21] = [
    [0.8, 1.2, 2.0, 3.0, 4.0, 6.0, 10.0, 14.0, 25.0, 40.0, 60.0, 100.0, 140.0, 250.0, 400.0, 600.0, 1000.0, 1400.0],
    [1.0, 1.5, 2.5, 4.0, 5.0, 8.0, 12.0, 18.0, 30.0, 48.0, 75.0, 120.0, 180.0, 300.0, 480.0, 750.0, 1200.0, 1800.0],
    [1.0, 1.5, 2.5, 4.0, 6.0, 9.0, 15.0, 22.0, 36.0, 58.0, 90.0, 150.0, 220.0, 360.0, 580.0, 900.0, 1500.0, 2200.0],
    [1.2, 2.0, 3.0, 5.0, 8.0, 11.0, 18.0, 27.0, 43.0, 70.0, 110.0, 180.0, 270.0, 430.0, 700.0, 1100.0, 1800.0, 2700.0],
    [1.5, 2.5, 4.0, 6.0, 9.0, 13.0, 21.0, 33.0, 52.0, 84.0, 130.0, 210.0, 330.0, 520.0, 840.0, 1300.0, 2100.0, 3300.0],
    [1.5, 2.5, 4.0, 7.0, 11.0, 16.0, 25.0, 39.0, 62.0, 100.0, 160.0, 250.0, 390.0, 620.0, 1000.0, 1600.0, 2500.0, 3900.0],
    [2.0, 3.0, 5.0, 8.0, 13.0, 19.0, 30.0, 46.0, 74.0, 120.0, 190.0, 300.0, 460.0, 740.0, 1200.0, 1900.0, 3000.0, 4600.0],
    [2.5, 4.0, 6.0, 10.0, 15.0, 22.0, 35.0, 54.0, 87.0, 140.0, 220.0, 350.0, 540.0, 870.0, 1400.0, 2200.0, 3500.0, 5400.0],
    [3.5, 5.0, 8.0, 12.0, 18.0, 25.0, 40.0, 63.0, 100.0, 160.0, 250.0, 400.0, 630.0, 1000.0, 1600.0, 2500.0, 4000.0, 6300.0],
    [4.5, 7.0, 10.0, 14.0, 20.0, 29.0, 46.0, 72.0, 115.0, 185.0, 290.0, 460.0, 720.0, 1150.0, 1850.0, 2900.0, 4600.0, 7200.0],
    [6.0, 8.0, 12.0, 16.0, 23.0, 32.0, 52.0, 81.0, 130.0, 210.0, 320.0, 520.0, 810.0, 1300.0, 2100.0, 3200.0, 5200.0, 8100.0],
    [7.0, 9.0, 13.0, 18.0, 25.0, 36.0, 57.0, 89.0, 140.0, 230.0, 360.0, 570.0, 890.0, 1400.0, 2300.0, 3600.0, 5700.0, 8900.0],
    [8.0, 10.0, 15.0, 20.0, 27.0, 40.0, 63.0, 97.0, 155.0, 250.0, 400.0, 630.0, 970.0, 1550.0, 2500.0, 4000.0, 6300.0, 9700.0],
    [9.0, 11.0, 16.0, 22.0, 32.0, 44.0, 70.0, 110.0, 175.0, 280.0, 440.0, 700.0, 1100.0, 1750.0, 2800.0, 4400.0, 7000.0, 11000.0],
    [10.0, 13.0, 18.0, 25.0, 36.0, 50.0, 80.0, 125.0, 200.0, 320.0, 500.0, 800.0, 1250.0, 2000.0, 3200.0, 5000.0, 8000.0, 12500.0],
    [11.0, 15.0, 21.0, 28.0, 40.0, 56.0, 90.0, 140.0, 230.0, 360.0, 560.0, 900.0, 1400.0, 2300.0, 3600.0, 5600.0, 9000.0, 14000.0],
    [13.0, 18.0, 24.0, 33.0, 47.0, 66.0, 105.0, 165.0, 260.0, 420.0, 660.0, 1050.0, 1650.0, 2600.0, 4200.0, 6600.0, 10500.0, 16500.0],
    [15.0, 21.0, 29.0, 39.0, 55.0, 78.0, 125.0, 195.0, 310.0, 500.0, 780.0, 1250.0, 1950.0, 3100.0, 5000.0, 7800.0, 12500.0, 19500.0],
    [18.0, 25.0, 35.0, 46.0, 65.0, 92.0, 150.0, 230.0, 370.0, 600.0, 920.0, 1500.0, 2300.0, 3700.0, 6000.0, 9200.0, 15000.0, 23000.0],
    [22.0, 30.0, 41.0, 55.0, 78.0, 110.0, 175.0, 280.0, 440.0, 700.0, 1100.0, 1750.0, 2800.0, 4400.0, 7000.0, 11000.0, 17500.0, 28000.0],
    [26.0, 36.0, 50.0, 68.0, 96.0, 135.0, 210.0, 330.0, 540.0, 860.0, 1350.0, 2100.0, 3300.0, 5400.0, 8600.0, 13500.0, 21000.0, 33000.0],
];

/// A standard tolerance grade, from `Grade::IT01`, the finest, to `Grade::it(18)`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Grade(u8);

impl Grade {
    /// IT01, for sizes up to 500 mm.
    pub const IT01: Self = Self(0);
    /// IT0, for sizes up to 500 mm.
    pub const IT0: Self = Self(1);

    /// IT1 to IT18.
    #[must_use]
    pub const fn it(number: u8) -> Option<Self> {
        match number {
            1..=18 => Some(Self(number + 1)),
            _ => None,
        }
    }

    /// All grades, the finest first.
    pub fn all() -> impl DoubleEndedIterator<Item = Self> {
        (0..20).map(Self)
    }

    /// The width of the tolerance zone in mm for a size in mm, as published. A dimension with the
    /// zone in the middle has half of it as tolerance on either side.
    ///
    /// `None` for sizes beyond 3150 mm (500 mm for IT01 and IT0), negative ones and NaN. ISO 286
    /// does not use IT14 to IT18 below 1 mm; the width is given all the same.
    ///
    /// ```
    /// use linkage_analysis::tolerance::Grade;
    ///
    /// assert_eq!(Grade::it(7).and_then(|grade| grade.width(50.0)), Some(0.025));
    /// ```
    #[must_use]
    pub fn width(self, size: f64) -> Option<f64> {
        let range = range_of(size)?;
        let micrometres = match self.0 {
            finest @ 0..2 => FINEST.get(range)?[usize::from(finest)],
            standard => STANDARD[range][usize::from(standard) - 2],
        };
        Some(micrometres / 1000.0)
    }
}

/// `IT7`.
impl fmt::Display for Grade {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            0 => f.pad("IT01"),
            number => f.pad(&alloc::format!("IT{}", number - 1)),
        }
    }
}

/// The standard tolerance factor in um for a size in mm: `0.45 cbrt(D) + 0.001 D` up to 500 mm,
/// then `0.004 D + 2.1`. D, in mm, is the geometric mean of the ends of the range of sizes; for up
/// to 3 mm that of 1 and 3 mm.
///
/// From IT5 on, the standard tolerances are 7, 10, 16, 25, 40, 64, 100 times this factor and so on,
/// rounded, and in places adapted, by the standard. `None` for sizes that have no range.
#[must_use]
pub fn tolerance_factor(size: f64) -> Option<f64> {
    let range = range_of(size)?;
    let lower = if range == 0 { 1.0 } else { UP_TO[range - 1] };
    let mean = (lower * UP_TO[range]).sqrt();
    Some(if UP_TO[range] <= 500.0 {
        0.45 * mean.cbrt() + 0.001 * mean
    } else {
        0.004 * mean + 2.1
    })
}

fn range_of(size: f64) -> Option<usize> {
    (size >= 0.0)
        .then(|| UP_TO.iter().position(|&end| size <= end))
        .flatten()
}

#[cfg(test)]
mod tests {
    use super::{FINEST, Grade, STANDARD, UP_TO, tolerance_factor};

    /// Multiples of the factor for IT5 to IT18.
    const MULTIPLES: [f64; 14] = [
        7.0, 10.0, 16.0, 25.0, 40.0, 64.0, 100.0, 160.0, 250.0, 400.0, 640.0, 1000.0, 1600.0,
        2500.0,
    ];

    #[test]
    fn published_values() {
        let it = |number: u8, size: f64| Grade::it(number).and_then(|grade| grade.width(size));
        for (number, size, width) in [
            (7, 50.0, 0.025),
            (7, 50.1, 0.030),
            (6, 2.0, 0.006),
            (8, 25.0, 0.033),
            (11, 120.0, 0.220),
            (12, 300.0, 0.520),
            (18, 500.0, 9.7),
            (5, 501.0, 0.032),
            (1, 3150.0, 0.026),
            (9, 1000.0, 0.230),
            (16, 0.5, 0.600),
        ] {
            assert_eq!(it(number, size), Some(width), "IT{number}, {size} mm");
        }
        assert_eq!(Grade::IT01.width(400.0), Some(0.003));
        assert_eq!(Grade::IT0.width(501.0), None);
        assert_eq!(it(7, 3150.1), None);
        assert_eq!(it(7, -1.0), None);
        assert_eq!(it(7, f64::NAN), None);
        assert_eq!((Grade::it(0), Grade::it(19)), (None, None));
    }

    /// The table is the formula, rounded, from IT5 on: at most 5.5 % or 0.7 um off, and more only
    /// in the first range, which the standard adapts.
    #[test]
    fn the_table_follows_from_the_formula() {
        for (range, row) in STANDARD.iter().enumerate() {
            let factor = tolerance_factor(UP_TO[range]).expect("it has a range");
            for (column, multiple) in MULTIPLES.iter().enumerate() {
                let (published, computed) = (row[column + 4], multiple * factor);
                let allowed = if range == 0 { 0.16 } else { 0.055 };
                assert!(
                    (published / computed - 1.0).abs() <= allowed
                        || (published - computed).abs() <= 0.7,
                    "IT{} up to {} mm: {published}, computed {computed}",
                    column + 5,
                    UP_TO[range]
                );
            }
        }
    }

    /// Up to 500 mm IT01 to IT1 are linear in the size, and IT2 to IT4 are in geometric progression
    /// to IT5. Such small widths are rounded by up to 29 %.
    #[test]
    fn the_finest_grades_follow_from_their_formulas() {
        for (range, finest) in FINEST.iter().enumerate() {
            let lower = if range == 0 { 1.0 } else { UP_TO[range - 1] };
            let mean = (lower * UP_TO[range]).sqrt();
            let near = |published: f64, computed: f64| {
                assert!(
                    (published / computed - 1.0).abs() < 0.29,
                    "up to {} mm: {published}, computed {computed}",
                    UP_TO[range]
                );
            };
            near(finest[0], 0.3 + 0.008 * mean);
            near(finest[1], 0.5 + 0.012 * mean);
            near(STANDARD[range][0], 0.8 + 0.02 * mean);
            let [first, second, third, fourth, fifth, ..] = STANDARD[range];
            let step = (fifth / first).powf(0.25);
            near(second, first * step);
            near(third, first * step * step);
            near(fourth, fifth / step);
        }
    }

    /// Beyond 500 mm IT1 to IT4 are multiples of the factor, too.
    #[test]
    fn the_finest_grades_of_large_sizes() {
        for (row, end) in STANDARD.iter().zip(UP_TO).skip(FINEST.len()) {
            let factor = tolerance_factor(end).expect("it has a range");
            for (published, multiple) in row.iter().zip([2.0, 2.7, 3.7, 5.0]) {
                let computed = multiple * factor;
                assert!(
                    (published / computed - 1.0).abs() < 0.07,
                    "up to {end} mm: {published}, computed {computed}"
                );
            }
        }
    }

    /// Every fifth grade is ten times as wide, from IT6 on, with one exception in the standard.
    #[test]
    fn every_fifth_grade_is_ten_times_as_wide() {
        for (range, row) in STANDARD.iter().enumerate() {
            for number in 6..=13 {
                let (width, wider) = (row[number - 1], row[number + 4]);
                match (range, number) {
                    (1, 6) => assert_eq!((width, wider), (8.0, 75.0)),
                    _ => assert_eq!(wider, 10.0 * width, "IT{number}, up to {} mm", UP_TO[range]),
                }
            }
        }
    }

    #[test]
    fn the_table_grows_in_both_directions() {
        for row in STANDARD {
            assert!(row.is_sorted_by(|a, b| a < b));
        }
        assert!(STANDARD.is_sorted_by(|a, b| a.iter().zip(b).all(|(a, b)| a <= b)));
        assert!(FINEST.iter().all(|[a, b]| a < b));
    }
}
