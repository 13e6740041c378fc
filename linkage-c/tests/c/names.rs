//! Names of the user that C, C++, their libraries or the exported files have themselves.

use std::collections::BTreeSet;

use linkage_c::{Real, Sources, all_sources, sources};
use linkage_corpus::given::Given;

use crate::machine;
use crate::users::{compile, exported, mechanism};

/// Names that a declaration may have, by kind: words of C in its versions, of C++ in its versions, of JavaScript; macros, functions, types and
/// variables of headers; names that compilers keep; names of the exported files.
const KINDS: [&str; 9] = [
    "auto case char default double float goto int long register short signed sizeof switch typedef union unsigned void volatile \
     inline restrict alignas alignof bool constexpr nullptr static_assert thread_local typeof_unqual fortran asm",
    "and and_eq bitand bitor catch char8_t char16_t char32_t class co_await co_return co_yield compl concept const_cast consteval \
     constinit decltype delete dynamic_cast explicit export friend mutable namespace new noexcept not not_eq operator or or_eq \
     private protected public reinterpret_cast requires static_cast template this throw typeid typename using wchar_t xor xor_eq",
    "arguments eval function var null undefined NaN Infinity instanceof interface package debugger finally implements import with",
    "NAN INFINITY HUGE_VAL M_PI M_PIl M_E FP_NAN FE_UPWARD SIZE_MAX INT_MAX INT32_MAX UINT8_MAX INT_FAST16_MAX UINTPTR_MAX PRId32 \
     PRIuLEAST8 SCNxMAX CHAR_BIT DBL_MAX FLT_EPSILON LDBL_DIG FLT_EVAL_METHOD EOF NULL BUFSIZ RAND_MAX EXIT_FAILURE CLOCKS_PER_SEC SIGINT \
     SIG_DFL EDOM ERANGE EINTR LC_ALL I complex stdin stdout stderr errno noreturn math_errhandling WEOF ONCE_FLAG_INIT R_OK W_OK F_OK \
     O_RDONLY PATH_MAX linux unix",
    "abs labs fabs fabsf sqrt sqrtf sin cos tan acosf atan2 hypotl isnan isinf signbit fmin fmax round trunc j0 y1 gamma printf malloc free \
     exit abort time clock signal raise memcpy strlen setjmp assert offsetof va_start link read write open close pipe select index sleep \
     pause kill wait access div rand nice sync",
    "size_t ptrdiff_t int8_t uint64_t float_t double_t time_t FILE div_t va_list jmp_buf fenv_t sig_atomic_t tm timespec timeval stat",
    "_Bool _Complex _Imaginary _Atomic _Generic _Noreturn _Alignas _Float16 _Static_assert _Thread_local _Decimal64 _BitInt _Pragma",
    "main std posix environ timezone optarg",
    "m x out at count results result inputs turns code dimensions miss moved prepared nothing v0 v17 state_0 k n number assemble error ok",
];

fn all_names() -> Vec<&'static str> {
    KINDS
        .iter()
        .flat_map(|own| own.split_whitespace())
        .collect()
}

#[test]
fn names_of_all_kinds_compile() {
    let names = all_names();
    let mut texts = vec![
        mechanism("AsParameters", &names, &[], &[], &[]),
        mechanism("AsResults", &[], &names, &[], &[]),
        mechanism("AsFunctions", &[], &[], &[], &names),
    ];
    for (number, some) in names.chunks(60).enumerate() {
        texts.push(mechanism(&format!("AsInputs{number}"), &[], &[], some, &[]));
    }
    let all = exported(&texts);
    let folder = machine::folder("names");
    all.iter().for_each(|own| machine::write(&folder, own));
    compile(&folder, &all);
}

/// Names of mechanisms and functions whose names in C are those of headers, of functions or of constants: `X_OK`, `int8_t`, `timer_create`.
const MECHANISMS: [(&str, &str); 42] = [
    ("Link", "at"),
    ("Main", "f"),
    ("Int", "f"),
    ("Double", "t"),
    ("Float", "t"),
    ("Class", "f"),
    ("Default", "f"),
    ("Nan", "f"),
    ("Abs", "f"),
    ("Time", "t"),
    ("Clock", "t"),
    ("Timer", "create"),
    ("Pthread", "create"),
    ("Sem", "open"),
    ("Size", "t"),
    ("Int8", "t"),
    ("Uint64", "t"),
    ("Ptrdiff", "t"),
    ("Div", "t"),
    ("Va", "start"),
    ("Sig", "atomic_t"),
    ("X", "f"),
    ("R", "f"),
    ("F", "f"),
    ("W", "f"),
    ("Math", "f"),
    ("Stdio", "f"),
    ("String", "f"),
    ("Stdint", "f"),
    ("Limits", "f"),
    ("Signal", "f"),
    ("Select", "f"),
    ("Stat", "f"),
    ("Tm", "f"),
    ("Std", "f"),
    ("Sin", "f"),
    ("Sinf", "f"),
    ("Complex", "f"),
    ("Atomic", "load"),
    ("Mtx", "lock"),
    ("_Start", "f"),
    ("Environ", "f"),
];

