//! A platform on six legs that meet in three points of it: each of these points runs on a circle about the line between the feet of its legs, so that
//! three unknowns remain of nine. All real assemblies against those of a published method, computed with 80 digits.

use linkage::Vector3;
use linkage_interpreted::interpreted;

interpreted! {
    /// The feet lie in a plane.
    pub struct Flat {
        unit mm;
        input leg = 360.5723mm in 356mm..366mm;
        unknown p1 = (157mm, 11mm, 324mm);
        unknown p2 = (-84mm, 101mm, 309mm);
        unknown p3 = (-43mm, -156mm, 296mm);
        loop distance(p1, (300.0mm, -55.0mm, 0.0mm)) = leg;
        loop distance(p1, (290.0mm, 70.0mm, 0.0mm)) = 355.3487mm;
        loop distance(p2, (-95.0mm, 285.0mm, 0.0mm)) = 360.3196mm;
        loop distance(p2, (-205.0mm, 220.0mm, 0.0mm)) = 352.8634mm;
        loop distance(p3, (-190.0mm, -235.0mm, 0.0mm)) = 340.0531mm;
        loop distance(p3, (-85.0mm, -290.0mm, 0.0mm)) = 327.7981mm;
        loop distance(p1, p2) = 258.04844506410031844mm;
        loop distance(p2, p3) = 260.19223662515374903mm;
        loop distance(p3, p1) = 262.39092972128438266mm;
    }
    impl Flat {
        pub fn pose(leg) -> FlatPose { p1, p2, p3, v: velocity(p2), m: margin() }
    }
}

interpreted! {
    /// The feet lie at different heights.
    pub struct Hilly {
        unit mm;
        input leg = 344.4669mm in 339mm..349mm;
        unknown p1 = (157mm, 11mm, 324mm);
        unknown p2 = (-84mm, 101mm, 309mm);
        unknown p3 = (-43mm, -156mm, 296mm);
        loop distance(p1, (300.0mm, -55.0mm, 18.0mm)) = leg;
        loop distance(p1, (290.0mm, 70.0mm, -22.0mm)) = 375.5409mm;
        loop distance(p2, (-95.0mm, 285.0mm, 9.0mm)) = 352.6233mm;
        loop distance(p2, (-205.0mm, 220.0mm, 27.0mm)) = 329.45mm;
        loop distance(p3, (-190.0mm, -235.0mm, -14.0mm)) = 352.3123mm;
        loop distance(p3, (-85.0mm, -290.0mm, 6.0mm)) = 322.3878mm;
        loop distance(p1, p2) = 258.04844506410031844mm;
        loop distance(p2, p3) = 260.19223662515374903mm;
        loop distance(p3, p1) = 262.39092972128438266mm;
    }
    impl Hilly {
        pub fn pose(leg) -> HillyPose { p1, p2, p3, v: velocity(p2), m: margin() }
    }
}

const FLAT: [[[f64; 3]; 3]; 8] = [
    [
        [157.33891256918832, 11.445852747935067, 324.4150833622692],
        [-84.37340910327474, 100.534730139388, 309.33776672971123],
        [-42.72076252576791, -155.96251442192056, 296.13850290381635],
    ],
    [
        [162.30317333849302, 11.842993609479441, 326.4720227829086],
        [-81.10517291954203, 95.00386890537882, 305.8408378448498],
        [38.098222245977425, -1.6717253122249103, 95.7351975976488],
    ],
    [
        [126.78640848541588, 9.00165242123327, 309.69860143252254],
        [4.236551267966029, -49.42058741194251, 90.25071607279173],
        [-55.276835356106055, -179.93319891620246, 307.33276289120516],
    ],
    [
        [-48.29638222944578, -5.004970835955662, 78.75602016389708],
        [-85.44899463245756, 102.35495180415894, 310.45092818377606],
        [-41.49673238693005, -153.6257296114119, 294.89170630347655],
    ],
    [
        [-48.29638222944578, -5.004970835955662, -78.75602016389708],
        [-85.44899463245756, 102.35495180415894, -310.45092818377606],
        [-41.49673238693005, -153.6257296114119, -294.89170630347655],
    ],
    [
        [126.78640848541588, 9.00165242123327, -309.69860143252254],
        [4.236551267966029, -49.42058741194251, -90.25071607279173],
        [
            -55.276835356106055,
            -179.93319891620246,
            -307.33276289120516,
        ],
    ],
    [
        [162.30317333849302, 11.842993609479441, -326.4720227829086],
        [-81.10517291954203, 95.00386890537882, -305.8408378448498],
        [38.098222245977425, -1.6717253122249103, -95.7351975976488],
    ],
    [
        [157.33891256918832, 11.445852747935067, -324.4150833622692],
        [-84.37340910327474, 100.534730139388, -309.33776672971123],
        [-42.72076252576791, -155.96251442192056, -296.13850290381635],
    ],
];

