//! Levenberg-Marquardt minimisation on a chart.

use nalgebra::{SMatrix, SVector};

use super::Loss;
use super::charts::Chart;
use crate::cloud::Vector;
use crate::surface::Surface;

/// Steps shorter than this, in units of the patch, change nothing.
const SETTLED: f64 = 1e-14;

/// When to stop.
#[derive(Debug, Clone, Copy)]
pub(super) struct Effort {
    /// Most steps.
    pub steps: usize,
    /// Smallest share of the cost that a step has to gain for another to be worth taking.
    pub least_gain: f64,
}

impl Effort {
    /// To the minimum. Points off their surface leave Gauss-Newton steps linear convergence, so what
    /// is left to go is not much less than the last step, whose gain is its square: parameters good
    /// to 1e-7 take a gain far below 1e-9, and a step or two more.
    pub const FULL: Self = Self {
        steps: 60,
        least_gain: 1e-13,
    };
    /// One step.
    pub const STEP: Self = Self {
        steps: 1,
        least_gain: 0.0,
    };
    /// For a hypothesis. Near a true surface the cost of exact points falls by orders of magnitude
    /// with each step; where it does not, the hypothesis is wrong and its minimum of no interest.
    pub const HYPOTHESIS: Self = Self {
        steps: 12,
        least_gain: 0.1,
    };
}

/// The surface that minimises Σ loss(d) over points of unit size, and its root (weighted) mean
/// squared distance. Each step solves (JᵀWJ + μ diag) δ = -JᵀWd; μ falls after a step that
/// lowers the cost and rises after one that does not, which is then not taken. How long
/// that goes on is a matter of `effort`.
pub(super) fn minimise<const N: usize, C: Chart<N>>(
    start: C,
    points: &[Vector],
    loss: Loss,
    effort: Effort,
) -> Option<(Surface, f64)> {
    let mut chart = start;
    let mut cost = total_cost(&chart, points, loss);
    let mut damping = 1e-4;
    for _ in 0..effort.steps {
        let (normal, gradient) = normal_equations(&chart, points, loss);
        let mut improvement = None;
        // An exhausted damping means that no step helps: a minimum to machine precision.
        while damping < 1e8 {
            let mut damped = normal;
            for i in 0..N {
                // The floor keeps a direction the points say nothing about from running away.
                damped[(i, i)] += damping * normal[(i, i)].max(1e-12 * normal.trace()) + 1e-300;
            }
            let step = -damped.cholesky()?.solve(&gradient);
            let next = chart.moved(&step);
            let next_cost = total_cost(&next, points, loss);
            if next_cost <= cost {
                improvement = Some((next, next_cost, step.norm()));
                damping = (damping * 0.1).max(1e-12);
                break;
            }
            if step.norm() < SETTLED {
                break;
            }
            damping *= 10.0;
        }
        let Some((next, next_cost, length)) = improvement else {
            break;
        };
        let gain = cost - next_cost;
        chart = next;
        cost = next_cost;
        if length < SETTLED || gain <= effort.least_gain * cost {
            break;
        }
    }
    let surface = chart.surface()?;
    let (mut sum, mut weights) = (0.0, 0.0);
    for point in points {
        let distance = chart.distance(point).0;
        let weight = loss.weight(distance);
        sum += weight * distance * distance;
        weights += weight;
    }
    (weights > 0.0).then(|| (surface, (sum / weights).sqrt()))
}

fn total_cost<const N: usize>(chart: &impl Chart<N>, points: &[Vector], loss: Loss) -> f64 {
    points
        .iter()
        .map(|point| loss.cost(chart.distance(point).0))
        .sum()
}

/// JᵀWJ and JᵀWd.
fn normal_equations<const N: usize>(
    chart: &impl Chart<N>,
    points: &[Vector],
    loss: Loss,
) -> (SMatrix<f64, N, N>, SVector<f64, N>) {
    let mut normal = SMatrix::<f64, N, N>::zeros();
    let mut gradient = SVector::<f64, N>::zeros();
    for point in points {
        let (distance, row) = chart.distance(point);
        let weight = loss.weight(distance);
        if weight > 0.0 {
            // Written out: the general rank-one update took a fifth of the time of a fit.
            for j in 0..N {
                let weighted = weight * row[j];
                gradient[j] += weighted * distance;
                for i in j..N {
                    normal[(i, j)] += weighted * row[i];
                }
            }
        }
    }
    normal.fill_upper_triangle_with_lower_triangle();
    (normal, gradient)
}
