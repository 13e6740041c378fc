//! Chooses all names of a mechanism in C.

use linkage_compiler::ir::CompiledMechanism;

use super::constant::constant;
use super::data::{CONSTANTS, CONSTANTS_OF_ALL, Dimension, Evaluator, Surface};
use super::declared::Declared;
use super::evaluator::{Scope, evaluator};
use super::notes::dimension_note;
use super::places::places;
use super::range_names::RangeNames;
use super::refusal::codes;
use super::renamed::Log;
use crate::c_names::{self, Names, Namespace, plain, snake_letters};
use crate::real::Real;

/// The surface of a mechanism that is called `title` in its declaration.
pub(crate) fn surface<'a>(title: &str, unit: &'a CompiledMechanism, real: Real) -> Surface<'a> {
    let prefix = c_names::prefix(title, |prefix| {
        let codes = codes(title, prefix, unit).into_iter().map(|code| code.name);
        let others = CONSTANTS_OF_ALL.map(|name| constant(prefix, name));
        codes.chain(others).collect()
    });
    let mut renamed = Log::default();
    let usual = snake_letters(title);
    renamed.note(|| format!("the mechanism `{title}`"), &usual, &prefix);
    let mut names = Names::new(Namespace::File, &[&prefix]);
    let mut global = |name: &str| names.take(&format!("{prefix}_{name}"));
    let [dimensions_type, assemble, error, ok, constants] =
        ["dimensions", "assemble", "error", "ok", CONSTANTS].map(&mut global);
    let vectors = ["xy", "xyz", "frame", "plane_frame"].map(&mut global);
    // A member of C++ is not called like the type of another one.
    let types: Vec<&str> = vectors.iter().map(String::as_str).collect();
    let functions = unit.functions.iter();
    let functions = functions.map(|function| {
        let scope = Scope {
            unit,
            real,
            prefix: &prefix,
            types: &types,
        };
        evaluator(scope, function, &mut global, &mut renamed)
    });
    let functions: Vec<Evaluator<'a>> = functions.collect();
    // After the functions: a user's function of one of these names keeps it.
    let range = RangeNames::new(&prefix, &mut global);
    let arguments = functions.iter().flat_map(|entry| &entry.arguments);
    let private = names.unused_beginning(&format!("{prefix}_own_"), arguments);
    let mut fields = Names::new(Namespace::Struct, &types);
    let dimensions: Vec<Dimension<'a>> = unit
        .parameters
        .iter()
        .map(|parameter| {
            // Of a part's parameter: `hook_crank`.
            let usual = parameter.name.replace('.', "_");
            let name = fields.take(&usual);
            renamed.note(
                || format!("the parameter `{}`", parameter.name),
                &usual,
                &name,
            );
            Dimension {
                name,
                documentation: &parameter.documentation,
                shape: parameter.shape.clone(),
                note: dimension_note(&parameter.scalars),
                values: parameter
                    .scalars
                    .iter()
                    .map(|scalar| scalar.nominal)
                    .collect(),
            }
        })
        .collect();
    let scalars = dimensions.iter();
    let scalars = scalars
        .flat_map(|item| places(&item.name, &item.shape))
        .collect();
    Surface {
        codes: codes(title, &prefix, unit),
        title: plain(title),
        unit,
        real,
        private,
        dimensions,
        scalars,
        functions,
        assemble: Declared {
            signature: format!("int {assemble}({prefix} *m, const {dimensions_type} *dimensions)"),
            name: assemble,
        },
        error: Declared {
            signature: format!("const char *{error}(int code)"),
            name: error,
        },
        range,
        ok: Declared {
            signature: format!("int {ok}({} number)", real.name()),
            name: ok,
        },
        constants,
        dimensions_type,
        renamed: renamed.0,
        vectors,
        prefix,
    }
}
