//! What entry points are said to be bound to is what naga finds that they use.

use naga::valid::{Capabilities, GlobalUse, ValidationFlags, Validator};
use naga::{AddressSpace, ImageClass, ScalarKind, ShaderStage, StorageAccess, TypeInner};
use sh_kernels::{Kind, MAX_ORDER, MIN_ORDER, Pass, Stage, source};

/// What naga says of a variable, as the table does.
fn kind(module: &naga::Module, variable: &naga::GlobalVariable) -> Kind {
    match (variable.space, &module.types[variable.ty].inner) {
        (AddressSpace::Uniform, _) => Kind::Uniform,
        (AddressSpace::Storage { access }, _) if access.contains(StorageAccess::STORE) => {
            Kind::Written
        }
        (AddressSpace::Storage { .. }, _) => Kind::Read,
        (_, TypeInner::Image { class, .. }) => match class {
            ImageClass::Sampled {
                kind: ScalarKind::Float,
                ..
            } => Kind::Floats,
            ImageClass::Sampled { .. } => Kind::Integers,
            ImageClass::Depth { .. } => Kind::Depth,
            ImageClass::Storage { .. } => Kind::Target,
            ImageClass::External => panic!("no kernel has one"),
        },
        other => panic!("{other:?} is nothing that is bound"),
    }
}

#[test]
fn entry_points_are_bound_to_what_they_use() {
    for order in MIN_ORDER..=MAX_ORDER {
        for pass in Pass::ALL {
            let text = source(pass, order).unwrap();
            let module = naga::front::wgsl::parse_str(text).unwrap();
            let info = Validator::new(ValidationFlags::all(), Capabilities::empty())
                .validate(&module)
                .unwrap();
            let found: Vec<_> = (0..)
                .zip(&module.entry_points)
                .map(|(index, entry)| {
                    let stage = match entry.stage {
                        ShaderStage::Vertex => Stage::Vertex,
                        ShaderStage::Fragment => Stage::Fragment,
                        _ => Stage::Compute,
                    };
                    let used = module.global_variables.iter().filter_map(|(at, variable)| {
                        let how = info.get_entry_point(index)[at];
                        let bound = variable.binding.filter(|_| !how.is_empty())?;
                        // Nothing is declared as written that is only read.
                        let kind = kind(&module, variable);
                        let written = how.contains(GlobalUse::WRITE);
                        assert_eq!(
                            written,
                            matches!(kind, Kind::Written | Kind::Target),
                            "{pass:?} {} {:?}",
                            entry.name,
                            variable.name
                        );
                        Some((bound.group, bound.binding, variable.name.clone()?, kind))
                    });
                    let mut used: Vec<_> = used.collect();
                    used.sort_by_key(|(group, binding, ..)| (*group, *binding));
                    (entry.name.clone(), stage, used)
                })
                .collect();
            let listed: Vec<_> = pass
                .entries()
                .iter()
                .map(|entry| {
                    let bindings = entry.bindings.iter();
                    let bound = bindings.map(|b| (b.group, b.binding, b.name.into(), b.kind));
                    (entry.name.to_string(), entry.stage, bound.collect())
                })
                .collect();
            assert_eq!(listed, found, "{pass:?} at order {order}");
        }
    }
}
