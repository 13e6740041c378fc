//! Accuracy of the eye-needle drive of a warp-knitting machine: a published analysis, made anew.
//!
//! The drive has six links; its triad is solved as one group. Tolerances are those of the published
//! analysis, which claims a largest error of about 18 um. This program shows which definition of the
//! error gives that figure, what the true limits are, and tolerances that would hold 18 um.

use crate::check::Check;
use linkage::Dimensions;
use linkage::tolerance::{
    Addition, Allocation, AllocationRule, Costs, Distribution, Effects, Extreme, MonteCarlo,
    Requirement, Sizes, ToleranceError, Tolerances, largest,
};
use std::error::Error;
use std::f64::consts::TAU;

include!("../../mechanisms/eye_needle.rs");

/// The published claim, in mm.
const CLAIM: f64 = 0.018;
/// Mechanisms in a study.
const SAMPLES: usize = 50_000;

type Outcome = Result<(), Box<dyn Error>>;
type Linkage = EyeNeedleAssembly;
type Given = Tolerances<13>;
type Error2 = Effects<13, 2>;

#[test]
fn known_answers_are_met() -> Outcome {
    let mut check = Check::default();
    let mechanism = EyeNeedle::default();
    let linkage = mechanism.assemble()?;
    let tolerances = Tolerances::complete(&mechanism.parameters())?;
    println!("Tolerances:\n{tolerances}");

    definitions(&mut check, &linkage, &tolerances)?;
    let worst = over_cycle(|phi| tolerances.effects(&linkage.accuracy(phi).e).worst_modulus())?;
    contributions(&linkage, &tolerances, worst.at);
    allocations(&mut check, &linkage, &tolerances)?;
    samples(&mut check, &linkage, &tolerances, worst.at)?;
    check.finish()
}

fn over_cycle(figure: impl FnMut(f64) -> f64) -> Result<Extreme, ToleranceError> {
    largest(0.0..TAU, 721, figure)
}

/// The largest error over the cycle by every definition, absolute and from the position at 0 degrees.
fn definitions(check: &mut Check, linkage: &Linkage, tolerances: &Given) -> Outcome {
    type Figure = fn(&Error2) -> f64;
    let rows: [(&str, Figure, f64); 8] = [
        ("algebraic sum, x", |e| e.algebraic_sum()[0].abs(), 17.577),
        ("algebraic sum, y", |e| e.algebraic_sum()[1].abs(), 14.360),
        ("root sum square, x", |e| e.root_sum_square()[0], 29.59),
        ("root sum square, y", |e| e.root_sum_square()[1], 40.82),
        (
            "root sum square, modulus",
            Error2::root_sum_square_modulus,
            50.42,
        ),
        ("worst case, x", |e| e.worst_case()[0], 91.70),
        ("worst case, y", |e| e.worst_case()[1], 97.14),
        ("worst case, modulus", Effects::worst_modulus, 111.42),
    ];
    let start = tolerances.effects(&linkage.accuracy(0.0).e);
    println!("Largest error over the cycle, um, and that of the displacement from 0 degrees:");
    println!(
        "{:<28}{:>10}{:>8}{:>14}{:>8}",
        "definition", "error", "at", "displacement", "at"
    );
    let mut found = Vec::new();
    for (name, figure, _) in rows {
        let here = |phi: f64| tolerances.effects(&linkage.accuracy(phi).e);
        let absolute = over_cycle(|phi| figure(&here(phi)))?;
        let relative = over_cycle(|phi| figure(&here(phi).relative_to(&start)))?;
        let place = |extreme: &Extreme| extreme.at.to_degrees();
        println!(
            "{name:<28}{:>10.3}{:>8.1}{:>14.3}{:>8.1}",
            1e3 * absolute.value,
            place(&absolute),
            1e3 * relative.value,
            place(&relative)
        );
        found.push(absolute);
    }
    println!(
        "The published figure is the algebraic sum of all 13 errors of equal sign, x component:"
    );
    for ((name, _, known), extreme) in rows.iter().zip(&found) {
        check.near(&format!("{name}, um"), 1e3 * extreme.value, *known, 0.02);
    }
    check.near("its angle, degrees", found[0].at.to_degrees(), 51.9, 0.5);
    check.holds(
        "the true limit is six times as large",
        found[7].value > 6.0 * found[0].value,
    );
    Ok(())
}

/// What each parameter contributes where the error is largest.
fn contributions(linkage: &Linkage, tolerances: &Given, phi: f64) {
    println!("\nAt {:.1} degrees, mm:", phi.to_degrees());
    print!("{}", tolerances.effects(&linkage.accuracy(phi).e));
}

