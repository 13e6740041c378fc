//! Sweeps, sets of dimensions and other scalars on coupled groups: the rows of single calls.

use linkage::AssemblyError;
use linkage_random::Random;
use std::f64::consts::TAU;

linkage::mechanism! {
    pub(crate) struct EyeNeedle {
        unit mm;
        param l12 = 50mm;
        param l23 = 272.5mm;
        param l34 = 81mm;
        param l45 = 104.5mm;
        param l35 = 174mm;
        param l46 = 104.5mm;
        param l57 = 261mm;
        param p6 = (195mm, 226mm);
        input phi = 0deg in 0deg..360deg;
        unknown phi23 = 62deg;
        unknown phi34 = 146deg;
        unknown phi64 = 144deg;
        unknown phi75 = -99deg;
        let p3 = polar(l12, phi) + polar(l23, phi23);
        loop p3 + polar(l34, phi34) = p6 + polar(l46, phi64);
        loop p3 + polar(l35, phi34 + triangle_angle(l34, l35, l45)) = (46mm, 533mm) + polar(l57, phi75);
    }

    impl EyeNeedle {
        pub(crate) fn needle(phi) -> Needle { p3, phi75, margin: margin() }
        pub(crate) fn link(phi) -> Link { p3, direction: dir(phi34) }
        pub(crate) fn rates(phi) -> Rates { v: velocity(phi75), a: acceleration(phi75), e: sensitivity(phi75) }
    }
}

fn nominal() -> EyeNeedleAssembly {
    EyeNeedle::default().assemble().expect("it closes")
}

/// Dimensions changed by up to 0.1 %.
fn perturbed(random: &mut Random) -> EyeNeedle {
    let m = EyeNeedle::default();
    let [l12, l23, l34, l45, l35, l46, l57] =
        random.near([m.l12, m.l23, m.l34, m.l45, m.l35, m.l46, m.l57], 1e-3);
    EyeNeedle {
        l12,
        l23,
        l34,
        l45,
        l35,
        l46,
        l57,
        ..m
    }
}

#[track_caller]
fn alike(one: &[f64], two: &[f64], tolerance: f64) {
    let apart = crate::largest(one.iter().zip(two).map(|(a, b)| (a - b) / b.abs().max(1.0)));
    assert!(
        one.len() == two.len() && apart <= tolerance,
        "{one:?}, not {two:?}"
    );
}

fn numbers(needle: &Needle) -> [f64; 4] {
    [needle.p3.x, needle.p3.y, needle.phi75, needle.margin]
}

fn rates(rates: &Rates) -> Vec<f64> {
    [rates.v, rates.a].into_iter().chain(rates.e).collect()
}

/// But for the rounding of sines: look-ups have the instruction set of what follows, too.
#[test]
fn rows_are_those_of_single_calls() {
    let linkage = nominal();
    let mut random = Random::new(41);
    for length in [0, 1, 7, 31, 32, 33, 200] {
        let phi: Vec<f64> = (0..length)
            .map(|_| random.between(-TAU, 2.0 * TAU))
            .collect();
        let (columns, slopes) = (linkage.needle_sweep(&phi), linkage.rates_sweep(&phi));
        for (i, phi) in phi.iter().enumerate() {
            alike(
                &numbers(&columns.get(i)),
                &numbers(&linkage.needle(*phi)),
                1e-14,
            );
            alike(&rates(&slopes.get(i)), &rates(&linkage.rates(*phi)), 1e-14);
        }
    }
}

