//! Tables and summaries hold what was put in, and no number that is none.

use std::collections::BTreeMap;

use serde::Serialize;
use tresca_io::history::{History, Value};
use tresca_io::pvd::{self, PvdPart};
use tresca_io::summary;

#[test]
fn a_history_reads_back_to_the_same_numbers() {
    let numbers = [0.1, 1.0 / 3.0, 1e-300, -2.5e17, 5e-324, f64::MAX, -0.0];
    let mut history = History::new(&["k", "q, decrease", "step"]);
    for (k, &number) in numbers.iter().enumerate() {
        let step = (k > 0).then_some(number);
        history
            .push(&[k.into(), number.into(), step.into()])
            .unwrap();
    }
    assert_eq!(history.rows(), numbers.len());
    let mut file = Vec::new();
    history.write(&mut file).unwrap();

    let mut reader = csv::Reader::from_reader(file.as_slice());
    assert_eq!(reader.headers().unwrap(), vec!["k", "q, decrease", "step"]);
    for (k, row) in reader.records().map(Result::unwrap).enumerate() {
        assert_eq!(row[0].parse::<usize>().unwrap(), k);
        let number: f64 = row[1].parse().unwrap();
        assert_eq!(number.to_bits(), numbers[k].to_bits());
        assert_eq!(row[2].is_empty(), k == 0);
    }
}

#[test]
fn a_history_refuses_rows_that_do_not_fit() {
    let mut history = History::new(&["k", "residual"]);
    history.push(&[Value::Integer(0), 1.0.into()]).unwrap();
    let error = history.push(&[Value::Integer(1), f64::NAN.into()]);
    assert_eq!(
        error.unwrap_err().to_string(),
        "`residual` is not a finite number at row 1: NaN"
    );
    let error = history.push(&[Value::Integer(1)]);
    assert_eq!(
        error.unwrap_err().to_string(),
        "`row 1` has 1 values, expected 2"
    );
    assert_eq!(history.rows(), 1);
}

#[derive(Serialize)]
struct Summary {
    status: &'static str,
    iterations: usize,
    certificate: BTreeMap<&'static str, f64>,
    pairs: Vec<Pair>,
}

#[derive(Serialize)]
struct Pair {
    normal_force_sum: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<f64>,
    plain: Option<f64>,
}

fn example(gap: f64, plain: Option<f64>) -> Summary {
    Summary {
        status: "converged",
        iterations: 9,
        certificate: BTreeMap::from([("duality_gap", gap), ("equilibrium", 1e-15)]),
        pairs: vec![Pair {
            normal_force_sum: 2.0,
            note: None,
            plain,
        }],
    }
}

fn written(summary: &Summary) -> Result<String, String> {
    let mut file = Vec::new();
    summary::write(&mut file, summary)
        .map(|()| String::from_utf8(file).unwrap())
        .map_err(|error| error.to_string())
}

#[test]
fn a_summary_keeps_the_order_of_its_keys() {
    insta::assert_snapshot!(written(&example(1e-12, Some(0.1))).unwrap(), @r#"
    {
      "status": "converged",
      "iterations": 9,
      "certificate": {
        "duality_gap": 1e-12,
        "equilibrium": 1e-15
      },
      "pairs": [
        {
          "normal_force_sum": 2.0,
          "plain": 0.1
        }
      ]
    }
    "#);
}

#[test]
fn a_summary_refuses_what_json_cannot_say() {
    let refused = |summary| written(&summary).unwrap_err();
    assert_eq!(
        refused(example(f64::NAN, Some(0.0))),
        "the summary has no finite number at `certificate.duality_gap`"
    );
    assert_eq!(
        refused(example(0.0, Some(f64::INFINITY))),
        "the summary has no finite number at `pairs.0.plain`"
    );
    assert_eq!(
        refused(example(0.0, None)),
        "the summary has no finite number at `pairs.0.plain`"
    );
}

#[test]
fn a_collection_numbers_its_parts_per_instant() {
    let part = |name, file, time| PvdPart { name, file, time };
    let mut file = Vec::new();
    pvd::write(
        &mut file,
        &[
            part("a", "a-0.vtu", 0.0),
            part("b", "b-0.vtu", 0.0),
            part("a", "a-1.vtu", 0.5),
        ],
    )
    .unwrap();
    let text = String::from_utf8(file).unwrap();
    let of = |name: &str| {
        text.lines()
            .find(|line| line.contains(name))
            .unwrap()
            .trim()
    };
    assert_eq!(
        of("b-0.vtu"),
        r#"<DataSet timestep="0.0" part="1" name="b" file="b-0.vtu"/>"#
    );
    assert_eq!(
        of("a-1.vtu"),
        r#"<DataSet timestep="0.5" part="0" name="a" file="a-1.vtu"/>"#
    );
    let error = pvd::write(&mut Vec::new(), &[part("a", "a.vtu", f64::NAN)]);
    assert_eq!(
        error.unwrap_err().to_string(),
        "`time` is not a finite number at part `a`: NaN"
    );
}
