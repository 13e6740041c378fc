//! Types and function blocks of a mechanism.

use std::collections::BTreeSet;
use std::fmt::Write;

use linkage_compiler::ir::{COMPONENTS, Shape};
use linkage_export::{
    Declarations, DeclaredAssembly, FunctionDeclaration, Helpers, MemberDeclaration, Target,
    scalar_paths,
};
use linkage_symbolic::program::{Program, Source};

use crate::names::Text;
use crate::program::{Printed, literal, printed};

/// A mechanism while it is printed.
pub(crate) struct Writer<'a, 'l> {
    pub(crate) declarations: &'a Declarations<'a>,
    pub(crate) assembly: &'a DeclaredAssembly,
    pub(crate) helpers: Helpers<'l>,
}

impl Writer<'_, '_> {
    /// Returns the types of vectors and of the mechanism.
    pub(crate) fn types(&self) -> String {
        let items = &self.declarations.items;
        let types = self.declarations.types.iter().map(|declared| {
            let members = declared.members.iter();
            let members =
                members.map(|name| line(&Text.declared(name, &declared.entry, items), ""));
            structure(
                &items[items.len() - 4 + declared.number],
                &members.collect::<String>(),
            )
        });
        let members = self.declarations.dimensions.iter().map(|dimension| {
            let mut values = dimension.scalars.iter().map(|scalar| scalar.nominal);
            let initial = initial(dimension.member.shape, &mut values);
            member(&dimension.member, &format!(" := {initial}"))
        });
        let mut members: String = members.collect();
        members += &line(
            "miss : LREAL",
            "by how much a loop misses closing, if one does",
        );
        if let Some(last) = self.declarations.unit.slots().checked_sub(1) {
            let prepared = format!("prepared : ARRAY[0..{last}] OF LREAL");
            members += &line(&prepared, "numbers that depend on the dimensions alone");
        }
        types.collect::<String>() + &structure(&self.declarations.name, &members)
    }

    /// Returns the type of the results of a function, and its block.
    pub(crate) fn function(&mut self, function: &FunctionDeclaration) -> String {
        let [result, name] = &function.items[..] else {
            unreachable!("a function has a result and a name")
        };
        let argument = |input| function.argument(input).unwrap_or_default().to_owned();
        let mut program = self.program(&function.function.called.program, &argument);
        let fields = function.fields.iter();
        let targets = fields
            .clone()
            .flat_map(|field| scalar_paths(&field.name, field.shape));
        for (target, value) in targets.zip(&program.results) {
            let _ = writeln!(
                program.statements,
                "    result.{} := {value};",
                path(&target)
            );
        }
        let mut members: String = fields.map(|field| member(field, "")).collect();
        if members.is_empty() {
            members = line("nothing : LREAL", "");
        }
        let arguments = function.arguments.iter();
        let inputs = arguments.map(|argument| line(&argument.declaration, &argument.note));
        let about = [function.function.documentation.trim(), &function.cost].join("\n");
        let block = block(
            [name, &self.declarations.name],
            &inputs.collect::<String>(),
            &format!("result : {result}"),
            program.variables,
            &program.statements,
        );
        structure(result, &members) + &comment(&about) + &block
    }

    /// Prints a program; `input` returns the expression of an input.
    pub(crate) fn program(
        &mut self,
        program: &Program,
        input: &dyn Fn(usize) -> String,
    ) -> Printed {
        let (declarations, assembly) = (self.declarations, self.assembly);
        let load = |source| match source {
            Source::Parameter(index) => format!("m.{}", path(&declarations.scalars[index])),
            Source::Input(index) => input(index),
            Source::Mode(index) => literal(assembly.modes[index]),
            Source::Centre(angle) => literal(assembly.centres[angle]),
            Source::Winding(angle, input) => literal(assembly.windings[angle][input]),
            Source::Prepared(slot) => format!("m.prepared[{slot}]"),
            Source::State(..) | Source::Limit | Source::Carried(_) => {
                unreachable!("there is no coupled group, and whole programs carry nothing")
            }
        };
        printed(program, &mut self.helpers, &declarations.private, &load)
    }
}

/// Returns an expression of a scalar: `e[0, 1].x` for `e[0][1].x`.
pub(crate) fn path(scalar: &str) -> String {
    scalar.replace("][", ", ")
}

/// Returns the initial value of a dimension.
fn initial(shape: &Shape, values: &mut dyn Iterator<Item = f64>) -> String {
    let mut next = || literal(values.next().unwrap_or(f64::NAN));
    match shape {
        Shape::Vector(count) => {
            let axes = COMPONENTS[..*count].iter();
            let components: Vec<String> =
                axes.map(|axis| format!("{axis} := {}", next())).collect();
            format!("({})", components.join(", "))
        }
        Shape::Scalar | Shape::Array(..) | Shape::Frame | Shape::PlaneFrame => next(),
    }
}

/// Returns a type with these members.
fn structure(name: &str, members: &str) -> String {
    format!("TYPE\n{name} : STRUCT\n{members}END_STRUCT;\nEND_TYPE\n\n")
}

/// Returns a member of a type, after the user's documentation of it.
fn member(member: &MemberDeclaration, initial: &str) -> String {
    let declaration = format!("{}{initial}", member.declaration);
    comment(member.documentation) + &line(&declaration, &member.note)
}

/// Returns a declaration with its comment.
fn line(declaration: &str, note: &str) -> String {
    format!("    {declaration}; {}", comment(note))
        .trim_end()
        .to_owned()
        + "\n"
}

/// Returns a function block that reads and changes a mechanism; its variables are declared once.
pub(crate) fn block(
    [name, mechanism]: [&String; 2],
    inputs: &str,
    output: &str,
    variables: Vec<String>,
    statements: &str,
) -> String {
    let mut text = format!("FUNCTION_BLOCK {name}\nVAR_IN_OUT m : {mechanism}; END_VAR\n");
    if !inputs.is_empty() {
        let _ = write!(text, "VAR_INPUT\n{inputs}END_VAR\n");
    }
    let _ = writeln!(text, "VAR_OUTPUT {output}; END_VAR");
    let variables: BTreeSet<String> = variables.into_iter().collect();
    if !variables.is_empty() {
        let variables: Vec<String> = variables.into_iter().collect();
        let _ = writeln!(text, "VAR_TEMP {} : LREAL; END_VAR", variables.join(", "));
    }
    text + statements + "END_FUNCTION_BLOCK\n\n"
}

/// Returns a text as a comment, which its own words do not end; nothing for no text.
pub(crate) fn comment(text: &str) -> String {
    let text = text.replace("*)", "* )").replace("(*", "( *");
    let lines: Vec<&str> = text.trim().lines().map(str::trim).collect();
    match lines.concat().is_empty() {
        true => String::new(),
        false => format!("(* {} *)\n", lines.join("\n   ")),
    }
}
