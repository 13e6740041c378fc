//! Names of the user as names of C.

use std::collections::BTreeSet;

/// What no name may be: words of C and of C++, and macros that stand for something alone.
const WORDS: &[&str] = &[
    "alignas",
    "alignof",
    "and",
    "and_eq",
    "asm",
    "auto",
    "bitand",
    "bitor",
    "bool",
    "break",
    "case",
    "catch",
    "char",
    "char16_t",
    "char32_t",
    "char8_t",
    "class",
    "co_await",
    "co_return",
    "co_yield",
    "compl",
    "concept",
    "const",
    "const_cast",
    "consteval",
    "constexpr",
    "constinit",
    "continue",
    "decltype",
    "default",
    "delete",
    "do",
    "double",
    "dynamic_cast",
    "else",
    "enum",
    "explicit",
    "export",
    "extern",
    "false",
    "float",
    "for",
    "friend",
    "goto",
    "if",
    "inline",
    "int",
    "long",
    "mutable",
    "namespace",
    "new",
    "noexcept",
    "not",
    "not_eq",
    "nullptr",
    "operator",
    "or",
    "or_eq",
    "private",
    "protected",
    "public",
    "register",
    "reinterpret_cast",
    "requires",
    "restrict",
    "return",
    "short",
    "signed",
    "sizeof",
    "static",
    "static_assert",
    "static_cast",
    "struct",
    "switch",
    "template",
    "this",
    "thread_local",
    "throw",
    "true",
    "try",
    "typedef",
    "typeid",
    "typename",
    "typeof",
    "union",
    "unsigned",
    "using",
    "virtual",
    "void",
    "volatile",
    "wchar_t",
    "while",
    "xor",
    "xor_eq",
    "linux",
    "unix",
    "EOF",
    "FILE",
    "HUGE_VAL",
    "I",
    "INFINITY",
    "NAN",
    "NULL",
    "complex",
    "errno",
    "stderr",
    "stdin",
    "stdout",
];

/// What a name of a file or of a function must not be: what `math.h`, `stdint.h` and `stddef.h` declare.
const LIBRARY: &[&str] = &[
    "acos",
    "acosh",
    "asin",
    "asinh",
    "atan",
    "atan2",
    "atanh",
    "cbrt",
    "ceil",
    "copysign",
    "cos",
    "cosh",
    "erf",
    "erfc",
    "exp",
    "exp2",
    "expm1",
    "fabs",
    "fabsf",
    "fdim",
    "floor",
    "fma",
    "fmax",
    "fmin",
    "fmod",
    "frexp",
    "gamma",
    "hypot",
    "ilogb",
    "isfinite",
    "isinf",
    "isnan",
    "isnormal",
    "j0",
    "j1",
    "jn",
    "ldexp",
    "lgamma",
    "llrint",
    "llround",
    "log",
    "log10",
    "log1p",
    "log2",
    "logb",
    "lrint",
    "lround",
    "modf",
    "nan",
    "nearbyint",
    "nextafter",
    "nexttoward",
    "pow",
    "remainder",
    "remquo",
    "rint",
    "round",
    "scalb",
    "scalbln",
    "scalbn",
    "signbit",
    "significand",
    "signgam",
    "sin",
    "sinh",
    "sqrt",
    "sqrtf",
    "tan",
    "tanh",
    "tgamma",
    "trunc",
    "y0",
    "y1",
    "yn",
    "size_t",
    "ptrdiff_t",
    "float_t",
    "double_t",
];

/// Where names stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// In a struct.
    Struct,
    /// In a file.
    File,
    /// In a function, whose values are called `v17`.
    Function,
}

/// The names of one place, each once.
#[derive(Clone, Debug)]
pub(crate) struct Names {
    place: Place,
    taken: BTreeSet<String>,
}

impl Names {
    /// A place in which some names are taken.
    pub(crate) fn new(place: Place, taken: &[&str]) -> Self {
        let taken = taken.iter().map(|&name| name.to_owned()).collect();
        Self { place, taken }
    }

    /// The name for something of the user: as it is written if C can have it, else with underscores behind it.
    pub(crate) fn take(&mut self, wanted: &str) -> String {
        let mut name = plain(wanted);
        while self.is_taken(&name) {
            name.push('_');
        }
        self.taken.insert(name.clone());
        name
    }

    fn is_taken(&self, name: &str) -> bool {
        let declared = LIBRARY.contains(&name);
        WORDS.contains(&name)
            || self.taken.contains(name)
            || match self.place {
                Place::Struct => false,
                Place::File => declared,
                Place::Function => declared || is_temporary(name),
            }
    }

    /// A beginning that no name has.
    pub(crate) fn unused_beginning(&self, wanted: &str) -> String {
        let mut beginning = wanted.to_owned();
        while self.taken.iter().any(|name| name.starts_with(&beginning)) {
            beginning.push('x');
        }
        beginning
    }
}

/// Programs call their values `v17`, and states `state_0`.
fn is_temporary(name: &str) -> bool {
    let digits = name
        .strip_prefix("state_")
        .or_else(|| name.strip_prefix('v'));
    digits.is_some_and(|own| !own.is_empty() && own.bytes().all(|c| c.is_ascii_digit()))
}

/// A name of Rust with numbers in place of letters that C does not know.
pub(crate) fn plain(name: &str) -> String {
    let mut plain = String::new();
    for letter in name.chars() {
        match letter.is_ascii_alphanumeric() || letter == '_' {
            true => plain.push(letter),
            false => plain += &format!("u{:x}", u32::from(letter)),
        }
    }
    plain
}

/// `SliderCrank` as `slider_crank`, `RSSR` as `rssr`.
pub(crate) fn snake(name: &str) -> String {
    let letters: Vec<char> = plain(name).chars().collect();
    let mut snake = String::new();
    for (index, letter) in letters.iter().enumerate() {
        let before = index.checked_sub(1).map(|k| letters[k]);
        let begins = before.is_some_and(|before| {
            let next = letters.get(index + 1);
            let ends_capitals =
                before.is_ascii_uppercase() && next.is_some_and(char::is_ascii_lowercase);
            letter.is_ascii_uppercase()
                && before != '_'
                && (!before.is_ascii_uppercase() || ends_capitals)
        });
        if begins {
            snake.push('_');
        }
        snake.push(letter.to_ascii_lowercase());
    }
    snake
}
