main :: IO ()
main = putStrLn "nothing is simulated"
