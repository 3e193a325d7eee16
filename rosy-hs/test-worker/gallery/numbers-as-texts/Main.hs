main = simulate (forM_ [1..3] say)
