//! What the preprocessor refuses, with what helps instead.

use linkage_c::Real;

use crate::arithmetic::{REALS, assembled, of_c, some, written};
use crate::machine::Compiler;

/// The messages of a compiler for which something is otherwise: a macro that it defines itself, or a flag.
fn refused(compiler: &Compiler, real: Real, flags: &[&str]) -> String {
    let (folder, name) = written("refused", &some()[1], real, |text| text);
    assembled(compiler, &folder, &name, flags).expect_err("it is refused")
}

#[test]
fn constants_without_their_digits_are_refused() {
    let Some(compiler) = Compiler::named("gcc") else {
        return;
    };
    let messages = refused(&compiler, Real::Double, &["-fsingle-precision-constant"]);
    assert!(
        messages.contains("press_is_not_for_fsingle_precision_constant"),
        "{messages}"
    );
    // Constants of floats have all their digits.
    let (folder, name) = written("constants", &some()[1], Real::Single, |text| text);
    let lines = assembled(&compiler, &folder, &name, &["-fsingle-precision-constant"]);
    assert_eq!(lines.expect("it compiles")[0], "0|Press: assembled");
}

/// As on AVR, on s390x in C99, and on an x86 without SSE.
#[test]
fn other_types_of_numbers_are_refused_with_what_helps() {
    let method = |number: i32| {
        [
            "-U__FLT_EVAL_METHOD__".to_owned(),
            format!("-D__FLT_EVAL_METHOD__={number}"),
        ]
    };
    for (command, compiler) in of_c() {
        let with = |real, flags: &[String]| {
            let flags: Vec<&str> = flags.iter().map(String::as_str).collect();
            refused(
                &compiler,
                real,
                &[&["-Wno-builtin-macro-redefined"], &flags[..]].concat(),
            )
        };
        let short = [
            "-U__DBL_MANT_DIG__".to_owned(),
            "-D__DBL_MANT_DIG__=24".to_owned(),
        ];
        let messages = with(Real::Double, &short);
        assert!(
            messages.contains("write it by linkage c --scalar float"),
            "{command}: {messages}"
        );
        // Which says nothing of constants.
        assert!(
            !messages.contains("single_precision"),
            "{command}: {messages}"
        );
        let messages = with(Real::Single, &method(1));
        assert!(
            messages.contains("for s390x, say -fexcess-precision=fast"),
            "{command}: {messages}"
        );
        for real in REALS {
            for number in [2, -1] {
                let messages = with(real, &method(number));
                assert!(
                    messages.contains("say -msse2 -mfpmath=sse"),
                    "{command}: {messages}"
                );
            }
        }
        let accepted = |real, flags: &[String]| {
            let (folder, name) = written("accepted", &some()[1], real, |text| text);
            let flags: Vec<&str> = flags.iter().map(String::as_str).collect();
            let lines = assembled(
                &compiler,
                &folder,
                &name,
                &[&["-Wno-builtin-macro-redefined"], &flags[..]].concat(),
            );
            assert_eq!(
                lines.expect("it compiles")[0],
                "0|Press: assembled",
                "{command}"
            );
        };
        accepted(Real::Single, &short);
        // A float that is computed as a double concerns no double.
        accepted(Real::Double, &method(1));
    }
}
