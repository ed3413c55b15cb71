//! WebGL2 renderer for segmented point clouds, loaded by the page.
