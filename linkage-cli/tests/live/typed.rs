//! What is typed into a field: units and sums as for `--set`, a decimal comma, and what is refused stays with its reason.

use linkage_browser::Key;
use linkage_compiler::check_value;

use crate::pages::Live;

/// Types a text into a field and confirms it.
fn typed(live: &mut Live, name: &str, text: &str) {
    let page = &mut live.page;
    page.value(&format!("(() => {{ const field = document.querySelector('input[data-dimension=\"{name}\"]'); field.focus(); field.select(); }})()"));
    page.type_text(text);
    page.key(Key::Enter);
    // Leaving the field tells of the change once more.
    page.value("document.activeElement.blur()");
}

fn field(live: &mut Live, name: &str) -> (String, bool) {
    let selector = format!("document.querySelector('input[data-dimension=\"{name}\"]')");
    let text = live.page.words(&format!("{selector}.value"));
    let marked = live.page.holds(&format!(
        "{selector}.getAttribute('aria-invalid') === 'true'"
    ));
    (text, marked)
}

/// A mechanism with a dimension of every kind.
const KINDS: &str = "
    pub struct Kinds {
        unit mm;
        param crank = 41mm;
        param size  = 2;
        param turned = 30deg;
        param mass = 2kg;
        param load = 10N;
        param inertia = 3kg*mm^2;
        param stiffness = 2N/mm;
        input phi = 30deg in 0deg..360deg;
        let pin = polar(crank * size, phi + turned);
    }
    impl Kinds {
        pub fn motion(phi) -> Motion { pin, torque: mass * inertia / mass + load * 1mm * 1s * 1s + stiffness * crank * 1mm * 1s * 1s }
    }";

/// The value of a text as the command reads it after `--set`, in the unit of the dimension; `None` if it is refused.
fn set(text: &str, unit: &str) -> Option<f64> {
    let checked = check_value("value", text.parse().ok()?, "mm");
    if !checked.messages.is_empty() {
        return None;
    }
    let unit_of = checked.unit?;
    let mut scalars = unit_of.scalars();
    let only = scalars.next()?;
    let is_value = scalars.next().is_none() && only.unit == unit && only.tolerance == 0.0;
    is_value.then_some(only.nominal)
}

/// The value that a field makes of a text, from the address; `None` if it is refused.
fn value_of(live: &mut Live, name: &str, text: &str) -> Option<f64> {
    live.page.value("document.getElementById('reset').click()");
    typed(live, name, text);
    if field(live, name).1 {
        return None;
    }
    live.page
        .value("new Promise((done) => setTimeout(done, 130))");
    let found = live.page.words(&format!(
        "new URLSearchParams(location.hash.slice(1)).get('{name}') ?? ''"
    ));
    match found.as_str() {
        "" => Some(f64::NAN),
        number => Some(number.parse().expect("a number")),
    }
}

