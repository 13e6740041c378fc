//! Motion laws for the default dimensions: knots in order, one value where a turn closes, jumps of
//! speed and acceleration.

mod ends;

use linkage_symbolic::Graph;

use crate::algebra::{Names, Nominal, nominal, translate};
use crate::diagnostic::{OriginId, Reporter};
use crate::message_format::MessageFormat;
use crate::model::{Expr, ExprKind, Mechanism, MotionLaw, MotionLawKind, Name, Repeats, Type};

/// A smaller difference, as a share of the size of speeds or accelerations, is rounding.
const ROUNDING: f64 = 1e-9;

/// Reports knots out of order, pieces without a law and values that do not close a turn, and warns
/// of jumps that nobody accepts.
pub(crate) fn check_motion_laws(mechanism: &Mechanism, nominal: &Nominal, reporter: &mut Reporter) {
    let lets = mechanism.lets.iter().map(|item| &item.value);
    let constants = mechanism.constants.iter().map(|constant| &constant.value);
    let loops = mechanism
        .loops
        .iter()
        .flat_map(|equation| [&equation.left, &equation.right]);
    let functions = mechanism
        .evaluators
        .iter()
        .flat_map(|function| &function.quantities);
    let mechanics = mechanism.expressions_of_mechanics().into_iter();
    let all = constants
        .chain(lets)
        .chain(loops)
        .chain(functions.map(|quantity| &quantity.value));
    let all = all.chain(mechanics).flat_map(Expr::parts);
    let courses: Vec<&Expr> = all
        .filter(|part| matches!(part.kind, ExprKind::MotionLaw(_)))
        .collect();
    if courses.is_empty() {
        return;
    }
    // A separate graph: nodes made in another order would change the written form of the
    // mechanism's sums.
    let graph = Graph::new();
    let mut names = Names::new(mechanism, &graph);
    translate::translate_lets(&mut names);
    let mut seen: Vec<OriginId> = Vec::new();
    for expr in courses {
        let ExprKind::MotionLaw(course) = &expr.kind else {
            continue;
        };
        // Slopes have the knots of the motion law that they are the slopes of.
        if seen.contains(&course.knots[0].origin) {
            continue;
        }
        seen.push(course.knots[0].origin);
        let mut number = |expression: &Expr| {
            let scale = translate::internal_per_unit(names.mechanism, &expression.ty);
            nominal::evaluated(&mut names, expression, &nominal.parameters, &[])[0] / scale
        };
        let knots: Vec<At> = course
            .knots
            .iter()
            .map(|knot| At {
                abscissa: number(&knot.abscissa),
                value: number(&knot.value),
            })
            .collect();
        let known = knots
            .iter()
            .all(|knot| knot.abscissa.is_finite() && knot.value.is_finite());
        // Values that move, or that are reported elsewhere as no number, are left to run time.
        if known {
            let words = MessageFormat::new(mechanism);
            Check {
                mechanism,
                nominal,
                course,
                knots,
                words,
            }
            .report(reporter);
        }
    }
}

/// A knot in numbers.
#[derive(Clone, Copy)]
struct At {
    abscissa: f64,
    value: f64,
}

struct Check<'c, 'm> {
    mechanism: &'m Mechanism,
    nominal: &'c Nominal,
    course: &'m MotionLaw,
    knots: Vec<At>,
    words: MessageFormat<'m>,
}

impl Check<'_, '_> {
    fn report(&self, reporter: &mut Reporter) {
        let before = reporter.errors();
        self.order(reporter);
        self.closure(reporter);
        if self.course.kind == MotionLawKind::Laws {
            self.laws(reporter);
        }
        if reporter.errors() == before {
            self.jumps(reporter);
        }
    }

    fn abscissa_text(&self, at: f64) -> String {
        self.words.value(&self.course.argument_type(), &[at])
    }

    fn value(&self, value: f64) -> String {
        self.words.value(&self.course.value_type(), &[value])
    }

    fn order(&self, reporter: &mut Reporter) {
        for (k, pair) in self.knots.windows(2).enumerate() {
            let (first, second) = (pair[0].abscissa, pair[1].abscissa);
            if second > first {
                continue;
            }
            let [before, behind] = [first, second].map(|at| self.abscissa_text(at));
            let fact = match second == first {
                true => format!("two knots stand at {before}"),
                false => {
                    let overlap = self.abscissa_text(first - second);
                    format!(
                        "the knot at {behind} stands behind that at {before}: the pieces overlap by {overlap}"
                    )
                }
            };
            let help = "write knots in the order of their places; each begins the next piece";
            reporter.error_with_help(self.course.knots[k + 1].origin, fact, help);
        }
    }

