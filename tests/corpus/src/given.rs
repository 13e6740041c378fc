//! Mechanisms that are exported: those of the golden files and of the folder `mechanisms`.

use std::fs;
use std::path::Path;
use std::sync::OnceLock;

use linkage_compiler::check;
use linkage_compiler::ir::CompiledMechanism;
use linkage_random::Random;
use proc_macro2::{TokenStream, TokenTree};

/// A mechanism with its name.
#[derive(Clone)]
pub struct Given {
    /// As its struct is called, the last one of several.
    pub name: String,
    /// Its programs.
    pub unit: CompiledMechanism,
}

impl Given {
    /// A mechanism from what stands between the braces of `mechanism!`.
    pub fn new(body: TokenStream) -> Self {
        let checked = check(body);
        let name = checked.name.expect("a mechanism has a name");
        let messages = checked.messages;
        let unit = checked
            .unit
            .unwrap_or_else(|| panic!("{name}: {messages:?}"));
        Self { name, unit }
    }

    /// A mechanism from its text.
    pub fn text(text: &str) -> Self {
        Self::new(text.parse().expect("brackets have partners"))
    }
}

/// Returns arguments of a function: the reference at the position 0, then places in the range and
/// around it.
pub fn arguments(
    unit: &CompiledMechanism,
    function: usize,
    position: usize,
    random: &mut Random,
) -> Vec<f64> {
    let one = |&index: &usize| match unit.inputs.get(index) {
        Some(input) if position == 0 => input.reference,
        Some(input) => {
            let around = if input.angle { 7.0 } else { 0.3 * unit.longest };
            let (low, high) = input
                .range
                .unwrap_or((input.reference - around, input.reference + around));
            // Every third position may be far out of reach.
            let beyond = if position % 3 == 2 { 2.0 } else { 0.1 } * (high - low);
            random.between(low - beyond, high + beyond)
        }
        None => random.load(10.0),
    };
    unit.functions[function].arguments.iter().map(one).collect()
}

/// Golden mechanisms and those of the folder `mechanisms`.
#[must_use]
pub fn exported() -> Vec<Given> {
    let mut all = golden();
    all.extend(examples());
    all
}

/// Mechanisms whose angles are not near to their estimates everywhere.
#[must_use]
pub fn turning() -> Vec<Given> {
    let text = include_str!("../../../linkage-compiler/tests/golden/crank_rocker.mech");
    // It has made turns before.
    let turned = text.replace("psi   = 80deg", "psi   = 800deg");
    assert_ne!(text, turned);
    [&turned, FAST, TWO_CRANKS, TWO_LEVERS]
        .map(Given::text)
        .into()
}

/// The mechanisms of the golden files, compiled once for all tests of a process.
#[must_use]
pub fn golden() -> Vec<Given> {
    static GOLDEN: OnceLock<Vec<Given>> = OnceLock::new();
    let all = GOLDEN.get_or_init(|| {
        let texts = texts("../../linkage-compiler/tests/golden", "mech");
        texts.iter().map(|text| Given::text(text)).collect()
    });
    all.clone()
}

/// The mechanisms of the folder `mechanisms`, compiled once for all tests of a process.
#[must_use]
pub fn examples() -> Vec<Given> {
    static EXAMPLES: OnceLock<Vec<Given>> = OnceLock::new();
    let all = EXAMPLES.get_or_init(|| {
        let mut bodies = Vec::new();
        for text in texts("../../mechanisms", "rs") {
            find(text.parse().expect("Rust"), &mut bodies);
        }
        bodies.into_iter().map(Given::new).collect()
    });
    all.clone()
}

/// The text in the first `mechanism!` of a file of the folder `mechanisms`.
pub fn example(file: &str) -> String {
    let path = format!("mechanisms/{file}");
    let all = written(&path);
    all.into_iter().next().expect("it has a mechanism")
}

/// What stands in each `mechanism!` and `interpreted!` of a file, whose path begins at the root of the project.
pub fn written(file: &str) -> Vec<String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(file);
    let text = fs::read_to_string(path).expect("it can be read");
    let mut bodies = Vec::new();
    find(text.parse().expect("Rust"), &mut bodies);
    bodies.iter().map(ToString::to_string).collect()
}

fn texts(folder: &str, end: &str) -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let files = fs::read_dir(&folder).expect("there are files");
    let mut paths: Vec<_> = files.map(|file| file.expect("a file").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|own| own == end));
    paths.sort();
    let texts = paths.iter().map(fs::read_to_string);
    texts.map(|text| text.expect("it can be read")).collect()
}

/// The macros that take mechanisms.
const MACROS: [&str; 2] = ["mechanism", "interpreted"];

/// What stands in the braces of such a macro, wherever it is called.
fn find(tokens: TokenStream, bodies: &mut Vec<TokenStream>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    for (index, token) in tokens.iter().enumerate() {
        let TokenTree::Group(group) = token else {
            continue;
        };
        let before = tokens[..index]
            .iter()
            .rev()
            .take(2)
            .map(ToString::to_string);
        match before.collect::<Vec<_>>().as_slice() {
            [sign, name] if sign == "!" && MACROS.contains(&name.as_str()) => {
                bodies.push(group.stream());
            }
            _ => find(group.stream(), bodies),
        }
    }
}

/// A crank-rocker of four lengths, for other ones at run time.
pub const FOUR_BAR: &str = "
    pub struct FourBar {
        unit mm;
        param crank = 50mm;
        param coupler = 120mm;
        param rocker = 100mm;
        param frame = 140mm;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        loop polar(crank, phi) + polar(coupler, theta) = (frame, 0) + polar(rocker, psi);
    }
    impl FourBar {
        pub fn motion(phi) -> Motion { psi, v: velocity(psi), a: acceleration(psi), m: margin() }
    }";

/// The pin passes so near to the lever's pivot that the lever makes half a turn between two steps along the range.
const FAST: &str = "
    pub struct Fast {
        unit mm;
        param frame = 100mm;
        param crank = 100.004mm;
        input phi = 40deg in 0deg..1440deg;
        unknown psi = 65deg;
        unknown along = 180mm;
        loop (0, frame) + polar(crank, phi) = polar(along, psi);
    }
    impl Fast {
        pub fn motion(phi) -> Motion { psi, along }
    }";

/// An angle that is followed along two inputs, from far off the middle of its motion along each.
const TWO_CRANKS: &str = "
    pub struct TwoCranks {
        unit mm;
        param a = 100mm;
        param b = 101mm;
        input first = 172deg in 0deg..360deg;
        input second = 0deg in -180deg..180deg;
        unknown psi = 82deg;
        unknown along = 14mm;
        loop polar(a, first) + polar(b, second) = polar(along, psi);
    }
    impl TwoCranks {
        pub fn motion(first, second) -> Motion { psi, along }
    }";

/// One lever turns with its crank, the other one swings.
const TWO_LEVERS: &str = "
    pub struct TwoLevers {
        unit mm;
        param near = 40mm;
        param crank = 100mm;
        param far = 300mm;
        input phi = 40deg in 0deg..360deg;
        unknown turning = 65deg;
        unknown along = 120mm;
        unknown swinging = 77deg;
        unknown reach = 370mm;
        loop (0, near) + polar(crank, phi) = polar(along, turning);
        loop (0, far) + polar(crank, phi) = polar(reach, swinging);
    }
    impl TwoLevers {
        pub fn motion(phi) -> Motion { turning, swinging }
    }";
