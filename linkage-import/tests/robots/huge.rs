//! Huge files of robots and of suspensions: a text or a message, within bounded memory and time.

use std::fmt::Write;

use linkage_import::{Format, Options, import};

use crate::hard_points;
use crate::memory::bounded;

/// Seconds that a file may take: one that is not optimized by the compiler included.
const SECONDS: u64 = 120;

const ROBOTS: [(Format, &str); 3] = [
    (Format::Urdf, "robot"),
    (Format::Sdf, "sdf"),
    (Format::Mjcf, "mujoco"),
];

fn of_format(format: Format) -> Options {
    Options {
        format: Some(format),
        ..Options::default()
    }
}

fn refused(content: &str, options: &Options) -> String {
    let result = import(content.as_bytes(), "a", options);
    result.expect_err("a file that is refused").to_string()
}

/// Entities that would become billions of letters are not read at all.
#[test]
fn xml_bombs_are_refused() {
    for (format, root) in ROBOTS {
        let mut bomb = format!("<!DOCTYPE {root} [<!ENTITY a0 \"ha\">");
        for level in 1..40 {
            let longer = format!("&a{};", level - 1).repeat(10);
            let _ = write!(bomb, "<!ENTITY a{level} \"{longer}\">");
        }
        let alone = format!("<{root} name=\"&a39;\"/>");
        bounded(root, SECONDS, || {
            let bomb = format!("{bomb}]>{alone}");
            assert!(refused(&bomb, &of_format(format)).contains("document type"));
            assert!(refused(&alone, &of_format(format)).contains("broken at byte"));
        });
    }
}

#[test]
fn deep_and_wide_robots_are_refused() {
    for (format, root) in ROBOTS {
        bounded(root, SECONDS, || {
            let deep = format!("<{root}>").repeat(1_000_000);
            assert!(refused(&deep, &of_format(format)).contains("nested too deeply"));
            let wide = format!("<{root}>{}</{root}>", "<a/>".repeat(2_000_000));
            assert!(refused(&wide, &of_format(format)).contains("more than 100000 elements"));
            let attributes = "a=\"1\" ".repeat(1_000_000);
            let long = format!("<{root} {attributes}/>");
            assert!(refused(&long, &of_format(format)).contains("broken at byte"));
            let name = "x".repeat(15_000_000);
            let named = refused(&format!("<{root} name=\"{name}\"/>"), &of_format(format));
            assert!(named.len() < 500, "{named}");
        });
    }
}

/// A number of a file that no mechanism has.
#[test]
fn huge_numbers_are_refused() {
    let digits = "9".repeat(1_000_000);
    let urdf = |number: &str| {
        format!(
            "<robot name=\"a\"><link name=\"b\"/><link name=\"c\"/><joint name=\"j\" \
             type=\"revolute\"><parent link=\"b\"/><child link=\"c\"/>\
             <origin xyz=\"{number} 0 0\"/></joint></robot>"
        )
    };
    let sdf = |number: &str| {
        format!(
            "<sdf version=\"1.7\"><model name=\"a\"><link name=\"b\"/><link name=\"c\">\
             <pose>{number} 0 0 0 0 0</pose></link><joint name=\"j\" type=\"revolute\">\
             <parent>b</parent><child>c</child><axis><xyz>0 0 1</xyz></axis></joint></model></sdf>"
        )
    };
    let mjcf = |number: &str| {
        format!(
            "<mujoco><worldbody><body name=\"b\" pos=\"{number} 0 0\"><joint/></body>\
             </worldbody></mujoco>"
        )
    };
    for (number, part) in [
        ("1e999", "too large"),
        ("1e300", "too large"),
        ("NaN", "no number"),
        (&digits, "no number"),
    ] {
        for (format, content) in [
            (Format::Urdf, urdf(number)),
            (Format::Sdf, sdf(number)),
            (Format::Mjcf, mjcf(number)),
        ] {
            let message = refused(&content, &of_format(format));
            assert!(message.contains(part), "{message}");
            assert!(message.len() < 500, "{message}");
        }
        let points = hard_points("forward,left,up", "left");
        let table = format!("lower_front,{number},0,0\n");
        assert!(!refused(&table, &points).is_empty());
    }
}

