//! What `assemble()` costs where functions return angles, whose turns are counted, and where they do not:
//! `cargo bench --bench assembly`.

use linkage::mechanism;
use linkage_peers::timing::{Candidate, interleave, only_tested};
use std::hint::black_box;
use std::time::Duration;

/// A crank-rocker; what is asked of it decides.
macro_rules! crank_rocker {
    ($name:ident, $result:ident { $($asked:tt)* }) => {
        mechanism! {
            pub struct $name {
                unit mm;
                param frame = 140mm;
                param crank = 50mm;
                param coupler = 120mm;
                param rocker = 100mm;
                input phi = 30deg in 0deg..360deg;
                unknown theta = 40deg;
                unknown psi = 80deg;
                let pin = polar(crank, phi) + polar(coupler, theta);
                loop pin = (frame, 0) + polar(rocker, psi);
            }
            impl $name {
                pub fn motion(phi) -> $result { $($asked)* }
            }
        }
    };
}

crank_rocker!(Pins, PinsMotion { pin });
crank_rocker!(Angles, AnglesMotion { theta, psi });

mechanism! {
    pub struct SliderCrank {
        unit mm;
        param crank = 40mm;
        param rod = 120mm;
        param offset = 5mm;
        input phi = 30deg in 0deg..360deg;
        unknown theta = -10deg;
        unknown slide = 150mm;
        loop polar(crank, phi) + polar(rod, theta) = (slide, offset);
    }
    impl SliderCrank {
        pub fn motion(phi) -> SliderCrankMotion { theta, slide }
    }
}

mechanism! {
    pub struct Shaper {
        unit mm;
        param pivot = (0mm, -100mm);
        param crank = 40mm;
        input phi = 30deg in 0deg..360deg;
        unknown psi = 70deg;
        unknown slide = 125mm;
        loop polar(crank, phi) = pivot + polar(slide, psi);
    }
    impl Shaper {
        pub fn motion(phi) -> ShaperMotion { psi }
    }
}

mechanism! {
    /// An eye-needle drive, a coupled group, whose angles are followed.
    pub struct EyeNeedle {
        unit mm;
        param l12 = 50mm;
        param l23 = 272.5mm;
        param l34 = 81mm;
        param l45 = 104.5mm;
        param l35 = 174mm;
        param l46 = 104.5mm;
        param l57 = 261mm;
        param p6 = (195mm, 226mm);
        param p7 = (46mm, 533mm);
        input phi = 0deg in 0deg..360deg;
        unknown phi23 = 62deg;
        unknown phi34 = 146deg;
        unknown phi64 = 144deg;
        unknown phi75 = -99deg;
        let p3 = polar(l12, phi) + polar(l23, phi23);
        loop p3 + polar(l34, phi34) = p6 + polar(l46, phi64);
        loop p3 + polar(l35, phi34 + triangle_angle(l34, l35, l45)) = p7 + polar(l57, phi75);
    }
    impl EyeNeedle {
        pub fn motion(phi) -> EyeNeedleMotion { phi75 }
    }
}

/// Calls in one run.
const CALLS: usize = 64;

fn main() {
    let time = Duration::from_millis(if only_tested() { 1 } else { 3000 });
    let mut candidates = Vec::new();
    macro_rules! measure {
        ($name:literal, $nominal:expr, |$one:ident| $call:expr) => {{
            let $one = $nominal;
            candidates.push(Candidate::new($name, CALLS, move || {
                for _ in 0..CALLS {
                    let $one = black_box(&$one);
                    black_box(&$call);
                }
            }));
        }};
    }
    measure!("crank-rocker, points", Pins::default(), |one| one
        .assemble());
    measure!("crank-rocker, two angles", Angles::default(), |one| one
        .assemble());
    let single = Angles::default().cast::<f32>();
    measure!("crank-rocker, two angles, f32", single, |one| one
        .assemble());
    measure!("slider-crank, an angle", SliderCrank::default(), |one| one
        .assemble());
    measure!(
        "crank and slotted lever, an angle",
        Shaper::default(),
        |one| one.assemble()
    );
    measure!("eye-needle drive, an angle", EyeNeedle::default(), |one| {
        one.assemble()
    });
    let from = Angles::default().assemble().expect("it assembles");
    let other = Angles {
        rocker: 103.0,
        ..Angles::default()
    };
    measure!("crank-rocker, two angles: assemble_from", other, |one| one
        .assemble_from(&from));
    measure!(
        "crank-rocker, two angles: circuits",
        Angles::default(),
        |one| one.circuits()
    );
    for times in interleave(candidates, time) {
        println!("{:44} {:10.3} us", times.name, times.spread().median / 1e3);
    }
}
