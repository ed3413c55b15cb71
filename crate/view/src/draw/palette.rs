//! Colour tables as textures: what each label looks like, and the colour map of scalars.

use crate::colouring::{Colouring, LabelState};
use crate::draw::gl::{Gl, GlError, Texture};

/// Width of the label table's texture; longer tables continue in the next row. The shaders know
/// it as the number of bits to shift.
const ROW_BITS: u32 = 10;

/// The label table of one side, and its colour map.
#[derive(Debug)]
pub struct Palette {
    table: Texture,
    map: Texture,
    uploaded: (u64, u64, u64),
}

impl Palette {
    /// Empty textures.
    ///
    /// # Errors
    /// [`GlError::Lost`] if the driver gives no object.
    pub fn new(gl: &Gl) -> Result<Self, GlError> {
        Ok(Self {
            table: Texture::new(gl, Gl::NEAREST)?,
            map: Texture::new(gl, Gl::LINEAR)?,
            uploaded: (u64::MAX, u64::MAX, u64::MAX),
        })
    }

    /// Brings the textures up to date. The table is as long as the largest label asks for, so that
    /// no shader reads beyond it.
    pub fn sync(&mut self, gl: &Gl, colouring: &Colouring) {
        let revisions = (
            colouring.table().revision(),
            colouring.labels().revision(),
            colouring.map().revision(),
        );
        if (self.uploaded.0, self.uploaded.1) != (revisions.0, revisions.1) {
            let texels = padded(colouring.table().get(), colouring.largest());
            let rows = texels.len() >> ROW_BITS;
            let rows = i32::try_from(rows).unwrap_or(i32::MAX);
            self.table
                .upload(gl, 1 << ROW_BITS, rows, texels.as_flattened());
        }
        if self.uploaded.2 != revisions.2 {
            match colouring.map().get().as_slice() {
                [] => self.map.upload(gl, 1, 1, &[128, 128, 128, 255]),
                steps => {
                    let width = i32::try_from(steps.len()).unwrap_or(i32::MAX);
                    self.map.upload(gl, width, 1, steps.as_flattened());
                }
            }
        }
        self.uploaded = revisions;
    }

    /// Binds the table to unit 0 and the map to unit 1.
    pub fn bind(&self, gl: &Gl) {
        self.table.bind(gl, 0);
        self.map.bind(gl, 1);
    }
}

/// The table continued to the largest label (at most [`MAX_LABEL`]) and to a full row.
fn padded(table: &[[u8; 4]], largest: u32) -> Vec<[u8; 4]> {
    let needed = (largest.min(MAX_LABEL) as usize + 1).max(table.len());
    let mut texels = table.to_vec();
    texels.resize(
        needed.next_multiple_of(1 << ROW_BITS),
        [128, 128, 128, LabelState::Shown as u8],
    );
    texels
}

/// The largest label that a texture of 2048 rows, the least that WebGL2 grants, has room for.
/// Larger labels share its entry.
pub const MAX_LABEL: u32 = (2048 << ROW_BITS) - 1;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_reaches_the_largest_label() {
        assert_eq!(padded(&[], 0).len(), 1024);
        assert_eq!(padded(&[[1; 4]; 3], 1023).len(), 1024);
        assert_eq!(padded(&[[1; 4]; 3], 1024).len(), 2048);
        assert_eq!(padded(&[[1; 4]; 3], 5)[3][3], LabelState::Shown as u8);
    }

    #[test]
    fn an_enormous_label_does_not_make_an_enormous_table() {
        assert_eq!(padded(&[], u32::MAX).len(), 2048 * 1024);
    }
}
