//! JSON and the page.

use crate::fixture::{FourBar, MOTION, PHI, Sweep};
use crate::four_bar;
use crate::once::series;
use crate::packed::page_data;
use linkage_analysis::summary::Curve;
use linkage_report::{Report, SummaryRow};
use linkage_runtime::{AssemblyMode, Group, Operations, Structure, Table};
use serde_json::Value;

const STRUCTURE: Structure = Structure {
    mobility: 1,
    groups: &[
        Group {
            class: 2,
            order: 2,
            kind: "RRR",
            loops: &[1],
            joints: "",
            unknowns: &["theta", "psi"],
            mode: Some(0),
            method: "intersection of two circles",
        },
        Group {
            class: 0,
            order: 0,
            kind: "angle",
            loops: &[2],
            joints: "",
            unknowns: &["chi"],
            mode: None,
            method: "linear",
        },
    ],
    functions: &[],
    prepare: Operations {
        add: 3,
        mul: 4,
        div: 0,
        sqrt: 0,
        sin_cos: 0,
        atan2: 0,
        other: 0,
    },
};

pub(crate) fn json(report: &Report) -> Value {
    serde_json::from_str(&report.json().unwrap()).unwrap()
}

pub(crate) fn numbers(value: &Value) -> Vec<f64> {
    let values = value.as_array().unwrap().iter();
    values.map(|x| x.as_f64().unwrap_or(f64::NAN)).collect()
}

/// Equal to the last bit; all NaN are equal.
pub(crate) fn same(a: &[f64], b: &[f64]) -> bool {
    let bits = |x: &f64| if x.is_nan() { None } else { Some(x.to_bits()) };
    a.iter().map(bits).eq(b.iter().map(bits))
}

#[test]
fn json_has_every_number_to_the_last_bit() {
    for mechanism in [FourBar::NOMINAL, FourBar::GAPPED] {
        let phi = PHI.positions(361);
        let json = json(&four_bar(mechanism));
        assert!(same(&numbers(&json["input"]["values"]), &phi));
        for (index, sweep) in [
            mechanism.motion(&phi),
            mechanism.accuracy(&phi),
            mechanism.picture(&phi),
        ]
        .iter()
        .enumerate()
        {
            let columns = json["tables"][index]["columns"].as_array().unwrap();
            assert_eq!(columns.len(), sweep.heading().columns.len());
            for (i, column) in columns.iter().enumerate() {
                assert_eq!(column["name"], sweep.heading().columns[i].name);
                assert_eq!(column["unit"], sweep.heading().columns[i].unit);
                assert!(
                    same(&series(&json, &column["values"]), sweep.column(i)),
                    "{column}"
                );
            }
        }
    }
}

#[test]
fn columns_tell_what_they_mean() {
    let json = json(&four_bar(FourBar::NOMINAL));
    let acceleration = &json["tables"][0]["columns"][4];
    assert_eq!(acceleration["meaning"], "rate");
    assert_eq!(
        (&acceleration["order"], &acceleration["of"]),
        (&Value::from(2), &Value::from("tracer.x"))
    );
    let sensitivity = &json["tables"][1]["columns"][5];
    assert_eq!(sensitivity["meaning"], "sensitivity");
    assert_eq!(
        (&sensitivity["parameter"], &sensitivity["of"]),
        (&Value::from("coupler"), &Value::from("tracer.y"))
    );
    assert_eq!(json["tables"][2]["columns"][0]["meaning"], "picture");
}

#[test]
fn the_picture_has_places_links_and_traces() {
    let phi = PHI.positions(361);
    let whole = json(&four_bar(FourBar::NOMINAL));
    let picture = &whole["picture"];
    assert_eq!(picture["dimension"], 2);
    assert_eq!(picture["unit"], "mm");
    assert_eq!(picture["points"][4]["kind"], "tip");
    assert_eq!(picture["links"][1]["points"], serde_json::json!([2, 3, 4]));
    assert_eq!(
        picture["traces"],
        serde_json::json!([4]),
        "tips without being asked"
    );
    let asked = four_bar(FourBar::NOMINAL)
        .trace("b")
        .trace("tracer")
        .trace("b");
    let asked = json(&asked);
    assert_eq!(
        asked["picture"]["traces"],
        serde_json::json!([3, 4]),
        "each once"
    );
    let tracer = series(&whole, &picture["points"][4]["at"][1]);
    let expected: Vec<f64> = phi
        .iter()
        .map(|phi| FourBar::NOMINAL.points(*phi)[4][1])
        .collect();
    assert!(same(&tracer, &expected));
}

#[test]
fn the_rest_is_there_too() {
    let report = four_bar(FourBar::NOMINAL)
        .note("Dimensions made up.")
        .structure(&STRUCTURE)
        .modes(&[AssemblyMode::Minus])
        .summary([
            SummaryRow::new("psi", "stroke", 1.25, "rad"),
            SummaryRow::new("psi", "upper limit", f64::NAN, "rad").at_input(0.1 + 0.2),
        ])
        .fact("Grashof", "crank-rocker");
    let json = json(&report);
    assert_eq!(json["title"], "Crank-rocker");
    assert_eq!(json["notes"][0], "Dimensions made up.");
    assert_eq!(json["structure"]["groups"][0]["mode"], "-");
    assert_eq!(json["structure"]["groups"][1]["mode"], Value::Null);
    assert_eq!(json["structure"]["groups"][0]["unknowns"][1], "psi");
    assert_eq!(json["structure"]["prepare"]["mul"], 4);
    assert_eq!(json["dimensions"][1]["name"], "coupler");
    assert_eq!(json["dimensions"][1]["tolerance"], 0.02);
    assert_eq!(json["summary"][0]["at"], Value::Null);
    assert_eq!(json["summary"][1]["at"], 0.1 + 0.2);
    assert_eq!(json["summary"][1]["value"], Value::Null);
    assert_eq!(json["facts"][0]["text"], "crank-rocker");
    assert_eq!(json["speed"], Value::Null);
}

