//! From the numbers of nodes or elements in a file to indices.

use std::collections::HashMap;

/// Finds the index of a number. Files number almost without gaps, for which a table is several
/// times faster than hashing; other files get the map.
#[derive(Clone, Debug)]
pub(super) enum Numbering {
    /// By number − lowest number; `u32::MAX` for none.
    Table { lowest: u64, index: Vec<u32> },
    /// By number.
    Map(HashMap<u64, u32>),
}

impl Default for Numbering {
    /// Without numbers.
    fn default() -> Self {
        Self::Map(HashMap::new())
    }
}

impl Numbering {
    /// Of numbers by index.
    ///
    /// # Errors
    /// The index of the first number that stood before.
    pub fn new(numbers: &[u64]) -> Result<Self, usize> {
        let lowest = numbers.iter().min().copied().unwrap_or(0);
        let highest = numbers.iter().max().copied().unwrap_or(0);
        let span = highest - lowest;
        if span < 8 * numbers.len() as u64 + 1024 {
            let mut index = vec![u32::MAX; span as usize + 1];
            for (i, number) in numbers.iter().enumerate() {
                let slot = &mut index[(number - lowest) as usize];
                if *slot != u32::MAX {
                    return Err(i);
                }
                *slot = i as u32;
            }
            return Ok(Self::Table { lowest, index });
        }
        let mut map = HashMap::with_capacity(numbers.len());
        for (i, number) in numbers.iter().enumerate() {
            if map.insert(*number, i as u32).is_some() {
                return Err(i);
            }
        }
        Ok(Self::Map(map))
    }

    /// The index of a number.
    pub fn find(&self, number: u64) -> Option<usize> {
        let index = match self {
            Self::Table { lowest, index } => {
                let slot = usize::try_from(number.checked_sub(*lowest)?).ok()?;
                *index.get(slot)?
            }
            Self::Map(map) => *map.get(&number)?,
        };
        (index != u32::MAX).then_some(index as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dense_and_scattered_numbers_are_found_and_repeated_ones_refused() {
        for numbers in [vec![7, 3, 4, 9], vec![1, u64::MAX - 1, 1 << 40]] {
            let numbering = Numbering::new(&numbers).unwrap();
            for (i, &number) in numbers.iter().enumerate() {
                assert_eq!(numbering.find(number), Some(i));
            }
            for absent in [0, 5, u64::MAX] {
                assert_eq!(numbering.find(absent), None);
            }
        }
        assert_eq!(Numbering::new(&[4, 2, 4]).unwrap_err(), 2);
        assert_eq!(Numbering::new(&[4, 1 << 50, 2, 1 << 50]).unwrap_err(), 3);
        assert_eq!(Numbering::new(&[]).unwrap().find(0), None);
    }
}
