//! All mechanisms of the golden files and of the examples that have closed forms alone: structured text against the
//! same programs on the runtime's numbers.

use linkage_corpus::given::{Given, arguments, exported, turning};
use linkage_corpus::reference::Assembled;
use linkage_corpus::sample;
use linkage_random::Random;
use linkage_st::structured_text;

use crate::parser;
use crate::runner::Value;
use crate::syntax::{File, Kind};

/// Positions of each function: the reference first.
const POSITIONS: usize = 10;

/// A mechanism that is printed and read again.
pub(crate) struct Read {
    pub(crate) name: String,
    pub(crate) file: File,
}

impl Read {
    pub(crate) fn new(given: &Given) -> Self {
        let printed = structured_text(&given.name, &given.unit).expect("it has closed forms");
        Self {
            name: printed.name.to_ascii_lowercase(),
            file: parser::file(&printed.text),
        }
    }

    /// The mechanism with these dimensions, those of the declaration by default, and the code of its assembly.
    pub(crate) fn assembled(&self, dimensions: Option<&[f64]>) -> (Value, i64) {
        let mut mechanism = self.file.value(&Kind::Named(self.name.clone()), None);
        if let Some(dimensions) = dimensions {
            self.set(&mut mechanism, dimensions);
        }
        let block = format!("{}_assemble", self.name);
        let variables = self.file.call(&block, &mut mechanism, &[]);
        let Value::Integer(code) = variables["code"] else {
            panic!("a code is an integer")
        };
        (mechanism, code)
    }

    fn set(&self, mechanism: &mut Value, dimensions: &[f64]) {
        let Value::Members(members) = mechanism else {
            panic!("a mechanism has members")
        };
        let mut rest = dimensions.iter().copied();
        let declared = self.file.types[&self.name].iter();
        for member in declared.take_while(|own| own.name != "miss") {
            let value = members.get_mut(&member.name).expect("it is there");
            match (value, &member.kind) {
                (Value::Real(x), _) => *x = rest.next().expect("a dimension"),
                (Value::Members(vector), Kind::Named(kind)) => {
                    for component in &self.file.types[kind] {
                        let x = Value::Real(rest.next().expect("a dimension"));
                        vector.insert(component.name.clone(), x);
                    }
                }
                (other, _) => panic!("{other:?} is no dimension"),
            }
        }
        assert_eq!(rest.next(), None);
    }

    /// The results of a function by its name in the declaration.
    pub(crate) fn call(&self, mechanism: &mut Value, name: &str, arguments: &[f64]) -> Vec<f64> {
        let block = format!("{}_{}", self.name, name.to_ascii_lowercase());
        let variables = self.file.call(&block, mechanism, arguments);
        let kind = Kind::Named(format!("{block}_result"));
        variables["result"].reals(&self.file, &kind)
    }
}

/// Compares all results to the last bit; any NaN is one. Returns how many there are, and how many of them are finite.
fn compare(given: &Given, dimensions: Option<&[f64]>, random: &mut Random) -> (usize, usize) {
    let Given { name, unit } = given;
    let read = Read::new(given);
    let nominal: Vec<f64> = unit.scalars().map(|own| own.nominal).collect();
    let (mut mechanism, code) = read.assembled(dimensions);
    let rust = Assembled::<f64>::new(unit, dimensions.unwrap_or(&nominal));
    assert_eq!(code == 0, rust.is_some(), "{name}: code {code}");
    let Some(rust) = rust else {
        return (0, 0);
    };
    let (mut count, mut finite) = (0, 0);
    for (index, function) in unit.functions.iter().enumerate() {
        for position in 0..POSITIONS {
            let arguments = arguments(unit, index, position, random);
            let expected = rust.call(function, &arguments);
            let results = read.call(&mut mechanism, &function.name, &arguments);
            assert_eq!(results.len(), expected.len(), "{name}::{}", function.name);
            for (number, (text, rust)) in results.iter().zip(&expected).enumerate() {
                assert!(
                    text.to_bits() == rust.to_bits() || (text.is_nan() && rust.is_nan()),
                    "{name}::{}, result {number} at {arguments:?}: {text:e} in structured text, {rust:e} in Rust",
                    function.name
                );
                count += 1;
                finite += usize::from(text.is_finite());
            }
        }
    }
    (count, finite)
}

