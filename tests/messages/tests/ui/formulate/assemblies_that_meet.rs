//! Linkages of Sarrus at a reference where two of their four assemblies meet, their upper links folded upon the lower ones.

use linkage::mechanism;

// The estimates mean those that meet.
mechanism! {
    pub struct Folded {
        unit mm;
        input phi = 60deg;
        unknown first = 230deg;
        unknown second = 70deg;
        unknown third = 230deg;
        const x = (1, 0, 0);
        const z = (0, 0, 1);
        const out = turn(x, z, 70deg);
        const hinge = turn((0, 1, 0), z, 70deg);
        let top = 90mm * x + 70mm * turn(x, (0, -1, 0), phi) + 80mm * turn(x, (0, -1, 0), first);
        loop top - 85mm * x = 5mm * out + 70mm * turn(out, -hinge, second) + 80mm * turn(out, -hinge, third);
    }
}

// They lie between the others.
mechanism! {
    pub struct Between {
        unit mm;
        input phi = 60deg;
        unknown first = 120deg;
        unknown second = 92.2deg;
        unknown third = 92.2deg;
        const x = (1, 0, 0);
        const z = (0, 0, 1);
        const out = turn(x, z, 70deg);
        const hinge = turn((0, 1, 0), z, 70deg);
        let top = 90mm * x + 70mm * turn(x, (0, -1, 0), phi) + 80mm * turn(x, (0, -1, 0), first);
        loop top - 85mm * x = 5mm * out + 70mm * turn(out, -hinge, second) + 80mm * turn(out, -hinge, third);
    }
}

// They are far from all.
mechanism! {
    pub struct Far {
        unit mm;
        input phi = 60deg;
        unknown first = 60deg;
        unknown second = 60deg;
        unknown third = 10deg;
        const x = (1, 0, 0);
        const z = (0, 0, 1);
        const out = turn(x, z, 70deg);
        const hinge = turn((0, 1, 0), z, 70deg);
        let top = 90mm * x + 70mm * turn(x, (0, -1, 0), phi) + 80mm * turn(x, (0, -1, 0), first);
        loop top - 85mm * x = 5mm * out + 70mm * turn(out, -hinge, second) + 80mm * turn(out, -hinge, third);
    }
}

fn main() {}
