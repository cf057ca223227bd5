//! Keyword arguments to settings. Which there are, what they default to and what they may be stands in one
//! place, the library's [`Settings`].

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyString};
use toml::{Table, Value};
use tresca::Settings;

use crate::errors;

/// (name, what it does, default, allowed values) of every option, as a case file spells them.
#[pyfunction]
pub fn options() -> Vec<(&'static str, String, String, String)> {
    Settings::options()
        .iter()
        .map(|option| {
            (
                option.name,
                option.doc.clone(),
                option.default.clone(),
                option.allowed.clone(),
            )
        })
        .collect()
}

/// `base` with the options of a call on top; `None` leaves an option as it is.
pub fn over(base: &Settings, options: &Bound<'_, PyDict>) -> PyResult<Settings> {
    let mut table = Table::try_from(base).map_err(errors::problem)?;
    for (key, value) in options.iter() {
        let name: String = key.extract()?;
        if !table.contains_key(&name) {
            let known: Vec<_> = Settings::options().iter().map(|o| o.name).collect();
            return Err(PyTypeError::new_err(format!(
                "there is no option `{name}`: expected one of {}",
                known.join(", ")
            )));
        }
        if !value.is_none() {
            let value = of_toml(&name, &value)?;
            table.insert(name, value);
        }
    }
    let settings: Settings = table
        .try_into()
        .map_err(|error: toml::de::Error| errors::problem(error.to_string().trim_end()))?;
    settings.validate().map_err(errors::problem)?;
    Ok(settings)
}

fn of_toml(name: &str, value: &Bound<'_, PyAny>) -> PyResult<Value> {
    if value.is_instance_of::<PyString>() {
        Ok(Value::String(value.extract()?))
    } else if value.is_instance_of::<PyBool>() {
        Ok(Value::Boolean(value.extract()?))
    } else if value.is_instance_of::<PyFloat>() {
        Ok(Value::Float(value.extract()?))
    } else if let Ok(integer) = value.extract::<i64>() {
        Ok(Value::Integer(integer))
    } else if let Ok(number) = value.extract::<f64>() {
        Ok(Value::Float(number))
    } else {
        Err(PyTypeError::new_err(format!(
            "the option `{name}` is {}: expected a number or a word",
            value.repr()?
        )))
    }
}
