//! Many changes by the fields of pages, with the values and the rows without values that Rust computes for the same dimensions.

use std::f64::consts::PI;

use linkage_corpus::reference::Assembled;
use linkage_random::Random;
use linkage_runtime::{AssemblyError, CoupledCause};
use serde_json::Value;

use crate::pages::Live;
use crate::pages::is_derived;

/// How many designs of all mechanisms together; `LIVE_COUNT=10000` in the environment takes more.
const COUNT: usize = 60;

/// Designs of one question to the page.
const AT_ONCE: usize = 20;

/// Roundoffs of results of coupled groups, as in `js/assembled.rs`: Rust makes one step from a table. Closed forms are equal to the last bit.
const COUPLED: f64 = 200.0;

/// Sets the fields of each design after a reset, one change for each, and gives what the page says, and of each table the rows of CSV that are asked for
/// and those at which a value begins or ends to be missing.
const CHANGED: &str = "window.changed = async (designs, every) => {
    const answers = [];
    for (const { fields, offset } of designs) {
        document.getElementById('reset').click();
        let says = '';
        for (const [name, value] of fields) {
            const field = document.querySelector(`input[data-dimension=\"${name}\"]`);
            field.value = value;
            field.dispatchEvent(new Event('change'));
            if (says === '') says = document.getElementById('says').textContent;
        }
        const tables = {};
        for (const button of document.querySelectorAll('button[data-file$=\".csv\"]')) {
            button.click();
            while (window.saved.length === 0) await new Promise((done) => setTimeout(done));
            const lines = (await window.saved.pop().text()).trimEnd().split('\\r\\n').filter((line) => !line.includes('# changed')).slice(1);
            const missing = lines.map((line) => line.split(',').map((word) => (word === '' ? 'x' : '.')).join(''));
            const edge = (row) => row >= 0 && row + 1 < lines.length && missing[row] !== missing[row + 1];
            tables[button.dataset.file.slice(0, -4)] = lines.filter((_, row) => row % every === offset || edge(row) || edge(row - 1));
        }
        answers.push({ says, tables });
    }
    return JSON.stringify(answers);
}; 0";

const EVERY: usize = 9;

/// What is typed, and the dimensions that it makes.
struct Design {
    fields: Vec<(String, f64)>,
    dimensions: Vec<f64>,
}

impl Design {
    /// One to three dimensions are others.
    fn random(live: &Live, random: &mut Random) -> Self {
        let mut dimensions = live.mechanism.dimensions();
        let mut fields = Vec::new();
        for _ in 0..=random.below(3) {
            let index = random.below(dimensions.len());
            let own = &live.mechanism.parameters()[index];
            let part = *random.pick(&[0.002, 0.02, 0.1, 0.3]);
            let size = match (own.nominal == 0.0, own.unit) {
                (false, _) => own.nominal,
                (true, "rad") => 1.0,
                (true, _) => live.mechanism.compiled().longest,
            };
            let moved = own.nominal + size * random.between(-part, part);
            // Fields of angles have degrees.
            let (typed, value) = match own.unit {
                "rad" => {
                    let typed = moved.to_degrees();
                    (typed, (typed * PI) / 180.0)
                }
                _ => (moved, moved),
            };
            dimensions[index] = value;
            fields.push((own.name.to_owned(), typed));
        }
        Self { fields, dimensions }
    }

    fn text(&self, offset: usize) -> String {
        let fields = self
            .fields
            .iter()
            .map(|(name, x)| format!("[{name:?}, {x:?}]"));
        let fields: Vec<String> = fields.collect();
        format!("{{ fields: [{}], offset: {offset} }}", fields.join(", "))
    }
}

#[derive(Debug, Default)]
struct Counts {
    designs: usize,
    refused: usize,
    /// Coupled groups that reach a dead point in the range, which Rust refuses and the page shows up to there.
    ended: usize,
    values: usize,
    missing: usize,
    roundoffs: f64,
}

