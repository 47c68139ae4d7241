// The eigen logarithm of a cap's visibility from its table. Twin of sh_core::cap::log_table.

#import library

// Zonal coefficients of the eigen logarithm of the visibility past a circular blocker about +Z whose angular radius is
// `angle`, interpolated between whole degrees; beyond 179 degrees it stays as it is there.
//
// Interpolation errs by at most 0.11 up to 150 degrees and by 0.42 from there on.
// Source: Ren et al. 2006, eq. 30-32, tabulated.
fn sh$N_cap_log_table(angle: f32) -> array<f32, $N> {
    let place = clamp(angle * 57.295779513, 0.0, 179.0);
    let row = min(u32(place), 178u);
    let share = place - f32(row);
    var z = array<f32, $N>();
    for (var k = 0u; k < 2u; k += 1u) {
        let weight = select(share, 1.0 - share, k == 0u);
        let numbers = sh$N_cap_log_row(row + k);
        for (var l = 0u; l < $Nu; l += 1u) {
            z[l] += weight * numbers[l];
        }
    }
    return z;
}
