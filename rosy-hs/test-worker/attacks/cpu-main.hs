main = let go n = go (n + 1) in go 0
