//! Functions that the header declares.

/// A function that the header declares and the source defines.
#[derive(Debug)]
pub(crate) struct Declared {
    pub(crate) name: String,
    /// Its macro, type, name and parameters, without the semicolon of a declaration.
    pub(crate) signature: String,
    /// Its parameters.
    pub(crate) parameters: String,
}

impl Declared {
    /// A function of this name; `api` is the macro before it, `result` the type of its result.
    pub(super) fn new(api: &str, result: &str, name: &str, parameters: &str) -> Self {
        // The asterisk of a pointer is at the name.
        let blank = if result.ends_with('*') { "" } else { " " };
        Self {
            name: name.to_owned(),
            signature: format!("{api} {result}{blank}{name}({parameters})"),
            parameters: parameters.to_owned(),
        }
    }
}
