//! Functions that printed programs call: operations that the target language does not have, or not
//! with these results.
//!
//! A text contains all of them. A line with a mark, `HELPER name (variant|variant): other, names`,
//! begins each function. The variants and the other names that it defines may be left out. In the
//! text, `own_` begins all names of helpers, and functions follow those that they call.

use std::collections::BTreeSet;

/// The helpers of a language.
#[derive(Debug)]
pub struct HelperLibrary {
    helpers: Vec<Helper>,
}

/// A function or a type.
#[derive(Debug)]
struct Helper {
    /// All names that it defines, the name that operations call first.
    names: Vec<&'static str>,
    /// The types of numbers that it is for, if there are others for the other types.
    variant: Option<&'static str>,
    text: &'static str,
}

impl HelperLibrary {
    /// Reads helpers from a text; `begin` and `end` enclose the mark: `/* ` and ` */`.
    pub fn new(text: &'static str, begin: &str, end: &str) -> Self {
        let begin = format!("{begin}HELPER ");
        let end = format!("{end}\n");
        let parts = text.split(&begin[..]).skip(1);
        let helper = |part: &'static str| {
            let (head, text) = part.split_once(&end[..]).unwrap_or((part, ""));
            let words = head.split([' ', ',', ':']).filter(|word| !word.is_empty());
            let (variants, names): (Vec<&str>, Vec<&str>) =
                words.partition(|word| word.starts_with('('));
            let variant = variants.first();
            Helper {
                names,
                variant: variant.map(|word| word.trim_matches(['(', ')'])),
                text,
            }
        };
        Self {
            helpers: parts.map(helper).collect(),
        }
    }

    /// Returns the names of all helpers of a variant, in the order of the text.
    pub fn names<'l>(&'l self, variant: &'l str) -> impl Iterator<Item = &'static str> + 'l {
        let helpers = self.helpers.iter();
        let of_variant = helpers.filter(move |helper| helper.is_for(variant));
        of_variant.map(|helper| helper.names[0])
    }

    /// The helper that defines a name, by its index.
    fn find(&self, name: &str, variant: &str) -> Option<usize> {
        let mut helpers = self.helpers.iter();
        helpers.position(|helper| helper.names.contains(&name) && helper.is_for(variant))
    }
}

impl Helper {
    fn is_for(&self, variant: &str) -> bool {
        let mut variants = self.variant.iter().flat_map(|all| all.split('|'));
        self.variant.is_none() || variants.any(|other| other == variant)
    }
}

/// The helpers that a mechanism needs.
#[derive(Clone, Debug)]
pub struct Helpers<'l> {
    library: &'l HelperLibrary,
    variant: &'static str,
    needed: BTreeSet<usize>,
}

impl<'l> Helpers<'l> {
    /// No helpers, of a variant.
    pub fn new(library: &'l HelperLibrary, variant: &'static str) -> Self {
        Self {
            library,
            variant,
            needed: BTreeSet::new(),
        }
    }

    /// Adds the helper of this name, and those that it calls.
    ///
    /// # Panics
    ///
    /// If the library does not have it.
    pub fn need(&mut self, name: &str) {
        let Some(index) = self.library.find(name, self.variant) else {
            panic!("the helpers have no `{name}`");
        };
        if self.needed.insert(index) {
            let text = self.library.helpers[index].text;
            let names = text.split("own_").skip(1).map(|rest| {
                let end = rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_'));
                &rest[..end.unwrap_or(rest.len())]
            });
            names.for_each(|name| self.need(name));
        }
    }

    /// Returns true if the helper of this name is needed.
    pub fn has(&self, name: &str) -> bool {
        let index = self.library.find(name, self.variant);
        index.is_some_and(|index| self.needed.contains(&index))
    }

    /// Returns the texts of all needed helpers, in the order of the library.
    pub fn texts(&self) -> impl Iterator<Item = &'static str> {
        let needed = self.needed.iter();
        needed.map(|&index| self.library.helpers[index].text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "(* HELPER one (wide|long) *)\nwide one\n(* HELPER one (short): pair *)\nshort one\n\
        (* HELPER two *)\nown_one(own_one)\n";

    #[test]
    fn helpers_come_with_those_that_they_call() {
        let library = HelperLibrary::new(TEXT, "(* ", " *)");
        assert!(library.names("short").eq(["one", "two"]));
        let mut helpers = Helpers::new(&library, "short");
        helpers.need("two");
        assert!(helpers.has("pair"));
        assert!(helpers.texts().eq(["short one\n", "own_one(own_one)\n"]));
        let mut helpers = Helpers::new(&library, "long");
        helpers.need("one");
        assert!(helpers.texts().eq(["wide one\n"]) && !helpers.has("two"));
    }
}
