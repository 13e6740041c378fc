//! A range that runs into a turning point of a triad: two of its assemblies meet there.

use linkage::mechanism;

mechanism! {
    pub struct EyeNeedle {
        unit mm;
        param l12 = 50mm;
        param l23 = 272.5mm;
        param l57 = 261mm;
        input phi = 45deg in 0deg..360deg;
        unknown phi23 = 51deg;
        unknown phi34 = 44deg;
        unknown phi64 = 47deg;
        unknown phi75 = -29deg;
        let p3 = polar(l12, phi) + polar(l23, phi23);
        loop p3 + polar(81mm, phi34) = (195mm, 226mm) + polar(104.5mm, phi64);
        loop p3 + polar(174mm, phi34 + triangle_angle(81mm, 174mm, 104.5mm)) = (46mm, 533mm) + polar(l57, phi75);
    }
}

fn main() {}