#[test]
fn mechanisms_that_are_called_like_something_of_the_library_compile() {
    let texts = MECHANISMS.map(|(name, function)| mechanism(name, &[], &[], &[], &[function]));
    let all = exported(&texts);
    let folder = machine::folder("names_of_mechanisms");
    all.iter().for_each(|own| machine::write(&folder, own));
    compile(&folder, &all);
    let name = |index: usize| &all[index].name[..];
    assert_eq!(
        [name(0), name(1), name(21), name(25)],
        ["link_", "main_", "x_", "math_"]
    );
    assert!(
        all[15].header.contains("int8_t_(const int8 *m"),
        "{}",
        all[15].header
    );
}

#[test]
fn other_names_are_in_the_header() {
    let given = Given::text(&mechanism(
        "Link",
        &["_Bool", "M_PI", "λ", "len"],
        &["class"],
        &["double"],
        &["ok"],
    ));
    let Sources {
        header, renamed, ..
    } = sources("Link", &given.unit, Real::Double).expect("it can be exported");
    let lines: Vec<String> = renamed.iter().map(ToString::to_string).collect();
    assert_eq!(
        lines,
        [
            "the mechanism `Link` is called `link_` in C",
            "the argument `double` of `all__` is called `double_` in C",
            "the result `class` of `all__` is called `class_` in C",
            "the function `ok` is called `link__ok_` in C",
            "the argument `double` of `ok` is called `double_` in C",
            "the parameter `_Bool` is called `x_Bool` in C",
            "the parameter `M_PI` is called `M_PI_` in C",
            "the parameter `λ` is called `u3bb` in C",
        ]
    );
    for line in lines {
        assert!(header.contains(&line.replace('`', "")), "{line}\n{header}");
    }
    let plain = Given::text(&mechanism(
        "Plain",
        &["len"],
        &["speed"],
        &["s"],
        &["motion"],
    ));
    let plain = sources("Plain", &plain.unit, Real::Double).expect("it can be exported");
    assert!(
        plain.renamed.is_empty() && !plain.header.contains("is called"),
        "{}",
        plain.header
    );
}

/// Names that become others are not those that others have.
#[test]
fn no_two_names_become_one() {
    let names = [
        "int", "int_", "int__", "λ", "u3bb", "_Bool", "x_Bool", "NAN_", "NAN",
    ];
    let text = mechanism(
        "Many",
        &names,
        &names,
        &["v1", "v1_", "double", "double_"],
        &["error", "error_", "ok_", "ok"],
    );
    let [own] = &exported(&[text])[..] else {
        panic!("one mechanism")
    };
    for part in [
        "typedef struct many_dimensions {",
        "typedef struct many_all___result {",
    ] {
        let (_, rest) = own.header.split_once(part).expect("a struct");
        let (fields, _) = rest.split_once('}').expect("its end");
        let fields: Vec<&str> = fields
            .lines()
            .filter_map(|line| line.trim().split(';').next())
            .collect();
        let different: BTreeSet<&str> = fields.iter().copied().collect();
        assert_eq!(different.len(), fields.len(), "{fields:?}");
    }
    for name in [
        "many_error_(",
        "many_error__(",
        "many_ok_(",
        "many_ok__(",
        "double v1_, double v1__, double double_, double double__",
    ] {
        assert!(own.header.contains(name), "{name} in\n{}", own.header);
    }
}

#[test]
fn two_mechanisms_with_one_name_in_c_are_refused() {
    let one =
        |name: &str, function: &str| Given::text(&mechanism(name, &[], &[], &[], &[function]));
    for (first, second, name) in [
        (("SliderCrank", "f"), ("Slider_Crank", "f"), "slider_crank"),
        (("É", "f"), ("Uc9", "f"), "uc9"),
        (("Press", "motion"), ("PressMotion", "f"), "press_motion"),
        (("Press", "f"), ("PressDimensions", "f"), "press_dimensions"),
    ] {
        let given = [one(first.0, first.1), one(second.0, second.1)];
        let named: Vec<_> = given.iter().map(|own| (&own.name[..], &own.unit)).collect();
        let refused = all_sources(&named, Real::Double)
            .expect_err("two names are one")
            .to_string();
        let start = format!(
            "`{}` and `{}` would both have the name `{name}` in C. ",
            first.0, second.0
        );
        assert!(refused.starts_with(&start), "{refused}");
        // Each of them alone is exported.
        named
            .iter()
            .for_each(|own| assert!(all_sources(&[*own], Real::Double).is_ok()));
    }
    let given = [one("Press", "f"), one("Presses", "f")];
    let named: Vec<_> = given.iter().map(|own| (&own.name[..], &own.unit)).collect();
    assert_eq!(
        all_sources(&named, Real::Single).map(|all| all.len()),
        Ok(2)
    );
}
