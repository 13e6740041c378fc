//! Names of the user as names of C.

mod reserved;

use std::collections::BTreeSet;

pub(crate) use reserved::is_macro;
use reserved::{is_declared, is_for_compilers, is_header, is_keyword, is_mathematics};

/// The scope of names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Namespace {
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
    namespace: Namespace,
    taken: BTreeSet<String>,
}

impl Names {
    /// A place in which some names are taken.
    pub(crate) fn new(namespace: Namespace, taken: &[&str]) -> Self {
        let taken = taken.iter().map(|&name| name.to_owned()).collect();
        Self { namespace, taken }
    }

    /// Returns the name in C of something of the user, which nothing else in this place gets. It is
    /// the user's own name if C can have it. Otherwise underscores follow it; names that are left
    /// to compilers begin with an `x`.
    pub(crate) fn take(&mut self, wanted: &str) -> String {
        let mut name = plain(wanted);
        if is_for_compilers(&name, self.namespace == Namespace::File) {
            name.insert(0, 'x');
        }
        while self.is_taken(&name) {
            name.push('_');
        }
        self.taken.insert(name.clone());
        name
    }

    fn is_taken(&self, name: &str) -> bool {
        is_keyword(name)
            || is_macro(name)
            || self.taken.contains(name)
            || match self.namespace {
                Namespace::Struct => false,
                Namespace::File => is_declared(name),
                Namespace::Function => is_mathematics(name) || is_temporary(name),
            }
    }

    /// Returns a beginning that no name of this place has, and none of the others.
    pub(crate) fn unused_beginning<'a>(
        &'a self,
        wanted: &str,
        others: impl Iterator<Item = &'a String> + Clone,
    ) -> String {
        let mut beginning = wanted.to_owned();
        let names = self.taken.iter().chain(others);
        while names.clone().any(|name| name.starts_with(&beginning)) {
            beginning.push('x');
        }
        beginning
    }
}

/// Returns the beginning of all names of a mechanism, which is also the name of its files.
/// `constants` returns the names of its constants for a beginning.
pub(crate) fn prefix(title: &str, constants: impl Fn(&str) -> Vec<String>) -> String {
    let mut prefix = Names::new(Namespace::File, &[]).take(&snake(title));
    while is_header(&prefix)
        || is_declared(&prefix)
        || constants(&prefix).iter().any(|name| is_macro(name))
    {
        prefix.push('_');
    }
    prefix
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

fn snake(name: &str) -> String {
    snake_letters(&plain(name))
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
