//! What machine code must be like, and a table of its size (printed with `--nocapture`).

use linkage::__private::{Function, Sealed, StageData, call_inlined};
use linkage::{Operations, Structure};
use linkage_machine_code::{Findings, Loops, Set, chosen, inspect, sweep};

/// A test of a mechanism: all its functions, their sweeps over inputs and over mechanisms.
macro_rules! check {
    ($test:ident: $mechanism:path, $assembly:path:
     $($function:ident $sweeps:tt $inputs:tt),* $(,)?) => {
        #[test]
        fn $test() {
            let structure = <$mechanism>::STRUCTURE;
            crate::judge::all_listed(structure, &[$(stringify!($function)),*]);
            let mut table = crate::judge::head(stringify!($test));
            $({
                let operations = crate::judge::operations(structure, stringify!($function));
                let [call, own] = check!(@one $assembly, $function $inputs);
                let looked_up = crate::judge::looked_up(structure);
                crate::judge::one(&mut table, stringify!($function), own, operations, false);
                crate::judge::choice(&mut table, stringify!($function), call, operations);
                let sweeps: [*const (); _] = check!(@sweeps $mechanism, $assembly, $sweeps $inputs);
                for entry in sweeps {
                    crate::judge::clones(&mut table, stringify!($function), entry, operations, looked_up);
                }
            })*
            println!("{table}");
        }
    };
    (@one $assembly:path, $function:ident ($($input:ident),*)) => {{
        #[inline(never)]
        fn call(linkage: &$assembly, $($input: f64),*) -> impl Sized {
            linkage.$function($($input),*)
        }
        #[inline(never)]
        fn own(linkage: &$assembly, $($input: f64),*) -> impl Sized {
            crate::judge::of_the_build(linkage, [$($input),*], || linkage.$function($($input),*))
        }
        [call as *const (), own as *const ()]
    }};
    (@sweeps $mechanism:path, $assembly:path, [$sweep:ident $sets:ident] ($($input:ident),*)) => {{
        #[inline(never)]
        fn sweep(linkage: &$assembly, $($input: &[f64]),*) -> impl Sized {
            linkage.$sweep($($input),*)
        }
        #[inline(never)]
        fn sets(linkage: &$assembly, sets: &[$mechanism], $($input: &[f64]),*) -> impl Sized {
            linkage.$sets(sets, $($input),*)
        }
        [sweep as *const (), sets as *const ()]
    }};
    (@sweeps $mechanism:path, $assembly:path, [] ()) => { [] };
}

/// Includes files of the folder `mechanisms` as modules.
#[allow(unused_macros, reason = "not every test looks at them")]
macro_rules! mechanisms {
    ($($name:ident),* $(,)?) => {
        $(
            #[allow(unreachable_pub, reason = "it is public for other programs")]
            mod $name {
                include!(concat!("../../../mechanisms/", stringify!($name), ".rs"));
            }
        )*
    };
}

/// A function's code for the flags of the build. What `like` would return tells which function it is.
#[allow(unsafe_code, reason = "the code is read, but never runs")]
#[inline(always)]
pub(crate) fn of_the_build<
    A,
    C: StageData<f64>,
    S,
    R: Function<f64, C, S, I, N, W>,
    const I: usize,
    const N: usize,
    const W: usize,
>(
    assembly: &A,
    x: [f64; I],
    _like: impl Fn() -> R,
) -> R {
    const {
        assert!(
            size_of::<A>() == size_of::<Sealed<C, S>>(),
            "it has one field"
        )
    };
    // SAFETY: the assembly consists of its data, and this code is read, but never runs.
    let data: &Sealed<C, S> = unsafe { &*core::ptr::from_ref(assembly).cast() };
    call_inlined(data, x)
}

/// Every function of the mechanism must be checked.
pub(crate) fn all_listed(structure: &Structure, names: &[&str]) {
    let functions: Vec<&str> = structure.functions.iter().map(|f| f.name).collect();
    assert_eq!(functions, names);
}

pub(crate) fn operations<'a>(structure: &'a Structure, name: &str) -> &'a Operations {
    let mut functions = structure.functions.iter();
    let function = functions.find(|function| function.name == name);
    &function.expect("it is listed").operations
}

/// True if some group starts from a prepared state: sweeps look it up row by row.
pub(crate) fn looked_up(structure: &Structure) -> bool {
    structure
        .groups
        .iter()
        .any(|group| group.method.starts_with("prepared"))
}

/// Instructions: of a single call, by the flags of the build and for AVX2, then of the sweeps over inputs and over mechanisms, each for three instruction sets.
pub(crate) fn head(title: &str) -> String {
    format!(
        "{title:<24}{:>8}{:>8}{:>10}{:>8}{:>8}{:>10}{:>8}{:>8}",
        "single", "AVX2", "sweep", "AVX2", "AVX-512", "sets", "AVX2", "AVX-512"
    )
}

/// Divisions: those that are planned, and one in each arc tangent.
fn divisions(operations: &Operations) -> usize {
    (operations.div + operations.atan2) as usize
}