#[test]
fn a_turn_closes_unless_there_are_gaps_or_it_is_none() {
    assert_eq!(json(&four_bar(FourBar::NOMINAL))["input"]["periodic"], true);
    let half: Vec<f64> = PHI.positions(361)[..181].to_vec();
    let report = Report::new("half", &PHI, &half).table(&FourBar::NOMINAL.motion(&half));
    assert_eq!(json(&report)["input"]["periodic"], false);
    // It starts in the gap.
    let from_pi: Vec<f64> = PHI.positions(361).iter().map(|x| x + 3.0).collect();
    let report = Report::new("gap", &PHI, &from_pi).table(&FourBar::GAPPED.motion(&from_pi));
    assert_eq!(json(&report)["input"]["periodic"], false);
    // An angle that is one turn larger at the end is the same.
    let phi = PHI.positions(73);
    let wound = Sweep::new(&MOTION, &phi, |phi| {
        vec![phi.cos(), 0.0, 0.0, 0.0, 0.0, 0.0, 1.0 + phi]
    });
    assert_eq!(
        json(&Report::new("wound", &PHI, &phi).table(&wound))["input"]["periodic"],
        true
    );
    let risen = Sweep::new(&MOTION, &phi, |phi| vec![phi, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]);
    assert_eq!(
        json(&Report::new("risen", &PHI, &phi).table(&risen))["input"]["periodic"],
        false
    );
}

#[test]
fn gaps_are_ranges_of_the_input() {
    assert_eq!(
        json(&four_bar(FourBar::NOMINAL))["gaps"],
        serde_json::json!([])
    );
    let gaps = &json(&four_bar(FourBar::GAPPED))["gaps"];
    assert_eq!(gaps.as_array().unwrap().len(), 1);
    let ends = ["from", "to"].map(|end| gaps[0][end].as_f64().unwrap().to_degrees().round());
    assert_eq!(ends, [133.0, 227.0]);
}

#[test]
fn the_figures_of_a_course_are_listed() {
    let yoke = |phi: f64| [40.0 * phi.sin(), 40.0 * phi.cos(), -40.0 * phi.sin()];
    let course = Curve::new((0.0, std::f64::consts::TAU), 360, yoke).unwrap();
    let report = four_bar(FourBar::NOMINAL).course("yoke", "mm", &course);
    let json = json(&report);
    let rows = json["summary"].as_array().unwrap();
    let heads: Vec<_> = rows
        .iter()
        .map(|row| ["what", "unit"].map(|key| row[key].as_str().unwrap()))
        .collect();
    assert_eq!(
        heads,
        [
            ["lowest", "mm"],
            ["highest", "mm"],
            ["stroke", "mm"],
            ["least velocity", "mm/rad"],
            ["greatest velocity", "mm/rad"],
            ["rises in", "rad"],
            ["falls in", "rad"],
            ["time ratio", ""],
        ]
    );
    assert!(rows.iter().all(|row| row["quantity"] == "yoke"));
    assert_eq!(
        (&rows[2]["value"], &rows[2]["at"]),
        (&Value::from(80.0), &Value::Null)
    );
    let at = rows[1]["at"].as_f64().unwrap();
    assert!((at - std::f64::consts::FRAC_PI_2).abs() < 1e-15, "{at}");
}

#[test]
fn true_rates_keep_names_and_change_units() {
    let json = json(&four_bar(FourBar::NOMINAL).speed(20.0, 0.0));
    let rates = json["true"].as_array().unwrap();
    let names: Vec<_> = rates
        .iter()
        .map(|r| (r["name"].as_str().unwrap(), r["unit"].as_str().unwrap()))
        .collect();
    assert_eq!(
        names,
        [
            ("v.x", "mm/s"),
            ("v.y", "mm/s"),
            ("a.x", "mm/s^2"),
            ("a.y", "mm/s^2")
        ]
    );
    let analogue = numbers(&json["tables"][0]["columns"][4]["values"]);
    let expected: Vec<f64> = analogue.iter().map(|a| a * 400.0).collect();
    assert!(same(&numbers(&rates[2]["values"]), &expected));
    assert_eq!(rates[2]["table"], "motion");
}

#[test]
fn the_page_has_the_data_and_needs_no_network() {
    let title = "Crank & <rocker> </script><!-- report -->";
    let phi = PHI.positions(37);
    let report = Report::new(title, &PHI, &phi)
        .about("</script>")
        .table(&FourBar::NOMINAL.motion(&phi));
    let page = report.html().unwrap();
    assert!(page.contains(
        "<title>Crank &amp; &lt;rocker&gt; &lt;/script&gt;&lt;!-- report --&gt;</title>"
    ));
    let start = "<script type=\"application/json\" id=\"report\">";
    assert_eq!(page.matches(start).count(), 1);
    let data = page_data(&page);
    assert_eq!(data, json(&report));
    assert_eq!(data["title"], title);
    for address in [
        "http://",
        "https://",
        // An attribute, and no assignment of a script.
        " src=",
        "@import",
        "<!-- style",
        "<!-- script",
    ] {
        let found = page
            .match_indices(address)
            .map(|(at, _)| &page[at..page.len().min(at + 60)]);
        // The name of SVG is no address that is loaded.
        let found: Vec<&str> = found
            .filter(|text| !text.starts_with("http://www.w3.org/"))
            .collect();
        assert!(found.is_empty(), "{found:?}");
    }
}
