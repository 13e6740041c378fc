//! Tables as CSV.

use crate::data::same;
use crate::fixture::{FourBar, PHI, Sweep, value};
use crate::four_bar;
use linkage_report::{CsvStyle, Report};
use linkage_runtime::{Heading, Table};

#[test]
fn csv_has_units_and_every_number_to_the_last_bit() {
    let phi = PHI.positions(361);
    let sweep = FourBar::GAPPED.motion(&phi);
    let text = four_bar(FourBar::GAPPED)
        .speed(3.0, 0.5)
        .csv("motion")
        .unwrap();
    let mut lines = text.split_terminator("\r\n");
    assert_eq!(
        lines.next().unwrap(),
        "phi [rad],tracer.x [mm],tracer.y [mm],v.x [mm/rad],v.y [mm/rad],a.x [mm/rad^2],a.y [mm/rad^2],psi [rad],\
         v.x [mm/s],v.y [mm/s],a.x [mm/s^2],a.y [mm/s^2]"
    );
    let rows: Vec<Vec<f64>> = lines
        .map(|line| {
            line.split(',')
                .map(|cell| cell.parse().unwrap_or(f64::NAN))
                .collect()
        })
        .collect();
    assert_eq!(rows.len(), phi.len());
    for (row, cells) in rows.iter().enumerate() {
        assert_eq!(cells.len(), 12);
        let mut expected = vec![phi[row]];
        expected.extend((0..7).map(|i| sweep.column(i)[row]));
        let (v, a) = (sweep.column(2)[row], sweep.column(4)[row]);
        assert!(same(&cells[..8], &expected), "row {row}");
        assert!(
            same(&[cells[8], cells[10]], &[v * 3.0, a * 9.0 + v * 0.5]),
            "row {row}"
        );
    }
    let gap = text.split_terminator("\r\n").nth(181).unwrap();
    assert!(gap.ends_with(",,,,,,,,,,,"), "{gap}");
}

#[test]
fn numbers_have_their_shortest_digits() {
    const ODD: Heading = Heading {
        function: "odd",
        arguments: &["phi"],
        columns: &[value("at \"a\", b", "mm")],
        picture: None,
    };
    let numbers = [0.1, 1e300, -5e-324, -0.0, 100.0, f64::INFINITY];
    let sweep = Sweep::new(&ODD, &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0], |x| {
        vec![numbers[x as usize]]
    });
    let text = Report::new("odd", &PHI, &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0])
        .table(&sweep)
        .csv("odd")
        .unwrap();
    let expected = [
        "phi [rad],\"at \"\"a\"\", b [mm]\"",
        "0,0.1",
        "1,1e300",
        "2,-5e-324",
        "3,-0",
        "4,100",
        "5,",
    ];
    assert_eq!(text, expected.map(|line| format!("{line}\r\n")).concat());
}

/// What would end a cell or a line is quoted, and nothing else.
#[test]
fn names_are_quoted_where_they_would_be_misread() {
    const ODD: Heading = Heading {
        function: "odd",
        arguments: &["phi"],
        columns: &[
            value("carriage\rreturn", "mm"),
            value("line\nfeed", "mm"),
            value("com,ma", "mm"),
            value("quo\"te", "mm"),
            value("semi;colon 'and' tab\t", "mm"),
        ],
        picture: None,
    };
    let sweep = Sweep::new(&ODD, &[0.0, 1.0], |_| vec![2.0; 5]);
    let report = Report::new("odd", &PHI, &[0.0, 1.0]).table(&sweep);
    assert_eq!(
        report.csv("odd").unwrap(),
        "phi [rad],\"carriage\rreturn [mm]\",\"line\nfeed [mm]\",\"com,ma [mm]\",\"quo\"\"te [mm]\",\
         semi;colon 'and' tab\t [mm]\r\n0,2,2,2,2,2\r\n1,2,2,2,2,2\r\n"
    );
}

#[test]
fn spreadsheets_have_their_style() {
    let phi = PHI.positions(3);
    let report = Report::new("Four-bar", &PHI, &phi).table(&FourBar::NOMINAL.motion(&phi));
    let plain = report.csv("motion").unwrap();
    let style = CsvStyle::default()
        .degrees(true)
        .digits(5)
        .separator(";")
        .decimal(',');
    let styled = report.clone().csv_style(style).csv("motion").unwrap();
    let mut lines = styled.split_terminator("\r\n");
    let title = lines.next().unwrap();
    assert!(title.starts_with("phi [deg];tracer.x [mm];"), "{title}");
    // Rates stay in radians.
    assert!(title.ends_with(";v.x [mm/rad];v.y [mm/rad];a.x [mm/rad^2];a.y [mm/rad^2];psi [deg]"));
    assert_eq!(lines.clone().count(), 3);
    for (line, plain) in lines.zip(plain.split_terminator("\r\n").skip(1)) {
        let (cells, plain) = (line.split(';'), plain.split(','));
        assert_eq!(cells.clone().count(), 8);
        for (column, (cell, plain)) in cells.zip(plain).enumerate() {
            let digits = cell.split('e').next().unwrap().chars();
            let digits = digits.filter(char::is_ascii_digit).collect::<String>();
            assert!(digits.trim_start_matches('0').len() <= 5, "{cell}");
            let [cell, plain] = [&cell.replace(',', "."), plain].map(|x| x.parse::<f64>().unwrap());
            let factor = if [0, 7].contains(&column) {
                180.0 / std::f64::consts::PI
            } else {
                1.0
            };
            assert!(
                (cell - factor * plain).abs() <= 5.1e-5 * cell.abs(),
                "{cell} {plain}"
            );
        }
    }
    assert!(styled.contains("\r\n180,00;"), "{styled}");
}

#[test]
fn a_separator_that_stands_in_numbers_is_refused() {
    let report = four_bar(FourBar::NOMINAL).csv_style(CsvStyle::default().decimal(','));
    let told = report.csv("motion").unwrap_err().to_string();
    assert!(
        told.starts_with("columns with \",\" between them and numbers with ','"),
        "{told}"
    );
    // Nothing is written that could not be read.
    assert!(report.check().is_err());
}
