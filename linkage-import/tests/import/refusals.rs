//! Files that break their format: a message each, within bounded memory.

use linkage_import::{Format, Options, import};

use crate::memory::bounded;

fn refused(content: &str, format: Format) -> String {
    let options = Options {
        format: Some(format),
        ..Options::default()
    };
    let error = import(content.as_bytes(), "a", &options);
    error.expect_err("a file that is refused").to_string()
}

/// Entities that would become billions of letters are not read at all.
#[test]
fn xml_bombs_are_refused() {
    let mut bomb = "<?xml version=\"1.0\"?><!DOCTYPE linkage2 [<!ENTITY a0 \"ha\">".to_owned();
    for level in 1..40 {
        bomb += &format!(
            "<!ENTITY a{level} \"{}\">",
            format!("&a{};", level - 1).repeat(10)
        );
    }
    bomb += "]><linkage2><connector id=\"0\" name=\"&a39;\"/></linkage2>";
    assert!(refused(&bomb, Format::Linkage).contains("document type"));
    // Without a document type, the entity is not known.
    let alone = "<linkage2><connector id=\"0\" name=\"&a39;\" x=\"0\" y=\"0\"/></linkage2>";
    assert!(refused(alone, Format::Linkage).contains("broken at byte"));
}

#[test]
fn deep_and_long_files_are_refused() {
    let deep = "<a>".repeat(1_000_000);
    assert!(refused(&deep, Format::Linkage).contains("nested too deeply"));
    let wide = format!("<linkage2>{}</linkage2>", "<a/>".repeat(200_000));
    assert!(refused(&wide, Format::Linkage).contains("more than 100000 elements"));
    let deep = "[".repeat(1_000_000);
    assert!(refused(&deep, Format::Pylinkage).contains("no JSON"));
    let joints = "J[R,P[0,0],L[a]],".repeat(100_000);
    assert!(refused(&format!("M[{joints}]"), Format::Pyslvs).contains("more than 2000"));
    let rows = "a,pin,0,0,b\n".repeat(100_000);
    let table = format!("name,kind,x,y,links\n{rows}");
    assert!(refused(&table, Format::JointTable).contains("more than 2000"));
}

/// The largest drawings take some seconds at most, whatever is at the limit.
#[test]
fn large_drawings_take_bounded_time() {
    let header = "name,kind,x,y,links\n";
    let chain = |count: usize, kind: &str| {
        let row = |index: usize| {
            let (x, y) = (index, index * index % 17);
            let end = if index.is_multiple_of(3) {
                "frame "
            } else {
                ""
            };
            format!("j{index},{kind},{x},{y},{end}l{index} l{}\n", index + 1)
        };
        header.to_owned() + &(0..count).map(row).collect::<String>()
    };
    let anchors = |index: usize| format!("j{index},pin,{index},0,frame l{} l{index}\n", index + 1);
    let anchors = header.to_owned() + &(0..1990).map(anchors).collect::<String>();
    let tables = [
        chain(1990, "pin"),
        chain(75, "pin"),
        chain(75, "motor"),
        anchors,
    ];
    bounded("large tables", 120, || {
        for table in tables {
            let options = Options {
                format: Some(Format::JointTable),
                ..Options::default()
            };
            // A text or a message, in time.
            let _ = import(table.as_bytes(), "a.csv", &options);
        }
    });
}

#[test]
fn huge_numbers_are_refused() {
    let linkage = |x: &str| {
        format!("<linkage2><connector id=\"0\" anchor=\"true\" x=\"{x}\" y=\"0\"/></linkage2>")
    };
    assert!(refused(&linkage("1e999"), Format::Linkage).contains("too large"));
    assert!(refused(&linkage("1e300"), Format::Linkage).contains("too far away"));
    assert!(refused(&linkage("NaN"), Format::Linkage).contains("no number"));
    assert!(refused(&linkage("0x10"), Format::Linkage).contains("no number"));
    let digits = "9".repeat(1000);
    assert!(refused(&linkage(&digits), Format::Linkage).contains("no number"));
    let expression = "M[J[R, P[1e400, 0], L[ground]]]";
    assert!(refused(expression, Format::Pyslvs).contains("too large"));
    let json = "{\"joints\": [{\"id\": \"a\", \"position\": [1e999, 0]}], \"links\": []}";
    assert!(refused(json, Format::Pylinkage).contains("no JSON"));
}

