//! Every rule of simplification does what its name says, and to a number no more than it says.
//!
//! The names are formulas: the left side is built, the right side expected. Then both are computed for random numbers, NaN,
//! infinities, zeros of both signs, subnormal and huge ones among them.

mod common_factors;
mod exact;
mod formula;
mod numbers;

use std::collections::{BTreeMap, BTreeSet};

use linkage_random::Random;
use linkage_symbolic::program::{Binary, Ternary, Unary};
use linkage_symbolic::rules::{self, Assumes, Changes, RewriteRule};
use linkage_symbolic::{Graph, NodeId, evaluate};

use exact::exact;
use formula::{Formula, Operation};
use numbers::{NUMBERS, SPECIAL, Symbols, Values};

/// Random values of the symbols, for each formula and each choice of its numbers.
const ROUNDS: usize = 1000;

/// Half a unit in the last place of 1.
const ROUNDOFF: f64 = f64::EPSILON / 2.0;

type Rewrite = dyn Fn(&Graph, &[NodeId]) -> Option<NodeId>;

/// One rule of an operation's list, whatever the operation.
struct Entry {
    operation: Operation,
    name: &'static str,
    also: &'static [&'static str],
    changes: Changes,
    assumes: Assumes,
    rewrite: Box<Rewrite>,
}

/// The rules of one operation in the order in which they are tried.
struct List {
    entries: Vec<Entry>,
    /// These rules stand before those of constructors, and some want what they make to exist.
    special: bool,
}

fn lists<Op: Copy + 'static, const ARITY: usize>(
    operations: &[Op],
    wrap: fn(Op) -> Operation,
    rules: fn(Op) -> &'static [RewriteRule<Op, ARITY>],
    special: bool,
) -> impl Iterator<Item = List> {
    operations.iter().map(move |&op| {
        let entry = |rule: &'static RewriteRule<Op, ARITY>| Entry {
            operation: wrap(op),
            name: rule.name,
            also: rule.also,
            changes: rule.changes,
            assumes: rule.assumes,
            rewrite: Box::new(move |graph, operands| {
                let operands = operands.try_into().expect("as many operands");
                rule.rewrite(graph, op, operands)
            }),
        };
        let entries = rules(op).iter().map(entry).collect();
        List { entries, special }
    })
}

fn all_lists() -> Vec<List> {
    let (one, two, three) = (Operation::Unary, Operation::Binary, Operation::Ternary);
    lists(Unary::ALL, one, rules::of_unary, false)
        .chain(lists(Binary::ALL, two, rules::of_binary, false))
        .chain(lists(Ternary::ALL, three, rules::of_ternary, false))
        .chain(lists(Binary::ALL, two, rules::of_rates, true))
        .chain(lists(Ternary::ALL, three, rules::of_inlined, true))
        .collect()
}

/// What the random numbers have shown of a rule.
#[derive(Default)]
struct Seen {
    /// A result that changed, as the rule says that it may.
    change: bool,
    /// A result that is another where the assumption does not hold.
    need: bool,
}

#[test]
fn names_are_distinct() {
    for list in all_lists() {
        let names: BTreeSet<_> = list.entries.iter().map(|entry| entry.name).collect();
        assert_eq!(names.len(), list.entries.len(), "{names:?}");
    }
}

#[test]
fn rules_do_what_they_say() {
    let mut seen: BTreeMap<&str, (Changes, Assumes, Seen)> = BTreeMap::new();
    for list in all_lists() {
        for (place, entry) in list.entries.iter().enumerate() {
            // The same numbers for each, however many rules there are.
            let mut random = Random::new(15);
            let (_, _, seen) =
                seen.entry(entry.name)
                    .or_insert((entry.changes, entry.assumes, Seen::default()));
            for text in [entry.name].iter().chain(entry.also) {
                for &numbers in &choices(text) {
                    let case = Case::new(&list, place, text, numbers);
                    case.compare(&mut random, seen);
                }
            }
        }
    }
    // What a rule says is not more than it needs.
    for (name, (changes, assumes, seen)) in seen {
        let changed = changes == Changes::Nothing || seen.change;
        assert!(changed, "{name}: {changes:?} was not seen");
        let needed = assumes == Assumes::Nothing || seen.need;
        assert!(needed, "{name}: nobody needs {assumes:?}");
    }
}

/// What `k` and `m` are.
fn choices(text: &str) -> Vec<[f64; 2]> {
    if !text.contains(['k', 'm']) {
        return vec![NUMBERS[0]];
    }
    let mut choices = NUMBERS.to_vec();
    if text.ends_with("is a number") {
        let pairs = |&k: &f64| SPECIAL.map(|m| [k, m]);
        choices.extend(SPECIAL.iter().flat_map(pairs));
    }
    choices
}

/// A rule's formula with numbers for `k` and `m`.
struct Case<'a> {
    rule: &'a Entry,
    text: &'a str,
    left: Formula,
    /// `None` for a number.
    right: Option<Formula>,
    graph: Graph,
    symbols: Symbols,
    operands: Vec<NodeId>,
    /// What the rule made of the operation.
    simpler: NodeId,
}

