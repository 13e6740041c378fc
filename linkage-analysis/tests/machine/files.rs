//! Cyclograms as CSV, JSON and pictures.

use crate::cyclogram::member;
use linkage_analysis::cyclogram::{Band, Cyclogram};
use linkage_formats::CsvStyle;

#[test]
fn files() {
    let lift = |lead: f64| move |x: f64| [(x + lead).cos(), -(x + lead).sin(), -(x + lead).cos()];
    let members = [("hook & eye", 0.0), ("press", 1.0)].map(|(name, lead)| {
        member(name, lift(lead), &[Band::Top(0.5)])
            .expect("an organ")
            .unit("mm")
            .sensitivities(|x| [x.cos()], |x| [-x.sin()])
    });
    let machine = Cyclogram::new(members).expect("a machine");
    let csv = machine
        .csv(&CsvStyle::default().degrees(true).digits(6))
        .expect("CSV");
    assert_eq!(
        csv,
        "organ,motion,band,from [deg],to [deg],range [deg],+- from [deg],+- to [deg]\r\n\
         hook & eye,return,,60.0000,180.000,120.000,,\r\n\
         hook & eye,advance,,180.000,300.000,120.000,,\r\n\
         hook & eye,dwell,top 0.5,300.000,60.0000,120.000,,\r\n\
         press,return,,2.70422,122.704,120.000,,\r\n\
         press,advance,,122.704,242.704,120.000,,\r\n\
         press,dwell,top 0.5,242.704,2.70422,120.000,,\r\n"
    );
    let degrees = CsvStyle::default().degrees(true).digits(6);
    assert_eq!(
        machine.order_csv(&degrees).expect("CSV"),
        "at [deg],+- at [deg],event,after [deg],after what\r\n\
         2.70422,,press's dwell (top 0.5 mm) ends,62.7042,hook & eye's dwell (top 0.5 mm) begins\r\n\
         60.0000,,hook & eye's dwell (top 0.5 mm) ends,57.2958,press's dwell (top 0.5 mm) ends\r\n\
         122.704,,press's advance begins,62.7042,hook & eye's dwell (top 0.5 mm) ends\r\n\
         180.000,,hook & eye's advance begins,57.2958,press's advance begins\r\n\
         242.704,,press's dwell (top 0.5 mm) begins,62.7042,hook & eye's advance begins\r\n\
         300.000,,hook & eye's dwell (top 0.5 mm) begins,57.2958,press's dwell (top 0.5 mm) begins\r\n"
    );
    assert_eq!(
        machine.overlaps_csv(&degrees).expect("CSV"),
        "organ,motion,band,other organ,its motion,its band,from [deg],to [deg],range [deg]\r\n\
         hook & eye,return,,press,return,,60.0000,122.704,62.7042\r\n\
         hook & eye,advance,,press,advance,,180.000,242.704,62.7042\r\n\
         hook & eye,dwell,top 0.5,press,dwell,top 0.5,300.000,2.70422,62.7042\r\n"
    );
    let wrong = CsvStyle::default().separator("1");
    assert!(machine.csv(&wrong).is_err());
    assert!(machine.order_csv(&wrong).is_err() && machine.overlaps_csv(&wrong).is_err());
    let json: serde_json::Value = serde_json::from_str(&machine.json()).expect("JSON");
    let at = json["organs"][1]["events"][2]["at"].as_f64();
    assert_eq!(at, Some(machine.members()[1].events()[2].at));
    let bounds = &json["organs"][0]["bounds"];
    assert_eq!(*bounds, serde_json::json!([["top", 0.5]]));
    assert_eq!(json["order"].as_array().map(Vec::len), Some(6));
    // The first event of the cycle follows the last one.
    let follows = &json["order"][0]["follows"];
    assert_eq!(*follows, serde_json::json!({ "organ": 0, "event": 2 }));
    let found = machine.overlaps();
    for (own, overlap) in found.all().iter().enumerate() {
        let told = &json["overlaps"][own];
        assert_eq!(told["organs"], serde_json::json!(overlap.members));
        assert_eq!(told["from"].as_f64(), Some(overlap.interval.from));
        assert_eq!(told["range"].as_f64(), Some(overlap.interval.range));
    }
    assert_eq!(
        json["overlaps"][2]["motions"],
        serde_json::json!(["dwell", "dwell"])
    );
    assert_eq!(json["overlaps"][2]["bands"], serde_json::json!([0, 0]));
    assert_eq!(
        json["overlaps"].as_array().map(Vec::len),
        Some(found.all().len())
    );
    assert_eq!(
        json["organs"][0]["events"][0]["sensitivity"]
            .as_array()
            .map(Vec::len),
        Some(1)
    );

    let svg = machine.svg().expect("a picture");
    let drawing = roxmltree::Document::parse(&svg).expect("XML");
    let class = |name: &str| {
        drawing
            .descendants()
            .filter(|node| {
                node.attribute("class")
                    .is_some_and(|own| own.split(' ').any(|word| word == name))
            })
            .count()
    };
    // Both dwells go across the seam: two bars each.
    assert_eq!((class("organ"), class("dwell")), (2, 4));
    // Where an angle is: on the axis, whose ends have theirs.
    let axis = drawing.descendants().find(|node| {
        node.attribute("class")
            .is_some_and(|own| own.split(' ').any(|word| word == "shaft"))
    });
    let number = |name: &str| {
        axis.and_then(|axis| axis.attribute(name)?.parse::<f64>().ok())
            .expect(name)
    };
    let share = (machine.members()[1].events()[0].at - number("data-from"))
        / (number("data-to") - number("data-from"));
    let place = number("x1") + share * (number("x2") - number("x1"));
    let circles = drawing
        .descendants()
        .filter(|node| node.has_tag_name("circle"));
    let mut places = circles.filter_map(|node| node.attribute("cx")?.parse::<f64>().ok());
    assert!(places.any(|x| (x - place).abs() < 1e-3), "{place}");
    assert!(
        svg.contains("60.00")
            && svg.contains("prefers-color-scheme: dark")
            && svg.contains("hook &amp; eye")
    );
    let member = member("a\u{1}b", lift(0.0), &[Band::Top(0.5)]).expect("an organ");
    assert!(Cyclogram::new([member]).expect("a machine").svg().is_err());
}
