// Irradiance: light without blockers, for every receiver: the environment's SH vector and that of every analytic
// light, dotted with the cosine lobe (Ren et al. 2006, equation 9). Twin of sh_cpu's `irradiance`.

#import shared/records
#import shared/invocation
#import shared/light
#import shared/emitted
#import constants
#import library

@group(0) @binding(0) var<uniform> lighting: Lighting;
@group(0) @binding(1) var<storage, read> emitters: array<Emitter>;
@group(1) @binding(0) var<storage, read> receivers: array<Receiver>;
// Radiance reflected by albedo 1: red, green, blue, 0.
@group(1) @binding(1) var<storage, read_write> radiance: array<vec4f>;

@compute @workgroup_size(WORKGROUP)
fn irradiance(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let index = element_index(workgroup, workgroups, lane);
    if (index >= arrayLength(&receivers)) {
        return;
    }
    let receiver = receivers[index];
    var result = vec3f(0.0);
    if (receiver.covered != 0u) {
        let lobe = sh$N_cosine(receiver.normal);
        result = max(reflected(lobe), vec3f(0.0)) + unshadowed_lamps(lobe, receiver);
    }
    radiance[index] = vec4f(result, 0.0);
}
