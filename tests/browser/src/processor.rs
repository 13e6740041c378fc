//! Processor times of the page's threads.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use crate::Page;

/// The tasks of a thread, with their processor times.
const TASK: &str = "ThreadControllerImpl::RunTask";

/// The processor times in milliseconds of the threads of all pages, by the thread's name: while an
/// expression of one page is computed. Other programs of the machine do not change them much.
pub fn processor_times(page: &mut Page, expression: &str) -> BTreeMap<String, f64> {
    let tools = &mut page.tools;
    tools.events.clear();
    tools.call(
        "Tracing.start",
        json!({ "traceConfig": { "includedCategories": ["toplevel"] }, "transferMode": "ReportEvents" }),
    );
    page.value(expression);
    let tools = &mut page.tools;
    tools.call("Tracing.end", json!({}));
    tools.wait("Tracing.tracingComplete");
    let traced = std::mem::take(&mut tools.events);
    let collected = traced
        .iter()
        .filter(|event| event["method"] == "Tracing.dataCollected");
    let events: Vec<&Value> = collected
        .filter_map(|event| event["params"]["value"].as_array())
        .flatten()
        .collect();
    summed(&events)
}

/// The times of all tasks by the names of their threads.
fn summed(events: &[&Value]) -> BTreeMap<String, f64> {
    let thread = |event: &Value| (event["pid"].as_u64(), event["tid"].as_u64());
    let names = events.iter().filter(|event| event["name"] == "thread_name");
    let names: BTreeMap<_, _> = names
        .filter_map(|event| Some((thread(event), event["args"]["name"].as_str()?)))
        .collect();
    let mut times = BTreeMap::new();
    for task in events.iter().filter(|event| event["name"] == TASK) {
        if let Some((name, time)) = names.get(&thread(task)).zip(task["tdur"].as_f64()) {
            *times.entry((*name).to_owned()).or_default() += time / 1000.0;
        }
    }
    times
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tasks_are_summed_by_their_threads() {
        let events = [
            json!({ "name": "thread_name", "pid": 1, "tid": 2, "args": { "name": "main" } }),
            json!({ "name": "thread_name", "pid": 3, "tid": 2, "args": { "name": "worker" } }),
            json!({ "name": TASK, "pid": 1, "tid": 2, "tdur": 1500 }),
            json!({ "name": TASK, "pid": 1, "tid": 2, "tdur": 500 }),
            json!({ "name": TASK, "pid": 3, "tid": 2, "tdur": 250 }),
            json!({ "name": "other", "pid": 3, "tid": 2, "tdur": 250 }),
        ];
        let times = summed(&events.iter().collect::<Vec<_>>());
        let expected = [("main", 2.0), ("worker", 0.25)];
        assert_eq!(
            times,
            expected.map(|(name, time)| (name.to_owned(), time)).into()
        );
    }
}
