//! Facts of the addresses of PMKS+, as its sources have them.

use std::fs;

use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use linkage_import::{Options, import};
use serde_json::{Value, json};

use crate::files::{folder, of_text};

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

/// Returns the document of bodies in a file.
fn document_of_bodies(file: &str) -> Value {
    let address = fs::read_to_string(folder().join("files").join(file)).expect("a file");
    let (_, payload) = address.trim().rsplit_once('.').expect("a payload");
    let text = URL_SAFE_NO_PAD.decode(payload).expect("base 64");
    serde_json::from_slice(&text).expect("JSON")
}

/// Returns the address of a document of bodies.
fn address_of_bodies(document: &Value) -> String {
    let text = document.to_string();
    let sum = crc32fast::hash(text.as_bytes());
    let payload = URL_SAFE_NO_PAD.encode(text);
    format!("https://app.pmksplus.com/?pmks2:{sum:08x}.{payload}")
}

/// The axes of a body are those of its masses and of forces that turn with it.
#[test]
fn pmks_takes_masses_and_forces_of_bodies() {
    let mut document = document_of_bodies("b_02.pmks");
    let body = &mut document["bodies"][2];
    body["mass"] = json!({
        "mass": {"mode": "explicit", "value": 2.5},
        "inertia": {"mode": "explicit", "value": 4.5},
        "center": {"mode": "explicit", "point": {"x": 1.0, "y": 0.5}, "editAnchor": "body"},
    });
    body["pose"] = json!({"x": -2.0, "y": 1.0, "angle": std::f64::consts::FRAC_PI_2});
    let id = body["id"].clone();
    let force = |frame: &str| {
        json!({
            "id": frame, "bodyId": id, "label": frame, "frame": frame, "couple": 0.0,
            "point": {"x": 1.0, "y": 1.0}, "vector": {"x": 3.0, "y": -4.0},
        })
    };
    document["forces"] = json!([force("world"), force("body")]);
    document["units"]["force"] = json!("lbf");
    let text = of_text("", &address_of_bodies(&document)).text;
    assert!(text.contains("centre_of_link2 = (-2.5cm, 2cm)"), "{text}");
    // Long items have several lines.
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(text.contains("mass 2.5kg at centre_of_link2, inertia 4.5kg*cm^2;"));
    assert!(text.contains("place_of_world = (-3cm, 2cm)"), "{text}");
    assert!(text.contains("force (3lbf, -4lbf) on link2 at place_of_world;"));
    // In the drawing this one is (4, 3): the body is turned by a right angle.
    let (_, turned) = text
        .split_once("force rotate((")
        .expect("a force that turns");
    let (components, _) = turned.split_once("), link2.angle)").expect("the angle");
    let components: Vec<f64> = components
        .split(", ")
        .map(|part| part.trim_end_matches("lbf").parse().expect("a number"))
        .collect();
    let joint = |name: &str| {
        let (_, rest) = text
            .split_once(&format!("joint {name} = ("))
            .expect("a joint");
        let (position, _) = rest.split_once(')').expect("a position");
        let position = position
            .split(", ")
            .map(|part| part.trim_end_matches("cm").parse());
        let position: Vec<f64> = position.map(|part| part.expect("a number")).collect();
        [position[0], position[1]]
    };
    let ([x, y], [u, v]) = (joint("j2"), joint("j3"));
    let (sin, cos) = (v - y).atan2(u - x).sin_cos();
    let drawn = [
        cos * components[0] - sin * components[1],
        sin * components[0] + cos * components[1],
    ];
    assert!((drawn[0] - 4.0).hypot(drawn[1] - 3.0) < 1e-12, "{drawn:?}");
}

#[test]
fn pmks_checks_documents_of_bodies() {
    let whole = address_of_bodies(&document_of_bodies("b_c.pmks"));
    let cut = &whole[..whole.len() - 3];
    let error = import(b"", cut, &Options::default()).expect_err("a cut address");
    assert!(error.to_string().contains("cut or changed"), "{error}");
    let mut later = document_of_bodies("b_c.pmks");
    later["version"] = json!(3);
    let error = import(b"", &address_of_bodies(&later), &Options::default());
    let error = error.expect_err("a later version").to_string();
    assert!(
        error.contains("version 3, and version 2 is read"),
        "{error}"
    );
    let mut lacking = document_of_bodies("b_c.pmks");
    lacking["joints"][0]["frameB"]["attachmentId"] = json!("none");
    let error = import(b"", &address_of_bodies(&lacking), &Options::default());
    let error = error.expect_err("a missing point").to_string();
    assert!(error.contains("lacks the point `none`"), "{error}");
}

/// A body that slides without turning, with a point of its own for the slot.
#[test]
fn pmks_takes_carriages() {
    let mut document = document_of_bodies("b_c.pmks");
    let joints = document["joints"].as_array_mut().expect("joints");
    let slot = joints
        .iter_mut()
        .find(|joint| joint["kind"] == "pin-in-slot");
    slot.expect("a slot")["kind"] = json!("prismatic");
    let text = of_text("", &address_of_bodies(&document)).text;
    assert!(text.contains("through j1, block link2;"), "{text}");
}

/// An arrow points away from its place of application, or towards it.
#[test]
fn pmks_takes_forces() {
    let number = address::number;
    let force = |flags: char| {
        let places = [1000, 2000, 1000, 2500, 3000].map(number).join(",");
        format!("{flags}F1,BC,F1,{places}.")
    };
    let body = |flags: char| {
        let whole = address::four_bar("1", "");
        let (_, query) = whole.split_once('?').expect("a query");
        let body = &query[..query.len() - 1];
        address::checked(&body.replace("..N_", &format!(".{}.N_", force(flags))))
    };
    let text = of_text("", &body('2')).text;
    assert!(
        text.contains("force (0N, 3N) on bc at place_of_f1;"),
        "{text}"
    );
    let text = of_text("", &body('0')).text;
    assert!(text.contains("force (0N, -3N) on bc"), "{text}");
    let text = of_text("", &body('3')).text;
    assert!(text.contains("force rotate(("), "{text}");
}

/// Whole numbers of two digits are in base 16, also coordinates, which the page itself misreads.
#[test]
fn pmks_reads_compressed_addresses() {
    let path = folder().join("files/c_01.pmks");
    let whole = fs::read_to_string(path).expect("a file");
    let text = of_text(&whole, "a.pmks").text;
    assert!(text.contains("j2 = (10cm, 12cm)"), "{text}");
    assert!(text.contains("at 15 revolutions per minute"), "{text}");
    let cut = &whole.trim()[..whole.len() - 40];
    let error = import(b"", cut, &Options::default()).expect_err("a cut address");
    assert!(error.to_string().contains("address"), "{error}");
}
