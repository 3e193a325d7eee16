"""Path previews: an edited program run headless with the room, the seed and the hands of a page's last run."""