#[test]
fn messages_name_the_fault() {
    let cases = [
        (Format::Linkage, "<linkage2", "broken at byte"),
        (
            Format::Linkage,
            "<linkage/>",
            "the root of the XML is `linkage`",
        ),
        (Format::Linkage, "<linkage2></linkage2>", "no connectors"),
        (
            Format::Linkage,
            "<linkage2><connector id=\"a\" x=\"0\" y=\"0\"/></linkage2>",
            "the id `a`",
        ),
        (
            Format::Linkage,
            "<linkage2><connector id=\"0\" y=\"0\"/></linkage2>",
            "connector 0 has no attribute `x`",
        ),
        (Format::Pmks, "https://app.pmksplus.com/", "no query"),
        (
            Format::Pmks,
            "https://app.pmksplus.com/?pmks2:00",
            "cut or changed",
        ),
        (Format::Pmks, "https://app.pmksplus.com/?a%zz", "broken `%`"),
        (
            Format::Pmks,
            "https://app.pmksplus.com/?data=N4Ig",
            "cannot be read",
        ),
        (
            Format::Pyslvs,
            "M[J[R, P[0 0], L[]]]",
            "is `0 0`, which is no number",
        ),
        (Format::Pyslvs, "M[J[Q, P[0, 0], L[]]]", "of the kind `Q`"),
        (Format::Pyslvs, "M[J[R, P[0, 0], L[a]", "the end where `]`"),
        (Format::Pyslvs, "M[]", "no joints"),
        (
            Format::Pyslvs,
            "M[J[R, P[0, 0], L[a]]]",
            "no link of the drawing moves",
        ),
        (
            Format::Pyslvs,
            "M[J[P, P[0, 0], L[a]]]",
            "no angle or no link",
        ),
        (Format::Pylinkage, "{}", "no list `joints`"),
        (Format::Pylinkage, "{\"nodes\": []}", "only a graph"),
        (
            Format::Pylinkage,
            "{\"joints\": [{\"id\": \"a\", \"position\": [null, null]}], \"links\": []}",
            "no `position` with two numbers",
        ),
        (Format::JointTable, "name,kind,x,y\n", "no column `links`"),
        (
            Format::JointTable,
            "name,kind,x (ell),y,links\n",
            "the unit `ell`",
        ),
        (Format::JointTable, "name,kind,x,y,links\n", "no joints"),
        (
            Format::JointTable,
            "name,kind,x,y,links\na,spring,0,0,b\n",
            "kinds are pin, motor",
        ),
    ];
    for (format, content, part) in cases {
        let message = refused(content, format);
        assert!(message.contains(part), "{content}: {message}");
        assert!(message.starts_with(|letter: char| letter.is_lowercase() || letter == '`'));
    }
}

/// Comments, empty lines and line ends of both kinds count.
#[test]
fn messages_about_tables_name_the_line() {
    let table = "\u{feff}name,kind,x,y,links\n# pivots\n\no,pin,0,0,frame a\np,pin,1,z,a\n";
    let at_fault = "line 5: y of `p` is `z`, which is no number";
    assert_eq!(refused(table, Format::JointTable), at_fault);
    let with_returns = table.replace('\n', "\r\n");
    assert_eq!(refused(&with_returns, Format::JointTable), at_fault);
    let kind = table.replace("1,z", "1,2").replace("p,pin", "p,spring");
    let message = refused(&kind, Format::JointTable);
    assert!(
        message.starts_with("line 5: `p` is of the kind"),
        "{message}"
    );
}

#[test]
fn commas_that_may_be_of_numbers_are_refused() {
    let row = |table: &str| refused(&format!("name,kind,x,y,links\n{table}"), Format::JointTable);
    let message = row("o,pin,0,0,frame a\np,pin,20,5,7,5,a\n");
    assert!(
        message.starts_with("line 3: the row has 7 cells, and the heading 5\nhelp: "),
        "{message}"
    );
    let table = "name;kind;x;y;links\no;pin;0,5;0;frame a\np;pin;1.5;7;a\n";
    let message = refused(table, Format::JointTable);
    assert!(
        message.contains("decimal points, and others have commas"),
        "{message}"
    );
    let thousands = table.replace("0,5", "1.000,5");
    let message = refused(&thousands, Format::JointTable);
    assert!(
        message.starts_with("line 2: x of `o` is `1.000,5`"),
        "{message}"
    );
}

/// A message about what is missing names what can be written there, or the format that was taken.
#[test]
fn what_is_missing_is_named_with_advice() {
    let table = "name,kind,x,y,links\no,motor,0,0,frame crank\nb,slot,8,1,frame crank\n";
    assert_eq!(
        refused(table, Format::JointTable),
        "line 3: the slot `b` has no `along`\nhelp: it is the direction in degrees, or two joints \
         of the link that has the slot"
    );
    let foreign = import(
        br#"{"robot": {"joints": 3}}"#,
        "a.json",
        &Options::default(),
    );
    let message = foreign.expect_err("another program").to_string();
    assert!(
        message
            .starts_with("the file has no list `joints`\nhelp: it is read as a file of pylinkage"),
        "{message}"
    );
    assert!(message.contains("`--format`"), "{message}");
    let already = import(b"pub struct A {}", "a.mech", &Options::default());
    let message = already.expect_err("a mechanism").to_string();
    assert!(
        message.starts_with("`a.mech` is a mechanism already\nhelp: "),
        "{message}"
    );
}
