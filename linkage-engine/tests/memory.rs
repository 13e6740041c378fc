//! Memory that stays after a mechanism is gone.

use linkage_engine::Mechanism;

const TEXT: &str = "struct Slider { unit mm; param crank = 40mm +- 10um; param rod = 120mm;
    input phi = 30deg in 0deg..360deg; unknown theta = -10deg; unknown slide = 150mm;
    loop polar(crank, phi) + polar(rod, theta) = (slide, 5mm); }
    impl Slider { fn motion(phi) -> Motion { slide, v: velocity(slide), shape: picture() } }";

/// Descriptions are stored once for all texts that differ in dimensions alone.
#[test]
fn other_dimensions_take_no_more_memory() {
    let compiled = |text: &str| Mechanism::compile(text).expect("no mistake");
    let first = compiled(TEXT);
    for length in 41..44 {
        let text = TEXT.replace("40mm", &format!("{length}mm"));
        let next = compiled(&text);
        assert_eq!(next.parameters()[0].nominal, f64::from(length));
        assert_eq!(
            next.parameters()[0].tolerance,
            first.parameters()[0].tolerance
        );
        assert!(std::ptr::eq(next.structure(), first.structure()));
        assert!(std::ptr::eq(next.inputs(), first.inputs()));
        assert!(std::ptr::eq(next.headings()[0], first.headings()[0]));
        assert!(std::ptr::eq(next.name(), first.name()));
    }
    let other = compiled(&TEXT.replace("slide", "way"));
    assert!(!std::ptr::eq(other.headings()[0], first.headings()[0]));
}
