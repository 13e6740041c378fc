//! A unit as C: a struct with all that programs load, and a function for each program.

use std::fmt::Write;

use linkage_compiler::unit::{Body, Column, Unit};
use linkage_symbolic::passes::stages::Stage;
use linkage_symbolic::program::{Instruction, Program, Source};

use crate::fields::{Field, called, fields};
use crate::instruction::{expression, name};

/// A unit as C.
pub(crate) struct Printed<'a> {
    /// The file, but for `#include "linkage.h"` in front.
    pub(crate) text: String,
    /// The functions that take the struct and an array for results, and the program whose results each of them gives.
    pub(crate) functions: Vec<(String, &'a Program)>,
    /// What stands in the struct, number by number.
    pub(crate) layout: Vec<Source>,
}

/// Prints a unit; names begin with `prefix`, which is also that of the struct.
pub(crate) fn print<'a>(prefix: &'a str, unit: &'a Unit) -> Printed<'a> {
    let fields = fields(unit);
    let mut printer = Printer {
        prefix,
        unit,
        text: format!("struct {prefix} {{\n"),
        functions: Vec::new(),
    };
    for Field { declared, note, .. } in &fields {
        let _ = writeln!(printer.text, "    double {declared}; /* {note} */");
    }
    printer.text += "};\n";
    printer.unit();
    Printed {
        text: printer.text,
        functions: printer.functions,
        layout: fields.into_iter().flat_map(|own| own.sources).collect(),
    }
}

struct Printer<'a> {
    prefix: &'a str,
    unit: &'a Unit,
    text: String,
    functions: Vec<(String, &'a Program)>,
}

impl<'a> Printer<'a> {
    /// All fields are named, so that a program that is added is not forgotten here.
    fn unit(&mut self) {
        let Unit {
            prepare,
            gaps,
            directions,
            bearings,
            survey,
            coupled,
            functions,
            length: _,
            parameters: _,
            inputs: _,
            arguments: _,
            unknowns: _,
            angles: _,
            groups: _,
            mobility: _,
            longest: _,
            picture: _,
            surveyed: _,
            surveying: _,
        } = self.unit;
        self.function("prepare", prepare, &[]);
        self.function("gaps", gaps, &[]);
        self.function("directions", directions, &[]);
        self.function("bearings", bearings, &[]);
        self.function("survey", survey, &[]);
        for (number, group) in coupled.iter().enumerate() {
            self.function(&format!("system_{number}"), &group.system, &[]);
            self.function(&format!("correct_{number}"), &group.correct, &[]);
            self.function(&format!("placed_{number}"), &group.placed, &[]);
        }
        for own in functions {
            // Something in front of what the user named keeps it apart from the names above.
            self.body(&format!("call_{}", own.name), &own.called, &own.columns);
            if let Some(beside) = &own.beside {
                self.body(&format!("beside_{}", own.name), beside, &own.columns);
            }
        }
    }

    fn body(&mut self, word: &str, body: &'a Body, columns: &[Column]) {
        self.function(word, &body.program, columns);
        self.staged(word, &body.stages, &body.program);
    }

    fn function(&mut self, word: &str, program: &'a Program, columns: &[Column]) {
        let own = format!("{}_{word}", self.prefix);
        let signature = format!("void {own}(const struct {} *m, double *out)", self.prefix);
        let _ = writeln!(self.text, "\n{signature}\n{{");
        self.values(program);
        for (index, value) in program.outputs.iter().enumerate() {
            let column = columns.get(index);
            let note = column.map_or_else(String::new, |c| format!(" /* {} {} */", c.name, c.unit));
            let _ = writeln!(self.text, "    out[{index}] = {};{note}", name(*value));
        }
        self.text += "}\n";
        self.functions.push((own, program));
    }

    /// A function for each stage, and one that calls them in turn.
    fn staged(&mut self, word: &str, stages: &[Stage], whole: &'a Program) {
        let prefix = self.prefix;
        let mut calls = String::new();
        let mut before = "0".to_owned();
        for (number, stage) in stages.iter().enumerate() {
            let own = format!("{prefix}_stage_{number}_of_{word}");
            let takes = format!("const struct {prefix} *m, const double *carried");
            let gives = "double *next, double *out";
            let _ = writeln!(self.text, "\nstatic void {own}({takes}, {gives})\n{{");
            self.values(&stage.program);
            let (next, results) = stage.program.outputs.split_at(stage.carried);
            for (index, value) in next.iter().enumerate() {
                let _ = writeln!(self.text, "    next[{index}] = {};", name(*value));
            }
            for (index, value) in stage.results.iter().zip(results) {
                let _ = writeln!(self.text, "    out[{index}] = {};", name(*value));
            }
            self.text += "}\n";
            // An array of nothing is not C.
            let (next, width) = (format!("carried_{number}"), stage.carried.max(1));
            let _ = writeln!(calls, "    double {next}[{width}];");
            let _ = writeln!(calls, "    {own}(m, {before}, {next}, out);");
            before = next;
        }
        let own = format!("{prefix}_staged_{word}");
        let signature = format!("void {own}(const struct {prefix} *m, double *out)");
        let _ = writeln!(self.text, "\n{signature}\n{{\n{calls}}}");
        self.functions.push((own, whole));
    }

    fn values(&mut self, program: &Program) {
        for (index, instruction) in program.instructions.iter().enumerate() {
            let note = match instruction {
                Instruction::Load(source) => called(self.unit, *source),
                _ => None,
            };
            let note = note.map_or_else(String::new, |name| format!(" /* {name} */"));
            let value = expression(program, index);
            let _ = writeln!(self.text, "    const double v{index} = {value};{note}");
        }
    }
}
