//! What entry points are bound to, as the kernels themselves declare it.
//!
//! The build script reads declarations such as `@group(1) @binding(0) var<storage, read> receivers: array<Receiver>;` and
//! finds which of them an entry point reaches. Layouts of bind groups are made from that, so that they are said once.

/// An entry point of a pass.
///
/// ```
/// let entries = sh_kernels::Pass::Irradiance.entries();
/// let [irradiance] = entries else { panic!("it has one") };
/// let names: Vec<_> = irradiance.bindings.iter().map(|binding| binding.name).collect();
/// assert_eq!(names, ["lighting", "emitters", "eye", "receivers", "radiance"]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EntryPoint {
    /// Its name.
    pub name: &'static str,
    /// Where it runs.
    pub stage: Stage,
    /// What it reaches, by group and binding.
    pub bindings: &'static [Binding],
}

/// Where an entry point runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// In a compute pass.
    Compute,
    /// In a render pass, once a vertex.
    Vertex,
    /// In a render pass, once a fragment.
    Fragment,
}

/// Something that a kernel is bound to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Binding {
    /// 0: what the pass owns. 1: what a host may own.
    pub group: u32,
    /// Its number in the group.
    pub binding: u32,
    /// The kernel's name of it.
    pub name: &'static str,
    /// The kernel's type of it.
    pub ty: &'static str,
    /// What kind of thing it is.
    pub kind: Kind,
}

/// What kind of thing a kernel is bound to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A uniform buffer.
    Uniform,
    /// A storage buffer that is read.
    Read,
    /// A storage buffer that is written, and may be read.
    Written,
    /// A texture of floats, read texel by texel.
    Floats,
    /// A texture of unsigned integers.
    Integers,
    /// A depth texture.
    Depth,
    /// A texture that is written.
    Target,
}
