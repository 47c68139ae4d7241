//! What was measured, as tables, JSON and a chart.

use super::{Comparison, Equal, LIGHTS};
use crate::accuracy::chart;
use crate::bench::scenes::Name;
use gaunt::Error;
use std::fmt::Write;
use std::path::Path;

impl Comparison {
    /// Tables in Markdown: ours, then rays.
    pub fn table(&self) -> String {
        let mut text = format!(
            "{} receivers, {} triangles (their hierarchy takes {:.0} ms to build, which is not counted), {} threads.\n\n",
            self.receivers, self.triangles, self.build_ms, self.threads
        );
        text.push_str("| light | accumulated at | ns a receiver | error | rays for the same error | their time / ours | error of the leaves | by hierarchy | error against the raw sky | rays | time / ours |\n|");
        text.push_str(&"---|".repeat(11));
        text.push('\n');
        // Writing to a string cannot fail.
        for row in &self.ours {
            let percent = [row.error, row.leaves, row.hierarchy, row.raw_error].map(|e| 100.0 * e);
            let [error, leaves, hierarchy, raw] = percent;
            let _ = writeln!(
                text,
                "| {} | {} | {:.0} | {error:.2} % | {:.0} | {:.0} | {leaves:.2} % | {hierarchy:.2} % | {raw:.1} % | {:.1} | {:.1} |",
                row.order,
                row.accumulation,
                row.ns,
                row.equal.rays,
                row.equal.times,
                row.raw.rays,
                row.raw.times,
            );
        }
        text.push_str("\n| rays | ns a receiver | error, order 3 | 4 | 5 | 6 | ns, raw sky | error, raw sky |\n|");
        text.push_str(&"---|".repeat(8));
        text.push('\n');
        for row in &self.rays {
            let [a, b, c, d, raw] = row.errors.map(|e| 100.0 * e);
            let _ = writeln!(
                text,
                "| {} | {:.0} | {a:.2} % | {b:.2} % | {c:.2} % | {d:.2} % | {:.0} | {raw:.1} % |",
                row.count, row.ns, row.raw_ns,
            );
        }
        text
    }

    /// The same as JSON.
    pub fn json(&self) -> serde_json::Value {
        let equal = |e: &Equal| serde_json::json!({"rays": e.rays, "times": e.times});
        let ours = self.ours.iter().map(|row| {
            serde_json::json!({
                "order": row.order,
                "accumulation_order": row.accumulation,
                "ns": row.ns,
                "rms": row.error,
                "rms_leaves": row.leaves,
                "rms_hierarchy": row.hierarchy,
                "equal_error": equal(&row.equal),
                "raw_rms": row.raw_error,
                "raw_equal_error": equal(&row.raw),
            })
        });
        let rays = self.rays.iter().map(|row| {
            serde_json::json!({
                "rays": row.count,
                "ns": row.ns,
                "rms": {"3": row.errors[0], "4": row.errors[1], "5": row.errors[2], "6": row.errors[3]},
                "raw_ns": row.raw_ns,
                "raw_rms": row.errors[LIGHTS - 1],
            })
        });
        serde_json::json!({
            "scene": Name::Battle.name(),
            "receivers": self.receivers,
            "triangles": self.triangles,
            "build_ms": self.build_ms,
            "threads": self.threads,
            "ours": ours.collect::<Vec<_>>(),
            "rays": rays.collect::<Vec<_>>(),
        })
    }

    /// Error against time under light of order 4.
    ///
    /// # Errors
    /// A file whose name ends in neither `.svg` nor `.png`, or that cannot be written.
    pub fn chart(&self, file: &Path) -> Result<(), Error> {
        let ours = self.ours.iter().filter(|row| row.order == 4);
        let ours = ours.map(|row| {
            (
                row.ns,
                row.error,
                format!("accumulated at {}", row.accumulation),
            )
        });
        let rays = self.rays.iter();
        let rays = rays.map(|row| (row.ns, row.errors[1], row.count.to_string()));
        let series = [
            ("ours", ours.collect()),
            ("rays, so many a receiver", rays.collect()),
        ];
        let lines = [
            "Up: root mean square of the difference to 4,096 rays a receiver, over the mean radiance. Right: nanoseconds a receiver, on the same threads.",
            "Both under the same light of order 4. Both scales are logarithmic; less is better in both.",
        ];
        let title = "Shadows of the battle scene: ours and ray casting";
        chart::series_of_points(title, lines, ["ns a receiver", "RMS error"], &series, file)
    }
}
