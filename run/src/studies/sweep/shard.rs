//! Parts of a sweep (shards) that are run separately, on one machine or on many.

use crate::error::Error;
use std::ops::Range;

/// Part of a sweep that is run separately: a range of consecutive points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// Number of this part, counted from 1.
    pub part: u64,
    /// Total number of parts into which the sweep is divided.
    pub of: u64,
}

impl Shard {
    /// Reads a shard from text such as `3/8`.
    ///
    /// # Errors
    /// [`Error::Request`] unless the text is i/n with whole numbers 1 ≤ i ≤ n.
    pub fn read(text: &str) -> Result<Self, Error> {
        let number = |text: &str| text.trim().parse::<u64>().ok();
        let numbers = text.split_once('/').and_then(|(part, of)| Some((number(part)?, number(of)?)));
        let Some((part, of)) = numbers else {
            let help = "write the number of the part and the number of parts, such as 3/8".to_owned();
            return Err(Error::request(format!("the shard is `{text}`"), help));
        };
        if part == 0 || part > of {
            let help = format!("parts are counted from 1 to {of}");
            let help = if of == 0 { "there must be one part at least, as in 1/1".to_owned() } else { help };
            return Err(Error::request(format!("there is no part {part} of {of}"), help));
        }
        Ok(Self { part, of })
    }

    /// Range of the points of this shard, in a sweep of `count` points. Consecutive shards have consecutive
    /// ranges, whose lengths differ by at most one point.
    #[must_use]
    pub fn shard_points(self, count: u64) -> Range<u64> {
        let start = |part: u64| {
            let start = u128::from(part) * u128::from(count) / u128::from(self.of);
            u64::try_from(start).expect("at most the count")
        };
        start(self.part - 1)..start(self.part)
    }
}

#[cfg(test)]
mod tests {
    use super::Shard;

    #[test]
    fn parts_follow_one_another_and_are_alike() {
        for (count, of) in [(0, 1), (1, 1), (10, 3), (3, 10), (1_000_000_000, 7), (5, u64::MAX), (12, 12)] {
            let parts = of.min(1000);
            let list: Vec<_> = (1..=parts).map(|part| Shard { part, of }.shard_points(count)).collect();
            assert_eq!(list[0].start, 0);
            assert!(list.windows(2).all(|w| w[0].end == w[1].start), "{count} in {of}");
            assert_eq!(Shard { part: of, of }.shard_points(count).end, count);
            let lengths = list.iter().map(|r| r.end - r.start);
            assert!(lengths.clone().max().unwrap() - lengths.min().unwrap() <= 1);
        }
    }

    #[test]
    fn wrong_parts_are_refused() {
        for text in ["0/3", "4/3", "1/0", "1", "1/2/3", "a/b", "-1/2", ""] {
            assert!(Shard::read(text).is_err(), "{text}");
        }
        assert_eq!(Shard::read("3/8").unwrap(), Shard { part: 3, of: 8 });
    }
}
