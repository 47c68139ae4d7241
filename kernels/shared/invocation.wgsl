// Which element an invocation works on. A dispatch may hold 65535 workgroups along one axis only, so
// large ones spread over x and y; elements are counted row by row.

#import constants

fn element_index(workgroup: vec3u, workgroups: vec3u, lane: u32) -> u32 {
    return (workgroup.y * workgroups.x + workgroup.x) * WORKGROUP + lane;
}
