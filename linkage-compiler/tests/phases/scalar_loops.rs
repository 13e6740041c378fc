//! Coupled groups of scalar loops, which have no link with a length of its own: the size of their
//! states is that of the lengths that turn in them.

use linkage_compiler::check;
use linkage_compiler::ir::PreparedTable;

/// A slide and a lever, whose guides are written as products with directions.
const GUIDES: &str = "
    input phi = 90deg in 60deg..120deg;
    input w = 55deg in 50deg..60deg;
    param v = 1deg;
    unknown s = 60mm;
    unknown k = 23deg;
    let c = polar(20mm, phi) + (s, 0mm) + polar(70mm, k);
    loop dot(c - (0mm, 45mm), dir(v + 90deg)) = 0;
    loop dot(c - (100mm, 20mm), dir(w + 90deg)) = 0;";

/// The same with two driven guides: no coefficient of the loops is fixed.
const DRIVEN_GUIDES: &str = "
    input v = 1deg in 0deg..4deg;
    input w = 55deg in 50deg..60deg;
    unknown s = 60mm;
    unknown k = 23deg;
    let c = polar(20mm, 90deg) + (s, 0mm) + polar(70mm, k);
    loop dot(c - (0mm, 45mm), dir(v + 90deg)) = 0;
    loop dot(c - (100mm, 20mm), dir(w + 90deg)) = 0;";

/// Returns the number of cells in which states are prepared.
fn cells(unit: &str, items: &str) -> usize {
    let inputs = items
        .split("input ")
        .skip(1)
        .map(|item| item.split(' ').next());
    let inputs: Vec<&str> = inputs.flatten().collect();
    let text = format!(
        "struct M {{ unit {unit}; {items} }} impl M {{ fn f({}) -> F {{ k }} }}",
        inputs.join(", ")
    );
    let checked = check(text.parse().expect("tokens"));
    let texts: Vec<&String> = checked
        .messages
        .iter()
        .map(|message| &message.text)
        .collect();
    let compiled = checked.unit.unwrap_or_else(|| panic!("{unit}: {texts:#?}"));
    match &compiled.coupled[0].start {
        Some(PreparedTable::Grid(grid)) => {
            assert_eq!(grid.reached(), grid.cells());
            grid.cells()
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn states_do_not_depend_on_the_unit_of_length() {
    for (items, most) in [(GUIDES, 8), (DRIVEN_GUIDES, 8)] {
        let in_millimetres = cells("mm", items);
        assert!(in_millimetres <= most, "{in_millimetres}: {items}");
        for unit in ["um", "m", "inch"] {
            assert_eq!(cells(unit, items), in_millimetres, "{unit}: {items}");
        }
    }
}
