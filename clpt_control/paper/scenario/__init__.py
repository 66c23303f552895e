"""One experiment, typed: its tables, its TOML file, the paper's own."""
