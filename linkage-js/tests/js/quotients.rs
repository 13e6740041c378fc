//! Derivatives of powers and quotients in JavaScript against differences of positions in JavaScript.

use linkage_corpus::given::Given;
use linkage_corpus::quotients::{Precision, Quotients};

use crate::page::{WRITTEN, list, page, read};

/// Seeds of random mechanisms.
const RANDOM: std::ops::RangeInclusive<u64> = 201..=206;

/// The results of a mechanism for dimensions and the crank's angle, as a list of numbers in the order of the columns.
const CALLED: &str = "const called = (mechanism, dimensions, phi) => {
    const names = mechanism.dimensions.map(({ name }) => name);
    const given = Object.fromEntries(names.map((name, k) => [name, dimensions[k]]));
    return written(Object.values(mechanism.assemble(given).motion(phi)).flat());
};\n";

#[test]
fn derivatives_are_differences() {
    let mut all = vec![Quotients::written()];
    all.extend(RANDOM.map(Quotients::random));
    let given: Vec<Given> = all.iter().map(|own| own.given.clone()).collect();
    let Some(mut page) = page(&given, &format!("{WRITTEN}{CALLED}")) else {
        return;
    };
    for (number, own) in all.iter().enumerate() {
        let name = &own.given.name;
        let calls = own.calls(Precision::DOUBLE).into_iter();
        let calls = calls.map(|call| {
            let dimensions = list(&call.dimensions);
            format!("[{dimensions}, {:?}]", call.degrees.to_radians())
        });
        let calls = calls.collect::<Vec<_>>().join(", ");
        let text = page.words(&format!(
            "(() => {{ const own = mechanisms[{number}]; if (own.name !== '{name}') throw new Error(own.name); \
             return [{calls}].map(([dimensions, phi]) => called(own, dimensions, phi)).join(';'); }})()"
        ));
        let results: Vec<Vec<f64>> = text.split(';').map(read).collect();
        own.check("JavaScript", Precision::DOUBLE, &results);
    }
    page.assert_quiet();
}
