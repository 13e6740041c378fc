//! Errors as text.

use core::fmt;
use std::string::String;
use std::vec::Vec;

use super::DesignError;
use linkage_core::format::rounded;

impl fmt::Display for DesignError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Several(errors) => {
                write!(f, "{} mistakes", errors.len())?;
                errors.iter().try_for_each(|error| write!(f, "\n- {error}"))
            }
            Self::NoParameter { name, known } => {
                write!(
                    f,
                    "there is no parameter `{name}`; the mechanism has {}",
                    known.join(", ")
                )
            }
            Self::Bounds { name, low, high } => write!(
                f,
                "the bounds of `{name}` contradict each other: from {} to {}; the lower one comes first, and both are finite",
                rounded(*low),
                rounded(*high)
            ),
            Self::Twice { name } => write!(f, "`{name}` is listed twice; leave one of both"),
            Self::Deviation {
                quantity,
                deviation,
            } => write!(
                f,
                "the standard deviation of `{quantity}` is {deviation}: it must be positive and finite"
            ),
            Self::SomeDeviations { quantities } => write!(
                f,
                "no standard deviations are given for {}, but for others; give them for all, or for none",
                quantities.join(", ")
            ),
            Self::StartOpen { input, open, count } => write!(
                f,
                "the mechanism that the fit begins with does not assemble, or stands at a dead point, for {open} of {count} \
                 readings, the first at input {}; begin with dimensions that are nearer",
                rounded(*input)
            ),
            Self::Unsettled { steps } => write!(
                f,
                "no least sum of squares in {steps} evaluations, which is our limit; give bounds with `vary`, or begin nearer"
            ),
            Self::Part { part, of } => write!(
                f,
                "there is no part {part} of {of}: parts are counted from 0, and there is at least one"
            ),
            Self::OtherProblem => f.write_str(
                "these descents are of another problem: what is wanted, variables, bounds, starts, seed and steps must be the \
                 same for all parts",
            ),
            Self::Repeated => {
                f.write_str("both parts have descents from the same starts: each part of a search is merged once")
            }
            Self::NoPart => f.write_str(
                "these bytes are no part of a search, or some of them are missing or changed; write them again by `to_bytes`",
            ),
            Self::Undivided => f.write_str(
                "a front is not made in parts: each of its searches begins with the result of another one; leave `part` and \
                 `known` out",
            ),
            Self::Nothing { what, objective } => write!(f, "{objective}: {what}"),
            Self::NotFinite { objective, number } => {
                write!(f, "{objective}: {number} is no finite number")
            }
            Self::Count {
                what,
                objective,
                expected,
                found,
            } => {
                write!(
                    f,
                    "{objective}: {found} {what}, where {expected} are needed"
                )
            }
            Self::OutOfRange {
                objective,
                input,
                low,
                high,
            } => write!(
                f,
                "{objective}: the input {} is outside of the mechanism's range from {} to {}; change it, or the range of the input",
                rounded(*input),
                rounded(*low),
                rounded(*high)
            ),
            Self::TooLong {
                objective,
                positions,
                step,
                length,
                range,
            } => write!(
                f,
                "{objective}: {positions} positions every {} take {}, the range is {}; take a shorter step or fewer positions, or widen the range \
                 of the input",
                rounded(*step),
                rounded(*length),
                rounded(*range)
            ),
            Self::NoRoom {
                objective,
                length,
                from,
                to,
            } => write!(
                f,
                "{objective}: an interval of {} does not fit between {} and {}, which are {} apart; take a shorter one, or widen its room",
                rounded(*length),
                rounded(*from),
                rounded(*to),
                rounded(to - from)
            ),
            Self::NoQuantity { function, quantity } => {
                write!(
                    f,
                    "`{function}` has no quantity `{quantity}`; add it to the function's list"
                )
            }
            Self::NoVelocity { function, quantity } => write!(
                f,
                "`{function}` has no derivative of `{quantity}` by the input, which is free; add `v: velocity({quantity})` to the function"
            ),
            Self::NoSensitivity {
                function,
                quantity,
                missing,
            } => write!(
                f,
                "`{function}` has no derivatives of `{quantity}` by {}, which may vary; add `s: sensitivity({quantity})` to the function",
                missing.join(", ")
            ),
            Self::Contradiction {
                relations,
                bounds,
                missed,
            } => {
                let (last, others) = relations
                    .split_last()
                    .map_or(("", &[][..]), |(last, others)| (last, others));
                let with: Vec<&str> = others.iter().chain(bounds).map(String::as_str).collect();
                write!(f, "{last} cannot hold")?;
                if !with.is_empty() {
                    write!(f, " with {}", with.join(", "))?;
                }
                write!(
                    f,
                    ": it is missed by at least {}; widen one of these bounds, or leave one of these relations",
                    rounded(*missed)
                )
            }
            Self::Goals { goals } if goals.is_empty() => {
                f.write_str("no wish is a goal; one is to be least, greatest, longest or narrowest")
            }
            Self::Goals { goals } => write!(
                f,
                "{} goals: {}; keep one, and make conditions of the others with `at_most` or `at_least`",
                goals.len(),
                goals.join(", ")
            ),
            Self::NoStart { objective } => write!(
                f,
                "{objective}: there is none in the mechanism that the search begins with; begin with another one"
            ),
            Self::OutOfReach {
                objective,
                by,
                nearest,
                at_bound,
                equations,
                variables,
                settled,
            } => {
                write!(
                    f,
                    "{objective}: missed by {} in the best mechanism that was found",
                    rounded(*by)
                )?;
                if equations > variables {
                    return write!(
                        f,
                        "; {equations} equations must hold, and what varies is {variables}; make limits of some, or vary more"
                    );
                }
                if !settled {
                    // The search lost its way: wider bounds would make it worse.
                    f.write_str(", where the search did not converge (")?;
                    for (k, (name, value)) in nearest.iter().enumerate() {
                        let comma = if k > 0 { ", " } else { "" };
                        write!(f, "{comma}{name} {}", rounded(*value))?;
                    }
                    return f.write_str("); narrow the bounds, begin with a mechanism that holds the conditions, or take more starts");
                }
                match at_bound.is_empty() {
                    true => f.write_str(", with no parameter at a bound; ask for less, or begin with another mechanism"),
                    false => write!(f, ", with {} at a bound; widen these, or ask for less", at_bound.join(", ")),
                }
            }
            Self::NoValues { parameters } => write!(
                f,
                "no values of the catalogues of {} near the best mechanism between them hold all conditions; offer more values, or ask for less",
                parameters.join(", ")
            ),
            Self::NotWhole(why) => write!(
                f,
                "the mechanism that was found {why}; ask for a margin, `Lowest(margin).at_least(..)`"
            ),
            Self::StartNotWhole(why) => write!(
                f,
                "the mechanism that the search begins with {why}; begin with dimensions that run through the whole range, or narrow the \
                 range of the input"
            ),
            Self::Start(error) => write!(
                f,
                "the mechanism that the search begins with does not assemble: {error}; begin with dimensions that do"
            ),
            Self::Ended {
                refusals,
                count,
                limit,
            } => {
                match limit {
                    Some(limit) => write!(f, "the time limit of {limit:?} ended the search")?,
                    None => f.write_str("the search was cancelled")?,
                }
                let done = refusals.starts;
                match done {
                    0 => write!(f, " before the first of {count} starts was done")?,
                    _ => write!(f, " after {done} of {count} starts; {refusals}")?,
                }
                f.write_str("; give it more time, or fewer starts")
            }
            Self::NotFound(refusals) => write!(
                f,
                "{refusals}; take more starts, wider bounds, less strict conditions, or relations that keep the range, such as Grashof's"
            ),
        }
    }
}
