//! Facts of the formats, as the sources of the tools have them.

use linkage_import::{Format, Options, import};

use crate::files::{all, imported, of_text};

#[test]
fn every_file_is_detected_and_read() {
    for file in all() {
        let text = imported(&file, &Options::default()).text;
        assert!(text.contains("pub struct "), "{}", file.display());
        assert!(text.contains("    input "), "{}: {text}", file.display());
    }
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

/// Positions are taken, and what contradicts them is named with its distance.
#[test]
fn pylinkage_names_what_contradicts_positions() {
    let warnings = |line_point: &str, distance: &str, angle: &str| {
        let json = format!(
            r#"{{"joints": [
            {{"id": "O", "type": "ground", "position": [0, 0]}},
            {{"id": "A", "position": [0, 1]}},
            {{"id": "B", "type": "prismatic", "position": [4, 1], "axis": [0, 2],
             "line_point": {line_point}}},
            {{"id": "T", "type": "tracker", "position": [0, 3], "ref_joint1_id": "A",
             "ref_joint2_id": "B", "distance": {distance}, "angle": {angle}}}],
            "links": [{{"id": "c", "type": "driver", "joints": ["O", "A"], "motor_joint": "O"}},
            {{"id": "r", "joints": ["A", "B"]}}]}}"#
        );
        let warnings = of_text(&json, "a.json").warnings.into_iter();
        let about = warnings.filter(|warning| warning.contains(" beside "));
        about.collect::<Vec<String>>()
    };
    let quarter = "1.5707963267948966";
    assert!(warnings("[4, -7]", "2", quarter).is_empty());
    assert_eq!(
        warnings("[4.5, -7]", "2", quarter),
        [
            "the joint `B` is 0.5 beside the line through its `line_point`: the line through its \
          position is taken"
        ]
    );
    assert_eq!(
        warnings("[4, 0]", "2.25", quarter),
        ["the tracker `T` is 0.25 beside its `distance` and `angle`: its position is taken"]
    );
    assert_eq!(warnings("[4, 0]", "2", "-1.5707963267948966").len(), 1);
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

/// The fixed link never turns: the other link of the motor does, with the opposite sign.
#[test]
fn motors_turn_the_link_that_is_not_fixed() {
    let table = "name,kind,x (mm),y (mm),links\no,motor,0,0,frame crank\na,pin,20,5,crank rod\n\
                 b,pin,80,40,rod rocker\nc,pin,90,0,rocker frame\n";
    let first = of_text(table, "a.csv");
    let second = of_text(&table.replace("frame crank", "crank frame"), "a.csv");
    assert!(second.text.contains("link crank: o, a at phi;"));
    let warning = "the motor `o` names the fixed link second: the angle of `crank` is taken, which \
                   has the opposite sign";
    assert!(second.warnings.contains(&warning.to_owned()));
    assert!(!first.warnings.contains(&warning.to_owned()));
    let is_item = |line: &&str| !line.trim_start().starts_with("//");
    let items = |text: &str| text.lines().filter(is_item).collect::<Vec<_>>().join("\n");
    assert_eq!(items(&first.text), items(&second.text));
}

#[test]
fn slides_are_inputs_by_their_joint() {
    let expression = "M[J[R, P[0, 0], L[ground, a]], J[R, P[10, 10], L[a, b]], \
                      J[RP, A[0], P[40, 0], L[ground, b]]]";
    let named = |input: &str| {
        let options = Options {
            inputs: vec![input.to_owned()],
            ..Options::default()
        };
        import(expression.as_bytes(), "a.pyslvs", &options)
    };
    let text = named("p2").expect("a slot").text;
    assert!(text.contains("    input travel = "), "{text}");
    assert!(!text.contains("    input phi"), "{text}");
    let error = named("p1").expect_err("no slot").to_string();
    assert!(
        error.starts_with("the input `p1` is no pair, and the joint has no slot\nhelp: "),
        "{error}"
    );
}

/// A doubt about the motor of the file ends with the option, and goes with it.
#[test]
fn doubts_about_motors_name_the_option() {
    let file = crate::files::folder().join("files/u_c.pmks");
    let doubts = |inputs: &[&str]| {
        let options = Options {
            inputs: inputs.iter().map(|input| (*input).to_owned()).collect(),
            ..Options::default()
        };
        let warnings = imported(&file, &options).warnings;
        let doubts = warnings.into_iter();
        doubts
            .filter(|warning| warning.contains("could turn several links"))
            .collect::<Vec<String>>()
    };
    assert_eq!(
        doubts(&[]),
        [
            "the motor at `j3` could turn several links; it turns `link2`: `--input PIVOT,JOINT` \
             names another one"
        ]
    );
    assert!(doubts(&["j3,j5"]).is_empty());
    assert!(doubts(&["j1,j2"]).is_empty());
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

/// A misspelt link is named with its row and the name that was meant.
#[test]
fn tables_name_links_of_a_single_row() {
    let table = "name,kind,x (mm),y (mm),links\r\n# the crank\r\no,motor,0,0,frame crank\r\n\r\n\
                 a,pin,20,5,crnk rod\r\nb,pin,80,40,rod rocker\r\nc,pin,90,0,rocker frame\r\n";
    let warnings = of_text(table, "a.csv").warnings;
    let misspelt = "line 5: only the joint `a` has the link `crnk`; the name next to it is `crank`";
    assert!(warnings.contains(&misspelt.to_owned()), "{warnings:?}");
    let alone = "line 3: only the joint `o` has the link `crank`; the name next to it is `crnk`";
    assert!(warnings.contains(&alone.to_owned()), "{warnings:?}");
    let right = of_text(&table.replace("crnk", "crank"), "a.csv").warnings;
    let is_single = |warning: &String| warning.contains("only the joint");
    assert!(!right.iter().any(is_single), "{right:?}");
}

/// Spreadsheets of many countries write `;` between columns and commas in numbers.
#[test]
fn tables_may_have_decimal_commas() {
    let table = "name,kind,x (mm),y (mm),links,along\no,motor,0,0,frame crank,\n\
                 a,pin,20.5,5.25,crank rod,\nb,slot,80.75,0,frame rod,0.5\n";
    let with_points = of_text(table, "a.csv").text;
    let with_commas = table.replace(',', ";").replace('.', ",");
    let with_commas = of_text(&with_commas, "a.csv").text;
    let remark = "// The file has decimal commas: here they are points.\n";
    assert!(with_commas.contains(remark), "{with_commas}");
    assert_eq!(with_commas.replace(remark, ""), with_points);
}
