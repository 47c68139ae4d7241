// Irradiance: light without blockers, for every receiver: the environment's SH vector and that of every analytic
// light, dotted with the cosine lobe (Ren et al. 2006, equation 9). Twin of sh_cpu's `irradiance`.

#import shared/records
#import shared/invocation
#import shared/lit
#import shared/gloss
#import shared/light
#import shared/emitted
#import constants
#import library

@group(0) @binding(0) var<uniform> lighting: Lighting;
@group(0) @binding(1) var<storage, read> emitters: array<Emitter>;
// Where the picture is seen from.
@group(0) @binding(2) var<uniform> eye: vec4f;
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
    if (is_lit(receiver)) {
        let gloss = gloss_of(receiver, eye.xyz);
        let lobe = sh$N_cosine(receiver.normal);
        var reflecting = lobe;
        if (GLOSS) {
            reflecting = lobe_of(receiver, gloss);
        }
        result = max(reflected(reflecting), vec3f(0.0));
        result += unshadowed_lamps(lobe, receiver, gloss);
    }
    radiance[index] = vec4f(result, 0.0);
}
