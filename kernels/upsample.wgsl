// Upsample: light at half resolution to samples, by a joint bilateral filter (Kopf et al. 2007), and which samples have
// to be shaded by themselves. The rule stands in sh_scene::upsample. Twin of sh_cpu's `upsample`.
//
// Half resolution tells the share of its light that a receiver gets through all blockers (`shares`). Samples take the
// share of those around them, and their own light without blockers; what spheres send is no share of that and is
// interpolated by itself (`upsample`, a workgroup a tile). Samples for which that will not do come together at the head
// of their tile, as clusters for the passes that shade; what these find goes back to where they came from (`scatter`).

#import shared/records
#import shared/invocation
#import shared/scan
#import shared/band
#import shared/tiles
#import shared/light
#import shared/emitted
#import shared/gloss
#import constants
#import library

@group(0) @binding(0) var<uniform> band: Band;
@group(0) @binding(1) var<uniform> lighting: Lighting;
@group(0) @binding(2) var<storage, read> emitters: array<Emitter>;
@group(0) @binding(3) var<uniform> rule: UpsampleRule;

// The rows at half resolution that lie under the band, in whole rows of tiles.
@group(1) @binding(0) var<storage, read> half_receivers: array<Receiver>;
// Radiance that albedo 1 reflects, and then the share: red, green, blue, 0.
@group(1) @binding(1) var<storage, read_write> half_radiance: array<vec4f>;

// Light without blockers.
fn unshadowed(receiver: Receiver) -> vec3f {
    let lobe = sh$N_cosine(receiver.normal);
    return max(reflected(lobe), vec3f(0.0)) + unshadowed_lamps(lobe, receiver, Gloss());
}

@compute @workgroup_size(WORKGROUP)
fn shares(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let index = element_index(workgroup, workgroups, lane);
    if (index >= arrayLength(&half_receivers) || half_receivers[index].covered == 0u) {
        return;
    }
    let light = unshadowed(half_receivers[index]);
    let share = half_radiance[index].rgb / light;
    half_radiance[index] = vec4f(select(vec3f(1.0), share, light > vec3f(0.0)), 0.0);
}

@group(1) @binding(1) var<storage, read> half_shares: array<vec4f>;
// The band's samples, tile by tile.
@group(1) @binding(2) var<storage, read> receivers: array<Receiver>;
@group(1) @binding(3) var<storage, read_write> radiance: array<vec4f>;
// What has to be shaded by itself: at the head of each tile, with the sample that it comes from as its object, and how
// many there are.
@group(1) @binding(4) var<storage, read_write> anew: array<Receiver>;
@group(1) @binding(5) var<storage, read_write> clusters: array<vec2u>;
// Radiance that spheres send, at half resolution.
@group(1) @binding(6) var<storage, read> half_sent: array<vec4f>;

// Samples of a tile that an invocation has.
const SAMPLES: u32 = AREA / WORKGROUP;

// Whether spheres send light on: without them `half_sent` is not read.
override SENT: bool = true;

// Cells of the grid of samples to one at half resolution.
const STEPS: f32 = f32(2u * OVERSAMPLE);

@compute @workgroup_size(WORKGROUP)
fn upsample(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let tile = workgroup.z * workgroups.y + workgroup.y;
    if (tile >= arrayLength(&clusters)) {
        return;
    }
    let first = tile * AREA + lane * SAMPLES;
    var failed = 0u;
    for (var i = 0u; i < SAMPLES; i += 1u) {
        let sample = receivers[first + i];
        var result = vec3f(0.0);
        if (sample.covered != 0u) {
            let open = unshadowed(sample);
            let around = interpolated(sample, tile_cell(first + i, tiles_across(band.columns)), open);
            if (around.will_do) {
                result = open * around.share + around.sent;
            } else {
                failed |= 1u << i;
            }
        }
        radiance[first + i] = vec4f(result, 0.0);
    }
    let count = countOneBits(failed);
    var place = tile * AREA + sum_up_to(lane, count) - count;
    for (var i = 0u; i < SAMPLES; i += 1u) {
        if ((failed >> i & 1u) != 0u) {
            anew[place] = receivers[first + i];
            // Which sample it is, in place of that it is covered.
            anew[place].covered = first + i + 1u;
            place += 1u;
        }
    }
    if (lane == 0u) {
        clusters[tile] = vec2u(tile * AREA, sums[WORKGROUP - 1u]);
    }
}

