//! The table that sweeps fill.
#![cfg(feature = "alloc")]

use linkage_runtime::Columns;

#[test]
fn rows_and_columns_meet() {
    let mut columns = Columns::<f64>::new(3, 5);
    for row in 0..5 {
        columns.set_row(row, (0..3).map(|column| (10 * column + row) as f64));
    }
    assert_eq!((columns.width(), columns.len()), (3, 5));
    assert_eq!(columns.column(2), [20.0, 21.0, 22.0, 23.0, 24.0]);
    assert_eq!(columns.get(4, 1), 14.0);
    assert_eq!(format!("{:?}", Columns::<f32>::new(2, 1)), "[[NaN], [NaN]]");
}

#[test]
fn columns_lie_an_odd_number_of_lines_apart() {
    for len in [1, 7, 8, 9, 512, 1000, 1024, 4096] {
        let columns = Columns::<f64>::new(2, len);
        let distance = columns.column(1).as_ptr().addr() - columns.column(0).as_ptr().addr();
        assert_eq!((distance % 64, distance / 64 % 2), (0, 1), "{len}");
        assert!(distance >= 8 * len && distance < 8 * len + 128, "{len}");
        let columns = Columns::<f32>::new(2, len);
        let distance = columns.column(1).as_ptr().addr() - columns.column(0).as_ptr().addr();
        assert_eq!((distance % 64, distance / 64 % 2), (0, 1), "{len}");
    }
}

#[test]
fn resizing_within_the_capacity_stays_in_place() {
    let mut columns = Columns::<f64>::new(4, 1000);
    let place = columns.column(0).as_ptr();
    columns.set_row(3, [1.0; 4]);
    columns.resize(1000);
    assert_eq!(columns.get(3, 2), 1.0);
    columns.resize(100);
    assert!(columns.get(3, 2).is_nan());
    columns.resize(1000);
    assert_eq!(columns.column(0).as_ptr(), place);
    columns.resize(0);
    assert!(columns.is_empty() && columns.column(3).is_empty());
}

#[test]
fn equality_is_that_of_the_values() {
    let filled = |len| {
        let mut columns = Columns::<f64>::new(2, len);
        (0..len).for_each(|row| columns.set_row(row, [1.0, row as f64]));
        columns
    };
    assert_eq!(filled(3), filled(3));
    assert_ne!(filled(3), filled(4));
    let mut resized = filled(9);
    resized.resize(3);
    (0..3).for_each(|row| resized.set_row(row, [1.0, row as f64]));
    assert_eq!(resized, filled(3));
}

#[test]
fn surplus_values_and_missing_columns_are_harmless() {
    let mut columns = Columns::<f64>::new(2, 2);
    columns.set_row(1, [1.0, 2.0, 3.0]);
    assert_eq!((columns.get(1, 0), columns.get(1, 1)), (1.0, 2.0));
    Columns::<f64>::new(0, 2).set_row(1, [1.0]);
}

#[test]
#[should_panic(expected = "row 2 of 2")]
fn a_row_beyond_the_end_is_refused() {
    Columns::<f64>::new(2, 2).set_row(2, [0.0, 0.0]);
}

#[test]
#[should_panic(expected = "column 2 of 2")]
fn a_column_beyond_the_end_is_refused() {
    let _ = Columns::<f64>::new(2, 2).column(2);
}