impl<'a> Case<'a> {
    /// Sees the rule fire, and no rule before it.
    fn new(list: &'a List, place: usize, text: &'a str, numbers: [f64; 2]) -> Self {
        let rule = &list.entries[place];
        let parse = |text| Formula::parse(text, rule.operation);
        let (left, right) = match text.strip_suffix(" is a number") {
            Some(left) => (parse(left), None),
            None => {
                let (left, right) = text.split_once(" = ").expect("an equation");
                (parse(left), Some(parse(right)))
            }
        };
        let Formula::Of(operation, ref parts) = left else {
            panic!("{text}: not an operation");
        };
        assert_eq!(operation, rule.operation, "{text}");
        let graph = Graph::new();
        let symbols = Symbols::new(&graph, numbers);
        if list.special {
            right.as_ref().map(|right| right.build(&graph, &symbols));
        }
        let operands: Vec<_> = parts.iter().map(|x| x.build(&graph, &symbols)).collect();
        let nodes = graph.len();
        // Numbers that are 0, negative or no numbers have rules of their own before they are folded.
        if NUMBERS.contains(&numbers) {
            for earlier in &list.entries[..place] {
                let fits = (earlier.rewrite)(&graph, &operands).is_some();
                assert!(!fits, "{text}: {} comes first", earlier.name);
            }
            assert_eq!(graph.len(), nodes, "{text}: nodes of rules that do not fit");
        }
        let simpler = (rule.rewrite)(&graph, &operands);
        let simpler = simpler.unwrap_or_else(|| panic!("{text}: does not fire"));
        match &right {
            Some(right) => assert_eq!(simpler, right.build(&graph, &symbols), "{text}"),
            None => assert!(graph.constant_value(simpler).is_some(), "{text}"),
        }
        if !list.special && NUMBERS.contains(&numbers) {
            let made = left.build(&graph, &symbols);
            assert_eq!(made, simpler, "{text}: the constructor");
        }
        Self {
            rule,
            text,
            left,
            right,
            graph,
            symbols,
            operands,
            simpler,
        }
    }

    /// Compares the plain operation with what the rule made of it.
    fn compare(&self, random: &mut Random, seen: &mut Seen) {
        if let (Changes::Roundings(more), Some(right)) = (self.rule.changes, &self.right) {
            let [before, after] = [&self.left, right].map(Formula::roundings);
            // Other ways of writing may be rounded less, as those with a factor 1.
            let is_name = self.text == self.rule.name;
            let as_said = before + more == after || !is_name && before + more > after;
            assert!(as_said, "{}: {before} and {after} roundings", self.text);
        }
        let nodes = self.operands.iter().chain([&self.simpler]);
        let nodes: Vec<_> = nodes.map(|&id| self.graph.ex(id)).collect();
        let rounds = if self.right.is_some() { ROUNDS } else { 1 };
        for _ in 0..rounds {
            let values = Values::new(random, &self.symbols);
            let mut results = evaluate(&nodes, |source| values.of_source(source));
            let simpler = results.pop().expect("the last one");
            let plain = self.rule.operation.apply(&results);
            let is_known = !self.left.has_large_angle(&values);
            if is_known || self.rule.changes == Changes::Nothing {
                self.judge(&values, plain, simpler, seen);
            }
        }
    }

    fn judge(&self, values: &Values, plain: f64, simpler: f64, seen: &mut Seen) {
        let told = || {
            let text = self.text;
            format!("{text} with {values:?}: {plain:e} became {simpler:e}")
        };
        let same = plain.to_bits() == simpler.to_bits() || plain.is_nan() && simpler.is_nan();
        if self.holds(self.rule.assumes, values) {
            seen.change |= !same;
            match self.rule.changes {
                Changes::Nothing => assert!(same, "{}", told()),
                Changes::SignOfZero => assert!(same || plain == simpler, "{}", told()),
                // At a pole.
                Changes::Roundings(_) if !plain.is_finite() => assert!(same, "{}", told()),
                Changes::Roundings(more) => {
                    let exact = exact(&self.left, values);
                    let before = self.left.roundings();
                    for (value, roundings) in [(plain, before), (simpler, before + more)] {
                        let limit = f64::from(roundings) * ROUNDOFF;
                        assert!(exact.error(value) <= limit, "{}, {exact:?}", told());
                    }
                }
            }
        } else if let Some(weaker) = weaker(self.rule.assumes) {
            let close = same || (plain - simpler).abs() <= 1e-9 * plain.abs().max(simpler.abs());
            seen.need |= !close && self.holds(weaker, values);
        }
        let keeps_nan = matches!(self.rule.changes, Changes::Roundings(_));
        if keeps_nan && self.kept().iter().any(|&x| values.of_letter(x).is_nan()) {
            assert!(plain.is_nan() && simpler.is_nan(), "{}", told());
        }
    }

    fn kept(&self) -> BTreeSet<char> {
        self.right
            .as_ref()
            .map(Formula::letters)
            .unwrap_or_default()
    }

    fn holds(&self, assumes: Assumes, values: &Values) -> bool {
        let kept = self.kept();
        let dropped = |is: fn(f64) -> bool| {
            let letters = self.left.letters();
            let mut dropped = letters.difference(&kept);
            dropped.all(|&x| is(values.of_letter(x)))
        };
        let in_range = || {
            let mut sides = [Some(&self.left), self.right.as_ref()]
                .into_iter()
                .flatten();
            sides.all(|side| side.in_range(values).is_some())
        };
        match assumes {
            Assumes::Nothing => true,
            Assumes::Number => dropped(|x| !x.is_nan()),
            Assumes::Finite => dropped(f64::is_finite),
            Assumes::Range => in_range(),
            Assumes::Nonzero => in_range() && dropped(|x| x != 0.0),
        }
    }
}

/// The assumption that an example must keep which shows that a stronger one is needed.
fn weaker(assumes: Assumes) -> Option<Assumes> {
    match assumes {
        Assumes::Nothing => None,
        Assumes::Number => Some(Assumes::Nothing),
        Assumes::Finite => Some(Assumes::Number),
        Assumes::Range => Some(Assumes::Finite),
        Assumes::Nonzero => Some(Assumes::Range),
    }
}
