//! Items of imported texts that the drawings of this test do not have.

use linkage_engine::Mechanism;

use crate::files::of_text;

/// Outer wheels turn against each other, those of a chain in the same sense.
#[test]
fn wheels_turn_by_their_sizes() {
    for (kind, sign) in [("gears", -1.0), ("chain", 1.0)] {
        let file = format!(
            "<linkage2><program units=\"Inches\"/>\
             <connector id=\"0\" x=\"0\" y=\"0\" anchor=\"true\" input=\"true\" rpm=\"9\"/>\
             <connector id=\"1\" x=\"48\" y=\"0\"/>\
             <connector id=\"2\" x=\"192\" y=\"0\" anchor=\"true\"/>\
             <Link id=\"0\"><connector id=\"0\"/><connector id=\"1\"/></Link>\
             <Link id=\"1\" gear=\"true\" fastenlink=\"0\"><connector id=\"0\"/></Link>\
             <Link id=\"2\" gear=\"true\"><connector id=\"2\"/></Link>\
             <ratios><ratio type=\"{kind}\"><link id=\"1\" size=\"20\"/>\
             <link id=\"2\" size=\"40\"/></ratio></ratios></linkage2>"
        );
        let text = of_text(&file, "wheels.linkage2").text;
        let mechanism = Mechanism::compile(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
        let assembly = mechanism.assemble(&mechanism.dimensions()).expect("wheels");
        let mark = |phi: f64| {
            let [x, y] = assembly.results("points", &[phi]).vector::<2>("mark_link2");
            y.atan2(x - 2.0)
        };
        let turned = mark(0.5) - mark(0.0);
        assert!(
            (turned - sign * 0.25).abs() < 1e-12,
            "{kind}: {turned}\n{text}"
        );
    }
}

/// A wheel on an anchor does not turn: another one in a chain with it keeps its angle.
#[test]
fn fixed_wheels_are_links() {
    let file = "<linkage2><program units=\"Inches\"/>\
        <connector id=\"0\" x=\"0\" y=\"0\" anchor=\"true\" input=\"true\" rpm=\"9\"/>\
        <connector id=\"1\" x=\"96\" y=\"0\"/><connector id=\"2\" x=\"96\" y=\"48\"/>\
        <Link id=\"0\"><connector id=\"0\"/><connector id=\"1\"/></Link>\
        <Link id=\"1\" gear=\"true\" fastenconnector=\"0\"><connector id=\"0\"/></Link>\
        <Link id=\"2\" gear=\"true\" fastenlink=\"3\"><connector id=\"1\"/></Link>\
        <Link id=\"3\"><connector id=\"1\"/><connector id=\"2\"/></Link>\
        <ratios><ratio type=\"chain\"><link id=\"1\" size=\"25\"/>\
        <link id=\"2\" size=\"25\"/></ratio></ratios></linkage2>";
    let text = of_text(file, "wheels.linkage2").text;
    let mechanism = Mechanism::compile(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let assembly = mechanism.assemble(&mechanism.dimensions()).expect("wheels");
    let [x, y] = assembly.results("points", &[0.5]).vector::<2>("c2");
    let wanted = [0.5f64.cos(), 0.5f64.sin() + 0.5];
    assert!(
        (x - wanted[0]).hypot(y - wanted[1]) < 1e-12,
        "({x}, {y})\n{text}"
    );
}

/// Words of the language and of generated code get another name.
#[test]
fn words_of_the_language_are_no_names() {
    let words = "about abs accel acceleration along alpha angle around at axis belt block body bore \
                 centre cos d damper deg dir drive e end f force friction gear gears gravity \
                 guide impl in inertia input joint jerk knots length let link load loop margin mass \
                 max min mm mode moment new norm omega on param part phi pi picture pin points polar \
                 pub radii radius range reaction rotate s self shape slider slot spring sqrt struct \
                 t tan teeth through time torque turn unit unknown velocity weld with x y";
    let mut failures = Vec::new();
    for word in words.split_whitespace() {
        let table = format!(
            "name,kind,x (mm),y (mm),links\no,motor,0,0,frame {word}\n{word},pin,3,4,{word} rod\n\
             b,pin,12,6,rod lever\nc,pin,14,0,frame lever\n"
        );
        let text = of_text(&table, "a.csv").text;
        if let Err(error) = Mechanism::compile(&text) {
            failures.push(format!("{word}: {error}"));
        }
    }
    assert!(
        failures.is_empty(),
        "{}",
        failures.join(
            "
"
        )
    );
}

/// Blocks, cylinders, driven slots and masses are items of the language.
#[test]
fn other_texts_compile() {
    let tables = [
        "name,kind,x (mm),y (mm),links,along,input\n\
         o,pin,0,0,frame crank,,\na,pin,20,35,crank rod,,\nb,block,140,20,frame piston rod,0,1\n\
         c,pin,150,20,piston,,\n",
        "name,kind,x (cm),y (cm),links\n\
         o,pin,0,0,frame boom\na,pin,20,5,boom\ng,pin,10,-9,frame\nram,cylinder,,,g a\n",
        "name,kind,x (m),y (m),links\n\
         Pi,motor,0,0,frame let\nlet,motor,1,2,let 2\n1,pin,3,2,2\n",
    ];
    for table in tables {
        let text = of_text(table, "a.csv").text;
        let mechanism = Mechanism::compile(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
        assert!(
            mechanism.assemble(&mechanism.dimensions()).is_ok(),
            "{text}"
        );
    }
}