const HILLY: [[[f64; 3]; 3]; 6] = [
    [
        [157.33869623732775, 11.445806297160019, 324.4150003342931],
        [-84.3737011081881, 100.53448483849148, 309.3377218914586],
        [-42.72085412353081, -155.96273190761315, 296.1385499638506],
    ],
    [
        [174.9657071385114, 15.039479041590948, 331.23847493534385],
        [-72.70661962400138, 76.03299265863014, 292.1589425342115],
        [66.95245273128899, -19.8479851556437, 94.66924254396268],
    ],
    [
        [114.61479642833476, 1.1270933010616009, 302.8499971737338],
        [-30.045573079323383, -50.61601821414733, 95.52168771110287],
        [-64.02201902650557, -190.84525310005046, 312.0427324252655],
    ],
    [
        [-38.38982245984046, -83.83110738217711, 75.60677476065665],
        [-67.97149087300743, 65.7096200232288, 283.8169948291142],
        [-65.2110104083069, -192.8525624689201, 312.764836415331],
    ],
    [
        [90.41298800024519, -171.15042136779294, -229.4667840594143],
        [-103.58358714176705, -5.448592242164814, -190.77269332722722],
        [88.37661555128663, -19.065578639623727, -15.65599434197006],
    ],
    [
        [-37.793583338724446, -113.16318575739402, -16.20502994217518],
        [-122.95615200631997, 19.016612311527417, -220.81401772227304],
        [57.30289723525163, -165.45870328229714, -255.10006595013817],
    ],
];

/// Every assembly is one of the known ones, and every known one is there.
fn compare(found: &[[Vector3<f64>; 3]], known: &[[[f64; 3]; 3]]) {
    assert_eq!(found.len(), known.len());
    for known in known {
        let apart = |points: &[Vector3<f64>; 3]| {
            let pairs = points.iter().zip(known);
            pairs
                .map(|(a, b)| (a - Vector3::from(*b)).norm())
                .fold(0.0, f64::max)
        };
        assert!(
            found.iter().any(|points| apart(points) < 1e-11),
            "{known:?}"
        );
    }
}

#[test]
fn all_assemblies_on_feet_in_a_plane_are_found() {
    let group = &Flat::structure().groups[0];
    assert_eq!(group.kind, "3 loops in space");
    assert_eq!(group.loops.len(), 9);
    let all = Flat::default().assemblies().expect("they are listed");
    let points = all.iter().map(|own| own.pose(360.5723));
    compare(
        &points
            .map(|own| [own.p1, own.p2, own.p3])
            .collect::<Vec<_>>(),
        &FLAT,
    );
}

#[test]
fn all_assemblies_on_feet_at_different_heights_are_found() {
    let all = Hilly::default().assemblies().expect("they are listed");
    let points = all.iter().map(|own| own.pose(344.4669));
    compare(
        &points
            .map(|own| [own.p1, own.p2, own.p3])
            .collect::<Vec<_>>(),
        &HILLY,
    );
}

#[test]
fn a_point_on_a_circle_moves_as_its_legs_say() {
    let platform = Flat::default().assemble().expect("it assembles");
    for k in 0..=8 {
        let leg = 360.5723 - 4.0 + f64::from(k);
        let pose = platform.pose(leg);
        let foot = |x, y| Vector3::new(x, y, 0.0);
        super::close((pose.p1 - foot(300.0, -55.0)).norm(), leg, 1e-14);
        super::close((pose.p1 - pose.p2).norm(), 258.048_445_064_100_3, 1e-14);
        let [before, after] = [leg - 1e-4, leg + 1e-4].map(|leg| platform.pose(leg).p2);
        let slope = (after - before) / 2e-4;
        super::close((pose.v - slope).norm(), 0.0, 1e-7);
        assert!(pose.m > 0.0 && pose.m < 1.0);
    }
}
