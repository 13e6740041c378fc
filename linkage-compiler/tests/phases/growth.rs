//! How an expansion grows with the mechanism: the time it takes, and what it gives to rustc, which costs users more.

use std::fmt::Write;

use linkage_compiler::check;
use proc_macro2::{TokenStream, TokenTree};

use super::compiled;
use super::speed::time;

/// A chain of parallelogram-like dyads, each driven by the last link of the one before.
fn chain(groups: usize, functions: &str) -> String {
    let mut text = String::from(
        "pub struct Chain { unit mm; input phi = 60deg in 55deg..65deg;\n\
         param crank = 30mm; let p0 = polar(crank, phi);\n",
    );
    for k in 1..=groups {
        let before = k - 1;
        let (x, y) = (40 * k, 0);
        let _ = writeln!(
            text,
            "param rod{k} = 40mm; param arm{k} = 30mm; const pivot{k} = ({x}mm, {y}mm);\n\
             unknown theta{k} = 5deg; unknown psi{k} = 62deg;\n\
             loop p{before} + polar(rod{k}, theta{k}) = pivot{k} + polar(arm{k}, psi{k});\n\
             let p{k} = pivot{k} + polar(arm{k}, psi{k});"
        );
    }
    let _ = writeln!(text, "}}\nimpl Chain {{ {functions} }}");
    text
}

/// A point at the end, its derivatives, the margin, and an angle at the beginning.
fn motion(groups: usize) -> String {
    let end = format!("p{groups}");
    chain(
        groups,
        &format!(
            "pub fn motion(phi) -> Motion {{ {end}, v: velocity({end}), a: acceleration({end}), m: margin() }}\n\
             pub fn first(phi) -> First {{ psi1, e: sensitivity(psi1, [crank, rod1, arm1]) }}"
        ),
    )
}

#[test]
fn time_grows_linearly_with_the_number_of_groups() {
    for groups in [1, 2, 5, 20] {
        println!("{groups} groups {:?}", time(&motion(groups), 5));
    }
    let (small, large) = (time(&motion(10), 5), time(&motion(50), 3));
    let ratio = large.as_secs_f64() / small.as_secs_f64();
    println!("10 groups {small:?}, 50 groups {large:?}: {ratio:.1} times");
    assert!(
        ratio < 10.0,
        "10 groups {small:?}, 50 groups {large:?}: {ratio:.1} times"
    );
}

/// A chain with one quantity, with `END` for the last point.
fn asking(groups: usize, field: &str) -> String {
    let field = field.replace("END", &format!("p{groups}"));
    let function = format!("pub fn motion(phi) -> Motion {{ it: {field} }}");
    chain(groups, &function)
}

/// What grows with the square of the number of dyads would take nine times as long for three times as many.
#[test]
fn time_of_sensitivities_and_pictures_grows_linearly() {
    for field in ["sensitivity(END)", "picture()"] {
        let [small, large] = [40, 120].map(|groups| time(&asking(groups, field), 2));
        let ratio = large.as_secs_f64() / small.as_secs_f64();
        println!("{field}: 40 groups {small:?}, 120 groups {large:?}: {ratio:.1} times");
        assert!(
            ratio < 5.5,
            "{field}: 40 groups {small:?}, 120 groups {large:?}: {ratio:.1} times"
        );
    }
}

/// The same of long chains, each twice as long as the one before.
#[test]
fn long_chains_take_twice_as_long_as_half_of_them() {
    if !linkage_random::is_long() {
        return;
    }
    for field in ["END", "acceleration(END)", "sensitivity(END)", "picture()"] {
        let times = [200, 400, 800].map(|groups| time(&asking(groups, field), 3));
        println!("{field}: 200, 400, 800 groups {times:?}");
        for pair in times.windows(2) {
            let ratio = pair[1].as_secs_f64() / pair[0].as_secs_f64();
            assert!(ratio < 2.8, "{field}: {times:?}");
        }
        assert!(times[2].as_secs_f64() < 8.0, "{field}: {times:?}");
    }
}

