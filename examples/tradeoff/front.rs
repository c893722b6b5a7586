//! Pareto fronts: the points that no other beats in both cost and error.

/// A cost and an error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trade {
    pub cost: f64,
    pub error: f64,
}

impl Trade {
    /// Whether this is as cheap and as accurate as the other, or better.
    pub fn covers(&self, other: &Self) -> bool {
        self.cost <= other.cost && self.error <= other.error
    }
}

/// The indices of the trades on the front, the cheapest first; of equal ones the first.
pub fn front(trades: &[Trade]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..trades.len()).collect();
    let key = |i: &usize| (trades[*i].cost, trades[*i].error);
    order.sort_by(|a, b| {
        key(a)
            .partial_cmp(&key(b))
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    let (mut least, mut front) = (f64::INFINITY, Vec::new());
    for i in order {
        if trades[i].error < least {
            least = trades[i].error;
            front.push(i);
        }
    }
    front
}

/// Whether none of these trades covers this one.
pub fn is_outside(trade: &Trade, ours: &[Trade]) -> bool {
    !ours.iter().any(|our| our.covers(trade))
}

/// The place of the cheapest whose error is no larger than that.
pub fn cheapest(trades: &[Trade], error: f64) -> Option<usize> {
    let good = (0..trades.len()).filter(|i| trades[*i].error <= error);
    good.min_by(|a, b| trades[*a].cost.total_cmp(&trades[*b].cost))
}

/// Tries these functions on a made-up set, and returns the complaints.
pub fn check() -> Vec<String> {
    let trade = |(cost, error)| Trade { cost, error };
    let made_up = [
        (4.0, 1.0),
        (1.0, 8.0),
        (2.0, 4.0),
        (3.0, 5.0),
        (2.0, 6.0),
        (9.0, 0.5),
        (9.0, 1.0),
    ]
    .map(trade);
    let mut wrong = Vec::new();
    let mut hold = |what: &str, holds: bool| {
        if !holds {
            wrong.push(format!("the front of a set made up for it: {what}"));
        }
    };
    hold("which are on it", front(&made_up) == [1, 2, 0, 5]);
    hold("of none", front(&[]).is_empty());
    let outside = |point| is_outside(&trade(point), &made_up);
    let cases = [
        ((0.5, 9.0), true),
        ((3.9, 3.9), true),
        ((10.0, 0.4), true),
        ((2.0, 4.0), false),
        ((4.0, 1.1), false),
        ((9.5, 7.0), false),
    ];
    for (point, due) in cases {
        hold(
            &format!("whether {point:?} is outside"),
            outside(point) == due,
        );
    }
    for (error, due) in [
        (8.0, Some(1)),
        (4.5, Some(2)),
        (1.0, Some(0)),
        (0.7, Some(5)),
        (0.1, None),
    ] {
        hold(
            &format!("the cheapest to {error}"),
            cheapest(&made_up, error) == due,
        );
    }
    wrong
}
