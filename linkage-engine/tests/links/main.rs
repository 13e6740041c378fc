//! Known mechanisms in both spellings, by joints and links and by loops: the same groups, the same
//! numbers of operations, the same positions.

mod random;

use linkage_engine::Mechanism;

/// Inputs at which positions are compared, from one end of the range to the other.
const STEPS: usize = 24;

/// A mechanism in both spellings. Their function `points` returns the same points.
struct Pair {
    name: &'static str,
    links: &'static str,
    loops: &'static str,
}

/// Returns the mechanisms of the file: a name, the text by joints and links, the one by loops.
fn pairs() -> Vec<Pair> {
    let entries = include_str!("pairs.txt").split("== ").skip(1);
    let pairs = entries.map(|entry| {
        let (name, texts) = entry.split_once('\n').expect("a name");
        let (links, loops) = texts.split_once("--\n").expect("two spellings");
        Pair { name, links, loops }
    });
    pairs.collect()
}

fn compiled(pair: &Pair, text: &str) -> Mechanism {
    let points: Vec<&str> = ["t", "c", "r"]
        .into_iter()
        .filter(|point| {
            [format!("let {point} "), format!(" {point} = (")]
                .iter()
                .any(|d| text.contains(d.as_str()))
        })
        .collect();
    let input = text
        .split_whitespace()
        .nth(1)
        .expect("it begins with its input");
    let points = points.join(", ");
    let text = format!(
        "pub struct Linkage {{ unit mm; {text} }} impl Linkage {{ pub fn points({input}) -> Points {{ {points} }} }}"
    );
    Mechanism::compile(&text).unwrap_or_else(|error| panic!("{}: {error}", pair.name))
}

#[test]
fn both_spellings_are_one_mechanism() {
    let pairs = pairs();
    assert_eq!(pairs.len(), 12);
    for pair in &pairs {
        let [links, loops] = [pair.links, pair.loops].map(|text| compiled(pair, text));
        let kinds = |mechanism: &Mechanism| {
            let groups = mechanism.structure().groups.iter();
            groups
                .map(|group| (group.kind, group.class, group.order))
                .collect::<Vec<_>>()
        };
        assert_eq!(kinds(&links), kinds(&loops), "{}", pair.name);
        let total = |mechanism: &Mechanism| {
            let functions = mechanism.structure().functions.iter();
            functions
                .map(|function| function.operations.total())
                .collect::<Vec<_>>()
        };
        assert_eq!(total(&links), total(&loops), "{}", pair.name);
        let (low, high) = links.inputs()[0].range.expect("the input has a range");
        let [links, loops] = [&links, &loops].map(|mechanism| {
            let dimensions = mechanism.dimensions();
            let assembly = mechanism.assemble(&dimensions);
            assembly.unwrap_or_else(|error| panic!("{}: {error}", pair.name))
        });
        for step in 0..=STEPS {
            let input = low + (high - low) * step as f64 / STEPS as f64;
            let [one, other] = [&links, &loops].map(|assembly| assembly.call(0, &[input]));
            assert!(!one.is_empty() && one.len() == other.len(), "{}", pair.name);
            for (one, other) in one.iter().zip(&other) {
                assert!((one - other).abs() <= 1e-11, "{}: {one} {other}", pair.name);
            }
        }
    }
}

/// At run time, too, a text with joints and links has no loops for the user.
#[test]
fn groups_have_the_names_of_joints() {
    let pairs = pairs();
    let four_bar = pairs.iter().find(|pair| pair.name == "four-bar");
    let four_bar = four_bar.expect("the four-bar");
    let names = |text: &str| -> Vec<String> {
        let mechanism = compiled(four_bar, text);
        let groups = mechanism.structure().groups.iter();
        groups.map(|group| group.loop_names()).collect()
    };
    assert_eq!(names(four_bar.links), ["joint `c` of `rocker`"]);
    assert_eq!(names(four_bar.loops), ["loop 1"]);
    let mechanism = compiled(four_bar, four_bar.links);
    let mut dimensions = mechanism.dimensions();
    let mut parameters = mechanism.parameters().iter();
    let crank = parameters.position(|parameter| parameter.name == "crank.length");
    dimensions[crank.expect("a length")] = 1000.0;
    let error = mechanism.assemble(&dimensions).expect_err("it is too long");
    let text = error.to_string();
    assert!(
        text.starts_with("Linkage: joint `c` of `rocker` ("),
        "{text}"
    );
}