/// A call: code for AVX2 is chosen at run time, unless the build has it or there is less to do than a call costs.
pub(crate) fn choice(table: &mut String, name: &str, entry: *const (), operations: &Operations) {
    match chosen(entry) {
        Some(entry) => one(table, name, entry, operations, true),
        None => {
            let few = operations.total() <= 12 && operations.sin_cos == 0;
            assert!(
                few || cfg!(target_feature = "fma"),
                "{name} chooses nothing"
            );
            *table += &format!("{:>8}", "");
        }
    }
}

/// One position at a time: nothing but arithmetic, as much as is planned.
pub(crate) fn one(
    table: &mut String,
    name: &str,
    entry: *const (),
    operations: &Operations,
    may_fuse: bool,
) {
    let found = inspect(entry);
    *table += &match may_fuse {
        false => format!("\n{name:<24}{:>8}", found.instructions),
        true => format!("{:>8}", found.instructions),
    };
    let judgement = format!("{name}: {found:?}, planned: {operations}");
    let Findings {
        instructions,
        branches,
        library,
        calls,
        divisions: divided,
        spare_lanes,
        roots,
        fused,
        strange,
    } = found;
    assert!(branches.is_empty(), "branch in {judgement}");
    assert!(strange.is_empty(), "{judgement}");
    assert!(library.is_empty() && calls == 0, "call in {judgement}");
    // A packed division takes the time of a single one, even if a lane of it repeats another division.
    let planned = divisions(operations);
    assert!(
        planned <= divided && divided <= planned + spare_lanes,
        "divisions in {judgement}"
    );
    assert_eq!(roots, operations.sqrt as usize, "roots in {judgement}");
    let may_fuse = may_fuse || cfg!(target_feature = "fma");
    assert!(fused == 0 || may_fuse, "{judgement}");
    assert!(
        fused > 0 || !may_fuse || operations.sin_cos == 0,
        "{judgement}"
    );
    // Unoptimised code would be many times as long. A choice takes up to seven instructions.
    let Operations {
        sqrt,
        sin_cos,
        atan2,
        other,
        ..
    } = *operations;
    let sum = operations.total() as usize;
    let most = 50 + 3 * sum + (4 * other + 40 * sqrt + 100 * sin_cos + 150 * atan2) as usize;
    assert!((sum / 2..most).contains(&instructions), "{judgement}");
}

/// A sweep on all instruction sets: all arithmetic in loops is packed and as wide as the registers are. A build for a
/// newer processor leaves some sets out.
pub(crate) fn clones(
    table: &mut String,
    name: &str,
    entry: *const (),
    operations: &Operations,
    looked_up: bool,
) {
    if cfg!(target_feature = "avx") {
        return;
    }
    let mut clones = sweep(entry);
    for (set, lanes, width) in [
        (Set::Baseline, 2, 10),
        (Set::Avx2, 4, 8),
        (Set::Avx512, 8, 8),
    ] {
        let Some(loops) = clones.remove(&set) else {
            panic!("no sweep of {name} for {set:?}");
        };
        *table += &format!("{:>width$}", loops.instructions);
        let judgement = format!("{name} for {set:?}: {loops:?}, planned: {operations}");
        assert!(loops.library.is_empty(), "call in {judgement}");
        if looked_up {
            // Beside the rows' look-ups, all arithmetic that is planned.
            let full = loops.packed.get(&lanes).copied().unwrap_or(0);
            let planned = (operations.total() / 2) as usize;
            assert!(full > planned, "little packed arithmetic in {judgement}");
        } else {
            packed(&loops, lanes, &judgement);
        }
        assert_eq!(loops.fused > 0, set != Set::Baseline, "{judgement}");
        assert!(
            set == Set::Baseline || only_repeats(&loops, looked_up),
            "call in {judgement}"
        );
        assert!(
            loops.divisions >= lanes * divisions(operations),
            "{judgement}"
        );
        assert!(
            loops.roots >= lanes * operations.sqrt as usize,
            "{judgement}"
        );
    }
}

/// Arithmetic in loops is packed and fills the registers, but for what is computed once for a block of rows: a fortieth of all lanes
/// may stay empty. (The optimiser takes some product of a constant in halves.)
fn packed(loops: &Loops, lanes: usize, judgement: &str) {
    let rest = loops.packed.iter().filter(|(width, _)| **width < lanes);
    let halves: usize = rest.map(|(width, count)| (lanes - width) * count).sum();
    let empty = halves + lanes * (loops.scalar.len() + loops.moves.len());
    let packed: usize = loops.packed.values().sum();
    assert!(packed > 0, "no packed arithmetic in {judgement}");
    assert!(
        40 * empty < lanes * packed,
        "scalar arithmetic in {judgement}"
    );
    // Those of blocks and loops, but none for each result. The code of the build has those of short sweeps, too.
    let few = loops.jumps <= 20 + packed / 8;
    assert!(lanes == 2 || few, "jumps in {judgement}");
}

/// No call in a loop but the rare one for the rows behind the last, and two that clear a block of states.
fn only_repeats(loops: &Loops, looked_up: bool) -> bool {
    let others = loops
        .calls
        .iter()
        .filter(|name| !name.contains("9arguments9last_rows"));
    loops.strange.is_empty() && others.count() <= 2 * usize::from(looked_up)
}
