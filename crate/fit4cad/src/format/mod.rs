//! The four text files of a model: reading, writing and grouping them.
