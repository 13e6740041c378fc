//! Facts of the files of Linkage, as its sources have them.

use crate::files::of_text;

/// A crank of a file of Linkage, with other elements.
fn linkage(program: &str, elements: &str) -> String {
    format!(
        "<linkage2><program {program}/>\
         <connector id=\"0\" layer=\"16\" x=\"0\" y=\"0\" anchor=\"true\" input=\"true\" rpm=\"-15\"/>\
         <connector id=\"1\" layer=\"16\" x=\"0\" y=\"37.795276\"/>\
         <Link id=\"0\" layer=\"16\"><connector id=\"0\"/><connector id=\"1\"/></Link>\
         {elements}</linkage2>"
    )
}

/// 37.795276 of 1/96 inch are 10 mm: files of people with whole millimetres have such numbers.
#[test]
fn linkage_stores_parts_of_an_inch_whatever_its_unit() {
    let text = of_text(&linkage("units=\"Millimeters\"", ""), "a.linkage2").text;
    assert!(text.contains("c1 = (0mm, 10.0000001083mm)"), "{text}");
    assert!(text.contains("10mm is within"), "{text}");
    assert!(text.contains("// (0mm, 10mm) is within"), "{text}");
    let text = of_text(&linkage("units=\"Inches\"", ""), "a.linkage2").text;
    assert!(text.contains("unit inch;"), "{text}");
    assert!(text.contains("0.393700791667inch"), "{text}");
}

#[test]
fn linkage_turns_clockwise_with_positive_speeds() {
    let text = of_text(&linkage("", ""), "a.linkage2").text;
    let speed = "counterclockwise at 15 revolutions per minute";
    assert!(text.contains(speed), "{text}");
}

#[test]
fn linkage_reads_scale_factors_as_whole_numbers() {
    let import = of_text(&linkage("scalefactor=\"1.500000\"", ""), "a.linkage2");
    assert!(import.warnings[0].contains("the scale factor 1.5"));
    let import = of_text(&linkage("scalefactor=\"1.000000\"", ""), "a.linkage2");
    assert_eq!(import.warnings.len(), 1, "{:?}", import.warnings);
}

/// The centre is to the left of the way from the first limit to the second one for positive radii.
#[test]
fn linkage_has_arcs_on_both_sides() {
    let arc = |radius: &str| {
        let elements = format!(
            "<connector id=\"2\" x=\"-80\" y=\"96\" anchor=\"true\"/>\
             <connector id=\"3\" x=\"112\" y=\"96\" anchor=\"true\"/>\
             <connector id=\"4\" x=\"16\" y=\"80\" slider=\"true\" slideradius=\"{radius}\">\
             <slidelimit id=\"2\"/><slidelimit id=\"3\"/></connector>\
             <Link id=\"1\"><connector id=\"1\"/><connector id=\"4\"/></Link>\
             <Link id=\"2\"><connector id=\"2\"/><connector id=\"3\"/></Link>"
        );
        of_text(&linkage("units=\"Inches\"", &elements), "a.linkage2")
    };
    // Half of the distance is one inch, so that a radius of 1.25 inch has the height 0.75 inch.
    let above = arc("120").text;
    assert!(
        above.contains("= (0.166666666667inch, 1.75inch); // not in the file"),
        "{above}"
    );
    assert!(above.contains("slider slot_c4: c4 on frame around centre_c2_c3;"));
    let below = arc("-120").text;
    assert!(
        below.contains("= (0.166666666667inch, 0.25inch); // not in the file"),
        "{below}"
    );
    // A radius that is too small is raised, as the program does.
    let raised = arc("50");
    assert!(
        raised.warnings[0].contains("less than half"),
        "{:?}",
        raised.warnings
    );
}

#[test]
fn linkage_slots_have_two_limits_on_one_link() {
    let slot = |limits: &str| {
        let elements = format!(
            "<connector id=\"2\" x=\"-96\" y=\"96\" anchor=\"true\"/>\
             <connector id=\"3\" x=\"96\" y=\"96\"/>\
             <connector id=\"4\" x=\"9\" y=\"96\" slider=\"true\">{limits}</connector>\
             <Link id=\"1\"><connector id=\"1\"/><connector id=\"4\"/></Link>"
        );
        of_text(&linkage("", &elements), "a.linkage2").warnings
    };
    assert!(slot("<slidelimit id=\"2\"/>")[0].contains("has 1 limits instead of two"));
    let other = slot("<slidelimit id=\"2\"/><slidelimit id=\"3\"/>");
    assert!(other[0].contains("which no link joins"), "{other:?}");
    let missing = slot("<slidelimit id=\"2\"/><slidelimit id=\"9\"/>");
    assert!(missing[0].contains("the connector 9"), "{missing:?}");
}

#[test]
fn linkage_names_all_that_it_does_not_take() {
    let elements = "<connector id=\"7\" layer=\"1\" x=\"1\" y=\"2\" drawcircle=\"9\"/>\
                    <connector id=\"8\" limitangle=\"45\" x=\"1\" y=\"2\"/>\
                    <springs/>";
    let import = of_text(&linkage("", elements), "a.linkage2");
    let has = |part: &str| import.warnings.iter().any(|warning| warning.contains(part));
    assert!(has("the attribute `limitangle=\"45\"` of `connector`"));
    assert!(has("the element `springs`"));
    assert!(
        import
            .text
            .contains("// No link has the joints c8: left out.")
    );
    assert!(import.text.contains("1 connectors of drawing layers"));
    assert!(import.text.contains("// - the element `springs`"));
}

