//! Names of the command line in the form in which names are compared.

use std::convert::Infallible;

use linkage_engine::normal_form;

/// A text of the command line.
pub(crate) fn normal(text: &str) -> Result<String, Infallible> {
    Ok(normal_form(text))
}
