//! Files that commands read and write.

pub(super) mod judged_publication;
pub(super) mod output_files;
pub(super) mod scene_file;
pub(super) mod workspace;
