//! Functions with the names of what a follower has. Where none is generated, the names are free.

use linkage::mechanism;

mechanism! {
    /// Two legs from motors turn a link about a ball joint: two inputs in one group.
    pub struct Ankle {
        unit mm;
        input left = 0deg in -20deg..20deg;
        input right = 0deg in -20deg..20deg;
        unknown pitch = 0deg;
        unknown roll = 0deg;
        let a = turn(turn((-40mm, 30mm, -30mm), (1, 0, 0), roll), (0, 1, 0), pitch);
        let b = turn(turn((-40mm, -30mm, -30mm), (1, 0, 0), roll), (0, 1, 0), pitch);
        loop distance(a, (-40mm, 30mm, 150mm) + turn((0mm, 0mm, -30mm), (0, 1, 0), left)) = 150mm;
        loop distance(b, (-40mm, -30mm, 150mm) + turn((0mm, 0mm, -30mm), (0, 1, 0), right)) = 150mm;
    }
    impl Ankle {
        pub fn follow(left, right) -> Followed { pitch, roll }
        pub fn inputs(left, right) -> Inputs { pitch }
        pub fn follower(left, right) -> Follower { roll }
        pub fn assembly(left, right) -> Whole { a }
    }
}

mechanism! {
    /// Each loop depends on one input.
    pub struct Free {
        unit mm;
        input left = 40deg in 10deg..60deg;
        input right = 40deg in 10deg..60deg;
        unknown a = 90mm;
        unknown b = 90mm;
        loop distance((a, 0mm), polar(30mm, left)) = 70mm;
        loop distance((b, 0mm), polar(30mm, right)) = 70mm;
    }
    impl Free {
        pub fn follow(left, right) -> FreeFollowed { a, b }
        pub fn inputs(left) -> FreeInputs { a }
    }
}

fn main() {}
