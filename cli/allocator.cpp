// The command's memory comes from jemalloc, in pages of 2 MB: every first touch of a 4 KB page costs
// more than filling it, and scenes of 100,000 objects touch tens of thousands
// (docs/decisions/0061-memory-from-jemalloc.md). The library looks for this name.
extern "C" {
extern const char* malloc_conf;
const char* malloc_conf = "thp:always,oversize_threshold:0,lg_extent_max_active_fit:14";
}
