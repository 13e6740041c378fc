//! The parser reads every text that the compiler reads.

use linkage_grammar::{Text, faults, mechanism_files, rust_macros, samples};

fn assert_readable(texts: &[Text], at_least: usize) {
    assert!(texts.len() >= at_least, "{} texts", texts.len());
    let faults = texts.iter().flat_map(|text| {
        let faults = faults(&text.text).into_iter();
        faults.map(|fault| format!("{}, line {fault}", text.name))
    });
    let faults: Vec<String> = faults.collect();
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

#[test]
fn text_files_are_read() {
    assert_readable(&mechanism_files(), 70);
}

#[test]
fn macros_are_read() {
    assert_readable(&rust_macros("mechanisms"), 30);
}

#[test]
fn samples_of_documents_are_read() {
    assert_readable(&samples("docs"), 80);
}

#[test]
fn a_fault_has_its_line() {
    let found = faults("struct M {\n    param a = ;\n    unit mm;\n}\n");
    assert_eq!(found, ["2: param a = ;"]);
    assert_eq!(faults("struct M { param a 5mm; }").len(), 1);
    assert_eq!(faults("struct M { unit mm; /* }").len(), 1);
}
