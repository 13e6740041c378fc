//! Structured text as a target language: names, and declarations of variables.

use linkage_compiler::ir::Shape;
use linkage_export::{FunctionItem, Scope, Target};

/// Words of the language, its types, and its functions and function blocks, in small letters; the
/// variables of blocks.
const WORDS: &str = include_str!("words.txt");

/// Structured text.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Text;

impl Target for Text {
    const LANGUAGE: &'static str = "structured text";

    const ITEMS: &'static [&'static str] = &["assemble", "xy", "xyz", "frame", "plane_frame"];

    const FUNCTION_ITEMS: &'static [FunctionItem] = &[
        FunctionItem {
            ending: "_result",
            kind: "the result of the function",
        },
        FunctionItem {
            ending: "",
            kind: "the function",
        },
    ];

    fn mechanism_name(&self, title: &str) -> String {
        title.to_owned()
    }

    fn item_name(&self, mechanism: &str, item: &str) -> String {
        format!("{mechanism}_{item}")
    }

    /// Letters of ASCII, and no underscores at the end or one after the other.
    fn spelled(&self, name: &str, _scope: Scope) -> String {
        let mut spelled = String::new();
        for letter in name.chars() {
            match letter {
                '_' if spelled.ends_with('_') => {}
                _ if letter.is_ascii_alphanumeric() || letter == '_' => spelled.push(letter),
                _ => spelled += &format!("u{:x}", u32::from(letter)),
            }
        }
        spelled.trim_end_matches('_').to_owned()
    }

    fn is_reserved(&self, name: &str, scope: Scope) -> bool {
        let name = self.key(name);
        let is_temporary = || {
            let number = name.strip_prefix(['v', 'c']);
            number.is_some_and(|digits| digits.bytes().all(|digit| digit.is_ascii_digit()))
        };
        name.is_empty()
            || WORDS.split_whitespace().any(|word| word == name)
            || (scope == Scope::Function && is_temporary())
    }

    fn altered(&self, name: &str) -> String {
        format!("{name}_x").trim_start_matches('_').to_owned()
    }

    fn key(&self, name: &str) -> String {
        name.to_ascii_lowercase()
    }

    fn names_in(&self, scope: Scope, mechanism: &str, items: &[String]) -> Vec<String> {
        match scope {
            Scope::Mechanism | Scope::Members => Vec::new(),
            Scope::File | Scope::Function => {
                let mut names = items.to_vec();
                names.push(mechanism.to_owned());
                names
            }
        }
    }

    fn declared(&self, name: &str, shape: &Shape, items: &[String]) -> String {
        format!("{name} : {}", type_of(shape, items))
    }
}

/// Returns the type of a variable; `items` are the names of the items of the mechanism.
fn type_of(shape: &Shape, items: &[String]) -> String {
    let [_, xy, xyz, frame, plane_frame] = items else {
        unreachable!("a mechanism has the types of vectors and frames")
    };
    match shape {
        Shape::Scalar => "LREAL".to_owned(),
        Shape::Vector(2) => xy.clone(),
        Shape::Vector(_) => xyz.clone(),
        Shape::Frame => frame.clone(),
        Shape::PlaneFrame => plane_frame.clone(),
        Shape::Array(count, entry) => {
            let (mut ranges, mut entry) = (format!("0..{}", count - 1), &**entry);
            while let Shape::Array(count, inner) = entry {
                ranges += &format!(", 0..{}", count - 1);
                entry = inner;
            }
            format!("ARRAY[{ranges}] OF {}", type_of(entry, items))
        }
    }
}
