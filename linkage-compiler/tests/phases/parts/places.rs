//! What is asked of one part costs what it costs alone, wherever the part stands and whatever stands beside it: counted exactly.

use linkage_compiler::ir::CompiledMechanism;
use linkage_compiler::{Checked, check_all};

use super::costs::golden;
use super::{checked, defaults, own, results, unit};

/// An organ of the machine: its mechanism, the input of that as it is declared, and what is asked of it, with `@` for its name.
pub(super) struct Organ {
    pub(super) name: &'static str,
    pub(super) of: &'static str,
    pub(super) text: String,
    pub(super) input: &'static str,
    pub(super) reference: f64,
    pub(super) asked: &'static [&'static str],
    /// Closed forms give the same bits wherever their input comes from.
    pub(super) is_closed: bool,
}

pub(super) fn organs() -> [Organ; 4] {
    [
        Organ {
            name: "rocker",
            of: "CrankRocker",
            text: golden("crank_rocker"),
            input: "phi",
            reference: 30.0,
            asked: &[
                "p: @tracer, v: velocity(@tracer), a: acceleration(@tracer)",
                "psi: @psi, v: velocity(@psi), e: sensitivity(@psi, [@crank, @lift, @pivot_d])",
                "p: @tracer, m: margin()",
                "j: jerk(@tracer), mixed: d(@psi, @crank, @crank)",
            ],
            is_closed: true,
        },
        Organ {
            name: "eye",
            of: "EyeNeedle",
            text: golden("eye_needle"),
            input: "phi",
            reference: 0.0,
            asked: &[
                "p: @p8, v: velocity(@p8)",
                "e: sensitivity(@p8, [@l12, @p7.y])",
                "theta: @phi75, a: acceleration(@phi75)",
            ],
            is_closed: false,
        },
        Organ {
            name: "hook",
            of: "Favorit",
            text: golden("favorit"),
            input: "phi12",
            reference: -90.0,
            asked: &[
                "p: @p10, v: velocity(@p10), a: acceleration(@p10)",
                "e: sensitivity(@p10, [@l12, @l89, @pivot_4.x]), s: @slide",
                "angle: @phi89, turn: velocity(@phi910)",
            ],
            is_closed: true,
        },
        Organ {
            name: "press",
            of: "CamPress",
            text: golden("cam_press"),
            input: "shaft",
            reference: 30.0,
            asked: &[
                "x: @x, v: velocity(@x), j: jerk(@table)",
                "e: sensitivity(@x, [@lift, @lead]), u: @part",
            ],
            is_closed: true,
        },
    ]
}

impl Organ {
    pub(super) fn functions(&self, prefix: &str, input: &str) -> String {
        let functions = self.asked.iter().enumerate().map(|(k, asked)| {
            let asked = asked.replace('@', prefix);
            let name = format!("{}_{k}", self.name);
            format!("pub fn {name}({input}) -> T{name} {{ {asked} }}\n")
        });
        functions.collect()
    }

    /// Its mechanism with what the machine gives to its input, `main` being the input of that.
    pub(super) fn alone(&self, before: &str, given: &str) -> String {
        let start = self.text.find("input ").expect("an input");
        let end = start + self.text[start..].find(';').expect("it ends") + 1;
        let body = self.text.find("impl ").expect("functions");
        let reference = self.reference - 30.0;
        format!(
            "{} {before} input main = {reference}deg in {reference}deg..{}deg; let {} = {given}; {} impl {} {{ {} }}",
            &self.text[..start],
            reference + 360.0,
            self.input,
            &self.text[end..body],
            self.of,
            self.functions("", "main"),
        )
    }
}

fn of_machine(all: &[&Organ], before: &str, given: &str, behind: &str) -> String {
    let mechanisms: String = all.iter().map(|own| own.text.as_str()).collect();
    let parts = all.iter().map(|own| {
        let (name, of, input) = (own.name, own.of, own.input);
        format!("part {name}: {of} {{ {input} = {given} }} {behind};\n")
    });
    let functions = all
        .iter()
        .map(|own| own.functions(&format!("{}.", own.name), "main"));
    format!(
        "{mechanisms} pub struct Machine {{ unit mm; {before} input main = 0deg in 0deg..360deg; {} }} impl Machine {{ {} }}",
        parts.collect::<String>(),
        functions.collect::<String>(),
    )
}

