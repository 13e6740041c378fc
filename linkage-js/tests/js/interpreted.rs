//! Descriptions as data: the interpreter gives the numbers of the modules, to the last bit.

use linkage_corpus::given::{Given, golden};
use linkage_js::engine::module_engine;
use linkage_js::{description_data, interpreter};

use crate::page::{WRITTEN, page};

/// The functions of a mechanism at many arguments: how many numbers they are, how many of them are
/// finite, and the first function with other numbers.
const COMPARED: &str = r#"
const compared = (one, other) => {
  const [first, second] = [one, other].map((mechanism) => mechanism.assemble());
  let [count, finite, different] = [0, 0, null];
  for (const { name, arguments: names } of one.functions) {
    for (let k = 0; k < 40; k += 1) {
      const at = names.map((argument, place) => (one.inputs.find((input) => input.name === argument)?.reference ?? 1) + (k - 7) * 0.21 * (place + 1));
      const [here, there] = [[one, first], [other, second]].map(([mechanism, assembly]) => mechanism.columns(assembly, name, ...at).map((column) => column[0]));
      if (written(here) !== written(there)) different ??= name;
      count += here.length;
      finite += here.filter(Number.isFinite).length;
    }
  }
  return [count, finite, different];
};
"#;

#[test]
fn interpreted_programs_are_those_of_modules() {
    let given = golden();
    let interpreter = format!(
        "const fromData = (() => {{\n{}\n{}\nreturn (data) => mechanismOf(revived(data));\n}})();\n",
        module_engine(),
        interpreter()
    );
    let Some(mut page) = page(&given, &format!("{WRITTEN}{COMPARED}{interpreter}")) else {
        return;
    };
    let (mut count, mut finite) = (0.0, 0.0);
    for (index, Given { name, unit }) in given.iter().enumerate() {
        let data = description_data(name, unit);
        let compared = page.value(&format!("compared(mechanisms[{index}], fromData({data}))"));
        assert!(compared[2].is_null(), "{name}: {}", compared[2]);
        count += compared[0].as_f64().expect("a number");
        finite += compared[1].as_f64().expect("a number");
        // It is JSON, with all its numbers.
        let parsed = page.holds(&format!(
            "JSON.stringify(JSON.parse({})) === JSON.stringify({data})",
            serde_json::Value::from(data.as_str())
        ));
        assert!(parsed, "{name}");
    }
    assert!(
        count > 5_000.0 && finite > count / 2.0,
        "{finite} of {count}"
    );
}
