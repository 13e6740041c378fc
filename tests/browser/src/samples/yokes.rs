//! A machine without loops that computes on its page: two slider cranks on one shaft, with programs written by hand.

use linkage_analysis::cyclogram::{Band, Cyclogram, Member};
use linkage_analysis::summary::Curve;
use linkage_report::Report;
use linkage_runtime::{Column, Heading, Meaning, Parameter, Programs};
use std::f64::consts::TAU;

use super::sheet::{SHAFT, Sheet, column};

const PARAMETERS: [Parameter; 4] = [
    dimension("crank", "mm", 40.0),
    dimension("rod", "mm", 130.0),
    dimension("lead", "rad", 0.7),
    dimension("more", "", 0.0),
];

const fn dimension(name: &'static str, unit: &'static str, nominal: f64) -> Parameter {
    Parameter {
        name,
        unit,
        nominal,
        tolerance: 0.0,
    }
}

const VELOCITY: Meaning = Meaning::Rate {
    order: 1,
    of: Some(0),
};

const COLUMNS: [Column; 2] = [
    column("way", "mm", Meaning::Value),
    column("v", "mm/rad", VELOCITY),
];

const fn heading(function: &'static str) -> Heading {
    Heading {
        function,
        arguments: &["shaft"],
        columns: &COLUMNS,
        picture: None,
    }
}

/// Columns of one name in each: what organ is which is told by numbers.
static HOOK: Heading = heading("hook");
static PRESS: Heading = heading("press");
static SINKER: Heading = heading("sinker");
static TWIN: Heading = heading("twin");

/// As the functions of the sample compute: `d` has the dimensions, `x` the shaft.
const PROGRAMS: Programs = Programs {
    description: "{ name: 'Yokes', dimensions: [{ name: 'crank', unit: 'mm', value: 40, tolerance: 0 }, { name: 'rod', unit: 'mm', value: 130, tolerance: 0 }, \
        { name: 'lead', unit: 'rad', value: 0.7, tolerance: 0 }, { name: 'more', unit: '', value: 0, tolerance: 0 }], \
        inputs: [{ name: 'shaft', unit: 'rad', angle: true, reference: 0, range: [0, 2 * Math.PI], followed: [0, 2 * Math.PI], rates: [] }], \
        arguments: [], reference: [0], modes: [], groups: [], angles: [], coupled: [], slots: 0, bearingNumbers: 0, \
        prepare: () => {}, bearings: () => {}, directions: () => {}, gaps: () => {}, \
        functions: [['hook', 0, 1, 0], ['press', 1, -1, 0], ['sinker', 1, 1, 0], ['twin', 0, 1, 1]].map(([name, leads, sign, grows]) => ({ name, arguments: [0], coupled: false, \
        columns: [{ name: 'way', unit: 'mm' }, { name: 'v', unit: 'mm/rad' }], fields: [], run: (own, x, states, out) => { \
        const [crank, rod, lead, more] = own.dimensions; const [s, c] = [Math.sin(x[0] + leads * lead), Math.cos(x[0] + leads * lead)]; \
        const across = Math.sqrt(rod * rod - crank * crank * c * c); const size = sign * (1 + grows * more); \
        out[0] = size * (crank * s + across); out[1] = size * (crank * c + crank * crank * s * c / across); } })) }",
};

/// What hook and press do with these dimensions: crank, rod, by how much the press leads. The press goes down where it advances.
///
/// # Panics
/// If there is no cyclogram.
#[must_use]
pub fn yokes_cyclogram([crank, rod, lead]: [f64; 3]) -> Cyclogram {
    let member = |name: &str, lead: f64, sign: f64, bands: &[Band]| {
        let course = Curve::new((0.0, TAU), 120, |x| {
            lift([crank, rod], x + lead).map(|y| sign * y)
        });
        Member::new(name, &course.expect("a cycle"), bands).expect("an organ")
    };
    let sinker = Curve::new((0.0, TAU), 120, |x: f64| [x.sin(), x.cos()]).expect("a cycle");
    let sinker = Member::new("sinker", &sinker, &[]).expect("an organ");
    let hook = member("hook", 0.0, 1.0, &[Band::Top(3.0), Band::Bottom(4.0)]);
    let press = member("press", lead, -1.0, &[Band::Between(-140.0, -120.0)]);
    Cyclogram::new([hook, press, sinker]).expect("one shaft")
}

fn lift([crank, rod]: [f64; 2], angle: f64) -> [f64; 2] {
    let (s, c) = angle.sin_cos();
    let across = (rod * rod - crank * crank * c * c).sqrt();
    [
        crank * s + across,
        crank * c + crank * crank * s * c / across,
    ]
}

/// The report about it, every three degrees. With `twin`, there is a table with the numbers of the hook that has a dimension of its own, `more`;
/// nothing has the quantity of the organ `sinker`.
#[must_use]
pub fn yokes(twin: bool) -> Report {
    let positions = SHAFT.positions(121);
    let values = PARAMETERS.map(|own| own.nominal);
    let [crank, rod, lead, _] = values;
    let sheet = |heading, lead: f64, sign: f64| {
        Sheet::new(heading, &positions, move |x| {
            lift([crank, rod], x + lead).map(|y| sign * y)
        })
    };
    let report = Report::new("Yokes", &SHAFT, &positions)
        .dimensions_listed(&PARAMETERS, &values)
        .programs(PROGRAMS)
        .table(&sheet(&HOOK, 0.0, 1.0))
        .table(&sheet(&PRESS, lead, -1.0))
        .table(&sheet(&SINKER, lead, 1.0))
        .cyclogram(&yokes_cyclogram([crank, rod, lead]));
    match twin {
        true => report.table(&sheet(&TWIN, 0.0, 1.0)),
        false => report,
    }
}
