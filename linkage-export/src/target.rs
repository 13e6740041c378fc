//! The interface of a target language: its names, and its declarations of variables.

use linkage_compiler::ir::Shape;

/// The set of names within which a name is unique.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scope {
    /// Mechanisms, and the files that have their names.
    Mechanism,
    /// Functions, types and constants of a file.
    File,
    /// Arguments and variables of a function.
    Function,
    /// Members of a type: dimensions, and results of a function.
    Members,
}

/// An item that is printed for each function of the user.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FunctionItem {
    /// The end of its name, after the name of the function: `_result`.
    pub ending: &'static str,
    /// Its kind, for notes about names: `the result of the function`.
    pub kind: &'static str,
}

/// A language that mechanisms are printed in.
///
/// The names of an item are chosen in this order: the mechanism, [`ITEMS`](Self::ITEMS), the items,
/// arguments and results of each function, [`LATER_ITEMS`](Self::LATER_ITEMS), the dimensions.
/// Names that are chosen first keep their usual form.
pub trait Target {
    /// The language in notes: `C`.
    const LANGUAGE: &'static str;

    /// Items of a mechanism that do not belong to a function of the user.
    const ITEMS: &'static [&'static str] = &[];

    /// Items that give way to functions of the user of the same name.
    const LATER_ITEMS: &'static [&'static str] = &[];

    /// Items of each function of the user.
    const FUNCTION_ITEMS: &'static [FunctionItem];

    /// Returns the usual name of a mechanism that is called `title` in its declaration. Its name is
    /// the title, [spelled](Self::spelled) in [`Scope::Mechanism`]; another one is noted.
    fn mechanism_name(&self, title: &str) -> String;

    /// Returns the usual name of an item of a mechanism, or of a function and its items.
    fn item_name(&self, mechanism: &str, item: &str) -> String;

    /// Returns a name in the letters that the language allows.
    fn spelled(&self, name: &str, scope: Scope) -> String;

    /// Returns true if the language, its library or the printed text has a name itself.
    fn is_reserved(&self, name: &str, scope: Scope) -> bool;

    /// Returns the next form of a name that is not available.
    fn altered(&self, name: &str) -> String {
        format!("{name}_")
    }

    /// Returns a text that is equal for names that the language does not distinguish.
    fn key(&self, name: &str) -> String {
        name.to_owned()
    }

    /// Returns true if calls of a function of `arguments` arguments need the item.
    fn has_function_item(&self, _item: &FunctionItem, _arguments: usize) -> bool {
        true
    }

    /// Returns the names that nothing of the user has in a scope, although they are not reserved:
    /// names of the mechanism that are visible there. `items` are the names of the function's items
    /// in [`Scope::Function`], those of [`ITEMS`](Self::ITEMS) in [`Scope::Members`].
    fn names_in(&self, _scope: Scope, _mechanism: &str, _items: &[String]) -> Vec<String> {
        Vec::new()
    }

    /// Returns the declaration of a variable, without its end: `double e[3]`. `items` are the names
    /// of [`ITEMS`](Self::ITEMS).
    fn declared(&self, name: &str, shape: &Shape, items: &[String]) -> String;
}
