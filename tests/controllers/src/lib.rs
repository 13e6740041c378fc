//! Five mechanisms in single precision, without the standard library and without an allocator, as a controller would have them.
//!
//! The tests compile this package for small processors and read its machine code; the page `docs/controllers.md` shows their
//! figures. Each function here stands for itself, as a call from an interrupt would.
#![no_std]

use linkage::{AssemblyError, mechanism};

mechanism! {
    /// A crank drives a slide.
    pub struct SliderCrank {
        unit mm;
        param crank = 40mm;
        param rod = 150mm;
        param offset = 10mm;
        input phi = 40deg in 0deg..360deg;
        unknown tilt = -6deg;
        unknown ram = 180mm;
        loop polar(crank, phi) + polar(rod, tilt) = (ram, offset);
    }
    impl SliderCrank {
        /// The ram with both derivatives.
        pub fn motion(phi) -> SliderCrankMotion { ram, v: velocity(ram), a: acceleration(ram) }
    }
}

mechanism! {
    /// A four-bar with a coupler point.
    pub struct CrankRocker {
        unit mm;
        param crank = 40mm;
        param coupler = 120mm;
        param rocker = 80mm;
        param frame = 100mm;
        param arm = 60mm;
        input phi = 40deg in 0deg..360deg;
        unknown theta = 20deg;
        unknown psi = 60deg;
        let a = polar(crank, phi);
        loop a + polar(coupler, theta) = (frame, 0) + polar(rocker, psi);
        let tracer = a + polar(arm, theta + 30deg);
    }
    impl CrankRocker {
        /// The coupler point.
        pub fn position(phi) -> CrankRockerPosition { tracer }
        /// The coupler point with both derivatives, and how far the dead point is.
        pub fn motion(phi) -> CrankRockerMotion {
            tracer, v: velocity(tracer), a: acceleration(tracer), margin: margin(),
        }
        /// What errors of the links do to the coupler point.
        pub fn accuracy(phi) -> CrankRockerAccuracy { e: sensitivity(tracer, [crank, coupler, rocker]) }
        /// The rocker's angle.
        pub fn angle(phi) -> CrankRockerAngle { psi }
    }
}

mechanism! {
    /// A crank in a slotted lever, then a rod to the ram of a shaper.
    pub struct QuickReturn {
        unit mm;
        param frame = 300mm;
        param crank = 120mm;
        param lever = 600mm;
        param rod = 200mm;
        param height = 575mm;
        input phi = 90deg in 0deg..360deg;
        unknown along = 420mm;
        unknown psi = 90deg;
        loop (0, frame) + polar(crank, phi) = polar(along, psi);
        unknown tilt = -7deg;
        unknown ram = 200mm;
        loop polar(lever, psi) + polar(rod, tilt) = (ram, height);
    }
    impl QuickReturn {
        /// The ram with both derivatives.
        pub fn motion(phi) -> QuickReturnMotion { ram, v: velocity(ram), a: acceleration(ram) }
    }
}

mechanism! {
    /// A four-bar whose rocker stretches a knee above the ram of a press.
    pub struct TogglePress {
        unit mm;
        param crank = 40mm;
        param coupler = 210mm;
        param rocker = 160mm;
        param pivot = (-200mm, -130mm);
        param knee = 200mm;
        input phi = 30deg in 0deg..360deg;
        unknown theta = -12deg;
        unknown psi = 260deg;
        let top = (0mm, 0mm);
        let joint = top + polar(rocker, psi);
        loop pivot + polar(crank, phi) + polar(coupler, theta) = joint;
        unknown lower = 280deg;
        unknown ram = -355mm;
        loop joint + polar(knee, lower) = (0mm, ram);
    }
    impl TogglePress {
        /// The ram with both derivatives.
        pub fn motion(phi) -> TogglePressMotion { ram, v: velocity(ram), a: acceleration(ram) }
    }
}

mechanism! {
    /// A crank and a rocker about crossed axes, between them a rod with two balls.
    pub struct SpatialCrankRocker {
        unit mm;
        param crank = 30mm;
        param pivot = (110mm, 30mm, -50mm);
        param rocker = 70mm;
        param rod = 130mm;
        input phi = 0deg in 0deg..360deg;
        let a = turn(crank * (0, 1, 0), (1, 0, 0), phi);
        unknown psi = 100deg;
        let b = pivot + turn(rocker * (1, 0, 0), (0, 0, 1), psi);
        loop distance(a, b) = rod;
    }
    impl SpatialCrankRocker {
        /// The rocker's ball with its first derivative.
        pub fn motion(phi) -> SpatialCrankRockerMotion { b, v: velocity(b) }
    }
}

mechanism! {
    /// No linkage: the functions that are called.
    pub struct Functions {
        param slope = 0.5;
        input phi = 10deg in 0deg..40deg;
    }
    impl Functions {
        /// A tangent, and angles from their functions.
        pub fn at(phi) -> FunctionsAt {
            tangent: slope * tan(phi), sine: asin(slope * phi), cosine: acos(slope * phi), ratio: atan(slope * phi),
        }
    }
}

/// One function for each of a mechanism, and one that assembles it.
macro_rules! compiled {
    ($($mechanism:ident $assembly:ident $assemble:ident: $($name:ident $method:ident $result:ident),*;)*) => {
        $(
            /// Assembles the mechanism.
            ///
            /// # Errors
            ///
            /// If the links do not reach each other.
            #[inline(never)]
            pub fn $assemble(dimensions: &$mechanism<f32>) -> Result<$assembly<f32>, AssemblyError> {
                dimensions.assemble()
            }
            $(
                /// The mechanism at one position.
                #[inline(never)]
                pub fn $name(linkage: &$assembly<f32>, phi: f32) -> $result<f32> {
                    linkage.$method(phi)
                }
            )*
        )*
    };
}

compiled! {
    SliderCrank SliderCrankAssembly slider_crank_assemble:
        slider_crank_motion motion SliderCrankMotion;
    CrankRocker CrankRockerAssembly crank_rocker_assemble:
        crank_rocker_position position CrankRockerPosition,
        crank_rocker_motion motion CrankRockerMotion,
        crank_rocker_accuracy accuracy CrankRockerAccuracy,
        crank_rocker_angle angle CrankRockerAngle;
    QuickReturn QuickReturnAssembly quick_return_assemble:
        quick_return_motion motion QuickReturnMotion;
    TogglePress TogglePressAssembly toggle_press_assemble:
        toggle_press_motion motion TogglePressMotion;
    SpatialCrankRocker SpatialCrankRockerAssembly spatial_crank_rocker_assemble:
        spatial_crank_rocker_motion motion SpatialCrankRockerMotion;
    Functions FunctionsAssembly functions_assemble:
        functions_at at FunctionsAt;
}