/// A direction that grows with the square is not built, but the one that costs least is, as where all are built.
#[test]
fn long_chains_take_the_direction_of_short_ones() {
    let direction = |groups: usize, field: &str| {
        let checked = check(asking(groups, field).parse().expect("tokens"));
        let unit = checked.unit.expect("it has no mistake");
        let called = unit.functions[0].called.count.total() as usize;
        (unit.functions[0].sensitivities, called)
    };
    let ((short, few), (long, many)) = (
        direction(30, "sensitivity(END)"),
        direction(70, "sensitivity(END)"),
    );
    assert_eq!(short, long);
    // So many operations for each dyad.
    let each = (many - few) as f64 / 40.0;
    let expected = few as f64 / 30.0;
    assert!((each / expected - 1.0).abs() < 0.1, "{few}, {many}");
    // Many results, few parameters.
    let points = (1..=70).map(|k| format!("e{k}: sensitivity(p{k}, [rod1, arm1])"));
    let function = points.collect::<Vec<_>>().join(", ");
    let function = format!("pub fn motion(phi) -> Motion {{ {function} }}");
    let checked = check(chain(70, &function).parse().expect("tokens"));
    let unit = checked.unit.expect("it has no mistake");
    assert_eq!(unit.functions[0].sensitivities, Some("forward"));
}

pub(super) fn count(tokens: TokenStream) -> usize {
    let one = |tree| match tree {
        TokenTree::Group(group) => 2 + count(group.stream()),
        _ => 1,
    };
    tokens.into_iter().map(one).sum()
}

/// What rustc gets for one field of a function.
fn tokens(groups: usize, field: &str) -> usize {
    let text = asking(groups, field);
    let output = compiled(text.parse().expect("tokens"));
    assert!(!output.to_string().contains("compile_error !"), "{output}");
    count(output)
}

/// What the end and a point of the coupler before it cost with their sensitivities.
fn operations(groups: usize) -> u32 {
    let coupler = format!("p{} + polar(15mm, theta{groups} + 20deg)", groups - 1);
    let function = format!(
        "pub fn accuracy(phi) -> Accuracy {{ p: sensitivity(p{groups}), q: sensitivity({coupler}) }}"
    );
    let text = chain(groups, &function);
    let checked = check(text.parse().expect("tokens"));
    let unit = checked.unit.expect("it has no mistake");
    let count = unit.functions[0].called.count;
    count.add + count.mul + count.div
}

/// A dyad before the last one acts on all four numbers through one angle. Without that, each cost 85 operations.
#[test]
fn sensitivities_pass_narrow_places_once() {
    let [small, large] = [4, 8].map(operations);
    println!("4 dyads {small} operations, 8 dyads {large}");
    assert!(large - small <= 4 * 55, "{small}, {large}");
}

/// `exponent`: of the number of groups, when it is doubled; of `sensitivity(sensitivity(..))` there are as many results as pairs of parameters.
#[test]
fn tokens_grow_with_the_number_of_results() {
    for (field, exponent) in [
        ("END", 1.0),
        ("acceleration(END)", 1.0),
        ("sensitivity(END)", 1.0),
        ("sensitivity(acceleration(END))", 1.0),
        ("sensitivity(sensitivity(END))", 2.0),
        ("picture()", 1.0),
    ] {
        // A square is soon large enough to be seen.
        let groups = if exponent > 1.0 { 6 } else { 20 };
        let [small, large] = [groups, 2 * groups].map(|groups| tokens(groups, field));
        let found = (large as f64 / small as f64).log2();
        println!("{field}: {small} and {large} tokens, exponent {found:.2}");
        assert!(
            found < exponent + 0.1,
            "{field}: {small} tokens for {groups} groups, {large} for twice as many"
        );
    }
}
