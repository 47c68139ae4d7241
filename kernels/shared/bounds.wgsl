// Where the receivers of a cluster are. Twin of sh_scene::Bounds, without the cone of normals.

#import shared/records
#import shared/invocation
#import shared/lit
#import constants

var<workgroup> lowest: array<vec3f, WORKGROUP>;

var<workgroup> highest: array<vec3f, WORKGROUP>;

const LARGEST: f32 = 3.4028234e38;

// Centre of the box around those that are lit of `count` receivers from `first` on, and the largest distance from
// there. All invocations of the workgroup have to call this, with the same numbers.
fn cluster_bounds(first: u32, count: u32, lane: u32) -> vec4f {
    var low = vec3f(LARGEST);
    var high = vec3f(-LARGEST);
    for (var i = lane; i < count; i += WORKGROUP) {
        if (is_lit(receivers[first + i])) {
            low = min(low, receivers[first + i].position);
            high = max(high, receivers[first + i].position);
        }
    }
    lowest[lane] = low;
    highest[lane] = high;
    halve(lane);
    let corner = workgroupUniformLoad(&lowest[0]);
    let center = corner + (workgroupUniformLoad(&highest[0]) - corner) * 0.5;
    var far = 0.0;
    for (var i = lane; i < count; i += WORKGROUP) {
        if (is_lit(receivers[first + i])) {
            let away = receivers[first + i].position - center;
            far = max(far, dot(away, away));
        }
    }
    highest[lane] = vec3f(far);
    halve(lane);
    return vec4f(center, sqrt(workgroupUniformLoad(&highest[0]).x));
}

// The lowest and the highest of all invocations come to the first.
fn halve(lane: u32) {
    workgroupBarrier();
    for (var half = WORKGROUP / 2u; half > 0u; half /= 2u) {
        if (lane < half) {
            lowest[lane] = min(lowest[lane], lowest[lane + half]);
            highest[lane] = max(highest[lane], highest[lane + half]);
        }
        workgroupBarrier();
    }
}
