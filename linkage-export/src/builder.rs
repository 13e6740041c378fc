//! Chooses all names of a mechanism in a target language, and collects its declarations.

use linkage_compiler::ir::{CompiledMechanism, Function, Parameter, Shape, plain};

use crate::angles::AngleTables;
use crate::coupled::CoupledDeclaration;
use crate::declarations::{
    ArgumentDeclaration, Declarations, FunctionDeclaration, InputDeclaration, MemberDeclaration,
    ParameterDeclaration,
};
use crate::names::Names;
use crate::notes::{
    dimension_note, field_note, input_note, length_unit, operations, reference_note,
};
use crate::refusals::refusals;
use crate::renamed::Renamed;
use crate::scalars::{compound_types, scalar_paths};
use crate::target::{Scope, Target};

impl<'a> Declarations<'a> {
    /// The declarations of a mechanism that is called `title` in its own declaration.
    pub fn new<T: Target>(title: &'a str, unit: &'a CompiledMechanism, target: &T) -> Self {
        let mut builder = Builder {
            target,
            unit,
            name: Names::new(target, Scope::Mechanism).take(title),
            renamed: Vec::new(),
        };
        let name = builder.name.clone();
        let usual = target.mechanism_name(title);
        builder.note(format!("the mechanism `{title}`"), &usual, &name);
        let visible = target.names_in(Scope::File, &name, &[]);
        let mut file = Names::new(target, Scope::File).with(&visible);
        let items = |all: &[&str], file: &mut Names<'_, T>| -> Vec<String> {
            let names = all.iter().map(|item| target.item_name(&name, item));
            names.map(|usual| file.take(&usual)).collect()
        };
        let first = items(T::ITEMS, &mut file);
        let functions = unit.functions.iter();
        let functions: Vec<_> = functions
            .map(|function| builder.function(function, &first, &mut file))
            .collect();
        let later = items(T::LATER_ITEMS, &mut file);
        let arguments = functions.iter().flat_map(|function| &function.arguments);
        let arguments = arguments.map(|argument| &argument.name);
        let private = file.unused_beginning(&target.item_name(&name, "own_"), arguments);
        let visible = target.names_in(Scope::Members, &name, &first);
        let mut members = Names::new(target, Scope::Members).with(&visible);
        let parameters = unit.parameters.iter();
        let dimensions: Vec<_> = parameters
            .map(|parameter| builder.dimension(parameter, &first, &mut members))
            .collect();
        let scalars = dimensions.iter().map(|dimension| &dimension.member);
        let scalars = scalars.flat_map(|member| scalar_paths(&member.name, member.shape));
        let fields = functions.iter().flat_map(|function| &function.fields);
        let members = dimensions.iter().map(|dimension| &dimension.member);
        let shapes = members.chain(fields).map(|member| member.shape);
        let inputs = unit.inputs.iter().map(|input| InputDeclaration {
            name: plain(&input.name),
            input,
            note: input_note(input),
        });
        Self {
            unit,
            title,
            documentation: unit.documentation.trim(),
            length: length_unit(unit),
            reference: reference_note(unit),
            inputs: inputs.collect(),
            scalars: scalars.collect(),
            types: compound_types(shapes),
            refusals: refusals(unit),
            angles: AngleTables::new(unit),
            coupled: CoupledDeclaration::all(unit),
            items: first,
            later_items: later,
            renamed: builder.renamed,
            name,
            functions,
            dimensions,
            private,
        }
    }
}

/// Names while they are chosen.
struct Builder<'t, 'a, T> {
    target: &'t T,
    unit: &'a CompiledMechanism,
    /// The name of the mechanism.
    name: String,
    renamed: Vec<Renamed>,
}

impl<'a, T: Target> Builder<'_, 'a, T> {
    /// Notes a name, unless it is the expected one.
    fn note(&mut self, what: String, expected: &str, name: &str) {
        if name != expected {
            self.renamed.push(Renamed {
                what,
                name: name.to_owned(),
                language: T::LANGUAGE,
            });
        }
    }

    fn function(
        &mut self,
        function: &'a Function,
        mechanism_items: &[String],
        file: &mut Names<'_, T>,
    ) -> FunctionDeclaration<'a> {
        let items = self.function_items(function, file);
        let arguments = self.arguments(function, &items, mechanism_items);
        let visible = self
            .target
            .names_in(Scope::Members, &self.name, mechanism_items);
        let mut members = Names::new(self.target, Scope::Members).with(&visible);
        let mut columns = &function.columns[..];
        let mut fields = Vec::new();
        for field in &function.fields {
            let (of_field, others) = columns.split_at(field.shape.width());
            columns = others;
            let usual = &field.name;
            let name = members.take(usual);
            let what = format!("the result `{usual}` of `{}`", function.name);
            self.note(what, usual, &name);
            fields.push(MemberDeclaration {
                declaration: self.target.declared(&name, &field.shape, mechanism_items),
                name,
                documentation: &field.documentation,
                shape: &field.shape,
                note: field_note(field, of_field),
            });
        }
        FunctionDeclaration {
            function,
            items,
            arguments,
            fields,
            cost: operations(&function.called.count),
        }
    }

    fn function_items(&mut self, function: &Function, file: &mut Names<'_, T>) -> Vec<String> {
        let mut items = Vec::new();
        for item in T::FUNCTION_ITEMS {
            if self
                .target
                .has_function_item(item, function.arguments.len())
            {
                let usual = format!("{}{}", function.name, item.ending);
                let usual = self.target.item_name(&self.name, &usual);
                let name = file.take(&usual);
                let what = format!("{} `{}`", item.kind, function.name);
                self.note(what, &usual, &name);
                items.push(name);
            }
        }
        items
    }

    fn arguments(
        &mut self,
        function: &Function,
        items: &[String],
        mechanism_items: &[String],
    ) -> Vec<ArgumentDeclaration> {
        let visible = self.target.names_in(Scope::Function, &self.name, items);
        let mut scope = Names::new(self.target, Scope::Function).with(&visible);
        let mut arguments = Vec::new();
        for &index in &function.arguments {
            let (usual, note) = match index.checked_sub(self.unit.inputs.len()) {
                None => {
                    let input = &self.unit.inputs[index];
                    (&input.name, input_note(input))
                }
                Some(index) => {
                    let argument = &self.unit.arguments[index];
                    (&argument.name, argument.unit.clone())
                }
            };
            let name = scope.take(usual);
            let what = format!("the argument `{usual}` of `{}`", function.name);
            self.note(what, usual, &name);
            let shape = Shape::Scalar;
            arguments.push(ArgumentDeclaration {
                declaration: self.target.declared(&name, &shape, mechanism_items),
                name,
                index,
                note,
            });
        }
        arguments
    }

    fn dimension(
        &mut self,
        parameter: &'a Parameter,
        mechanism_items: &[String],
        members: &mut Names<'_, T>,
    ) -> ParameterDeclaration<'a> {
        // Of a part's parameter: `hook_crank`.
        let usual = parameter.name.replace('.', "_");
        let name = members.take(&usual);
        self.note(format!("the parameter `{}`", parameter.name), &usual, &name);
        ParameterDeclaration {
            member: MemberDeclaration {
                declaration: self
                    .target
                    .declared(&name, &parameter.shape, mechanism_items),
                name,
                documentation: &parameter.documentation,
                shape: &parameter.shape,
                note: dimension_note(&parameter.scalars),
            },
            scalars: &parameter.scalars,
        }
    }
}
