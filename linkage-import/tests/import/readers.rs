//! Facts of the formats, as the sources of the tools have them.

use linkage_import::{Format, Options, import};

use crate::files::{all, imported, of_text};

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

#[test]
fn every_file_is_detected_and_read() {
    for file in all() {
        let text = imported(&file, &Options::default()).text;
        assert!(text.contains("pub struct "), "{}", file.display());
        assert!(text.contains("    input "), "{}: {text}", file.display());
    }
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

/// The first link of P and RP joints has the slot, and a P joint keeps the angle of the second.
#[test]
fn pyslvs_names_the_guide_first() {
    let text = |kind: &str| {
        let expression = format!(
            "M[J[R, P[0, 0], L[ground, a]], J[R, color[(1, 2, 3)], P[1, 1], L[a, b]], # comment\n\
             J[{kind}, A[45.0], color[Green], P[5.25, 0], L[ground, c, b]],\n\
             #[ J[R ] #]\nJ[R, P[7, 3], L[c]],]"
        );
        of_text(&expression, "x.txt").text
    };
    assert!(
        text("RP").contains("slider slot_p2: p2 on frame along 45deg;"),
        "{}",
        text("RP")
    );
    assert!(text("P").contains("slider slot_p2: p2 on frame along 45deg, block c;"));
    // Several links do not turn in one slot, so that they are one body.
    assert!(text("P").contains("link c: p2, p3, p1;"), "{}", text("P"));
    // Four decimals are written, and zeros at their end are cut.
    assert!(text("P").contains("may be wrong by 0.00005mm"));
}

#[test]
fn pyslvs_expressions_take_the_inputs_that_are_named() {
    let expression = "M[J[R, P[0, 0], L[ground, a]], J[R, P[10, 10], L[a, b]], \
                      J[R, P[40, 20], L[b, c]], J[R, P[50, 0], L[ground, c]]]";
    let options = Options {
        inputs: vec!["p3,p2".to_owned()],
        ..Options::default()
    };
    let import_named = import(expression.as_bytes(), "a.pyslvs", &options).expect("an expression");
    assert!(
        import_named.text.contains("link c: p3, p2 at phi;"),
        "{}",
        import_named.text
    );
    let chosen = of_text(expression, "a.pyslvs");
    assert!(chosen.text.contains("link a: p0, p1 at phi;"));
    assert!(
        chosen
            .warnings
            .iter()
            .any(|warning| warning.contains("names no input"))
    );
    let options = Options {
        inputs: vec!["p3,p1".to_owned()],
        ..Options::default()
    };
    let error = import(expression.as_bytes(), "a.pyslvs", &options).expect_err("no such link");
    assert!(error.to_string().contains("no link turns"), "{error}");
}

#[test]
fn several_motors_run_in_one_time() {
    let elements = "<connector id=\"2\" x=\"96\" y=\"0\" anchor=\"true\" input=\"true\" rpm=\"9.5\"/>\
                    <connector id=\"3\" x=\"96\" y=\"48\"/>\
                    <Link id=\"1\"><connector id=\"2\"/><connector id=\"3\"/></Link>";
    let text = of_text(&linkage("", elements), "a.linkage2").text;
    let rates = "phi1 = 90deg + 90deg/s * t, phi2 = 90deg - 57deg/s * t.";
    assert!(text.contains(rates), "{text}");
    let cylinder = "<Link id=\"9\" actuator=\"true\" throw=\"9\" cpm=\"5\"><connector id=\"1\"/>\
                    <connector id=\"3\"/></Link>";
    let elements = elements.replace(" input=\"true\" rpm=\"9.5\"", "") + cylinder;
    let text = of_text(&linkage("", &elements), "a.linkage2").text;
    assert!(text.contains("move to and fro"), "{text}");
}

#[test]
fn text_around_expressions_is_named() {
    let project = "input:\n- {base: 0}\nmechanism: \"M[J[R, P[0, 0], L[ground, a]],\" \n\
                   \"J[R, P[1, 1], L[a]]]\"\n";
    let import = of_text(project, "a.yml");
    let has = |part: &str| import.warnings.iter().any(|warning| warning.contains(part));
    assert!(
        has("the text around the expression"),
        "{:?}",
        import.warnings
    );
}

/// Numbers of addresses of PMKS+ in base 64, for drawings of this test.
mod address {
    const DIGITS: &[u8] = b"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-";

    pub(super) fn number(thousandths: i64) -> String {
        let mut digits = Vec::new();
        let mut rest = thousandths.unsigned_abs() as usize;
        while rest > 0 || digits.is_empty() {
            digits.push(DIGITS[rest % 64]);
            rest /= 64;
        }
        if thousandths < 0 {
            digits.push(b'0');
        }
        digits.reverse();
        String::from_utf8(digits).expect("digits")
    }

    /// Returns an address with the check of its length.
    pub(super) fn checked(body: &str) -> String {
        let check = char::from(DIGITS[body.len() % 62]);
        format!("https://app.pmksplus.com/?{body}{check}")
    }

    /// A crank, a coupler and a rocker, with a unit and a tail.
    pub(super) fn four_bar(unit: &str, tail: &str) -> String {
        let joint = |flags: char, id: &str, x: i64, y: i64| {
            format!("{flags}{id},{id},{},{},0.", number(x), number(y))
        };
        let link = |id: &str, mass: &str| {
            let (a, b) = id.split_at(1);
            format!(
                "YR{id},{id},{mass},{mass},{},0,c5cae9,{a},{b},,.",
                number(-500)
            )
        };
        let body = format!(
            "0P.Fe.K,0.{unit}11.{}{}{}{}.{}{}{}..N_{tail}",
            joint('M', "A", 0, 0),
            joint('G', "B", 0, 1050),
            joint('G', "C", 3000, 2500),
            joint('K', "D", 3500, -64),
            link("AB", "Fe"),
            link("BC", &number(2500)),
            link("CD", "Fe")
        );
        checked(&body)
    }
}

/// Thousandths of the unit, which may be the metre: a zero in front is the sign.
#[test]
fn pmks_rounds_to_thousandths_of_its_unit() {
    assert_eq!(address::number(1400), "Lu");
    assert_eq!(address::number(-11), "0B");
    for (digit, unit) in [("0", "inch"), ("1", "cm"), ("2", "m")] {
        let import = of_text("", &address::four_bar(digit, ""));
        assert!(
            import.text.contains(&format!("unit {unit};")),
            "{}",
            import.text
        );
        assert!(
            import
                .text
                .contains(&format!("d = (3.5{unit}, -0.064{unit})"))
        );
        assert!(
            import
                .text
                .contains(&format!("may be wrong by 0.0005{unit}"))
        );
    }
    let text = of_text("", &address::four_bar("2", "")).text;
    assert!(text.contains("a to b 1.0500 +-0.001m"), "{text}");
    assert!(
        text.contains("clockwise at 20 revolutions per minute"),
        "{text}"
    );
}

/// A mass of 1 with an inertia of 1 is that of every new link.
#[test]
fn pmks_masses_have_their_units() {
    let text = of_text("", &address::four_bar("1", "")).text;
    assert!(
        text.contains("mass 2.5kg at centre_of_bc, inertia 2.5kg*cm^2;"),
        "{text}"
    );
    assert!(
        text.contains("2 links have no mass or the mass 1"),
        "{text}"
    );
    let text = of_text("", &address::four_bar("2", "")).text;
    assert!(
        text.contains("mass 2.5kg at centre_of_bc, inertia 2.5kg*m^2;"),
        "{text}"
    );
    let text = of_text("", &address::four_bar("0", "")).text;
    assert!(
        text.contains("mass 1.133980925kg at centre_of_bc"),
        "{text}"
    );
}

/// Newer pages correct numbers that thousandths do not hold.
#[test]
fn pmks_takes_corrections() {
    let text = of_text("", &address::four_bar("1", ".PJB~1~1.0504,PLBC~0~2.25")).text;
    assert!(text.contains("b = (0cm, 1.0504cm)"), "{text}");
    assert!(text.contains("mass 2.25kg"), "{text}");
    assert!(!text.contains("may be wrong by"), "{text}");
}

/// The digest of newer pages is FNV-1a in base 62. That of the empty text is known.
#[test]
fn pmks_checks_its_addresses() {
    let whole = address::four_bar("1", "");
    let cut = &whole[..whole.len() - 1];
    let error = import(b"", cut, &Options::default()).expect_err("a cut address");
    assert!(error.to_string().contains("cut or changed"), "{error}");
    // The same length, and another place: only a digest sees it.
    let error = import(b"", &format!("{whole}*000000"), &Options::default());
    assert!(
        error
            .expect_err("a wrong digest")
            .to_string()
            .contains("cut or changed")
    );
    let text = format!("see [the model]({whole}) for more");
    let read = import(text.as_bytes(), "notes.md", &Options::default()).expect("an address");
    assert!(read.text.contains("link ab: a, b at phi;"));
}

#[test]
fn pylinkage_has_positions_and_no_lengths() {
    let json = r#"{"name": "press 2", "joints": [
        {"id": "O", "type": "ground", "position": [0.0, 0.0]},
        {"id": "A", "type": "revolute", "position": [1.0, 0.25], "name": "pin"},
        {"id": "B", "type": "prismatic", "position": [4, 0.5], "axis": [1, 0],
         "line_point": [0, 0.5]},
        {"id": "T", "type": "tracker", "position": [2, 2], "ref_joint1_id": "A",
         "ref_joint2_id": "B", "distance": 1, "angle": 0.1}],
        "links": [{"id": "g", "type": "ground", "joints": ["O"]},
        {"id": "c", "type": "driver", "joints": ["O", "A"], "motor_joint": "O",
         "angular_velocity": 0.1, "colour": "red"},
        {"id": "r", "type": "link", "joints": ["A", "B"]}], "ground": "g"}"#;
    let from_json = of_text(json, "a.json");
    assert!(
        from_json.text.contains("pub struct Press2 {"),
        "{}",
        from_json.text
    );
    assert!(
        from_json.text.contains("link c: o, pin at phi;"),
        "{}",
        from_json.text
    );
    assert!(from_json.text.contains("link r: pin, b, t;"));
    assert!(
        from_json
            .text
            .contains("slider slot_b: b on frame along 0rad;")
    );
    assert!(from_json.text.contains("has no lengths"));
    assert!(
        from_json
            .warnings
            .iter()
            .any(|warning| warning.contains("`colour`"))
    );
    let angle = "\"initial_angle\": 0.25, \"angular_velocity\"";
    let turned = json.replace("\"angular_velocity\"", angle);
    let turned = of_text(&turned, "a.json").warnings;
    assert!(
        turned
            .iter()
            .any(|warning| warning.contains("begins at 0.25 rad in the program"))
    );
    // The same as Python prints it.
    let python = json
        .replace('"', "'")
        .replace("[1, 0]", "(1, 0,)")
        .replace("'red'", "None");
    let from_python = of_text(&python, "a.py");
    assert_eq!(from_json.text.replace("a.json", "a.py"), from_python.text);
}