    /// A course that repeats ends where it begins.
    fn closure(&self, reporter: &mut Reporter) {
        let (first, last) = (
            &self.course.knots[0],
            &self.course.knots[self.knots.len() - 1],
        );
        if self.course.repeats == Repeats::Never || first.value == last.value {
            return;
        }
        let ends = [self.knots[0], self.knots[self.knots.len() - 1]];
        let [from, to] = ends.map(|knot| self.value(knot.value));
        let [begins, closes] = ends.map(|knot| self.abscissa_text(knot.abscissa));
        let fact = match ends[0].value == ends[1].value {
            true => format!(
                "at {closes} it is another expression than at {begins}: for other dimensions it jumps"
            ),
            false => {
                let jump = self.value(ends[0].value - ends[1].value);
                format!(
                    "jumps by {jump}, from {to} at {closes} to {from} at {begins}, where it repeats"
                )
            }
        };
        let help = "write the same value at both ends; of a motion that goes on from turn to turn, add the way of a turn outside";
        reporter.error_with_help(last.origin, fact, help);
    }

    /// A piece without a law rests.
    fn laws(&self, reporter: &mut Reporter) {
        for (k, pair) in self.course.knots.windows(2).enumerate() {
            if pair[1].law.is_some() || pair[0].value == pair[1].value {
                continue;
            }
            let [from, to] = [self.knots[k], self.knots[k + 1]];
            let [begin, end] = [from, to].map(|knot| self.abscissa_text(knot.abscissa));
            let fact = match from.value == to.value {
                true => format!(
                    "no law leads from {begin} to {end}, and their values are different expressions"
                ),
                false => {
                    let [before, behind] = [from, to].map(|knot| self.value(knot.value));
                    format!("no law leads from {before} at {begin} to {behind} at {end}")
                }
            };
            let help = "write a law behind the value, such as `modified_sine`, or `line`; without one the values are the same";
            reporter.error_with_help(pair[1].origin, fact, help);
        }
    }

    /// Warns where speed or acceleration jumps and no `jump` accepts it.
    fn jumps(&self, reporter: &mut Reporter) {
        let rest = [0.0; 2];
        let pieces = self.pieces();
        if pieces.is_empty() {
            return;
        }
        let last = self.knots.len() - 1;
        let repeats = self.course.repeats != Repeats::Never;
        for (k, knot) in self.course.knots.iter().enumerate() {
            let before = match k {
                0 if repeats => continue,
                0 => rest,
                _ => pieces[k - 1][1],
            };
            let behind = match k {
                k if k == last && repeats => pieces[0][0],
                k if k == last => rest,
                _ => pieces[k][0],
            };
            let accepted = knot.may_jump || (k == last && repeats && self.course.knots[0].may_jump);
            if accepted || !self.is_reached(k) {
                continue;
            }
            for (order, name) in ["speed", "acceleration"].into_iter().enumerate() {
                let (from, to) = (before[order], behind[order]);
                if (to - from).abs() <= ROUNDING * self.size(order + 1) {
                    continue;
                }
                // Zero has no sign for a reader.
                let [from, to] = [from, to].map(|value| self.rate(value + 0.0, order + 1));
                let at = self.abscissa_text(self.knots[k].abscissa);
                let fact = format!("the {name} of this course jumps at {at}, from {from} to {to}");
                let help = match order {
                    _ if matches!(self.course.kind, MotionLawKind::Spline(..)) => {
                        "write `clamped, quintic` behind the points, which ends without acceleration, or `jump` behind this one to accept it"
                    }
                    0 => {
                        "lead to rest with a law like `modified_sine`, or write `jump` behind the knot to accept it"
                    }
                    _ => {
                        "`poly345`, `cycloidal`, `modified_sine` and `modified_trapezoid` begin and end without acceleration; or write `jump` behind the knot to accept it"
                    }
                };
                reporter.warning_with_help(knot.origin, fact, help);
                // The acceleration of a speed that jumps is no number anyway.
                break;
            }
        }
    }

    /// Returns true if the argument comes to both sides of a knot; the first and the last one may
    /// be the ends of an input's range.
    fn is_reached(&self, knot: usize) -> bool {
        let at = self.knots[knot].abscissa;
        let Some(Name::Input(input)) = self.course.argument.as_name() else {
            return true;
        };
        let range = self.nominal.ranges.get(input).copied().flatten();
        self.course.repeats != Repeats::Never
            || range.is_none_or(|(low, high)| low < at && at < high)
    }

    /// Returns the approximate size of a derivative.
    fn size(&self, order: usize) -> f64 {
        let pieces = self.knots.windows(2).map(|pair| {
            let width = pair[1].abscissa - pair[0].abscissa;
            (pair[1].value - pair[0].value).abs() / width.powi(order as i32)
        });
        pieces.fold(0.0, f64::max)
    }

    /// A derivative by the argument, with its unit.
    fn rate(&self, rate: f64, order: usize) -> String {
        let per = match self.course.argument_type() {
            Type::Scalar(dimension) if dimension.angle => "rad".to_owned(),
            ty => ty.dimension().map_or(String::new(), |dimension| {
                dimension.unit(self.mechanism.unit).to_string()
            }),
        };
        let per = match (per.as_str(), order) {
            ("", _) => String::new(),
            (_, 1) => format!("/{per}"),
            _ => format!("/{per}^{order}"),
        };
        format!("{}{per}", self.value(rate))
    }
}
