// The receivers of a cluster.

#import shared/records

// First receiver of a cluster and how many there are.
fn cluster_range(cluster: u32) -> vec2u {
    if (cluster >= arrayLength(&clusters)) {
        return vec2u(0u);
    }
    let first = min(clusters[cluster].x, arrayLength(&receivers));
    return vec2u(first, min(clusters[cluster].y, arrayLength(&receivers) - first));
}

// A receiver of a cluster; one that is not covered beyond its end.
fn receiver_at(range: vec2u, at: u32) -> Receiver {
    var receiver = Receiver();
    if (at < range.y) {
        receiver = receivers[range.x + at];
    }
    return receiver;
}
