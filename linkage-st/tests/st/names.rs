//! Names of the user that structured text does not allow.

use linkage_corpus::given::Given;
use linkage_st::{all_structured_text, structured_text};

use crate::mechanisms::Read;

/// Words, names that differ by the case of letters alone, letters of other alphabets, and names of the printed text.
const WORDS: &str = "
    pub struct Crank {
        unit mm;
        param array = 12mm;
        param Array = 13mm;
        param λ = 14mm;
        param double__line = 15mm;
        param end_ = 16mm;
        param var = (17mm, 18mm);
        input Of = 30deg;
    }
    impl Crank {
        pub fn type_(Of) -> Type { int: array * sin(Of), Int: Array * cos(Of), m: λ + double__line + end_, result: var }
        pub fn Assemble(Of) -> Other { v1: array * sin(Of) }
        pub fn assemble(Of) -> Third { end_var: Array * sin(Of) }
    }";

#[test]
fn names_get_another_form_where_they_must() {
    let given = Given::text(WORDS);
    let printed = structured_text(&given.name, &given.unit).expect("it has closed forms");
    let renamed: Vec<String> = printed.renamed.iter().map(ToString::to_string).collect();
    for line in [
        "the parameter `array` is called `array_x` in structured text",
        "the parameter `Array` is called `Array_x_x` in structured text",
        "the parameter `λ` is called `u3bb` in structured text",
        "the parameter `double__line` is called `double_line` in structured text",
        "the parameter `end_` is called `end` in structured text",
        "the argument `Of` of `type_` is called `Of_x` in structured text",
        "the function `Assemble` is called `Crank_Assemble_x` in structured text",
        "the function `assemble` is called `Crank_assemble_x_x` in structured text",
        "the result `int` of `type_` is called `int_x` in structured text",
    ] {
        assert!(
            renamed.iter().any(|own| own == line),
            "{line}: {renamed:#?}"
        );
    }
    let read = Read::new(&given);
    let (mut mechanism, code) = read.assembled(None);
    assert_eq!(code, 0);
    let results = read.call(&mut mechanism, "type", &[0.5]);
    let expected = [12.0 * 0.5_f64.sin(), 13.0 * 0.5_f64.cos(), 45.0, 17.0, 18.0];
    for (text, rust) in results.iter().zip(expected) {
        assert!((text - rust).abs() < 1e-13, "{results:?}");
    }
}

#[test]
fn names_that_are_allowed_stay() {
    let text = "pub struct Crank { unit mm; param radius = 12mm; input phi = 30deg; }
        impl Crank { pub fn height(phi) -> Height { height: radius * sin(phi) } }";
    let given = Given::text(text);
    let printed = structured_text(&given.name, &given.unit).expect("it has closed forms");
    assert_eq!((printed.renamed.len(), &printed.name[..]), (0, "Crank"));
    assert!(
        printed.text.contains("\n    phi : LREAL; (* rad *)\n"),
        "{}",
        printed.text
    );
}

#[test]
fn mechanisms_with_a_common_name_are_refused() {
    let unit =
        Given::text("struct Crank { unit mm; param radius = 12mm; input phi = 30deg; }").unit;
    assert!(all_structured_text(&[("Crank", &unit), ("Other", &unit)]).is_ok());
    let refused = all_structured_text(&[("Crank", &unit), ("CRANK", &unit)]);
    let message = refused
        .expect_err("letters are not distinguished")
        .to_string();
    assert!(
        message.contains("`Crank` and `CRANK` would both have the name `crank"),
        "{message}"
    );
}
