//! One mechanism, one margin: a coupled group measures the same however it is written.

mod groups;
mod triads;

/// What spellings of one mechanism have for margins at a position, all assemblies in order.
#[track_caller]
fn expect_alike(all: &[(&str, Vec<f64>)]) {
    let (first, expected) = &all[0];
    for (name, found) in all {
        let context = || format!("{first}: {expected:?}, {name}: {found:?}");
        assert_eq!(expected.len(), found.len(), "{}", context());
        let pairs = expected.iter().zip(found);
        let alike = pairs.clone().all(|(a, b)| (a - b).abs() < 1e-9);
        assert!(alike, "{}", context());
        assert!(found.iter().all(|x| *x > 0.0 && *x <= 1.0), "{}", context());
    }
}

/// Mechanisms that differ in how they are written: `NAME(phi)` gives the margins of all of their assemblies, in order.
macro_rules! spellings {
    (@one [$($common:tt)*] $name:ident { $($items:tt)* }) => {
        fn $name(phi: f64) -> Vec<f64> {
            linkage_interpreted::interpreted! {
                struct Mechanism {
                    unit mm;
                    $($common)*
                    $($items)*
                }
                impl Mechanism {
                    fn position(phi) -> Position { margin: margin() }
                }
            }
            let found = Mechanism::default().assemblies_at(phi).expect("it is no dead point");
            let mut margins: Vec<f64> = found.iter().map(|one| one.position(phi).margin).collect();
            margins.sort_by(f64::total_cmp);
            margins
        }
    };
    ($common:tt $($name:ident $items:tt)*) => {
        $(crate::spellings! { @one $common $name $items })*
    };
}
use spellings;