/// Tolerances that would really hold the claim.
fn allocations(check: &mut Check, linkage: &Linkage, tolerances: &Given) -> Outcome {
    let present = tolerances.values();
    // The needle's arm turns the needle's point about P7.
    let sizes = Sizes::new(tolerances.parameters())?.lever(EyeNeedle::INDEX_ANGLE_578, 136.8)?;
    // The present tolerances cost 1 each.
    let costs = Costs {
        cost: present,
        exponent: [1.0; 13],
    };
    let rules = [
        ("in proportion", AllocationRule::Proportional(present)),
        ("equal effect", AllocationRule::EqualEffect),
        ("equal tolerance", AllocationRule::EqualTolerance(sizes)),
        ("IT factor", AllocationRule::StandardFactor(sizes)),
        ("IT grade", AllocationRule::StandardGrade(sizes)),
        ("least cost", AllocationRule::LeastCost(costs)),
    ];
    for (addition, title) in [
        (Addition::WorstCase, "No error vector longer than"),
        (
            Addition::Statistical,
            "Root sum square of the error vector not larger than",
        ),
    ] {
        let cycle = (0..720).map(|i| linkage.accuracy(f64::from(i).to_radians() / 2.0).e);
        let requirement = Requirement::new(CLAIM, addition).over(cycle)?;
        let found: Result<Vec<Allocation<13>>, _> = rules
            .iter()
            .map(|(_, rule)| requirement.allocate(tolerances.parameters(), rule))
            .collect();
        let found = found?;
        println!("\n{title} 18 um: tolerances in um (the arm's in arc seconds)");
        print_allocations(tolerances, &rules.map(|(name, _)| name), &found);
        for ((name, _), allocation) in rules.iter().zip(&found) {
            let error = |phi: f64| {
                let effects = allocation.tolerances.effects(&linkage.accuracy(phi).e);
                match addition {
                    Addition::WorstCase => effects.worst_modulus(),
                    Addition::Statistical => effects.root_sum_square_modulus(),
                }
            };
            let error = over_cycle(error)?.value;
            check.holds(
                &format!("{name}: {:.3} um over the whole cycle", 1e3 * error),
                error <= CLAIM * (1.0 + 1e-4),
            );
        }
        let cheapest = &found[5];
        let (cost, least) = (cheapest.cost, cheapest.least_possible_cost);
        let gap = cost
            .zip(least)
            .map_or(f64::NAN, |(cost, least)| cost / least - 1.0);
        check.holds(
            &format!("no tolerances are cheaper by more than {gap:.0e}"),
            gap < 1e-6,
        );
    }
    Ok(())
}

fn print_allocations(present: &Given, names: &[&str], found: &[Allocation<13>]) {
    print!("{:<10}{:>10}", "", "present");
    names.iter().for_each(|name| print!("{name:>17}"));
    println!();
    let shown = |tolerances: &Given, i: usize| {
        let parameter = &tolerances.parameters()[i];
        match parameter.unit {
            "rad" => 3600.0 * parameter.tolerance.to_degrees(),
            _ => 1e3 * parameter.tolerance,
        }
    };
    for (i, parameter) in present.parameters().iter().enumerate() {
        print!("{:<10}{:>10.1}", parameter.name, shown(present, i));
        found
            .iter()
            .for_each(|f| print!("{:>17.2}", shown(&f.tolerances, i)));
        println!();
    }
    // What a tolerance costs: present over new.
    print!("{:<10}{:>10.1}", "cost", 13.0);
    for allocation in found {
        let pairs = present
            .values()
            .into_iter()
            .zip(allocation.tolerances.values());
        print!(
            "{:>17.1}",
            pairs.map(|(present, new)| present / new).sum::<f64>()
        );
    }
    println!();
    if let Some(grade) = found.iter().find_map(|allocation| allocation.grade) {
        println!("The grade is {grade}.");
    }
}

/// Random mechanisms at the position of the largest error.
fn samples(check: &mut Check, linkage: &Linkage, tolerances: &Given, phi: f64) -> Outcome {
    let nominal = linkage.needle(phi).p8;
    let effects = tolerances.effects(&linkage.accuracy(phi).e);
    for distribution in [Distribution::Normal, Distribution::Uniform] {
        println!("\n{SAMPLES} random mechanisms, {distribution:?}:");
        let study = || MonteCarlo::new(SAMPLES).seed(1).distribution(distribution);
        let point = study().run(&EyeNeedle::default(), tolerances, |mechanisms, [x, y]| {
            let rows = linkage.needle_sweep_sets(mechanisms, &[phi]);
            let [px, py] = rows.p8();
            x.copy_from_slice(px);
            y.copy_from_slice(py);
        })?;
        check.holds("all of them can be assembled", point.missing() == 0);
        for (name, found) in ["x", "y"]
            .iter()
            .zip(point.agreement(&effects, nominal.into()))
        {
            println!("{name}, mm:\n{found}");
            check.holds(
                "the linear analysis agrees within 0.5 %",
                found.within(0.005),
            );
            let farthest = found.farthest / found.worst_case;
            check.holds("no sample is beyond the worst case", farthest < 1.01);
        }
        let size = study().run(&EyeNeedle::default(), tolerances, |mechanisms, [size]| {
            let rows = linkage.needle_sweep_sets(mechanisms, &[phi]);
            for (size, row) in size.iter_mut().zip(rows.iter()) {
                *size = 1e3 * (row.p8 - nominal).norm();
            }
        })?;
        println!("length of the error vector, um, with intervals of 95 %:");
        for part in [0.5, 0.95, 0.9973] {
            println!(
                "{:>6.2} %  {}",
                100.0 * part,
                size.percentile(0, part, 0.95)
            );
        }
        let claimed = size.part_within(0, 0.0, 1e3 * CLAIM, 0.95);
        println!("part of the mechanisms within 18 um: {claimed}");
        check.holds(
            "more than a quarter is not within 18 um",
            claimed.high < 0.75,
        );
    }
    Ok(())
}
