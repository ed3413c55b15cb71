use proptest::prelude::*;

use super::assignment::{Table, most_iou};
use super::overlaps::Overlaps;
use super::{fit4cad, hpnet, nvdnet, panoptic, parsenet, spfn};
use crate::cloud::{Cloud, Point};
use crate::model::{Primitive, Segmentation};

type Lists = Vec<Vec<u32>>;

fn segmentation(lists: &[Vec<u32>]) -> Segmentation {
    let primitive = |points: &Vec<u32>| Primitive {
        points: points.clone(),
        ..Primitive::default()
    };
    Segmentation {
        primitives: lists.iter().map(primitive).collect(),
    }
}

fn overlaps(points: usize, truth: &[Vec<u32>], predicted: &[Vec<u32>]) -> Overlaps {
    Overlaps::of(points, &segmentation(truth), &segmentation(predicted)).unwrap()
}

type Score = fn(&Overlaps) -> Option<f64>;

/// Every protocol that looks at sets alone.
const PROTOCOLS: [(&str, Score); 7] = [
    ("fit4cad", fit4cad::score),
    ("spfn", spfn::score),
    ("spfn-large", spfn::score_without_small),
    ("parsenet", parsenet::score),
    ("hpnet", hpnet::score),
    ("f1", panoptic::f1),
    ("pq", panoptic::quality),
];

/// Lists of a run of points.
fn runs(runs: &[std::ops::Range<u32>]) -> Lists {
    runs.iter().map(|run| run.clone().collect()).collect()
}

/// One list of a run of points.
fn one(run: std::ops::Range<u32>) -> Lists {
    vec![run.collect()]
}

#[test]
fn the_truth_itself_scores_one() {
    let truth = runs(&[0..400, 400..550, 500..1000]);
    let same = overlaps(1000, &truth, &truth);
    for (name, score) in PROTOCOLS {
        assert_eq!(score(&same), Some(1.0), "{name}");
    }
}

#[test]
fn finding_nothing_scores_zero_and_no_truth_scores_nothing() {
    let truth = runs(&[0..400, 400..1000]);
    let (missed, invented) = (overlaps(1000, &truth, &[]), overlaps(1000, &[], &truth));
    for (name, score) in PROTOCOLS {
        assert_eq!(score(&missed), Some(0.0), "{name}");
        let expected = match name {
            "f1" | "pq" => Some(0.0),
            _ => None,
        };
        assert_eq!(score(&invented), expected, "{name}");
        assert_eq!(score(&overlaps(1000, &[], &[])), None, "{name}");
    }
}

#[test]
fn one_perfect_face_alone_is_full_marks_by_two_protocols() {
    let truth = runs(&[0..400, 400..700, 700..1000]);
    let found = overlaps(1000, &truth, &one(0..400));
    let third = Some(1.0 / 3.0);
    for (name, score) in PROTOCOLS {
        let expected = match name {
            "parsenet" | "hpnet" => Some(1.0),
            "f1" | "pq" => Some(2.0 / 4.0),
            _ => third,
        };
        assert_eq!(score(&found), expected, "{name}");
    }
}

#[test]
fn only_the_benchmark_lets_one_prediction_serve_many() {
    let truth = runs(&[0..500, 500..1000]);
    let merged = overlaps(1000, &truth, &one(0..1000));
    assert_eq!(fit4cad::score(&merged), Some(2.0 / 3.0));
    assert_eq!(spfn::score(&merged), Some(0.25));
    // One half is no hit: it has to be more.
    assert_eq!(panoptic::f1(&merged), Some(0.0));
}

#[test]
fn small_predictions_are_removed_below_half_a_per_cent_and_not_at_it() {
    let truth = runs(&[0..4, 4..9, 9..1000]);
    let same = overlaps(1000, &truth, &truth);
    assert_eq!(spfn::score_without_small(&same), Some(2.0 / 3.0));
}

#[test]
fn parsenet_looks_from_a_hundred_points_on_and_hpnet_beyond() {
    // Found: the faces of 99 and of 100 points; that of 101 is found by half.
    let truth = runs(&[0..99, 100..200, 200..301]);
    let predicted = runs(&[0..99, 100..200, 200..250]);
    let found = overlaps(301, &truth, &predicted);
    let half = 50.0 / 101.0;
    assert_eq!(parsenet::score(&found), Some((1.0 + half) / 2.0));
    assert_eq!(hpnet::score(&found), Some(half));
}

