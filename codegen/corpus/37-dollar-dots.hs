main :: IO ()
main = simulate $ mconcat $ map Just $ filter even . map (+ 1) . takeWhile (< 100) $ [1 ..]