/// Four-bars next to each other: each has an input, and all are one system of equations.
#[test]
fn large_robots_take_bounded_time() {
    let mut urdf = "<robot name=\"many\"><link name=\"base\"/>".to_owned();
    for number in 0..130 {
        let mut link = |name: &str, parent: &str, xyz: &str| {
            let _ = write!(
                urdf,
                "<link name=\"{name}{number}\"/><joint name=\"j_{name}{number}\" type=\"continuous\">\
                 <parent link=\"{parent}\"/><child link=\"{name}{number}\"/>\
                 <origin xyz=\"{xyz}\"/><axis xyz=\"0 0 1\"/></joint>"
            );
        };
        link("crank", "base", "0 0 0");
        link("coupler", &format!("crank{number}"), "0 0.1 0");
        link("rocker", "base", "0.4 0 0");
        let _ = write!(
            urdf,
            "<loop_joint name=\"loop{number}\" type=\"spherical\">\
             <link1 link=\"coupler{number}\" xyz=\"0.3 0.1 0\"/>\
             <link2 link=\"rocker{number}\" xyz=\"-0.1 0.2 0\"/></loop_joint>"
        );
    }
    let closures = (0..500).map(|_| "ball,coupler0,0.3,0.1,0,rocker0\n");
    let closures = "kind,link1,x1,y1,z1,link2\n".to_owned() + &closures.collect::<String>();
    urdf += "</robot>";
    bounded("many four-bars", SECONDS, || {
        let imported = import(urdf.as_bytes(), "a.urdf", &Options::default()).expect("a text");
        let is_warned = |warning: &String| warning.contains("too large for a search of ranges");
        assert!(imported.warnings.iter().any(is_warned));
        let options = Options {
            closures: Some(closures),
            ..of_format(Format::Urdf)
        };
        assert!(refused(&urdf, &options).contains("more than 400 loops"));
    });
    let fixed = (0..20_000).map(|number| {
        format!(
            "<link name=\"l{}\"/><joint name=\"f{number}\" type=\"fixed\">\
             <parent link=\"l{number}\"/><child link=\"l{}\"/></joint>",
            number + 1,
            number + 1
        )
    });
    let fixed: String = fixed.collect();
    bounded("fixed links", SECONDS, || {
        let urdf = format!("<robot name=\"a\"><link name=\"l0\"/>{fixed}</robot>");
        assert!(refused(&urdf, &of_format(Format::Urdf)).contains("nothing moves"));
    });
}

#[test]
fn huge_tables_of_points_are_refused() {
    let options = hard_points("forward,left,up", "left");
    let rows: String = (0..500_000).map(|row| format!("p{row},1,2,3\n")).collect();
    let deep = format!("a: {}", "[".repeat(1_000_000));
    // Aliases that would become billions of numbers.
    let mut aliases = "a0: &a0 [1, 2, 3]\n".to_owned();
    for level in 1..40 {
        let last = format!("*a{}, ", level - 1).repeat(10);
        let _ = writeln!(aliases, "a{level}: &a{level} [{last}]");
    }
    let long = format!("lower_front,{},0,0\n", "1".repeat(15_000_000));
    for (name, content) in [
        ("a.csv", &rows),
        ("a.yaml", &deep),
        ("a.yaml", &aliases),
        ("a.csv", &long),
    ] {
        bounded(name, SECONDS, || {
            let result = import(content.as_bytes(), name, &options);
            let message = result.expect_err("no suspension").to_string();
            assert!(message.len() < 20_000, "{} letters", message.len());
        });
    }
}