/// Compares the tables of a design.
fn compare(live: &Live, design: &Design, tables: &Value, counts: &mut Counts) {
    let unit = &live.mechanism.compiled();
    let name = live.mechanism.name();
    let exact = unit.coupled.is_empty();
    let plain = Assembled::new(unit, &design.dimensions);
    let command = live.mechanism.assemble(&design.dimensions);
    if let (false, Err(error)) = (exact, &command) {
        ends_there(design, tables, error);
        counts.ended += 1;
        return;
    }
    let tables = tables.as_object().expect("tables").iter();
    for (function, rows) in tables.filter(|(name, _)| !is_derived(live.mechanism, name)) {
        let number = unit
            .functions
            .iter()
            .position(|own| own.name == *function)
            .expect("it is one of them");
        let own = &unit.functions[number];
        let at = |x: f64| {
            let places = own.arguments.iter();
            let arguments = places.map(|&place| match place {
                0 => x,
                _ => unit.inputs[place].reference,
            });
            let arguments: Vec<f64> = arguments.collect();
            match exact {
                true => plain.as_ref().expect("it closes").call(own, &arguments),
                false => command
                    .as_ref()
                    .expect("it closes")
                    .call(number, &arguments),
            }
        };
        let rows: Vec<Vec<Option<f64>>> = rows
            .as_array()
            .expect("rows")
            .iter()
            .map(|line| {
                let words = line.as_str().expect("a line").split(',');
                words.map(|word| word.parse().ok()).collect()
            })
            .collect();
        let rust: Vec<Vec<f64>> = rows
            .iter()
            .map(|row| at(row[0].expect("an input")))
            .collect();
        for column in 0..own.columns.len() {
            let sizes = rust
                .iter()
                .map(|row| row[column].abs())
                .filter(|x| x.is_finite());
            let size = sizes.fold(unit.longest * 1e-3, f64::max);
            for (row, rust) in rows.iter().zip(&rust) {
                let rust = rust[column];
                let what = || {
                    format!(
                        "{name}, {:?}, {function}, {} at {:?}",
                        design.fields, own.columns[column].name, row[0]
                    )
                };
                match row[column + 1] {
                    None => {
                        assert!(!rust.is_finite(), "{}: there is {rust}", what());
                        counts.missing += 1;
                    }
                    Some(js) if exact => {
                        assert!(js == rust, "{}: {js:e} on the page, {rust:e}", what());
                        counts.values += 1;
                    }
                    Some(js) => {
                        let x = row[0].expect("an input");
                        let beside = at(x + 1e-9 * x.abs().max(1.0))[column];
                        let growth = (beside - rust).abs() / 1e-9;
                        let roundoffs = (js - rust).abs() / (f64::EPSILON * (size + growth));
                        assert!(roundoffs <= COUPLED, "{}: {roundoffs}", what());
                        counts.roundoffs = counts.roundoffs.max(roundoffs);
                        counts.values += 1;
                    }
                }
            }
        }
    }
}

/// The page's rows end where Rust finds the dead point of the range.
fn ends_there(design: &Design, tables: &Value, error: &AssemblyError) {
    let AssemblyError::Coupled(own) = error else {
        panic!("{:?}: {error}", design.fields)
    };
    let CoupledCause::DeadPoint(place) = &own.cause else {
        panic!("{:?}: {error}", design.fields)
    };
    let lines = tables["rocker"].as_array().expect("rows").iter();
    let rows: Vec<(f64, bool)> = lines
        .map(|line| {
            let (x, rest) = line.as_str().expect("a line").split_once(',').expect("two");
            (x.parse().expect("an input"), !rest.starts_with(','))
        })
        .collect();
    let turned = |x: f64| [x - 2.0 * PI, x, x + 2.0 * PI];
    let edges = rows.windows(2).filter(|pair| pair[0].1 != pair[1].1);
    let near = |pair: &[(f64, bool)]| {
        let places = turned(place.value).into_iter();
        places
            .into_iter()
            .any(|x| x >= pair[0].0 - 1e-6 && x <= pair[1].0 + 1e-6)
    };
    let found = edges.clone().any(near);
    assert!(
        found,
        "{:?}: {error}, {:?}",
        design.fields,
        edges.collect::<Vec<_>>()
    );
}

#[test]
fn many_changes_are_what_rust_computes() {
    let wanted = std::env::var("LIVE_COUNT").ok();
    let count = wanted.and_then(|text| text.parse().ok()).unwrap_or(COUNT);
    let mechanisms = [
        "crank_rocker.mech",
        "favorit.rs",
        "quick_return.rs",
        "spatial_crank_rocker.rs",
        "geared_five_bar.rs",
        "eye_needle.rs",
    ];
    let each = usize::div_ceil(count, mechanisms.len());
    let mut random = Random::new(10_000);
    for file in mechanisms {
        let found = match file.ends_with(".rs") {
            true => Live::example_as(file, "many"),
            false => Live::golden_as(file, "many"),
        };
        let Some(mut live) = found else {
            return;
        };
        live.page.value("document.getElementById('play').click()");
        live.page.value(CHANGED);
        let mut counts = Counts::default();
        while counts.designs < each {
            let designs: Vec<Design> = (0..AT_ONCE.min(each - counts.designs))
                .map(|_| Design::random(&live, &mut random))
                .collect();
            let texts: Vec<String> = designs
                .iter()
                .map(|own| own.text(random.below(EVERY)))
                .collect();
            let answer = live
                .page
                .words(&format!("changed([{}], {EVERY})", texts.join(", ")));
            let answers: Value = serde_json::from_str(&answer).expect("answers");
            for (design, answer) in designs.iter().zip(answers.as_array().expect("a list")) {
                counts.designs += 1;
                let says = answer["says"].as_str().expect("words");
                if says.is_empty() {
                    compare(&live, design, &answer["tables"], &mut counts);
                } else {
                    // What is refused changes nothing; `typed.rs` looks at that.
                    assert!(says.contains(" is refused: "), "{says}");
                    counts.refused += 1;
                }
            }
        }
        println!("{file}: {counts:?}");
        assert!(counts.values > 0 && counts.refused < counts.designs / 2);
        live.page.assert_quiet();
    }
}