#[test]
fn units_and_sums_are_those_of_set() {
    let Some(mut live) = Live::text("kinds", KINDS) else {
        return;
    };
    let message = check_value("value", "1furlong".parse().expect("tokens"), "mm").messages;
    let message = format!("{:?}", message.first().expect("a message"));
    let (_, units) = message.split_once("units are ").expect("a list");
    let (units, _) = units.split_once(';').expect("an end");
    assert_eq!(units.split(' ').count(), 35, "{units}");
    let dimensions = [
        ("crank", "mm"),
        ("size", ""),
        ("turned", "rad"),
        ("mass", "kg"),
        ("load", "N"),
        ("inertia", "kg*mm^2"),
        ("stiffness", "N/mm"),
    ];
    let parameters = live.mechanism.parameters();
    for (own, (name, unit)) in parameters.iter().zip(dimensions) {
        assert_eq!((own.name, own.unit), (name, unit));
    }
    let mut texts: Vec<(&str, &str, String)> = Vec::new();
    for unit in units.split(' ') {
        for (name, own) in dimensions {
            texts.push((name, own, format!("1.25{unit}")));
        }
    }
    for (name, own, text) in [
        ("crank", "mm", "2inch + 1mm"),
        ("crank", "mm", "4.75cm - 0.5 mm"),
        ("crank", "mm", "(1mm + 2mm) * 3 / 4"),
        ("crank", "mm", "sqrt(9mm * 16mm)"),
        ("crank", "mm", "hypot(30mm, 4cm)"),
        ("crank", "mm", "max(30mm, 4cm)"),
        ("crank", "mm", "min(30mm, 4cm)"),
        ("crank", "mm", "50mm * sin(30deg)"),
        ("crank", "mm", "50mm * cos(PI / 3)"),
        ("crank", "mm", "-50mm + 100mm"),
        ("crank", "mm", "1e2mm"),
        ("crank", "mm", "1_0mm"),
        ("crank", "mm", "abs(-3mm)"),
        ("crank", "mm", "40mm + 1"),
        ("crank", "mm", "40mm +"),
        ("crank", "mm", "(40mm"),
        ("crank", "mm", "40mm)"),
        ("crank", "mm", "crank + 1mm"),
        ("crank", "mm", "40mm +- 0.1mm"),
        ("crank", "mm", "0 + 3mm"),
        ("crank", "mm", "sin(30) * 3mm"),
        ("crank", "mm", "30deg"),
        ("crank", "mm", "1mm * 1mm"),
        ("size", "", "30mm / 20mm"),
        ("size", "", "30deg"),
        ("turned", "rad", "45deg + 30arcmin"),
        ("turned", "rad", "atan2(1mm, 2mm)"),
        ("turned", "rad", "PI / 6 - 0.1rad"),
        ("turned", "rad", "asin(0.25)"),
        ("load", "N", "2kg * 9.80665m/s^2"),
        ("load", "N", "2psi * (3inch * 1ft)"),
        ("stiffness", "N/mm", "12lbf/inch"),
        ("size", "", "30rpm * 1s"),
        ("inertia", "kg*mm^2", "49663.7g*mm^2"),
        ("stiffness", "N/mm", "2.5kN / m"),
    ] {
        texts.push((name, own, text.to_owned()));
    }
    let mut taken = 0;
    for (name, unit, text) in &texts {
        let expected = set(text, unit);
        let found = value_of(&mut live, name, text);
        match (expected, found) {
            (None, None) => {}
            (Some(expected), Some(found)) => {
                assert!(
                    (found - expected).abs() <= 4.0 * f64::EPSILON * expected.abs(),
                    "{name} = {text}: {found}, {expected} by --set"
                );
                taken += 1;
            }
            _ => panic!("{name} = {text}: {found:?}, {expected:?} by --set"),
        }
    }
    assert!(taken >= 40, "{taken}");
    live.page.assert_quiet();
}

/// Without a unit a number is in the unit beside the field, degrees for an angle, and a comma is a decimal mark.
#[test]
fn numbers_are_in_the_unit_of_the_field() {
    let Some(mut live) = Live::golden_as("crank_rocker.mech", "typed_numbers") else {
        return;
    };
    for (name, text, shown) in [
        ("crank", "47,5", "47.5"),
        ("crank", "40 + 2,5", "42.5"),
        ("crank", "47,5 mm", "47.5"),
        ("crank", "4,75cm", "47.5"),
        ("lift", "22,5", "22.5"),
        ("lift", "0,5rad", "28.6478897565"),
    ] {
        typed(&mut live, name, text);
        assert_eq!(field(&mut live, name), (shown.to_owned(), false), "{text}");
        assert_eq!(live.says(), "");
    }
    // A negative length is taken with a remark, a negative coordinate without one.
    typed(&mut live, "pivot_d.y", "-3");
    assert_eq!(live.says(), "");
    typed(&mut live, "arm", "-70");
    assert_eq!(field(&mut live, "arm"), ("-70".to_owned(), false));
    assert_eq!(
        live.says(),
        "arm is negative: as a length it leads the other way."
    );
    typed(&mut live, "arm", "70");
    assert_eq!(live.says(), "");
    // Arrows step by one, and an empty field is as before.
    live.page
        .value("document.querySelector('input[data-dimension=crank]').focus()");
    live.page.key(Key::Up);
    assert_eq!(field(&mut live, "crank"), ("48.5".to_owned(), false));
    live.page
        .value("document.querySelector('input[data-dimension=crank]').select()");
    live.page.type_text(" ");
    live.page.key(Key::Enter);
    assert_eq!(field(&mut live, "crank"), ("48.5".to_owned(), false));
    live.page.assert_quiet();
}

