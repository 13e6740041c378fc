//! A mechanism as a module of its own.

use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::{self, Display, Formatter};

use linkage_compiler::ir::CompiledMechanism;
use linkage_export::Declarations;

use crate::description::description;
use crate::engine::module_engine;
use crate::js_names::JavaScript;
use crate::object::Notation;
use crate::types;

/// A mechanism as JavaScript.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Module {
    /// The name by which it is exported, and that of its files: the mechanism's own, unless
    /// JavaScript has that itself. Then an underscore follows it.
    pub name: String,
    /// The text of a module, which exports the mechanism and the error that assembling throws.
    pub script: String,
    /// Its types, the text of a `.d.ts` file.
    pub types: String,
}

/// Two mechanisms whose files would be one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Clash {
    message: String,
}

impl Display for Clash {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl Error for Clash {}

/// Prints a mechanism that is called `title` in its declaration.
///
/// The module exports the mechanism by [`Module::name`], and `AssemblyError`, which its `assemble`
/// throws.
pub fn module(title: &str, unit: &CompiledMechanism) -> Module {
    let engine = module_engine();
    let declarations = Declarations::new(title, unit, &JavaScript);
    let description = description(&declarations, Notation::Script);
    let name = &declarations.name;
    let renamed = match name == title {
        true => String::new(),
        false => format!(
            "// JavaScript has the name {title} itself, or its modules have: this one exports {name}.\n"
        ),
    };
    // In a function: no name of the engine, or of the browser, meets that of the mechanism.
    let script = format!(
        "// {title}. Written by linkage; not to be changed by hand.\n{renamed}\nconst own = (() => {{\n{engine}\n\
         return {{ mechanism: mechanismOf({description}), AssemblyError }};\n}})();\n\
         const {{ mechanism, AssemblyError }} = own;\nexport {{ mechanism as {name}, AssemblyError }};\n"
    );
    Module {
        script,
        types: types::types(&declarations),
        name: declarations.name,
    }
}

/// Prints mechanisms whose files may be in one folder: each by its name in the declaration, with
/// its unit.
///
/// # Errors
///
/// For two whose names are one, or are one where a file system takes large and small letters for
/// the same: `SliderCrank` and `SLIDERCRANK`.
pub fn modules(mechanisms: &[(&str, &CompiledMechanism)]) -> Result<Vec<Module>, Clash> {
    let modules = mechanisms.iter().map(|(title, unit)| module(title, unit));
    let modules: Vec<Module> = modules.collect();
    let mut owners: BTreeMap<String, (&str, &str)> = BTreeMap::new();
    for ((title, _), module) in mechanisms.iter().zip(&modules) {
        let file = module.name.to_lowercase();
        if let Some((other, its)) = owners.insert(file, (title, &module.name)) {
            return Err(Clash {
                message: format!(
                    "`{other}` and `{title}` would have the files `{its}.js` and `{}.js`, which are one where a file system takes large and small \
                     letters for the same. Call one of them otherwise, or write them one by one, into two folders",
                    module.name
                ),
            });
        }
    }
    Ok(modules)
}
