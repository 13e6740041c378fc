//! The items of one mechanism.

use linkage_language::model::{Mechanism, Shape};
use linkage_language::syntax::{FunctionDef, MechanismDef};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::{from_numbers, rust_type, to_numbers};

/// The struct of a mechanism, its assembly and the results of its functions. `all` is the static
/// that has the mechanisms of the text.
pub(crate) fn mechanism(
    definition: &MechanismDef,
    mechanism: &Mechanism,
    all: &Ident,
) -> TokenStream {
    let (name, visibility) = (&definition.name, &definition.visibility);
    let assembly = format_ident!("{name}Assembly");
    let title = definition.title();
    let parameters: Vec<(Ident, Shape)> = mechanism
        .parameters
        .iter()
        .map(|own| (identifier(&own.name), Shape::from_type(&own.ty)))
        .collect();
    let fields = parameters.iter().map(|(name, shape)| {
        let ty = rust_type(shape);
        quote!(pub #name: #ty)
    });
    let values = parameters.iter().map(|(name, shape)| {
        let value = from_numbers(shape);
        quote!(#name: #value)
    });
    let numbers = parameters
        .iter()
        .flat_map(|(name, shape)| to_numbers(shape, &quote!(self.#name)));
    let count = mechanism.scalar_parameters.len();
    let indices = mechanism.scalar_parameters.iter().enumerate();
    let indices = indices.map(|(index, own)| {
        let name = own.name.replace('.', "_").to_uppercase();
        let name = format_ident!("INDEX_{name}");
        quote!(pub const #name: usize = #index;)
    });
    let inputs: Vec<Ident> = mechanism
        .inputs
        .iter()
        .map(|own| identifier(&own.name))
        .collect();
    let methods = methods(&assembly, &inputs);
    let functions = definition.functions.iter().enumerate();
    let functions: Vec<_> = functions
        .map(|(number, function)| self::function(function, number, name, mechanism))
        .collect();
    let (results, calls): (Vec<_>, Vec<_>) = functions.into_iter().unzip();
    quote! {
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[allow(dead_code, missing_docs, unreachable_pub, clippy::all)]
        #visibility struct #name { #(#fields),* }

        #[allow(dead_code, missing_docs, unreachable_pub, clippy::all)]
        impl #name {
            /// The number of scalar parameters.
            pub const SCALARS: usize = #count;
            #(#indices)*

            /// The mechanism of the engine.
            pub fn mechanism() -> &'static ::linkage_engine::Mechanism {
                let mut all = #all.iter();
                all.find(|one| one.name() == #title).expect("it is in the text")
            }

            /// The dimensions, parameter by parameter.
            pub fn numbers(&self) -> Vec<f64> {
                vec![#(#numbers),*]
            }

            #methods
        }

        impl Default for #name {
            fn default() -> Self {
                let numbers = Self::mechanism().dimensions();
                ::linkage::Dimensions::from_values(&numbers.try_into().expect("all of them"))
            }
        }

        impl ::linkage::Dimensions<#count> for #name {
            const PARAMETERS: &'static [::linkage::Parameter] =
                panic!("the engine knows them, and no constant: `parameters()` returns them");

            fn parameters(&self) -> [::linkage::Parameter; #count] {
                let mut parameters = <[_; #count]>::try_from(Self::mechanism().parameters());
                let parameters = parameters.as_mut().expect("all of them");
                for (parameter, value) in parameters.iter_mut().zip(self.numbers()) {
                    parameter.nominal = value;
                }
                *parameters
            }

            fn from_values(values: &[f64; #count]) -> Self {
                let mut numbers = values.iter().copied();
                #[allow(unused_variables, unused_mut)]
                let mut next = || numbers.next().expect("a number for each parameter");
                Self { #(#values),* }
            }

            fn values(&self) -> [f64; #count] {
                self.numbers().try_into().expect("all of them")
            }
        }

        #[derive(Clone, Debug)]
        #[allow(dead_code, missing_docs, unreachable_pub, clippy::all)]
        #visibility struct #assembly(pub ::linkage_engine::Assembly<'static>);

        #[allow(dead_code, missing_docs, unreachable_pub, clippy::all)]
        impl #assembly {
            /// The mode of each group that has two.
            pub fn modes(&self) -> &[::linkage_engine::AssemblyMode] {
                self.0.modes()
            }

            /// Searches the range of the inputs.
            pub fn check_range(&self) -> ::linkage_engine::RangeReport {
                self.0.check_range()
            }

            /// The share of the ranges in which coupled groups are assembled.
            pub fn served(&self) -> f64 {
                self.0.served()
            }

            #(#calls)*
        }

        #(#results)*
    }
}

/// The methods that close the loops, and descriptions.
fn methods(assembly: &Ident, inputs: &[Ident]) -> TokenStream {
    let circuits = (inputs.len() == 1).then(|| {
        quote! {
            /// Every assembly over the range of the input.
            pub fn circuits(
                &self,
            ) -> Result<::linkage_engine::Circuits<#assembly>, ::linkage_engine::AssemblyError> {
                let found = Self::mechanism().circuits(&self.numbers()).expect("it has groups")?;
                let branches = found.branches.into_iter().map(|branch| ::linkage_engine::Branch {
                    assembly: #assembly(branch.assembly),
                    circuit: branch.circuit,
                    ends: branch.ends,
                    closed: branch.closed,
                    margin: branch.margin,
                    at: branch.at,
                    input: branch.input,
                    unknowns: branch.unknowns,
                });
                Ok(::linkage_engine::Circuits {
                    cycle: found.cycle,
                    input: found.input,
                    branches: branches.collect(),
                    meetings: found.meetings,
                    undetermined: found.undetermined,
                })
            }
        }
    });
    quote! {
        /// The assembly that the estimates choose.
        pub fn assemble(&self) -> Result<#assembly, ::linkage_engine::AssemblyError> {
            Self::mechanism().assemble(&self.numbers()).map(#assembly)
        }

        /// All assemblies at the reference.
        pub fn assemblies(&self) -> Result<Vec<#assembly>, ::linkage_engine::AssemblyError> {
            let mechanism = Self::mechanism();
            let all = mechanism.assemblies(&self.numbers(), &mechanism.reference())?;
            Ok(all.into_iter().map(#assembly).collect())
        }

        /// All assemblies at these inputs.
        pub fn assemblies_at(
            &self,
            #(#inputs: f64),*
        ) -> Result<Vec<#assembly>, ::linkage_engine::AssemblyError> {
            let all = Self::mechanism().assemblies(&self.numbers(), &[#(#inputs),*])?;
            Ok(all.into_iter().map(#assembly).collect())
        }

        /// The assembly of other dimensions, followed to these.
        pub fn assemble_from(
            &self,
            from: &#assembly,
        ) -> Result<#assembly, ::linkage_engine::AssemblyError> {
            Self::mechanism().assemble_from(&self.numbers(), &from.0).map(#assembly)
        }

        #circuits

        /// The groups and their solutions.
        pub fn structure() -> &'static ::linkage_engine::Structure {
            Self::mechanism().structure()
        }

        /// The scalar parameters.
        pub fn parameters() -> &'static [::linkage_engine::Parameter] {
            Self::mechanism().parameters()
        }

        /// The inputs.
        pub fn inputs() -> &'static [::linkage_engine::Input] {
            Self::mechanism().inputs()
        }
    }
}

/// The result of a function, and its methods.
fn function(
    definition: &FunctionDef,
    number: usize,
    owner: &Ident,
    mechanism: &Mechanism,
) -> (TokenStream, TokenStream) {
    let (name, result, visibility) = (&definition.name, &definition.result, &definition.visibility);
    let resolved = &mechanism.evaluators[number];
    let fields = definition.quantities.iter().zip(&resolved.quantities);
    let fields: Vec<(&Ident, Shape)> = fields
        .map(|(own, resolved)| (&own.field, Shape::from_type(&resolved.value.ty)))
        .collect();
    let types = fields.iter().map(|(name, shape)| {
        let ty = rust_type(shape);
        quote!(pub #name: #ty)
    });
    let values = fields.iter().map(|(name, shape)| {
        let value = from_numbers(shape);
        quote!(#name: #value)
    });
    let result_type = quote! {
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[allow(dead_code, missing_docs, unreachable_pub, clippy::all)]
        #visibility struct #result { #(#types),* }

        impl #result {
            fn from_numbers(numbers: &[f64]) -> Self {
                let mut numbers = numbers.iter().copied();
                let mut next = || numbers.next().expect("a number for each field");
                Self { #(#values),* }
            }
        }
    };
    let arguments = &definition.inputs;
    let [sweep, sets] = ["sweep", "sweep_sets"].map(|word| format_ident!("{name}_{word}"));
    let calls = quote! {
        #visibility fn #name(&self, #(#arguments: f64),*) -> #result {
            #result::from_numbers(&self.0.call(#number, &[#(#arguments),*]))
        }

        #visibility fn #sweep(&self, #(#arguments: &[f64]),*) -> Vec<#result> {
            use ::linkage_engine::Table;
            let columns = self.0.sweep(#number, &[#(#arguments),*]);
            let width = columns.heading().columns.len();
            let numbers = |row: usize| (0..width).map(|k| columns.column(k)[row]).collect::<Vec<f64>>();
            (0..columns.rows()).map(|row| #result::from_numbers(&numbers(row))).collect()
        }

        #visibility fn #sets(&self, sets: &[#owner], #(#arguments: &[f64]),*) -> Vec<#result> {
            use ::linkage_engine::Table;
            let sets: Vec<Vec<f64>> = sets.iter().map(#owner::numbers).collect();
            let parameters = #owner::parameters().len();
            let parameter = |k: usize| sets.iter().map(|set| set[k]).collect::<Vec<f64>>();
            let slices: Vec<Vec<f64>> = (0..parameters).map(parameter).collect();
            let slices: Vec<&[f64]> = slices.iter().map(Vec::as_slice).collect();
            let columns = self.0.sweep_sets(#number, &slices, &[#(#arguments),*]);
            let width = columns.heading().columns.len();
            let numbers = |row: usize| (0..width).map(|k| columns.column(k)[row]).collect::<Vec<f64>>();
            (0..columns.rows()).map(|row| #result::from_numbers(&numbers(row))).collect()
        }
    };
    (result_type, calls)
}

/// A name as an identifier: `hook_crank` for `hook.crank`.
fn identifier(name: &str) -> Ident {
    let name = name.replace('.', "_");
    match name.strip_prefix("r#") {
        Some(name) => format_ident!("r#{name}"),
        None => format_ident!("{name}"),
    }
}