/// What cannot be assembled stays in its field, with a mark, and the message stays with the nearest value that can.
#[test]
fn what_is_refused_stays_and_says_why() {
    let Some(mut live) = Live::golden_as("crank_rocker.mech", "typed_refused") else {
        return;
    };
    let before = live.csv("motion");
    typed(&mut live, "rocker", "10");
    let said = live.says();
    let (start, nearest) = said
        .split_once(" The nearest value that works is ")
        .unwrap_or_else(|| panic!("{said}"));
    assert!(start.starts_with("rocker = 10 is refused: CrankRocker: the RRR group of theta, psi (loop 1) cannot be closed: "), "{said}");
    assert_eq!(field(&mut live, "rocker"), ("10".to_owned(), true));
    assert!(live.csv("motion") == before, "nothing has changed");
    // Half a second later, and after another change, it is still there.
    live.page
        .value("new Promise((done) => setTimeout(done, 500))");
    assert_eq!(live.says(), said);
    typed(&mut live, "arm", "60");
    assert_eq!(live.says(), said);
    assert_eq!(field(&mut live, "rocker"), ("10".to_owned(), true));
    live.page.shoot("refused");
    // The nearest value works, and one step farther does not.
    let nearest = nearest.trim_end_matches(" mm.").to_owned();
    assert!(nearest.len() <= 7, "{nearest}");
    typed(&mut live, "rocker", &nearest);
    assert_eq!(field(&mut live, "rocker"), (nearest.clone(), false));
    assert_eq!(live.says(), "");
    let number: f64 = nearest.parse().expect("a number");
    let step = 10_f64.powi(number.log10().floor() as i32 - 5);
    typed(&mut live, "rocker", &format!("{:?}", number - 2.0 * step));
    assert!(field(&mut live, "rocker").1, "{number} - {step}");
    // Texts that are no values.
    for (text, why) in [
        (
            "80 furlongs",
            "rocker = 80 furlongs is refused: \"furlongs\" is no unit; units are m mm cm ",
        ),
        (
            "80deg",
            "rocker = 80deg is refused: this is an angle, and not in mm.",
        ),
        (
            "80 +",
            "rocker = 80 + is refused: a number is expected at the end.",
        ),
        (
            "80mm +- 1mm",
            "rocker = 80mm +- 1mm is refused: a tolerance cannot be changed here.",
        ),
    ] {
        typed(&mut live, "rocker", text);
        assert_eq!(field(&mut live, "rocker"), (text.to_owned(), true));
        let said = live.says();
        assert!(said.starts_with(why), "{said}");
    }
    // A slider, escape and reset end it.
    live.page
        .value("document.querySelector('input[data-dimension=rocker]').focus()");
    live.page.key(Key::Escape);
    assert_eq!(field(&mut live, "rocker"), (nearest, false));
    assert_eq!(live.says(), "");
    typed(&mut live, "rocker", "?");
    live.page.value("document.getElementById('reset').click()");
    assert_eq!(field(&mut live, "rocker"), ("100".to_owned(), false));
    assert_eq!(live.says(), "");
    assert!(live.page.holds("document.getElementById('reset').disabled"));
    live.page.assert_quiet();
}