// What the receivers around a sample agree on, if they do: the share of its light, and what spheres send.
struct Around {
    share: vec3f,
    will_do: bool,
    sent: vec3f,
}

fn interpolated(sample: Receiver, cell: vec2u, open: vec3f) -> Around {
    let place = vec2f(f32(cell.x) + 0.5, f32(band.first_row + cell.y) + 0.5) / STEPS - 0.5;
    let corner = floor(place);
    let reach = distance(sample.position, band.eye) * band.footprint;
    var shares = Mean(vec3f(0.0), vec3f(LARGEST_SHARE), vec3f(-LARGEST_SHARE));
    var sent = shares;
    var total = 0.0;
    for (var k = 0u; k < 4u; k += 1u) {
        let at = vec2i(corner) + vec2i(vec2u(k & 1u, k >> 1u));
        if (any(at < vec2i(0)) || at.x >= i32(band.half_columns) || at.y >= i32(band.half_rows)) {
            continue;
        }
        let index = tile_index(u32(at.x), u32(at.y) - band.half_first_row, tiles_across(band.half_columns));
        let near = 1.0 - abs(place - vec2f(at));
        let weight = near.x * near.y * alike(sample, half_receivers[index], reach);
        total += weight;
        shares = with_corner(shares, weight, half_shares[index].rgb);
        if (SENT) {
            sent = with_corner(sent, weight, half_sent[index].rgb);
        }
    }
    // What is sent differs too much if it does so against all light.
    let light = max(open + sent.high, vec3f(SMALLEST_LIGHT));
    let spread = max(shares.high - shares.low, (sent.high - sent.low) / light);
    let will_do = total >= rule.min_weight && max(spread.x, max(spread.y, spread.z)) <= rule.max_spread;
    return Around(shares.sum / total, will_do, sent.sum / total);
}

// A weighted sum, and the range of what weighs enough.
struct Mean {
    sum: vec3f,
    low: vec3f,
    high: vec3f,
}

fn with_corner(mean: Mean, weight: f32, value: vec3f) -> Mean {
    var result = mean;
    result.sum += weight * value;
    if (weight > rule.corner) {
        result.low = min(result.low, value);
        result.high = max(result.high, value);
    }
    return result;
}

const SMALLEST_LIGHT: f32 = 1.2e-38;

// Above any share.
const LARGEST_SHARE: f32 = 1e9;

// How much the light of a receiver tells of that of a sample, 0 to 1; `reach` is what two pixels cover there.
fn alike(sample: Receiver, receiver: Receiver, reach: f32) -> f32 {
    if (receiver.covered == 0u) {
        return 0.0;
    }
    let apart = receiver.position - sample.position;
    let height = max(abs(dot(apart, sample.normal)), abs(dot(apart, receiver.normal)));
    let part = height / reach;
    let facing = (dot(sample.normal, receiver.normal) - rule.normal_from) / (1.0 - rule.normal_from);
    return max(1.0 - part * part, 0.0) * clamp(facing, 0.0, 1.0);
}

@group(1) @binding(0) var<storage, read> shaded_clusters: array<vec2u>;
@group(1) @binding(1) var<storage, read> shaded_receivers: array<Receiver>;
@group(1) @binding(2) var<storage, read> shaded: array<vec4f>;

@compute @workgroup_size(WORKGROUP)
fn scatter(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let tile = workgroup.z * workgroups.y + workgroup.y;
    if (tile >= arrayLength(&shaded_clusters)) {
        return;
    }
    let cluster = shaded_clusters[tile];
    for (var i = cluster.x + lane; i < cluster.x + cluster.y; i += WORKGROUP) {
        radiance[shaded_receivers[i].covered - 1u] = shaded[i];
    }
}
