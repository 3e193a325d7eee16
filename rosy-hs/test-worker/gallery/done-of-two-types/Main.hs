turn = task () (\(Bumper s _) -> if s == LeftBumper then Done 3 else Done 4)
main = simulate turn