#[test]
fn sets_are_as_if_assembled_one_by_one() {
    let linkage = nominal();
    let mut random = Random::new(42);
    let mechanisms: Vec<EyeNeedle> = (0..100).map(|_| perturbed(&mut random)).collect();
    let phi: Vec<f64> = mechanisms
        .iter()
        .map(|_| random.between(0.0, TAU))
        .collect();
    let columns = linkage.needle_sweep_sets(&mechanisms, &phi);
    let slopes = linkage.rates_sweep_sets(&mechanisms, &phi);
    for (i, (mechanism, phi)) in mechanisms.iter().zip(&phi).enumerate() {
        let own = mechanism.assemble().expect("it closes");
        alike(
            &numbers(&columns.get(i)),
            &numbers(&own.needle(*phi)),
            4e-15,
        );
        alike(&rates(&slopes.get(i)), &rates(&own.rates(*phi)), 1e-13);
    }
    // One position for all; a mechanism that cannot be assembled; NaN.
    let mut mechanisms = mechanisms;
    mechanisms[17].l46 = 1.0;
    mechanisms[18].l23 = f64::NAN;
    let columns = linkage.needle_sweep_sets(&mechanisms, &[1.2]);
    for (i, row) in columns.iter().enumerate() {
        assert_eq!(
            numbers(&row).iter().all(|x| x.is_nan()),
            [17, 18].contains(&i),
            "row {i}: {row:?}"
        );
    }
}

/// A set far from the mechanism of the table is right or NaN, never another assembly.
#[test]
fn sets_far_from_the_table_are_right_or_nan() {
    let linkage = nominal();
    let mut random = Random::new(43);
    for (part, least) in [(0.001, 40), (0.01, 40), (0.03, 40), (0.1, 30), (0.3, 10)] {
        let (mut right, mut refused) = (0, 0);
        for _ in 0..40 {
            let m = EyeNeedle::default();
            let [l12, l23, l34, l45, l35, l46, l57] =
                random.near([m.l12, m.l23, m.l34, m.l45, m.l35, m.l46, m.l57], part);
            let other = EyeNeedle {
                l12,
                l23,
                l34,
                l45,
                l35,
                l46,
                l57,
                ..m
            };
            let phi = random.between(0.0, TAU);
            let row = numbers(&linkage.needle_sweep_sets(&[other], &[phi]).get(0));
            if row[0].is_nan() {
                refused += 1;
                continue;
            }
            let all = other.assemblies_at(phi).expect("they can be listed");
            let places: Vec<[f64; 4]> = all.iter().map(|a| numbers(&a.needle(phi))).collect();
            let same = |place: &&[f64; 4]| (place[0] - row[0]).hypot(place[1] - row[1]) < 1e-9;
            assert!(
                places.iter().any(|place| same(&place)),
                "{row:?}, not of {places:?}: {other:?}"
            );
            right += 1;
        }
        println!("dimensions changed by up to {part}: {right} right, {refused} NaN");
        assert!(right >= least);
    }
}

#[test]
fn single_precision() {
    let linkage = nominal();
    let single = EyeNeedle::default()
        .cast::<f32>()
        .assemble()
        .expect("it closes");
    for phi in [0.3, 1.1, 4.0, 5.9] {
        let found = single.needle(phi as f32);
        let row = [found.p3.x, found.p3.y, found.phi75, found.margin].map(f64::from);
        alike(&row, &numbers(&linkage.needle(f64::from(phi as f32))), 5e-6);
    }
}

#[test]
fn what_cannot_be_assembled_says_so() {
    let short = EyeNeedle {
        l23: 30.0,
        ..EyeNeedle::default()
    };
    let error = short.assemble().expect_err("the coupler is too short");
    println!("{error}");
    assert!(short.assemblies().expect("they can be listed").is_empty());
    let longer = (12..40).map(|tens| EyeNeedle {
        l12: 10.0 * f64::from(tens),
        ..EyeNeedle::default()
    });
    let error = longer
        .filter_map(|m| m.assemble().err())
        .next()
        .expect("the crank is too long to turn");
    println!("{error}");
    assert!(error.to_string().contains("phi = "), "{error}");
    let nan = EyeNeedle {
        l45: f64::NAN,
        ..EyeNeedle::default()
    };
    let error = nan.assemble().expect_err("not a number");
    println!("{error}");
    assert!(
        matches!(error, AssemblyError::NotFinite { .. }),
        "{error:?}"
    );
}
