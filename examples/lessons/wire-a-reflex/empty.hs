main :: IO ()
main = simulate _
