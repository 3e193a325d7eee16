main = simulate t
t :: Int -> Task ()
t n = say (show n)
