//! Assembled mechanisms in JavaScript, of the golden files and of the examples, at their dimensions and at others: against the command's own numbers, and
//! to the last bit against generated Rust without fused multiply-adds.

use std::f64::consts::TAU;

use linkage_browser::Page;
use linkage_compiler::ir::Function;
use linkage_corpus::given::{Given, exported, turning};
use linkage_corpus::reference::Assembled;
use linkage_engine::{Assembly, Mechanism};
use linkage_random::Random;

use crate::{load, object};

/// Sets of dimensions of each mechanism, and positions for each: the declared ones and the reference first.
const SETS: usize = 4;
const POSITIONS: usize = 60;

/// Roundoffs of the size of a result: the command fuses multiply-adds, with which its sines have other polynomials. Groups without a closed form end at a
/// correction whose square is a roundoff; among positions of several hundred thousand results the largest difference was 244.
const CLOSED_FORMS: f64 = 40.0;
const COUPLED: f64 = 300.0;

/// Roundoffs between JavaScript and generated Rust without fused multiply-adds that settles coupled groups as JavaScript does: both end some roundoffs from
/// the solution, in different ones, which sensitivities beside dead points enlarge (31 of them where it was measured; of positions 6), and the condition
/// of a platform on six legs, which is 155 (186).
const SETTLED: f64 = 256.0;
/// Steps after which a state from a table is settled: the square of 1e-7 of its own square.
const STEPS: usize = 2;

/// A mechanism, and its module in a page.
struct Both<'p> {
    mechanism: Mechanism,
    page: &'p mut Page,
}

impl<'p> Both<'p> {
    fn new(given: Given, page: &'p mut Page) -> Self {
        Self {
            mechanism: load("assembled", given, page),
            page,
        }
    }

    /// Dimensions near the declared ones.
    fn dimensions(&self, set: usize, random: &mut Random) -> Vec<f64> {
        let part = 0.02 * set as f64;
        let own = self.mechanism.dimensions().into_iter();
        own.map(|x| x * (1.0 + random.between(-part, part)))
            .collect()
    }

    /// Assembles both; `None` if neither closes.
    fn assembled(&mut self, dimensions: &[f64]) -> Option<Assembly<'_>> {
        let given = object(&self.mechanism, dimensions);
        let said = self.page.words(&format!(
            "(() => {{ try {{ window.own = mechanism.assemble({given}); return ''; }} catch (error) {{ return error.message; }} }})()"
        ));
        let expected = self.mechanism.assemble(dimensions);
        let name = self.mechanism.name();
        assert_eq!(
            said.is_empty(),
            expected.is_ok(),
            "{name}: {said}\n{:?}",
            expected.err()
        );
        expected.ok()
    }
}

/// Arguments of a function: the reference, then others within the ranges.
fn arguments(mechanism: &Mechanism, function: usize, random: &mut Random) -> Vec<Vec<f64>> {
    let unit = &mechanism.compiled();
    let mut one = |position: usize, place: usize| match unit.inputs.get(place) {
        Some(input) if position == 0 => input.reference,
        Some(input) => {
            let (low, high) = input.range.unwrap_or(input.followed);
            let turns = (high - low) / TAU;
            // Whole turns lead back.
            let more = if input.angle && turns >= 0.999 {
                TAU * random.below(5) as f64 - 2.0 * TAU
            } else {
                0.0
            };
            random.between(low, high) + more
        }
        None => random.between(-2.0, 2.0),
    };
    let places = &unit.functions[function].arguments;
    let rows =
        (0..POSITIONS).map(|position| places.iter().map(|&place| one(position, place)).collect());
    rows.collect()
}

/// The columns of a function in the page.
fn columns(page: &mut Page, name: &str, rows: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let arguments = (0..rows[0].len()).map(|k| {
        let own: Vec<f64> = rows.iter().map(|row| row[k]).collect();
        format!(", {own:?}")
    });
    let arguments: String = arguments.collect();
    let text = page.words(&format!(
        "mechanism.columns(own, {name:?}{arguments}).map((column) => Array.from(column).join(' ')).join(';')"
    ));
    let numbers = |column: &str| {
        column
            .split(' ')
            .map(|word| word.parse().expect("a number"))
            .collect()
    };
    text.split(';').map(numbers).collect()
}

/// Compares a function; how many results were compared.
fn compare(
    page: &mut Page,
    expected: &Assembly,
    mechanism: &Mechanism,
    function: usize,
    random: &mut Random,
) -> usize {
    let own = &mechanism.compiled().functions[function];
    if own.columns.is_empty() {
        return 0;
    }
    let rows = arguments(mechanism, function, random);
    let rust: Vec<Vec<f64>> = rows
        .iter()
        .map(|row| expected.call(function, row))
        .collect();
    let growth: Vec<Vec<f64>> = rows
        .iter()
        .map(|row| growth(expected, function, row))
        .collect();
    let js = columns(page, own.name.trim_start_matches("r#"), &rows);
    let roundoffs = match mechanism.compiled().coupled.is_empty() {
        true => CLOSED_FORMS,
        false => COUPLED,
    };
    for (column, values) in js.iter().enumerate() {
        let size = size(own, column, &rust);
        // Functions without arguments have one row.
        for (row, js) in values.iter().enumerate() {
            let (rust, growth) = (rust[row][column], growth[row][column]);
            let same = js == &rust || (js.is_nan() && rust.is_nan());
            assert!(
                same || (js - rust).abs() <= roundoffs * f64::EPSILON * (size + growth),
                "{}, {}, {} at {:?}: {js:e} in JavaScript, {rust:e} in Rust, {:.1} roundoffs of {size:e} and {growth:e}",
                mechanism.name(),
                own.name,
                own.columns[column].name,
                rows[row],
                (js - rust).abs() / (f64::EPSILON * (size + growth))
            );
        }
    }
    js.len() * js[0].len()
}