#[test]
fn tables_have_all_kinds_of_joints() {
    let table = "name;kind;x [cm];y [cm];links;along;input\n\
                 o;motor;0;0;frame crank;;\n\
                 a;pin;2;1;crank rod;;\n\
                 b;block;8;1;frame piston rod;30;\n\
                 c;pin;9;1;piston;;\n\
                 # a cylinder between two joints\n\
                 f;;5;-3;frame;;\n\
                 ram;cylinder;;;f a;;\n";
    let import = of_text(table, "a.csv");
    let text = import.text;
    assert!(text.contains("unit cm;"));
    assert!(text.contains("link crank: o, a at phi;"), "{text}");
    assert!(text.contains("link ram: f, a length stroke;"), "{text}");
    assert!(
        text.contains("slider slot_b: b on frame along 30deg, block piston;"),
        "{text}"
    );
}

#[test]
fn names_become_identifiers_once() {
    let table = "name,kind,x,y,links\nPi,pin,0,0,frame Link A-1\nlet,pin,1,2,A-1 a_1\n\
                 Größe 3,pin,4,2,a_1 b\n1,pin,5,0,frame b\n";
    let text = of_text(table, "1 press.csv").text;
    assert!(text.contains("pub struct Mechanism1Press {"), "{text}");
    for joint in ["pi_2", "let_2", "gr_e_3", "j1"] {
        assert!(
            text.contains(&format!("    joint {joint} = ")),
            "{joint}: {text}"
        );
    }
    assert!(text.contains("link a_1: "));
    assert!(text.contains("link a_1_2: "));
}

#[test]
fn formats_have_names() {
    for format in Format::ALL {
        assert_eq!(Format::named(format.name()), Some(format));
    }
    let error = import(b"hello", "a.txt", &Options::default()).expect_err("no format");
    assert!(
        error.to_string().contains("linkage2, pmks, pyslvs"),
        "{error}"
    );
}
