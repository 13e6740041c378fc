//! The modules of a crate: their items, imports, and the paths in their code.

use std::collections::{BTreeMap, BTreeSet};

/// The words of a path.
pub(crate) type Path<'t> = Vec<&'t str>;

/// A meaning of a name in a module.
#[derive(Debug)]
pub(crate) enum Entry<'t> {
    /// An item of the module's file.
    Item { is_trait: bool },
    /// A module below, by its index.
    Module(usize),
    /// An import.
    Import(Path<'t>),
}

/// An import, or all names of a module.
#[derive(Debug)]
pub(crate) struct Import<'t> {
    pub(crate) path: Path<'t>,
    /// The name that it gets; none for `_` and for all names of a module.
    pub(crate) name: Option<&'t str>,
    pub(crate) is_glob: bool,
    /// True for `pub use` and the like.
    pub(crate) is_public: bool,
    pub(crate) line: usize,
}

/// A path in code, or the name of a macro that is called.
#[derive(Debug)]
pub(crate) struct Mention<'t> {
    pub(crate) path: Path<'t>,
    pub(crate) line: usize,
}

/// A block of methods without a trait.
#[derive(Debug)]
pub(crate) struct Methods<'t> {
    pub(crate) of: Path<'t>,
    pub(crate) count: usize,
}

#[derive(Debug, Default)]
pub(crate) struct Module<'t> {
    /// The index of its file among the sources.
    pub(crate) file: usize,
    pub(crate) parent: Option<usize>,
    /// From the root: nothing for the root itself.
    pub(crate) path: Vec<&'t str>,
    pub(crate) names: BTreeMap<&'t str, Vec<Entry<'t>>>,
    pub(crate) imports: Vec<Import<'t>>,
    pub(crate) mentions: Vec<Mention<'t>>,
    pub(crate) methods: Vec<Methods<'t>>,
    /// All words of its code, without fields, methods and imports.
    pub(crate) words: BTreeSet<&'t str>,
    /// Macros that are called by a single word.
    pub(crate) calls: Vec<Mention<'t>>,
}

/// All modules of a crate; the root is the first.
#[derive(Debug, Default)]
pub(crate) struct Modules<'t> {
    pub(crate) modules: Vec<Module<'t>>,
    /// The files that define macros by `macro_rules!`.
    pub(crate) macros: BTreeMap<&'t str, BTreeSet<usize>>,
}