#[test]
fn pairs_without_overlap_go_to_what_is_left_in_the_order_of_the_file() {
    // Two predictions overlap with nothing; three true primitives are left, the second too small to
    // be looked at. Of the others the first gets a pair that counts as 0.
    let truth = runs(&[0..200, 200..400, 400..450, 450..650]);
    let found = runs(&[0..200, 900..910, 910..920]);
    assert_eq!(parsenet::score(&overlaps(1000, &truth, &found)), Some(0.5));
    let small_first = runs(&[0..200, 400..450, 200..400, 450..650]);
    let score = parsenet::score(&overlaps(1000, &small_first, &found[..2]));
    assert_eq!(score, Some(1.0));
}

#[test]
fn parsenet_knows_fifty_primitives() {
    let truth: Lists = (0..60)
        .map(|k| (k * 100..(k + 1) * 100).collect())
        .collect();
    let mut found = truth.clone();
    for list in &mut found[50..] {
        list.truncate(10);
    }
    let found = overlaps(6000, &truth, &found);
    assert_eq!(parsenet::score(&found), Some(1.0));
    assert!(spfn::score(&found) < Some(1.0));
}

#[test]
fn indices_beyond_the_cloud_do_not_exist() {
    let lists = vec![vec![0, 1, 2, 900, u32::MAX]];
    let found = overlaps(10, &lists, &one(0..3));
    assert_eq!(found.truth, [3]);
    assert_eq!(panoptic::quality(&found), Some(1.0));
}

#[test]
fn lists_heaped_on_the_same_points_are_refused() {
    let heap: Lists = vec![(0..10).collect(); 5000];
    let heap = segmentation(&heap);
    assert_eq!(Overlaps::of(10, &heap, &heap), None);
}

/// The best of all ways to give every row of the shorter side a column.
fn exhaustive(rows: usize, columns: usize, worth: &dyn Fn(usize, usize) -> f64) -> f64 {
    fn search(
        row: usize,
        rows: usize,
        free: &mut [bool],
        worth: &dyn Fn(usize, usize) -> f64,
    ) -> f64 {
        if row == rows {
            return 0.0;
        }
        let mut most = f64::NEG_INFINITY;
        for column in 0..free.len() {
            if std::mem::take(&mut free[column]) {
                most = most.max(worth(row, column) + search(row + 1, rows, free, worth));
                free[column] = true;
            }
        }
        most
    }
    if rows <= columns {
        search(0, rows, &mut vec![true; columns], worth)
    } else {
        search(0, columns, &mut vec![true; rows], &|row, column| {
            worth(column, row)
        })
    }
}

/// An independent reading of the protocols: every pair by its points, every matching tried.
mod brute {
    use super::{Lists, exhaustive};

    pub fn iou(one: &[u32], other: &[u32]) -> f64 {
        let shared = one.iter().filter(|point| other.contains(point)).count();
        let union = one.len() + other.len() - shared;
        if union == 0 {
            0.0
        } else {
            shared as f64 / union as f64
        }
    }

    fn best_sum(truth: &[Vec<u32>], predicted: &[Vec<u32>]) -> f64 {
        exhaustive(truth.len(), predicted.len(), &|row, column| {
            iou(&truth[row], &predicted[column])
        })
    }

    pub fn spfn(truth: &Lists, predicted: &Lists) -> f64 {
        best_sum(truth, predicted) / truth.len() as f64
    }

    pub fn spfn_large(points: usize, truth: &Lists, predicted: &Lists) -> f64 {
        let large = predicted.iter().filter(|list| list.len() * 200 >= points);
        best_sum(truth, &large.cloned().collect::<Vec<_>>()) / truth.len() as f64
    }

    pub fn hpnet(truth: &Lists, predicted: &Lists) -> Option<f64> {
        let large: Lists = truth
            .iter()
            .filter(|list| list.len() > 100)
            .cloned()
            .collect();
        let pairs = large.len().min(predicted.len());
        if large.is_empty() {
            return None;
        }
        Some(if pairs == 0 {
            0.0
        } else {
            best_sum(&large, predicted) / pairs as f64
        })
    }

    pub fn panoptic(truth: &Lists, predicted: &Lists) -> (f64, f64) {
        let pairs = truth
            .iter()
            .flat_map(|one| predicted.iter().map(|other| iou(one, other)));
        let hits: Vec<f64> = pairs.filter(|&iou| iou > 0.5).collect();
        let half = (truth.len() + predicted.len()) as f64 / 2.0;
        (hits.len() as f64 / half, hits.iter().sum::<f64>() / half)
    }

