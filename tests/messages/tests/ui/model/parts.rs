//! What a part is given, and what it is asked for.

use linkage::mechanism;

mechanism! {
    struct Bar {
        unit mm;
        param radius = 12mm;
        param rod = 55mm;
        param base = (0mm, 0mm);
        argument load = 5N;
        input phi = 20deg in 0deg..360deg;
        unknown theta = -80deg;
        unknown lift = -45mm;
        loop base + polar(radius, phi) + polar(rod, theta) = (4mm, lift);
        let tip = (4mm, lift - 30mm);
        body crank = pin hub on frame at base, turns phi, mass 20g at base + polar(radius, phi);
        body bar = slide way on frame at (4mm, lift) along (0, 1);
        body link = pin eye on crank at base + polar(radius, phi), turns theta;
        pin knuckle = link on bar at (4mm, lift);
        force (0, load) on bar at tip;
    }
    struct Machine {
        unit mm;
        param lead = 30deg;
        param pivot = (80mm, 0mm);
        input shaft = 0deg in 0deg..360deg;
        input stroke = 3mm;
        part open: Bar { load = 5N };
        part twice: Bar { phi = shaft, phi = shaft + lead, load = 5N };
        part other: Bar { phi = shaft, rodd = 50mm, load = 5N };
        part length: Bar { phi = stroke, load = 5N };
        part bare: Bar { phi = 30, load = 5N };
        part moved: Bar { phi = shaft, rod = stroke, load = 5N };
        part loaded: Bar { phi = shaft };
        part unknown: Bar { phi = shfat, load = 5N } at pivto;
        part placed: Bar { phi = shaft, load = 5N } on frmae at lead, turned by stroke;
        part space: Bar { phi = shaft, load = 5N } at (1mm, 2mm, 3mm);
        part sound: Bar { phi = shaft, load = 5N };
        part sound: Bar { phi = shaft, load = 5N };
        part shaft: Bar { phi = 0deg, load = 5N };
        param sound_rod = 1mm;
        let a = sound.tpi;
        let b = sound;
        let c = sound.bar;
        let d = later.tip;
        part later: Bar { phi = shaft, load = 5N } at pivot;
        body gear = pin on sound.crnak at (0, 0), turns shaft, mass 1kg at (0, 0);
    }
    struct Near {
        input shaft = 0deg;
        part late: Bra { phi = shaft };
        let tip = late.tip;
    }
    impl Machine {
        fn motion(shaft) -> Motion {
            a: d(sound.tip, sound.rdo), b: sensitivity(sound.tip, [sound.rod, sound.theta]),
            c: reaction(sound.wya), d: reaction(sound.bar), e: sound.tip.z, f: d(sound.tip, sound),
        }
    }
}

fn main() {}
