//! Values by name.

use std::collections::BTreeMap;

/// The places that names have got, 0, 1, … as they came.
#[derive(Debug, Clone, Default)]
pub(super) struct Places(BTreeMap<String, usize>);

impl Places {
    /// The place of a name; a new one gets the next. O(log n).
    #[inline(never)]
    pub(super) fn give(&mut self, name: &str) -> usize {
        if let Some(place) = self.get(name) {
            return place;
        }
        let place = self.len();
        self.0.insert(name.to_owned(), place);
        place
    }

    #[inline(never)]
    pub(super) fn get(&self, name: &str) -> Option<usize> {
        self.0.get(name).copied()
    }

    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    #[inline(never)]
    fn in_order(&self) -> Vec<usize> {
        self.0.values().copied().collect()
    }
}

/// Values by name. A map of the standard library is compiled anew for every type of keys and of values, 4 kB each,
/// which the page has to wait for; here there is one of them, from names to places in a list.
#[derive(Debug, Clone)]
pub(super) struct Named<V> {
    places: Places,
    values: Vec<V>,
}

impl<V> Default for Named<V> {
    fn default() -> Self {
        Self {
            places: Places::default(),
            values: Vec::new(),
        }
    }
}

impl<V> Named<V> {
    pub(super) fn get(&self, name: &str) -> Option<&V> {
        self.values.get(self.places.get(name)?)
    }

    pub(super) fn contains(&self, name: &str) -> bool {
        self.places.get(name).is_some()
    }

    /// The value of a name, which gets this one where it has none.
    pub(super) fn or_insert(&mut self, name: &str, value: V) -> &mut V {
        let place = self.places.give(name);
        if place >= self.values.len() {
            self.values.push(value);
        }
        &mut self.values[place]
    }

    /// The values as they came.
    pub(super) fn iter(&self) -> std::slice::Iter<'_, V> {
        self.values.iter()
    }

    /// The values in the order of their names.
    pub(super) fn in_order(self) -> impl Iterator<Item = V> {
        let mut values: Vec<Option<V>> = self.values.into_iter().map(Some).collect();
        let places = self.places.in_order().into_iter();
        places.filter_map(move |place| values.get_mut(place)?.take())
    }
}

/// One name of several parts; different parts give different names, whatever characters they hold.
pub(super) fn joined(parts: &[&str]) -> String {
    let mut name = String::new();
    for part in parts {
        name.push_str(&part.len().to_string());
        name.push(':');
        name.push_str(part);
    }
    name
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_had_by_name_and_in_the_order_of_names() {
        let mut named = Named::default();
        *named.or_insert("pear", 1) += 10;
        *named.or_insert("apple", 2) += 10;
        *named.or_insert("pear", 3) += 10;
        assert_eq!((named.get("pear"), named.get("plum")), (Some(&21), None));
        assert_eq!(named.in_order().collect::<Vec<_>>(), [12, 21]);
    }

    #[test]
    fn parts_are_told_apart_from_what_looks_like_them() {
        assert_ne!(joined(&["a", "b"]), joined(&["ab", ""]));
        assert_ne!(joined(&["a1:b"]), joined(&["a", "b"]));
    }
}