    pub fn dice(truth: &Lists, predicted: &Lists) -> f64 {
        let best = |one: &Vec<u32>| {
            let mut most = (0, 0.0);
            for other in predicted {
                let shared = one.iter().filter(|point| other.contains(point)).count();
                if shared > most.0 {
                    most = (
                        shared,
                        (2 * shared) as f64 / (one.len() + other.len()) as f64,
                    );
                }
            }
            most.1
        };
        truth.iter().map(best).sum::<f64>() / truth.len() as f64
    }
}

const POINTS: u32 = 600;

/// One label a point, of up to seven primitives; or lists that may share points.
fn labelled(most: usize) -> impl Strategy<Value = Lists> {
    // Cuts along the row of points: pieces of all sizes, beside thresholds of 3 and of 100 points.
    pieces(POINTS, most)
}

fn pieces(points: u32, most: usize) -> impl Strategy<Value = Lists> {
    let cuts = prop::collection::vec(0..=points, 1..=most);
    cuts.prop_map(|mut cuts| {
        cuts.push(0);
        cuts.sort_unstable();
        cuts.windows(2)
            .map(|cut| (cut[0]..cut[1]).collect())
            .collect()
    })
}

fn overlapping() -> impl Strategy<Value = Lists> {
    let run = (0..POINTS, 0..200u32)
        .prop_map(|(from, length)| (from..(from + length).min(POINTS)).collect());
    prop::collection::vec(run, 1..=6)
}

