//! Searches in all assemblies of the first mechanism.

use super::{N, Rocker, RockerAssembly, design, tip};
use linkage::design::{CycleDesign, DesignError, Figure, Highest};

/// From the assembly of the declaration, or from another one.
fn from(assembly: RockerAssembly) -> CycleDesign<'static, Rocker, RockerAssembly, N> {
    let design = CycleDesign::new(
        Rocker::default(),
        |_| Ok(assembly),
        Rocker::assemble_from,
        Rocker::circuits,
    );
    let design = design.expect("it is given").vary_by("crank", 0.1);
    design.vary_by("coupler", 0.1).vary_by("rocker", 0.1)
}

/// The other assembly is the mirror image: its rocker swings below the frame, where the tip is elsewhere. All is found that starting there finds.
#[test]
fn both_assemblies_are_searched() -> Result<(), DesignError> {
    let wish = || Highest(tip()).least();
    let alone = design().want(wish()).starts(3).run_all()?;
    let all = design()
        .want(wish())
        .starts(3)
        .in_all_assemblies()
        .run_all()?;
    let own = Rocker::default().assemble().expect("assembles");
    let circuits = Rocker::default().circuits().expect("assembles");
    let others = circuits.whole().map(|branch| &branch.assembly);
    let mut others = others.filter(|assembly| assembly.modes() != own.modes());
    let (Some(other), None) = (others.next(), others.next()) else {
        panic!("two assemblies");
    };
    let there = from(*other).want(wish()).starts(3).run_all()?;
    assert!((there[0].goal - alone[0].goal).abs() > 1.0);
    assert_eq!(all[0].goal, f64::min(there[0].goal, alone[0].goal));
    let goals = |goal: f64| all.iter().any(|best| best.goal == goal);
    assert!(alone.iter().chain(&there).all(|best| goals(best.goal)));
    assert_eq!(all.len(), alone.len() + there.len());
    let hits: usize = all.iter().map(|best| best.hits).sum();
    assert_eq!(hits, 6);
    let modes = all.iter().map(|best| best.assembly.modes());
    assert!(modes.clone().any(|modes| modes == own.modes()));
    assert!(modes.clone().any(|modes| modes == other.modes()));
    // Begun in the other one, the same are found.
    let back = from(*other)
        .want(wish())
        .starts(3)
        .in_all_assemblies()
        .run_all()?;
    let values = |all: &[linkage::design::BestCycle<Rocker, RockerAssembly>]| {
        let mut goals: Vec<f64> = all.iter().map(|best| best.goal).collect();
        goals.sort_by(f64::total_cmp);
        goals
    };
    assert_eq!(values(&back), values(&all));
    Ok(())
}
