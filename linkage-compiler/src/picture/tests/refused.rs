//! Refused pictures, and functions without a picture next to one with a picture.

use crate::check;
use crate::ir::CompiledMechanism;

use super::{FOUR_BAR, compile, expect_message};

#[test]
fn a_link_that_stretches_is_refused() {
    let items = format!(
        "{FOUR_BAR} let p = polar(crank, phi); let q = (base, 0) + polar(rocker, psi); loop p + polar(coupler, theta) = q;"
    );
    let stretched = "fn look(phi) -> Look { shape: picture([(base, 0), p]) }";
    expect_message(&items, stretched, "a link that stretches: from");
    let same = "fn look(phi) -> Look { shape: picture([p, polar(crank, phi)]) }";
    expect_message(&items, same, "these points are always at the same place");
    let fixed = "fn look(phi) -> Look { shape: picture([(base, 0), (0, 0)]) }";
    expect_message(&items, fixed, "this is no link, but the frame");
}

#[test]
fn a_picture_stands_alone() {
    let items = format!(
        "{FOUR_BAR} loop polar(crank, phi) + polar(coupler, theta) = (base, 0) + polar(rocker, psi);"
    );
    let within = "fn look(phi) -> Look { shape: 2 * picture() }";
    expect_message(&items, within, "`picture` within an expression");
    let derived = "fn look(phi) -> Look { shape: velocity(picture()) }";
    expect_message(&items, derived, "`picture` within an expression");
    let list = "fn look(phi) -> Look { shape: picture(crank) }";
    expect_message(&items, list, "expected a link, found no list");
    let short = "fn look(phi) -> Look { shape: picture([polar(crank, phi)]) }";
    expect_message(&items, short, "a link joins at least two points");
    let angle = "fn look(phi) -> Look { shape: picture([polar(crank, phi), theta]) }";
    expect_message(&items, angle, "a link joins points, found an angle");
    let twice =
        "fn look(phi) -> Look { shape: picture() } fn again(phi) -> Again { shape: picture() }";
    expect_message(&items, twice, "a mechanism has one picture");
}

#[test]
fn without_links_there_is_nothing_to_draw() {
    let text = "struct M { input phi = 0deg in 0deg..360deg; let psi = 2 * phi; } impl M {
        fn look(phi) -> Look { psi, shape: picture() } fn turned(phi) -> Turned { psi } }";
    let checked = check(text.parse().expect("tokens"));
    assert!(checked.messages.is_empty(), "{:?}", checked.messages);
    let [warning] = &checked.warnings[..] else {
        panic!("{:?}", checked.warnings);
    };
    assert!(
        warning.text.contains("there is nothing to draw"),
        "{}",
        warning.text
    );
    let unit = checked.unit.expect("no mistake");
    let functions: Vec<&str> = unit.functions.iter().map(|f| f.name.as_str()).collect();
    assert_eq!(functions, ["turned"]);
    assert!(unit.picture.is_none());
}

#[test]
fn other_functions_stay_as_they_are() {
    let items = format!(
        "{FOUR_BAR} let p = polar(crank, phi); loop p + polar(coupler, theta) = (base, 0) + polar(rocker, psi);
         let tip = p + polar(70mm, theta + 25deg);"
    );
    let motion = "fn motion(phi) -> Motion { tip, v: velocity(tip), a: acceleration(tip), e: sensitivity(tip), m: margin() }";
    let look = "fn look(phi) -> Look { shape: picture() }";
    let (alone, _) = compile(&items, motion);
    for functions in [format!("{motion} {look}"), format!("{look} {motion}")] {
        let (beside, messages) = compile(&items, &functions);
        assert!(messages.is_empty(), "{messages:?}");
        let find = |unit: &CompiledMechanism| {
            let found = unit
                .functions
                .iter()
                .find(|function| function.fields.len() == 5);
            let program = &found.expect("the function").called.program;
            let operations = program
                .instructions
                .iter()
                .map(|one| format!("{one:?}").split('(').next().map(str::to_owned));
            (program.outputs.clone(), operations.collect::<Vec<_>>())
        };
        assert_eq!(find(&beside), find(&alone));
    }
    assert!(alone.picture.is_none());
}
