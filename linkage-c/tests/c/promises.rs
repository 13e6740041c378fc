//! What exported C promises of itself: no warning, no call of others, no double in single precision, names that C can have.

use std::fs;
use std::path::Path;
use std::process::Command;

use linkage_c::{Real, Sources, sources};
use linkage_random::one_in;

use crate::machine::{self, Compiler, WARNINGS};
use linkage_corpus::given::{Given, exported, golden};

const REALS: [Real; 2] = [Real::Double, Real::Single];

/// A mechanism whose names are words of C, of C++ or of its own functions, or written in other letters.
const NAMES: &str = "
    pub struct Double {
        unit mm;
        param register = 30mm;
        param default = 80mm;
        param size_t = 1mm;
        input signed = 60deg in 0deg..360deg;
        unknown v1 = -20deg;
        unknown λ = 90mm;
        loop polar(register, signed) + polar(default, v1) = (λ, size_t);
    }
    impl Double {
        pub fn error(signed) -> Motion { λ, class: velocity(λ), int: v1 }
        pub fn own_pair(signed) -> Other { m: λ }
    }";

/// A mechanism without dimensions, and a function without arguments.
const NOTHING: &str = "
    pub struct Nothing {
        unit mm;
        input phi = 60deg;
        unknown psi = 120deg;
        loop psi = 2 * phi;
        let p = polar(30mm, psi);
    }
    impl Nothing {
        pub fn place(phi) -> Place { p }
        pub fn fixed() -> Fixed { two: 2 }
    }";

/// A mechanism whose user says much, also what would end a comment of C, and lines that would go on in the next one.
const DOCUMENTED: &str = r#"
    /// A drive.
    ///
    /// Turns */ 1 /* and *\
    /// / end ??/
    pub struct Documented {
        unit mm;
        /// From the shaft to the pin,
        /// as milled.
        param crank = 40mm +- 0.02mm;
        #[doc = "Not `//` long: λ."]
        param rod = 150mm;
        input phi = 40deg in 0deg..360deg;
        unknown tilt = -15deg;
        unknown ram = 180mm;
        loop polar(crank, phi) + polar(rod, tilt) = (ram, 0);
    }
    impl Documented {
        /// What the controller asks.
        pub fn motion(phi) -> Motion {
            /// Of the pin.
            ram,
            v: velocity(ram),
        }
    }"#;

const TEXTS: [&str; 3] = [NAMES, NOTHING, DOCUMENTED];

/// The first ones are those of the texts.
fn all() -> Vec<Given> {
    let mut all: Vec<Given> = TEXTS.map(Given::text).into();
    all.extend(exported());
    all
}

fn written(folder: &Path, given: &[Given], real: Real) -> Vec<Sources> {
    let given = given.iter().enumerate();
    let sources = given.map(|(index, own)| {
        let name = match &own.name[..] {
            "Double" => own.name.clone(),
            name => format!("M{index}{name}"),
        };
        let sources = sources(&name, &own.unit, real).expect("it can be exported");
        machine::write(folder, &sources);
        sources
    });
    sources.collect()
}

#[test]
fn no_compiler_warns() {
    let given = all();
    let compilers = machine::compilers();
    for real in REALS {
        let folder = machine::folder(&format!("warnings_{}", real.name()));
        let sources = written(&folder, &given, real);
        let files: Vec<String> = sources
            .iter()
            .map(|own| format!("{}.c", own.name))
            .collect();
        for (command, compiler) in &compilers {
            let optimised = (*command, real) == ("gcc", Real::Double);
            // What takes long, and versions beside the usual one, look at a part of the others: mechanisms consist of the same lines.
            let slow = optimised || command.contains("++") || command.contains('-');
            let (texts, others) = files.split_at(TEXTS.len());
            let others = one_in(if slow { 8 } else { 1 }, others);
            let language = match command.contains("++") {
                true => ["-x", "c++", "-std=c++11"],
                false => ["-x", "c", "-std=c99"],
            };
            let mut arguments = vec!["-c"];
            arguments.extend(language);
            // Some warnings of GCC need what optimisation finds out, which is the same in both precisions.
            arguments.push(if optimised { "-O1" } else { "-fsyntax-only" });
            arguments.extend(WARNINGS);
            let before = arguments.len();
            arguments.extend(texts.iter().chain(others).map(String::as_str));
            compiler.run(&folder, &arguments);
            let count = arguments.len() - before;
            println!("{command}: {count} files of {}s", real.name());
        }
    }
}