/// A gear that is fastened to a link is one body with it; one on an anchor is the frame.
#[test]
fn linkage_has_gears_and_chains() {
    let elements = "<connector id=\"2\" x=\"96\" y=\"0\" anchor=\"true\"/>\
                    <connector id=\"3\" x=\"96\" y=\"48\"/>\
                    <Link id=\"1\" gear=\"true\" fastenlink=\"0\"><connector id=\"0\"/></Link>\
                    <Link id=\"2\" gear=\"true\" fastenlink=\"3\"><connector id=\"2\"/></Link>\
                    <Link id=\"3\"><connector id=\"2\"/><connector id=\"3\"/></Link>\
                    <ratios><ratio type=\"gears\"><link id=\"1\" size=\"1\"/>\
                    <link id=\"2\" size=\"2\"/></ratio></ratios>";
    let text = of_text(&linkage("", elements), "a.linkage2").text;
    assert!(
        text.contains("gears link0, link3 on frame teeth 1, 2;"),
        "{text}"
    );
    let chain = elements.replace("type=\"gears\"", "type=\"chain\"");
    let text = of_text(&linkage("", &chain), "a.linkage2").text;
    assert!(
        text.contains("belt link0, link3 on frame teeth 1, 2;"),
        "{text}"
    );
    let alone = "<connector id=\"2\" x=\"96\" y=\"0\" anchor=\"true\"/>\
                 <Link id=\"2\" gear=\"true\"><connector id=\"2\"/></Link>\
                 <ratios><ratio type=\"gears\"><link id=\"0\" size=\"1.5\"/>\
                 <link id=\"2\" size=\"2\"/></ratio></ratios>";
    let text = of_text(&linkage("", alone), "a.linkage2").text;
    assert!(text.contains("joint mark_link2 = ("), "{text}");
    assert!(
        text.contains("gears link0, link2 on frame radii 1.5mm, 2mm;"),
        "{text}"
    );
}

/// A cylinder retracts from the drawing if its speed is negative.
#[test]
fn linkage_cylinders_move_by_their_throw() {
    let cylinder = |cpm: &str| {
        let elements = format!(
            "<connector id=\"2\" x=\"0\" y=\"96\" anchor=\"true\"/>\
             <connector id=\"3\" x=\"96\" y=\"96\"/>\
             <Link id=\"2\"><connector id=\"2\"/><connector id=\"3\"/></Link>\
             <connector id=\"4\" x=\"96\" y=\"0\" anchor=\"true\"/>\
             <Link id=\"5\" actuator=\"true\" throw=\"24\" cpm=\"{cpm}\"><connector id=\"4\"/>\
             <connector id=\"3\"/></Link>"
        );
        of_text(&linkage("units=\"Inches\"", &elements), "a.linkage2").text
    };
    let text = cylinder("5");
    assert!(
        text.contains("input stroke = 1inch in 1inch..1.25inch;"),
        "{text}"
    );
    assert!(text.contains("link link5: c4, c3 length stroke;"), "{text}");
    let text = cylinder("-5");
    assert!(
        text.contains("input stroke = 1inch in 0.75inch..1inch;"),
        "{text}"
    );
}

/// Links that hang on one joint are left out, together with those that hang on them.
#[test]
fn linkage_names_links_that_hang_on_one_joint() {
    let closed = "<connector id=\"2\" x=\"200\" y=\"100\"/>\
                  <connector id=\"3\" x=\"200\" y=\"0\" anchor=\"true\"/>\
                  <Link id=\"1\"><connector id=\"1\"/><connector id=\"2\"/></Link>\
                  <Link id=\"2\"><connector id=\"2\"/><connector id=\"3\"/></Link>";
    let hanging = "<connector id=\"4\" x=\"260\" y=\"130\"/>\
                   <connector id=\"5\" x=\"300\" y=\"130\"/>\
                   <Link id=\"3\"><connector id=\"2\"/><connector id=\"4\"/></Link>\
                   <Link id=\"4\"><connector id=\"4\"/><connector id=\"5\"/></Link>";
    let import = of_text(&linkage("", &format!("{closed}{hanging}")), "a.linkage2");
    let free = import
        .warnings
        .iter()
        .filter(|text| text.contains("is free"));
    let free: Vec<&str> = free.map(String::as_str).collect();
    assert_eq!(
        free,
        [
            "the link `link4` is held only at the joint `c4`, so that its motion is free: it is \
             left out",
            "the link `link3` is held only at the joint `c2`, so that its motion is free: it is \
             left out"
        ]
    );
    let lines = |text: &str| {
        let lines = text
            .lines()
            .filter(|line| !line.trim_start().starts_with("//"));
        lines.map(str::to_owned).collect::<Vec<String>>()
    };
    let without = of_text(&linkage("", closed), "a.linkage2");
    assert!(
        without.text.contains("link link2: c2, c3;"),
        "{}",
        without.text
    );
    assert_eq!(lines(&import.text), lines(&without.text));
}
