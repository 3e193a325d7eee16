"""Parts that several robots have, and the reader of their dimensions."""
