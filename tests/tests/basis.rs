//! The basis against values of an independent library: what no product or rotation can see, its signs.

use sh_core::Routines;
use sh_reference::scipy;

#[test]
fn scipy_values() {
    let samples = scipy::samples();
    assert!(samples.len() >= 30, "only {} directions", samples.len());
    for sample in samples {
        let ours = <[f64; 36]>::basis(sample.direction);
        for (i, (a, b)) in ours.iter().zip(&sample.values).enumerate() {
            assert!(
                (a - b).abs() < 1e-14,
                "coefficient {i} at {:?}: {a}, SciPy {b}",
                sample.direction
            );
        }
    }
}

/// Lower orders are the first coefficients of higher ones.
#[test]
fn orders_nest() {
    let d = [0.48, -0.6, 0.64];
    let most = <[f64; 36]>::basis(d);
    assert_eq!(<[f64; 4]>::basis(d), most[..4]);
    assert_eq!(<[f64; 9]>::basis(d), most[..9]);
    assert_eq!(<[f64; 16]>::basis(d), most[..16]);
    assert_eq!(<[f64; 25]>::basis(d), most[..25]);
}
