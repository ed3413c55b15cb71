//! A picture to be saved, put together from tiles and scaled down to smooth it.

/// Side of a tile in drawn pixels, without its margin. Even, so that no pixel lies on two tiles.
pub const TILE: i32 = 2048;

/// A picture under way: for every pixel the sum of those drawn for it, premultiplied by alpha.
#[derive(Debug)]
pub struct Picture {
    width: usize,
    height: usize,
    factor: usize,
    sums: Vec<[u16; 4]>,
}

impl Picture {
    /// An empty picture of so many pixels, each the mean of `factor` × `factor` drawn ones.
    pub fn new(width: i32, height: i32, factor: i32) -> Self {
        let size = |length: i32| length.unsigned_abs() as usize;
        Self {
            width: size(width),
            height: size(height),
            factor: size(factor).clamp(1, 8),
            sums: vec![[0; 4]; size(width) * size(height)],
        }
    }

    /// Adds a tile (r g b a, lowest row first) whose lower left pixel, without its margin, is the
    /// drawn pixel (x, y) from below.
    pub fn add(&mut self, x: i32, y: i32, tile: &[u8], tile_width: i32, margin: i32) {
        let (tile, _) = tile.as_chunks::<4>();
        let [x, y, tile_width, margin] =
            [x, y, tile_width, margin].map(|length| length.unsigned_abs() as usize);
        let inner = tile_width.saturating_sub(2 * margin);
        let rows = tile
            .chunks_exact(tile_width.max(1))
            .skip(margin)
            .take(TILE as usize);
        for (drawn_row, source) in (y..self.height * self.factor).zip(rows) {
            let row = self.height - 1 - drawn_row / self.factor;
            let start = row * self.width;
            let Some(target) = self.sums.get_mut(start..start + self.width) else {
                continue;
            };
            for (drawn_column, pixel) in (x..).zip(source.iter().skip(margin).take(inner)) {
                if let Some(sums) = target.get_mut(drawn_column / self.factor) {
                    for (sum, channel) in sums.iter_mut().zip(pixel) {
                        *sum += u16::from(*channel);
                    }
                }
            }
        }
    }

    /// The means, r g b a, uppermost row first, with colours divided by their alpha as image files
    /// want them.
    pub fn into_straight_alpha(self) -> Vec<u8> {
        let count = (self.factor * self.factor) as u32;
        let byte = |value: u32| u8::try_from(value).unwrap_or(255);
        self.sums
            .iter()
            .flat_map(|&[r, g, b, a]| {
                let alpha = u32::from(a);
                let straight = |sum: u16| match alpha {
                    0 => 0,
                    alpha => byte((u32::from(sum) * 255 + alpha / 2) / alpha),
                };
                let opacity = byte((alpha + count / 2) / count);
                [straight(r), straight(g), straight(b), opacity]
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_land_where_they_belong_and_the_picture_is_upright() {
        let mut picture = Picture::new(3, 2, 1);
        // A tile of 5 × 4 with a margin of one pixel; its inner lower left pixel is number 6.
        let tile: Vec<u8> = (0..20).flat_map(|number| [number, 0, 0, 255]).collect();
        picture.add(0, 0, &tile, 5, 1);
        let reds: Vec<u8> = picture
            .into_straight_alpha()
            .iter()
            .step_by(4)
            .copied()
            .collect();
        assert_eq!(reds, [11, 12, 13, 6, 7, 8]);
    }

    #[test]
    fn two_tiles_beside_each_other_leave_no_seam() {
        let mut picture = Picture::new(2, 1, 2);
        let tile = [[100_u8, 0, 0, 255]; 4];
        picture.add(0, 0, tile.as_flattened(), 2, 0);
        picture.add(2, 0, tile.as_flattened(), 2, 0);
        assert_eq!(
            picture.into_straight_alpha(),
            [100, 0, 0, 255, 100, 0, 0, 255]
        );
    }

    #[test]
    fn a_pixel_is_the_mean_of_those_drawn_for_it() {
        let mut picture = Picture::new(1, 1, 2);
        let tile = [[255, 0, 0, 255], [255, 0, 0, 255], [0; 4], [0; 4]];
        picture.add(0, 0, tile.as_flattened(), 2, 0);
        assert_eq!(picture.into_straight_alpha(), [255, 0, 0, 128]);
    }

    #[test]
    fn premultiplied_colours_become_straight() {
        let mut picture = Picture::new(1, 1, 1);
        picture.add(0, 0, &[64, 128, 0, 128], 1, 0);
        assert_eq!(picture.into_straight_alpha(), [128, 255, 0, 128]);
    }
}
