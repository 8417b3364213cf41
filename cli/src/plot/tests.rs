//! Tests of figures: they can be drawn for any values, and are the same in each run.

use super::*;

fn panel(curves: &[Vec<(f64, f64)>]) -> Panel {
    let series = |(at, points): (usize, &Vec<_>)| Series::curve(format!("curve {at}"), at, points.clone());
    Panel {
        title: "Energy".to_owned(),
        x_label: "t [s]".to_owned(),
        y_label: "T + V [J]".to_owned(),
        scale: Scale::Linear,
        x_scale: Scale::Linear,
        series: curves.iter().enumerate().map(series).collect(),
        note: None,
    }
}

/// Each marker has one meaning: no two looks share their outline, or both colour and width, which determine the dashes.
#[test]
fn every_look_is_another() {
    let looks: Vec<_> = (0..curve_look::LOOKS.len()).map(curve_look::look).collect();
    for (at, a) in looks.iter().enumerate() {
        for b in &looks[at + 1..] {
            assert!(!a.is_like(b), "{at}");
        }
    }
}

#[test]
fn degenerate_panels_draw() {
    let nan = f64::NAN;
    for curves in [
        vec![],
        vec![vec![]],
        vec![vec![(0.0, 1.0)]],
        vec![vec![(nan, 1.0), (0.0, nan), (f64::INFINITY, 2.0)]],
        vec![vec![(0.0, 7.0), (1.0, 7.0)]],
        vec![vec![(0.0, 0.0), (0.0, 0.0)]],
        vec![vec![(0.0, 1e-16), (1.0, 1e5)], vec![(0.0, -1e299), (1.0, 1e299)]],
        vec![vec![(0.0, 5e-324), (1.0, 1e-310)]],
    ] {
        for scale in [Scale::Linear, Scale::Logarithmic] {
            let svg = draw(&[Panel { scale, ..panel(&curves) }], 1).unwrap();
            assert!(svg.starts_with("<svg role=\"img\"") && svg.trim_end().ends_with("</svg>"));
            assert!(!svg.contains("NaN") && !svg.contains("inf") && !svg.contains("2147483647"), "{svg}");
        }
    }
    assert!(draw(&[], 0).is_ok());
}

/// Goal: a look has one name in a legend. Method: panels whose first curves have different names get legends of their
/// own. Otherwise the name of the first panel would stand above the second, too. Panels with the same names share a
/// legend.
#[test]
fn a_legend_is_shared_where_no_look_has_two_names() {
    let points = vec![(0.0, 1.0), (1.0, 2.0)];
    let named = |names: [&str; 2]| {
        let mut panel = panel(&[points.clone(), points.clone()]);
        panel.series.iter_mut().zip(names).for_each(|(series, name)| series.label = name.to_owned());
        panel
    };
    let height_of = |svg: &str, text: &str| -> Option<f64> {
        let tag = svg[..svg.find(&format!(">\n{text}\n<"))?].rsplit('<').next()?.to_owned();
        tag.split("y=\"").nth(1)?.split('"').next()?.parse().ok()
    };
    let apart = draw(&[named(["q1", "q2"]), named(["u1", "u2"])], 1).unwrap();
    let shared = draw(&[named(["kane", "lagrange"]), named(["kane", "lagrange"])], 1).unwrap();
    assert!(height_of(&apart, "u1") > height_of(&apart, "q2").map(|y| y + 1000.0), "{apart}");
    assert_eq!(shared.matches(">\nkane\n<").count(), 1);
}

#[test]
fn a_figure_is_the_same_each_time() {
    let points: Vec<_> = (0..9000).map(|i| (f64::from(i), f64::from(i).sin())).collect();
    let figure = || draw(&[panel(&[points.clone(), points.clone()]), panel(std::slice::from_ref(&points))], 2).unwrap();
    assert_eq!(figure(), figure());
    assert!(figure().len() < 300_000, "a long curve is thinned: {}", figure().len());
}

#[test]
fn a_band_is_drawn_where_it_is_wider_than_its_curve_and_stays_inside_its_panel() {
    let points: Vec<_> = (0..50).map(|i| (f64::from(i), f64::from(i).sin())).collect();
    let banded = |error: f64| {
        let mut panel = panel(std::slice::from_ref(&points));
        panel.series[0].band =
            points.iter().map(|(x, y)| Bounds { x: *x, low: y - error * x, high: y + error * x }).collect();
        draw(&[panel], 1).unwrap()
    };
    let polygons = |svg: &str| svg.matches("z\"/>").count();
    assert_eq!((polygons(&banded(1e-6)), polygons(&banded(1e-2)), polygons(&banded(f64::NAN))), (0, 1, 0));
    let wide = banded(1e3);
    assert_eq!(polygons(&wide), 1);
    let edge = wide.lines().find(|line| line.ends_with("z\"/>")).and_then(|line| line.split(" d=\"m").nth(1)).unwrap();
    let steps: Vec<f64> = edge
        .trim_end_matches("z\"/>")
        .replace('-', " -")
        .split_whitespace()
        .map(|number| number.parse().unwrap())
        .collect();
    let heights: Vec<f64> = steps
        .chunks(2)
        .scan(0.0, |y, step| {
            *y += step[1];
            Some(*y)
        })
        .collect();
    assert!(heights.len() > 3 && heights.iter().all(|y| (0.0..2000.0).contains(y)), "{heights:?}");
}

#[test]
fn the_title_of_a_figure_is_text_of_xml() {
    let figure = super::svg_element("", "a]]> & <b> \"c\"", 100.0);
    assert!(figure.contains("<title>a]]&gt; &amp; &lt;b&gt; &quot;c&quot;</title>"), "{figure}");
}
