//! Many positions at once: the sweeps of a function over inputs, and over mechanisms.

mod doc_text;
mod rows;

pub(super) use doc_text::about;
use doc_text::summary;
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::docs::doc;
use super::load::Places;
use super::outline::{Function, Outline, plain};
use super::stages::Version;
use super::{assembly_data, attribute, coupled, literal, result_module, stages};
use crate::model::Sweep;
use crate::syntax::Word;

/// The common data of the methods of one function.
struct Sweeps<'a> {
    outline: &'a Outline<'a>,
    function: &'a Function<'a>,
    /// Names of arguments that no input has.
    columns: Ident,
    slices: Ident,
    sets: Ident,
}

/// All sweeps of a function; nothing for one without inputs.
pub(super) fn items(outline: &Outline, function: &Function) -> TokenStream {
    if function.arguments.is_empty() {
        return TokenStream::new();
    }
    let taken = |name: &str| function.arguments.iter().any(|argument| *argument == name);
    let argument = |name: &str| match taken(name) {
        true => format_ident!("__{name}"),
        false => format_ident!("{name}"),
    };
    let sweeps = Sweeps {
        outline,
        function,
        columns: argument("columns"),
        slices: argument("slices"),
        sets: argument("sets"),
    };
    let over_inputs = sweeps.over_inputs();
    let over_sets = (!outline.parameters.is_empty()).then(|| sweeps.over_sets());
    let everywhere = &attribute::split(function.attributes).everywhere;
    let (runtime, assembly) = (&outline.runtime, &outline.assembly);
    let allow = attribute::allow();
    quote! {
        #runtime::if_alloc! {
            #(#everywhere)*
            #allow
            impl<T: #runtime::Scalar> #assembly<T> {
                #over_inputs
                #over_sets
            }
        }
    }
}

