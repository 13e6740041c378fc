//! The functions of a generated mechanism, and what each of their results is.

use std::fmt::Write;

use crate::builder::Builder;

/// What a quantity is differentiated by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Variable {
    /// An input of the mechanism, by index.
    Input(usize),
    /// A scalar parameter, by index.
    Parameter(usize),
}

/// One scalar result of a function: a component of a quantity, differentiated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Number of the quantity within the function.
    pub quantity: usize,
    /// Component of a vector; 0 for a scalar.
    pub component: usize,
    /// Differentiated by these, in order.
    pub by: Vec<Variable>,
    /// The expression that was differentiated.
    pub name: String,
}

/// What the results of a function are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Values and margin.
    Position,
    /// Values and derivatives, as the entries say.
    Derivatives,
    /// Differences of the two sides of loops, and their derivatives: all zero.
    Closure,
}

/// A function of the generated `impl` block.
#[derive(Clone, Debug)]
pub struct Function {
    /// Its name.
    pub name: String,
    /// What it returns.
    pub kind: Kind,
    /// Indices of its arguments.
    pub inputs: Vec<usize>,
    /// Names of the fields of its result.
    pub fields: Vec<String>,
    /// One for each scalar result, in order; none for a margin.
    pub entries: Vec<Entry>,
}

struct Quantity {
    name: String,
    components: usize,
}

/// The `impl` block of a mechanism, and its functions.
pub(crate) fn functions(builder: &mut Builder) -> (String, Vec<Function>) {
    let mut text = String::new();
    let mut all = Vec::new();
    for mask in 1..1u32 << builder.inputs.len() {
        let mut quantities: Vec<Quantity> = Vec::new();
        let points = builder
            .points
            .iter()
            .filter(|p| p.inputs == mask)
            .rev()
            .take(2);
        quantities.extend(points.map(|p| Quantity {
            name: p.text.clone(),
            components: 2,
        }));
        let places = builder
            .places
            .iter()
            .filter(|p| p.inputs == mask)
            .rev()
            .take(1);
        quantities.extend(places.map(|p| Quantity {
            name: p.text.clone(),
            components: 3,
        }));
        let unknowns = builder
            .unknowns
            .iter()
            .filter(|u| u.inputs == mask)
            .rev()
            .take(4);
        quantities.extend(unknowns.map(|u| Quantity {
            name: u.name.clone(),
            components: u.value.len(),
        }));
        if quantities.is_empty() {
            continue;
        }
        let inputs: Vec<usize> = (0..builder.inputs.len())
            .filter(|k| mask >> k & 1 == 1)
            .collect();
        let mut writer = Writer {
            builder,
            mask,
            inputs,
            text: &mut text,
            all: &mut all,
        };
        writer.position(&quantities);
        quantities.truncate(4);
        writer.motion(&quantities);
        writer.accuracy(&quantities);
        writer.closure();
    }
    (text, all)
}

struct Writer<'a> {
    builder: &'a mut Builder,
    mask: u32,
    inputs: Vec<usize>,
    text: &'a mut String,
    all: &'a mut Vec<Function>,
}

