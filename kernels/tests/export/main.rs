//! The exported files: what is checked in, the names in them, whether their real compilers take them, and the numbers
//! that come out of them.
//!
//! A test whose compiler or device is missing shows as ignored; with `GAUNT_REQUIRE_COMPILERS=1` and
//! `GAUNT_REQUIRE_GPU=1` it fails. `GAUNT_REWRITE=1` writes `kernels/include` anew.

mod compilers;
mod device;
mod files;
mod numbers;
mod samples;

use libtest_mimic::{Arguments, Failed, Trial};
use sh_kernels::export::Language;
use std::sync::Arc;

fn main() {
    let arguments = Arguments::from_args();
    let mut trials: Vec<Trial> = files::TESTS
        .iter()
        .map(|&(name, test)| {
            Trial::test(name, move || {
                test();
                Ok(())
            })
        })
        .collect();
    for language in Language::ALL {
        let name = format!("compiles::{}", language.name().replace([' ', ','], "_"));
        let test = move || compilers::check(language);
        trials.push(needs(
            name,
            compilers::missing(language),
            "GAUNT_REQUIRE_COMPILERS",
            test,
        ));
    }
    let device = device::Device::open().map(Arc::new);
    for (language, orders) in numbers::RUNS {
        for order in orders {
            let name = format!("runs::{}_{order}", language.option());
            let opened = device.clone();
            let glslang = compilers::missing(language).filter(|_| language == Language::Glsl450);
            trials.push(match (&device, glslang) {
                (Err(reason), _) => {
                    needs(name, Some(reason.clone()), "GAUNT_REQUIRE_GPU", || Ok(()))
                }
                (_, missing) => needs(name, missing, "GAUNT_REQUIRE_COMPILERS", move || {
                    numbers::check(&*opened?, language, *order)
                }),
            });
        }
    }
    libtest_mimic::run(&arguments, trials).exit();
}

/// A test that something may be missing for.
fn needs(
    name: String,
    missing: Option<String>,
    required: &str,
    test: impl FnOnce() -> Result<(), Failed> + Send + 'static,
) -> Trial {
    let required = std::env::var_os(required).is_some_and(|value| value != "0");
    match missing {
        None => Trial::test(name, test),
        Some(reason) => {
            Trial::test(name, move || Err(Failed::from(reason))).with_ignored_flag(!required)
        }
    }
}
