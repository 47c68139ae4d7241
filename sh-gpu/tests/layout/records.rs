//! The records of the kernels and those of Rust have the same layout, as naga lays WGSL out.

use naga::proc::Layouter;
use sh_gpu::records::{
    Band, Basis, Body, Lighting, PunctualScene, ScreenSource, Sender, UpsampleRule, VertexSource,
};
use sh_kernels::{MAX_ORDER, MIN_ORDER, Pass, source};
use sh_scene::basis::{Disc, Facet, Patch, Region};
use sh_scene::surface::SurfacePoint;
use sh_scene::{Emitter, LightView, Node, PunctualRecord, Receiver};
use std::mem::offset_of;

/// Size and member offsets of a struct in a kernel.
fn wgsl(pass: Pass, order: usize, name: &str) -> (u32, Vec<(String, u32)>) {
    let module = naga::front::wgsl::parse_str(source(pass, order).unwrap()).unwrap();
    let mut layouter = Layouter::default();
    layouter.update(module.to_ctx()).unwrap();
    let (handle, ty) = module
        .types
        .iter()
        .find(|(_, ty)| ty.name.as_deref() == Some(name))
        .unwrap_or_else(|| panic!("{} has no struct {name}", pass.name()));
    let naga::TypeInner::Struct { members, .. } = &ty.inner else {
        panic!("{name} is no struct");
    };
    let offsets = members
        .iter()
        .map(|m| (m.name.clone().unwrap(), m.offset))
        .collect();
    (layouter[handle].size, offsets)
}

macro_rules! same_layout {
    ($pass:expr, $order:expr, $type:ident { $($field:ident),* }) => {
        let rust = vec![$((stringify!($field).to_string(), offset_of!($type, $field) as u32)),*];
        let (size, fields) = wgsl($pass, $order, stringify!($type));
        assert_eq!(fields, rust, "{} of {:?} at order {}", stringify!($type), $pass, $order);
        assert_eq!(size, size_of::<$type>() as u32, "{} of {:?}", stringify!($type), $pass);
    };
}

#[test]
fn records_are_laid_out_alike() {
    for order in MIN_ORDER..=MAX_ORDER {
        // What lights see are no receivers.
        for pass in Pass::ALL.into_iter().filter(|p| *p != Pass::LightView) {
            same_layout!(
                pass,
                order,
                Receiver {
                    position,
                    covered,
                    normal,
                    object
                }
            );
        }
        for pass in Pass::ALL {
            let mut bound = pass.entries().iter().flat_map(|entry| entry.bindings);
            if !bound.any(|binding| binding.ty == "Lighting") {
                continue;
            }
            same_layout!(
                pass,
                order,
                Lighting {
                    nodes,
                    emitters,
                    sin_max,
                    sin_min,
                    coefficients
                }
            );
        }
        for pass in [Pass::Irradiance, Pass::Shadow, Pass::Upsample] {
            same_layout!(
                pass,
                order,
                Emitter {
                    center,
                    radius,
                    radiance,
                    local,
                    gains,
                    order,
                    distribution
                }
            );
        }
        for pass in [Pass::BasisUpdate, Pass::BasisGather] {
            same_layout!(
                pass,
                order,
                Basis {
                    world_from_object,
                    object_from_world,
                    center,
                    radius,
                    scale,
                    object,
                    first,
                    patches,
                    functions,
                    weights,
                    duals,
                    sends,
                    light,
                    own,
                    few,
                    first_few
                }
            );
        }
        same_layout!(
            Pass::BasisGather,
            order,
            Disc {
                center,
                area,
                normal,
                unused
            }
        );
        same_layout!(Pass::BasisGather, order, Facet { disc, escape });
        same_layout!(Pass::BasisGather, order, Patch { whole, discs });
        same_layout!(
            Pass::BasisGather,
            order,
            Region {
                center,
                radius,
                whole,
                quarters
            }
        );
        for pass in [Pass::LightUpdate, Pass::Shadow, Pass::LightGather] {
            same_layout!(
                pass,
                order,
                Node {
                    center,
                    radius,
                    area,
                    parent,
                    skip,
                    sphere,
                    weight,
                    object
                }
            );
        }
        same_layout!(
            Pass::LightUpdate,
            order,
            SurfacePoint {
                position,
                direction,
                normal,
                share,
                albedo
            }
        );
        same_layout!(
            Pass::LightUpdate,
            order,
            Sender {
                world_from_object,
                turn,
                frame,
                first,
                count,
                object,
                node
            }
        );
        same_layout!(
            Pass::Upsample,
            order,
            UpsampleRule {
                min_weight,
                max_spread,
                normal_from,
                corner
            }
        );
    }
}

#[test]
fn what_hosts_bring_is_laid_out_alike() {
    same_layout!(
        Pass::Vertices,
        MIN_ORDER,
        VertexSource {
            world_from_object,
            first,
            stride,
            normal,
            object
        }
    );
    same_layout!(
        Pass::Screen,
        MIN_ORDER,
        ScreenSource {
            world_from_clip,
            size,
            first_row,
            empty,
            scale,
            bias
        }
    );
}

#[test]
fn lights_with_sharp_shadows_are_laid_out_alike() {
    same_layout!(
        Pass::Punctual,
        MIN_ORDER,
        PunctualRecord {
            position,
            radius,
            axis,
            outer,
            radiance,
            steep,
            distant,
            first,
            views,
            unused
        }
    );
    for pass in [Pass::LightView, Pass::Punctual] {
        same_layout!(
            pass,
            MIN_ORDER,
            LightView {
                origin,
                distant,
                right,
                far,
                up,
                near,
                forward,
                inverse
            }
        );
        same_layout!(
            pass,
            MIN_ORDER,
            PunctualScene {
                lights,
                views,
                side,
                across,
                ground,
                ground_height,
                tail
            }
        );
    }
}

#[test]
fn camera_and_body_are_laid_out_alike() {
    for pass in [Pass::Gbuffer, Pass::Upsample, Pass::Resolve] {
        same_layout!(
            pass,
            MIN_ORDER,
            Band {
                clip_from_world,
                eye,
                near,
                right,
                first_row,
                up,
                rows,
                forward,
                ground,
                extent,
                columns,
                ground_height,
                ground_albedo,
                footprint,
                half_columns,
                half_rows,
                half_first_row
            }
        );
    }
    same_layout!(
        Pass::Gbuffer,
        MIN_ORDER,
        Body {
            world_from_object,
            albedo,
            object,
            glossy,
            roughness,
            metallic,
            tail
        }
    );
}