/// Compares a function with generated Rust that has no fused multiply-adds: to the last bit if all groups have a closed form. The largest difference in
/// roundoffs of the size of results and of what roundoffs of the arguments make of them.
fn compare_plain(
    page: &mut Page,
    plain: &Assembled<'_, f64>,
    expected: &Assembly,
    mechanism: &Mechanism,
    function: usize,
    random: &mut Random,
) -> f64 {
    let own = &mechanism.compiled().functions[function];
    let mut worst = 0.0;
    if own.columns.is_empty() {
        return worst;
    }
    let rows = arguments(mechanism, function, random);
    let js = columns(page, own.name.trim_start_matches("r#"), &rows);
    let rust: Vec<Vec<f64>> = rows.iter().map(|row| plain.call(own, row)).collect();
    let growth: Vec<Vec<f64>> = rows
        .iter()
        .map(|row| growth(expected, function, row))
        .collect();
    for (column, values) in js.iter().enumerate() {
        let size = size(own, column, &rust);
        for (row, js) in values.iter().enumerate() {
            let rust = rust[row][column];
            if js == &rust || (js.is_nan() && rust.is_nan()) {
                continue;
            }
            assert!(
                !mechanism.compiled().coupled.is_empty(),
                "{}, {}, {} at {:?}: {js:e} in JavaScript, {rust:e} in Rust",
                mechanism.name(),
                own.name,
                own.columns[column].name,
                rows[row]
            );
            let roundoffs = (js - rust).abs() / (f64::EPSILON * (size + growth[row][column]));
            worst = f64::max(worst, roundoffs);
        }
    }
    worst
}

/// What the roundings of a column are measured by: the largest of its numbers and of those that have its unit, since a coordinate may be nothing but what
/// sums leave of larger ones.
fn size(own: &Function, column: usize, rows: &[Vec<f64>]) -> f64 {
    let columns = &own.columns;
    let alike = (0..columns.len()).filter(|&other| columns[other].unit == columns[column].unit);
    let sizes = alike.flat_map(|other| rows.iter().map(move |row| row[other].abs()));
    // A number is a quotient of lengths, and so is an angle, as of an axis that is hardly tilted: what they are made of has the size 1.
    let least = f64::from(["", "rad"].contains(&&columns[column].unit[..]));
    sizes.filter(|x| x.is_finite()).fold(least, f64::max)
}

/// By how much results change for a small part of the arguments, over that part: near a dead point roundoffs of what goes in are large in what comes
/// out.
fn growth(expected: &Assembly, function: usize, row: &[f64]) -> Vec<f64> {
    const PART: f64 = 1e-9;
    let beside: Vec<f64> = row.iter().map(|x| x * (1.0 + PART)).collect();
    let [here, there] = [row, &beside].map(|row| expected.call(function, row));
    let pairs = here.iter().zip(&there);
    pairs
        .map(|(here, there)| (there - here).abs() / PART)
        .collect()
}

#[test]
fn assembled_mechanisms_are_those_of_the_command() {
    let Some(mut page) = Page::empty() else {
        return;
    };
    let mut random = Random::new(7);
    let (mut closed, mut count, mut worst) = (0, 0, 0.0);
    for given in exported().into_iter().chain(turning()) {
        let mut both = Both::new(given, &mut page);
        for set in 0..SETS {
            let dimensions = both.dimensions(set, &mut random);
            if both.assembled(&dimensions).is_none() {
                assert!(
                    set > 0,
                    "{} closes as it is declared",
                    both.mechanism.name()
                );
                continue;
            }
            let Both { mechanism, page } = &mut both;
            let expected = mechanism.assemble(&dimensions).expect("it closed before");
            closed += 1;
            for function in 0..mechanism.compiled().functions.len() {
                count += compare(page, &expected, mechanism, function, &mut random);
            }
            // The tables of coupled groups are those of the declaration.
            if mechanism.compiled().coupled.is_empty() || set == 0 {
                let plain =
                    Assembled::new(mechanism.compiled(), &dimensions).expect("it closed before");
                let plain = plain.stepped(STEPS);
                for function in 0..mechanism.compiled().functions.len() {
                    let found =
                        compare_plain(page, &plain, &expected, mechanism, function, &mut random);
                    worst = f64::max(worst, found);
                }
            }
        }
    }
    println!("{closed} assemblies, {count} results, coupled groups to {worst:.1} roundoffs");
    assert!(worst < SETTLED, "{worst}");
    assert!(closed > 100 && count > 200_000);
}
