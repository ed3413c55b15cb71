//! Changing inputs, a little or much.

use crate::random::Random;

/// Numbers that text is given in place of its own.
const NUMBERS: [&str; 24] = [
    "0",
    "-0",
    "1",
    "-1",
    "2",
    "0.5",
    "1e-3",
    "1e-9",
    "1e-320",
    "5e-324",
    "1e30",
    "1e31",
    "1e154",
    "1e308",
    "-1e308",
    "1e309",
    "NaN",
    "inf",
    "-inf",
    "4294967295",
    "4294967296",
    "18446744073709551616",
    "0.1234567890123456789",
    "00000000001",
];

/// Whole numbers at the edges of their types.
const EDGES: [u64; 10] = [
    0,
    1,
    0x7F,
    0xFF,
    0x7FFF,
    0xFFFF,
    0x7FFF_FFFF,
    0xFFFF_FFFF,
    0x7FFF_FFFF_FFFF_FFFF,
    u64::MAX,
];

/// Makes another input of one: one change as a rule, up to sixteen. `other` is one to take parts of.
pub fn mutate(
    input: &mut Vec<u8>,
    other: &[u8],
    words: &[&str],
    longest: usize,
    random: &mut Random,
) {
    let mut changes = 1;
    while changes < 16 && random.chance(2) {
        changes += 1;
    }
    for _ in 0..changes {
        change(input, other, words, random);
    }
    input.truncate(longest);
}

fn change(input: &mut Vec<u8>, other: &[u8], words: &[&str], random: &mut Random) {
    let at = random.below(input.len() + 1);
    match random.below(14) {
        0 => {
            if let Some(byte) = input.get_mut(at) {
                *byte ^= 1 << random.below(8);
            }
        }
        1 => {
            if let Some(byte) = input.get_mut(at) {
                *byte = random.next() as u8;
            }
        }
        2 => {
            if let Some(byte) = input.get_mut(at) {
                let by = random.below(35) as u8 + 1;
                *byte = if random.chance(2) {
                    byte.wrapping_add(by)
                } else {
                    byte.wrapping_sub(by)
                };
            }
        }
        3 => {
            let width = [2, 4, 8][random.below(3)];
            let edge = random.one(&EDGES).copied().unwrap_or_default();
            let value = edge.wrapping_add(random.below(5) as u64).wrapping_sub(2);
            overwrite(input, at, &value.to_le_bytes()[..width]);
        }
        4 => {
            let bits = f64::from_bits(random.next() & random.next());
            overwrite(input, at, &bits.to_le_bytes());
        }
        5 => {
            let count = random.below(9);
            let bytes: Vec<u8> = (0..count).map(|_| random.next() as u8).collect();
            input.splice(at..at, bytes);
        }
        6 => {
            let range = part(input, random);
            input.drain(range);
        }
        7 => {
            let copy = input[part(input, random)].to_vec();
            let times = if random.chance(8) { 30 } else { 1 };
            input.splice(at..at, copy.repeat(times));
        }
        8 => {
            let copy = input[part(input, random)].to_vec();
            overwrite(input, at, &copy);
        }
        9 => {
            let range = part(other, random);
            input.splice(at..at, other[range].iter().copied());
        }
        10 => {
            // The head of one and the tail of the other.
            input.truncate(at);
            input.extend_from_slice(&other[random.below(other.len() + 1)..]);
        }
        11 | 12 if !words.is_empty() => {
            let word = random.one(words).copied().unwrap_or_default().as_bytes();
            if random.chance(2) {
                overwrite(input, at, word);
            } else {
                input.splice(at..at, word.iter().copied());
            }
        }
        _ => number(input, at, random),
    }
}

/// Puts another number in the place of one in the text, at or after a place.
fn number(input: &mut Vec<u8>, at: usize, random: &mut Random) {
    let is_part =
        |byte: &u8| byte.is_ascii_digit() || matches!(byte, b'.' | b'-' | b'+' | b'e' | b'E');
    let Some(start) = input[at..]
        .iter()
        .position(u8::is_ascii_digit)
        .map(|from| at + from)
    else {
        return;
    };
    let end = input[start..]
        .iter()
        .position(|byte| !is_part(byte))
        .map_or(input.len(), |to| start + to);
    let text = random.one(&NUMBERS).copied().unwrap_or_default();
    input.splice(start..end, text.bytes());
}

fn overwrite(input: &mut [u8], at: usize, with: &[u8]) {
    for (byte, with) in input.iter_mut().skip(at).zip(with) {
        *byte = *with;
    }
}

/// A part: a short one as a rule.
fn part(of: &[u8], random: &mut Random) -> std::ops::Range<usize> {
    let start = random.below(of.len() + 1);
    let most = if random.chance(4) { of.len() } else { 16 };
    start..start + random.below(most.min(of.len() - start) + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_seed_gives_the_same_inputs_again_and_none_is_too_long() {
        let stream = |seed| {
            let mut random = Random::new(seed);
            let mut input = b"Points:=[1, 2, 3]".to_vec();
            let step = |_| {
                mutate(
                    &mut input,
                    b"Primitive1:=[1 2];",
                    &["Plane"],
                    200,
                    &mut random,
                );
                input.clone()
            };
            (0..5_000).map(step).collect::<Vec<_>>()
        };
        let made = stream(3);
        assert!(made.iter().all(|input| input.len() <= 200));
        assert_eq!(made, stream(3));
        assert_ne!(made, stream(4));
    }

    #[test]
    fn every_number_of_a_text_is_replaced_sooner_or_later() {
        let mut random = Random::new(1);
        let mut found = 0;
        for _ in 0..2_000 {
            let mut input = b"[12.5]".to_vec();
            number(&mut input, 0, &mut random);
            found += usize::from(input == b"[1e308]");
        }
        assert!(found > 20);
    }
}