impl Sweeps<'_> {
    /// The private method that a sweep into columns and the one that returns them both call: one
    /// loop for both, and a panic names the method that was called.
    fn behind(&self, into: Sweep) -> Ident {
        format_ident!("__{}{}", self.function.name, into.word())
    }

    /// The method as the user calls it.
    fn title(&self, sweep: Sweep) -> String {
        format!("{}{}", plain(self.function.name), sweep.word())
    }

    /// A method. The docs of the assembly describe sweeps once, for all methods.
    fn method(&self, sweep: Sweep, signature: TokenStream, body: TokenStream) -> TokenStream {
        let visibility = self.function.visibility;
        let name = format_ident!("{}{}", self.function.name, sweep.word());
        let name_only = plain(self.function.name);
        let doc = doc(&format!(
            "`{name_only}` {}: see [sweeps](Self#sweeps).",
            summary(sweep)
        ));
        let body = self.outline.body(body);
        quote!(#doc #visibility fn #name #signature { #body })
    }

    fn over_inputs(&self) -> TokenStream {
        let runtime = &self.outline.runtime;
        let arguments = &self.function.arguments;
        let ty = result_module::columns(self.outline, self.function);
        let (columns, slices) = (&self.columns, &self.slices);
        let width = literal::index(self.function.width());
        let inputs = quote!(#(#arguments: &[T]),*);
        let behind = self.behind(Sweep::Into);
        let rows = self.inputs(quote!(__title));
        let fill = self.outline.body(self.with_kernel(|kernel| {
            let given = quote!(&#kernel, &#rows, &mut #columns.0);
            let one = self.one();
            quote!(#runtime::fill_or_call(#given, |__at| #one);)
        }));
        let [owned, into] = [Sweep::Owned, Sweep::Into].map(|sweep| self.title(sweep));
        let sweep = self.method(
            Sweep::Owned,
            quote!((&self, #inputs) -> #ty<T>),
            quote! {
                let mut __columns = ::core::default::Default::default();
                self.#behind(#owned, #(#arguments,)* &mut __columns);
                __columns
            },
        );
        let sweep_into = self.method(
            Sweep::Into,
            quote!((&self, #inputs, #columns: &mut #ty<T>)),
            quote!(self.#behind(#into, #(#arguments,)* #columns);),
        );
        let title = self.title(Sweep::Slices);
        let inputs_slices = self.inputs(quote!(#title));
        let sweep_slices = self.method(
            Sweep::Slices,
            quote!((&self, #inputs, #slices: [&mut [T]; #width])),
            self.with_kernel(
                |kernel| quote!(#runtime::fill_slices(#title, &#kernel, &#inputs_slices, #slices);),
            ),
        );
        let title = self.title(Sweep::ParallelInto);
        let inputs_parallel = self.inputs(quote!(#title));
        let parallel = self.method(
            Sweep::ParallelInto,
            quote! {
                (&self, #inputs, #columns: &mut #ty<T>)
                where T: ::core::marker::Send + ::core::marker::Sync
            },
            self.with_kernel(|kernel| {
                quote!(#runtime::fill_parallel(&#kernel, &#inputs_parallel, &mut #columns.0);)
            }),
        );
        quote! {
            fn #behind(&self, __title: &'static ::core::primitive::str, #inputs, #columns: &mut #ty<T>) { #fill }
            #[must_use]
            #sweep
            #sweep_into
            #sweep_slices
            #runtime::if_rayon! { #parallel }
        }
    }

    /// The result at the position `__at`, by the function as it is called.
    fn one(&self) -> TokenStream {
        let runtime = &self.outline.runtime;
        let arguments = &self.function.arguments;
        quote!(#runtime::as_in_sweeps(self, [#(#runtime::in_row(#arguments, __at)),*]))
    }

    /// A sweep by the kernel over inputs, or by the one that does not rely on the digits of tables.
    fn with_kernel(&self, sweep: impl Fn(TokenStream) -> TokenStream) -> TokenStream {
        let [called, beside] = [Version::Called, Version::Beside].map(|version| {
            let runtime = &self.outline.runtime;
            let stages = stages::name(self.outline, self.function, version);
            let core = assembly_data::core(self.outline, &quote!(self));
            sweep(quote!(#runtime::OverInputs::<_, #stages>::new(#core)))
        });
        match self.function.beside {
            true => quote!(if T::REFINES { #beside } else { #called }),
            false => called,
        }
    }

    /// The kernel over mechanisms and inputs. Its dimensions are not those of tables.
    fn kernel_over_sets(&self) -> TokenStream {
        let Self {
            outline, function, ..
        } = *self;
        let runtime = &outline.runtime;
        let stages = stages::name(outline, function, Version::refining(function));
        let core = assembly_data::core(outline, &quote!(self));
        let dimensions = outline.scalar_fields().len();
        let arguments = Places::of_function(outline, function).width();
        let [dimensions, arguments, row] =
            [dimensions, arguments, dimensions + arguments].map(literal::index);
        quote!(#runtime::OverSets::<_, #stages, #dimensions, #arguments, #row>::new(#core))
    }

    fn over_sets(&self) -> TokenStream {
        let runtime = &self.outline.runtime;
        let mechanism = self.outline.name;
        let arguments = &self.function.arguments;
        let ty = result_module::columns(self.outline, self.function);
        let (columns, sets, kernel) = (&self.columns, &self.sets, self.kernel_over_sets());
        let inputs = quote!(#sets: &[#mechanism<T>], #(#arguments: &[T]),*);
        let follow = !self.function.states.is_empty();
        let behind = self.behind(Sweep::SetsInto);
        let rows = self.sets(quote!(__title));
        let followed = follow.then(|| {
            let followed = coupled::followed(self.outline, self.function);
            quote!(&#followed,)
        });
        let [all, all_parallel] = match follow {
            true => [
                quote!(#runtime::fill_followed),
                quote!(#runtime::fill_followed_parallel),
            ],
            false => [
                quote!(#runtime::fill_results),
                quote!(#runtime::fill_parallel),
            ],
        };
        let fill = quote!(#all(&#kernel, &#rows, #followed &mut #columns.0););
        let fill = self.outline.body(fill);
        let [owned, into] = [Sweep::Sets, Sweep::SetsInto].map(|sweep| self.title(sweep));
        let sweep = self.method(
            Sweep::Sets,
            quote!((&self, #inputs) -> #ty<T>),
            quote! {
                let mut __columns = ::core::default::Default::default();
                self.#behind(#owned, #sets, #(#arguments,)* &mut __columns);
                __columns
            },
        );
        let sweep_into = self.method(
            Sweep::SetsInto,
            quote!((&self, #inputs, #columns: &mut #ty<T>)),
            quote!(self.#behind(#into, #sets, #(#arguments,)* #columns);),
        );
        let title = self.title(Sweep::SetsParallelInto);
        let source = self.sets(quote!(#title));
        let parallel = self.method(
            Sweep::SetsParallelInto,
            quote! {
                (&self, #inputs, #columns: &mut #ty<T>)
                where T: ::core::marker::Send + ::core::marker::Sync
            },
            quote! {
                #all_parallel(&#kernel, &#source, #followed &mut #columns.0);
            },
        );
        quote! {
            fn #behind(&self, __title: &'static ::core::primitive::str, #inputs, #columns: &mut #ty<T>) { #fill }
            #[must_use]
            #sweep
            #sweep_into
            #runtime::if_rayon! { #parallel }
        }
    }
}
