average :: [Double] -> Double
average = (/) <$> sum <*> fromIntegral . length

slug :: String -> String
slug = map (\c -> if c == ' ' then '-' else c) . unwords . words

main = simulate (Say . slug . show)