fn compare(organ: &Organ, alone: &CompiledMechanism, machine: &CompiledMechanism, what: &str) {
    for k in 0..organ.asked.len() {
        let function = format!("{}_{k}", organ.name);
        let [here, there] = [machine, alone].map(|unit| own(unit, &function).called.count);
        assert_eq!(here, there, "{function}, {what}");
        if !organ.is_closed {
            continue;
        }
        for step in 0..8 {
            let main = [0.3 + 0.7 * f64::from(step)];
            let [here, there] =
                [machine, alone].map(|unit| results(unit, &function, &defaults(unit), &main));
            // Angles that were led to another reference may differ by whole turns, written in one rounding.
            let same = here.iter().zip(&there).all(|(a, b)| {
                let turns = (a - b) / std::f64::consts::TAU;
                a.to_bits() == b.to_bits()
                    || (turns.round() != 0.0 && (turns - turns.round()).abs() < 1e-14)
            });
            assert!(same, "{function}, {what}: {here:?} {there:?}");
        }
    }
}

/// What the inputs of all parts are given, with what the machine has of its own for it.
const GIVEN: [(&str, &str, &str); 4] = [
    ("main", "", "main"),
    ("a lead", "param ahead = 30deg;", "main + ahead"),
    (
        "backwards",
        "param ahead = 30deg; const base = 20deg;",
        "base - (main - ahead)",
    ),
    ("geared", "param ahead = 30deg;", "2 * main + ahead"),
];

/// Every organ in every place, by every input.
#[test]
fn every_part_costs_what_it_costs_alone_in_every_place() {
    let organs = organs();
    for (what, before, given) in GIVEN {
        let alone: Vec<Vec<Checked>> = organs
            .iter()
            .map(|own| checked(&own.alone(before, given)))
            .collect();
        for first in 0..organs.len() {
            let order: Vec<&Organ> = (0..4).map(|k| &organs[(first + k) % 4]).collect();
            let all = checked(&of_machine(&order, before, given, ""));
            let machine = unit(&all, "Machine");
            for (organ, alone) in organs.iter().zip(&alone) {
                let place = order.iter().position(|own| own.name == organ.name);
                let what = format!("{what}, place {place:?}");
                compare(organ, unit(alone, organ.of), machine, &what);
            }
        }
    }
}

/// Loops of the machine's own stand before the parts, and drive none of them, or all.
#[test]
fn loops_of_the_machine_cost_those_who_ask_for_them() {
    let organs = organs();
    let order: Vec<&Organ> = organs.iter().collect();
    let before = "param lever = 50mm; unknown drag = 34deg; unknown tilt = 91deg;
        loop polar(20mm, main + 60deg) + polar(95mm, drag) = (90mm, 20mm) + polar(lever, tilt);";
    for (what, given) in [("beside", "main + 30deg"), ("before", "tilt - 60deg")] {
        let all = checked(&of_machine(&order, before, given, ""));
        let machine = unit(&all, "Machine");
        for organ in &organs {
            let own = if what == "before" { before } else { "" };
            let mut alone = organ.alone(own, given);
            if what == "before" {
                // There the loop is closed at the machine's reference, too.
                let start = alone.find("input main").expect("an input");
                let end = start + alone[start..].find(';').expect("it ends");
                alone.replace_range(start..end, "input main = 0deg in 0deg..360deg");
            }
            let all = check_all(alone.parse().expect("tokens"));
            let found = all.last().and_then(|own| own.unit.as_ref());
            let alone =
                found.unwrap_or_else(|| panic!("{:#?}", all.last().map(|own| &own.messages)));
            for k in 0..organ.asked.len() {
                let function = format!("{}_{k}", organ.name);
                let [here, there] =
                    [machine, alone].map(|unit| super::own(unit, &function).called.count);
                assert_eq!(here, there, "{function}, loops {what}");
            }
        }
    }
}

/// The frame of a part costs those who ask for points, and them no more than written by hand.
#[test]
fn places_of_parts_cost_what_they_cost_by_hand() {
    let organs = organs();
    let order: Vec<&Organ> = organs.iter().collect();
    let text = of_machine(
        &order,
        "",
        "main + 30deg",
        "at (80mm, 5mm), turned by 10deg",
    );
    let by_hand = [("rocker", "tracer"), ("eye", "p8"), ("hook", "p10")];
    let all = checked(&text);
    let machine = unit(&all, "Machine");
    for organ in &organs {
        let mut alone = organ.alone("", "main + 30deg");
        for (name, point) in by_hand {
            if name == organ.name {
                let start = alone.rfind("impl ").expect("functions");
                let functions = alone.split_off(start);
                let seen = format!("((80mm, 5mm) + rotate({point}, 10deg))");
                alone += &functions.replace(point, &seen);
            }
        }
        let all = checked(&alone);
        let alone = unit(&all, organ.of);
        for k in 0..organ.asked.len() {
            let function = format!("{}_{k}", organ.name);
            let [here, there] =
                [machine, alone].map(|unit| super::own(unit, &function).called.count);
            assert_eq!(here, there, "{function}");
        }
    }
}
