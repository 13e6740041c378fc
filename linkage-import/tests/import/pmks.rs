//! Facts of the addresses of PMKS+, as its sources have them.

use linkage_import::{Options, import};

use crate::files::of_text;

/// Numbers of addresses of PMKS+ in base 64, for drawings of this test.
mod address {
    const DIGITS: &[u8] = b"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-";

    pub(super) fn number(thousandths: i64) -> String {
        let mut digits = Vec::new();
        let mut rest = thousandths.unsigned_abs() as usize;
        while rest > 0 || digits.is_empty() {
            digits.push(DIGITS[rest % 64]);
            rest /= 64;
        }
        if thousandths < 0 {
            digits.push(b'0');
        }
        digits.reverse();
        String::from_utf8(digits).expect("digits")
    }

    /// Returns an address with the check of its length.
    pub(super) fn checked(body: &str) -> String {
        let check = char::from(DIGITS[body.len() % 62]);
        format!("https://app.pmksplus.com/?{body}{check}")
    }

    /// A crank, a coupler and a rocker, with a unit and a tail.
    pub(super) fn four_bar(unit: &str, tail: &str) -> String {
        let joint = |flags: char, id: &str, x: i64, y: i64| {
            format!("{flags}{id},{id},{},{},0.", number(x), number(y))
        };
        let link = |id: &str, mass: &str| {
            let (a, b) = id.split_at(1);
            format!(
                "YR{id},{id},{mass},{mass},{},0,c5cae9,{a},{b},,.",
                number(-500)
            )
        };
        let body = format!(
            "0P.Fe.K,0.{unit}11.{}{}{}{}.{}{}{}..N_{tail}",
            joint('M', "A", 0, 0),
            joint('G', "B", 0, 1050),
            joint('G', "C", 3000, 2500),
            joint('K', "D", 3500, -64),
            link("AB", "Fe"),
            link("BC", &number(2500)),
            link("CD", "Fe")
        );
        checked(&body)
    }
}

/// Thousandths of the unit, which may be the metre: a zero in front is the sign.
#[test]
fn pmks_rounds_to_thousandths_of_its_unit() {
    assert_eq!(address::number(1400), "Lu");
    assert_eq!(address::number(-11), "0B");
    for (digit, unit) in [("0", "inch"), ("1", "cm"), ("2", "m")] {
        let import = of_text("", &address::four_bar(digit, ""));
        assert!(
            import.text.contains(&format!("unit {unit};")),
            "{}",
            import.text
        );
        assert!(
            import
                .text
                .contains(&format!("d = (3.5{unit}, -0.064{unit})"))
        );
        assert!(
            import
                .text
                .contains(&format!("may be wrong by 0.0005{unit}"))
        );
    }
    let text = of_text("", &address::four_bar("2", "")).text;
    assert!(text.contains("a to b 1.0500 +-0.001m"), "{text}");
    assert!(
        text.contains("clockwise at 20 revolutions per minute"),
        "{text}"
    );
}

/// A mass of 1 with an inertia of 1 is that of every new link.
#[test]
fn pmks_masses_have_their_units() {
    let text = of_text("", &address::four_bar("1", "")).text;
    assert!(
        text.contains("mass 2.5kg at centre_of_bc, inertia 2.5kg*cm^2;"),
        "{text}"
    );
    assert!(
        text.contains("2 links have no mass or the mass 1"),
        "{text}"
    );
    let text = of_text("", &address::four_bar("2", "")).text;
    assert!(
        text.contains("mass 2.5kg at centre_of_bc, inertia 2.5kg*m^2;"),
        "{text}"
    );
    let text = of_text("", &address::four_bar("0", "")).text;
    assert!(
        text.contains("mass 1.133980925kg at centre_of_bc"),
        "{text}"
    );
}

/// A welded link is a root with its parts.
#[test]
fn pmks_welds_parts_of_links() {
    let body = "0P.Fe.K,0.1011.MA,A,0,0,0.OB,B,0,Fe,0.GC,C,Fe,Fe,0..YRABC,arm,Fe,Fe,0,0,c5cae9,A,B,,\
                AB,BC.NRAB,AB,Fe,Fe,0,0,c5cae9,A,B,,.NRBC,BC,Fe,Fe,0,0,c5cae9,B,C,,...N_";
    let text = of_text("", &address::checked(body)).text;
    assert!(text.contains("link arm: a, b, c at phi;"), "{text}");
}

/// Newer pages correct numbers that thousandths do not hold.
#[test]
fn pmks_takes_corrections() {
    let text = of_text("", &address::four_bar("1", ".PJB~1~1.0504,PLBC~0~2.25")).text;
    assert!(text.contains("b = (0cm, 1.0504cm)"), "{text}");
    assert!(text.contains("mass 2.25kg"), "{text}");
    assert!(!text.contains("may be wrong by"), "{text}");
}

/// The digest of newer pages is FNV-1a in base 62. That of the empty text is known.
#[test]
fn pmks_checks_its_addresses() {
    let whole = address::four_bar("1", "");
    let cut = &whole[..whole.len() - 1];
    let error = import(b"", cut, &Options::default()).expect_err("a cut address");
    assert!(error.to_string().contains("cut or changed"), "{error}");
    // The same length, and another place: only a digest sees it.
    let error = import(b"", &format!("{whole}*000000"), &Options::default());
    assert!(
        error
            .expect_err("a wrong digest")
            .to_string()
            .contains("cut or changed")
    );
    let text = format!("see [the model]({whole}) for more");
    let read = import(text.as_bytes(), "notes.md", &Options::default()).expect("an address");
    assert!(read.text.contains("link ab: a, b at phi;"));
}
