parse :: Either String Int -> Maybe Say
parse (Left err) = Just (Say err)
parse (Right n) = if n > 3 then Just (Say (show n)) else Nothing

pick :: Maybe a -> a -> a
pick m d = case m of { Just x -> x; Nothing -> d }

main = simulate (parse (Right 4))
