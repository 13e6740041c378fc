//! Names of the headers that this system has: all of them are on the exporter's lists.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

use linkage_c::{Real, sources};
use linkage_corpus::given::Given;
use linkage_random::one_in;

use crate::machine::{self, Compiler, compilers};
use crate::users::{BOTH, OF_C, mechanism};

#[test]
fn macros_of_the_headers_here_are_no_names() {
    let headers = [&BOTH[..], &OF_C].concat();
    let all = compilers()
        .into_iter()
        .map(|(command, _)| command)
        .filter(|own| !own.contains("++"));
    for command in all.chain(["arm-none-eabi-gcc", "avr-gcc"]) {
        if Compiler::named(command).is_none() {
            continue;
        }
        let folder = machine::folder(&format!("macros_{command}"));
        // What a library does not have, or not for this processor, is left out.
        let has = |header: &&&str| {
            preprocessed(command, &folder, &format!("#include <{header}>\n")).is_some()
        };
        let text: String = headers
            .iter()
            .filter(has)
            .map(|own| format!("#include <{own}>\n"))
            .collect();
        let printed = preprocessed(command, &folder, &format!("#define _GNU_SOURCE\n{text}"));
        let printed = printed.expect("headers that are there");
        let macros = printed
            .lines()
            .filter_map(|line| line.strip_prefix("#define ")?.split(' ').next());
        // Not with arguments; names of compilers begin with an underscore.
        // Rust has `true` and `false` itself.
        let is_named = |own: &&str| {
            !own.contains('(') && !own.starts_with('_') && !matches!(*own, "true" | "false")
        };
        let macros = macros.filter(is_named);
        let macros: Vec<&str> = macros.collect();
        assert!(macros.len() > 150, "{command}: {} macros", macros.len());
        for some in macros.chunks(300) {
            let given = Given::text(&mechanism("Macros", some, &[], &[], &[]));
            let own = sources("Macros", &given.unit, Real::Double).expect("it can be exported");
            let renamed: BTreeSet<&str> = own.renamed.iter().map(|own| &own.what[..]).collect();
            let is_kept = |own: &&&str| !renamed.contains(&format!("the parameter `{own}`")[..]);
            let kept: Vec<_> = some.iter().filter(is_kept).collect();
            assert!(kept.is_empty(), "{command}: {kept:?}");
        }
        println!("{command}: {} macros", macros.len());
    }
}

/// The macros that a compiler knows behind a text; `None` if it cannot read that.
fn preprocessed(command: &str, folder: &Path, text: &str) -> Option<String> {
    fs::write(folder.join("macros.c"), text).expect("C can be written");
    let mut all = Command::new(command);
    let output = all
        .current_dir(folder)
        .args(["-dM", "-E", "macros.c"])
        .output();
    let output = output.expect("the compiler runs");
    output
        .status
        .success()
        .then(|| String::from_utf8(output.stdout).expect("names"))
}

/// A mechanism called like a function has another name. The compiler lists what headers declare.
#[test]
fn functions_of_the_headers_here_are_no_names() {
    let Some(compiler) = Compiler::named("gcc") else {
        return;
    };
    let folder = machine::folder("functions");
    let headers = BOTH.iter().chain(&OF_C);
    let text: String = headers.map(|own| format!("#include <{own}>\n")).collect();
    fs::write(folder.join("all.c"), format!("#define _GNU_SOURCE\n{text}"))
        .expect("C can be written");
    compiler.run(
        &folder,
        &["-c", "all.c", "-o", "all.o", "-aux-info", "declared"],
    );
    let declared = fs::read_to_string(folder.join("declared")).expect("it was written");
    // `/* file */ extern int name (...);`
    let names = declared
        .lines()
        .filter_map(|line| line.split(" (").next()?.rsplit([' ', '*']).next());
    // Of several words are those of mechanisms with a function.
    let names: BTreeSet<&str> = names
        .filter(|own| own.starts_with(|c: char| c.is_ascii_lowercase()) && !own.contains('_'))
        .collect();
    assert!(names.len() > 900, "{} functions", names.len());
    let mut count = 0;
    for name in one_in(8, names) {
        let (first, rest) = name.split_at(1);
        let title = first.to_uppercase() + rest;
        let given = Given::text(&mechanism(&title, &[], &[], &[], &["f"]));
        let own = sources(&title, &given.unit, Real::Double).expect("it can be exported");
        assert_ne!(own.name, name);
        count += 1;
    }
    println!("{count} functions");
}