impl Writer<'_> {
    fn push(&mut self, word: &str, kind: Kind, fields: &[String], entries: Vec<Entry>) {
        let mask = self.mask;
        let arguments: Vec<&str> = self
            .inputs
            .iter()
            .map(|&k| self.builder.inputs[k].name.as_str())
            .collect();
        let name = format!("{}{mask}", word.to_lowercase());
        let _ = writeln!(
            self.text,
            "    pub fn {name}({}) -> {word}{mask} {{\n        {}\n    }}",
            arguments.join(", "),
            fields.join(",\n        ")
        );
        let before_colon = |field: &String| field.split(':').next().map(str::to_owned);
        self.all.push(Function {
            fields: fields.iter().filter_map(before_colon).collect(),
            name,
            kind,
            inputs: self.inputs.clone(),
            entries,
        });
    }

    fn position(&mut self, quantities: &[Quantity]) {
        let mut fields: Vec<String> = quantities.iter().map(|q| q.name.clone()).collect();
        // Without a group of its own, the function would be about the margin of all groups.
        if self.builder.unknowns.iter().any(|u| u.inputs == self.mask) {
            fields.push("margin: margin()".to_owned());
        }
        let entries = entries(quantities, &[vec![]]);
        self.push("Position", Kind::Position, &fields, entries);
    }

    /// Values, first and second derivatives by all inputs; the third one where there is a single input.
    fn motion(&mut self, quantities: &[Quantity]) {
        let inputs: Vec<Variable> = self.inputs.iter().map(|&k| Variable::Input(k)).collect();
        let first = inputs.iter().map(|&x| vec![x]);
        let second = inputs
            .iter()
            .flat_map(|&x| inputs.iter().map(move |&y| vec![x, y]));
        let mut orders: Vec<Vec<Variable>> = first.chain(second).collect();
        let mut words = vec!["velocity", "acceleration"];
        if let [x] = inputs[..] {
            words.push("jerk");
            orders.push(vec![x; 3]);
        }
        let mut fields = Vec::new();
        let mut all = Vec::new();
        for (k, quantity) in quantities.iter().enumerate() {
            let name = &quantity.name;
            fields.push(name.clone());
            fields.extend(
                words
                    .iter()
                    .map(|word| format!("{word}{k}: {word}({name})")),
            );
            all.extend(numbered(k, quantity, &[vec![]]));
            all.extend(numbered(k, quantity, &orders));
        }
        self.push("Motion", Kind::Derivatives, &fields, all);
    }

    /// Derivatives by parameters, alone and mixed.
    fn accuracy(&mut self, quantities: &[Quantity]) {
        let count = self.builder.parameters.len();
        let input = *self.builder.random.pick(&self.inputs);
        let input_name = self.builder.inputs[input].name.clone();
        let mut fields = Vec::new();
        let mut all = Vec::new();
        for (k, quantity) in quantities.iter().enumerate() {
            let name = &quantity.name;
            let p = self.builder.random.below(count);
            let r = (p + 1 + self.builder.random.below(count - 1)) % count;
            let [pn, rn] = [p, r].map(|p| self.builder.parameters[p].0.clone());
            fields.push(name.clone());
            fields.push(format!("e{k}: sensitivity({name}, [{pn}, {rn}])"));
            fields.push(format!("v{k}: d({name}, {input_name})"));
            fields.push(format!("m{k}: d({name}, {input_name}, {pn})"));
            fields.push(format!("w{k}: d({name}, {pn}, {rn})"));
            let [p, r] = [p, r].map(Variable::Parameter);
            let x = Variable::Input(input);
            let orders = [vec![], vec![p], vec![r], vec![x], vec![x, p], vec![p, r]];
            all.extend(numbered(k, quantity, &orders));
        }
        self.push("Accuracy", Kind::Derivatives, &fields, all);
    }

    fn closure(&mut self) {
        let closures = self
            .builder
            .closures
            .iter()
            .filter(|c| c.inputs == self.mask);
        let mut fields = Vec::new();
        for (k, closure) in closures.enumerate() {
            let difference = format!("({}) - ({})", closure.left, closure.right);
            fields.push(format!("r{k}: {difference}"));
            fields.push(format!("v{k}: velocity({difference})"));
            fields.push(format!("a{k}: acceleration({difference})"));
        }
        if !fields.is_empty() {
            self.push("Closure", Kind::Closure, &fields, Vec::new());
        }
    }
}

fn entries(quantities: &[Quantity], orders: &[Vec<Variable>]) -> Vec<Entry> {
    quantities
        .iter()
        .enumerate()
        .flat_map(|(k, quantity)| numbered(k, quantity, orders))
        .collect()
}

fn numbered(quantity: usize, of: &Quantity, orders: &[Vec<Variable>]) -> Vec<Entry> {
    let name = of.name.clone();
    orders
        .iter()
        .flat_map(|by| {
            let name = name.clone();
            (0..of.components).map(move |component| Entry {
                quantity,
                component,
                by: by.clone(),
                name: name.clone(),
            })
        })
        .collect()
}