fn close(one: f64, other: f64) -> bool {
    (one - other).abs() < 1e-9
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn an_independent_reading_says_the_same(truth in labelled(6), predicted in labelled(6)) {
        let found = overlaps(POINTS as usize, &truth, &predicted);
        let spfn = brute::spfn(&truth, &predicted);
        prop_assert!(close(spfn::score(&found).unwrap(), spfn));
        let large = brute::spfn_large(POINTS as usize, &truth, &predicted);
        prop_assert!(close(spfn::score_without_small(&found).unwrap(), large));
        let hpnet = brute::hpnet(&truth, &predicted);
        prop_assert_eq!(hpnet::score(&found).is_some(), hpnet.is_some());
        prop_assert!(close(hpnet::score(&found).unwrap_or(0.0), hpnet.unwrap_or(0.0)));
        let (f1, pq) = brute::panoptic(&truth, &predicted);
        prop_assert!(close(panoptic::f1(&found).unwrap(), f1));
        prop_assert!(close(panoptic::quality(&found).unwrap(), pq));
        let dice = brute::dice(&truth, &predicted);
        prop_assert!(close(fit4cad::score(&found).unwrap(), dice));
    }

    #[test]
    fn sets_that_share_points_are_matched_as_well_as_can_be(
        truth in overlapping(), predicted in overlapping(),
    ) {
        let found = overlaps(POINTS as usize, &truth, &predicted);
        prop_assert!(close(spfn::score(&found).unwrap(), brute::spfn(&truth, &predicted)));
        // No one is matched twice.
        let partners = most_iou(&found, &|_| true).unwrap();
        let mut taken: Vec<usize> = partners.iter().flatten().map(|it| it.predicted).collect();
        let count = taken.len();
        taken.sort_unstable();
        taken.dedup();
        prop_assert_eq!(taken.len(), count);
    }

    #[test]
    fn a_table_is_assigned_as_well_as_by_trying_all(
        rows in 1usize..=7, columns in 1usize..=7, cells in prop::collection::vec(-1.0..1.0, 49),
    ) {
        let worth = |row: usize, column: usize| cells[row * 7 + column];
        let mut table = Table::new(rows, columns).unwrap();
        for row in 0..rows {
            for column in 0..columns {
                table.set(row, column, worth(row, column));
            }
        }
        let chosen = table.largest();
        let pairs = chosen.iter().enumerate().filter_map(|(row, at)| Some((row, (*at)?)));
        prop_assert_eq!(pairs.clone().count(), rows.min(columns));
        let sum: f64 = pairs.map(|(row, column)| worth(row, column)).sum();
        prop_assert!(close(sum, exhaustive(rows, columns, &worth)));
    }

    /// All but ParseNet's, which hangs on the order of the file where pairs do not overlap.
    #[test]
    fn the_order_of_primitives_and_of_points_changes_nothing(
        truth in labelled(6), predicted in labelled(6), seed in any::<u64>(),
    ) {
        let before = overlaps(POINTS as usize, &truth, &predicted);
        let mut random = crate::random::Random::new(seed, 0);
        let mut places: Vec<u32> = (0..POINTS).collect();
        random.shuffle(&mut places);
        let mut moved = |lists: &Lists| {
            let moved = lists.iter().map(|list| {
                let mut list: Vec<u32> = list.iter().map(|&point| places[point as usize]).collect();
                list.sort_unstable();
                list
            });
            let mut moved: Lists = moved.collect();
            random.shuffle(&mut moved);
            moved
        };
        let after = overlaps(POINTS as usize, &moved(&truth), &moved(&predicted));
        for (name, score) in PROTOCOLS {
            // Which of two equal matches DSC takes is said by the order of the file, too.
            if name != "parsenet" && name != "fit4cad" {
                let (before, after) = (score(&before), score(&after));
                prop_assert!(close(before.unwrap_or(-1.0), after.unwrap_or(-1.0)), "{}", name);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn measured_pairs_are_the_cheapest(truth in pieces(90, 4), predicted in pieces(90, 4)) {
        let cloud = bent(90);
        let found = nvdnet::score(&cloud, &segmentation(&truth), &segmentation(&predicted));
        let expected = detection(&cloud, &truth, &predicted);
        match (found, expected) {
            (Some(found), Some(expected)) => {
                prop_assert!(close(found.precision, expected[0]));
                prop_assert!(close(found.recall, expected[1]));
                prop_assert!(close(found.f1, expected[2]));
            }
            (found, expected) => prop_assert_eq!(found.is_some(), expected.is_some()),
        }
    }
}

/// Points along a curve without symmetries, so that the cheapest matching is one.
fn bent(points: u32) -> Cloud {
    let at = |k: u32| {
        let t = f64::from(k) / f64::from(points);
        Point::new(t, t * t * (1.0 - t), libm::sin(3.0 * t) * 0.3)
    };
    Cloud::new((0..points).map(at).collect())
}

/// NVDNet's figures with every distance measured and every matching tried.
fn detection(cloud: &Cloud, truth: &Lists, predicted: &Lists) -> Option<[f64; 3]> {
    let there = |lists: &Lists| -> Lists {
        lists
            .iter()
            .filter(|list| !list.is_empty())
            .cloned()
            .collect()
    };
    let (truth, predicted) = (there(truth), there(predicted));
    if truth.is_empty() {
        return None;
    }
    if predicted.is_empty() {
        return Some([0.0; 3]);
    }
    let at = |index: u32| cloud.points()[index as usize];
    let one_way = |from: &[u32], to: &[u32]| {
        let nearest = |&point: &u32| {
            let all = to.iter().map(|&other| (at(point) - at(other)).norm());
            all.fold(f64::INFINITY, f64::min)
        };
        from.iter().map(nearest).sum::<f64>() / from.len() as f64
    };
    let distance = |row: usize, column: usize| {
        let (one, other) = (&truth[row], &predicted[column]);
        0.5 * (one_way(one, other) + one_way(other, one)) / cloud.bounds().longest_side()
    };
    let all: Vec<Vec<f64>> = (0..truth.len())
        .map(|row| {
            (0..predicted.len())
                .map(|column| distance(row, column))
                .collect()
        })
        .collect();
    // Of the cheapest matching the hits at each threshold: a hit is worth what it is short of cost.
    let cheapest = exhaustive(truth.len(), predicted.len(), &|row, column| {
        -all[row][column]
    });
    let mut sums = [0.0; 3];
    for threshold in nvdnet::THRESHOLDS {
        // A tiny reward a hit tells how many hits the cheapest matching has.
        let reward = 1e-7;
        let with = exhaustive(truth.len(), predicted.len(), &|row, column| {
            let hit = all[row][column] < threshold;
            -all[row][column] + if hit { reward } else { 0.0 }
        });
        let hits = ((with - cheapest) / reward).round();
        sums[0] += hits / predicted.len() as f64 / 5.0;
        sums[1] += hits / truth.len() as f64 / 5.0;
        sums[2] += 2.0 * hits / (truth.len() + predicted.len()) as f64 / 5.0;
    }
    Some(sums)
}

#[test]
fn the_truth_itself_is_found_at_every_distance() {
    let truth = segmentation(&runs(&[0..100, 100..250, 250..600]));
    let found = nvdnet::score(&bent(POINTS), &truth, &truth).unwrap();
    assert_eq!((found.precision, found.recall, found.f1), (1.0, 1.0, 1.0));
}

#[test]
fn a_cloud_without_extent_has_no_unit() {
    let cloud = Cloud::new(vec![Point::origin(); 3]);
    let truth = segmentation(&one(0..3));
    assert_eq!(nvdnet::score(&cloud, &truth, &truth), None);
}
