//! The programs of the slider-crank.

use linkage_symbolic::program::{Binary, Instruction, Program, Source, Ternary, Unary, Value};

use linkage_symbolic::count::Count;
use linkage_symbolic::passes::stages::split;

use linkage_compiler::ir::{Body, CompiledMechanism, ContinuousAngle, Field, Function};
use linkage_language::model::Shape;

/// Appends instructions.
#[derive(Default)]
struct Builder(Program);

impl Builder {
    fn push(&mut self, instruction: Instruction) -> Value {
        self.0.push(instruction)
    }

    fn load(&mut self, source: Source) -> Value {
        self.push(Instruction::Load(source))
    }

    fn unary(&mut self, operation: Unary, x: Value) -> Value {
        self.push(Instruction::Unary(operation, x))
    }

    fn binary(&mut self, operation: Binary, a: Value, b: Value) -> Value {
        self.push(Instruction::Binary(operation, a, b))
    }

    fn finish(mut self, outputs: Vec<Value>) -> Program {
        self.0.outputs = outputs;
        self.0
    }

    /// The crank pin.
    fn pin(&mut self) -> [Value; 2] {
        let phi = self.load(Source::Input(0));
        let crank = self.load(Source::Parameter(2));
        let cosine = self.unary(Unary::Cos, phi);
        let sine = self.unary(Unary::Sin, phi);
        [(cosine, 0), (sine, 1)].map(|(direction, component)| {
            let pivot = self.load(Source::Parameter(component));
            let along = self.binary(Binary::Mul, crank, direction);
            self.binary(Binary::Add, pivot, along)
        })
    }

    /// The distance from the pin to the slider, along x.
    fn reach(&mut self, pin_y: Value) -> Value {
        let rod2 = self.load(Source::Prepared(0));
        let mode = self.load(Source::Prepared(1));
        let square = self.binary(Binary::Mul, pin_y, pin_y);
        let rest = self.binary(Binary::Sub, rod2, square);
        let slack = self.unary(Unary::Slack, rod2);
        let one = self.push(Instruction::Constant(1.0));
        let root = self.push(Instruction::Ternary(Ternary::GuardedSqrt, rest, slack, one));
        self.binary(Binary::Mul, mode, root)
    }

    fn directions(&mut self) -> Vec<Value> {
        let [_, y] = self.pin();
        let dx = self.reach(y);
        let down = self.unary(Unary::Neg, y);
        vec![dx, down, Value(2), Value(3)]
    }
}

fn prepare() -> Program {
    let mut builder = Builder::default();
    let rod = builder.load(Source::Parameter(3));
    let mut outputs = vec![builder.binary(Binary::Mul, rod, rod)];
    outputs.push(builder.load(Source::Mode(0)));
    for angle in 0..2 {
        outputs.push(builder.load(Source::Centre(angle)));
        outputs.push(builder.load(Source::Winding(angle, 0)));
    }
    builder.finish(outputs)
}

fn gaps() -> Program {
    let mut builder = Builder::default();
    let [_, y] = builder.pin();
    let height = builder.unary(Unary::Abs, y);
    let rod = builder.load(Source::Parameter(3));
    let gap = builder.binary(Binary::Sub, height, rod);
    builder.finish(vec![gap])
}

fn angles() -> Program {
    let mut builder = Builder::default();
    let outputs = builder.directions();
    builder.finish(outputs)
}

fn path() -> Program {
    let mut builder = Builder::default();
    let [x, y] = builder.pin();
    let dx = builder.reach(y);
    let s = builder.binary(Binary::Add, x, dx);
    builder.finish(vec![x, y, s])
}

fn turning() -> Program {
    let mut builder = Builder::default();
    let directions = builder.directions();
    let mut outputs: Vec<Value> = (0..2)
        .map(|angle| {
            let phi = Value(0);
            let centre = builder.load(Source::Prepared(2 + 2 * angle));
            let winding = builder.load(Source::Prepared(3 + 2 * angle));
            let turned = builder.binary(Binary::Mul, winding, phi);
            let guide = builder.binary(Binary::Add, centre, turned);
            let (cosine, sine) = (directions[2 * angle], directions[2 * angle + 1]);
            builder.push(Instruction::Ternary(
                Ternary::AngleNear,
                sine,
                cosine,
                guide,
            ))
        })
        .collect();
    let factor = builder.push(Instruction::Constant(-1.5));
    for index in 0..4 {
        let entry = outputs[index % 2];
        outputs.push(builder.binary(Binary::Mul, entry, factor));
    }
    builder.finish(outputs)
}

/// A function of the slider-crank.
fn function(name: &str, arguments: Vec<usize>, program: Program, fields: Vec<Field>) -> Function {
    Function {
        name: name.to_owned(),
        documentation: String::new(),
        arguments,
        states: Vec::new(),
        called: Body {
            count: Count::of_program(&program),
            stages: split(&program),
            compares_sines: program.compares_sines(),
            program,
        },
        beside: None,
        settled: None,
        fields,
        columns: Vec::new(),
        sensitivities: None,
    }
}

/// The margin, and the slack of the only group: how far the rod is longer than the pin is high.
fn survey() -> Program {
    let mut out = Builder::default();
    let [_, pin_y] = out.pin();
    let rod2 = out.load(Source::Prepared(0));
    let square = out.binary(Binary::Mul, pin_y, pin_y);
    let slack = out.binary(Binary::Sub, rod2, square);
    let margin = out.binary(Binary::Div, slack, rod2);
    out.finish(vec![margin, slack])
}

/// Every program of the slider-crank.
pub(crate) fn unit() -> CompiledMechanism {
    let field = |name: &str, shape: Shape, unit: &str| Field {
        name: name.to_owned(),
        documentation: String::new(),
        shape,
        unit: unit.to_owned(),
        about: String::new(),
        reaction: None,
        driven_acceleration: None,
    };
    let angle = |unknown, estimate| ContinuousAngle {
        unknown,
        inputs: vec![0],
        estimate,
        phases: Vec::new(),
    };
    let mut fixed = Builder::default();
    let rod2 = fixed.load(Source::Prepared(0));
    let rates = Shape::Array(2, Box::new(Shape::Vector(2)));
    CompiledMechanism {
        prepare: prepare(),
        gaps: gaps(),
        survey: survey(),
        directions: angles(),
        angles: vec![angle(0, 0.0), angle(1, 0.5)],
        functions: vec![
            function(
                "path",
                vec![0],
                path(),
                vec![
                    field("a", Shape::Vector(2), "mm"),
                    field("s", Shape::Scalar, "mm"),
                ],
            ),
            function(
                "modes",
                vec![0],
                turning(),
                vec![
                    field("len", Shape::Scalar, "rad"),
                    field("wheel", Shape::Scalar, "rad"),
                    field("v", rates, "1"),
                ],
            ),
            function(
                "fixed",
                Vec::new(),
                fixed.finish(vec![rod2]),
                vec![field("rod2", Shape::Scalar, "mm^2")],
            ),
        ],
        ..CompiledMechanism::default()
    }
}
