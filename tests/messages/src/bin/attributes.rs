//! Attributes and documentation pass through, privacy is the user's.

#![deny(warnings, missing_docs)]

use linkage::mechanism;

mechanism! {
    /// A crank.
    ///
    /// With *two* paragraphs.
    #[derive(PartialOrd)]
    #[must_use = "a mechanism does nothing by itself"]
    #[allow(clippy::large_types_passed_by_value)]
    pub(crate) struct Crank {
        /// Its length.
        #[doc(alias = "radius")]
        param length = 3;
        #[cfg(all())]
        #[allow(unused)]
        param other = 2;
        input phi = 0deg;
        let tip = polar(length, phi);
    }

    impl Crank {
        /// The tip.
        #[derive(PartialOrd)]
        #[inline(never)]
        pub(crate) fn height(phi) -> Height { y: tip.y, }
        #[deprecated = "use `height`"]
        #[cfg(all())]
        pub fn old(phi) -> Old { tip }
        #[cfg(any())]
        pub fn absent(phi) -> Absent { tip }
        fn private(phi) -> Private { tip }
    }
}

/// Not taken by the absent function.
pub struct Absent;

mechanism! {
    #[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
    struct Derived {
        #[allow(dead_code)]
        param a = 3;
        input phi = 0deg;
    }

    impl Derived {
        #[derive(Debug, Clone, PartialOrd, PartialEq)]
        fn angle(phi) -> DerivedAngle { phi }
    }
}

fn main() {
    let crank = Crank::default();
    assert!(
        crank
            < Crank {
                length: 4.0,
                ..crank
            }
    );
    let linkage = crank.assemble().expect("no loop");
    assert!(linkage.height(0.1) < linkage.height(0.2));
    #[allow(deprecated)]
    let tip = linkage.old(0.0).tip;
    assert_eq!(tip, linkage.private(0.0).tip);
    let derived = Derived::default();
    assert_eq!(
        derived.partial_cmp(&derived),
        Some(std::cmp::Ordering::Equal)
    );
    assert!(derived.assemble().expect("no loop").angle(0.1) < DerivedAngle { phi: 0.2 });
    let _ = (Absent, derived.a);
}
