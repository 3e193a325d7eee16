drive forward until you hit a wall