#[test]
fn nothing_is_called_but_roots() {
    let Some(compiler) = Compiler::find() else {
        return;
    };
    if Command::new("nm").arg("--version").output().is_err() {
        println!("skipped: there is no `nm`");
        return;
    }
    let given = golden();
    for real in REALS {
        let folder = machine::folder(&format!("calls_{}", real.name()));
        let allowed = match real {
            Real::Double | Real::Fused => ["sqrt", "fabs"],
            Real::Single => ["sqrtf", "fabsf"],
        };
        for own in written(&folder, &given, real) {
            let file = format!("{}.c", own.name);
            // As for a machine without an operating system: compilers take nothing for their own.
            compiler.run(
                &folder,
                &[
                    "-std=c99",
                    "-O0",
                    "-ffreestanding",
                    "-fno-builtin",
                    "-c",
                    &file,
                    "-o",
                    "one.o",
                ],
            );
            let output = Command::new("nm")
                .current_dir(&folder)
                .args(["-u", "one.o"])
                .output();
            let output = String::from_utf8(output.expect("it runs").stdout).expect("names");
            let called: Vec<&str> = output
                .split_whitespace()
                .filter(|word| *word != "U")
                .collect();
            let of_platform = |name: &&str| !name.starts_with('_');
            let others: Vec<&&str> = called
                .iter()
                .filter(|own| !allowed.contains(own))
                .filter(|own| of_platform(own))
                .collect();
            assert!(others.is_empty(), "{file} calls {others:?}");
            assert!(
                called.contains(&allowed[0]),
                "{file} takes a root: {called:?}"
            );
        }
    }
}

#[test]
fn nothing_in_singles_is_double() {
    for own in all() {
        let Sources { header, source, .. } =
            sources(&own.name, &own.unit, Real::Single).expect("it can be exported");
        let code = without_texts(&(header + &source));
        let of_name = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '.';
        for word in code.split(|c| !of_name(c)) {
            let number = word.starts_with(|c: char| c.is_ascii_digit()) && word.contains('.');
            assert!(
                word != "double" && word != "uint64_t" && word != "sqrt" && word != "fabs",
                "{}: {word}",
                own.name
            );
            assert!(
                !number || word.ends_with('f') || word.ends_with('e'),
                "{}: {word}",
                own.name
            );
        }
    }
}

/// C without comments and strings.
fn without_texts(code: &str) -> String {
    let mut kept = String::new();
    let mut rest = code;
    while let Some(start) = rest.find(['"', '/']) {
        kept += &rest[..start];
        let behind = &rest[start + 1..];
        let length = match &rest[start..=start] {
            "\"" => behind.find('"').map(|end| end + 1),
            _ if behind.starts_with('*') => behind.find("*/").map(|end| end + 2),
            slash => {
                kept += slash;
                Some(0)
            }
        };
        rest = &behind[length.expect("what begins ends")..];
    }
    kept + rest
}

#[test]
fn names_are_those_of_the_user_where_c_can_have_them() {
    let own = Given::text(NAMES);
    let Sources { name, header, .. } =
        sources(&own.name, &own.unit, Real::Double).expect("it can be exported");
    assert_eq!(name, "double_");
    for line in [
        "double register_; /* mm */",
        "double default_; /* mm */",
        "double size_t; /* mm */",
        "double u3bb; /* mm */",
        "double class_; /* derivative of λ by signed, in mm/rad */",
        "double int_; /* v1, in rad */",
        "double__error_result double__error_(const double_ *m, double signed_);",
        "double__own_pair_result double__own_pair(const double_ *m, double signed_);",
    ] {
        assert!(header.contains(line), "`{line}` in\n{header}");
    }
}

#[test]
fn comments_of_the_user_stand_in_front() {
    let own = Given::text(DOCUMENTED);
    let Sources { header, .. } =
        sources(&own.name, &own.unit, Real::Double).expect("it can be exported");
    for lines in [
        "not to be changed by hand.\n   A drive.\n\n   Turns * / 1 / * and *\\\n   / end ?? /\n   All numbers are doubles",
        "    /* From the shaft to the pin,\n       as milled. */\n    double crank; /* mm; tolerance 0.02 */\n",
        "    /* Not `//` long: λ. */\n    double rod; /* mm */\n",
        "    /* Of the pin. */\n    double ram; /* mm */\n    double v; /* derivative of ram by phi, in mm/rad */\n",
        "/* What the controller asks.\n   ",
    ] {
        assert!(header.contains(lines), "`{lines}` in\n{header}");
    }
}

#[test]
fn files_are_the_same_each_time() {
    let given = golden();
    let own = given.iter().find(|own| own.name == "CrankRocker");
    let own = own.expect("one of the golden mechanisms");
    let text = fs::read_to_string(
        Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../linkage-compiler/tests/golden/crank_rocker.mech"),
    );
    let again = Given::text(&text.expect("it can be read"));
    assert_eq!(
        sources(&own.name, &own.unit, Real::Double),
        sources(&again.name, &again.unit, Real::Double)
    );
}
