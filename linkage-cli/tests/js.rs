//! Assembled mechanisms in JavaScript, of the golden files and of the examples, at their dimensions and at others: against the command's own numbers.

use std::f64::consts::TAU;
use std::fs;
use std::path::Path;

use linkage_browser::Page;
use linkage_cli::{Assembly, Mechanism};
use linkage_compiler::Checked;
use linkage_corpus::given::{Given, exported, turning};
use linkage_random::Random;

/// Sets of dimensions of each mechanism, and positions for each: the declared ones and the reference first.
const SETS: usize = 4;
const POSITIONS: usize = 60;

/// Roundoffs of the size of a result: sines have others in the browser, and the command fuses multiply-adds. Groups without a closed form end at a
/// correction whose square is a roundoff.
const CLOSED_FORMS: f64 = 40.0;
const COUPLED: f64 = 200.0;

/// A mechanism, and its module in a page.
struct Both<'p> {
    mechanism: Mechanism,
    page: &'p mut Page,
}

impl<'p> Both<'p> {
    fn new(given: Given, page: &'p mut Page) -> Self {
        let Given { name, unit } = given;
        let script = linkage_js::module(&name, &unit).script;
        let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.html"));
        let html = format!(
            "<!doctype html><meta charset=\"utf-8\"><script type=\"module\">\n{script}\nwindow.mechanism = mechanism;\n</script>"
        );
        fs::write(&file, html).expect("a file");
        page.load(&file);
        page.wait(&format!("mechanism.name === '{name}'"));
        let checked = Checked {
            name: Some(name),
            unit: Some(unit),
            messages: Vec::new(),
            warnings: Vec::new(),
        };
        Self {
            mechanism: Mechanism::new(&checked).expect("it has no mistake"),
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
        let names = self.mechanism.parameters.iter().map(|own| own.name);
        let pairs = names
            .zip(dimensions)
            .map(|(name, x)| format!("{name:?}: {x:?}"));
        let pairs = pairs.collect::<Vec<_>>().join(", ");
        let said = self.page.words(&format!(
            "(() => {{ try {{ window.own = mechanism.assemble({{ {pairs} }}); return ''; }} catch (error) {{ return error.message; }} }})()"
        ));
        let expected = self.mechanism.assemble(dimensions);
        let name = self.mechanism.name;
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
    let unit = &mechanism.unit;
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
    let own = &mechanism.unit.functions[function];
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
    let roundoffs = match mechanism.unit.coupled.is_empty() {
        true => CLOSED_FORMS,
        false => COUPLED,
    };
    for (column, values) in js.iter().enumerate() {
        // A coordinate may be nothing but what sums leave of larger ones.
        let alike =
            (0..js.len()).filter(|&other| own.columns[other].unit == own.columns[column].unit);
        let sizes = alike.flat_map(|other| rust.iter().map(move |row| row[other].abs()));
        let size = sizes.filter(|x| x.is_finite()).fold(0.0, f64::max);
        // Functions without arguments have one row.
        for (row, js) in values.iter().enumerate() {
            let (rust, growth) = (rust[row][column], growth[row][column]);
            let same = js == &rust || (js.is_nan() && rust.is_nan());
            assert!(
                same || (js - rust).abs() <= roundoffs * f64::EPSILON * (size + growth),
                "{}, {}, {} at {:?}: {js:e} in JavaScript, {rust:e} in Rust, {:.1} roundoffs of {size:e} and {growth:e}",
                mechanism.name,
                own.name,
                own.columns[column].name,
                rows[row],
                (js - rust).abs() / (f64::EPSILON * (size + growth))
            );
        }
    }
    js.len() * js[0].len()
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
    let (mut closed, mut count) = (0, 0);
    for given in exported().into_iter().chain(turning()) {
        let mut both = Both::new(given, &mut page);
        for set in 0..SETS {
            let dimensions = both.dimensions(set, &mut random);
            if both.assembled(&dimensions).is_none() {
                assert!(set > 0, "{} closes as it is declared", both.mechanism.name);
                continue;
            }
            let Both { mechanism, page } = &mut both;
            let expected = mechanism.assemble(&dimensions).expect("it closed before");
            closed += 1;
            for function in 0..mechanism.unit.functions.len() {
                count += compare(page, &expected, mechanism, function, &mut random);
            }
        }
    }
    println!("{closed} assemblies, {count} results");
    assert!(closed > 100 && count > 200_000);
}
