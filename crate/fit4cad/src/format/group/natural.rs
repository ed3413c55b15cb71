//! The order in which people count: PC2 before PC10.

use std::cmp::Ordering;

/// Compares names with runs of digits as numbers and letters without case; names that differ only
/// in case or leading zeros are told apart by their bytes, so that the order is total.
pub(super) fn compare(a: &str, b: &str) -> Ordering {
    let (mut left, mut right) = (a.as_bytes(), b.as_bytes());
    loop {
        let order = match (left, right) {
            ([], []) => return a.cmp(b),
            ([], _) => return Ordering::Less,
            (_, []) => return Ordering::Greater,
            ([x, ..], [y, ..]) if x.is_ascii_digit() && y.is_ascii_digit() => {
                let (x, y) = (take_number(&mut left), take_number(&mut right));
                x.len().cmp(&y.len()).then(x.cmp(y))
            }
            ([x, rest_left @ ..], [y, rest_right @ ..]) => {
                (left, right) = (rest_left, rest_right);
                x.to_ascii_lowercase().cmp(&y.to_ascii_lowercase())
            }
        };
        if order.is_ne() {
            return order;
        }
    }
}

/// Takes the digits in front and returns them without leading zeros.
fn take_number<'a>(text: &mut &'a [u8]) -> &'a [u8] {
    let end = text
        .iter()
        .position(|byte| !byte.is_ascii_digit())
        .unwrap_or(text.len());
    let (digits, rest) = text.split_at(end);
    *text = rest;
    let zeros = digits.iter().take_while(|&&digit| digit == b'0').count();
    digits.get(zeros..).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn numbers_within_names_count() {
        let mut names = ["PC10", "pc2", "PC1", "PC02", "PC2", "a/PC3", "PC1_b"];
        names.sort_by(|a, b| compare(a, b));
        assert_eq!(
            names,
            ["a/PC3", "PC1", "PC1_b", "PC02", "PC2", "pc2", "PC10"]
        );
    }

    proptest! {
        #[test]
        fn the_order_is_total(a in "[a-bA0-2/]{0,6}", b in "[a-bA0-2/]{0,6}", c in "[a-bA0-2/]{0,6}") {
            prop_assert_eq!(compare(&a, &b), compare(&b, &a).reverse());
            prop_assert_eq!(compare(&a, &b).is_eq(), a == b);
            if compare(&a, &b).is_le() && compare(&b, &c).is_le() {
                prop_assert!(compare(&a, &c).is_le());
            }
        }
    }
}
