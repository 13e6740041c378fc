//! Names of the user as names of C.

mod reserved;

use linkage_export::Scope;

pub(crate) use reserved::is_macro;
use reserved::{is_declared, is_for_compilers, is_header, is_keyword, is_mathematics};

/// Returns a name in the letters of C; names that are left to compilers begin with an `x`. Names of
/// mechanisms have small letters.
pub(crate) fn spelled(name: &str, scope: Scope) -> String {
    let mut name = plain(name);
    if scope == Scope::Mechanism {
        name = snake_letters(&name);
    }
    let of_file = matches!(scope, Scope::Mechanism | Scope::File);
    if is_for_compilers(&name, of_file) {
        name.insert(0, 'x');
    }
    name
}

/// Returns true if C, its library or programs have a name in a scope.
pub(crate) fn is_reserved(name: &str, scope: Scope) -> bool {
    is_keyword(name)
        || is_macro(name)
        || match scope {
            Scope::Members => false,
            Scope::Mechanism => is_declared(name) || is_header(name),
            Scope::File => is_declared(name),
            Scope::Function => is_mathematics(name) || is_temporary(name),
        }
}

/// Programs call their values `v17`, and states `state_0`.
fn is_temporary(name: &str) -> bool {
    let digits = name
        .strip_prefix("state_")
        .or_else(|| name.strip_prefix('v'));
    digits.is_some_and(|entry| !entry.is_empty() && entry.bytes().all(|c| c.is_ascii_digit()))
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
pub(crate) fn snake_letters(name: &str) -> String {
    let letters: Vec<char> = name.chars().collect();
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
