//! The public functions that make an assembly of dimensions.

use proc_macro2::TokenStream;

use super::outline::{Outline, plain};
use super::{code, docs};
use linkage_language::model::Sweep;
use linkage_language::syntax::Word;

/// The methods that are called on dimensions although they need an assembly: rustc then points at
/// `assemble`, which has these names as aliases.
fn aliases(outline: &Outline) -> Vec<String> {
    let functions = outline.functions.iter().flat_map(|function| {
        let name = plain(function.name);
        [name.clone(), format!("{name}{}", Sweep::Owned.word())]
    });
    functions.filter(|name| name != "assemble").collect()
}

/// Strings, quoted.
fn quoted(strings: &[String]) -> String {
    let quoted: Vec<String> = strings.iter().map(|one| format!("{one:?}")).collect();
    quoted.join(",")
}

const ASSEMBLE: &str = "\
Closes the loops at the reference inputs in the assembly mode that the start estimates choose, and
computes what depends on the dimensions alone.

# Errors

Says which loop cannot close and by how much it misses, or has no finite solution, or which angle cannot be
followed through the range.";

const ASSEMBLIES: &str = "\
Every real assembly at the reference inputs, each ready to evaluate; the one that the start
estimates choose comes first if it is real. The list is empty if no assembly is.
{}
# Errors

Fails if a dimension is not a finite number, if there are more than 16 groups with two modes, or if the assemblies of a
group without a closed form cannot be listed or followed.";

const ASSEMBLIES_AT: &str = "\
Every real assembly at the given inputs, each ready to evaluate; the one that the start estimates
choose comes first if it is real there.
{}
# Errors

As `assemblies()`.";

const ASSEMBLE_FROM: &str = "\
These dimensions in the assembly of a mechanism with others: it is followed along the straight way from those to these, at
the reference inputs, in steps too small to leave it. Each lane of `T` has a way of its own; it is followed in `f64`, on
real parts, and the assembly has the digits and derivatives of `T` as one from `assemble()` has.

# Errors

`Blocked` where the assembly ends on the way, in one lane at least; what `assemble()` says of these dimensions.";

/// A paragraph about groups that are followed from their estimates.
const FROM_ESTIMATES: &str = "\n\
It is not complete: of groups whose solutions cannot be listed (`STRUCTURE` says which), only the assembly is in it to which \
the start estimates lead.\n";

/// `assemble`, `assemblies`, `assemblies_at`, `assemble_from`.
pub(super) fn items(outline: &Outline) -> TokenStream {
    let [name, assembly] = [outline.name, &outline.assembly].map(code::text);
    let assemble = outline.body_text(match outline.starts.is_empty() {
        true => "__p::assemble(self)",
        false => "__p::assemble_coupled(self)",
    });
    let assemblies = outline.body_text("__p::assemblies(self)");
    let from = outline.body_text("__p::assemble_from(self, __assembly)");
    let list = format!("__p::Result<__p::Vec<{assembly}<T>>, __p::AssemblyError>");
    let from_estimates = match outline.starts.iter().any(|start| start.followed) {
        true => FROM_ESTIMATES,
        false => "",
    };
    let names = outline.inputs.iter().map(|input| code::text(input.name));
    let names: Vec<String> = names.collect();
    let at = match names.is_empty() {
        true => String::new(),
        false => {
            let body = format!("__p::assemblies_at(self, &[{}])", names.join(","));
            let body = outline.body_text(&body);
            let doc = docs::doc_text(&ASSEMBLIES_AT.replace("{}", from_estimates));
            let arguments: String = names.iter().map(|name| format!("{name}: T,")).collect();
            format!("{doc} pub fn assemblies_at(&self, {arguments}) -> {list} {{ {body} }}")
        }
    };
    let aliases = match &aliases(outline)[..] {
        [] => String::new(),
        aliases => format!("#[doc(alias({}))]", quoted(aliases)),
    };
    let assemble_doc = docs::doc_text(ASSEMBLE);
    let assemblies_doc = docs::doc_text(&ASSEMBLIES.replace("{}", from_estimates));
    let from_doc = docs::doc_text(ASSEMBLE_FROM);
    code::tokens(&format!(
        "impl<T: __p::Scalar> {name}<T> {{
            {assemble_doc}
            {aliases}
            pub fn assemble(&self) -> __p::Result<{assembly}<T>, __p::AssemblyError> {{ {assemble} }}
        }}
        __p::if_alloc! {{
            impl<T: __p::Scalar> {name}<T> {{
                {assemblies_doc}
                pub fn assemblies(&self) -> {list} {{ {assemblies} }}
                {at}
                {from_doc}
                pub fn assemble_from(
                    &self,
                    __assembly: &{assembly}<T>,
                ) -> __p::Result<{assembly}<T>, __p::AssemblyError> {{ {from} }}
            }}
        }}"
    ))
}

/// `circuits()`; nothing for a mechanism without groups or with another number of inputs than one.
pub(super) fn circuits(outline: &Outline) -> TokenStream {
    if outline.inputs.len() != 1 {
        return TokenStream::new();
    }
    let [name, assembly] = [outline.name, &outline.assembly].map(code::text);
    let body = outline.body_text("__p::circuits_of(self)");
    let doc = docs::doc_text(CIRCUITS);
    code::tokens(&format!(
        "__p::if_alloc! {{
            impl {name}<__p::f64> {{
                {doc}
                #[inline]
                pub fn circuits(&self)
                    -> __p::Result<__p::Circuits<{assembly}<__p::f64>>, __p::AssemblyError>
                {{
                    {body}
                }}
            }}
        }}"
    ))
}

const CIRCUITS: &str = "\
Every assembly over the range of the input (a turn about the reference where an angle has none): how far each
reaches, its turning points, and where its margin is smallest.

# Errors

As `assemblies()`, if it fails at every position.";
