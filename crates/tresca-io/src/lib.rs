//! Files in and out: case files with reports that show the place of an error, and results as VTU,
//! CSV and JSON, written so that a failed run never destroys an earlier result.

pub mod case;
