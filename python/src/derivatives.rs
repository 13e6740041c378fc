//! Functions with derivatives that the text of a mechanism does not have.

use linkage_engine::Mechanism;
use linkage_language::diagnostic::Diagnostics;
use linkage_language::syntax;
use linkage_page::with_further_functions;

use crate::text::File;

/// The name of the function; that of its result is in the way of rustc.
const NAME: &str = "linkage_derivatives";
const RESULT: &str = "LinkageDerivatives";

/// Returns a mechanism of a text with one more function: all fields of a function of it, and after
/// them the derivatives of some fields with respect to each of these inputs and dimensions, field by
/// field. `None` if there is no such function, or a field has no such derivative.
pub(crate) fn derivatives(
    file: &File,
    mechanism: &str,
    function: &str,
    fields: &[String],
    variables: &[String],
) -> Option<Mechanism> {
    let source = file.source().ok()?;
    let mut definitions = source
        .calls()
        .iter()
        .flat_map(|call| syntax::parse(call.tokens.clone(), &mut Diagnostics::default()));
    let definition = definitions.find(|one| one.title() == mechanism)?;
    let mut functions = definition.functions.iter();
    let found = functions.find(|one| named(&one.name.to_string(), function))?;
    // The fields keep the arguments, which are those that a function needs.
    let mut quantities: Vec<String> = found
        .quantities
        .iter()
        .map(|quantity| format!("{}: {:#}", quantity.field, quantity.value))
        .collect();
    for (number, field) in fields.iter().enumerate() {
        let mut all = found.quantities.iter();
        let quantity = all.find(|one| named(&one.field.to_string(), field))?;
        for (index, variable) in variables.iter().enumerate() {
            quantities.push(format!(
                "linkage_{number}_{index}: d({:#}, {variable})",
                quantity.value
            ));
        }
    }
    let arguments: Vec<String> = found.inputs.iter().map(ToString::to_string).collect();
    let text = format!(
        "fn {NAME}({}) -> {RESULT} {{ {} }}",
        arguments.join(", "),
        quantities.join(", ")
    );
    with_further_functions(&source, mechanism, &text)
}

/// True for a name as it is read: `loop` for `r#loop`.
fn named(written: &str, name: &str) -> bool {
    written.strip_prefix("r#").unwrap_or(written) == name
}
