//! Dimensions, names, whole items and types handed in by another macro.

macro_rules! slider_crank {
    ($name:ident, $result:ident, $crank:expr, $rod:expr, $offset:expr, $reference:literal, $range:expr, $quantity:ident: $value:expr) => {
        ::linkage::mechanism! {
            pub struct $name {
                unit mm;
                param crank = $crank;
                param rod = $rod +- 10um;
                const offset = $offset;
                input phi = $reference in $range;
                unknown theta = -10deg;
                unknown s = 150mm;
                loop polar(crank, phi) + polar(rod, theta) = (s, offset);
                let doubled = 2 * $offset;
            }

            impl $name {
                pub fn slide(phi) -> $result { s, doubled, $quantity: $value }
            }
        }
    };
}

slider_crank!(Short, ShortSlide, 20mm + 10mm, 120mm, -3mm, 40deg, 0deg..360deg, twice: 2 * crank);

macro_rules! items {
    ($name:ident { $($items:tt)* } $result:ident) => {
        linkage::mechanism! {
            struct $name { $($items)* }
            impl $name { fn all(phi) -> $result { q } }
        }
    };
}

items! { Gears { param ratio = 2; input phi = 0deg; let q = -ratio * phi; } Angles }

macro_rules! described {
    ($(#[$about:meta])* $vis:vis $name:ident, $(#[$field:meta])* $crank:ident, $(#[$method:meta])* $f:ident -> $result:ident, $derived:path) => {
        linkage::mechanism! {
            $(#[$about])*
            #[derive($derived)]
            $vis struct $name {
                unit mm;
                $(#[$field])*
                param $crank = 30mm;
                input phi = 0deg;
                let p = polar($crank, phi);
            }
            impl $name {
                $(#[$method])*
                $vis fn $f(phi) -> $result { p }
            }
        }
    };
}

described! {
    /// A crank with a description.
    #[derive(Debug)]
    #[cfg(all())]
    pub(crate) Crank,
    /// Its length.
    #[doc = concat!("from joint", " to joint")]
    length,
    /// Its end.
    #[inline]
    #[cfg(not(any()))]
    end -> CrankEnd,
    ::core::cmp::PartialOrd
}

fn main() {
    let crank = Crank::default();
    assert!(crank <= Crank::default());
    assert_eq!(crank.assemble().expect("no loop").end(0.0).p.x, 30.0);

    let linkage = Short::default().assemble().expect("it closes");
    let slide = linkage.slide(0.0);
    let expected = 30.0 + (120f64 * 120.0 - 9.0).sqrt();
    assert!((slide.s - expected).abs() < 1e-12);
    // `$offset` is one operand, not `2 * -3mm` by text.
    assert!((slide.doubled + 6.0).abs() < 1e-12);
    assert!((slide.twice - 60.0).abs() < 1e-12);
    let gears = Gears::default().assemble().expect("no loop");
    assert_eq!(gears.all(1.0).q, -2.0);
}
