// In which order spheres hide each other; sh_scene::order.

#import constants

const SMALLEST_DIVISOR: f32 = 1.2e-38;

// The power of a point against a sphere: the square of a tangent's length.
fn power(place: vec3f, center: vec3f, radius: f32) -> f32 {
    let away = center - place;
    return dot(away, away) - radius * radius;
}

// Half of the distance over which an order changes: the radius of the circle in which spheres cut each other.
fn swap_width(a: f32, b: f32, apart: f32) -> f32 {
    let smaller = min(a, b);
    var circle = 0.0;
    if (apart < a + b) {
        if (apart <= abs(a - b)) {
            circle = smaller;
        } else {
            let along = (apart * apart + a * a - b * b) / (2.0 * apart);
            circle = sqrt(max(a * a - along * along, 0.0));
        }
    }
    return max(circle, SHARPEST * smaller);
}
