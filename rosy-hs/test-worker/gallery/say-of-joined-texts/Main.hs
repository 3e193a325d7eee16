tell :: Int -> Task ()
tell n = say "bumps: " ++ show n

main = simulate (tell 3)
