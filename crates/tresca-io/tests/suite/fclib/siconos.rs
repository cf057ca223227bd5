//! The problems that came from Siconos, as they were printed.

use tresca_io::fclib::read;

use super::{data, global, local, matrix};

/// A number as it is printed in the file.
fn number(text: &str) -> f64 {
    text.parse().unwrap()
}

#[test]
fn a_plane_local_problem() {
    let document = read(&data("FC2D_SliderCrankLagrangian00000.dat")).unwrap();
    let problem = local(&document.problem);
    assert_eq!(problem.dimension, 2);
    assert_eq!(problem.friction, [0.01, 0.01]);
    // The text has columns in its lines.
    let entry = |place: (usize, usize)| {
        let entries = problem.w.entries().iter();
        entries.clone().find(|e| (e.0, e.1) == place).unwrap().2
    };
    assert_eq!(entry((1, 0)), number("-4.642665883420582986218506e+02"));
    assert_eq!(entry((0, 1)), number("-4.642662921766745967033785e+02"));
    assert_eq!(problem.q[3], number("-8.407368208001527065675873e+00"));
}

#[test]
fn local_problems_in_space() {
    for (name, first) in [
        ("Rover1039.dat", "1.399132380123367484781038e-02"),
        ("Rover4516.dat", "1.384671605597719359903586e-02"),
    ] {
        let document = read(&data(name)).unwrap();
        let problem = local(&document.problem);
        assert_eq!((problem.dimension, problem.q.len()), (3, 12));
        assert_eq!(problem.w.entries()[0], (0, 0, number(first)));
        assert_eq!(problem.friction, [0.7; 4]);
        assert!(document.solution.is_none() && document.guesses.is_empty());
    }
}

#[test]
fn global_problems_dense_and_by_blocks() {
    let document = read(&data("GFC3D_Example00.dat")).unwrap();
    let problem = global(&document.problem);
    let identity = matrix(&[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    assert_eq!((&problem.m, &problem.h), (&identity, &identity));
    assert_eq!(
        (problem.f.as_slice(), problem.w.as_slice()),
        (&[-1.0; 3][..], &[0.0; 3][..])
    );
    assert_eq!(problem.friction, [0.1]);

    let document = read(&data("GFC3D_Example00_badly_scaled.dat")).unwrap();
    let scaled = matrix(&[[1e-4, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1e4]]);
    assert_eq!(global(&document.problem).m, scaled);

    let document = read(&data("problem-check2.dat")).unwrap();
    let problem = global(&document.problem);
    let mass = matrix(&[
        [106.5, 81.0, 126.5],
        [81.0, 91.5, 110.0],
        [126.5, 110.0, 163.5],
    ]);
    assert_eq!((&problem.m, &problem.h), (&mass, &identity));
    assert_eq!(problem.w, [-2.5, -10.0, -5.5]);
    assert_eq!(problem.friction, [0.5]);
}