fn with_closed_forms() -> Vec<Given> {
    let mut all = exported();
    all.retain(|own| own.unit.coupled.is_empty());
    all.extend(turning());
    all
}

#[test]
fn results_are_those_of_rust() {
    let mut random = Random::new(45);
    let (mut count, mut finite) = (0, 0);
    let given = with_closed_forms();
    for own in &given {
        let (own_count, own_finite) = compare(own, None, &mut random);
        assert!(own_finite > 0, "{} moves", own.name);
        count += own_count;
        finite += own_finite;
    }
    println!(
        "{} mechanisms, {count} results, {finite} of them finite",
        given.len()
    );
    assert!(
        count > 10_000 && finite > count / 2 && finite < count,
        "{finite} of {count}"
    );
}

#[test]
fn random_mechanisms_are_those_of_rust() {
    let mut random = Random::new(46);
    let texts = (0..20).map(|number| sample(7 * number + 1, "Generated").text);
    let mut given: Vec<Given> = texts.map(|text| Given::text(&text)).collect();
    given.retain(|own| own.unit.coupled.is_empty());
    let finite = given.iter().map(|own| compare(own, None, &mut random).1);
    let finite: usize = finite.sum();
    assert!(
        given.len() > 5 && finite > 1000,
        "{} mechanisms, {finite} results",
        given.len()
    );
}

#[test]
fn other_dimensions_are_assembled_where_no_turns_are_counted() {
    let mut random = Random::new(47);
    let (mut assembled, mut refused) = (0, 0);
    for own in with_closed_forms() {
        let moved: Vec<f64> = own
            .unit
            .scalars()
            .map(|own| own.nominal * (1.0 + random.between(-0.05, 0.05)))
            .collect();
        let others = own
            .unit
            .scalars()
            .map(|own| own.nominal)
            .ne(moved.iter().copied());
        if own.unit.angles.is_empty() || !others {
            assembled += usize::from(compare(&own, Some(&moved), &mut random).1 > 0);
        } else {
            let (_, code) = Read::new(&own).assembled(Some(&moved));
            assert_ne!(code, 0, "{}", own.name);
            refused += 1;
        }
    }
    assert!(
        assembled > 3 && refused > 3,
        "{assembled} assembled, {refused} refused"
    );
}

/// A slider-crank without an angle whose turns are counted.
const SLIDER: &str = "
    pub struct SliderCrank {
        unit mm;
        param crank = 30mm;
        param rod = 80mm;
        input phi = 90deg in 0deg..360deg;
        unknown theta = -20deg;
        unknown s = 90mm;
        loop polar(crank, phi) + polar(rod, theta) = (s, 0);
    }
    impl SliderCrank {
        pub fn motion(phi) -> Motion { s, speed: velocity(s) }
    }";

#[test]
fn codes_have_their_reasons() {
    let given = Given::text(SLIDER);
    let read = Read::new(&given);
    let code = |dimensions: [f64; 2]| read.assembled(Some(&dimensions)).1;
    assert_eq!(code([30.0, 80.0]), 0);
    assert_eq!(code([f64::NAN, 80.0]), 1);
    assert_eq!(code([30.0, f64::INFINITY]), 2);
    assert_eq!(code([30.0, 20.0]), 3);
    assert_eq!(code([30.0, 1e200]), 5);
    let (mechanism, _) = read.assembled(Some(&[30.0, 20.0]));
    let Value::Members(members) = mechanism else {
        panic!("it has members")
    };
    let Value::Real(miss) = members["miss"] else {
        panic!("a number")
    };
    assert!((miss - 10.0).abs() < 1e-12, "{miss}");
}

#[test]
fn coupled_groups_are_refused_by_their_names() {
    let mut given = exported();
    given.retain(|own| !own.unit.coupled.is_empty());
    let Given { name, unit } = &given[0];
    let refused = structured_text(name, unit)
        .expect_err("it has a coupled group")
        .to_string();
    let group = &unit.groups[unit.coupled[0].group];
    assert!(refused.contains(&group.unknowns.join(", ")), "{refused}");
    assert!(refused.starts_with(&format!("{name}: loop")), "{refused}");
    assert!(refused.ends_with(
        "has no closed form, and structured text has closed forms only. Export C by `linkage c`"
    ));
}
